"""One kind of expression for what is derived and for what somebody typed."""

from __future__ import annotations

import copy
import pickle

import mpmath
import numpy as np
import pytest

from pieper.algebra.arithmetics import DigitsField, NumpyField, SympyField
from pieper.algebra.expression import Call, Num, Sym, Trig, add, mul
from pieper.algebra.formula import Mention, Neg, positions, replaced
from pieper.algebra.parser import FormulaError, parse


def test_symbols_of_one_name_and_different_places_in_a_product_are_two():
    length, entry = Sym("b", "x", 1), Sym("b", "x", 4)
    assert length is not entry and length.rank == 1 and entry.rank == 4
    assert Sym("b", "x", 1) is length


def test_two_mentions_of_a_symbol_are_two_places():
    tree = parse("a2 c1 + a2 s1", {"a2"}, 6)
    first, second = (path for path, node, _ in positions(tree) if isinstance(node, Mention) and node.name == "a2")
    assert str(replaced(tree, first, Mention("a3"))) == "a3 c1 + a2 s1"
    assert str(replaced(tree, second, Mention("a3"))) == "a2 c1 + a3 s1"


def test_what_is_typed_keeps_its_digits_and_what_is_derived_is_folded():
    assert str(parse("0.50 c1 + 0", (), 6)) == "0.50 c1 + 0"
    assert str(add(mul(Num("0.50"), Num(2), Sym("a", "2")), Num(0))) == "a2"


def test_a_derived_formula_is_written_in_both_manners():
    expr = mul(Sym("a", "2"), Trig("c", ((2, 1), (3, 1)), 2)) - Sym("d", "4")
    assert expr.text() == "a2*c23 - d4"
    assert str(expr) == "a2 c23 - d4"
    assert str(parse(str(expr), {"a2", "d4"}, 6)) == str(expr)


@pytest.mark.parametrize(
    "text", ["acos(c1)", "asin(s1)", "atan2(s1, c1)", "sqrt(c1^2)", "hypot(s1, 2)", "tan t1", "sign(c1)"]
)
def test_all_arithmetics_mean_the_same(text):
    expr, at = parse(text, (), 6), 0.7
    plain = float(expr.evaluate({"theta1": at}))
    with mpmath.workdps(40):
        digits = float(expr.evaluate({"theta1": mpmath.mpf(at)}, DigitsField()))
    field = SympyField()
    exact = float(expr.evaluate({"theta1": field.sympy.Float(at)}, field))
    assert plain == pytest.approx(digits, abs=1e-15) == pytest.approx(exact, abs=1e-12)


@pytest.mark.parametrize("name", ["sqrt", "acos", "asin"])
def test_what_has_no_real_value_is_nan_in_every_arithmetic(name):
    outside = {"x": -1.5}
    assert np.isnan(Call(name, Mention("x")).evaluate(outside, NumpyField))
    assert mpmath.isnan(Call(name, Mention("x")).evaluate({"x": mpmath.mpf(-1.5)}, DigitsField()))


def test_an_arc_forgives_rounding_and_nothing_more():
    assert Call("acos", Mention("x")).evaluate({"x": 1 + 2e-16}) == 0
    assert np.isnan(Call("acos", Mention("x")).evaluate({"x": 1 + 1e-9}))


def test_a_branch_is_never_zero_but_a_sign_may_be():
    assert Call("sgn", Num(0)).evaluate({}) == 1
    assert Call("sign", Num(0)).evaluate({}) == 0


def test_a_division_of_numbers_by_zero_is_a_value():
    with np.errstate(divide="ignore"):
        assert np.isinf(parse("1/0").evaluate({}))


@pytest.mark.parametrize("number", ["1e999999999", "1e-300", "9" * 5000])
def test_numbers_out_of_range_are_refused_and_not_worked_out(number):
    with pytest.raises(FormulaError, match="out of range"):
        parse(number)


def test_minus_signs_do_not_pile_up():
    x = Mention("x")
    assert Neg.of(Neg.of(x)) is x
    assert str(parse("--a2", {"a2"}, 6)) == "a2"


def test_formulas_copy_and_pickle_with_their_symbols():
    derived = Sym("a", "2") * Trig("c", ((2, 1), (3, 1)), 2)
    typed = parse("0.50 a2 c23 +- 1", {"a2"}, 6)
    for back in (copy.deepcopy(derived), pickle.loads(pickle.dumps(derived))):
        assert back.atoms() == derived.atoms()
    assert str(pickle.loads(pickle.dumps(typed))) == str(typed)
