"""A cell: the external axis is a joint like any other, and what lies on a turntable turns with it."""

import numpy as np
import pytest

import pieper
from pieper.errors import InputError
from pieper.kinematics.pose import rotation_z

ARM = pieper.load("denso-vp6242")
HOME = np.asarray(ARM.postures["line-start"], float)


def test_a_rail_carries_the_arm():
    cell = pieper.Cell(ARM, rail=(0, 2, 0), limits=(-1.0, 1.0))
    T = cell.fk([0.7, *HOME])
    np.testing.assert_allclose(T[:3, 3], ARM.fk(HOME)[:3, 3] + [0, 0.7, 0], atol=1e-12)
    np.testing.assert_allclose(T[:3, :3], ARM.fk(HOME)[:3, :3], atol=1e-12)
    np.testing.assert_allclose(cell.whole.limits[0], (-1.0, 1.0))
    np.testing.assert_allclose(cell.whole.limits[1:], ARM.limits)


@pytest.mark.parametrize("angle", [0.0, 0.6, -2.0])
def test_what_lies_on_a_turntable_turns_with_it(angle):
    point, axis = np.array([0.5, 0.1, 0.2]), np.array([0.0, 0.0, 1.0])
    cell = pieper.Cell(ARM, turntable=(point, axis), limits=(-3.0, 3.0))
    on_work = cell.fk([angle, *HOME])
    np.testing.assert_allclose(cell.work(angle) @ on_work, ARM.fk(HOME), atol=1e-12)
    np.testing.assert_allclose(cell.on_table(ARM.fk(HOME), angle), on_work, atol=1e-12)
    np.testing.assert_allclose(cell.work(angle)[:3, :3], rotation_z(np.asarray(angle))[:3, :3], atol=1e-12)
    np.testing.assert_allclose(cell.work(angle) @ [*point, 1], [*point, 1], atol=1e-12)


@pytest.mark.slow
def test_a_seam_longer_than_the_arm_reaches_is_welded_from_a_rail():
    T = ARM.fk(HOME)
    shift = np.tile(np.eye(4), (12, 1, 1))
    shift[:, 1, 3] = np.linspace(-0.6, 0.6, 12)
    path = shift @ T
    assert ARM.route(path).verdict is pieper.Verdict.IMPOSSIBLE
    cell = pieper.Cell(ARM, rail=(0, 1, 0), limits=(-1.0, 1.0))
    route = cell.route(path)
    assert route.verdict is pieper.Verdict.FOUND
    np.testing.assert_allclose(cell.fk(route.q), path, atol=1e-8)
    assert np.ptp(route.q[:, 0]) > 0.3


@pytest.mark.parametrize(
    "said, word",
    [
        (dict(), "one of them"),
        (dict(rail=(0, 1, 0), turntable=((0, 0, 0), (0, 0, 1))), "one of them"),
        (dict(rail=(0, 0, 0)), "no length"),
        (dict(rail=(0, np.nan, 0)), "finite"),
        (dict(turntable=(0, 0, 1)), "point, axis"),
        (dict(rail=(0, 1, 0), limits=(1.0, -1.0)), "lower end first"),
        (dict(rail=(0, 1, 0), limits=3), "lo, hi"),
    ],
)
def test_a_cell_that_is_none_is_refused(said, word):
    with pytest.raises(InputError, match=word):
        pieper.Cell(ARM, **said)


def test_a_cell_needs_an_arm():
    with pytest.raises(InputError, match="needs an arm"):
        pieper.Cell("denso", rail=(0, 1, 0))


def cells():
    """A rail and a turntable, the arm with a base of its own and a tool."""
    arm = ARM.with_base(pieper.pose(0.1, 0.2, 0.3, rpy=(0.1, 0.2, 0.3))).with_tool(pieper.pose(0, 0.02, 0.1))
    rail = pieper.Cell(arm, rail=(0, 1, 0), limits=(-1.0, 1.0))
    return rail, pieper.Cell(arm, turntable=((0.5, 0.1, 0.2), (0, 0, 1)), limits=(-3.0, 3.0))


@pytest.mark.parametrize("cell", cells(), ids=["rail", "turntable"])
def test_a_cell_is_as_far_from_an_obstacle_as_its_arm(cell):
    scene = pieper.Scene([pieper.Box(pieper.pose(0.6, -0.2, 0.1, rpy=(0.3, 0, 0.2)), (0.2, 0.3, 0.4))])
    rng = np.random.default_rng(3)
    for external in (0.0, 0.7):
        Q = rng.uniform(ARM.limits[:, 0], ARM.limits[:, 1], (40, ARM.n))
        # the obstacle as the arm sees it: left behind by the rail, turned along by the table
        T = cell.work(external) if cell.kind == "turntable" else pieper.pose(0, -external, 0)
        seen = pieper.Scene([pieper.Box(T @ scene[0].T, scene[0].size)])
        whole = cell.distance(np.column_stack([np.full(40, external), Q]), scene)
        np.testing.assert_allclose(np.asarray(whole), np.asarray(cell.arm.distance(Q, seen)), atol=1e-9)
    assert cell.bodies.names == cell.arm.bodies.names


def test_a_cell_follows_proves_and_solves_as_its_whole_arm():
    cell, _ = cells()
    q = np.array([0.1, *HOME])
    path = pieper.line(cell.fk(q), pieper.pose(0, 0.05, 0) @ cell.fk(q), 10)
    track = cell.follow(path, start=q)
    assert track.complete
    np.testing.assert_allclose(cell.fk(track.q), path, atol=1e-8)
    far = pieper.Scene([pieper.Box([5, 5, 5], [0.1, 0.1, 0.1])])
    assert cell.clear(track.q, far).verdict == cell.whole.clear(track.q, far).verdict
    assert cell.joint_names[0] == "rail" and cell.limits.shape == (7, 2)
    assert cell.jacobian(q).shape == (6, 7)


def test_what_a_cell_has_not_is_told_with_what_has_it():
    cell, _ = cells()
    with pytest.raises(AttributeError, match=r"cell\.whole\.reach_map or cell\.arm\.reach_map"):
        cell.reach_map  # noqa: B018
    with pytest.raises(AttributeError, match="has no 'nonsense'"):
        cell.nonsense  # noqa: B018
    with pytest.raises(InputError, match=r"cell\.whole"):
        pieper.Program(cell, pieper.Limits(speed=1, acceleration=1))
