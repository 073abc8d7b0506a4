"""Law: where the elbow is folded and the wrist in line, the self-motion is told; just beside, the double roots."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from oracle.arms.known import free
from pieper.kinematics.joints import short_way

#: Arms and where joint 3 folds the forearm back onto the upper arm, rad: on levers of 35 to 60 mm joint 2 moves far.
FOLDED = {"kawasaki-rs020n": pi, "doosan-m1509": pi, "kuka-lbr-iisy15-r930": pi, "staubli-tx2-60": pi}
#: Multiples of 90 degrees at which shoulder, elbow and wrist of a Doosan arm are singular at once.
UPRIGHT = {"doosan-h2017": (2, 2, 0, -1, 2, 2), "doosan-m1013": (2, 2, 0, -1, 2, 2), "doosan-m1509": (0, 2, 0, 1, 2, 2)}


@pytest.mark.parametrize("turned", [0.0, pi])
@pytest.mark.parametrize("name", FOLDED)
def test_a_folded_elbow_does_not_hide_the_wrist_s_self_motion(name: str, turned: float):
    arm, rng = free(name), np.random.default_rng(3)
    for _ in range(12):
        q = rng.uniform(-3, 3, 6)
        q[2], q[4] = FOLDED[name], turned
        T = arm.fk(q)
        sols = arm.ik(T)
        assert sols.status.name == "SINGULAR" and arm.ik_many(T[None]).status[0] == sols.status
        assert sum(motion.contains(q) for motion in sols.self_motions) == 1
        assert sols.multiplicity.sum() + len(sols.self_motions) <= 8


@pytest.mark.parametrize("name", UPRIGHT)
def test_three_singularities_at_once_do_not_hide_it_either(name: str):
    arm, q = free(name), np.array(UPRIGHT[name]) * pi / 2
    sols = arm.ik(arm.fk(q))
    assert sols.status.name == "SINGULAR"
    assert [motion.contains(q) for motion in sols.self_motions] == [True]


@pytest.mark.parametrize("name", FOLDED)
def test_beside_the_line_no_more_is_told_than_there_is(name: str):
    """The elbow at its fold, the wrist in line but for a little: four double roots, two of them next to the line."""
    arm, rng = free(name), np.random.default_rng(4)
    for off in (3e-8, 1e-7, 4e-7):
        for _ in range(4):
            q = rng.uniform(-3, 3, 6)
            q[2], q[4] = 0.0 if name == "doosan-m1509" else FOLDED[name], off
            sols = arm.ik(arm.fk(q))
            assert sols.multiplicity.sum() + 2 * len(sols.self_motions) <= 8
            gap = short_way(sols.nearest(q) - q)
            assert np.abs(gap[[0, 1, 2, 4]]).max() < 1e-6
