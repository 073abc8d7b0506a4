"""Axes 1, 4 and 6 in one line: what holds the pose is one surface, whatever the digits, and a line on it has no end.

Lines on it were told as curves between two ends though they had come round, and from a posture typed with twelve digits
as curves of one degree of freedom beside the surface that they lie on.
"""

from __future__ import annotations

import numpy as np
import pytest

import pieper

QUARTER = np.pi / 2
#: Joints 2 and 3 in quarters of a turn.
POSTURES = [
    ("epson-n2-a450", 1, 0),
    ("doosan-e0509", -2, 0),
    ("doosan-a0509", 0, 0),
    ("realman-rm65", 0, 0),
    ("motoman-hc20", 0, -1),
    ("motoman-hc20", 2, 1),
    ("kuka-kr10-r1100-2", -1, 0),
]


@pytest.mark.parametrize("digits", [12, 17])
@pytest.mark.parametrize(("name", "second", "third"), POSTURES)
def test_what_holds_the_pose_is_told_as_one_surface(name, second, third, digits):
    arm = pieper.load(name)
    arm = arm.with_limits(dict.fromkeys(arm.joint_names, (-np.pi, np.pi)))
    q = np.round(np.array([0, second, third, 0, 0, 0]) * QUARTER, digits)
    T = arm.fk(q)
    axes = arm.jacobian(q)[:, [0, 3, 5]]
    assert np.linalg.matrix_rank(axes, tol=1e-9) == 1
    sols = arm.ik(T)
    lines = [motion for motion in sols.self_motions if motion.dimension > 1]
    assert lines and all(motion.dimension == 2 for motion in lines)
    for motion in sols.self_motions:
        points = np.array([motion.at(u) for u in np.linspace(0, 1, 31)])
        assert np.abs(arm.fk(points) - T).max() < 1e-9
        free = [np.linalg.matrix_rank(J, tol=1e-6) for J in (arm.jacobian(p)[:, [0, 3, 5]] for p in points)]
        # three axes in one line leave two degrees of freedom, and two axes one
        assert (min(free) == max(free) == 1) == (motion.dimension == 2)
        assert ("two ends" in str(motion)) == (motion.dimension == 1 and not motion.closed)
        # two joints that turn against one another come round
        assert motion.closed or not motion.relation
    others = len(sols.self_motions) - len(lines)
    assert f"{others + 1} self-motion" in sols.why and "2 degrees of freedom" in sols.why
    J = axes[:3] if np.abs(axes[:3]).max() > np.abs(axes[3:]).max() else axes[3:]
    senses = [np.sign(J[:, k] @ J[:, 0]) for k in (1, 2)]
    for t, v in np.random.default_rng(4).uniform(-1.5, 1.5, (6, 2)):
        on = q + [t, 0, 0, v, 0, -senses[1] * (t + senses[0] * v)]
        assert np.abs(arm.fk(on) - T).max() < 1e-11
        assert any(motion.contains(on) for motion in lines)
        assert np.abs(sols.nearest(on) - on).max() < 1e-6
    many = arm.ik_many(T[None])
    assert many.status[0] == sols.status and many.count[0] == len(sols.all_q)


def test_axes_through_one_point_are_one_surface():
    """Seven axes through one point: all that holds a pose is a surface, on which no two axes lie in one line."""
    twists = [-np.pi / 2, -np.pi / 2, 2.8037, np.pi / 2, np.pi / 2, -0.4959, np.pi / 2]
    rows = [pieper.DH(alpha=twist, d=0.489 * (i == 0), a=0.09 * (i == 6)) for i, twist in enumerate(twists)]
    arm = pieper.Arm.from_dh(rows, convention="standard", limits=[(-3, 3)] * 7)
    q = np.random.default_rng(15).uniform(-2, 2, 7)
    motions = arm.ik(arm.fk(q)).self_motions
    assert len(motions) == 1 and motions[0].dimension == 4 and motions[0].contains(q, 1e-6)
