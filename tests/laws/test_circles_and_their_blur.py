"""Seven joints, the elbow straight or nearly so, axes nearly in one line: the circles and curves there are, each once.

Where an elbow is stretched solutions merge all along a circle, and rows of it are known to half the digits, or to two
where shoulder or wrist are nearly in line too: what is followed from them wanders round the circle and never closes.
"""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from oracle.joints import flips

LWR, RM75, IIWA, SIA = "kuka-lwr-4-plus", "realman-rm75", "kuka-lbr-iiwa-14-r820", "motoman-sia10d"
STRETCHED = [(LWR, 0.3, 1e-5), (RM75, 1e-5, 0.3), (IIWA, 1e-5, 1e-5), (SIA, 1e-4, 1e-4), (IIWA, 0.3, 1e-5)]
ROUND = 2 * np.pi * np.sqrt(2)


def lengths(motions):
    points = [np.unwrap([m.at(u) for u in np.linspace(0, 1, 401)], axis=0) for m in motions]
    return np.sort([np.linalg.norm(np.diff(x, axis=0), axis=1).sum() for x in points])


@pytest.mark.parametrize(("name", "shoulder", "wrist"), [*STRETCHED, (IIWA, 0.3, 0.4), (IIWA, 1e-3, 0.4)])
def test_a_stretched_elbow_has_four_circles(name, shoulder, wrist):
    arm, q = pieper.load(name), np.array([0.7, shoulder, 0.6, 0.0, -0.8, wrist, 0.5])
    motions = arm.ik(arm.fk(q)).self_motions
    assert len(motions) == 4 and all(motion.dimension == 1 for motion in motions)
    assert np.abs(lengths(motions) - ROUND).max() < 1e-2
    for posture in flips(q):
        assert sum(motion.contains(posture, 1e-6) for motion in motions) == 1


@pytest.mark.parametrize("elbow", [1e-3, 1e-4])
def test_an_elbow_all_but_straight_and_a_shoulder_in_line_have_four_circles_and_four_curves_across(elbow):
    arm, q = pieper.load(IIWA), np.array([0.7, 0.0, 0.6, elbow, -0.8, 0.4, 0.5])
    T = arm.fk(q)
    motions = arm.ik(T).self_motions
    found = lengths(motions)
    assert len(found) == 8 and np.abs(found[:4] - ROUND).max() < 1e-2 and np.ptp(found[4:]) < 0.01 < found[4] - ROUND
    for motion in motions:
        points = np.array([motion.at(u) for u in np.linspace(0, 1, 25)])
        assert np.abs(arm.fk(points) - T).max() < 1e-9
    for posture in flips(q):
        assert any(motion.contains(posture, 1e-6) for motion in motions)
