"""The arm as it looks: shapes and meshes of the user's own URDF, over the sketch or instead."""

from __future__ import annotations

import struct

import numpy as np
import pytest

import pieper
from tests.browser.conftest import Server

CUBE = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
QUADS = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
TRIANGLES = np.array([CUBE[[q[0], q[a], q[a + 1]]] for q in QUADS for a in (1, 2)])

URDF = """<robot name="looked-at">
 <material name="amber"><color rgba="0.95 0.6 0.1 1"/></material>
 <link name="base"><visual><origin xyz="0 0 0.05"/><geometry><cylinder radius="0.12" length="0.1"/></geometry></visual>
 </link>
 <link name="one"><visual><origin xyz="-0.05 -0.05 0"/><geometry><mesh filename="package://look/meshes/one.stl"
   scale="0.1 0.1 0.3"/></geometry><material name="amber"/></visual></link>
 <link name="two"><visual><origin xyz="0 -0.04 0" rpy="0 0 0.2"/><geometry><mesh filename="meshes/two.obj"
   scale="0.3 0.08 0.08"/></geometry></visual>
   <visual><origin xyz="0.3 0 0"/><geometry><sphere radius="0.06"/></geometry><material name="amber"/></visual></link>
 <link name="three"><visual><geometry><mesh filename="meshes/three.dae"/></geometry></visual>
   <visual><origin xyz="0 0 0.1"/><geometry><box size="0.05 0.2 0.02"/></geometry></visual></link>
 <link name="tool0"/>
 <joint name="j1" type="revolute"><parent link="base"/><child link="one"/><origin xyz="0 0 0.1" rpy="0 0 0.3"/>
   <axis xyz="0 0 1"/><limit lower="-3" upper="3" effort="1" velocity="1"/></joint>
 <joint name="j2" type="revolute"><parent link="one"/><child link="two"/><origin xyz="0 0 0.3"/>
   <axis xyz="0 1 0"/><limit lower="-3" upper="3" effort="1" velocity="1"/></joint>
 <joint name="j3" type="prismatic"><parent link="two"/><child link="three"/><origin xyz="0.35 0 0" rpy="0 1.5707963 0"/>
   <axis xyz="0 0 1"/><limit lower="0" upper="0.3" effort="1" velocity="1"/></joint>
 <joint name="end" type="fixed"><parent link="three"/><child link="tool0"/><origin xyz="0 0 0.12"/></joint>
</robot>"""

DAE = """<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="0.001"/><up_axis>Z_UP</up_axis></asset>
<library_effects><effect id="e"><profile_COMMON><technique sid="t"><lambert>
<diffuse><color>0.1 0.4 0.8 1</color></diffuse>
</lambert></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="m"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh><source
id="p"><float_array id="pa" count="24">{points}</float_array></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<polylist material="M" count="6"><input semantic="VERTEX" source="#v" offset="0"/><vcount>4 4 4 4 4 4
</vcount><p>{faces}</p>
</polylist></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node><translate>-40 -40 0</translate><scale>80 80 100</scale>
<instance_geometry url="#g"><bind_material>
<technique_common><instance_material symbol="M" target="#m"/></technique_common>
</bind_material></instance_geometry></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>"""


def write_arm(folder):
    """Write the arm with a mesh of each kind, and return its URDF."""
    meshes = folder / "look" / "meshes"
    meshes.mkdir(parents=True)
    rows = np.zeros(12, dtype=[("n", "<f4", 3), ("c", "<f4", (3, 3)), ("r", "<u2")])
    rows["c"] = TRIANGLES
    (meshes / "one.stl").write_bytes(b"\0" * 80 + struct.pack("<I", 12) + rows.tobytes())
    corners = "".join("v {} {} {}\n".format(*p) for p in CUBE)
    (meshes / "two.obj").write_text(corners + "".join("f {} {} {} {}\n".format(*(i + 1 for i in q)) for q in QUADS))
    points, faces = (" ".join(f"{v:g}" for v in np.ravel(a)) for a in (CUBE, QUADS))
    (meshes / "three.dae").write_text(DAE.format(points=points, faces=faces))
    (folder / "look" / "arm.urdf").write_text(URDF)
    return folder / "look" / "arm.urdf"


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("robots")


@pytest.fixture(scope="module")
def urdf(folder):
    return write_arm(folder)


@pytest.fixture(scope="module")
def looked_at(urdf):
    served = Server(pieper.load(urdf))
    yield served
    served.stop()


def turned(axis: str, angle: float) -> np.ndarray:
    R = {"x": (angle, 0, 0), "y": (0, angle, 0), "z": (0, 0, angle)}[axis]
    return pieper.pose(0, 0, 0, rpy=R)


