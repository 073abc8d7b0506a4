"""Judges of tables and limits: printed errors, printed positions, a joint's printed range, a printed number."""

from __future__ import annotations

import itertools

import numpy as np

from pieper.algebra.tree import evaluate
from pieper.errors import InputError
from pieper.judge.evidence import Evidence, fresh_samples
from pieper.judge.model import ArmModel, evaluate_samples
from pieper.judge.printed import UNITS, as_text, last_digit, misprint, read_joints, read_number
from pieper.judge.slips.arm_slips import axis_renamings
from pieper.judge.verdict import HOLDS, PARTLY, WRONG, Verdict

ZEROS = (0, 90, 180, -90)  # deg, where makers put the zero of a joint relative to a DH table


def judge_number(ev: Evidence, claim: dict) -> Verdict:
    """Judge a printed number against a formula, at given joints when the formula needs them (keys is, value, q_deg,
    unit)."""
    q = read_joints(claim, ev.model) if any(k in claim for k in ("q", "q_deg", "q_rad")) else np.zeros(ev.model.n)
    samples = evaluate_samples(ev.model, np.atleast_2d(q))
    ev.fill(samples.env)
    node = ev.parse(str(claim["is"]), claim.get("where"))
    scale = 180 / np.pi if claim.get("unit") == "deg" else 1.0
    with np.errstate(all="ignore"):
        right = float(np.ravel(evaluate(node, samples.env))[0]) * scale
    printed = claim["value"]
    unit = f" {claim['unit']}" if "unit" in claim else ""
    text = f"{claim['is']} = {as_text(printed)}{unit}"
    says = claim.get("says", "")
    if not np.isfinite(right):
        return Verdict(
            claim["id"],
            text,
            WRONG,
            "Wrong: the value is undefined (a division by zero).",
            says,
            (("undefined", "a relative error of a zero reference has no value"),),
        )
    if abs(read_number(printed) - right) <= 0.51 * last_digit(printed):
        return Verdict(claim["id"], text, HOLDS, f"Holds to the printed digits; more exactly {right:.10g}{unit}.", says)
    why = misprint(printed, right)
    details = (("nearest right reading", f"{right:.10g}{unit}"),) + ((("the slip", why),) if why else ())
    if why.startswith("last digit"):
        return Verdict(
            claim["id"],
            text,
            HOLDS,
            f"Holds but for the rounding of the last digit; more exactly {right:.10g}{unit}.",
            says,
            details,
        )
    return Verdict(
        claim["id"],
        text,
        WRONG,
        f"Wrong: printed {as_text(printed)}, right {right:.10g}{unit}.",
        says,
        details,
        "misprint" if why else "",
    )


def judge_errors(ev: Evidence, claim: dict) -> Verdict:
    """Judge the largest percent errors of a table of reference and simulated positions (keys rows, percent)."""
    reference = np.array([[read_number(v) for v in r["reference"]] for r in claim["rows"]])
    simulated = np.array([[read_number(v) for v in r["simulation"]] for r in claim["rows"]])
    if reference.shape != simulated.shape:
        raise InputError(
            f"claim {claim['id']}: reference and simulation have different shapes {reference.shape} and "
            f"{simulated.shape}",
            claim=claim["id"],
        )
    with np.errstate(all="ignore"):
        percent = np.where(reference == 0, np.nan, 100 * np.abs(simulated - reference) / np.abs(reference))
    lines, wrong, undefined = [], 0, []
    for k, (axis, printed) in enumerate(claim["percent"].items()):
        column = percent[:, k]
        right = float(np.nanmax(column)) if np.isfinite(column).any() else np.nan
        fine = np.isfinite(right) and abs(right - read_number(printed)) <= 0.51 * last_digit(printed)
        wrong += not fine
        empty = [str(r + 1) for r in np.flatnonzero((reference[:, k] == 0) & (simulated[:, k] != 0))]
        undefined += [f"{axis} in row {r}" for r in empty]
        lines.append(
            (
                axis,
                f"printed {as_text(printed)} %, recomputed {right:.4f} %"
                + (f"; undefined in row {', '.join(empty)} (reference 0)" if empty else ""),
            )
        )
    text = "largest errors " + ", ".join(f"{a} {as_text(v)} %" for a, v in claim["percent"].items())
    says = claim.get("says", "")
    if wrong:
        return Verdict(
            claim["id"], text, WRONG, f"Wrong in {wrong} of {len(claim['percent'])} values.", says, tuple(lines)
        )
    if undefined:
        return Verdict(
            claim["id"],
            text,
            PARTLY,
            "Holds for the rows that have a relative error; it is undefined for "
            + ", ".join(undefined)
            + ", where the reference is zero.",
            says,
            tuple(lines),
        )
    return Verdict(claim["id"], text, HOLDS, "Holds: recomputed from the printed positions.", says, tuple(lines))


