"""What would have to stand at a place of a formula for the whole to be right, found by undoing the operations from the
top down.

Comparing candidates with this value costs one small evaluation each, where building and evaluating the whole formula
would
cost a hundred.
"""

from __future__ import annotations

import numpy as np

from pieper.algebra.tree import Node


def required_values(root: Node, wanted: np.ndarray | None, angle: bool, value: dict[Node, np.ndarray]) -> dict:
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
    if root.op == "eq":
        if root.has_branch():
            return out
        stack = [((0,), root.args[0], value[root.args[1]], False), ((1,), root.args[1], value[root.args[0]], False)]
    else:
        stack = [((), root, wanted, angle)]
    with np.errstate(all="ignore"):
        while stack:
            path, node, need, turning = stack.pop()
            if not turning:
                out[path] = need
            for k, child in enumerate(node.args):
                # an angle is wanted modulo a turn and on either branch; a cosine or a tangent forgets both
                forgets = node.op == "call" and node.value in ("acos", "asin", "atan", "atan2")
                if turning and not forgets:
                    others = [a for a in node.args if a is not child]
                    if node.op not in ("neg", "pm", "add") or any(a.has_branch() for a in others):
                        continue
                inner = _undo(node, k, need, value)
                if inner is not None and np.isfinite(inner).any():
                    stack.append((path + (k,), child, inner, turning and not forgets))
    return out


def _undo(node: Node, k: int, need: np.ndarray, value: dict[Node, np.ndarray]):
    op = node.op
    if op not in ("add", "neg", "pm"):
        others = [value[a] for i, a in enumerate(node.args) if i != k]
    if op == "neg":
        return -need
    if op == "pm":
        # either sign may be meant; what follows (acos) does not see the difference, anything else is tried in full
        return need if node.args[0].op == "call" and node.args[0].value == "acos" else None
    if op == "add":
        return need - (value[node] - value[node.args[k]])
    if op == "mul":
        return need / np.prod(np.broadcast_arrays(*others), axis=0)
    if op == "div":
        return need * others[0] if k == 0 else others[0] / need
    if op != "call":
        return None
    name = node.value
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
