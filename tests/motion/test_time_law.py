"""Time laws along paths: within every limit between the samples too, as fast as another search, sections even."""

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

import pieper
from pieper.errors import InputError
from pieper.motion.curve import JointCurve
from pieper.motion.tool_bounds import point_derivatives, tool_curve

RNG = np.random.default_rng(11)
UR = pieper.load("universal-robots-ur10e").with_tool(pieper.pose(0.05, 0.02, 0.35, rpy=(0, 0.6, 0)))
START = np.array([0.1, -1.2, 1.5, -1.0, -1.2, 0.3])


def seam(points=60, length=0.5):
    T0 = UR.fk(START)
    T1 = T0.copy()
    T1[:3, 3] += np.array([0.3, -0.9, -0.1]) * length
    return UR.follow(pieper.line(T0, T1, points), start=START)


def in_time(motion, order, rate):
    """Differences of positions a fixed time apart: nothing of the time law's own derivatives is used."""
    q = motion.q[:-1]
    return np.abs(np.diff(q, order, axis=0)) * rate**order, 2**order * 1e-15 * np.abs(q).max() * rate**order


@pytest.mark.parametrize("points", [2, 3, 4, 9, 40])
@pytest.mark.parametrize("joints", [1, 2, 6])
def test_no_difference_in_time_passes_a_limit(points, joints):
    for _ in range(3):
        q = np.cumsum(RNG.uniform(-1, 1, (points, joints)), 0)
        speed, acceleration = RNG.uniform(0.5, 3, joints), RNG.uniform(1, 20, joints)
        motion = pieper.time_law(q, pieper.Limits(speed, acceleration), rate=1000.0)
        assert 1 - 1e-6 < motion.margin <= 1
        for order, limit in ((1, speed), (2, acceleration)):
            differences, rounding = in_time(motion, order, 1000.0)
            assert (differences <= limit + rounding).all()
        assert np.allclose(motion.q[[0, -1]], q[[0, -1]], atol=1e-13)
        assert np.abs(motion.dq[[0, -1]]).max() < 1e-6


def test_the_curve_goes_through_the_points_as_somebody_elses_spline():
    for points in (2, 3, 4, 5, 30):
        q, s = RNG.normal(size=(points, 3)), np.sort(RNG.uniform(0, 1, points))
        if points > 3:
            s[0], s[-1] = 0, 1
        ours, at = JointCurve.through(s, q), np.linspace(s[0], s[-1], 200)
        theirs = CubicSpline(s, q) if points > 2 else None
        if theirs is None:
            assert np.allclose(ours.at(at)[0], q[0] + (at - s[0])[:, None] / (s[1] - s[0]) * (q[1] - q[0]))
            continue
        scale = np.abs(theirs(at)).max()
        assert np.abs(ours.at(at)[0] - theirs(at)).max() < 1e-9 * scale


def test_a_straight_line_takes_the_time_of_the_closed_form():
    from pieper.motion.joint_move import joint_move_time

    for _ in range(20):
        q0, q1 = RNG.uniform(-2, 2, (2, 5))
        limits = pieper.Limits(RNG.uniform(0.3, 3, 5), RNG.uniform(1, 9, 5))
        motion = pieper.time_law(np.linspace(q0, q1, 7), limits)
        assert motion.duration == pytest.approx(float(joint_move_time(q0, q1, limits)), rel=2e-5)
        assert motion.deviation < 1e-12


def slowest_first(curve, speed, acceleration, cells=400, levels=1200):
    """A dynamic programme over (s, speed): no controllable sets, no rows of a cell. Its time is an upper bound."""
    s = np.linspace(0, 1, cells + 1)
    h = s[1]
    _, d1, d2, _ = curve.at(s)
    top = ((speed / np.maximum(np.abs(d1), 1e-12)) ** 2).min(1)
    grid = np.linspace(0, np.sqrt(top.max()), levels) ** 2
    cost = np.where(grid == 0, 0.0, np.inf)
    for i in range(cells - 1, -1, -1):
        x = grid[:, None]
        u = (grid[None] - x) / (2 * h)
        ok = (grid[None] <= top[i + 1]) & (x <= top[i])
        for k, value in ((i, x), (i + 1, grid[None])):
            for j in range(d1.shape[1]):
                ok &= np.abs(d1[k, j] * u + d2[k, j] * value) <= acceleration[j]
        with np.errstate(divide="ignore"):
            time = 2 * h / (np.sqrt(x) + np.sqrt(grid[None]))
        cost = np.where(ok, time + cost[None], np.inf).min(1)
    return cost[0]


