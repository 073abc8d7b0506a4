"""From matrix equations to one unknown after the other: the classical way, with every choice written down.

For known joints 1..i and j+1..n the rest of the arm satisfies
    (A1..Ai)^-1 T (A_{j+1}..An)^-1 = A_{i+1} .. A_j,
twelve equations for every split, of which those with a single unknown are solved (Paul 1981). Sums of squares help
where none has one: the distance of the wrist from a fixed point or axis does not depend on the joint that turns about
it (Pieper 1968). The order is fixed: one solution before two, outer joints before inner ones, short before long.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from pieper.algebra.determinant import one_circle
from pieper.algebra.expression import Expr, Num, Sym, Trig, add, angle_symbol, mul
from pieper.algebra.harmonic import Poly
from pieper.algebra.notation import subscript
from pieper.equations.derivation.patterns import (
    Recipe,
    Solved,
    recognise_double,
    recognise_single,
    recognise_slide,
    sign_expression,
)
from pieper.equations.derivation.quartic import recognise_quartics
from pieper.equations.derivation.unknowns import Knowledge
from pieper.equations.derivation.witness import Witness, single_joint
from pieper.equations.table import SymbolTable, inverse, matmul
from pieper.equations.target import Target

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


@dataclass(frozen=True)
class Move:
    """One unknown solved: what, by which equations, how."""

    symbol: Sym
    angle: tuple[tuple[int, int], ...]
    equations: tuple[Equation, ...]
    solved: Solved
    sigma: Sym | None
    names: tuple


class Eliminator:
    """Solves a chain joint by joint.

    Args:
        table: The arm as symbols (theta notation).
        given: Columns of the target that the task gives.
        chosen: Joints (1-based) whose value is chosen beforehand (redundant arms).
        fold_tool: Count the constant tool matrix to the last link (tasks that do not give the whole pose).
    """

    def __init__(
        self, table: SymbolTable, *, given: str = "noap", chosen: tuple[int, ...] = (), fold_tool: bool = False
    ) -> None:
        self.table, self.n, self.chosen = table, table.n, chosen
        self.links = list(table.A)
        if fold_tool:
            self.links[-1] = matmul(self.links[-1], table.tool)
        self._products: dict = {}
        self._inverses: dict = {}
        self.knowledge = Knowledge({j: table.variable(j) for j in table.prismatic})
        self.target = Target(self.product, self.n, self.knowledge, given)
        self.branch_signs: dict = {}
        self.moves: list[Move] = []
        self.free: list[int] = []
        self.witness = Witness(self)
        self.knowledge.joints |= set(chosen)

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

    # -- the loop --------------------------------------------------------------------------------------------
    def solve(self) -> bool:
        """Solve as far as it goes; True when every joint is known or free."""
        self.follow_sums()
        while len(self.knowledge.joints) < self.n:
            move = self.best()
            if move is None:
                return self.witness.stays_beside(self.knowledge) and self._free_rest()
            self.take(move)
        return True

    @property
    def outer(self) -> tuple[int, int]:
        """(i, j): joints 1..i and j+1..n are known."""
        i, j = 0, self.n
        while i < self.n and i + 1 in self.knowledge.joints:
            i += 1
        while j > i and j in self.knowledge.joints:
            j -= 1
        return i, j

    def take(self, move: Move) -> None:
        """Make a move: its joint or its sum of joints is known from here on."""
        self.moves.append(move)
        joint = single_joint(move.angle)
        if joint is not None:
            self.knowledge.joints.add(joint)
        else:
            self.knowledge.sums[move.angle] = move.symbol
        for function, factor in move.solved.sign_of.items():
            if function == "d":
                self.branch_signs[move.symbol] = move.sigma
            else:
                group = self.table.groups[move.angle[0][0] - 1]
                self.branch_signs[Trig(function, move.angle, group)] = mul(Num(factor), move.sigma)
        self.follow_sums()

    def follow_sums(self) -> None:
        """theta4 = theta234 - theta2 - theta3, as soon as all but one joint of a known sum are known."""
        again = True
        while again:
            again = False
            for angle, symbol in self.knowledge.sums.items():
                rest = [(j, k) for j, k in angle if j not in self.knowledge.joints]
                if len(rest) == 1 and abs(rest[0][1]) == 1:
                    joint, factor = rest[0]
                    others = [mul(Num(-k * factor), angle_symbol(j)) for j, k in angle if j != joint]
                    formula = add(mul(Num(factor), symbol), *others)
                    solved = Solved(formula, 1, (), None, "sum")
                    self.moves.append(Move(angle_symbol(joint), ((joint, 1),), (), solved, None, ()))
                    self.knowledge.joints.add(joint)
                    again = True
                    break

    def _free_rest(self) -> bool:
        """Joints that only occur in sums that are known are free: choose all but one of each sum."""
        while len(self.knowledge.joints) < self.n:
            open_sums = [a for a in self.knowledge.sums if any(j not in self.knowledge.joints for j, _ in a)]
            if not open_sums:
                return False
            joint = next(j for j, _ in open_sums[0] if j not in self.knowledge.joints)
            covered = {j for a in open_sums for j, _ in a}
            if set(range(1, self.n + 1)) - self.knowledge.joints - covered:
                return False
            self.free.append(joint)
            self.knowledge.joints.add(joint)
            self.follow_sums()
        return True

    # -- equations -------------------------------------------------------------------------------------------
    def tiers(self) -> Iterator[Iterator[Equation]]:
        """Generators of equations, the plain ones first; a later tier is looked at when the earlier have nothing."""
        i, j = self.outer
        seen: set = set()
        if self.moves and self.moves[-1].solved.kind == "quartic":
            yield iter(self.moves[-1].equations)
        yield self._plain(i, j, seen)
        yield self._sums_of_squares(i, j, seen)
        yield self._inverse_positions(i, j, seen)

    def _quartics(self, rho: Sym) -> Iterator[tuple]:
        """Options of the last resort: two equations in two unknowns that leave a quartic."""
        i, j = self.outer
        seen: set = set()
        equations = []
        for a, b, left, right in self._positions(i):
            if a == i:
                equations += [
                    e for r in range(3) for e in self._equation(left[r], right[r], Source(a, b, ((r, 3),)), seen)
                ]
                equations += list(self._squares(left, right, a, b, "squares", seen, longest=4 * LONGEST_SQUARES))
        for place, (y, recipe, used, polys) in enumerate(
            recognise_quartics(equations, self.knowledge, self.table.groups, rho)
        ):
            yield self._score(recipe, y, used, place), y, used, recipe, polys

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
        for a, b, left, right in self._positions(i):
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
        for shift in options:
            ones = [one_circle((p - s) ** 2) for p, s in zip(left, shift, strict=True)]
            twos = [one_circle((p - s) ** 2) for p, s in zip(right, shift, strict=True)]
            for rows in ((0, 1), (0, 2), (1, 2), (0, 1, 2)):
                one, two = (sum((squares[r] for r in rows), Poly()) for squares in (ones, twos))
                source = Source(a, b, tuple((r, 3) for r in rows), kind)
                yield from self._equation(one, two, source, seen, longest=3 * longest)

    # -- choosing --------------------------------------------------------------------------------------------
    def best(self) -> Move | None:
        """The next step: the first tier that has one, its best candidate that the witness confirms."""
        sigma = Sym("sigma", str(1 + sum(m.sigma is not None for m in self.moves)), 0)
        name = Sym("k", str(1 + len(self.moves)), 4)
        rho = Sym("rho", sigma.sub, 0)
        searches = [lambda e=e: self.options(e, sigma, name) for e in self.tiers()] + [lambda: self._quartics(rho)]
        for search in searches:
            options = sorted(search(), key=lambda option: option[0])
            for _, angle, used, recipe, polys in options:
                solved = recipe.build()
                mark = rho if solved is not None and solved.branches == 4 else sigma
                if solved is not None and self.witness.confirms(angle, solved, mark):
                    shown = [*polys, solved.formula, *(x for _, x in solved.definitions)]
                    names = tuple(self.target.show([*shown, *(p for e in used for p in (e.left, e.right))]))
                    return Move(self.symbol(angle), angle, used, solved, mark if solved.branches > 1 else None, names)
        return None

    def options(self, equations: Iterable[Equation], sigma: Sym, name: Sym) -> Iterator[tuple]:
        """(score, angle, equations, recipe, coefficients) for everything that can be solved now."""
        linear: dict[tuple, list] = {}
        # what a quartic leaves is the pair of equations it came from, and only the pair is unique
        pairs_only = bool(self.moves) and self.moves[-1].solved.kind == "quartic"
        for place, equation in enumerate(equations):
            view = self.knowledge.view(equation.left - equation.right)
            found = view.quadratic()
            if found is not None:
                symbol, coefficients = found[0], found[1:]
                recipe = recognise_slide(*coefficients, sigma)
                if recipe is not None:
                    joint = next(k for k, s in self.knowledge.prismatic.items() if s is symbol)
                    angle = ((joint, 1),)
                    yield self._score(recipe, angle, (equation,), place), angle, (equation,), recipe, coefficients
                continue
            found = view.linear()
            if found is None:
                continue
            angle, coefficients = found[0], found[1:]
            linear.setdefault(angle, []).append((equation, coefficients, place))
            recipe = recognise_single(*coefficients, sigma, name, self.target.column_mates)
            if recipe is not None and not pairs_only:
                yield self._score(recipe, angle, (equation,), place), angle, (equation,), recipe, coefficients
        for angle, rows in linear.items():
            rows = sorted(rows, key=lambda row: len((row[0].left - row[0].right).terms))[:10]
            for (e1, first, p1), (e2, second, p2) in itertools.combinations(rows, 2):
                recipe = recognise_double(first, second, self._sign)
                if recipe is not None:
                    score = self._score(recipe, angle, (e1, e2), min(p1, p2))
                    yield score, angle, (e1, e2), recipe, (*first, *second)

    def symbol(self, angle: tuple) -> Sym:
        """The symbol of a joint or of a sum of joints."""
        joint = single_joint(angle)
        return self.table.variable(joint) if joint is not None else Sym("theta", subscript(angle)[0], 3)

    def _sign(self, poly: Poly) -> Expr:
        return sign_expression(poly, self.branch_signs)

    def _score(self, recipe: Recipe, angle: tuple, equations: tuple, place: int) -> tuple:
        i, j = self.outer
        joint, outermost = single_joint(angle), self.outer == (0, self.n)
        left = {j for e in equations for j in e.left.joints() if j not in self.knowledge.joints}
        kinds = (
            "both functions",
            "rotated pair",
            "slide",
            "homogeneous",
            "square of a slide",
            "one function",
            "two functions",
            "quadratic of a slide",
            "linear pair",
            "quartic",
        )
        # A pair whose determinant may vanish anywhere is worse than two clean branches.
        weak = recipe.kind == "linear pair" and recipe.may_fail
        return (
            recipe.branches + 2 * weak,
            len(left),
            recipe.may_fail,
            len({(e.source.i, e.source.j, e.source.kind) for e in equations}) > 1,
            joint is None or joint not in (i + 1, j),
            recipe.branches > 1 and outermost and any(c != 3 for e in equations for _, c in e.source.places),
            kinds.index(recipe.kind),
            sum(a.rank == 1 for e in equations for a in e.right.atoms() if recipe.may_fail),
            sum(len(e.left.terms) + len(e.right.terms) for e in equations),
            place,
        )


def _unit() -> list[list[Poly]]:
    return [[Poly.number(int(r == c)) for c in range(4)] for r in range(4)]
