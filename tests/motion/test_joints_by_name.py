"""Files that name joints are read by the names: columns in any order and unit, and nobody else's motion."""

import csv

import numpy as np
import pytest

import pieper

ARM = pieper.load("denso-vp6242")
LIMITS = pieper.Limits(speed=2, acceleration=8)
HOME = ARM.postures["line-start"]
CELL = pieper.Arm.from_dh(
    [pieper.DH(0, 0, 0, 0), pieper.DH(0.4, 0, 0, 0), pieper.DH(0.3, np.pi, 0, 0)],
    convention="standard",
    joint_types="PRR",
    limits=[(0, 0.5), (-2, 2), (-2, 2)],
)


def written(tmp_path, name, arm=ARM, start=HOME):
    dialect = "ros" if name.endswith("yaml") else "csv"
    pieper.Program(arm, LIMITS, start=start).move_j(start + 0.1).write(tmp_path / name, dialect=dialect)
    return tmp_path / name


def table(path):
    with open(path, newline="") as file:
        return list(csv.reader(file))


def kept(path, rows):
    with open(path, "w", newline="") as file:
        csv.writer(file).writerows(rows)
    return path


def test_columns_may_stand_in_any_order(tmp_path):
    rows = table(written(tmp_path, "m.csv"))
    expected = pieper.read_motion(tmp_path / "m.csv", ARM)
    for number in range(8):
        order = [0, *(1 + np.random.default_rng(number).permutation(len(rows[0]) - 1))]
        file = kept(tmp_path / "p.csv", [[row[i] for i in order] for row in rows])
        read = pieper.read_motion(file, ARM)
        for what in ("t", "q", "dq", "ddq"):
            assert np.array_equal(getattr(read, what), getattr(expected, what))
        taken = pieper.Program(ARM, LIMITS, start=HOME).take(pieper.read_program(file)).motion()
        assert np.abs(taken.q[-1] - expected.q[-1]).max() < 1e-9


@pytest.mark.parametrize(("arm", "start"), [(ARM, HOME), (CELL, np.array([0.1, 0.2, 0.3]))])
def test_a_columns_unit_is_the_one_in_its_name(tmp_path, arm, start):
    motion = pieper.Program(arm, LIMITS, start=start).move_j(start + 0.1).motion()
    for degrees in (False, True):
        for mm in (False, True):
            motion.save(tmp_path / "m.csv", degrees=degrees, mm=mm)
            read = pieper.read_motion(tmp_path / "m.csv", arm)
            for what in ("q", "dq", "ddq"):
                assert np.abs(getattr(read, what) - getattr(motion, what)).max() < 1e-12
            targets = pieper.read_program(tmp_path / "m.csv")
            assert np.abs(targets[-1].q - motion.q[-1]).max() < 1e-12


def test_a_trajectorys_joints_are_the_ones_it_names(tmp_path):
    text = written(tmp_path, "m.yaml").read_text()
    expected = pieper.read_motion(tmp_path / "m.yaml", ARM)
    swapped = text.replace("joint_1", "?").replace("joint_2", "joint_1").replace("?", "joint_2")
    (tmp_path / "s.yaml").write_text(swapped)
    read = pieper.read_motion(tmp_path / "s.yaml", ARM)
    assert np.array_equal(read.q, expected.q[:, [1, 0, 2, 3, 4, 5]])
    assert [t.joints[0] for t in pieper.read_program(tmp_path / "s.yaml")][:1] == ["joint_2"]


def test_another_arms_motion_is_refused_by_its_names(tmp_path):
    other = pieper.load("ur5e")
    for name in ("m.csv", "m.yaml"):
        file = written(tmp_path, name)
        with pytest.raises(pieper.InputError, match=r"shoulder_pan.*Is it a motion of another arm\?"):
            pieper.read_motion(file, other)
        with pytest.raises(pieper.InputError, match="names 6 joints"):
            pieper.Program(other, LIMITS, start=np.full(6, 0.1)).take(pieper.read_program(file))


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda rows: [[rows[0][0], rows[0][2], *rows[0][2:]], *rows[1:]], "names joint_2 twice"),
        (lambda rows: [[name.replace("joint_3_deg", "joint_3_mm") for name in rows[0]], *rows[1:]], "joint_3 turns"),
        (lambda rows: rows[:1], "a head and no row"),
        (lambda rows: [*rows, rows[-1]], "times must rise"),
        (lambda rows: [*rows[:-1], rows[-1][:-1]], "another number of columns"),
        (lambda rows: [[row[0], *row[2:]] for row in rows], "names 5 joints"),
        (lambda rows: [*rows[:-1], [rows[-1][0], "x", *rows[-1][2:]]], "all numbers be finite"),
    ],
)
def test_a_table_that_says_no_motion_is_refused(tmp_path, change, words):
    file = kept(tmp_path / "p.csv", change(table(written(tmp_path, "m.csv"))))
    with pytest.raises(pieper.InputError, match=words) as told:
        pieper.read_motion(file, ARM)
    assert str(told.value).startswith("p.csv")


MAKERS = {
    "p.mod": "abb-irb2400",
    "p.script": "universal-robots-ur5e",
    "p.src": "kuka-kr16-2",
    "p.ls": "fanuc-lr-mate-200id",
    "p.jbi": "motoman-gp12",
    "p.pcs": "denso-vp6242",
}


@pytest.mark.parametrize("name", MAKERS)
def test_a_program_in_which_nothing_moves_comes_back(tmp_path, name):
    arm = pieper.load(MAKERS[name])
    start = np.clip([0.1, -0.3, 0.3, 0.2, 0.6, 0.1], *arm.limits.T)
    program = pieper.Program(arm, LIMITS, start=start).wait(0.5).output(3, True).gripper(1)
    program.write(tmp_path / name)
    targets = pieper.read_program(tmp_path / name)
    assert [target.kind for target in targets] == ["stay"]
    assert pieper.Program(arm, LIMITS, start=start).take(targets).motion().events == program.motion().events
