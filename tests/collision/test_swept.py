"""A proof holds against sampling a thousand times finer; a hit is one; what is undecided is near the margin."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from pieper import Clearance

ARMS = ("denso-vp6242", "universal-robots-ur10e", "stanford-arm", "kuka-lbr-iiwa-14-r820", "adept-cobra-600")


def random_scene(rng, count=8, spread=1.0):
    shapes = []
    for _ in range(count):
        p = rng.uniform(-spread, spread, 3)
        kind = rng.integers(3)
        if kind == 0:
            shapes.append(pieper.Capsule(p, p + rng.normal(0, 0.2, 3), rng.uniform(0.01, 0.08)))
        else:
            T = pieper.pose(*p, rpy=rng.uniform(-3, 3, 3))
            size = rng.uniform(0.03, 0.3, 3)
            shapes.append(pieper.Box(T, size) if kind == 1 else pieper.Cylinder(T, size[0] / 2, size[1]))
    return pieper.Scene(shapes)


def random_path(rng, arm, points):
    low = np.where(np.isfinite(arm.limits[:, 0]), arm.limits[:, 0], -np.pi)
    high = np.where(np.isfinite(arm.limits[:, 1]), arm.limits[:, 1], np.pi)
    return rng.uniform(low, high, arm.n) + np.cumsum(rng.normal(0, 0.12, (points, arm.n)), 0) * np.minimum(
        high - low, 1.0
    )


def sampled(arm, path, scene, times):
    share = np.arange(times) / times
    fine = np.concatenate(
        [(path[:-1, None] + share[:, None] * np.diff(path, axis=0)[:, None]).reshape(-1, arm.n), path[-1:]]
    )
    return fine, np.asarray(arm.distance(fine, scene))


@pytest.mark.parametrize("name", ARMS)
def test_what_is_proved_holds_wherever_one_looks(name):
    arm, rng = pieper.load(name), np.random.default_rng(7)
    seen = {verdict: 0 for verdict in Clearance}
    for _ in range(60):
        scene, path = random_scene(rng), random_path(rng, arm, int(rng.integers(2, 6)))
        margin = float(rng.choice([0.0, 0.005, 0.05]))
        found = arm.clear(path, scene, margin)
        fine, metres = sampled(arm, path, scene, 1000)
        seen[found.verdict] += 1
        if found.verdict is Clearance.CLEAR:
            assert metres.min() >= margin
        elif found.verdict is Clearance.HIT:
            here = arm.distance(found.q, scene)
            assert here < margin and margin - here <= found.depth + 1e-12
            before = np.arange(len(fine)) < found.s * (len(fine) - 1) - 1e-3 * (len(path) - 1)
            assert metres[before].min(initial=1.0) > margin - 1e-4
            at = found.s * (len(path) - 1)
            i = min(int(at), len(path) - 2)
            assert np.abs(path[i] + (at - i) * (path[i + 1] - path[i]) - found.q).max() < 1e-9
        else:
            assert metres.min() > margin - 1e-5 and metres.min() < margin + 1e-3
    assert seen[Clearance.CLEAR] >= 3 and seen[Clearance.HIT] >= 3, seen


def test_touching_exactly_is_neither_clear_nor_a_hit():
    arm = pieper.Arm.from_dh([pieper.DH(d=0.5), pieper.DH(a=1.0)], convention="standard", name="two")
    arm = arm.with_bodies({"joint_2": [pieper.Capsule([-1, 0, 0], [0, 0, 0], 0.05, name="rod")]}, instead=True)
    # the rod turns level at z = 0.5 over a plate whose top is at 0.45
    plate = pieper.Scene([pieper.Box([0, 0, 0.4], [4, 4, 0.1], name="plate")])
    path = np.array([[0.0, 0.0], [0.5, 0.2], [1.0, -0.3]])
    touching = arm.clear(path, plate, gap=1e-4)
    assert (
        touching.verdict is Clearance.UNCERTAIN and touching.pair == ("rod", "plate") and "0.1 mm" in touching.explain()
    )
    assert arm.clear(path, plate, 0.001).verdict is Clearance.HIT
    lower = pieper.Scene([pieper.Box([0, 0, 0.399], [4, 4, 0.1])])
    assert arm.clear(path, lower, 0.0005).verdict is Clearance.CLEAR
    assert arm.clear(path, lower, 0.0015).depth == pytest.approx(0.0005, abs=1e-9)


def test_a_thin_post_between_two_points_is_not_missed():
    arm = pieper.load("universal-robots-ur10e")
    path = np.zeros((2, 6))
    path[:, 1] = -0.5
    path[1, 0] = 2.0
    T = arm.fk([1.234, -0.5, 0, 0, 0, 0])
    post = pieper.Scene([pieper.Capsule(T[:3, 3], T[:3, 3] + [0, 0, 0.2], 1e-4, name="needle")])
    found = arm.clear(path, post)
    assert found.verdict is Clearance.HIT and found.pair[1] == "needle" and 0.5 < found.s < 0.64
    assert 0 < found.depth < 0.1


def test_a_path_that_begins_in_a_hit_says_so():
    arm = pieper.load("universal-robots-ur10e")
    q = np.array([0.3, -1.0, 0.7, 0.1, 0.2, 0.3])
    T = arm.fk(q)
    ball = pieper.Scene([pieper.Capsule(T[:3, 3], T[:3, 3], 0.05, name="ball")])
    found = arm.clear([q, q + 0.1], ball)
    assert found.verdict is Clearance.HIT and found.s == 0.0 and found.explain().startswith("The path begins where")
    assert arm.clear(q, ball).verdict is Clearance.HIT, "one posture is a path"


def test_points_doubled_and_paths_reversed_change_nothing():
    arm, rng = pieper.load("denso-vp6242"), np.random.default_rng(3)
    for _ in range(20):
        scene, path = random_scene(rng, 5), random_path(rng, arm, 4)
        there, back = arm.clear(path, scene), arm.clear(path[::-1], scene)
        assert there.verdict is back.verdict
        assert there.s <= 1 - back.s + 1e-6 or there.verdict is not Clearance.HIT
        twice = np.repeat(path, 2, axis=0)
        assert arm.clear(twice, scene).verdict is there.verdict


def test_slides_and_coupled_joints_are_proved_too():
    C = np.eye(3)
    C[2, 1] = -1.0
    rows = [pieper.DH(d=0.3, alpha=np.pi / 2), pieper.DH(a=0.5), pieper.DH(a=0.4)]
    coupled = pieper.Arm.from_dh(rows, convention="standard", coupling=C, limits=[(-3, 3)] * 3, name="coupled")
    plain = pieper.Arm.from_dh(rows, convention="standard", limits=[(-3, 3)] * 3, name="plain")
    rng = np.random.default_rng(1)
    for _ in range(30):
        scene, path = random_scene(rng, 4, 0.8), rng.uniform(-1.5, 1.5, (4, 3))
        one, other = coupled.clear(path, scene, 0.01), plain.clear(path @ C.T, scene, 0.01)
        assert one.verdict is other.verdict and one.s == pytest.approx(other.s, abs=1e-12)
        d, e = coupled.distance(path, scene), plain.distance(path @ C.T, scene)
        assert np.abs(d - e).max() < 1e-14
        assert np.abs(d.gradient - e.gradient @ C).max() < 1e-13


def test_bad_paths_and_margins_are_refused():
    arm, scene = pieper.load("denso-vp6242"), random_scene(np.random.default_rng(0))
    for bad, word in (([[0.0] * 5], "6"), ([[np.nan] * 6], "finite"), (np.zeros((0, 6)), "at least one")):
        with pytest.raises(pieper.InputError, match=word):
            arm.clear(bad, scene)
    for margin in (-0.1, np.nan, np.inf, "1 mm"):
        with pytest.raises(pieper.InputError, match="margin"):
            arm.clear(np.zeros((2, 6)), scene, margin)
    with pytest.raises(pieper.InputError, match="at most 10,000,000"):
        arm.clear(np.broadcast_to(np.zeros(6), (10_000_001, 6)), scene)
    with pytest.raises(pieper.InputError, match="Scene"):
        arm.clear(np.zeros((2, 6)), [pieper.Box([0, 0, 0], [1, 1, 1])])


def test_a_track_a_route_and_a_motion_are_paths_too():
    arm = pieper.load("ur5e")
    q = np.array([0.0, -1.2, 1.5, -1.8, -1.5, 0.0])
    T = arm.fk(q)
    T[1, 3] += 0.1
    line = pieper.line(arm.fk(q), T, 20)
    track = arm.follow(line, start=q)
    motion = pieper.time_law(track, pieper.Limits(2.0, 10.0))
    scene = pieper.Scene([pieper.Box(arm.fk(track.q[-1])[:3, 3], [0.05, 0.05, 0.05], name="part")])
    for path in (track, arm.route(line, start=q), motion):
        for around in (None, scene):
            said, plain = arm.clear(path, around), arm.clear(path.q, around)
            assert (said.verdict, said.s, said.pair) == (plain.verdict, plain.s, plain.pair)
        assert said.verdict is Clearance.HIT
    T[1, 3] += 5
    stopped = arm.follow(pieper.line(arm.fk(q), T, 20), start=q)
    with pytest.raises(pieper.InputError, match=r"looked at to its end.*Look at track\.followed"):
        arm.clear(stopped)
    assert arm.clear(stopped.followed).verdict
    refused = arm.route(pieper.line(arm.fk(q), T, 20), start=q)
    with pytest.raises(pieper.InputError, match="no path to look at"):
        arm.clear(refused)
