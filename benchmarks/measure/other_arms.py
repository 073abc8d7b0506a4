"""Hold arms of one to five and of seven and eight joints, for every task, against the multi-start search.

Usage: python -m benchmarks.measure.other_arms [--arms 60] [--poses 3] [--joints 1 2 3 4 5 7 8] [--out FILE]

A redundant arm is asked at the generating values of its spare joints, and the search holds the same joints. Where the
task itself leaves the tool free to turn, the generating joint vector must lie on a family. Ctrl-C stops after the arm
at hand; the same command goes on from there.
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

from benchmarks.kept import RESULTS, write
from benchmarks.measure.random_arms import PATIENCE, joint_vectors, patience, poses
from oracle import TASKS, build, compare, equations, locked, machine, whole_set
from oracle.arms.numbered import random_arm

SUMS = (
    "arms",
    "poses",
    "solutions",
    "missing",
    "generating_missed",
    "extra",
    "unseen",
    "on_self_motions",
    "uncertain",
    "crowded",
    "failed",
    "refused",
)


def judged(arm, number: int, task: str, count: int, library) -> dict:
    """Return what came out of one arm and task."""
    out: dict = dict.fromkeys(SUMS, 0) | {"arms": 1, "cases": []}
    m = machine(arm)
    q = joint_vectors(arm, number, count, m.unit)
    T = poses(m, q)
    try:
        plan = arm.plan_for(task)
    except ValueError as error:
        return out | {"refused": 1, "cases": [str(error)]}
    names = list(arm.joint_names)
    held = [names.index(name) for name in plan.redundancy if name in names]
    turning = [name for name in plan.redundancy if name not in names]
    for i in range(count):
        chosen = {"redundancy": q[i, held]} if held and not turning else {}
        sols = arm.ik(T[i], task=task, **chosen)
        out["poses"] += 1
        out["uncertain"] += sols.status.name == "UNCERTAIN"
        case = {
            "pose": i,
            "q": q[i].tolist(),
            "status": sols.status.name,
            "rows": len(sols.all_q),
            "spare": list(plan.redundancy),
        }
        if turning:
            left = np.linalg.norm(equations(m, m.inner(sols.all_q), m.pose(T[i]), TASKS[task])[0], axis=1)
            bad = int((left > 1e-9).sum())
            out["extra"] += bad
            # with more than one spare coordinate the self-motions given are lines on a surface: q need not lie on one
            lost = len(plan.redundancy) == 1 and not any(f.contains(q[i], 1e-4) for f in sols.self_motions)
            out["generating_missed"] += lost
            out["on_self_motions"] += not lost
            if lost or bad or not len(sols.all_q):
                out["cases"].append(case | {"bad": bad})
            continue
        rest = m
        for j in sorted(held, reverse=True):
            rest = locked(rest, j, m.inner(q)[i, j])
        free = [j for j in range(arm.n) if j not in held]
        rows = sols.all_q[:, free]
        if not free:  # every joint is to spare: the chosen values are the answer
            out["generating_missed"] += len(sols.all_q) != 1
            continue
        how: dict[str, Any] = {
            "library": library,
            "rng": np.random.default_rng([number, i]),
            "task": task,
            "least": 600,
            "most": 12_000,
        }
        found = whole_set(rest, T[i], **how)
        verdict = compare(rest, T[i], rows, found, task)
        if verdict.unseen and not found.crowded:
            found = whole_set(rest, T[i], **{**how, "least": 10_000, "most": 40_000})
            verdict = compare(rest, T[i], rows, found, task)
        out["solutions"] += len(found.q)
        out["crowded"] += found.crowded
        missing = [x for x in verdict.missing if x[2] > 1e-5 or not found.crowded]
        if missing and sols.self_motions:
            full = np.repeat(q[i][None], len(missing), 0)
            full[:, free] = [x[0] for x in missing] if missing else full[:, free]
            missing = [
                x for x, p in zip(missing, full, strict=True) if not any(f.contains(p, 1e-4) for f in sols.self_motions)
            ]
        out["missing"] += len(missing)
        out["extra"] += len(verdict.extra)
        out["unseen"] += 0 if found.crowded else len(verdict.unseen)
        if missing or verdict.extra:
            out["cases"].append(case | {"missing": missing[:2], "extra": verdict.extra[:2]})
    return out


def main() -> None:
    """Go on from the file, or begin."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--arms", type=int, default=60)
    parser.add_argument("--poses", type=int, default=3)
    parser.add_argument("--joints", type=int, nargs="*", default=[1, 2, 3, 4, 5, 7, 8])
    parser.add_argument("--out", type=Path, default=RESULTS / "other_arms.json")
    args = parser.parse_args()
    state = (
        json.loads(args.out.read_text())
        if args.out.exists()
        else {"poses": args.poses, "rows": {}, "next": {}, "notable": []}
    )
    stop = Counter()
    signal.signal(signal.SIGINT, lambda *_: stop.update(now=1))
    said = time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        library = build(folder)
        for joints in args.joints:
            while state["next"].get(str(joints), 0) < args.arms and not stop:
                number = state["next"].get(str(joints), 0)
                arm, kind = random_arm(number, joints)
                for task in TASKS if joints < 7 else ("pose",):
                    try:
                        with patience(PATIENCE):
                            result = judged(arm, number, task, args.poses, library)
                    except Exception as error:  # whatever comes out is the finding
                        result = dict.fromkeys(SUMS, 0) | {
                            "arms": 1,
                            "failed": 1,
                            "cases": [f"{type(error).__name__}: {error}"],
                        }
                    row = state["rows"].setdefault(f"{joints} joints, {task}", dict.fromkeys(SUMS, 0))
                    for key in SUMS:
                        row[key] += int(result[key])
                    if result["cases"] or result["uncertain"]:
                        state["notable"].append(
                            {
                                "joints": joints,
                                "number": number,
                                "kind": kind,
                                "types": arm.joint_types,
                                "task": task,
                                **result,
                            }
                        )
                        print(json.dumps({k: v for k, v in state["notable"][-1].items() if v}), flush=True)
                state["next"][str(joints)] = number + 1
                if time.monotonic() - said > 10:
                    said = time.monotonic()
                    write(state, args.out)
            write(state, args.out)
            print({k: v for k, v in state["rows"].items() if k.startswith(f"{joints} ")}, flush=True)


if __name__ == "__main__":
    main()
