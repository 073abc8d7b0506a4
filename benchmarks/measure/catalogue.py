"""Measure every arm of the catalogue: its plan, how many solutions, recall and speed.

Usage: python -m benchmarks.measure.catalogue [--poses 2000] [--again] [--seconds 120]

Arms that have a line keep it unless they were changed since or it is asked for again; with a time limit what was
measured until then is written, and the next call goes on. The time is the processor's, so that a busy machine does not
count.
"""

from __future__ import annotations

import argparse
import hashlib
import time

import numpy as np

import pieper
from benchmarks.kept import RESULTS, read, write
from oracle.joints import around


def fingerprint(arm: pieper.Arm) -> str:
    """Return a checksum of what the numbers of an arm rest on: how it moves, and its limits, to twelve decimals."""
    found = hashlib.sha256(arm.joint_types.encode())
    for array in (arm.limits, arm.coupling, arm.frames(np.vstack([np.zeros(arm.n), np.eye(arm.n)]))):
        found.update(repr((np.round(array, 12) + 0.0).tolist()).encode())
    return found.hexdigest()[:16]


def measured(name: str, count: int) -> dict:
    """Measure one arm."""
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
    start = time.process_time()
    found = arm.ik_many(T, threads=1, redundancy=values)
    spent = 1e6 * (time.process_time() - start) / count
    gap = np.where(plan.prismatic, found.q - q[:, None], around(found.q - q[:, None]))
    missed = int(np.sum(~((np.abs(gap).max(-1) < 1e-6) & found.valid).any(1)))
    counts = found.count
    return {
        "arm": name,
        "joints": arm.joint_types,
        "task": plan.task,
        "family": plan.family,
        "spare": list(plan.redundancy),
        "most": plan.count.most,
        "fewest": int(counts.min()),
        "largest": int(counts.max()),
        "mean": round(float(counts.mean()), 2),
        "missed": missed,
        "poses": count,
        "us_a_pose": float(f"{spent:.3g}"),
        "sha256": fingerprint(arm),
    }


def main() -> None:
    """Measure all arms and write the result whole."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--poses", type=int, default=2000)
    parser.add_argument("--again", action="store_true", help="measure arms that have a line too")
    parser.add_argument("--seconds", type=float, default=np.inf, help="of processor time, after which no arm is begun")
    args = parser.parse_args()
    kept = {row["arm"]: row for row in (read("catalogue") or {"rows": []})["rows"]}
    for name in pieper.catalog():
        if time.process_time() > args.seconds:
            break
        if args.again or name not in kept or kept[name].get("sha256") != fingerprint(pieper.load(name)):
            kept[name] = measured(name, args.poses)
            print(kept[name], flush=True)
    rows = [kept[name] for name in pieper.catalog() if name in kept]
    write({"rows": rows}, RESULTS / "catalogue.json", indent=1)


if __name__ == "__main__":
    main()
