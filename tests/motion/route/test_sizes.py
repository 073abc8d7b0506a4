"""Slides count by the arm's length: what is near, cheapest or missed is the same whatever the arm's size."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

import pieper
from pieper.motion.route.along_front import _cheapest
from pieper.motion.route.curves_at import _few_each
from pieper.motion.route.front import Ended
from pieper.motion.route.together import _whole
from pieper.motion.route.windows import misses_end

SIZES = (0.01, 1.0, 100.0)


def turn_and_slide(size):
    rows = [pieper.DH(d=0.3 * size, alpha=-np.pi / 2), pieper.DH(a=0.1 * size)]
    chain = pieper.Arm.from_dh(rows, convention="standard", joint_types="RP").chain
    return chain, np.array([1.0, chain.length])


@pytest.mark.parametrize("size", SIZES)
def test_what_goes_from_cell_to_cell_is_a_chain(size):
    """Three ways, one of them cut in two, rows in any order: an end, a middle and an end of each of the four."""
    chain, unit = turn_and_slide(size)
    ways = np.array([[0.0, 0.1], [1.5, 0.5], [-1.5, 0.9]]) + 0.02 * np.arange(9)[:, None, None]
    ways[5:, 2] += [0.0, 0.8]
    order = np.random.default_rng(8).permuted(np.tile(np.arange(3), (9, 1)), axis=1)
    x = np.take_along_axis(ways * unit, order[:, :, None], axis=1)
    few = _few_each(SimpleNamespace(chain=chain), x, np.ones((9, 3), bool)) / unit
    ends = [ways[k, way] for way, places in ((0, (0, 4, 8)), (1, (0, 4, 8)), (2, (0, 2, 4, 5, 7, 8))) for k in places]
    assert len(few) == len(ends)
    assert np.abs(few[:, None] - np.array(ends)).max(-1).min(0).max() < 1e-12


@pytest.mark.parametrize("largest", [False, True])
@pytest.mark.parametrize("size", SIZES)
def test_the_cheapest_chain_leads_over_the_points_themselves(size, largest):
    chain, unit = turn_and_slide(size)
    world = SimpleNamespace(chain=chain, weights=unit**-2.0, m=2, n=2)
    way = np.array([[3.0, 0.2], [3.2, 0.35], [-2.9, 0.5], [-2.7, 0.3]])
    far = way + [0.0, 0.7]
    stations = [np.array([a, b]) * unit for a, b in zip(way, far, strict=True)]
    stations[0] = stations[0][:1]
    x = _cheapest(SimpleNamespace(setting=world, largest=largest), stations, 0.5)
    assert np.abs(x / unit - (way + [[0, 0], [0, 0], [2 * np.pi, 0], [2 * np.pi, 0]])).max() < 1e-12
    assert _cheapest(SimpleNamespace(setting=world, largest=largest), stations, 0.1) is None


@pytest.mark.parametrize("size", SIZES)
def test_an_end_is_missed_by_a_slide_that_is_farther_off_than_a_point_stands_for(size):
    chain, unit = turn_and_slide(size)
    end = np.array([0.4, 0.7]) * unit
    task = SimpleNamespace(setting=SimpleNamespace(chain=chain), ends=(None, end))
    for within, missed in ((0.29, True), (0.31, False)):
        front = SimpleNamespace(
            q=(end + [0.0, 0.3 * unit[1]])[None], within=np.array([within]), s=1.0, ended=Ended.ARRIVED
        )
        assert misses_end(task, front) == missed


@pytest.mark.parametrize("size", SIZES)
def test_of_rows_with_other_virtual_joints_those_of_the_same_arm_are_taken(size):
    """The slide tells the rows apart: by 0.2 lengths of the arm, against a turn of the virtual joint by 1 rad."""
    rows = [pieper.DH(d=0.3 * size, alpha=-np.pi / 2), pieper.DH(a=0.1 * size), pieper.DH()]
    chain = pieper.Arm.from_dh(rows, convention="standard", joint_types="RPR").chain
    unit = chain.joints.unit[:2]
    setting = SimpleNamespace(n=2, m=3, chain=chain)
    q = np.array([[0.1, 0.4], [0.2, 0.5]]) * unit
    own = np.concatenate([q, [[1.0], [1.1]]], axis=1)
    other = own + np.array([0.0, 0.2 * unit[1], -1.0])
    rows = np.stack([other, own], axis=1)
    assert np.abs(_whole(setting, q, rows, np.ones((2, 2), bool)) - own).max() < 1e-12