def test_no_dynamic_programme_is_faster():
    for _ in range(2):
        q = RNG.uniform(-1, 1, (5, 2))
        curve = JointCurve.through(np.linspace(0, 1, 5), q)
        speed, acceleration = np.array([1.5, 2.0]), np.array([6.0, 5.0])
        ours = pieper.time_law(q, pieper.Limits(speed, acceleration)).duration
        theirs = slowest_first(curve, speed, acceleration, 60)
        assert ours <= theirs * (1 + 2e-2)
        assert ours >= theirs * 0.9


def test_the_same_path_backward_takes_the_same_time():
    q = RNG.uniform(-1, 1, (8, 4))
    limits = pieper.Limits(2.0, 6.0)
    there, back = pieper.time_law(q, limits).duration, pieper.time_law(q[::-1], limits).duration
    assert there == pytest.approx(back, rel=1e-4)


def test_a_motion_is_itself_and_may_be_a_key():
    one, other = (pieper.time_law(START + np.array([[0.0] * 6, [0.1] * 6]), pieper.Limits(1.0, 2.0)) for _ in "ab")
    assert one == one and one != other and {one: 1, other: 2}[one] == 1


def test_slower_limits_stretch_time_exactly():
    q = RNG.uniform(-1, 1, (6, 3))
    one = pieper.time_law(q, pieper.Limits(2.0, 6.0)).duration
    assert pieper.time_law(q, pieper.Limits(0.5, 6.0 / 16)).duration == pytest.approx(4 * one, rel=1e-9)


def test_the_tools_bounds_hold_between_the_points():
    q = START + np.cumsum(RNG.uniform(-0.3, 0.3, (12, 6)), 0)
    curve = JointCurve.through(np.linspace(0, 1, 12), q)
    fine = np.linspace(0, 1, 200 * 11 + 1)
    coarse = curve.split(fine[::20])
    bounds, exact = tool_curve(UR.chain, coarse), tool_curve(UR.chain, curve.split(fine))
    for name in ("point", "turn"):
        value, strays = getattr(bounds, name), getattr(bounds, f"{name}_strays")
        u = (np.arange(len(fine) - 1) % 20 / 20)[:, None]
        i = np.arange(len(fine) - 1) // 20
        off = np.linalg.norm(getattr(exact, name)[:-1] - ((1 - u) * value[i] + u * value[i + 1]), axis=1)
        assert (off <= strays[i] * (1 + 1e-9) + 1e-12).all()
        assert off.max() > 1e-3 * strays.max()
    # derivatives against differences of forward kinematics
    p = UR.fk(curve.at(fine)[0])[:, :3, 3]
    h = fine[1]
    assert np.abs((p[2:] - p[:-2]) / (2 * h) - exact.point[1:-1]).max() < 2e-3
    bend = (p[2:] - 2 * p[1:-1] + p[:-2]) / h**2
    away = np.arange(1, len(fine) - 1) % 200 != 0
    assert np.abs(bend - exact.bend[1:-1])[away].max() < 2e-2 * np.abs(bend).max()


def test_the_bound_between_the_points_is_the_least_of_a_tool_on_a_circle():
    """What curves evenly departs from its chords by the bound itself: any less would let it pass a limit."""
    arm = pieper.Arm.from_dh([pieper.DH(a=0.5)], convention="standard")
    curve = JointCurve.through(np.linspace(0, 1, 9), np.linspace(0, 0.8, 9)[:, None])
    bounds = tool_curve(arm.chain, curve)
    middle, _ = point_derivatives(arm.chain, curve, (curve.s[1:] + curve.s[:-1]) / 2)
    off = np.linalg.norm(middle - (bounds.point[1:] + bounds.point[:-1]) / 2, axis=1)
    assert (off <= bounds.point_strays).all() and (off > 0.99 * bounds.point_strays).all()


