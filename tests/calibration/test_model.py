"""The product of exponentials: it is the arm, and its derivatives are those of differences."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from pieper.calibration.measurements import SETUP, Measurements
from pieper.calibration.model import AxesModel, screw_motion
from pieper.calibration.parameters import parameters_of
from pieper.kinematics.pose import skew
from tests.calibration.planted import ARMS, planted, postures


@pytest.mark.parametrize("name", pieper.catalog())
def test_the_model_of_an_arm_is_the_arm(name):
    arm = pieper.load(name)
    if arm.description.linked:
        arm = arm.uncoupled()  # what a linkage moves is calibrated axis by axis
    q = postures(arm, np.random.default_rng(1), 10)
    assert np.abs(AxesModel.of(arm.chain).fk(q) - arm.fk(q)).max() < 1e-12


@pytest.mark.parametrize("name", ARMS)
def test_it_has_four_numbers_a_turning_joint_two_a_slide_and_six_of_the_tool(name):
    arm = pieper.load(name)
    count = parameters_of(arm.chain, arm.joint_names, (), ()).count
    assert count == 4 * arm.joint_types.count("R") + 2 * arm.joint_types.count("P") + 6


@pytest.mark.parametrize("kind", ["pose", "position", "distance", "plane"])
@pytest.mark.parametrize("name", ARMS)
def test_derivatives_are_those_of_differences(name, kind):
    arm, rng = pieper.load(name), np.random.default_rng(2)
    terms = ("gain", "coupling", "harmonic")
    parameters, q = parameters_of(arm.chain, arm.joint_names, (), terms), postures(arm, rng, 8)
    model, far = planted(arm, rng, terms), planted(arm, rng, terms).fk(q)
    point = np.array([0.9, 0.3, 0.2]) if kind == "distance" else np.array([0.6, 0.0, 0.8])
    values = {
        "pose": far,
        "position": far[:, :3, 3],
        "distance": np.linalg.norm(far[:, :3, 3] - point, axis=1),
        "plane": far[:, 2, 3],
    }[kind]
    data = Measurements(kind, values, point, 0.1)
    way, turn = data.derivatives(*model.pose_and_jacobian(q, parameters))
    found = np.concatenate([way, turn], 1) if kind == "pose" else way
    total, h = parameters.count + SETUP[kind], 1e-6

    def misses(step):
        moved = model.moved(step[: parameters.count], parameters)
        return np.concatenate(data.moved(step[parameters.count :]).misses(moved.fk(q)), 1)

    for k in range(total):
        step = np.zeros(total)
        step[k] = h
        assert np.abs((misses(step) - misses(-step)) / (2 * h) - found[:, :, k]).max() < 3e-9, (kind, k)


@pytest.mark.parametrize("angle", [0.0, 1e-9, 1e-5, 9.9e-5, *np.geomspace(1.01e-4, 1.0, 17)])
def test_a_screw_motion_is_the_sum_of_the_powers_of_its_twist(angle):
    rng = np.random.default_rng(4)
    for w, v in rng.standard_normal((20, 2, 3)):
        w *= angle / np.linalg.norm(w)
        X, power, total = np.zeros((4, 4)), np.eye(4), np.eye(4)
        X[:3, :3], X[:3, 3] = skew(w), v
        for k in range(1, 25):
            power = power @ X / k
            total = total + power
        off = np.abs(screw_motion(np.concatenate([w, v])) - total)
        assert off[:3, :3].max() < 1e-15 and off[:3, 3].max() < 1e-15 * (1 + np.abs(v).max())
