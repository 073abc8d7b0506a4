"""Judges of solutions: a set of joint vectors said to solve a pose, and how many solutions a pose is said to have."""

from __future__ import annotations

import numpy as np

from pieper.errors import PieperError
from pieper.judge.claim import Claim
from pieper.judge.evidence import Evidence
from pieper.judge.judges.poses import joint_slips
from pieper.judge.numbers import (
    UNITS,
    joint_tolerance,
    joint_units,
    last_digit,
    read_joints,
    read_matrix,
    read_number,
    unit_of,
)
from pieper.judge.samples import pose_of
from pieper.judge.verdict import Verdict
from pieper.judge.within_digits import nearest_inside, room, turn_between
from pieper.tolerances import JUDGED_ZERO
from pieper.words_by_number import plural


def judge_solutions(ev: Evidence, claim: Claim) -> Verdict:
    """Judge joint vectors said to be solutions of a pose, and whether they are all.

    Keys: matrix or q_deg, solutions_deg, complete, unit, task.
    """
    model, unit = ev.model, unit_of(claim, ev.model)
    factor = UNITS[model.unit] / UNITS[unit]
    T, slack, tilt = _wanted_pose(ev, claim, factor)
    position = claim.get("task") == "position"
    turning = np.array([not model.sliding(k + 1) for k in range(model.n)])
    solutions = claim.get("solutions_deg")
    if not solutions:
        raise claim.error("solutions_deg must list at least one joint vector")
    lines, bad = [], 0
    given = [
        read_joints(claim.part(f"{claim.id} solution {k + 1}", {"q_deg": row}), model)
        for k, row in enumerate(solutions)
    ]
    slips: list[tuple[str, str]] = []
    for k, (row, q) in enumerate(zip(solutions, given, strict=True)):
        units = joint_units(row)
        units = np.where(turning, np.radians(units), units)

        def off(q: np.ndarray) -> tuple[np.ndarray, float, float]:
            got = _in_unit(pose_of(model, q)[0], factor)
            turn = 0.0 if position else float(np.degrees(np.linalg.norm(turn_between(got[:3, :3], T[:3, :3]))))
            return got, float(np.linalg.norm(got[:3, 3] - T[:3, 3])), turn

        def closes(q: np.ndarray, row: list = row, units: np.ndarray = units) -> bool:
            gap, turn = nearest_inside(model, q, room(row, q, units), _in_unit(T, 1 / factor), position)
            return gap * factor <= slack * 2 and turn <= tilt * 2

        got, gap, turn = off(q)
        fine = closes(q)
        bad += not fine
        reached = "" if fine else f"; it reaches ({', '.join(f'{v:.3f}' for v in got[:3, 3])})"
        words = "closes" if fine else "is NO solution"
        said = f"position off by {gap:.{3 if fine else 6}g} {unit}, orientation by {turn:.1g} deg"
        lines.append((f"solution {k + 1}", f"{words}: {said}{reached}"))
        if not fine:
            near = [
                (kind, says)
                for kind, says, other in joint_slips(model, q)
                if closes(other, units=units * (180 / np.pi if kind == "degrees" else 1.0))
            ]
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
    twice = _twice(ev, solutions, given)
    different = count - len(twice)
    same = "; ".join(f"{j + 1} and {i + 1} are one and the same" for i, j in twice)
    if complete:
        try:
            rows = ev.solved(_in_unit(T, 1 / factor), claim.get("task"))
        except PieperError as error:
            return claim.partly(f"Every one is a solution; whether they are all could not be checked: {error}", lines)
        total = len(rows)
        if model.solver is not None and model.solver.endless(_in_unit(T, UNITS[unit]), claim.get("task")):
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


def _twice(ev: Evidence, printed: list, given: list[np.ndarray]) -> list[tuple[int, int]]:
    """Return (later, earlier) for joint vectors that are the same to their digits, whole turns apart or not."""
    found = []
    for i, q in enumerate(given):
        for j in range(i):
            near = JUDGED_ZERO + joint_tolerance(printed[i], True) + joint_tolerance(printed[j], True)
            if np.all(ev.apart(q[None], given[j])[0] <= near):
                found.append((i, j))
                break
    return found


def _wanted_pose(ev: Evidence, claim: Claim, factor: float) -> tuple[np.ndarray, float, float]:
    """Return the pose in the claim's unit, and how far its printed position and rotation (rad) may be off."""
    none = JUDGED_ZERO * ev.model.length() * factor
    if "matrix" not in claim:
        return _in_unit(pose_of(ev.model, read_joints(claim, ev.model))[0], factor), none, JUDGED_ZERO
    printed = read_matrix(claim)[:3]
    T = np.eye(4)
    for i, row in enumerate(printed):
        T[i, : len(row)] = [read_number(v) for v in row]
    digits = [last_digit(v) for r in printed for v in r[:3] if read_number(v) % 1]
    return T, max([none, *(last_digit(v) for r in printed for v in r[3:])]), max([JUDGED_ZERO, *digits])


def _in_unit(T: np.ndarray, factor: float) -> np.ndarray:
    T = T.copy()
    T[:3, 3] *= factor
    return T


def judge_count(ev: Evidence, claim: Claim) -> Verdict:
    """Judge how many solutions a pose has, at random poses the arm can reach (keys count, task)."""
    count = claim.whole("count")
    if ev.model.solver is None:
        raise claim.error("this arm's table cannot be given to the solver, so its solutions cannot be counted")
    claim = claim.reads(f"a pose has {plural(count, 'solution')}")
    counts = []
    for k in np.flatnonzero(ev.samples.nominal)[:40]:
        try:
            counts.append(len(ev.solved(ev.samples.frames["T"][k], claim.get("task"))))
        except PieperError as error:
            return claim.partly(f"Could not be checked: {error}")
    found = {c: counts.count(c) for c in sorted(set(counts))}
    spread = ", ".join(f"{c} at {100 * m / len(counts):.0f}%" for c, m in found.items())
    details = [("solutions found", f"{spread} of {len(counts)} random poses")]
    if set(found) == {count}:
        return claim.holds(
            f"Holds: {plural(count, 'solution')} at {len(counts)} of {len(counts)} random poses.", details
        )
    if max(found) == count:
        return claim.partly(f"Holds as the largest number only; there are {spread} of the poses.", details)
    never = "" if count in found else f", never {count}"
    return claim.wrong(f"Wrong: there are {spread} of {len(counts)} random poses{never}.", details)
