"""Cuspidal arms are found by an example that holds; arms that cannot be cuspidal are never called so."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from oracle.joints import turns_apart
from pieper.kinematics.newton import determinant
from pieper.solver.plan import cuspidal


def test_an_arm_with_a_wrist_and_parallel_axes_is_never_called_cuspidal():
    assert not pieper.load("denso-vp6242").plan.cuspidal.found


def test_a_search_that_finds_no_path_has_none_to_show():
    arm = pieper.load("denso-vp6242")
    found = cuspidal.search(arm.chain, lambda T: arm.plan.solver.many(T, 1)[:2], poses=1)
    assert not found.found and found.tried and found.path.shape == (0, 6)


def test_the_path_of_a_cuspidal_arm_joins_two_solutions_and_meets_no_singularity():
    arm = pieper.load("fanuc-crx-10ia")
    found = arm.plan.cuspidal
    assert found.found
    ends = arm.fk(found.path[[0, -1]])
    np.testing.assert_allclose(ends[0], ends[1], atol=1e-9)
    gap = turns_apart(found.path[0], found.path[-1]).max()
    assert gap > 1e-2
    # looked at anew, two hundred times as finely
    t = np.linspace(0, len(found.path) - 1, 200 * len(found.path))
    fine = np.stack([np.interp(t, np.arange(len(found.path)), column) for column in found.path.T], 1)
    assert len(set(np.sign(determinant(arm.chain, fine)))) == 1


@pytest.mark.parametrize("backward", [False, True])
@pytest.mark.parametrize(("ratio", "taken"), [(1.4, True), (1.8, False)])
def test_a_determinant_that_jumps_between_two_points_might_have_been_zero_there(monkeypatch, backward, ratio, taken):
    """It falls gently and then grows to `ratio` times as much in one step; walked backward it falls in one."""

    def fake(chain, path):
        values = np.ones(path.shape[:-1])
        if path.shape[-2] > cuspidal.POINTS:
            low = 0.1 * ratio
            half = path.shape[-2] // 2
            values = np.concatenate([np.geomspace(1.0, 0.1, half), np.full(path.shape[-2] - half, low)])
            values = values[::-1] if backward else values
        return values

    monkeypatch.setattr(cuspidal, "determinant", fake)
    chain = pieper.load("fanuc-crx-10ia").chain
    found = cuspidal._connect(chain, np.zeros(6), np.full(6, 0.4), 1.0, 1.0, np.random.default_rng(0))
    assert (found is not None) == taken
