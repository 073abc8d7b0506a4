"""What the branch signs of a derivation mean for the posture: found by looking at the branches of random poses."""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np

from pieper.algebra.expression import Sym
from pieper.document.blocks import Document, Piece
from pieper.document.formulas import Written, equals
from pieper.equations.derivation.closed_form import ClosedForm
from pieper.kinematics.arrays import Array
from pieper.solver.plan.plan import Plan
from pieper.solver.words.labels import sides

POSES = 60
PLUS = Written("+1", "+1", "<mn>+1</mn>")
MINUS = Written("-1", "-1", "<mn>-1</mn>")


@dataclass(frozen=True)
class SignName:
    """What one sign, or the product of two, says of the posture.

    Attributes:
        signs: One branch sign, or two that are multiplied.
        plus: The word of the posture where it is +1.
        minus: The word where it is -1.
    """

    signs: tuple[Sym, ...]
    plus: str
    minus: str


def sign_names(form: ClosedForm, plan: Plan, T: Array) -> list[SignName]:
    """Find which branch sign decides which word of the posture label.

    Args:
        form: The closed form.
        plan: How the arm is solved; its labels are the words.
        T: (N, 4, 4) poses at which the branches are looked at.

    Returns:
        One `SignName` for each pair of words that a sign decides at every branch of every pose; none where the words
        follow no sign.
    """
    if not form.sigmas or any(step.branches > 2 for step in form.steps) or form.chosen or plan.n != form.n:
        return []
    found = form.evaluate(T)
    signs = np.array(list(itertools.product((1, -1), repeat=len(form.sigmas))))
    real = np.isfinite(found).all(-1)
    branch = np.nonzero(real)[0]
    if not len(branch):
        return []
    out: list[SignName] = []
    groups = [(k,) for k in range(len(form.sigmas))] + list(itertools.combinations(range(len(form.sigmas)), 2))
    for side in sides(plan, found[real]):
        words = np.array(side.said())
        for group in groups:
            sign = signs[branch][:, group].prod(1)
            plus, minus = set(words[sign > 0].tolist()), set(words[sign < 0].tolist())
            if len(plus) == len(minus) == 1 and plus != minus and "" not in plus | minus:
                out.append(SignName(tuple(form.sigmas[k] for k in group), plus.pop(), minus.pop()))
                break
    return out


def add_sign_names(page: Document, names: list[SignName]) -> None:
    """Say on a page what the signs mean, with the number of poses at which that was seen."""
    if not names:
        return
    parts: list[tuple[Piece, ...]] = []
    for name in names:
        times = [piece for sign in name.signs for piece in (" times ", sign)][1:]
        before: tuple[Piece, ...] = tuple(times[:-1])
        parts.append((*before, equals(name.signs[-1], PLUS), f" is {name.plus} and ", MINUS, f" is {name.minus}"))
    said = [piece for part in parts for piece in ("; ", *part)][1:]
    page.say("The signs name the posture: ", *said, f" (so at every branch of {POSES} random poses).")
