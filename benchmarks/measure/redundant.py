"""Seven-joint arms: 128 values of the redundant coordinate beside their six-joint family, and the arm angle.

Usage: python -m benchmarks.measure.redundant [--rounds 25]

Prints a table. *6R*: the six-joint chain that the arm becomes when its spare joint is held, on the same 128 problems,
where they are in reach. All on one thread, in one run; on a shared machine only the ratios within a line count.
"""

from __future__ import annotations

import argparse
import time
from types import SimpleNamespace
from typing import Any

import numpy as np

import pieper
from pieper.solver import verbs as solve
from pieper.solver.plan.classify import make_plan

VALUES = 128
COLUMNS = (
    "arm",
    "family",
    "held",
    "6R ik, us",
    "6R ik_many, us a pose",
    f"{VALUES} values, us each",
    "over ik_many",
    "over ik",
    "arm angle, us each",
)


def fastest(calls: list, rounds: int) -> np.ndarray:
    """Return the shortest time (s) of each call, called in turn."""
    best = np.full(len(calls), np.inf)
    for _ in range(rounds):
        for i, call in enumerate(calls):
            start = time.perf_counter()
            call()
            best[i] = min(best[i], time.perf_counter() - start)
    return best


def row(name: str, rounds: int) -> str:
    """Measure one arm and return its line."""
    arm = pieper.load(name)
    plan, reduction = arm.plan, arm.plan.reduction
    joint = reduction.locked[0]
    T = arm.fk(np.random.default_rng(0).uniform(-1, 1, 7))
    low, high = np.clip(arm.limits[joint], -np.pi, np.pi)
    values = np.linspace(low, high, VALUES)
    poses = np.tile(T, (VALUES, 1, 1))
    found = arm.ik_many(poses, threads=1, redundancy=values)
    # out of reach a six-joint arm is looked at with care, which is not what is compared
    reached = np.flatnonzero(found.valid.any(1))
    six_poses = np.ascontiguousarray(reduction.moved_pose(poses, values[:, None])[np.resize(reached, VALUES)])
    names = tuple(f"joint_{k}" for k in range(6))
    described: Any = SimpleNamespace(name=name, limits=arm.limits[reduction.kept], joint_names=names, base=np.eye(4))
    six = make_plan(reduction.six(plan.defaults), described)
    few = 1 if plan.arm_angle is not None and plan.arm_angle.spherical else 16
    angles = np.linspace(-3, 3, VALUES)[::few]
    one, many, swept = fastest(
        [
            lambda: solve.ik(six, six_poses[0]),
            lambda: solve.ik_many(six, six_poses, 1),
            lambda: arm.ik_many(poses, threads=1, redundancy=values),
        ],
        rounds,
    )
    (turned,) = fastest(
        [lambda: arm.ik_many(poses[::few], threads=1, redundancy={"arm angle": angles})], max(1, rounds // few)
    )
    one, many, swept, turned = 1e6 * np.array([one, many / VALUES, swept / VALUES, turned / len(angles)])
    return (
        f"| {name} | {plan.family} | {plan.redundancy[0]} | {one:.2f} | {many:.2f} | {swept:.2f} "
        f"| {swept / many:.2f} | {swept / one:.2f} | {turned:.3g} |"
    )


def main() -> None:
    """Measure every seven-joint arm of the catalogue."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--rounds", type=int, default=25)
    args = parser.parse_args()
    print(f"| {' | '.join(COLUMNS)} |\n|{'---|' * len(COLUMNS)}", flush=True)
    for name in pieper.catalog():
        if pieper.load(name).n == 7:
            print(row(name, args.rounds), flush=True)


if __name__ == "__main__":
    main()
