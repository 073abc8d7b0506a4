"""A tool that may lean within a cone: its route is at rest, along the cone's edge too."""

import numpy as np
import pytest

import pieper
from benchmarks.measure.route_verdicts import drawn
from pieper.kinematics.newton import scaled_jacobian
from pieper.motion.route.search import cost_of

CONE = 0.2


@pytest.mark.parametrize(
    "name, number", [("abb-irb2400", 2), ("fanuc-m-10ia", 1), ("universal-robots-ur5e", 4), ("denso-vs060", 2)]
)
def test_no_small_change_inside_the_cone_makes_a_route_cheaper(name, number):
    arm, path = drawn(name, number)
    route = arm.route(path, free=pieper.Freedom(cone=CONE))
    assert route.found and route.slope < 1e-8
    world, rng = route.setting, np.random.default_rng(number)
    x = route.others.x
    low, high = world.limits.T
    cost = cost_of(world, x, False)
    assert abs(cost - route.cost) < 1e-9
    edge = world.inside_cone(x) < 1e-9
    assert edge.any() and route.tilt.max() <= CONE
    free = np.swapaxes(np.linalg.svd(scaled_jacobian(world.chain, x))[2][:, world.m - world.spare :], 1, 2)
    tried = 0
    for _ in range(60):
        # changes of a few neighbours and of all; no point on the edge leaves the cone
        wave = np.interp(np.arange(len(x)), np.sort(rng.uniform(0, len(x) - 1, 4)), rng.normal(size=4))
        step = np.einsum("kma,a->km", free, rng.normal(size=free.shape[2])) * wave[:, None]
        out = np.sin(x[:, -2]) * np.cos(x[:, -1]) * step[:, -2] + np.cos(x[:, -2]) * np.sin(x[:, -1]) * step[:, -1]
        step *= np.where(edge & (out > 0), -1.0, 1.0)[:, None]
        moved, on = world.on(x + 1e-4 * step / np.abs(step).max(), world.path)
        inside = (world.inside_cone(moved) >= 0).all() and ((moved > low) & (moved < high)).all()
        if on.all() and inside:
            tried += 1
            assert cost_of(world, moved, False) >= cost * (1 - 1e-9)
    assert tried >= 15
