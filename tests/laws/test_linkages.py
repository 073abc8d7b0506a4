"""Laws of axes that a linkage moves: what the joints made is found again, and nothing else."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import least_squares

import pieper
from pieper import DH, PlanError, Status

HALF = np.pi / 2
ROWS = (
    DH(a=0.3, alpha=-HALF, d=0.8),
    DH(a=1.0, theta=-HALF),
    DH(a=1.1, theta=HALF),
    DH(a=0.2, alpha=-HALF),
    DH(d=0.1),
)
#: The forearm keeps its angle to the ground, and so does the hand.
LEVEL = ((1, 0, 0, 0), (0, 1, 0, 0), (0, -1, 1, 0), (0, 0, -1, 0), (0, 0, 0, 1))
LIMITS = ((-2.8, 2.8), (-0.7, 1.5), (-0.3, 2.0), (-5.0, 5.0))


def palletizer(**said):
    return pieper.Arm.from_dh(
        ROWS, **{"convention": "standard", "coupling": LEVEL, "limits": LIMITS, "name": "palletizer"} | said
    )


def relative():
    """The same axes by numbers that are angles between links."""
    C = ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, -1, -1, 0), (0, 0, 0, 1))
    return palletizer(coupling=C, sign=(1, 1, -1, -1, -1), name="relative")


def held_wrist():
    """Six axes and five joints: a wrist axis that keeps the sum of three parallel turns."""
    plain = pieper.load("universal-robots-ur5e").description
    C = np.zeros((6, 5))
    C[[0, 1, 2, 4, 5], np.arange(5)] = 1.0
    C[3, [1, 2]] = -1.0
    return pieper.Arm.from_dh(plain.rows, convention=plain.convention, coupling=C, limits=[(-3, 3)] * 5, name="held")


def driven_slide():
    """A SCARA whose hand is turned back by what the first two joints turn: three joints move four axes."""
    rows = (DH(a=0.4, d=0.3), DH(a=0.3), DH(alpha=np.pi), DH())
    C = ((1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0))
    return pieper.Arm.from_dh(
        rows, convention="standard", joint_types="RRPR", coupling=C, limits=((-2.5, 2.5), (-2, 2), (-0.2, 0)), name="s"
    )


ARMS = {"palletizer": palletizer, "relative": relative, "held wrist": held_wrist, "scara": driven_slide}


def postures(arm, count, seed=0):
    return np.random.default_rng(seed).uniform(*arm.limits.T, (count, arm.n))


@pytest.mark.parametrize("name", ARMS)
def test_the_joints_that_made_a_pose_are_found_again_and_every_row_closes(name):
    arm = ARMS[name]()
    for q in postures(arm, 12):
        T = arm.fk(q)
        sols = arm.ik(T)
        assert sols.status in (Status.SOLVED, Status.SINGULAR)
        assert np.abs(sols.nearest(q) - q).max() < 1e-7
        assert np.abs(arm.fk(sols.all_q) - T).max() < 1e-9
        # the linkage holds every row: the axes alone, put where it says, take the pose
        values = sols.all_q @ arm.coupling.T
        assert np.abs(arm.uncoupled().fk(values) - T).max() < 1e-9


@pytest.mark.parametrize("name", ["kuka-kr120-r3200-pa", "dobot-mg400", "dobot-magician"])
def test_round_postures_of_the_catalogue_are_found_again_stretched_and_with_the_hand_over_the_base_too(name):
    arm = pieper.load(name)
    lower, upper = np.degrees(arm.limits).T
    rng = np.random.default_rng(5)
    q = np.radians(np.clip(np.round(rng.uniform(lower, upper, (120, 4)) / 15) * 15, lower, upper))
    q[::4, 2] = q[::4, 1] - np.pi / 2 if name != "kuka-kr120-r3200-pa" else 0.0  # stretched: two postures are one
    q = q[((q >= arm.limits[:, 0]) & (q <= arm.limits[:, 1])).all(1)]
    Ts = arm.fk(q)
    many = arm.ik_many(Ts, near=q)
    for i, T in enumerate(Ts):
        sols = arm.ik(T)
        assert np.abs(sols.nearest(q[i]) - q[i]).max() < 1e-6
        assert many.status[i] == sols.status
        assert sols.self_motions or np.abs(many.nearest[i] - q[i]).max() < 1e-6


@pytest.mark.parametrize("name", ["dobot-mg400", "dobot-magician"])
def test_stretched_postures_outside_the_limits_are_as_many_of_many_poses_as_of_one(name):
    arm = pieper.load(name)
    lower, upper = np.degrees(arm.limits).T
    q = np.random.default_rng(5).uniform(lower, upper, (80, 4))
    q = np.radians(np.clip(np.round(q / 15) * 15, lower, upper))[40:70]
    q[::2, 2] = q[::2, 1] - np.pi / 2
    Ts, narrow = arm.fk(q), arm.with_limits({arm.joint_names[1]: (5.0, 5.05)})
    many = narrow.ik_many(Ts)
    for i, T in enumerate(Ts):
        one = narrow.ik(T)
        assert many.status[i] == one.status and many.valid[i].sum() == len(one.all_q)


@pytest.mark.parametrize("name", ["palletizer", "relative", "scara"])
def test_no_more_and_no_fewer_than_a_search_of_the_forward_kinematics_finds(name):
    arm = ARMS[name]()
    rng = np.random.default_rng(3)
    for q in postures(arm, 3, seed=4):
        T = arm.fk(q)
        found = []
        for start in rng.uniform(-np.pi, np.pi, (60, arm.n)):
            hit = least_squares(lambda x, T=T: (arm.fk(x) - T)[:3].ravel(), start, xtol=1e-15, ftol=1e-15, gtol=1e-15)
            if hit.cost < 1e-20:
                found.append(hit.x)
        space = arm.chain.joints
        distinct = np.array(found)[space.distinct(np.array(found), 1e-5)]
        mine = arm.ik(T).all_q
        assert len(distinct) == len(mine)
        assert all(space.apart(row, mine).min() < 1e-6 for row in distinct)


@pytest.mark.parametrize("name", ARMS)
def test_many_poses_come_out_as_one_by_one(name):
    arm = ARMS[name]()
    q = postures(arm, 6, seed=1)
    Ts = np.concatenate([arm.fk(q), arm.fk(q[:2]) @ pieper.pose(0, 0, 0, rpy=(0.2, 0.1, 0))])
    many = arm.ik_many(Ts, near=q[0])
    for i, T in enumerate(Ts):
        one = arm.ik(T)
        assert many.status[i] == one.status
        assert many.valid[i].sum() == len(one.all_q)
        assert np.allclose(many.q[i][many.in_limits[i]], one.q, atol=1e-8)
        assert bool(many.has_nearest[i]) == bool(len(one))


@pytest.mark.parametrize("name", ARMS)
def test_the_jacobian_is_the_derivative_by_the_joints_numbers(name):
    arm = ARMS[name]()
    q, h = postures(arm, 1)[0], 1e-6
    J = arm.jacobian(q)
    assert J.shape == (6, arm.n) and arm.frames(q).shape == (arm.chain.axis_count + 2, 4, 4)
    for i in range(arm.n):
        step = h * np.eye(arm.n)[i]
        change = (arm.fk(q + step)[:3, 3] - arm.fk(q - step)[:3, 3]) / (2 * h)
        assert np.abs(J[:3, i] - change).max() < 1e-8


def test_a_pose_that_the_linkage_does_not_hold_is_out_of_reach_and_the_reason_is_told():
    arm = palletizer()
    values = arm.coupling @ [0.3, 0.2, 0.4, 0.1] + [0, 0, 0, 0.1, 0]
    sols = arm.ik(arm.uncoupled().fk(values))
    assert sols.status == Status.OUT_OF_REACH
    assert "at best 5.73 deg are missing. Its linkage turns axis_4" in sols.why
    assert sols.closest.metres < 1e-9 and abs(sols.closest.radians - 0.1) < 1e-9
    # the axes by themselves take it
    assert len(arm.uncoupled().ik(sols.T).all_q)


def test_a_wrist_above_the_first_axis_leaves_a_self_motion_that_holds_the_posture():
    arm = palletizer()
    # the hand's axis on the first one: 0.3 + sin q2 + 1.1 cos q3' + 0.2 = 0, all of it in the arm's plane
    q3 = np.arccos((0.5 - np.sin(0.6)) / 1.1)
    q = np.array([0.4, -0.6, q3 - np.pi, 0.3])
    q = next(v for v in (q, q * [1, 1, -1, 1]) if np.hypot(*arm.fk(v)[:2, 3]) < 1e-9)
    sols = arm.with_limits(dict.fromkeys(arm.joint_names, (-4.0, 4.0))).ik(arm.fk(q))
    assert sols.status == Status.SINGULAR
    assert any(motion.contains(q) for motion in sols.self_motions)
    for motion in sols.self_motions:
        assert max(np.abs(arm.fk(motion.at(u)) - sols.T).max() for u in np.linspace(0, 1, 5)) < 1e-9


def test_a_straight_elbow_is_found_as_a_double_root():
    arm = relative().with_limits(dict.fromkeys(palletizer().joint_names, (-4.0, 4.0)))
    q = np.array([0.3, 0.4, HALF, 0.2])
    if np.linalg.cond(arm.jacobian(q)) < 1e6:
        q[2] = -HALF
    sols = arm.ik(arm.fk(q))
    assert sols.status == Status.SOLVED and np.abs(sols.nearest(q) - q).max() < 1e-6


@pytest.mark.parametrize("name", ARMS)
def test_files_keep_the_linkage(name, tmp_path):
    arm = ARMS[name]()
    q = postures(arm, 5)
    for file in ("a.toml", "a.urdf"):
        arm.save(tmp_path / file)
        back = pieper.load(tmp_path / file)
        assert back.joint_names == arm.joint_names and np.array_equal(back.coupling, arm.coupling)
        assert np.abs(back.fk(q) - arm.fk(q)).max() < 1e-12
        assert np.allclose(back.limits, arm.limits, atol=1e-15)
    text = (tmp_path / "a.toml").read_text()
    arm.save(tmp_path / "a.toml")
    assert (tmp_path / "a.toml").read_text() == text


@pytest.mark.parametrize("name", ARMS)
def test_changed_arms_are_the_same_in_space(name):
    arm = ARMS[name]()
    q = postures(arm, 4)
    T = arm.fk(q)
    assert np.abs(arm.to("modified").fk(q) - T).max() < 1e-12
    assert np.abs(arm.reversed().fk(q[:, ::-1]) @ T - np.eye(4)).max() < 1e-12
    last = arm.joint_names[-1]
    value = float(np.clip(0.25, *arm.limits[-1]))
    held = arm.with_joints_locked({last: value})
    assert np.abs(held.fk(q[:, :-1]) - arm.fk(np.column_stack([q[:, :-1], np.full(4, value)]))).max() < 1e-12
    assert arm.with_limits({last: (0, 1)}).description.linked == arm.description.linked
    assert arm.uncoupled().n == arm.chain.axis_count


def test_a_line_is_followed_and_what_the_linkage_does_not_hold_stops_it():
    arm = palletizer()
    q = np.array([0.3, 0.2, 0.4, 0.1])
    T = arm.fk(q)
    track = arm.follow(pieper.line(T, T @ pieper.pose(0.1, 0.1, 0.1), n=12), start=q)
    assert track.complete and np.abs(track.followed[0] - q).max() < 1e-9
    tilted = arm.follow(pieper.line(T, T @ pieper.pose(0.1, 0, 0, rpy=(0.2, 0, 0)), n=12), start=q)
    assert not tilted.complete


def test_what_is_not_done_for_linkages_is_refused_by_name():
    arm = palletizer()
    T = arm.fk([0.3, 0.2, 0.4, 0.1])
    for ask in (
        lambda: arm.symbolic.ik(),
        lambda: arm.symbolic.singularities(),
        lambda: arm.route(T[None].repeat(2, 0), free=pieper.Freedom(turn="free")),
        lambda: arm.calibrate(np.zeros((9, 4)), T[None].repeat(9, 0)),
        lambda: arm.choose_poses(2, np.zeros((9, 4))),
        lambda: arm.ik(T, task="position"),
    ):
        with pytest.raises(PlanError, match=r"axis_4"):
            ask()
    assert arm.symbolic.fk().check(20).worst < 1e-12
    assert arm.symbolic.jacobian().check(20).worst < 1e-12


def test_a_linkage_by_parts_of_turns_has_forward_kinematics_and_no_inverse():
    C = np.array(LEVEL, float)
    C[3, 2] = -0.5
    arm = palletizer(coupling=C)
    assert arm.fk(np.zeros(4)).shape == (4, 4)
    with pytest.raises(PlanError, match="by parts of turns"):
        arm.ik(np.eye(4))


def test_clearance_counts_by_the_joints_numbers():
    arm = palletizer()
    scene = pieper.Scene([pieper.Box(pieper.pose(1.6, 0.2, 0.6), (0.2, 0.2, 0.2))])
    q, h = np.array([0.1, 0.5, 0.6, 0.2]), 1e-6
    found = arm.distance(q, scene)
    ends = [[float(arm.distance(q + side * h * e, scene)) for side in (1, -1)] for e in np.eye(4)]
    slope = [(a - b) / (2 * h) for a, b in ends]
    assert np.abs(found.gradient - slope).max() < 1e-5


def test_plans_and_arms_pickle():
    import pickle

    arm = pickle.loads(pickle.dumps(palletizer()))
    plan = pickle.loads(pickle.dumps(arm.plan))
    assert plan.names == arm.joint_names and replace(arm.description, name="b").linked
