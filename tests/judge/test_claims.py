"""Claims files: what a verdict says, and how a bad file is refused with its place."""

from __future__ import annotations

import json
import tracemalloc

import pytest

import pieper
from pieper.errors import InputError
from pieper.judge.claims import check
from pieper.judge.verdict import HOLDS, PARTLY, WRONG
from tests.judge.planted.short_arms import two_links

ARM = two_links(0.4, 0.3)
RIGHT = '[[claim]]\nid = "x"\nkind = "entry"\nof = "Px"\nis = "a1 C1 + a2 C12"\n'


def judged(claim, arm=ARM):
    """Judge one claim."""
    return check(f"title = 'test'\n{arm}\n[[claim]]\nid = 'x'\n{claim}")["x"]


def refused(text):
    """Return the message with which a file is refused."""
    with pytest.raises(InputError) as caught:
        check(text)
    return str(caught.value)


def test_a_right_entry_holds_for_any_lengths_and_to_many_digits():
    verdict = check(ARM + RIGHT)["x"]
    assert verdict.status == HOLDS
    assert "for any lengths" in verdict.sentence
    assert verdict.digits >= 40


def test_a_right_entry_with_the_arms_own_numbers_says_so():
    verdict = judged("kind = 'entry'\nof = 'Px'\nis = '0.4 C1 + 0.3 C12'")
    assert verdict.status == HOLDS
    assert "this arm's lengths" in verdict.sentence


@pytest.mark.parametrize(
    ("formula", "slip", "reading"),
    [
        ("a1 C1 - a2 C12", "sign", "a1 c1 + a2 c12"),
        ("a1 C1 + a2 C2", "index", "a1 c1 + a2 c12"),
        ("a1 C1 + a2 S12", "sine for cosine", "a1 c1 + a2 c12"),
        ("a1 C1 + C12", "missing factor", "a1 c1 + c12 a2"),
        ("a1 C1 + a2 C12 S1", "extra factor", "a1 c1 + a2 c12"),
        ("a2 C1 + a2 C12", "index", "a1 c1 + a2 c12"),
        ("a1 C1 + a2 C12 + a1", "extra term", "a1 c1 + a2 c12"),
        ("1000(a1 C1 + a2 C12)", "millimetres", "a1 c1 + a2 c12"),
        ("a1 C1 + a2 - C12", "product", "a1 c1 + a2 c12"),
    ],
)
def test_a_wrong_entry_names_its_slip_and_the_right_reading(formula, slip, reading):
    verdict = judged(f"kind = 'entry'\nof = 'Px'\nis = '{formula}'")
    assert verdict.status == WRONG
    assert verdict.slip == slip
    assert verdict.reading == reading
    assert dict(verdict.details)["counter-example"].startswith("at joints (")


def test_the_difference_is_simplified():
    verdict = judged("kind = 'entry'\nof = 'Px'\nis = 'a1 C1 + a2 C1 C2 + a2 S1 S2'")
    assert "2 a2 s1 s2" in dict(verdict.details)["difference"]


def test_an_entry_of_the_other_convention_is_recognised():
    modified = ARM.replace("standard", "modified").replace('"a1"', '"a0"').replace('"a2"', '"a1"')
    modified = modified.replace("a1 = 0.4, a2 = 0.3", "a0 = 0.4, a1 = 0.3")
    verdict = judged("kind = 'entry'\nof = 'Px'\nis = 'a0 C1 + a1 C12'", modified)
    assert verdict.slip == "convention"


def test_a_branch_that_holds_in_a_region_only_names_the_region():
    verdict = judged("kind = 'joint'\njoint = 2\nis = 'acos((Px^2 + Py^2 - a1^2 - a2^2)/(2a1a2))'")
    assert verdict.status == PARTLY
    assert "sin(theta2) > 0" in verdict.sentence
    assert verdict.slip == "branch"


def test_a_branch_with_both_signs_holds_where_both_are_solutions():
    claim = "kind = 'joint'\njoint = 2\ntask = 'position'\nis = '+-acos((Px^2 + Py^2 - a1^2 - a2^2)/(2a1a2))'"
    verdict = judged(claim)
    assert verdict.status == HOLDS
    assert "both are solutions" in dict(verdict.details)["both signs"]


