"""Routes of arms with fewer than six joints: found or refused with proof, as their own formulas say."""

import numpy as np
import pytest

import pieper
from oracle.planar import reached

LINKS = (0.4, 0.35, 0.1)
LIMITS = [(-2.0, 2.0), (-2.2, 2.2), (-1.5, 1.5)]
PLANAR = pieper.Arm.from_dh([pieper.DH(a, 0, 0, 0) for a in LINKS], convention="standard", limits=LIMITS)
FREE = pieper.Freedom()


@pytest.mark.parametrize("number", range(12))
def test_a_planar_arm_is_refused_where_no_heading_leads_on(number):
    rng = np.random.default_rng([5, number])
    ends = [PLANAR.fk(rng.uniform(*PLANAR.limits.T)) for _ in range(2)]
    if number % 3 == 0:
        ends[1][:2, 3] *= 1.1 * sum(LINKS) / np.linalg.norm(ends[1][:2, 3])
    route = PLANAR.route(pieper.line(*ends, 16), free=FREE)
    points = pieper.line(*ends, 200)[:, :2, 3]
    last = reached(points, LINKS, PLANAR.limits)
    assert route.verdict is not pieper.Verdict.UNCERTAIN
    assert route.found == (last == 199)
    if not route.found:
        # the place told is the one where the flood ends, as nearly as stations stand
        assert route.blocked.s[0] - 0.02 < last / 199 < route.blocked.s[1] + 0.01


@pytest.mark.parametrize("free", [None, FREE, pieper.Freedom(turn=(-0.5, 0.5))])
@pytest.mark.parametrize("name", ["adept-cobra-600", "doosan-p3020"])
def test_a_pose_out_of_reach_of_a_short_arm_is_told_where_it_is(name, free):
    arm = pieper.load(name)
    near = arm.fk(np.clip(np.full(arm.n, 0.3), *(0.9 * arm.limits.T)))
    far = near.copy()
    far[0, 3] += 5.0
    route = arm.route(pieper.line(near, far, 30), free=free)
    assert route.verdict is pieper.Verdict.IMPOSSIBLE
    assert "out of reach" in route.blocked.why
    assert route.blocked.s[1] < 0.3
