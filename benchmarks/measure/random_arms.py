"""Judge thousands of random arms: is the joint vector that made a pose found again, and what is said where it is not?

Usage: python -m benchmarks.measure.random_arms [--arms 5000] [--poses 100] [--joints 6] [--first 0] [--out FILE]

Poses come from the oracle's own product of matrices (oracle/). Ctrl-C stops the run after the arm at hand and
writes the file whole; the same command goes on from there. Every number in the file can be made again: an arm is
`oracle.arms.numbered.random_arm(number)`, its joint vectors are `joint_vectors(arm, number, poses)`.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import signal
import sys
import time
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.kept import RESULTS, write
from oracle import Machine, equations, forward, gap, machine
from oracle.arms.numbered import random_arm
from pieper import Arm, PlanError

#: A joint vector is found again within this, rad or arm lengths, ...
FOUND = 1e-6
#: ... and by this / sigma more, as rounding of a pose moves a solution whose smallest singular value is sigma.
ROUNDED = 1e-14
#: Below this smallest singular value two roots can be one within rounding, which is given once: an odd count.
DOUBLE = 1e-5
#: Seconds after which an arm is given up and reported.
PATIENCE = 120
#: Poses that share the values of the spare joints of a redundant arm.
VALUES = 10
#: Slides farther out than this many arm lengths are far away.
FAR = 100
SUMS = (
    "arms",
    "poses",
    "missed",
    "found_within_rounding",
    "odd",
    "odd_at_double_root",
    "odd_far_away",
    "uncertain",
    "singular",
    "wrong",
    "twice",
)


def joint_vectors(arm: Arm, number: int, count: int, unit: float) -> np.ndarray:
    """Return joint vectors (count, n): the whole turn, slides over one length of the arm to either side."""
    span = np.where(np.array(list(arm.joint_types)) == "P", unit, np.pi)
    return span * np.random.default_rng([7, number]).uniform(-1, 1, (count, arm.n))


def poses(m: Machine, q: np.ndarray) -> np.ndarray:
    """Return the poses (N, 4, 4) of joint vectors q (N, n), metres."""
    T = forward(m, m.inner(q))[0].copy()
    T[:, :3, 3] *= m.unit
    return T


def slopes(m: Machine, q: np.ndarray) -> np.ndarray:
    """Return Jacobians (N, 6, n) of q, lengths by the arm's size, from the oracle's axes and points."""
    P, z, o = forward(m, m.inner(q))
    turning = (~m.slides)[None, :, None]
    move = np.where(turning, np.cross(z, P[:, None, :3, 3] - o), z)
    return np.swapaxes(np.concatenate([move, np.where(turning, z, 0.0)], 2), 1, 2)


def smallest(J: np.ndarray) -> np.ndarray:
    """Return the smallest singular values of Jacobians (..., 6, k)."""
    return np.linalg.svd(J, compute_uv=False)[..., -1]


def rank(m: Machine, q: np.ndarray) -> int:
    """Return how many directions an arm can move in at a joint vector that is not special."""
    J = slopes(m, q)
    J = J / np.maximum(np.linalg.norm(J, axis=1, keepdims=True), 1e-300)
    s = np.linalg.svd(J, compute_uv=False)
    return int((s > 1e-9 * s[:, :1]).sum(1).max())


class Late(Exception):
    """An arm took longer than PATIENCE."""


@contextlib.contextmanager
def patience(seconds: float):
    """Raise Late in the block when it takes longer; only between calls of the native module."""

    def late(*_):
        raise Late(f"not done after {seconds:.0f} s")

    before = signal.signal(signal.SIGALRM, late)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def judged(arm: Arm, number: int, count: int) -> dict:
    """Return what came out of one arm: numbers to be added up, and lists of what must be looked at."""
    m = machine(arm)
    q = joint_vectors(arm, number, count, m.unit)
    T = poses(m, q)
    out: dict = dict.fromkeys(SUMS, 0) | {"arms": 1, "rank": rank(m, q[:5])}
    begin = time.process_time()
    try:
        plan = arm.plan
    except PlanError as error:
        return out | {"refused": str(error), "plan_ms": 1e3 * (time.process_time() - begin)}
    out |= {"plan_ms": 1e3 * (time.process_time() - begin), "family": plan.family, "poses": count}
    held = [list(arm.joint_names).index(name) for name in plan.redundancy]
    free = [j for j in range(arm.n) if j not in held]
    if held:  # a solver is prepared for each value: a few values, several poses each
        q[:, held] = q[np.arange(count) // VALUES * VALUES][:, held]
        T = poses(m, q)
    chosen: dict[str, Any] = {"redundancy": q[:, held]} if held else {}
    begin = time.process_time()
    many = arm.ik_many(T, threads=1, **chosen)
    out["us_a_pose"] = 1e6 * (time.process_time() - begin) / count
    out["held"] = len(held)
    found, inner = m.inner(many.q), m.inner(q)
    near = np.where(many.valid, gap(m, found, inner[:, None]), np.inf).min(1)
    # the unknowns of a pose are the joints that are not held, its equations as many as the arm can move in
    sigma = np.linalg.svd(slopes(m, q)[:, :, free], compute_uv=False)[:, min(out["rank"], len(free)) - 1]
    # a base or a tool far away rounds the pose more coarsely
    size = 1 + np.linalg.norm(T[:, :3, 3], axis=1) / m.unit
    wide = FOUND + ROUNDED * size / np.maximum(sigma, 1e-300)
    lost = np.flatnonzero(near > wide)
    names = [s.name for s in map(type(arm.ik(T[0]).status), many.status)]
    lost = [i for i in lost if not on_a_self_motion(arm, T[i], q[i], held)]
    out["missed"] = len(lost)
    out["lost"] = [
        {"pose": int(i), "sigma": float(sigma[i]), "near": float(min(near[i], 1e9)), "status": names[i]}
        for i in lost[:5]
    ]
    out["found_within_rounding"] = int(((near > FOUND) & (near <= wide)).sum())
    out["uncertain"], out["singular"] = names.count("UNCERTAIN"), names.count("SINGULAR")
    rows(arm, m, many, T, free, out)
    return out


def on_a_self_motion(arm: Arm, T, q, held) -> bool:
    """Return whether q lies on one of the self-motions of its pose."""
    try:
        sols = arm.ik(T, redundancy=q[held]) if held else arm.ik(T)
    except ValueError:
        return False
    return any(motion.contains(q, 1e-5) for motion in sols.self_motions)


def rows(arm: Arm, m: Machine, many, T, free, out) -> None:
    """Look at the answers themselves: do they close, is one given twice, is their number even."""
    which = np.repeat(np.arange(len(T)), many.valid.sum(1))
    answers = m.inner(many.q[many.valid])
    if not len(answers):
        return
    goal = np.stack([m.pose(t) for t in T])
    left = np.linalg.norm((forward(m, answers)[0] - goal[which])[:, :3].reshape(len(answers), -1), axis=1)
    size = 1 + np.linalg.norm(goal[which, :3, 3], axis=1)
    out["worst"] = float((left / size).max())
    out["wrong"] = int((left > 1e-9 * size).sum())
    sigma = smallest(slopes(m, m.outer(answers))[:, :, free])
    for i in range(len(T)):
        mine = np.flatnonzero(which == i)
        apart = gap(m, answers[mine][:, None], answers[mine][None]) + 9 * np.eye(len(mine))
        out["twice"] += int((np.triu(apart < 1e-7).any(1) & (sigma[mine] > 1e-5)).sum())
        if len(mine) % 2 == 0 or out["rank"] < 6:
            continue  # an arm that moves in fewer than six directions can have one solution, or three
        out["odd"] += 1
        if sigma[mine].min() < DOUBLE:
            out["odd_at_double_root"] += 1
        elif (elsewhere := far_away(m, goal[i], answers[mine])) % 2:
            out["odd_far_away"] += 1
        elif len(listed := out.setdefault("odd_poses", [])) < 3:
            listed.append([i, len(mine), float(sigma[mine].min()), elsewhere])


def far_away(m: Machine, goal, known) -> int:
    """Return how many solutions besides `known` (k, n) have slides 100 to 1e6 arm lengths out: plain Newton steps.

    Where slides are nearly parallel, one of a pair of solutions can be that far out.
    """
    if not m.slides.any():
        return 0
    rng = np.random.default_rng(0)
    v = rng.uniform(-np.pi, np.pi, (60, m.n))
    v[:, m.slides] = rng.standard_normal((60, m.slides.sum())) * 10 ** rng.uniform(0, 6, (60, 1))
    for _ in range(60):
        r, J = equations(m, v, goal)
        step = (np.linalg.pinv(J, rcond=1e-13) @ r[..., None])[..., 0]
        v = v - step * np.minimum(1, 0.5 / np.maximum(np.abs(step[:, ~m.slides]).max(1, initial=1e-9), 1e-9))[:, None]
    size = 1 + np.abs(v[:, m.slides]).max(1)
    v = v[(np.linalg.norm(equations(m, v, goal)[0], axis=1) < 1e-12 * size) & (size < 1e6)]
    count = 0
    while len(v):
        count += bool(np.abs(v[0, m.slides]).max() > FAR and gap(m, known, v[0]).min() > 1e-4 * FAR)
        v = v[gap(m, v, v[0]) > 1e-4 * (1 + np.abs(v[0, m.slides]).max())]
    return count


def notable(result: dict) -> bool:
    """Return whether an arm must be looked at by a person."""
    return bool(
        result.get("failed")
        or result.get("refused")
        or result["missed"]
        or result.get("odd_poses")
        or result["wrong"]
        or result["twice"]
        or result["uncertain"]
        or result["plan_ms"] > 1000
        or result.get("us_a_pose", 0) > 1e5
    )


def added(state: dict, number: int, kind: str, arm: Arm, result: dict) -> None:
    """Add an arm's result to the state."""
    for where in (kind, "all"):
        total = state["kinds"].setdefault(where, dict.fromkeys(SUMS, 0) | {"failed": 0, "refused": 0, "worst": 0.0})
        for key in SUMS:
            total[key] += result.get(key, 0)
        total["failed"] += "failed" in result
        total["refused"] += "refused" in result
        total["worst"] = max(total["worst"], result.get("worst", 0.0))
    for key in ("family", "rank", "held"):
        if key in result:
            counts = state[key]
            counts[str(result[key])] = counts.get(str(result[key]), 0) + 1
    for key in ("plan_ms", "us_a_pose"):
        if key in result:
            times, decade = state[key], str(10 ** int(np.ceil(np.log10(max(result[key], 1)))))
            times["up_to"][decade] = times["up_to"].get(decade, 0) + 1
            times["worst"] = max(times["worst"], [round(result[key], 1), number])
    if notable(result):
        state["notable"].append({"number": number, "kind": kind, "types": arm.joint_types, **result})


