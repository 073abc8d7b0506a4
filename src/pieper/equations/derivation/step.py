"""One numbered step of a derivation, as data."""

from __future__ import annotations

from dataclasses import dataclass

from pieper.algebra.arithmetics import NumpyField
from pieper.algebra.expression import Expr, Num, Sym
from pieper.algebra.harmonic import Poly
from pieper.equations.derivation.elimination import Eliminator, Move
from pieper.equations.derivation.splits import Equation, Source
from pieper.tolerances import ROUNDING


@dataclass(frozen=True)
class Step:
    """One numbered step.

    Attributes:
        number: 1, 2, ...
        symbol: What it solves for (theta1, d3, or a sum such as theta234).
        angle: The joints of it, ((joint, factor), ...).
        sources: The matrix equations used, each with its entries.
        names: Shorthands introduced here, (symbol, formula).
        equations: The scalar equations used, (left, right).
        formula: The formula for `symbol`.
        sigma: The branch sign in it, or None.
        kind: The pattern, see `patterns`.
        degenerate: Expressions that all vanish where `symbol` is free; empty when that cannot happen.
        merge: Vanishes where the two branches become one; None for one branch.
    """

    number: int
    symbol: Sym
    angle: tuple[tuple[int, int], ...]
    sources: tuple[Source, ...]
    names: tuple[tuple[Sym, Expr], ...]
    equations: tuple[tuple[Expr, Expr], ...]
    formula: Expr
    sigma: Sym | None
    kind: str
    degenerate: tuple[Expr, ...]
    merge: Expr | None

    @property
    def branches(self) -> int:
        """How many solutions the step has."""
        return 1 if self.sigma is None else 4 if self.kind == "quartic" else 2


def steps_of(eliminator: Eliminator, table: dict) -> tuple[Step, ...]:
    """The moves of an elimination as steps; `table` has its names -> those of the page."""
    return tuple(step_of(eliminator, table, number, move) for number, move in enumerate(eliminator.moves, 1))


def step_of(eliminator: Eliminator, table: dict, number: int, move: Move) -> Step:
    """One move as a step, see `steps_of`."""
    constants = eliminator.table.constants(NumpyField)

    def tidy(expr: Expr) -> Expr:
        return expr.substitute(table)

    names = [(table[s], tidy(eliminator.target.definitions[s].expr())) for s in move.names]
    names += [(s, tidy(x)) for s, x in move.solved.definitions]
    return Step(
        number,
        move.symbol,
        move.angle,
        tuple(e.source for e in move.equations),
        tuple(names),
        tuple((tidy(left.expr()), tidy(right.expr())) for e in move.equations for left, right in [_turned(e)]),
        tidy(move.solved.formula),
        move.sigma,
        move.solved.kind,
        _vanishing([tidy(x) for x in move.solved.degenerate], constants),
        tidy(move.solved.merge) if move.solved.merge is not None else None,
    )


def _turned(equation: Equation) -> tuple[Poly, Poly]:
    """Both sides, their signs turned where each is one term with a minus: s2 = a_z, not -s2 = -a_z."""
    sides = equation.left, equation.right
    if all(len(p.terms) == 1 and next(iter(p.terms.values())) < 0 for p in sides):
        return -sides[0], -sides[1]
    return sides


def _vanishing(conditions: list[Expr], constants: dict) -> tuple[Expr, ...]:
    """The conditions, or nothing when one of them is a length that does not vanish."""
    for condition in conditions:
        if condition.atoms() <= set(constants) and abs(condition.evaluate(constants, NumpyField)) > ROUNDING:
            return ()
    return tuple(c for c in conditions if not (isinstance(c, Num) and c.value == 0))