def test_the_tool_keeps_its_limits():
    track = seam()
    free = pieper.time_law(track, pieper.Limits(3.0, 30.0))
    for said in (
        dict(tool_speed=0.4),
        dict(tool_acceleration=1.5),
        dict(turn_speed=0.2),
        dict(tool_speed=0.3, tool_acceleration=3.0),
    ):
        limits = pieper.Limits(3.0, 30.0, **said)
        path = track if "turn_speed" not in said else START + np.linspace(0, 1, 30)[:, None] * np.ones(6)
        motion = pieper.time_law(path, limits, rate=1000.0, arm=UR)
        T = UR.fk(motion.q[:-1])
        v = np.linalg.norm(np.diff(T[:, :3, 3], axis=0), axis=1) * 1000
        a = np.linalg.norm(np.diff(T[:, :3, 3], 2, axis=0), axis=1) * 1e6
        w = np.linalg.norm(np.einsum("kij,kj->ki", UR.jacobian(motion.q)[:, 3:], motion.dq), axis=1)
        assert motion.margin <= 1
        assert v.max() <= said.get("tool_speed", np.inf) * (1 + 1e-9)
        assert a.max() <= said.get("tool_acceleration", np.inf) * (1 + 1e-8)
        assert w.max() <= said.get("turn_speed", np.inf) * (1 + 1e-9)
        if "turn_speed" not in said:
            assert motion.duration > free.duration
        name = next(iter(said)).replace("_", " ")
        assert name in {t.limit for t in motion.tight}


def test_a_section_of_constant_speed_is_even():
    track = seam()
    limits = pieper.Limits(3.0, 30.0)
    v = 0.25
    motion = pieper.time_law(track, limits, constant_speed=[(0.3, 0.7, v)], rate=2000.0)
    speed = np.linalg.norm(np.einsum("kij,kj->ki", UR.jacobian(motion.q)[:, :3], motion.dq), axis=1)
    inside = (motion.s >= 0.3) & (motion.s <= 0.7)
    assert inside.sum() > 100
    assert np.abs(speed[inside] / v - 1).max() < 1e-6
    assert motion.margin <= 1


def test_the_fastest_constant_speed_can_be_had_and_no_faster_one():
    track = seam()
    for said in ((3.0, 30.0), (0.4, 300.0), (3.0, 2.0), (3.0, 30.0, None, 0.1)):
        limits = pieper.Limits(*said)
        best = pieper.fastest_constant_speed(track, limits, 0.2, 0.8)
        assert best > 0 and best.why
        motion = pieper.time_law(track, limits, constant_speed=[(0.2, 0.8, best * (1 - 1e-6))])
        assert motion.margin <= 1
        with pytest.raises(InputError, match="highest speed that would do") as caught:
            pieper.time_law(track, limits, constant_speed=[(0.2, 0.8, best * (1 + 1e-4))])
        assert caught.value.fastest == pytest.approx(best)
    assert pieper.fastest_constant_speed(track, pieper.Limits(0.4, 300.0), 0.2, 0.8).limit == "speed"
    assert pieper.fastest_constant_speed(track, pieper.Limits(3.0, 2.0), 0.02, 0.8).limit == "run-up"
    assert pieper.fastest_constant_speed(track, pieper.Limits(3.0, 2.0), 0.2, 0.98).limit == "run-out"
    assert pieper.fastest_constant_speed(track, limits, 0.0, 0.5) == 0


@pytest.mark.parametrize(
    "q, word",
    [
        (np.zeros((1, 2)), "at least 2 points"),
        ([[0.0, 0], [1, np.nan]], "finite"),
        ([[0.0, 0], [1, 1], [1, 1]], "points 2 and 3"),
        ([0.0, 1.0], "shape"),
        ("up", "joint points"),
    ],
)
def test_what_is_no_path_is_refused(q, word):
    with pytest.raises(InputError, match=word):
        pieper.time_law(q, pieper.Limits(1.0, 1.0))


@pytest.mark.parametrize(
    "section, word",
    [
        ((0.5, 0.2, 1.0), "forward"),
        ((0.2, 0.5, -1.0), "positive"),
        ((0.2, 1.5, 1.0), "0 to 1"),
        ((0.2, 0.5), "s0, s1, v"),
        ((0.0, 0.5, 0.1), "run-up"),
        ((0.5, 1.0, 0.05), "run-out"),
        ((0.2, 0.5, 100.0), "highest speed"),
    ],
)
def test_an_impossible_section_is_refused(section, word):
    with pytest.raises(InputError, match=word):
        pieper.time_law(seam(), pieper.Limits(1.0, 5.0), constant_speed=[section])


def test_a_path_that_is_asked_too_much_is_refused():
    q = RNG.uniform(-1, 1, (5, 6))
    with pytest.raises(InputError, match="arm="):
        pieper.time_law(q, pieper.Limits(1.0, 1.0, tool_speed=1.0))
    with pytest.raises(InputError, match="samples"):
        pieper.time_law(q, pieper.Limits(1.0, 1.0), rate=1e9)
    with pytest.raises(InputError, match="overlap"):
        pieper.time_law(seam(), pieper.Limits(1.0, 1.0), constant_speed=[(0.2, 0.5, 0.1), (0.4, 0.6, 0.1)])
    far = pieper.line(UR.fk(START), pieper.pose(5, 0, 0), 20)
    with pytest.raises(InputError, match="the track stops at point"):
        pieper.time_law(UR.follow(far, start=START), pieper.Limits(1.0, 1.0))


