"""Redundant arms inside narrow limits: status, nearest posture and the stretches of self-motions, arm by arm.

Usage: python -m benchmarks.measure.narrow_limits [--poses 5000] [--nearest 2] [--arm NAME ...] [--again]

Twenty arms of seven joints and ten of eight (oracle/arms/spare.py). A chunk draws a middle posture c, gives the arm
the limits c - w to c + w (lengths per length of the arm), w one of five widths, makes poses from joint vectors inside
and asks for them in one batch: each has solutions inside. Of the first few of a chunk the nearest posture to the
joint vector is asked for, which is that joint vector, and of seven-joint arms all stretches of the self-motions inside
the limits are compared with a dense sampling. Chunks that were measured are kept and not measured again; the arms take
turns, so that all have as many when it is stopped. `make pages` writes the page.
"""

from __future__ import annotations

import argparse
import json
import time
import warnings
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

import pieper
from benchmarks.kept import RESULTS, in_chunks, write_text
from benchmarks.pages.narrow_limits import table
from oracle import slow_forward
from oracle.arms.spare import ARMS
from pieper import Arm, Status

CHUNK = 250
SEED = 47
WIDTHS = (1.0, 0.5, 0.2, 0.1, 0.05)
#: A joint vector that holds the pose is met by `nearest` within this, and a stretch ends at a limit within it.
MET = 1e-6
#: Samples along a self-motion, and how many wrong joint vectors a chunk keeps.
SAMPLES, CASES = 600, 3


def inside(arm: Arm, q: np.ndarray, room: float = 0.0) -> np.ndarray:
    """Return whether joint vectors (m, n) lie inside the limits by `room` (rad; lengths), angles whole turns apart."""
    middle, half = arm.limits.mean(1), np.ptp(arm.limits, axis=1) / 2
    off = q - middle
    off = np.where(arm.chain.prismatic, off, (off + np.pi) % (2 * np.pi) - np.pi)
    return (np.abs(off) <= half - room).all(-1)


def stretches_agree(arm: Arm, motion: Any) -> bool:
    """Return whether the stretches of a self-motion that are said to be inside the limits are those of its samples."""
    u = np.linspace(0, 1, SAMPLES)
    q = np.array([motion.at(float(at)) for at in u])
    told = np.zeros(SAMPLES, bool)
    for a, b in motion.inside:
        told |= (u >= a) & (u <= b)
        ends = np.array([motion.at(a), motion.at(b)])
        if not inside(arm, ends, -MET).all():
            return False
    return bool((told | ~inside(arm, q, MET)).all() and (~told | inside(arm, q, -MET)).all())


def measure(arm: Arm, place: int, width: float, seed: int, asked: int) -> dict[str, Any]:
    """Solve one chunk and return what was found: how many statuses, nearest postures and stretches are wrong."""
    rng = np.random.default_rng([SEED, place, int(1000 * width), seed])
    unit = np.where(arm.chain.prismatic, arm.chain.length, 1.0)
    c = rng.uniform(-1.5, 1.5, arm.n) * unit
    arm = Arm(replace(arm.description, limits=np.c_[c - width * unit, c + width * unit]))
    q = c + rng.uniform(-width, width, (CHUNK, arm.n)) * unit
    T = slow_forward.fk(arm.chain, q)
    start = time.process_time()
    many = arm.ik_many(T, threads=1)
    spent = time.process_time() - start
    wrong = (many.status != Status.REDUNDANT) | ~many.in_limits.any(1)
    rows, index = many.q[many.in_limits], np.repeat(np.arange(CHUNK), many.in_limits.sum(1))
    there = slow_forward.fk(arm.chain, rows)
    off = np.abs(there - T[index]).max((1, 2)) > 1e-9 * max(1.0, arm.chain.length)
    astray = np.unique(index[off | ~inside(arm, rows, -1e-9)])
    out = {"poses": CHUNK, "wrong": int(wrong.sum()), "astray": len(astray), "seconds": spent}
    cases = [["wrong", int(many.status[i]), q[i].tolist()] for i in np.flatnonzero(wrong)[:CASES]]
    cases += [["astray", 0, q[i].tolist()] for i in astray[:CASES]]
    missed = torn = looked = 0
    for i in range(asked):
        sols = arm.ik(T[i])
        try:
            near = sols.nearest(q[i])
            away = float(np.abs((near - q[i]) / unit).max())
        except pieper.PieperError:
            away = np.inf
        missed += away > MET
        if away > MET:
            cases.append(["nearest", away, q[i].tolist()])
        if arm.n > 7:
            continue
        for motion in sols.self_motions:
            looked += 1
            if not stretches_agree(arm, motion):
                torn += 1
                cases.append(["stretch", 0, q[i].tolist()])
    return {**out, "asked": asked, "missed": missed, "looked": looked, "torn": torn, "cases": cases}


def main() -> None:
    """Measure what is not measured yet, chunk by chunk, and print the table."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--poses", type=int, default=5000, help="an arm and width")
    parser.add_argument("--nearest", type=int, default=2, help="nearest postures asked for, a chunk")
    parser.add_argument("--arm", action="append", choices=list(ARMS))
    parser.add_argument("--again", action="store_true", help="forget what was measured of these arms")
    parser.add_argument("--file", type=Path, default=RESULTS / "narrow_limits.json")
    args = parser.parse_args()
    warnings.simplefilter("ignore", pieper.PieperWarning)
    kept = json.loads(args.file.read_text()) if args.file.exists() else {}
    arms = {name: ARMS[name]() for name in args.arm or ARMS}
    for name, arm in arms.items():
        if args.again or name not in kept:
            kept[name] = {"family": arm.plan.family, "joints": arm.n, "chunks": {}}
    for seed in range(-(-args.poses // CHUNK)):
        for name, arm in arms.items():
            for width in WIDTHS:
                key = f"{width} {seed}"
                if key not in kept[name]["chunks"]:
                    chunk = measure(arm, list(ARMS).index(name), width, seed, args.nearest)
                    kept[name]["chunks"][key] = chunk
            write_text(in_chunks(kept), args.file)
        print(f"{seed + 1} chunks an arm and width", flush=True)
    print(table(kept))


if __name__ == "__main__":
    main()
