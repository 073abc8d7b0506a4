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
