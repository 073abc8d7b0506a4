"""A front goes on past places where it loses its grip, and loses nothing that moves on there."""

import numpy as np
import pytest

import pieper
from benchmarks.measure.route_verdicts import drawn, judged
from pieper.motion.route.front import Ended, everything_at, follow
from pieper.motion.route.passed import follow_past, stretches

FREE = pieper.Freedom()
#: Between the first two points of this seam, at 0.9 of the way, what a pose leaves free crosses itself.
NAME, NUMBER = "kuka-kr16-2", 21
#: The same of the first three points.
BEFORE = 0.426


@pytest.fixture(scope="module")
def open_seam():
    arm, path = drawn(NAME, NUMBER)
    route = arm.route(path[:3], free=FREE)
    assert route.found
    return route


@pytest.mark.parametrize("fine", [1.0, 2.5])
def test_what_moves_past_such_a_place_is_among_what_is_reached_behind_it(open_seam, fine):
    world, k = open_seam.setting, 1
    window = BEFORE, float(open_seam.s[k])
    every = everything_at(world, world.limits, BEFORE)
    assert follow(world, world.limits, every, window, fine, 2_000_000).ended is Ended.SINGULAR
    front = follow_past(world, world.limits, every, window, fine, 2_000_000)
    assert front.ended is Ended.ARRIVED and front.begun == BEFORE and front.s == window[1]
    x = np.append(open_seam.q[k], -open_seam.turn[k])
    gap = np.linalg.norm((front.q - x) / world.chain.joints.unit, axis=1)
    assert (gap <= front.within + 1e-9).any()


def test_only_stretches_that_came_from_before_are_reached(open_seam):
    world = open_seam.setting
    behind = float(open_seam.s[1])
    every = everything_at(world, world.limits, behind)
    all_there = follow(world, world.limits, every, (behind, behind), 1.0, 2_000_000)
    # begun with one stretch before the place, only part of all there is behind it is reached
    before = everything_at(world, world.limits, BEFORE)
    first, _ = next(stretches(follow(world, world.limits, before, (BEFORE, BEFORE), 1.0, 2_000_000)))
    some = follow_past(world, world.limits, first, (BEFORE, behind), 1.0, 2_000_000)
    assert 0 < len(some.stretch) < len(all_there.stretch)


@pytest.mark.slow
@pytest.mark.parametrize("name, number", [(NAME, NUMBER), ("fanuc-lr-mate-200id", 19)])
def test_what_closes_behind_such_places_or_far_away_is_proved_and_a_flood_agrees(name, number):
    seen = judged(name, number)
    assert seen["verdict"] == "IMPOSSIBLE" and seen["wrong"] == ""
