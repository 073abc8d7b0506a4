"""Judges of velocities: an entry or the whole of a Jacobian, its determinant, and where it is singular."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from pieper.algebra.expression import Expr
from pieper.judge.claim import Claim
from pieper.judge.evidence import Evidence, number, wrapped
from pieper.judge.judges.formulas import judge_equal
from pieper.judge.samples import Samples, samples_at
from pieper.judge.verdict import Verdict
from pieper.tolerances import JUDGED_HOLDS, JUDGED_ZERO, NO_LENGTH, SLOPE_WIDTH
from pieper.words_by_number import plural

MARCHES = 60  # of a search for a zero of a formula
ZEROS = 40  # joint vectors with the formula at zero that are looked at
MOST_ROWS = 6
HALVINGS = 8  # of a step that does not help
FEW_PLACES = 3  # singular joint vectors that show what they have in common
HALF_TURN = 180.0
TWO = "two slips"


def rows_for(ev: Evidence, claim: Claim) -> list[int]:
    """The rows (0-based) of the Jacobian whose determinant is meant: those named, or those that ever move."""
    n = ev.model.n
    if "rows" in claim:
        rows = [int(r) - 1 for r in claim["rows"]]
        if len(rows) != n or min(rows) < 0 or max(rows) >= MOST_ROWS:
            raise claim.error(
                f"rows: the determinant of {n} joints takes {n} of the rows 1 to 6 (x, y, z, rx, ry, rz)", "rows"
            )
        return rows
    size = np.abs(ev.samples.frames["J"]).max(axis=(0, 2))
    moving = [r for r in range(MOST_ROWS) if size[r] > JUDGED_ZERO * max(1.0, ev.model.length())]
    if len(moving) > n and n <= 3:
        moving = moving[:n] if all(r < 3 for r in moving[:n]) else moving
    if len(moving) != n:
        raise claim.error(f"rows: say which {n} of the rows 1 to 6 (x, y, z, rx, ry, rz) the determinant is of")
    return moving


def judge_jacobian(ev: Evidence, claim: Claim) -> Verdict:
    """Judge an entry of the Jacobian (of = "J[1,2]"), or the whole of it given row by row (keys of, is, where)."""
    ev = ev.holding(claim)
    J = ev.samples.frames["J"]
    given = claim["is"]
    if not isinstance(given, list):
        name = str(claim.get("of", "")).replace(" ", "")
        inside = name[2:-1].split(",") if name.startswith("J[") and name.endswith("]") else []
        if len(inside) != 2 or not all(part.isdigit() for part in inside):
            raise claim.error(
                'of: say which entry, as in of = "J[1,2]" (rows x, y, z, rx, ry, rz; one column a joint)', "of"
            )
        i, j = (int(part) for part in inside)
        if not (1 <= i <= MOST_ROWS and 1 <= j <= ev.model.n):
            raise claim.error(f"of: the Jacobian has 6 rows and {ev.model.n} columns, not {name}", "of")
        node = ev.parse(str(given), claim.where)
        return judge_equal(ev, claim.reads(f"{name} = {given}"), node, J[:, i - 1, j - 1], source=_entry(i - 1, j - 1))
    rows = [row if isinstance(row, list) else [row] for row in given]
    if any(len(row) != ev.model.n for row in rows) or len(rows) not in (2, 3, MOST_ROWS):
        raise claim.error(f"is: a Jacobian has 6 (or, for a position, 2 or 3) rows of {ev.model.n} entries", "is")
    wrong: list[tuple[str, str]] = []
    slip = ""
    for i, row in enumerate(rows):
        for j, text in enumerate(row):
            if str(text).strip() in ("", "*"):
                continue
            part = claim.part(f"{claim.id}[{i + 1},{j + 1}]", {}).reads(f"J[{i + 1},{j + 1}] = {text}")
            one = judge_equal(ev, part, ev.parse(str(text), claim.where), J[:, i, j], source=_entry(i, j))
            if not one.holds:
                more = "; ".join(f"{h}: {b}" for h, b in one.details if h in ("nearest right reading", "the slip"))
                wrong.append((f"entry ({i + 1},{j + 1})", f"{one.claim}: {one.sentence} {more}"))
                slip = slip or one.slip
    claim = claim.reads("J = [" + "; ".join(", ".join(map(str, row)) for row in rows) + "]")
    if wrong:
        return claim.wrong(f"Wrong in {plural(len(wrong), 'entry', 'entries')} of {sum(map(len, rows))}.", wrong, slip)
    return claim.holds("Holds identically: every entry that is given is that of the Jacobian in the base frame.")


def _entry(i: int, j: int) -> Callable[[Evidence], np.ndarray]:
    return lambda ev: ev.samples.frames["J"][:, i, j]


def judge_determinant(ev: Evidence, claim: Claim) -> Verdict:
    """Judge a formula for the determinant of the Jacobian; a sign of the whole is a matter of the rows' order.

    Keys: is, rows (1-based rows of the Jacobian, where the arm has fewer than six joints), where.
    """
    rows = rows_for(ev, claim)

    def determinant(at: Evidence) -> np.ndarray:
        return np.linalg.det(at.samples.frames["J"][:, rows, :])

    right = determinant(ev)
    node = ev.parse(str(claim["is"]), claim.where)
    claim = claim.reads(f"det J = {claim['is']}")
    other, own = ev.goal(-right).fits(node), ev.samples.nominal
    if other[own].all() and not ev.goal(right).fits(node).all():
        named = ev.naming(node)
        if not (named.goal(-determinant(named)).fits(node)).all():
            return judge_equal(ev, claim, node, -right, source=lambda at: -determinant(at))
        return claim.holds(
            "Holds but for the sign of the whole, which goes with the order of rows and the frame: equal to -det J at "
            f"{len(right)} of {len(right)} joint vectors."
        )
    return _with_either_sign(ev, claim, node, determinant)


def _with_either_sign(ev: Evidence, claim: Claim, node: Expr, determinant: Callable[[Evidence], np.ndarray]) -> Verdict:
    """The verdict on a determinant against that sign of the right one from which it is one slip away.

    The sign is free, so that it is no slip: the one that the formula goes along with is tried first, and the other
    where that leaves more than one slip.
    """
    right = determinant(ev)
    with np.errstate(all="ignore"):
        along = np.nansum(np.broadcast_to(np.asarray(node.evaluate(ev.samples.env), dtype=float), right.shape) * right)
    found: list[Verdict] = []
    for sign in (1, -1) if along >= 0 else (-1, 1):
        one = judge_equal(ev, claim, node, sign * right, source=lambda at, sign=sign: sign * determinant(at))
        if sign < 0 and not one.holds:
            told = ("sign", "compared with -det J, for the sign of the whole goes with the order of rows and the frame")
            one = replace(one, details=(*one.details, told))
        found.append(one)
        if not one.wrong or one.slip not in ("", TWO):
            return one
    return next((one for one in found if one.slip), found[0])


def judge_singular(ev: Evidence, claim: Claim) -> Verdict:
    """Judge where an arm is said to be singular: a formula that is zero there (keys is = "s5 = 0", rows, where).

    Both ways are looked at: the Jacobian loses rank wherever the formula is zero, and, if the claim names several with
    "or", nowhere else.
    """
    parts = [part.strip() for part in str(claim["is"]).replace("||", " or ").split(" or ")]
    nodes = []
    for part in parts:
        left, equals, right = part.partition("=")
        if not equals:
            raise claim.error(f'is: {part!r} is no equation; write it as "s5 = 0" or "s3 = 0 or s5 = 0"', "is")
        nodes.append(ev.parse(f"({left}) - ({right})", claim.where))
    claim = claim.reads(f"singular where {' or '.join(parts)}")
    lines: list[tuple[str, str]] = []
    bad = 0
    never = True
    for part, node in zip(parts, nodes, strict=True):
        q, least = _zeros(ev, _value_of(ev, node))
        if not len(q):
            lines.append(
                (part, f"no joint vector was found that makes it zero; the smallest value met is {number(least)}")
            )
            bad += 1
            continue
        never = False
        ratio = _least(ev, claim, q)
        fine = ratio < JUDGED_HOLDS
        lines.append((part, f"the Jacobian loses rank at {int(fine.sum())} of {len(q)} joint vectors with it"))
        if not fine.all():
            k = int(np.flatnonzero(~fine)[0])
            joints = ", ".join(f"{np.degrees(v):.4g}" for v in q[k])
            lines.append(("counter-example", f"at joints ({joints}) deg it is zero and the arm is not singular"))
            bad += 1
    if bad and never:
        return claim.wrong("Wrong: nothing was found that makes it zero on this arm.", lines)
    if bad:
        return claim.wrong("Wrong: the arm is not singular wherever that is zero.", lines)
    others = _elsewhere(ev, claim, nodes)
    if not others:
        return claim.holds("Holds: the Jacobian loses rank wherever it is zero.", lines)
    lines.append(("left out", f"the arm is singular {others}, and nothing that is named is zero there"))
    return claim.holds(
        f"Holds: the Jacobian loses rank wherever it is zero; it does so elsewhere too, {others}.", lines
    )


def _samples_at(ev: Evidence, q: np.ndarray) -> Samples:
    found = samples_at(ev.model, q)
    ev.pick(found.env, found.frames)
    ev.fill(found.env)
    return found


def _value_of(ev: Evidence, node: Expr) -> Callable[[np.ndarray], np.ndarray]:
    """A formula's values at joint vectors."""

    def value(q: np.ndarray) -> np.ndarray:
        with np.errstate(all="ignore"):
            return np.broadcast_to(np.asarray(node.evaluate(_samples_at(ev, q).env), dtype=float), (len(q),))

    return value


