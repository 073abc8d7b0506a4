"""Measure one contestant on one arm, in the environment this runs in; prints one JSON line.

Usage: python -m benchmarks.measure.worker CONTESTANT CASE.npz

The case is a file (what `Case` says, with joint vectors and their poses), not an import: a peer's environment holds
neither this package nor the oracle.
"""

import json
import sys
import time

import numpy as np

from benchmarks.measure.contestants import CONTESTANTS, Case


def best_of(call, threads=1, rounds=5, least=0.05):
    """Return the smallest seconds a call takes over rounds; of one thread processor time, which others do not spoil."""
    clock = time.process_time if threads == 1 else time.perf_counter
    call()
    best = np.inf
    for _ in range(rounds):
        start, done = clock(), 0
        while clock() - start < least or not done:
            t = clock()
            call()
            best = min(best, clock() - t)
            done += 1
    return best


def main(name, path):
    """Measure and print."""
    with np.load(path) as kept:
        case = Case(str(kept["arm"]), kept["table"], bool(kept["general"]))
        q, T = kept["q"], kept["T"]
    count = len(q)
    out = {"contestant": name, "arm": case.arm, "poses": count}
    try:
        contestant = CONTESTANTS[name](case)
    except NotImplementedError as reason:
        print(json.dumps(out | {"unsupported": str(reason)}))
        return
    if hasattr(contestant, "poses"):
        q, T = contestant.poses(count)
    few = [np.ascontiguousarray(t) for t in T[: getattr(contestant, "few", 2000)]]
    times = np.empty(len(few))
    for i, pose in enumerate(few):
        contestant.single(pose)
        t = time.perf_counter()
        contestant.single(pose)
        times[i] = time.perf_counter() - t
    out["single_us"] = 1e6 * float(np.median(times))
    found = missed = 0
    for i in range(0, len(few), 4):
        rows = contestant.rows(contestant.single(few[i]))
        gap = np.abs((rows - q[i] + np.pi) % (2 * np.pi) - np.pi)
        missed += not (len(rows) and (gap.max(-1) < 1e-6).any())
        found += len(rows)
    out["solutions_a_pose"], out["missed"], out["checked"] = found / (len(few) / 4), missed, len(few) // 4
    for threads in contestant.batch_threads:
        out[f"batch_ns_{threads}"] = 1e9 * best_of(contestant.batch(T, threads), threads) / count
    if hasattr(contestant, "batch_into"):
        away = np.array(T)
        away[:, :3, 3] *= 20  # out of reach, whatever the arm
        for threads in contestant.batch_threads:
            out[f"into_ns_{threads}"] = 1e9 * best_of(contestant.batch_into(T, threads), threads) / count
        out["away_ns"] = 1e9 * best_of(contestant.batch_into(away, 1)) / count
    if hasattr(contestant, "fk"):
        many = np.tile(q, (max(1, 10**5 // count), 1))
        out["fk_per_s"] = len(many) / best_of(contestant.fk(many))
        out["jacobian_per_s"] = len(many) / best_of(contestant.jacobian(many))
    print(json.dumps(out))


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])
