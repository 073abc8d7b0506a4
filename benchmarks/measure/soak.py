"""Random arms, tasks, limits and poses, one law after the other, until time is up or the first law is broken.

Usage: python -m benchmarks.measure.soak [--minutes 60] [--seed 0] [--out FILE]

A round is made again from its seed alone: `--seed N --minutes 0` runs round N and no other. The first broken law ends
the run with exit status 1: which law, what was seen, and the seed, which the file keeps beside how many rounds held.
"""

from __future__ import annotations

import argparse
import pickle
import sys
import time
import warnings
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

import pieper
from benchmarks.kept import RESULTS, write
from oracle import slow_forward
from oracle.arms.numbered import random_arm, turned
from pieper import Arm, PlanError, Status

#: Poses of an arm, and of these how many are asked one by one; of arms with joints to spare fewer, since these trace.
POSES, ALONE, ALONE_SPARE = 24, 4, 1
#: How far a row may miss its pose (per length; rad).
CLOSES = 1e-8
#: Two ways to one answer differ by rounding alone.
ALIKE = 1e-9
#: A joint vector that made a pose is met by `nearest` within this (rad; per length), and within rounding over sigma.
MET, ROUNDED = 1e-6, 1e-13
#: Relative sigma below which a solution is one of several that merge, of which one is told.
MERGED = 1e-5
#: A position this many arm lengths away is out of reach of any arm without slides.
FAR = 50.0


class BrokenError(Exception):
    """A law does not hold."""


def holds(law: bool, name: str, **seen: Any) -> None:
    """Raise where a law does not hold.

    Raises:
        BrokenError: With the law's name and what was seen.
    """
    if not law:
        raise BrokenError(f"{name}: " + ", ".join(f"{key} = {value}" for key, value in seen.items()))


def drawn(rng: np.random.Generator) -> tuple[Arm, str]:
    """Return an arm with limits, and what it is: of the catalogue, or one of no name with four to eight joints."""
    if rng.uniform() < 0.3:
        name = str(rng.choice(pieper.catalog()))
        arm, words = pieper.load(name), name
    else:
        joints = int(rng.choice([4, 5, 6, 7, 8], p=[0.1, 0.15, 0.45, 0.2, 0.1]))
        arm, words = random_arm(int(rng.integers(1_000_000)), joints)
    kind = int(rng.integers(4))
    if kind:
        unit = np.where(arm.chain.prismatic, arm.chain.length, 1.0)
        width = np.array([[0.05, 1.0], [1.0, 3.0], [3.2, 6.2]][kind - 1])
        half = np.exp(rng.uniform(np.log(width[0]), np.log(width[1]), arm.n)) * unit
        centre = rng.uniform(-1.5, 1.5, arm.n) * unit
        arm = Arm(replace(arm.description, limits=np.c_[centre - half, centre + half]))
    return arm, f"{words}, limits of kind {kind}"


