"""Routes that something in the way closes: refused with proof where no posture of a pose keeps clear, at once."""

import numpy as np
import pytest

import pieper
from pieper.motion.route.nowhere import nothing_within_cone
from pieper.motion.route.setting import setting

DOWN = {"rpy": (180, 0, 0), "degrees": True}
IRB = pieper.load("abb-irb2400")
UR = pieper.load("universal-robots-ur5e")
SEAMS = {
    "irb": (IRB, pieper.line(*(pieper.pose(0.9, y, 0.9, **DOWN) for y in (-0.3, 0.3)), 8), [0.9, 0.0, 0.9], 0.1),
    "ur": (UR, pieper.line(*(pieper.pose(0.4, y, 0.3, **DOWN) for y in (-0.15, 0.15)), 8), [0.4, 0.0, 0.3], 0.05),
}
FREES = [None, pieper.Freedom(turn=(-0.2, 0.2)), pieper.Freedom()]


@pytest.mark.parametrize("free", FREES)
@pytest.mark.parametrize("name", SEAMS)
def test_what_stands_on_the_path_closes_it_with_proof(name, free):
    arm, path, at, size = SEAMS[name]
    scene = pieper.Scene([pieper.Box(at, [size] * 3)])
    route = arm.route(path, free=free, scene=scene, clearance=0.01)
    assert route.verdict is pieper.Verdict.IMPOSSIBLE, route.explain()
    assert "box" in route.blocked.why and route.blocked.s[0] == route.blocked.s[1]
    # every turn anew, the solver's rows at each: none keeps the clearance
    turns = np.linspace(-np.pi, np.pi, 1440) if free and free.turn == "free" else np.linspace(-0.2, 0.2, 41)
    turns = turns if free else np.zeros(1)
    pose = path[int(round(route.blocked.s[0] * (len(path) - 1)))]
    _, q = arm.ik_many(pieper.Freedom().turned(pose, turns)).rows()
    assert len(q) and (np.asarray(arm.distance(q, scene)) < 0.01).all()


@pytest.mark.parametrize("free", FREES)
@pytest.mark.parametrize("name", SEAMS)
def test_what_stands_beside_the_path_does_not(name, free):
    arm, path, at, size = SEAMS[name]
    scene = pieper.Scene([pieper.Box([at[0], at[1], at[2] - 0.15 - size], [size] * 3)])
    route = arm.route(path, free=free, scene=scene, clearance=0.01)
    assert route.found, route.explain()
    assert (np.asarray(arm.distance(route.q, scene)) >= 0.01).all()


def test_a_turn_that_keeps_clear_is_not_denied():
    """A plate beside the tool leaves some turns clear: what is proved for the others may not be told of all."""
    arm, path, at, _ = SEAMS["irb"]
    clear = 0
    for x in np.linspace(0.05, 0.5, 10):
        scene = pieper.Scene([pieper.Box([at[0] + x, 0.0, at[2] + 0.3], [0.02, 0.5, 0.3])])
        route = arm.route(path, free=pieper.Freedom(), scene=scene)
        pose = path[len(path) // 2]
        _, q = arm.ik_many(pieper.Freedom().turned(pose, np.linspace(-np.pi, np.pi, 720))).rows()
        q = q[((q >= arm.limits[:, 0]) & (q <= arm.limits[:, 1])).all(1)]
        if (np.asarray(arm.distance(q, scene)) > 0).any() and route.verdict is pieper.Verdict.IMPOSSIBLE:
            assert abs(route.blocked.s[0] - (len(path) // 2) / (len(path) - 1)) > 1e-9
        clear += route.found
    assert clear


def test_the_way_out_of_a_closed_pose_is_sought_when_asked_for():
    arm, path, at, size = SEAMS["irb"]
    scene = pieper.Scene([pieper.Box(at, [size] * 3)])
    route = arm.route(path, free=pieper.Freedom(), scene=scene)
    for cure in route.blocked.relaxations:
        assert cure.kind == "shift" and cure.amount > 0


@pytest.mark.parametrize("turn", [(0.0, 0.0), (-0.1, 0.1)])
def test_what_stands_on_the_path_closes_it_within_a_cone_too(turn):
    arm, path, at, size = SEAMS["irb"]
    scene = pieper.Scene([pieper.Box(at, [size] * 3)])
    free = pieper.Freedom(turn=turn, cone=0.1)
    route = arm.route(path, free=free, scene=scene, clearance=0.01)
    assert route.verdict is pieper.Verdict.IMPOSSIBLE and "boxes of joint values" in route.reason
    assert "box" in route.blocked.why
    pose = path[int(round(route.blocked.s[0] * (len(path) - 1)))]
    rng = np.random.default_rng(3)
    leans = [pieper.pose(0, 0, 0, rotvec=(*(0.07 * rng.uniform(-1, 1, 2)), rng.uniform(*turn))) for _ in range(500)]
    _, q = arm.ik_many(pose @ np.stack(leans)).rows()
    assert len(q) and (np.asarray(arm.distance(q, scene)) < 0.01).all()


def test_a_posture_that_keeps_clear_within_a_cone_is_never_denied():
    arm, _, _, _ = SEAMS["irb"]
    rng, tried = np.random.default_rng(4), 0
    scene = pieper.Scene([pieper.Box([0.9, 0.1, 0.7], [0.2] * 3)])
    while tried < 6:
        q = rng.uniform(*np.clip(arm.limits, -2.0, 2.0).T)
        room = float(np.asarray(arm.distance(q, scene)))
        if not 0.0 < room < 0.2:
            continue
        tried += 1
        few = arm.with_limits({n: (v - 0.02, v + 0.02) for n, v in zip(arm.joint_names, q, strict=True)})
        T = arm.fk(q) @ pieper.pose(0, 0, 0, rotvec=(0.05, 0.03, 0.0))
        free = pieper.Freedom(cone=0.1)
        world = setting(*few._plans_of(free), free, np.stack([T, T]), np.array([0.0, 1.0]))
        kept, missed = few._keep(room - 1e-6, 0.0, scene), few._keep(room + 0.5, 0.0, scene)
        assert nothing_within_cone(world, T, 20_000, kept) is None
        assert nothing_within_cone(world, T, 60_000, missed) is not None
