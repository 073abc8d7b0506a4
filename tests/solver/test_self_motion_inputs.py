"""What a self-motion is asked: numbers, joints' names and postures' names as everywhere, and nothing else."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from pieper.errors import InputError

CASES = {
    "a redundant arm": ("franka-panda", [0, 0.1, 0, -1.5, 0, 1.6, 0.7]),
    "a straight wrist": ("denso-vp6242", [0.3, 0.9, -2.6, 0.4, 0.0, 0.2]),
}


@pytest.fixture(params=CASES)
def asked(request):
    arm = pieper.load(CASES[request.param][0])
    return arm, arm.ik(arm.fk(CASES[request.param][1])).self_motions[0]


def test_what_is_no_joint_vector_or_parameter_is_refused_in_a_sentence(asked):
    arm, motion = asked
    n, last = arm.n, arm.joint_names[-1]
    for ask, said in (
        (lambda: motion.nearest([np.nan] * n), "q_now must be finite"),
        (lambda: motion.nearest([0.0] * (n - 1)), f"q_now must have shape .*{n}"),
        (lambda: motion.nearest("nope"), f"{arm.name} has no posture 'nope'"),
        (lambda: motion.nearest([0.0] * n, weights=[1.0]), "weights must have shape"),
        (lambda: motion.contains([0.0] * (n + 1)), "q must have shape"),
        (lambda: motion.contains([np.nan] * n), "q must be finite"),
        (lambda: motion.distance("nope"), "no posture"),
        (lambda: motion.at(3), "u must be .* at most 1"),
        (lambda: motion.at(np.nan), "u must be"),
        (lambda: motion.at([0, 0.5, 1]), "u must be"),
        (lambda: motion.at_joint(n, 0.3), "joint must be a whole number from 0"),
        (lambda: motion.at_joint("joint_99", 0.3), f"there is no joint 'joint_99'; the arm has .*{last}"),
        (lambda: motion.at_joint(0, np.nan), "value must be a finite number"),
    ):
        with pytest.raises(InputError, match=said):
            ask()


def test_names_mean_what_they_mean_everywhere(asked):
    arm, motion = asked
    moving = motion.free[0]
    value = float(motion.at(0.4)[moving])
    assert np.array_equal(motion.at_joint(arm.joint_names[moving], value), motion.at_joint(moving, value))
    assert motion.contains("zero") == motion.contains(np.zeros(arm.n))
    assert np.array_equal(motion.nearest("zero"), motion.nearest([0.0] * arm.n))
    assert motion.contains(motion.at(0.4)) and motion.distance(list(motion.at(0.4))) < 0.01


def test_a_solution_beyond_the_last_says_how_many_there_are():
    arm = pieper.load("denso-vp6242")
    sols = arm.ik(pieper.pose(0.35, 0, 0.4))
    with pytest.raises(IndexError, match="index 7 of 1 solution inside the limits; indices begin at 0"):
        sols[7]
