"""Slips in printed numbers: poses, solutions and tables of poses, each with one thing gone wrong.

Each slip says what an explanation must name: the right number at its place, or words.
"""

from __future__ import annotations

import random
from dataclasses import dataclass
from typing import Any

import mpmath as mp

from tests.judge.held_out.arms import ARMS, HeldOutArm
from tests.judge.held_out.plant import head

DIGITS = 4
Numbers = list[list[float]]


@dataclass(frozen=True)
class WrongNumber:
    """A claim about numbers with one slip.

    Attributes:
        arm: Whose it is.
        text: The claim as it stands in a claims file.
        slip: The slip's name.
        names: Words of which the explanation must have one of each group.
    """

    arm: HeldOutArm
    text: str
    slip: str
    names: tuple[tuple[str, ...], ...]


def _pose(arm: HeldOutArm, q: list[float], values: dict[str, float] | None = None) -> Numbers:
    T = arm.pose([mp.mpf(v) for v in q], {k: mp.mpf(v) for k, v in (values or arm.values).items()})
    return [[float(T[i, j]) for j in range(4)] for i in range(4)]


def _joints(arm: HeldOutArm, rng: random.Random) -> tuple[list[float], list[str]]:
    """Joint values, and as they are printed: whole degrees, millimetres of a slide."""
    q, text = [], []
    for slides in arm.slides:
        v = rng.choice([-1, 1]) * rng.randint(100, 700) / 1000 if slides else rng.choice([-1, 1]) * rng.randint(8, 172)
        q.append(v if slides else float(mp.radians(v)))
        text.append(f"{v} m" if slides else f"{v} deg")
    return q, text


def _printed(rows: Numbers) -> list[list[str]]:
    return [[f"{v + 0.0:.{DIGITS}f}" for v in row] for row in rows]


def _claim(kind: str, joints: list[str], key: str, printed: Any) -> str:
    quoted = str(printed).replace("'", '"')
    told = ", ".join(f'"{j}"' for j in joints)
    return f'[[claim]]\nid = "1"\nkind = "{kind}"\nq = [{told}]\n{key} = {quoted}\n'


def _digit(text: str, rng: random.Random) -> str:
    places = [k for k, c in enumerate(text) if c.isdigit() and text.index(".") <= k < len(text) - 1]
    k = rng.choice(places or [len(text) - 2])
    return text[:k] + str((int(text[k]) + rng.randint(2, 8)) % 10) + text[k + 1 :]


def _exchanged_digits(text: str, rng: random.Random) -> str:
    pairs = [k for k in range(len(text) - 1) if text[k].isdigit() and text[k + 1].isdigit() and text[k] != text[k + 1]]
    if not pairs:
        return text
    k = rng.choice(pairs)
    return text[:k] + text[k + 1] + text[k] + text[k + 2 :]


def drawn(seed: int, count: int) -> list[WrongNumber]:
    """Draw wrong numbers; what is right by chance is drawn again."""
    rng = random.Random(seed)
    out: list[WrongNumber] = []
    while len(out) < count:
        arm = ARMS[len(out) % len(ARMS)]
        made = rng.choice(_MAKERS)(arm, rng)
        if made is not None:
            out.append(made)
    return out


def _entry_slip(arm: HeldOutArm, rng: random.Random) -> WrongNumber | None:
    """One entry of a matrix or a position: a digit, two digits, a sign, a thousand."""
    q, told = _joints(arm, rng)
    right = _pose(arm, q)
    rows = _printed(right)
    i, j = rng.randrange(3), rng.choice([0, 1, 2, 3, 3])
    slip = rng.choice(["digit", "digits exchanged", "sign", "factor 1000"])
    old = rows[i][j]
    if slip == "digit":
        new = _digit(old, rng)
    elif slip == "digits exchanged":
        new = _exchanged_digits(old, rng)
    elif slip == "sign":
        new = old[1:] if old[0] == "-" else "-" + old
    else:
        new, j = f"{1000 * right[i][3]:.1f}", 3
        old = rows[i][3]
    if abs(float(new) - right[i][j]) < 3 * 10.0**-DIGITS:
        return None
    place = f"({i + 1},{j + 1})"
    rows[i][j] = new
    words = {
        "sign": ("sign",),
        "factor 1000": ("1000", "millimet"),
        "digit": ("digit", "misprint"),
        "digits exchanged": ("digit", "exchanged"),
    }
    if rng.random() < 0.5 and j == 3:
        text = _claim("pose", told, "position", [row[3] for row in rows[:3]])
    else:
        text = _claim("pose", told, "matrix", rows)
    return WrongNumber(arm, text, slip, ((place,), words[slip]))


