"""The geometric Jacobian as equations: columns in the base frame at the tool point, or in any frame at any origin."""

from __future__ import annotations

import functools
import itertools
from collections.abc import Callable
from typing import Any

import numpy as np

from pieper.algebra.arithmetics import NumpyField, SympyField
from pieper.algebra.exact import rational
from pieper.algebra.expression import Num
from pieper.algebra.harmonic import Poly, matmul
from pieper.document import text
from pieper.document.blocks import Document, Equation
from pieper.document.formulas import matrix, named
from pieper.document.readable import Readable
from pieper.equations.forward import Check, ForwardEquations
from pieper.equations.table import inverse
from pieper.kinematics.arrays import Array


class JacobianEquations(Readable):
    """The 6 x n geometric Jacobian by the joint coordinates q, linear rows first, tool point, base frame.

    Args:
        forward: The forward equations it is derived from.
        jacobian: The numeric Jacobian q (..., n) -> (..., 6, n) against which `check` measures.
    """

    def __init__(
        self, forward: ForwardEquations, *, jacobian: Callable[[np.ndarray], np.ndarray] | None = None
    ) -> None:
        self.forward, self._jacobian = forward, jacobian
        self._frames: dict[tuple[int, int], list[list[Poly]]] = {}

    @property
    def n(self) -> int:
        """Number of axes."""
        return self.forward.n

    @functools.cached_property
    def polynomials(self) -> list[list[Poly]]:
        """6 x n polynomials."""
        f, table = self.forward, self.forward.table
        total = matmul(matmul(table.base, f.product(0, self.n)), table.tool)
        modified = f.description.convention == "modified"
        columns = []
        for joint in range(1, self.n + 1):
            symbol = table.variable(joint)
            sense = int(round(float(f.description.sign[joint - 1]))) if symbol.base != "q" else 1
            if joint in table.prismatic:
                linear = [total[r][3].coefficient(symbol) * sense for r in range(3)]
                columns.append([*linear, Poly(), Poly(), Poly()])
                continue
            linear = [total[r][3].derivative(joint, table.letter) * sense for r in range(3)]
            frame = joint if modified else joint - 1
            before = table.base if frame == 0 else matmul(table.base, f.product(0, frame))
            turn = int(round(float(f.description.sign[joint - 1])))
            columns.append([*linear, *(before[r][2] * turn for r in range(3))])
        if f.description.coupling is not None:
            columns = [_together(columns, by) for by in f.description.coupling.T]
        return [list(row) for row in zip(*columns, strict=True)]

    @functools.cached_property
    def entries(self) -> list[list]:
        """6 x n formulas."""
        return [[p.expr() for p in row] for row in self.polynomials]

    def column(self, joint: int, frame: int, point: int) -> tuple[list[Poly], list[Poly]]:
        """Linear and angular part of a joint's column (by theta or d) in frame `frame`, at the origin of `point`.

        Frames 0 to n are those of the table, n + 1 is the tool.
        """
        f = self.forward
        own = joint if f.description.convention == "modified" else joint - 1
        rotation = self._between(frame, own)
        axis = [rotation[r][2] for r in range(3)]
        if joint in f.table.prismatic:
            return axis, [Poly(), Poly(), Poly()]
        arm = [self._between(own, point)[r][3] for r in range(3)]
        local = [-arm[1], arm[0]]
        return [rotation[r][0] * local[0] + rotation[r][1] * local[1] for r in range(3)], axis

    def _between(self, first: int, last: int) -> list[list[Poly]]:
        if (first, last) not in self._frames:
            self._frames[first, last] = self._worked_out(first, last)
        return self._frames[first, last]

    def _worked_out(self, first: int, last: int) -> list[list[Poly]]:
        if first == last:
            return [[Poly.number(int(r == c)) for c in range(4)] for r in range(4)]
        if last == self.n + 1:
            tool = self.forward.table.tool
            return tool if first == self.n else matmul(self._between(first, self.n), tool)
        if first < last:
            return self.forward.product(first, last)
        return inverse(self._between(last, first))

    # -- output ----------------------------------------------------------------------------------------------
    @functools.cached_property
    def page(self) -> Document:
        """The matrix."""
        return Document(self._title, blocks=[Equation((named("J"), matrix(self.entries)))])

    @property
    def _title(self) -> str:
        return f"Jacobian of {self.forward.description.name}: tool point, base frame, linear rows first"

    def text(self) -> str:
        """One line an entry, column by column, zeros left out."""
        page = Document(self._title)
        for c, r in itertools.product(range(self.forward.table.joints), range(6)):
            if self.entries[r][c] != Num(0):
                page.show(named("J", f"{r + 1}{c + 1}"), self.entries[r][c])
        return text.fragment(page)

    def sympy(self) -> Any:
        """A sympy Matrix (6, n)."""
        import sympy

        field, symbols = SympyField(), SympyField.symbols
        return sympy.Matrix([[e.evaluate(symbols, field) for e in row] for row in self.entries])

    def evaluate(self, q: Array) -> np.ndarray:
        """The Jacobians (..., 6, n) of joint vectors q (..., n) by these equations."""
        q = np.asarray(q, float)
        values = self.forward.table.values(np.moveaxis(q, -1, 0), NumpyField)
        shape = q.shape[:-1]
        rows = [[np.broadcast_to(e.evaluate(values, NumpyField), shape) for e in row] for row in self.entries]
        return np.moveaxis(np.array(rows), (0, 1), (-2, -1))

    def check(self, n: int = 200, *, rng: np.random.Generator | None = None) -> Check:
        """Compare with the numeric Jacobian at `n` random joint vectors."""
        joints = self.forward.table.joints
        return Check.of(self.evaluate, self._jacobian, joints, n, rng, ("jacobian", f"{6 * joints}", "Jacobian"))


def _together(columns: list[list[Poly]], by: Array) -> list[Poly]:
    """The column of a joint that moves axes by these numbers (n,)."""
    parts = [[p * rational(float(c)) for p in column] for column, c in zip(columns, by, strict=True) if c]
    return [sum(row, Poly()) for row in zip(*parts, strict=True)]
