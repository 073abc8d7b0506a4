"""Straight lines between poses."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from pieper.errors import InputError
from pieper.kinematics.pose import rotation_about, rotation_vector, transform
from pieper.motion.path import checked_path, line, shortest_turn

UNIT = st.floats(-1, 1)


def pose(axis, angle, position):
    axis = np.asarray(axis, float)
    return transform(rotation_about(axis / np.linalg.norm(axis), angle), np.asarray(position, float))


@settings(max_examples=60, deadline=None)
@given(st.tuples(UNIT, UNIT, UNIT), st.floats(-3.1, 3.1), st.tuples(UNIT, UNIT, UNIT), st.integers(2, 40))
def test_steps_are_equal_and_every_pose_is_a_rotation(axis, angle, position, n):
    axis = np.array(axis) + [0, 0, 1.5]
    T0 = pose([1, 2, 3], 0.7, [0.3, -0.1, 0.2])
    path = line(T0, pose(axis, angle, position), n)
    R = path[:, :3, :3]
    assert np.abs(np.swapaxes(R, 1, 2) @ R - np.eye(3)).max() < 1e-14
    steps = np.diff(path[:, :3, 3], axis=0)
    assert np.abs(steps - steps[0]).max() < 1e-14
    turns = rotation_vector(np.swapaxes(R[:-1], 1, 2) @ R[1:])
    assert np.abs(turns - turns[0]).max() < 1e-12


def test_the_ends_are_the_given_poses_to_the_last_bit():
    T0, T1 = pose([1, 0, 2], 0.3, [0.1, 0.2, 0.3]), pose([0, 1, 1], 2.0, [1, 2, 3])
    path = line(T0, T1, 7)
    assert np.array_equal(path[0], T0)
    assert np.array_equal(path[-1], T1)


def test_equal_orientations_stay_exactly_equal():
    T0 = pose([1, 1, 0], 0.4, [0, 0, 0])
    T1 = T0.copy()
    T1[:3, 3] = 1.0
    assert all(np.array_equal(T[:3, :3], T0[:3, :3]) for T in line(T0, T1, 11))


@pytest.mark.parametrize("axis", [[1, 0, 0], [0, -1, 0], [0, 0, -1], [0.6, -0.8, 0]])
def test_a_half_turn_goes_about_the_axis_whose_largest_component_is_positive(axis):
    axis = np.array(axis, float)
    T0 = pose([3, 1, 2], 1.1, [0, 0, 0])
    half = T0 @ transform(rotation_about(axis, np.pi))
    turn = shortest_turn(T0[:3, :3], half[:3, :3])
    assert np.linalg.norm(turn) == pytest.approx(np.pi, abs=1e-9)
    assert turn[np.argmax(np.abs(turn))] > 0
    middle = line(T0, half, 3)[1]
    expected = axis * np.sign(axis[np.argmax(np.abs(axis))])
    assert np.allclose(rotation_vector(T0[:3, :3].T @ middle[:3, :3]), expected * np.pi / 2, atol=1e-7)


def test_the_line_of_zero_length_rests_or_turns_on_the_spot():
    T = pose([0, 0, 1], 0.2, [0.1, 0.2, 0.3])
    assert np.array_equal(line(T, T, 4), np.broadcast_to(T, (4, 4, 4)))
    turned = T @ transform(rotation_about(np.array([1.0, 0, 0]), 1.0))
    assert np.array_equal(line(T, turned, 5)[:, :3, 3], np.broadcast_to(T[:3, 3], (5, 3)))


def test_a_pose_rounded_to_float32_is_accepted_and_made_exact():
    T0 = pose([1, 2, 3], 0.7, [0, 0, 0]).astype(np.float32)
    path = line(T0, np.eye(4), 3)
    assert np.abs(path[0, :3, :3].T @ path[0, :3, :3] - np.eye(3)).max() < 1e-14


@pytest.mark.parametrize(
    ("T1", "noun"),
    [
        (np.full((4, 4), np.nan), "finite"),
        (np.eye(3), "shape"),
        (np.diag([1.0, 1, -1, 1]), "left-handed"),
        (np.diag([1.1, 1.1, 1.1, 1]), "not a rotation"),
        ("nonsense", "4x4"),
    ],
)
def test_what_is_not_a_pose_is_refused_by_name(T1, noun):
    with pytest.raises(InputError, match=noun) as caught:
        line(np.eye(4), T1)
    assert "T1" in str(caught.value)


@pytest.mark.parametrize("n", [1, 0, -3, 2.5, "many", None])
def test_a_line_needs_a_whole_number_of_at_least_two_poses(n):
    with pytest.raises(InputError, match="poses"):
        line(np.eye(4), np.eye(4), n)


def test_a_bad_pose_inside_a_path_is_named_by_its_index():
    path = line(np.eye(4), pose([0, 0, 1], 1.0, [1, 0, 0]), 5)
    path[3, 0, 3] = np.nan
    with pytest.raises(InputError, match="3"):
        checked_path(path)


@pytest.mark.parametrize("path", [np.eye(4), np.zeros((0, 4, 4)), np.zeros((2, 3, 3)), "path", [[1, 2], [3]]])
def test_what_is_not_a_stack_of_poses_is_refused(path):
    with pytest.raises(InputError, match="path"):
        checked_path(path)


def test_turns_of_many_pairs_are_those_of_each_alone():
    rng = np.random.default_rng(3)
    R0 = Rotation.random(60, rng=rng).as_matrix()
    R1 = Rotation.random(60, rng=rng).as_matrix()
    R1[:10] = R0[:10]
    axis = rng.standard_normal((20, 3))
    # half turns, whose axis rounding would choose
    R1[10:30] = R0[10:30] @ Rotation.from_rotvec(np.pi * axis / np.linalg.norm(axis, axis=1)[:, None]).as_matrix()
    together = shortest_turn(R0, R1)
    assert np.array_equal(together, [shortest_turn(a, b) for a, b in zip(R0, R1, strict=True)])
    assert (together[:10] == 0).all()
    assert (together[10:30].max(1) >= -together[10:30].min(1)).all()
    assert np.abs(R0 @ Rotation.from_rotvec(together).as_matrix() - R1).max() < 1e-14
