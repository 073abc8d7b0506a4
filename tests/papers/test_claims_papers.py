"""The five source papers judged: every claim gets the verdict an independent recomputation of the papers gave it."""

from __future__ import annotations

import functools
import re
from pathlib import Path

import pytest

from pieper.judge.claims import check
from pieper.judge.pages import page
from pieper.judge.verdict import HOLDS, PARTLY, WRONG

ROOT = Path(__file__).parents[2]
CLAIMS = ROOT / "examples" / "claims"

# Everything that is not listed holds. The second word is the kind of slip that explains a wrong claim, "" where no
# single one does.
EXPECTED = {
    "seed000_denso_vp6242": {
        WRONG: {
            "Table 1, limits": "zero",
            "7, Px": "missing factor",
            "9": "missing factor",
            "11, left (1,4)": "missing factor",
            "11, left (2,4)": "missing factor",
            "15, right (1,4)": "index",
            "15, right (2,4)": "index",
            "16, first": "index",
            "16, second": "index",
            "17, A": "index",
            "17, B": "index",
            "phi": "atan",
            "phi, value": "",
            "25 with the printed phi": "atan",
            "28, right (1,4)": "index",
            "28, right (2,4)": "index",
            "29": "index",
            "K1": "product",
            "31 with the printed K1": "product",
            "35 and 36, last column": "index",
            "37, right": "index",
            "41 and 43": "branch",
            "the printed method": "",
            "the method with atan2": "",
        },
        PARTLY: {
            "12": "branch",
            "12 with atan2": "branch",
            "31": "branch",
            "31 with the printed gamma": "",
            "34": "branch",
            "41": "branch",
            "41 with atan2": "branch",
            "43": "branch",
            "43 with atan2": "branch",
        },
    },
    "seed001_dfrobot_rob0036": {
        WRONG: {
            "six degrees of freedom": "",
            "20": "power",
            "21": "sign",
            "21, theta34": "sign",
            "23": "order",
            "24, left (3,4)": "two slips",
            "24, left (3,3)": "index",
            "25": "two slips",
            "26": "",
            "29": "index",
            "31": "order",
            "31, entry (3,4)": "",
            "32": "",
            "33": "",
            "Fig. 5, A3": "misprint",
            "Fig. 5, A5": "misprint",
            "example, theta3": "",
            "example, theta6": "misprint",
            "example, angles of the text": "joint value",
            "Fig. 6, pose as scanned": "misprint",
            "Fig. 6, solution": "",
        },
        PARTLY: {"20, theta3 from theta4": "branch", "27": "branch", "28": "", "30": "branch"},
    },
    "seed002_homework": {
        WRONG: {
            "X as scanned": "",
            "X, only the signs as scanned": "sign",
            "Y as scanned": "",
            "5": "index",
            "6": "index",
            "10": "index",
            "11": "sign",
            "13": "",
            "14": "",
            "14 from (13)": "",
            "theta3": "sign",
            "eight pairs": "",
        },
        PARTLY: {},
    },
    "seed003_denso_vs6577": {
        WRONG: {
            "2, T1 for (4) to (7)": "sign",
            "2, T3 for (4) to (7)": "twist",
            "4 to 7": "twist",
            "Table 1, limit of joint 1": "",
            "Table 1, limit of joint 3": "",
            "Table 1, limit of joint 4": "",
            "Table 2, P0 by (7)": "",
            "Table 2, reference": "axes",
            "Table 2, simulation at q = 0": "",
            "Table 2, time of a leg": "misprint",
            "height at q = 0, d1 = 395": "",
            "forward reach at q = 0, d6 = 80": "",
        },
        PARTLY: {"largest errors": ""},
    },
    "seed004_fanuc_r2000ic": {
        WRONG: {
            "table, [mm]": "millimetres",
            "1": "index",
            "set 1, T06": "row",
            "set 2, T03": "",
            "set 2, T06": "row",
            "set 3, T06": "row",
            "3": "index",
            "Px": "index",
            "Py": "index",
            "Pz": "swapped factor",
            "c22": "extra factor",
            "alternative, Px": "extra factor",
            "alternative, Py": "extra factor",
            "alternative, squares": "extra term",
            "alternative, c3": "extra term",
            "alternative, q3": "extra term",
            "ZYZ": "index",
            "wrist is ZYZ": "sense",
            "q5, first": "",
            "q5, second": "atan",
            "q4": "atan",
            "q4 of a ZYZ wrist": "atan",
            "q6": "atan",
            "q6 of a ZYZ wrist": "atan",
            "singular, first": "atan",
            "singular, second": "half turn",
            "singular, free joints": "index",
        },
        PARTLY: {"q2": "branch", "alternative, range of c3": "", "number of solutions": ""},
    },
}


