"""A self-motion with the points on limits put among its samples: the same curve, closed as before, none of it lost."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from pieper.kinematics.newton import missed
from pieper.solver.redundant.bounded_motion import bounded_motion
from pieper.solver.redundant.box import box
from pieper.solver.singular.trace import trace

Q = np.array([0.3, 0.6, -0.4, -1.2, 0.5, 0.9, -0.2])


@pytest.mark.parametrize("name", ["kuka-lbr-iiwa-14-r820", "franka-panda", "rethink-sawyer"])
@pytest.mark.parametrize("steps", [4000, 20])
def test_points_on_limits_are_put_between_the_samples_and_the_curve_stays_what_it_was(name, steps):
    arm = pieper.load(name)
    chain, T, free = arm.chain, arm.fk(Q), np.tile([-np.inf, np.inf], (7, 1))
    traced = trace(chain, Q, T, free, arm.joint_names, most_steps=steps)
    assert traced.closed == (steps > 20)
    joint = int(np.argmax(np.ptp(traced.samples, axis=0)))
    value = np.quantile(traced.samples[:, joint], 0.8)
    limits = free.copy()
    limits[joint, 1] = value
    crossed = np.flatnonzero((traced.samples[:-1, joint] <= value) != (traced.samples[1:, joint] <= value))
    ends = np.array([traced._halved(int(i), joint, float(value)) for i in crossed])
    assert len(ends)
    bounded = bounded_motion(trace(chain, Q, T, limits, arm.joint_names, most_steps=steps), ends)
    joints, out = chain.joints, bounded.samples
    assert missed(chain, out, T).max() < 1e-9
    # every sample stands where it stood, the ends too, and one more for every end
    distance = joints.apart(traced.samples[:, None], out[None])
    assert distance.min(1).max() < 1e-12
    assert len(out) == len(traced.samples) + len(ends)
    assert np.abs(np.diff(out, axis=0)).max() < 1.5 * np.abs(np.diff(traced.samples, axis=0)).max()
    if traced.closed:
        assert joints.apart(out[0], out[-1]) < 1e-12
        assert any(joints.apart(out[0], end) < 1e-9 for end in ends)
    else:
        assert joints.apart(out[0], traced.samples[0]) < 1e-12
    # and of the samples only these are marked: a closed curve's first one again as its last
    assert len(bounded.marks) == len(ends) + traced.closed
    assert all(joints.apart(out[k], ends).min() < 1e-9 for k in bounded.marks)


def test_what_is_searched_lies_inside_the_limits_and_is_a_turn_wide_or_more_where_there_are_none():
    arm = pieper.load("kuka-lbr-iiwa-14-r820")
    limits = np.tile([-np.inf, np.inf], (7, 1))
    limits[1], limits[2, 0], limits[3, 1] = (-0.5, 0.2), 5.0, -4.0
    low, high = box(arm.chain, limits)
    assert (low >= limits[:, 0]).all() and (high <= limits[:, 1]).all()
    assert low[1] == -0.5 and high[1] == 0.2
    others = [0, 2, 3, 4, 5, 6]
    assert (high - low)[others].min() >= 2 * np.pi - 1e-12
    assert (low[[0, 4, 5, 6]] == -np.pi).all() and (high[[0, 4, 5, 6]] == np.pi).all()
