"""What routes, time laws, joint moves and proofs of clearance cost: processor time a call, beside public packages.

Usage: python -m benchmarks.measure.motion_speed [--rounds 9] [--only route ...]

Prints one line a measurement: median and least of the rounds. toppra, ruckig and coal are asked where they are
installed. Tools are tilted: one in line with the last joint would let it swallow the turn.
"""

from __future__ import annotations

import argparse
import importlib
import importlib.util
import time
import tracemalloc
from collections.abc import Callable
from typing import Any

import numpy as np

import pieper
from oracle.turns import ring
from pieper import Arm
from pieper.kinematics.pose import rotation_about, transform
from pieper.motion.joint_move import joint_move_time

TORCH = transform(rotation_about(np.array([0.0, 1.0, 0.0]), np.radians(35.0)), np.array([0.05, 0.02, 0.35]))
LIMITS = {"speed": 2.0, "acceleration": 8.0}
FREE = pieper.Freedom()
#: Rings in front of an arm: centre and radius, m; beside the second the IRB 2400 touches its limits.
RINGS = {
    "universal-robots-ur10e": (((0.8, 0.0, 0.4), 0.25), ((0.9, 0.0, 0.3), 0.15)),
    "abb-irb2400": (((1.1, 0.0, 0.6), 0.3), ((0.8, 0.0, 0.4), 0.25)),
}
#: Calls a round of what takes microseconds.
MANY = 200


def report(what: str, call: Callable[[], object], rounds: int, scale: float = 1e3, unit: str = "ms") -> None:
    """Print the processor time of a call, the first one (which loads what is needed) left out."""
    call()
    spent = []
    for _ in range(rounds):
        begun = time.process_time()
        call()
        spent.append(scale * (time.process_time() - begun))
    print(f"{what:58} {np.median(spent):9.3f} {unit}, least {min(spent):.3f}", flush=True)


def torch_arm(name: str) -> Arm:
    """Return an arm of the catalogue with the tilted torch, wide joints turning from -360 to 360 degrees on a UR."""
    arm = pieper.load(name)
    arm = arm.with_tool(arm.tool @ TORCH)
    if "universal" in name:
        arm = arm.with_limits({joint: (-2 * np.pi, 2 * np.pi) for joint in arm.joint_names})
    return arm


def routes(rounds: int) -> None:
    """Seams of 500 points with a free turn, verdict included."""
    for name, rings in RINGS.items():
        arm = torch_arm(name)
        for centre, radius in rings:
            seam = ring(500, centre, radius)
            route = arm.route(seam, free=FREE)
            what = f"route, {name}, ring at {centre[0]} m: {route.verdict.name}"
            report(what, lambda seam=seam, arm=arm: arm.route(seam, free=FREE), rounds)
            tracemalloc.start()
            arm.route(seam, free=FREE)
            room = tracemalloc.get_traced_memory()[1] / 1e6
            print(f"    {room:.1f} MB, cost {route.cost:.12g}, slope {route.slope:.1e}")
            tracemalloc.stop()


def curve(points: int, seed: int = 5) -> np.ndarray:
    """Return points of a smooth joint curve of six joints."""
    rng = np.random.default_rng(seed)
    s = np.linspace(0.0, 1.0, points)
    q = np.zeros((points, 6))
    for k in range(4):
        q += rng.uniform(-0.6, 0.6, 6) * np.sin(np.pi * (k + 1) * s[:, None] + rng.uniform(0, 6))
    return q