def _least(ev: Evidence, claim: Claim, q: np.ndarray) -> np.ndarray:
    """The smallest singular value over the largest, of the rows that are meant, (K,)."""
    J = _samples_at(ev, q).frames["J"].copy()
    scale = max(ev.model.length(), NO_LENGTH)
    J[:, :3] /= scale
    rows = rows_for(ev, claim) if ev.model.n < MOST_ROWS or "rows" in claim else list(range(MOST_ROWS))
    values = np.linalg.svd(J[:, rows, :], compute_uv=False)
    return values[:, -1] / values[:, 0]


def _zeros(
    ev: Evidence, value: Callable[[np.ndarray], np.ndarray], *, round_about: bool = False
) -> tuple[np.ndarray, float]:
    """Joint vectors (K, n) at which a value is zero, and the smallest size that it had.

    They are found by halving between samples of opposite signs; a formula that keeps its sign, as a sum of squares
    does, is followed down to where it touches zero.

    Args:
        ev: The arm and its samples.
        value: Joint vectors (K, n) -> values (K,).
        round_about: Whether joints may go over the half turn.
    """
    rng = np.random.default_rng(12)
    start = ev.samples.q[ev.samples.nominal]
    a, b = start.copy(), start[rng.permutation(len(start))]
    if round_about:
        # over the half turn too, at which the samples end
        turning = np.array([not ev.model.sliding(j + 1) for j in range(ev.model.n)])
        b = b + 2 * np.pi * turning * rng.integers(-1, 2, size=b.shape)
    at_a, at_b = value(a), value(b)
    rows = np.isfinite(at_a) & np.isfinite(at_b) & (at_a * at_b < 0)
    a, b, at_a = a[rows][:ZEROS], b[rows][:ZEROS], at_a[rows][:ZEROS]
    for _ in range(MARCHES):
        middle = (a + b) / 2
        here = value(middle)
        same = here * at_a > 0
        a, b = np.where(same[:, None], middle, a), np.where(same[:, None], b, middle)
    q = (a + b) / 2
    sizes = np.abs(value(start))
    typical, least = float(np.nanmedian(sizes)), float(np.nanmin(sizes))
    slack = JUDGED_ZERO
    if not len(q):
        # where it touches zero the joints are known to the root of the value only
        q, slack = _touching(value, start[:ZEROS]), JUDGED_HOLDS**2
    off = np.abs(value(q))
    least = min(least, float(np.nanmin(off, initial=least)))
    return q[off < slack * max(typical, NO_LENGTH)], least


