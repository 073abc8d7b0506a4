"""Tools and work frames that change within a program: in its motion, in every dialect and in its own file."""

import numpy as np
import pytest

import pieper
from oracle.makers import AT_HOME
from pieper.kinematics.pose import inverse, pose_error
from pieper.motion.dialects.files import DIALECTS
from pieper.motion.instructions import Move

GRIPPER = pieper.pose(0.01, 0.02, 0.11, rpy=(0.2, -0.1, 0.4))
TORCH = pieper.pose(-0.02, 0.01, 0.16, rpy=(-0.3, 0.5, 0.1))
TABLE = pieper.pose(0.3, -0.2, 0.1, rpy=(0.1, -0.2, 0.7))


def moved(T, x=0.0, y=0.0, z=0.0):
    out = T.copy()
    out[:3, 3] += [x, y, z]
    return out


def built(name, degrees):
    """A program with two tools and a frame, and for each move the tool, the frame and the pose in the base."""
    arm = pieper.load(name).with_tool(GRIPPER)
    q = np.where([kind == "P" for kind in arm.joint_types], degrees, np.radians(degrees))
    p = pieper.Program(arm, pieper.Limits(2.0, 8.0), start=q)
    torch = arm.with_tool(TORCH)
    T = arm.fk(q)
    meant = []

    def add(tool, frame, T):
        meant.append((tool, frame, T))
        return inverse(frame) @ T

    p.move_l(add(GRIPPER, np.eye(4), moved(T, y=0.03)), blend=0.01)
    p.tool(TORCH).output(1, True)
    U = torch.fk(p.moves[-1].q)
    p.frame(TABLE).move_l(add(TORCH, TABLE, moved(U, z=-0.02)), speed=0.1)
    via = moved(U, x=0.006, z=-0.01)
    p.move_c(inverse(TABLE) @ via, add(TORCH, TABLE, U))
    p.move_j(add(TORCH, TABLE, moved(U, y=-0.02)))
    p.frame(np.eye(4)).move_l(add(TORCH, np.eye(4), U))
    p.tool(GRIPPER)
    p.move_l(add(GRIPPER, np.eye(4), T))
    return arm, p, meant


@pytest.fixture(scope="module")
def denso():
    return built(*AT_HOME["pacscript"])


def test_targets_are_where_the_tool_of_then_goes(denso):
    arm, p, meant = denso
    for move, (tool, _, T) in zip(p.moves, meant, strict=True):
        assert (pose_error(arm.with_tool(tool).fk(move.q), T) < 1e-9).all()


def test_a_change_of_the_tool_is_a_stop_and_nothing_jumps(denso):
    arm, p, _ = denso
    motion = p.motion(rate=1000.0)
    assert motion.margin <= 1 and any("blend is left out" in remark for remark in motion.remarks)
    assert np.abs(np.diff(motion.q, axis=0)).max() < 2.0 * 1.01e-3
    rests = [motion.at(t) for t in motion.arrivals]
    assert np.abs(motion.dq[rests]).max() < 1e-9
    # the torch goes straight where it was told to: through the frame's own line
    first, second = p.moves[0].q, p.moves[1].q
    a, b = (int(np.argmin(np.abs(motion.q - q).max(1))) for q in (first, second))
    points = arm.with_tool(TORCH).fk(motion.q[a : b + 1])[:, :3, 3]
    assert np.ptp(points[:, :2], axis=0).max() < 2.2e-5
    text = p.explain()
    assert "tool at" in text and "targets in the frame at x 300.0" in text