def judge_table(ev: Evidence, claim: dict) -> Verdict:
    """Judge printed positions for given joints; where they disagree, look for renamed axes and for the maker's zeros
    and senses.

    Keys: rows, each with q_deg and position; unit; within (how far a position may be off, in the unit); search_zeros =
    [2, 3, 5], the
    joints whose zero and sense may differ from the table's.
    """
    model = ev.model
    unit = claim.get("unit", model.unit)
    if unit not in UNITS:
        raise InputError(
            f"claim {claim['id']}: unit {unit!r} is not known; use one of {', '.join(UNITS)}", claim=claim["id"]
        )
    factor = UNITS[model.unit] / UNITS[unit]
    rows = claim["rows"]
    q = np.array([read_joints({**r, "id": f"{claim['id']} row {k + 1}"}, model) for k, r in enumerate(rows)])
    printed = np.array([[read_number(v) for v in r["position"]] for r in rows])
    within = float(claim.get("within", 0.51 * max(last_digit(v) for r in rows for v in r["position"])))
    right = fresh_samples(model, q).frames["T"][:, :3, 3] * factor
    gap = np.abs(right - printed).max(1)
    text = "; ".join(
        f"({', '.join(as_text(v) for v in r['q_deg'])}) deg: ({', '.join(as_text(v) for v in r['position'])}) {unit}"
        for r in rows
    )
    says = claim.get("says", "")
    if gap.max() <= within:
        return Verdict(claim["id"], text, HOLDS, f"Holds: every position within {gap.max():.3g} {unit}.", says)
    lines = [
        (
            f"row {k + 1}",
            f"printed ({', '.join(as_text(v) for v in rows[k]['position'])}), by the table "
            f"({', '.join(f'{v:.2f}' for v in right[k])}) {unit}",
        )
        for k in range(len(rows))
    ]
    best = _best_zeros(model, q, printed, factor, claim.get("search_zeros", []))
    residual, flips, axes, zeros, moved = best
    zeros_tried = 8 ** len(claim.get("search_zeros", []))
    tried = f"24 namings of the axes times {zeros_tried} zeros and senses, one lost sign allowed"
    lines.append(("tried", tried))
    if residual > within:
        lines.append(("closest", f"{axes}; {zeros}: still {residual:.3g} {unit} off"))
        return Verdict(
            claim["id"],
            text,
            WRONG,
            f"Wrong: off by up to {gap.max():.1f} {unit}, and no naming of the axes brings it within "
            f"{within:g} {unit}.",
            says,
            tuple(lines),
        )
    lines.insert(
        0, ("the slip", axes + (f"; {zeros}" if zeros else "") + (f"; one sign lost: {flips}" if flips else ""))
    )
    lines.insert(
        1, ("nearest right reading", "; ".join(f"({', '.join(f'{v:.2f}' for v in row)})" for row in moved) + f" {unit}")
    )
    kind = "axes" if "axes" in axes else "zero"
    return Verdict(
        claim["id"],
        text,
        WRONG,
        f"Wrong as it stands, off by up to {gap.max():.1f} {unit}; explained to {residual:.3g} {unit} by: {axes}"
        + (f"; {zeros}" if zeros else "")
        + ".",
        says,
        tuple(lines),
        kind,
    )


def _best_zeros(model: ArmModel, q, printed, factor, joints) -> tuple[float, str, str, str, np.ndarray]:
    """Find the zeros, senses and axes that bring the printed positions closest; one sign of one number may be lost."""
    choices = list(itertools.product((1, -1), ZEROS))
    combos = list(itertools.product(choices, repeat=len(joints)))
    variants = np.repeat(q[None], len(combos), axis=0)
    for c, combo in enumerate(combos):
        for joint, (sign, zero) in zip(joints, combo, strict=True):
            variants[c, :, joint - 1] = sign * q[:, joint - 1] + np.radians(zero)
    points = (
        evaluate_samples(model, variants.reshape(-1, model.n)).frames["T"][:, :3, 3].reshape(len(combos), len(q), 3)
        * factor
    )
    best = (np.inf, 9, 9, "", "", "", points[0])
    names = [("the axes as they are", np.eye(3)), *axis_renamings()]
    for words, R in names:
        if np.linalg.det(R) < 0:
            continue  # a mirrored frame is no frame
        turned = points @ R.T
        gap = np.abs(turned - printed)
        flipped = np.abs(turned + printed)
        lost = (flipped < gap - 1e-9) & (np.abs(printed) > 0)
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


def judge_range(ev: Evidence, claim: dict) -> Verdict:
    """Judge whether used values lie in the range printed for the joint (keys joint, range_deg, values_deg)."""
    low, high = (float(v) for v in claim["range_deg"])
    values = [read_number(v) for v in claim["values_deg"]]
    outside = [f"{v:g}" for v in values if not low <= v <= high]
    shown = ", ".join(f"{v:g}" for v in values)
    text = f"joint {claim['joint']} at {shown} deg is in {low:g} .. {high:g} deg"
    says = claim.get("says", "")
    if outside:
        return Verdict(claim["id"], text, WRONG, f"Wrong: {', '.join(outside)} deg outside the printed range.", says)
    return Verdict(claim["id"], text, HOLDS, f"Holds: all {len(values)} values.", says)


