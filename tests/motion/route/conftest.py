"""Arms with a tilted tool and seams for routes: a tool in line with the last joint would swallow the turn."""

import numpy as np
import pytest

import pieper
from oracle.turns import ring
from pieper.kinematics.pose import rotation_about, transform

TORCH = transform(rotation_about(np.array([0.0, 1.0, 0.0]), np.radians(35.0)), np.array([0.05, 0.02, 0.35]))


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