@pytest.mark.parametrize("cartesian", [False, True])
@pytest.mark.parametrize("dialect", [d for d, found in DIALECTS.items() if found.maker])
def test_every_dialect_is_read_back_with_tools_and_frames(dialect, cartesian, tmp_path):
    arm, p, meant = built(*AT_HOME[dialect])
    file = tmp_path / f"t{DIALECTS[dialect].suffixes[0]}"
    p.write(file, dialect=dialect, name="t", cartesian=cartesian)
    targets = pieper.read_program(file)
    assert [t.kind for t in targets] == [m.kind for m in p.moves]
    for k, (target, move, (tool, frame, T)) in enumerate(zip(targets, p.moves, meant, strict=True)):
        if target.q is not None:
            assert np.abs(target.q - move.q).max() < np.radians(1e-3) / 10
        else:
            off = pose_error(target.T, T)
            assert off[0] < 1e-6 and off[1] < np.radians(1e-3)
            assert (target.frame is None) == np.array_equal(frame, np.eye(4))
            if target.frame is not None:
                assert (pose_error(target.frame, frame) < 2e-6).all()
        # a file does not set what the controller has been told already: the arm's own tool
        if target.tool is not None:
            assert target.means_tool(tool)
        else:
            assert np.array_equal(tool, GRIPPER) and dialect in ("fanuc-ls", "inform", "pacscript")
        if move.via is not None and target.via is not None:
            assert np.abs(target.via[:3, 3] - move.via[:3, 3]).max() < 1e-6, k
    assert file.read_text().isascii()


@pytest.mark.parametrize("dialect", ["ros", "csv"])
def test_trajectories_hold_the_joints_that_the_tools_ask_for(dialect, tmp_path):
    _, p, _ = built(*AT_HOME["csv"])
    file = tmp_path / f"t{DIALECTS[dialect].suffixes[0]}"
    p.write(file, dialect=dialect, rate=50.0)
    q = np.array([t.q for t in pieper.read_program(file)])
    assert np.abs(q - p.motion(rate=50.0).q).max() < 2e-9


def test_its_own_file_keeps_tools_and_frames(denso, tmp_path):
    arm, p, _ = denso
    pieper.save_program(p, tmp_path / "a.toml")
    text = (tmp_path / "a.toml").read_text()
    assert "tool = [-20" in text and "frame = [300" in text
    back = pieper.load_program(arm, tmp_path / "a.toml")
    assert len(back.instructions) == len(p.instructions)
    for a, b in zip(p.moves, back.moves, strict=True):
        assert a.kind == b.kind and np.abs(a.q - b.q).max() < 1e-9
    pieper.save_program(back, tmp_path / "b.toml")
    assert (tmp_path / "b.toml").read_text() == text


def test_what_is_called_keeps_its_own_tools_and_gives_back_those_of_the_caller(denso):
    arm, other, _ = denso
    p = pieper.Program(arm, pieper.Limits(2.0, 8.0), start=other.start)
    p.tool(TORCH).frame(TABLE).call(other, times=2)
    assert len(p.moves) == 2 * len(other.moves)
    for a, b in zip(p.moves[: len(other.moves)], other.moves, strict=True):
        assert np.abs(a.q - b.q).max() < 1e-9
    here = arm.with_tool(TORCH).fk(p.moves[-1].q)
    p.move_l(inverse(TABLE) @ moved(here, z=0.01))
    assert (pose_error(arm.with_tool(TORCH).fk(p.moves[-1].q), moved(here, z=0.01)) < 1e-9).all()
    assert p.motion().margin <= 1


def test_what_changes_nothing_is_no_instruction_and_bad_ones_are_refused(denso):
    arm, other, _ = denso
    p = pieper.Program(arm, pieper.Limits(2.0, 8.0), start=other.start)
    p.tool(GRIPPER).frame(np.eye(4))
    assert not p.instructions
    for bad in (lambda: p.tool(np.eye(3)), lambda: p.tool("no such tool"), lambda: p.frame(2 * np.eye(4))):
        with pytest.raises(pieper.InputError):
            bad()
    assert not p.instructions and isinstance(other.instructions[0], Move)


def test_the_command_reads_a_file_with_tools(denso, tmp_path, capsys):
    from pieper.cli import main

    arm, p, _ = denso
    arm.save(tmp_path / "arm.toml")
    p.write(tmp_path / "t.pcs", cartesian=True)
    start = " ".join(f"{v:.9f}" for v in np.degrees(p.start))
    words = ["program", str(tmp_path / "arm.toml"), str(tmp_path / "t.pcs"), "--speed", "100", "--acceleration", "400"]
    with pytest.raises(SystemExit) as left:
        main([*words, "--start", start, "--write", str(tmp_path / "back.toml")])
    assert left.value.code == 0, capsys.readouterr()
    back = pieper.load_program(arm, tmp_path / "back.toml")
    for a, b in zip(p.moves, back.moves, strict=True):
        assert np.abs(a.q - b.q).max() < 1e-5