def postures(arm: Arm, rng: np.random.Generator) -> np.ndarray:
    """Return joint vectors (POSES, n) inside the limits: any, and some with joints at limits or quarters of a turn."""
    unit = np.where(arm.chain.prismatic, arm.chain.length, np.pi)
    low = np.where(np.isfinite(arm.limits[:, 0]), arm.limits[:, 0], -unit)
    high = np.where(np.isfinite(arm.limits[:, 1]), arm.limits[:, 1], np.maximum(unit, low + unit))
    q = rng.uniform(low, high, (POSES, arm.n))
    for row in q[POSES // 2 :]:
        for joint in rng.choice(arm.n, rng.integers(1, 3), replace=False):
            special = rng.choice(np.array([low[joint], high[joint], 0.0, np.pi / 2, -np.pi / 2, np.pi]))
            row[joint] = np.clip(special, low[joint], high[joint])
    return q


def away(arm: Arm, a: np.ndarray, b: np.ndarray) -> float:
    """Return the distance of two joint vectors as they stand, without units."""
    return float(np.linalg.norm((a - b) / np.where(arm.chain.prismatic, arm.chain.length, 1.0)))


def closes(arm: Arm, q: np.ndarray, T: np.ndarray, task: str, name: str) -> None:
    """Look whether joint vectors (m, n) hold a pose by the oracle's product of matrices, as far as the task asks."""
    there = slow_forward.fk(arm.chain, q)
    miss = np.linalg.norm(there[:, :3, 3] - T[:3, 3], axis=1) / arm.chain.length
    if task == "pose":
        miss = np.maximum(miss, np.abs(there[:, :3, :3] - T[:3, :3]).max((1, 2), initial=0.0))
    if task == "position+axis":
        miss = np.maximum(miss, np.abs(there[:, :3, 2] - T[:3, 2]).max(1, initial=0.0))
    holds(miss.max(initial=0.0) < CLOSES, name, miss=miss.max(initial=0.0))


def sigma(arm: Arm, q: np.ndarray) -> float:
    """Return the smallest relative singular value of the oracle's Jacobian without units."""
    J = slow_forward.jacobian(arm.chain, q)
    J[:3] /= arm.chain.length
    s = np.linalg.svd(np.where(arm.chain.prismatic, J * arm.chain.length, J), compute_uv=False)
    return float(s[-1] / s[0])


def one_round(seed: int) -> str:
    """Hold one arm against every law; return what it was and how many poses were not certain.

    Raises:
        BrokenError: A law does not hold.
    """
    rng = np.random.default_rng([31, seed])
    arm, words = drawn(rng)
    tasks = ["pose", "position", "position+axis"] if arm.n < 7 and rng.uniform() < 0.3 else [None]
    uncertain = 0
    for asked in tasks:
        try:
            plan = arm.plan if asked is None else arm.plan_for(asked)
        except PlanError as refused:
            words += f"; {asked or 'its task'} refused: {str(refused)[:60]}"
            continue
        uncertain += laws(arm, plan.task, bool(plan.redundancy), asked, rng)
    return f"{words}; {uncertain} uncertain"


def laws(arm: Arm, task: str, spare: bool, asked: str | None, rng: np.random.Generator) -> int:
    """Hold an arm's answers for one task against every law; return how many poses were not certain."""
    q = postures(arm, rng)
    T = slow_forward.fk(arm.chain, q)
    how: dict[str, Any] = {} if asked is None else {"task": asked}
    many = arm.ik_many(T, threads=1, near=q, **how)
    denied = np.isin(many.status, [Status.OUT_OF_REACH, Status.OUTSIDE_LIMITS, Status.INVALID])
    at = np.flatnonzero(denied)
    holds(not denied.any(), "a pose that was made inside has an answer", task=task, pose=at[:5], q=q[at[:1]].tolist())
    order = rng.permutation(len(T))
    again = arm.ik_many(T[order], threads=2, **how)
    same = (again.status == many.status[order]).all() and np.array_equal(again.valid, many.valid[order])
    holds(same and np.abs(again.q - many.q[order]).max() < ALIKE, "no order changes an answer", task=task)
    copied = pickle.loads(pickle.dumps(again))
    holds(np.array_equal(copied.q, again.q) and np.array_equal(copied.status, again.status), "a batch pickles")
    for i in range(len(T)):
        closes(arm, many.q[i][many.valid[i]], T[i], task, f"every row holds its pose ({task}, pose {i})")
    inside = many.q[many.in_limits]
    holds(bool(((inside >= arm.limits[:, 0] - 1e-8) & (inside <= arm.limits[:, 1] + 1e-8)).all()), "inside is inside")
    certain = many.status != Status.UNCERTAIN
    for i in rng.choice(len(T), ALONE_SPARE if spare else ALONE, replace=False):
        alone(arm, T[i], q[i], many, int(i), task, spare, how)
    if not arm.chain.prismatic.any():
        far = turned(rng, 1.0)
        far[:3, 3] = arm.chain.links[0][:3, 3] + FAR * arm.chain.length * (1 + arm.n)
        holds(arm.ik(far, **how).status == Status.OUT_OF_REACH, "what is far away is out of reach", task=task)
    return int((~certain).sum())


def alone(
    arm: Arm,
    T: np.ndarray,
    q: np.ndarray,
    many: pieper.SolutionBatch,
    i: int,
    task: str,
    spare: bool,
    how: dict[str, Any],
) -> None:
    """Hold one pose's answer against that of the batch, and its nearest posture against the one that made the pose."""
    sols = arm.ik(T, **how)
    holds(
        sols.status == many.status[i], "ik and ik_many say one status", task=task, one=sols.status, many=many.status[i]
    )
    rows = many.q[i][many.valid[i]]
    alike = len(rows) == len(sols.all_q) and np.allclose(rows, sols.all_q, atol=ALIKE)
    holds(alike, "ik and ik_many give one answer", task=task, pose=i, one=len(sols.all_q), many=len(rows))
    if sols.status == Status.UNCERTAIN:
        return
    nearest = sols.nearest(q)
    closes(arm, nearest[None], T, task, "the nearest holds the pose")
    weak = sigma(arm, q) if task == "pose" and not spare else 1.0
    if weak > MERGED:
        met = MET + ROUNDED / weak
        holds(away(arm, nearest, q) <= met, "the nearest to what made a pose is that", task=task, pose=i, q=q.tolist(),
              nearest=nearest.tolist(), sigma=weak)  # fmt: skip


def main() -> int:
    """Run rounds until time is up; return 1 where a law is broken."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--minutes", type=float, default=60.0)
    parser.add_argument("--seed", type=int, default=0, help="of the first round; each later one counts one more")
    parser.add_argument("--out", type=Path, default=RESULTS / "soak.json")
    args = parser.parse_args()
    warnings.simplefilter("ignore", pieper.PieperWarning)
    start, seed = time.monotonic(), args.seed
    state: dict[str, Any] = {"first": args.seed, "rounds": 0, "uncertain": 0, "broken": None}
    try:
        while True:
            began = time.process_time()
            said = one_round(seed)
            state["rounds"] += 1
            state["uncertain"] += int(said.rsplit(";", 1)[1].split()[0])
            print(f"round {seed}: {said}; {time.process_time() - began:.1f} s", flush=True)
            if time.monotonic() - start >= 60 * args.minutes:
                break
            seed += 1
    except KeyboardInterrupt:
        print("stopped", flush=True)
    except Exception as broken:  # whatever it is, the seed makes it again
        state["broken"] = {"seed": seed, "law": f"{type(broken).__name__}: {broken}"}
        print(f"round {seed} BROKEN: {broken}", flush=True)
    write(state, args.out, indent=1)
    return 1 if state["broken"] else 0


if __name__ == "__main__":
    sys.exit(main())
