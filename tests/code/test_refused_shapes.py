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
