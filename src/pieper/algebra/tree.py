"""Expressions as small immutable trees: how a formula is held, printed back and evaluated.

A tree is evaluated by an *arithmetic* (NumPy arrays, mpmath numbers or sympy symbols); nothing is ever handed to
Python's own evaluator.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

import numpy as np

FUNCTIONS = {
    "sin": 1,
    "cos": 1,
    "tan": 1,
    "asin": 1,
    "acos": 1,
    "atan": 1,
    "atan2": 2,
    "sqrt": 1,
    "sign": 1,
    "abs": 1,
    "hypot": 2,
}
ANGLE = re.compile(r"theta(\d+)$")


@dataclass(frozen=True, eq=False)
class Node:
    """One node of an expression.

    Attributes:
        op: ``num sym neg add mul div pow pm call``, and ``eq`` at the top of an equation (its value is left minus
        right).
        args: the children.
        value: the number as written, the symbol's or function's name, or +1/-1 for the upper sign of a +- (-+).
    """

    op: str
    args: tuple[Node, ...] = ()
    value: Any = None
    _text: list = field(default_factory=list, repr=False)

    def __str__(self) -> str:
        if not self._text:
            self._text.append(_print(self))
        return self._text[0]

    def walk(self) -> Iterator[Node]:
        """Yield every node, children before parents, without recursion."""
        stack, order = [self], []
        while stack:
            node = stack.pop()
            order.append(node)
            stack.extend(node.args)
        return reversed(order)

    def symbols(self) -> set[str]:
        """Return the names of all symbols in the tree."""
        return {n.value for n in self.walk() if n.op == "sym"}

    def has_branch(self) -> bool:
        """Say whether the tree contains a +-."""
        return any(n.op == "pm" for n in self.walk())

    def size(self) -> int:
        """Return the number of nodes."""
        return sum(1 for _ in self.walk())


def num(value) -> Node:
    """Make a number node; the value keeps the digits as written."""
    return Node("num", (), str(value))


def sym(name: str) -> Node:
    """Make a symbol node."""
    return Node("sym", (), name)


def call(name: str, *args: Node) -> Node:
    """Make a function call node."""
    return Node("call", tuple(args), name)


def negated(node: Node) -> Node:
    """Return minus the node, without piling up signs."""
    return node.args[0] if node.op == "neg" else Node("neg", (node,))


def add(*terms: Node) -> Node:
    """Make a sum, flattening sums inside it."""
    flat = [t for term in terms for t in (term.args if term.op == "add" else (term,))]
    return flat[0] if len(flat) == 1 else Node("add", tuple(flat))


def mul(*factors: Node) -> Node:
    """Make a product, flattening products inside it."""
    flat = [f for factor in factors for f in (factor.args if factor.op == "mul" else (factor,))]
    return flat[0] if len(flat) == 1 else Node("mul", tuple(flat))


def joint_sum(node: Node) -> tuple[tuple[int, int], ...] | None:
    """Read a node as a signed sum of joint angles: ((sign, joint), ...), or None when it is something else."""
    parts = []
    for term in node.args if node.op == "add" else (node,):
        sign = 1
        if term.op == "neg":
            sign, term = -1, term.args[0]
        found = ANGLE.match(term.value) if term.op == "sym" else None
        if not found:
            return None
        parts.append((sign, int(found.group(1))))
    return tuple(parts)


def angle_sum(parts: tuple[tuple[int, int], ...]) -> Node:
    """Build the node of a signed sum of joint angles."""
    return add(*[sym(f"theta{j}") if s > 0 else negated(sym(f"theta{j}")) for s, j in parts])


def _print(node: Node) -> str:
    op, args = node.op, node.args
    if op == "num":
        return node.value
    if op == "sym":
        return node.value
    if op == "eq":
        return f"{args[0]} = {args[1]}"
    if op == "neg":
        return "-" + _wrap(args[0], ("add", "neg", "pm"))
    if op == "pm":
        return ("+-" if node.value > 0 else "-+") + _wrap(args[0], ("add", "neg", "pm"))
    if op == "add":
        out = str(args[0])
        for term in args[1:]:
            if term.op == "neg":
                out += " - " + _wrap(term.args[0], ("add", "neg", "pm"))
            elif term.op == "pm":
                out += (" +- " if term.value > 0 else " -+ ") + _wrap(term.args[0], ("add", "neg", "pm"))
            else:
                out += " + " + str(term)
        return out
    if op == "mul":
        return " ".join(
            _wrap(f, ("add", "neg", "pm", "div") if i else ("add", "neg", "pm")) for i, f in enumerate(args)
        )
    if op == "div":
        return _wrap(args[0], ("add", "neg", "pm")) + "/" + _wrap(args[1], ("add", "neg", "pm", "mul", "div"))
    if op == "pow":
        return (
            _wrap(args[0], ("add", "neg", "pm", "mul", "div", "pow"))
            + "^"
            + _wrap(args[1], ("add", "neg", "pm", "mul", "div", "pow"))
        )
    if node.value in ("sin", "cos"):
        parts = joint_sum(args[0])
        if parts:
            letter = node.value[0]
            if all(s > 0 for s, _ in parts):
                return letter + "".join(str(j) for _, j in parts)
            if len(parts) > 1 and parts[0][0] > 0:
                inside = "".join(("+" if s > 0 else "-") + str(j) for s, j in parts)[1:]
                return f"{letter}({inside})"
    return f"{node.value}({', '.join(map(str, args))})"


def _wrap(node: Node, loose: tuple[str, ...]) -> str:
    return f"({node})" if node.op in loose else str(node)


class NumpyArithmetic:
    """Vectorised floating-point arithmetic; undefined operations give nan or inf, which the judge reports."""

    pi = np.pi

    @staticmethod
    def number(text: str):
        return float(Fraction(text)) if "/" in text else float(text)

    sin, cos, tan, atan, sqrt, sign, abs = np.sin, np.cos, np.tan, np.arctan, np.sqrt, np.sign, np.abs
    atan2, hypot = np.arctan2, np.hypot

    @staticmethod
    def asin(x):
        return np.arcsin(_settle(x))

    @staticmethod
    def acos(x):
        return np.arccos(_settle(x))

    @staticmethod
    def power(x, y):
        return np.power(np.asarray(x, dtype=float), y)


def _settle(x):
    """Bring a value that rounding pushed past +-1 back to it; a real overshoot stays and becomes nan."""
    x = np.asarray(x, dtype=float)
    return np.where((np.abs(x) > 1) & (np.abs(x) < 1 + 1e-12), np.sign(x), x)


class HighPrecisionArithmetic:
    """The same operations on mpmath numbers, at the working precision of the caller."""

    def __init__(self):
        import mpmath

        self.mp = mpmath.mp
        self.pi = +mpmath.mp.pi
        for name in ("sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sqrt", "sign", "hypot"):
            setattr(self, name, getattr(mpmath.mp, name))
        self.abs = abs

    def number(self, text: str):
        if "/" in text:
            top, bottom = text.split("/")
            return self.mp.mpf(top) / self.mp.mpf(bottom)
        return self.mp.mpf(text)

    def power(self, x, y):
        return x ** (int(y) if y == int(y) else y)


class SymbolicArithmetic:
    """The same operations on sympy expressions."""

    def __init__(self):
        import sympy

        self.sp = sympy
        self.pi = sympy.pi
        self.sin, self.cos, self.tan = sympy.sin, sympy.cos, sympy.tan
        self.asin, self.acos, self.atan, self.atan2 = sympy.asin, sympy.acos, sympy.atan, sympy.atan2
        self.sqrt, self.sign, self.abs = sympy.sqrt, sympy.sign, sympy.Abs
        self.hypot = lambda x, y: sympy.sqrt(x**2 + y**2)

    def number(self, text: str):
        return self.sp.Rational(text)

    def power(self, x, y):
        return x**y


NUMPY = NumpyArithmetic()


def evaluate(
    node: Node, env: dict[str, Any], arithmetic=NUMPY, branch: int = 1, cache: dict | None = None, learn: bool = True
):
    """Evaluate a tree.

    Args:
        node: the tree.
        env: value of every symbol, arrays of any common shape (or numbers of the arithmetic).
        arithmetic: what the operations mean.
        branch: +1 takes the upper sign of every +-, -1 the lower one.
        cache: values of subtrees already known, by identity. Trees that share subtrees (a formula and its variants)
        share
            their work through it.
        learn: add new subtrees to the cache.

    Returns:
        The value, of the shape of the symbols.
    """
    if cache is not None:
        hit = cache.get(node)
        if hit is not None:
            return hit
    op, args = node.op, node.args
    if op == "num":
        out = arithmetic.number(node.value)
    elif op == "sym":
        out = env[node.value]
    else:
        v = [evaluate(a, env, arithmetic, branch, cache, learn) for a in args]
        if op == "neg":
            out = -v[0]
        elif op == "add":
            out = v[0]
            for x in v[1:]:
                out = out + x
        elif op == "mul":
            out = v[0]
            for x in v[1:]:
                out = out * x
        elif op == "div":
            out = v[0] / v[1]
        elif op == "eq":
            out = v[0] - v[1]
        elif op == "pow":
            out = arithmetic.power(v[0], v[1])
        elif op == "pm":
            out = v[0] if branch * node.value > 0 else -v[0]
        else:
            out = getattr(arithmetic, node.value)(*v)
    if cache is not None and learn:
        cache[node] = out
    return out


def rebuilt(node: Node, args: tuple[Node, ...]) -> Node:
    """Return the node with other children, sums and products flattened."""
    if node.op == "add":
        return add(*args)
    if node.op == "mul":
        return mul(*args)
    if node.op == "neg":
        return negated(args[0])
    return Node(node.op, args, node.value)


def replaced(root: Node, path: tuple[int, ...], new: Node) -> Node:
    """Return the tree with the node at `path` (child numbers from the root) replaced; everything else is shared."""
    if not path:
        return new
    args = list(root.args)
    args[path[0]] = replaced(args[path[0]], path[1:], new)
    return rebuilt(root, tuple(args))


def replaced_everywhere(root: Node, new: dict[Node, Node]) -> Node:
    """Return the tree with every occurrence of some shared nodes replaced."""
    if root in new:
        return new[root]
    if not root.args:
        return root
    args = tuple([replaced_everywhere(a, new) for a in root.args])
    return root if all(x is y for x, y in zip(args, root.args, strict=True)) else rebuilt(root, args)


def positions(root: Node) -> Iterator[tuple[tuple[int, ...], Node, Node | None]]:
    """Yield (path, node, parent) for every node, top down."""
    stack: list[tuple[tuple[int, ...], Node, Node | None]] = [((), root, None)]
    while stack:
        path, node, parent = stack.pop()
        yield path, node, parent
        stack.extend((path + (k,), child, node) for k, child in reversed(list(enumerate(node.args))))


def substitute(node: Node, definitions: dict[str, Node]) -> Node:
    """Replace symbols by the trees that define them, all the way down."""
    if node.op == "sym":
        return substitute(definitions[node.value], definitions) if node.value in definitions else node
    if not node.args:
        return node
    args = tuple(substitute(a, definitions) for a in node.args)
    if all(x is y for x, y in zip(args, node.args, strict=True)):
        return node
    return rebuilt(node, args)
