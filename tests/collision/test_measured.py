"""Bodies out of a URDF: shapes where they stand, meshes enclosed, what cannot be read said."""

from __future__ import annotations

import struct

import numpy as np
import pytest

import pieper
from pieper.description import stl
from pieper.description.enclose import enclosing

URDF = """<robot name="two">
  <link name="base_link"><collision><origin xyz="0 0 0.05"/>
    <geometry><cylinder radius="0.1" length="0.1"/></geometry></collision></link>
  <joint name="j1" type="revolute"><parent link="base_link"/><child link="upper"/>
    <origin xyz="0 0 0.2" rpy="0 0 0.3"/><axis xyz="0 0 1"/><limit lower="-3" upper="3"/></joint>
  <link name="upper"><collision><origin xyz="0.25 0 0"/>
    <geometry><box size="0.5 0.08 0.1"/></geometry></collision></link>
  <joint name="j2" type="revolute"><parent link="upper"/><child link="fore"/><origin xyz="0.5 0 0"/>
    <axis xyz="0 1 0"/><limit lower="-3" upper="3"/></joint>
  <link name="fore"><collision>
    <geometry><mesh filename="package://two_description/meshes/fore.stl" scale="0.001 0.001 0.001"/>
    </geometry></collision>
    <collision><geometry><mesh filename="fore.dae"/></geometry></collision></link>
  <joint name="f" type="fixed"><parent link="fore"/><child link="hand"/><origin xyz="0.4 0 0"/></joint>
  <link name="hand"><collision><geometry><sphere radius="0.05"/></geometry></collision></link>
  <joint name="finger" type="prismatic"><parent link="hand"/><child link="tip"/>
    <origin xyz="0.05 0 0"/><axis xyz="0 1 0"/><limit lower="0" upper="0.04"/></joint>
  <link name="tip"><collision><geometry><box size="0.02 0.02 0.02"/></geometry></collision></link>
</robot>"""


def triangles():
    corners = np.array([[i, j, k] for i in (0, 400) for j in (-30, 30) for k in (-20, 20)], float)
    return np.array([corners[[a, b, c]] for a in range(8) for b in range(a) for c in range(b)])


@pytest.fixture
def urdf(tmp_path):
    folder = tmp_path / "two_description"
    (folder / "urdf").mkdir(parents=True)
    (folder / "meshes").mkdir()
    faces = triangles()
    data = b"\0" * 80 + struct.pack("<I", len(faces))
    for face in faces:
        data += struct.pack("<12fH", 0, 0, 0, *face.ravel(), 0)
    (folder / "meshes" / "fore.stl").write_bytes(data)
    (folder / "urdf" / "two.urdf").write_text(URDF)
    return folder / "urdf" / "two.urdf"


def test_shapes_stand_where_the_urdf_says(urdf):
    arm = pieper.load(urdf, tip="hand")
    assert arm.notes == pieper.load(urdf, tip="hand").notes
    assert arm.bodies.names == ("base_link", "upper", "fore", "hand", "tip") and not arm.bodies.guessed
    words = arm.bodies.explain()
    assert "measured: box about the mesh fore.stl of fore" in words
    assert "fore.dae is no STL" in words and "finger" in words and "stand where these are at zero" in words
    # the fore link's mesh is 0.4 long along x, 0.06 by 0.04; turned by j1's frame and j2
    q = np.array([0.2, -0.7])
    T = np.asarray(pieper.pose(0, 0, 0.2, rpy=(0, 0, 0.5))) @ pieper.pose(0.5, 0, 0, rpy=(0, -0.7, 0))
    above = T @ pieper.pose(0.2, 0, 0.02 + 0.1 + 0.01)
    ball = pieper.Scene([pieper.Capsule(above[:3, 3], above[:3, 3], 0.01, name="ball")])
    d = arm.distance(q, ball)
    assert tuple(d.pair) == ("fore", "ball") and float(d) == pytest.approx(0.1, abs=1e-7)


