"""Hold whole sets of solutions against a multi-start search that shares nothing with the solver.

Usage: python -m benchmarks.measure.completeness [--poses 2000] [--starts 1500] [--arms NAME ...] [--out FILE]

Poses are those of random joint vectors, made by the oracle's own product of matrices (oracle/). Each is searched
from at least 1,500 random starts, and from more while its rarest solution was met fewer than eight times. Ctrl-C stops
after the pose at hand and writes the file whole; the same command goes on from there. `make pages` writes
docs/completeness.md.
"""

from __future__ import annotations

import argparse
import json
import signal
import tempfile
import time
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np

import pieper
from benchmarks.kept import RESULTS, write
from benchmarks.measure.random_arms import joint_vectors, poses
from oracle import DOUBLE, Found, build, compare, locked, machine, polish, whole_set
from oracle.arms import tables
from oracle.arms.chains import plane_arm, wrist_arm
from oracle.arms.gauge import from_chain
from oracle.arms.known import free, tabled

CHUNK = 100


def chained(kind, seed: int, *how):
    """Return an arm of a closed-form family, written as a table that looks nothing like the chain it came from."""
    return from_chain(kind(np.random.default_rng(seed), *how))


#: name -> how to make the arm. The first group is general, the second closed forms wherever they can stand.
ARMS = {
    "motoman-ea1400n": lambda: tabled("motoman-ea1400n"),
    "fanuc-crx-10ia": lambda: tabled("fanuc-crx-10ia"),
    "random-6r": lambda: tabled("random-6r"),
    "ur5e": lambda: tabled("ur5e"),
    **{name: (lambda name=name: tabled(name)) for name in tables.TABLES if "calibrated" in name},
    "motoman-hc10": lambda: free("motoman-hc10"),
    "kinova-jaco-j2n6": lambda: free("kinova-jaco-j2n6"),
    "stanford-arm": lambda: free("stanford-arm"),
    "franka-panda, joint 7 held": lambda: free("franka-panda"),
    "denso-vp6242": lambda: tabled("denso-vp6242"),
    "puma-560": lambda: tabled("puma-560"),
    "rrp-wrist": lambda: free("rrp-wrist"),
    "wrist at the base, RRR": lambda: chained(wrist_arm, 1, 0, "RRR", False),
    "wrist inside, RRR": lambda: chained(wrist_arm, 2, 2, "RRR", False),
    "wrist at the end, any RRR": lambda: chained(wrist_arm, 3, 3, "RRR", False),
    "wrist at the end, RPR": lambda: chained(wrist_arm, 4, 3, "RPR", False),
    "wrist inside, PRP": lambda: chained(wrist_arm, 5, 1, "PRP", False),
    "wrist at the end, PPP": lambda: chained(wrist_arm, 6, 3, "PPP", False),
    "plane RRR at 1 to 3": lambda: chained(plane_arm, 7, 0, "RRRRRR", False),
    "plane RRR at 3 to 5": lambda: chained(plane_arm, 8, 2, "RRRRRR", False),
    "plane RPR at 2 to 4": lambda: chained(plane_arm, 9, 1, "RRPRRR", False),
    "plane PRP at 4 to 6": lambda: chained(plane_arm, 10, 3, "RRRPRP", False),
}


def begun(arm) -> dict:
    """Return the counts of an arm that has not begun."""
    sums = ("poses", "solutions", "missing", "generating_missed", "extra", "unseen", "odd", "odd_at_double_root")
    more = ("uncertain", "singular", "ik_differs", "starts_beyond", "crowded")
    plan = arm.plan
    start = dict.fromkeys((*sums, *more), 0)
    return start | {
        "family": plan.family,
        "types": arm.joint_types,
        "held": list(plan.redundancy),
        "counts": {},
        "cases": [],
        "seconds": 0.0,
        "fewest": 10**9,
    }


