"""Maps and calibration, measured in slices: python -m benchmarks.measure.scale SLICE.

Slices: maps, whole (a map of 1e8 poses with and without symmetry), rm4d (the grid of RM4D filled at its cells'
centres), calibration (--seed).
Each adds to benchmarks/results/scale.json; processor times, one thread, unless said otherwise.
"""

from __future__ import annotations

import argparse
import json
import time
from typing import Any

import numpy as np

import pieper
from benchmarks.kept import RESULTS, held, read, write
from pieper.maps.grid import grid_of
from tests.calibration.planted import ARMS, NOISE, noisy, planted, postures


def least(work: Any, rounds: int = 3) -> float:
    """Return the least processor time of a work, s."""
    took = []
    for _ in range(rounds):
        start = time.process_time()
        work()
        took.append(time.process_time() - start)
    return min(took)


def fused_kernel(plan: Any) -> Any:
    """Return the kernel of maps of an arm that is its own six-joint chain."""
    return plan.solver.reach


def maps() -> dict[str, Any]:
    """Millions of checks a second: the kernel pose by pose, with the last joint's symmetry, and poses in arrays."""
    said = {}
    for name in ("universal-robots-ur5e", "denso-vp6242", "fanuc-crx-10ia"):
        plan = pieper.load(name).plan
        grid = grid_of(((-0.9, 0.9), (-0.9, 0.9), (-0.3, 1.0)), 0.1, (128, 16), "pose", plan.chain.length)
        centres = grid.centres(np.random.default_rng(0).choice(grid.count, 60, replace=False))
        own, reach, checks = np.arange(60)[:, None], fused_kernel(plan), 60 * len(grid.turns) / 1e6
        T = grid.poses(np.arange(30), grid.turns)

        def fused(sense: float, each: Any = None) -> None:
            reach(centres, grid.turns, grid.rolls, sense, own, 1.0, each, plan.chain.length, 1)  # noqa: B023

        said[name] = {
            "direct": checks / least(lambda: fused(0.0)),
            "last_joint": checks / least(lambda: fused(1.0)),
            "measured": checks / least(lambda: fused(1.0, plan.chain.links), 1),  # noqa: B023
            "arrays": len(T) / 1e6 / least(lambda: plan.solver.many(T, 1)),  # noqa: B023
        }
    return said


def whole() -> dict[str, Any]:
    """Maps of up to 4e8 poses of a UR5e, with symmetry and without: seconds, and whether they agree."""
    arm, said = pieper.load("universal-robots-ur5e"), {}
    box, bits = ((-0.9, 0.9), (-0.9, 0.9), (-0.3, 0.9)), []
    for symmetry, step in (("auto", 0.05), ("none", 0.05), ("auto", 0.02)):
        start, wall = time.process_time(), time.perf_counter()
        m = arm.reach_map(box, step, (128, 16), symmetry=symmetry)
        poses = m.grid.count * len(m.grid.turns)
        said[f"{symmetry} {step}"] = {
            "poses": poses,
            "cpu_s": time.process_time() - start,
            "s": time.perf_counter() - wall,
        }
        bits.append((m.bits, m.count))
    said["same"] = bool(np.array_equal(bits[0][0], bits[1][0]) and np.array_equal(bits[0][1], bits[1][1]))
    return said


