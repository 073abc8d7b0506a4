"""Judge of a printed pose: a matrix of numbers for given joints, and the one slip that explains a wrong one."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from pieper.judge.claim import Claim
from pieper.judge.digits import ROUNDED
from pieper.judge.evidence import Evidence, number
from pieper.judge.matrices import value_of
from pieper.judge.model import ArmModel
from pieper.judge.numbers import (
    BLANK,
    UNITS,
    cut_off,
    joint_units,
    last_digit,
    misprint,
    read_joints,
    read_matrix,
    read_number,
    unit_of,
)
from pieper.judge.products import Product
from pieper.judge.samples import samples_at
from pieper.judge.slips.arm_slips import arm_slips
from pieper.judge.slips.fitting import joint_that_fits, lengths_that_fit
from pieper.judge.verdict import Verdict
from pieper.tolerances import ROUND_OFF

Place = tuple[int, int]
Reader = Callable[[ArmModel, np.ndarray], "Reading"]


@dataclass(frozen=True, eq=False)
class Reading:
    """A printed matrix beside a computed one: which entries agree to the printed digits."""

    printed: list[list]
    right: np.ndarray
    slack: np.ndarray

    @property
    def claimed(self) -> list[Place]:
        """The (row, column), 0-based, of entries that the source prints."""
        return [(i, j) for i, row in enumerate(self.printed) for j, value in enumerate(row) if value not in BLANK]

    def gap(self, place: Place) -> float:
        """How far an entry is off."""
        i, j = place
        return abs(read_number(self.printed[i][j]) - self.right[i, j])

    def misprint(self, place: Place) -> str:
        """The one misprint that explains an entry, "" when there is none."""
        return misprint(self.printed[place[0]][place[1]], self.right[place])

    def off(self) -> list[Place]:
        """The entries that differ by more than rounding."""
        return [
            (i, j)
            for i, j in self.claimed
            if self.gap((i, j)) > max(0.51 * last_digit(self.printed[i][j]), ROUND_OFF) + self.slack[i, j]
        ]

    def serious(self) -> list[Place]:
        """The entries that are neither rounded nor cut off at their last digit."""
        return [place for place in self.off() if not self._cut(place)]

    def _cut(self, place: Place) -> bool:
        near = [self.right[place] + k * self.slack[place] for k in (-1, 0, 1)]
        return any(cut_off(self.printed[place[0]][place[1]], value) for value in near)


def judge_pose(ev: Evidence, claim: Claim) -> Verdict:
    """Judge a printed matrix for given joints (keys q_deg, of, matrix or position, unit, rounded)."""
    model = ev.model
    q = read_joints(claim, model)
    product = ev.product(claim, "of")
    printed = [["", "", "", v] for v in claim["position"]] if "position" in claim else read_matrix(claim)
    factor = UNITS[model.unit] / UNITS[unit_of(claim, model)]
    slack = _slack(claim, model, q, product, factor)

    def reading(arm: ArmModel, joints: np.ndarray) -> Reading:
        right = _value(product, arm, joints)
        if right.shape == (4, 4):
            right[:3, 3] *= factor
        return Reading(printed, right, slack)

    shape = _value(product, model, q).shape
    if len(shape) < 2 or len(printed) > shape[0] or len(printed[0]) > shape[1]:
        raise claim.error(f"{product} has the shape {shape}; the {len(printed)} rows printed do not fit it", "of")
    first = reading(model, q)
    given = claim.get("q_deg", claim.get("q", claim.get("q_rad")))
    unit = " deg" if "q_deg" in claim else ""
    claim = claim.reads(f"{product} at ({'; '.join(map(str, given))}){unit} = {_matrix_text(printed)}")
    count, off, serious = len(first.claimed), first.off(), first.serious()
    if not serious:
        note = [
            ("printed rounding", f"entry ({i + 1},{j + 1}) {printed[i][j]}: {first.misprint((i, j))}") for i, j in off
        ]
        rest = f", {len(off)} differ by the rounding of the last digit." if off else "."
        sentence = f"Holds to the printed digits: {count - len(off)} of {count} entries agree{rest}"
        return claim.holds(sentence, note, digits=_digits(printed))
    details = [
        (f"entry ({i + 1},{j + 1})", f"printed {printed[i][j]}, right {number(first.right[i, j])}") for i, j in serious
    ]
    words, kind, tried, corrected = _explain(model, q, reading, first)
    right = [[_rounded(v, first.right[i, j]) for j, v in enumerate(r)] for i, r in enumerate(printed)]
    details += [
        ("the slip", words or "no single slip explains it"),
        ("nearest right reading", _matrix_text(right)),
        ("tried", tried),
    ]
    i, j = max(serious, key=first.gap)
    worst = f"the worst, ({i + 1},{j + 1}), is off by {number(first.gap((i, j)))}."
    return claim.wrong(f"Wrong in {len(serious)} of {count} entries; {worst}", details, kind, corrected)


def _value(product: Product, model: ArmModel, q: np.ndarray) -> np.ndarray:
    return value_of(product, samples_at(model, q).frames)[0].copy()


def _slack(claim: Claim, model: ArmModel, q: np.ndarray, product: Product, factor: float) -> np.ndarray:
    """Return how much the rounding of printed joints can move each entry, (4, 4) or (3, 3)."""
    slack = np.zeros_like(_value(product, model, q))
    if not claim.get("rounded"):
        return slack
    half = ROUNDED * joint_units(claim, model)
    base = _value(product, model, q)
    for k, h in enumerate(half):
        moved = q.copy()
        moved[k] += h
        slack += np.abs(_value(product, model, moved) - base)
    if slack.shape == (4, 4):
        slack[:3, 3] *= factor
    return slack


def _digits(printed: list[list]) -> int:
    return min(
        (max(0, round(-np.log10(last_digit(v)))) for r in printed for v in r if v not in ("", "*", 0, 1)), default=0
    )


def _rounded(printed: Any, right: float) -> str:
    if printed in BLANK:
        return ""
    decimals = min(12, max(0, round(-np.log10(last_digit(printed)))))
    if misprint(printed, right).startswith("a factor"):
        decimals += 3  # as many digits as were printed
    return f"{right + 0.0:z.{max(decimals, 0)}f}"


def _matrix_text(rows: list[list]) -> str:
    return "[" + "; ".join(", ".join(str(v) if str(v) else "." for v in r) for r in rows) + "]"


def joint_slips(model: ArmModel, q: np.ndarray) -> Iterator[tuple[str, str, np.ndarray]]:
    """Yield (kind, words, q) for joint vectors one slip away from the printed ones."""
    turning = np.array([not model.sliding(k + 1) for k in range(len(q))])
    for k in range(len(q)):
        if q[k]:
            new = q.copy()
            new[k] = -q[k]
            yield "sense", f"joint {k + 1} with the other sign", new
        for j in range(len(q)):
            if j != k and q[j] != q[k]:
                new = q.copy()
                new[k] = q[j]
                yield "copied joint", f"joint {k + 1} given the value of joint {j + 1}", new
                if j > k:
                    new = q.copy()
                    new[[j, k]] = q[[k, j]]
                    yield "exchanged joints", f"joints {k + 1} and {j + 1} exchanged", new
        for turn in (180, 90, -90) if turning[k] else ():
            new = q.copy()
            new[k] += np.radians(turn)
            yield "zero", f"joint {k + 1} with its zero {turn:+d} deg away", new
    yield "degrees", "radians printed as if they were degrees", np.where(turning, np.degrees(q), q)
    yield "degrees", "degrees printed as if they were radians", np.where(turning, np.radians(q), q)


def printed_slips(first: Reading) -> Iterator[tuple[str, str, Reading]]:
    """Yield (kind, words, reading) for a matrix that was written down wrongly as a whole."""

    def as_if(right: np.ndarray) -> Reading:
        return Reading(first.printed, right, first.slack)

    right = first.right
    if right.shape[0] >= 3 and right.shape[1] >= 3:
        turned = right.copy()
        turned[:3, :3] = right[:3, :3].T
        yield "transposed", "the rotation transposed", as_if(turned)
    if right.shape == (4, 4):
        yield "inverse", "the inverse of the pose", as_if(np.linalg.inv(right))
        for scale, words in ((1000.0, "millimetres for metres"), (0.001, "metres for millimetres")):
            scaled = right.copy()
            scaled[:3, 3] *= scale
            yield "millimetres", words, as_if(scaled)
    if len(first.serious()) == 2:
        a, b = first.serious()
        swapped = right.copy()
        swapped[a], swapped[b] = right[b], right[a]
        yield "entries exchanged", " and ".join(f"({i + 1},{j + 1})" for i, j in (a, b)) + " exchanged", as_if(swapped)
    for i, j in ((0, 1), (0, 2), (1, 2)):
        order = [0, 1, 2, 3][: len(right)]
        order[i], order[j] = j, i
        yield "rows exchanged", f"rows {i + 1} and {j + 1} exchanged", as_if(right[order])
        if right.shape[1] >= 3:
            order = [0, 1, 2, 3][: right.shape[1]]
            order[i], order[j] = j, i
            yield "columns exchanged", f"columns {i + 1} and {j + 1} exchanged", as_if(right[:, order])


def _explain(model: ArmModel, q: np.ndarray, reading: Reader, first: Reading) -> tuple[str, str, str, str]:
    """Look for one slip that explains the printed matrix; return (words, kind, what was tried, corrected)."""
    best = (len(first.serious()), "", "", first)
    arms = [(k, w, arm, q) for k, w, arm in arm_slips(model)]
    arms += [(k, w, model, new) for k, w, new in joint_slips(model, q)]
    variants = [*printed_slips(first)] if best[0] > 1 else []
    variants += [(k, w, reading(arm, joints)) for k, w, arm, joints in arms]
    for kind, words, r in variants:
        serious = r.serious()
        if len(serious) < best[0]:
            best = (len(serious), kind, words, r)
    kinds = "convention, a and d of a row, lengths exchanged, twists, senses, zeros, tool, base, axes, units"
    written = "transposed, inverse, rows or columns exchanged, units"
    tried = f"{len(variants)} other arms, joint vectors ({kinds}) and matrices ({written}), misprints of one number"
    left, kind, words, r = best
    start = len(first.serious())
    prints = {place: first.misprint(place) for place in first.serious()}
    single = len(prints) == 1 or not (kind and left == 0)  # one slip is likelier than several misprints
    if single and all(prints.values()) and len(prints) <= max(1, len(first.claimed) // 4):
        return "; ".join(f"entry ({i + 1},{j + 1}): {w}" for (i, j), w in prints.items()), "misprint", tried, ""
    if kind and (left == 0 or (left <= 2 and left < start / 2)):
        rest = {place: r.misprint(place) for place in r.serious()}
        if all(rest.values()):
            more = "".join(f"; besides, entry ({i + 1},{j + 1}) is a misprint: {w}" for (i, j), w in rest.items())
            return f"{words} gives the printed numbers{more}", kind, tried, words
    words, kind = _one_number(model, q, reading, first)
    return (f"{words}: all entries agree then" if words else ""), kind, tried, words


def _one_number(model: ArmModel, q: np.ndarray, reading: Reader, first: Reading) -> tuple[str, str]:
    """The one joint or length whose other value makes every printed entry right, (words, kind)."""
    wanted = np.full(first.right.shape, np.nan)
    for i, j in first.claimed:
        wanted[i, j] = read_number(first.printed[i][j])

    def value(arm: ArmModel, joints: np.ndarray) -> np.ndarray:
        return reading(arm, joints).right

    for joint in range(model.n):
        found, new = joint_that_fits(model, q, joint, value, wanted)
        if not reading(model, new).serious():
            unit, turn = (model.unit, 1.0) if model.sliding(joint + 1) else ("deg", 180 / np.pi)
            return f"joint {joint + 1} is {turn * found:z.4f} {unit}, not {turn * q[joint]:g} {unit}", "joint value"
    finest = min((last_digit(first.printed[i][j]) for i, j in first.claimed), default=ROUND_OFF)
    for place, old, new_length, arm in lengths_that_fit(model, q, value, wanted):
        if not reading(arm, q).serious():
            digits = max(0, round(-np.log10(finest)))
            return f"{place} is {new_length:z.{digits}f}, not {old:g} {model.unit}", "length value"
    return "", ""
