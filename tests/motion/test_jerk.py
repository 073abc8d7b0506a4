"""Motions within jerk limits: no third difference in time passes them; a straight line takes the least time."""

import numpy as np
import pytest

import pieper
from pieper import _kernel
from pieper.errors import InputError
from pieper.motion.curve import JointCurve
from pieper.motion.jerk import _COEFFICIENTS, _largest_over, averaged
from pieper.motion.joint_move import joint_move_time
from pieper.motion.profile import Profile, rest_to_rest

RNG = np.random.default_rng(5)


@pytest.mark.parametrize("points, joints", [(3, 1), (5, 2), (9, 6), (30, 6)])
def test_no_difference_in_time_passes_a_limit(points, joints):
    q = np.cumsum(RNG.uniform(-1, 1, (points, joints)), 0)
    limits = pieper.Limits(RNG.uniform(1, 3, joints), RNG.uniform(4, 20, joints), RNG.uniform(30, 200, joints))
    motion = pieper.time_law(q, limits, rate=1000.0)
    assert 0.9 < motion.margin <= 1
    for order, limit in ((1, limits.speed), (2, limits.acceleration), (3, limits.jerk)):
        differences = np.abs(np.diff(motion.q[:-1], order, axis=0)) * 1000.0**order
        rounding = 2**order * 1e-15 * np.abs(q).max() * 1000.0**order
        assert (differences <= limit + rounding).all()
    assert np.abs(motion.ddq[[0, -1]]).max() < 1e-6
    fastest = pieper.time_law(q, pieper.Limits(limits.speed, limits.acceleration)).duration
    assert fastest < motion.duration < 3 * fastest


def test_a_straight_line_takes_the_time_of_the_closed_form():
    q0, q1 = np.zeros(6), np.array([1, 2, -1, 0.5, 0.3, 1.0])
    limits = pieper.Limits(2.0, 14.0, 140.0)
    motion = pieper.time_law(np.linspace(q0, q1, 20), limits)
    assert motion.duration == pytest.approx(float(joint_move_time(q0, q1, limits)), rel=1e-4)


def test_an_average_is_one_and_times_are_found():
    profile = rest_to_rest(2.0, 6.0, None)
    even = averaged(profile, 0.13)
    t = np.linspace(0, even.duration, 400)
    fine = np.linspace(-0.13, 0, 4001)
    mean = [
        np.where((u := moment + fine) < 0, 0, profile.at(np.clip(u, 0, profile.duration))[0]).mean() for moment in t
    ]
    assert np.abs(even.at(t)[0] - mean).max() < 1e-4
    assert isinstance(even, Profile) and even.duration == pytest.approx(profile.duration + 0.13)


def test_a_profile_is_split_where_the_curves_pieces_meet_and_uses_what_it_uses():
    rng = np.random.default_rng(7)
    s = np.append(np.sort(rng.uniform(0.0, 0.98, 12)), 1.0)
    s[0] = 0.0
    curve = JointCurve.through(s, rng.uniform(-1, 1, (13, 3)))
    even = averaged(rest_to_rest(2.0, 6.0, None), 0.13)
    speed, bend, jerk = rng.uniform(1, 3, (3, 3))
    grid, share = np.linspace(0, 1, 8), rng.uniform(0.3, 1, 7)
    pieces = {"s": s, "d1": curve.d1, "d2": curve.d2, "d3": curve.d3, "t": even.t, "c": even.c}
    bounds = {"speed": speed, "acceleration": bend, "jerk": jerk, "grid": grid, "share": share, "moment": 1e-12}
    for coefficients in (np.zeros((0, 0)), _COEFFICIENTS):
        t, c, used, fastest = _kernel.jerk_ratios(**pieces, **bounds, coefficients=coefficients)
        assert np.abs(c[:, 0][:, None] - s[1:-1]).min(0).max() < 1e-12
        assert np.isin(even.t, t).all() and t[-1] == even.duration
        # beside many samples of each piece, by the formulas
        u = (t[:-1, None] + np.diff(t)[:, None] * np.linspace(0, 1, 101)[1:-1]).ravel()
        at, v, a, j = (x[:, None] for x in even.at(u))
        _, d1, d2, d3 = curve.at(at[:, 0])
        values = np.abs([d1 * v, d2 * v**2 + d1 * a, d3 * v**3 + 3 * d2 * v * a + d1 * j]).reshape(3, -1, 99, 3).max(2)
        part = share[np.clip(np.searchsorted(grid, at[49::99, 0], side="right") - 1, 0, 6)][:, None]
        said = values / np.stack([part * speed, part * 0 + bend, part * 0 + jerk])
        found = used.reshape(3, 3, -1).transpose(1, 2, 0)
        if len(coefficients):
            assert (found >= said * (1 - 1e-9)).all() and (fastest >= v.reshape(-1, 99).max(1) * (1 - 1e-9)).all()
        close = np.quantile(np.abs(found - said) / said.max(), 0.9)
        assert close < 0.02


def test_programs_keep_jerks_and_the_tools_speed():
    arm = pieper.load("denso-vp6242")
    home = np.radians([0, 51.492738, -150.638208, 0, 99.14547, 0])
    T = arm.fk(home)
    T[1, 3] += 0.1
    limits = pieper.Limits(3.0, 20.0, 300.0, tool_speed=0.2)
    motion = pieper.Program(arm, limits, start=home).move_l(T).motion(rate=1000.0)
    assert motion.margin <= 1
    assert (np.abs(np.diff(motion.q[:-1], 3, axis=0)).max() * 1e9) <= 300 * (1 + 1e-9) + 8e-6
    speed = np.linalg.norm(np.einsum("kij,kj->ki", arm.jacobian(motion.q)[:, :3], motion.dq), axis=1)
    assert speed.max() <= 0.2 * (1 + 1e-9) and speed.max() > 0.15


def test_what_is_not_planned_with_a_jerk_is_refused():
    arm = pieper.load("denso-vp6242")
    q = RNG.uniform(-0.3, 0.3, (4, 6))
    with pytest.raises(InputError, match="not planned"):
        pieper.time_law(q, pieper.Limits(1.0, 5.0, 50.0, tool_acceleration=1.0), arm=arm)
    with pytest.raises(InputError, match="not planned"):
        pieper.time_law(q, pieper.Limits(1.0, 5.0, 50.0), constant_speed=[(0.3, 0.5, 0.1)], arm=arm)


def test_what_is_too_fast_takes_back_every_cell_under_its_window():
    rng = np.random.default_rng(1)
    for _ in range(50):
        n, m = 30, int(rng.integers(0, 12))
        last = np.minimum(np.sort(rng.integers(1, n, m) + rng.integers(0, 5, m)), n)
        first = np.sort(np.maximum(last - rng.integers(1, 6, m), 0))
        first = np.minimum(first, last - 1)
        values = 1 + rng.uniform(size=m)
        said = np.ones(n)
        for a, b, value in zip(first, last, values, strict=True):
            said[a:b] = np.maximum(said[a:b], value)
        assert np.array_equal(_largest_over(first, last, values, n), said)
