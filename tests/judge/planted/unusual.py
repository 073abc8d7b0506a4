"""Right formulas in unusual forms: expanded, half angles, cosine laws, atan with sign, product to sum."""

from __future__ import annotations

import ast
import copy
import re
from collections.abc import Iterator

from .slips import places

_TRIG = re.compile(r"([cs])(\d+)$")


def _p(text: str, **parts: ast.expr) -> ast.expr:
    """A pattern with parts put in for its names."""

    class Put(ast.NodeTransformer):
        def visit_Name(self, node: ast.Name) -> ast.expr:
            return copy.deepcopy(parts[node.id]) if node.id in parts else node

    return Put().visit(ast.parse(text, mode="eval").body)


def rewritings(tree: ast.expr) -> Iterator[tuple[str, ast.expr]]:
    """Every rewriting of one place that leaves the formula's value alone.

    Args:
        tree: A right formula.
    """
    for index, node in enumerate(places(tree)):
        for kind, new in _at(node):
            yield kind, _put(tree, index, new)


def _put(tree: ast.expr, index: int, new: ast.expr) -> ast.expr:
    if index == 0:
        return new
    out = copy.deepcopy(tree)
    old = places(out)[index]

    class Put(ast.NodeTransformer):
        def visit(self, node: ast.AST) -> ast.AST:
            return new if node is old else self.generic_visit(node)

    Put().visit(out)
    return out


def _at(node: ast.expr) -> Iterator[tuple[str, ast.expr]]:
    match node:
        case ast.Name(name) if match := _TRIG.match(name):
            letter, joints = match.groups()
            angle = " + ".join(f"theta{j}" for j in joints)
            half = f"tan(({angle})/2)"
            if letter == "c":
                yield "half angle", _p(f"(1 - {half}**2)/(1 + {half}**2)")
                yield "double angle", _p(f"2*cos(({angle})/2)**2 - 1")
                yield "phase", _p(f"sin({angle} + pi/2)")
            else:
                yield "half angle", _p(f"2*{half}/(1 + {half}**2)")
                yield "double angle", _p(f"2*sin(({angle})/2)*cos(({angle})/2)")
                yield "phase", _p(f"-cos({angle} + pi/2)")
            if len(joints) > 1:
                a, b = joints[:-1], joints[-1]
                yield "expanded", _p(f"c{a}*c{b} - s{a}*s{b}" if letter == "c" else f"s{a}*c{b} + c{a}*s{b}")
        case ast.BinOp(ast.Name(a), ast.Mult(), ast.Name(b)) if (m := _TRIG.match(a)) and (k := _TRIG.match(b)):
            i, j = (" + ".join(f"theta{x}" for x in y.group(2)) for y in (m, k))
            plus, minus = f"({i}) + ({j})", f"({i}) - ({j})"
            sums = {
                "cc": f"(cos({minus}) + cos({plus}))/2",
                "ss": f"(cos({minus}) - cos({plus}))/2",
                "sc": f"(sin({plus}) + sin({minus}))/2",
                "cs": f"(sin({plus}) - sin({minus}))/2",
            }
            yield "product to sum", _p(sums[m.group(1) + k.group(1)])
        case ast.BinOp(left, ast.Mult(), ast.BinOp(a, ast.Add(), b)):
            yield "distributed", _p("L*A + L*B", L=left, A=a, B=b)
        case ast.BinOp(left, ast.Mult(), ast.BinOp(a, ast.Sub(), b)):
            yield "distributed", _p("L*A - L*B", L=left, A=a, B=b)
        case ast.BinOp(ast.BinOp(a, ast.Add(), b), ast.Pow(), ast.Constant(2)):
            yield "square written out", _p("A**2 + 2*A*B + B**2", A=a, B=b)
        case ast.BinOp(ast.BinOp(a, ast.Sub(), b), ast.Pow(), ast.Constant(2)):
            yield "square written out", _p("A**2 - 2*A*B + B**2", A=a, B=b)
        case ast.BinOp(a, ast.Add(), b):
            yield "order", _p("B + A", A=a, B=b)
        case ast.Call(ast.Name("acos"), [x]):
            yield "cosine law the other way", _p("pi - acos(-(X))", X=x)
            yield "sine", _p("pi/2 - asin(X)", X=x)
            yield "half angle", _p("2*atan(sqrt((1 - X)/(1 + X)))", X=x)
            yield "atan2 of a root", _p("atan2(sqrt(1 - X**2), X)", X=x)
        case ast.Call(ast.Name("atan2"), [y, x]):
            yield "half angle", _p("2*atan2(Y, sqrt(X**2 + Y**2) + X)", X=x, Y=y)
            yield "atan with sign", _p("atan(Y/X) + pi/2*(1 - sign(X))", X=x, Y=y)
            yield "turned", _p("pi/2 - atan2(X, Y)", X=x, Y=y)
            yield "complement", _p("-atan2(-(Y), X)", X=x, Y=y)
        case ast.Call(ast.Name("sqrt"), [x]):
            yield "power", _p("(X)**(1/2)", X=x)
        case _:
            return
