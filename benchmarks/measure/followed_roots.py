"""Hold sets of solutions against the ends of sixteen complex paths: a second complete method, with no random starts.

Usage: python -m benchmarks.measure.followed_roots [--poses 200] [--arms NAME ...] [--out FILE]

See oracle/homotopy.py. Ctrl-C stops after the arm at hand; the same command goes on from there.
"""

from __future__ import annotations

import argparse
import json
import signal
import time
from collections import Counter
from pathlib import Path

import numpy as np

from benchmarks.kept import RESULTS, write
from benchmarks.measure.completeness import ARMS
from benchmarks.measure.random_arms import joint_vectors, poses
from oracle import machine, polish
from oracle.homotopy import all_solutions, apart, kept

#: An end is real when its imaginary parts are smaller than this and rounding: a double root of sigma splits by 1e-8.
REAL = 1e-7
NAMES = [name for name in ARMS if not name.startswith(("stanford", "franka", "rrp", "wrist", "plane"))]


def held_against(name: str, count: int, begin) -> dict:
    """Return the counts of one arm."""
    arm = ARMS[name]()
    m = machine(arm)
    q = joint_vectors(arm, 99, count, m.unit)
    T = poses(m, q)
    clock = time.process_time()
    x, arrived, doubtful = all_solutions(arm, m, q, begin)
    out: dict = {"poses": count, "ms_a_pose": 1e3 * (time.process_time() - clock) / count}
    many = arm.ik_many(T, threads=1)
    ends = Counter(arrived.sum(1).tolist())
    out |= {"family": arm.plan.family, "ends": {str(k): v for k, v in sorted(ends.items())}}
    out |= {"doubtful": int(doubtful.sum()), "real": 0, "missing": 0, "unseen": 0, "generating_unseen": 0, "cases": []}
    for i in range(count):
        real = x[i][arrived[i] & (np.abs(x[i].imag).max(1) < REAL)].real
        rows = many.q[i][many.valid[i]]
        sigma = polish(m, m.pose(T[i]), m.inner(np.concatenate([real, rows])), rounds=0)[2]
        wide = 1e-6 + 1e-14 / sigma.min()
        missing = [r.tolist() for r in real if not (apart(rows, r) < wide).any()]
        unseen = [r.tolist() for r in rows if not (apart(real, r) < wide).any()]
        out["real"] += len(real)
        out["missing"] += len(missing)
        out["unseen"] += len(unseen)
        out["generating_unseen"] += not (apart(real, q[i]) < wide).any()
        if missing or unseen:
            out["cases"].append({"pose": i, "missing": missing, "unseen": unseen, "sigma": float(sigma.min())})
    return out


def main() -> None:
    """Judge each arm and write the file."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--poses", type=int, default=200)
    parser.add_argument("--arms", nargs="*", default=NAMES)
    parser.add_argument("--out", type=Path, default=RESULTS / "followed_roots.json")
    args = parser.parse_args()
    state = json.loads(args.out.read_text()) if args.out.exists() else {"arms": {}}
    stop = Counter()
    signal.signal(signal.SIGINT, lambda *_: stop.update(now=1))
    begin = kept()
    for name in args.arms:
        if stop:
            break
        if name not in state["arms"] or state["arms"][name]["poses"] < args.poses:
            state["arms"][name] = held_against(name, args.poses, begin)
            write(state, args.out)
        print(f"{name}: {json.dumps(state['arms'][name])[:400]}", flush=True)


if __name__ == "__main__":
    main()
