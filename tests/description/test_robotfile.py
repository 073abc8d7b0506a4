"""Robot files: what is read, what is written, and that nothing is lost on the way."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from oracle.slow_forward import placed
from pieper.description import catalog, robotfile
from pieper.description.dh import DH, Actuator, Check
from pieper.description.quantity import ExpressionError, evaluate
from pieper.description.said import describe
from tests.description.robotfile_samples import EXAMPLES, TWO_JOINTS, same


def test_units_in_the_keys_become_metres_and_radians():
    arm = robotfile.loads(TWO_JOINTS)
    assert arm.rows[0] == DH(a=0.010, alpha=math.pi / 2, d=0.125, theta=0)
    assert arm.rows[1] == DH(a=0, alpha=math.radians(30), d=0.0015, theta=math.radians(10))
    assert arm.joint_types == "RP"
    assert arm.joint_names == ("turn", "slide")
    assert arm.limits.tolist() == [[math.radians(-170), math.inf], [0.0, 0.3]]


def test_what_is_not_said_is_unlimited_unturned_and_at_zero():
    arm = robotfile.loads(TWO_JOINTS.replace("limits_deg = [-170, inf]\n", ""))
    assert arm.limits[0].tolist() == [-math.inf, math.inf]
    assert arm.sign.tolist() == [1, 1] and arm.offset.tolist() == [0, 0]
    assert np.array_equal(arm.base, np.eye(4)) and np.array_equal(arm.tool, np.eye(4))
    assert arm.actuator is None and arm.postures == {} and arm.checks == ()


@pytest.mark.parametrize(
    ("keys", "rotation"),
    [
        ("rpy_deg = [0, 90, 0]", [[0, 0, 1], [0, 1, 0], [-1, 0, 0]]),
        ("rpy_rad = ['pi', 0, 0]", [[1, 0, 0], [0, -1, 0], [0, 0, -1]]),
        ("zyx_deg = [90, 0, 0]", [[0, -1, 0], [1, 0, 0], [0, 0, 1]]),
        ("zyz_deg = [90, 0, 90]", [[-1, 0, 0], [0, -1, 0], [0, 0, 1]]),
        ("rotation_vector_deg = [0, 0, 90]", [[0, -1, 0], [1, 0, 0], [0, 0, 1]]),
        ("quaternion_wxyz = [0, 1, 0, 0]", [[1, 0, 0], [0, -1, 0], [0, 0, -1]]),
        ("quaternion_xyzw = [1, 0, 0, 0]", [[1, 0, 0], [0, -1, 0], [0, 0, -1]]),
    ],
)
def test_every_rotation_notation_means_what_its_name_says(keys, rotation):
    arm = robotfile.loads(f"{TWO_JOINTS}[tool]\nxyz_mm = [1, 2, 3]\n{keys}\n")
    assert np.array_equal(arm.tool[:3, :3], rotation)
    assert arm.tool[:3, 3].tolist() == [0.001, 0.002, 0.003]


def test_a_pose_may_be_a_matrix():
    rows = "[[0, -1, 0, 10], [1, 0, 0, 20], [0, 0, 1, 30], [0, 0, 0, 1]]"
    arm = robotfile.loads(f"{TWO_JOINTS}[base]\nmatrix_mm = {rows}\n")
    assert arm.base.tolist() == [[0, -1, 0, 0.01], [1, 0, 0, 0.02], [0, 0, 1, 0.03], [0, 0, 0, 1]]


def test_mixed_joint_vectors_name_both_units():
    arm = robotfile.loads(TWO_JOINTS + "[postures.home]\nq_deg_mm = [90, 250]\n")
    assert arm.postures["home"].tolist() == [math.pi / 2, 0.25]


def test_the_gripper_has_a_value_and_limits_and_moves_no_frame():
    text = TWO_JOINTS + '[tool.actuator]\nname = "gripper"\nlimits_deg = [0, 180]\nvalue_deg = 45\n'
    arm = robotfile.loads(text)
    assert arm.actuator == Actuator("gripper", 0.0, math.pi, math.pi / 4, "rad")
    assert np.array_equal(arm.tool, np.eye(4))


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("pi/2", math.pi / 2),
        ("-3*pi/4", -3 * math.pi / 4),
        ("2*(1 + .5)", 3.0),
        ("sqrt(2)/2", math.sqrt(2) / 2),
        ("1e-3", 1e-3),
    ],
)
def test_expressions_are_exact(text, value):
    assert evaluate(text) == value


@pytest.mark.parametrize(
    "text", ["", "pi pi", "2**3", "__import__('os')", "1/0", "sqrt 2", "(1", "1e999", "pi+" * 40, "sqrt(-1)"]
)
def test_anything_but_arithmetic_is_refused_in_expressions(text):
    with pytest.raises(ExpressionError):
        evaluate(text)


@pytest.mark.parametrize("name", catalog.names())
def test_every_catalogue_arm_comes_back_from_text_to_the_last_bit(name):
    arm = catalog.load(name)
    assert same(robotfile.loads(robotfile.dumps(arm)), arm)


@pytest.mark.parametrize("path", sorted(EXAMPLES.glob("*.toml")), ids=lambda p: p.stem)
def test_the_example_files_are_read_and_come_back(path):
    arm = robotfile.read(path)
    assert same(robotfile.loads(robotfile.dumps(arm)), arm)


finite = st.floats(allow_nan=False, allow_infinity=False, min_value=-50, max_value=50)
LIMITS = [None, (-1.25, math.inf), (-math.inf, 2.0), (-7.5, 0.1 + 0.2)]
texts = st.text(st.characters(codec="utf-8", exclude_characters="\r"), max_size=300)


@st.composite
def arms(draw):
    """Return an arm with every field filled by arbitrary doubles."""
    n = draw(st.integers(1, 7))
    kinds = draw(st.text("RP", min_size=n, max_size=n))
    vector = st.lists(finite, min_size=n, max_size=n)
    poses = []
    for _ in range(2):
        q, p = np.array(draw(st.lists(finite, min_size=4, max_size=4))), draw(st.lists(finite, min_size=3, max_size=3))
        poses.append(placed(q if np.linalg.norm(q) > 1e-3 else [1.0, 0, 0, 0], p))
    small = st.floats(-6, 6)
    return describe(
        [DH(draw(finite), draw(small), draw(finite), draw(small)) for _ in range(n)],
        convention=draw(st.sampled_from(["standard", "modified"])),
        joint_types=kinds,
        limits=[
            draw(st.sampled_from([None, (-1.25, math.inf), (-math.inf, 2.0), (-7.5, 0.1 + 0.2)])) for _ in range(n)
        ],
        sign=[draw(st.sampled_from([1, -1])) for _ in range(n)],
        offset=draw(vector),
        base=poses[0],
        tool=poses[1],
        name=draw(texts),
        notes=draw(texts),
        source=draw(texts),
        departures=draw(st.lists(texts, max_size=3)),
        actuator=draw(
            st.sampled_from([None, Actuator("jaw", 0.0, 1 / 3, 0.1, "m"), Actuator("jaw", -1.0, 2.0, 0.3, "rad")])
        ),
        postures={draw(texts): draw(vector)},
        checks=[Check(np.array(draw(vector)), poses[0], "elsewhere", draw(st.floats(1e-12, 1.0)))],
    )


@given(arms())
@settings(max_examples=100, deadline=None)
def test_any_arm_comes_back_from_text_to_the_last_bit(arm):
    assert same(robotfile.loads(robotfile.dumps(arm)), arm)


def test_a_written_file_says_round_numbers_in_degrees_and_millimetres():
    text = robotfile.dumps(catalog.load("denso-vp6242"))
    assert "alpha_deg = 90" in text and "d_mm = 125" in text and "limits_deg = [-30, 210]" in text


def test_a_number_that_is_no_short_degree_is_written_in_radians(tmp_path):
    arm = describe([DH(alpha=0.1)], convention="standard", name="odd")
    path = robotfile.write(arm, tmp_path / "odd.toml")
    assert "alpha_rad = 0.1" in path.read_text()
    assert robotfile.read(path).rows[0].alpha == 0.1
