"""Laws of redundant arms inside tight limits: statuses, the nearest point and the exact ends of what is inside."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import pieper
from oracle import slow_forward
from pieper import DH, Arm, Status
from pieper.solver.redundant import anywhere, stops

SEVEN = ["franka-panda", "kuka-lbr-iiwa-14-r820", "rethink-sawyer", "kinova-gen3-7dof", "random"]
WIDTHS = [1.0, 0.5, 0.2, 0.05]


def some(name, rng) -> Arm:
    """Return a catalogue arm, or one of no special kind with as many joints as its name says."""
    if not name.startswith("random"):
        return pieper.load(name)
    joints = 8 if name.endswith("eight") else 7
    rows = [DH(rng.uniform(-0.5, 0.5), rng.uniform(-3, 3), rng.uniform(-0.5, 0.5), 0.0) for _ in range(joints)]
    return Arm.from_dh(rows, convention="standard", name=name)


def tight(name, width, seed, count):
    """Return an arm with limits of one width about a posture, joint vectors inside them, and their poses."""
    rng = np.random.default_rng(seed)
    arm = some(name, rng)
    centre = rng.uniform(-1.5, 1.5, arm.n)
    arm = Arm(replace(arm.description, limits=np.c_[centre - width, centre + width]))
    q = centre + rng.uniform(-width, width, (count, arm.n))
    return arm, q, arm.fk(q)


def inside(arm, q):
    return ((q >= arm.limits[:, 0] - 1e-8) & (q <= arm.limits[:, 1] + 1e-8)).all(-1)


@pytest.mark.parametrize("width", WIDTHS)
@pytest.mark.parametrize("name", [*SEVEN, "random eight"])
def test_a_pose_made_inside_the_limits_is_redundant_with_a_row_inside(name, width):
    arm, _, T = tight(name, width, 1, 20 if name == "random eight" else 100)
    many = arm.ik_many(T, threads=1)
    assert (many.status == Status.REDUNDANT).all()
    assert many.in_limits.any(1).all()
    rows, pose = many.q[many.in_limits], np.nonzero(many.in_limits)[0]
    assert inside(arm, rows).all()
    assert np.abs(slow_forward.fk(arm.chain, rows) - T[pose]).max() < 1e-9
    back = np.random.default_rng(0).permutation(len(T))[:15]
    again = arm.ik_many(T[back], threads=1)
    np.testing.assert_allclose(again.q, many.q[back], atol=1e-9)
    one = arm.ik(T[0])
    assert one.status == Status.REDUNDANT
    np.testing.assert_allclose(one.all_q, many.q[0][many.valid[0]], atol=1e-9)


@pytest.mark.parametrize("width", [0.8, 0.1])
@pytest.mark.parametrize("name", ["franka-panda", "rethink-sawyer", "random", "random eight"])
def test_the_nearest_point_to_a_posture_that_holds_the_pose_is_that_posture(name, width):
    arm, q, T = tight(name, width, 2, 1)
    nearest = arm.ik(T[0]).nearest(q[0])
    assert np.abs(nearest - q[0]).max() < 1e-6


def followed(arm, q, T, way):
    """Return where the self-motion through q leaves the limits: tiny steps along the null direction, then halving.

    Forward kinematics and Jacobian are the oracle's, Newton's method is written here.
    """
    chain, length = arm.chain, 1e-3
    old = None
    for _ in range(8000):
        null = np.linalg.svd(slow_forward.jacobian(chain, q))[2][-1]
        null = null * (np.sign(null @ old) if old is not None else way)
        step = length
        ahead = onto(chain, q + step * null, T)
        if not inside_exactly(arm, ahead):
            while step > 1e-12:
                step /= 2
                ahead = onto(chain, q + step * null, T)
                if inside_exactly(arm, ahead):
                    q = ahead
            return q
        q, old = ahead, null
    return None


def onto(chain, q, T):
    for _ in range(4):
        now = slow_forward.fk(chain, q)
        R = T[:3, :3] @ now[:3, :3].T
        turn = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) / 2
        e = np.concatenate([T[:3, 3] - now[:3, 3], turn])
        q = q + np.linalg.lstsq(slow_forward.jacobian(chain, q), e, rcond=None)[0]
    return q


def inside_exactly(arm, q):
    return bool(((q >= arm.limits[:, 0]) & (q <= arm.limits[:, 1])).all())


@pytest.mark.parametrize("seed", range(2))
@pytest.mark.parametrize("name", ["franka-panda", "kuka-lbr-iiwa-14-r820", "random"])
def test_intervals_inside_end_where_small_steps_leave_the_limits(name, seed):
    arm, q, T = tight(name, (0.4, 0.06)[seed], 3 + seed, 1)
    q, T = q[0], T[0]
    ends = [followed(arm, q, T, way) for way in (1.0, -1.0)]
    assert all(end is not None for end in ends), "the self-motion does not leave the limits"
    motion = next(m for m in arm.ik(T).self_motions if m.contains(q, 1e-6))
    found = np.array([motion.at(u) for interval in motion.inside for u in interval])
    for end in ends:
        assert np.abs(found - end).max(1).min() < 1e-6
    for low, high in motion.inside:
        points = np.array([motion.at(u) for u in np.linspace(low, high, 5)])
        assert inside(arm, points).all()
    assert all(b < c for (_, b), (c, _) in zip(motion.inside, motion.inside[1:], strict=False))


def test_a_joint_with_more_than_a_turn_is_resolved_to_the_nearest_winding():
    arm = pieper.load("kuka-lbr-iiwa-14-r820")
    limits = np.tile([-2.9, 2.9], (7, 1))
    limits[2], limits[4], limits[6] = (-4.5, 4.5), (-0.5, 4.0), (-7.0, 5.0)
    arm = Arm(replace(arm.description, limits=limits))
    q = np.array([0.4, -0.7, 3.9, 1.1, 2.6, 0.9, -6.3])
    assert np.abs(arm.ik(arm.fk(q)).nearest(q) - q).max() < 1e-6


def test_four_thousand_poses_made_inside_are_redundant_in_one_call():
    arm = pieper.load("franka-panda")
    q = np.random.default_rng(0).uniform(*arm.limits.T, (4000, 7))
    many = arm.ik_many(arm.fk(q))
    assert (many.status == Status.REDUNDANT).all() and many.in_limits.any(1).all()


BRAVO = [
    DH(0.046, -np.pi / 2, -0.0554),
    DH(0.29, 0.0, 0.0),
    DH(-0.0408, np.pi / 2, 0.0),
    DH(0.0408, -np.pi / 2, -0.16),
    DH(0.0408, np.pi / 2, 0.0),
    DH(0.033, -np.pi / 2, 0.28),
    DH(0.0, np.pi, 0.0),
]


def test_values_at_which_two_axes_come_to_coincide_are_stepped_over():
    arm = Arm.from_dh(BRAVO, convention="standard", limits=[(0, 1.5)] * 7)
    q = 1.5 * np.random.default_rng(0).random((30, 7))
    T = arm.fk(q)
    many = arm.ik_many(T, threads=1)
    assert (many.status == Status.REDUNDANT).all()
    assert all(arm.ik(T[i]).status == Status.REDUNDANT for i in range(5))
    middle = arm.fk(np.full(7, 0.5))
    assert any(m.contains(np.full(7, 0.5), 1e-5) for m in arm.ik(middle, redundancy=0.5).self_motions)


@pytest.mark.parametrize("half", [0.0, 1e-16, 1e-12])
def test_limits_closer_than_rounding_hold_a_joint_and_lose_no_pose(half):
    for name, joint in (("franka-panda", 2), ("denso-vp6242", 2)):
        arm = pieper.load(name)
        q = arm.limits.mean(1) + 0.1
        limits = arm.limits.copy()
        limits[joint] = q[joint] - half, q[joint] + half
        arm = Arm(replace(arm.description, limits=limits))
        sols = arm.ik(arm.fk(q))
        assert sols.status == (Status.REDUNDANT if arm.n > 6 else Status.SOLVED)
        assert np.abs(sols.nearest(q) - q).max() < 1e-6


def test_of_a_position_alone_the_posture_that_reaches_it_is_the_nearest_to_itself():
    rng = np.random.default_rng(6)
    for name in ("universal-robots-ur5e", "franka-panda"):
        arm = pieper.load(name)
        for _ in range(2):
            q = rng.uniform(*(0.6 * arm.limits).T) if name.startswith("univ") else rng.uniform(*arm.limits.T)
            nearest = arm.ik(arm.fk(q), task="position").nearest(q)
            assert np.abs(nearest - q).max() < 1e-6


def test_every_pose_that_is_left_is_looked_at_however_many_there_are(monkeypatch):
    # the parts of the poses that are left are looked at one after the other, while what is found leaves fewer
    arm, q, T = tight("random", 0.5, 7, 60)
    looked_at = []

    def all_of_them(plan, poses, threads):
        of = [int(np.argmin(np.abs(T - pose).sum((1, 2)))) for pose in poses]
        looked_at.extend(of)
        return np.arange(len(poses)), q[of]

    monkeypatch.setattr(anywhere, "TOGETHER", 16)
    monkeypatch.setattr(anywhere, "descended", lambda chain, q, T, low, high: (q, np.full(len(q), 1.0)))
    monkeypatch.setattr(anywhere, "slices", all_of_them)
    monkeypatch.setattr(anywhere, "stops", lambda plan, T, threads: stops.stops(plan, T[:0], threads))
    found = anywhere.anywhere(arm.plan, T)
    assert sorted(looked_at) == list(range(60))
    assert (found.kind == anywhere.INSIDE).all()


@pytest.mark.parametrize("limit", [(-np.inf, 2.0), (-1.0, np.inf)])
@pytest.mark.parametrize(("name", "task"), [("panda", "pose"), ("ur5e", "position+axis")])
def test_a_stop_on_one_side_alone_bounds_self_motions_there(name, task, limit):
    """Any joint of the arm: what it is asked for lies on a self-motion, a turn farther on the open side too."""
    rng = np.random.default_rng(1)
    whole = pieper.load(name)
    for j in range(whole.n):
        arm = whole.with_limits({whole.joint_names[j]: limit})
        q = np.clip(rng.uniform(-1, 1, arm.n), arm.limits[:, 0], arm.limits[:, 1])
        found = arm.ik(arm.fk(q), task=task)
        assert found.self_motions and any(motion.inside for motion in found.self_motions)
        assert np.abs(found.nearest(q) - q).max() < 1e-6
        further = q.copy()
        further[j] += 2 * np.pi if np.isinf(limit[1]) else -2 * np.pi
        assert np.abs(found.nearest(further) - further).max() < 1e-6


#: Arm, a posture beside a singular one, and limits it stands well inside of: descents rest beside the pose.
BESIDE_SINGULAR = [
    (
        "franka-panda",
        (-0.4608921560287373, 1.465223456802749, -1.733730806768889, -0.5347895950115915)
        + (1.570719651648539, -1.9950764073996934, -0.9633450840132707),
        (-0.595895, 0.805468, -2.333427, -0.824782, 1.110009, -2.301927, -1.803495),
        1.057594,
    ),
    (
        "ufactory-xarm7",
        (0.661024578681449, 1.180337751122992, -1.520515326130227, 2.6704299489656083)
        + (-1.5707958432009688, -1.0750489708170248, 1.8851269137670172),
        (0.014319, 0.862354, -1.806641, 2.426313, -2.866925, -2.105428, 1.530449),
        1.47135,
    ),
    (
        "kinova-gen3-7dof",
        (-1.7748499459910452, 1.4851368866328294, 0.0004396488574747103, -0.00012424810295890925)
        + (0.12219199104167648, -1.0303029391933922, 0.3174595991657521),
        (-3.625829, 0.951636, -0.238781, -1.465731, -0.364448, -1.463029, -0.131953),
        2.126242,
    ),
]


@pytest.mark.parametrize("aside", [0.0, 1e-7, 1e-5])
@pytest.mark.parametrize(("name", "q", "lower", "width"), BESIDE_SINGULAR)
def test_a_posture_inside_the_limits_is_not_denied_beside_a_singular_one(name, q, lower, width, aside):
    """A damped descent rests before it arrives, or where the way that is missed bends back: OUT_OF_REACH was said."""
    arm, q = pieper.load(name), np.array(q) + aside
    arm = arm.with_limits({joint: (low, low + width) for joint, low in zip(arm.joint_names, lower, strict=True)})
    assert np.minimum(q - arm.limits[:, 0], arm.limits[:, 1] - q).min() > 0.1
    T = arm.fk(q)
    one, many = arm.ik(T), arm.ik_many(T[None], threads=1)
    assert one.status.name == "REDUNDANT" and many.status[0] == one.status
    assert np.abs(one.nearest(q) - q).max() < 1e-6
    assert len(one.q) and np.abs(arm.fk(one.q) - T).max() < 1e-9