def _touching(value: Callable[[np.ndarray], np.ndarray], q: np.ndarray) -> np.ndarray:
    """Joint vectors (K, n) after Newton's steps to the nearest zero of a formula that keeps its sign.

    To a zero of even order each step goes half of the way; a step that does not help is halved.
    """
    for _ in range(MARCHES):
        here = value(q)
        slope = np.stack(
            [(value(q + SLOPE_WIDTH * e) - value(q - SLOPE_WIDTH * e)) / (2 * SLOPE_WIDTH) for e in np.eye(q.shape[1])],
            1,
        )
        with np.errstate(all="ignore"):
            step = np.nan_to_num(slope * (here / (slope**2).sum(1))[:, None], nan=0.0, posinf=0.0, neginf=0.0)
        step /= np.maximum(1.0, np.linalg.norm(step, axis=1))[:, None]
        for _ in range(HALVINGS):
            worse = ~(np.abs(value(q - step)) <= np.abs(here))
            if not worse.any():
                break
            step[worse] /= 2
        q = q - np.where(worse[:, None], 0.0, step)
    return q


def _elsewhere(ev: Evidence, claim: Claim, nodes: list[Expr]) -> str:
    """Where the arm is singular though none of the formulas is zero, in words; "" where no such place is found.

    The determinant's own zeros are looked for, and those at which a formula is zero are taken out.
    """
    if ev.model.n > MOST_ROWS:
        return ""
    rows = rows_for(ev, claim) if ev.model.n < MOST_ROWS or "rows" in claim else list(range(MOST_ROWS))
    q, _ = _zeros(ev, lambda at: np.linalg.det(_samples_at(ev, at).frames["J"][:, rows, :]), round_about=True)
    if not len(q):
        return ""
    env = _samples_at(ev, q).env
    named = np.zeros(len(q), dtype=bool)
    for node in nodes:
        value = np.broadcast_to(np.asarray(node.evaluate(env), dtype=float), (len(q),))
        size = np.nanmedian(np.abs(np.asarray(node.evaluate(ev.samples.env), dtype=float)))
        named |= np.abs(wrapped(value) if _is_angle(ev, node) else value) < JUDGED_HOLDS * max(float(size), NO_LENGTH)
    q = q[~named]
    return _places(ev, q) if len(q) else ""


