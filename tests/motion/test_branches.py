"""Branches taken over a singular point, on a way of two joints whose solutions are written down."""

from __future__ import annotations

import numpy as np
import pytest

from pieper.motion import branches
from pieper.motion.branches import Strand
from pieper.tolerances import BRANCHES_MET, BRIDGE, READING

POINT = 4
BEYOND = POINT + BRIDGE
#: Nearer than branches that have met, and clearly farther.
NEAR, FAR = 0.5 * BRANCHES_MET, 3.0 * BRANCHES_MET


class Way:
    """Solutions at places of the path; a step is sure where it is said to be, or takes the nearest when loose."""

    unit = np.ones(2)

    def __init__(self, solutions, *, sure=False, projected=None):
        self.found, self.sure, self.projected = {x: np.array(q, float) for x, q in solutions.items()}, sure, projected
        self.steps: list[tuple[float, float, bool]] = []

    def solutions(self, x):
        return self.found.get(x, np.zeros((0, 2))).reshape(-1, 2), False

    def gap(self, to, q):
        return to - q

    def step(self, q, x, to, *, loose=False):
        self.steps.append((x, to, loose))
        found, _ = self.solutions(to)
        if not len(found):
            return q, np.array([False])
        return found[np.argmin(np.linalg.norm(found - q, axis=-1))][None], np.array([self.sure or loose])

    def project(self, q, x):
        return (q, False) if self.projected is None else (np.array(self.projected, float), True)


def strand(x=POINT - BRIDGE):
    """A strand at the origin, just before the point."""
    return Strand([np.zeros(2)], np.zeros(2), x)


def crossed(solutions, **said):
    """Take one strand over the point; return it, whether it lives, and the way."""
    way, one = Way({BEYOND: solutions}, **said), strand()
    return one, branches._cross(way, [one], POINT) == [one], way


def test_a_sure_step_takes_a_branch_to_just_behind_the_point():
    one, lives, way = crossed([[0.1, 0.0]], sure=True)
    assert lives and one.x == BEYOND and one.crossings == [POINT]
    assert one.at.tolist() == [0.1, 0.0]
    assert way.steps == [(POINT - BRIDGE, BEYOND, False)]


@pytest.mark.parametrize(
    "solutions",
    [
        pytest.param([[NEAR, 0.0]], id="the only solution there"),
        pytest.param([[NEAR, 0.0], [FAR, 0.0]], id="one of two, the other far"),
        pytest.param([[NEAR, 0.0], [0.0, FAR], [1.0, 1.0]], id="one of three, the others far"),
    ],
)
def test_where_no_step_is_sure_the_one_solution_that_is_near_takes_the_branch_on_behind_the_point(solutions):
    one, lives, way = crossed(solutions)
    assert lives and one.x == BEYOND and one.crossings == [POINT]
    assert one.at.tolist() == [NEAR, 0.0]
    assert way.steps[-1] == (POINT - BRIDGE, BEYOND, True), "the loose step leads behind the point as well"


@pytest.mark.parametrize(
    "solutions",
    [
        pytest.param([], id="no solution"),
        pytest.param([[FAR, 0.0]], id="far away"),
        pytest.param([[NEAR, 0.0], [0.0, 1.1 * NEAR]], id="two that are as near"),
        pytest.param([[NEAR, 0.0], [0.0, 1.1 * NEAR], [1.0, 1.0]], id="two that are as near, of three"),
    ],
)
def test_a_branch_ends_at_the_point_where_none_or_several_could_be_it(solutions):
    one, lives, _ = crossed(solutions)
    assert not lives and one.end == POINT and not one.crossings and one.x == POINT - BRIDGE


def test_a_strand_is_read_at_the_point_where_a_solution_is_as_near_as_branches_that_have_met():
    one = strand()
    branches._read(Way({POINT: [[0.9, 0.0], [NEAR, 0.0]]}), one, POINT)
    assert one.end is None and one.q[-1].tolist() == [NEAR, 0.0]


@pytest.mark.parametrize(("away", "read"), [(0.9 * READING, True), (1.1 * READING, False)])
def test_else_it_is_pulled_onto_the_pose_and_ends_where_that_leads_too_far(away, read):
    one = strand()
    branches._read(Way({POINT: [[1.0, 0.0]]}, projected=[0.0, away]), one, POINT)
    assert (len(one.q) == 2) == read and one.end == (None if read else POINT)


def test_a_strand_that_cannot_be_pulled_onto_the_pose_ends():
    one = strand()
    branches._read(Way({}), one, POINT)
    assert one.end == POINT and len(one.q) == 1


def test_a_strand_leaves_a_continuum_by_its_nearest_solution_or_ends_on_it():
    near, lost = strand(POINT - 1.0), strand(POINT - 1.0)
    lost.at = np.array([2.0, 2.0])
    way = Way({POINT - 1 + BRIDGE: [[NEAR, 0.0], [1.0, 0.0]]})
    assert branches._leave_continuum(way, [near, lost], POINT) == [near]
    assert near.at.tolist() == [NEAR, 0.0] and near.x == POINT - 1 + BRIDGE and near.end is None
    assert lost.end == POINT - 1 and lost.x == POINT - 1.0
