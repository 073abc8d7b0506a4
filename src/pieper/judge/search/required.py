"""What would have to stand at a place of a formula for the whole to be right.

It is found by undoing the operations from the top down.

Comparing candidates with this value costs one small evaluation each, where building and evaluating the whole formula
would cost a hundred.
"""

from __future__ import annotations

import numpy as np

from pieper.algebra.expression import Add, Call, Div, Expr, Mul, Power
from pieper.algebra.formula import Equation, Neg, PlusMinus, has_branch, is_call

ARCS = ("acos", "asin", "atan", "atan2")


def required_values(root: Expr, wanted: np.ndarray | None, angle: bool, value: dict[Expr, np.ndarray]) -> dict:
    """Return path -> (K,) required value of the node there; a path is missing where the operation cannot be undone.

    Args:
        root: the formula, or an equation.
        wanted: (K,) what the formula should give; None for an equation.
        angle: the formula is for an angle, so the top is known only modulo a turn.
        value: values of all subtrees of the formula as it is.

    Returns:
        The required values.
    """
    out: dict[tuple[int, ...], np.ndarray] = {}
    stack: list[tuple[tuple[int, ...], Expr, np.ndarray, bool]] = []
    if isinstance(root, Equation):
        if has_branch(root):
            return out
        stack = [((0,), root.args[0], value[root.args[1]], False), ((1,), root.args[1], value[root.args[0]], False)]
    elif wanted is not None:
        stack = [((), root, wanted, angle)]
    with np.errstate(all="ignore"):
        while stack:
            path, node, need, turning = stack.pop()
            if not turning:
                out[path] = need
            for k, child in enumerate(node.args):
                # an angle is wanted modulo a turn and on either branch; a cosine or a tangent forgets both
                forgets = is_call(node, *ARCS)
                if turning and not forgets:
                    # beside a +- the upper sign is taken, so that the value is right at some of the samples only
                    if not isinstance(node, (Neg, PlusMinus, Add)):
                        continue
                inner = _undo(node, k, need, value)
                if inner is not None and np.isfinite(inner).any():
                    stack.append((path + (k,), child, inner, turning and not forgets))
    return out


def _undo(node: Expr, k: int, need: np.ndarray, value: dict[Expr, np.ndarray]) -> np.ndarray | None:
    if isinstance(node, Neg):
        return -need
    if isinstance(node, PlusMinus):
        return need  # for the upper sign: right at some of the samples only
    if isinstance(node, Add):
        return need - (value[node] - value[node.args[k]])
    others = [value[a] for i, a in enumerate(node.args) if i != k]
    if isinstance(node, Mul):
        return need / np.prod(np.broadcast_arrays(*others), axis=0)
    if isinstance(node, Div):
        return need * others[0] if k == 0 else others[0] / need
    if isinstance(node, Power) and k == 0 and isinstance(node.power, int) and node.power > 0:
        root = np.abs(need) ** (1 / node.power)
        if node.power % 2:
            return np.sign(need) * root
        return np.where(need < 0, np.nan, np.where(np.asarray(value[node.args[0]]) < 0, -root, root))
    name = node.name if isinstance(node, Call) else ""
    if name == "acos":
        return np.cos(need)
    if name == "asin":
        return np.sin(need)
    if name == "atan":
        return np.tan(need)
    if name == "sqrt":
        return need**2
    if name == "atan2":
        return others[0] * np.tan(need) if k == 0 else others[0] / np.tan(need)
    return None
