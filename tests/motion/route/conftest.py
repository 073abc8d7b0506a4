"""Arms with a tilted tool and seams for routes: a tool in line with the last joint would swallow the turn."""

import numpy as np
import pytest

import pieper
from pieper.kinematics.pose import rotation_about, transform

TORCH = transform(rotation_about(np.array([0.0, 1.0, 0.0]), np.radians(35.0)), np.array([0.05, 0.02, 0.35]))


def ring(N, centre, radius, tilt=np.pi / 6):
    a = np.linspace(0, 2 * np.pi, N)
    p = np.stack([centre[0] + radius * np.cos(a), centre[1] + radius * np.sin(a), centre[2] + 0 * a], -1)
    x = np.stack([-np.sin(a), np.cos(a), 0 * a], -1)
    out = np.stack([np.cos(a), np.sin(a), 0 * a], -1)
    z = -np.cos(tilt) * np.array([0, 0, 1.0]) - np.sin(tilt) * out
    return np.stack([transform(R, q) for R, q in zip(np.stack([x, np.cross(z, x), z], -1), p, strict=True)])


@pytest.fixture(scope="session")
def irb():
    arm = pieper.load("abb-irb2400")
    return arm.with_tool(arm.tool @ TORCH)


@pytest.fixture(scope="session")
def ur():
    arm = pieper.load("universal-robots-ur10e")
    return arm.with_tool(arm.tool @ TORCH)


@pytest.fixture(scope="session")
def seam():
    return ring(41, (1.1, 0.0, 0.6), 0.3)


@pytest.fixture(scope="session")
def found(irb, seam):
    return irb.route(seam, free=pieper.Freedom())
