"""Trigonometric polynomials in a form in which angle sums appear by construction and zero is always seen as zero.

A term is a rational coefficient, powers of plain symbols, and at most one sine or cosine per run of parallel axes.
Two functions of the same run are multiplied by the product-to-sum rules at once, so c2 c3 - s2 s3 becomes c23 and
s2^2 + c2^2 becomes 1 without any search. The functions of whole-number combinations of independent angles are linearly
independent (Fourier), therefore two polynomials are equal exactly when their terms are.
"""

from __future__ import annotations

import functools
from fractions import Fraction
from typing import Any

from pieper.algebra.arithmetics import NumpyField
from pieper.algebra.expression import ZERO, Expr, Num, Sym, Trig, mul
from pieper.algebra.nesting import shortest, whole

HALF = Fraction(1, 2)


class Poly:
    """A sum of terms {(symbols, trig): coefficient}.

    `symbols` is a sorted tuple of (Sym, power), `trig` a tuple of Trig sorted by group, one per group.
    """

    __slots__ = ("terms",)

    def __init__(self, terms: dict | None = None) -> None:
        self.terms = terms or {}

    @classmethod
    def number(cls, value: Any) -> Poly:
        """The polynomial that is a number."""
        value = whole(Fraction(value))
        return cls({((), ()): value} if value else {})

    @classmethod
    def symbol(cls, atom: Sym | Trig, coefficient: int | Fraction = 1) -> Poly:
        """The polynomial that is a multiple of one symbol or function."""
        key = ((), (atom,)) if isinstance(atom, Trig) else (((atom, 1),), ())
        return cls({key: coefficient})

    def __bool__(self) -> bool:
        return bool(self.terms)

    def __eq__(self, other: Any) -> bool:
        return isinstance(other, Poly) and self.terms == other.terms

    def __hash__(self) -> int:
        return hash(frozenset(self.terms.items()))

    def __add__(self, other: Any) -> Poly:
        other = as_poly(other)
        terms = dict(self.terms)
        for key, value in other.terms.items():
            gather(terms, key, value)
        return Poly(terms)

    __radd__ = __add__

    def __neg__(self) -> Poly:
        return Poly({key: -value for key, value in self.terms.items()})

    def __sub__(self, other: Any) -> Poly:
        return self + (-as_poly(other))

    def __rsub__(self, other: Any) -> Poly:
        return as_poly(other) - self

    def __mul__(self, other: Any) -> Poly:
        other = as_poly(other)
        terms: dict = {}
        for (sym1, trig1), c1 in self.terms.items():
            for (sym2, trig2), c2 in other.terms.items():
                symbols = _merge_symbols(sym1, sym2)
                for trig, factor in _merge_trig(trig1, trig2):
                    gather(terms, (symbols, trig), _scaled(c1 * c2, factor))
        return Poly(terms)

    __rmul__ = __mul__

    def __pow__(self, power: int) -> Poly:
        if power == 2:
            return self._squared()
        result = self if power else Poly.number(1)
        for _ in range(power - 1):
            result = result * self
        return result

    def _squared(self) -> Poly:
        # each pair of terms once, and doubled
        terms: dict = {}
        items = list(self.terms.items())
        for place, ((sym1, trig1), c1) in enumerate(items):
            for other, ((sym2, trig2), c2) in enumerate(items[place:]):
                symbols, value = _merge_symbols(sym1, sym2), c1 * c2 * (2 if other else 1)
                for trig, factor in _merge_trig(trig1, trig2):
                    gather(terms, (symbols, trig), _scaled(value, factor))
        return Poly(terms)

    # -- looking inside --------------------------------------------------------------------------------------
    def atoms(self) -> set:
        """The symbols and functions that occur."""
        return {a for symbols, trig in self.terms for a in (*trig, *(s for s, _ in symbols))}

    def joints(self) -> set[int]:
        """Joints whose angle occurs."""
        return {j for _, trig in self.terms for t in trig for j, _ in t.angle}

    def angles(self) -> set[tuple]:
        """The angle combinations that occur."""
        return {t.angle for _, trig in self.terms for t in trig}

    def constant(self) -> Fraction | None:
        """The value, when the polynomial is a plain number."""
        if not self.terms:
            return Fraction(0)
        if len(self.terms) == 1:
            return self.terms.get(((), ()))
        return None

    def coefficient(self, atom: Sym | Trig) -> Poly:
        """The polynomial that multiplies the first power of `atom`."""
        terms: dict = {}
        for (symbols, trig), value in self.terms.items():
            if isinstance(atom, Trig):
                if atom in trig:
                    terms[(symbols, tuple(t for t in trig if t is not atom))] = value
            elif (atom, 1) in symbols:
                terms[(tuple(s for s in symbols if s[0] is not atom), trig)] = value
        return Poly(terms)

    def without(self, *atoms: Sym | Trig) -> Poly:
        """The terms in which none of the atoms occurs."""
        return Poly(
            {
                key: value
                for key, value in self.terms.items()
                if not any(t in atoms for t in key[1]) and not any(s in atoms for s, _ in key[0])
            }
        )

    def substitute(self, table: dict) -> Poly:
        """Replace symbols by polynomials or numbers."""
        if not any(atom in table for atom in self.atoms()):
            return self
        total = Poly()
        for (symbols, trig), value in self.terms.items():
            term = Poly({((), ()): value})
            for symbol, power in symbols:
                term = term * (as_poly(table.get(symbol, symbol)) ** power)
            for t in trig:
                term = term * as_poly(table.get(t, t))
            total = total + term
        return total

    def derivative(self, joint: int, letter: str = "theta") -> Poly:
        """The derivative by the angle of one joint."""
        total = Poly()
        for (symbols, functions), value in self.terms.items():
            for place, t in enumerate(functions):
                factor = dict(t.angle).get(joint, 0)
                if factor and t.letter == letter:
                    turned = Trig("s" if t.kind == "c" else "c", t.angle, t.group, letter)
                    key = (symbols, (*functions[:place], turned, *functions[place + 1 :]))
                    total = total + Poly({key: value * factor * (-1 if t.kind == "c" else 1)})
        return total

    def evaluate(self, values: dict) -> Any:
        """The value in double precision, for numbers or arrays."""
        total = 0.0
        for (symbols, functions), value in self.terms.items():
            term = float(value)
            for symbol, power in symbols:
                term = term * values[symbol] ** power
            for t in functions:
                term = term * t.evaluate(values, NumpyField)
            total = total + term
        return total

    # -- writing it out --------------------------------------------------------------------------------------
    def expr(self) -> Expr:
        """The polynomial as a person would factor it: nested along the chain, the shorter of two nestings."""
        if not self.terms:
            return ZERO
        shown = _without_double_angles(self)
        sizes = {abs(value) for value in shown.terms.values()}
        # halves and doubles come from the product rules; lengths that were put in as numbers are left alone
        content = min(sizes) if sizes <= {Fraction(1, 4), HALF, Fraction(1), Fraction(2), Fraction(4)} else 1
        rows = [
            (whole(Fraction(value) / content), [s for s, power in symbols for _ in range(power)] + list(trig))
            for (symbols, trig), value in shown.terms.items()
        ]
        return mul(Num(content), shortest(rows))


