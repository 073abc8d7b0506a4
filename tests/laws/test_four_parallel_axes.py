"""Where a joint brings four axes parallel the arm moves by itself, however little it misses a special shape.

A SCARA with a wrist whose axes miss a point by a micrometre is no spherical wrist and no other family: rows of the
linkage's curve were taken for isolated ones, and with the elbow stretched poses that had been made were denied.
"""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from pieper import DH, Arm, Status
from pieper.kinematics.chain import Chain
from pieper.kinematics.newton import missed
from pieper.solver.singular import four_parallel as known
from pieper.solver.singular.four_parallel import Parallel, four_parallel
from pieper.solver.singular.linkage_motion import LinkageMotion

H = pi / 2


def _scara(a4: float, a5: float, d5: float = 0.0) -> Arm:
    rows = [
        DH(a=0.3, d=0.2),
        DH(a=0.25),
        DH(),
        DH(a=a4, alpha=-H),
        DH(a=a5, alpha=H, d=d5),
        DH(d=0.1),
    ]
    limits = [(-pi, pi), (-pi, pi), (-0.5, 0.5), *[(-pi, pi)] * 3]
    return Arm.from_dh(rows, convention="standard", joint_types="RRPRRR", limits=limits)


@pytest.mark.parametrize("off", [1e-5, 1e-6, 2e-7, 2e-8, 1e-9])
@pytest.mark.parametrize("where", [(0, 1, 0), (1, 0, 0), (1, 1, 0), (0, 0, 1)])
def test_a_stretched_elbow_and_a_straight_wrist_are_a_linkage(off: float, where: tuple[int, int, int]) -> None:
    arm = _scara(*(off * k for k in where))
    rng = np.random.default_rng(5)
    for _ in range(4):
        q = rng.uniform(-1, 1, 6) * [1, 0, 0.1, 1, 0, 1]
        found = arm.ik(arm.fk(q))
        assert found.status is Status.SINGULAR
        (motion,) = found.self_motions
        assert isinstance(motion, LinkageMotion)
        assert motion.contains(q)
        assert len(found.q) == 1
        assert missed(arm.plan.chain, motion.samples, arm.fk(q)).max() < 1e-14
        # the plane's own geometry: the last axis turns about where it stands, and the arm's length is the elbow's
        tip = np.array([arm.fk(p)[:3, 3] for p in motion.samples[::24]])
        assert np.ptp(tip, axis=0).max() < 1e-14
        assert np.ptp(motion.samples[:, 3]) > 1e-2


@pytest.mark.parametrize("off", [1e-5, 1e-6, 2e-7, 2e-8, 1e-9])
@pytest.mark.parametrize("last", [0.0, 0.7])
def test_a_linkage_that_is_stretched_throughout_is_held(off: float, last: float) -> None:
    arm = _scara(0.0, off)
    rng = np.random.default_rng(6)
    for turned in (0.0, 1e-5, 1e-4):
        q = rng.uniform(-1, 1, 6) * [1, 0, 0.1, 0, 0, 0] + [0, 0, 0, turned, 0, last]
        found = arm.ik(arm.fk(q))
        assert found.status in {Status.SOLVED, Status.SINGULAR}
        assert len(found.q) == 1
        # to first order in the elbow's angle the pose says nothing of it: half the digits
        assert np.abs(found.nearest(q) - q).max() < 1e-3
        assert missed(arm.plan.chain, found.q, arm.fk(q)).max() < 1e-14


def test_a_straight_wrist_brings_four_axes_parallel() -> None:
    found = four_parallel(_scara(0.0, 1e-6).plan.chain)
    assert {(at.joint, at.four) for at in found} == {(4, (0, 1, 3, 5))}
    assert sorted(abs(at.value) for at in found) == pytest.approx([0.0, pi])
    # a slide across the axes moves with them
    rows = [DH(a=0.3, d=0.2), DH(alpha=H), DH(alpha=-H, a=0.1), DH(a=0.2, alpha=-H), DH(a=0.01, alpha=H), DH(d=0.1)]
    across = Arm.from_dh(rows, convention="standard", joint_types="RRPRRR", limits=[(-2, 2)] * 6)
    assert four_parallel(across.plan.chain) == ()


@pytest.mark.parametrize(("off", "turned"), [(1e-6, 1e-3), (1e-7, 1e-3), (1e-8, 3e-3), (1e-8, 1e-2), (1e-9, 1e-2)])
def test_a_linkage_that_hardly_moves_is_told_alone(off: float, turned: float) -> None:
    arm = _scara(0.0, off)
    rng = np.random.default_rng(1)
    for _ in range(6):
        q = rng.uniform(-1, 1, 6) * [1, 0, 0.1, 0, 0, 1] + [0, 0, 0, turned, 0, 0]
        found = arm.ik(arm.fk(q))
        (motion,) = found.self_motions
        assert len(found.q) == 1
        assert motion.contains(q)


@pytest.mark.parametrize("off", [1e-5, 1e-6])
def test_out_of_reach_of_a_stretched_linkage_is_said(off: float) -> None:
    arm = _scara(0.0, off)
    q = np.array([0.4, 0.0, 0.03, 0.0, 0.0, 0.5])
    T = arm.fk(q)
    away = T[:3, 3] * [1, 1, 0]
    for beyond in (1e-10, 1e-8, 1e-6):
        farther = T.copy()
        farther[:3, 3] += beyond * away / np.linalg.norm(away)
        assert arm.ik(farther).status is Status.OUT_OF_REACH


def test_nothing_is_claimed_of_a_curve_that_is_not_recognised(monkeypatch: pytest.MonkeyPatch) -> None:
    def nowhere(chain: Chain) -> tuple[Parallel, ...]:
        return ()

    monkeypatch.setattr(known, "four_parallel", nowhere)
    arm = _scara(0.0, 1e-6)
    # as many rows as there can be, each singular to rounding
    q = np.array([0.2739234, 0.0, -0.0918053, -0.9669447, 0.0, 0.0])
    assert arm.ik(arm.fk(q)).status in {Status.SINGULAR, Status.UNCERTAIN}
    # where Newton's method stalls nothing is denied
    q = np.array([0.2132716, 0.0, 0.008725, 0.000087, 0.0, 0.0])
    assert arm.ik(arm.fk(q)).status in {Status.SOLVED, Status.SINGULAR, Status.UNCERTAIN}
