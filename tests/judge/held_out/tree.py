"""Formulas as nested tuples: read from plain text, written back, evaluated in mpmath or with opaque functions.

Nodes: ("n", text), ("v", name), ("+", parts), ("*", parts), ("/", a, b), ("^", a, k), ("-", a), ("pm", a),
("f", name, args), ("eq", left, right) with the value left minus right.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from typing import Any

import mpmath as mp

Tree = Any  # nested tuples, as said above
_TOKEN = re.compile(r"\s*(\d+\.?\d*|\+-|[A-Za-z_]\w*|[-+*/^(),])")
FUNCTIONS = ("sqrt", "atan2", "acos", "asin", "atan", "sin", "cos", "sign")


def read(text: str) -> Tree:
    """Read a formula with explicit products or products side by side."""
    if "=" in text:
        left, right = text.split("=")
        return ("eq", read(left), read(right))
    tokens, at = [], 0
    while at < len(text.rstrip()):
        match = _TOKEN.match(text, at)
        if match is None:
            raise ValueError(f"cannot read {text[at:]!r}")
        tokens.append(match.group(1))
        at = match.end()
    parts = [*tokens, ""]
    tree, end = _sum(parts, 0)
    if parts[end]:
        raise ValueError(f"left over {parts[end:]} of {text!r}")
    return tree


def _sum(t: list[str], i: int) -> tuple[Tree, int]:
    parts: list[Tree] = []
    sign = "+"
    if t[i] in ("-", "+", "+-"):
        sign, i = t[i], i + 1
    while True:
        node, i = _product(t, i)
        parts.append(node if sign == "+" else ("-" if sign == "-" else "pm", node))
        if t[i] not in ("+", "-", "+-"):
            return (parts[0] if len(parts) == 1 else ("+", tuple(parts))), i
        sign, i = t[i], i + 1


def _product(t: list[str], i: int) -> tuple[Tree, int]:
    node, i = _power(t, i)
    parts = [node]
    while True:
        if t[i] == "*":
            node, i = _power(t, i + 1)
            parts.append(node)
        elif t[i] == "/":
            below, i = _power(t, i + 1)
            parts = [("/", _times(parts), below)]
        elif t[i] and (t[i][0].isalnum() or t[i][0] in "(_"):
            node, i = _power(t, i)
            parts.append(node)
        else:
            return _times(parts), i


def _times(parts: list[Tree]) -> Tree:
    return parts[0] if len(parts) == 1 else ("*", tuple(parts))


def _power(t: list[str], i: int) -> tuple[Tree, int]:
    node, i = _atom(t, i)
    if t[i] == "^":
        return ("^", node, int(t[i + 1])), i + 2
    return node, i


def _atom(t: list[str], i: int) -> tuple[Tree, int]:
    token = t[i]
    if token == "(":
        node, i = _sum(t, i + 1)
        return node, i + 1
    if token in FUNCTIONS:
        args, i = [], i + 2
        while True:
            node, i = _sum(t, i)
            args.append(node)
            i += 1
            if t[i - 1] == ")":
                return ("f", token, tuple(args)), i
    return (("n", token) if token[0].isdigit() else ("v", token)), i + 1


def write(x: Tree, place: int = 0) -> str:
    """Write a tree; `place` is 0 in a sum, 1 in a product, 2 under a power or after a slash."""
    kind = x[0]
    if kind == "eq":
        return f"{write(x[1])} = {write(x[2])}"
    if kind in "nv":
        return str(x[1])
    if kind == "f":
        return f"{x[1]}({', '.join(write(a) for a in x[2])})"
    if kind == "^":
        return f"{write(x[1], 2)}^{x[2]}"
    if kind == "*":
        parts = [write(p, 2) for p in x[1]]
        text = parts[0]
        for part in parts[1:]:
            text += ("*" if text[-1].isdigit() and part[0].isdigit() else " ") + part
        return f"({text})" if place > 1 else text
    if kind == "/":
        text = f"{write(x[1], 1)}/{write(x[2], 2)}"
        return f"({text})" if place else text
    if kind in ("-", "pm"):
        text = ("-" if kind == "-" else "+-") + write(x[1], 1)
        return f"({text})" if place else text
    text = write(x[1][0])
    for part in x[1][1:]:
        sign = {"-": "-", "pm": "+-"}.get(part[0], "+")
        text += f" {sign} {write(part if sign == '+' else part[1], 1)}"
    return f"({text})" if place else text


def places(x: Tree, path: tuple[int, ...] = ()) -> Iterator[tuple[tuple[int, ...], Tree]]:
    """Every node of a tree with its path."""
    yield path, x
    for k, child in enumerate(_children(x)):
        yield from places(child, (*path, k))


def _children(x: Tree) -> tuple[Tree, ...]:
    return {"+": x[1], "*": x[1], "f": x[-1], "/": x[1:], "^": x[1:2], "-": x[1:], "pm": x[1:], "eq": x[1:]}.get(
        x[0], ()
    )


def put(x: Tree, path: tuple[int, ...], new: Tree) -> Tree:
    """Return the tree with the node at `path` exchanged."""
    if not path:
        return new
    k, rest = path[0], path[1:]
    inner = tuple(put(c, rest, new) if j == k else c for j, c in enumerate(_children(x)))
    kind = x[0]
    if kind in "+*":
        return (kind, inner)
    if kind == "f":
        return (kind, x[1], inner)
    return (kind, *inner, x[2]) if kind == "^" else (kind, *inner)


def value(x: Tree, name: Callable[[str], Any], sign: int, call: Callable[[str, list[Any]], Any]) -> Any:
    """Evaluate: `name` gives a symbol's value, `call` a function's, `sign` stands for every plus-minus."""
    kind = x[0]
    if kind == "n":
        return mp.mpf(x[1])
    if kind == "v":
        return name(x[1])
    if kind == "f":
        return call(x[1], [value(a, name, sign, call) for a in x[2]])
    if kind == "+":
        return mp.fsum(value(p, name, sign, call) for p in x[1])
    if kind == "*":
        return mp.fprod(value(p, name, sign, call) for p in x[1])
    if kind == "/":
        return value(x[1], name, sign, call) / value(x[2], name, sign, call)
    if kind == "^":
        return value(x[1], name, sign, call) ** x[2]
    if kind == "eq":
        return value(x[1], name, sign, call) - value(x[2], name, sign, call)
    return (sign if kind == "pm" else -1) * value(x[1], name, sign, call)


def real(name: str, args: list[Any]) -> Any:
    """Evaluate a function on real numbers; NaN outside its domain."""
    if any(mp.isnan(a) for a in args):
        return mp.nan
    if name in ("acos", "asin") and abs(args[0]) > 1:
        return mp.nan
    if name == "sqrt" and args[0] < 0:
        return mp.nan
    return getattr(mp, name)(*args)


def opaque(name: str, args: list[Any]) -> Any:
    """Evaluate a function as something that nothing is known of: equal only where it is written alike."""
    total = mp.mpf(sum(ord(c) for c in name))
    for k, a in enumerate(args):
        total += mp.exp(mp.sin((k + 2) * a + total)) * (k + mp.mpf("1.37"))
    return total


def written_alike(a: Tree, b: Tree) -> bool:
    """Say whether two formulas are the same but for the order of sums and products: every letter is free."""
    for seed in range(3):

        def free(name: str, seed: int = seed) -> Any:
            if name == "pi":
                return mp.pi
            code = mp.mpf(sum((k + 3) * (k + 5) * ord(c) for k, c in enumerate(name)))
            return mp.mpf("1.1") + mp.sin(code * (seed + 1) + seed) ** 2

        for sign in (1, -1):
            x, y = value(a, free, sign, opaque), value(b, free, sign, opaque)
            if abs(x - y) > 1e-18 * (1 + abs(x)):
                return False
    return True
