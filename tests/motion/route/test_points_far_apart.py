"""Paths of few points: a branch may change between two of them, which is no reason to refuse the path."""

import numpy as np
import pytest

import pieper
from oracle.turns import ring
from pieper.kinematics.pose import rotation_about, transform

TORCH = transform(rotation_about(np.array([0.0, 1.0, 0.0]), np.radians(35.0)), np.array([0.05, 0.02, 0.35]))
FREE = pieper.Freedom()


@pytest.mark.parametrize("points", [9, 11, 14])
def test_a_ring_of_few_points_has_a_route_as_one_of_many_has(points):
    arm = pieper.load("universal-robots-ur10e")
    arm = arm.with_tool(arm.tool @ TORCH).with_limits({name: (-2 * np.pi, 2 * np.pi) for name in arm.joint_names})
    path = ring(points, (0.8, 0.0, 0.4), 0.25)
    route = arm.route(path, free=FREE)
    assert route.verdict is pieper.Verdict.FOUND
    assert np.abs(arm.fk(route.q) - FREE.turned(path, route.turn)).max() < 1e-9
    many = arm.route(ring(8 * (points - 1) + 1, (0.8, 0.0, 0.4), 0.25), free=FREE)
    # what leads through many points leads through every eighth of them
    assert route.cost <= np.sum(np.diff(many.q[::8], axis=0) ** 2) * 1.02
