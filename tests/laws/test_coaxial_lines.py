"""Laws of seven joints at poses where two or more come to turn about one line: every self-motion is told, once."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

import pieper
from oracle import slow_forward
from pieper import Arm

#: Joints that stand at values, and then: the joints that turn against each other alone, in how many dimensions, in how
#: many pieces, and how many curves of the whole arm there are beside them.
PLACES = [
    ({5: 0.0}, (4, 6), 1, 4, 4),
    ({5: np.pi}, (4, 6), 1, 4, 4),
    ({1: 0.0}, (0, 2), 1, 4, 4),
    ({3: 0.0}, (2, 4), 1, 4, 0),
    ({1: 0.0, 5: 0.0}, (0, 2, 4, 6), 2, 2, 4),
    ({3: 0.0, 5: 0.0}, (2, 4, 6), 2, 1, 0),
    ({1: 0.0, 3: 0.0, 5: 0.0}, (0, 2, 4, 6), 3, 1, 0),
]


def free(name) -> Arm:
    arm = pieper.load(name)
    return arm.with_limits(dict.fromkeys(arm.joint_names, (-np.inf, np.inf)))


def flips(q):
    """Return the postures that an arm with two spherical groups and an elbow has beside one by symmetry."""
    out = []
    for shoulder, elbow, wrist in itertools.product((False, True), repeat=3):
        p = q.copy()
        for flip, k in ((shoulder, 1), (elbow, 3), (wrist, 5)):
            if flip:
                p[[k - 1, k + 1]] += np.pi
                p[k] = -p[k]
        out.append(p)
    return np.array(out)


@pytest.mark.parametrize(("at", "turning", "dimension", "pieces", "curves"), PLACES)
@pytest.mark.parametrize("name", ["kuka-lbr-iiwa-14-r820", "kuka-lwr-4-plus"])
def test_what_turns_about_one_line_is_told_beside_the_curves_of_the_whole_arm(
    name, at, turning, dimension, pieces, curves
):
    arm, rng = free(name), np.random.default_rng(11)
    q = rng.uniform(-1.5, 1.5, 7)
    q[list(at)] = list(at.values())
    T = slow_forward.fk(arm.chain, q)
    found = arm.ik(T).self_motions
    lines = [m for m in found if set(m.free) <= set(turning)]
    assert [(m.free, m.dimension) for m in lines] == pieces * [(turning, dimension)]
    assert len(found) - len(lines) == curves
    senses = slow_forward.jacobian(arm.chain, q)[:, list(turning)]
    for _ in range(2):
        turns = rng.uniform(-2, 2, len(turning))
        turns -= np.linalg.pinv(senses, rcond=1e-9) @ senses @ turns  # what they add up to must not change
        for p in flips(q):
            p[list(turning)] += turns
            assert np.abs(slow_forward.fk(arm.chain, p) - T).max() < 1e-13
            assert any(m.contains(p, 1e-6) for m in lines)


@pytest.mark.parametrize("at", [{3: 0.0}, {1: 0.0}])
def test_lines_of_a_panda_are_told_and_hold_its_pose(at):
    arm = free("franka-panda")
    q = np.random.default_rng(3).uniform(-1.5, 1.5, 7)
    (k,) = at
    q[k] = 0.0
    T = arm.fk(q)
    line = next(m for m in arm.ik(T).self_motions if m.free == (k - 1, k + 1))
    for turn in np.linspace(-3, 3, 7):
        p = q.copy()
        p[[k - 1, k + 1]] += (turn, -turn)
        assert np.abs(slow_forward.fk(arm.chain, p) - T).max() < 1e-13
        assert line.contains(p, 1e-6)
    assert np.abs(arm.fk(line.samples) - T).max() < 1e-12
