"""An arm beside a toolbox: what agrees is said to, and every kind of disagreement is noticed and named."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from pieper.verify import toolboxes
from pieper.verify.comparison import compare
from pieper.verify.placements import placements

ARMS = (
    "denso-vp6242",
    "universal-robots-ur5e",
    "franka-panda",
    "stanford-arm",
    "adept-cobra-600",
    "three-r",
    "rrp-wrist",
)


class Rows:
    """A toolbox of the test's own: rows multiplied out, a Jacobian by the complex step's real cousin; may be spoilt."""

    def __init__(self, arm, turn=None, scale=1.0, shift=0.0):
        self.name, self.words = "rows 1.0", "rows multiplied out."
        d = arm.description
        self.placed = placements(d)
        self.coupling = np.eye(d.n) if d.coupling is None else d.coupling
        self.turn, self.scale, self.shift = turn, scale, shift

    def fk(self, q):
        v = (self.coupling @ q) * self.placed.sense
        T = np.eye(4)
        for before, value, slides in zip(self.placed.before, v, self.placed.slides, strict=True):
            move = np.eye(4)
            if slides:
                move[2, 3] = value
            else:
                move[:2, :2] = [[np.cos(value), -np.sin(value)], [np.sin(value), np.cos(value)]]
            T = T @ before @ move
        T = T @ self.placed.tool
        T[0, 3] += self.shift
        return T if self.turn is None else self.turn @ T

    def jacobian(self, q):
        J, h, R = np.empty((6, len(q))), 1e-3, self.fk(q)[:3, :3]
        for k in range(len(q)):
            step = h * np.eye(len(q))[k]
            # Richardson's: the error of central differences goes with the fourth power of h
            D = [(self.fk(q + m * step) - self.fk(q - m * step)) / (2 * m * h) for m in (1, 2, 3)]
            d = 1.5 * D[0] - 0.6 * D[1] + 0.1 * D[2]
            W = d[:3, :3] @ R.T
            J[:, k] = [*d[:3, 3], W[2, 1], W[0, 2], W[1, 0]]
        return J * self.scale

    def solve(self, T, start):
        return None


def lines(found):
    return {line.what: line for line in found.lines}


@pytest.mark.parametrize("name", ARMS)
def test_poses_agree_and_no_solution_of_the_other_is_missing(name):
    arm = pieper.load(name)
    found = compare(arm, Rows(arm), poses=12)
    assert (
        lines(found)["forward kinematics, position"].agrees and lines(found)["forward kinematics, orientation"].agrees
    )
    assert not len(found.missing)
    put_back = lines(found)["pieper's solutions put back, position"]
    assert put_back.count > 0 and put_back.agrees
    jacobians = [line for what, line in lines(found).items() if what.startswith("Jacobian")]
    assert len(jacobians) == (4 if "P" in arm.joint_types else 2) and max(line.worst for line in jacobians) < 1e-8


def coupled():
    rows = [pieper.DH(a=0, alpha=np.pi / 2, d=0.3), pieper.DH(a=0.3, theta=1.0), pieper.DH(a=0.25)]
    C = [[1, 0, 0], [0, 1, 0], [0, -1, 1]]
    return pieper.Arm.from_dh(rows, convention="standard", coupling=C, limits=[(-1, 1)] * 3)


def test_a_coupled_arm_is_compared_in_the_numbers_of_its_joints():
    arm = coupled()
    found = compare(arm, Rows(arm), poses=8)
    assert lines(found)["forward kinematics, position"].agrees and not len(found.missing)


def test_a_base_that_is_turned_a_wrong_jacobian_and_a_shifted_tool_are_noticed():
    arm = pieper.load("denso-vp6242")
    turn = np.diag([-1.0, -1.0, 1.0, 1.0])
    turned = compare(arm, Rows(arm, turn=turn), poses=8)
    assert not turned.agrees and "do not agree" in turned.explain()
    assert "forward kinematics, position" in turned.explain() and "forward kinematics, orientation" in turned.explain()
    scaled = compare(arm, Rows(arm, scale=1.01), poses=8)
    assert lines(scaled)["forward kinematics, position"].agrees and "Jacobian, linear rows" in scaled.explain()
    shifted = compare(arm, Rows(arm, shift=1e-6), poses=8)
    assert 0.9e-6 < lines(shifted)["forward kinematics, position"].worst < 1.1e-6 and not shifted.agrees
    assert lines(shifted)["forward kinematics, orientation"].agrees


def test_a_solution_that_pieper_does_not_give_is_missing(monkeypatch):
    from pieper.solver import verbs

    arm, solve = pieper.load("denso-vp6242"), verbs.ik

    class Fewer:
        def __init__(self, sols):
            self.all_q, self.self_motions = sols.all_q[1:], sols.self_motions

    monkeypatch.setattr(verbs, "ik", lambda *asked: Fewer(solve(*asked)))
    found = compare(arm, Rows(arm), poses=40)
    assert len(found.missing) and not found.agrees and "missing here" in found.explain()
    for q in found.missing:
        assert np.isfinite(q).all() and len(q) == arm.n


def test_a_toolbox_that_is_unknown_or_not_there_is_named_with_the_cure(monkeypatch):
    arm = pieper.load("denso-vp6242")
    with pytest.raises(pieper.InputError, match="toolboxes are roboticstoolbox, pinocchio, mujoco, got 'klampt'"):
        arm.verify("klampt")
    monkeypatch.setattr(toolboxes, "find_spec", lambda name: None)
    with pytest.raises(pieper.InputError, match=r"pip install 'pieper\[pinocchio\]'"):
        arm.verify("pinocchio")
    with pytest.raises(pieper.InputError, match="poses must be"):
        compare(arm, Rows(arm), poses=0)


@pytest.mark.parametrize("toolbox", toolboxes.KNOWN)
@pytest.mark.parametrize("name", ARMS)
def test_the_toolboxes_agree_with_every_kind_of_arm(toolbox, name):
    pytest.importorskip(toolboxes.KNOWN[toolbox])
    found = pieper.load(name).verify(toolbox, poses=12)
    assert found.agrees, str(found)


@pytest.mark.parametrize("toolbox", toolboxes.KNOWN)
def test_the_toolboxes_are_given_the_coupling_too(toolbox):
    pytest.importorskip(toolboxes.KNOWN[toolbox])
    found = coupled().verify(toolbox, poses=12)
    assert found.agrees, str(found)


def test_pinocchio_reads_the_urdf_itself(tmp_path):
    pytest.importorskip("pinocchio")
    pieper.load("kuka-lwr-4-plus").save(tmp_path / "arm.urdf")
    arm = pieper.load(tmp_path / "arm.urdf")
    found = arm.verify("pinocchio", poses=12)
    assert "read" in found.conventions and "arm.urdf itself" in found.conventions and found.agrees
    T = np.eye(4)
    T[2, 3] = 0.1
    changed = arm.with_tool(arm.tool @ T).verify("pinocchio", poses=4)
    assert "itself" not in changed.conventions and changed.agrees, "a changed arm is no longer what the file says"


def test_mujoco_reads_the_model_itself(tmp_path):
    mujoco = pytest.importorskip("mujoco")
    file = tmp_path / "arm.xml"
    file.write_text(
        """<mujoco><worldbody><body name="one" pos="0 0 .2" euler="10 20 30"><geom size=".1"/>
        <joint name="a" axis="0 0 1" range="-90 90"/><body name="two" pos=".3 0 .1"><geom size=".1"/>
        <joint name="b" axis="1 1 0" pos=".1 0 0" ref="20" range="-90 90"/>
        <body name="three" pos=".2 .1 0"><geom size=".1"/>
        <joint name="c" type="slide" axis="0 1 0" ref="0.05" range="-.2 .3"/>
        <site name="tip" pos="0 0 .1"/></body></body></body></worldbody></mujoco>"""
    )
    found = pieper.load(file, tip="tip").verify("mujoco", poses=12)
    assert mujoco.__version__ in found.toolbox and "arm.xml itself" in found.conventions
    assert all(line.agrees for line in found.lines if "kinematics" in line.what or "Jacobian" in line.what), str(found)


def test_mujoco_reads_a_model_whose_joints_and_bodies_have_no_names(tmp_path):
    pytest.importorskip("mujoco")
    file = tmp_path / "arm.xml"
    # the second joint has the name that the first would be given, and the second body that of the first
    file.write_text(
        """<mujoco><worldbody><body euler="10 20 30"><geom size=".1"/><joint axis="0 0 1" range="-90 90"/>
        <body name="body_1" pos=".3 0 .1"><geom size=".1"/><joint name="joint_0" axis="0 1 0" range="-90 90"/>
        <body pos=".2 .1 0"><geom size=".1"/><joint type="slide" axis="0 1 0" range="-.2 .3"/></body>
        </body></body></worldbody></mujoco>"""
    )
    arm = pieper.load(file)
    assert arm.n == 3 and len(set(arm.joint_names)) == 3
    found = arm.verify("mujoco", poses=12)
    assert "arm.xml itself" in found.conventions
    assert all(line.agrees for line in found.lines if "kinematics" in line.what or "Jacobian" in line.what), str(found)


def test_the_command_line_prints_the_table_and_the_report_has_it(capsys, monkeypatch, tmp_path):
    pytest.importorskip("click")
    from pieper.cli import main
    from pieper.verify import comparison

    arm = pieper.load("three-r")
    monkeypatch.setattr(comparison, "open_toolbox", lambda name, description: Rows(arm))
    for arguments, status in ((["verify", "three-r", "--with", "mujoco", "-n", "8"], (0, 1)),):
        with pytest.raises(SystemExit) as left:
            main(arguments)
        assert left.value.code in status
    said = capsys.readouterr().out
    assert "forward kinematics, position" in said and "rows 1.0" in said and "worst difference" in said
    page = pieper.report(arm, comparison=arm.verify("mujoco", poses=8))
    headings = [str(block) for block in page.blocks if "rows 1.0" in str(block)]
    assert headings
