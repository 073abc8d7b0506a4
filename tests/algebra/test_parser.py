"""The formula language: what it reads, how it prints it back, and how it refuses."""

from __future__ import annotations

import time

import numpy as np
import pytest

from pieper.algebra.parser import FormulaError, parse, parse_equation

NAMES = set("a1 a2 a3 d1 d4 d6 nx ax ay az px py pz Px Py Pz K1 r12 r22".split())


@pytest.mark.parametrize(
    ("text", "printed"),
    [
        ("C1 C2", "c1 c2"),
        ("-S_6(C_4S_1 + S_4 C_{23})", "-s6 (c4 s1 + s4 c23)"),
        ("a_2C_1C_2 + a3C345", "a2 c1 c2 + a3 c345"),
        ("2a2a3", "2 a2 a3"),
        ("c(2-3) + s(2+3)", "c(2-3) + s23"),
        ("cos(t2 - t3) sin θ1", "c(2-3) s1"),
        ("cq2q3 cq1", "c23 c1"),
        ("axS23C1", "ax s23 c1"),
        ("a3.cq2q3".replace(".", " "), "a3 c23"),
        ("tan^-1(P_y/P_x)", "atan(Py/Px)"),
        ("arccos(az) ± π", "acos(az) +- pi"),
        ("atan2(r12, -r22)", "atan2(r12, -r22)"),
        ("sin^2 t1", "s1^2"),
        ("a2² − d4**2", "a2^2 - d4^2"),
        ("K_1/(2d4)", "K1/(2 d4)"),
        ("c1*c2*s3", "c1 c2 s3"),
        ("[a1 + {a2 (a3)}]", "a1 + a2 a3"),
    ],
)
def test_reads_the_notation_of_papers(text, printed):
    assert str(parse(text, NAMES, 6)) == printed


@pytest.mark.parametrize(
    "text", ["a2 c1 - a3 (s2 + d4/c3)^2", "atan2(-ay, ax) +- acos(pz/d6)", "-(a1 + a2) s(2-3) - 3 d4"]
)
def test_what_is_printed_reads_back_the_same(text):
    once = parse(text, NAMES, 6)
    assert str(parse(str(once), NAMES, 6)) == str(once)


def test_degrees_are_turned_into_radians():
    assert parse("90 deg").evaluate({}) == pytest.approx(np.pi / 2)
    assert parse("sin(30°)").evaluate({}) == pytest.approx(0.5)


def test_all_signs_of_one_formula_go_together():
    tree = parse("a1 +- a2 -+ a3", NAMES, 6)
    env = {"a1": 1.0, "a2": 10.0, "a3": 100.0}
    assert tree.evaluate(env, branch=1) == 1 + 10 - 100
    assert tree.evaluate(env, branch=-1) == 1 - 10 + 100


def caret_column(error):
    """Return the character under the caret of a message."""
    lines = str(error).splitlines()
    return lines[-2][lines[-1].index("^")]


@pytest.mark.parametrize(
    ("text", "word", "under"),
    [
        ("C1 (C2 + S3", "never closed", "("),
        ("C1)", "never opened", ")"),
        ("C1 + foo", "not a known symbol", "f"),
        ("C1 + C7", "the arm has 6 joints", "C"),
        ("__import__('os')", "no symbol", "_"),
        ("C1 $ 2", "has no meaning", "$"),
        ("3 4", "two numbers", "4"),
        ("atan2(ay)", "takes two values", "a"),
        ("atan(ay, ax)", "takes one value", "a"),
        ("a1 + * a2", "must stand here", "*"),
        ("C1 = C2", "no equals sign", "="),
    ],
)
def test_an_error_points_at_the_character(text, word, under):
    with pytest.raises(FormulaError, match=word) as caught:
        parse(text, NAMES, 6)
    assert caret_column(caught.value) == under


def test_an_unknown_symbol_gets_suggestions():
    with pytest.raises(FormulaError, match="did you mean.*a2") as caught:
        parse("a22 C1", NAMES, 6)
    assert "a2" in caught.value.suggestions


@pytest.mark.parametrize("text", ["", "   ", "C1 +", "sqrt"])
def test_an_unfinished_formula_is_refused(text):
    with pytest.raises(FormulaError, match="something must follow|must stand here"):
        parse(text, NAMES, 6)


@pytest.mark.parametrize(
    "text",
    [
        "(" * 5000 + "1" + ")" * 5000,
        "+-" * 5000 + "1",
        "sin " * 5000 + "1",
        "1" + "/2" * 5000,
        "-" * 5000 + "1",
        "2^" * 5000 + "2",
    ],
)
def test_nesting_beyond_reading_is_refused_and_not_a_crash(text):
    with pytest.raises(FormulaError):
        parse(text, NAMES, 6)


def test_a_sum_of_ten_thousand_terms_is_read_quickly():
    start = time.process_time()
    tree = parse(" + ".join(["a2 C1 S23"] * 10_000), NAMES, 6)
    assert len(tree.args) == 10_000
    assert time.process_time() - start < 5
    assert tree.evaluate({"a2": 1.0, "theta1": 0.0, "theta2": 0.0, "theta3": np.pi / 2}) == pytest.approx(10_000)


def test_a_formula_that_is_too_long_is_refused():
    with pytest.raises(FormulaError, match="characters"):
        parse("a1 + " * 100_000 + "a1", NAMES, 6)


def test_an_equation_needs_its_equals_sign():
    with pytest.raises(FormulaError, match="needs one '='"):
        parse_equation("C1 C2", NAMES, 6)
    left, right = parse_equation("C1^2 + S1^2 = 1", NAMES, 6)
    assert str(left) == "c1^2 + s1^2" and str(right) == "1"


def test_a_formula_must_be_text():
    with pytest.raises(FormulaError, match="text in quotes"):
        parse(3, NAMES, 6)
