"""The equations of an arm of which some joints are known: every split of the chain, entries and sums of squares.

For known joints 1..i and j+1..n the rest of the arm satisfies (A1..Ai)^-1 T (A_{j+1}..An)^-1 = A_{i+1} .. A_j, twelve
equations for every split. The distance of the wrist from a fixed point or axis does not depend on the joint that turns
about it (Pieper 1968): sums of squares.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import dataclass

from pieper.algebra.determinant import one_circle
from pieper.algebra.harmonic import Poly
from pieper.equations.derivation.unknowns import Knowledge
from pieper.equations.table import inverse, matmul
from pieper.equations.target import Target

FOUR_COLUMNS = 4  # of a whole pose
LONGEST = 90  # terms of one equation; longer ones help nobody
LONGEST_SQUARES = 44  # terms before squaring


@dataclass(frozen=True)
class Source:
    """Where an equation comes from: the split (i, j) and the entries used, or which sum of squares."""

    i: int
    j: int
    places: tuple[tuple[int, int], ...]
    kind: str = "entry"  # entry, squares, inverse, inverse squares


@dataclass(frozen=True)
class Equation:
    """left - right = 0 with its source."""

    left: Poly
    right: Poly
    source: Source


class Splits:
    """Every split of a chain.

    Args:
        links: A1 .. An.
        knowledge: What is known so far (shared with the solver; it grows).
        given: Columns of T that the task gives, a subset of "noap".
    """

    def __init__(self, links: list[list[list[Poly]]], knowledge: Knowledge, given: str) -> None:
        self.links, self.n, self.knowledge = links, len(links), knowledge
        self._products: dict = {}
        self._inverses: dict = {}
        self._squared: dict[Poly, Poly] = {}
        self._put: dict = {}
        self.target = Target(self.product, self.n, knowledge, given)

    def put(self, values: dict) -> None:
        """Put values for symbols into every equation from here on, as where a sine vanishes."""
        self._put = values

    def product(self, i: int, j: int) -> list[list[Poly]]:
        """A_{i+1} ... A_j."""
        if (i, j) not in self._products:
            self._products[i, j] = (
                self.links[i] if j - i == 1 else matmul(self.links[i], self.product(i + 1, j)) if j > i else _unit()
            )
        return self._products[i, j]

    def inverse(self, i: int, j: int) -> list[list[Poly]]:
        """(A_{i+1} ... A_j)^-1, link by link: turned back as a whole it would have to be multiplied out."""
        if (i, j) not in self._inverses:
            back = inverse(self.links[i]) if j > i else _unit()
            self._inverses[i, j] = matmul(self.inverse(i + 1, j), back) if j - i > 1 else back
        return self._inverses[i, j]

    @property
    def outer(self) -> tuple[int, int]:
        """(i, j): joints 1..i and j+1..n are known."""
        i, j = 0, self.n
        while i < self.n and i + 1 in self.knowledge.joints:
            i += 1
        while j > i and j in self.knowledge.joints:
            j -= 1
        return i, j

    def tiers(self) -> Iterator[Iterator[Equation]]:
        """Generators of equations, the plain ones first; a later tier is looked at when the earlier have nothing."""
        i, j = self.outer
        seen: set = set()
        yield self._plain(i, j, seen)
        yield self._sums_of_squares(i, j, seen)
        yield self._inverse_positions(i, j, seen)

    def with_two_unknowns(self) -> list[Equation]:
        """Positions and sums of squares that may be longer: two of them may leave a quartic."""
        i, _ = self.outer
        seen: set = set()
        found: list[Equation] = []
        for a, b, left, right in self._positions(i):
            if a == i:
                for r in range(3):
                    found += self._equation(left[r], right[r], Source(a, b, ((r, 3),)), seen)
                found += self._squares(left, right, a, b, "squares", seen, longest=4 * LONGEST_SQUARES)
        return found

    def spare_equations(self) -> Iterator[Equation]:
        """Entries of every split in T's own entries: what a finished derivation can still be held against."""
        for a in range(self.n):
            left = self.target.matrix(0, self.n)
            if a:
                left = matmul(self.inverse(0, a), left)
            right = self.product(a, self.n)
            for c, r in itertools.product((3, 2, 0, 1), range(3)):
                total = left[r][c] - right[r][c]
                if total and len(total.terms) <= LONGEST and self.target.usable(total):
                    yield Equation(left[r][c], right[r][c], Source(a, self.n, ((r, c),)))

    def _plain(self, i: int, j: int, seen: set) -> Iterator[Equation]:
        yield from self._entries(i, j, i, j, seen)
        if j - i > 1:
            yield from self._entries(i, j, i + 1, j, seen)
            yield from self._entries(i, j, i, j - 1, seen)
        if j < self.n and len(self.target.given) < FOUR_COLUMNS:
            # joints at the end are known, but their matrices turn columns that are not given into those that are
            yield from self._entries(i, self.n, i, self.n, seen)
        for a, b, left, right in self._positions(i):
            for part in self._known_part(left, right):
                moved = [p - k for p, k in zip(right, part, strict=True)]
                both = zip(
                    self.target.shifted(a, b, [p - k for p, k in zip(left, part, strict=True)]), moved, strict=True
                )
                for r, (one, other) in enumerate(both):
                    yield from self._equation(one, other, Source(a, b, ((r, 3),)), seen)
            for r in range(3):
                yield from self._equation(left[r], right[r], Source(a, b, ((r, 3),)), seen)

    def _sums_of_squares(self, i: int, j: int, seen: set) -> Iterator[Equation]:
        for a, b, left, right in self._positions(i):
            yield from self._squares(left, right, a, b, "squares", seen)

    def _entries(self, i: int, j: int, a: int, b: int, seen: set) -> Iterator[Equation]:
        F = self.target.matrix(i, j)
        left = F
        if a > i:
            left = matmul(self.inverse(i, a), left)
        if b < j:
            left = matmul(left, self.inverse(b, j))
        right = self.product(a, b)
        for c in (3, 2, 0, 1):
            for r in range(3):
                yield from self._equation(left[r][c], right[r][c], Source(a, b, ((r, c),)), seen)

    def _positions(self, i: int) -> Iterator[tuple[int, int, list[Poly], list[Poly]]]:
        """(a, b, left, right): positions of the two sides, for every split whose position needs no later joint."""
        for b in range(self.n, i, -1):
            if not self.target.position_is_known(b):
                return
            w = self.target.column(i, b, 3)
            for a in (i, i + 1):
                if a < b:
                    left = w
                    if a > i:
                        back = self.inverse(i, a)
                        left = [sum((back[r][k] * w[k] for k in range(3)), back[r][3]) for r in range(3)]
                    yield a, b, left, [self.product(a, b)[r][3] for r in range(3)]

    def _inverse_positions(self, i: int, j: int, seen: set) -> Iterator[Equation]:
        for a in range(i, j):
            here = [self.product(0, a)[r][3] if a else Poly() for r in range(3)]
            if not all(self.knowledge.knows(p) for p in here):
                break
            seen_from = self.target.inverse_position(a, j)
            for b in (j, j - 1):
                if b <= a:
                    continue
                left = seen_from
                if b < j:
                    out = self.product(b, j)
                    left = [sum((out[r][k] * seen_from[k] for k in range(3)), out[r][3]) for r in range(3)]
                right = [row[3] for row in self.inverse(a, b)[:3]]
                for r in range(3):
                    yield from self._equation(left[r], right[r], Source(a, b, ((r, 3),), "inverse"), seen)
                yield from self._squares(left, right, a, b, "inverse squares", seen)

    def _equation(
        self, left: Poly, right: Poly, source: Source, seen: set, longest: int = LONGEST
    ) -> Iterator[Equation]:
        if self._put:
            left, right = left.substitute(self._put), right.substitute(self._put)
        total = left - right
        if not total or len(total.terms) > longest or total in seen or -total in seen:
            return
        if not self.target.usable(total) or self.knowledge.knows(total):
            return
        seen.add(total)
        yield Equation(left, right, source)

    def _squares(
        self, left: list[Poly], right: list[Poly], a: int, b: int, kind: str, seen: set, longest: int = LONGEST_SQUARES
    ) -> Iterator[Equation]:
        if self._put:
            left, right = ([p.substitute(self._put) for p in side] for side in (left, right))
        # One joint can drop out on each side; with more than one besides them nothing single can be left.
        unknown = {j for p in (*left, *right) for j in p.joints() if j not in self.knowledge.joints}
        if sum(len(p.terms) for p in (*left, *right)) > longest or len(unknown) > 3:
            return
        options = [[Poly()] * 3]
        # distances from a fixed point: the constant part of the position, or the origin of the first joint
        for fixed in (right, [row[3] for row in self.product(a, a + 1)[:3]]):
            constant = [Poly({key: v for key, v in p.terms.items() if not key[1]}) for p in fixed]
            constant = [p if self.knowledge.knows(p) else Poly() for p in constant]
            if any(constant) and constant not in options:
                options.append(constant)
        for shift in [*options, *self._known_part(left, right)]:
            sides = [[p - s for p, s in zip(ps, shift, strict=True)] for ps in (left, right)]
            if shift not in options:
                sides[0] = self.target.shifted(a, b, sides[0])
            ones, twos = ([self._square(p) for p in side] for side in sides)
            for rows in ((0, 1), (0, 2), (1, 2), (0, 1, 2)):
                one, two = (sum((squares[r] for r in rows), Poly()) for squares in (ones, twos))
                source = Source(a, b, tuple((r, 3) for r in rows), kind)
                yield from self._equation(one, two, source, seen, longest=3 * longest)

    def _known_part(self, left: list[Poly], right: list[Poly]) -> Iterator[list[Poly]]:
        """What is known of the right side's terms with angles, as where theta234 is: it goes to the other side."""
        if not all(map(self.knowledge.knows, left)):
            return
        part = [Poly({k: v for k, v in p.terms.items() if k[1] and self.knowledge.knows(Poly({k: v}))}) for p in right]
        if any(part):
            yield part

    def _square(self, poly: Poly) -> Poly:
        """The square; the same ones come back from step to step."""
        if poly not in self._squared:
            self._squared[poly] = one_circle(poly**2)
        return self._squared[poly]


def _unit() -> list[list[Poly]]:
    return [[Poly.number(int(r == c)) for c in range(4)] for r in range(4)]
