"""Laws of what seven joints leave free at a pose: closed curves, each told once, as a slow tracer follows them."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from oracle import curve_of_seven as slow
from oracle import slow_forward
from pieper import DH, Arm
from pieper.kinematics.newton import scaled_jacobian


def random_seven(seed) -> Arm:
    rng = np.random.default_rng(seed)
    rows = [
        DH(rng.uniform(-0.2, 0.2), rng.choice([-1, 1]) * rng.uniform(0.5, 2.5), rng.uniform(0.1, 0.4), 0)
        for _ in range(7)
    ]
    return Arm.from_dh(rows, convention="standard", limits=[(-3.1, 3.1)] * 7)


def arm_of(name) -> Arm:
    if name.startswith("random"):
        return random_seven(int(name.split()[1]))
    arm = pieper.load(name)
    return arm.with_limits(dict.fromkeys(arm.joint_names, (-3.1, 3.1)))


def near_singular(arm, rng, away):
    """Return a posture so far (rad) from one at which another direction is free."""

    def weakest(q):
        return np.linalg.svd(scaled_jacobian(arm.chain, q), compute_uv=False)[..., 5]

    steps = 1e-6 * np.eye(7)
    while True:
        q = rng.uniform(-2.5, 2.5, 7)
        for _ in range(60):
            value = weakest(q)
            if value < 1e-9:
                break
            slope = (weakest(q + steps) - weakest(q - steps)) / 2e-6
            step = -value * slope / (slope @ slope + 1e-12)
            q = q + step * min(1.0, 0.2 / np.abs(step).max())
        way = rng.normal(size=7)
        q = slow.around(q) + away * way / np.linalg.norm(way)
        if value < 1e-7 and (np.abs(q) < 3.0).all():
            return q


def postures(name):
    """Return an arm and postures: any, with zeros that bring axes into one line, round ones, beside singular ones."""
    arm, rng = arm_of(name), np.random.default_rng(21)
    out = [rng.uniform(-2.9, 2.9, 7)]
    for at in ({1: 0.0}, {5: 0.0}, {1: 1e-3, 5: 0.0}, {1: -1e-5}, {5: 1e-4}):
        q = rng.uniform(-2.9, 2.9, 7)
        q[list(at)] = list(at.values())
        out.append(q)
    out += [near_singular(arm, rng, away) for away in (1e-2, 1e-3, 1e-4, 3e-5)]
    return arm, out


def length(motion):
    return float(np.linalg.norm(np.diff(motion.samples, axis=0), axis=1).sum())


def assert_told_once(arm, q, *, across=slow.FAR, thorough=False):
    """Assert that what holds the pose that q makes is told as closed curves, each once, q and all rows on one."""
    rng = np.random.default_rng(3)
    T = slow_forward.fk(arm.chain, q)
    sols = arm.ik(T)
    motions = sols.self_motions
    assert all(m.closed and m.dimension == 1 for m in motions)
    for row in (q, *sols.all_q):
        assert sum(m.contains(row) for m in motions) == 1
    mine = next(m for m in motions if m.contains(q))
    points, closed, long = slow.followed(slow_forward, arm.chain, q, T, across=across)
    assert closed
    assert abs(length(mine) - long) < 0.02 * long
    assert all(mine.contains(p) for p in slow.around(points[:: max(1, len(points) // 12)]))
    for motion in motions:
        some = [motion.at(u) for u in rng.random(3)]
        for p in some:
            assert np.abs(slow_forward.fk(arm.chain, p) - T).max() < 1e-11
            assert sum(other.contains(p) for other in motions) == 1
        if thorough:
            _, closed, long = slow.followed(slow_forward, arm.chain, some[0], T, across=across)
            assert closed and abs(length(motion) - long) < 0.02 * long


@pytest.mark.parametrize("k", range(10))
@pytest.mark.parametrize(
    "name",
    [
        "franka-panda",
        "kinova-gen3-7dof",
        "ufactory-xarm7",
        "rethink-sawyer",
        "random 1",
        "random 2",
    ],
)
def test_what_is_free_is_told_as_closed_curves_each_once(name, k):
    arm, some = postures(name)
    assert_told_once(arm, some[k], across=slow.CLOSELY if k > 5 else slow.FAR, thorough=k % 3 == 1)


#: Where the general course crosses a circle of axes in one line: it turned into the circle and went round it ten times.
CROSSED = [
    ("franka-panda", [-2.356194490192345, 0, 2.356194490192345, -2.356194490192345, -2.356194490192345, 0, 0]),
    ("franka-panda", [1.9117449, 0, -1.50633382, -0.0798, 2.45849655, 2.0726078, -2.18771097]),
    ("franka-panda", [-1.5707963267948966, 0, 2.356194490192345, -0.7853981633974483, 0, 1.5707963267948966, 0]),
    ("ufactory-xarm7", [-2.56631752, 0, 1.23067748, -0.162448168, 1.8467988, 0, -1.11668952]),
    ("kinova-gen3-7dof", [1.24688280, 0.001, -1.49104644, 2.56959666, 2.29766446, 0, 0.577856411]),
    ("kinova-gen3-7dof", [0.43488254, 0, 0.06998644, -0.26480403, 0.12858005, 0, -1.47831971]),
]


@pytest.mark.parametrize(("name", "q"), CROSSED)
def test_a_curve_that_crosses_a_circle_of_axes_in_one_line_goes_straight_on(name, q):
    assert_told_once(arm_of(name), np.array(q))


#: Beside singular postures: closed curves were told twice, or as one between two ends that goes round three times; a
#: few thousandths of a radian across they were lost, or told as points.
BESIDE = [
    (
        "franka-panda",
        [
            1.6084887715067195,
            1.577287960233285,
            -0.5721191430439353,
            -0.5363426280175034,
            1.5708164973368401,
            -1.11181882393721,
            1.4172226783609938,
        ],
    ),
    (
        "kinova-gen3-7dof",
        [
            -0.6278883034129583,
            -0.01663413808064107,
            -1.8725209609171738,
            5.470513036553447e-06,
            -1.8227056275544138,
            -1.5166827854226175,
            2.415254078863498,
        ],
    ),
    (
        "kinova-gen3-7dof",
        [
            1.99639262018956,
            0.01660126661774826,
            1.8781816614875049,
            3.694381408808542e-07,
            0.45352885130707543,
            -0.914749479231384,
            -0.10888091323900623,
        ],
    ),
    (
        "ufactory-xarm7",
        [
            2.0900140842012793,
            -1.8019154325653564,
            1.6849601452550933,
            2.6787706026292266,
            -1.5703529705944181,
            -1.881939345304288,
            -0.014062697414424827,
        ],
    ),
    (
        "random 1",
        [
            0.3309064851872892,
            -1.2858537371516743,
            0.7561314359076725,
            0.4411628817330985,
            0.6425211773943157,
            -1.9190671675251687,
            -1.33541045686977,
        ],
    ),
    (
        "random 2",
        [
            -0.0577019032476699,
            -2.438025416374875,
            -2.1875270149891453,
            1.1742936337681742,
            2.4604667838411522,
            -2.0293754249241505,
            -0.11796617807290524,
        ],
    ),
    (
        "random 2",
        [
            -1.5678203067306777,
            -1.6127674113516943,
            2.0550091171544356,
            1.9991999915627832,
            1.325966003183603,
            2.8500877507776368,
            -0.04643658565378643,
        ],
    ),
]


@pytest.mark.parametrize(("name", "q"), BESIDE)
def test_curves_beside_singular_postures_are_told_once_however_small(name, q):
    assert_told_once(arm_of(name), np.array(q), across=slow.CLOSELY)
