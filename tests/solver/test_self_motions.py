"""What a self-motion says of itself, asked point by point: its pose, limits, nearest point, tangent and words."""

from __future__ import annotations

import re

import numpy as np
import pytest

import pieper
from oracle.joints import turns_apart
from pieper.solver.singular.relation import said

#: An arm, a posture whose pose has self-motions, and the limits of every joint in half turns.
CASES = {
    "two axes in one line": ("denso-vp6242", [0.3, 0.4, 1.2, 0.5, 0.0, -0.7], 0.9),
    "two axes in one line, narrow": ("denso-vp6242", [0.3, 0.4, 1.2, 0.5, 0.0, -0.7], 0.45),
    "four axes linked": ("universal-robots-ur5e", [0.3, -1.1, 1.3, -0.9, 0.0, 0.4], 1.0),
    "a spare joint": ("kuka-lbr-iiwa-14-r820", [0.3, 0.6, -0.4, -1.2, 0.5, 0.9, -0.2], 0.8),
}


def case(name):
    arm_name, q, part = CASES[name]
    arm = pieper.load(arm_name)
    arm = arm.with_limits(dict.fromkeys(arm.joint_names, (-part * np.pi, part * np.pi)))
    T = arm.fk(np.array(q))
    return arm, T, arm.ik(T)


@pytest.mark.parametrize("name", CASES)
def test_every_point_holds_the_pose_and_only_the_free_joints_move(name):
    arm, T, sols = case(name)
    assert sols.self_motions
    for motion in sols.self_motions:
        points = np.array([motion.at(u) for u in np.linspace(0, 1, 23)])
        assert np.abs(arm.fk(points) - T).max() < 1e-9
        # it begins with its samples, whole turns and all; a linkage goes on without a jump
        assert np.abs(points[0] - motion.samples[0, : arm.n]).max() < 1e-6
        assert name != "four axes linked" or np.abs(np.diff(points, axis=0)).max() < 2.5
        spread = turns_apart(points, points[0]).max(0)
        assert set(np.flatnonzero(spread > 1e-6)) == set(motion.free)
        assert all(motion.contains(point) and motion.distance(point) < 0.02 for point in points)
        still = [j for j in range(arm.n) if j not in motion.free]
        beside = points[7].copy()
        beside[still[0] if still else motion.free[0]] += 0.2
        assert not motion.contains(beside) and 0 < motion.distance(beside) < 0.21


@pytest.mark.parametrize("name", CASES)
def test_the_intervals_inside_the_limits_are_where_the_points_are(name):
    arm, _, sols = case(name)
    joints = arm.plan.chain.joints
    for motion in sols.self_motions:
        grid = np.linspace(0, 1, 301)
        points = np.array([motion.at(u) for u in grid])
        really = joints.inside_limits(points, arm.limits)[1]
        said = np.array([any(a <= u <= b for a, b in motion.inside) for u in grid])
        edges = np.array([e for ends in motion.inside for e in ends] or [-9.0])
        # a closed curve's end is its beginning again
        off = np.abs(grid[:, None] - edges)
        far = np.minimum(off, np.abs(1 - off)).min(1) > 0.02
        assert (really == said)[far].all()


@pytest.mark.parametrize("name", CASES)
def test_the_nearest_point_is_inside_and_no_point_of_a_fine_grid_is_nearer(name):
    arm, T, sols = case(name)
    joints = arm.plan.chain.joints
    rng = np.random.default_rng(2)
    for motion in sols.self_motions:
        points = np.array([motion.at(u) for u in np.linspace(0, 1, 400)])
        for weights in (None, rng.uniform(0.2, 3.0, arm.n)):
            now = rng.uniform(-2, 2, arm.n)
            counts = np.ones(arm.n) if weights is None else weights
            wound, inside = joints.inside_limits(joints.unwound(points, now, arm.limits), arm.limits)
            best = np.sqrt((counts * (wound - now) ** 2).sum(1))[inside].min(initial=np.inf)
            found = motion.nearest(now, weights)
            if found is None:
                assert not inside.any()
                continue
            assert np.abs(arm.fk(found) - T).max() < 1e-9 and joints.inside_limits(found, arm.limits)[1]
            assert np.sqrt((counts * (found - now) ** 2).sum()) < best + 1e-6


@pytest.mark.parametrize("name", CASES)
def test_the_tangent_moves_nothing_and_has_length_one(name):
    arm, _, sols = case(name)
    for motion in sols.self_motions:
        J = arm.jacobian(motion.representative)
        assert abs(np.linalg.norm(motion.direction) - 1) < 1e-12
        assert np.abs(J @ (motion.direction * arm.plan.chain.joints.unit)).max() < 1e-6


