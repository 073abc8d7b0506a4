"""Single rows that belong to another unit or to nothing are named, and nothing is called sure that was not seen."""

from __future__ import annotations

import numpy as np
import pytest

import pieper


def _measured(count: int = 60):
    rng = np.random.default_rng(5)
    arm = pieper.load("ur5e")
    q = rng.uniform(-2.5, 2.5, (count, 6))
    T = arm.with_tool(pieper.pose(0.001, 0, 0.002)).fk(q)
    T[:, :3, 3] += rng.normal(0, 5e-5, (count, 3))
    return arm, q, T


def test_single_rows_that_are_no_noise_are_named_where_squares_would_follow_them():
    """A slip in one cell, two rows exchanged, a joint vector in degrees: of loss huber they are left out."""
    arm, q, T = _measured()
    slip = T.copy()
    slip[7, :3, 3] *= 1000
    with pytest.raises(pieper.InputError, match=r"1 measurement of 60 \(8\) misses.*there .*in millimetres") as said:
        arm.calibrate(q, slip)
    assert said.value.rows == [7]
    swapped = T.copy()
    swapped[[3, 9]] = T[[9, 3]]
    with pytest.raises(pieper.InputError, match=r"2 measurements of 60 \(4, 10\) miss ") as said:
        arm.calibrate(q, swapped)
    joints = q.copy()
    joints[5] = np.degrees(q[5])
    with pytest.raises(pieper.InputError, match=r"\(6\) misses .*there the joint angles are in degrees"):
        arm.calibrate(joints, T[:, :3, 3], kind="position")
    fit = arm.calibrate(q, slip, loss="huber")
    assert fit.outliers == (7,)
    assert fit.held_out.metres < 2e-4


def test_half_of_the_rows_in_another_unit_are_not_cured_by_changing_all():
    arm, q, T = _measured()
    T[::2, :3, 3] *= 1000
    with pytest.raises(pieper.InputError, match=r"millimetres in 30 measurements of 60 \(1, 3, 5, .*others are right"):
        arm.calibrate(q, T)
    T[:, :3, 3] /= 1000
    with pytest.raises(pieper.InputError, match=r"metres that were taken for millimetres in 30 measurements|miss"):
        arm.calibrate(q, T)


def test_what_was_not_seen_is_not_said_to_be_sure_and_no_noise_is_said_that_was_not():
    rng = np.random.default_rng(0)
    arm = pieper.load("ur5e")
    q = rng.uniform(-2, 2, (60, 6))
    d = np.linalg.norm(arm.fk(q)[:, :3, 3] - [0.7, 0.2, 0.1], axis=1)
    blind = arm.calibrate(q, d + rng.normal(0, 0.02, 60), kind="distance")
    assert len(blind.unobservable) == 30
    assert "None of 30 numbers was seen beyond the noise" in blind.explain()
    assert "Least sure" not in blind.explain()
    partly = arm.calibrate(q, d + rng.normal(0, 1e-5, 60), kind="distance")
    assert f"{30 - len(partly.unobservable)} of 30 numbers were fitted" in partly.explain()
    exact = arm.calibrate(q, arm.with_tool(pieper.pose(0.001, 0, 0.002)).fk(q))
    assert "that was said" not in exact.explain()
    assert "no noise but rounding" in exact.explain()
    assert "than the noise that was said" in arm.calibrate(q, exact.arm.fk(q), sigma=(0.05, 0.1)).explain()
