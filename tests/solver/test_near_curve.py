"""Curves that hold a pose but for one direction: near a straight wrist both turns of the wrist lie along one."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from oracle.joints import turns_apart
from pieper.kinematics.newton import pose_difference, scaled_jacobian
from pieper.solver.singular.near_curve import NearCurve, follow, hiding, onto

ARMS = {"denso-vp6242": [0.3, 0.4, 1.2, 0.5, 0.0, -0.7], "stanford-arm": [0.3, 0.8, 0.4, 0.5, 0.0, -0.7]}
CASES = [(name, bent) for name in ARMS for bent in (5e-5, -1e-4, 1e-6)]


def case(name, bent):
    arm = pieper.load(name)
    q = np.array(ARMS[name])
    q[4] = bent
    return arm.chain, q, arm.fk(q)


@pytest.mark.parametrize(("name", "bent"), CASES)
def test_a_point_brought_onto_the_curve_misses_along_the_weakest_direction_alone(name, bent):
    chain, q, T = case(name, bent)
    aside = q + np.random.default_rng(1).uniform(-1e-3, 1e-3, (5, 6))
    points = onto(chain, aside, T, 6)
    for k in range(5):
        U, s, Vt = np.linalg.svd(scaled_jacobian(chain, points.q[k]))
        assert np.isclose(points.sigma[k], s[5] / s[0], atol=1e-12)
        assert np.abs(points.null[k] @ Vt[5]) > 1 - 1e-9 and np.abs(points.left[k] @ U[:, 5]) > 1 - 1e-9
        e = pose_difference(chain, points.q[k], T)
        assert np.isclose(points.miss[k], e @ points.left[k], atol=1e-14)
        assert np.linalg.norm(e - points.miss[k] * points.left[k]) == pytest.approx(points.rest[k], abs=1e-14)
        assert points.rest[k] < 1e-10


@pytest.mark.parametrize(("name", "bent"), CASES)
@pytest.mark.parametrize("along", [0.0, 0.7])
def test_the_curve_comes_home_in_even_steps_and_both_turns_of_the_wrist_hide_on_it(name, bent, along):
    chain, q, T = case(name, bent)
    start = q.copy()
    start[[3, 5]] += along, -along
    curve = follow(chain, start, T)
    steps = np.linalg.norm(np.diff(curve.q, axis=0) / chain.joints.unit, axis=1)
    assert curve.closed and steps.max() < 0.25 and len(curve.q) < 80
    assert (np.einsum("ki,ki->k", curve.left[1:], curve.left[:-1]) > 0.9).all(), "what is missed keeps its sense"
    # home again: up to whole turns, and each wrist axis once round
    assert turns_apart(curve.q[-1], curve.q[0]).max() < 1e-12
    assert abs(abs(curve.q[-1, 3] - curve.q[0, 3]) - 2 * np.pi) < 1e-9
    error = pose_difference(chain, curve.q, T)
    assert np.linalg.norm(error - curve.miss[:, None] * curve.left, axis=1).max() < 1e-9
    found = hiding(chain, T, curve)
    other = q + [0, 0, 0, np.pi, -2 * bent, np.pi]
    for wanted in (q, other):
        assert turns_apart(found, wanted).max(1).min() < 1e-5
    assert np.linalg.norm(pose_difference(chain, found, T), axis=1).max() < 1e-9


@pytest.mark.parametrize("along", [0.03, 0.05, 0.08, -0.05, -0.08, -0.12])
def test_two_solutions_between_neighbouring_samples_are_found_by_their_smallest_value(along):
    chain, q, T = case("denso-vp6242", 2e-3)
    curve = follow(chain, q + [0, 0, 0, along, 0, -along], T)
    # told with one sign, as on a curve that is missed twice between two samples: the smallest value is looked at
    size = np.abs(curve.miss)
    least = 1 + int(np.argmin(size[1:-1]))
    some = [least - 1, least, least + 1]
    found = hiding(chain, T, NearCurve(curve.q[some], size[some], curve.left[some], False))
    twin = q + [0, 0, 0, np.pi, -4e-3, np.pi]
    assert min(turns_apart(found, wanted).max(1).min() for wanted in (q, twin)) < 0.03


def test_a_curve_of_one_or_two_points_is_given_back():
    chain, q, T = case("denso-vp6242", 2e-3)
    curve = follow(chain, q, T)
    short = NearCurve(curve.q[:2], curve.miss[:2], curve.left[:2], False)
    assert (hiding(chain, T, short) == short.q).all()
