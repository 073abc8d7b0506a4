"""Small parts of motion asked by themselves: instructions, the corner of a blend, a sampled curve, what a file says."""

from __future__ import annotations

import dataclasses
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.interpolate import CubicHermiteSpline, PPoly

import pieper
from pieper.errors import InputError
from pieper.motion import between_points, blend, instructions, program_file
from pieper.motion.certificate import tool_acceleration_peaks
from pieper.motion.curve import JointCurve
from pieper.motion.dialects.trajectory import read_ros
from pieper.motion.joint_move import joint_move
from pieper.motion.motion import hermite
from pieper.motion.stops import _parameter
from pieper.motion.tool_bounds import ToolCurve
from pieper.motion.tool_way import ToolWay


def test_no_instruction_can_be_changed_once_it_is_said():
    kinds = [kind for kind in vars(instructions).values() if dataclasses.is_dataclass(kind)]
    assert len(kinds) > 5
    for kind in kinds:
        one = kind(*(1.0 for field in dataclasses.fields(kind) if field.default is dataclasses.MISSING))
        with pytest.raises(dataclasses.FrozenInstanceError):
            setattr(one, dataclasses.fields(kind)[0].name, 2.0)


def test_every_peak_of_a_step_is_where_its_cubic_turns_back():
    rng = np.random.default_rng(5)
    for _ in range(40):
        first, last, m0, m1 = rng.normal(size=(4, 3, 2))
        everywhere = np.full(2, -np.inf)
        found = between_points._peaks(first, last, m0, m1, everywhere, everywhere)
        slope = CubicHermiteSpline([0.0, 1.0], [first, last], [m0, m1]).derivative()
        for k in range(3):
            turns = [t for j in range(2) for t in PPoly(slope.c[:, :, k, j], slope.x).roots() if 0 < t < 1]
            assert [t for at, t in found if at == k] == pytest.approx(sorted(turns), abs=1e-9)


def test_an_arm_of_one_branch_is_followed_along_it():
    rows = [pieper.DH(alpha=np.pi / 2), pieper.DH(theta=np.pi / 2, alpha=np.pi / 2), pieper.DH()]
    gantry = pieper.Arm.from_dh(rows, convention="standard", joint_types="PPP", limits=[(-2.0, 2.0)] * 3)
    start = np.array([0.1, 0.2, 0.3])
    path = pieper.line(gantry.fk(start), gantry.fk([0.5, -0.3, 0.9]), 12)
    track = gantry.follow(path, start=start)
    assert track.complete and len(track.branches) == 1
    assert np.abs(track.followed[-1] - [0.5, -0.3, 0.9]).max() < 1e-12


def test_a_bound_of_the_tool_s_acceleration_is_met_where_it_peaks_between_two_points():
    """A slide's acceleration q' u + q'' x is of second degree on a piece: its middle is what the bound says."""
    h, u, x0, d1, d3 = 0.3, 0.7, 0.4, -5.0, 2.0
    x = np.array([x0, x0 + 2 * u * h])
    d2 = -d3 * (u * h / 2 + x[1]) / (3 * u)  # both ends are equally fast then
    way = np.array([[1.0, 0.0, 0.0]])
    point, bend = (np.array([[a], [b]]) * way for a, b in ((d1, d1 + h * d2 + h**2 / 2 * d3), (d2, d2 + h * d3)))
    tool = ToolCurve(
        point, bend, 0 * bend, *np.zeros((2, 1)), third=np.array([d3]), turn_third=np.zeros(1), fourth=np.zeros(1)
    )
    s = h / 2
    middle = (d1 + d2 * s + d3 * s**2 / 2) * u + (d2 + d3 * s) * (x0 + 2 * u * s)
    assert abs(middle) > abs(d1 * u + d2 * x0) + 1e-3
    assert tool_acceleration_peaks(tool, np.array([h]), x) == pytest.approx(abs(middle), rel=1e-12)


