"""What kind of arm it is, and how many solutions a pose can have by what its own axes do.

The slots of a plan (`max_solutions`) are those of the six-joint problem that is solved, padding included; an arm with
fewer joints cannot fill them all. Here its own axes are counted: each step of the argument is an equation of a known
degree, and together they bound the number of solutions of a pose that is not singular.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np

from pieper.kinematics.arrays import Bools
from pieper.kinematics.chain import Chain
from pieper.kinematics.geometry import Geometry, look
from pieper.solver.plan.count_of_five import five_joints
from pieper.solver.plan.holding import TRIED
from pieper.solver.plan.plan import Count, Plan
from pieper.solver.plan.six_joints import generic_rank, with_task_joints
from pieper.solver.plan.unlike import unlike
from pieper.words_by_number import plural

#: Turns and slides of the first three joints of a spherical wrist's arm, or of an arm for positions: solutions at most.
_REGIONAL = {0: 4, 1: 4, 2: 2, 3: 1}
_QUARTIC = "three joints put a point somewhere by an equation of degree four at most (Pieper 1968)"


def count_of(plan: Plan) -> Count:
    """Return what kind of arm a plan solves and how many solutions a pose can have."""
    if plan.uncoupled is not None:
        return count_of(plan.uncoupled)  # the joints' numbers follow from the axes' values, one each
    bound = None
    if not plan.snapped:
        bound = _with_spares_held(plan) if plan.redundancy else _own(plan.nominal, plan.geometry, plan.names, plan.task)
    if bound is None or bound.most > plan.max_solutions:
        turns = int((~plan.nominal.prismatic).sum())
        kind = _plain_kind(plan.nominal, turns)
        bound = Count(kind, plan.max_solutions, "the equation it is solved by has no more roots")
    if not plan.redundancy:
        return bound
    spare = plural(len(plan.redundancy), "freedom")
    kind = f"a redundant arm, which has {spare} more than the task needs"
    return Count(kind, bound.most, f"with {' and '.join(plan.redundancy)} held, {bound.argument}")


def _own(chain: Chain, geometry: Geometry, names: tuple[str, ...], task: str) -> Count | None:
    """Count the solutions of an arm by its own axes; None where they say nothing, or where it has joints to spare."""
    full, slides = with_task_joints(chain, task), chain.prismatic
    if generic_rank(full) != full.n:
        return None
    if chain.n == 6:
        return _six(geometry, slides)
    turns = int((~slides).sum())
    if task != "position+axis":
        return _short(chain, geometry, names, task)
    # with the turn that the task leaves open it is an arm with one joint more
    whole = look(full, geometry.tolerance)
    found = _six(whole, full.prismatic) if full.n == 6 else _short(full, whole, (*names, "tool roll"), "pose")
    return None if found is None else replace(found, kind=_plain_kind(chain, turns))


def _with_spares_held(plan: Plan) -> Count | None:
    """Count what is left of an arm while its spare joints are held, at values of no special kind.

    What is parallel, or meets in a point, at some of them is so at all.
    """
    reduction = plan.reduction
    virtual = any(joint >= plan.n for joint in reduction.locked)
    # where the task's own joints are solved for, the arm is counted without them: a wrist that is none has two ways
    way, task = (reduction, "pose") if virtual else (replace(reduction, full=plan.nominal), plan.task)
    names = tuple(plan.full_names[joint] for joint in range(way.full.n) if joint not in reduction.locked)
    most: Count | None = None
    for value in TRIED:
        chain = way.with_locked(unlike(len(reduction.locked), value))
        found = _own(chain, look(chain, plan.geometry.tolerance), names, task)
        if found is None:
            return None
        most = found if most is None or found.most > most.most else most
    return most


def _plain_kind(chain: Chain, turns: int) -> str:
    rank = generic_rank(chain)
    made = f"{plural(turns, 'turn')}" + (f" and {plural(chain.n - turns, 'slide')}" if chain.n > turns else "")
    return f"an arm of {made}" + (f" that can do {plural(rank, 'thing')} at once" if rank < chain.n else "")


# ---------------------------------------------------------------------------------------------- fewer than six joints


def _short(chain: Chain, geometry: Geometry, names: tuple[str, ...], task: str) -> Count | None:
    """Count an arm whose joints are all needed and fewer than six, or an arm of up to three joints for positions."""
    slides = chain.prismatic
    turns = int((~slides).sum())
    if turns == 0:
        return Count("a gantry", 1, "its joints only slide, and their equations are linear")
    alike = _all_alike(geometry, ~slides)
    if task == "position":
        return _for_positions(slides, turns, alike)
    found = _planar(geometry, slides, turns) if alike else _around_a_plane(geometry, names, slides)
    if found is None and chain.n == 4 and slides.sum() == 3:
        return Count("a gantry with one turn", 1, "the turn is read off the orientation, and the slides are linear")
    if found is not None:
        return found
    few = None if alike else _few_turns(geometry, slides)
    if few is not None:
        return few
    if chain.n == 4:
        return _two_and_two(chain, turns)
    five = five_joints(geometry, slides)
    return None if five is None else Count(_plain_kind(chain, turns), *five)


def _two_and_two(chain: Chain, turns: int) -> Count:
    """Count an arm of four joints that depend on each other nowhere but at singular poses.

    Displacements are points of a projective space of seven dimensions. What two joints do to a body is a quadric in a
    space of three (two turns: 1, the two axes and their product span it), or a plane of two slides. The first two
    joints bring the body between them into one such space, the last two, seen from the tool, into another. The two meet
    in a line at most wherever a solution is regular: where they share a plane, both quadrics are that of all
    displacements, or both are groups, and the solutions are curves. A line meets a quadric in two points or lies on it.
    """
    why = (
        "its first two joints and its last two each hold the body between them on a quadric in a space of three "
        "dimensions, and the line that two such spaces have in common meets a quadric twice (Selig 2005)"
    )
    return Count(_plain_kind(chain, turns), 2, why)


def _for_positions(slides: Bools, turns: int, alike: bool) -> Count | None:
    if turns == 1 and len(slides) == 3:
        return Count(
            "an arm of a turn and two slides, for positions",
            2,
            "its slides taken out, one linear equation in the cosine and sine of its turn is left, with two roots",
        )
    if turns == 1 and len(slides) == 1:
        return Count("a single turn, for positions", 1, "a point comes by each place of its circle once")
    if alike and turns == 2:
        return Count(
            "an arm of two parallel turns, for positions", 2, "they put a point where two circles meet, a slide apart"
        )
    if turns == 2 and len(slides) == 2:
        return Count(
            "an arm of two turns, for positions",
            2,
            "how high a point is along the first axis, and how far from it, are linear in the cosine and sine of the "
            "second turn, which leaves two values of it",
        )
    if len(slides) == 2 and turns == 1:
        return Count("an arm of a turn and a slide, for positions", 2, "a line meets a circle in at most two points")
    if len(slides) < 3:
        return None
    kind = "an arm of three turns, for positions" if turns == 3 else "an arm of two turns and a slide, for positions"
    return Count(kind, _REGIONAL[int(slides.sum())], _QUARTIC)


def _planar(geometry: Geometry, slides: Bools, turns: int) -> Count | None:
    """Count an arm whose turns are all about parallel axes: the orientation says their sum."""
    axes = geometry.chain.axes
    z = axes[int(np.argmax(~slides))]
    along = np.abs(axes[slides] @ z) >= 1 - geometry.tolerance
    across = int((~along).sum())
    if turns > 3 or turns + across > 3:
        return None
    kind = "a planar arm"
    if along.any():
        kind = "a SCARA arm" if turns >= 2 else "an arm of a turn and a slide"
    if turns == 3 or (turns == 2 and across == 1):
        where = "two circles" if turns == 3 else "a circle and a line"
        return Count(
            kind,
            2,
            f"the orientation says the sum of its turns, and what is left is where {where} meet"
            + (", the slide along the axes apart" if along.any() else ""),
        )
    return Count(kind, 1, "the orientation says the sum of its turns, and the position says each of them")


def _around_a_plane(geometry: Geometry, names: tuple[str, ...], slides: Bools) -> Count | None:
    """Count an arm with three turns in a row about parallel axes and one or two turns beside them."""
    if slides.any() or len(slides) not in (4, 5):
        return None
    for group in geometry.parallel:
        if len(group.joints) != 3:
            continue
        others = [j for j in range(len(slides)) if j not in group.joints]
        common = ", ".join(names[j] for j in group.joints)
        if len(others) == 1:
            return Count(
                "a planar arm on a turn",
                2,
                f"the orientation says where the common direction of {common} points, and so {names[others[0]]}; "
                "those three then place a point where two circles meet",
            )
        between = others[0] < group.joints[0] < others[1]
        first, last = (names[j] for j in others)
        way = (
            f"two values of {first} give the common direction of {common} its angle to the axis of {last}"
            if between
            else f"two pairs of values of {first} and {last} turn the common direction of {common} where it must point"
        )
        kind = "a planar arm between two turns" if between else "a planar arm and two turns"
        return Count(kind, 4, f"{way}, and for each those three place a point where two circles meet")
    return None


# ---------------------------------------------------------------------------------------------- six joints


def _six(geometry: Geometry, slides: Bools) -> Count | None:
    """Count an arm of six joints of which three meet in a point, or three slide."""
    if not geometry.spherical:
        return _few_turns(geometry, slides)
    count = int(slides.sum())
    why = {
        2: "its slides taken out, one linear equation in a cosine and a sine is left for its centre, with two roots",
        3: "its slides are linear",
    }.get(count, _QUARTIC)
    kind = {
        0: "an arm with a spherical wrist",
        1: "an arm of two turns and a slide, with a spherical wrist",
        2: "an arm of a turn and two slides, with a spherical wrist",
    }.get(count, "a gantry with a spherical wrist")
    return Count(kind, 2 * _REGIONAL[count], f"{why}, and the wrist has two ways to an orientation")


def _few_turns(geometry: Geometry, slides: Bools) -> Count | None:
    """Count an arm of two or three turns, each across the one before it, and slides, which leave the orientation.

    Of three turns without a slide two neighbours may be parallel: the orientation says their sum and the third, and the
    position, which goes round a circle, each of them.
    """
    turning = np.flatnonzero(~slides)
    axes = geometry.chain.axes
    if len(turning) not in (2, 3):
        return None
    parallel = [1 - abs(axes[i] @ axes[j]) <= geometry.tolerance for i, j in pairwise(turning)]
    turns, slid = plural(len(turning), "turn"), plural(len(slides) - len(turning), "slide")
    if any(parallel):
        if all(parallel):
            return None
        if slides.any():
            first, last = turning[parallel.index(True) : parallel.index(True) + 2]
            return _one_turn_left(turns, slid, int(slides.sum()), bool(slides[first:last].any()))
        why = "the orientation says the sum of its parallel turns and the other one, and the position says each of them"
        return Count(f"an arm of {turns}", 1, why)
    ways, most = ("two ways", 2) if len(turning) == 3 else ("one way", 1)
    if not slides.any():
        return Count(f"an arm of {turns}", most, f"its turns have {ways} to an orientation")
    why = f"slides leave the orientation alone, its turns have {ways} to it, and the slides are then linear"
    return Count(f"an arm of {turns} and {slid}", most, why)


def _one_turn_left(turns: str, slid: str, count: int, between: bool) -> Count | None:
    """Count an arm that slides and one of two parallel turns place; None where a slide is between these two."""
    if between or count > 2:
        return None
    why = (
        "the orientation says the sum of its parallel turns and the other one; the slides taken out of the position, "
        "an equation linear in the cosine and sine of a parallel turn is left, which has two roots"
    )
    return Count(f"an arm of {turns} and {slid}", 2, why)


def _all_alike(geometry: Geometry, which: Bools) -> bool:
    """Whether the axes of some joints are parallel, wherever the arm stands."""
    chosen = np.flatnonzero(which)
    axes, turning = geometry.chain.axes, ~geometry.chain.prismatic
    for first, last in pairwise(chosen):
        if 1 - abs(axes[first] @ axes[last]) > geometry.tolerance:
            return False
        if turning[first + 1 : last].any():
            return False
    return True
