"""Poses of a file go to the posture that its words, or the posture it names, select: not to the nearest one."""

import dataclasses

import numpy as np
import pytest

import pieper
from oracle.makers import AT_HOME
from pieper.errors import InputError, NoSolutionError
from pieper.motion.dialects.configuration import MAKERS, is_of
from pieper.motion.dialects.files import DIALECTS
from pieper.motion.dialects.shape import has_shape

LIMITS = pieper.Limits(2.0, 8.0)
LANGUAGES = [d for d, found in DIALECTS.items() if found.maker]
QUARTER = np.pi / 2


def home_of(dialect):
    name, degrees = AT_HOME[dialect]
    return pieper.load(name), np.radians(degrees)


def apart(arm, dialect, a, b):
    """Return how far two postures (k, n) are from each other, but for whole turns without a word."""
    off = np.abs(a - b)
    for k, q in enumerate(b):
        untold = () if dialect == "urscript" else arm.configuration(q, DIALECTS[dialect].maker).untold
        for joint in untold:
            j = arm.joint_names.index(joint)
            off[k, j] = np.abs((off[k, j] + np.pi) % (2 * np.pi) - np.pi)
    return off


def written_and_taken(arm, start, postures, dialect, tmp_path):
    p = pieper.Program(arm, LIMITS, start=start)
    for q in postures:
        p.move_j(q)
    file = tmp_path / f"a{DIALECTS[dialect].suffixes[0]}"
    p.write(file, dialect=dialect, cartesian=True)
    again = pieper.Program(arm, LIMITS, start=start).take(pieper.read_program(file))
    return np.array([move.q for move in again.moves])


def drawn(arm, rng, count):
    low, high = np.clip(arm.limits, -2 * np.pi, 2 * np.pi).T
    out = rng.uniform(low, high, (count, arm.n))
    # joints at just a quarter of a turn, or at zero, are a rounding error from another word
    quarters = np.round(out / QUARTER) * QUARTER
    exact = (rng.random(out.shape) < 0.3) & (quarters > low) & (quarters < high)
    # at just half a turn both ways round have the word for beyond it
    exact &= np.round(out / QUARTER) % 4 != 2
    out = np.where(exact, quarters, out)
    out[:, 4] = np.where(np.abs(np.sin(out[:, 4])) < 0.05, (low[4] + 2 * high[4]) / 3, out[:, 4])
    return out


@pytest.mark.parametrize("dialect", LANGUAGES)
def test_joint_moves_to_poses_come_back_to_the_postures_they_were_written_from(dialect, tmp_path):
    arm, home = home_of(dialect)
    postures = drawn(arm, np.random.default_rng(5), 80)
    if dialect != "urscript":
        clear = [arm.configuration(q, str(DIALECTS[dialect].maker)).clear for q in postures]
        postures = postures[np.array(clear) > 0.03]
    taken = written_and_taken(arm, home, postures, dialect, tmp_path)
    assert len(postures) > 40
    assert apart(arm, dialect, taken, postures).max() < np.radians(0.01)


@pytest.mark.slow
def test_words_of_every_arm_that_has_them_select_the_posture_that_was_written(tmp_path):
    dialects = {d.maker: d.name for d in DIALECTS.values()}
    count = 0
    for name in pieper.catalog():
        arm = pieper.load(name)
        for maker in MAKERS:
            if not is_of(arm.description.manufacturer or "nobody", maker) or not has_shape(arm.plan):
                continue
            postures = drawn(arm, np.random.default_rng(6), 4)
            postures = postures[[arm.configuration(q, maker).clear > 0.03 for q in postures]]
            taken = written_and_taken(arm, (postures[0] + postures[-1]) / 2 + 0.01, postures, dialects[maker], tmp_path)
            assert apart(arm, dialects[maker], taken, postures).max() < np.radians(0.01), name
            count += len(postures)
    assert count > 200


@pytest.mark.parametrize("dialect", [d for d in LANGUAGES if d != "urscript"])
def test_a_straight_wrist_leaves_two_turns_open_and_is_gone_to_all_the_same(dialect, tmp_path):
    arm, home = home_of(dialect)
    straight = home.copy()
    straight[4] = 0.0
    taken = written_and_taken(arm, home, [straight], dialect, tmp_path)
    assert np.abs(arm.fk(taken[0]) - arm.fk(straight)).max() < 2e-6
    assert np.abs(taken[0, :3] - straight[:3]).max() < 1e-4


def test_words_that_no_solution_has_are_told_with_those_there_are(tmp_path):
    arm, home = home_of("rapid")
    file = tmp_path / "a.mod"
    pieper.Program(arm, LIMITS, start=home).move_j(home + 0.2).write(file, cartesian=True)
    file.write_text(file.read_text().replace("[0,0,0,0]", "[3,0,0,0]"))
    (target,) = pieper.read_program(file)
    assert target.words is not None and target.words.turns == (3, 0, 0)
    program = pieper.Program(arm, LIMITS, start=home)
    with pytest.raises(NoSolutionError, match="target 1 of the file says abb's configuration 0 with turns 3, 0, 0"):
        program.take([target])
    program.take([dataclasses.replace(target, words=None)])
    assert np.abs(program.moves[0].q - home - 0.2).max() < 1e-5


def test_a_line_that_ends_in_another_posture_than_its_words_mean_is_told(tmp_path):
    arm, home = home_of("rapid")
    T = arm.fk(home)
    T[:3, 3] += [0.02, 0.03, -0.02]
    file = tmp_path / "a.mod"
    pieper.Program(arm, LIMITS, start=home).move_l(T).write(file)
    targets = pieper.read_program(file)
    assert len(pieper.Program(arm, LIMITS, start=home).take(targets).moves) == 1
    others = arm.ik(arm.fk(home)).q
    other = next(q for q in others if np.sign(q[4]) != np.sign(home[4]))
    with pytest.raises(NoSolutionError, match="the line to it ends in [0-7] with turns"):
        pieper.Program(arm, LIMITS, start=other).take(targets)


def test_words_of_one_maker_are_not_taken_for_another_makers_arm(tmp_path):
    arm, home = home_of("rapid")
    file = tmp_path / "a.mod"
    pieper.Program(arm, LIMITS, start=home).move_j(home + 0.2).write(file, cartesian=True)
    other, there = home_of("krl")
    with pytest.raises(InputError, match="made by KUKA; abb's words"):
        pieper.Program(other, LIMITS, start=there).take(pieper.read_program(file))


def test_a_config_that_is_not_read_is_told(tmp_path):
    arm, home = home_of("fanuc-ls")
    file = tmp_path / "a.ls"
    pieper.Program(arm, LIMITS, start=home).move_j(home - 0.2).write(file, cartesian=True)
    file.write_text(file.read_text().replace("CONFIG : 'N", "CONFIG : 'X"))
    with pytest.raises(InputError, match="CONFIG 'X U T, 0, 0, [01]' is not read: it is N or F"):
        pieper.read_program(file)
