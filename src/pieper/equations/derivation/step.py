"""One numbered step of a derivation, as data."""

from __future__ import annotations

from dataclasses import dataclass

from pieper.algebra.expression import Expr, Sym
from pieper.equations.derivation.elimination import Source


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
