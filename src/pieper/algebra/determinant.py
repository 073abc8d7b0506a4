"""Determinants of matrices of trigonometric polynomials, kept in factors.

Expanding a 6x6 determinant and factoring the result is slow and loses the angle sums. Two facts avoid it. The value
does not depend on the frame nor on the reference point, so both are chosen for the most zeros; and a matrix with enough
zeros is block triangular after permuting rows and columns (Dulmage & Mendelsohn 1958), so its determinant is a product
of small ones: shoulder, elbow and wrist come out as the blocks.
"""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from pieper.algebra.expression import Sym, Trig
from pieper.algebra.harmonic import Poly, gather

LARGEST = 6000  # products of terms in one cofactor


class TooLarge(Exception):
    """The determinant is too long to be written out."""


@dataclass(frozen=True)
class Factor:
    """One factor of a determinant.

    Attributes:
        poly: The factor.
        columns: The columns (joints, 0-based) of the block it comes from.
    """

    poly: Poly
    columns: tuple[int, ...]


@dataclass(frozen=True)
class Factored:
    """scale * product of factors; `largest` is the size of the largest block that had to be expanded."""

    scale: Poly
    factors: tuple[Factor, ...]
    largest: int

    def poly(self) -> Poly:
        """Everything multiplied out."""
        total = self.scale
        for factor in self.factors:
            total = total * factor.poly
        return total

    @property
    def zero(self) -> bool:
        """Whether the value is zero."""
        return not self.scale


def blocks(matrix: list[list[Poly]]) -> list[tuple[list[int], list[int]]] | None:
    """Diagonal blocks (rows, columns) of the block triangular form; None when the matrix is singular by its zeros."""
    size = len(matrix)
    row_of = _matching([[c for c in range(size) if matrix[r][c].terms] for r in range(size)], size)
    if row_of is None:
        return None
    # An edge from column a to column b when the row matched to a has an entry in b; strong components are the blocks.
    edges = {c: [b for b in range(size) if b != c and matrix[row_of[c]][b].terms] for c in range(size)}
    return [([row_of[c] for c in part], part) for part in _strong_components(edges, size)]


def determinant(matrix: list[list[Poly]], variables: frozenset = frozenset()) -> Factored:
    """The determinant of a square matrix, in factors; `variables` are the symbols (d3, q3) that move."""
    parts = blocks(matrix)
    if parts is None:
        return Factored(Poly(), (), 0)
    rows = [r for part, _ in parts for r in part]
    columns = [c for _, part in parts for c in part]
    scale = Poly.number(_parity(rows) * _parity(columns))
    factors: list[Factor] = []
    for block_rows, block_columns in parts:
        value = expand([[matrix[r][c] for c in block_columns] for r in block_rows])
        if not value:
            return Factored(Poly(), (), len(block_columns))
        content, pieces = split(value, variables)
        scale = scale * content
        factors += [Factor(piece, tuple(sorted(block_columns))) for piece in pieces]
    return Factored(scale, tuple(factors), max(len(c) for _, c in parts))


def expand(matrix: list[list[Poly]]) -> Poly:
    """Determinant by cofactors along the row with the most zeros.

    Raises:
        TooLarge: More than LARGEST terms; no reader would follow, and nothing is gained over numbers.
    """
    if len(matrix) == 1:
        return matrix[0][0]
    row = max(range(len(matrix)), key=lambda r: sum(not p.terms for p in matrix[r]))
    total = Poly()
    for column, entry in enumerate(matrix[row]):
        if entry.terms:
            minor = [[p for c, p in enumerate(line) if c != column] for r, line in enumerate(matrix) if r != row]
            cofactor = expand(minor)
            if len(entry.terms) * len(cofactor.terms) > LARGEST:
                raise TooLarge
            total = total + entry * cofactor * (-1 if (row + column) % 2 else 1)
    return total


