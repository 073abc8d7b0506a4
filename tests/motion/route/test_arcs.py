"""Arcs: exact intervals of the turn; what ends them; together they are all turns that are open."""

import numpy as np
import pytest

import pieper
from oracle.turns import ring
from pieper.kinematics.pose import rotation_z


def measure(arm, T, turns):
    """Return how much of the turn is open, every branch and every set of whole turns counted, by sampling."""
    low, high = arm.limits.T
    many = arm.ik_many(T @ rotation_z(turns))
    count = np.floor((high - many.q) / (2 * np.pi)) - np.ceil((low - many.q) / (2 * np.pi)) + 1
    return float((np.prod(np.maximum(count, 0), -1) * many.valid).sum() * (turns[1] - turns[0]))


@pytest.mark.parametrize("index", [0, 17, 30])
def test_arcs_are_all_turns_that_are_open(irb, seam, index):
    turns = np.linspace(0, 2 * np.pi, 20000, endpoint=False)
    total = sum(arc.hi - arc.lo for arc in irb.arcs(seam[index]))
    assert total == pytest.approx(measure(irb, seam[index], turns), abs=2e-2)


def test_arcs_end_where_a_joint_stands_at_its_limit(irb, seam):
    for arc in irb.arcs(seam[5]):
        assert arc.lo < arc.hi
        for q, end in zip((arc.q[0], arc.q[-1]), arc.ends, strict=True):
            if end.kind == "limit":
                assert q[irb.joint_names.index(end.joint)] == pytest.approx(end.value, abs=1e-8)
        np.testing.assert_allclose(irb.fk(arc.q), seam[5] @ rotation_z(arc.turn), atol=1e-8)
        assert ((arc.q >= irb.limits[:, 0] - 1e-8) & (arc.q <= irb.limits[:, 1] + 1e-8)).all()


def test_an_interval_of_the_turn_ends_arcs_too(irb, seam):
    arcs = irb.arcs(seam[5], pieper.Freedom(turn=(-1.0, 1.0)))
    assert all(-1.0 - 1e-9 <= arc.lo and arc.hi <= 1.0 + 1e-9 for arc in arcs)
    assert "interval" in {end.kind for arc in arcs for end in arc.ends}


def test_folds_are_where_the_arm_is_singular(ur):
    T = ring(8, (0.9, 0.0, 0.3), 0.25)[2]
    seen = 0
    for arc in ur.arcs(T):
        # a closed curve that begins at a fold is followed as closely past its own beginning
        assert np.abs(np.diff(arc.q, axis=0)).max() < 0.3
        for q, end in zip((arc.q[0], arc.q[-1]), arc.ends, strict=True):
            if end.kind == "fold":
                seen += 1
                s = np.linalg.svd(ur.jacobian(q), compute_uv=False)
                assert s[-1] < 1e-3
    assert seen > 20
    total = sum(arc.hi - arc.lo for arc in ur.arcs(T))
    assert total == pytest.approx(measure(ur, T, np.linspace(0, 2 * np.pi, 20000, endpoint=False)), rel=1e-3)


def test_arcs_need_one_coordinate(irb, seam):
    with pytest.raises(pieper.InputError, match="cone"):
        irb.arcs(seam[0], pieper.Freedom(cone=0.1))
    with pytest.raises(pieper.PlanError, match="nothing is left to choose; say a turn"):
        irb.arcs(seam[0], pieper.Freedom(turn=(0.0, 0.0)))
