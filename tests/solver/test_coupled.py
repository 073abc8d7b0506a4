"""The inverse of coupled joints: in the joints' own numbers, inside the joints' own limits."""

from __future__ import annotations

import itertools
import pickle
import re
from dataclasses import replace

import numpy as np
import pytest

import pieper
from pieper import PlanError, Status
from pieper.kinematics.pose import rotation_z
from pieper.solver.plan.six_joints import appended

ARMS = {
    "fanuc-lr-mate-200id": [(2, 1, 1)],
    "abb-irb2400": [(2, 1, -1)],
    "universal-robots-ur5e": [(2, 1, 1), (3, 1, -1), (3, 2, 1)],
    "adept-cobra-600": [(1, 0, -1)],
    "motoman-gp8": [(2, 1, -1), (4, 3, 2), (5, 4, -1)],
}


def coupled(name):
    plain = pieper.load(name)
    C = np.eye(plain.n)
    for i, j, value in ARMS[name]:
        C[i, j] = value
    return pieper.Arm(replace(plain.description, coupling=C)), plain, C


def joints(arm, count=60):
    lower, upper = np.clip(arm.limits, -3, 3).T
    return np.random.default_rng(7).uniform(lower, upper, (count, arm.n))


@pytest.mark.parametrize("name", ARMS)
def test_the_joints_that_made_a_pose_are_found_and_every_row_closes_inside_the_limits(name):
    arm, plain, C = coupled(name)
    for q in joints(arm):
        T = arm.fk(q)
        assert np.allclose(T, plain.fk(C @ q), atol=1e-13)
        sols = arm.ik(T)
        assert np.abs(sols.nearest(q) - q).max() < 1e-7
        assert sols.residual.max() < 1e-9
        for rows in (sols.q, sols.windings()):
            assert (rows >= arm.limits[:, 0] - 1e-9).all() and (rows <= arm.limits[:, 1] + 1e-9).all()
            assert np.abs(arm.fk(rows) - T).max() < 1e-9


@pytest.mark.parametrize("name", ARMS)
def test_there_are_as_many_solutions_as_of_the_chain_and_their_labels_are_its_own(name):
    arm, plain, C = coupled(name)
    free = plain.with_limits(dict.fromkeys(plain.joint_names))
    for q in joints(arm, 20):
        sols, of_chain = arm.ik(arm.fk(q)), free.ik(arm.fk(q))
        gap = sols.all_q @ C.T - of_chain.all_q
        turns = np.where(plain.chain.prismatic, 0.0, 2 * np.pi * np.round(gap / (2 * np.pi)))
        assert np.abs(gap - turns).max() < 1e-9
        assert sols.all_labels == of_chain.all_labels


@pytest.mark.parametrize("name", ARMS)
def test_many_poses_come_out_as_one_by_one(name):
    arm, _, _ = coupled(name)
    Ts = np.concatenate([arm.fk(joints(arm, 20)), arm.fk(np.zeros((1, arm.n))), pieper.pose(30)[None]])
    many = arm.ik_many(Ts)
    for i, T in enumerate(Ts):
        one = arm.ik(T)
        assert many.status[i] == one.status
        assert np.allclose(many.q[i][many.in_limits[i]], one.q, atol=1e-9)


def test_limits_are_those_of_the_joints_not_of_the_chain():
    arm, _, _ = coupled("fanuc-lr-mate-200id")
    q = np.array([0.1, 0.6, 0.5, 0.3, 0.7, 0.2])
    held = arm.with_limits({arm.joint_names[2]: (0.4, 0.6)})
    sols = held.ik(arm.fk(q))
    assert sols.status == Status.SOLVED and np.abs(sols.q - q).max(1).min() < 1e-9
    assert ((sols.q[:, 2] > 0.4) & (sols.q[:, 2] < 0.6)).all()
    none = arm.with_limits({arm.joint_names[2]: (1.05, 1.15)}).ik(arm.fk(q))
    assert none.status == Status.OUTSIDE_LIMITS and arm.joint_names[2] in none.why


def test_self_motions_are_curves_of_the_joints():
    arm, _, _ = coupled("motoman-gp8")
    sols = arm.ik(arm.fk(np.zeros(6)))
    assert sols.status == Status.SINGULAR
    for motion in sols.self_motions:
        for u in np.linspace(0, 1, 9):
            assert np.abs(arm.fk(motion.at(u)) - sols.T).max() < 1e-9
        for lower, upper in motion.inside:
            assert motion.nearest(motion.at((lower + upper) / 2)) is not None
        assert motion.contains(motion.at(0.4))


