"""Laws of seven joints at poses where two or more come to turn about one line: every self-motion is told, once."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from oracle import slow_forward
from oracle.joints import flips
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


def walked(arm, q, T, way, step):
    """Return points beside one another on the self-motion through q: steps along the null direction, Newton back."""
    points, old = [q], None
    for _ in range(int(3.5 / step)):
        null = np.linalg.svd(slow_forward.jacobian(arm.chain, q))[2][-1]
        old = null * (way if old is None else np.sign(null @ old))
        q = q + step * old
        for _ in range(3):
            now = slow_forward.fk(arm.chain, q)
            R = T[:3, :3] @ now[:3, :3].T
            turn = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) / 2
            miss = np.concatenate([T[:3, 3] - now[:3, 3], turn])
            q = q + np.linalg.lstsq(slow_forward.jacobian(arm.chain, q), miss, rcond=None)[0]
        points.append(q)
    return points


@pytest.mark.parametrize("gap", [1e-3, 2e-4])
def test_a_curve_that_passes_close_beside_a_line_turns_along_it_and_is_one(gap):
    """Half a turn of joints 5 and 7 lies there, and another curve passes as close on the other side."""
    arm, rng = free("kuka-lbr-iiwa-14-r820"), np.random.default_rng(103)
    q = rng.uniform(-1.5, 1.5, 7)
    q[5] = gap
    T = slow_forward.fk(arm.chain, q)
    found = arm.ik(T).self_motions
    assert len(found) == 8 and all(m.closed and len(m.samples) < 400 for m in found)
    mine = next(m for m in found if m.contains(q, 1e-6))
    step = gap**0.5 / 2  # the curve turns into the line so sharply
    points = np.array(walked(arm, q, T, 1.0, step) + walked(arm, q, T, -1.0, step))
    assert np.ptp(points[:, 4]) > 2.0
    assert np.abs(slow_forward.fk(arm.chain, points) - T).max() < 1e-9
    assert all(mine.contains(p, 1e-6) for p in points[::100])


def test_a_curve_that_crosses_a_line_and_passes_close_beside_another_closes():
    arm = free("kuka-lbr-iiwa-14-r820")
    q = np.array([0.0, 2.087337716, 1.268335587, -2.831823417, 0.0970363, 0.0, 2.529733])
    found = arm.ik(arm.fk(q)).self_motions
    assert sorted(m.free for m in found) == 4 * [(0, 1, 2, 4, 5, 6)] + 4 * [(4, 6)]
    assert all(m.closed for m in found)
