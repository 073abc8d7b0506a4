"""What a robot file says of its looks: shapes in the arm's frames, colours, meshes, what is left out."""

from __future__ import annotations

import numpy as np
import pytest

import pieper

HEAD = '<robot name="r"><material name="red"><color rgba="1 0 0 1"/></material>'
TAIL = """<link name="tool"/>
<joint name="j1" type="revolute"><parent link="base"/><child link="l1"/><origin xyz="0.1 0 0.2" rpy="0.4 0.3 0.2"/>
<axis xyz="0 1 0"/><limit lower="-2" upper="2" effort="1" velocity="1"/></joint>
<joint name="f" type="fixed"><parent link="l1"/><child link="tool"/><origin xyz="0 0 0.3"/></joint></robot>"""


def arm_with(tmp_path, base: str = "", link: str = ""):
    path = tmp_path / "r.urdf"
    path.write_text(f'{HEAD}<link name="base">{base}</link><link name="l1">{link}</link>{TAIL}')
    return pieper.load(path)


def visual(geometry: str, more: str = "") -> str:
    return f"<visual>{more}<geometry>{geometry}</geometry></visual>"


def test_shapes_stand_where_the_file_has_them_at_every_posture(tmp_path):
    at = '<origin xyz="0.01 0.02 0.03" rpy="0.1 0.2 0.3"/>'
    arm = arm_with(tmp_path, visual('<sphere radius="0.1"/>', at), visual('<box size="1 2 3"/>', at))
    here = pieper.pose(0.01, 0.02, 0.03, rpy=(0.1, 0.2, 0.3))
    joint = pieper.pose(0.1, 0, 0.2, rpy=(0.4, 0.3, 0.2))
    for angle in (0.0, 0.7, -1.2):
        frames = arm.frames([angle])
        base, moved = (frames[v.on] @ v.T for v in arm.visuals.shapes)
        assert np.allclose(base, here, atol=1e-12)
        assert np.allclose(moved, joint @ pieper.pose(0, 0, 0, rpy=(0, angle, 0)) @ here, atol=1e-12)


def test_looks_are_the_same_in_every_convention_and_go_with_the_base(tmp_path):
    arm = arm_with(tmp_path, link=visual('<cylinder radius="0.1" length="0.4"/>'))
    base = pieper.pose(1, 2, 3, rpy=(0.1, 0.2, 0.3))
    (own,) = arm.visuals.shapes
    assert own.size == (0.1, 0.4) and own.kind == "cylinder"
    for other, moved in (
        (arm.to("modified"), np.eye(4)),
        (arm.with_base(base), base),
        (arm.with_tool(base), np.eye(4)),
    ):
        for shape in other.visuals.shapes:  # or it no longer knows them
            there = other.frames([0.5])[shape.on] @ shape.T
            here = arm.frames([0.5])[own.on] @ own.T
            back = np.linalg.inv(other.frames([0.5])[0]) @ there
            assert np.allclose(back, np.linalg.inv(arm.frames([0.5])[0]) @ here, atol=1e-12), moved


def test_a_colour_is_found_by_its_name_wherever_it_is_said(tmp_path):
    later = visual('<sphere radius="1"/>').replace("</visual>", '<material name="red"/></visual>')
    own = visual('<sphere radius="2"/>').replace(
        "</visual>", '<material name="x"><color rgba="0 1 0 0.5"/></material></visual>'
    )
    arm = arm_with(tmp_path, later + own + visual('<sphere radius="3"/>'))
    assert [v.colour for v in arm.visuals.shapes] == [(1, 0, 0, 1), (0, 1, 0, 0.5), None]


def test_a_mesh_is_found_beside_the_file_or_in_its_package(tmp_path):
    (tmp_path / "meshes").mkdir()
    (tmp_path / "meshes" / "a.stl").write_bytes(b"")
    arm = arm_with(tmp_path, visual('<mesh filename="meshes/a.stl" scale="1 1 2"/>'))
    (shape,) = arm.visuals.shapes
    assert shape.mesh is not None and arm.visuals.mesh_file(shape.mesh) == tmp_path / "meshes" / "a.stl"
    assert shape.size == (1, 1, 2)
    with pytest.raises(pieper.InputError, match="no mesh"):
        arm.visuals.mesh_file("meshes/b.stl")


@pytest.mark.parametrize(
    "geometry",
    [
        '<box size="1 2"/>',
        '<sphere radius="-1"/>',
        '<cylinder radius="1"/>',
        '<mesh filename=""/>',
        '<torus r="1"/>',
        '<box size="nan 1 1"/>',
    ],
)
def test_what_cannot_be_read_is_left_out_and_said(tmp_path, geometry):
    arm = arm_with(tmp_path, visual(geometry) + visual('<sphere radius="1"/>'))
    assert len(arm.visuals.shapes) == 1 and "left out" in arm.visuals.notes[0]


def test_an_arm_of_the_catalogue_has_no_looks():
    assert pieper.load("denso-vp6242").visuals.shapes == ()


def test_a_mujoco_model_has_its_geoms_and_meshes(tmp_path):
    pytest.importorskip("mujoco")
    path = tmp_path / "m.xml"
    path.write_text(
        '<mujoco model="m"><asset><mesh name="tet" vertex="0 0 0  1 0 0  0 1 0  0 0 1"/></asset><worldbody>'
        '<body name="a" pos="0 0 .1"><joint name="j1" axis="0 0 1" range="-90 90"/><geom type="capsule" size=".05 .2"/>'
        '<body name="b" pos="0 0 .4"><joint name="j2" axis="0 1 0" range="-90 90"/><geom type="mesh" mesh="tet"/>'
        '<geom type="box" size=".1 .2 .3" group="3"/></body></body></worldbody></mujoco>'
    )
    arm = pieper.load(path)
    capsule, mesh = arm.visuals.shapes
    assert capsule.size == (0.05, 0.4) and mesh.mesh == "tet"
    triangles = arm.visuals.triangles
    assert triangles is not None
    T = arm.frames([0.0, 0.0])[mesh.on] @ mesh.T
    corners = triangles["tet"].reshape(-1, 3) @ T[:3, :3].T + T[:3, 3]
    wanted = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]) + [0, 0, 0.5]
    assert all(np.abs(corners - w).max(1).min() < 1e-6 for w in wanted)
