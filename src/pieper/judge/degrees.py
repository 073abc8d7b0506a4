"""Formulas for an angle in degrees, as pages write them: 180 - acos(..), theta2 = 90 - beta - atan(..)."""

from __future__ import annotations

from pieper.algebra.expression import Call, Div, Expr, Mul, PiFraction
from pieper.algebra.formula import ANGLE, Mention, number, with_args
from pieper.algebra.notation import joint_sum

_ARCS = ("acos", "asin", "atan", "atan2")
_TURNS = ("sin", "cos", "tan")
DEGREE = Div(PiFraction(1), number(180))


def from_degrees(node: Expr) -> Expr:
    """The formula in radians, of one whose numbers, joints and inverse functions are degrees.

    Args:
        node: The formula; the sine of a joint, or of a sum of joints, is what it is in either unit.
    """
    return Mul.of(_degrees(node), DEGREE)


def _degrees(node: Expr) -> Expr:
    if isinstance(node, Mention):
        return Div(node, DEGREE) if ANGLE.match(node.name) else node
    if isinstance(node, Div) and str(node.args[1]) == str(DEGREE):
        return node  # acosd(..) is in degrees already
    if isinstance(node, Call) and node.name in _TURNS:
        (inner,) = node.args
        if isinstance(inner, Mul) and str(inner.args[-1]) == str(DEGREE):
            return Call(node.name, Mul.of(*map(_degrees, inner.args[:-1]), DEGREE))
        return node if joint_sum(inner) else Call(node.name, Mul.of(_degrees(inner), DEGREE))
    inside = [_degrees(a) for a in node.args]
    made = node if all(x is y for x, y in zip(inside, node.args, strict=True)) else with_args(node, inside)
    return Div(made, DEGREE) if isinstance(node, Call) and node.name in _ARCS else made
