"""Joint vectors said to solve a pose, and to be all of its solutions."""

from __future__ import annotations

import numpy as np

from pieper.errors import PieperError
from pieper.judge.claim import Claim
from pieper.judge.digits import ROUNDED, Interval, reaches
from pieper.judge.evidence import Evidence
from pieper.judge.judges.poses import joint_slips
from pieper.judge.model import ArmModel
from pieper.judge.numbers import (
    UNITS,
    digit_units,
    joint_units,
    misprint,
    read_joints,
    read_matrix,
    read_number,
    unit_of,
)
from pieper.judge.samples import pose_of
from pieper.judge.slips.fitting import joint_that_fits
from pieper.judge.verdict import Verdict
from pieper.tolerances import JUDGED_ZERO

RADIAN_DIGITS = 0.02  # rad: a number of one decimal or none could be any angle


def judge_solutions(ev: Evidence, claim: Claim) -> Verdict:
    """Judge joint vectors said to be solutions of a pose, and whether they are all.

    Keys: matrix or q_deg, solutions_deg, complete, unit, task.
    """
    model, unit = ev.model, unit_of(claim, ev.model)
    factor = UNITS[model.unit] / UNITS[unit]
    pose = _wanted_pose(ev, claim, factor)
    T = np.vstack([pose.value, [0.0, 0.0, 0.0, 1.0]])
    solutions = claim.get("solutions_deg")
    if not solutions:
        raise claim.error("solutions_deg must list at least one joint vector", "solutions_deg")
    lines, bad = [], 0
    parts = [claim.part(f"{claim.id} solution {k + 1}", {"q_deg": row}) for k, row in enumerate(solutions)]
    given = [Interval(read_joints(part, model), joint_units(part, model)) for part in parts]
    task = claim.get("task", "pose")  # the turn is asked for unless the claim says it is not
    position = task == "position"
    slips: list[tuple[str, str]] = []
    for k, joints in enumerate(given):
        got = _in_unit(pose_of(model, joints.value)[0], factor)
        gap = float(np.linalg.norm(got[:3, 3] - factor * pose.value[:, 3]))
        turn = 0.0 if position else _rotation_between(got[:3, :3], pose.value[:, :3])
        fine = reaches(model, joints, pose, position=position)
        bad += not fine
        reached = "" if fine else f"; it reaches ({', '.join(f'{v:z.3f}' for v in got[:3, 3])})"
        words = "closes" if fine else "is NO solution"
        said = f"position off by {gap:.{3 if fine else 6}g} {unit}" + (
            "" if position else f", orientation by {turn:.1g} deg"
        )
        lines.append((f"solution {k + 1}", f"{words}: {said}{reached}"))
        if not fine:
            near = [
                (kind, says)
                for kind, says, q in joint_slips(model, joints.value)
                if reaches(
                    model,
                    Interval(q, joints.unit * (180 / np.pi if kind == "degrees" else 1.0)),
                    pose,
                    position=position,
                )
            ]
            near = near[:1] or _one_joint(model, solutions[k], joints, pose, position=position)
            slips += near[:1]
            lines += [("the slip", f"solution {k + 1}: {says}") for _, says in near[:1]]
    count, complete = len(solutions), claim.get("complete")
    listed = "; ".join("(" + ", ".join(str(v) for v in r) + ")" for r in solutions)
    claim = claim.reads(
        f"{count} solution{'' if count == 1 else 's'}{', said to be all' if complete else ''}: {listed} deg"
    )
    if bad:
        kind = slips[0][0] if len(slips) == bad and len({kind for kind, _ in slips}) == 1 else ""
        reading = "; ".join(says for _, says in slips) if kind else ""
        return claim.wrong(f"Wrong: {bad} of {count} given joint vectors do not reach the pose.", lines, kind, reading)
    twice = _twice(ev, given)
    different = count - len(twice)
    same = "; ".join(f"{j + 1} and {i + 1} are one and the same" for i, j in twice)
    if complete:
        try:
            rows = ev.solved(T, task)
        except PieperError as error:
            return claim.partly(f"Every one is a solution; whether they are all could not be checked: {error}", lines)
        total = len(rows)
        if model.solver is not None and model.solver.endless(_in_unit(T, UNITS[model.unit]), task):
            return claim.partly("Every one is a solution, but they are not all: there are infinitely many.", lines)
        if total != different:
            again = f" Of the {count} given, {same}." if twice else ""
            sentence = f"Every one is a solution, but they are not all: there are {total}.{again}"
            return claim.partly(sentence, lines, "listed twice" if twice else "")
    if twice:
        sentence = f"Every one is a solution, but there are {different}, not {count}: {same}."
        return claim.partly(sentence, lines, "listed twice")
    others = ", and there are no others." if complete else "."
    return claim.holds(f"Holds: {count} of {count} reach the pose{others}", lines)


