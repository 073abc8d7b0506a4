"""Slips of one place told by their own words: a slide, a zero, columns, inverses, a lost half, the sign of a wrist."""

from __future__ import annotations

import tomllib
from fractions import Fraction
from types import SimpleNamespace

import numpy as np
import pytest

from pieper.algebra.parser import parse
from pieper.errors import InputError
from pieper.judge.arm_sides import arm_features
from pieper.judge.arms import read_arm
from pieper.judge.difference import difference_from_matrix
from pieper.judge.products import MAX_DEPTH
from pieper.judge.samples import samples_at
from pieper.judge.search import lookup
from tests.judge.test_excerpt_lines import guessed
from tests.judge.test_slips_of_pages import LINKS, PUMA, verdict

POLAR = """[arm]
convention = "standard"
length_unit = "m"
columns = ["theta", "d", "a", "alpha"]
rows = [["q1", 0.3, 0, "-90 deg"], [0, "q2", 0.1, "90 deg"], ["q3", 0, 0.2, 0]]
"""


def told(arm, claim):
    found = verdict(arm, claim)
    return dict(found.details) | {"kind": found.slip}


def model(arm):
    return read_arm("[arm]", tomllib.loads(arm)["arm"])


def printed(T, q_deg):
    """A claim that prints a pose for joints."""
    rows = [[f"{x:.5f}" for x in row] for row in T]
    return f"kind = 'pose'\nq_deg = {list(map(float, q_deg))}\nmatrix = {rows}"


def made_by(arm, q):
    """The pose at joints, rad or m."""
    return samples_at(model(arm), np.array(q, float)).frames["T"][0]


def test_the_value_of_a_slide_that_makes_the_printed_pose_is_told():
    T = made_by(POLAR, [np.radians(40), 0.45, np.radians(-25)])
    assert verdict(POLAR, printed(T, [40, 0.45, -25])).holds
    said = told(POLAR, printed(T, [40, 0.3, -25]))
    assert said["the slip"].startswith("joint 2 is 0.4500 m, not 0.3 m"), said


@pytest.mark.parametrize("turn", [90, -90, 180])
def test_a_joint_with_its_zero_elsewhere_is_told(turn):
    T = made_by(LINKS, np.radians([40, 30 + turn, -25]))
    said = told(LINKS, printed(T, [40, 30, -25]))
    assert said["kind"] == "zero" and said["the slip"].startswith(f"joint 2 has its zero {turn:+d} deg"), said


@pytest.mark.parametrize("turn", [90, -90, 180])
def test_a_listed_solution_with_the_zero_of_a_joint_elsewhere_is_told(turn):
    listed = [["40", str(30 - turn), "-25"]]
    found = verdict(LINKS, f'kind = "solutions"\nq_deg = [40, 30, -25]\nsolutions_deg = {listed}')
    assert found.wrong and found.slip == "zero" and found.reading == f"joint 2 with its zero {turn:+d} deg away", found


@pytest.mark.parametrize(("i", "j"), [(0, 1), (0, 2), (1, 2)])
@pytest.mark.parametrize("what", ["rows", "columns"])
def test_rows_and_columns_that_are_exchanged_are_told(i, j, what):
    T = made_by(PUMA, np.radians([40, 30, -25, 50, 65, 20]))
    order = [0, 1, 2, 3]
    order[i], order[j] = j, i
    said = told(PUMA, printed(T[order] if what == "rows" else T[:, order], [40, 30, -25, 50, 65, 20]))
    assert said["the slip"].startswith(f"{what} {i + 1} and {j + 1} exchanged gives the printed numbers"), said


@pytest.mark.parametrize(("entry", "right"), [((1, 3), "s1"), ((2, 3), "-c1"), ((3, 4), "d1 + a2 s2 + a3 s23")])
def test_a_difference_is_taken_from_the_entry_that_is_meant(entry, right):
    joints = [f"theta{k}" for k in (1, 2, 3)]
    found = difference_from_matrix(parse(f"{right} + d1", ["d1", "a2", "a3"], len(joints)), model(LINKS), entry, ())
    assert found == "d1"


@pytest.mark.parametrize("printed", ["T03^-1 = A1^-1 A2^-1 A3^-1", "A1^-1 A2^-1 A3^-1 = T03^-1"])
def test_inverses_in_the_order_of_what_they_invert_are_put_right_on_either_side(printed):
    said = told(LINKS, f'kind = "product"\nis = "{printed}"')
    assert said["the slip"] == "the inverses in the wrong order"
    assert said["nearest right reading"] == printed.replace("A1^-1 A2^-1 A3^-1", "A3^-1 A2^-1 A1^-1")


def test_as_many_brackets_as_are_allowed_may_stand_inside_one_another():
    for depth in (MAX_DEPTH, MAX_DEPTH + 1):
        claim = f'kind = "product"\nis = "{"(" * depth}A1{")" * depth} = A1"'
        if depth == MAX_DEPTH:
            assert verdict(LINKS, claim).holds
            continue
        with pytest.raises(InputError, match=f"more than {MAX_DEPTH} brackets"):
            verdict(LINKS, claim)


