"""Judges of tables: printed errors, printed positions, a joint's printed values, a printed number."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np

from pieper.judge.claim import Claim
from pieper.judge.dimensions import in_unit
from pieper.judge.evidence import Evidence
from pieper.judge.model import ArmModel
from pieper.judge.numbers import UNITS, as_text, cut_off, last_digit, misprint, read_joints, read_number, unit_of
from pieper.judge.samples import pose_of, samples_at
from pieper.judge.slips.arm_slips import arm_slips, axis_renamings
from pieper.judge.verdict import Verdict
from pieper.tolerances import JUDGED_ZERO

ZEROS = (0, 90, 180, -90)  # deg, where makers put the zero of a joint relative to a DH table


def judge_number(ev: Evidence, claim: Claim) -> Verdict:
    """Judge a printed number against a formula, at given joints when the formula needs them.

    Keys: is, value, q_deg, unit, where. The value is compared in the unit that is printed, whatever the arm's.
    """
    q = read_joints(claim, ev.model) if any(k in claim for k in ("q", "q_deg", "q_rad")) else np.zeros(ev.model.n)
    node = ev.parse(str(claim["is"]), claim.where)
    there = samples_at(ev.model, q)
    env = there.env
    ev.pick(env, there.frames)
    ev.fill(env)
    scale, other = in_unit(ev, node, str(claim.get("unit", "")))
    with np.errstate(all="ignore"):
        value = float(np.ravel(node.evaluate(env))[0])
    right, printed = value * scale, claim["value"]
    unit = f" {claim['unit']}" if "unit" in claim else ""
    claim = claim.reads(f"{claim['is']} = {as_text(printed)}{unit}")
    if other:
        return claim.wrong(f"Wrong: {claim['is']} {other}, and has no value in {claim['unit']}.", slip="unit")
    if not np.isfinite(right):
        why = "a relative error of a zero reference has no value"
        return claim.wrong("Wrong: the value is undefined (a division by zero).", [("undefined", why)])
    if abs(read_number(printed) - right) <= 0.51 * last_digit(printed):
        return claim.holds(f"Holds to the printed digits; more exactly {right:.10g}{unit}.")
    why = misprint(printed, right) or _other_unit(ev, claim, value)
    details = [("nearest right reading", f"{right:.10g}{unit}")] + ([("the slip", why)] if why else [])
    if cut_off(printed, right):
        sentence = f"Holds but for the rounding of the last digit, which is cut off; more exactly {right:.10g}{unit}."
        return claim.holds(sentence, details)
    sentence = f"Wrong: printed {as_text(printed)}, right {right:.10g}{unit}."
    return claim.wrong(sentence, details, "misprint" if why else "")


def _other_unit(ev: Evidence, claim: Claim, value: float) -> str:
    """The unit of length in which a printed number would be right; "" where there is none."""
    here = claim.get("unit", ev.model.unit)
    for unit, size in UNITS.items():
        right = value * UNITS[ev.model.unit] / size
        if (
            here in UNITS
            and unit != here
            and abs(read_number(claim["value"]) - right) <= 0.51 * last_digit(claim["value"])
        ):
            return f"the number is in {unit}"
    return ""


def judge_errors(ev: Evidence, claim: Claim) -> Verdict:
    """Judge the largest percent errors of a table of reference and simulated positions (keys rows, percent)."""
    widths = {len(r[k]) for r in claim["rows"] for k in ("reference", "simulation")}
    if widths != {len(claim["percent"])}:
        raise claim.error(
            f"rows: every reference and simulation must have {len(claim['percent'])} numbers, one a key of percent",
            "rows",
        )
    reference = np.array([[read_number(v) for v in r["reference"]] for r in claim["rows"]])
    simulated = np.array([[read_number(v) for v in r["simulation"]] for r in claim["rows"]])
    with np.errstate(all="ignore"):
        percent = np.where(reference == 0, np.nan, 100 * np.abs(simulated - reference) / np.abs(reference))
    lines, wrong, undefined = [], 0, []
    for k, (axis, printed) in enumerate(claim["percent"].items()):
        column = percent[:, k]
        right = float(np.nanmax(column)) if np.isfinite(column).any() else np.nan
        wrong += not (np.isfinite(right) and abs(right - read_number(printed)) <= 0.51 * last_digit(printed))
        empty = [str(r + 1) for r in np.flatnonzero((reference[:, k] == 0) & (simulated[:, k] != 0))]
        undefined += [f"{axis} in row {r}" for r in empty]
        gone = f"; undefined in row {', '.join(empty)} (reference 0)" if empty else ""
        lines.append((axis, f"printed {as_text(printed)} %, recomputed {right:z.4f} %{gone}"))
    claim = claim.reads("largest errors " + ", ".join(f"{a} {as_text(v)} %" for a, v in claim["percent"].items()))
    if wrong:
        return claim.wrong(f"Wrong in {wrong} of {len(claim['percent'])} values.", lines)
    if undefined:
        return claim.partly(
            f"Holds for the rows that have a relative error; it is undefined for {', '.join(undefined)}, where the "
            "reference is zero.",
            lines,
        )
    return claim.holds("Holds: recomputed from the printed positions.", lines)


def judge_table(ev: Evidence, claim: Claim) -> Verdict:
    """Judge printed positions for given joints; where they differ, look for renamed axes, other zeros and senses.

    Keys: rows, each with q_deg and position; unit; within (how far a position may be off, in the unit); search_zeros =
    [2, 3, 5], the joints whose zero and sense may differ from the table's.
    """
    model, unit = ev.model, unit_of(claim, ev.model)
    factor = UNITS[model.unit] / UNITS[unit]
    rows, joints = claim["rows"], claim.get("search_zeros", [])
    q = np.array([read_joints(claim.part(f"{claim.id} row {k + 1}", r), model) for k, r in enumerate(rows)])
    printed = np.array([[read_number(v) for v in r["position"]] for r in rows])
    within = float(claim.get("within", 0.51 * max(last_digit(v) for r in rows for v in r["position"])))
    right = pose_of(model, q)[:, :3, 3] * factor
    gap = np.abs(right - printed).max(1)
    given = [", ".join(as_text(v) for v in r["position"]) for r in rows]
    at = [", ".join(as_text(v) for v in r["q_deg"]) for r in rows]
    claim = claim.reads("; ".join(f"({a}) deg: ({g}) {unit}" for a, g in zip(at, given, strict=True)))
    if gap.max() <= within:
        return claim.holds(f"Holds: every position within {gap.max():.3g} {unit}.")
    finest = min(last_digit(v) for r in rows for v in r["position"])
    decimals = min(9, max(2, round(-np.log10(finest)) + 1))

    def shown(row: np.ndarray) -> str:
        return f"({', '.join(f'{v:z.{decimals}f}' for v in row)})"

    lines = [(f"row {k + 1}", f"printed ({g}), by the table {shown(right[k])} {unit}") for k, g in enumerate(given)]
    few = _misprinted(rows, right, np.abs(right - printed) > within)
    if few:
        lines = [("the slip", few), ("nearest right reading", "; ".join(map(shown, right)) + f" {unit}"), *lines]
        return claim.wrong(f"Wrong, off by up to {gap.max():.3g} {unit}; {few}.", lines, "misprint", few)
    simple = _whole_table(right, printed, within) or _other_arm(model, q, printed, factor, within)
    if simple:
        words, kind, reading = simple
        lines = [("the slip", words), ("nearest right reading", "; ".join(map(shown, right)) + f" {unit}"), *lines]
        return claim.wrong(f"Wrong as it stands, off by up to {gap.max():.6g} {unit}; {words}.", lines, kind, reading)
    residual, flips, axes, zeros, moved = _best_zeros(model, q, printed, factor, joints)
    lines.append(("tried", f"24 namings of the axes times {8 ** len(joints)} zeros and senses, one lost sign allowed"))
    most = f"off by up to {gap.max():.4g} {unit}"
    because = axes + (f"; {zeros}" if zeros else "")
    if residual > within:
        lines.append(("closest", f"{because}: still {residual:.3g} {unit} off"))
        return claim.wrong(f"Wrong: {most}, and no naming of the axes brings it within {within:g} {unit}.", lines)
    lines = [
        ("the slip", because + (f"; one sign lost: {flips}" if flips else "")),
        ("nearest right reading", "; ".join(map(shown, moved)) + f" {unit}"),
        *lines,
    ]
    sentence = f"Wrong as it stands, {most}; explained to {residual:.3g} {unit} by: {because}."
    return claim.wrong(sentence, lines, "axes" if "axes" in axes else "zero")


def _misprinted(rows: list[dict[str, Any]], right: np.ndarray, off: np.ndarray) -> str:
    """The misprints of a table in which few numbers are off, each with its row; "" where that is not what it is."""
    places = np.argwhere(off)
    if len(places) > max(1, off.size // 6):
        return ""
    words = [misprint(rows[k]["position"][axis], float(right[k, axis])) for k, axis in places]
    if not all(words):
        return ""
    return "; ".join(f"{'XYZ'[axis]} in row {k + 1}: {w}" for (k, axis), w in zip(places, words, strict=True))


def _other_arm(
    model: ArmModel, q: np.ndarray, printed: np.ndarray, factor: float, within: float
) -> tuple[str, str, str] | None:
    """The arm one slip away for which the whole table is right; renamed axes are looked for with zeros and senses."""
    for kind, words, arm in arm_slips(model):
        if kind != "axes" and np.all(np.abs(pose_of(arm, q)[:, :3, 3] * factor - printed) <= within):
            return f"right for the arm with {words}", kind, words
    return None


def _whole_table(right: np.ndarray, printed: np.ndarray, within: float) -> tuple[str, str, str] | None:
    """One slip of the whole table, (words, kind, reading): another unit, or one axis mirrored; None for neither."""
    for factor, words in ((1000.0, "millimetres for metres"), (0.001, "metres for millimetres")):
        if np.all(np.abs(right * factor - printed) <= within * max(1.0, factor)):
            return f"a factor of 1,000: {words}", "millimetres", words
    for axis in range(3):
        mirrored = right.copy()
        mirrored[:, axis] *= -1
        if np.all(np.abs(mirrored - printed) <= within) and np.any(np.abs(right[:, axis]) > within):
            return f"{'XYZ'[axis]} is mirrored in every row", "mirrored", f"-{'XYZ'[axis]}"
    return None


def _best_zeros(
    model: ArmModel, q: np.ndarray, printed: np.ndarray, factor: float, joints: list[int]
) -> tuple[float, str, str, str, np.ndarray]:
    """Find the zeros, senses and axes that bring the printed positions closest; one sign of one number may be lost."""
    choices = list(itertools.product((1, -1), ZEROS))
    combos = list(itertools.product(choices, repeat=len(joints)))
    variants = np.repeat(q[None], len(combos), axis=0)
    for c, combo in enumerate(combos):
        for joint, (sign, zero) in zip(joints, combo, strict=True):
            variants[c, :, joint - 1] = sign * q[:, joint - 1] + np.radians(zero)
    points = pose_of(model, variants.reshape(-1, model.n))[:, :3, 3].reshape(len(combos), len(q), 3) * factor
    best = (np.inf, 9, 9, "", "", "", points[0])
    names = [("the axes as they are", np.eye(3)), *axis_renamings()]
    for words, R in names:
        if np.linalg.det(R) < 0:
            continue  # a mirrored frame is no frame
        turned = points @ R.T
        gap = np.abs(turned - printed)
        flipped = np.abs(turned + printed)
        lost = (flipped < gap - JUDGED_ZERO) & (np.abs(printed) > 0)
        single = lost.reshape(len(combos), -1).sum(1) == 1
        plain = gap.reshape(len(combos), -1).max(1)
        repaired = np.where(single, np.minimum(gap, flipped).reshape(len(combos), -1).max(1), np.inf)
        for score, flips in ((plain, False), (repaired, True)):
            c = int(np.argmin(score))
            changes = sum(s != 1 or z != 0 for s, z in combos[c])
            key = (round(float(score[c]), 6), int(flips), changes)
            if key < best[:3]:
                where = ""
                if flips:
                    row, axis = np.argwhere(lost[c])[0]
                    where = f"{'XYZ'[axis]} in row {row + 1}"
                zeros = "; ".join(
                    f"theta{j} = {'-' if s < 0 else ''}J{j}{f' {z:+d} deg' if z else ''}"
                    for j, (s, z) in zip(joints, combos[c], strict=True)
                    if s != 1 or z
                )
                best = (*key, words, zeros, where, turned[c])
    return best[0], best[5], best[3], best[4], best[6]


def judge_range(ev: Evidence, claim: Claim) -> Verdict:
    """Judge whether used values lie in the range printed for the joint (keys joint, range_deg, values_deg)."""
    low, high = (float(v) for v in claim["range_deg"])
    values = [read_number(v) for v in claim["values_deg"]]
    outside = [f"{v:g}" for v in values if not low <= v <= high]
    shown = ", ".join(f"{v:g}" for v in values)
    claim = claim.reads(f"joint {claim['joint']} at {shown} deg is in {low:g} .. {high:g} deg")
    if outside:
        return claim.wrong(f"Wrong: {', '.join(outside)} deg outside the printed range.")
    return claim.holds(f"Holds: all {len(values)} values." if len(values) > 1 else "Holds.")