def summary(state: dict) -> str:
    """Return one line on where the run stands."""
    t = state["kinds"].get("all", dict.fromkeys(SUMS, 0))
    return ", ".join(f"{key.replace('_', ' ')} {t[key]}" for key in t)


def fresh(args) -> dict:
    """Return the state of a run that has not begun."""
    settings = {"joints": args.joints, "poses": args.poses, "first": args.first, "next": args.first}
    times = {key: {"up_to": {}, "worst": [0.0, -1]} for key in ("plan_ms", "us_a_pose")}
    return {**settings, "kinds": {}, "family": {}, "rank": {}, "held": {}, **times, "notable": []}


def main() -> None:
    """Go on from the file, or begin, and stop where asked."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--arms", type=int, default=5000)
    parser.add_argument("--poses", type=int, default=100)
    parser.add_argument("--joints", type=int, default=6)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--out", type=Path, default=RESULTS / "random_arms.json")
    args = parser.parse_args()
    state = json.loads(args.out.read_text()) if args.out.exists() else fresh(args)
    asked = {"joints": args.joints, "poses": args.poses, "first": args.first}
    if any(state[k] != v for k, v in asked.items()):
        sys.exit(f"{args.out} holds a run of other settings; give another --out or remove it")
    stop = Counter()
    signal.signal(signal.SIGINT, lambda *_: stop.update(now=1))
    said = time.monotonic()
    while state["next"] < args.first + args.arms and not stop:
        number = state["next"]
        arm, kind = random_arm(number, args.joints)
        try:
            with patience(PATIENCE):
                result = judged(arm, number, args.poses)
        except Exception as error:  # whatever comes out is the finding
            result = dict.fromkeys(SUMS, 0) | {"arms": 1, "plan_ms": 0.0, "failed": f"{type(error).__name__}: {error}"}
        added(state, number, kind, arm, result)
        state["next"] = number + 1
        if notable(result):
            print(f"{number} {arm.name}: {json.dumps({k: v for k, v in result.items() if v})}", flush=True)
        if time.monotonic() - said > 10:
            said = time.monotonic()
            write(state, args.out)
            print(f"[{state['next']}] {summary(state)}", flush=True)
    write(state, args.out)
    print(f"[{state['next']}] {summary(state)}")


if __name__ == "__main__":
    main()
