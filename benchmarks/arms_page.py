"""Write docs/arms.md: every arm of the catalogue with its plan, number of solutions, recall and speed, as measured now.

Usage: python benchmarks/arms_page.py [--poses 2000]
"""

from __future__ import annotations

import argparse
import time
from pathlib import Path

import numpy as np

import pieper

HEAD = """# The arms of the catalogue

One line an arm, written by `python benchmarks/arms_page.py`. *Counts*: how many solutions random joint vectors' poses
have (limits not applied), as smallest to largest and mean. *Missed*: generating joint vectors not found again within
1e-6. *us*: time a pose in `ik_many`, one thread, on a shared machine; only the ratios between lines mean something.
Redundant arms: at the generating value of the spare joint.

| arm | joints | task | family | spare | most | counts (mean) | missed | us |
|---|---|---|---|---|---|---|---|---|
"""


def row(name: str, count: int) -> str:
    """Measure one arm and return its line."""
    arm = pieper.load(name)
    plan = arm.plan
    span = np.where(plan.prismatic, plan.chain.length, np.pi)
    q = span * np.random.default_rng(0).uniform(-1, 1, (count, arm.n))
    for j in plan.reduction.locked:
        if j < arm.n:
            lower, upper = arm.limits[j]
            q[:, j] = np.clip(0.37 if plan.reduction.at_ends is None else q[:, j], lower, upper)
    T = arm.fk(q)
    values = q[:, [j for j in plan.reduction.locked if j < arm.n]] if plan.redundancy else None
    arm.ik_many(T[:10], threads=1, redundancy=None if values is None else values[:10])
    start = time.perf_counter()
    found = arm.ik_many(T, threads=1, redundancy=values)
    spent = 1e6 * (time.perf_counter() - start) / count
    gap = np.where(plan.prismatic, found.q - q[:, None], (found.q - q[:, None] + np.pi) % (2 * np.pi) - np.pi)
    missed = int(np.sum(~((np.abs(gap).max(-1) < 1e-6) & found.valid).any(1)))
    counts = found.count
    spare = ", ".join(plan.redundancy)
    return (
        f"| {name} | {arm.joint_types} | {plan.task} | {plan.family} | {spare} | {plan.max_solutions} | "
        f"{counts.min()} to {counts.max()} ({counts.mean():.2f}) | {missed} of {count} | {spent:.3g} |\n"
    )


def main() -> None:
    """Measure all arms and write the page whole."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--poses", type=int, default=2000)
    args = parser.parse_args()
    text = HEAD
    for name in pieper.catalog():
        text += row(name, args.poses)
        print(text.splitlines()[-1], flush=True)
    page = Path(__file__).resolve().parents[1] / "docs" / "arms.md"
    part = page.with_suffix(".part")
    part.write_text(text)
    part.replace(page)


if __name__ == "__main__":
    main()
