"""Recall near singular postures: joint vectors 1e-10 to 1e-2 away from a singular one, and exactly singular ones.

Usage: python -m benchmarks.measure.singular_strata [--poses 2000] [--arm NAME ...] [--again]

A line through joint space is searched for a change of sign of the Jacobian's determinant (of the six joints that the
arm is solved as), which meets every kind of singular posture: wrist, elbow, shoulder and the stranger ones of offset
arms. From there the joint vector goes a log-uniform distance in a generic direction. Recall is counted twice: within
1e-6 rad, and within 1e-6 + 1e-14 / sigma_min, as well as a pose in double precision tells. A pose with a continuous
family counts as found where the joint vector lies on it. Every miss of the second kind is judged in fifty digits
(fifty_digits.py), and of those of the first alone the first few of each chunk. Chunks that were measured are kept and
not measured again. `make pages` writes the page.
"""

from __future__ import annotations

import argparse
import json
import time
from pathlib import Path

import numpy as np

from benchmarks.kept import RESULTS, in_chunks, write_text
from benchmarks.measure.fifty_digits import verdict
from benchmarks.pages.singular_strata import VERDICTS, table
from oracle.arms.strata import ARMS
from oracle.joints import around
from pieper.kinematics.newton import scaled_jacobian

CHUNK = 250
#: Chunks are drawn from seeds from here on: anew for each solver that is measured.
SEED = 31000
#: Part of the joint vectors that are exactly singular (to rounding); the others are spread over eight decades.
EXACT = 0.1
POINTS = 96
#: Misses within what a pose in double precision tells that are judged all the same, a chunk.
JUDGED = 2
FLAT, BLUR = 1e-6, 1e-14


def singular_joints(arm, rng, count: int) -> np.ndarray:
    """Return joint vectors (count, n) at which the determinant changes sign, to rounding."""
    plan = arm.plan
    values = plan.defaults
    six = plan.reduction.six(values)
    kept = plan.reduction.kept
    own = np.flatnonzero(kept < arm.n) if len(kept) else np.zeros(0, int)
    unit = np.where(six.prismatic, six.length, 1.0)
    out: list[np.ndarray] = []
    while len(out) < count:
        start = np.zeros((64, 6))
        start[:, len(kept) :] = 0.0
        virtual = np.setdiff1d(np.arange(len(kept)), own)
        start[:, own] = rng.uniform(-1, 1, (64, len(own))) * np.where(six.prismatic, six.length, np.pi)[own]
        start[:, virtual] = np.array([0.7, 1.1, -0.6])[: len(virtual)]
        way = np.zeros((64, 6))
        way[:, own] = rng.standard_normal((64, len(own))) * unit[own]
        at = start[:, None] + np.linspace(0, 3, POINTS)[:, None] * way[:, None]
        det = np.linalg.det(scaled_jacobian(six, at))
        for k in range(64):
            turns = np.flatnonzero(det[k, :-1] * det[k, 1:] < 0)
            if not len(turns):
                continue
            t = int(rng.choice(turns))
            lower, upper, sign = at[k, t], at[k, t + 1], np.sign(det[k, t])
            for _ in range(60):
                middle = (lower + upper) / 2
                if np.sign(np.linalg.det(scaled_jacobian(six, middle))) == sign:
                    lower = middle
                else:
                    upper = middle
            full = np.zeros(plan.reduction.full.n)
            full[kept] = lower[: len(kept)]
            full[list(plan.reduction.locked)] = values
            out.append(full[: arm.n])
            if len(out) == count:
                break
    return np.array(out)


def smallest(arm, q: np.ndarray) -> np.ndarray:
    """Return sigma_min (N,) of what the arm is solved as, lengths per length of the arm."""
    plan = arm.plan
    six = plan.reduction.six(plan.defaults)
    full = np.zeros((len(q), plan.reduction.full.n))
    full[:, : arm.n] = q
    at = np.zeros((len(q), 6))
    at[:, : len(plan.reduction.kept)] = full[:, plan.reduction.kept]
    if plan.task == "position":
        return np.linalg.svd(scaled_jacobian(arm.chain, q)[:, :3], compute_uv=False)[:, -1]
    return np.linalg.svd(scaled_jacobian(six, at), compute_uv=False)[:, -1]


