"""Verdicts of routes along random seams, beside a flood over 7,200 turns of the tool and a search of another kind.

Usage: python -m benchmarks.measure.route_verdicts [--seconds 150] [--seams 100] [--arm NAME ...] [--costs 5]

Seams are rings and lines before twenty arms with a tool tilted off joint 6, the turn free; limits as the arms ship and,
every third seam, those of one joint narrowed. FOUND is looked at point by point and ten times between points, by Newton
from the route's own neighbours; IMPOSSIBLE by `oracle.turns.flooded`, from everything inside the limits where its proof
begins. Seams on which what the poses leave free is nearly singular anywhere (pole poses) are counted apart. What was
measured is kept, seam by seam, and not measured again; `--costs` measures so many routes' costs beside a ladder of
1,440 turns made short by another method.
"""

from __future__ import annotations

import argparse
import json
import time
from pathlib import Path
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

import pieper
from benchmarks.kept import RESULTS, write
from benchmarks.measure.route_costs import ladder_cost, torn
from benchmarks.pages.route_verdicts import table
from oracle.turns import flooded, ring
from pieper import Arm, Verdict
from pieper.kinematics.pose import rotation_z

ARMS = (
    "abb-irb2400",
    "abb-irb1200-7-70",
    "kuka-kr6-r900-sixx",
    "kuka-kr16-2",
    "fanuc-lr-mate-200id",
    "fanuc-m-10ia",
    "motoman-gp7",
    "denso-vs060",
    "universal-robots-ur5e",
    "universal-robots-ur10e",
    "staubli-tx2-90",
    "kawasaki-rs007n",
    "nachi-mz07",
    "mitsubishi-rv4fr",
    "comau-ns16hand",
    "unimation-puma-560",
    "epson-c4-a601s",
    "abb-irb4600-40-255",
    "kuka-kr10-r1100-2",
    "doosan-m1013",
)
FREE = pieper.Freedom()
#: Turns of the flood, and places of a seam at which it looks: as many as keep its steps small.
TURNS, PLACES = 7200, 70
#: How far behind the place told the flood may get: the width of its own steps.
PAST = 0.01
#: Points of a seam.
POINTS = 24


def drawn(name: str, number: int) -> tuple[Arm, np.ndarray]:
    """Return the arm with tool and limits of a seam, and its poses (POINTS, 4, 4)."""
    rng = np.random.default_rng([ARMS.index(name), number])
    arm = pieper.load(name)
    length = arm.chain.length
    tilt, roll = rng.uniform(0.3, 0.9), rng.uniform(-np.pi, np.pi)
    x, y = rng.uniform(-0.03, 0.03, 2) * length
    torch = pieper.pose(x, y, 0.08 * length, rotvec=(0.0, 0.0, roll))
    arm = arm.with_tool(arm.tool @ torch @ pieper.pose(0.0, 0.0, 0.0, rotvec=(0.0, tilt, 0.0)))
    if number % 3 == 0:
        j = int(rng.integers(6))
        low, high = np.clip(arm.limits[j], -np.pi, np.pi)
        middle, half = rng.uniform(low, high), rng.uniform(0.15, 0.5) * (high - low)
        arm = arm.with_limits({arm.joint_names[j]: (max(low, middle - half), min(high, middle + half))})
    out, angle = rng.uniform(0.15, 0.7) * length, rng.uniform(-np.pi, np.pi)
    centre = np.array([out * np.cos(angle), out * np.sin(angle), rng.uniform(-0.1, 0.6) * length])
    if number % 2:
        return arm, ring(POINTS, centre, rng.uniform(0.03, 0.2) * length, rng.uniform(0.0, 1.2))
    way = rng.standard_normal(3)
    way *= rng.uniform(0.1, 0.5) * length / np.linalg.norm(way)
    ends = []
    for side in (-0.5, 0.5):
        lean = pieper.pose(0.0, 0.0, 0.0, rotvec=(np.pi + rng.uniform(-0.6, 0.6), rng.uniform(-0.6, 0.6), 0.0))
        lean[:3, 3] = centre + side * way
        ends.append(lean)
    return arm, pieper.line(ends[0], ends[1], POINTS)


