"""Motions within jerk limits: no third difference in time passes them; a straight line takes the least time."""

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

import pieper
from pieper import _kernel
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


def spread(rng, low, high, joints):
    """Limits that lie apart: a power of ten a joint."""
    return 10 ** rng.uniform(low, high, joints)


def test_a_straight_line_takes_the_time_of_the_closed_form_however_its_points_and_limits_lie_apart():
    rng = np.random.default_rng(3)
    for k in range(40):
        q0, q1 = rng.uniform(-2, 2, (2, 5))
        limits = pieper.Limits(*(spread(rng, low, high, 5) for low, high in ((-0.5, 0.5), (-1, 2), (-1, 3))))
        at = np.linspace(0, 1, 2 + k % 5)[:, None] if k % 3 else np.array([0.0, 0.2, 0.45, 0.7, 1.0])[:, None]
        motion = pieper.time_law(q0 + at * (q1 - q0), limits)
        assert motion.duration == pytest.approx(float(joint_move_time(q0, q1, limits)), rel=1e-9)
        assert 1 - 1e-9 < motion.margin <= 1 and np.array_equal(motion.q[-1], q1)
        # s is that of the points, even or not
        there = CubicSpline(np.linspace(0, 1, len(at)), at[:, 0])(motion.s) if len(at) > 2 else motion.s
        assert np.abs(q0 + there[:, None] * (q1 - q0) - motion.q).max() < 1e-9


def test_a_straight_line_within_limits_of_the_tool_is_no_slower_than_the_closed_form_must_be_slowed():
    arm = pieper.load("ur5e")
    q = np.array([[0, -1.2, 1.5, -1.8, -1.5, 0], [0.2, -1.1, 1.8, -1.8, -1.5, 0]])
    free = pieper.time_law(q, pieper.Limits(1.5, 10.0, 20.0))
    speed = np.linalg.norm(np.einsum("kij,kj->ki", arm.jacobian(free.q)[:, :3], free.dq), axis=1).max()
    for part in (0.5, 0.9, 1.001):
        motion = pieper.time_law(q, pieper.Limits(1.5, 10.0, 20.0, tool_speed=part * speed), arm=arm)
        assert motion.margin <= 1
        assert free.duration * (1 - 1e-9) <= motion.duration <= free.duration / min(part, 1) * (1 + 3e-3)


def some_path(rng, joints, k):
    """Through few points, along a wave, or nearly straight."""
    s = np.linspace(0, 1, 40)[:, None]
    if k % 3 == 0:
        return np.cumsum(rng.uniform(-1, 1, (int(rng.integers(3, 9)), joints)), 0)
    if k % 3 == 1:
        return sum(rng.normal(size=joints) * np.sin(m * np.pi * s + rng.uniform(0, 6, joints)) / m for m in (1, 2, 3))
    ends = rng.uniform(-1, 1, (2, joints)) * 10 ** rng.uniform(-2, 0.5)
    return np.vstack([ends[0], ends.mean(0) + 1e-3 * rng.normal(size=joints), ends[1]])


@pytest.mark.parametrize("k", range(12))
def test_wider_limits_are_never_slower(k):
    rng = np.random.default_rng(40 + k)
    joints = int(rng.integers(2, 7))
    q, apart = some_path(rng, joints, k), joints if k % 2 else 1
    narrow = [spread(rng, low, high, apart) for low, high in ((-0.3, 0.7), (-0.5, 1.5), (0, 3))]
    factor = [spread(rng, 0, 1.5, apart) if k % 4 in (3, i) else np.ones(apart) for i in (2, 0, 1)]
    as_said = [values if apart > 1 else float(values[0]) for values in narrow]
    wider = [values * by if apart > 1 else float((values * by)[0]) for values, by in zip(narrow, factor, strict=True)]
    slow, fast = pieper.time_law(q, pieper.Limits(*as_said)), pieper.time_law(q, pieper.Limits(*wider))
    assert max(slow.margin, fast.margin) <= 1
    assert fast.duration <= slow.duration * 1.01


def test_an_acceleration_that_no_jerk_reaches_changes_nothing():
    q = np.sin(np.linspace(0, 6, 50))[:, None] * np.array([0.5, 0.3, -0.4, 0.2, 0.1, 0])
    durations = [pieper.time_law(q, pieper.Limits(2.0, a, 20.0)).duration for a in (4.0, 10.0, 40.0, 100.0, 1e4)]
    assert (np.diff(durations) <= 1e-9).all() and durations[1] == pytest.approx(durations[-1], rel=1e-9)
    assert durations[-1] < 2.9  # 10.6 s where the window was as long as acceleration and jerk alone say


