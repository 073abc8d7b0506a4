"""How long a plan takes: every arm of the catalogue with every task, and random arms of 2 to 10 and of 30 joints.

Usage: python -m benchmarks.measure.planning [--seed 0] [--arms 4]

Prints the slowest, in processor time, the solver's preparation included.
"""

from __future__ import annotations

import argparse
import time

import numpy as np

import pieper
from pieper import DH, Arm
from pieper.solver.plan.classify import make_plan

TASKS = (None, "pose", "position", "position+axis")


def random_arm(rng: np.random.Generator, joints: int, kind: str) -> Arm:
    """Return an arm of a kind: "turning" (general, revolute), "mixed" (R and P), "square" (R and P, right angles)."""
    types = "R" * joints if kind == "turning" else "".join(rng.choice(list("RRRP"), joints))
    if kind == "square":
        quarter = np.pi / 2
        rows = [DH(rng.choice([0, 0.3, 0.2]), rng.choice([0, quarter, -quarter]), rng.choice([0, 0.3])) for _ in types]
    else:
        rows = [DH(rng.uniform(-0.5, 0.5), rng.uniform(-3, 3), rng.uniform(-0.5, 0.5)) for _ in types]
    return Arm.from_dh(rows, convention="standard", joint_types=types, name=f"{kind} {types}")


def timed(arm: Arm, task: str | None) -> float | None:
    """Return the processor time (s) of a plan and its solver, or None where the arm cannot have the task."""
    start = time.process_time()
    try:
        _ = make_plan(arm.chain, arm.description, task=task).solver
    except pieper.PlanError:
        return None
    return time.process_time() - start


def main() -> None:
    """Plan them all and print the slowest."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--arms", type=int, default=4)
    args = parser.parse_args()
    rng = np.random.default_rng(args.seed)
    kinds = ("turning", "mixed", "square")
    made = [random_arm(rng, n, kind) for n in range(2, 11) for kind in kinds for _ in range(args.arms)]
    made += [random_arm(rng, 30, kind) for kind in kinds]
    for arms, what in (([pieper.load(name) for name in pieper.catalog()], "catalogue"), (made, "random")):
        for arm in arms[:3]:
            timed(arm, None)  # modules that load on first use are not the arm's doing
        spent = [(timed(arm, task), arm.name, task) for arm in arms for task in TASKS]
        done = [(seconds, name, task) for seconds, name, task in spent if seconds is not None]
        done.sort(key=lambda entry: -entry[0])
        times = 1e3 * np.array([entry[0] for entry in done])
        print(f"{what}: {len(done)} plans, {len(spent) - len(done)} refused, median {np.median(times):.1f} ms")
        for seconds, name, task in done[:5]:
            print(f"  {1e3 * seconds:.1f} ms: {name}, task {task or 'by default'}")


if __name__ == "__main__":
    main()
