"""The arms whose behaviour near singular postures is measured: every family, several geometries each."""

from __future__ import annotations

from functools import partial

import numpy as np

from oracle.arms.known import free, tabled
from pieper import DH, Arm

QUARTER = np.pi / 2


def wrist_at(first: int, types: str, seed: int) -> Arm:
    """Return an arm whose joints first..first+2 (0-based) meet in a point; everything else is of no special kind."""
    rng = np.random.default_rng(seed)
    rows = [DH(rng.uniform(0.1, 0.5), rng.uniform(-3, 3), rng.uniform(0.1, 0.5), rng.uniform(-3, 3)) for _ in range(6)]
    one, two = rows[first], rows[first + 1]
    rows[first] = DH(0, QUARTER, one.d, one.theta)
    rows[first + 1] = DH(0, -QUARTER if first else two.alpha, 0, two.theta)
    return Arm.from_dh(rows, convention="standard", joint_types=types, name=f"wrist at {first + 1}, {types}")


def three_parallel(seed: int) -> Arm:
    """Return an arm with parallel joints 2, 3 and 4 and twists of no special kind around them."""
    rng = np.random.default_rng(seed)
    twists = [rng.uniform(0.7, 2.4), 0.0, 0.0, rng.uniform(0.7, 2.4), rng.uniform(0.7, 2.4), 0.0]
    rows = [DH(rng.uniform(0.1, 0.5), t, rng.uniform(0.1, 0.5), 0.0) for t in twists]
    return Arm.from_dh(rows, convention="standard", name="three parallel, skew")


#: name -> maker of the arm. The family each is solved by is read off its plan.
ARMS = {
    **{
        name: partial(free, name, placed=True)
        for name in (
            "denso-vp6242",
            "fanuc-r2000ic-165f",
            "unimation-puma-560",
            "stanford-arm",
            "rrp-wrist",
            "universal-robots-ur5e",
            "motoman-ea1400n",
            "fanuc-crx-10ia",
            "motoman-hc10",
            "kinova-jaco-j2n6",
            "three-r",
            "adept-cobra-600",
            "dfrobot-rob0036",
            "kuka-lbr-iiwa-14-r820",
            "franka-panda",
        )
    },
    "wrist at the end, RRR (quartic)": partial(wrist_at, 3, "RRRRRR", 1),
    "wrist at the base, RRR (quartic)": partial(wrist_at, 0, "RRRRRR", 2),
    "wrist inside, RRR (quartic)": partial(wrist_at, 2, "RRRRRR", 3),
    "wrist at the end, PPP": partial(wrist_at, 3, "PPPRRR", 4),
    "wrist at the end, RPR": partial(wrist_at, 3, "RPRRRR", 5),
    "three parallel, skew": partial(three_parallel, 6),
    **{name: partial(tabled, name) for name in ("random-6r", "ur5e-calibrated-0.001", "ur5e-calibrated-1e-05")},
}