def test_programs_are_never_slower_with_a_wider_acceleration():
    arm = pieper.load("ur5e")
    home = [0, -1.2, 1.5, -1.8, -1.5, 0]
    T = arm.fk(home)
    T[1, 3] += 0.1
    durations = []
    for acceleration in (1.0, 4.0, 10.0, 100.0):
        limits = pieper.Limits(2.0, acceleration, 20.0, tool_speed=0.25)
        motion = pieper.Program(arm, limits, start=home).move_l(T).move_j(home).motion()
        assert motion.margin <= 1
        durations.append(motion.duration)
    assert (np.diff(durations) <= 1e-3).all() and durations[-1] < 1.4


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


def test_every_cell_has_the_largest_of_what_its_window_holds():
    rng = np.random.default_rng(1)
    for _ in range(50):
        n, m = 30, int(rng.integers(1, 12))
        last = np.minimum(np.sort(rng.integers(1, n, m) + rng.integers(0, 5, m)), n)
        first = np.sort(np.maximum(last - rng.integers(1, 6, m), 0))
        first = np.minimum(first, last - 1)
        values = rng.uniform(size=m)
        said = np.zeros(n)
        for a, b, value in zip(first, last, values, strict=True):
            said[a:b] = np.maximum(said[a:b], value)
        held = said > 0
        assert np.array_equal(_largest_over(first, last, values, n)[held], said[held])


def used(arm, motion, limits):
    """The largest value over its limit by differences of positions in time, and of the tool's places, alone."""
    step, poses = motion.t[1], arm.fk(motion.q[:-1])

    def of(values, order, limit):
        return np.diff(values, order, axis=0) / step**order / limit

    q, p, R = motion.q[:-1], poses[:, :3, 3], poses[:, :3, :3]
    out = [np.abs(of(q, 1, limits.speed)).max(), np.abs(of(q, 2, limits.acceleration)).max()]
    out.append(np.abs(of(q, 3, limits.jerk)).max())
    for order, limit in ((1, limits.tool_speed), (2, limits.tool_acceleration)):
        out.append(0.0 if limit is None else np.linalg.norm(of(p, order, limit), axis=1).max())
    if limits.turn_speed is not None:
        # |R1 - R0| in the sum of squares is 2 sqrt(2) sin of half the angle between
        between = 2 * np.arcsin(np.linalg.norm(np.diff(R, axis=0), axis=(1, 2)) / np.sqrt(8))
        out.append(between.max() / step / limits.turn_speed)
    return max(out)


@pytest.mark.parametrize("name", ["kuka-lbr-iiwa-14-r820", "ur5e", "stanford-arm", "denso-cobotta"])
@pytest.mark.parametrize("of_the_tool", range(1, 8))
def test_the_margin_is_the_largest_value_over_its_limit_whatever_of_the_tool_is_limited(name, of_the_tool):
    # a first piece that lasts long bounded the tool's acceleration by far: 47 percent slower, margin 1 said of 0.68
    arm, rng = pieper.load(name), np.random.default_rng(of_the_tool)
    low, high = np.clip(arm.limits, -2.5, 2.5).T
    q, n = rng.uniform(low, high, (int(rng.integers(2, 8)), arm.n)), arm.n
    limits = pieper.Limits(
        speed=rng.uniform(0.3, 3, n),
        acceleration=rng.uniform(1, 20, n),
        jerk=rng.uniform(5, 400, n),
        tool_speed=rng.uniform(0.1, 1) if of_the_tool & 1 else None,
        tool_acceleration=rng.uniform(0.3, 5) if of_the_tool & 2 else None,
        turn_speed=rng.uniform(0.3, 2) if of_the_tool & 4 else None,
    )
    motion = pieper.time_law(q, limits, arm=arm, rate=4000.0)
    assert 1 - 1e-5 <= motion.margin <= 1
    assert used(arm, motion, limits) == pytest.approx(motion.margin, abs=1e-3)


def test_no_limit_is_far_where_a_motion_begins_slowly():
    arm = pieper.load("kuka-lbr-iiwa-14-r820")
    low, high = np.clip(arm.limits, -2.5, 2.5).T
    q = np.random.default_rng(5).uniform(low, high, (9, 7))
    limits = pieper.Limits(speed=1.0, acceleration=10.0, jerk=100.0, tool_acceleration=3.0)
    motion = pieper.time_law(q, limits, arm=arm, rate=4000.0)
    assert used(arm, motion, limits) == pytest.approx(1.0, abs=1e-3)
    assert motion.duration < 38 and motion.tight  # 48.7 s with nothing nearer to its limit than 0.77
