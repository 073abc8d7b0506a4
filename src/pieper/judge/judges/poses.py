"""Judges of printed poses and solutions: a matrix for given joints, a set of solutions for a pose, how many solutions
there are."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from pieper.errors import InputError
from pieper.judge.evidence import Evidence, fresh_samples, number
from pieper.judge.matrices import Product, parse_product, value_of
from pieper.judge.model import ArmModel
from pieper.judge.printed import UNITS, joint_tolerance, last_digit, misprint, read_joints, read_matrix, read_number
from pieper.judge.slips.arm_slips import arm_slips
from pieper.judge.verdict import HOLDS, WRONG, Verdict

ROUND_OFF = 1e-12  # printed 6.1E-17 stands for zero


@dataclass(frozen=True)
class Reading:
    """A printed matrix beside a computed one: which entries agree to the printed digits."""

    printed: list[list]
    right: np.ndarray
    slack: np.ndarray

    def off(self) -> list[tuple[int, int]]:
        """Return the (row, column), 0-based, of entries that differ by more than rounding."""
        out = []
        for i, row in enumerate(self.printed):
            for j, value in enumerate(row):
                if value in ("", "*"):
                    continue
                allowed = max(0.51 * last_digit(value), ROUND_OFF) + self.slack[i, j]
                if abs(read_number(value) - self.right[i, j]) > allowed:
                    out.append((i, j))
        return out

    def serious(self) -> list[tuple[int, int]]:
        """Return entries off by a whole unit of the last digit or more (a cut-off digit is not serious)."""
        return [
            (i, j)
            for i, j in self.off()
            if abs(read_number(self.printed[i][j]) - self.right[i, j])
            >= last_digit(self.printed[i][j]) + self.slack[i, j]
        ]


def judge_pose(ev: Evidence, claim: dict) -> Verdict:
    """Judge a printed matrix for given joints (keys q_deg, of, matrix or position, unit, rounded)."""
    model = ev.model
    q = read_joints(claim, model)
    product = parse_product(str(claim.get("of", "T")), model.n)
    printed = [["", "", "", v] for v in claim["position"]] if "position" in claim else read_matrix(claim)
    factor = UNITS[model.unit] / UNITS[unit_of(claim, model)]
    slack = _slack(claim, model, q, product, factor)

    def reading(arm: ArmModel, joints: np.ndarray) -> Reading:
        right = value_of(product, fresh_samples(arm, joints).frames)[0].copy()
        if right.shape == (4, 4):
            right[:3, 3] *= factor
        return Reading(printed, right, slack)

    first = reading(model, q)
    shown = "; ".join(f"{v}" for v in claim.get("q_deg", claim.get("q", claim.get("q_rad"))))
    text = f"{product} at ({shown})" + (" deg" if "q_deg" in claim else "") + " = " + _matrix_text(printed)
    count = sum(v not in ("", "*") for r in printed for v in r)
    says, off, serious = claim.get("says", ""), first.off(), first.serious()
    if not serious:
        note = tuple(
            (
                "printed rounding",
                f"entry ({i + 1},{j + 1}) {printed[i][j]}: {misprint(printed[i][j], first.right[i, j])}",
            )
            for i, j in off
        )
        return Verdict(
            claim["id"],
            text,
            HOLDS,
            f"Holds to the printed digits: {count - len(off)} of {count} entries agree"
            + (f", {len(off)} differ by the rounding of the last digit." if off else "."),
            says,
            note,
            digits=_digits(printed),
        )
    details = [
        (f"entry ({i + 1},{j + 1})", f"printed {printed[i][j]}, right {number(first.right[i, j])}") for i, j in serious
    ]
    words, kind, tried, corrected = _explain(model, q, reading, first)
    if words:
        details.append(("the slip", words))
    else:
        details.append(("the slip", "no single slip explains it"))
    details.append(
        (
            "nearest right reading",
            _matrix_text([[_rounded(v, first.right[i, j]) for j, v in enumerate(r)] for i, r in enumerate(printed)]),
        )
    )
    details.append(("tried", tried))
    worst = max(serious, key=lambda ij: abs(read_number(printed[ij[0]][ij[1]]) - first.right[ij]))
    gap = abs(read_number(printed[worst[0]][worst[1]]) - first.right[worst])
    return Verdict(
        claim["id"],
        text,
        WRONG,
        f"Wrong in {len(serious)} of {count} entries; the worst, ({worst[0] + 1},{worst[1] + 1}), is off by "
        f"{number(gap)}.",
        says,
        tuple(details),
        kind,
        corrected,
    )


def unit_of(claim: dict, model: ArmModel) -> str:
    unit = claim.get("unit", model.unit)
    if unit not in UNITS:
        raise InputError(
            f"claim {claim['id']}: unit {unit!r} is not known; use one of {', '.join(UNITS)}", claim=claim["id"]
        )
    return unit


def _slack(claim: dict, model: ArmModel, q, product: Product, factor: float) -> np.ndarray:
    """Return how much the rounding of printed joints can move each entry, (4, 4)."""
    slack = np.zeros((4, 4))
    if not claim.get("rounded"):
        return slack
    half = joint_tolerance(claim.get("q_deg", claim.get("q_rad", [])), "q_deg" in claim)
    base = value_of(product, fresh_samples(model, q).frames)[0]
    for k, h in enumerate(half):
        moved = q.copy()
        moved[k] += h
        slack += np.abs(value_of(product, fresh_samples(model, moved).frames)[0] - base)
    slack[:3, 3] *= factor
    return slack


def _digits(printed) -> int:
    return min(
        (max(0, round(-np.log10(last_digit(v)))) for r in printed for v in r if v not in ("", "*", 0, 1)), default=0
    )


def _rounded(printed, right: float):
    if printed in ("", "*"):
        return ""
    decimals = min(12, max(0, round(-np.log10(last_digit(printed)))))
    return f"{right + 0.0:.{max(decimals, 0)}f}"


def _matrix_text(rows) -> str:
    return "[" + "; ".join(", ".join(str(v) if str(v) else "." for v in r) for r in rows) + "]"


def _joint_slips(q: np.ndarray) -> Iterator[tuple[str, str, np.ndarray]]:
    """Yield (kind, words, q) for joint vectors one slip away from the printed ones."""
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
        for turn in (90, -90, 180):
            new = q.copy()
            new[k] += np.radians(turn)
            yield "zero", f"joint {k + 1} with its zero {turn:+d} deg away", new
    yield "degrees", "degrees taken for radians", np.degrees(q)
    yield "degrees", "radians taken for degrees", np.radians(q)


def _explain(model: ArmModel, q, reading, first: Reading) -> tuple[str, str, str, str]:
    """Look for one slip that explains the printed matrix; return (words, kind, what was tried, corrected)."""
    best = (len(first.serious()), "", "", first)
    variants = [(k, w, arm, q) for k, w, arm in arm_slips(model)] + [
        (k, w, model, new) for k, w, new in _joint_slips(q)
    ]
    for kind, words, arm, joints in variants:
        r = reading(arm, joints)
        serious = r.serious()
        if len(serious) < best[0]:
            best = (len(serious), kind, words, r)
    kinds = "convention, a and d of a row, twists, senses, zeros, tool, base, axes, units"
    tried = f"{len(variants)} other arms and joint vectors ({kinds}), misprints of one number"
    left, kind, words, r = best
    start = len(first.serious())
    total = sum(v not in ("", "*") for r in first.printed for v in r)
    prints = {ij: misprint(first.printed[ij[0]][ij[1]], first.right[ij]) for ij in first.serious()}
    if all(prints.values()) and len(prints) <= max(1, total // 4):
        return "; ".join(f"entry ({i + 1},{j + 1}): {w}" for (i, j), w in prints.items()), "misprint", tried, ""
    if kind and (left == 0 or (left <= 2 and left < start / 2)):
        rest = {ij: misprint(r.printed[ij[0]][ij[1]], r.right[ij]) for ij in r.serious()}
        if all(rest.values()):
            more = "".join(f"; besides, entry ({i + 1},{j + 1}) is a misprint: {w}" for (i, j), w in rest.items())
            return f"{words} gives the printed numbers{more}", kind, tried, words
    for joint in range(model.n):
        value = _joint_that_fits(model, q, joint, reading, first)
        if value is not None:
            words = f"joint {joint + 1} is {np.degrees(value):.4f} deg, not {np.degrees(q[joint]):g} deg"
            return f"{words}: all entries agree then", "joint value", tried, words
    scaled = [f for f in (1000.0, 0.001) if _scaled(first, f)]
    if scaled:
        return "millimetres for metres" if scaled[0] > 1 else "metres for millimetres", "millimetres", tried, ""
    return "", "", tried, ""


def _joint_that_fits(model: ArmModel, q, joint: int, reading, first: Reading) -> float | None:
    """Return the value of a joint with which every printed entry agrees; a pose is linear in its sine and cosine."""
    if model.sliding(joint + 1):
        return None
    at = []
    for angle in (0.0, np.pi / 2, np.pi):
        moved = q.copy()
        moved[joint] = angle
        at.append(reading(model, moved).right)
    middle, cosine = (at[0] + at[2]) / 2, (at[0] - at[2]) / 2
    sine = at[1] - middle
    cells = [(i, j) for i, r in enumerate(first.printed) for j, v in enumerate(r) if v not in ("", "*")]
    scale = {c: 1 / (1 + abs(first.right[c])) for c in cells}
    M = np.array([[cosine[c] * scale[c], sine[c] * scale[c]] for c in cells])
    y = np.array([(read_number(first.printed[c[0]][c[1]]) - middle[c]) * scale[c] for c in cells])
    c, s = np.linalg.lstsq(M, y, rcond=None)[0]
    moved = q.copy()
    moved[joint] = np.arctan2(s, c)
    return None if reading(model, moved).serious() else float(moved[joint])


def _scaled(first: Reading, factor: float) -> bool:
    right = first.right.copy()
    right[:3, 3] *= factor
    return not Reading(first.printed, right, first.slack).serious()
