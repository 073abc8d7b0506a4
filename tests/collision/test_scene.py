"""Shapes, scenes and bodies: what is refused, what a file keeps, what may touch."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

import pieper
from pieper import Box, Capsule, Convex, Cylinder, InputError, Scene


@pytest.mark.parametrize(
    ("make", "word"),
    [
        (lambda: Box([0, 0, 0], [1, 1, 0]), "sides of a box"),
        (lambda: Box([0, 0, 0], [1, 1, np.nan]), "size of a box"),
        (lambda: Box(np.ones((4, 4)), [1, 1, 1]), "pose of a box"),
        (lambda: Capsule([0, 0, 0], [0, 0, 1], -0.1), "radius of a capsule"),
        (lambda: Capsule([0, 0, 0], [0, 0, 1], 0.0), "radius of a capsule"),
        (lambda: Capsule([0, 0], [0, 0, 1], 0.1), "end a of a capsule"),
        (lambda: Capsule([0, 0, 0], [0, 0, np.inf], 0.1), "end b of a capsule"),
        (lambda: Cylinder([0, 0, 0], 0.1, 0.0), "height of a cylinder"),
        (lambda: Convex([], 0.0), "points of a convex body"),
        (lambda: Convex([[0, 0, 0], [1, 0, 0], [0, 1, 0]]), "at least four"),
        (lambda: Convex([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]), "one plane"),
        (lambda: Convex([[0, 0, 0]] * 5), "one plane"),
        (lambda: Convex(np.eye(3).tolist() + [[0, 0, 0]], -1), "layer"),
        (lambda: Scene(Box([0, 0, 0], [1, 1, 1])), "brackets"),
        (lambda: Scene([3]), "obstacle 1"),
        (lambda: Scene([Box([0, 0, 0], [1, 1, 1], "a"), Capsule([0, 0, 0], [0, 0, 0], 1, "a")]), "two obstacles"),
        (lambda: Scene([], allowed=[("x", "y")]), "neither is an obstacle"),
    ],
)
def test_a_shape_that_is_none_is_refused_by_name(make, word):
    with pytest.raises(InputError, match=word):
        make()


def test_a_body_on_an_unknown_joint_is_refused_with_the_joints_there_are():
    arm = pieper.load("denso-vp6242")
    with pytest.raises(InputError, match="joint_9.*joint_1"):
        arm.with_bodies({"joint_9": Capsule([0, 0, 0], [0, 0, 0.1], 0.02)})
    with pytest.raises(InputError, match="Box, Capsule"):
        arm.with_bodies({"tool": 3})
    with pytest.raises(InputError, match="no body 'x'"):
        arm.with_bodies({"tool": Capsule([0, 0, 0], [0, 0, 0.1], 0.02)}, allowed=[("x", "tool")])
    scene = Scene([Box([1, 1, 1], [1, 1, 1], name="block")], allowed=[("gripper", "block")])
    with pytest.raises(InputError, match="no such body"):
        arm.distance(np.zeros(6), scene)


def some_bodies(arm):
    return arm.with_bodies(
        {
            "base": Cylinder([0, 0, 0.05], 0.08, 0.1, name="foot"),
            "joint_2": [Capsule([-0.21, 0, 0], [0, 0, 0], 0.04, name="upper arm"), Box([0, 0, 0.1], [0.1, 0.05, 0.02])],
            "tool": Convex([[0, 0, 0], [0.03, 0, 0], [0, 0.03, 0], [0, 0, 0.05]], 0.002, name="claw"),
        },
        allowed=[("claw", "foot")],
    )


def test_a_robot_file_keeps_its_bodies(tmp_path):
    arm = some_bodies(pieper.load("denso-vp6242"))
    arm.save(tmp_path / "arm.toml")
    again = pieper.load(tmp_path / "arm.toml")
    assert again.bodies.names == arm.bodies.names and again.bodies.allowed == arm.bodies.allowed
    q = np.random.default_rng(0).uniform(-1, 1, (50, 6))
    assert np.array_equal(np.asarray(arm.distance(q)), np.asarray(again.distance(q)))
    more = again.with_bodies({"joint_3": Capsule([0, 0, 0], [0.1, 0, 0], 0.03, name="more")})
    more.save(tmp_path / "arm.toml")
    assert "more" in pieper.load(tmp_path / "arm.toml").bodies.names


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ('on = "joint_2"\nsize_mm = [1, 2, 0]', "size_mm: must be more than zero, mm, got 0"),
        ('on = "joint_7"\nsize_mm = [1, 2, 3]', "no joint of this arm"),
        ('on = "joint_2"', "nothing says what it is"),
        ('on = "joint_2"\nfrom_mm = [0, 0, 0]\nto_mm = [0, 0, 1]', "radius"),
        (
            'on = "joint_2"\nfrom_mm = [0, 0, 0]\nto_mm = [0, 0, 1]\nradius_mm = -3',
            "must be more than zero, mm, got -3",
        ),
        ('on = "joint_2"\nsize_mm = [1, 2, 3]\nheight_mm = 3', "both a box and a cylinder"),
        ('on = "tool"\npoints_mm = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]', "one plane"),
        ('on = "tool"\nsize_mm = [1, 2, 3]\nradius_mm = 3', "unknown"),
    ],
)
def test_a_wrong_body_of_a_robot_file_is_named_with_its_line(tmp_path, text, word):
    file = tmp_path / "arm.toml"
    pieper.load("denso-vp6242").save(file)
    file.write_text(file.read_text() + f"\n[[bodies]]\n{text}\n")
    with pytest.raises(InputError, match=word) as said:
        pieper.load(file)
    assert "arm.toml, line" in str(said.value)


def test_an_axes_file_says_bodies_in_the_base_at_zero(tmp_path):
    text = """\
