"""What a part lacks that a formula uses more than once, as D in atan2(sqrt(1 - D^2), D).

The value that such a part must have to make the whole right is found where the whole, as a function of it, crosses what
is wanted; what the part lacks is then looked up as in a formula of its own.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from pieper.algebra.arithmetics import NumpyField
from pieper.algebra.expression import Add, Expr
from pieper.algebra.formula import Equation, Mention, Neg, replaced_everywhere
from pieper.judge.search.lookup import ENOUGH, Lost, Shelf
from pieper.judge.search.required import required_values
from pieper.judge.slips.slip import Slip
from pieper.kinematics.joints import short_way

LEAST = 5  # nodes of a part in which something may be missing
PLACES = 801  # values at which the whole is looked at
HALVINGS = 50  # of the way between two of them
JUMP = 1.0  # rad; a crossing is no jump, as of an angle by a whole turn
_PART = "part?"


def slips_in_shared(
    root: Expr,
    lost: Lost,
    shelf: Shelf,
    env: Mapping[str, np.ndarray],
    wanted: np.ndarray | None,
    values: dict[Expr, Any],
    *,
    angle: bool,
) -> Iterator[Slip]:
    """Yield the formulas in which a part that occurs more than once has what it lacks.

    Args:
        root: The formula or the equation, as printed.
        lost: What may be missing.
        shelf: Products of letters at a few samples.
        env: Values of all symbols at them, (P,) each.
        wanted: What the formula should give, (P,); None of an equation.
        values: Values of all subtrees as printed.
        angle: Whether that is an angle, rad.
    """
    if isinstance(root, Equation):
        root_of, wanted = Add.of(root.args[0], Neg.of(root.args[1])), np.zeros(shelf.shape)
    elif wanted is None:
        return
    else:
        root_of = root
    for part in _shared(root):
        whole = replaced_everywhere(root_of, {id(part): Mention(_PART)})
        printed = np.broadcast_to(np.asarray(values[part], dtype=float), wanted.shape)
        need = _crossing(whole, env, wanted, printed, angle=angle)
        if np.count_nonzero(np.isfinite(need)) < ENOUGH:
            continue
        needed = required_values(part, need, False, values)
        for slip in lost.slips(part, shelf, needed, values):
            yield Slip(slip.kind, slip.words, root, None, slip.tree, slip.cost, part)


def _shared(root: Expr) -> list[Expr]:
    """The largest parts that occur more than once."""
    count: dict[int, int] = {}
    for node in root.walk():
        count[id(node)] = count.get(id(node), 0) + 1
    found: dict[int, Expr] = {}
    inside: set[int] = set()
    for node in root.walk():
        if count[id(node)] > 1 and id(node) not in inside and id(node) not in found and node.size() >= LEAST:
            found[id(node)] = node
            inside.update(id(x) for x in node.walk() if x is not node)
    return list(found.values())


def _crossing(
    whole: Expr, env: Mapping[str, np.ndarray], wanted: np.ndarray, printed: np.ndarray, *, angle: bool
) -> np.ndarray:
    """The value of a part, nearest to what it is as printed, with which the whole is what is wanted; nan for none."""
    size = 2 * float(np.nanmax(np.abs(printed), initial=1.0))
    # closer together where they are small: a cosine lies between -1 and 1 whatever was printed
    places = size * np.linspace(-1, 1, PLACES) ** 3

    def off(x: np.ndarray) -> np.ndarray:
        with np.errstate(all="ignore"):
            shaped = {name: value[:, None] for name, value in env.items()} | {_PART: x}
            value = np.asarray(whole.evaluate(shaped, NumpyField, 1), dtype=float)
            gap = value - wanted[:, None]
            return np.broadcast_to(short_way(gap) if angle else gap, x.shape)

    x = np.broadcast_to(places, (len(wanted), PLACES))
    at = off(x)
    with np.errstate(all="ignore"):
        crosses = (at[:, :-1] * at[:, 1:] <= 0) & (not angle or np.abs(at[:, :-1] - at[:, 1:]) < JUMP)
        gap = np.where(crosses, np.abs((x[:, :-1] + x[:, 1:]) / 2 - printed[:, None]), np.inf)
    first = gap.argmin(axis=1)
    rows = np.arange(len(wanted))
    low, high = x[rows, first], x[rows, first + 1]
    side = at[rows, first]
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        same = off(middle[:, None])[:, 0] * side > 0
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    return np.where(np.isfinite(gap[rows, first]), (low + high) / 2, np.nan)
