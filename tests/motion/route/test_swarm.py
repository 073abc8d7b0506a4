"""Short arms within a cone: told ends, a turn rate and a clearance are kept, as a search over all leans says."""

import numpy as np
import pytest

import pieper
from pieper.motion.route.swarm import search_by_swarm

ARM = pieper.load("robotis-openmanipulator-x")
CONE = 0.15
FREE = pieper.Freedom(axis="y", cone=CONE)


def drawn(number):
    """Return the first and the last posture of a line, and its poses."""
    rng = np.random.default_rng([number, 5])
    low, high = np.clip(ARM.limits, -2.5, 2.5).T
    q = rng.uniform(low + 0.25 * (high - low), high - 0.25 * (high - low))
    end = q + rng.uniform(-0.15, 0.15, ARM.n)
    return q, end, pieper.line(ARM.fk(q), ARM.fk(end), 12)


def every_lean(path, pitches):
    """Return all postures of an arm that leans in the plane of its first joint alone, and their turns, point by point.

    The point tells the first joint; of the orientations about it those that are within the cone are solved.
    """
    y = FREE.to_z[:3, :3]
    out = []
    for T in path:
        pan = np.arctan2(T[1, 3], T[0, 3])
        poses = np.tile(np.eye(4), (len(pitches), 1, 1))
        for pose, pitch in zip(poses, pitches, strict=True):
            c, s = np.cos(pan), np.sin(pan)
            pose[:3, :3] = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ [
                [np.cos(pitch), 0, np.sin(pitch)],
                [0, 1, 0],
                [-np.sin(pitch), 0, np.cos(pitch)],
            ]
        poses[:, :3, 3] = T[:3, 3]
        many = ARM.ik_many(poses)
        k, row = np.nonzero(many.in_limits)
        q = many.q[k, row]
        D = y.T @ T[:3, :3].T @ ARM.fk(q)[:, :3, :3] @ y
        inside = D[:, 2, 2] >= np.cos(CONE)
        out.append((q[inside], np.arctan2(-D[inside, 0, 1], D[inside, 0, 0])))
    return out


def cheapest(path, ends, rate, scene, clearance):
    """Return the least cost over a grid of leans that keeps all that is asked, infinite where nothing does."""
    rows = every_lean(path, np.linspace(-np.pi, np.pi, 721))
    way = np.linalg.norm(np.diff(path[:, :3, 3], axis=0), axis=1)
    cost = last = turn = None
    for k, (q, now) in enumerate(rows):
        if k in (0, len(rows) - 1) and ends[k > 0] is not None:
            q, now = ends[k > 0][None], np.zeros(1)  # they hold their poses as these are
        if scene is not None and len(q):
            clear = np.asarray(ARM.distance(q, scene)) >= clearance
            q, now = q[clear], now[clear]
        if not len(q):
            return np.inf
        if k == 0:
            cost = np.zeros(len(q))
        else:
            step = q[:, None] - last[None]
            far = np.abs(step).max(-1) > 0.3
            if rate is not None:
                far |= np.abs(now[:, None] - turn[None]) > rate * way[k - 1]
            cost = np.where(far, np.inf, (step**2).sum(-1) + cost).min(1)
        last, turn = q, now
    return float(cost.min())


@pytest.mark.parametrize("told", ["neither", "start", "end", "both"])
@pytest.mark.parametrize("rate", [None, 1.5])
@pytest.mark.parametrize("number", [0, pytest.param(1, marks=pytest.mark.slow)])
def test_ends_and_turn_rates_are_kept_and_no_lean_on_a_grid_is_much_cheaper(number, rate, told):
    q, end, path = drawn(number)
    ends = (q if told in ("start", "both") else None, end if told in ("end", "both") else None)
    route = ARM.route(path, free=FREE, start=ends[0], end=ends[1], turn_rate=rate)
    assert route.found, route.explain()
    assert np.abs(ARM.fk(route.q)[:, :3, 3] - path[:, :3, 3]).max() < 1e-9 and route.tilt.max() <= CONE + 1e-9
    for at, posture in zip((0, -1), ends, strict=True):
        assert posture is None or np.abs(route.q[at] - posture).max() < 1e-7
    if rate is not None:
        way = np.linalg.norm(np.diff(path[:, :3, 3], axis=0), axis=1)
        assert (np.abs(np.diff(route.turn)) <= rate * way + 1e-9).all()
    assert route.cost <= 1.02 * cheapest(path, ends, rate, None, 0.0)


@pytest.mark.parametrize("told", ["neither", "both"])
def test_a_clearance_is_kept(told):
    q, end, path = drawn(0)
    ends = (q, end) if told == "both" else (None, None)
    plain = ARM.route(path, free=FREE, start=ends[0], end=ends[1])
    kept = 0
    for z in (0.3, 0.06):
        scene = pieper.Scene([pieper.Box(path[6, :3, 3] + [0.0, 0.0, z], [0.08, 0.08, 0.02])])
        clearance = float(np.min(np.asarray(ARM.distance(plain.q, scene)))) + 2e-4
        if any(p is not None and float(np.asarray(ARM.distance(p, scene))) < clearance for p in ends):
            continue
        route = ARM.route(path, free=FREE, start=ends[0], end=ends[1], scene=scene, clearance=max(clearance, 0.0))
        least = cheapest(path, ends, None, scene, max(clearance, 0.0))
        assert route.found or not np.isfinite(least)
        if route.found:
            kept += 1
            assert (np.asarray(ARM.distance(route.q, scene)) >= clearance).all()
    assert kept or told == "both"


@pytest.mark.parametrize("told", [(True, False), (False, True), (True, True)])
def test_an_arm_that_meets_grids_has_the_same_ends_by_a_swarm(told):
    from pieper.motion.route.search import Task
    from pieper.motion.route.setting import setting

    arm = pieper.load("universal-robots-ur5e")
    arm = arm.with_tool(arm.tool @ pieper.pose(0.03, 0.02, 0.15, rpy=(0, 0.6, 0)))
    q = np.array([0.3, -1.2, 1.3, -0.9, -1.1, 0.4])
    end = q + [0.2, 0.1, -0.15, 0.1, 0.05, -0.1]
    path, free = pieper.line(arm.fk(q), arm.fk(end), 12), pieper.Freedom(cone=0.2)
    world = setting(*arm._plans_of(free), free, path, np.linspace(0, 1, 12))
    ends = tuple(world.whole(p, world.path[k]) if t else None for p, k, t in ((q, 0, told[0]), (end, -1, told[1])))
    found = search_by_swarm(Task(world, False, ends, None))
    assert found is not None
    for at, posture, t in ((0, q, told[0]), (-1, end, told[1])):
        assert not t or np.abs(found.x[at, :6] - posture).max() < 1e-7
    assert (
        found.cost <= 1.1 * arm.route(path, free=free, start=q if told[0] else None, end=end if told[1] else None).cost
    )
