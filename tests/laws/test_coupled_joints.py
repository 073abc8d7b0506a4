"""A law of coupled joints: whatever the ratios are, a joint vector that made a pose is found again."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import pieper
from pieper import Status

pytestmark = pytest.mark.slow

ARMS = (
    "fanuc-lr-mate-200id",
    "abb-irb2400",
    "universal-robots-ur5e",
    "adept-cobra-600",
    "stanford-arm",
    "fanuc-crx-10ia",
    "three-r",
    "rrp-wrist",
)


def random_coupling(rng, n):
    """Return ratios that are none of whole numbers, gears on the diagonal now and then, slides among them too."""
    C = np.eye(n)
    if rng.random() < 0.5:
        C[np.diag_indices(n)] = rng.choice([1, -1, 0.5, 2, 1.5], n)
    for _ in range(2):
        i, j = rng.choice(n, 2, replace=False)
        C[i, j] = np.round(rng.uniform(-1.5, 1.5), 2)
    return C if np.linalg.cond(C) < 50 else np.eye(n) + 0.3 * np.eye(n, k=-1)


def coupled(name, seed):
    rng = np.random.default_rng(seed)
    plain = pieper.load(name)
    C = random_coupling(rng, plain.n)
    arm = pieper.Arm(replace(plain.description, coupling=C))
    lower, upper = np.clip(arm.limits, -3, 3).T
    return arm, plain, C, rng.uniform(lower, upper, (12, arm.n))


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("name", ARMS)
def test_the_joints_that_made_a_pose_are_found_again_and_every_row_closes(name, seed):
    arm, _, _, joints = coupled(name, seed)
    for q in joints:
        T = arm.fk(q)
        sols = arm.ik(T)
        assert np.abs(sols.nearest(q) - q).max() < 1e-7
        assert sols.residual.max() < 1e-9
        rows = sols.windings()
        assert arm.plan.residual(rows, T).max() < 1e-8
        assert (rows >= arm.limits[:, 0] - 1e-8).all() and (rows <= arm.limits[:, 1] + 1e-8).all()
        assert np.abs(rows - q).max(1).min() < 1e-7 or not np.isfinite(arm.limits).all()


@pytest.mark.parametrize("name", ARMS)
def test_the_windings_are_all_there_are_by_counting_turns_of_the_axes(name):
    arm, plain, C, joints = coupled(name, 5)
    arm = arm.with_limits(dict.fromkeys(arm.joint_names, (-2.5, 2.5)))
    free = plain.with_limits(dict.fromkeys(plain.joint_names))
    turning = np.flatnonzero(~plain.chain.prismatic)
    grid = np.stack(np.meshgrid(*[np.arange(-3, 4)] * len(turning), indexing="ij"), -1).reshape(-1, len(turning))
    turns = np.zeros((len(grid), arm.n))
    turns[:, turning] = 2 * np.pi * grid
    for q in joints[:2]:
        T = arm.fk(q)
        wanted = 0
        for values in free.ik(T).all_q:
            found = np.linalg.solve(C, (values + turns).T).T
            wanted += int((np.abs(found) <= 2.5 + 1e-9).all(1).sum())
        assert len(arm.ik(T).windings()) == wanted


@pytest.mark.parametrize("name", ARMS)
def test_many_poses_come_out_as_one_by_one_and_the_nearest_row_is_the_nearest(name):
    arm, _, _, joints = coupled(name, 7)
    Ts = arm.fk(joints)
    many, turn = arm.ik_many(Ts, near=joints[0]), arm.ik_many(Ts, near="previous", start=joints[0])
    now = joints[0]
    for i, T in enumerate(Ts):
        one = arm.ik(T)
        assert many.status[i] == one.status
        assert np.allclose(many.q[i][many.in_limits[i]], one.q, atol=1e-8)
        if not one.self_motions:
            assert np.abs(many.nearest[i] - one.nearest(joints[0])).max() < 1e-7
            assert np.abs(turn.nearest[i] - one.nearest(now)).max() < 1e-7
        now = turn.nearest[i]


def test_without_a_start_the_first_pose_takes_its_first_row_and_the_others_the_nearest_to_the_one_before():
    arm, _, _, joints = coupled("motoman-gp8", 7)
    Ts = arm.fk(joints)
    many, turn = arm.ik_many(Ts), arm.ik_many(Ts, near="previous")
    first = int(np.flatnonzero(many.in_limits.any(1))[0])
    assert np.array_equal(turn.nearest[first], many.q[first][many.in_limits[first]][0])
    for i in range(first + 1, len(Ts)):
        if many.in_limits[i].any() and many.in_limits[i - 1].any():
            assert np.abs(turn.nearest[i] - arm.ik(Ts[i]).nearest(turn.nearest[i - 1])).max() < 1e-7


def test_a_self_motion_of_coupled_joints_holds_the_pose_and_its_joints():
    plain = pieper.load("motoman-gp8")
    C = np.eye(6)
    C[4, 3], C[5, 4] = 0.37, -0.61
    arm = pieper.Arm(replace(plain.description, coupling=C))
    q = np.linalg.solve(C, [0.2, 0.1, 0.3, 0.4, 0.0, 0.5])
    sols = arm.ik(arm.fk(q))
    assert sols.status == Status.SINGULAR and any(motion.contains(q) for motion in sols.self_motions)
    for motion in sols.self_motions:
        for u in np.linspace(0, 1, 7):
            assert np.abs(arm.fk(motion.at(u)) - sols.T).max() < 1e-9


def test_a_pose_outside_the_limits_says_by_how_much_the_least_variant_is_outside():
    plain = pieper.load("fanuc-lr-mate-200id")
    C = np.eye(6)
    C[2, 1] = 0.7
    arm = pieper.Arm(replace(plain.description, coupling=C))
    q = np.array([0.1, 0.6, 0.5, 0.3, 0.7, 0.2])
    held = arm.with_limits({arm.joint_names[2]: (0.75, 0.8)})
    sols = held.ik(arm.fk(q))
    assert sols.status == Status.OUTSIDE_LIMITS
    name, by = arm.joint_names[2], np.degrees(0.25)
    assert f"{name} by {by:.4g} deg" in sols.why


def test_a_line_is_followed_through_ratios_that_are_no_whole_numbers():
    plain = pieper.load("abb-irb2400")
    C = np.eye(6)
    C[2, 1], C[4, 3] = -0.4, 0.25
    arm = pieper.Arm(replace(plain.description, coupling=C))
    q = np.array([0.1, 0.2, 0.1, 0.3, 0.5, 0.2])
    path = pieper.line(arm.fk(q), arm.fk(q) @ pieper.pose(0.02, 0.01, 0.03), n=12)
    track = arm.follow(path, start=q)
    assert track.complete and np.abs(arm.fk(track.followed) - path).max() < 1e-9
    assert np.abs(track.followed[0] - q).max() < 1e-9
