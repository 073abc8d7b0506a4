"""One slip at one place of a formula: what a hand or a typesetter gets wrong."""

from __future__ import annotations

import ast
import copy
import re
from collections.abc import Iterator

_TRIG = re.compile(r"([cs])(\d+)$")
_LENGTH = re.compile(r"([a-zA-Z])(\d)$")
_ENTRY = re.compile(r"r(\d)(\d)$")

Slip = tuple[str, ast.expr]


def places(tree: ast.expr) -> list[ast.expr]:
    """Every subexpression, in a stable order."""
    return [node for node in ast.walk(tree) if isinstance(node, ast.expr)]


def _swap(tree: ast.expr, index: int, new: ast.expr) -> ast.expr:
    """The tree with the subexpression of one number replaced."""
    out = copy.deepcopy(tree)
    old = places(out)[index]
    if index == 0:
        return new

    class Put(ast.NodeTransformer):
        def visit(self, node: ast.AST) -> ast.AST:
            return new if node is old else self.generic_visit(node)

    Put().visit(out)
    return out


def _sum(node: ast.expr) -> bool:
    """A sum before its last term: dropping it would lose several terms at once."""
    return isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Sub)


def _call(name: str, *args: ast.expr) -> ast.expr:
    return ast.Call(ast.Name(name, ast.Load()), list(args), [])


def _minus(node: ast.expr) -> ast.expr:
    return ast.UnaryOp(ast.USub(), node)


def planted(tree: ast.expr, lengths: tuple[str, ...], n: int) -> Iterator[Slip]:
    """Every formula that is one slip away, with the slip's kind.

    Args:
        tree: A right formula.
        lengths: Names of the arm's lengths, of which one may be written for another.
        n: How many joints the arm has.
    """
    for index, node in enumerate(places(tree)):
        for kind, new in _at(node, lengths, n):
            yield kind, _swap(tree, index, new)


def _at(node: ast.expr, lengths: tuple[str, ...], n: int) -> Iterator[Slip]:
    match node:
        case ast.BinOp(left, ast.Add(), right):
            yield "sign", ast.BinOp(left, ast.Sub(), right)
            yield "lost term", left
            if not _sum(left):
                yield "lost term", right
        case ast.BinOp(left, ast.Sub(), right):
            yield "sign", ast.BinOp(left, ast.Add(), right)
            yield "lost term", left
            if not _sum(left):
                yield "lost term", _minus(right)
        case ast.BinOp(left, ast.Mult(), right):
            if isinstance(left, ast.Constant):
                yield "lost factor", right
            else:
                yield "lost factor", left
                yield "lost factor", right
        case ast.BinOp(left, ast.Div(), right):
            yield "upside down", ast.BinOp(right, ast.Div(), left)
        case ast.BinOp(left, ast.Pow(), _):
            yield "lost power", left
            yield "power as factor", ast.BinOp(ast.Constant(2), ast.Mult(), left)
        case ast.UnaryOp(_, operand):
            yield "sign", operand
        case ast.Call(ast.Name("pm"), [inner]):
            yield "lost branch", inner
            yield "lost branch", _minus(inner)
        case ast.Call(ast.Name("atan2"), [y, x]):
            yield "arguments swapped", _call("atan2", x, y)
            yield "atan for atan2", _call("atan", ast.BinOp(y, ast.Div(), x))
            yield "sign", _call("atan2", _minus(y), x)
            yield "sign", _call("atan2", y, _minus(x))
        case ast.Call(ast.Name("acos"), args):
            yield "asin for acos", _call("asin", *args)
        case ast.Call(ast.Name("sqrt"), [inner]):
            yield "lost root", inner
        case ast.Name(name):
            yield from ((kind, ast.Name(text, ast.Load())) for kind, text in _name(name, lengths, n))
        case _:
            return


def _name(name: str, lengths: tuple[str, ...], n: int) -> Iterator[tuple[str, str]]:
    if match := _TRIG.match(name):
        letter, joints = match.groups()
        yield "sine for cosine", ("s" if letter == "c" else "c") + joints
        if len(joints) == 1:
            yield from (("index", f"{letter}{k}") for k in (int(joints) - 1, int(joints) + 1) if 1 <= k <= n)
        else:
            yield "index", letter + joints[:-1]
            yield "index", letter + joints[1:]
    elif name in lengths:
        yield from (("length", other) for other in lengths if other != name)
    elif match := _ENTRY.match(name):
        i, j = match.groups()
        if i != j:
            yield "transposed", f"r{j}{i}"
        yield from (("entry", f"r{i}{k}") for k in "123" if k != j)
    elif name in ("px", "py", "pz"):
        yield from (("axis", "p" + other) for other in "xyz" if other != name[1])
    elif (match := _LENGTH.match(name)) and match.group(1) == "b":
        yield from (("slide's index", f"b{k}") for k in range(1, n + 1) if k != int(match.group(2)))
