"""Classify an arm once and decide how it is solved; everything per pose happens elsewhere."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from pieper import arguments
from pieper.description.dh import Description
from pieper.errors import PlanError
from pieper.kinematics.arrays import Array
from pieper.kinematics.chain import Chain
from pieper.kinematics.geometry import look, snapped
from pieper.solver.families import choose, named, tier
from pieper.solver.families.family import KernelSpec
from pieper.solver.native import without_far_ends
from pieper.solver.plan.count import count_of
from pieper.solver.plan.plan import Plan
from pieper.solver.plan.six_joints import (
    TASKS,
    Held,
    Reduction,
    default_task,
    generic_rank,
    reduce,
    refilled,
    sample_joints,
    with_task_joints,
)
from pieper.solver.plan.unlike import unlike, unlike_parts
from pieper.solver.words.explain import explain
from pieper.tolerances import GEOMETRY_EXACT, NEARLY_SPECIAL
from pieper.words_by_number import plural

#: Ways to lock spare joints that are tried before an arm is refused.
MOST_WAYS = 24
#: Parts of their limits at which spare joints are held where none of the ways is solvable at the middle of them.
UNLIKE_OTHERS = (0.5821, 0.3817)
#: Postures that a linkage holds at which its axes are to be solved well.
HELD_POSTURES = 15


def make_plan(
    chain: Chain,
    description: Description,
    *,
    task: str | None = None,
    snap: float | None = None,
    hold: Held | None = None,
) -> Plan:
    """Classify a chain and choose how it is solved.

    Args:
        chain: The arm.
        description: Its names and limits.
        task: "pose", "position", "position+axis", or None for the default of the arm.
        snap: Angles (rad) and distances (per characteristic length) below which axes are made parallel or meeting;
            None takes the table as exact.
        hold: What a linkage holds of the axes; None where each moves by itself.

    Raises:
        InputError: The task is unknown.
        PlanError: The arm cannot have the task, or no solver takes it; the message names the geometry found.
    """
    if task is not None:
        arguments.word(task, "task", TASKS)
    if chain.coupling is not None:
        return _coupled(chain, description, task, snap)
    try:
        plan = _as_told(chain, description, task, snap, hold)
    except PlanError:
        # between dependent and independent no elimination holds: the arm that this one nearly is has an answer
        nearest = None if snap is not None or hold is not None else next(_special(task, chain, description), None)
        if nearest is None:
            raise
        return nearest
    if snap is None and not plan.spec.info.get("certified", True):
        return _by_nearly(plan, chain, description)
    return plan


def _by_nearly(plan: Plan, chain: Chain, description: Description) -> Plan:
    """Return a plan through the special arm that this one nearly is, where it can only be solved so with certainty.

    So near to a special arrangement (an angle typed with nine digits, for one) every elimination drowns in rounding.
    The special arm's solutions are refined on the arm as described, and counted (see `snap_count`). A special arm with
    more joints to spare has self-motions where the arm as described has a few solutions, which nothing refines into
    these; nor do the few joints of a short arm take its special one's solutions onto the pose.
    """
    if plan.reduction.fill:
        return plan
    certain = (other for other in _special(plan.task, chain, description) if other.spec.info.get("certified", True))
    return next((other for other in certain if other.rank >= plan.rank), plan)


def _nearly(plan: Plan) -> Plan | None:
    """Return the plan through a closed form of the special arm that a plan's own nearly is; None where it is none."""
    if not plan.direct or not named(plan.family).eliminating:
        return None
    others = _special(plan.task, plan.chain, plan.description)
    return next((other for other in others if not named(other.family).eliminating), None)


def _plain(plan: Plan) -> Plan | None:
    """Return the plan of the arm as described, nothing made special; None where no solver takes it."""
    try:
        return _as_told(plan.chain, plan.description, plan.task, None)
    except PlanError:
        return None


def _from_afar(plan: Plan, distance: float) -> Plan:
    """Return a plan of an arm for poses this far away, m.

    Raises:
        PlanError: From so far away joints do the same, or no solver takes it.
    """
    found = make_plan(replace(plan.chain, scale=distance), plan.description, task=plan.task)
    if found.reduction.trivial:
        return found
    raise PlanError(f"{plan.name} has joints that do the same {distance:g} m away.")


