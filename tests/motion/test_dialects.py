"""Programs for controllers: read back they are the same targets, and what a maker does not take is refused."""

import re

import numpy as np
import pytest

import pieper
from oracle.makers import AT_HOME
from pieper.errors import InputError
from pieper.kinematics.pose import pose_error
from pieper.motion.dialects.files import DIALECTS
from pieper.motion.instructions import Gripper, Move, Output, Wait

TOOL = pieper.pose(0.03, -0.02, 0.15, rpy=(0.1, 0.5, -0.3))


def built(dialect, tool=True):
    name, degrees = AT_HOME[dialect]
    arm = pieper.load(name)
    arm = arm.with_tool(arm.tool @ TOOL) if tool else arm
    q = np.where([kind == "P" for kind in arm.joint_types], degrees, np.radians(degrees))
    p = pieper.Program(arm, pieper.Limits(2.0, 8.0), start=q)
    T = arm.fk(q)
    other = T.copy()
    other[:3, 3] += [0.02, 0.05, -0.03]
    via = other.copy()
    via[:3, 3] += [0.005, -0.025, 0.02]
    p.move_l(other, speed=0.2, blend=0.01).output(2, True).move_c(via, T).wait(0.5)
    p.move_j(q + 0.05, speed=0.4).gripper(1.0).move_j(T)
    return arm, p


def same(target, move, T_via=True):
    if target.q is not None:
        assert np.abs(target.q - move.q).max() < np.radians(1e-3) / 10
    if target.T is not None:
        off = pose_error(target.T, move.T)
        assert off[0] < 1e-6 and off[1] < np.radians(1e-3)


@pytest.mark.parametrize("cartesian", [False, True])
@pytest.mark.parametrize("dialect", [d for d, found in DIALECTS.items() if found.maker])
def test_what_is_written_is_read_back(dialect, cartesian, tmp_path):
    arm, p = built(dialect)
    file = tmp_path / f"weld_1{DIALECTS[dialect].suffixes[0]}"
    p.write(file, dialect=dialect, cartesian=cartesian)
    targets = pieper.read_program(file)
    moves = [item for item in p.instructions if isinstance(item, Move)]
    assert [t.kind for t in targets] == [m.kind for m in moves]
    for target, move in zip(targets, moves, strict=True):
        assert (target.q is None) != (target.T is None)
        same(target, move)
        if move.via is not None:
            assert target.via is not None or target.q_via is not None
            if target.via is not None:
                assert np.abs(target.via[:3, 3] - move.via[:3, 3]).max() < 1e-6
            else:
                assert np.abs(arm.fk(target.q_via)[:3, 3] - move.via[:3, 3]).max() < 2e-5
    joint_moves = [t for t in targets if t.kind == "move_j"]
    if dialect != "inform":
        assert all((t.q is None) == cartesian for t in joint_moves)
    text = file.read_text()
    assert text.isascii() and "Not confirmed on a controller" in text


@pytest.mark.parametrize("dialect", ["ros", "csv"])
def test_trajectories_are_read_back(dialect, tmp_path):
    _, p = built(dialect, tool=False)
    file = tmp_path / f"weld{DIALECTS[dialect].suffixes[0]}"
    p.write(file, dialect=dialect, rate=50.0)
    targets = pieper.read_program(file)
    motion = p.motion(rate=50.0)
    q = np.array([t.q for t in targets])
    assert q.shape == motion.q.shape
    assert np.abs(q - motion.q).max() < 2e-9 and {t.kind for t in targets} == {"point"}


def test_yaml_of_ros_is_yaml(tmp_path):
    yaml = pytest.importorskip("yaml")
    _, p = built("ros", tool=False)
    p.write(tmp_path / "a.yaml", dialect="ros", rate=20.0)
    found = yaml.safe_load((tmp_path / "a.yaml").read_text())
    assert len(found["joint_names"]) == 7 and found["points"][0]["time_from_start"] == {"sec": 0, "nanosec": 0}


