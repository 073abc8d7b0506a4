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
from typing import Any

from pieper.algebra.expression import Expr, Num, Sym, Trig, add, angle_symbol, mul
from pieper.algebra.harmonic import Poly
from pieper.algebra.notation import subscript
from pieper.equations.derivation.patterns import (
    Recipe,
    Solved,
    positive_first,
    recognise_double,
    recognise_single,
    recognise_slide,
    sign_expression,
)
from pieper.equations.derivation.quartic import recognise_quartics
from pieper.equations.derivation.splits import Equation, Splits
from pieper.equations.derivation.unknowns import Knowledge
from pieper.equations.derivation.witness import Witness, single_joint
from pieper.equations.table import SymbolTable, matmul


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
        links = list(table.A)
        if fold_tool:
            links[-1] = matmul(links[-1], table.tool)
        self.knowledge = Knowledge({j: table.variable(j) for j in table.prismatic})
        self.splits = Splits(links, self.knowledge, given)
        self.target = self.splits.target
        self.branch_signs: dict = {}
        self.moves: list[Move] = []
        self.free: list[int] = []
        self.letter = "k"  # for a right-hand side that is long
        self.witness = Witness(self)
        self.knowledge.joints |= set(chosen)

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

    def take(self, move: Move) -> None:
        """Make a move: its joint or its sum of joints is known from here on."""
        for angle in self._met_sums(move):
            self._known_sum(angle)
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

    def _met_sums(self, move: Move) -> list[tuple]:
        """Sums in the formulas of a move that are known by another one: theta34 where theta234 and theta2 are."""
        named = {s: self.target.definitions[s] for s in move.names}
        polys = [*named.values(), *(p for e in move.equations for p in (e.left, e.right))]
        exprs = [move.solved.formula, *(x for _, x in move.solved.definitions)]
        atoms = set[Any]().union(*(p.atoms() for p in polys), *(x.atoms() for x in exprs))
        met = {
            t.angle
            for t in atoms
            if isinstance(t, Trig)
            and t.angle not in self.knowledge.sums
            and not self.knowledge.unknown_part(t.angle)
            and any(j not in self.knowledge.joints for j, _ in t.angle)
        }
        return sorted(met)

    def _known_sum(self, angle: tuple) -> None:
        """Write down a sum that is another one but for known joints."""
        for whole, symbol in self.knowledge.sums.items():
            for sign in (1, -1):
                rest = {j: k for j, k in angle}
                for j, k in whole:
                    rest[j] = rest.get(j, 0) - sign * k
                if all(j in self.knowledge.joints for j, k in rest.items() if k):
                    terms = [mul(Num(k), angle_symbol(j)) for j, k in sorted(rest.items()) if k]
                    formula = add(mul(Num(sign), symbol), *terms)
                    name = self.symbol(angle)
                    self.moves.append(Move(name, angle, (), Solved(formula, 1, (), None, "sum"), None, ()))
                    self.knowledge.sums[angle] = name
                    return

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
                    formula = positive_first(add(mul(Num(factor), symbol), *others))
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

    # -- choosing ------------------------------------------------------------------------------------------
    def tiers(self) -> Iterator[Iterator[Equation]]:
        """Generators of equations; after a quartic the pair that it came from first."""
        if self.moves and self.moves[-1].solved.kind == "quartic":
            yield iter(self.moves[-1].equations)
        yield from self.splits.tiers()

    def _quartics(self, rho: Sym) -> Iterator[tuple]:
        """Options of the last resort: two equations in two unknowns that leave a quartic."""
        equations = self.splits.with_two_unknowns()
        for place, (y, recipe, used, polys) in enumerate(
            recognise_quartics(equations, self.knowledge, self.table.groups, rho)
        ):
            yield self._score(recipe, y, used, place), y, used, recipe, polys

    def best(self) -> Move | None:
        """The next step: the first tier that has one, its best candidate that the witness confirms."""
        sigma = Sym("sigma", str(1 + sum(m.sigma is not None for m in self.moves)), 0)
        name = Sym(self.letter, str(1 + len(self.moves)), 4)
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
        i, j = self.splits.outer
        joint, outermost = single_joint(angle), self.splits.outer == (0, self.n)
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