def _special(task: str | None, chain: Chain, description: Description) -> Iterator[Plan]:
    """Yield plans through the special arms that an arm nearly is, the nearest first."""
    for near in NEARLY_SPECIAL:
        if snapped(chain, near)[1]:
            try:
                special = replace(_as_told(chain, description, task, near), plain=_plain)
            except PlanError:
                continue  # as a special arm it has joints that do the same, or no solver
            yield special


def _as_told(
    chain: Chain, description: Description, task: str | None, snap: float | None, hold: Held | None = None
) -> Plan:
    """Plan for the chain itself, or for the one that it becomes when what is near is made special."""
    nominal, moved, _ = (chain, [], 0.0) if snap is None else snapped(chain, snap)
    tolerance = GEOMETRY_EXACT
    geometry = look(nominal, tolerance)
    if generic_rank(chain) == 0:
        raise PlanError(
            f"{description.name} cannot move its tool at all: no joint changes the pose.", geometry=geometry
        )
    wanted = default_task(nominal) if task is None else task
    full = with_task_joints(nominal, wanted)
    ways = reduce(nominal, wanted, hold)
    if not ways:
        raise PlanError(f"{description.name}: no choice of locked joints leaves a solvable arm.", geometry=geometry)
    # the fastest family wins, then locks at the ends (which keep one plan for all values), then conditioning
    if len(ways) > 1:
        ways = _ranked(ways, description, tolerance)
    reduction, defaults, family, spec = _first_solvable(ways, description, tolerance)
    most = spec.max_solutions
    if wanted == "position" and reduction.full.n - len(reduction.locked) == 6 and not reduction.fill and chain.n <= 3:
        most //= 2  # the two turns of the virtual wrist are one position
    if moved:
        most = max(most, 16)  # what nearly is special need not be bounded as what is
    return Plan(
        name=description.name,
        description=description,
        chain=chain,
        nominal=nominal,
        geometry=geometry,
        limits=description.limits,
        names=description.joint_names,
        task=wanted,
        family=family,
        max_solutions=most,
        reduction=reduction,
        spec=spec,
        rank=full.n - len(reduction.locked),
        snapped=tuple(moved),
        defaults=defaults,
        base=description.base,
        words=explain,
        counting=count_of,
        special=_nearly,
        from_afar=_from_afar,
    )


def _coupled(chain: Chain, description: Description, task: str | None, snap: float | None) -> Plan:
    """Plan for coupled joints: the chain is solved as if each moved by itself, limits wait for the joints' numbers.

    Of axes that a linkage moves those postures are kept that the linkage holds (`solver/linked.py`); such an arm is
    asked for whole poses.
    """
    if chain.linked and not chain.whole_turns:
        raise PlanError(
            f"{description.name} has {_linked_words(description)} by parts of turns; its inverse is not taken, since a "
            "whole turn of a joint leads to another pose. Forward kinematics and Jacobian are.",
            coupling=chain.coupling,
        )
    # what a linkage holds may be special for its axes: they are made six joints for that
    hold = None
    if chain.linked:
        behind = 1 + max(i for i in range(chain.axis_count) if i not in chain.own)
        values = sample_joints(chain, HELD_POSTURES, seed=2) @ np.asarray(chain.coupling).T
        hold = Held(values, behind if behind < chain.axis_count else None)
    asked = "pose" if chain.linked and task is None else task
    plain = make_plan(chain.uncoupled, description.by_axes(), task=asked, snap=snap, hold=hold)
    if plain.redundancy:
        what = _linked_words(description) if chain.linked else "coupled joints"
        raise PlanError(
            f"{description.name} has {what} and {', '.join(plain.redundancy)} to spare for this task; the "
            f"inverse takes one or the other. {_spare_cure(chain, plain.task)}",
            coupling=chain.coupling,
        )
    return replace(
        plain,
        description=description,
        chain=chain,
        nominal=chain,
        geometry=plain.geometry if chain.linked else replace(plain.geometry, chain=chain),
        reduction=replace(plain.reduction, arm=chain, full=with_task_joints(chain, plain.task)),
        limits=description.limits,
        names=description.joint_names,
        uncoupled=plain,
    )


