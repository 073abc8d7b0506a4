"""A map with a scene counts the solutions that touch nothing, each asked by itself; another scene is another map."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

import pieper
from pieper.maps.around import Around

BOX = ((-0.5, 0.5), (-0.5, 0.5), (0.0, 0.8))
SCENE = pieper.Scene([pieper.Box([0.3, 0.0, 0.1], [0.3, 0.6, 0.2]), pieper.Capsule([0, 0.4, 0], [0, 0.4, 0.7], 0.05)])


@pytest.mark.parametrize("name", ["denso-vp6242", "universal-robots-ur5e", "stanford-arm"])
@pytest.mark.parametrize("scene", [SCENE, pieper.Scene()], ids=["scene", "alone"])
def test_a_solution_counts_where_it_touches_nothing(name, scene):
    arm = pieper.load(name)
    m = arm.reach_map(BOX, 0.25, (5, 3), scene=scene)
    free = arm.reach_map(BOX, 0.25, (5, 3))
    T = m.grid.poses(np.arange(m.grid.count), m.grid.turns).reshape(m.grid.count, -1, 4, 4)
    for voxel in range(m.grid.count):
        clear = [sum(row > 0 for row in arm.distance(s.q, scene)) if len(s) else 0 for s in map(arm.ik, T[voxel])]
        assert m.fraction.ravel()[voxel] == np.mean(np.array(clear) > 0)
        assert m.count.ravel()[voxel] == sum(clear)
    assert (m.bits & ~free.bits).max() == 0
    assert scene is not SCENE or m.count.sum() < free.count.sum()


def test_what_is_reached_is_asked_with_the_same_scene():
    arm = pieper.load("denso-vp6242")
    m = arm.reach_map(BOX, 0.5, (4, 2), scene=SCENE)
    q = np.random.default_rng(3).uniform(*arm.limits.T, (300, 6))
    T = arm.fk(q)
    clear = [bool(len(s) and (np.asarray(arm.distance(s.q, SCENE)) > 0).any()) for s in map(arm.ik, T)]
    assert (m.reached(T) == clear).all() and 0 < np.mean(clear) < 1
    assert "2 obstacles" in m.explain() and "guessed" in m.explain()
    assert "collisions do not" in arm.reach_map(BOX, 0.5, (4, 2)).explain()


def test_another_scene_is_another_map(tmp_path):
    arm = pieper.load("denso-vp6242")
    kept = arm.reach_map(BOX, 0.5, (4, 2), scene=SCENE, store=tmp_path)
    assert arm.reach_map(BOX, 0.5, (4, 2), scene=SCENE, store=tmp_path).computed == 0
    for other in (None, pieper.Scene(), pieper.Scene(list(SCENE)[:1])):
        with pytest.raises(pieper.InputError, match="what stands around the arm"):
            arm.reach_map(BOX, 0.5, (4, 2), scene=other, store=tmp_path)
    sent = pickle.loads(pickle.dumps(kept.around))
    assert isinstance(sent, Around) and sent.fingerprint == kept.around.fingerprint
    q = np.random.default_rng(0).uniform(-2, 2, (50, 6))
    assert (sent.clear(q) == kept.around.clear(q)).all()
