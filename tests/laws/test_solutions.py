"""Laws of completeness and truth: every solution closes, the joint vector that made the pose is found again."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from oracle.arms.kinds import (
    KINDS,
    general,
    general_mixed,
    offset_wrist,
    spherical_wrist,
    spherical_wrist_parallel,
    three_parallel,
)
from oracle.joints import around, random_joints
from tests.laws.of_kinds import of_kinds

TURN = 2 * np.pi


def joint_gap(arm, a, b):
    """Return largest joint differences (...), angles around the circle, prismatic joints per length of the arm."""
    prismatic = arm.chain.prismatic
    gap = np.where(prismatic, (a - b) / arm.chain.length, around(a - b))
    return np.abs(gap).max(-1)


def missed(arm, q, batch, tolerance):
    """Return indices of the joint vectors q (N, n) that are not among the solutions of their poses."""
    hit = ((joint_gap(arm, batch.q, q[:, None]) < tolerance[:, None]) & batch.valid).any(1)
    left = np.flatnonzero(~hit)
    # a pose with a self-motion counts as found where the joint vector lies on it
    return [i for i in left if not any(f.contains(q[i], 1e-5) for f in arm.ik(arm.fk(q[i])).self_motions)]


def blurred(arm, q, floor=1e-7):
    """Return how well each joint vector can be known from its pose.

    Next to a double root two branches blur into one over the square root of rounding; next to a self-motion the error
    is rounding over the smallest singular value.
    """
    from pieper.kinematics.newton import scaled_jacobian

    s = np.linalg.svd(scaled_jacobian(arm.chain, q), compute_uv=False)
    size = 1.0 + np.abs(arm.fk(q)[..., :3, 3]).max() / arm.chain.length
    smallest = np.maximum(s[:, -1], 1e-300)
    return np.maximum(floor, np.maximum(np.minimum(1e-13 * size / smallest, 3e-6 * size), 2e-15 * size / smallest))


@of_kinds(KINDS, examples=12)
def test_every_solution_closes_and_the_joint_vector_that_made_the_pose_is_found_again(arm, rng):
    q = random_joints(arm, rng, 60)
    T = arm.fk(q)
    batch = arm.ik_many(T, threads=1)
    assert not missed(arm, q, batch, blurred(arm, q))
    rows, poses = batch.q[batch.valid], np.repeat(T, batch.count, axis=0)
    error = arm.plan.residual(rows, poses)
    size = arm.chain.length + np.linalg.norm(poses[:, :3, 3], axis=-1)
    assert (error[:, 0] / size).max() < 1e-9 and error[:, 1].max() < 1e-9
    assert batch.count.max() <= arm.plan.max_solutions


@of_kinds(KINDS, examples=8)
def test_solutions_come_in_pairs_away_from_singularities(arm, rng):
    if arm.chain.prismatic.any():
        return  # a sliding joint may send one root of a pair to infinity
    batch = arm.ik_many(arm.fk(random_joints(arm, rng, 200)), threads=1)
    clear = (batch.flag & 3) == 0
    assert not np.any(batch.count[clear] % 2)


@pytest.mark.parametrize("kind", [spherical_wrist_parallel, spherical_wrist, three_parallel, offset_wrist, general])
@pytest.mark.parametrize("joint", [1, 2, 4])
def test_nothing_is_lost_near_a_singularity(kind, joint):
    """Joint vectors are pulled towards a singularity until the pose is 1e-10 to 1e-2 rad away from it."""
    rng = np.random.default_rng(joint)
    misses = total = 0
    for _ in range(3):
        arm = kind(rng)
        q = near_singular(arm, rng, joint, 30)
        T = arm.fk(q)
        misses += len(missed(arm, q, arm.ik_many(T, threads=1), blurred(arm, q)))
        total += len(q)
    assert total >= 50
    assert misses == 0, f"{misses} of {total}"


def near_singular(arm, rng, joint, count):
    """Return joint vectors whose determinant changes sign 1e-10 to 1e-2 away along one joint."""
    from pieper.kinematics.newton import determinant

    out = []
    for start in random_joints(arm, rng, 4 * count):
        line = np.tile(start, (400, 1))
        span = arm.chain.length if arm.chain.prismatic[joint] else np.pi
        line[:, joint] += np.linspace(-span, span, 400)
        det = determinant(arm.chain, line)
        turns = np.flatnonzero(det[:-1] * det[1:] < 0)
        if not len(turns):
            continue
        lower, upper = line[turns[0]].copy(), line[turns[0] + 1].copy()
        sign = np.sign(det[turns[0]])
        for _ in range(60):
            middle = (lower + upper) / 2
            if np.sign(determinant(arm.chain, middle)) == sign:
                lower = middle
            else:
                upper = middle
        point = lower.copy()
        point[joint] += rng.choice([-1, 1]) * 10 ** rng.uniform(-10, -2) * (span / np.pi)
        out.append(point)
        if len(out) == count:
            break
    return np.array(out).reshape(-1, arm.n)


@pytest.mark.parametrize("name", pieper.catalog())
def test_every_arm_of_the_catalogue_finds_its_own_postures_again(name):
    arm = pieper.load(name)
    if arm.plan.redundancy:
        pytest.skip("redundant arms have a law of their own")
    rng = np.random.default_rng(11)
    q = random_joints(arm, rng, 150)
    batch = arm.ik_many(arm.fk(q), threads=1)
    assert not missed(arm, q, batch, blurred(arm, q))


def test_mixed_joints_lose_nothing():
    for seed in range(6):
        rng = np.random.default_rng(seed)
        arm = general_mixed(rng)
        q = random_joints(arm, rng, 100)
        assert not missed(arm, q, arm.ik_many(arm.fk(q), threads=1), blurred(arm, q)), arm.name
