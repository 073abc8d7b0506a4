"""A law: a pose comes to the same digits alone as among others, however many they are and in whatever order.

Where a joint stands at half a turn its last digit says whether that is +pi or -pi, and limits may hold only one.
"""

from __future__ import annotations

import numpy as np
import pytest

import pieper

#: Of the closed forms and an offset wrist.
SOLVED_AT_ONCE = (
    "denso-vp6242", "kuka-kr6-r900-2", "abb-irb-2400", "puma-560", "staubli-tx60", "doosan-m1013", "ur5e", "ur10e",
    "techman-tm5-700", "dobot-nova5", "stanford-arm", "motoman-ea1400n", "universal-robots-ur3",
    "fanuc-lr-mate-200id", "kuka-kr10-r1100-2",
)  # fmt: skip
#: By elimination, with coupled joints, linkages, slides, fewer joints than six: singular poses take up to a second.
OTHERS = (
    "fanuc-crx-10ia", "kinova-mico", "kinova-gen3-6dof", "fanuc-lr-mate-200id-controller",
    "fanuc-crx-10ia-controller", "kuka-kr120-r3200-pa", "dobot-mg400", "dobot-magician", "adept-cobra-600",
    "epson-ls3-401s", "doosan-p3020", "ufactory-xarm5", "three-r", "so-101", "interbotix-pincherx-100",
    "interbotix-viperx-300", "robotis-openmanipulator-x", "dfrobot-rob0036",
)  # fmt: skip


def limited(arm):
    """Yield an arm with its own limits, with a whole turn, with limits at eighths of a turn, and cut elsewhere."""
    yield arm
    slides = arm.chain.prismatic[:, None]
    eighths = np.round(np.clip(arm.limits, -np.pi, np.pi) / (np.pi / 4)) * (np.pi / 4)
    for limits in ([[-np.pi, np.pi]], eighths, [[-7.0, 1.0]]):
        wanted = np.where(slides, arm.limits, limits)
        wanted = np.where((wanted[:, 1] - wanted[:, 0] < 0.1)[:, None], arm.limits, wanted)
        yield arm.with_limits(
            {name: tuple(map(float, pair)) for name, pair in zip(arm.joint_names, wanted, strict=True)}
        )


def poses(arm, rng, count):
    """Return poses at quarters of a turn, with some joints at these, and at random; some are typed with 8 digits."""
    unit = np.where(arm.chain.prismatic, arm.chain.length / 5, 1.0)
    quarters = rng.integers(-2, 3, (count, arm.n)) * (np.pi / 2)
    any_where = rng.uniform(-np.pi, np.pi, (count, arm.n))
    mixed = np.where(rng.random((count, arm.n)) < 0.5, quarters, any_where)
    T = arm.fk(np.concatenate([quarters, mixed, any_where[: count // 2]]) * unit)
    T[::7] = np.round(T[::7], 8)
    return T


def the_same(one, many, i):
    there = many.valid[i]
    assert one.status == many.status[i] and one.flag == many.flag[i], f"pose {i}: {one.status}, {many.status[i]}"
    np.testing.assert_array_equal(one.all_q, many.q[i][there], err_msg=f"pose {i}")
    np.testing.assert_array_equal(one.in_limits, many.in_limits[i][there], err_msg=f"pose {i}")


def hold(name, count):
    rng = np.random.default_rng(sum(map(ord, name)))
    for arm in limited(pieper.load(name)):
        T = poses(arm, rng, count)
        alone = [arm.ik(pose) for pose in T]
        for size in (1, 9, len(T)):
            for first in range(0, len(T), size):
                many = arm.ik_many(T[first : first + size], threads=1)
                for k in range(len(many)):
                    the_same(alone[first + k], many, k)
        order = rng.permutation(len(T))
        # no two postures that differ by quarters of a turn are as near: what is in one sum is in no other
        near = 2.1 + np.sqrt([2.0, 3.0, 5.0, 7.0, 11.0, 13.0])[: arm.n] % 1
        many = arm.ik_many(T[order], threads=2, near=near)
        for k, i in enumerate(order):
            the_same(alone[i], many, k)
            if alone[i].status is pieper.Status.SOLVED:
                np.testing.assert_allclose(alone[i].nearest(near), many.nearest[k], rtol=0, atol=1e-12)


@pytest.mark.parametrize("name", SOLVED_AT_ONCE)
def test_alone_and_among_others(name):
    hold(name, 8)


@pytest.mark.slow
@pytest.mark.parametrize("name", OTHERS)
def test_alone_and_among_others_of_slower_arms(name):
    hold(name, 8)


@pytest.mark.parametrize("count", [2, 7, 8, 9, 17])
def test_forward_kinematics_alone_and_among_others(count):
    arm = pieper.load("denso-vp6242")
    q = np.random.default_rng(count).uniform(-3, 3, (count, 6))
    together = arm.fk(q), arm.jacobian(q), arm.frames(q)
    for k in range(count):
        for one, many in zip((arm.fk(q[k]), arm.jacobian(q[k]), arm.frames(q[k])), together, strict=True):
            np.testing.assert_array_equal(one, many[k])
