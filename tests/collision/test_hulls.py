"""Bodies the kernel has no distance of go through coal; what is said of them is proved by a direction of our own."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from pieper import Clearance
from pieper.collision import hulls

coal = pytest.importorskip("coal")


def box_points(size):
    return np.array([[i, j, k] for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)]) * np.array(size) / 2


def test_a_box_of_points_is_the_box():
    arm, rng = pieper.load("universal-robots-ur10e"), np.random.default_rng(0)
    T, size = pieper.pose(0.5, 0.2, 0.4, rpy=(0.3, 0.5, -0.2)), [0.3, 0.2, 0.5]
    box = pieper.Scene([pieper.Box(T, size, name="it")])
    points = pieper.Scene([pieper.Convex(box_points(size) @ T[:3, :3].T + T[:3, 3], name="it")])
    q = rng.uniform(-3, 3, (60, 6))
    one, other = arm.distance(q, box), arm.distance(q, points)
    assert (one.pair == other.pair).all()
    assert np.abs(one - other).max() < 1e-9
    apart = np.asarray(one) > 0
    assert np.abs(one.gradient - other.gradient)[apart].max() < 1e-5
    # coal's direction can only be a lower bound, and is the distance itself to its own precision
    assert (np.asarray(other) <= np.asarray(one) + 1e-13).all()


def test_cylinders_and_boxes_are_apart_by_what_can_be_worked_out_by_hand():
    arm = pieper.Arm.from_dh([pieper.DH(a=1.0), pieper.DH()], convention="standard", name="two")
    arm = arm.with_bodies({"joint_2": [pieper.Box([0, 0, 0], [0.2, 0.2, 0.2], name="cube")]}, instead=True)
    drum = pieper.Scene([pieper.Cylinder([1.5, 0, 0], 0.1, 0.4, name="drum")])
    d = arm.distance(np.zeros(2), drum)
    assert float(d) == pytest.approx(0.3, abs=1e-9) and tuple(d.pair) == ("cube", "drum")
    turned = arm.distance([np.pi / 4, -np.pi / 4], drum)
    corner = np.array([np.cos(np.pi / 4) + 0.1, np.sin(np.pi / 4) - 0.1])
    assert float(turned) == pytest.approx(np.linalg.norm(corner - [1.5, 0]) - 0.1, abs=1e-9)


def test_a_layer_about_points_comes_off_the_distance():
    arm = pieper.load("denso-vp6242")
    points = box_points([0.2, 0.2, 0.2]) + [0.413, 0, 0.41]
    q = np.radians([0, 90, -180, 0, 0, 0])
    bare, thick = (arm.distance(q, pieper.Scene([pieper.Convex(points, r)])) for r in (0.001, 0.004))
    assert float(bare - thick) == pytest.approx(0.003, abs=1e-9)


@pytest.mark.parametrize("seed", range(6))
def test_a_swept_proof_with_hulls_holds_against_sampling(seed):
    rng = np.random.default_rng(seed)
    arm = pieper.load("universal-robots-ur10e")
    arm = arm.with_bodies({"tool": [pieper.Convex(rng.normal(0, 0.05, (20, 3)) + [0, 0, 0.1], name="gripper")]})
    shapes = [pieper.Convex(rng.normal(0, 0.1, (12, 3)) + rng.uniform(-1, 1, 3)) for _ in range(4)]
    shapes.append(pieper.Cylinder(pieper.pose(*rng.uniform(-1, 1, 3), rpy=rng.uniform(-3, 3, 3)), 0.05, 0.4))
    scene = pieper.Scene(shapes)
    path = rng.uniform(-2, 2, 6) + np.cumsum(rng.normal(0, 0.2, (4, 6)), 0)
    found = arm.clear(path, scene, 0.01)
    share = np.arange(200) / 200
    fine = (path[:-1, None] + share[:, None] * np.diff(path, axis=0)[:, None]).reshape(-1, 6)
    metres = np.asarray(arm.distance(fine, scene))
    if found.verdict is Clearance.CLEAR:
        assert metres.min() >= 0.01
    elif found.verdict is Clearance.HIT:
        assert arm.distance(found.q, scene) < 0.01
    else:
        assert metres.min() > 0.0099


def test_without_the_extra_the_message_says_which_pair_and_how(monkeypatch):
    import sys

    monkeypatch.setitem(sys.modules, "coal", None)
    arm = pieper.load("denso-vp6242")
    scene = pieper.Scene([pieper.Convex(box_points([0.1, 0.1, 0.1]) + [0.3, 0, 0.3], name="lump")])
    with pytest.raises(pieper.InputError, match="lump .convex body. needs an extra: pip install 'pieper.collision.'"):
        arm.distance(np.radians([0, 90, -180, 0, 0, 0]), scene)
    assert hulls.Hulls is not None