def test_every_arm_of_a_maker_can_be_written_for_it(tmp_path):
    from pieper.motion.dialects.configuration import MAKERS, is_of
    from pieper.motion.dialects.shape import has_shape

    dialects = {"abb": "rapid", "kuka": "krl", "fanuc": "fanuc-ls", "yaskawa": "inform", "denso": "pacscript"}
    count = 0
    for name in pieper.catalog():
        arm = pieper.load(name)
        for maker in MAKERS:
            if not is_of(arm.description.manufacturer or "nobody", maker) or not has_shape(arm.plan):
                continue
            low, high = np.clip(arm.limits, -3, 3).T
            q = low + 0.6 * (high - low)
            p = pieper.Program(arm, pieper.Limits(1.0, 1.0), start=q).move_j(q - 0.1 * (high - low))
            file = tmp_path / f"p{DIALECTS[dialects[maker]].suffixes[0]}"
            for cartesian in (False, True):
                p.write(file, dialect=dialects[maker], cartesian=cartesian)
                (target,) = pieper.read_program(file)
                same(target, p.moves[0])
            count += 1
    assert count > 35


def test_fanuc_counts_joint_3_from_the_level(tmp_path):
    _, p = built("fanuc-ls")
    p.write(tmp_path / "a.ls", dialect="fanuc-ls")
    text = (tmp_path / "a.ls").read_text()
    q = np.degrees(p.moves[-2].q)
    assert f"J3= {q[2] - q[1]:.5f} deg" in text


@pytest.mark.parametrize(
    "dialect, arm_dialect, name, word",
    [
        ("fortran", "rapid", None, "'rapid', 'urscript', 'krl'"),
        ("krl", "rapid", None, "another maker"),
        ("urscript", "fanuc-ls", None, "another maker"),
        ("krl", "krl", "a" * 25, "24 characters"),
        ("rapid", "rapid", "pièce", "ASCII"),
        ("rapid", "rapid", "2nd", "begins with a letter"),
        ("rapid", "ros", None, "another maker"),
        ("urscript", "urscript", "end", "a word of urscript itself"),
        ("urscript", "urscript", "movej", "a word of urscript itself"),
        ("rapid", "rapid", "EndProc", "a word of rapid itself"),
        ("krl", "krl", "Ptp", "a word of krl itself"),
        ("pacscript", "pacscript", "Sub", "a word of pacscript itself"),
    ],
)
def test_what_a_maker_does_not_take_is_refused_and_nothing_is_written(dialect, arm_dialect, name, word, tmp_path):
    _, p = built(arm_dialect, tool=False)
    file = tmp_path / "weld.txt"
    with pytest.raises(InputError, match=word):
        p.write(file, dialect=dialect, name=name)
    assert not file.exists()


def test_files_that_are_no_programs_are_refused(tmp_path):
    with pytest.raises(InputError, match="ending"):
        pieper.read_program(tmp_path / "a.xyz")
    (tmp_path / "c.mod").write_text("\n \n")
    with pytest.raises(InputError, match=r"c\.mod is empty"):
        pieper.read_program(tmp_path / "c.mod")
    with pytest.raises(InputError, match="cannot read"):
        pieper.read_program(tmp_path / "a.mod")
    (tmp_path / "b.mod").write_text("MODULE b\n PROC main()\n MoveAbsJ p9,v100,fine,tool0;\n ENDPROC\nENDMODULE\n")
    with pytest.raises(InputError, match="not rapid"):
        pieper.read_program(tmp_path / "b.mod")