@pytest.mark.parametrize("name", CASES)
def test_a_joint_is_brought_to_a_value_wherever_the_curve_has_it(name):
    arm, T, sols = case(name)
    for motion in sols.self_motions:
        joint = motion.free[0]
        point = motion.at(0.37)
        found = motion.at_joint(joint, point[joint])
        assert len(found) and np.abs(arm.fk(found) - T).max() < 1e-8
        assert turns_apart(found[:, joint], point[joint]).max() < 1e-8
        assert turns_apart(found, point).max(1).min() < 1e-5


def test_the_relation_in_words_is_that_of_the_points():
    for name in ("two axes in one line", "two axes in one line, narrow"):
        arm, _, sols = case(name)
        (motion,) = [m for m in sols.self_motions if m.relation][:1]
        first, sign, second, value = re.fullmatch(r"(\w+) ([+-]) (\w+) = (\S+) deg", motion.relation).groups()
        i, j = (arm.joint_names.index(word) for word in (first, second))
        total = [motion.at(u)[i] + (1 if sign == "+" else -1) * motion.at(u)[j] for u in np.linspace(0, 1, 9)]
        assert np.abs(np.angle(np.exp(1j * (np.array(total) - np.radians(float(value)))))).max() < 1e-5
        assert str(motion) == f"{first}, {second} move together all the way round with {motion.relation}"


def test_the_representative_is_inside_the_limits_if_any_point_is_and_small():
    for name in CASES:
        arm, _, sols = case(name)
        joints = arm.plan.chain.joints
        for motion in sols.self_motions:
            points = np.array([motion.at(u) for u in np.linspace(0, 1, 200)])
            near, inside = joints.inside_limits(joints.unwound(points, np.zeros(arm.n), arm.limits), arm.limits)
            assert joints.inside_limits(motion.representative, arm.limits)[1] == inside.any()
            least = np.linalg.norm(near[inside] if inside.any() else near, axis=1).min()
            assert np.linalg.norm(motion.representative) < least + 0.15


@pytest.mark.parametrize("name", ["kuka-lbr-iiwa-14-r820", "rethink-sawyer"])
def test_at_an_arm_angle_the_posture_that_has_it_is_found_and_every_row_has_it(name):
    arm, rng = pieper.load(name), np.random.default_rng(6)
    for q in rng.uniform(-1.2, 1.2, (3, 7)):
        T, angle = arm.fk(q), float(arm.arm_angle(q)[0])
        rows = arm.ik(T, redundancy={"arm angle": angle}).all_q
        assert turns_apart(rows, q).max(1).min() < 1e-6
        assert np.abs(arm.fk(rows) - T).max() < 1e-9
        assert turns_apart(arm.arm_angle(rows)[0], angle).max() < 1e-6
        assert len(rows) == len(np.unique(np.round(np.sin(rows), 5), axis=0)), "no row stands twice"


@pytest.mark.parametrize("limits", [(1.0, 2.0), (-3.0, -0.4), (0.1, 0.2), (-0.5, 0.5)])
def test_the_representative_of_two_axes_in_one_line_is_the_smallest_point_inside(limits):
    arm_name, q, _ = CASES["two axes in one line"]
    arm = pieper.load(arm_name)
    wide = dict.fromkeys(arm.joint_names, (-3.1, 3.1))
    arm = arm.with_limits(wide | {"joint_4": limits, "joint_6": (-5.5, 5.5)})
    sols = arm.ik(arm.fk(np.array(q)))
    inside = [motion for motion in sols.self_motions if motion.inside]
    assert inside
    for motion in inside:
        at = motion.at(0.2)
        sense = -np.sign(np.prod((motion.at(0.3) - at)[[3, 5]]))
        fourth = np.linspace(*limits, 20001)
        sixth = sense * (at[3] + sense * at[5] - fourth)[:, None] + 2 * np.pi * np.arange(-2, 3)
        size = np.where(np.abs(sixth) <= 5.5, fourth[:, None] ** 2 + sixth**2, np.inf)
        least = fourth[np.unravel_index(np.argmin(size), size.shape)[0]]
        assert abs(motion.representative[3] - least) < 2e-4 and abs(motion.representative[5]) <= 5.5


def test_what_is_rounding_is_said_as_zero_and_only_joints_that_move_are_named():
    arm = pieper.load("denso-vp6242")
    (motion,) = arm.ik(arm.fk("zero")).self_motions
    assert motion.relation == "joint_4 + joint_6 = 0 deg"
    assert repr(motion) == "<SelfMotion of joint_4, joint_6: closed, dimension 1>"
    assert [said(value, "mm") for value in (-1e-13, 1e-12, -2.5, 1e-6)] == ["0 mm", "0 mm", "-2.5 mm", "1e-06 mm"]