def split(poly: Poly, variables: frozenset = frozenset()) -> tuple[Poly, list[Poly]]:
    """Write a polynomial as (number and constant lengths) times factors that move."""
    scale, pieces, queue = Poly.number(1), [], [one_circle(poly)]
    while queue:
        content, rest = monomial_content(queue.pop())
        for (symbols, functions), value in content.terms.items():
            scale = scale * value
            for symbol, power in symbols:
                if symbol in variables:
                    pieces += [Poly.symbol(symbol)] * power
                else:
                    scale = scale * Poly.symbol(symbol) ** power
            for t in functions:
                (joint, factor), *more = t.angle
                if t.kind == "s" and factor == 2 and not more:  # sin 2x = 2 sin x cos x
                    pieces += [Poly.symbol(Trig(kind, ((joint, 1),), t.group, t.letter)) for kind in "sc"]
                    scale = scale * 2
                else:
                    pieces.append(Poly.symbol(t))
        if rest.constant() is not None:
            scale = scale * rest
            continue
        pair = _separate(rest) or _single_function(rest)
        if pair is not None:
            queue += pair
        elif any(isinstance(a, Trig) or a in variables for a in rest.atoms()):
            pieces.append(rest)
        else:
            scale = scale * rest
    return scale, pieces


def one_circle(poly: Poly) -> Poly:
    """Write the square of a constant sine (of a twist that is no quarter turn) as 1 - cosine squared."""
    if not any(map(_squared_sine, itertools.chain.from_iterable(symbols for symbols, _ in poly.terms))):
        return poly
    total = {key: value for key, value in poly.terms.items() if not any(map(_squared_sine, key[0]))}
    for (symbols, functions), value in poly.terms.items():
        if not any(map(_squared_sine, symbols)):
            continue
        kept = [item for item in symbols if not _squared_sine(item)]
        term = Poly({(tuple(kept), functions): value})
        for symbol, power in filter(_squared_sine, symbols):
            cosine = Poly.symbol(Sym("c" + symbol.base[1:], symbol.sub, 2))
            term = term * (1 - cosine * cosine) ** (power // 2)
            term = term * Poly.symbol(symbol) if power % 2 else term
        for key, more in term.terms.items():
            gather(total, key, more)
    return Poly(total)


def _squared_sine(item: tuple[Sym, int]) -> bool:
    symbol, power = item
    return symbol.rank == 2 and symbol.base[0] == "s" and power > 1


def monomial_content(poly: Poly) -> tuple[Poly, Poly]:
    """(monomial, rest) with poly = monomial * rest; the first term of the rest has a positive coefficient."""
    items = list(poly.terms.items())
    symbols = dict(items[0][0][0])
    functions = list(items[0][0][1])
    for (other, trig), _ in items[1:]:
        powers = dict(other)
        symbols = {s: min(p, powers[s]) for s, p in symbols.items() if s in powers}
        functions = [t for t in functions if t in trig]
    number = Fraction(math.gcd(*(v.numerator for _, v in items)), math.lcm(*(v.denominator for _, v in items)))
    rest = {}
    for (other, trig), value in items:
        powers = dict(other)
        kept = tuple((s, p - symbols.get(s, 0)) for s, p in other if powers[s] > symbols.get(s, 0))
        rest[(kept, tuple(t for t in trig if t not in functions))] = Fraction(value) / number
    if sum(1 for v in rest.values() if v < 0) * 2 > len(rest):
        number, rest = -number, {k: -v for k, v in rest.items()}
    key = (tuple(sorted(symbols.items(), key=lambda item: item[0].order)), tuple(functions))
    return Poly({key: number}), Poly(rest)


def _separate(poly: Poly) -> list[Poly] | None:
    """Two factors, when the coefficients of the functions of one group (or powers of one symbol) are proportional."""
    if len(poly.terms) < 4:
        return None
    groups = sorted({t.group for _, trig in poly.terms for t in trig})
    keys = [lambda symbols, trig, g=g: tuple(t for t in trig if t.group == g) for g in groups]
    keys += [lambda symbols, trig, s=s: tuple(x for x in symbols if x[0] is s) for s in _plain_symbols(poly)]
    for key in keys:
        table: dict = {}
        for (symbols, trig), value in poly.terms.items():
            mine = key(symbols, trig)
            rest = (tuple(x for x in symbols if x not in mine), tuple(t for t in trig if t not in mine))
            table.setdefault(mine, {})[rest] = value
        if len(table) < 2:
            continue
        first, total = monomial_content(Poly(next(iter(table.values()))))[1], Poly()
        for mine, terms in table.items():
            content, rest = monomial_content(Poly(terms))
            number = next(iter(rest.terms.values()))
            ratio = Fraction(number) / first.terms.get(next(iter(rest.terms)), number)
            if rest != first * ratio:
                break
            mono = Poly({((), mine) if mine and isinstance(mine[0], Trig) else (mine, ()): Fraction(1)})
            total = total + content * mono * ratio
        else:
            if len(first.terms) > 1:
                return [first, total]
    return None


def _single_function(poly: Poly) -> list[Poly] | None:
    """Take out s4 (or c4) hidden in 1 - c(2*4) and s(2*4): [s4, quotient] when the polynomial vanishes with it."""
    for joint in sorted(poly.joints()):
        single, double = ((joint, 1),), ((joint, 2),)
        mine = [t for t in poly.atoms() if isinstance(t, Trig) and any(j == joint for j, _ in t.angle)]
        if any(t.angle not in (single, double) for t in mine) or not any(t.angle == double for t in mine):
            continue
        t = mine[0]
        c1, s1, c2, s2 = (Trig(kind, angle, t.group, t.letter) for angle in (single, double) for kind in "cs")
        a0, a1, b1 = poly.without(*mine), poly.coefficient(c1), poly.coefficient(s1)
        a2, b2 = poly.coefficient(c2), poly.coefficient(s2)
        if not a1 and a0 == -a2:
            return [Poly.symbol(s1), b1 - 2 * (a2 * Poly.symbol(s1)) + 2 * (b2 * Poly.symbol(c1))]
        if not b1 and a0 == a2:
            return [Poly.symbol(c1), a1 + 2 * (a2 * Poly.symbol(c1)) + 2 * (b2 * Poly.symbol(s1))]
    return None


def _plain_symbols(poly: Poly) -> list[Any]:
    return sorted({s for symbols, _ in poly.terms for s, _ in symbols}, key=lambda s: s.order)


def _matching(rows: list[list[int]], size: int) -> dict[int, int] | None:
    """Columns matched to rows (augmenting paths), {column: row}, or None when there is no perfect matching."""
    owner: dict[int, int] = {}

    def assign(r: int, seen: set[int]) -> bool:
        for c in rows[r]:
            if c not in seen:
                seen.add(c)
                if c not in owner or assign(owner[c], seen):
                    owner[c] = r
                    return True
        return False

    return owner if all(assign(r, set()) for r in range(size)) else None


def _strong_components(edges: dict[int, list[int]], size: int) -> list[list[int]]:
    reach = [{c} for c in range(size)]
    changed = True
    while changed:
        changed = False
        for c in range(size):
            more = set().union(*(reach[b] for b in edges[c])) - reach[c] if edges[c] else set()
            if more:
                reach[c] |= more
                changed = True
    parts, placed = [], set()
    for c in range(size):
        if c not in placed:
            part = [b for b in sorted(reach[c]) if c in reach[b]]
            placed |= set(part)
            parts.append(part)
    return parts


def _parity(order: list[int]) -> int:
    sign = 1
    order = list(order)
    for i in range(len(order)):
        while order[i] != i:
            j = order[i]
            order[i], order[j] = order[j], order[i]
            sign = -sign
    return sign