def _one_joint(
    model: ArmModel, printed: list, joints: Interval, pose: Interval, *, position: bool
) -> list[tuple[str, str]]:
    """The joint that alone is wrong, [(kind, words)]: with another value of it the joint vector reaches the pose."""
    wanted = pose.value.copy()
    wanted[:, :3] = np.nan if position else wanted[:, :3]
    for k, text in enumerate(printed):
        slides = model.sliding(k + 1)
        turn = 1.0 if slides else 180 / np.pi
        read, unit = turn * joints.value[k], joints.unit.copy()
        if not slides and abs(read) < 2 * np.pi and turn * unit[k] < RADIAN_DIGITS:  # the number as radians
            new, unit[k] = joints.value.copy(), turn * joints.unit[k]
            new[k] = read
            if reaches(model, Interval(new, unit), pose, position=position):
                return [("degrees", f"joint {k + 1} is {turn * read:.6g} deg, not {read:.6g}: in radians")]
        found, new = joint_that_fits(model, joints.value, k, lambda arm, q: pose_of(arm, q)[0, :3], wanted)
        unit[k] = max(joints.unit)
        if not reaches(model, Interval(new, unit), pose, position=position):
            continue
        right = turn * found if slides else turn * found + 360 * round((read - turn * found) / 360)
        why = next((w for v in (right, turn * found) for w in [misprint(text, v)] if w), "")
        last = turn * unit[k] or JUDGED_ZERO
        short = new.copy()
        short[k] = round(right / last) * last / turn
        right = turn * short[k] if reaches(model, Interval(short, unit), pose, position=position) else right
        words = f"joint {k + 1} is {right:.6g} {model.unit if slides else 'deg'}, not {read:.6g}"
        return [("misprint" if why else "joint value", words + (f": {why}" if why else ""))]
    return []


def _twice(ev: Evidence, given: list[Interval]) -> list[tuple[int, int]]:
    """Return (later, earlier) for joint vectors that are the same to their digits, whole turns apart or not."""
    found = []
    for i, joints in enumerate(given):
        for j in range(i):
            near = JUDGED_ZERO + ROUNDED * (joints.unit + given[j].unit)
            if np.all(ev.apart(joints.value[None], given[j].value)[0] <= near):
                found.append((i, j))
                break
    return found


def _wanted_pose(ev: Evidence, claim: Claim, factor: float) -> Interval:
    """Return the pose (3, 4) in the arm's unit of length, and one unit of the last digit of each number."""
    if "matrix" not in claim:
        T = pose_of(ev.model, read_joints(claim, ev.model))[0, :3]
        return Interval(T, np.zeros((3, 4)))
    printed = read_matrix(claim)[:3]
    T, unit = np.eye(4)[:3], np.zeros((3, 4))
    for columns, scale in ((slice(0, 3), 1.0), (slice(3, 4), 1 / factor)):
        cells = [value for row in printed for value in row[columns]]
        if cells:
            shape = (3, len(cells) // 3)
            T[:, columns] = scale * np.reshape([read_number(value) for value in cells], shape)
            units = scale * digit_units(cells).reshape(shape)
            # whole numbers alone are a rotation by quarter turns, which is exact
            unit[:, columns] = units if columns.start or units.min() < 1 else 0.0
    return Interval(T, unit)


def _in_unit(T: np.ndarray, factor: float) -> np.ndarray:
    T = T.copy()
    T[:3, 3] *= factor
    return T


def _rotation_between(A: np.ndarray, B: np.ndarray) -> float:
    """Return the angle (deg) between two rotations, exact also where it is small and B is rounded."""
    R = A.T @ B
    spin = 0.5 * np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    return float(np.degrees(np.arctan2(np.linalg.norm(spin), (np.trace(R) - 1) / 2)))
