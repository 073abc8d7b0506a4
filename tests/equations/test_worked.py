"""Worked examples and names of signs: what a page says with numbers is what comes out when it is computed again."""

import numpy as np
import pytest

import pieper
from pieper.equations.derivation.worked import DECIMALS
from pieper.errors import InputError
from pieper.presentation.report import good_pose

ARMS = ["denso-vp6242", "unimation-puma-560", "universal-robots-ur5e", "stanford-arm", "adept-cobra-600", "abb-irb2400"]


@pytest.mark.parametrize("name", ARMS)
def test_every_line_of_a_worked_example_gives_its_last_number_again(name):
    arm = pieper.load(name)
    T = good_pose(arm)
    worked = arm.symbolic.ik().worked(T)
    assert np.abs(arm.fk(worked.q) - T).max() < 1e-12
    rows = [b for b in worked.page.blocks if hasattr(b, "sides") and len(b.sides) >= 3]
    assert len(rows) >= len(worked.form.steps)
    names = {"sqrt": np.sqrt, "atan2": np.arctan2}
    for row in rows:
        numbers, shown = row.sides[-2].text(), row.sides[-1].text()
        again = eval(numbers.replace("^", "**"), {"__builtins__": {}}, names)
        if shown.endswith("°"):
            off = (np.degrees(again) - float(shown[:-1]) + 180) % 360 - 180
        else:
            off = again - float(shown)
        # the numbers put in are rounded themselves; what a line of them loses is far below this
        assert abs(off) < 2e-2, (numbers, shown, DECIMALS)


def test_a_pose_out_of_reach_is_refused_with_its_cure():
    arm = pieper.load("denso-vp6242")
    T = np.eye(4)
    T[0, 3] = 5.0
    with pytest.raises(InputError, match="take one that the arm reaches"):
        arm.symbolic.ik().worked(T)


@pytest.mark.parametrize("name", ARMS)
def test_the_signs_name_the_posture_that_the_solver_labels(name):
    arm = pieper.load(name)
    ik = arm.symbolic.ik()
    assert ik.sign_names
    q = np.random.default_rng(5).uniform(-2.8, 2.8, (30, arm.n))
    Ts = arm.fk(q)
    found = ik.evaluate(Ts)
    signs = np.stack(np.meshgrid(*[[1, -1]] * len(ik.form.sigmas), indexing="ij"), -1).reshape(-1, len(ik.form.sigmas))
    for k, T in enumerate(Ts):
        sols = arm.ik(T)
        for b in np.flatnonzero(np.isfinite(found[:, k]).all(-1)):
            gap = np.abs(np.angle(np.exp(1j * (sols.all_q - found[b, k])))).max(1)
            if gap.min() > 1e-6:
                continue
            label = sols.all_labels[int(gap.argmin())]
            for name_ in ik.sign_names:
                sign = np.prod([signs[b][ik.form.sigmas.index(s)] for s in name_.signs])
                assert (name_.plus if sign > 0 else name_.minus) in label
