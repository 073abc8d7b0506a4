"""The kernel's forward kinematics against plain matrix products."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from oracle import slow_forward
from pieper import InputError, PieperWarning


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
        arm.frames(["a"] * 6)


def test_a_posture_goes_where_a_joint_vector_goes():
    arm = pieper.load("universal-robots-ur5e")
    assert np.array_equal(arm.fk("upright"), arm.fk(arm.postures["upright"]))
    assert np.array_equal(arm.jacobian("zero"), arm.jacobian(np.zeros(6)))
    with pytest.raises(InputError, match="no posture 'uprigth'. Did you mean 'upright'"):
        arm.frames("uprigth")


def test_degrees_where_radians_are_meant_get_a_warning_and_metres_of_a_slide_do_not(recwarn):
    pieper.load("denso-vp6242").fk([7, -7, 7, 40, 0, 0])
    pieper.load("adept-cobra-600").fk([1, 1, 90.0, 1])
    assert not recwarn
    with pytest.warns(PieperWarning, match="looks like degrees"):
        pieper.load("denso-vp6242").fk([90, 0, 0, 0, 0, 0])
