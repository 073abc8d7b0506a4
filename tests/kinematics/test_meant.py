"""Numbers that were probably meant in millimetres or degrees are warned of at every door that takes them."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

import pieper

UR = "universal-robots-ur5e"


def by_axes(second: tuple[float, ...], home: np.ndarray, first: tuple[float, ...] = (0, 0, 0)) -> pieper.Arm:
    return pieper.Arm.from_axes([[0, 0, 1], [0, 1, 0]], [first, second], home)


SAID = {
    "millimetres": lambda arm: pieper.Arm.from_opw(a1=100, a2=-100, b=0, c1=400, c2=500, c3=500, c4=100),
    "the tool reaches 100 m": lambda arm: arm.with_tool(pieper.pose(100, 0, 0)),
    "the base stands away by 500 m": lambda arm: arm.with_base(pieper.pose(500, 0, 0)),
    "links between the joints of this arm add up to 300 m": lambda arm: by_axes((300, 0, 0), pieper.pose(1, 0, 0)),
    "tool stands from the last axis by 300 m": lambda arm: by_axes((0.3, 0, 0), pieper.pose(300.3, 0, 0)),
    "base stands away by 400 m": lambda arm: by_axes((400.3, 0, 0), pieper.pose(400.5, 0, 0), (400, 0, 0)),
    "rpy has 90 rad": lambda arm: pieper.pose(0, 0, 0, rpy=(0, 90, 0)),
    "as far away as 500 m": lambda arm: arm.base_places(arm.fk(np.zeros((1, 6))), x=[500], y=[0], z=[0], yaw=[0]),
    "yaw has 90 rad": lambda arm: arm.base_places(arm.fk(np.zeros((1, 6))), x=[0], y=[0], z=[0], yaw=[90]),
    "candidates holds": lambda arm: arm.choose_poses(8, np.degrees(np.random.default_rng(0).uniform(-2, 2, (40, 6)))),
    "the pose is 400 m away": lambda arm: arm.ik(pieper.pose(0, 0, 400)),
    "2 poses without a solution": lambda arm: arm.ik_many([pieper.pose(0, 0, z) for z in (0.4, 400, 500)]),
}


@pytest.mark.parametrize("words", SAID)
def test_a_door_warns_and_takes_the_numbers_as_they_are(words):
    arm = pieper.load(UR)
    with pytest.warns(pieper.PieperWarning, match=words):
        SAID[words](arm)


def test_usual_numbers_are_taken_without_a_word():
    arm = pieper.load(UR)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        arm.with_tool(pieper.pose(0, 0, 5.0))
        pieper.pose(0, 0, 0, rpy=(0, 90, 0), degrees=True)
        pieper.pose(3.0, 0, 0, quat_wxyz=(0, 1, 0, 0))
        arm.ik_many([pieper.pose(0, 0, z) for z in (0.4, 4.0)])
        arm.base_places(arm.fk(np.zeros((1, 6))), x=[5], y=[0], z=[0], yaw=[3])


def test_one_pose_for_many_and_many_for_one_are_refused_with_what_to_write():
    arm = pieper.load(UR)
    T = arm.fk(np.zeros(6))
    for ask, cure in (
        (lambda: arm.ik_many(T), r"Ts\[None\]"),
        (lambda: arm.follow(T), r"path\[None\]"),
        (lambda: arm.calibrate(np.zeros((1, 6)), T), r"measured\[None\]"),
        (lambda: arm.ik(np.stack([T, T])), "ik_many"),
    ):
        with pytest.raises(pieper.InputError, match=cure):
            ask()
