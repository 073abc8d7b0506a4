"""Poses as people say them: every notation there and back, against an independent library, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import pieper
from pieper import InputError
from pieper.kinematics.pose import rotation_vector
from pieper.kinematics.spoken import MAKERS, SPOKEN

#: Notation -> what SciPy calls it, and the order of its numbers there.
SEQUENCES = {
    "rpy": "xyz",
    "wpr": "xyz",
    "yaskawa": "xyz",
    "fanuc": "xyz",
    "abc": "ZYX",
    "kuka": "ZYX",
    "zyz": "ZYZ",
    "staubli": "XYZ",
}


@pytest.mark.parametrize(("notation", "sequence"), SEQUENCES.items())
def test_three_angles_mean_what_the_makers_say(notation, sequence):
    angles = (20.0, -35.0, 50.0)
    T = pieper.pose(100, 200, 300, **{notation: angles}, degrees=True, mm=True)
    assert np.abs(T[:3, :3] - Rotation.from_euler(sequence, angles, degrees=True).as_matrix()).max() < 1e-15
    assert np.abs(T[:3, 3] - [0.1, 0.2, 0.3]).max() < 1e-16


def test_vectors_and_quaternions_mean_what_the_makers_say():
    R = Rotation.from_rotvec([0.1, -0.7, 1.9])
    x, y, z, w = R.as_quat()
    for said in (
        {"rotvec": [0.1, -0.7, 1.9]},
        {"ur": [0.1, -0.7, 1.9]},
        {"quat_wxyz": [w, x, y, z]},
        {"abb": [w, x, y, z]},
        {"quat_xyzw": [x, y, z, w]},
        {"R": R.as_matrix()},
    ):
        assert np.abs(pieper.pose(**said)[:3, :3] - R.as_matrix()).max() < 1e-15


RPY = [(0, 90, 0), (30, 90, 40), (1, -90, 2), (180, 0, 0), (0, 0, 180), (0, 90 - 1e-9, 3), (5, -90 + 1e-7, 3)]
ZYZ = [(0, 0, 0), (30, 0, 40), (10, 180, 20), (10, 1e-9, 20), (0, 180, 0), (0, 1e-12, 0)]
ORIENTATIONS = [
    *Rotation.random(30, rng=np.random.default_rng(0)).as_matrix(),
    *(pieper.pose(rpy=angles, degrees=True)[:3, :3] for angles in RPY),
    *(pieper.pose(zyz=angles, degrees=True)[:3, :3] for angles in ZYZ),
]


@pytest.mark.parametrize("notation", [*SPOKEN, *MAKERS])
@pytest.mark.parametrize("units", [{}, {"degrees": True, "mm": True}])
def test_what_is_read_says_the_same_pose_again(notation, units):
    for R in ORIENTATIONS:
        T = pieper.pose(1, -2, 0.5, R=R)
        x, y, z, *numbers = pieper.read_pose(T, notation, **units)
        numbers = np.reshape(numbers, (3, 3)) if notation == "R" else numbers
        assert np.abs(pieper.pose(x, y, z, **{notation: numbers}, **units) - T).max() < 5e-15


def test_quarter_turns_in_degrees_are_exact():
    T = pieper.pose(rpy=(90, 0, 180), degrees=True)
    assert set(np.unique(T)) == {-1.0, 0.0, 1.0}
    assert pieper.read_pose(T, "rpy", degrees=True)[3:] == (90.0, 0.0, 180.0)


def test_a_pose_without_an_orientation_is_a_position():
    assert np.array_equal(pieper.pose(1, 2, 3)[:3], [[1, 0, 0, 1], [0, 1, 0, 2], [0, 0, 1, 3]])


@pytest.mark.parametrize(
    ("said", "message"),
    [
        ({"rpy": (0, 0, 0), "abc": (0, 0, 0)}, "rpy and abc say the orientation twice"),
        ({"rpy": (0, 0)}, "rpy must be 3 finite numbers"),
        ({"rpy": (0, 0, np.nan)}, "rpy must be 3 finite"),
        ({"rpy": "abc"}, "rpy must be 3 finite"),
        ({"quat_wxyz": (1, 1, 0, 0)}, "length 1.41421.*up to 1e-3"),
        ({"quat_xyzw": (0, 0, 0, 0)}, "length 0"),
        ({"quat_xyzw": (0, 0, 0.00201, 1.0005)}, None),
        ({"R": np.eye(4)}, r"R must be \(3, 3\)"),
        ({"R": np.diag([1, 1, -1])}, "left-handed"),
        ({"R": 2 * np.eye(3)}, "not a rotation"),
        ({"x": np.inf}, "x, y, z must be 3 finite"),
        ({"x": "1"}, "x, y, z must be 3 finite"),
    ],
)
def test_what_says_no_pose_is_refused(said, message):
    if message is None:
        assert np.abs(np.linalg.det(pieper.pose(**said)) - 1) < 1e-15
        return
    with pytest.raises(InputError, match=message):
        pieper.pose(**said)


@pytest.mark.parametrize("off", [0.3, 0.1, 0.05, 1e-3, 1e-5, 1e-7, 2e-7, 1e-8, 1e-12, 0.0])
def test_a_rotation_vector_beside_half_a_turn_comes_back(off):
    rng = np.random.default_rng(0)
    axes = np.vstack([np.eye(3), [0.6, 0.8, 0], [0, -0.6, 0.8], rng.normal(size=(200, 3))])
    for axis in axes / np.linalg.norm(axes, axis=1, keepdims=True):
        v = (np.pi - off) * axis
        back = np.array(pieper.read_pose(pieper.pose(rotvec=v), "ur")[3:])
        # at half a turn itself either sense is right
        assert min(np.abs(back - v).max(), np.abs(back + v).max() if off < 1e-9 else 9.0) < 5e-15


def test_rotations_beside_each_other_are_read_each_by_itself():
    half = pieper.pose(rotvec=(np.pi - 1e-9) * np.array([0.6, 0.8, 0.0]))[:3, :3]
    with np.errstate(all="raise"):
        both = rotation_vector(np.stack([np.eye(3), half]))
    assert np.array_equal(both[0], np.zeros(3)) and np.allclose(both[1], rotation_vector(half), atol=1e-15)


def test_an_unknown_notation_is_answered_with_the_known_ones():
    with pytest.raises(InputError, match="notation must be 'rpy', 'zyz', .*got 'euler'"):
        pieper.read_pose(np.eye(4), "euler")
    with pytest.raises(InputError, match="T must have shape"):
        pieper.read_pose(np.eye(3))
