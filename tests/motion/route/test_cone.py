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


@pytest.mark.slow
def test_a_passage_between_narrow_limits_and_the_edge_of_a_cone_is_found():
    # no ladder leads through: found first by a search of another kind, 500 particles that drift along the line
    tool = np.eye(4)
    tool[:3] = [
        [0.8688584470239011, -0.4910393339547414, -0.06297119614949834, -0.01005533726865608],
        [0.4946273589730348, 0.8663670602634356, 0.06893397308913173, 0.14416934752985347],
        [0.02070687785677171, -0.09104114124820968, 0.9956318274390631, 0.04000694090983883],
    ]
    low = [-1.2638573302263183, -0.9948276812206265, 1.270107153018563, 1.2222972566934833]
    low += [0.18131426432640863, -1.082272819823891]
    high = [-0.323625190879232, -0.49973514747812864, 1.8599833716911056, 2.009859980425972]
    high += [0.8423440093744997, -0.46635134345276286]
    arm = pieper.load("ur5e").with_tool(tool)
    arm = arm.with_limits(dict(zip(arm.joint_names, zip(low, high, strict=True), strict=True)))
    ends = np.tile(np.eye(4), (2, 1, 1))
    ends[0, :3] = [
        [-0.6785708862220328, -0.6133062185647283, -0.404223990680512, -0.6329693655914344],
        [-0.01120563365827177, 0.5588921781533067, -0.8291646199479143, 0.2145339892801257],
        [0.7344494442411686, -0.5581173850265609, -0.38612044543762786, 0.16590415727406174],
    ]
    ends[1, :3] = [
        [-0.5421352811354102, -0.8020850146790851, -0.2504974374629041, -0.7221737851300865],
        [-0.22097613848674338, 0.42370133187771525, -0.8784342477297535, 0.24591818481063416],
        [0.8107150443699176, -0.42087624142056557, -0.4069450899568399, 0.21845693218101347],
    ]
    cone = 0.28850345842843556
    path = pieper.line(ends[0], ends[1], 15)
    route = arm.route(path, free=pieper.Freedom(cone=cone))
    assert route.found
    poses = arm.fk(route.q)
    assert np.abs(poses[:, :3, 3] - path[:, :3, 3]).max() < 1e-9
    assert np.arccos((poses[:, :3, 2] * path[:, :3, 2]).sum(1)).max() <= cone + 1e-9
    assert (route.q >= np.array(low) - 1e-9).all() and (route.q <= np.array(high) + 1e-9).all()