@functools.cache
def report_of(name):
    return check(CLAIMS / f"{name}.toml")


@pytest.fixture(scope="module", params=EXPECTED)
def judged(request):
    return request.param, report_of(request.param)


def test_every_claim_gets_its_expected_verdict(judged):
    name, report = judged
    expected = {i: status for status, ids in EXPECTED[name].items() for i in ids}
    found = {v.id: v.status for v in report.verdicts}
    assert set(expected) <= set(found)
    different = {i: (s, expected.get(i, HOLDS)) for i, s in found.items() if s != expected.get(i, HOLDS)}
    assert different == {}


def test_every_slip_is_the_expected_one(judged):
    name, report = judged
    expected = {i: slip for ids in EXPECTED[name].values() for i, slip in ids.items()}
    found = {v.id: v.slip for v in report.verdicts if not v.holds}
    assert {i: (s, expected[i]) for i, s in found.items() if s != expected[i]} == {}


def test_a_wrong_claim_shows_a_counter_example_or_what_is_right(judged):
    _, report = judged
    wrong = [v for v in report.verdicts if v.status == WRONG and "outside the printed range" not in v.sentence]
    bare = [v.id for v in wrong if not v.details]
    assert bare == []


def test_the_published_page_is_what_the_judge_says(judged):
    name, report = judged
    published = (ROOT / "docs" / "papers" / f"{name}.md").read_text(encoding="utf-8")
    assert published == page(CLAIMS / f"{name}.toml", report)


@pytest.fixture(scope="module")
def reports():
    return {name[4:7]: report_of(name) for name in EXPECTED}


@pytest.mark.parametrize(
    ("paper", "claim", "words"),
    [
        ("000", "7, Px", r"c2 lost from a3 c1 c3"),
        ("000", "7, Px", r"printed minus right = -a3 c1 c3 \(c2 - 1\)"),
        ("000", "9", r"A1 A2 A3 A4 A5 A6 A6\^-1 = T A6\^-1"),
        ("000", "12 with atan2", r"\{0, pi\}"),
        ("000", "15, right (1,4)", r"l5 for d6"),
        ("000", "phi, value", r"109\.653824"),
        ("000", "Table 1, limits", r"0\.06973 m"),
        ("000", "Table 1, limits", r"-J3 -90 deg in -250 \.\. -110 deg"),
        ("000", "41 with atan2", r"where sin\(theta5\) < 0"),
        ("000", "43 with atan2", r"where sin\(theta5\) > 0"),
        ("000", "41 and 43", r"never right together"),
        ("000", "the printed method", r"no solution at any"),
        ("000", "the method put right", r"all 8 solutions"),
        ("001", "six degrees of freedom", r"theta1 and theta2"),
        ("001", "23", r"A2\^-1 A1\^-1 T = A3 A4 A5 A6"),
        ("001", "31", r"A3\^-1 A2\^-1 A1\^-1 T = A4 A5 A6"),
        ("001", "27", r"sin\(theta3\+theta4\+theta5\) < 0"),
        ("001", "29", r"theta2 for theta1 \+ theta2 throughout"),
        ("001", "Fig. 5, A3", r"60\.5071"),
        ("001", "example, angles of the text", r"joint 3 is 47\.75\d\d deg, not 45\.92 deg"),
        ("001", "Fig. 6, solution", r"271\.64\d mm.*44\.308, -130\.960, 62\.227"),
        ("002", "5", r"s2 for s3"),
        ("002", "eight pairs", r"4 at 100%"),
        ("003", "Table 2, reference", r"Y up"),
        ("003", "Table 2, reference", r"theta2 = J2 -90 deg; theta3 = J3 \+180 deg; theta5 = -J5"),
        ("003", "largest errors", r"undefined for X in row 1"),
        ("004", "set 1, T06", r"a and d swapped in row 6"),
        ("004", "set 2, T06", r"-0\.2588"),
        ("004", "set 3, T06", r"0\.0561, 0\.0233|0\.0561"),
        ("004", "Px", r"a2 for a3"),
        ("004", "singular, free joints", r"theta4 and theta6"),
    ],
)
def test_the_verdict_says_why(reports, paper, claim, words):
    verdict = reports[paper][claim]
    said = "\n".join([verdict.sentence, *(f"{h}: {b}" for h, b in verdict.details)])
    assert re.search(words, said, re.DOTALL), said