def test_a_division_by_zero_for_all_joints_is_said():
    verdict = judged("kind = 'entry'\nof = 'Px'\nis = 'a1 C1/(C2^2 + S2^2 - 1)'")
    assert verdict.status == WRONG
    assert "divides by zero for all joints" in verdict.sentence
    assert dict(verdict.details)["undefined"]


def test_a_division_of_numbers_by_zero_is_a_wrong_claim_and_no_crash():
    verdict = judged("kind = 'entry'\nof = 'Px'\nis = '1/0 + a1 C1'")
    assert verdict.wrong and "divides by zero" in verdict.sentence
    assert "difference" not in dict(verdict.details)


@pytest.mark.parametrize("rounded", ["", "\nrounded = true"])
def test_a_printed_rotation_is_judged_without_a_position(rounded):
    matrix = "[['0.26', '-0.97', '0'], ['0.97', '0.1', '0.3'], ['0', '0.5', '1']]"
    verdict = judged(f"kind = 'pose'\nof = 'R02'\nq_deg = [30, 45]\nmatrix = {matrix}{rounded}")
    assert verdict.wrong and "3 of 9 entries" in verdict.sentence


def test_a_long_sum_is_judged_without_delay_or_heap():
    terms = " + ".join(["a1 C1/10000"] * 10_000)
    tracemalloc.start()
    verdict = judged(f"kind = 'entry'\nof = 'A1[1,4]'\nis = '{terms}'")
    assert tracemalloc.get_traced_memory()[1] < 400e6
    tracemalloc.stop()
    assert verdict.status == HOLDS


def test_a_printed_pose_is_compared_to_its_digits():
    good = "kind = 'pose'\nq_deg = [30, 45]\nposition = ['0.4241', '0.4898', '0']"
    assert judged(good).status == HOLDS
    swapped = judged(good.replace("0.4241", "0.4214"))
    assert swapped.status == WRONG and swapped.slip == "misprint"
    sense = judged("kind = 'pose'\nq_deg = [30, -45]\nposition = ['0.4241', '0.4898', '0']")
    assert sense.slip in ("sense", "joint value")


def test_an_inverse_in_the_wrong_order_is_put_right():
    verdict = judged("kind = 'product'\nis = 'A1^-1 A2^-1 T = I'")
    assert verdict.reading == "A2^-1 A1^-1 T = I"
    assert verdict.slip == "order"


def test_the_report_has_all_its_forms():
    report = check(ARM + RIGHT + RIGHT.replace('"x"', '"y"').replace("C12", "C2"))
    assert not report.ok and report.counts() == {HOLDS: 1, PARTLY: 0, WRONG: 1}
    assert "[WRONG] y" in report.text()
    assert "## y" in report.markdown()
    assert json.loads(report.json())["verdicts"][1]["slip"] == "index"
    assert "<table>" in report.html() and "<script" not in report.html()


def test_an_arm_can_be_given_instead_of_the_files_own():
    arm = pieper.load("denso-vp6242")
    report = check(
        '[[claim]]\nid = "x"\nkind = "entry"\nof = "nz"\nis = "C6(S5 C23 + C4 C5 S23) - S4 S6 S23"\n', arm=arm
    )
    assert report["x"].status == HOLDS


