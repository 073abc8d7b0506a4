"""What cannot be meant, one by one: routes, limits, time laws, programs, bodies and files say what, and the cure."""

import numpy as np
import pytest

import pieper
from oracle.turns import ring
from pieper.errors import InputError

ARM = pieper.load("abb-irb2400")
FREE = pieper.Freedom()
LIMITS = pieper.Limits(2.0, 8.0)
HOME = np.radians([0.0, 10, 10, 10, 30, 10])
T = ARM.fk(HOME)
PATH = ring(12, (1.1, 0, 0.6), 0.3, 0.3)
UP = [0, 0, 1]


def moved(x=0.0, y=0.0, z=0.0):
    out = T.copy()
    out[:3, 3] += [x, y, z]
    return out


def with_nan(values):
    out = np.array(values, float)
    out[(1,) * out.ndim] = np.nan
    return out


def program():
    return pieper.Program(ARM, LIMITS, start=HOME)


def law(**kinds):
    return pieper.time_law(np.stack([HOME, HOME + 0.1, HOME + 0.3]), LIMITS, **kinds)


def corner():
    side = pieper.line(T, moved(y=0.1), 12)
    return ARM.follow(np.concatenate([side, pieper.line(moved(y=0.1), moved(y=0.1, z=-0.1), 12)[1:]]), start=HOME)


