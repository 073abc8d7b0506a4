"""The few equations of one unknown that inverse kinematics comes down to, and how each is solved.

A cos x + B sin x + C = 0, alone or twice with the same x; a slide alone, or its square. Each pattern gives the formula,
the number of its branches, and where it degenerates. The list is that of Paul (1981) and Craig (2005), chapter 4.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from pieper.algebra.determinant import monomial_content
from pieper.algebra.expression import Add, Call, Expr, Num, Sym, add, atan2, mul, sqrt
from pieper.algebra.harmonic import Poly
from pieper.algebra.notation import negative


@dataclass(frozen=True)
class Solved:
    """One unknown solved.

    Attributes:
        formula: The formula for it.
        branches: 1, or 2 when the formula holds a branch sign.
        degenerate: Expressions that all vanish where the unknown is free.
        merge: Expression that vanishes where the two branches are one; None for one branch.
        sign_of: Functions whose sign the branch sign is, {"s": factor} meaning sign(sin x) = factor * sigma.
        kind: Name of the pattern.
    """

    formula: Expr
    branches: int
    degenerate: tuple[Expr, ...]
    merge: Expr | None
    kind: str
    definitions: tuple = ()
    sign_of: dict = field(default_factory=dict)


@dataclass(frozen=True)
class Recipe:
    """A pattern recognised but not yet written out: enough to choose between several.

    Attributes:
        kind: Name of the pattern.
        branches: Number of solutions.
        may_fail: Whether a unique solution needs something not to vanish.
        build: Writes the formula out, as Solved, or None when it has no real solution.
    """

    kind: str
    branches: int
    may_fail: bool
    build: Callable[[], Solved | None]


def recognise_single(A: Poly, B: Poly, C: Poly, sigma: Sym, name: Sym, mates: Any = None) -> Recipe | None:
    """A cos x + B sin x + C = 0, before it is written out."""
    if not A and not B:
        return None
    kind = "homogeneous" if not C else "two functions" if A and B else "one function"
    return Recipe(kind, 2, False, lambda: single(A, B, C, sigma, name, mates))


def recognise_double(first: tuple, second: tuple, signs: Any) -> Recipe | None:
    """Two such equations, before they are written out."""
    (A1, B1, _), (A2, B2, _) = first, second
    if not A2 and B2 and not B1 and A1 or not A1 and B1 and not B2 and A2:
        kind, may_fail = "both functions", (A1 or B1).constant() is None or (A2 or B2).constant() is None
    elif (A2 == -B1 and B2 == A1) or (A2 == B1 and B2 == -A1):
        kind, may_fail = "rotated pair", False
    else:
        D = A1 * B2 - A2 * B1
        if not D:
            return None
        kind, may_fail = "linear pair", D.constant() is None
    return Recipe(kind, 1, may_fail, lambda: double(first, second, signs))


def recognise_slide(A: Poly, B: Poly, C: Poly, sigma: Sym) -> Recipe | None:
    """A d^2 + B d + C = 0, before it is written out."""
    if not A and not B:
        return None
    if not A:
        return Recipe("slide", 1, B.constant() is None, lambda: slide(A, B, C, sigma))
    return Recipe("quadratic of a slide" if B else "square of a slide", 2, False, lambda: slide(A, B, C, sigma))


def quotient(over: Poly, under: Poly) -> Expr:
    """Quotient over / under, with numbers and a common minus sign worked in."""
    value = under.constant()
    if value is not None:
        return positive_first((over * (1 / Fraction(value))).expr())
    if len(under.terms) == 1 and next(iter(under.terms.values())) < 0:
        over, under = -over, -under
    return positive_first(over.expr()) / under.expr()


def positive_first(expr: Expr) -> Expr:
    """A sum that begins with a minus sign with a term that has none in front, if there is one."""
    if not isinstance(expr, Add) or not negative(expr):
        return expr
    return add(*(t for t in expr.args if not negative(t)), *(t for t in expr.args if negative(t)))


def _square(expr: Expr) -> Expr:
    """The square, of a product without its sign."""
    return (mul(Num(-1), expr) if negative(expr) and not isinstance(expr, Add) else expr) ** 2


def single(A: Poly, B: Poly, C: Poly, sigma: Sym, name: Sym, mates: Any = None) -> Solved | None:
    """A cos x + B sin x + C = 0 alone: two branches.

    Args:
        A: Factor of the cosine.
        B: Factor of the sine.
        C: The rest.
        sigma: Sign of the branch.
        name: Symbol for the right-hand side where it is long.
        mates: symbol -> the other two entries of its column, when it is an entry of a rotation matrix.
    """
    if not A and not B:
        return None
    if not C:
        if not A or not B:
            # cos x = 0 or sin x = 0: two fixed values
            where = (sigma, Num(0)) if not B else (Num(0), sigma)
            return Solved(atan2(*where), 2, ((A or B).expr(),), None, "homogeneous")
        return Solved(atan2(sigma * -A.expr(), sigma * B.expr()), 2, (A.expr(), B.expr()), None, "homogeneous")
    if not B or not A:
        one = A or B
        value, definitions = quotient(-C, one), ()
        if isinstance(value, Num) and abs(value.value) > 1:
            return None
        if len(C.terms) > 1:
            value, definitions = name, ((name, value),)
        root = _complement(C, one, mates) or sqrt(add(Num(1), mul(Num(-1), value**2)))
        # cos x = value: the branch is the sign of sin x; sin x = value: that of cos x
        formula = atan2(sigma * root, value) if not B else atan2(value, sigma * root)
        return Solved(
            formula,
            2,
            (one.expr(),) if one.constant() is None else (),
            root,
            "one function",
            definitions,
            {"s" if not B else "c": 1},
        )
    # A cos x + B sin x = -C, divided by what A and B share
    both = shared(A, B)
    A, B = divided(A, both), divided(B, both)
    if _negatives(A) + _negatives(B) > (len(A.terms) + len(B.terms)) / 2:
        A, B, both = -A, -B, -both
    right, definitions = quotient(-C, both), ()
    if len(C.terms) > 1 or len(both.atoms()) > 0:
        right, definitions = name, ((name, right),)
    a, b = A.expr(), B.expr()
    square = A * A + B * B
    root = add(
        square.expr() if square.constant() is not None or len(square.terms) < 3 else add(_square(a), _square(b)),
        -(right**2),
    )
    formula = add(atan2(b, a), atan2(sigma * sqrt(root), right))
    return Solved(formula, 2, (a, b), root, "two functions", definitions)


def double(first: tuple[Poly, Poly, Poly], second: tuple[Poly, Poly, Poly], signs: Any) -> Solved | None:
    """Two equations A cos x + B sin x + C = 0 with the same x: one solution."""
    (A1, B1, C1), (A2, B2, C2) = first, second
    if not A2 and B2 and not B1 and A1 or not A1 and B1 and not B2 and A2:
        if not A1:
            (A1, B1, C1), (A2, B2, C2) = second, first
        # A1 cos x = -C1, B2 sin x = -C2
        same = A1 == B2 or A1 == -B2
        if same:
            sign = 1 if A1 == B2 else -1
            value = A1.constant()
            scale = signs(A1)
            over, under = (-C2 * sign), -C1
            if value is not None and value < 0:
                over, under = -over, -under
            degenerate = () if value is not None else (A1.expr(),)
            return Solved(
                atan2(mul(scale, over.expr()), mul(scale, under.expr())), 1, degenerate, None, "both functions"
            )
        return Solved(atan2(quotient(-C2, B2), quotient(-C1, A1)), 1, (A1.expr(), B2.expr()), None, "both functions")
    D = A1 * B2 - A2 * B1
    if not D:
        return None
    over, under = A2 * C1 - A1 * C2, B1 * C2 - B2 * C1
    rotated = (A2 == -B1 and B2 == A1) or (A2 == B1 and B2 == -A1)
    if rotated:
        sign = 1 if B2 == A1 else -1
        return Solved(atan2(_times(over, sign), _times(under, sign)), 1, (A1.expr(), B1.expr()), None, "rotated pair")
    scale = signs(D)
    value = D.constant()
    if value is not None and value < 0:
        over, under = -over, -under
    degenerate = () if value is not None else (D.expr(),)
    return Solved(atan2(mul(scale, over.expr()), mul(scale, under.expr())), 1, degenerate, None, "linear pair")


def slide(A: Poly, B: Poly, C: Poly, sigma: Sym) -> Solved | None:
    """A d^2 + B d + C = 0 for a sliding joint."""
    if not A:
        if not B:
            return None
        return Solved(quotient(-C, B), 1, () if B.constant() is not None else (B.expr(),), None, "slide")
    if not B:
        square = quotient(-C, A)
        return Solved(sigma * sqrt(square), 2, (), square, "square of a slide", (), {"d": 1})
    root = add(B.expr() ** 2, mul(Num(-4), A.expr(), C.expr()))
    return Solved((-B.expr() + sigma * sqrt(root)) / (Num(2) * A.expr()), 2, (A.expr(),), root, "quadratic of a slide")


def _times(poly: Poly, sign: int) -> Expr:
    return (poly * sign).expr()


def _negatives(poly: Poly) -> int:
    return sum(1 for value in poly.terms.values() if value < 0)


def shared(A: Poly, B: Poly) -> Poly:
    """The number and symbols that every term of A and B has (no functions of angles)."""
    both = Poly({((), ()): Fraction(1)})
    contents = [monomial_content(p)[0] for p in (A, B)]
    ((one, _), v1), ((two, _), v2) = (next(iter(c.terms.items())) for c in contents)
    powers = dict(two)
    symbols = tuple((s, min(p, powers[s])) for s, p in one if s in powers)
    number = Fraction(math.gcd(v1.numerator, v2.numerator), math.lcm(v1.denominator, v2.denominator))
    return Poly({(symbols, ()): number}) if symbols or number != 1 else both


def divided(poly: Poly, by: Poly) -> Poly:
    """The polynomial over a monomial that divides it."""
    (((symbols, _), number),) = by.terms.items()
    powers = dict(symbols)
    return Poly(
        {
            (tuple((s, p - powers.get(s, 0)) for s, p in mine if p > powers.get(s, 0)), trig): Fraction(value) / number
            for (mine, trig), value in poly.terms.items()
        }
    )


def _complement(C: Poly, one: Poly, mates: Any) -> Expr | None:
    """sqrt(1 - u33^2) as sqrt(u13^2 + u23^2): the same, and exact where u33 is close to 1."""
    if mates is None or one.constant() not in (1, -1) or len(C.terms) != 1:
        return None
    (((symbols, functions), value),) = C.terms.items()
    if functions or len(symbols) != 1 or symbols[0][1] != 1 or abs(value) != 1:
        return None
    others = mates(symbols[0][0])
    if others is None or any(p.constant() is not None and p.constant() != 0 for p in others):
        return None
    terms = [_square(p.expr()) for p in others if p]
    return sqrt(add(*terms)) if terms else None


def sign_expression(poly: Poly, branch_signs: dict) -> Expr:
    """The sign of a known factor: a number, the branch sign that it is, or sgn(...).

    Args:
        poly: The factor.
        branch_signs: {Trig or slide symbol: branch sign} of unknowns solved with a square root.
    """
    value = poly.constant()
    if value is not None:
        return Num(1)
    if len(poly.terms) == 1:
        (((symbols, functions), number),) = poly.terms.items()
        pieces = [branch_signs.get(t) for t in functions]
        rest = [(s, p) for s, p in symbols if p % 2]
        pieces += [branch_signs.get(s) for s, _ in rest]
        unknown = [a for a, p in zip([*functions, *(s for s, _ in rest)], pieces, strict=True) if p is None]
        known = [p for p in pieces if p is not None]
        sign = Num(1 if number > 0 else -1)
        if not unknown:
            return mul(sign, *known)
        return mul(sign, *known, Call("sgn", mul(*unknown)))
    return Call("sgn", poly.expr())
