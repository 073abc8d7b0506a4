"""The triangle of the law of cosines is the arm's: its sides and its joint are those of forward kinematics."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from oracle.joints import around
from pieper.equations.triangle import triangle_of

WRIST = ["denso-vp6242", "puma-560", "abb-irb120", "kuka-kr16-2", "staubli-tx60", "kuka-kr210-l150"]
PARALLEL = ["ur5e", "ur10", "dobot-nova2", "elephant-mycobot-280"]


def _planar(n: int) -> pieper.Arm:
    rows = [pieper.DH(a=a, alpha=0, d=0, theta=0) for a in (0.4, 0.3, 0.2)[:n]]
    return pieper.Arm.from_dh(rows, convention="standard", joint_types="R" * n, name=f"planar-{n}")


def _scara() -> pieper.Arm:
    rows = [
        pieper.DH(a=0.35, alpha=0, d=0.4, theta=0),
        pieper.DH(a=0.25, alpha=np.pi, d=0, theta=0),
        pieper.DH(a=0, alpha=0, d=0, theta=0),
        pieper.DH(a=0, alpha=0, d=0.05, theta=0),
    ]
    return pieper.Arm.from_dh(rows, convention="standard", joint_types="RRPR", name="scara")


ARMS = [*WRIST, *PARALLEL, _planar(2), _planar(3), _scara()]


def _corner(arm, q, triangle, which: str) -> tuple[np.ndarray, np.ndarray]:
    """A point of a corner and the elbow's axis, by turning joints and nothing else."""

    def fixed_points(joint: int) -> tuple[np.ndarray, np.ndarray]:
        other = q.copy()
        other[joint - 1] += 1.1
        M = np.asarray(arm.fk(other)) @ np.linalg.inv(arm.fk(q))
        values, vectors = np.linalg.eig(M[:3, :3])
        z = np.real(vectors[:, np.argmin(np.abs(values - 1))])
        return np.linalg.pinv(np.eye(3) - M[:3, :3]) @ M[:3, 3], z / np.linalg.norm(z)

    if which == "tool":
        return np.asarray(arm.fk(q))[:3, 3], fixed_points(triangle.elbow)[1]
    if which == "wrist":
        sides, at = np.zeros((3, 3)), np.zeros(3)
        for joint in range(arm.n - 2, arm.n + 1):
            p, z = fixed_points(joint)
            across = np.eye(3) - np.outer(z, z)
            sides, at = sides + across, at + across @ p
        return np.linalg.solve(sides, at), fixed_points(triangle.elbow)[1]
    return fixed_points(int(which))


@pytest.mark.parametrize("arm", ARMS, ids=lambda a: a if isinstance(a, str) else a.name)
def test_the_sides_and_the_joint_are_the_arms(arm):
    arm = pieper.load(arm) if isinstance(arm, str) else arm
    found = triangle_of(arm)
    assert found is not None
    end = {"the wrist centre": "wrist", "the tool's point": "tool"}.get(found.end, found.end.split()[-1])
    rng = np.random.default_rng(4)
    for _ in range(6):
        q = rng.uniform(-2, 2, arm.n)
        (a, z), (b, _), (c, _) = (_corner(arm, q, found, w) for w in (str(found.shoulder), str(found.elbow), end))
        one, two, three = (v - z * (z @ v) for v in (b - a, c - b, c - a))
        assert np.allclose([np.linalg.norm(one), np.linalg.norm(two)], [found.first, found.second], atol=1e-9)
        assert abs(np.linalg.norm(three) - found.third(q)) < 1e-9
        inside = np.arccos(np.clip(-(one @ two) / (found.first * found.second), -1, 1))
        assert abs(inside - found.inner(q)) < 1e-7
        low, high = found.reach
        assert low - 1e-9 <= found.third(q) <= high + 1e-9
        # the sentence on the page: q = +-(180 - gamma) - constant
        bend = np.pi - found.inner(q)
        off = [abs(around(q[found.elbow - 1] + found.constant - s * bend)) for s in (1, -1)]
        assert min(off) < 1e-9


def test_an_arm_without_two_parallel_axes_has_none():
    assert triangle_of(pieper.load("kuka-lbr-iiwa-14-r820")) is None
    assert triangle_of(pieper.load("stanford")) is None
