"""Random postures at which every step of an elimination is tried before it is taken."""

from __future__ import annotations

from typing import Any

import numpy as np

from pieper.algebra.arithmetics import NumpyField
from pieper.algebra.expression import Sym, angle_symbol
from pieper.equations.derivation.patterns import Solved
from pieper.equations.derivation.unknowns import Knowledge
from pieper.kinematics.arrays import Array
from pieper.tolerances import DERIVED_SAME, NO_DIRECTION

RANDOM = 3  # postures


class _Values(dict):
    """Numbers for symbols; those of named entries are worked out when first asked for."""

    def __init__(self, witness: Witness, values: dict) -> None:
        super().__init__(values)
        self.witness = witness

    def __missing__(self, symbol: Any) -> Any:
        self[symbol] = value = self.witness.eliminator.target.definitions[symbol].evaluate(self)
        return value


class Witness:
    """Random postures at which every step is tried before it is taken.

    An equation that follows from the steps before has coefficients that vanish wherever those hold; only numbers tell
    it from a useful one, and they also guard every formula against a wrong sign.
    """

    def __init__(self, eliminator: Any, postures: Array | None = None) -> None:
        """Take random postures, or those given, (count, n)."""
        self.eliminator = eliminator
        table = eliminator.table
        q = np.random.default_rng(5).uniform(-2.5, 2.5, (table.n, RANDOM)) if postures is None else postures.T
        self.given = eliminator.target.given
        self.count, self.joints = q.shape[1], table.values(q, NumpyField)
        self.values = _Values(self, self.joints)
        self.values.update(self._pose(self.joints))

    def _pose(self, values: dict) -> dict[Sym, Array]:
        """The entries of the pose (count,) by their symbols, of values of all lengths and joints."""
        links = self.eliminator.splits.product(0, self.eliminator.n)
        pose = [[p.evaluate(values) + np.zeros(self.count) for p in row] for row in links]
        return {Sym(c, axis, 4): pose[r][k] for k, c in enumerate("noap") for r, axis in enumerate("xyz")}

    def stays_beside(self, knowledge: Knowledge) -> bool:
        """Whether what is given of the pose stays while the joints move as the known joints and sums allow."""
        n, table = self.eliminator.n, self.eliminator.table
        known = [((j, 1),) for j in knowledge.joints] + list(knowledge.sums)
        rows = np.zeros((len(known), n))
        for row, angle in zip(rows, known, strict=True):
            for j, k in angle:
                row[j - 1] = k
        for way in np.linalg.svd(rows)[2][np.linalg.matrix_rank(rows) :]:
            moved = {v: self.joints[v] + by for j, by in enumerate(way, 1) for v in [table.variable(j)]}
            gaps = [v - self.values[s] for s, v in self._pose(self.joints | moved).items() if s.base in self.given]
            if np.abs(gaps).max() >= DERIVED_SAME:
                return False
        return True

    def confirms(self, angle: tuple, solved: Solved, sigma: Sym) -> bool:
        """Whether one branch of the formula gives the true value at every posture, and no posture is degenerate."""
        e = self.eliminator
        truth = (
            e.symbol(angle).evaluate(self.values, NumpyField)
            if single_joint(angle)
            else sum(k * self.values[angle_symbol(j)] for j, k in angle)
        )
        hits = []
        choices = branch_values(solved.branches)
        for sign in choices:
            values = _Values(self, self.values)
            values[sigma] = np.full_like(truth, sign)
            for symbol, expression in solved.definitions:
                values[symbol] = expression.evaluate(values, NumpyField)
            if solved.degenerate:
                size = max(float(np.max(np.abs(x.evaluate(values, NumpyField)))) for x in solved.degenerate)
                if not size > NO_DIRECTION:
                    return False
            result = solved.formula.evaluate(values, NumpyField)
            gap = result - truth
            if e.symbol(angle) not in e.knowledge.prismatic.values():
                gap = np.angle(np.exp(1j * gap))
            hits.append(np.abs(gap) < DERIVED_SAME)
        if not np.all(np.any(hits, axis=0)):
            return False
        if solved.branches > 1:
            self.values[sigma] = np.select(hits, choices)
        if not single_joint(angle):
            self.values[e.symbol(angle)] = truth
        for symbol, expression in solved.definitions:
            self.values[symbol] = expression.evaluate(self.values, NumpyField)
        return True


def branch_values(branches: int) -> tuple[float, ...]:
    """The values a branch symbol takes: one, two signs, or the numbers of four roots."""
    return {1: (1.0,), 2: (1.0, -1.0), 4: (1.0, 2.0, 3.0, 4.0)}[branches]


def single_joint(angle: tuple) -> int | None:
    """The joint whose angle this is, None for a sum or a multiple."""
    return angle[0][0] if len(angle) == 1 and angle[0][1] == 1 else None
