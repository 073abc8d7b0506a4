"""Judges of solutions: a set of joint vectors said to solve a pose, and how many solutions a pose is said to have."""

from __future__ import annotations

import numpy as np

from pieper.errors import InputError, PieperError
from pieper.judge.evidence import Evidence, fresh_samples
from pieper.judge.judges.poses import unit_of
from pieper.judge.model import ArmModel
from pieper.judge.printed import UNITS, joint_tolerance, last_digit, read_joints, read_matrix, read_number
from pieper.judge.verdict import HOLDS, PARTLY, WRONG, Verdict


def judge_solutions(ev: Evidence, claim: dict) -> Verdict:
    """Judge joint vectors said to be solutions of a pose, and whether they are all (keys matrix or q_deg,
    solutions_deg, complete, unit)."""
    model = ev.model
    factor = UNITS[model.unit] / UNITS[unit_of(claim, model)]
    if "matrix" in claim:
        printed = read_matrix(claim)
        T = np.eye(4)
        for i, row in enumerate(printed[:3]):
            for j, v in enumerate(row):
                T[i, j] = read_number(v)
        slack = max((last_digit(v) for r in printed[:3] for v in r[3:]), default=0.0)
    else:
        T = fresh_samples(model, read_joints(claim, model)).frames["T"][0].copy()
        T[:3, 3] *= factor
        slack = 1e-9 * model.length()
    position_only = claim.get("task") == "position"
    lines, bad = [], 0
    solutions = claim.get("solutions_deg")
    if not solutions:
        raise InputError(f"claim {claim['id']}: solutions_deg must list at least one joint vector", claim=claim["id"])
    for k, row in enumerate(solutions):
        q = read_joints({"id": f"{claim['id']} solution {k + 1}", "q_deg": row}, model)
        got = fresh_samples(model, q).frames["T"][0].copy()
        got[:3, 3] *= factor
        gap = float(np.linalg.norm(got[:3, 3] - T[:3, 3]))
        turn = 0.0 if position_only else _rotation_between(got[:3, :3], T[:3, :3])
        half = joint_tolerance(row, True)
        allowed = slack * 2 + float(half.sum()) * model.length() * factor
        fine = gap <= allowed and turn <= max(0.02, np.degrees(half.sum()) * 2)
        bad += not fine
        lines.append(
            (
                f"solution {k + 1}",
                ("closes" if fine else "is NO solution")
                + f": position off by {gap:.{3 if fine else 6}g} {unit_of(claim, model)}, "
                f"orientation by {turn:.1g} deg"
                + ("" if fine else f"; it reaches ({', '.join(f'{v:.3f}' for v in got[:3, 3])})"),
            )
        )
    text = (
        f"{len(solutions)} solution(s)"
        + (", said to be all" if claim.get("complete") else "")
        + ": "
        + "; ".join("(" + ", ".join(str(v) for v in r) + ")" for r in solutions)
        + " deg"
    )
    says = claim.get("says", "")
    if bad:
        return Verdict(
            claim["id"],
            text,
            WRONG,
            f"Wrong: {bad} of {len(solutions)} given joint vectors do not reach the pose.",
            says,
            tuple(lines),
        )
    if claim.get("complete"):
        try:
            total = len(_solve(ev, T / _scale(factor, model), claim))
        except (PieperError, AttributeError, NotImplementedError, ImportError) as error:
            return Verdict(
                claim["id"],
                text,
                PARTLY,
                f"Every one is a solution; whether they are all could not be checked: {error}",
                says,
                tuple(lines),
            )
        if total != len(solutions):
            return Verdict(
                claim["id"],
                text,
                PARTLY,
                f"Every one is a solution, but they are not all: there are {total}.",
                says,
                tuple(lines),
            )
    return Verdict(
        claim["id"],
        text,
        HOLDS,
        f"Holds: {len(solutions)} of {len(solutions)} reach the pose"
        + (", and there are no others." if claim.get("complete") else "."),
        says,
        tuple(lines),
    )


def _rotation_between(A: np.ndarray, B: np.ndarray) -> float:
    """Return the angle (deg) between two rotations, exact also where it is small and B is rounded."""
    R = A.T @ B
    spin = 0.5 * np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    return float(np.degrees(np.arctan2(np.linalg.norm(spin), (np.trace(R) - 1) / 2)))


def _scale(factor: float, model: ArmModel) -> np.ndarray:
    out = np.ones((4, 4))
    out[:3, 3] = factor / UNITS[model.unit]
    return out


def _solve(ev: Evidence, T: np.ndarray, claim: dict) -> np.ndarray:
    task = {"task": claim["task"]} if "task" in claim else {}
    return np.asarray(ev.model.solver.ik(T, **task).all_q)


def judge_count(ev: Evidence, claim: dict) -> Verdict:
    """Judge how many solutions a pose has, at random poses the arm can reach (keys count, task)."""
    count = claim.get("count")
    if not isinstance(count, int):
        raise InputError(f"claim {claim['id']}: count must be a whole number", claim=claim["id"])
    if ev.model.solver is None:
        raise InputError(
            f"claim {claim['id']}: this arm's table cannot be given to the solver, so its solutions cannot be counted",
            claim=claim["id"],
        )
    text = f"a pose has {count} solutions"
    says = claim.get("says", "")
    counts = []
    for k in np.flatnonzero(ev.samples.nominal)[:40]:
        T = ev.samples.frames["T"][k].copy()
        T[:3, 3] *= UNITS[ev.model.unit]
        try:
            counts.append(len(_solve(ev, T, claim)))
        except (PieperError, AttributeError, NotImplementedError, ImportError) as error:
            return Verdict(claim["id"], text, PARTLY, f"Could not be checked: {error}", says)
    found = {c: counts.count(c) for c in sorted(set(counts))}
    spread = ", ".join(f"{c} at {100 * m / len(counts):.0f}%" for c, m in found.items())
    details = (("solutions found", f"{spread} of {len(counts)} random poses"),)
    if set(found) == {count}:
        return Verdict(
            claim["id"],
            text,
            HOLDS,
            f"Holds: {count} solutions at {len(counts)} of {len(counts)} random poses.",
            says,
            details,
        )
    if max(found) == count:
        return Verdict(
            claim["id"],
            text,
            PARTLY,
            f"Holds as the largest number only; there are {spread} of the poses.",
            says,
            details,
        )
    return Verdict(
        claim["id"],
        text,
        WRONG,
        f"Wrong: there are {spread} of {len(counts)} random poses, never {count}."
        if count not in found
        else f"Wrong: there are {spread} of {len(counts)} random poses.",
        says,
        details,
    )