def test_the_nearest_posture_of_a_self_motion_is_placed_to_rounding():
    """From it no small step along the curve comes nearer: what is left of the way to it is square to the curve."""
    half = np.pi / 2
    rows = [pieper.DH(0.3, -half, 0.8), pieper.DH(1.0, theta=-half), pieper.DH(1.1, theta=half)]
    rows += [pieper.DH(0.2, -half), pieper.DH(d=0.1)]
    level = ((1, 0, 0, 0), (0, 1, 0, 0), (0, -1, 1, 0), (0, 0, -1, 0), (0, 0, 0, 1))
    palletizer = pieper.Arm.from_dh(rows, convention="standard", coupling=level, limits=[(-4.0, 4.0)] * 4)
    # the hand's axis on the first one
    q = np.array([0.4, -0.6, np.pi - np.arccos((0.5 - np.sin(0.6)) / 1.1), 0.3])
    q = next(v for v in (q, q * [1, 1, -1, 1]) if np.hypot(*palletizer.fk(v)[:2, 3]) < 1e-9)
    motions = palletizer.ik(palletizer.fk(q)).self_motions
    assert motions
    rng = np.random.default_rng(4)
    for motion, now in itertools.product(motions, q + rng.uniform(-0.6, 0.6, (4, 4))):
        nearest = motion.nearest(now)
        _, values, directions = np.linalg.svd(palletizer.jacobian(nearest))
        assert values[-1] < 1e-9 < 1e-3 < values[-2]
        assert abs(directions[-1] @ (nearest - now)) < 1e-7


def test_a_line_is_followed_in_the_joints_numbers():
    arm, _, _ = coupled("abb-irb2400")
    q = np.array([0.1, 0.2, 0.1, 0.3, 0.5, 0.2])
    path = pieper.line(arm.fk(q), arm.fk(q) @ pieper.pose(0.02, 0.01, 0.03), n=12)
    track = arm.follow(path, start=q)
    assert track.complete and np.abs(arm.fk(track.followed) - path).max() < 1e-9
    assert np.abs(track.followed[0] - q).max() < 1e-9


def test_a_slide_that_moves_with_a_turn_is_solved():
    """A screw: the quill's stroke follows the last turn by its pitch, so every turn is another stroke."""
    plain = pieper.load("adept-cobra-600")
    C, pitch = np.eye(4), 0.02 / (2 * np.pi)
    C[2, 3] = pitch
    arm = pieper.Arm(replace(plain.description, coupling=C)).with_limits({plain.joint_names[3]: (-7.0, 7.0)})
    q = np.array([0.3, 0.8, 0.1, 1.0])
    sols = arm.ik(arm.fk(q))
    assert np.abs(sols.nearest(q) - q).max() < 1e-9
    turns = sols.windings()
    assert np.abs(arm.fk(turns) - sols.T).max() < 1e-12 and len(turns) > len(sols)
    turned = q + [0, 0, 0.02, -2 * np.pi]
    assert np.abs(turns - turned).max(1).min() < 1e-9


def test_a_joint_to_spare_beside_coupled_ones_is_refused_by_name():
    plain = pieper.load("franka-panda")
    C = np.eye(7)
    C[3, 1] = 1
    with pytest.raises(PlanError, match="to spare.*with_joints_locked"):
        _ = pieper.Arm(replace(plain.description, coupling=C)).plan


def test_a_plan_of_coupled_joints_pickles():
    arm, _, _ = coupled("fanuc-lr-mate-200id")
    T = arm.fk([0.1, 0.6, 0.5, 0.3, 0.7, 0.2])
    from pieper.solver import verbs

    assert np.allclose(verbs.ik(pickle.loads(pickle.dumps(arm.plan)), T).q, arm.ik(T).q)
    assert "coupl" in repr(arm.plan) or arm.plan.explain()


def test_the_uncoupled_arm_is_the_same_by_its_axes_and_is_the_cure_where_coupling_is_refused():
    arm = pieper.load("fanuc-lr-mate-200id-controller")
    plain = arm.uncoupled()
    q = np.array([0.1, 0.3, 0.2, 0.4, 0.5, 0.6])
    assert np.array_equal(plain.coupling, np.eye(6)) and plain.uncoupled().description is plain.description
    assert np.abs(plain.fk(arm.coupling @ q) - arm.fk(q)).max() < 1e-15
    assert np.isinf(plain.limits[2]).all() and np.array_equal(plain.limits[[0, 1, 3]], arm.limits[[0, 1, 3]])
    path = pieper.line(arm.fk(q), arm.fk(q) @ pieper.pose(0.01), n=3)
    own = arm.route(path)
    assert own.verdict is pieper.Verdict.FOUND and np.abs(arm.fk(own.q)[:, :3, 3] - path[:, :3, 3]).max() < 1e-6
    assert (own.q >= arm.limits[:, 0] - 1e-9).all() and (own.q <= arm.limits[:, 1] + 1e-9).all()
    parts = np.array(arm.coupling)
    parts[4, 3] = 0.37
    with pytest.raises(PlanError, match=r"arm\.follow(.|\n)*arm\.uncoupled"):
        pieper.Arm(replace(arm.description, coupling=parts)).route(path)
    route = plain.route(path)
    joints = np.linalg.solve(arm.coupling, route.q.T).T
    assert np.abs(arm.fk(joints)[:, :3, 3] - path[:, :3, 3]).max() < 1e-6