def by_hand(q) -> list[np.ndarray]:
    """Return where each visual stands, by the URDF's own words."""

    def at(x, y, z, rpy=(0, 0, 0), scale=(1, 1, 1)):
        return pieper.pose(x, y, z, rpy=rpy) @ np.diag([*scale, 1.0])

    base = np.eye(4)
    one = at(0, 0, 0.1, (0, 0, 0.3)) @ turned("z", q[0])
    two = one @ at(0, 0, 0.3) @ turned("y", q[1])
    three = two @ at(0.35, 0, 0, (0, np.pi / 2, 0)) @ at(0, 0, q[2])
    return [
        base @ at(0, 0, 0.05),
        one @ at(-0.05, -0.05, 0, scale=(0.1, 0.1, 0.3)),
        two @ at(0, -0.04, 0, (0, 0, 0.2), (0.3, 0.08, 0.08)),
        two @ at(0.3, 0, 0),
        three,
        three @ at(0, 0, 0.1),
    ]


def places(bench) -> list[np.ndarray]:
    return sorted(
        (np.reshape(T, (4, 4)) for T in bench.value("workbench.looks.places")), key=lambda T: tuple(T.ravel().round(6))
    )


def test_a_urdf_is_seen_as_its_file_has_it_over_the_sketch_or_instead(people, looked_at):
    bench = people(url=looked_at.url).open()
    bench.until("workbench.looks.shapes === 6 && workbench.looks.loading === 0")
    for i, value in enumerate((40, -25, 120)):
        bench.fill(f"q-{i + 1}", value)
    q = np.array(bench.value("workbench.q"))
    expected = sorted(by_hand(q), key=lambda T: tuple(T.ravel().round(6)))
    for mine, theirs in zip(places(bench), expected, strict=True):
        # three's matrices are doubles, the mesh's own numbers are the file's
        assert np.abs(mine - theirs).max() < 1e-6
    assert bench.value("workbench.looks.triangles") >= 3 * 12
    bench.shot("looks-real", both=True)
    bench.page.get_by_test_id("look").get_by_text("Both").click()
    bench.page.get_by_test_id("look-opacity").fill("0.3")
    assert bench.value("workbench.looks.mode") == "both"
    bench.shot("looks-both", both=True)
    bench.page.get_by_test_id("look").get_by_text("Sketch").click()
    assert not bench.value("workbench.looks.visible")
    # what is known is of this arm alone: another one, and an edited one, are sketched
    bench.page.get_by_test_id("look").get_by_text("Real").click()
    bench.tab("DH table")
    bench.fill("dh-2-a", 400)
    bench.until("!workbench.looks.visible")
    bench.page.keyboard.press("Control+z")
    bench.until("workbench.looks.visible")
    # a reload brings the looks back, and the chosen way to see them
    bench.page.get_by_test_id("look").get_by_text("Both").click()
    bench.page.reload()
    bench.until("window.workbench && workbench.looks.shapes === 6 && workbench.looks.mode === 'both'")


def test_a_folder_is_opened_with_the_meshes_that_its_file_names(bench, urdf):
    bench.tab("DH table")
    bench.page.get_by_test_id("robot-folder").set_input_files(urdf.parent)
    bench.until("workbench.table.name === 'looked-at' && workbench.looks.shapes === 6 && workbench.looks.loading === 0")
    q = np.array(bench.value("workbench.q"))
    expected = sorted(by_hand(q), key=lambda T: tuple(T.ravel().round(6)))
    assert max(np.abs(a - b).max() for a, b in zip(places(bench), expected, strict=True)) < 1e-6
    assert not [r for r in bench.requests if "/looks/" in r], "its meshes never leave the browser"


def test_the_picture_holds_what_the_links_wear_and_comes_nearer_when_they_wear_it_no_more(people, tmp_path):
    text = URDF.replace('<box size="0.05 0.2 0.02"/>', '<box size="0.05 3 0.02"/>').replace("looked-at", "broad")
    (write_arm(tmp_path).parent / "broad.urdf").write_text(text)
    served = Server(pieper.load(tmp_path / "look" / "broad.urdf"))
    try:
        bench = people(url=served.url).open()
        bench.until("workbench.looks.shapes === 6 && workbench.looks.loading === 0")
        bar = by_hand(np.array(bench.value("workbench.q")))[-1]
        ends = [(bar @ [0, y, 0, 1])[:3].tolist() for y in (-1.5, 1.5)]
        bench.until(
            """ends => ends.every((p) => {
              const [x, y] = workbench.toScreen(p),
                r = document.querySelector('canvas').getBoundingClientRect();
              return x > r.left && x < r.right && y > r.top && y < r.bottom;
            })""",
            ends,
        )
        bench.shot("looks-broad")
        away = "Math.hypot(...[0, 1, 2].map((i) => workbench.camera[i] - workbench.camera[i + 3]))"
        wide = bench.value(away)
        bench.page.get_by_test_id("look").get_by_text("Sketch").click()
        bench.until(f"wide => {away} < 0.8 * wide", wide)
    finally:
        served.stop()
