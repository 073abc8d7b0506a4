"""Law of the closest posture: no other descent that begins there finds a smaller turn at the same position."""

from __future__ import annotations

import numpy as np
import pytest

from oracle import slow_forward
from pieper import DH, Arm

optimize = pytest.importorskip("scipy.optimize")

#: A pose that the arm below takes outside its limits alone; what is left of its turn falls slowly along two limits.
POSE = np.array(
    [
        [-0.7153862054956688, 0.6618886102884755, -0.22388846454629957, 0.4278758123271614],
        [-0.5862338009362305, -0.7429147283034999, -0.32312170634235804, 0.38444592617181844],
        [-0.3802006149736861, -0.09990582585679171, 0.9194924242936988, 0.2704637520579049],
        [0.0, 0.0, 0.0, 1.0],
    ]
)


def test_no_other_descent_from_the_closest_posture_turns_it_nearer():
    rng = np.random.default_rng(2)
    limits = [(-rng.uniform(0.5, 3), rng.uniform(0.5, 3)) for _ in range(7)]
    rows = [DH(rng.uniform(-0.4, 0.4), rng.uniform(-3, 3), rng.uniform(-0.4, 0.4), 0.0) for _ in range(7)]
    arm = Arm.from_dh(rows, convention="standard", limits=limits)
    found = arm.ik(POSE).closest
    lower, upper = np.array(limits).T

    def miss(q, weight):
        gap = slow_forward.fk(arm.chain, q) - POSE
        return np.concatenate([weight * gap[:3, 3], gap[:3, :3].ravel()])

    q = found.q
    for weight in (1e2, 1e3, 1e4, 1e5, 1e6):
        exact = {"xtol": 1e-15, "ftol": 1e-15, "gtol": 1e-15}
        at = np.clip(q, lower + 1e-12, upper - 1e-12)
        q = optimize.least_squares(miss, at, bounds=(lower, upper), args=(weight,), **exact).x
    left = miss(q, 1.0)
    turn = 2 * np.arcsin(np.linalg.norm(left[3:]) / 8**0.5)
    assert np.linalg.norm(left[:3]) < 1e-9 and found.metres < 1e-12
    assert found.radians < turn + 1e-6
