"""Wrong claims that look right, and right ones that look wrong: each kind with its neighbours."""

from __future__ import annotations

import pytest

import pieper
from oracle.arms.claim_headers import elbow, puma

ELBOW = elbow(0.3, 0.4, 0.4)
PUMA = puma(0.4318, 0.1245, 0.0203, 0.4318)
PLANAR = """[arm]
convention = "standard"
length_unit = "m"
columns = ["theta", "d", "a", "alpha"]
rows = [["q1", 0, "a1", 0], ["q2", 0, "a2", 0], ["q3", 0, "a3", 0]]
values = { a1 = 0.5, a2 = 0.37, a3 = 0.21 }
"""
NUMBERS = """[arm]
convention = "standard"
length_unit = "m"
columns = ["theta", "d", "a", "alpha"]
rows = [["q1", 0.4318, 0, "90 deg"], ["q2", 0, 0.4318, 0]]
"""
UR = '[arm]\nrobot = "universal-robots-ur5e"\n'
FIVE = """[arm]
convention = "standard"
length_unit = "m"
columns = ["theta", "d", "a", "alpha"]
rows = [["q1", "d1", 0, "90 deg"], ["q2", 0, "a2", 0], ["q3", 0, "a3", 0], ["q4", 0, 0, "90 deg"], ["q5", "d5", 0, 0]]
values = { d1 = 0.3, a2 = 0.25, a3 = 0.21, d5 = 0.12 }
"""


def verdict(arm, claim):
    (found,) = pieper.check(f"{arm}\n[[claim]]\n{claim}").verdicts
    return found


def joint(arm, number, formula, more=""):
    return verdict(arm, f'kind = "joint"\njoint = {number}\nis = "{formula}"\n{more}')


def entry(arm, of, formula, more=""):
    return verdict(arm, f'kind = "entry"\nof = "{of}"\nis = "{formula}"\n{more}')


@pytest.mark.parametrize(
    ("arm", "of", "formula", "because"),
    [
        (PUMA, "Pz", "-a3 s23 - d4 s2 - a2 c23", "a2 = d4"),
        (PUMA, "Pz", "-a3 s23 - a2 s2 - a2 c23", "a2 = d4"),
        (PUMA, "Pz", "-0.0203 s23 - d4 s2 - a2 c23", "a2 = d4"),
        (ELBOW, "Px", "c1(a3 c2 + a2 c23)", "a2 = a3"),
        (ELBOW, "Pz", "d1 + a2 s2 + a2 s23", "a2 = a3"),
    ],
)
def test_lengths_that_happen_to_be_equal_hide_no_slip(arm, of, formula, because):
    found = entry(arm, of, formula)
    assert found.partly and f"only because {because}" in found.sentence


@pytest.mark.parametrize("formula", ["-a3 s23 - a2 s2 - d4 c23", "-0.0203 s23 - 0.4318 s2 - d4 c23"])
def test_the_right_lengths_hold(formula):
    assert entry(PUMA, "Pz", formula).holds


def test_equal_lengths_hide_no_slip_in_a_joint_s_formula():
    K = 'where = { K = "(px^2+py^2+pz^2-a2^2-a3^2-d3^2-d4^2)/(2 %s)" }'
    formula = "atan2(a3,d4) - atan2(K, +-sqrt(a3^2+d4^2-K^2))"
    wrong, right = (joint(PUMA, 3, formula, K % name) for name in ("d4", "a2"))
    assert wrong.partly and "only because a2 = d4" in wrong.sentence
    assert dict(wrong.details)["the slip"] == "d4 for a2"
    assert right.holds


@pytest.mark.parametrize(
    ("number", "formula", "more"),
    [
        (2, "atan2(s2, c2)", ""),
        (3, "theta3", ""),
        (3, "atan2(s3, (px^2+py^2+(pz-d1)^2-a2^2-a3^2)/(2a2a3))", ""),
        (2, "atan2(w, c2)", 'where = { w = "s2" }'),
    ],
)
def test_a_formula_that_uses_its_own_angle_is_circular(number, formula, more):
    found = joint(ELBOW, number, formula, more)
    assert found.wrong and found.slip == "circular"


def test_a_sum_that_is_known_is_no_circle():
    found = joint(ELBOW, 3, "(theta2 + theta3) - theta2")
    assert "circular" not in found.slip
    found = joint(ELBOW, 3, "+-acos((px^2+py^2+(pz-d1)^2-a2^2-a3^2)/(2a2a3))", 'task = "position"')
    assert found.holds


def test_a_solution_listed_twice_counts_once():
    def claim(solutions):
        text = f'kind = "solutions"\nq_deg = [30, 40, 50]\ncomplete = true\nsolutions_deg = {solutions}'
        return verdict(PLANAR, text)

    other = pieper.check(f'{PLANAR}\n[[claim]]\nkind = "count"\ncount = 2\n').verdicts[0]
    assert other.holds
    for twice in ('[["30","40","50"],["30","40","50"]]', '[["30","40","50"],["30","-320","50"]]'):
        assert claim(twice).partly and "one and the same" in claim(twice).sentence


@pytest.mark.parametrize(
    ("value", "status"),
    [("0.6404", "wrong"), ("0.6403", "holds"), ("0.64", "holds"), ("0.65", "wrong"), ("0.640312", "holds")],
)
def test_a_number_off_by_less_than_its_last_digit_is_wrong_unless_it_is_cut_off(value, status):
    arm = PLANAR.replace("a1 = 0.5, a2 = 0.37", "a1 = 0.5, a2 = 0.4")
    assert verdict(arm, f'kind = "number"\nis = "sqrt(a1^2 + a2^2)"\nvalue = "{value}"').status == status