ROUTES = [
    ("a path with NaN", lambda: ARM.route(with_nan(PATH), free=FREE), r"path must be finite, got nan at index"),
    ("a start with NaN", lambda: ARM.route(PATH, free=FREE, start=[np.nan] * 6), "start must be finite"),
    ("a pose with NaN", lambda: ARM.arcs(with_nan(T), FREE), "T must be finite"),
    ("one point", lambda: ARM.route(PATH[:1], free=FREE), "at least two points"),
    ("no point", lambda: ARM.route(PATH[:0], free=FREE), "at least one pose"),
    ("a repeated point", lambda: ARM.route(PATH[[0, 1, 1, 2]], free=FREE), "points 2 and 3 .* leave one out"),
    ("a line of no length", lambda: ARM.route(pieper.line(T, T, 5), free=FREE), "a segment of no length"),
    ("an interval the wrong way round", lambda: pieper.Freedom(turn=(1, -1)), r"did you mean \(-1, 1\)"),
    ("an interval over a turn", lambda: pieper.Freedom(turn=(-4, 4)), "at most 360"),
    ("an interval with NaN", lambda: pieper.Freedom(turn=(np.nan, 1)), "finite"),
    ("a cone of 90 degrees", lambda: pieper.Freedom(cone=np.pi / 2), "less than 90 degrees"),
    ("a negative cone", lambda: pieper.Freedom(cone=-0.1), "cone"),
    (
        "a start off the path",
        lambda: ARM.route(PATH, free=FREE, start=HOME),
        "start is not on the path: .* Leave it out",
    ),
    ("an end off the path", lambda: ARM.route(PATH, free=FREE, end=HOME), "end is not on the path: .* Leave it out"),
    (
        "a start outside limits",
        lambda: ARM.route(PATH, free=FREE, start=HOME + 9),
        "joint_1 at 515.662 deg, outside its limits",
    ),
    ("no freedom", lambda: ARM.route(PATH, free=0.3), "pieper.Freedom"),
    ("an unknown cost", lambda: ARM.route(PATH, free=FREE, cost="cheap"), "'motion' or 'time'"),
    ("a negative clearance", lambda: ARM.route(PATH, free=FREE, clearance=-0.1), "clearance"),
    ("a clearance of nothing", lambda: ARM.route(PATH, free=FREE, clearance=0.1), "needs a scene"),
    ("a turn rate of zero", lambda: ARM.route(PATH, free=FREE, turn_rate=0.0), "turn_rate"),
]
TIMES = [
    ("points with NaN", lambda: pieper.time_law(with_nan(np.eye(6)), LIMITS), "point 2, joint 2"),
    ("one point", lambda: pieper.time_law(HOME[None], LIMITS), "at least 2 points"),
    ("a repeated point", lambda: pieper.time_law([HOME, HOME, T[0, 0] + HOME], LIMITS), "no length .* Leave one"),
    ("no acceleration", lambda: pieper.Limits(speed=2.0), "acceleration is missing"),
    ("a joint without a limit", lambda: pieper.Limits([1, 1, None, 1, 1, 1], 8.0), "speed of joint 3 is missing"),
    (
        "a limit of zero",
        lambda: pieper.Limits([1, 1, 0, 1, 1, 1], 8.0),
        "speed of joint 3 .* got 0; a joint that is to stand still",
    ),
    ("no end of a limit", lambda: pieper.Limits(1.0, [1, np.inf, 1, 1, 1, 1]), "acceleration of joint 2 .* got inf"),
    (
        "a limit that is NaN",
        lambda: pieper.Limits([1, 1, 1, np.nan, 1, 1], 8.0),
        "speed of joint 4 .* got nan; say how much",
    ),
    ("limits of five joints", lambda: law(arm=ARM) and pieper.Limits([1.0] * 5, 8.0).of(6), "joint 6 has none"),
    ("a jerk alone", lambda: pieper.Limits(speed=1.0, jerk=10.0), "jerk .* without an acceleration"),
    ("a jerk of zero", lambda: pieper.Limits(1.0, 1.0, 0.0), "jerk must be .* leave it out"),
    ("a tool's speed of zero", lambda: pieper.Limits(1.0, 1.0, tool_speed=0.0), "tool_speed"),
    (
        "constant speed round a corner",
        lambda: pieper.time_law(corner(), LIMITS, constant_speed=[(0.2, 0.8, 0.3)]),
        r"cannot keep 0.3 m/s .* at s = 0\.[45].* joint_\d.* highest speed that would do is 0\.",
    ),
    ("a section backward", lambda: law(arm=ARM, constant_speed=[(0.8, 0.2, 0.1)]), "forward"),
    ("a section's speed below zero", lambda: law(arm=ARM, constant_speed=[(0.2, 0.8, -0.1)]), "positive"),
    ("too many samples", lambda: law(rate=1e9), "at most 10,000,000"),
    ("no samples", lambda: law(rate=0.0), "rate must be finite and positive"),
]
PROGRAMS = [
    ("no limits", lambda d: pieper.Program(ARM, None), "pieper.Limits"),
    ("a move of no length", lambda d: program().move_l(T), "no length.* Leave it out"),
    ("a pose with NaN", lambda d: program().move_l(with_nan(T)), "finite"),
    ("a negative blend", lambda d: program().move_l(moved(y=0.02), blend=-0.01), "radius"),
    ("a via at the end", lambda d: program().move_c(moved(z=-0.1), moved(z=-0.1)), "the via and the end .* one point"),
    ("a via at the start", lambda d: program().move_c(T, moved(z=-0.1)), "the via and the start .* one point"),
    ("a via in line", lambda d: program().move_c(moved(z=-0.05), moved(z=-0.1)), "in line: use move_l"),
    ("a name too long", lambda d: program().move_j(T2).write(d / f"{'a' * 40}.mod"), "at most 32 characters"),
    ("a name not ASCII", lambda d: program().move_j(T2).write(d / "pièce.mod"), "ASCII"),
    ("an unknown dialect", lambda d: program().move_j(T2).write(d / "a.mod", dialect="fortran"), "'rapid', 'urscript'"),
    ("another maker's dialect", lambda d: program().move_j(T2).write(d / "a.src"), "made by ABB; krl is for another"),
    ("an unknown maker", lambda d: ARM.configuration(HOME, "acme"), "abb, kuka, fanuc"),
    ("an unknown picture", lambda d: law(arm=ARM).animate(d / "a.avi"), ".gif, .webp, .mp4, .html"),
]
T2 = HOME + 0.1
BODIES = [
    ("a negative radius", lambda: pieper.Capsule([0, 0, 0], UP, -0.1), "radius of a capsule"),
    ("a cylinder's negative radius", lambda: pieper.Cylinder(T, -0.1, 1.0), "radius of a cylinder"),
    ("a cylinder of no height", lambda: pieper.Cylinder(T, 0.1, 0.0), "height of a cylinder"),
    ("a box inside out", lambda: pieper.Box(T, [1, -1, 1]), "sides of a box"),
    ("an empty hull", lambda: pieper.Convex([]), "got none"),
    ("a hull of three points", lambda: pieper.Convex(np.eye(3)), "at least four points, got 3. Give a Box"),
    ("a flat hull", lambda: pieper.Convex([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]), "in one plane: .* Give a Box"),
    ("a hull's negative layer", lambda: pieper.Convex(np.vstack([np.eye(3), -np.eye(3)]), -0.1), "layer"),
    (
        "a body on an unknown joint",
        lambda: ARM.with_bodies({"joint_9": pieper.Capsule(UP, UP, 0.1)}),
        "joint_1, joint_2",
    ),
    ("a negative margin", lambda: ARM.clear([HOME, T2], pieper.Scene([]), -1.0), "margin"),
]