@pytest.mark.parametrize("corner", [0, 1])
def test_the_second_half_of_a_corner_is_as_fast_as_the_move_behind_it(corner):
    arm = pieper.load("abb-irb2400")
    start = np.array([0.1, 0.2, -0.1, 0.3, 0.9, 0.2])
    program, T = pieper.Program(arm, pieper.Limits(3.0, 30.0), start=start), arm.fk(start)
    speeds, corners = [0.3, 0.3, 0.3], []
    speeds[corner + 1] = 0.05
    for speed, step in zip(speeds, ((0, 0.2, 0), (0, 0.2, 0.1), (0, 0.3, 0.1)), strict=True):
        target = T.copy()
        target[:3, 3] += step
        corners.append(target[:3, 3])
        program.move_l(target, speed=speed, blend=0.02 if len(corners) < 3 else 0.0)
    motion = program.motion()
    tool = arm.fk(motion.q)[:, :3, 3]
    begin, end = (int(np.linalg.norm(tool - corners[at], axis=1).argmin()) for at in (corner, corner + 1))
    fast = np.linalg.norm(np.diff(tool, axis=0), axis=1) / np.diff(motion.t)
    assert fast[begin + 1 : end - 1].max() < 0.05 * 1.001 < 0.1 < fast.max()


def test_between_its_points_the_parameter_of_a_tool_s_way_is_the_cubic_that_fits():
    places, s, rate = np.array([0.0, 0.3, 1.0]), np.array([0.0, 0.5, 1.0]), np.array([0.8, 1.1, 2.0])
    curve = JointCurve.through(places, np.zeros((3, 1)))
    way = ToolWay(curve, s, rate, 1.0, ((0.0, 1.0),))
    at = np.linspace(0.0, 1.0, 57)
    wanted = np.clip(CubicHermiteSpline(places, s, 1 / rate)(at), 0.0, 1.0)
    assert np.abs(way.own(at) - wanted).max() < 1e-14


@pytest.mark.parametrize("radius", [0.011, 0.2, 0.5, 0.93])
@pytest.mark.parametrize("power", [1.0, 2.0])
def test_a_blend_begins_where_the_way_from_its_corner_is_its_radius(radius, power):
    distance = np.linspace(0.0, 1.0, blend.PLACES) ** power
    place = blend._enters(distance, radius)
    assert np.interp(place, np.linspace(0.0, 0.5, blend.PLACES), distance) == pytest.approx(radius, abs=1e-12)


def test_a_curve_in_time_ends_at_its_last_point_and_stays_there():
    t = np.array([0.0, 0.4, 1.0])
    q = np.array([[0.0], [0.3], [1.0]])
    dq = np.array([[1.0], [2.0], [0.5]])
    assert np.array_equal(hermite(t, q, dq, np.array([0.0, 0.4, 1.0, 1.5, 7.0]))[:, 0], [0.0, 0.3, 1.0, 1.0, 1.0])


def test_a_path_of_two_poses_has_its_parameter_and_one_of_a_single_pose_begins():
    assert _parameter(SimpleNamespace(path=[0, 0]), 0.25) == 0.25
    assert _parameter(SimpleNamespace(path=[0, 0, 0]), 0.5) == 0.25
    assert _parameter(SimpleNamespace(path=[0]), 0.0) == 0.0


def test_the_first_point_of_a_trajectory_is_called_the_first():
    with pytest.raises(InputError, match="point 1 of the trajectory has 1 position"):
        read_ros("joint_names: [a, b]\npoints:\n- positions: [1.0]\n- positions: [1.0, 2.0]\n")


@pytest.mark.parametrize("value", [0.0, -0.0, -1e-13, 1e-13])
def test_a_number_of_a_program_s_file_that_rounds_to_zero_has_no_sign(value):
    assert program_file._number(value) == "0.0"


def test_a_move_of_the_joints_is_sampled_five_hundred_times_a_second():
    motion = joint_move(np.zeros(2), np.array([1.0, 0.5]), pieper.Limits(1.0, 2.0))
    assert np.abs(np.diff(motion.t)[:-1] - 1 / 500).max() < 1e-12