@pytest.mark.parametrize("turned", [100.0, 180.0, 270.0, 350.0])
@pytest.mark.parametrize("dialect", [d for d, found in DIALECTS.items() if found.maker])
def test_a_long_circle_is_written_in_pieces_of_less_than_half_a_turn(dialect, turned, tmp_path):
    name, degrees = AT_HOME[dialect]
    arm = pieper.load(name)
    q = np.radians(degrees)
    T, centre = arm.fk(q), arm.fk(q)[:3, 3] + [0.0, 0.0, -0.03]

    def at(angle):
        out = T.copy()
        out[:3, 3] = centre + 0.03 * np.array([0.0, np.sin(angle), np.cos(angle)])
        return out

    end = np.radians(turned)
    # the via is not in the middle
    p = pieper.Program(arm, pieper.Limits(2.0, 8.0), start=q).move_c(at(0.3 * end), at(end), blend=0.004).move_l(T)
    file = tmp_path / f"c{DIALECTS[dialect].suffixes[0]}"
    p.write(file, dialect=dialect, name="c", cartesian=True)
    targets = pieper.read_program(file)
    assert [t.kind for t in targets] == ["move_c"] * (1 + (turned > 170) + (turned > 340)) + ["move_l"]
    here, gone = T[:3, 3], 0.0
    for t in targets[:-1]:
        for point in (t.via[:3, 3], t.T[:3, 3]):
            assert abs(np.linalg.norm(point - centre) - 0.03) < 1e-6
            u, v = here - centre, point - centre
            angle = np.arctan2(np.cross(v, u) @ [1, 0, 0], u @ v)
            # between a start, a via and an end there is less than half a turn, the way round that was asked for
            assert 0 < angle < np.radians(90)
            here, gone = point, gone + angle
    assert gone == pytest.approx(end, abs=1e-4)
    same(targets[-2], p.moves[0])
    # as joint values, too, every point of the pieces lies on the circle
    if dialect in ("urscript", "fanuc-ls"):
        p.write(file, dialect=dialect, name="c")
        for t in pieper.read_program(file)[:-1]:
            for posture in (t.q_via, t.q):
                assert abs(np.linalg.norm(arm.fk(posture)[:3, 3] - centre) - 0.03) < 2e-5


#: How each dialect says the speed of a line or circle, and how many of its units are a metre a second.
LINE_SPEED = {
    "rapid": (r"speeddata vp[3-6]:=\[([\d.]+)", 1000.0),
    "urscript": (r"mov[e][lc]\(.*v=([\d.]+)", 1.0),
    "krl": (r"\$VEL\.CP=([\d.]+)", 1.0),
    "fanuc-ls": (r" ([\d.]+)mm/sec", 1000.0),
    "inform": (r"MOV[LC].* V=([\d.]+)", 1000.0),
    "pacscript": (r"Move [LC].*' ([\d.]+) mm/s", 1000.0),
}


@pytest.mark.parametrize("dialect", LINE_SPEED)
def test_every_line_says_its_own_speed_within_the_limit_of_the_tools(dialect, tmp_path):
    name, degrees = AT_HOME[dialect]
    arm, q = pieper.load(name), np.radians(degrees)
    T = arm.fk(q)
    near, via = T.copy(), T.copy()
    near[:3, 3] += [0.01, 0.01, 0.0]
    via[:3, 3] += [0.01, 0.0, 0.01]
    for most, written in ((0.05, {0.05, 0.01}), (None, {0.25, 0.01, 0.4})):
        p = pieper.Program(arm, pieper.Limits(0.1, 1.0, tool_speed=most), start=q)
        p.move_j(q + 0.01).move_j(q, speed=0.5).move_l(near, speed=0.01).move_l(T).move_l(near, speed=0.4).move_c(
            via, T
        )
        file = tmp_path / f"s{DIALECTS[dialect].suffixes[0]}"
        p.write(file, dialect=dialect, name="s", cartesian=True)
        text = file.read_text()
        pattern, unit = LINE_SPEED[dialect]
        speeds = [float(v) / unit for v in re.findall(pattern, text)]
        # none is inherited from the move before
        assert len(speeds) >= 4 and speeds[:2] == [0.01, min(written - {0.01, 0.4})]
        assert set(speeds) == written
        words = " ".join(re.sub(r"[!;#'\d:]+", " ", text).split())
        assert ("not of the limits" in words) == (dialect != "urscript")


def arc_job(tmp_path, between):
    name, degrees = AT_HOME["inform"]
    arm, q = pieper.load(name), np.radians(degrees)
    T = arm.fk(q)
    end, via = T.copy(), T.copy()
    end[:3, 3] += [0.03, 0.03, 0.01]
    via[:3, 3] += [0.01, 0.02, 0.01]
    p = pieper.Program(arm, pieper.Limits(2.0, 8.0), start=q).move_l(end).move_c(via, T)
    if between:
        p.wait(0.1)
    p.move_c(via, end).move_l(T)
    file = tmp_path / "a.jbi"
    p.write(file)
    return p, file


