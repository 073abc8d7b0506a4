"""What six-joint arms are made of: generic joint vectors, and how many solutions a plan allows for."""

from math import pi

import numpy as np

import pieper
from pieper.kinematics.geometry import look
from pieper.solver.families import spherical_wrist_parallel
from pieper.solver.plan.six_joints import sample_joints


def test_generic_joint_vectors_fill_a_turn_and_a_length_evenly_and_are_the_same_every_time():
    chain = pieper.load("stanford-arm").chain
    q = sample_joints(chain, 400)
    part = q / np.where(chain.prismatic, chain.length, pi)
    assert np.abs(part).max() <= 1
    in_quarters = np.apply_along_axis(np.bincount, 0, np.minimum((2 * part + 2).astype(int), 3), minlength=4)
    assert np.abs(in_quarters - 100).max() <= 5
    assert np.array_equal(q, sample_joints(chain, 400))
    assert np.abs(sample_joints(chain, 400, seed=2) - q).min() > 0


def test_two_turns_of_a_virtual_wrist_are_one_position_where_they_take_none_of_its_own_joints():
    rng = np.random.default_rng(1)
    for joints, most in ((3, 4), (4, 8)):
        rows = [pieper.DH(a=rng.uniform(0.1, 0.4), alpha=rng.uniform(0.3, 1.4), d=0.1 * k) for k in range(joints)]
        arm = pieper.Arm.from_dh(rows, convention="standard")
        plan = arm.plan_for("position")
        assert plan.family == "spherical_wrist" and plan.max_solutions == most


def test_a_wrist_whose_centre_lies_on_the_third_axis_has_no_forearm():
    """Four axes through a point: the third joint cannot move the centre, and the triangle has a side of no length."""
    sizes = {0.0: None, 0.3: spherical_wrist_parallel.Match}
    for forearm, kind in sizes.items():
        rows = [
            pieper.DH(a=0, alpha=pi / 2, d=0.4),
            pieper.DH(a=0.4, alpha=0, d=0),
            pieper.DH(a=forearm, alpha=pi / 2, d=0.1),
            pieper.DH(a=0, alpha=-pi / 2, d=0),
            pieper.DH(a=0, alpha=pi / 2, d=0),
            pieper.DH(a=0, alpha=0, d=0.1),
        ]
        chain = pieper.Arm.from_dh(rows, convention="standard").chain
        found = spherical_wrist_parallel.match(chain, look(chain, 1e-9))
        assert found is None if kind is None else isinstance(found, kind)
