"""Of an arm whose joints are coupled the judge takes the values of the axes, in every kind of claim, and says so."""

from __future__ import annotations

import numpy as np
import pytest

import pieper

COUPLED = [name for name in pieper.catalog() if pieper.load(name).description.coupling is not None]


@pytest.mark.parametrize("name", COUPLED)
def test_poses_and_solutions_of_coupled_joints_are_judged_by_the_axes(name, tmp_path):
    arm = pieper.load(name)
    axes = arm.uncoupled()
    lower, upper = np.where(np.isfinite(arm.limits), arm.limits, [-2, 2]).T
    q = np.random.default_rng(1).uniform(lower, upper)
    T, turns = arm.fk(q), np.degrees(arm.coupling @ q)
    rows = np.degrees(axes.ik(T).all_q).round(3).tolist()
    (tmp_path / "c.toml").write_text(
        f'title = "c"\n[arm]\nrobot = "{name}"\n'
        f'[[claim]]\nid = "pose"\nkind = "pose"\nq_deg = {turns.tolist()}\nposition = {T[:3, 3].round(4).tolist()}\n'
        f'[[claim]]\nid = "all"\nkind = "solutions"\nq_deg = {turns.tolist()}\nsolutions_deg = {rows}\n'
        "complete = true\n"
    )
    judged = pieper.check(tmp_path / "c.toml")
    assert [v.status for v in judged.verdicts] == ["holds", "holds"], judged.text()
    assert "values of the axes" in judged.arms[0] and "q2" in judged.arms[0]
    # what the judgement says of the axes is what moves them
    for said in judged.arms[0].split("(")[-1].split(")")[0].split(", "):
        axis, text = said.split(" = ")
        numbers = {f"q{j + 1}": float(value) for j, value in enumerate(q)}
        assert eval(text, {}, numbers) == pytest.approx(float((arm.coupling @ q)[int(axis[5:]) - 1]))


def test_an_arm_whose_joints_move_by_themselves_has_no_such_remark(tmp_path):
    (tmp_path / "c.toml").write_text(
        'title = "c"\n[arm]\nrobot = "denso-vp6242"\n[[claim]]\nid = "1"\nkind = "entry"\nof = "T[4,4]"\nis = "1"\n'
    )
    assert "coupled" not in pieper.check(tmp_path / "c.toml").text()
