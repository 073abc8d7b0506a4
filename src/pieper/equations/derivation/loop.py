"""The matrix equation of a step as a formula: (A1 .. Ai)^-1 T (A_{j+1} .. An)^-1 = A_{i+1} .. A_j."""

from __future__ import annotations

from pieper.document.blocks import Formula
from pieper.document.formulas import MINUS_ONE, Written, equals, named, product


def matrix_equation(i: int, j: int, n: int, *, inverse: bool = False) -> Written:
    """Return the equation, or the inverse of both sides."""
    if inverse:
        sides = [*_links(j + 1, n), _inverted(named("T")), *_links(1, i)], [_back(i + 1, j)]
    else:
        left = [*([_back(1, i)] if i else []), named("T"), *([_back(j + 1, n)] if j < n else [])]
        sides = left, _links(i + 1, j)
    return equals(*map(product, sides))


def _links(first: int, last: int) -> list[Formula]:
    return [named("A", str(k)) for k in range(first, last + 1)]


def _back(first: int, last: int) -> Written:
    if first == last:
        index = f"<msubsup><mi>A</mi><mn>{first}</mn>{MINUS_ONE}</msubsup>"
        return Written(f"A{first}^-1", f"A_{{{first}}}^{{-1}}", index)
    inner = product(_links(first, last))
    return _inverted(
        Written(f"({inner.text()})", f"({inner.latex()})", f"<mrow><mo>(</mo>{inner.mathml()}<mo>)</mo></mrow>")
    )


def _inverted(base: Written) -> Written:
    return Written(f"{base.text()}^-1", f"{base.latex()}^{{-1}}", f"<msup>{base.mathml()}{MINUS_ONE}</msup>")
