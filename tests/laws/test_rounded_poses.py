"""A pose that was written down with some digits has as many rows as the pose itself."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from tests.code.test_export import poses

ARMS = (
    "denso-vp6242",
    "abb-irb4400l-30-243",
    "fanuc-lr-mate-200id-controller",
    "universal-robots-ur5e",
    "stanford-arm",
    "fanuc-crx-10ia",
    "adept-cobra-600",
    "franka-panda",
)


def counts(arm, T, values):
    many = arm.ik_many(T, redundancy=values)
    return many.valid.sum(1), (many.flag & 3) == 0


@pytest.mark.parametrize("name", ARMS)
@pytest.mark.parametrize("digits", [12, 13])
def test_rounding_a_pose_loses_no_row(name, digits):
    arm = pieper.load(name)
    q, T = poses(arm, 4000)
    values = None if not arm.plan.reduction.locked else q[:, list(arm.plan.reduction.locked)]
    # fewer digits would take some poses over an edge of reach
    exact, clear = counts(arm, T, values)
    rounded, as_clear = counts(arm, np.round(T, digits), values)
    assert np.array_equal(exact[clear & as_clear], rounded[clear & as_clear])


@pytest.mark.parametrize("name", ["denso-vp6242", "abb-irb4400l-30-243", "universal-robots-ur5e", "fanuc-crx-10ia"])
@pytest.mark.parametrize("off", [3e-15, 5e-14, 1.9e-13, 2.1e-13, 9.9e-13, 1e-9, 9e-6])
def test_a_rotation_that_is_off_by_any_allowed_amount_has_all_rows(name, off):
    # of a pose that stays as it is every row misses by what its rotation is off
    arm, rng = pieper.load(name), np.random.default_rng(4)
    T = poses(arm, 500)[1]
    wrong = rng.normal(size=(500, 3, 3))
    wrong += np.swapaxes(wrong, 1, 2)
    wrong *= 0.5 * off / np.abs(wrong).max((1, 2))[:, None, None]
    bent = T.copy()
    bent[:, :3, :3] = T[:, :3, :3] @ (np.eye(3) + wrong)
    exact, clear = counts(arm, T, None)
    found, as_clear = counts(arm, bent, None)
    assert np.array_equal(exact[clear & as_clear], found[clear & as_clear])
    assert as_clear.mean() > 0.99