@pytest.mark.parametrize(("sign", "words"), [("", "sign(s5)"), ("-", "-sign(s5)")])
def test_the_sign_of_a_wrist_turn_chooses_the_branch_of_the_one_before_it(sign, words):
    y, x = ("R36[3,3]", "-R36[1,3]") if not sign else ("-R36[3,3]", "R36[1,3]")
    found = verdict(PUMA, f'kind = "joint"\njoint = 4\nis = "atan2({y}, {x})"')
    assert found.partly and found.slip == "branch"
    assert dict(found.details)["the slip"].endswith(f"go with {words}")


@pytest.mark.parametrize(
    ("arm", "of", "printed", "slip", "reading"),
    [
        (LINKS, "", "s1 c1 = sin(2 theta1)", "0.5 lost from sin(2 theta1)", "s1 c1 = 0.5 sin(2 theta1)"),
        (LINKS, "px", "c1 (a2 c2 - c23)", "a3 lost from c23", "c1 (a2 c2 + a3 c23)"),
        (
            PUMA,
            "Px",
            "a3 c1 c2 c3 - a3 c1 s2 s3 - d4 c1 s23 + c1 c2 - d3 s1",
            "a2 lost from c1 c2",
            "a3 c1 c2 c3 - a3 c1 s2 s3 - d4 c1 s23 + c1 c2 a2 - d3 s1",
        ),
    ],
)
def test_a_lost_number_or_length_is_told(arm, of, printed, slip, reading):
    claim = f'kind = "entry"\nof = "{of}"' if of else 'kind = "equation"'
    said = told(arm, f'{claim}\nis = "{printed}"')
    assert said["the slip"].startswith(slip)
    assert said["nearest right reading"] == reading


def test_a_lost_term_of_four_letters_is_made_of_the_formula_s_own():
    printed = "a3 c1 c2 c3 - a3 c1 s2 s3 - d4 c1 c2 s3 + a2 c1 c2 - d3 s1"
    said = told(PUMA, f'kind = "entry"\nof = "Px"\nis = "{printed}"')
    assert "c1 s2 c3 d4 lost" in said["the slip"]


def test_sine_of_what_is_no_sum_of_joints_is_looked_into_and_of_a_joint_it_is_named():
    for formula, name in (("2 asin(sin(theta3/2))", "theta3"), ("asin(sin(theta3))", "s3")):
        found = verdict(LINKS, f'kind = "joint"\njoint = 3\nis = "{formula}"')
        assert found.wrong and found.slip == "circular" and f"uses theta3 itself, in {name}" in found.sentence


def test_an_arm_s_length_counts_its_tool_and_its_base_once():
    bare, tool = model(LINKS), "tool = [[1, 0, 0, 0.02], [0, 1, 0, 0.03], [0, 0, 1, 0.05], [0, 0, 0, 1]]"
    tooled = model(LINKS.replace("values", f"{tool}\nvalues"))
    assert bare.length() == pytest.approx(0.4 + 0.3 + 0.25)
    assert tooled.length() == pytest.approx(bare.length() + 0.1)


def test_a_side_that_vanishes_at_a_sample_has_no_sign_and_names_none():
    arm = model(LINKS.replace('"a3", 0]]', '"a3", 0], ["q4", 0, 0.1, 0]]'))
    rng = np.random.default_rng(2)
    q = rng.uniform(0.3, 1.2, (6, arm.n))
    names = [words for words, _ in arm_features(arm, samples_at(arm, q))]
    elbow = [words for words in names if "elbow" in words]
    assert elbow
    q[2] = 0.0
    straight = samples_at(arm, q)
    assert not any("elbow" in words for words, _ in arm_features(arm, straight))


def test_an_equation_with_which_a_sentence_begins_is_read_whole():
    found = guessed("s5 = 0 or s3 = 0 where the arm is singular.", "denso-vp6242")
    assert 'kind = "singular"' in found and 'is = "s5 = 0 or s3 = 0"' in found


@pytest.mark.parametrize(("value", "slip"), [("30.000", "the number is in cm"), ("30.123", None), ("29.990", None)])
def test_a_number_is_in_another_unit_only_where_it_is_right_there(value, slip):
    said = told(LINKS, f'kind = "number"\nis = "a2"\nunit = "m"\nq_deg = [10, 20, 30]\nvalue = "{value}"')
    assert said.get("the slip") == slip


def test_what_a_lost_term_costs_does_not_depend_on_those_found_before_it():
    """Letters of the rotation are unlikely where a formula has none; the term after such a one pays for its own."""
    names = ["r11", "px"]
    letters = [parse("r11", names), parse("px", names)]
    rotation, plain = (lookup.Found(Fraction(1), (k,)) for k in (0, 1))

    def costs(*found):
        shelf = SimpleNamespace(
            letters=letters, product=lambda one: letters[one.letters[0]], find=lambda gap, most: iter(found)
        )
        node = parse("c1 + s1")
        return [slip.cost for slip in lookup._terms(node, (), node, shelf, np.zeros(3), 0.0)]

    assert costs(rotation, plain) == costs(rotation) + costs(plain)
    assert costs(rotation) > costs(plain)
