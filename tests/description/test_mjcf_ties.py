"""Constraints and keyframes of MuJoCo models: followers, held joints, curves, rings, named postures."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pieper
from pieper.errors import InputError
from pieper.verify import with_mujoco

mujoco: Any = pytest.importorskip("mujoco")

ARM = """<mujoco model="m"><compiler angle="radian" autolimits="true"/><worldbody>
<body name="a"><joint name="j1" axis="0 0 1" range="-1 1" ref="{r[0]}"/><geom size=".1"/>
<body name="b" pos="1 0 0"><joint name="j2" axis="0 1 0" range="{lead}" ref="{r[1]}"/><geom size=".1"/>
<body name="c" pos="{c}"><joint name="j3" axis="0 1 0" range="{follow}" ref="{r[2]}"/><geom size=".1"/>
<body name="d" pos="0 0.2 1"><joint name="j4" axis="1 0 0" range="-1 1" ref="{r[3]}"/><geom size=".1"/>
<site name="tip" pos="1 0 0"/></body></body></body></body><body name="target" mocap="true"/></worldbody>{more}
<equality>{ties}</equality></mujoco>"""
TWO = '<fixed name="{name}"><joint joint="{a}" coef="{x}"/><joint joint="{b}" coef="{y}"/></fixed>'

THREE = '<fixed name="t">' + "".join(f'<joint joint="j{i}" coef="1"/>' for i in (3, 2, 4)) + "</fixed>"


def load(
    folder: Path,
    ties: str,
    more: str = "",
    *,
    c: str = "0.3 0 1",
    lead: str = "-1 1",
    follow: str = "-9 9",
    r: tuple[float, ...] = (0.0, 0.0, 0.0, 0.0),
    tip: str | None = None,
) -> pieper.Arm:
    file = folder / "m.xml"
    file.write_text(ARM.format(ties=ties, more=more, c=c, lead=lead, follow=follow, r=r), encoding="utf-8")
    return pieper.load(file, tip=tip)


def residual(folder: Path, values: dict[str, float]) -> float:
    """Return by how much MuJoCo itself finds the constraints of joints violated."""
    model = mujoco.MjModel.from_xml_path(str(folder / "m.xml"))
    data = mujoco.MjData(model)
    for name, value in values.items():
        data.joint(name).qpos = value
    mujoco.mj_forward(model, data)
    of_equality = data.efc_type[: data.nefc] == mujoco.mjtConstraint.mjCNSTR_EQUALITY
    return float(np.abs(data.efc_pos[: data.nefc][of_equality]).max())


@pytest.mark.parametrize("place", ["0.3 0 1", "0 0.5 0"])
@pytest.mark.parametrize(
    ("ties", "more"),
    [
        ('<joint joint1="j3" joint2="j2" polycoef="0.1 2 0 0 0"/>', ""),
        ('<joint joint1="j3" joint2="j2" polycoef="-0.4 -0.7 0 0 0"/>', ""),
        ('<tendon tendon1="t" polycoef="0.2 0 0 0 0"/>', TWO.format(name="t", a="j2", x=1.5, b="j3", y=-1)),
        (
            '<tendon tendon1="t" tendon2="u" polycoef="0.2 0.5 0 0 0"/>',
            TWO.format(name="t", a="j2", x=1.5, b="j3", y=-1) + TWO.format(name="u", a="j3", x=1, b="j2", y=0.25),
        ),
    ],
)
def test_a_follower_stands_where_mujoco_itself_finds_the_constraint_kept(
    tmp_path: Path, ties: str, more: str, place: str
):
    r = (0.1, -0.2, 0.3, 0.4)
    arm = load(tmp_path, ties, f"<tendon>{more}</tendon>" if more else "", r=r, c=place)
    assert arm.joint_names == ("j1", "j2", "j4")
    assert any("mimics 'j2'" in note for note in arm.notes)
    model, rng = with_mujoco.build(arm.description), np.random.default_rng(1)
    for q in rng.uniform(-1, 1, (5, 3)):
        assert np.abs(arm.fk(q) - model.fk(q)).max() < 1e-12
        assert np.abs(arm.jacobian(q) - model.jacobian(q)).max() < 1e-12
        follower = float(model._data.joint("j3").qpos[0])
        assert residual(tmp_path, dict(j1=q[0], j2=q[1], j3=follower, j4=q[2])) < 1e-12


@pytest.mark.parametrize(
    ("ties", "more", "tied"),
    [
        (
            '<joint joint1="j3" joint2="j2" polycoef="0.1 2 1 0 0"/>',
            "",
            "follows 'j2' by a curve (polycoef 0.1 2 1 0 0)",
        ),
        ('<joint joint1="j3" joint2="j2" polycoef="0 1 0 0 0.5"/>', "", "by a curve"),
        (
            '<tendon tendon1="t"/>',
            THREE,
            "is tied to",
        ),
    ],
)
def test_a_tie_that_no_coupling_says_is_refused_with_a_cure_that_works(tmp_path: Path, ties: str, more: str, tied: str):
    with pytest.raises(InputError) as raised:
        load(tmp_path, ties, f"<tendon>{more}</tendon>" if more else "")
    said = str(raised.value)
    assert tied in said and "tip='" in said
    joint = said.partition("joint '")[2].partition("'")[0]
    tip = said.partition("tip='")[2].partition("'")[0]
    arm = load(tmp_path, ties, f"<tendon>{more}</tendon>" if more else "", tip=tip)
    assert arm.joint_names == (("j1", "j2") if joint == "j3" else ("j1",))


@pytest.mark.parametrize(
    "ties", ['<joint joint1="j3" polycoef="0.3 2 1 0 0"/>', '<tendon tendon1="t" polycoef="0.15"/>']
)
def test_a_joint_held_still_by_a_constraint_is_no_joint_of_the_arm(tmp_path: Path, ties: str):
    tendon = '<tendon><fixed name="t"><joint joint="j3" coef="0.5"/></fixed></tendon>' if "tendon" in ties else ""
    arm = load(tmp_path, ties, tendon, r=(0.0, 0.1, 0.2, 0.0))
    assert arm.joint_names == ("j1", "j2", "j4")
    assert "Held still by the model's constraints: j3 at 0.5 (rad or m)." in arm.notes
    assert residual(tmp_path, dict(j3=0.5)) < 1e-12
    q = np.array([0.3, -0.4, 0.5])
    assert np.abs(arm.fk(q) - with_mujoco.build(arm.description).fk(q)).max() < 1e-12


def test_what_is_not_active_or_closes_a_ring_is_told_and_a_target_is_not(tmp_path: Path):
    arm = load(tmp_path, '<joint joint1="j3" joint2="j2" active="false"/>')
    assert arm.n == 4 and arm.notes == ("A constraint on j3, j2 is not active at the model's start.",)
    arm = load(tmp_path, '<connect body1="c" body2="a" anchor="0 0 0"/>')
    assert arm.n == 4
    assert arm.notes == (
        "Bodies 'c' and 'a' are held together (connect), which ties j3, j2; here each moves by itself.",
    )
    assert load(tmp_path, '<weld body1="target" body2="d"/>').notes == ()


def test_keyframes_are_postures_of_the_arm_and_lie_where_mujoco_has_them(tmp_path: Path):
    said = '<key name="home" qpos=".1 .2 .3 .4"/><key qpos="0 0 .5 0"/><key name="é &quot;x&quot;" qpos="0 .1 0 0"/>'
    keys = f"<keyframe>{said}</keyframe>"
    arm = load(tmp_path, "", keys)
    assert list(arm.postures) == ["zero", "home", "key_1", 'é "x"']
    model = mujoco.MjModel.from_xml_path(str(tmp_path / "m.xml"))
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, 0)
    mujoco.mj_forward(model, data)
    assert np.abs(arm.fk("home")[:3, 3] - data.site("tip").xpos).max() < 1e-12
    arm.save(tmp_path / "a.toml")
    again = pieper.load(tmp_path / "a.toml")
    assert all(np.array_equal(again.postures[name], q) for name, q in arm.postures.items())
    coupled = load(tmp_path, '<joint joint1="j3" joint2="j2"/>', keys)
    assert coupled.postures["home"].tolist() == [0.1, 0.2, 0.4]


def test_a_follower_s_range_narrows_its_leader_s(tmp_path: Path):
    arm = load(tmp_path, '<joint joint1="j3" joint2="j2" polycoef="0.3 2 0 0 0"/>', follow="-1 1")
    assert np.allclose(arm.limits, [[-1, 1], [-0.65, 0.35], [-1, 1]], atol=1e-15)
    assert any(
        note.startswith("The limits of 'j2' are -0.65 to 0.35 (the file's own: -1 to 1): beyond, 'j3'")
        for note in arm.notes
    )


def test_a_range_the_wrong_way_round_is_told_as_in_other_files(tmp_path: Path):
    """MuJoCo itself takes such a joint as unlimited and says nothing."""
    with pytest.raises(InputError, match="limits of joint 'j2' are swapped"):
        load(tmp_path, "", lead="1 -1")
