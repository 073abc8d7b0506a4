"""Maps of arms that hold no pose in general ask what they hold, and say so; what cannot be meant is refused."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

import pieper

BOX = ((-0.6, 0.6), (-0.6, 0.6), (-0.2, 0.8))
D = pieper.DH


def five_axes():
    rows = [D(0, pi / 2, 0.3), D(0.4), D(0.3), D(0, pi / 2, 0, pi / 2), D(0, 0, 0.1)]
    return pieper.Arm.from_dh(rows, convention="standard", limits=[(-2, 2)] * 5)


def test_sampled_directions_ask_a_short_arm_what_it_holds():
    arm = five_axes()
    m = arm.reach_map(box=BOX, step=0.4, orientations=(8, 1))
    assert m.plan.task == "position" and m.fraction.mean() > 0.5
    assert "position alone was asked" in m.explain() and "27 questions" in m.explain()
    centres = m.grid.centres(np.arange(m.grid.count))
    wanted = [len(arm.ik(pieper.pose(*p), task="position").q) > 0 for p in centres]
    assert (m.fraction.ravel() > 0).tolist() == wanted


def test_a_whole_pose_is_asked_when_it_is_said_and_the_words_tell_what_that_means():
    scara = pieper.load("adept-cobra-600")
    down = np.diag([1.0, -1.0, -1.0])
    m = scara.reach_map(box=((0.2, 0.6), (0, 0.4), (0.2, 0.4)), step=0.2, orientations=down[None])
    assert m.plan.task == "pose" and m.fraction.any()
    assert "hold 4 of 6 numbers" in m.explain()
    poses = pieper.pose(9, 9, 9, R=down)[None]
    same = scara.reach_map(box=((0.2, 0.6), (0, 0.4), (0.2, 0.4)), step=0.2, orientations=poses)
    assert np.array_equal(same.fraction, m.fraction)


@pytest.mark.parametrize("lengths", [(0.4, 0.3), (0.4, 0.3, 0.1)])
def test_a_planar_arm_is_asked_for_positions(lengths):
    arm = pieper.Arm.from_dh(
        [pieper.DH(a) for a in lengths], convention="standard", limits=[(-3.2, 3.2)] * len(lengths)
    )
    m = arm.reach_map(box=((-0.8, 0.8), (-0.8, 0.8), (-0.05, 0.05)), step=0.1, orientations=(4, 4))
    x, y, _ = np.moveaxis(m.grid.centres(np.arange(m.grid.count)), -1, 0)
    away = np.hypot(x, y)
    inner = 0.1 if len(lengths) == 2 else 0.0
    assert m.plan.task == "position" and "position alone" in m.explain()
    assert np.array_equal(m.fraction.ravel() > 0, (away <= sum(lengths)) & (away >= inner))


def test_words_agree_with_their_numbers():
    box = ((0.2, 0.4), (0, 0.2), (0, 0.2))
    said = pieper.load("three-r").reach_map(box=box, step=0.2, orientations=(1, 1)).explain()
    assert "1 voxels" not in said and "1 orientations" not in said and "in every one" not in said


@pytest.mark.parametrize(
    "wrong",
    [
        lambda arm, m: arm.reach_map(box=BOX, step=0.5, orientations=np.zeros((0, 3, 3))),
        lambda arm, m: arm.reach_map(box=BOX, step=0.5, orientations=np.ones((2, 3, 2))),
        lambda arm, m: arm.reach_map(box=BOX, step=0.5, orientations=(4, 1), task="speed"),
        lambda arm, m: m.slice(z="a"),
        lambda arm, m: m.slice(x=np.nan),
        lambda arm, m: m.minus(3),
        lambda arm, m: m.measured("colour"),
    ],
)
def test_what_cannot_be_meant_is_refused(wrong):
    arm = pieper.load("universal-robots-ur5e")
    with pytest.raises(pieper.InputError):
        wrong(arm, arm.reach_map(box=BOX, step=0.5, orientations=(4, 1), measure=True))