def test_the_bodies_are_the_same_however_the_arm_is_said(urdf, tmp_path):
    arm, q = pieper.load(urdf, tip="hand"), np.random.default_rng(0).uniform(-1, 1, (30, 2))
    scene = pieper.Scene([pieper.Capsule([0.6, 0.1, -0.5], [0.6, 0.1, 0.9], 0.05)])
    d = np.asarray(arm.distance(q, scene))
    arm.save(tmp_path / "two.toml")
    assert np.abs(np.asarray(pieper.load(tmp_path / "two.toml").distance(q, scene)) - d).max() < 1e-13
    base = pieper.pose(0.3, 1.0, 0.0, rpy=(0, 0, 1.0))
    moved = pieper.Scene([shape.moved(base) for shape in scene])
    assert np.abs(np.asarray(arm.with_base(base @ arm.base).distance(q, moved)) - d).max() < 1e-13
    assert np.abs(np.asarray(arm.to("modified").distance(q, scene)) - d).max() < 1e-13
    held = arm.with_joints_locked({"j1": 0.4})
    q[:, 0] = 0.4
    assert held.bodies.names[0] == "base_link"
    # what stands still now is not compared with the scene any more
    now, before = held.distance(q[:, 1:], scene), arm.distance(q, scene)
    same = before.pair[:, 0] != "upper"
    assert (now >= before - 1e-13).all() and np.abs(np.asarray(now) - before)[same].max(initial=0.0) < 1e-13


def test_a_mesh_that_is_not_there_is_said_and_the_rest_is_read(urdf):
    (urdf.parent.parent / "meshes" / "fore.stl").unlink()
    arm = pieper.load(urdf, tip="hand")
    assert "fore" not in arm.bodies.names and "upper" in arm.bodies.names
    assert "there is no mesh package://two_description/meshes/fore.stl" in arm.bodies.explain()


@pytest.mark.parametrize("seed", range(8))
def test_what_encloses_points_holds_them_all_and_is_not_much_larger(seed):
    rng = np.random.default_rng(seed)
    points = rng.normal(size=(500, 3)) * rng.uniform(0.02, 0.4, 3) + rng.uniform(-1, 1, 3)
    shape = enclosing(points, "")
    if isinstance(shape, pieper.Capsule):
        u = shape.b - shape.a
        t = np.clip((points - shape.a) @ u / max(u @ u, 1e-300), 0, 1)
        assert (np.linalg.norm(points - shape.a - t[:, None] * u, axis=1) <= shape.r * (1 + 1e-9)).all()
        volume = np.pi * shape.r**2 * (np.linalg.norm(u) + 4 / 3 * shape.r)
    else:
        seen = (points - shape.T[:3, 3]) @ shape.T[:3, :3]
        assert (np.abs(seen) <= shape.size / 2 + 1e-9).all()
        volume = np.prod(shape.size)
    assert volume <= np.prod(points.max(0) - points.min(0)) * (1 + 1e-9)


def test_a_capsule_comes_back_as_itself():
    rng = np.random.default_rng(0)
    way = rng.normal(size=(4000, 3))
    ball = 0.1 * way / np.linalg.norm(way, axis=1)[:, None]
    shape = enclosing(ball + np.where(rng.random(4000) < 0.5, 0.0, 0.5)[:, None] * np.array([0, 0, 1]), "")
    assert isinstance(shape, pieper.Capsule)
    assert shape.r == pytest.approx(0.1, rel=0.01) and np.linalg.norm(shape.b - shape.a) == pytest.approx(0.5, rel=0.02)


def test_text_stl_is_read_and_rubbish_refused(tmp_path):
    facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
    (tmp_path / "a.stl").write_text(f"solid a\n{facet}")
    assert stl.read(tmp_path / "a.stl").shape == (3, 3)
    for rubbish in (b"", b"solid x", b"\0" * 90, b"vertex a b c"):
        (tmp_path / "b.stl").write_bytes(rubbish)
        with pytest.raises(pieper.InputError, match="STL"):
            stl.read(tmp_path / "b.stl")
