"""Laws of `nearest`: no winding, row or point of a self-motion inside the limits is nearer, by any weights."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import pieper
from pieper import Arm, InputError

WEIGHTS = [None, (1, 1, 1, 1, 1, 1, 1), (9, 0.1, 1, 4, 0, 0.3, 2), (0, 0, 0, 0, 0, 2, 1)]


def away(arm, rows, now, weights):
    """Return the weighted distances (k,) of rows from a posture: written here once more, for arms that only turn."""
    counts = np.ones(arm.n) if weights is None else np.array(weights[: arm.n], float)
    return np.sqrt((((rows - now) ** 2) * counts).sum(1))


@pytest.mark.parametrize("weights", WEIGHTS)
@pytest.mark.parametrize("name", ["denso-vp6242", "universal-robots-ur5e"])
def test_of_all_windings_of_all_rows_none_is_nearer(name, weights):
    arm, rng = pieper.load(name), np.random.default_rng(1)
    for _ in range(10):
        q, now = rng.uniform(*arm.limits.T), rng.uniform(*arm.limits.T)
        sols = arm.ik(arm.fk(q))
        nearest = sols.nearest(now, None if weights is None else weights[:6])
        every = away(arm, sols.windings(), now, weights)
        assert away(arm, nearest[None], now, weights)[0] <= every.min() + 1e-9
        assert np.abs(arm.fk(nearest) - sols.T).max() < 1e-9


@pytest.mark.parametrize("weights", WEIGHTS)
@pytest.mark.parametrize("name", ["denso-vp6242", "universal-robots-ur5e", "fanuc-lr-mate-200ic"])
def test_of_a_singular_pose_no_point_of_a_self_motion_is_nearer(name, weights):
    arm, rng = pieper.load(name), np.random.default_rng(2)
    for _ in range(4):
        q, now = rng.uniform(*arm.limits.T), rng.uniform(*arm.limits.T)
        q[4] = 0.0
        sols = arm.ik(arm.fk(q))
        nearest = sols.nearest(now, None if weights is None else weights[:6])
        assert np.abs(arm.fk(nearest) - sols.T).max() < 1e-9
        assert ((nearest >= arm.limits[:, 0] - 1e-8) & (nearest <= arm.limits[:, 1] + 1e-8)).all()
        least = away(arm, nearest[None], now, weights)[0]
        for motion in sols.self_motions:
            for low, high in motion.inside:
                points = np.array([motion.at(u) for u in np.linspace(low, high, 150)])
                wound = arm.chain.joints.unwound(points, now, arm.limits)
                assert least <= away(arm, wound, now, weights).min() + 1e-6


@pytest.mark.parametrize("weights", WEIGHTS)
@pytest.mark.parametrize("name", ["franka-panda", "kuka-lbr-iiwa-14-r820", "rethink-sawyer"])
def test_of_a_redundant_arm_no_slice_holds_a_nearer_row(name, weights):
    arm, rng = pieper.load(name), np.random.default_rng(3)
    centre = rng.uniform(-1, 1, 7)
    arm = Arm(replace(arm.description, limits=np.c_[centre - 0.7, centre + 0.7]))
    for _ in range(2):
        q, now = (centre + rng.uniform(-0.7, 0.7, 7) for _ in range(2))
        T = arm.fk(q)
        nearest = arm.ik(T).nearest(now, weights)
        assert np.abs(arm.fk(nearest) - T).max() < 1e-9
        assert ((nearest >= arm.limits[:, 0] - 1e-8) & (nearest <= arm.limits[:, 1] + 1e-8)).all()
        least = away(arm, nearest[None], now, weights)[0]
        for joint in ("first", "last"):
            held = arm.joint_names[0 if joint == "first" else 6]
            lower, upper = arm.limits[0 if joint == "first" else 6]
            values = np.linspace(lower, upper, 400)
            many = arm.ik_many(np.tile(T, (400, 1, 1)), redundancy={held: values}, threads=1)
            rows = many.q[many.in_limits]
            assert len(rows)
            assert least <= away(arm, rows, now, weights).min() + 1e-9


@pytest.mark.parametrize("common", [1e-300, 1e-20, 1e-8, 1e20, 1e307])
@pytest.mark.parametrize("name", ["denso-vp6242", "franka-panda"])
def test_only_the_ratios_of_weights_count(name, common):
    arm = pieper.load(name)
    middle = arm.limits.mean(1)
    sols = arm.ik(arm.fk(middle + 0.4))
    now, weights = middle + 0.2, np.arange(1.0, arm.n + 1)
    one, other = sols.nearest(now, weights), sols.nearest(now, weights * common)
    assert np.abs(one - other).max() < 1e-7
    assert np.abs(arm.fk(other) - arm.fk(one)).max() < 1e-12


@pytest.mark.parametrize(
    "weights", [(1, 1), (1, 1, 1, 1, 1, -1), (0,) * 6, (1, 1, 1, 1, 1, np.nan), "heavy", np.ones((2, 6))]
)
def test_weights_that_weigh_nothing_are_refused(weights):
    arm = pieper.load("denso-vp6242")
    sols = arm.ik(arm.fk([0.3, 0.5, 1.4, 0.6, 0.7, 0.2]))
    with pytest.raises(InputError, match="weights"):
        sols.nearest(np.zeros(6), weights)


@pytest.mark.parametrize("now", [np.zeros(5), np.zeros((2, 6)), [0, 0, 0, 0, 0, np.inf], "nowhere"])
def test_a_posture_that_is_none_is_refused(now):
    arm = pieper.load("denso-vp6242")
    sols = arm.ik(arm.fk([0.3, 0.5, 1.4, 0.6, 0.7, 0.2]))
    for ask in (sols.nearest, sols.nearest_row):
        with pytest.raises(InputError, match="q_now|posture"):
            ask(now)