def rm4d() -> dict[str, Any]:
    """RM4D's own grid of a UR5e: 5 cm in x*, y* and z, 36 angles of the axis; and how often a look-up is right."""
    plan = pieper.load("universal-robots-ur5e").plan
    x, z = np.arange(-1.025, 1.05, 0.05), np.arange(0.025, 1.35, 0.05)
    tilt = (np.arange(36) + 0.5) * np.pi / 36
    R = np.stack([pieper.pose(0, 0, 0, rpy=(0, t, 0))[:3, :3] for t in tilt])
    centres = np.stack(np.meshgrid(z, x, x, indexing="ij"), -1).reshape(-1, 3)[:, [1, 2, 0]] * [-1, -1, 1]
    out = []

    def fill() -> None:
        ask = (R, 1, 0.0, np.arange(len(centres))[:, None], 1.0, None, plan.chain.length, 1)
        out.append(fused_kernel(plan)(centres, *ask))

    took = least(fill, 2)
    bits = np.unpackbits(out[0][0], axis=1)[:, :36].reshape(len(z), len(x), len(x), 36).astype(bool)
    rng = np.random.default_rng(0)
    turns = np.linalg.qr(rng.normal(size=(20000, 3, 3)))[0]
    turns[np.linalg.det(turns) < 0, :, 0] *= -1
    T = np.tile(np.eye(4), (20000, 1, 1))
    T[:, :3, :3], T[:, :3, 3] = turns, rng.uniform([-1.05, -1.05, 0], [1.05, 1.05, 1.35], (20000, 3))
    truth = plan.solver.many(T, 1)[2].any(1)
    turn = np.arctan2(turns[:, 1, 2], turns[:, 0, 2])
    p, c, s = T[:, :3, 3], np.cos(turn), np.sin(turn)
    at = [-(c * p[:, 0] + s * p[:, 1]), -(c * p[:, 1] - s * p[:, 0])]
    inside = (np.abs(at[0]) < 1.05) & (np.abs(at[1]) < 1.05)
    cell = lambda v, low, step, n: np.clip(((v - low) / step).astype(int), 0, n - 1)  # noqa: E731
    found = bits[
        cell(p[:, 2], 0, 0.05, len(z)),
        cell(at[0], -1.05, 0.05, len(x)),
        cell(at[1], -1.05, 0.05, len(x)),
        cell(np.arccos(turns[:, 2, 2]), 0, np.pi / 36, 36),
    ]
    return {"cells": bits.size, "cpu_s": took, "right": float(((found & inside) == truth).mean())}


def calibration(seed: int) -> dict[str, Any]:
    """Held-out error over its prediction on planted arms, ms a fit of 50 poses, us a pose of the fitted arm's ik."""
    said: dict[str, Any] = {"seed": seed}
    for name in ARMS:
        arm, squares, predicted, took = pieper.load(name), [], [], []
        for trial in range(8):
            rng = np.random.default_rng([seed, trial])
            true, q = planted(arm, rng), postures(arm, rng, 67)
            Y = noisy(true.fk(q), rng)
            start = time.process_time()
            fit = arm.calibrate(q, Y, sigma=NOISE)
            took.append(time.process_time() - start)
            if (held := fit.held_out) is not None:
                squares.append(held.metres**2)
                predicted.append(held.predicted_metres**2)
        T = np.repeat(fit.arm.fk(q), 8, 0)
        value = None if not fit.arm.plan.redundancy else np.repeat(q[:, list(fit.arm.plan.reduction.locked)], 8, 0)
        each = least(lambda: fit.arm.ik_many(T, threads=1, redundancy=value), 2) / len(T) * 1e6  # noqa: B023
        said[name] = {
            "over_prediction": float(np.sqrt(np.sum(squares) / np.sum(predicted))),
            "fit_ms": 1e3 * float(np.median(took)),
            "inverse_us": each,
        }
    return said


def main() -> None:
    """Measure what is asked and keep it."""
    ask = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    ask.add_argument("slice", choices=["maps", "whole", "rm4d", "calibration"])
    ask.add_argument("--seed", type=int, default=2026)
    said = ask.parse_args()
    work = {"maps": maps, "whole": whole, "rm4d": rm4d, "calibration": lambda: calibration(said.seed)}
    found = work[said.slice]()
    print(json.dumps(found, indent=1))
    with held():
        write((read("scale") or {}) | {said.slice: found}, RESULTS / "scale.json", indent=1)


if __name__ == "__main__":
    main()