def test_a_catalogue_arm_is_named_in_the_file():
    report = check('[arm]\nrobot = "denso-vp6242"\n[[claim]]\nid = "x"\nkind = "entry"\nof = "A1[1,1]"\nis = "C1"\n')
    assert report.ok


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("[arm\n", ["not TOML", "line 1"]),
        (ARM, ["no claim"]),
        (RIGHT, ["no arm is named"]),
        ('[arm]\nrobot = "denso-vp9999"\n' + RIGHT, ["denso-vp"]),
        (ARM + RIGHT.replace("entry", "entri"), ["claim x", "did you mean 'entry'"]),
        (ARM + RIGHT.replace("of =", "off ="), ["claim x", "'off'", "did you mean 'of'"]),
        (ARM + RIGHT.replace('of = "Px"\n', ""), ["claim x", "lacks the key 'of'"]),
        (ARM + RIGHT + RIGHT, ["two claims are called 'x'"]),
        (ARM + RIGHT.replace("a1 C1", "a11 C1"), ["claim x", "a11", "did you mean", "^"]),
        (ARM + RIGHT.replace("a1 C1", "(a1 C1"), ["claim x", "never closed", "^"]),
        (ARM + RIGHT.replace("a1 C1", "__import__('os')"), ["claim x", "__import__", "^"]),
        (ARM + RIGHT.replace("Px", "Tx"), ["claim x", "'Tx' is no matrix"]),
        (ARM + RIGHT.replace("Px", "T[5,1]"), ["claim x", "4 rows and 4 columns"]),
        (ARM + RIGHT.replace("Px", "T"), ["claim x", "say which entry"]),
        (ARM.replace('"standard"', '"normal"') + RIGHT, ["convention", "standard"]),
        (ARM.replace('length_unit = "m"', 'length_unit = "inch"') + RIGHT, ["length_unit", "mm"]),
        (ARM.replace('["q2", 0, "a2", 0]', '["q2", 0, "a2", 90]') + RIGHT, ["row 2", "alpha", "no unit", "90 deg"]),
        (ARM.replace('["q2", 0, "a2", 0]', '["q2", 0, "a2"]') + RIGHT, ["row 2", "four cells"]),
        (ARM.replace('["q2", 0, "a2", 0]', '[0, 0, "a2", 0]') + RIGHT, ["C12", "joint 2", "1 joint"]),
        (ARM + "[symbols]\na1 = 'C1'\n" + RIGHT, ["[symbols] a1", "already means"]),
        (ARM + "[symbols]\nk = 'C1 + nope'\n" + RIGHT, ["[symbols] k", "nope", "^"]),
    ],
)
def test_a_bad_file_is_refused_and_the_place_named(text, words):
    message = refused(text)
    for word in words:
        assert word in message, message


@pytest.mark.parametrize(
    ("claim", "words"),
    [
        ("kind = 'pose'\nq = [30, 45]\nposition = [1, 2, 3]", ["q[1]", "no unit", "30 deg"]),
        ("kind = 'pose'\nq_deg = [30]\nposition = [1, 2, 3]", ["1 entry", "2 joints"]),
        ("kind = 'pose'\nposition = [1, 2, 3]", ["q_deg"]),
        ("kind = 'pose'\nq_deg = [0, 0]\nmatrix = [[1, 0], [0, 1]]", ["2 rows", "4 x 4"]),
        ("kind = 'pose'\nq_deg = [0, 0]\nmatrix = [[1,0,0,0],[0,1,0,0],[0,0,'one',0],[0,0,0,1]]", ["(3,3)", "one"]),
        ("kind = 'matrix'\nof = 'A1'\nis = [['C1', '-S1'], ['S1', 'C1']]", ["4 rows of 4", "2 rows"]),
        ("kind = 'joint'\njoint = 3\nis = 'atan2(Py, Px)'", ["joint 3 does not exist"]),
        ("kind = 'joint'\nis = 'atan2(Py, Px)'", ["say which joint"]),
        ("kind = 'product'\nis = 'A1 A2 T'", ["exactly one '='"]),
        ("kind = 'product'\nis = 'A1 A3 = T'", ["'A3'", "2 joints"]),
        ("kind = 'count'\ncount = 'many'", ["count must be a whole number"]),
        ("kind = 'limit'\njoint = 1\nrange_deg = [10, -10]", ["range_deg", "lower, upper"]),
        ("kind = 'procedure'\nsteps = [{ joint = 1, is = 'theta2' }]", ["uses theta2", "no step before"]),
    ],
)
def test_a_bad_claim_is_refused_and_the_place_named(claim, words):
    message = refused(f"{ARM}\n[[claim]]\nid = 'x'\n{claim}")
    assert "claim x" in message
    for word in words:
        assert word in message, message


def test_a_file_that_does_not_exist_is_refused():
    with pytest.raises(InputError, match="no-such-file.toml"):
        check("no-such-file.toml")


def test_a_binary_file_is_refused(tmp_path):
    path = tmp_path / "claims.toml"
    path.write_bytes(bytes(range(256)) * 10)
    with pytest.raises(InputError, match="not a text file"):
        check(path)