def draw(arm, rng, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Return joint vectors (count, n) and how far each was moved from a singular one (0 for the exact ones)."""
    q = singular_joints(arm, rng, count)
    distance = np.where(rng.uniform(size=count) < EXACT, 0.0, 10 ** rng.uniform(-10, -2, count))
    way = rng.standard_normal(q.shape)
    locked = [j for j in arm.plan.reduction.locked if j < arm.n]
    way[:, locked] = 0.0
    way /= np.linalg.norm(way, axis=1, keepdims=True)
    unit = np.where(arm.chain.prismatic, arm.chain.length, 1.0)
    return q + distance[:, None] * way * unit, distance


def measure(arm, seed: int) -> dict:
    """Solve one chunk and return its counts, by decade of the distance."""
    plan = arm.plan
    rng = np.random.default_rng(SEED + seed)
    q, distance = draw(arm, rng, CHUNK)
    T = arm.fk(q)
    sigma = smallest(arm, q)
    how = {"redundancy": plan.defaults} if plan.redundancy else {}
    start = time.process_time()
    many = arm.ik_many(T, threads=1, **how)
    spent = time.process_time() - start
    prismatic, length = arm.chain.prismatic, arm.chain.length
    gap = np.where(prismatic, (many.q - q[:, None]) / length, around(many.q - q[:, None]))
    gap = np.where(many.valid, np.abs(gap).max(-1), np.inf).min(1)
    decade = np.clip(np.floor(np.log10(np.maximum(distance, 1e-11))) + 11, 1, 8).astype(int)
    decade[distance == 0] = 0
    out = {
        "poses": [int((decade == d).sum()) for d in range(9)],
        "seconds": spent,
        "marked": int((many.flag & 1).sum()),
    }
    for key in ("flat", "told", *VERDICTS):
        out[key] = [0] * 9
    out["worst_m"] = out["worst_rad"] = 0.0
    rows, index = many.q[many.valid], np.repeat(np.arange(CHUNK), many.count)
    error = plan.residual(rows, T[index])
    reach = np.maximum(length, np.linalg.norm(T[index, :3, 3], axis=1))
    unmarked = (many.flag[index] & 3) == 0
    out["worst_m"] = float((error[:, 0] / reach)[unmarked].max(initial=0.0))
    out["worst_rad"] = float(error[:, 1][unmarked].max(initial=0.0))
    out["over"] = int(((error[:, 0] / reach > 1e-12) | (error[:, 1] > 1e-12))[unmarked].sum())
    out["cases"] = []
    judged = 0
    for i in range(CHUNK):
        if gap[i] < FLAT:
            out["flat"][decade[i]] += 1
            out["told"][decade[i]] += 1
            continue
        # where a singular slice has a self-motion of its own a held arm's rows are one point of it
        motions = arm.ik(T[i], **({"redundancy": plan.defaults} if plan.redundancy else {})).self_motions
        if any(motion.contains(q[i], FLAT) for motion in motions):
            out["flat"][decade[i]] += 1
            out["told"][decade[i]] += 1
            continue
        told = FLAT + BLUR / max(sigma[i], 1e-300)
        within = bool(gap[i] < told or any(motion.contains(q[i], told) for motion in motions))
        out["told"][decade[i]] += within
        if within and judged == JUDGED:
            out["as told"][decade[i]] += 1
            continue
        judged += within
        said = verdict(
            arm,
            T[i],
            q[i],
            many.q[i][many.valid[i]],
            asked=range(3) if plan.task == "position" else range(6),
            held=[j for j in plan.reduction.locked if j < arm.n],
        )
        out[said][decade[i]] += 1
        if said in ("lost", "unsettled"):
            out["cases"].append([said, float(distance[i]), float(sigma[i]), float(gap[i]), q[i].tolist()])
    return out


def main() -> None:
    """Measure what is not measured yet, chunk by chunk, and print the table."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--poses", type=int, default=2000)
    parser.add_argument("--arm", action="append", choices=list(ARMS))
    parser.add_argument("--again", action="store_true", help="forget what was measured of these arms")
    parser.add_argument("--file", type=Path, default=RESULTS / "singular_strata.json")
    args = parser.parse_args()
    kept = json.loads(args.file.read_text()) if args.file.exists() else {}
    for name in args.arm or ARMS:
        arm = ARMS[name]()
        if args.again or name not in kept:
            kept[name] = {"family": arm.plan.family, "chunks": {}}
        for seed in range(-(-args.poses // CHUNK)):
            if str(seed) in kept[name]["chunks"]:
                continue
            kept[name]["chunks"][str(seed)] = measure(arm, seed)
            write_text(in_chunks(kept), args.file)
        print(table({name: kept[name]}).splitlines()[-1], flush=True)
    print(table(kept))


if __name__ == "__main__":
    main()