def time_laws(rounds: int) -> None:
    """Points without an arm, and with one; beside toppra."""
    limits = pieper.Limits(**LIMITS)
    q, arm = curve(1000), torch_arm("abb-irb2400")
    motion = pieper.time_law(q, limits)
    report("time law, 1,000 points", lambda: pieper.time_law(q, limits), 4 * rounds)
    report("time law, 1,000 points, with an arm", lambda: pieper.time_law(q, limits, arm=arm), 4 * rounds)
    print(f"    margin {motion.margin:.12f}, duration {motion.duration:.9f}")
    if importlib.util.find_spec("toppra"):
        import toppra  # pyright: ignore[reportMissingImports]
        import toppra.algorithm  # pyright: ignore[reportMissingImports]
        import toppra.constraint  # pyright: ignore[reportMissingImports]

        toppra.setup_logging("ERROR")
        s = np.linspace(0.0, 1.0, len(q))
        path = toppra.SplineInterpolator(s, q)
        both = np.array([-1.0, 1.0])

        def asked(cells: int) -> float:
            kept = [
                toppra.constraint.JointVelocityConstraint(np.outer(np.full(6, LIMITS["speed"]), both)),
                toppra.constraint.JointAccelerationConstraint(
                    np.outer(np.full(6, LIMITS["acceleration"]), both),
                    discretization_scheme=toppra.constraint.DiscretizationType.Interpolation,
                ),
            ]
            grid = np.linspace(0.0, 1.0, cells + 1)
            law = toppra.algorithm.TOPPRA(kept, path, gridpoints=grid, parametrizer="ParametrizeConstAccel")
            done: Any = law.compute_trajectory()
            return float(done.duration)

        report("    toppra, 1,000 cells", lambda: asked(1000), rounds)
        for cells in (1000, 8000):
            print(f"    slower than toppra on {cells} cells by {motion.duration / asked(cells) - 1:.2e}")
    q = curve(200, 6)
    limits = pieper.Limits(**LIMITS, jerk=60.0)
    dense = pieper.time_law(curve(1600, 6), limits).duration
    motion = pieper.time_law(q, limits)
    report("jerk-limited, 200 points", lambda: pieper.time_law(q, limits), rounds)
    print(f"    margin {motion.margin:.12f}, {motion.duration / dense - 1:.1e} slower than through 1,600 points")


def joint_moves(rounds: int) -> None:
    """Rest to rest with a jerk; beside ruckig."""
    rng = np.random.default_rng(0)
    q0, q1 = rng.uniform(-2, 2, (2, MANY * 10, 6))
    limits = pieper.Limits(**LIMITS, jerk=60.0)
    report("joint move, in a batch", lambda: joint_move_time(q0, q1, limits), rounds, 1e6 / len(q0), "us")
    if importlib.util.find_spec("ruckig"):
        ruckig: Any = importlib.import_module("ruckig")

        solver, given, way = ruckig.Ruckig(6), ruckig.InputParameter(6), ruckig.Trajectory(6)
        given.current_position, given.target_position = q0[0].tolist(), q1[0].tolist()
        given.max_velocity, given.max_acceleration, given.max_jerk = [2.0] * 6, [8.0] * 6, [60.0] * 6

        def asked() -> None:
            for _ in range(MANY):
                solver.calculate(given, way)

        report("    ruckig, a call", asked, rounds, 1e6 / MANY, "us")


def clearance(rounds: int) -> None:
    """Self pairs, and a route of 500 points among 20 boxes that it passes, 5 mm to be kept."""
    rng = np.random.default_rng(1)
    for name, ((centre, radius), *_) in RINGS.items():
        arm = torch_arm(name)
        model = arm.collision_model(None)
        low, high = np.clip(arm.limits, -np.pi, np.pi).T
        q = rng.uniform(low, high, (4000, 6))
        exact = model.exact
        assert exact is not None
        pairs = len(model.pairs)
        what = f"distance of {pairs} self pairs, {name}"
        report(what, lambda exact=exact, q=q: exact.nearest(q, False), rounds, 1e9 / (len(q) * pairs), "ns a pair")
        route = arm.route(ring(500, centre, radius), free=FREE)
        boxes: list[pieper.Box] = []
        while len(boxes) < 20:
            x, y, z = rng.uniform((-1.6, -1.6, 0.0), 1.6)
            at = pieper.pose(x, y, z, rotvec=rng.uniform(-1, 1, 3).tolist())
            box = pieper.Box(at, rng.uniform(0.05, 0.3, 3))
            if arm.clear(route.q, pieper.Scene([box]), margin=0.005).verdict.name == "CLEAR":
                boxes.append(box)
        scene = pieper.Scene(boxes)
        seen = arm.clear(route.q, scene, margin=0.005)
        what = f"swept proof, {name}: {seen.verdict.name}, {seen.looked} postures"
        report(what, lambda arm=arm, route=route, scene=scene: arm.clear(route.q, scene, margin=0.005), rounds)


PARTS = {"route": routes, "time": time_laws, "move": joint_moves, "clear": clearance}


def main() -> None:
    """Measure all, or what is named."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--rounds", type=int, default=9)
    parser.add_argument("--only", action="append", choices=PARTS)
    args = parser.parse_args()
    for name in args.only or PARTS:
        PARTS[name](args.rounds)


if __name__ == "__main__":
    main()
