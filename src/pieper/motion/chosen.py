"""Which solution of a pose a file means: the one that its configuration words, or the posture it names, select."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pieper.errors import NoSolutionError
from pieper.kinematics.arrays import Array
from pieper.kinematics.forward import fk
from pieper.kinematics.joints import TURN
from pieper.kinematics.pose import pose_error
from pieper.motion.dialects.configuration import words_at
from pieper.motion.dialects.target import Target, Words
from pieper.solver import verbs
from pieper.solver.plan.plan import Plan
from pieper.tolerances import EITHER_WORD, SAME_TOOL_IN_FILE

#: Whole turns that are tried of a joint without limits, each way.
_TURNS = 2
_CURE = "dataclasses.replace(target, words=None) drops them"


def meant(plan: Plan, made_by: str, T: Array, target: Target, number: int, now: Array) -> Array:
    """Return the posture (n,) that a joint move to a pose ends in.

    Args:
        plan: How the arm is solved.
        made_by: Whose arm it is.
        T: (4, 4) the pose in the base.
        target: With its words, or the posture that it is to be near.
        number: Which target of its file it is, from 1.
        now: (n,) the posture that is left: what the words do not tell apart is as near to it as can be.

    Raises:
        InputError: The words are another maker's, or the arm is none that they are said of.
        NoSolutionError: The pose has no solution, or none with these words.
    """
    if target.words is not None:
        # another maker's words are refused before anything is solved
        words_at(plan, now, target.words.maker, made_by)
    near = target.near
    if near is not None and (pose_error(fk(plan.chain, near), T) < SAME_TOOL_IN_FILE).all():
        # it is the posture itself: the pose, rounded, may be a hair out of reach
        return near
    try:
        found = verbs.ik(plan, T)
        nearest = found.nearest(now if near is None else near)
    except NoSolutionError as error:
        raise NoSolutionError(f"target {number} of the file has no posture: {error}", target=number) from None
    if target.words is None:
        return nearest
    said = target.words
    limits = np.where(np.isfinite(plan.limits), plan.limits, [-_TURNS * TURN, _TURNS * TURN])
    joints = plan.chain.joints.first(plan.n)
    rows = np.concatenate([nearest[None], *(joints.variants(row, limits) for row in found.q)])
    told = [words_at(plan, row, said.maker, made_by) for row in rows]
    fits = np.array([here[:2] == (said.words, said.turns) for here in told])
    if not fits.any():
        fits = np.array([_may_be(plan, row, said, made_by) for row in rows])
    if fits.any():
        mine = rows[fits]
        return mine[int(np.argmin(_far(plan, mine, now)))]
    others = "; ".join(dict.fromkeys(str(Words(said.maker, *here[:2])) for here in told))
    raise NoSolutionError(
        f"target {number} of the file says {said.maker}'s configuration {said}, which no solution of its pose inside "
        f"the limits has; theirs are {others}. {_CURE}, and the nearest is gone to.",
        target=number,
    )


def check_arrived(plan: Plan, made_by: str, target: Target, number: int, q: Array) -> None:
    """Say what is wrong with a line or a circle that ends in another posture q (n,) than its target's words mean.

    Raises:
        NoSolutionError: It does.
    """
    said = target.words
    if said is None:
        return
    here = words_at(plan, q, said.maker, made_by)[:2]
    if here != (said.words, said.turns) and not _may_be(plan, q, said, made_by):
        raise NoSolutionError(
            f"target {number} of the file says {said.maker}'s configuration {said}, and the {_WAYS[target.kind]} to it "
            f"ends in {Words(said.maker, *here)}: it begins in another posture than the file's. Say "
            f"start= of that posture; {_CURE}.",
            target=number,
        )


_WAYS = {"move_l": "line", "move_c": "circle"}


def _far(plan: Plan, rows: Array, now: Array) -> Array:
    """Return how far postures (k, n) are from another one, whole turns counted."""
    out: Array = np.linalg.norm((rows - now) / plan.chain.joints.first(plan.n).unit, axis=1)
    return out


def _may_be(plan: Plan, q: Array, said: Words, made_by: str) -> bool:
    """Whether words are those of a posture but for what is open there: a joint by a rounding error on either side.

    Where the wrist is straight only the sum of two turns is the pose's, and they are not asked.
    """
    steps = np.vstack([np.zeros(plan.n), np.eye(plan.n), -np.eye(plan.n)]) * EITHER_WORD
    words, turns, clear = zip(*(words_at(plan, q + step, said.maker, made_by) for step in steps), strict=True)
    return _among(words, said.words) and (clear[0] < EITHER_WORD or _among(turns, said.turns))


def _among(seen: Sequence[Sequence[str | int]], wanted: Sequence[str | int]) -> bool:
    """Whether each part of what is wanted is among those seen; a number alone is a sum of either-ors, each a part."""
    parts = [_parts(one) for one in seen]
    return all(part in {other[k] for other in parts} for k, part in enumerate(_parts(wanted)))


def _parts(said: Sequence[str | int]) -> Sequence[str | int]:
    return [int(said[0]) >> bit & 1 for bit in range(6)] if len(said) == 1 else said