name = "axes"
convention = "axes"
[[joints]]
type = "revolute"
axis = [0, 0, 1]
point_m = [0, 0, 0]
[[joints]]
type = "revolute"
axis = [0, 1, 0]
point_m = [0.1, 0, 0.5]
[home]
xyz_m = [1.0, 0, 0.5]
[base]
xyz_m = [0, 2, 0]
[[bodies]]
name = "rod"
on = "joint_2"
from_m = [0.1, 0, 0.5]
to_m = [1.0, 0, 0.5]
radius_m = 0.05
"""
    (tmp_path / "axes.toml").write_text(text)
    arm = pieper.load(tmp_path / "axes.toml")
    ball = Scene([Capsule([1.2, 2, 0.5], [1.2, 2, 0.5], 0.01)])
    assert float(arm.distance([0.0, 0.0], ball)) == pytest.approx(0.2 - 0.06, abs=1e-12)
    ball = Scene([Capsule([0.1, 2, 1.6], [0.1, 2, 1.6], 0.01)])
    assert float(arm.distance([0.0, -np.pi / 2], ball)) == pytest.approx(0.2 - 0.06, abs=1e-12)


def test_a_scene_file_comes_back_as_it_was(tmp_path):
    scene = Scene(
        [
            Box(pieper.pose(0.3, 0, 0.1, rpy=(0, 0, 0.5)), [0.2, 0.3, 0.1], name="table"),
            Capsule([0, 0, 0], [0, 0.5, 0], 0.02),
            Cylinder([0.1, 0.2, 0.3], 0.04, 0.5),
            Convex([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], 0.01),
        ],
        allowed=[("joint_6 axis", "table")],
    )
    scene.save(tmp_path / "cell.toml")
    again = Scene.load(tmp_path / "cell.toml")
    assert again.names == scene.names and again.allowed == scene.allowed
    arm, q = pieper.load("denso-vp6242"), np.random.default_rng(0).uniform(-1, 1, (20, 6))
    assert np.array_equal(np.asarray(arm.distance(q, scene)), np.asarray(arm.distance(q, again)))
    (tmp_path / "cell.toml").write_text("[[bodies]]\nsize_mm = [1, 2]\n")
    with pytest.raises(InputError, match="cell.toml"):
        Scene.load(tmp_path / "cell.toml")


@pytest.mark.parametrize("name", pieper.catalog())
def test_every_arm_has_bodies_that_are_said_to_be_guessed_and_let_it_move(name):
    arm = pieper.load(name)
    assert len(arm.bodies) >= 2 and arm.bodies.guessed and "guessed from the DH table" in arm.bodies.explain()
    low = np.where(np.isfinite(arm.limits[:, 0]), arm.limits[:, 0], -np.pi)
    high = np.where(np.isfinite(arm.limits[:, 1]), arm.limits[:, 1], np.pi)
    q = np.random.default_rng(1).uniform(low, np.minimum(high, low + 10), (400, arm.n))
    assert np.mean(np.asarray(arm.distance(q)) > 0) > 0.5


def test_pickling_and_copying_keep_what_was_said():
    import copy
    import pickle

    arm = some_bodies(pieper.load("denso-vp6242"))
    arm.distance(np.zeros(6))
    again = pickle.loads(pickle.dumps(arm))
    assert float(again.distance(np.zeros(6))) == float(arm.distance(np.zeros(6)))
    d = copy.copy(pickle.loads(pickle.dumps(arm.distance(np.zeros((2, 6))))))
    assert d.shape == (2,)


MILLIMETRES = [
    (pieper.Box([700, 0, 100], [500, 1000, 200], name="table"), "table is at least"),
    (pieper.Box([0, 0, -50], [2000, 2000, 100], name="floor"), "floor is up to"),
    (pieper.Capsule([300, -900, 0], [300, -900, 0], 30, name="ball"), "ball is at least"),
    (pieper.Convex([[400, 0, 0], [400, 50, 0], [400, 0, 50], [450, 0, 0]], name="hull"), "hull is at least"),
]


@pytest.mark.parametrize("shape, said", MILLIMETRES, ids=lambda x: getattr(x, "name", ""))
def test_a_scene_typed_in_millimetres_is_remarked_once(shape, said):
    arm = pieper.load("ur5e")
    q = np.array([0.0, -1.2, 1.0, -1.4, -1.57, 0.0])
    scene = pieper.Scene([pieper.Box([0.7, 0, 0.1], [0.5, 1, 0.2]), shape])
    with pytest.warns(pieper.PieperWarning, match=said + ".*millimetres") as caught:
        arm.clear(np.stack([q, q]), scene)
    assert len(caught) == 1 and caught[0].filename == __file__
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        arm.distance(q, scene)  # said once
    with pytest.warns(pieper.PieperWarning, match=said):
        assert pieper.load("ur5e").ik(arm.fk(q), scene=scene).clearance.size


def test_a_body_of_the_arm_typed_in_millimetres_is_remarked():
    arm = pieper.load("ur5e").with_bodies({"tool": pieper.Capsule([0, 0, 0], [0, 0, 150], 30, name="gripper")})
    with pytest.warns(pieper.PieperWarning, match="gripper is up to 210 m across"):
        arm.distance(np.zeros(6))


def test_what_is_large_or_far_in_metres_is_not_remarked():
    arm = pieper.load("ur5e")
    hall = [
        pieper.Box([0, 0, -0.6], [100, 100, 1], name="floor"),
        pieper.Box([30, 0, 5], [0.2, 60, 10], name="wall"),
        pieper.Cylinder([-50, 20, 5], 0.5, 10, name="column"),
    ]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        arm.distance(np.array([0.0, -1.2, 1.0, -1.4, -1.57, 0.0]), pieper.Scene(hall))


@pytest.mark.parametrize("name", ["mecademic-meca500", "so-101", "dobot-mg400"])
def test_a_scene_that_a_desk_arm_cannot_touch_is_remarked_and_cannot_be_touched(name):
    rng = np.random.default_rng(4)
    arm = pieper.load(name)
    low, high = np.clip(arm.limits, -3, 3).T
    said = 0
    for _ in range(12):
        place, size = rng.uniform(-1.6, 1.6, 3), rng.uniform(0.05, 2.0, 3)
        fresh, scene = pieper.load(name), pieper.Scene([pieper.Box(place, size, name="table")])
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            near = fresh.distance(rng.uniform(low, high, (200, arm.n)), scene)
        words = [str(w.message) for w in caught]
        if any("nothing of the scene is within reach: table is the nearest" in w for w in words):
            said += 1
            # the arm's own bodies may touch each other in a posture drawn at random, but not the table
            assert not any("table" in pair for pair in np.ravel(near.pair) if pair is not None)
    assert 0 < said < 12


def test_a_block_about_the_place_where_the_arm_stands_is_remarked_and_a_floor_is_not():
    arm = pieper.load("mecademic-meca500")
    q = np.array([0.0, -0.5, 0.5, 0.0, 0.5, 0.0])
    with pytest.warns(pieper.PieperWarning, match="table holds the place .* 400 mm inside.*of its middle"):
        arm.distance(q, pieper.Scene([pieper.Box([0, 0, 0.1], [1, 1, 1], name="table")]))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        arm.distance(q, pieper.Scene([pieper.Box([0, 0, 0], [2, 2, 0.02], name="floor")]))


def test_a_body_of_a_scene_stands_on_nothing(tmp_path):
    file = tmp_path / "cell.toml"
    file.write_text('[[bodies]]\non = "joint_9"\nsize_mm = [10, 10, 10]\n')
    with pytest.raises(InputError, match="line 2.*bodies of a scene stand still"):
        pieper.Scene.load(file)
