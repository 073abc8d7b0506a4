"""Formulas that somebody typed: what they hold besides, and how they are looked through and changed at one place."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from pieper.algebra.expression import Add, Call, Expr, Num, Operation, Sym, natural

ANGLE = re.compile(r"theta(\d+)$")


class Mention(Sym):
    """A symbol at one place of a formula that somebody typed; its values are found by its name.

    It is not pooled: two mentions of a2 are two nodes, so that one of them can be looked at and replaced.
    """

    __slots__ = ()

    def __new__(cls, name: str) -> Mention:
        """Return a new mention of the name."""
        found = object.__new__(cls)
        found.name = name
        found.base = name.rstrip("0123456789") or name
        found.sub, found.rank = name[len(found.base) :], 1
        found.order = (1, found.base, natural(found.sub))
        return found

    def __reduce__(self) -> tuple[Any, ...]:
        return Mention, (self.name,)

    def _looked_up(self, values: Mapping[Any, Any], field: Any) -> Any:
        return values[self.name]

    def substitute(self, table: Mapping[Any, Any]) -> Any:
        """What the table has for this name."""
        return table.get(self.name, self)


class Neg(Operation):
    """A minus sign as written; `-x` of a derived formula is a product with -1."""

    __slots__ = ()
    op = "minus"
    precedence = 1

    @classmethod
    def of(cls, x: Expr) -> Expr:
        """Minus x, without piling up signs."""
        return x.args[0] if isinstance(x, Neg) else Neg(x)

    def _rebuilt(self, args: Iterable[Any]) -> Any:
        return Neg.of(*args)

    def _combined(self, v: list[Any], field: Any, branch: int) -> Any:
        return -v[0]


class PlusMinus(Operation):
    """+- (or -+) before a term; all signs of one formula go together."""

    __slots__ = ("sign",)
    op = "plus-minus"
    precedence = 1

    def __init__(self, x: Expr, sign: int = 1) -> None:
        super().__init__(x)
        self.sign = sign

    def _rebuilt(self, args: Iterable[Any]) -> Any:
        return PlusMinus(next(iter(args)), self.sign)

    def _combined(self, v: list[Any], field: Any, branch: int) -> Any:
        return v[0] if branch * self.sign > 0 else -v[0]


class Equation(Operation):
    """left = right; its value is left minus right."""

    __slots__ = ()
    op = "equation"
    precedence = 0

    def _combined(self, v: list[Any], field: Any, branch: int) -> Any:
        return v[0] - v[1]


# -- building and reading ------------------------------------------------------------------------------------
def number(text: str | int) -> Num:
    """A number that keeps its digits as written."""
    return Num(text, str(text))


def is_call(node: Expr | None, *names: str) -> bool:
    """Whether the node is a call of one of some functions."""
    return isinstance(node, Call) and node.name in names


def angle_sum(parts: tuple[tuple[int, int], ...]) -> Expr:
    """Build the node of a signed sum of joint angles."""
    return Add.of(*(Mention(f"theta{j}") if s > 0 else Neg(Mention(f"theta{j}")) for s, j in parts))


def has_branch(root: Expr) -> bool:
    """Whether the formula holds a +-."""
    return any(isinstance(node, PlusMinus) for node in root.walk())


def on_branch(root: Expr, branch: int) -> Expr:
    """The formula with the upper sign of every +-, with the lower one where `branch` is -1."""
    args = [on_branch(a, branch) for a in root.args]
    if isinstance(root, PlusMinus):
        return args[0] if branch * root.sign > 0 else Neg.of(args[0])
    return root if all(x is y for x, y in zip(args, root.args, strict=True)) else root._rebuilt(args)


def unordered(node: Expr) -> str:
    """The formula as text that is the same whatever the order of terms and factors."""
    inner = [unordered(a) for a in node.args]
    if node.op in ("sum", "product"):
        inner.sort()
    head = node.name if isinstance(node, Call) else node.op + (str(node.sign) if isinstance(node, PlusMinus) else "")
    return f"{head}({','.join(inner)})" if inner else str(node)


# -- places --------------------------------------------------------------------------------------------------
def positions(root: Expr) -> Iterator[tuple[tuple[int, ...], Expr, Expr | None]]:
    """Yield (path, node, parent) for every node, top down; a path is the argument numbers from the root."""
    stack: list[tuple[tuple[int, ...], Expr, Expr | None]] = [((), root, None)]
    while stack:
        path, node, parent = stack.pop()
        yield path, node, parent
        stack.extend((path + (k,), child, node) for k, child in reversed(list(enumerate(node.args))))


def replaced(root: Expr, path: tuple[int, ...], new: Expr) -> Expr:
    """Return the formula with the node at `path` replaced; everything else is shared."""
    if not path:
        return new
    args = list(root.args)
    args[path[0]] = replaced(args[path[0]], path[1:], new)
    return root._rebuilt(args)


def with_args(node: Expr, args: Iterable[Expr]) -> Expr:
    """The same operation on other arguments."""
    return node._rebuilt(args)


def replaced_everywhere(root: Expr, new: Mapping[int, Expr]) -> Expr:
    """Return the formula with every occurrence of some nodes, named by their `id`, replaced."""
    if id(root) in new:
        return new[id(root)]
    args = [replaced_everywhere(a, new) for a in root.args]
    return root if all(x is y for x, y in zip(args, root.args, strict=True)) else root._rebuilt(args)