def as_poly(value: Any) -> Poly:
    """The value itself when it is a polynomial, else the polynomial that is this number, symbol or function."""
    if isinstance(value, Poly):
        return value
    if isinstance(value, (Sym, Trig)):
        return Poly.symbol(value)
    if isinstance(value, Num):
        return Poly.number(value.value)
    return Poly.number(value)


def trig(kind: str, angle: dict[int, int], group: int, letter: str = "theta") -> Poly:
    """Sine or cosine of an angle combination, with the first factor made positive."""
    items = tuple(sorted((j, k) for j, k in angle.items() if k))
    if not items:
        return Poly.number(1 if kind == "c" else 0)
    sign = 1
    if items[0][1] < 0:
        items = tuple((j, -k) for j, k in items)
        sign = 1 if kind == "c" else -1
    return Poly.symbol(Trig(kind, items, group, letter), sign)


def matmul(left: list[list[Poly]], right: list[list[Poly]]) -> list[list[Poly]]:
    """Product of two matrices of polynomials."""
    columns = list(zip(*right, strict=True))
    return [[_dot(row, column) for column in columns] for row in left]


def _dot(row: Any, column: Any) -> Poly:
    total = Poly()
    for x, y in zip(row, column, strict=True):
        if x.terms and y.terms:
            total = total + x * y
    return total


