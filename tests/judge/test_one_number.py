"""One wrong number is named: a length's other value, one joint of a solution, two entries, a lost point or divisor."""

from __future__ import annotations

import pytest

import pieper

ELBOW = """
title = "An elbow"
[arm]
name = "elbow"
convention = "standard"
length_unit = "m"
columns = ["theta", "d", "a", "alpha"]
rows = [["q1", "d1", 0, "90 deg"], ["q2", 0, "a2", 0], ["q3", 0, "a3", 0]]
values = { d1 = 0.45, a2 = 0.38, a3 = 0.29 }
"""
#: The last row is the hand's, and has no joint.
HAND = """
title = "Craig's three joints"
[arm]
name = "three joints and a hand"
convention = "modified"
length_unit = "m"
columns = ["alpha", "a", "d", "theta"]
rows = [[0, 0, 0, "q1"], ["90 deg", "L1", 0, "q2"], [0, "L2", 0, "q3"], [0, "L3", 0, 0]]
values = { L1 = 0.24, L2 = 0.36, L3 = 0.21 }
"""


def judged(tmp_path, arm, claim):
    path = tmp_path / "claim.toml"
    path.write_text(f'{arm}[[claim]]\nid = "1"\n{claim}\n')
    return pieper.check(str(path)).verdicts[0]


def the_slip(verdict):
    return "; ".join(words for name, words in verdict.details if name == "the slip")


def printed(arm, q, change=lambda rows: rows):
    """The pose at q (deg) to four decimals as a claim, by plain products of matrices."""
    import numpy as np

    def link(theta, d, a, alpha, standard):
        c, s, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
        if standard:
            return np.array([[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]])
        return np.array([[c, -s, 0, a], [s * ca, c * ca, -sa, -sa * d], [s * sa, c * sa, ca, ca * d], [0, 0, 0, 1]])

    t, T = np.radians(q), np.eye(4)
    standard = arm is ELBOW
    rows = [(0.45, 0, np.pi / 2), (0, 0.38, 0), (0, 0.29, 0)] if standard else []
    rows = rows or [(0, 0, 0), (0, 0.24, np.pi / 2), (0, 0.36, 0), (0, 0.21, 0)]
    for k, (d, a, alpha) in enumerate(change(rows)):
        T = T @ link(t[k] if k < len(t) else 0.0, d, a, alpha, standard)
    return [[f"{v:.4f}" for v in row] for row in T[:3]]


def matrix(rows):
    return "[" + ", ".join("[" + ", ".join(f'"{v}"' for v in row) + "]" for row in rows) + "]"


def test_a_length_with_another_value(tmp_path):
    rows = printed(ELBOW, [30, -55, 72], lambda rows: [rows[0], (0, 0.41, 0), rows[2]])
    said = judged(tmp_path, ELBOW, f'kind = "pose"\nq_deg = [30, -55, 72]\nof = "T"\nmatrix = {matrix(rows)}')
    assert said.wrong and "a of row 2 is 0.4100, not 0.38 m" in the_slip(said)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda r: [*r[:3], (0, -0.21, 0)], "a of row 4 has the other sign"),
        (lambda r: [*r[:3], (0, 0, 0)], "a of row 4 left out"),
        (lambda r: [*r[:2], (0, 0.21, 0), (0, 0.36, 0)], "L2 and L3 exchanged"),
        (lambda r: [*r[:3], (0, 0.28, 0)], "a of row 4 is 0.2800, not 0.21 m"),
    ],
)
def test_a_length_of_a_row_without_a_joint(tmp_path, change, words):
    rows = printed(HAND, [30, -55, 72], change)
    said = judged(tmp_path, HAND, f'kind = "pose"\nq_deg = [30, -55, 72]\nof = "T"\nmatrix = {matrix(rows)}')
    assert said.wrong and words in the_slip(said)


def test_two_entries_exchanged(tmp_path):
    rows = printed(ELBOW, [30, -55, 72])
    rows[0][3], rows[2][0] = rows[2][0], rows[0][3]
    said = judged(tmp_path, ELBOW, f'kind = "pose"\nq_deg = [30, -55, 72]\nof = "T"\nmatrix = {matrix(rows)}')
    assert said.wrong and "(1,4) and (3,1) exchanged" in the_slip(said)


