"""Formulas as Python's syntax trees: evaluated by NumPy, printed as papers print them."""

from __future__ import annotations

import ast
import re

import numpy as np
import numpy.typing as npt

from .arms import PlantedArm

_SINGLE = re.compile(r"([cs])(\d+)$")


def names_at(arm: PlantedArm, q: npt.NDArray[np.float64], lengths: dict[str, float] | None = None) -> dict[str, float]:
    """What every name in a formula is worth at one posture.

    Args:
        arm: The arm.
        q: Joint values, shape (n,), rad or m.
        lengths: Other lengths than the arm's own, m.
    """
    named = arm.lengths if lengths is None else lengths
    T = arm.pose(q, named)
    out: dict[str, float] = dict(named)
    for i in range(3):
        out["p" + "xyz"[i]] = float(T[i, 3])
        for j in range(3):
            out[f"r{i + 1}{j + 1}"] = float(T[i, j])
    for i, value in enumerate(q, start=1):
        out[("theta" if arm.rows[i - 1].kind == "R" else "b") + str(i)] = float(value)
    out["pi"] = np.pi
    return out


def _trig(name: str, values: dict[str, float]) -> float:
    match = _SINGLE.match(name)
    if match is None:
        raise KeyError(name)
    angle = sum(values[f"theta{i}"] for i in match.group(2))
    return float(np.cos(angle) if match.group(1) == "c" else np.sin(angle))


def evaluate(node: ast.expr, values: dict[str, float], branch: float = 1.0) -> float:
    """A formula's number; NaN where it is not real.

    Args:
        node: The formula.
        values: What the names are worth.
        branch: +1 or -1, for the sign that `pm` chooses.
    """
    match node:
        case ast.BinOp(left, op, right):
            a, b = evaluate(left, values, branch), evaluate(right, values, branch)
            match op:
                case ast.Add():
                    return a + b
                case ast.Sub():
                    return a - b
                case ast.Mult():
                    return a * b
                case ast.Div():
                    return a / b if b != 0 else np.nan
                case _:
                    return float(np.power(a, b)) if a >= 0 or float(b).is_integer() else np.nan
        case ast.UnaryOp(_, operand):
            return -evaluate(operand, values, branch)
        case ast.Constant(value):
            return float(value)  # pyright: ignore[reportArgumentType]
        case ast.Name(name):
            return values[name] if name in values else _trig(name, values)
        case ast.Call(ast.Name(name), args):
            numbers = [evaluate(arg, values, branch) for arg in args]
            if name == "pm":
                return branch * numbers[0]
            function = {"acos": np.arccos, "asin": np.arcsin, "atan": np.arctan, "atan2": np.arctan2}.get(
                name
            ) or getattr(np, name)
            with np.errstate(invalid="ignore"):
                return float(function(*numbers))
        case _:
            raise ValueError(ast.dump(node))


_LEVEL = {ast.Add: 1, ast.Sub: 1, ast.Mult: 2, ast.Div: 2, ast.Pow: 4}


def paper(node: ast.expr) -> str:
    """A formula as a paper prints it."""
    return _paper(node)[0].replace(" + +-", " +- ").replace(" - +-", " -+ ")


def _paper(node: ast.expr) -> tuple[str, int]:
    match node:
        case ast.BinOp(left, op, right):
            level = _LEVEL[type(op)]
            a, b = _wrap(left, level + (level == 4)), _wrap(right, level + (not isinstance(op, ast.Add | ast.Mult)))
            sign = {ast.Add: " + ", ast.Sub: " - ", ast.Mult: " ", ast.Div: "/", ast.Pow: "^"}[type(op)]
            return a + sign + b, level
        case ast.UnaryOp(_, operand):
            return "-" + _wrap(operand, 2), 1
        case ast.Constant(value):
            return f"{value:g}" if isinstance(value, float) else str(value), 5
        case ast.Name(name):
            return name, 5
        case ast.Call(ast.Name("pm"), [inner]):
            return "+-" + _wrap(inner, 2), 1
        case ast.Call(ast.Name(name), args):
            return f"{name}({', '.join(paper(arg) for arg in args)})", 5
        case _:
            raise ValueError(ast.dump(node))


def _wrap(node: ast.expr, level: int) -> str:
    text, own = _paper(node)
    return text if own >= level else f"({text})"


def parse(text: str) -> ast.expr:
    """A formula in Python's notation, as a tree."""
    return ast.parse(text, mode="eval").body
