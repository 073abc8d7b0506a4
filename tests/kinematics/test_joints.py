"""The joint metric: the short way round, whole turns inside limits, slides per length."""

from __future__ import annotations

import itertools

import numpy as np

from pieper.kinematics.joints import TURN, JointSpace, inside, short_way, turned_from, wrapped
from pieper.kinematics.whole_turns import WholeTurns

SPACE = JointSpace(np.array([False, True, False]), 0.5)


def test_half_a_turn_has_one_sign_each_way_of_wrapping():
    assert short_way(np.pi) == -np.pi and wrapped(-np.pi) == np.pi
    assert np.allclose(short_way(np.array([3 * np.pi / 2, -0.1 - TURN])), [-np.pi / 2, -0.1])


def test_an_angle_is_put_into_the_turn_that_begins_anywhere():
    start, angle = np.array([0.5, -7.0, 20.0]), np.random.default_rng(0).uniform(-30, 30, (50, 3))
    found = turned_from(start, angle)
    assert (found >= start).all() and (found < start + TURN).all()
    assert np.abs((found - angle) / TURN - np.round((found - angle) / TURN)).max() < 1e-12


def test_a_slide_counts_per_length_and_is_never_wrapped():
    a, b = np.array([np.pi - 0.1, 9.0, 0.2]), np.array([-np.pi + 0.1, 1.0, 0.2])
    assert np.allclose(SPACE.difference(a, b), [-0.2, 16.0, 0.0])
    assert np.allclose(SPACE.way(a, b), [-0.2, 8.0, 0.0])
    assert np.isclose(SPACE.apart(a, b), 16.0)


def test_distance_counts_whole_turns():
    assert np.isclose(SPACE.straight(np.array([TURN, 0.3, 0.0]), np.zeros(3)), np.hypot(TURN, 0.6))


def test_turns_go_as_near_as_the_limits_allow():
    limits = np.array([[-np.pi, np.pi], [0.0, 1.0], [-3 * np.pi, 3 * np.pi]])
    q, near = np.array([3.0, 0.5, 3.0]), np.array([-3.0 - TURN, 5.0, -3.0])
    assert np.allclose(SPACE.unwound(q, near, limits), [3.0, 0.5, 3.0 - TURN])


def test_a_value_outside_its_limits_is_moved_only_where_that_helps():
    limits = np.array([[4.0, 7.0], [0.0, 1.0], [-1.0, 1.0]])
    q, ok = SPACE.inside_limits(np.array([[0.0, 0.5, 0.0], [0.0, 2.0, 2.0]]), limits)
    assert list(ok) == [True, False] and np.allclose(q, [[TURN, 0.5, 0.0], [TURN, 2.0, 2.0]])
    assert list(inside(np.array([4.0 - 1e-12, 1.1, 0.0]), limits)) == [True, False, True]


def test_the_first_of_each_cluster_stays():
    q = np.array([[0.0, 0.0, np.pi], [0.0, 0.0, -np.pi], [0.0, 1e-9, 0.0], [0.0, 0.1, 0.0]])
    assert list(SPACE.distinct(q, 1e-6)) == [0, 2, 3]
    assert list(SPACE.without_repeats(q[None], np.ones((1, 4), bool), 1e-6)[0]) == [True, False, True, True]


def test_whole_turns_of_joints_without_limits_are_the_nearest_of_all():
    """Against every move of nine turns; six tied joints took gigabytes where each was looked at as far as eight."""
    rng = np.random.default_rng(0)
    for _ in range(60):
        n = int(rng.integers(1, 4))
        C = np.diag(rng.choice([1, 1.001, 0.5, 2, -1], n)) + np.tril(rng.choice([0, 0.3, -0.5, 1, 0.002], (n, n)), -1)
        weight, turns = rng.uniform(0.2, 3, n), WholeTurns(C, np.zeros(n, bool))
        q, near = rng.uniform(-9, 9, (2, 20, n))
        found = turns.nearest(q, near, np.tile([-np.inf, np.inf], (n, 1)), weight)
        moves = TURN * np.array(list(itertools.product(range(-9, 10), repeat=n))) @ turns.inverse.T
        best = (weight * (q[:, None] + moves - near[:, None]) ** 2).sum(-1).min(1)
        assert ((weight * (found - near) ** 2).sum(-1) <= best + 1e-9).all()
        whole = turns.axes(found - q) / TURN
        assert np.abs(whole - np.round(whole)).max() < 1e-9
    C = 1.001 * np.eye(6) + np.tril(np.full((6, 6), 2e-3), -1)
    turns = WholeTurns(C, np.zeros(6, bool))
    q, near = rng.uniform(-3, 3, (2, 80, 6))
    found = turns.nearest(q, near, np.tile([-np.inf, np.inf], (6, 1)), np.ones(6))
    assert np.abs(found - near).max() < 1.1 * np.pi


def test_whole_turns_outside_limits_are_those_that_are_outside_least():
    rng = np.random.default_rng(0)
    for case in range(300):
        slides, coupling = rng.uniform(size=4) < 0.25, np.eye(4)
        for _ in range(2 * (case % 2)):
            i, j = sorted(rng.choice(4, 2, replace=False))
            coupling[j, i] = rng.choice([-1, 0.5, 1, 0.003, -0.25])
        middle, half = rng.uniform(-9, 9, 4), rng.uniform(0.05, 2.5, 4)
        limits = np.c_[middle - half, middle + half]
        limits = np.where(rng.uniform(size=(4, 2)) < 0.1, [-np.inf, np.inf], limits)
        turns = WholeTurns(coupling, slides)
        q = rng.uniform(-3, 3, 4)
        over = np.maximum(JointSpace(slides, 1.0, turns if case % 2 else None).least_over(q[None], limits)[0], 0.0)
        turning = np.flatnonzero(~slides)
        counts = np.array(list(itertools.product(*[range(-5, 6)] * len(turning))), float)
        tried = q + TURN * counts @ turns.inverse[:, turning].T
        beyond = np.maximum(np.maximum(limits[:, 0] - tried, tried - limits[:, 1]), 0.0)
        for block in turns.blocks if case % 2 else np.arange(4)[:, None]:
            parts = [block[~slides[block]], block[slides[block]]]
            first, second = (beyond[:, part].max(1, initial=0.0) for part in parts)
            best = np.lexsort((second, np.round(first, 9)))[0]
            own = [over[part].max(initial=0.0) for part in parts]
            # five turns each way are not all there are
            assert own[0] <= first[best] + 1e-9, case
            assert own[0] < first[best] - 1e-9 or own[1] <= second[best] + 1e-9, case
