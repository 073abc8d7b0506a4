"""Every arm one slip away from a given one: a row misread, a convention mistaken, a frame turned."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction

import numpy as np

from pieper.algebra.expression import Add, Expr, PiFraction
from pieper.algebra.formula import Mention, Neg, number
from pieper.judge.model import ArmModel
from pieper.judge.slips.fitting import lengths_of
from pieper.tolerances import ROUNDING, WHOLE_TURN

ARM_KINDS = {
    "convention": "standard for modified DH",
    "lengths": "two lengths exchanged",
    "row": "a and d swapped in a row, or a length in the wrong row",
    "twist": "the sign of a twist",
    "sense": "the maker's sense of a joint",
    "zero": "the maker's zero of a joint",
    "tool": "the tool left out",
    "base": "the base left out",
    "flange": "the last length left out",
    "axes": "axes renamed",
}


def arm_slips(model: ArmModel) -> Iterator[tuple[str, str, ArmModel]]:
    """Yield (kind, words, arm) for the arms one slip away, each with the slip *made*.

    A claim that is right for such an arm was worked out with that slip.
    """
    other = "modified" if model.convention == "standard" else "standard"
    yield "convention", f"{other} for {model.convention} DH", replace(model, convention=other)
    for i, row in enumerate(model.rows):
        joint = i + 1
        if not model.sliding(joint):
            if _value(model, row.a) or _value(model, row.d):
                yield "row", f"a and d swapped in row {joint}", model.with_row(i, a=row.d, d=row.a)
            yield "sense", f"joint {joint} turns the other way", _turned(model, i, Neg.of)
            for degrees in (90, -90, 180):
                shift = PiFraction(Fraction(degrees, 180))
                words = f"joint {joint} has its zero {degrees:+d} deg from there"
                yield "zero", words, _turned(model, i, lambda v, s=shift: Add.of(v, s))
        twist = _value(model, row.alpha)
        if twist and abs(abs(twist) - np.pi) > WHOLE_TURN:
            yield "twist", f"the twist of row {joint} has the other sign", model.with_row(i, alpha=Neg.of(row.alpha))
    for place, node, make in lengths_of(model):
        yield "row", f"{place} left out", make(model, number(0))
        yield "row", f"{place} has the other sign", make(model, Neg.of(node))
    yield from _exchanged(model)
    if not np.allclose(model.tool, np.eye(4)):
        yield "tool", "the tool left out", replace(model, tool=np.eye(4))
    if not np.allclose(model.base, np.eye(4)):
        yield "base", "the base left out", replace(model, base=np.eye(4))
    for words, R in axis_renamings():
        turned = np.eye(4)
        turned[:3, :3] = R
        yield "axes", words, replace(model, base=turned @ model.base)


def two_twists(model: ArmModel) -> Iterator[tuple[str, str, ArmModel]]:
    """Yield the arms in which the twists of two rows have the other sign."""
    values = [abs(_value(model, row.alpha)) for row in model.rows]
    turned = [i for i, twist in enumerate(values) if twist and abs(twist - np.pi) > WHOLE_TURN]
    for i, j in itertools.combinations(turned, 2):
        arm = model.with_row(i, alpha=Neg.of(model.rows[i].alpha)).with_row(j, alpha=Neg.of(model.rows[j].alpha))
        yield "twist", f"the twists of rows {i + 1} and {j + 1} have the other sign", arm


def _exchanged(model: ArmModel) -> Iterator[tuple[str, str, ArmModel]]:
    """Yield the arms in which two lengths of the table stand in each other's place."""
    for (first, a, make), (second, b, make_other) in itertools.combinations(lengths_of(model), 2):
        apart = abs(_value(model, a) - _value(model, b)) > ROUNDING
        if first.split()[-1] != second.split()[-1] and apart:
            yield "lengths", f"{a} and {b} exchanged", make_other(make(model, b), a)


def axis_renamings() -> Iterator[tuple[str, np.ndarray]]:
    """Yield (words, R) for the 47 ways to rename the base axes, mirrored ones included."""
    for order in itertools.permutations(range(3)):
        for signs in itertools.product((1, -1), repeat=3):
            R = np.zeros((3, 3))
            for k, (axis, sign) in enumerate(zip(order, signs, strict=True)):
                R[k, axis] = sign
            if np.array_equal(R, np.eye(3)):
                continue
            names = ", ".join(
                f"printed {'XYZ'[k]} is {'-' if s < 0 else ''}{'xyz'[a]}"
                for k, (a, s) in enumerate(zip(order, signs, strict=True))
                if a != k or s < 0
            )
            up = " (Y up)" if R[1, 2] == 1 else ""
            yield f"axes renamed{up}: {names}", R


def _turned(model: ArmModel, index: int, change: Callable[[Expr], Expr]) -> ArmModel:
    name = f"theta{index + 1}"
    return model.with_row(index, theta=model.rows[index].theta.substitute({name: change(Mention(name))}))


def _value(model: ArmModel, node: Expr) -> float:
    return float(node.evaluate(model.at_zero))
