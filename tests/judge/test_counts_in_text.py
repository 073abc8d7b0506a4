"""How many solutions running text says there are, in words and digits, with conditions, and what is judged of it."""

from __future__ import annotations

import pytest

import pieper
from pieper.judge.excerpt_counts import counted
from pieper.judge.verdict import HOLDS, WRONG

D = r"(p_x^2+p_y^2+(p_z-d_1)^2-a_2^2-a_3^2)/(2 a_2 a_3)"


@pytest.mark.parametrize(
    ("sentence", "keys"),
    [
        ("There are four solutions.", {"count": 4}),
        ("The arm therefore has\neight inverse kinematic solutions for a given pose.", {"count": 8}),
        ("A 6R arm of this kind has **up to eight** solutions.", {"count": 8, "at_most": True}),
        ("- Up to 8 IK solutions", {"count": 8, "at_most": True}),
        ("At most \\emph{16} different solutions exist.", {"count": 16, "at_most": True}),
        ("There are $2^3 = 8$ solutions in total.", {"count": 8}),
        ("The robot can reach a point in two configurations: up and down.", {"count": 2, "task": "position"}),
        ("The number of solutions is 4.", {"count": 4}),
        ("It has a unique solution.", {"count": 1}),
        ("There is no solution if $D > 1$.", {"count": 0, "when": "D > 1"}),
        ("No solution exists when px^2 + py^2 > (a1 + a2)^2.", {"count": 0, "when": "px^2 + py^2 > (a1 + a2)^2"}),
        (r"If $|D| \leq 1$, there are two solutions.", {"count": 2, "when": "abs(D)  <= 1"}),
    ],
)
def test_a_sentence_that_counts_solutions_is_read(sentence, keys):
    (said,) = counted(sentence)
    assert said.keys == {"kind": "count", **keys}


@pytest.mark.parametrize(
    "sentence",
    [
        "The equation has two solutions for theta3.",
        r"There are two possible solutions for $\theta_1$.",
        "Sine and cosine are both known up to one positive factor, so there is one solution:",
        "An equation of this form has two solutions, one for each sign of sigma1 = +1 or -1:",
        "Of the two solutions we take the elbow up.",
        "We choose one solution out of them.",
        "There are three singular configurations.",
    ],
)
def test_what_is_said_of_a_joint_or_an_equation_is_no_count_of_the_arm(sentence):
    assert not counted(sentence)


@pytest.mark.parametrize(
    "sentence",
    [
        "There are infinitely many solutions when s5 = 0.",
        "The wrist has two solutions.",
        "There are at least two solutions.",
        "There is no solution if the point lies outside the workspace.",
    ],
)
def test_a_count_that_cannot_be_judged_says_why(sentence):
    (said,) = counted(sentence)
    assert not said.keys
    assert said.why


def test_a_sentence_begins_on_the_line_where_it_stands():
    said = counted("The arm\ntherefore has\neight solutions. And so\n\non.\nThere are two solutions.\n")
    assert [(one.line, one.keys["count"]) for one in said] == [(1, 8), (6, 2)]


@pytest.mark.parametrize(
    ("sentence", "status"),
    [
        ("There are four solutions.", HOLDS),
        ("There are two solutions.", WRONG),
        ("A position has up to four solutions.", HOLDS),
        ("A position has up to two solutions.", WRONG),
        ("There is no solution if $D > 1$.", HOLDS),
        ("There is no solution if $D < -1$.", HOLDS),
        ("There is no solution if $D > 0.9999$.", WRONG),
        (r"No solution exists for $p_x^2+p_y^2+(p_z-d_1)^2 > (a_2+a_3)^2$.", HOLDS),
        (r"No solution exists for $p_x^2+p_y^2+(p_z-d_1)^2 \ge (a_2+a_3-10^{-3})^2$.", WRONG),
        ("There are four solutions if $D < 0.9$.", HOLDS),
        ("There are three solutions if $D < 0.9$.", WRONG),
    ],
)
def test_the_count_is_judged(robot, sentence, status):
    file, _, _ = pieper.guess_claims(f"with $D = {D}$. {sentence}\n", robot, "page")
    (verdict,) = pieper.check(file).verdicts
    assert verdict.status == status, verdict.sentence


def test_a_bound_that_is_too_large_is_true_and_not_the_largest_number(robot):
    file, _, _ = pieper.guess_claims("A position has up to six solutions.\n", robot, "page")
    (verdict,) = pieper.check(file).verdicts
    assert verdict.status == "holds only in part"
    assert "no position of this arm has more than 4" in verdict.sentence
