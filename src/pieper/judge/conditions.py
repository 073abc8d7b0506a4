"""What a claim says of the joints it is about: when = "s5 > 0", when = "0 < theta5 < pi and c3 < 0"."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from pieper.algebra.expression import Expr
from pieper.errors import InputError

_AND = re.compile(r"\s+and\s+|\s*,\s*(?![^()]*\))|\s*&+\s*")
_COMPARED = re.compile(r"(<=|>=|<|>)")


@dataclass(frozen=True)
class Condition:
    """One comparison, left < right.

    Attributes:
        text: as the file has it.
        less, more: the formulas of which `less` must be the smaller.
    """

    text: str
    less: Expr
    more: Expr

    def met(self, env: Mapping[str, np.ndarray]) -> np.ndarray:
        """Where the condition holds, (K,) bool."""
        with np.errstate(all="ignore"):
            less, more = (np.asarray(side.evaluate(env), dtype=float) for side in (self.less, self.more))
            return np.broadcast_to(less < more, np.shape(env["theta1"]))


def read_conditions(text: str, read: Callable[[str], Expr]) -> tuple[Condition, ...]:
    """Read comparisons joined by "and" or commas; `read` reads a formula."""
    found: list[Condition] = []
    for one in _AND.split(text.strip()):
        pieces = _COMPARED.split(one)
        if len(pieces) < 3 or not all(p.strip() for p in pieces):
            raise InputError(f'when: {one!r} is no comparison; write it as "s5 > 0" or "0 < theta5 < pi"', key="when")
        sides = [read(p) for p in pieces[::2]]
        for k, sign in enumerate(pieces[1::2]):
            pair = (sides[k], sides[k + 1]) if sign[0] == "<" else (sides[k + 1], sides[k])
            found.append(Condition(one.strip(), *pair))
    return tuple(found)
