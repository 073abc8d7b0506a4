"""Laws of the arm angle: solutions have the angle asked for, none is missing, and where there is none it is said."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from oracle.joints import around
from pieper import Status
from pieper.solver.redundant.at_arm_angle import by_sweep

SPHERICAL = ["kuka-lbr-iiwa-14-r820", "kuka-lwr-4-plus", "motoman-sia10d", "motoman-sia20d"]
OFFSET = ["franka-panda", "franka-fr3", "kinova-gen3-7dof", "ufactory-xarm7", "rethink-sawyer", "rethink-baxter-left"]
POSTURE = np.array([0.4, -0.7, 0.5, 1.1, -0.6, 0.9, 0.3])


def lines(arm, q):
    """Return a point (7, 3) on each joint axis and the axes (7, 3), of the frames that the table itself makes."""
    F = arm.frames(q)
    before = 1 if arm.description.convention == "modified" else 0
    joints = F[before : before + 7]
    return joints[:, :3, 3], joints[:, :3, 2]


def foot(p, u, r, v):
    """Return the point of the line p + t u nearest to the line r + s v."""
    t, _ = np.linalg.lstsq(np.stack([u, -v], 1), r - p, rcond=None)[0]
    return p + t * u


def angle_by_definition(arm, q):
    """Return the arm angle of q as Elias and Wen write it, from frames alone: S on axis 1, E on axis 4, W on axis 7.

    Where axes 1, 2 and 3 meet, the point of axis 1 nearest to axis 2 is where they meet; so at the wrist.
    """
    p, u = lines(arm, q)
    S, E, W = foot(p[0], u[0], p[1], u[1]), foot(p[3], u[3], p[2], u[2]), foot(p[6], u[6], p[5], u[5])
    pole, reference = -arm.base[:3, 2], arm.base[:3, 0]
    sw = (W - S) / np.linalg.norm(W - S)
    across = np.cross(np.cross(sw - pole, reference), sw)
    across /= np.linalg.norm(across)
    return np.arctan2((E - S) @ np.cross(sw, across), (E - S) @ across)


def turned(a, b):
    """Return angles a - b around the circle."""
    return around(np.asarray(a) - b)


@pytest.mark.parametrize("name", SPHERICAL + OFFSET)
def test_the_arm_angle_of_a_posture_is_the_one_of_the_definition(name):
    arm = pieper.load(name)
    q = np.random.default_rng(1).uniform(-3, 3, (20, 7))
    angle, defined = arm.arm_angle(q)
    assert defined.all()
    assert np.abs(turned(angle, [angle_by_definition(arm, row) for row in q])).max() < 1e-12


@pytest.mark.parametrize("name", SPHERICAL + OFFSET)
def test_each_solution_has_the_arm_angle_asked_for_and_the_posture_it_came_from_is_among_them(name):
    arm = pieper.load(name)
    count = 40 if name in SPHERICAL else 3
    q = np.random.default_rng(2).uniform(-3, 3, (count, 7))
    T, asked = arm.fk(q), arm.arm_angle(q)[0]
    many = arm.ik_many(T, threads=1, redundancy={"arm angle": asked})
    for i in range(count):
        rows = many.q[i][many.valid[i]]
        assert np.abs(turned(rows, q[i])).max(1).min() < 1e-7
        assert max(abs(turned(angle_by_definition(arm, row), asked[i])) for row in rows) < 1e-9
        assert arm.plan.residual(rows, T[i]).max() < 1e-10


@pytest.mark.parametrize("name", SPHERICAL[:2] + OFFSET[:1])
def test_one_pose_and_many_poses_agree_at_an_arm_angle(name):
    arm = pieper.load(name)
    T = arm.fk(np.random.default_rng(3).uniform(-2, 2, (3, 7)))
    many = arm.ik_many(T, threads=1, redundancy={"arm angle": 0.4})
    for i in range(3):
        one = arm.ik(T[i], redundancy={"arm angle": 0.4})
        np.testing.assert_allclose(one.all_q, many.q[i][many.valid[i]], atol=1e-9)
        np.testing.assert_array_equal(one.in_limits, many.in_limits[i][many.valid[i]])
        assert one.status == many.status[i]


def searched(arm, T, asked, starts, rng):
    """Return the distinct solutions of pose and arm angle that Newton's method finds from random starts.

    Its own equations: the angle by definition, its derivative by differences.
    """

    def equations(q):
        now = arm.fk(q)
        R = T[:3, :3] @ now[:3, :3].T
        turn = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) / 2
        return np.concatenate([T[:3, 3] - now[:3, 3], turn, [turned(asked, angle_by_definition(arm, q))]])

    found = []
    for start in rng.uniform(-np.pi, np.pi, (starts, 7)):
        q = start
        for _ in range(40):
            e = equations(q)
            if np.linalg.norm(e) < 1e-11:
                break
            grow = [(angle_by_definition(arm, q + d) - angle_by_definition(arm, q - d)) for d in 1e-6 * np.eye(7)]
            A = np.vstack([arm.jacobian(q), turned(np.array(grow), 0.0) / 2e-6])
            step = np.linalg.lstsq(A, e, rcond=1e-10)[0]
            q = q + step * min(1.0, 0.5 / np.linalg.norm(step))
        now = arm.fk(q)
        if np.linalg.norm(equations(q)) < 1e-9 and np.abs(now - T).max() < 1e-8:
            if not any(np.abs(turned(q, other)).max() < 1e-5 for other in found):
                found.append(q)
    return np.array(found)


@pytest.mark.parametrize("name", ["kuka-lbr-iiwa-14-r820", "rethink-sawyer"])
def test_an_independent_search_finds_nothing_else(name):
    arm = pieper.load(name)
    T, asked = arm.fk(POSTURE), float(arm.arm_angle(POSTURE)[0])
    rows = arm.ik(T, redundancy={"arm angle": asked}).all_q
    found = searched(arm, T, asked, 24, np.random.default_rng(4))
    assert len(found) >= 3, "the search found too little to judge by"
    for q in found:
        assert np.abs(turned(rows, q)).max(1).min() < 1e-6
    assert len(rows) >= len(found)


@pytest.mark.parametrize("name", SPHERICAL[:1] + OFFSET[:1])
def test_no_poses_at_all_are_an_empty_batch_at_an_arm_angle(name):
    arm = pieper.load(name)
    many = arm.ik_many(np.zeros((0, 4, 4)), redundancy={"arm angle": 0.3})
    assert many.q.shape == (0, arm.plan.arm_angle.max_solutions, 7) and many.status.shape == (0,)


@pytest.mark.parametrize("name", SPHERICAL[:3])
def test_the_closed_form_and_the_sweep_agree(name):
    arm = pieper.load(name)
    for q in np.random.default_rng(5).uniform(-2.5, 2.5, (3, 7)):
        T, asked = arm.fk(q), float(arm.arm_angle(q)[0])
        rows = arm.ik(T, redundancy={"arm angle": asked}).all_q
        swept, valid, _ = by_sweep(arm.plan, arm.plan.arm_angle, T[None], np.array([asked]))
        swept = swept[valid]
        assert len(rows) == len(swept)
        assert max(np.abs(turned(rows, other)).max(1).min() for other in swept) < 1e-7


def undefined(arm, T):
    """Assert that a pose has no arm angle and says so, alone and in a batch."""
    sols = arm.ik(T, redundancy={"arm angle": 0.3})
    assert sols.status == Status.UNCERTAIN and len(sols.all_q) == 0 and "undefined" in sols.why
    many = arm.ik_many(np.stack([T, T]), threads=1, redundancy={"arm angle": 0.3})
    assert (many.status == Status.UNCERTAIN).all() and not many.valid.any() and np.isfinite(many.q).all()


def test_a_stretched_elbow_has_no_arm_angle_and_says_so():
    arm = pieper.load("kuka-lbr-iiwa-14-r820")
    q = np.array([0.3, 0.4, 0.5, 0.0, 0.2, 0.7, 0.3])
    angle, defined = arm.arm_angle(q)
    assert angle == 0.0 and not defined
    undefined(arm, arm.fk(q))


@pytest.mark.parametrize("name", ["kuka-lbr-iiwa-14-r820", "franka-panda"])
def test_a_wrist_on_the_pole_of_the_reference_has_no_arm_angle_and_says_so(name):
    arm = pieper.load(name)
    angle = arm.plan.arm_angle
    T = arm.fk(POSTURE)
    T[:3, 3] += (angle.shoulder + 0.5 * angle.pole) - (T[:3, :3] @ angle.wrist + T[:3, 3])
    undefined(arm, T)
    beside = T.copy()
    beside[:3, 3] += 1e-3 * angle.reference
    assert arm.ik(beside, redundancy={"arm angle": 0.3}).status != Status.UNCERTAIN


@pytest.mark.parametrize("shoulder", [0.0, 1e-10, 1e-7, 1e-3])
@pytest.mark.parametrize("wrist", [0.0, 1e-9, 1e-6, 1e-2])
def test_shoulder_and_wrist_in_line_or_nearly_lose_nothing(shoulder, wrist):
    arm = pieper.load("kuka-lbr-iiwa-14-r820")
    q = np.array([0.3, shoulder, 0.5, 1.0, 0.2, wrist, 0.3])
    T, asked = arm.fk(q), float(arm.arm_angle(q)[0])
    sols = arm.ik(T, redundancy={"arm angle": asked})
    assert sols.status == Status.REDUNDANT
    assert arm.plan.residual(sols.all_q, T).max() < 1e-12
    assert np.abs(turned([angle_by_definition(arm, row) for row in sols.all_q], asked)).max() < 1e-9
    # where axes line up only the sum of their joints is told
    told = [[row[0] + row[2], row[1], row[3], row[4] + row[6], row[5]] for row in (*sols.all_q, q)]
    assert np.abs(turned(told[:-1], told[-1])).max(1).min() < 1e-6
    assert len(sols.all_q) == 2 * (1 if shoulder == 0 else 2) * (1 if wrist == 0 else 2)


def test_a_wrist_straight_up_has_an_arm_angle():
    arm = pieper.load("kuka-lbr-iiwa-14-r820")
    q = np.array([0.7, 0.5, 0.2, -1.0, 0.3, 0.6, 0.1])
    angle = arm.plan.arm_angle
    T = arm.fk(q)
    T[:3, 3] += (angle.shoulder - 0.6 * angle.pole) - (T[:3, :3] @ angle.wrist + T[:3, 3])
    sols = arm.ik(T, redundancy={"arm angle": -1.2})
    assert len(sols.all_q) == 8
    assert np.abs(turned([angle_by_definition(arm, row) for row in sols.all_q], -1.2)).max() < 1e-9


@pytest.mark.parametrize(
    ("redundancy", "word"),
    [
        ({"arm angle": np.nan}, "finite"),
        ({"arm angle": "up"}, "finite"),
        ({"arm angle": [0.1, 0.2]}, "one number"),
        ({"arm angle": 0.1, "joint_1": 0.2}, "either"),
        ({"elbow": 0.1}, "arm angle"),
    ],
)
def test_an_impossible_arm_angle_is_refused(redundancy, word):
    arm = pieper.load("kuka-lbr-iiwa-14-r820")
    with pytest.raises(pieper.InputError, match=word):
        arm.ik(arm.fk(POSTURE), redundancy=redundancy)


def test_arms_without_an_arm_angle_say_why():
    eight = pieper.Arm.from_dh([pieper.DH(0.1, 1.0, 0.2, 0)] * 8, convention="standard")
    with pytest.raises(pieper.InputError, match="one joint to spare"):
        eight.arm_angle(np.zeros(8))
    sliding = pieper.Arm.from_dh([pieper.DH(0.1, 1.0, 0.2, 0)] * 7, convention="standard", joint_types="RRRPRRR")
    with pytest.raises(pieper.InputError, match="seven revolute"):
        sliding.ik(sliding.fk(np.full(7, 0.2)), redundancy={"arm angle": 0.1})
    flat = [pieper.DH(0.3, 0, 0, 0)] + [pieper.DH(0.1, 1.0, 0.2, 0)] * 6
    with pytest.raises(pieper.InputError, match="joints 1 and 2 are parallel"):
        pieper.Arm.from_dh(flat, convention="standard").arm_angle(np.zeros(7))