def _linked_words(description: Description) -> str:
    names = ", ".join(dict.fromkeys(axis.name for axis in description.linked))
    return f"a linkage that moves {names}"


def _spare_cure(chain: Chain, task: str) -> str:
    if chain.linked and task != "pose":
        return "Ask for the whole pose: position, and how the tool is turned."
    return "Lock a joint (with_joints_locked) or choose another task."


def _first_solvable(
    ways: list[Reduction], description: Description, tolerance: float
) -> tuple[Reduction, Array, str, KernelSpec]:
    """Return the first way that a solver takes, with the values of its locked joints, its family and kernel.

    Where none does, the values may be at fault: at the middle of the limits, or at zero, axes often meet by design.
    """
    refused: PlanError | None = None
    for part, some in itertools.chain(
        ((part, ways) for part in (0.5, *UNLIKE_OTHERS) if part == 0.5 or ways[0].locked),
        # nor may every elimination hold with the virtual joints that condition it best
        ((0.5, refilled(way)) for way in ways[:1]),
    ):
        for reduction in some[:MOST_WAYS]:
            defaults = _defaults(reduction, description, part)
            six, _ = without_far_ends(reduction.six(defaults))
            try:
                family, spec = choose(six, look(six, tolerance))
            except PlanError as error:
                refused = refused or error
                continue
            return reduction, defaults, family, spec
    if refused is None:
        raise PlanError(f"{description.name}: no way to lock joints was left to try.")
    raise _in_words_of(ways[0], description, refused)


def _in_words_of(way: Reduction, description: Description, refused: PlanError) -> PlanError:
    """Return what a family said of six joints as said of the arm and task that these were made of."""
    if way.trivial:
        return refused
    made = plural(way.arm.n, "joint of its own", "joints of its own")
    if way.full.n > way.arm.n:
        made += f", {plural(way.full.n - way.arm.n, 'joint')} for what the task {way.task!r} leaves free"
    if way.fill:
        made += f", {plural(len(way.fill), 'joint')} that must stay at zero"
    if way.locked:
        made += f", {len(way.locked)} of them held"
    others = " or ".join(repr(task) for task in TASKS if task != way.task)
    return PlanError(
        f"{description.name} is solved as six joints ({made}), and these have no solver. "
        f"{refused.data.get('reason', refused)} Lock a joint, or ask for the task {others}.",
        **refused.data,
    )


def _ranked(ways: list[Reduction], description: Description, tolerance: float) -> list[Reduction]:
    scored: list[tuple[int, int, bool, int, Reduction]] = []
    for order, way in enumerate(ways[:MOST_WAYS]):
        values = unlike(len(way.locked), 0.3719)  # a generic value: zero often looks more special than the arm is
        six = way.six(values)
        real = sum(j < way.arm.n for j in way.locked)
        # an arm of fewer than six joints cannot keep a chosen orientation: its own joints are held, not the task's
        real = real if way.arm.n >= 6 else -real
        scored.append((real, tier(six, look(six, tolerance)), way.at_ends is None, order, way))
    scored.sort(key=lambda entry: entry[:4])
    return [entry[-1] for entry in scored]


def _defaults(reduction: Reduction, description: Description, part: float = 0.5) -> Array:
    """Return the values locked joints have when nobody chooses: this far within their limits, or about zero."""
    values: list[float] = []
    count = len(reduction.locked)
    parts = unlike_parts(count, part).tolist() if part in UNLIKE_OTHERS else [part] * count
    for joint, part in zip(reduction.locked, parts, strict=True):
        lower, upper = description.limits[joint] if joint < reduction.arm.n else (-np.inf, np.inf)
        bounded = np.isfinite(lower) and np.isfinite(upper)
        values.append(float((1 - part) * lower + part * upper if bounded else np.clip(2 * part - 1, lower, upper)))
    return np.array(values)