def places(path: np.ndarray) -> np.ndarray:
    """Return the poses of a seam at PLACES places, evenly."""
    each = -(-PLACES // (len(path) - 1))
    return np.concatenate(
        [pieper.line(a, b, each + 1)[:-1] for a, b in zip(path[:-1], path[1:], strict=True)] + [path[-1:]]
    )


def at(path: np.ndarray, s: np.ndarray) -> np.ndarray:
    """Return the poses (k, 4, 4) of a seam at s (k,), 0 to 1."""
    place = s * (len(path) - 1)
    k = np.clip(place.astype(int), 0, len(path) - 2)
    out = path[k].copy()
    for i, part in enumerate(place - k):
        turn = Rotation.from_matrix(path[k[i], :3, :3].T @ path[k[i] + 1, :3, :3]).as_rotvec()
        out[i, :3, :3] = out[i, :3, :3] @ Rotation.from_rotvec(part * turn).as_matrix()
        out[i, :3, 3] += part * (path[k[i] + 1, :3, 3] - path[k[i], :3, 3])
    return out


def least_singular(arm: Arm, q: np.ndarray, axes: np.ndarray) -> float:
    """Return the least singular value of what holds the tool's point and its axis (k, 3) at postures q (k, n)."""
    if not len(q):
        return np.inf
    J = arm.jacobian(q)
    across = np.cross(axes[:, :, None], J[:, 3:], axis=1)
    held = np.concatenate([J[:, :3] / arm.chain.length, across], axis=1)
    # three rows hold two directions of the axis: of six singular values one is zero
    return float(np.linalg.svd(held, compute_uv=False)[:, 4].min())


def missed(arm: Arm, route: pieper.Route) -> str:
    """Return what is wrong with a route that was found, looked at between its points; nothing where all is well."""
    low, high = arm.limits.T
    length = arm.chain.length
    T = arm.fk(route.q)
    wanted = route.path @ rotation_z(route.turn)
    if np.abs(T[:, :3, 3] - wanted[:, :3, 3]).max() > 1e-8 * length or np.abs(T - wanted)[:, :3, :3].max() > 1e-8:
        return "off its poses"
    if ((route.q < low - 1e-9) | (route.q > high + 1e-9)).any():
        return "outside the limits"
    return torn(arm, route.path, route.q, arm.limits)


def judged(name: str, number: int) -> dict[str, Any]:
    """Return one seam's verdict and what was seen beside it."""
    arm, path = drawn(name, number)
    start = time.process_time()
    route = arm.route(path, free=FREE)
    out: dict[str, Any] = {"verdict": route.verdict.name, "seconds": round(time.process_time() - start, 3)}
    if route.verdict is Verdict.FOUND:
        out["wrong"] = missed(arm, route)
        axes = (route.path @ rotation_z(route.turn))[:, :3, 2]
        out["least"] = least_singular(arm, route.q, axes)
        return out
    dense = places(path)
    out["wrong"] = ""
    if route.verdict is Verdict.IMPOSSIBLE:
        assert route.blocked is not None
        begun, (first, last) = route.blocked.begun, route.blocked.s
        back = begun > last
        end, past = (first, max(0.0, first - PAST)) if back else (last, min(1.0, last + PAST))
        # what the proof says: of everything inside the limits where it begins, nothing gets past where it ends
        window = at(path, np.linspace(begun, past, 2 + int(np.ceil(abs(end - begun) * 8 * PLACES))))
        if _flood(arm, window) == len(window) - 1 and 0.0 < end < 1.0:
            out["wrong"] = "the flood gets past the place"
    if out["wrong"]:
        out["reached"] = _flood(arm, dense) / (len(dense) - 1)
        if out["wrong"] and out["reached"] == 1.0:
            out["wrong"] = "the flood gets there"
    many = arm.ik_many((dense[:, None] @ rotation_z(np.arange(72) * 2 * np.pi / 72)).reshape(-1, 4, 4))
    axes = np.repeat(dense[:, :3, 2], 72, 0)
    k, row = np.nonzero(many.in_limits)
    out["least"] = least_singular(arm, many.q[k, row], axes[k])
    return out


def _flood(arm: Arm, poses: np.ndarray) -> int:
    """Return how far the flood gets; whole turns are told apart where it matters, of many sets with fewer turns."""
    reached = flooded(arm, poses, TURNS, lifted=False)
    span = np.where(np.isfinite(arm.limits).all(1), arm.limits[:, 1] - arm.limits[:, 0], 0.0)
    windings = np.prod((np.maximum(0.0, span + 1e-9) / (2 * np.pi)).astype(int) + 1)
    if reached == len(poses) - 1 and windings > 1:
        reached = flooded(arm, poses, TURNS // (8 if windings > 8 else 1), lifted=True)
    return reached


def main() -> None:
    """Measure what is not measured yet, until time is up, and print the counts."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--seconds", type=float, default=150.0, help="of processor time")
    parser.add_argument("--seams", type=int, default=100, help="of each arm")
    parser.add_argument("--first", type=int, default=0, help="number of the first seam")
    parser.add_argument("--arm", action="append", choices=ARMS)
    parser.add_argument("--costs", type=int, default=0, help="of each arm's found routes")
    parser.add_argument("--file", type=Path, default=RESULTS / "route_verdicts.json")
    args = parser.parse_args()
    kept: dict[str, Any] = json.loads(args.file.read_text()) if args.file.exists() else {"seams": {}}
    begun = time.process_time()
    for number in range(args.first, args.seams):
        for name in args.arm or ARMS:
            seams = kept["seams"].setdefault(name, {})
            if str(number) not in seams:
                seams[str(number)] = judged(name, number)
            seam = seams[str(number)]
            counted = sum("ladder" in s for s in seams.values())
            if seam["verdict"] == "FOUND" and "ladder" not in seam and counted < args.costs:
                seam.update(ladder_cost(*drawn(name, number), FREE))
            if seam["wrong"] or seam["verdict"] == "UNCERTAIN":
                print(name, number, seam, flush=True)
            write(kept, args.file)
            if time.process_time() - begun > args.seconds:
                print(sum(map(len, kept["seams"].values())), "seams so far")
                return
    print(table(kept))


if __name__ == "__main__":
    main()