def _is_angle(ev: Evidence, node: Expr) -> bool:
    """Whether a formula goes up by whole turns when a joint does, as theta2 - pi does."""
    q = ev.samples.q[:1]
    turns = [
        (
            float(node.evaluate(_samples_at(ev, q + 2 * np.pi * e).env)[0])
            - float(node.evaluate(_samples_at(ev, q).env)[0])
        )
        / (2 * np.pi)
        for k, e in enumerate(np.eye(ev.model.n))
        if not ev.model.sliding(k + 1)
    ]
    whole = np.round(turns)
    return bool(np.any(whole != 0) and np.abs(np.array(turns) - whole).max() < JUDGED_HOLDS)


def _places(ev: Evidence, q: np.ndarray) -> str:
    """Joint vectors (K, n) in words: the joint that stands still among them, or one of them."""
    for joint in range(1, ev.model.n + 1):
        turned = np.exp(1j * q[:, joint - 1])
        shared = np.abs(turned[:, None] - turned[None]) < JUDGED_HOLDS
        most = int(np.argmax(shared.sum(1)))
        if ev.model.sliding(joint) or shared[most].sum() < FEW_PLACES:
            continue
        angle = float(np.degrees(wrapped(np.angle(turned[most]))))
        angle = abs(angle) if abs(angle) > HALF_TURN - JUDGED_HOLDS else round(angle, 4)
        others = "" if shared[most].all() else ", among others"
        return f"where theta{joint} = {angle + 0.0:.4g} deg{others}"
    joints = ", ".join(
        f"{v:.4g}" if ev.model.sliding(k + 1) else f"{np.degrees(wrapped(v)):.4g}" for k, v in enumerate(q[0])
    )
    return f"at joints ({joints}) deg, for one"