@pytest.mark.parametrize("between", [False, True])
def test_an_arc_of_inform_is_three_movc(between, tmp_path):
    p, file = arc_job(tmp_path, between)
    words = re.findall(r"^(MOV.) (C\d+)", file.read_text(), re.M)
    assert "".join(word[-1] for word, _ in words) == "LCCCLCCCL"
    # an arc begins where the way before it ends
    assert words[1][1] == words[0][1] and words[5][1] == words[4][1] == words[3][1]
    targets = pieper.read_program(file)
    assert [t.kind for t in targets] == ["move_l", "move_c", "move_c", "move_l"]
    for target, move in zip(targets, p.moves, strict=True):
        same(target, move)


def test_other_counts_of_movc_are_refused(tmp_path):
    _, file = arc_job(tmp_path, False)
    lines = file.read_text().splitlines()
    at = next(k for k, line in enumerate(lines) if line.startswith("MOVC"))
    for changed in (lines[:at] + lines[at + 1 :], lines[:at] + [lines[at]] + lines[at:]):
        file.write_text("\n".join(changed))
        with pytest.raises(InputError, match="three MOVC"):
            pieper.read_program(file)
    # from elsewhere the way to an arc's beginning is a line
    file.write_text("\n".join(lines[: at - 1] + ["MOVL C00001 V=100.0"] + lines[at:]))
    assert [t.kind for t in pieper.read_program(file)][:3] == ["move_l", "move_l", "move_c"]


#: Lines of each language that say or change a target in another way than is written here.
FOREIGN = {
    "rapid": ["MoveL Offs(p1,0,0,50),v100,fine,tool0;", "MoveJ *,v100,z10,tool0;", "MoveL p1,v100,fine,tool0\\CRobT;"],
    "urscript": [
        "movej([0, d2r(-90), 1.57, 0, 0, 0])",
        "movep(p[.3,.2,.1,0,3.14,0])",
        "movel(pose_add(p[0,0,0,0,0,0], p[.3,.2,.1,0,3.14,0]))",
        "servoj([0,0,0,0,0,0])",
    ],
    "krl": [
        "LIN_REL {Z 50}",
        "SLIN {X 500,Y 0,Z 650,A 0,B 90,C 0}",
        "lin {X 500,Y 0,Z 650,A 0,B 90,C 0}",
        "CIRC {X 500,Y 10,Z 600,A 0,B 0,C 0},{X 510,Y 20,Z 600,A 0,B 90,C 0},CA 360",
        "PTP {A1 30}",
        "$BASE=BASE_DATA[1]",
    ],
    "fanuc-ls": [
        "  99:J PR[1] 100% FINE ;",
        "  99:L P[1] 100mm/sec FINE Offset,PR[1] ;",
        "  99:A P[2] 100mm/sec CNT50 ;",
    ],
    "inform": [
        "///POSTYPE PULSE",
        "MOVL P001 V=100.0",
        "MOVS C00001 V=100.0",
        "IMOV P001 V=10.0",
        "MOVL C00001 V=10 FPL=1",
    ],
    "pacscript": ["Approach P, P1, 50", "Move L, @P P1", "Move P, @E J(1, 2, 3, 4, 5, 6) , Next", "Draw L, P(0, 0, 5)"],
}


