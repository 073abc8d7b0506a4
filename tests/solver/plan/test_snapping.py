"""A snapped arm is solved as its nominal one and refined; a count of solutions that this changes is said."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import pieper
from oracle.joints import turns_apart
from pieper import DH, Arm, Status

NAMES = ["denso-vp6242", "universal-robots-ur5e"]


def drawn(name: str, noise: float, *, snap: float | None) -> Arm:
    """Return a catalogue arm as a drawing with noise (rad, m) in its table would describe it, without limits."""
    d = pieper.load(name).description
    rng = np.random.default_rng(1)
    rows = tuple(
        DH(r.a + noise * rng.standard_normal(), r.alpha + noise * rng.standard_normal(), r.d, r.theta) for r in d.rows
    )
    return Arm(replace(d, rows=rows, limits=np.tile([-np.inf, np.inf], (d.n, 1))), snap=snap)


@pytest.mark.parametrize("name", NAMES)
def test_the_nominal_family_is_solved_and_every_row_is_exact_on_the_arm_as_described(name):
    arm = drawn(name, 2e-4, snap=1e-2)
    assert arm.plan.family != "general" and arm.plan.snapped
    q = np.random.default_rng(2).uniform(-3, 3, (40, 6))
    many = arm.ik_many(arm.fk(q), threads=1)
    gap = turns_apart(many.q, q[:, None]).max(-1)
    assert ((gap < 1e-6) & many.valid).any(1).all()
    assert arm.plan.residual(many.q, arm.fk(q)[:, None])[many.valid].max() < 1e-9


@pytest.mark.parametrize("name", NAMES)
def test_counts_agree_with_the_general_solver_on_the_arm_as_described_or_are_called_uncertain(name):
    snapped, exact = drawn(name, 2e-4, snap=1e-2), drawn(name, 2e-4, snap=None)
    assert exact.plan.family == "general"
    # a quarter of the poses near the edge of what the elbow can do, where pairs of solutions come and go
    q = np.random.default_rng(3).uniform(-3, 3, (60, 6))
    q[::4, 2] = np.random.default_rng(4).normal(0.0, 0.05, 15) - (np.pi / 2 if name == "denso-vp6242" else 0.0)
    T = exact.fk(q)
    ours, theirs = snapped.ik_many(T, threads=1), exact.ik_many(T, threads=1)
    agreed = (ours.count == theirs.count) | (ours.status == Status.UNCERTAIN) | (theirs.status == Status.UNCERTAIN)
    assert agreed.all()


def edge(arm: Arm, reach: float) -> np.ndarray:
    """Return a pose of a stretched UR5e moved so far (m) straight away from its base."""
    T = arm.fk(np.array([0.3, -1.0, 1e-3, -1.2, 0.9, 0.2]))
    direction = T[:3, 3] / np.linalg.norm(T[:3, 3])
    T[:3, 3] += reach * direction
    return T


def test_a_pose_where_the_count_changes_is_uncertain_and_says_by_how_much_the_arms_differ():
    snapped, exact = drawn("universal-robots-ur5e", 2e-4, snap=1e-2), drawn("universal-robots-ur5e", 2e-4, snap=None)
    changed = []
    # outwards through the edge of reach, a tenth of the difference of the two arms a step
    for reach in np.arange(-2e-4, 2e-4, 1e-5):
        T = edge(exact, reach)
        sols = snapped.ik(T)
        if len(sols.all_q) != len(exact.ik(T).all_q):
            assert sols.status == Status.UNCERTAIN
        bare = snapped.plan.solver.many(T[None], 1)[1].sum()
        if bare != len(exact.ik(T).all_q):
            changed.append(sols)
    assert len(changed) > 2, "the walk met no pose where the nominal arm has another count"
    for sols in changed:
        assert sols.status == Status.UNCERTAIN and sols.all_q.shape[0] == len(exact.ik(sols.T).all_q)
        assert "another number" in sols.why and "mm" in sols.why
        assert len(sols.residual) == 0 or sols.residual.max() < 1e-9


def test_an_arm_that_is_special_as_it_stands_is_not_changed_by_snapping():
    arm, same = pieper.load("denso-vp6242"), pieper.load("denso-vp6242", snap=1e-2)
    assert not same.plan.snapped and same.plan.drift == 0.0 and same.plan.family == arm.plan.family


def test_self_motions_and_arm_angle_of_a_snapped_redundant_arm_are_those_of_the_arm_as_described():
    arm = drawn("kuka-lbr-iiwa-14-r820", 2e-4, snap=1e-2)
    assert arm.plan.snapped and arm.plan.family == "spherical_wrist"
    q = np.array([0.4, -0.7, 0.5, 1.1, -0.6, 0.9, 0.3])
    T = arm.fk(q)
    family = arm.ik(T, redundancy=q[0]).self_motions[0]
    assert np.abs(arm.fk(family.samples) - T).max() < 1e-9
    asked = float(arm.arm_angle(q)[0])
    rows = arm.ik(T, redundancy={"arm angle": asked}).all_q
    assert turns_apart(rows, q).max(1).min() < 1e-7
    assert np.abs(arm.fk(rows) - T).max() < 1e-9
    assert turns_apart(arm.arm_angle(rows)[0], asked).max() < 1e-9
