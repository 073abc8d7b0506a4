"""Configuration words: they tell every solution of a pose from the others, whole turns included."""

import re
from dataclasses import replace

import numpy as np
import pytest

import pieper
from pieper.errors import InputError
from pieper.motion.dialects.configuration import MAKERS
from pieper.motion.dialects.shape import _signs, axes_at, has_shape

ARMS = [
    (name, maker)
    for name in pieper.catalog()
    for maker, (said, *_) in MAKERS.items()
    if any(word in pieper.load(name).description.manufacturer.lower() for word in said)
]
#: Wrists that do not meet in a point, or seven joints: the makers' words are not defined for them here.
WITHOUT = {
    "abb-gofa-crb15000-5-95",
    "denso-cobotta",
    "fanuc-crx-10ia",
    # their joints are coupled: words are said of arm.uncoupled()
    "fanuc-crx-10ia-controller",
    "fanuc-lr-mate-200id-controller",
    "fanuc-r1000ia-80f-controller",
    "kuka-kr120-r3200-pa",
    "kuka-lbr-iiwa-7-r800",
    "kuka-lbr-iiwa-14-r820",
    "kuka-lwr-4-plus",
    "motoman-ea1400n",
    "motoman-hc10",
    "motoman-sia10d",
    "motoman-sia20d",
}


@pytest.mark.parametrize("name, maker", ARMS)
def test_words_and_turns_select_exactly_one_solution(name, maker):
    arm = pieper.load(name)
    if not has_shape(arm.plan):
        with pytest.raises(InputError, match="another kind of arm|joints are coupled"):
            arm.configuration(np.zeros(arm.n), maker)
        return
    rng = np.random.default_rng(1)
    open_ended = {
        arm.joint_names[j]: (-3.1, 3.1) if j in (1, 2, 4) else (-6.1, 6.1)
        for j in range(6)
        if np.isinf(arm.limits[j]).any()
    }
    arm = arm.with_limits(open_ended) if open_ended else arm
    low, high = arm.limits.T
    several = told = 0
    for _ in range(25):
        q = rng.uniform(low, high)
        rows = arm.ik(arm.fk(q)).windings()
        said = [arm.configuration(row, maker) for row in rows]
        if min(c.clear for c in said) < 1e-6:
            continue
        mine = arm.configuration(q, maker)
        same = rows[[(c.words, c.turns) == (mine.words, mine.turns) for c in said]]
        # whole turns of a joint for which the maker has no word, and which is said to be so
        joints = [arm.joint_names.index(name) for name in mine.untold]
        alike = same[(np.abs(np.delete(same - q, joints, 1)) < 1e-6).all(1)]
        assert len(alike) == len(same) and (len(same) == 1 or joints)
        told += not joints
        several += len(rows) > 1
    assert several > 5
    assert told > 0


def test_the_arms_without_words_are_few_and_known():
    without = {name for name, _ in ARMS if not has_shape(pieper.load(name).plan)}
    assert without == WITHOUT


def test_words_at_postures_that_manuals_show():
    abb = pieper.load("abb-irb2400").configuration(np.radians([10, 0, 0, -20, 30, 100]), "abb")
    assert (abb.words, abb.turns) == (("0",), (0, -1, 1))
    assert "confdata" in abb.rule and "Not confirmed on a controller" in abb.rule
    kuka = pieper.load("kuka-kr6-r900-sixx").configuration(np.radians([-10, -90, 90, 0, 45, 0]), "kuka")
    assert (kuka.words, kuka.turns) == (("6",), (3,))
    fanuc = pieper.load("fanuc-lr-mate-200id").configuration(np.radians([0, 0, 0, 0, -90, 0]), "fanuc")
    assert (fanuc.words, fanuc.turns) == (("N", "U", "T"), (0, 0, 0))
    yaskawa = pieper.load("motoman-gp7").configuration(np.radians([0, 0, 0, 0, -90, 0]), "yaskawa")
    assert (yaskawa.words, yaskawa.turns) == (("1", "0", "0"), (0, 0, 0))


def test_the_words_do_not_change_with_the_place_the_arm_stands_in():
    arm = pieper.load("fanuc-m-20ia")
    moved = arm.with_base(pieper.pose(1, 2, 3, rpy=(0.3, 2.9, -1)) @ arm.base)
    q = np.radians([20, 10, -20, 30, 40, 50])
    ours, theirs = moved.configuration(q, "fanuc"), arm.configuration(q, "fanuc")
    assert (ours.words, ours.turns) == (theirs.words, theirs.turns)


@pytest.mark.parametrize("maker", MAKERS)
def test_an_arm_of_another_maker_has_no_words(maker):
    own = next(name for name, of in ARMS if of == maker and name not in WITHOUT)
    for name in ("abb-irb2400", "kuka-kr6-r900-sixx", "universal-robots-ur5e", "staubli-tx2-60", own):
        arm = pieper.load(name)
        q = np.radians([10, 20, 15, -20, 30, 40])
        if (name, maker) in ARMS:
            assert arm.configuration(q, maker).words
            continue
        with pytest.raises(InputError, match=f"is made by {arm.description.manufacturer}; {maker}'s words"):
            arm.configuration(q, maker)


@pytest.mark.parametrize("line, told", [("", True), ('manufacturer = "Yaskawa Electric"\n', False)])
def test_an_arm_that_names_no_maker_is_taken_for_one_and_its_words_and_files_say_so(line, told, tmp_path):
    arm, file = pieper.load("motoman-gp7"), tmp_path / "mine.toml"
    arm.save(file)
    file.write_text(re.sub("manufacturer = .*\n", line, file.read_text()))
    mine = pieper.load(file)
    assert bool(mine.description.manufacturer) != told
    q = np.radians([10, 20, 15, -20, 30, 40])
    ours, theirs = mine.configuration(q, "yaskawa"), arm.configuration(q, "yaskawa")
    assert (ours.words, ours.turns) == (theirs.words, theirs.turns)
    assert ("names no maker" in ours.rule) == told and "names no maker" not in theirs.rule
    pieper.Program(mine, pieper.Limits(2.0, 8.0), start=q).move_j(q + 0.1).write(tmp_path / "a.jbi")
    head = " ".join((tmp_path / "a.jbi").read_text().replace("\n'", " ").split())
    assert ("names no maker" in head) == told


@pytest.mark.parametrize(
    "maker, q, word",
    [("siemens", np.zeros(6), "abb, kuka"), ("abb", np.zeros(5), "shape"), ("abb", np.zeros((2, 6)), "one joint")],
)
def test_impossible_questions_are_refused(maker, q, word):
    with pytest.raises(InputError, match=word):
        pieper.load("abb-irb2400").configuration(q, maker)


def test_what_words_are_made_of_does_not_depend_on_where_the_frames_of_parallel_axes_stand():
    plain = pieper.load("abb-irb2400").description
    rows = list(plain.rows)
    assert rows[1].alpha == 0.0 and plain.convention == "standard"
    rows[1], rows[2] = replace(rows[1], d=rows[1].d + 0.3), replace(rows[2], d=rows[2].d - 0.3)
    arms = [pieper.Arm.from_dh(r, convention="standard") for r in (plain.rows, rows)]
    for q in np.random.default_rng(6).uniform(-2, 2, (20, 6)):
        one, other = (_signs(arm.plan, *(x[0] for x in axes_at(arm.chain, q[None]))) for arm in arms)
        assert one == pytest.approx(other, abs=1e-12)