@pytest.mark.parametrize("extra", ["0.000000001", "0.000000000001", "1e-13"])
def test_what_is_added_far_behind_the_point_is_seen(extra):
    assert entry(ELBOW, "Px", f"c1(a2 c2 + a3 c23) + {extra}").wrong


@pytest.mark.parametrize("extra", ["1e-8", "1e-9", "4e-10", "1e-10", "1e-11", "1e-12"])
@pytest.mark.parametrize(
    "claim",
    [
        'kind = "equation"\nis = "px = c1(a2 c2 + a3 c23) + %s"',
        'kind = "entry"\nof = "Pz"\nis = "d1 + a2 s2 + a3 s23 + %s"',
        'kind = "jacobian"\nof = "J[3,3]"\nis = "a3 c23 + %s"',
    ],
)
def test_a_small_difference_is_wrong_everywhere_whatever_the_tolerance(claim, extra):
    found = verdict(ELBOW, claim % extra)
    assert found.wrong and ("if only just" in found.sentence or "right at 0 of 96" in found.sentence), found.sentence
    example = dict(found.details).get("counter-example", "")
    if "left side" in example:
        left, right = example.split("left side ")[1].split(", right side ")
        assert left != right


@pytest.mark.parametrize(
    ("of", "formula", "status"),
    [
        ("Px", "0.4318 c1 c2", "holds"),
        ("Px", "0.432 c1 c2", "holds"),
        ("Px", "0.43 c1 c2", "holds"),
        ("Px", "0.433 c1 c2", "wrong"),
        ("Px", "0.4381 c1 c2", "wrong"),
        ("Px", "0.4318 c1 cos(q2 + 1.5708 - 1.5707963)", "holds"),
        ("Pz", "0.432 + 0.432 s2", "holds"),
        ("Pz", "0.432 + 0.432 c2", "wrong"),
        ("Pz", "0.432 + 0.431 s2", "wrong"),
    ],
)
def test_rounded_constants_are_right_to_their_digits(of, formula, status):
    assert entry(NUMBERS, of, formula).status == status


def test_a_formula_right_on_one_branch_holds_where_that_branch_is_named():
    formula = "acos((px^2+py^2+(pz-d1)^2-a2^2-a3^2)/(2a2a3))"
    assert joint(ELBOW, 3, formula, 'task = "position"').partly
    assert joint(ELBOW, 3, formula, 'task = "position"\nwhen = "s3 > 0"').holds
    assert joint(ELBOW, 3, formula, 'task = "position"\nwhen = "0 < theta3 < pi"').holds
    assert not joint(ELBOW, 3, formula, 'task = "position"\nwhen = "s3 < 0"').holds
    assert not joint(ELBOW, 3, formula, 'task = "position"\nwhen = "s2 > 0"').holds


def test_a_joint_that_is_held_or_given_is_no_longer_free():
    arm = """[arm]
convention = "modified"
length_unit = "m"
columns = ["a", "d", "alpha", "theta"]
rows = [[0, "d1", 0, "q1"],[0,0,"-pi/2","q2"],[0,"d3","pi/2","q3"],["a4",0,"pi/2","q4"],["-a4","d5","-pi/2","q5"],
        [0,0,"pi/2","q6"],["a7","df","pi/2","q7"]]
values = { d1 = 0.333, d3 = 0.316, d5 = 0.384, df = 0.107, a4 = 0.0825, a7 = 0.088 }
[symbols]
Wx = "Px-df ax-a7(c7 nx-s7 ox)"
Wy = "Py-df ay-a7(c7 ny-s7 oy)"
Wz = "Pz-df az-a7(c7 nz-s7 oz)-d1"
L1 = "sqrt(d3^2+a4^2)"
L2 = "sqrt(d5^2+a4^2)"
"""
    formula = "+-acos((Wx^2+Wy^2+Wz^2-L1^2-L2^2)/(2 L1 L2)) - atan2(a4,d3) - atan2(a4,d5)"
    assert joint(arm, 4, formula, "at_deg = { theta7 = 40 }").holds
    assert not joint(arm, 4, formula.replace("atan2(a4,d5)", "atan2(d5,a4)"), "at_deg = { theta7 = 40 }").holds


def test_the_law_of_cosines_for_one_of_three_parallel_joints():
    where = """where = { r = "c1 px + s1 py - d5 (c1 ax + s1 ay)", z = "pz - d1 - d5 az" }"""
    formula = "+-acos((r^2 + z^2 - a2^2 - a3^2)/(2 a2 a3))"
    assert joint(FIVE, 3, formula, where).holds
    pitch = """where = { r = "c1 px + s1 py - d5 s234", z = "pz - d1 + d5 c234" }"""
    assert joint(FIVE, 3, formula, pitch).holds
    assert not joint(FIVE, 3, formula, pitch.replace("- d5 s234", "+ d5 s234")).holds


def test_a_region_is_confirmed_before_it_is_said():
    found = entry(
        """[arm]
convention = "standard"
length_unit = "m"
columns = ["theta", "d", "a", "alpha"]
rows = [["q1", "d1", "a1", 0], ["q2", 0, "a2", "180 deg"], [0, "b3", 0, 0], ["q4", "d4", 0, 0]]
values = { d1 = 0.387, a1 = 0.325, a2 = 0.275, d4 = 0.05 }
""",
        "ny",
        "sin(theta1+theta2) c4 + cos(theta1+theta2) s4",
    )
    assert found.wrong and "only where" not in found.sentence