def test_a_lost_decimal_point(tmp_path):
    rows = printed(ELBOW, [30, -55, 72])
    rows[2][3] = rows[2][3].replace(".", "").lstrip("0")
    said = judged(tmp_path, ELBOW, f'kind = "pose"\nq_deg = [30, -55, 72]\nof = "T"\nmatrix = {matrix(rows)}')
    assert said.wrong and "the decimal point lost" in the_slip(said)


@pytest.mark.parametrize(
    ("solution", "words"),
    [
        ("[30, -58, 72]", "joint 2 is -55"),  # one digit
        ("[30, -55, 1.2566]", "joint 3 is 71.9979 deg, not 1.2566: in radians"),
        ("[41.5, -55, 72]", "joint 1 is 30"),  # nothing that looks like a slip, and still this joint alone
    ],
)
def test_the_one_joint_of_a_solution_that_is_wrong(tmp_path, solution, words):
    rows = [*printed(ELBOW, [30, -55, 72]), ["0", "0", "0", "1"]]
    said = judged(tmp_path, ELBOW, f'kind = "solutions"\nmatrix = {matrix(rows)}\nsolutions_deg = [{solution}]')
    assert said.wrong and words in the_slip(said)


@pytest.mark.parametrize(
    ("formula", "words", "reading"),
    [
        ("+-acos(px^2 + py^2 + (pz - d1)^2 - a2^2 - a3^2)", "the division by 2 a2 a3 lost", "/(2 a2 a3)"),
        ("+-acos((px^2 + px^2 + (pz - d1)^2 - a2^2 - a3^2)/(2 a2 a3))", "px for py", "py^2"),
    ],
)
def test_a_lost_division_and_a_letter_that_is_squared(tmp_path, formula, words, reading):
    said = judged(tmp_path, ELBOW, f'kind = "joint"\njoint = 3\nis = "{formula}"')
    assert said.wrong and words in the_slip(said) and reading in said.reading


def test_a_lost_term_of_five_letters(tmp_path):
    puma = """
title = "A wrist on an elbow"
[arm]
name = "six"
convention = "standard"
length_unit = "m"
columns = ["theta", "d", "a", "alpha"]
rows = [["q1", "d1", 0, "90 deg"], ["q2", 0, "a2", 0], ["q3", 0, 0, "90 deg"], ["q4", "d4", 0, "-90 deg"],
        ["q5", 0, 0, "90 deg"], ["q6", "d6", 0, 0]]
values = { d1 = 0.4, a2 = 0.35, d4 = 0.36, d6 = 0.08 }
"""
    right = "-c1 c23 c4 c5 s6 - c1 c23 c6 s4 + c1 s23 s5 s6 - c5 s1 s4 s6 + c4 c6 s1"
    assert judged(tmp_path, puma, f'kind = "entry"\nof = "ox"\nis = "{right}"').holds
    lost = right.removeprefix("-c1 c23 c4 c5 s6 - ").replace("c1 c23 c6 s4", "-c1 c23 c6 s4", 1)
    said = judged(tmp_path, puma, f'kind = "entry"\nof = "ox"\nis = "{lost}"')
    assert said.wrong and said.slip == "missing term"
    assert all(letter in the_slip(said) for letter in ("c23", "c4", "c5", "s6", "lost"))


@pytest.mark.parametrize(
    "formula",
    [
        "rad2deg(pi/2 - atan2(px, py))",
        "atan2(py, px) 180/pi",
        "180/pi (pi/2 - atan2(px, py))",
        "np.degrees(2*np.arctan(py/(np.hypot(px, py) + px)))",
        "90 - atan2(px, py)",
        "atan2d(py, px)",
    ],
)
def test_a_page_in_degrees_may_turn_its_radians_itself(tmp_path, formula):
    claim = f'kind = "joint"\njoint = 1\nunit = "deg"\nwhen = "c1 px + s1 py > 0"\nis = "{formula}"'
    assert judged(tmp_path, ELBOW, claim).holds
