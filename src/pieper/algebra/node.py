"""A node of a formula: its value in any arithmetic, its parts, and how it is written."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from pieper.algebra import notation
from pieper.algebra.arithmetics import NumpyField, SympyField


class Node:
    """What every node of an expression tree can do; `expression` has the kinds of nodes."""

    __slots__ = ()
    op = ""  # what the node is, for those who write it
    precedence = 9  # printing: 0 equation, 1 sum, 2 product, 3 quotient, 4 power, 9 atom
    args: tuple[Any, ...] = ()

    # -- value -----------------------------------------------------------------------------------------------
    def evaluate(
        self, values: Mapping, field: Any = NumpyField, branch: int = 1, cache: dict | None = None, learn: bool = True
    ) -> Any:
        """Evaluate the formula.

        Args:
            values: Number of every symbol, arrays of any common shape or numbers of the arithmetic.
            field: What the operations mean, see `arithmetics`.
            branch: +1 takes the upper sign of every +-, -1 the lower one.
            cache: Values of nodes already known. Formulas that share nodes share their work through it.
            learn: Add new nodes to the cache.
        """
        if cache is not None:
            found = cache.get(self)
            if found is not None:
                return found
        if self.args:
            found = self._combined([a.evaluate(values, field, branch, cache, learn) for a in self.args], field, branch)
        else:
            found = self._looked_up(values, field)
        if cache is not None and learn:
            cache[self] = found
        return found

    def _combined(self, v: list, field: Any, branch: int) -> Any:
        """Value of the node from those of its arguments."""
        raise TypeError(f"a {type(self).__name__} has no arguments")

    def _looked_up(self, values: Mapping, field: Any) -> Any:
        """Value of a node without arguments."""
        raise TypeError(f"a {type(self).__name__} is no atom")

    # -- structure -------------------------------------------------------------------------------------------
    def _rebuilt(self, args: Iterable[Any]) -> Any:
        """The same operation on other arguments; sums and products inside one another are joined."""
        return self

    def substitute(self, table: Mapping) -> Any:
        """Replace symbols by expressions (the keys are pooled symbols, or the names of mentions)."""
        args = [a.substitute(table) for a in self.args]
        return self if all(x is y for x, y in zip(args, self.args, strict=True)) else self._rebuilt(args)

    def walk(self) -> Iterator[Any]:
        """Every node, arguments before what holds them, without recursion."""
        stack: list[Any] = [self]
        order: list[Any] = []
        while stack:
            node = stack.pop()
            order.append(node)
            stack.extend(node.args)
        return reversed(order)

    def size(self) -> int:
        """Number of nodes."""
        return sum(1 for _ in self.walk())

    # -- writing ---------------------------------------------------------------------------------------------
    def text(self) -> str:
        """One line of plain text, products with a star."""
        return notation.text(self)

    def latex(self) -> str:
        """LaTeX for math mode."""
        return notation.latex(self)

    def mathml(self) -> str:
        """Presentation MathML without the outer element."""
        return notation.mathml(self)

    def sympy(self) -> Any:
        """The same formula for sympy: theta1 as a symbol, c23 as cos(theta2 + theta3), exact rationals."""
        return self.evaluate(SympyField.symbols, SympyField())

    def __repr__(self) -> str:
        return self.text()

    def __str__(self) -> str:
        return notation.typed(self)
