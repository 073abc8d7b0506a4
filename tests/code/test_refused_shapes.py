"""What an exported file does not take is refused, not cut to size."""

import numpy as np
import pytest

import pieper
from tests.code.test_export import loaded


def test_shapes_that_an_exported_file_does_not_take_are_refused(tmp_path):
    six = loaded(pieper.load("denso-vp6242").code("python", tmp_path / "six.py"))
    for wrong in (np.zeros(7), np.zeros((3, 5)), 0.0):
        for ask in (six.fk, six.jacobian):
            with pytest.raises(ValueError, match="q must have shape"):
                ask(wrong)
    for wrong in (np.eye(3), np.zeros((2, 3, 4))):
        with pytest.raises(ValueError, match="Ts must have shape"):
            six.ik(wrong)


@pytest.mark.parametrize("value", [None, np.nan])
def test_a_spare_joint_needs_a_value(value, tmp_path):
    arm = pieper.load("kuka-lbr-iiwa-14-r820")
    spare = loaded(arm.code("python", tmp_path / "spare.py"))
    with pytest.raises(ValueError, match="values must be finite"):
        spare.ik(arm.fk(np.zeros(7)), value)


def test_a_name_that_a_language_would_cut_short_is_refused(tmp_path):
    with pytest.raises(pieper.InputError, match="at most 48 letters"):
        pieper.load("denso-vp6242").code("matlab", tmp_path / "out", name="a" * 300)


def test_an_arm_whose_name_has_two_lines_is_written_as_one_comment(tmp_path):
    arm = pieper.Arm.from_dh([pieper.DH(a=0.3)] * 3, convention="standard", name="one\ntwo", limits=[(-3, 3)] * 3)
    folder = arm.code("matlab", tmp_path / "out", name="x")
    for file in folder.iterdir():
        heads = file.read_text().split("\n")
        assert not any(line.startswith("two") for line in heads), file.name
        assert any("one two" in line for line in heads)
