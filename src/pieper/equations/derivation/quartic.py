"""Three axes in general position: one angle eliminated between two equations, a quartic for the next (Pieper 1968).

The squared distance of the wrist from the origin and its height do not depend on theta1. With k1, k2 functions of
theta3, they read alpha (k1 cos x + k2 sin x) + C1 = 0 and beta (k2 cos x - k1 sin x) + C2 = 0 in x = theta2; squares
added up, x is gone: (C1/alpha)^2 + (C2/beta)^2 = k1^2 + k2^2, a polynomial of degree 4 in the half-angle tangent of
theta3.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import Any

from pieper.algebra.determinant import monomial_content, one_circle
from pieper.algebra.expression import Call, Expr, Sym, Trig
from pieper.algebra.harmonic import Poly
from pieper.equations.derivation.patterns import Recipe, Solved, divided, shared
from pieper.equations.derivation.unknowns import Knowledge, View

COEFFICIENTS = tuple(Sym("e", str(k), 4) for k in (4, 3, 2, 1, 0))


def recognise_quartics(equations: list, knowledge: Knowledge, groups: tuple, rho: Sym) -> Iterator[Any]:
    """(angle, recipe, (equation, equation), polynomials) for every pair that leaves a quartic in one joint's angle.

    Args:
        equations: Equations with two unknown angles.
        knowledge: What is known.
        groups: Runs of parallel axes, by joint.
        rho: The symbol that numbers the roots, 1 to 4.
    """
    views = []
    for equation in equations:
        view = knowledge.view(equation.left - equation.right)
        if not view.slides and len(view.angles) == 2 and all(len(a) == 1 and a[0][1] == 1 for a in view.angles):
            views.append((equation, view))
    for (e1, v1), (e2, v2) in itertools.combinations(views, 2):
        if v1.angles != v2.angles:
            continue
        for x in sorted(v1.angles):
            (y,) = v1.angles - {x}
            first, second = _by(v1, x, groups), _by(v2, x, groups)
            if first is None or second is None:
                continue
            short, names = _named_constants((first, second))
            total = _eliminated(*short)
            if total is None:
                continue
            parts = _harmonics(knowledge.view(total), y)
            if parts is not None:
                recipe = Recipe("quartic", 4, False, lambda parts=parts, names=names: _solved(parts, rho, names))
                yield y, recipe, (e1, e2), (*first, *second)


def _by(view: View, x: tuple, groups: tuple) -> tuple[Poly, Poly, Poly] | None:
    """(A, B, C) of A cos x + B sin x + C, with the other angle inside them; None when x stands squared."""
    parts = {"c": Poly(), "s": Poly(), "": Poly()}
    for (_, mono), coefficient in view.terms.items():
        mine = [kind for kind, angle in mono if angle == x]
        if len(mine) > 1:
            return None
        rest = coefficient
        for kind, angle in mono:
            if angle != x:
                rest = rest * Poly.symbol(Trig(kind, angle, groups[angle[0][0] - 1]))
        parts[mine[0] if mine else ""] = parts[mine[0] if mine else ""] + rest
    return parts["c"], parts["s"], parts[""]


def _named_constants(equations: tuple) -> tuple[list[tuple], list[tuple[Sym, Poly]]]:
    """The equations with the part of C that holds no unknown under a name, so that its square stays short."""
    short, names = [], []
    for number, (A, B, C) in enumerate(equations, 1):
        known = Poly({key: value for key, value in C.terms.items() if not key[1]})
        if len(known.terms) > 1:
            name = Sym("K", str(number), 4)
            names.append((name, known))
            C = C - known + Poly.symbol(name)
        short.append((A, B, C))
    return short, names


def _eliminated(first: tuple, second: tuple) -> Poly | None:
    (A1, B1, C1), (A2, B2, C2) = first, second
    if not ((A1 or B1) and (A2 or B2)):
        return None
    # of crossed offsets that vanish (d3 = 0) one equation holds the sine alone and the other the cosine
    alpha, beta = (shared(A, B) if A and B else monomial_content(A or B)[0] for A, B in ((A1, B1), (A2, B2)))
    k1, k2 = divided(A1, alpha), divided(B1, alpha)
    a2, b2 = divided(A2, beta), divided(B2, beta)
    if not ((a2 == k2 and b2 == -k1) or (a2 == -k2 and b2 == k1)):
        return None
    return one_circle((beta * C1) ** 2 + (alpha * C2) ** 2 - (alpha * beta) ** 2 * (k1 * k1 + k2 * k2))


def _harmonics(view: View, y: tuple) -> tuple[Poly, ...] | None:
    """Coefficients of 1, cos y, sin y, cos 2y, sin 2y, when there is nothing else."""
    twice = ((y[0][0], 2),)
    keys = [(), (("c", y),), (("s", y),), (("c", twice),), (("s", twice),)]
    if not set(view.terms) <= {((), key) for key in keys}:
        return None
    return tuple(view.part((), key) for key in keys)


def _solved(parts: tuple[Poly, ...], rho: Sym, names: list) -> Solved:
    f0, c1, s1, c2, s2 = parts
    quartic = (f0 - c1 + c2, 2 * s1 - 4 * s2, 2 * f0 - 6 * c2, 2 * s1 + 4 * s2, f0 + c1 + c2)
    definitions: tuple[tuple[Sym, Expr], ...] = tuple(
        (symbol, poly.expr()) for symbol, poly in (*names, *zip(COEFFICIENTS, quartic, strict=True))
    )
    return Solved(Call("quartic", *COEFFICIENTS, rho), 4, (), None, "quartic", definitions)
