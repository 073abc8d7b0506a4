"""Geoms of an MJCF are the arm's bodies: where MuJoCo has them, as far from things as MuJoCo says."""

import numpy as np
import pytest

import pieper

mujoco = pytest.importorskip("mujoco")

MODEL = """<mujoco model="crane">
  <compiler angle="radian" autolimits="true"/>
  <asset><mesh name="wedge" vertex="0 0 0  0.2 0 0  0 0.1 0  0 0 0.15  0.2 0.1 0"/></asset>
  <worldbody>
    <geom name="floor" type="plane" size="1 1 0.1"/>
    <geom name="ball" type="sphere" size="0.08" pos="0.45 0.2 0.4"/>
    <body name="column" pos="0 0 0.1">
      <joint name="slew" axis="0 0 1" range="-2.9 2.9"/>
      <geom type="cylinder" size="0.07 0.1" pos="0 0 0.1"/>
      <body name="boom" pos="0 0 0.25">
        <joint name="luff" axis="0 1 0" range="-1.5 1.5"/>
        <geom type="capsule" fromto="0 0 0 0.4 0 0.05" size="0.04"/>
        <geom type="box" size="0.05 0.06 0.02" pos="0.1 0 0.1" euler="0.2 0.3 0.1" contype="0" conaffinity="0"/>
        <body name="jib" pos="0.4 0 0.05" euler="0 0.3 0">
          <joint name="fold" axis="0 1 0" range="-2 2"/>
          <geom type="box" size="0.12 0.03 0.04" pos="0.12 0 0" euler="0.4 0 0.2"/>
          <geom type="sphere" size="0.05" pos="0.25 0 0"/>
          <geom type="mesh" mesh="wedge" pos="0.2 0.05 0.02" euler="0.1 0.2 0.3"/>
          <geom type="ellipsoid" size="0.05 0.03 0.02" pos="0.3 0 0.05"/>
        </body>
      </body>
    </body>
  </worldbody>
</mujoco>
"""


@pytest.fixture
def crane(tmp_path):
    (tmp_path / "crane.xml").write_text(MODEL)
    model = mujoco.MjModel.from_xml_path(str(tmp_path / "crane.xml"))
    return pieper.load(tmp_path / "crane.xml"), model, tmp_path


def test_its_geoms_are_its_bodies_and_what_touches_nothing_is_left_out(crane):
    arm, _, _ = crane
    kinds = sorted(type(body.shape).__name__ for body in arm.bodies)
    # the mesh and the ellipsoid are enclosed; the box that nothing touches and the world's own geoms are not there
    assert len(kinds) == 6 and kinds.count("Cylinder") == 1 and not arm.bodies.guessed
    said = arm.bodies.explain()
    assert "the capsule of boom" in said and "about the mesh wedge of jib" in said
    assert "box about the ellipsoid of jib" in said


def test_they_are_where_mujoco_has_them_and_as_far_from_a_ball(crane):
    arm, model, _ = crane
    data = mujoco.MjData(model)
    ball = pieper.Scene([pieper.Capsule([0.45, 0.2, 0.4], [0.45, 0.2, 0.4], 0.08, name="ball")])
    exact = {"cylinder", "capsule", "box", "sphere"}
    names = {int(getattr(mujoco.mjtGeom, f"mjGEOM_{kind.upper()}")): kind for kind in exact}
    low, high = arm.limits.T
    rng = np.random.default_rng(4)
    ours = {body.name: body.source for body in arm.bodies}
    for _ in range(20):
        q = low + rng.uniform(size=arm.n) * (high - low)
        data.qpos[:] = q
        mujoco.mj_forward(model, data)
        nearest = np.inf
        for g in range(model.ngeom):
            kind = names.get(int(model.geom_type[g]))
            touches = model.geom_contype[g] or model.geom_conaffinity[g]
            if kind is None or not touches or model.geom_bodyid[g] == 0:
                continue
            nearest = min(nearest, mujoco.mj_geomDistance(model, data, g, 1, 10.0, None))
        found = arm.distance(q, ball)
        if float(found) < nearest - 1e-9:
            # nearer only by what encloses a mesh or an ellipsoid
            assert ours[str(found.pair[0])].startswith("measured") or "ball" not in found.pair
        else:
            assert float(found) == pytest.approx(nearest, abs=1e-6)


def test_a_model_whose_meshes_are_gone_is_guessed_and_says_so(crane, tmp_path):
    text = MODEL.replace(
        '<mesh name="wedge" vertex="0 0 0  0.2 0 0  0 0.1 0  0 0 0.15  0.2 0.1 0"/>',
        '<mesh name="wedge" file="gone.stl"/>',
    )
    (tmp_path / "gone.xml").write_text(text)
    arm = pieper.load(tmp_path / "gone.xml")
    assert arm.bodies.guessed and "left out" in arm.bodies.explain()


def test_a_tool_and_a_base_carry_them_along(crane):
    arm, _, _ = crane
    q = np.array([0.3, -0.4, 0.9])
    ball = [0.5, 0.2, 0.4]
    away = float(arm.distance(q, pieper.Scene([pieper.Capsule(ball, ball, 0.05)])))
    move = pieper.pose(0.1, -0.2, 0.05, rotvec=(0.0, 0.0, 0.4))
    moved = (move @ np.append(ball, 1.0))[:3]
    other = arm.with_base(move @ arm.base).with_tool(pieper.pose(0.0, 0.0, 0.1))
    assert float(other.distance(q, pieper.Scene([pieper.Capsule(moved, moved, 0.05)]))) == pytest.approx(
        away, abs=1e-12
    )