def _scaled(value: Any, factor: Any) -> int | Fraction:
    if type(value) is not int or type(factor) is int:
        return value * factor
    whole, rest = divmod(value * factor.numerator, factor.denominator)
    return Fraction(value) * factor if rest else whole


def gather(terms: dict, key: Any, value: Any) -> None:
    """Add a value to a term, in place; a term that becomes zero goes."""
    total = terms.get(key, 0) + value
    if total:
        terms[key] = total if type(total) is int else whole(total)
    else:
        terms.pop(key, None)


def _merge_symbols(left: tuple, right: tuple) -> tuple:
    if not left or not right:
        return left or right
    powers = dict(left)
    for symbol, power in right:
        powers[symbol] = powers.get(symbol, 0) + power
    return tuple(sorted(powers.items(), key=lambda item: item[0].order))


def _merge_trig(left: tuple, right: tuple) -> list[tuple[tuple, int | Fraction]]:
    if not left or not right:
        return [(left or right, 1)]
    groups = {t.group: t for t in left}
    results = [(dict(groups), 1)]
    for t in right:
        mine = groups.get(t.group)
        if mine is None:
            for table, _ in results:
                table[t.group] = t
            continue
        results = [
            (
                {**{g: x for g, x in table.items() if g != t.group}, **({t.group: product} if product else {})},
                factor * weight,
            )
            for table, factor in results
            for product, weight in _product_to_sum(mine, t)
        ]
    return [(tuple(table[g] for g in sorted(table)), factor) for table, factor in results]


@functools.cache
def _product_to_sum(x: Trig, y: Trig) -> list[tuple[Trig | None, Fraction]]:
    """x*y for two functions of the same group, as [(function or None for 1, factor)]."""
    total, difference = dict(x.angle), dict(x.angle)
    for joint, factor in y.angle:
        total[joint] = total.get(joint, 0) + factor
        difference[joint] = difference.get(joint, 0) - factor
    kinds = x.kind + y.kind
    kind = "c" if kinds in ("cc", "ss") else "s"
    weights = {"cc": (HALF, HALF), "ss": (-HALF, HALF), "sc": (HALF, HALF), "cs": (HALF, -HALF)}[kinds]
    found = []
    for angle, weight in ((total, weights[0]), (difference, weights[1])):
        for (_, functions), sign in trig(kind, angle, x.group, x.letter).terms.items():
            found.append((functions[0] if functions else None, weight * sign))
    return found


def _without_double_angles(poly: Poly) -> Poly:
    """Write c(2*4) and s(2*4) with c4 and s4, as people do; other sums of angles stay.

    The powers are kept among the symbols, where the product rules do not gather them again; the result is for printing.
    """
    if not any(k == 2 and len(t.angle) == 1 for t in poly.atoms() if isinstance(t, Trig) for _, k in t.angle):
        return poly
    terms: dict = {}
    for (symbols, functions), value in poly.terms.items():
        rows = [(list(symbols), [], value)]
        for t in functions:
            (joint, factor), *more = t.angle
            if factor != 2 or more:
                rows = [(s, [*f, t], v) for s, f, v in rows]
                continue
            c, s_ = (Trig(kind, ((joint, 1),), t.group, t.letter) for kind in "cs")
            if t.kind == "s":
                rows = [([*s, (c, 1), (s_, 1)], f, 2 * v) for s, f, v in rows]
            else:
                rows = [row for s, f, v in rows for row in (([*s, (c, 2)], f, 2 * v), (s, f, -v))]
        for s, f, v in rows:
            gather(terms, (tuple(sorted(s, key=lambda item: item[0].order)), tuple(f)), v)
    return Poly(terms)