def judge_limit(ev: Evidence, claim: dict) -> Verdict:
    """Judge a joint's printed range against a path the arm is said to follow (keys joint, range_deg, path = {from, to,
    n}, unit).

    The tool's orientation is left free: what is out of reach then is out of reach for every orientation.
    """
    model, joint = ev.model, claim["joint"]
    if not isinstance(joint, int) or not 1 <= joint <= model.n:
        raise InputError(
            f"claim {claim['id']}: joint {joint!r} does not exist; the arm has joints 1 to {model.n}", claim=claim["id"]
        )
    low, high = (float(v) for v in claim["range_deg"])
    if low >= high:
        raise InputError(
            f"claim {claim['id']}: range_deg must be [lower, upper], got {claim['range_deg']}", claim=claim["id"]
        )
    unit = claim.get("unit", model.unit)
    path = claim.get("path")
    if not isinstance(path, dict) or "from" not in path or "to" not in path:
        raise InputError(
            f"claim {claim['id']}: a limit is judged against a path; give path = "
            f"{{ from = [x, y, z], to = [x, y, z] }}",
            claim=claim["id"],
        )
    factor = UNITS[unit] / UNITS[model.unit]
    points = np.linspace(np.array(path["from"], float), np.array(path["to"], float), int(path.get("n", 2))) * factor
    text = f"joint {joint} stays in {low:g} .. {high:g} deg on the way {path['from']} to {path['to']} {unit}"
    says = claim.get("says", "")
    ends = points[[0, -1]]
    gaps = np.array([_closest(model, p, joint, np.radians([low, high])) for p in ends]) / factor
    tolerance = 1e-4 * model.length() / factor
    if (gaps < tolerance).all():
        return Verdict(
            claim["id"],
            text,
            HOLDS,
            "Holds: both ends can be reached inside the range with some orientation of the tool.",
            says,
        )
    maps = []
    for sign in (1, -1):
        for zero in ZEROS:
            lo, hi = sorted(sign * v + zero for v in (low, high))
            if all(_closest(model, p, joint, np.radians([lo, hi])) / factor < tolerance for p in ends):
                maps.append(
                    f"theta{joint} = {'-' if sign < 0 else ''}J{joint}{f' {zero:+d} deg' if zero else ''} "
                    f"in {lo:g} .. {hi:g} deg"
                )
    bad = int(np.argmax(gaps))
    details = [
        (
            "counter-example",
            f"with theta{joint} in {low:g} .. {high:g} deg the tool comes no closer than {gaps[bad]:.4g} "
            f"{unit} to the path's "
            f"{'first' if bad == 0 else 'last'} point, whatever its orientation",
        )
    ]
    if maps:
        details.append(
            ("the slip", "the maker's zero and sense of the joint; the path can be reached with " + ", or ".join(maps))
        )
    details.append(("tried", "both senses and zeros at 0, 90, 180, -90 deg"))
    return Verdict(
        claim["id"],
        text,
        WRONG,
        "Wrong: the range cannot be that of this table's joint, for the path leaves it.",
        says,
        tuple(details),
        "zero" if maps else "",
    )


def _closest(model: ArmModel, point, joint: int, limits) -> float:
    """Return the least distance of the tool from a point, any orientation, one joint limited: damped Gauss-Newton from
    many starts."""
    rng = np.random.default_rng(7)
    k = joint - 1
    q = rng.uniform(-np.pi, np.pi, (64, model.n))
    q[:, k] = rng.uniform(limits[0], limits[1], len(q))
    step, size = 1e-6, model.length()
    best = np.inf
    for _ in range(80):
        moved = np.repeat(q[:, None], model.n + 1, axis=1)
        moved[:, np.arange(model.n), np.arange(model.n)] += step
        p = evaluate_samples(model, moved.reshape(-1, model.n)).frames["T"][:, :3, 3].reshape(len(q), model.n + 1, 3)
        here = p[:, -1]
        best = min(best, float(np.linalg.norm(here - point, axis=1).min()))
        if best < 1e-6 * model.length():
            break
        J = (p[:, :-1] - here[:, None]).transpose(0, 2, 1) / step
        pull = np.einsum("kij,ki->kj", J, point - here)[:, k]
        stuck = ((q[:, k] <= limits[0]) & (pull < 0)) | ((q[:, k] >= limits[1]) & (pull > 0))
        J[stuck, :, k] = 0  # at a stop the other joints must do it alone
        # damping that follows the error converges inside the reach and settles at its edge (Sugihara, 2011)
        damp = (0.5 * size * np.linalg.norm(point - here, axis=1) + 1e-9 * size**2)[:, None, None] * np.eye(3)
        dq = np.einsum(
            "kji,kj->ki", J, np.linalg.solve(J @ J.transpose(0, 2, 1) + damp, (point - here)[..., None])[..., 0]
        )
        q += np.clip(dq, -0.5, 0.5)
        q[:, k] = np.clip(q[:, k], *limits)
    return best
