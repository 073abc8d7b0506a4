"""What a page on the inverse says, checked sentence by sentence: formulas, counts, degenerate cases, conditions."""

from __future__ import annotations

import re
from collections.abc import Callable

import numpy as np
from scipy.optimize import minimize

from oracle.arms.numbered import random_arm
from pieper import Arm
from pieper.equations.derivation.closed_form import UNDECIDED
from pieper.equations.derivation.degenerate import ELSEWHERE, FREE, IMPOSSIBLE, UNREACHED, _vanishing

POSES = 4
SAME, MISSED = 1e-4, 1e-5
MET = (
    1e-12  # of the usual size of what decides a step; true zeros are found below 1e-14, the smallest floor seen is 1e-9
)
__all__ = ["false_sentences", "random_arm"]


def false_sentences(arm: Arm, poses: int = POSES) -> list[str]:
    """The sentences of an arm's derivation that do not hold, with why; empty where all do.

    Args:
        arm: The arm.
        poses: Random poses at which the formulas are tried.
    """
    ik = arm.symbolic.ik()
    text = ik.text()
    bad: list[str] = []
    found = ik.check(poses)
    if not found.holds:
        bad.append(f"formulas: {found.what}")
    if not ik.closed:
        return [*bad, *_polynomial(arm, ik.general)]
    bad += [f"count: {words}" for words in _counts(arm, text)]
    for number, case in ik.form.cases.items():
        if case.kind in (FREE, ELSEWHERE):
            bad += [f"step {number}, {case.kind}: {words}" for words in _at_postures(arm, ik, case)]
        elif case.kind in (IMPOSSIBLE, UNREACHED):
            nearest = _nearest_to_nothing(lambda q, step=ik.steps[number - 1]: _vanishing(ik.form, step, q), arm.n)
            if nearest <= MET:
                bad.append(f"step {number}, {case.kind}: a posture comes within {nearest:.1e} of its usual size")
            if "is free" in text.split(f"Step {number}:")[1].split("Step ")[0]:
                bad.append(f"step {number}, {case.kind}: called free all the same")
    return bad


def _nearest_to_nothing(coefficients: Callable[[np.ndarray], np.ndarray], n: int) -> float:
    """How near all coefficients come to nothing at one posture, in parts of their usual size, searched downhill."""
    q = np.random.default_rng(8).uniform(-np.pi, np.pi, (2000, n))
    found = np.abs(coefficients(q))
    usual = np.median(found, axis=0)
    usual = np.where(usual > 0, usual, 1.0)

    def gap(x: np.ndarray) -> float:
        return float((np.abs(coefficients(x[None])) / usual).max())

    best = np.argsort((found / usual).max(axis=1))[:3]
    fine = {"xatol": 1e-12, "fatol": 1e-14, "maxiter": 400 * n}
    return min(float(minimize(gap, q[k], method="Nelder-Mead", options=fine).fun) for k in best)


def _polynomial(arm: Arm, general) -> list[str]:
    """The postures that the page prints reach its pose, the one that made it among them, and no pose has more."""
    q, chosen = general.example, list(general.chosen)
    T = arm.fk(q)
    found = general.polynomial(T, q[chosen])
    if found is None:
        return []
    rows = np.tile(q, (len(found.solutions), 1))
    rows[:, [j for j in range(arm.n) if j not in chosen]] = found.solutions
    bad = []
    if len(rows) and np.abs(arm.fk(rows) - T).max() > MISSED * max(1.0, arm.chain.length):
        bad.append(f"polynomial: a printed posture misses its pose by {np.abs(arm.fk(rows) - T).max():.1e}")
    if not (arm.chain.joints.apart(rows, q) < SAME).any():
        bad.append("polynomial: the posture that made the pose is not printed")
    if len(rows) > found.degree:
        bad.append(f"polynomial: {len(rows)} postures of a polynomial of degree {found.degree}")
    return bad


def _counts(arm: Arm, text: str) -> list[str]:
    """A pose has no more solutions than the page says, and the page's choices of signs are as many as it says."""
    said = re.search(r"A pose has at most (\d+) solution", text)
    if not said:
        return []
    q = np.random.default_rng(4).uniform(-2, 2, (12, arm.n))
    counts = [len(arm.ik(T).all_q) for T in arm.fk(q)]
    return [f"{max(counts)} for {said.group(1)}"] if max(counts) > int(said.group(1)) else []


def _at_postures(arm: Arm, ik, case) -> list[str]:
    """At a degenerate posture the formulas give it back with what is free chosen, and reach nothing else."""
    bad = []
    T = arm.fk(case.postures)
    found = ik.form.solved(T, case.postures)
    rows, undecided = found.q, np.zeros(len(T), dtype=bool)
    for way in found.ways.values():  # where the page says that no formula decides, evaluate gives nothing
        undecided |= (way == UNDECIDED).any(axis=0)
    turns = np.array([kind == "R" for kind in arm.joint_types])
    gap = rows - case.postures
    gap = np.abs(np.where(turns, np.angle(np.exp(1j * gap)), gap)).max(axis=2)
    nearest = np.nan_to_num(gap, nan=np.inf).min(axis=0)
    nearest = nearest[~undecided]
    if not (nearest < SAME).all() and (case.kind == FREE or case.chosen is not None):
        bad.append(f"a posture is not given back, off by {nearest.max():.1e}")
    real = np.isfinite(rows).all(axis=2)
    given = ["noap".index(c) for c in ik.form.given]
    size = np.array([1.0, 1.0, 1.0, max(1.0, np.abs(T[:, :3, 3]).max())])  # of 350 m no more digits are to be had
    miss = (np.abs(arm.fk(np.nan_to_num(rows)) - T)[..., :3, :] / size)[..., given].max(axis=(2, 3))
    if miss[real].max(initial=0.0) >= MISSED:
        bad.append(f"a real choice of signs misses the pose by {miss[real].max():.1e}")
    if case.kind == FREE and not ik.form.chosen:
        for q in case.postures[:1]:
            if not arm.ik(arm.fk(q)).self_motions:
                bad.append("called free, and the solver finds nothing that moves")
    return bad