def test_tight_names_the_joint_that_binds():
    motion = pieper.time_law(np.array([[0.0, 0], [0.1, 5]]), pieper.Limits(1.0, 2.0))
    assert [(t.limit, t.joint) for t in motion.tight] == [
        ("acceleration", "joint 2"),
        ("speed", "joint 2"),
        ("acceleration", "joint 2"),
    ]
    assert motion.tight[0].start == 0 and motion.tight[-1].end == pytest.approx(motion.duration)


def test_a_limit_of_turning_that_is_never_reached_costs_nothing():
    # along a straight line, round a corner and on: the tool turns nowhere but by rounding
    arm = pieper.load("denso-vp6242")
    home = np.radians([0, 51.492738, -150.638208, 0, 99.14547, 0])
    T = arm.fk(home)
    corner, end = T.copy(), T.copy()
    corner[:3, 3] += [0, 0.08, 0]
    end[:3, 3] += [-0.08, 0.08, 0.01]
    for scale in (1.0, 1.0 + 1e-15, 1.0 - 3e-15):
        durations = []
        for turn in (None, 1e-3, 10.0):
            limits = pieper.Limits(speed=3.0 * scale, acceleration=20.0, tool_speed=0.4, turn_speed=turn)
            program = pieper.Program(arm, limits, start=home)
            durations.append(program.move_l(corner, blend=0.01).move_l(end).motion(rate=50).duration)
        assert durations[1] == pytest.approx(durations[0], rel=1e-3)
        assert durations[2] == pytest.approx(durations[0], rel=1e-6)


def test_a_curve_that_swings_beyond_the_limits_of_its_arm_says_so():
    arm = pieper.load("abb-irb2400")
    points = np.zeros((5, 6))
    points[:, 1] = [0, 1.919, 1.918, 0, -1]
    limits = pieper.Limits(speed=2, acceleration=8)
    (said,) = pieper.time_law(points, limits, arm=arm).remarks
    assert arm.joint_names[1] in said and "16.2 deg beyond" in said
    assert pieper.time_law(points * 0.8, limits, arm=arm).remarks == ()
    assert pieper.time_law(points, limits).remarks == ()


def wandering(seed, points=5):
    rng = np.random.default_rng(seed)
    return START + np.cumsum(rng.uniform(-0.4, 0.4, (points, 6)), 0), 10 ** rng.uniform(-0.3, 0.5)


@pytest.mark.parametrize("seed", [7, 19, 25, 59])
def test_one_place_where_the_tools_bounds_are_loose_slows_nothing_else(seed):
    """The same curve through other points has other cells, and takes the same time."""
    q, most = wandering(seed)
    finer = CubicSpline(np.linspace(0, 1, 5), q)
    limits = pieper.Limits(3.0, 10.0, tool_acceleration=most)
    durations = []
    for points in (5, 13, 41, 57):
        motion = pieper.time_law(finer(np.linspace(0, 1, points)), limits, arm=UR, rate=1000.0)
        durations.append(motion.duration)
        path = UR.fk(motion.q[:-1])[:, :3, 3]
        peak = (np.linalg.norm(np.diff(path, 2, axis=0), axis=1) - 4e-15).max() * 1e6
        assert 0.98 * most < peak <= most * (1 + 1e-9) and motion.margin <= 1
    assert max(durations) < 1.002 * min(durations)


@pytest.mark.parametrize("seed", [19, 59])
def test_a_section_keeps_its_speed_beside_loose_bounds_of_the_tools_acceleration(seed):
    q, most = wandering(seed, 8)
    limits = pieper.Limits(3.0, 10.0, tool_acceleration=most)
    best = pieper.fastest_constant_speed(q, limits, 0.4, 0.5, arm=UR)
    motion = pieper.time_law(q, limits, arm=UR, constant_speed=[(0.4, 0.5, 0.98 * best)], rate=2000.0)
    inside = (motion.s > 0.4) & (motion.s < 0.5)
    speed = np.linalg.norm(np.einsum("kij,kj->ki", UR.jacobian(motion.q)[:, :3], motion.dq), axis=1)[inside]
    assert motion.margin <= 1 and inside.sum() > 10
    assert np.abs(speed / (0.98 * best) - 1).max() < 1e-6
