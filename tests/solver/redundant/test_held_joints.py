"""A joint that was held is the one that the words speak of."""

from __future__ import annotations

import pytest

import pieper


@pytest.mark.parametrize("joint", [0, 2, 6])
def test_the_sentence_names_the_joint_that_was_held(joint):
    arm = pieper.load("franka-panda")
    name = arm.joint_names[joint]
    sols = arm.ik(arm.fk(arm.limits.mean(1)), redundancy={name: 0.05})
    assert f"at the chosen {name};" in sols.why
    assert all(abs(q[joint] - 0.05) < 1e-12 for q in sols.q)