def chunk(arm, name: str, state: dict, count: int, starts: int, library) -> None:
    """Judge `count` more poses of an arm."""
    m = machine(arm)
    first = state["poses"]
    rng = np.random.default_rng([sorted(ARMS).index(name), first])
    q = joint_vectors(arm, int(rng.integers(2**31)), count, m.unit)
    held = [list(arm.joint_names).index(h) for h in state["held"]]
    chosen = {}
    if held:
        q[:, held] = q[0, held]  # one value a chunk
        chosen = {"redundancy": q[0, held]}
    T = poses(m, q)
    rest = m
    for j in sorted(held, reverse=True):
        rest = locked(rest, j, m.inner(q)[0, j])
    many = arm.ik_many(T, threads=1, **chosen)
    free_joints = [j for j in range(arm.n) if j not in held]
    begin = time.perf_counter()
    for i in range(count):
        rows = many.q[i][many.valid[i]]
        if i % 20 == 0:
            alone = arm.ik(T[i], **chosen).all_q
            same = len(alone) == len(rows) and (
                not len(rows) or np.abs(np.sort(alone, 0) - np.sort(rows, 0)).max() < 1e-9
            )
            state["ik_differs"] += not same
        rows = rows[:, free_joints]
        how: dict[str, Any] = {"library": library, "rng": np.random.default_rng([first + i, 1]), "least": starts}
        found = whole_set(rest, T[i], **how)
        verdict = compare(rest, T[i], rows, found)
        if verdict.unseen:  # the search was too short: begin again, and longer
            state["starts_beyond"] += 1
            found = whole_set(rest, T[i], **{**how, "least": 16 * starts, "most": 64 * starts})
            verdict = compare(rest, T[i], rows, found)
        made = compare(rest, T[i], rows, generating(rest, T[i], q[i, free_joints]))
        state["poses"] += 1
        state["solutions"] += len(found.q)
        state["missing"] += len(verdict.missing)
        state["generating_missed"] += len(made.missing)
        state["extra"] += len(verdict.extra)
        state["unseen"] += len(verdict.unseen)
        state["crowded"] += found.crowded
        state["fewest"] = min(state["fewest"], found.fewest) if len(found.q) else state["fewest"]
        state["counts"][str(len(rows))] = state["counts"].get(str(len(rows)), 0) + 1
        status = int(many.status[i])
        state["uncertain"] += status == pieper.Status.UNCERTAIN
        state["singular"] += status == pieper.Status.SINGULAR
        odd = len(rows) % 2 == 1
        state["odd"] += odd
        state["odd_at_double_root"] += odd and verdict.sigma < DOUBLE
        if verdict.missing or verdict.extra or verdict.unseen or made.missing or odd:
            case = {"pose": first + i, "q": q[i].tolist(), "rows": len(rows), "status": pieper.Status(status).name}
            case |= {
                "missing": verdict.missing,
                "extra": verdict.extra,
                "unseen": verdict.unseen,
                "sigma": verdict.sigma,
            }
            state["cases"] = [*state["cases"], case][:50]
            print(f"{name}: {json.dumps(case)[:600]}", flush=True)
    state["seconds"] += time.perf_counter() - begin


def generating(m, T, q):
    """Return the joint vector that made the pose as if it had been searched for."""
    v = m.inner(q[None])
    _, residual, sigma = polish(m, m.pose(T), v, 0, rounds=0)
    return Found(q[None], np.ones(1, int), sigma, residual, False)


def main() -> None:
    """Go on from the file, or begin."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--poses", type=int, default=2000)
    parser.add_argument("--starts", type=int, default=1500)
    parser.add_argument("--arms", nargs="*", default=list(ARMS))
    parser.add_argument("--out", type=Path, default=RESULTS / "completeness.json")
    args = parser.parse_args()
    state = json.loads(args.out.read_text()) if args.out.exists() else {"starts": args.starts, "arms": {}}
    stop = Counter()
    signal.signal(signal.SIGINT, lambda *_: stop.update(now=1))
    with tempfile.TemporaryDirectory() as folder:
        library = build(folder)
        for name in args.arms:
            arm = ARMS[name]()
            mine = state["arms"].setdefault(name, begun(arm))
            while mine["poses"] < args.poses and not stop:
                chunk(arm, name, mine, min(CHUNK, args.poses - mine["poses"]), args.starts, library)
                write(state, args.out)
            shown = {k: v for k, v in mine.items() if k not in ("cases", "counts")}
            print(f"{name}: {json.dumps(shown)}", flush=True)


if __name__ == "__main__":
    main()