@pytest.mark.parametrize("dialect", FOREIGN)
def test_no_line_is_passed_over_and_none_taken_for_another(dialect, tmp_path):
    _, p = built(dialect)
    file = tmp_path / f"f{DIALECTS[dialect].suffixes[0]}"
    p.write(file, dialect=dialect, cartesian=True, name="f")
    lines = file.read_text().splitlines()
    known = len(pieper.read_program(file))
    for foreign in [*FOREIGN[dialect], "JUMP TO LABEL"]:
        for at in (1, len(lines) // 2, len(lines) - 1):
            file.write_text("\n".join([*lines[:at], foreign, *lines[at:]]))
            with pytest.raises(InputError, match=f"line {at + 1} is not {dialect}"):
                pieper.read_program(file)
    file.write_text("\n".join(lines))
    assert len(pieper.read_program(file)) == known


@pytest.mark.parametrize(
    "dialect, was, becomes",
    [
        ("rapid", r",tPieper;", r",tOther;"),
        ("rapid", r",tPieper;", r",tPieper\\WObj:=wOther;"),
        ("fanuc-ls", r"/POS", "  99:UFRAME_NUM=4 ;\n/POS"),
        ("pacscript", r"  GiveArm", "  ChangeWork 3\n  GiveArm"),
        ("ros", r"- joint_2\n", ""),
    ],
)
def test_a_tool_or_frame_that_the_file_does_not_set_is_told(dialect, was, becomes, tmp_path):
    _, p = built(dialect if dialect != "ros" else "rapid")
    file = tmp_path / f"f{DIALECTS[dialect].suffixes[0]}"
    p.write(file, dialect=dialect, cartesian=True, name="f")
    text, count = re.subn(was, becomes, file.read_text(), count=1)
    assert count == 1
    file.write_text(text)
    with pytest.raises(InputError, match="nowhere set" if dialect != "ros" else "positions for 5 joints"):
        pieper.read_program(file)


def happenings(items):
    """Return what happens before each move, and after the last one."""
    out = [[]]
    for item in items:
        if isinstance(item, Move):
            out.append([])
        elif isinstance(item, (Wait, Output, Gripper)):
            out[-1].append(item)
    return out


@pytest.mark.parametrize("cartesian", [False, True])
@pytest.mark.parametrize("dialect", [d for d, found in DIALECTS.items() if found.maker])
def test_speeds_blends_and_what_happens_are_read_back(dialect, cartesian, tmp_path):
    _, p = built(dialect)
    p.output(7, False).wait(0.25)
    file = tmp_path / f"weld_1{DIALECTS[dialect].suffixes[0]}"
    p.write(file, dialect=dialect, cartesian=cartesian)
    targets = pieper.read_program(file)
    moves = [item for item in p.instructions if isinstance(item, Move)]
    for target, move in zip(targets, moves, strict=True):
        if move.kind == "move_j" and dialect == "urscript":
            assert target.speed is None
            assert target.joint_speed == pytest.approx(2.0 * (move.speed or 1.0), abs=1e-4)
        else:
            wanted = move.speed or (1.0 if move.kind == "move_j" else 0.25)
            assert target.speed == pytest.approx(wanted, rel=6e-3 if dialect == "krl" else 1e-3)
        # CNT and PL are no radii
        assert target.blend == (None if move.blend and dialect in ("fanuc-ls", "inform") else pytest.approx(move.blend))
    *before, after = happenings(p.instructions)
    assert [list(t.before) for t in targets] == before
    assert list(targets[-1].after) == after and all(not t.after for t in targets[:-1])


@pytest.mark.parametrize("dialect", [d for d, found in DIALECTS.items() if found.maker])
def test_a_program_taken_from_its_file_is_the_same_motion(dialect, tmp_path):
    arm, p = built(dialect)
    told = pieper.Program(arm, p.limits, start=p.start)
    for item in p.instructions:
        if not isinstance(item, Move):
            told.instructions.append(item)
        elif item.kind == "move_j":
            told.move_j(item.q, speed=item.speed, blend=item.blend)
        elif item.kind == "move_l":
            told.move_l(item.T, speed=0.2, blend=item.blend)
        else:
            told.move_c(item.via, item.T, speed=0.15, blend=item.blend)
    file = tmp_path / f"weld_1{DIALECTS[dialect].suffixes[0]}"
    told.write(file, dialect=dialect)
    taken = pieper.Program(arm, p.limits, start=p.start).take(pieper.read_program(file))
    a, b = told.motion(), taken.motion()
    assert [e[1:] for e in b.events] == [e[1:] for e in a.events]
    if dialect in ("fanuc-ls", "inform"):
        assert b.duration > a.duration
    else:
        assert b.duration == pytest.approx(a.duration, rel=2e-3)
        assert np.abs(np.array([e[0] for e in a.events]) - [e[0] for e in b.events]).max() < 5e-3
