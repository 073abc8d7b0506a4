"""What is wrong with a robot file is said with its file, line, joint and key, and with what is allowed."""

from __future__ import annotations

import os
import time

import pytest

from pieper.description import robotfile
from pieper.errors import InputError, PieperWarning
from tests.description.robotfile_samples import TWO_JOINTS


def refused(old: str, new: str) -> InputError:
    assert old in TWO_JOINTS
    with pytest.raises(InputError) as caught:
        robotfile.loads(TWO_JOINTS.replace(old, new), "two.toml")
    assert str(caught.value).startswith("two.toml")
    return caught.value


def test_a_missing_key_is_named_with_its_joint_and_its_units():
    error = refused("d_mm = 125\n", "")
    assert error.joint == "turn" and "d_mm or d_m" in str(error) and "missing" in str(error)


def test_a_missing_convention_is_asked_for():
    assert "convention" in str(refused('convention = "standard"\n', ""))


def test_an_unknown_convention_lists_the_two():
    error = refused('"standard"', '"craig"')
    assert error.key == "convention" and error.line == 3
    assert '"standard"' in str(error) and '"modified"' in str(error)


def test_a_misspelt_key_gets_a_suggestion():
    error = refused("alpha_deg = 30", "alpah_deg = 30")
    assert "Did you mean 'alpha_deg'" in str(error)
    assert (error.line, error.joint, error.key) == (17, "slide", "alpah_deg")


def test_a_length_with_an_angle_unit_and_the_reverse_are_told_apart():
    assert "use alpha_deg or alpha_rad" in str(refused("alpha_deg = 30", "alpha_mm = 30"))
    assert "use d_mm or d_m" in str(refused("d_mm = 125", "d_deg = 125"))
    assert "use limits_mm or limits_m" in str(refused("limits_mm = [0, 300]", "limits_deg = [0, 300]"))


def test_a_key_without_its_unit_is_told_which():
    assert "'d' needs its unit in the key: use d_mm or d_m" in str(refused("d_mm = 125", "d = 125"))


def test_the_same_quantity_in_two_units_is_refused():
    assert "say the same thing twice" in str(refused("d_mm = 125", "d_mm = 125\nd_m = 0.125"))


def test_two_joints_of_one_name_are_refused():
    error = refused('name = "slide"', 'name = "turn"')
    assert "used twice" in str(error) and error.line == 14


@pytest.mark.parametrize("value", ["nan", "inf", "-inf"])
def test_a_length_that_is_not_a_number_is_refused(value):
    error = refused("d_mm = 125", f"d_mm = {value}")
    assert error.key == "d_mm" and error.joint == "turn" and error.line == 10


def test_nan_in_limits_is_refused():
    assert "nan" in str(refused("[-170, inf]", "[nan, 170]"))


def test_swapped_limits_are_refused_with_their_numbers():
    error = refused("[-170, inf]", "[170, -170]")
    assert "swapped" in str(error) and "170" in str(error) and error.key == "limits_deg"


@pytest.mark.parametrize("value", ['"abc"', "true", "[1]", '"1/0"', "\"__import__('os')\"", "2020-01-01"])
def test_what_is_no_number_is_refused(value):
    assert refused("d_mm = 125", f"d_mm = {value}").key == "d_mm"


def test_a_number_beyond_double_precision_range_is_refused():
    assert refused("d_mm = 125", "d_mm = 1" + "0" * 400).key == "d_mm"


def test_an_unknown_joint_type_lists_what_there_is():
    assert "revolute" in str(refused('type = "P"', 'type = "spherical"'))


def test_a_sign_is_one_or_minus_one():
    assert refused("d_mm = 125", "d_mm = 125\nsign = 2").key == "sign"


def test_an_arm_without_joints_is_refused():
    with pytest.raises(InputError, match="no joints"):
        robotfile.loads('name = "x"\nconvention = "standard"\n')


@pytest.mark.parametrize(
    ("pose", "message"),
    [
        ("xyz_mm = [1, 2]", "list of 3 numbers"),
        ("rpy_deg = [0, 0, 0]\nquaternion_wxyz = [1, 0, 0, 0]", "rotation twice"),
        ("quaternion_wxyz = [1, 1, 0, 0]", "length 1"),
        ("matrix_m = [[1, 0, 0, 0], [0, -1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]", "left-handed"),
        ("matrix_m = [[2, 0, 0, 0], [0, 2, 0, 0], [0, 0, 2, 0], [0, 0, 0, 1]]", "not a rotation"),
        ("matrix_m = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]", "four rows"),
        ("matrix_m = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]\nxyz_m = [0, 0, 0]", "twice"),
    ],
)
def test_impossible_poses_are_refused(pose, message):
    with pytest.raises(InputError, match=message):
        robotfile.loads(f"{TWO_JOINTS}[tool]\n{pose}\n")


def test_a_joint_vector_of_a_mixed_arm_must_say_both_units():
    with pytest.raises(InputError, match="q_deg_mm"):
        robotfile.loads(TWO_JOINTS + "[postures.home]\nq_deg = [0, 0]\n")


def test_a_joint_vector_of_the_wrong_length_is_refused():
    with pytest.raises(InputError, match="list of 2 numbers"):
        robotfile.loads(TWO_JOINTS + "[postures.home]\nq_deg_mm = [0, 0, 0]\n")


def test_a_check_that_says_nothing_is_refused():
    with pytest.raises(InputError, match="nothing is said of the pose"):
        robotfile.loads(TWO_JOINTS + '[[checks]]\nq_deg_mm = [0, 0]\nsource = "x"\n')


def test_degrees_in_a_radian_key_get_a_warning():
    with pytest.warns(PieperWarning, match="turn.*looks like degrees"):
        robotfile.loads(TWO_JOINTS.replace('alpha_rad = "pi/2"', "alpha_rad = 90"))


def test_broken_toml_is_told_with_its_line():
    with pytest.raises(InputError, match="not valid TOML.*line 2"):
        robotfile.loads('name = "x"\nconvention = standard\n')


@pytest.mark.parametrize("size", [100, 10_000_000])
def test_garbage_is_refused_quickly(tmp_path, size):
    path = tmp_path / "garbage.toml"
    path.write_bytes(os.urandom(size))
    begin = time.perf_counter()
    with pytest.raises(InputError, match="not a robot file"):
        robotfile.read(path)
    assert time.perf_counter() - begin < 1.0


def test_deep_nesting_is_refused():
    with pytest.raises(InputError, match="nested|TOML"):
        robotfile.loads("name = " + "[" * 100_000)


def test_a_missing_file_gets_the_nearest_name(tmp_path):
    (tmp_path / "my-arm.toml").write_text(TWO_JOINTS)
    with pytest.raises(InputError, match=r"Did you mean .*my-arm\.toml"):
        robotfile.read(tmp_path / "my-amr.toml")


def test_a_folder_is_not_a_robot_file(tmp_path):
    with pytest.raises(InputError, match="cannot be read"):
        robotfile.read(tmp_path)


def test_a_byte_order_mark_is_no_obstacle():
    assert robotfile.loads(b"\xef\xbb\xbf" + TWO_JOINTS.encode()).name == "two"