@pytest.mark.parametrize("build, word", [case[1:] for case in ROUTES + TIMES + BODIES], ids=lambda x: None)
def test_what_cannot_be_meant_is_refused_with_a_cure(build, word):
    with pytest.raises(InputError, match=word):
        build()


@pytest.mark.parametrize("build, word", [case[1:] for case in PROGRAMS], ids=lambda x: None)
def test_what_a_program_cannot_take_is_refused_and_nothing_is_written(build, word, tmp_path):
    with pytest.raises(InputError, match=word):
        build(tmp_path)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("which", ["start", "end"])
def test_a_start_or_an_end_in_collision_is_told_with_the_pair_and_how_deep(which):
    path = PATH[:4]
    route = ARM.route(path, free=FREE)
    q = route.q[0 if which == "start" else -1]
    crate = pieper.Box(ARM.fk(q), [0.2, 0.2, 0.2], name="crate")
    with pytest.raises(InputError, match=rf"{which} is in collision, .* mm deep: .*crate.* Leave {which} out") as said:
        ARM.route(path, free=FREE, scene=pieper.Scene([crate]), **{which: q})
    assert said.value.data["metres"] < 0
    away = float(ARM.distance(q, pieper.Scene([])))
    with pytest.raises(InputError, match=f"{which} is .* mm from touching: .*; a clearance of"):
        ARM.route(path, free=FREE, scene=pieper.Scene([]), clearance=away + 0.01, **{which: q})


def test_a_start_nearer_to_singular_than_what_is_kept_is_told():
    path = PATH[:4]
    q = ARM.route(path, free=FREE).q[0]
    with pytest.raises(InputError, match="start is nearer to a singular posture than the 0.9"):
        ARM.route(path, free=FREE, start=q, singularity=0.9)


def test_a_capsule_of_no_length_is_a_sphere_and_a_blend_over_half_a_segment_shrinks():
    ball = pieper.Capsule([2.0, 0, 0], [2.0, 0, 0], 0.1)
    far = pieper.Scene([pieper.Capsule([2.0, 0, 0], [2.0, 0, 1e-9], 0.1)])
    assert float(ARM.distance(HOME, pieper.Scene([ball]))) == pytest.approx(float(ARM.distance(HOME, far)), abs=1e-8)
    p = program().move_l(moved(y=0.02), blend=0.05).move_l(moved(x=-0.1, y=0.02))
    (remark,) = p.motion().remarks
    assert "shrinks to 10 mm" in remark
