"""Seven joints, shoulder and wrist all but in line at once, the elbow bent: eight closed curves that pass each other.

Near such a posture the curves of both sides of the shoulder, with either side of the wrist, run within its distance of
one line: what went straight on there changed both sides at once, and curves were told that went round 7 or 25 times.
"""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from oracle.joints import flips

LWR, RM75, IIWA, SIA = "kuka-lwr-4-plus", "realman-rm75", "kuka-lbr-iiwa-14-r820", "motoman-sia10d"
PASSING = [
    (IIWA, 1e-4, -0.8, 1e-4),
    (IIWA, -1e-4, 1.2, 1e-4),
    (IIWA, 1e-3, -1.9, -1e-3),
    (IIWA, -1.2259e-4, 0.61830, -1.2259e-4),
    (IIWA, 1.1861e-4, -1.6425, 2.6041e-6),
    (SIA, 1e-4, 0.8, 1e-4),
    (RM75, 3e-5, -1.0, -3e-5),
    (LWR, 1e-5, -1.4292, -1e-5),
    (LWR, -1e-2, 2.0, 1e-2),
]


def times_round(arm, points):
    """Return how often the elbow goes round the line from shoulder to wrist, the upper arm on a cone."""
    upper = np.array([arm.jacobian(q)[3:, 2] for q in points])
    rim = upper - (upper.max(0) + upper.min(0)) / 2
    across = np.linalg.svd(np.diff(upper, axis=0))[2][:2]
    x, y = (rim @ across.T).T
    turned = np.unwrap(np.arctan2(y, x))
    return abs(turned[-1] - turned[0]) / (2 * np.pi)


@pytest.mark.parametrize(("name", "shoulder", "elbow", "wrist"), PASSING)
def test_each_of_the_eight_flips_has_a_closed_curve_of_its_own_that_goes_round_once(name, shoulder, elbow, wrist):
    arm = pieper.load(name)
    arm = arm.with_limits(dict.fromkeys(arm.joint_names, (-3.1, 3.1)))
    q = np.array([0.7, shoulder, 0.6, elbow, -0.8, wrist, 0.5])
    T = arm.fk(q)
    motions = arm.ik(T).self_motions
    assert len(motions) == 8 and all(motion.closed and motion.dimension == 1 for motion in motions)
    for posture in flips(q):
        assert np.abs(arm.fk(posture) - T).max() < 1e-13
        assert sum(motion.contains(posture) for motion in motions) == 1
    for motion in motions:
        points = np.array([motion.at(u) for u in np.linspace(0, 1, 801)])
        assert np.abs(arm.fk(points) - T).max() < 1e-11
        assert abs(times_round(arm, points) - 1) < 1e-6
