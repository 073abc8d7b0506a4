"""Limits: one number or one a joint, and every impossible one named."""

import warnings

import numpy as np
import pytest

import pieper
from pieper.errors import InputError


@pytest.mark.parametrize(
    "said, word",
    [
        (dict(acceleration=1.0), "speed is missing"),
        (dict(speed=1.0), "acceleration is missing"),
        (dict(speed=1.0, jerk=2.0), "jerk was given without an acceleration"),
        (dict(speed=[1.0, 0.0], acceleration=1.0), "joint 2"),
        (dict(speed=[1.0, None], acceleration=1.0), "joint 2 is missing"),
        (dict(speed=1.0, acceleration=[np.inf, 1.0]), "joint 1"),
        (dict(speed=1.0, acceleration=1.0, jerk=[1.0, 1.0, -3.0]), "joint 3"),
        (dict(speed=[np.nan], acceleration=1.0), "joint 1"),
        (dict(speed="fast", acceleration=1.0), "speed must be"),
        (dict(speed=np.ones((2, 2)), acceleration=1.0), "shape"),
        (dict(speed=1.0, acceleration=1.0, tool_speed=0.0), "tool_speed"),
        (dict(speed=1.0, acceleration=1.0, turn_speed=np.inf), "turn_speed"),
    ],
)
def test_an_impossible_limit_is_refused_and_named(said, word):
    with pytest.raises(InputError, match=word):
        pieper.Limits(**said)


def test_one_number_is_for_all_joints_and_the_first_joint_without_a_limit_is_named():
    limits = pieper.Limits(speed=2.0, acceleration=[1.0, 2.0, 3.0])
    assert np.array_equal(limits.of(3).speed, [2, 2, 2])
    with pytest.raises(InputError, match="elbow has none"):
        limits.of(4, ("base", "shoulder", "arm", "elbow"))


@pytest.mark.parametrize(
    "said, word",
    [
        (dict(speed=180.0), "speed is 180 rad/s.*degrees a second"),
        (dict(speed=[2.0, 90.0]), "speed is 90 .*degrees"),
        (dict(speed=2.0, tool_speed=250.0), "tool_speed is 250 m/s.*millimetres a second"),
        (dict(speed=2.0, turn_speed=90.0), "turn_speed is 90 rad/s.*degrees a second"),
    ],
)
def test_a_speed_in_degrees_or_millimetres_is_remarked(said, word):
    with pytest.warns(pieper.PieperWarning, match=word) as caught:
        pieper.Limits(acceleration=8.0, **said)
    assert len(caught) == 1 and caught[0].filename == __file__


def test_fast_arms_and_no_limit_are_not_remarked():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        pieper.Limits(speed=52.0, acceleration=600.0, tool_speed=12.0)
        pieper.Limits(speed=1e6, acceleration=1e6, tool_speed=1e3)
