"""The solver's sets of solutions are those of the oracle: catalogue, random arms of every kind, scales, limits."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from oracle import exact_residual, judge, machine, search
from oracle.arms.known import KINDS, free, perturbed
from oracle.joints import random_joints, turns_apart
from pieper import DH, Arm

QUARTER = np.pi / 2


def agree(arm, T, **how):
    """Assert that arm and oracle agree at T, looking harder before a missing solution is believed."""
    sols = arm.ik(T)
    verdict = judge(arm, T, rows=sols.all_q, self_motions=sols.self_motions, starts=500, **how)
    if verdict.unseen:  # the oracle was too lazy
        verdict = judge(arm, T, rows=sols.all_q, self_motions=sols.self_motions, starts=5000, **how)
    assert not verdict.wrong, f"do not close: {verdict.wrong[:2]}"
    assert not verdict.missing, f"missing (q, hits, sigma): {verdict.missing[:2]}, {sols.status.name}: {sols.why}"
    assert not verdict.unseen, f"the oracle has not found {verdict.unseen[:2]}"
    assert len(sols.all_q) == len(verdict.found.q) or sols.self_motions
    return sols, verdict.found


def test_the_oracle_finds_both_postures_of_two_links():
    arm = Arm.from_dh([DH(0.4, 0, 0, 0), DH(0.3, 0, 0, 0)], convention="standard")
    found = search(arm, arm.fk([0.3, 0.8]), task="position", starts=50)
    assert len(found.q) == 2 and sorted(found.q[:, 1].round(12)) == [-0.8, 0.8]
    assert found.fewest >= 5


def test_the_oracle_is_right_to_50_digits_and_finds_all_sixteen():
    arm = pieper.load("motoman-ea1400n")
    T = arm.fk(np.radians([-151.45, -29.24, -151.63, -156.12, -142.47, -39.64]))
    sols, found = agree(arm, T)
    assert len(found.q) == 16 and found.fewest >= 5
    assert max(exact_residual(arm, T, q) for q in sols.all_q[:4]) < 1e-12


@pytest.mark.parametrize("q4_deg", [0.0, 45.0])
def test_the_oracle_sees_a_self_motion(q4_deg):
    arm = pieper.load("denso-vp6242")
    found = search(arm, arm.fk(np.radians([10, 20, 30, q4_deg, 0, 5])), starts=300, at_most=25)
    assert found.crowded


@pytest.mark.parametrize(
    "name",
    ["fanuc-crx-10ia", "universal-robots-ur5e", "stanford-arm", "rrp-wrist", "kinova-jaco-j2n6", "unimation-puma-560"],
)
def test_arms_of_the_catalogue(name):
    arm = pieper.load(name)
    rng = np.random.default_rng(21)
    for q in random_joints(arm, rng, 2):
        agree(arm, arm.fk(q), rng=rng)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("seed", range(3))
def test_random_arms_of_every_kind(kind, seed):
    rng = np.random.default_rng([77, seed])
    arm = KINDS[kind](rng)
    try:
        redundant = arm.plan.redundancy
    except pieper.PlanError as error:
        assert len(str(error)) > 40
        return
    if redundant:
        pytest.skip("dependent joints: judged by test_redundant_arms")
    for q in random_joints(arm, rng, 2):
        agree(arm, arm.fk(q), rng=rng)


@pytest.mark.parametrize("size", [1e-6, 1e-4, 1e-3, 1e-2])
def test_an_arm_with_calibration_errors_is_solved_as_it_is(size):
    rng = np.random.default_rng(4)
    arm = perturbed("universal-robots-ur5e", size, rng)
    for q in random_joints(arm, rng, 2):
        sols, found = agree(arm, arm.fk(q), rng=rng)
        assert found.residual.max() < 1e-12


@pytest.mark.parametrize("name", ["denso-vp6242", "motoman-ea1400n", "universal-robots-ur5e"])
@pytest.mark.parametrize("scale", [1e-6, 1e6])
def test_tiny_and_huge_arms(name, scale):
    base = pieper.load(name).description
    rows = [DH(r.a * scale, r.alpha, r.d * scale, r.theta) for r in base.rows]
    arm = Arm.from_dh(rows, convention=base.convention)
    assert arm.plan.family == free(name).plan.family
    q = random_joints(arm, np.random.default_rng(2), 1)[0]
    agree(arm, arm.fk(q))


@pytest.mark.parametrize("name", ["denso-vp6242", "motoman-ea1400n", "stanford-arm"])
def test_limits_choose_among_the_whole_set_and_windings_are_all_there(name):
    bare = free(name)
    d = bare.description
    limits = np.array([(-7.0, 2.0), (0.5, 9.0), (-4.0, 4.0), (3.3, 9.0), (-np.inf, 1.0), (-1.0, np.inf)])
    slides = np.array(list(bare.joint_types)) == "P"
    limits[slides] = (-0.5, 0.9)
    arm = Arm.from_dh(
        d.rows, convention=d.convention, joint_types=bare.joint_types, limits=limits, sign=d.sign, offset=d.offset
    )
    rng = np.random.default_rng(8)
    for q in random_joints(arm, rng, 6):
        T = arm.fk(q)
        whole, sols = bare.ik(T).all_q, arm.ik(T)
        expected = [row for row in whole if turns(row, limits, slides)]
        assert len(sols.all_q) == len(whole) and len(sols.q) == len(expected)
        assert (sols.q >= limits[:, 0]).all() and (sols.q <= limits[:, 1]).all()
        for row in sols.q:
            assert np.abs(arm.fk(row) - T).max() < 1e-9
            home = (row > -np.pi) & (row <= np.pi)
            for j in np.flatnonzero(~home & ~slides):  # outside (-pi, pi] only where that is not allowed
                principal = np.pi - (np.pi - row[j]) % (2 * np.pi)
                assert not limits[j, 0] <= principal <= limits[j, 1]
        finite = np.isfinite(limits).all(1)
        count = sum(int(np.prod([max(1, k) for k in turns(row, limits, slides, finite)])) for row in expected)
        assert len(sols.windings()) == count
        assert sols.status.name in (("SOLVED", "SINGULAR") if len(expected) else ("OUTSIDE_LIMITS",))


def turns(row, limits, slides, counted=None):
    """Return how many whole-turn variants of each joint lie inside its limits, or [] where one joint has none."""
    out = []
    for value, (lower, upper), slide in zip(row, limits, slides, strict=True):
        if slide:
            out.append(int(lower <= value <= upper))
        else:
            k = value + 2 * np.pi * np.arange(-4, 5)
            out.append(int(((k >= lower) & (k <= upper)).sum()))
    if not all(out):
        return []
    return out if counted is None else [k if c else 1 for k, c in zip(out, counted, strict=True)]


@pytest.mark.parametrize("name", ["denso-vp6242", "motoman-ea1400n", "universal-robots-ur5e"])
def test_poses_rounded_to_float32_have_the_solutions_of_the_nearest_rotation(name):
    arm = free(name)
    rng = np.random.default_rng(6)
    for q in random_joints(arm, rng, 2):
        T = arm.fk(q).astype(np.float32).astype(float)
        U, _, Vt = np.linalg.svd(T[:3, :3])
        near = T.copy()
        near[:3, :3] = U @ Vt
        sols = arm.ik(T)
        assert sols.rounded
        verdict = judge(arm, near, rows=sols.all_q, self_motions=sols.self_motions, starts=500, rng=rng)
        assert not verdict.missing and not verdict.wrong


@pytest.mark.parametrize("name", ["denso-vp6242", "fanuc-r2000ic-165f", "universal-robots-ur5e"])
@pytest.mark.parametrize("short_of", [1e-3, 1e-6, 1e-9])
def test_at_the_edge_of_reach_both_roots_are_there_inside_and_none_outside(name, short_of):
    """The elbow is bent by a little; moving the tool on along the arm leaves the reach and is said by how much."""
    arm = free(name)
    q = np.array([0.4, 0.7, straight(arm), 0.5, 0.9, 0.3])
    q[2] += np.sqrt(short_of)
    T = arm.fk(q)
    sols = arm.ik(T)
    gap = turns_apart(sols.all_q, q).max(1)
    assert gap.min() < 1e-6
    verdict = judge(arm, T, rows=sols.all_q, self_motions=sols.self_motions, starts=800)
    assert not verdict.missing and not verdict.wrong
    T[:3, 3] += 0.05 * (arm.frames(q)[4, :3, 3] - arm.frames(q)[1, :3, 3])
    assert machine(arm).n == 6 and not any(_near(arm.ik(T).all_q, q, 0.05))


def straight(arm):
    """Return the value of joint 3 that stretches the arm: where joint 5's axis point is farthest from joint 2's."""
    q = np.tile([0.4, 0.7, 0.0, 0.5, 0.9, 0.3], (4001, 1))
    q[:, 2] = np.linspace(-np.pi, np.pi, 4001)
    for _ in range(4):
        F = arm.frames(q)
        far = np.linalg.norm(F[:, 4, :3, 3] - F[:, 1, :3, 3], axis=1).argmax()
        step = q[1, 2] - q[0, 2]
        best = q[far, 2]
        q[:, 2] = np.linspace(best - step, best + step, 4001)
    return best


def _near(rows, q, tolerance):
    return [turns_apart(row, q).max() < tolerance for row in rows]
