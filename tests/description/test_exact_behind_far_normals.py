"""Axes that meet or are parallel do so in the table too, where a common normal before them lies far away."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from pieper.description import robotfile
from pieper.kinematics.geometry import look
from pieper.tolerances import GEOMETRY_EXACT

NAMES = ("kuka-kr6-r700-sixx", "denso-vp6242", "abb-irb2400", "fanuc-m-20ia", "universal-robots-ur5e")


def tilted(name, tilt, joint, seed):
    """Return axes, points and tool at zero of an arm of which one axis is turned by an angle about its point."""
    chain, rng = pieper.load(name).chain, np.random.default_rng(seed)
    axes, points = chain.axes.copy(), chain.points.copy()
    for group in look(chain, GEOMETRY_EXACT).spherical:
        points[list(group.joints)] = group.point
    across = np.cross(axes[joint], rng.normal(size=3))
    axes[joint] = np.cos(tilt) * axes[joint] + np.sin(tilt) * across / np.linalg.norm(across)
    points[1] += 1e-4 * rng.normal(size=3)
    return axes, points, chain.home


def by_exponentials(axes, points, home, q):
    """Return the pose by Rodrigues' formula for each axis, without a table."""
    T = np.eye(4)
    for z, p, angle in zip(axes, points, q, strict=True):
        K = np.cross(np.eye(3), z)
        step = np.eye(4)
        step[:3, :3] = np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K @ K
        step[:3, 3] = p - step[:3, :3] @ p
        T = T @ step
    return T @ home


def written(axes, points, home):
    """Return a robot file that keeps an arm as axes."""
    joints = "".join(
        f"[[joints]]\nname = 'j{i}'\ntype = 'revolute'\naxis = {z.tolist()}\npoint_m = {p.tolist()}\n"
        for i, (z, p) in enumerate(zip(axes, points, strict=True))
    )
    return f"name = 'tilted'\nconvention = 'axes'\n{joints}[home]\nmatrix_m = {home.tolist()}\n"


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("tilt", [1e-4, 1e-5, 1e-6, 1e-7, 2e-8])
@pytest.mark.parametrize("name", NAMES)
def test_a_wrist_and_parallel_axes_stay_what_they_are(name, tilt):
    ur, q = name == "universal-robots-ur5e", np.random.default_rng(4).uniform(-2, 2, (20, 6))
    for seed in range(6):
        said = tilted(name, tilt, 1 if ur else 2, seed)
        for arm in (pieper.Arm.from_axes(*said), pieper.Arm(robotfile.loads(written(*said)))):
            found = look(arm.chain, GEOMETRY_EXACT)
            if ur:
                assert (2, 3) in [group.joints[:2] for group in found.parallel]
            else:
                assert (3, 4, 5) in [group.joints for group in found.spherical]
                assert arm.plan.family == "spherical_wrist"
            apart = [np.abs(arm.fk(row) - by_exponentials(*said, row)).max() for row in q]
            assert max(apart) < 1e-15 / tilt
