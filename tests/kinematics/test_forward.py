"""The kernel's forward kinematics against plain matrix products."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from oracle import slow_forward
from pieper import InputError


@pytest.mark.parametrize("name", pieper.catalog())
@pytest.mark.parametrize("shape", [(), (1,), (3, 2), (11,), (0,)])
def test_poses_frames_and_jacobians_are_those_of_plain_products(name, shape):
    arm = pieper.load(name)
    q = np.random.default_rng(1).uniform(-7, 7, (*shape, arm.n))
    size = arm.chain.length + np.abs(arm.base).max() + np.abs(arm.tool).max() + 7 * arm.chain.prismatic.any()
    np.testing.assert_allclose(arm.fk(q), slow_forward.fk(arm.chain, q), atol=2e-14 * size)
    np.testing.assert_allclose(arm.frames(q), slow_forward.frames(arm.chain, q, arm.base), atol=2e-14 * size)
    np.testing.assert_allclose(arm.jacobian(q), slow_forward.jacobian(arm.chain, q), atol=4e-14 * size)


def test_bad_joint_vectors_say_what_is_wrong():
    arm = pieper.load("denso-vp6242")
    with pytest.raises(InputError, match=r"shape \(\.\.\., 6\)"):
        arm.fk([1, 2, 3])
    with pytest.raises(InputError, match="finite"):
        arm.jacobian([0, 0, np.nan, 0, 0, 0])
    with pytest.raises(InputError, match="numbers"):
        arm.frames("home")
