"""Formulas for an angle in degrees, as pages write them: 180 - acos(..), theta2 = 90 - beta - atan(..)."""

from __future__ import annotations

from collections.abc import Mapping

from pieper.algebra.expression import Add, Call, Div, Expr, Mul, PiFraction
from pieper.algebra.formula import ANGLE, Mention, Neg, PlusMinus, number, with_args
from pieper.algebra.notation import joint_sum

_ARCS = ("acos", "asin", "atan", "atan2")
_TURNS = ("sin", "cos", "tan")
DEGREE = Div(PiFraction(1), number(180))


def from_degrees(node: Expr) -> Expr:
    """The formula in radians, of one whose numbers, joints and inverse functions are degrees.

    Args:
        node: The formula; the sine of a joint, or of a sum of joints, is what it is in either unit.
    """
    if isinstance(node, (Add, Neg, PlusMinus)):
        return with_args(node, [from_degrees(a) for a in node.args])
    if (turned := _turned_by_hand(node)) is not None:
        return turned
    made = _degrees(node)
    return made.args[0] if _of_degrees(made) else Mul.of(made, DEGREE)


def angles_among(symbols: Mapping[str, Expr]) -> dict[str, Expr]:
    """Those of a file's symbols that are angles, which a formula in degrees has in degrees too."""
    return {name: tree for name, tree in symbols.items() if _degrees(tree) is not tree}


def _of_degrees(node: Expr) -> bool:
    return isinstance(node, Div) and str(node.args[1]) == str(DEGREE)


def _turned_by_hand(node: Expr) -> Expr | None:
    """What a page turns into degrees itself, np.degrees(pi - x) or (pi - x) 180/pi; None where it does not.

    Inside, everything is radians. Of one inverse function alone, atan2d(..) or np.degrees(np.arctan2(..)), that is not
    said: its sines may be of degrees.
    """
    if _of_degrees(node):
        return None if isinstance(node.args[0], Call) else node.args[0]
    if not isinstance(node, (Mul, Div)):
        return None
    over, under = _factors(node)
    half = next((f for f in over if str(f) == "180"), None)
    turn = next((f for f in under if str(f) == str(PiFraction(1))), None)
    if half is None or turn is None:
        return None
    over, under = [f for f in over if f is not half], [f for f in under if f is not turn]
    top = Mul.of(*over) if over else number(1)
    return Div(top, Mul.of(*under)) if under else top


def _factors(node: Expr) -> tuple[list[Expr], list[Expr]]:
    """What stands above and below the line of a product."""
    if isinstance(node, Mul):
        parts = [_factors(a) for a in node.args]
        return [f for over, _ in parts for f in over], [f for _, under in parts for f in under]
    if isinstance(node, Div):
        (over, under), (below, above) = _factors(node.args[0]), _factors(node.args[1])
        return over + above, under + below
    return [node], []


def _degrees(node: Expr) -> Expr:
    if (turned := _turned_by_hand(node)) is not None:
        return Div(turned, DEGREE)
    if isinstance(node, Mention):
        return Div(node, DEGREE) if ANGLE.match(node.name) else node
    if _of_degrees(node) and isinstance(node.args[0], Call):
        # acosd(..) is in degrees already; the sines inside may be of degrees
        return Div(with_args(node.args[0], [_degrees(a) for a in node.args[0].args]), DEGREE)
    if isinstance(node, Call) and node.name in _TURNS:
        (inner,) = node.args
        if isinstance(inner, Mul) and str(inner.args[-1]) == str(DEGREE):
            return Call(node.name, from_degrees(Mul.of(*inner.args[:-1])))
        return node if joint_sum(inner) else Call(node.name, from_degrees(inner))
    inside = [_degrees(a) for a in node.args]
    made = node if all(x is y for x, y in zip(inside, node.args, strict=True)) else with_args(node, inside)
    return Div(made, DEGREE) if isinstance(node, Call) and node.name in _ARCS else made
