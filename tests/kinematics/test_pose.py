"""Poses of other libraries go wherever a pose goes."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import RigidTransform, Rotation

import pieper
from pieper import InputError
from pieper.kinematics.pose import checked_pose

T = pieper.pose(0.3, -0.1, 0.4, rpy=(0.3, 0.7, -0.4))


class WithParts:
    """A pose that hands out its rotation and translation, as Pinocchio's and others' do."""

    def __init__(self, T):
        self.rotation, self.translation = T[:3, :3], T[:3, 3]


class WithMethods:
    """A pose whose parts are methods, its rotation an object of its own."""

    def __init__(self, T):
        self._T = T

    def rotation(self):
        return Rotation.from_matrix(self._T[:3, :3])

    def translation(self):
        return self._T[:3, 3:]


class WithHomogeneous:
    def __init__(self, T):
        self.homogeneous = T


class WithMatrix:
    def __init__(self, T):
        self._T = T

    def matrix(self):
        return self._T


@pytest.mark.parametrize(
    "kind", [np.array, list, RigidTransform.from_matrix, WithParts, WithMethods, WithHomogeneous, WithMatrix]
)
def test_every_way_to_hold_a_pose_is_understood(kind):
    assert np.abs(checked_pose(kind(T)) - T).max() < 1e-15


@pytest.mark.parametrize(("module", "name"), [("spatialmath", "SE3"), ("pinocchio", "SE3")])
def test_poses_of_spatialmath_and_pinocchio_are_understood(module, name):
    kind = getattr(pytest.importorskip(module), name)
    assert np.abs(checked_pose(kind(T)) - T).max() < 1e-15


@pytest.mark.parametrize("kind", [RigidTransform.from_matrix, WithParts])
def test_functions_that_take_a_pose_take_them(kind):
    arm = pieper.load("universal-robots-ur5e")
    pose = arm.fk([0.1, -1, 1, 0.2, 0.5, 0.3])
    assert np.allclose(arm.ik(kind(pose)).q, arm.ik(pose).q, atol=1e-12)
    assert np.allclose(arm.ik_many([kind(pose), kind(pose)]).q[0], arm.ik_many([pose]).q[0], atol=1e-12)
    assert np.allclose(pieper.line(kind(pose), kind(T), n=3), pieper.line(pose, T, n=3))
    assert np.allclose(arm.with_tool(kind(T)).tool, T) and np.allclose(arm.with_base(kind(T)).base, T)
    assert np.allclose(pieper.read_pose(kind(T)), pieper.read_pose(T))
    assert np.allclose(pieper.Arm.from_axes([[0, 0, 1]], [[0, 0, 0]], kind(T)).fk([0]), T)


def test_many_poses_in_one_object_are_understood():
    many = RigidTransform.from_matrix(np.stack([T, T]))
    assert checked_pose(many, batch=True).shape == (2, 4, 4)


@pytest.mark.parametrize("what", ["a pose", 3, None, object(), [None, None], {"T": 1}])
def test_what_is_no_pose_is_refused(what):
    with pytest.raises(InputError, match="T must"):
        checked_pose(what)


def test_millimetres_where_metres_are_meant_get_a_warning(recwarn):
    arm = pieper.load("universal-robots-ur5e")
    assert not len(arm.ik(pieper.pose(3, 0, 0))) and not recwarn
    with pytest.warns(pieper.PieperWarning, match="500.1 m away.*millimetres"):
        arm.ik(pieper.pose(500, 10, 0))
