"""One slip in a formula: where, what, and the formula without it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

from pieper.algebra.expression import Expr
from pieper.algebra.formula import replaced, replaced_everywhere

KINDS = {
    "sign": "a sign",
    "index": "an index",
    "sine for cosine": "sine for cosine",
    "swapped factor": "a swapped factor",
    "missing factor": "a missing factor",
    "missing term": "a missing term",
    "two slips": "two slips at once",
    "extra factor": "a factor too many",
    "extra term": "a term too many",
    "product": "a product written as a sum, or a sum as a product",
    "power": "a square or a root",
    "atan": "atan for atan2, or its arguments exchanged",
    "branch": "the sign of a branch",
    "half turn": "half a turn",
    "inverse function": "arcsine for arccosine",
    "fraction": "a fraction upside down",
    "number": "a number",
    "degrees": "degrees for radians",
    "millimetres": "millimetres for metres",
}


@dataclass(frozen=True, eq=False)
class Slip:
    """One slip: the place in the formula and what stands there once the slip is undone.

    Attributes:
        kind: the family of slips it belongs to, one of `KINDS`.
        words: what was done: a text with places for the nodes that follow it, put together only when somebody reads it.
        root: the formula as printed.
        path: the place, child numbers from the root; None when `new` replaces every occurrence of `old`.
        new: what stands there once the slip is undone.
        cost: how far-fetched it is, smaller is likelier; ranks equally good explanations.
        old: a node that occurs more than once.
    """

    kind: str
    words: tuple[Any, ...]
    root: Expr
    path: tuple[int, ...] | None
    new: Expr
    cost: float
    old: Expr | None = None

    @cached_property
    def tree(self) -> Expr:
        """The formula with the slip undone."""
        if self.path is not None:
            return replaced(self.root, self.path, self.new)
        return replaced_everywhere(self.root, {id(self.old): self.new})

    @property
    def says(self) -> str:
        """What was done, in words."""
        return self.words[0].format(*map(_short, self.words[1:]))


def _short(node: Expr) -> str:
    text = str(node)
    return text if len(text) <= 48 else text[:45] + "..."