@pytest.mark.parametrize("name", ["fanuc-lr-mate-200id", "universal-robots-ur5e"])
@pytest.mark.parametrize("part", [1.0, 0.5])
def test_how_far_the_least_offending_solution_is_outside_is_the_least_over_whole_turns_of_the_axes(name, part):
    arm, plain, C = coupled(name)
    C = np.where(np.eye(len(C), dtype=bool), C, part * C)
    arm = pieper.Arm(replace(plain.description, coupling=C))
    narrow = arm.with_limits(dict.fromkeys(arm.joint_names, (2.9, 3.1)))
    turns = np.array(list(itertools.product((-2, -1, 0, 1, 2), repeat=3)))
    every = np.zeros((len(turns), arm.n))
    every[:, 1:4] = turns
    for q in joints(arm, 12):
        sols = narrow.ik(arm.fk(q))
        assert sols.status is Status.OUTSIDE_LIMITS
        over = np.inf
        for row in sols.all_q:
            variants = row + 2 * np.pi * every @ np.linalg.inv(C).T
            # an axis that turns alone is free of the others
            alone = [j for j in range(arm.n) if j not in (1, 2, 3)]
            far = np.maximum(2.9 - variants, variants - 3.1)
            for j in alone:
                shifted = row[j] + 2 * np.pi * np.arange(-2, 3)
                far[:, j] = np.maximum(2.9 - shifted, shifted - 3.1).min()
            over = min(over, far.max(1).min())
        said = float(sols.why.split(" by ")[1].split()[0])
        assert said == pytest.approx(np.degrees(over), rel=2e-3), sols.why


@pytest.mark.parametrize("name", ARMS)
def test_virtual_joints_are_added_to_coupled_ones(name):
    arm, _, C = coupled(name)
    chain = appended(arm.chain, [(np.eye(3), False), (np.eye(3), True)])
    assert chain.n == arm.n + 2
    assert chain.prismatic.tolist() == [*arm.chain.prismatic.tolist(), False, True]
    q = joints(arm, 5)
    wanted = arm.chain.native.fk(q) @ rotation_z(np.full(5, 0.3)) @ pieper.pose(0, 0, 0.2)
    assert np.abs(chain.native.fk(np.hstack([q, np.full((5, 1), 0.3), np.full((5, 1), 0.2)])) - wanted).max() < 1e-14


def test_what_breaks_a_limit_is_the_slide_that_is_far_outside_and_not_the_screw_that_could_be_wound():
    rows = [pieper.DH(a=0.3, d=0.4), pieper.DH(a=0.25, alpha=np.pi), pieper.DH(), pieper.DH(d=0.05)]
    screw = np.eye(4)
    screw[2, 3] = 0.003
    limits = [(-2.5, 2.5), (-2.5, 2.5), (0, 0.2), (-13, 13)]
    arm = pieper.Arm.from_dh(rows, joint_types="RRPR", convention="standard", limits=limits, coupling=screw)
    for z in (10, 50, 300, 700, 3e5):
        sols = arm.ik(pieper.pose(0.3, 0.1, z, rpy=(np.pi, 0, 0)))
        least = min(min(abs(q[2] + screw[2, 3] * 2 * np.pi * k) for k in range(-2, 3)) for q in sols.all_q)
        said = re.search(r"exceeds joint_3 by ([\d.e+]+) m[.m]", sols.why)
        assert said, sols.why
        metres = float(said[1]) / (1000 if f"{said[1]} mm" in sols.why else 1)
        assert abs(metres - least) < 0.02 + 1e-3 * least, (z, sols.why, least)


@pytest.mark.parametrize("far", [1e13, 1e160])
def test_no_arm_takes_a_place_that_no_metres_can_mean(far):
    for name in ("stanford-arm", "denso-vp6242", "epson-g6-651s"):
        arm = pieper.load(name)
        T = arm.fk(np.full(arm.n, 0.1))
        T[2, 3] = far
        for asked in (arm.ik, lambda T, arm=arm: arm.ik_many(T[None])):
            with pytest.raises(pieper.InputError, match="metres are meant"):
                asked(T)