def _whole_slip(arm: HeldOutArm, rng: random.Random) -> WrongNumber | None:
    """The whole pose: transposed rotation, millimetres, lengths exchanged, x and y exchanged."""
    q, told = _joints(arm, rng)
    right = _pose(arm, q)
    slip = rng.choice(["transposed", "all in millimetres", "exchanged lengths", "x and y exchanged"])
    if slip == "transposed":
        wrong = [[right[j][i] for j in range(3)] + [right[i][3]] for i in range(3)] + [right[3]]
        names: tuple[tuple[str, ...], ...] = (("transpos",),)
    elif slip == "all in millimetres":
        wrong = [[*row[:3], 1000 * row[3]] for row in right[:3]] + [right[3]]
        names = (("1000", "millimet", "unit"),)
    elif slip == "exchanged lengths":
        a, b = rng.sample(sorted(arm.values), 2) if len(arm.values) > 1 else ("", "")
        if not a:
            return None
        wrong = _pose(arm, q, {**arm.values, a: arm.values[b], b: arm.values[a]})
        names = ((a,), (b,))
    else:
        wrong = [right[1], right[0], *right[2:]]
        names = (("Y is x", "x and y", "rows 1 and 2", "X is y"),)
    if max(abs(wrong[i][j] - right[i][j]) for i in range(3) for j in range(4)) < 1e-3:
        return None
    if slip in ("exchanged lengths", "all in millimetres") and rng.random() < 0.5:
        text = _claim("pose", told, "position", [row[3] for row in _printed(wrong)[:3]])
    else:
        text = _claim("pose", told, "matrix", _printed(wrong))
    return WrongNumber(arm, text, slip, names)


def _joint_slip(arm: HeldOutArm, rng: random.Random) -> WrongNumber | None:
    """Joints: one with another sign, half a turn off, two exchanged, a digit; printed for a pose or as a solution."""
    q, told = _joints(arm, rng)
    right = _pose(arm, q)
    turning = [k for k, s in enumerate(arm.slides) if not s]
    k = rng.choice(turning)
    slip = rng.choice(["sign of a joint", "half a turn", "joints exchanged", "radians"])
    wrong, names = list(told), ((f"joint {k + 1}", f"theta{k + 1}", f"q{k + 1}"),)
    degrees = int(told[k].split()[0])
    if slip == "sign of a joint":
        wrong[k] = f"{-degrees} deg"
        names = (*names, ("sign", "sense"))
    elif slip == "half a turn":
        wrong[k] = f"{degrees - 180 if degrees > 0 else degrees + 180} deg"
        names = (*names, ("half a turn", "180", "zero"))
    elif slip == "joints exchanged":
        others = [j for j in turning if j != k]
        if not others:
            return None
        j = rng.choice(others)
        wrong[k], wrong[j] = wrong[j], wrong[k]
        names = ((str(k + 1),), (str(j + 1),), ("exchanged", "swapped"))
    else:
        wrong = [w if arm.slides[j] else f"{q[j]:.6f} deg" for j, w in enumerate(told)]
        names = (("radian",),)
    shifted = [v if arm.slides[j] else float(mp.radians(float(wrong[j].split()[0]))) for j, v in enumerate(q)]
    got = _pose(arm, shifted)
    if max(abs(got[i][j] - right[i][j]) for i in range(3) for j in range(4)) < 1e-3:
        return None
    if rng.random() < 0.5 and all(not s for s in arm.slides) and not arm.task and len(arm.rows) == 6:
        rows = str(_printed([[*r] for r in right])).replace("'", '"')
        numbers = ", ".join(f'"{float(w.split()[0]):.3f}"' for w in wrong)
        text = f'[[claim]]\nid = "1"\nkind = "solutions"\nmatrix = {rows}\nsolutions_deg = [[{numbers}]]\n'
        return WrongNumber(arm, text, f"solution: {slip}", names)
    return WrongNumber(arm, _claim("pose", wrong, "matrix", _printed(right)), slip, names)


def _table_slip(arm: HeldOutArm, rng: random.Random) -> WrongNumber | None:
    """A table of positions: one number, millimetres, a mirrored axis."""
    if any(arm.slides):
        return None
    slip = rng.choice(["table: digit", "table: millimetres", "table: mirrored"])
    qs = [_joints(arm, rng) for _ in range(4)]
    rows = [[row[3] for row in _pose(arm, q)[:3]] for q, _ in qs]
    axis = rng.choice([a for a in range(3) if max(abs(r[a]) for r in rows) > 0.02])
    printed = _printed(rows)
    names: tuple[tuple[str, ...], ...]
    if slip == "table: digit":
        k = rng.randrange(4)
        new = _digit(printed[k][axis], rng)
        if abs(float(new) - rows[k][axis]) < 3e-4:
            return None
        printed[k][axis] = new
        names = ((f"row {k + 1}", f"rows {k + 1}"), ("XYZ"[axis], "xyz"[axis]))
    elif slip == "table: millimetres":
        printed = [[f"{1000 * v:.1f}" for v in row] for row in rows]
        names = (("1000", "millimet", "unit"),)
    else:
        printed = [[f"{-v + 0.0 if a == axis else v:.4f}" for a, v in enumerate(row)] for row in rows]
        names = (("mirror", f"{'XYZ'[axis]} is -{'xyz'[axis]}"), ("XYZ"[axis], "xyz"[axis]))
    told = ",\n".join(
        f"  {{ q_deg = [{', '.join(t.split()[0] for t in text)}], position = {str(p)} }}".replace("'", '"')
        for (_, text), p in zip(qs, printed, strict=True)
    )
    return WrongNumber(arm, f'[[claim]]\nid = "1"\nkind = "table"\nwithin = 0.0006\nrows = [\n{told}\n]\n', slip, names)


_MAKERS = (_entry_slip, _entry_slip, _whole_slip, _joint_slip, _table_slip)


def claims_file(wrong: WrongNumber) -> str:
    """The text of a claims file with this claim alone."""
    return head(wrong.arm) + "\n" + wrong.text
