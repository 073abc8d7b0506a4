"""Is a formula right but for the rounding of its printed numbers?

0.432 stands for whatever rounds to it. The exact numbers are looked for by Newton's method; when they lie within half a
unit of the last printed digits, and the formula with them is right at fresh joint vectors too, the print is right to
its digits. A slip cannot hide here: with it no such numbers exist.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from pieper.algebra.expression import Expr, Num
from pieper.algebra.formula import Mention, replaced_everywhere
from pieper.judge.evidence import Evidence
from pieper.judge.lengths import decimals
from pieper.judge.numbers import last_digit
from pieper.judge.verdict import Verdict
from pieper.tolerances import EXACT_ENOUGH, EXPLAINED_RANK, NO_CHANGE, SLOPE_STEP

HALF = 0.51  # of a unit of the last digit: rounding either way, and a little for binary numbers
STEPS = 6
ROWS = 400  # joint vectors from which the numbers are found
CHECKED = 200  # fresh ones at which they are tried

Gap = Callable[[Evidence, Expr, dict[str, np.ndarray]], np.ndarray]
Judged = Callable[[Evidence, Expr], np.ndarray]


@dataclass(frozen=True)
class Unrounded:
    """A formula with the numbers that its printed ones were rounded from.

    Attributes:
        tree: the formula with them.
        words: "0.4318 for 0.432", ...
        off: by how much the formula as printed is off at most.
        digits: how many digits the coarsest of the numbers has.
    """

    tree: Expr
    words: str
    off: float
    digits: int


def unrounded(ev: Evidence, node: Expr, gap: Gap, judged: Judged) -> Unrounded | None:
    """Return the formula with its numbers unrounded, or None when rounding does not explain what is wrong.

    Args:
        ev: the arm.
        node: the formula, wrong as it is printed.
        gap: evidence, formula and values that come on top -> printed minus right, (K,); nan where undefined.
        judged: evidence and a formula -> where it is right, (K,) bool.
    """
    root = node.substitute(ev.definitions)
    found = [leaf for leaf in decimals(root) if leaf.value]
    if not found:
        return None
    steps = np.array([last_digit(leaf.written) for leaf in found])
    names = [f"number {k}" for k in range(len(found))]
    open_tree = replaced_everywhere(root, {id(leaf): Mention(name) for leaf, name in zip(found, names, strict=True)})
    many = ev.drawn(ROWS, 17, {})
    start = np.array([float(leaf.value) for leaf in found])
    value = start.copy()

    def off(at: np.ndarray) -> np.ndarray:
        return gap(many, open_tree, {name: np.full(len(many.samples.q), v) for name, v in zip(names, at, strict=True)})

    first = off(start)
    for _ in range(STEPS):
        here = off(value)
        slopes = []
        for k in range(len(value)):
            moved = value.copy()
            moved[k] += SLOPE_STEP * steps[k]
            slopes.append((off(moved) - here) / SLOPE_STEP)
        rows = np.isfinite(here) & np.all(np.isfinite(slopes), axis=0)
        if rows.sum() < max(8, 3 * len(value)):
            return None
        change = np.linalg.lstsq(np.array(slopes)[:, rows].T, -here[rows], rcond=EXPLAINED_RANK)[0]
        value = value + np.clip(change, -1, 1) * steps
        if np.abs(change).max() < NO_CHANGE:
            break
    if np.any(np.abs(value - start) > HALF * steps):
        return None
    right = {id(leaf): Num(repr(float(v)), f"{v:.10g}") for leaf, v in zip(found, value, strict=True) if np.isfinite(v)}
    tree = replaced_everywhere(root, right)
    if not judged(ev.drawn(CHECKED, 18, {}), tree).all():
        return None
    changed = [
        (leaf, v) for leaf, v in zip(found, value, strict=True) if abs(v - float(leaf.value)) > EXACT_ENOUGH * abs(v)
    ]
    if not changed:
        return None
    words = ", ".join(dict.fromkeys(f"{v:.7g} for {leaf.written}" for leaf, v in changed))
    digits = min(len(leaf.written.lower().split("e")[0].replace(".", "").lstrip("0")) for leaf, _ in changed)
    return Unrounded(tree, words, float(np.nanmax(np.abs(first))), digits)


def with_rounding(verdict: Verdict, exact: Unrounded, off: str) -> Verdict:
    """The verdict on the unrounded formula as that of the printed one."""
    words = f"Right to its {exact.digits} digits (exact with {exact.words}; {off}). "
    return replace(verdict, sentence=words + verdict.sentence, digits=exact.digits)
