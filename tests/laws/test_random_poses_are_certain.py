"""A random pose is solved for certain: UNCERTAIN is not said because a solver is weak there."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from oracle import compare, machine, whole_set
from oracle.arms.known import free
from pieper import Arm, Status
from pieper.solver.rows import Flag

#: The only arm of the catalogue that is solved by the general elimination; rounding drowns it near straight wrists.
GENERAL = "kinova-gen3-6dof"


def made(arm: Arm, count: int, seed: int) -> np.ndarray:
    """Return random joint vectors (count, 6), turns over their whole turn, slides within the arm's length."""
    q = np.random.default_rng(seed).uniform(-np.pi, np.pi, (count, 6))
    q[:, arm.chain.prismatic] *= arm.chain.length / np.pi
    return q


def test_no_random_pose_of_the_catalogue_is_uncertain_or_lacks_its_posture():
    families = set()
    for name in pieper.catalog():
        if pieper.load(name).n != 6 or pieper.load(name).description.coupling is not None:
            continue
        arm = free(name)
        q = made(arm, 200, 1)
        many, sigma = arm.ik_many(arm.fk(q), threads=1), np.linalg.svd(arm.jacobian(q), compute_uv=False)[:, -1]
        gap = np.where(many.valid, arm.chain.joints.apart(many.q, q[:, None]), np.inf).min(1)
        told = (gap < 1e-6 + 1e-14 / sigma) | (many.status == Status.SINGULAR)
        assert told.all() and not (many.status == Status.UNCERTAIN).any(), name
        families.add(arm.plan.family)
    assert len(families) > 4


def test_where_the_elimination_is_weak_poses_beside_vouch():
    arm = free(GENERAL)
    T = arm.fk(made(arm, 20000, 9))
    weak = np.flatnonzero(arm.plan.solver.many(T, 1)[3] & Flag.UNCERTAIN)
    assert len(weak) > 2
    many = arm.ik_many(T[weak], threads=1)
    assert (many.status == Status.SOLVED).all()
    assert [arm.ik(pose).status for pose in T[weak]] == [Status.SOLVED] * len(weak)


@pytest.mark.slow
def test_what_poses_beside_vouched_for_is_all_that_a_search_finds():
    arm, m = free(GENERAL), machine(free(GENERAL))
    T = arm.fk(made(arm, 4000, 9))
    weak = np.flatnonzero(arm.plan.solver.many(T, 1)[3] & Flag.UNCERTAIN)
    for pose in T[weak]:
        found = whole_set(m, pose, library=None, rng=np.random.default_rng(1), most=3000)
        compared = compare(m, pose, arm.ik(pose).all_q, found)
        assert not compared.missing and not compared.extra
