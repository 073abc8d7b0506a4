"""A posture's name in exported code: each word hangs on the sign of a short sum of sines and cosines of the joints.

The numbers behind the words (`pieper.solver.words.labels`) are polynomials in the joints' sines, cosines and slides, of
degree two at most in each joint, since they are scalar products and volumes of points and axes that the joints carry.
They are found from as many values as they have terms, and compared with the words themselves before they are written.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np

from pieper.errors import PlanError
from pieper.kinematics.arrays import Array
from pieper.solver.plan.plan import Plan
from pieper.solver.words.labels import Sides, joined, sides
from pieper.tolerances import LABEL_TERM, NO_SIDE

#: Five values of a joint tell a polynomial of degree two in its sine and cosine.
_VALUES = np.linspace(0.0, 2 * np.pi, 5, endpoint=False)
#: Sums are compared with the words' own numbers at this many postures.
_POSTURES = 200


@dataclass(frozen=True)
class Term:
    """A number times functions of joints: (joint from 0; "cos", "sin" or "slide"; times the angle, or power)."""

    number: float
    factors: tuple[tuple[int, str, int], ...]


@dataclass(frozen=True)
class Side:
    """One word of the label: a sum of terms whose sign decides; mirrored where the first sum is negative."""

    terms: tuple[Term, ...]
    mirrored: bool


@dataclass(frozen=True)
class Labels:
    """All of an arm's names: 3^k of them for k words, positive, negative and neither in turn, the last word fastest."""

    sides: tuple[Side, ...]
    names: tuple[str, ...]


def labels_of(plan: Plan) -> Labels:
    """Return how an arm's postures are named; without sides and with one empty name where they have none.

    Raises:
        PlanError: A word is no such sum.
    """
    at_zero = sides(plan, np.zeros((1, plan.n)))
    if not at_zero:
        return Labels((), ("",))
    found = tuple(Side(_terms(plan, k), side.mirrored) for k, side in enumerate(at_zero))
    names = tuple(joined(words) for words in itertools.product(*(side.words for side in at_zero)))
    return Labels(found, names)


def _smooth(side: Sides, first: Sides) -> Array:
    return side.values * np.where(first.values >= 0, 1.0, -1.0) if side.mirrored else side.values


def _number(plan: Plan, k: int, q: Array) -> Array:
    """Return the k-th number at rows q (m, n), not mirrored."""
    all_sides = sides(plan, q)
    return _smooth(all_sides[k], all_sides[0])


def _terms(plan: Plan, k: int) -> tuple[Term, ...]:
    rng = np.random.default_rng(6)
    q = rng.uniform(-2.9, 2.9, (_POSTURES, plan.n))
    values = _number(plan, k, q)
    used = [j for j in range(plan.n) if _depends(plan, k, q[:40], values[:40], j, rng)]
    grid = np.zeros((5 ** len(used), plan.n))
    points = [_points(plan, j) for j in used]
    if used:
        grid[:, used] = np.stack([axis.ravel() for axis in np.meshgrid(*points, indexing="ij")], -1)
    tensor = _number(plan, k, grid).reshape((5,) * len(used))
    for axis, j in enumerate(used):
        tensor = np.moveaxis(np.tensordot(np.linalg.inv(_basis(plan, j, points[axis])), tensor, (1, axis)), 0, axis)
    terms = tuple(
        Term(float(tensor[place]), tuple(_factor(plan, j, i) for j, i in zip(used, place, strict=True) if i))
        for place in itertools.product(range(5), repeat=len(used))
        if abs(tensor[place]) > LABEL_TERM
    )
    again = sum((t.number * np.prod([_value(q, f) for f in t.factors], axis=0) for t in terms), np.zeros(len(q)))
    if not np.allclose(again, values, rtol=0.0, atol=NO_SIDE / 2):
        raise PlanError(f"{plan.name}: a word of its labels is no sum of sines and cosines that could be written.")
    return terms


def _depends(plan: Plan, k: int, q: Array, values: Array, joint: int, rng: np.random.Generator) -> bool:
    moved = q.copy()
    moved[:, joint] = rng.uniform(-2.9, 2.9, len(q))
    return bool(np.abs(_number(plan, k, moved) - values).max() > LABEL_TERM)


def _points(plan: Plan, joint: int) -> Array:
    return plan.chain.length * np.linspace(-1.0, 1.0, 5) if plan.prismatic[joint] else _VALUES


def _basis(plan: Plan, joint: int, x: Array) -> Array:
    factors = [np.ones_like(x)]
    for i in range(1, 5):
        _, kind, times = _factor(plan, joint, i)
        factors.append(x**times if kind == "slide" else np.sin(times * x) if kind == "sin" else np.cos(times * x))
    return np.stack(factors, -1)


def _factor(plan: Plan, joint: int, i: int) -> tuple[int, str, int]:
    if plan.prismatic[joint]:
        return joint, "slide", i
    return joint, ("cos", "sin")[(i - 1) % 2], 1 + (i - 1) // 2


def _value(q: Array, factor: tuple[int, str, int]) -> Array:
    joint, kind, times = factor
    x = q[:, joint]
    return x**times if kind == "slide" else np.sin(times * x) if kind == "sin" else np.cos(times * x)


@dataclass(frozen=True)
class Manner:
    """How a language says what names a posture.

    Args:
        sin: A sine, with {0} for the angle; cos likewise.
        cos: A cosine.
        entry: A joint's value, with {0} for its number.
        first: The number of the first joint.
        line: A line that keeps a sum {1} under the name {0}.
        side: Which side (0, 1, 2) a sum {0} lies on for somebody who faces {1}.
    """

    sin: str
    cos: str
    entry: str
    first: int
    line: str
    side: str

    def parts(self, labels: Labels, names: str) -> dict[str, str]:
        """Return what a frame needs to name a posture; names as the language says a list of them."""
        return {
            "NAMES": names,
            "SUMS": self._sums(labels),
            "PLACE": self._place(labels),
            "NO_SIDE": repr(NO_SIDE),
        }

    def _sums(self, labels: Labels) -> str:
        sums = (" + ".join(map(self._term, side.terms)) or "0.0" for side in labels.sides)
        return "\n".join(self.line.format(f"side{i}", text) for i, text in enumerate(sums))

    def _place(self, labels: Labels) -> str:
        k = len(labels.sides)
        faced = ("side0" if side.mirrored else "1.0" for side in labels.sides)
        digits = [f"{3 ** (k - 1 - i)} * {self.side.format(f'side{i}', way)}" for i, way in enumerate(faced)]
        return " + ".join(digits) or "0"

    def _term(self, term: Term) -> str:
        number = f"({term.number!r})" if term.number < 0 else repr(term.number)
        return " * ".join([number, *(self._factor(*factor) for factor in term.factors)])

    def _factor(self, joint: int, kind: str, times: int) -> str:
        x = self.entry.format(joint + self.first)
        if kind == "slide":
            return " * ".join([x] * times)
        return (self.sin if kind == "sin" else self.cos).format(x if times == 1 else f"{times} * {x}")
