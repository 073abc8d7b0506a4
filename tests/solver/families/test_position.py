"""Three joints that place a point, and three that turn a body, as kernels of their own."""

from __future__ import annotations

import numpy as np
import pytest

from oracle.joints import difference
from pieper.kinematics.chain import Chain
from pieper.kinematics.forward import fk
from pieper.kinematics.pose import rotation_x, rotation_z, translation
from pieper.solver.families import position

QUARTER = np.pi / 2


def _dh(*rows) -> Chain:
    """Standard DH rows (a, alpha, d), all revolute."""
    links = [np.eye(4)] + [translation(a, 0.0, d) @ rotation_x(alpha) for a, alpha, d in rows]
    return Chain.of(np.array(links), np.zeros(len(rows), bool))


def _solver(spec, chain):
    return spec.solver(np.tile([-np.inf, np.inf], (3, 1)), chain.prismatic)


def test_the_3r_arm_has_the_four_solutions_of_its_paper_not_eight():
    # problem 4 of Seed 002 (l1 = 0.5, l2 = 0.8), its example point and every solution, in degrees
    chain = _dh((0.0, QUARTER, 0.0), (0.0, QUARTER, -0.5), (0.8, 0.0, 0.0))
    expected = np.radians(
        [
            [17.188733854, 40.107045659, -22.918311805],
            [17.188733854, -139.892954341, -157.081688195],
            [-52.367624151, 139.892954341, -22.918311805],
            [-52.367624151, -40.107045659, -157.081688195],
        ]
    )
    T = fk(chain, expected[0])
    np.testing.assert_allclose(T[:3, 3], [0.2985769989033322, 0.9418359086134053, 0.47469102668910995], atol=1e-9)
    q, _, _, _ = _solver(position.prepare(chain, position.match(chain, None)), chain).one(np.ascontiguousarray(T))
    assert len(q) == 4
    assert all(difference(chain, expected, row).min() < 1e-9 for row in q)


@pytest.mark.parametrize("types", ["RRR", "RRP", "RPR", "PRR", "RPP", "PRP", "PPR", "PPP"])
def test_a_point_is_reached_by_the_joints_that_placed_it(types):
    rng = np.random.default_rng(len(types) + sum(map(ord, types)))
    for _ in range(5):
        links = [rotation_z(a) @ translation(*t) @ rotation_x(b) for a, b, *t in rng.uniform(-1, 1, (4, 5))]
        chain = Chain.of(np.array(links), np.array([t == "P" for t in types]))
        solver = _solver(position.prepare(chain, position.match(chain, None)), chain)
        Q = rng.uniform(-1, 1, (200, 3)) * np.where(chain.prismatic, 0.6, np.pi)
        q, valid, _, _ = solver.many(fk(chain, Q), 1)
        assert (np.where(valid, difference(chain, q, Q[:, None]), np.inf).min(1) < 1e-6).all()
        misses = fk(chain, q[valid])[:, :3, 3] - np.repeat(fk(chain, Q)[:, None, :3, 3], 4, 1)[valid]
        assert np.abs(misses).max() < 1e-11


def test_three_meeting_axes_turn_a_body_in_two_ways():
    rng = np.random.default_rng(1)
    links = [rotation_z(a) @ rotation_x(b) for a, b in rng.uniform(0.5, 1.5, (4, 2))]
    chain = Chain.of(np.array(links), np.zeros(3, bool))
    Q = rng.uniform(-np.pi, np.pi, (300, 3))
    q, valid, _, _ = _solver(position.prepare_orientation(chain), chain).many(fk(chain, Q), 1)
    assert valid.all()
    assert (difference(chain, q, Q[:, None]).min(1) < 1e-6).all()
