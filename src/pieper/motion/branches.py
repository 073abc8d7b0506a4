"""Every branch that starts at the first pose of a path, carried point by point to its end, singular points bridged."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.motion.continuation import AGREEMENT, Continuation
from pieper.solver.verbs import ik
from pieper.tolerances import BRANCH_ROUNDING, BRANCHES_MET, BRIDGE, READING

#: Halvings allowed when a branch is carried along a continuum of solutions.
PROJECTED_HALVINGS = 12


@dataclass
class Strand:
    """One branch on its way along the path.

    Attributes:
        q: Joint vectors (n,) at the path's points so far, whole turns continuous, rad or m.
        at: Joint vector from which the branch is carried on.
        x: Where `at` belongs, in points from the start of the path.
        end: Where the branch could be carried no further, in points; None while it lives.
        unresolved: Whether it was given up because the steps became too many.
        crossings: Where it passed a singularity, in points.
    """

    q: list[Array]
    at: Array
    x: float
    end: float | None = None
    unresolved: bool = False
    crossings: list[float] = field(default_factory=list[float])


def strands(way: Continuation, start: Array) -> list[Strand]:
    """Return every branch of the first pose, carried as far as it goes.

    Args:
        way: The arm on its path.
        start: (n,) posture the arm is in; on a continuum of solutions the member nearest to it starts a branch.
    """
    found = _first(way, start)
    for k in range(1, len(way.path)):
        alive = [s for s in found if s.end is None]
        if not alive:
            break
        if way.redundant:
            for strand in alive:
                _carry_on_continuum(way, strand, k)
        elif way.solutions(k)[1]:
            _reach_special(way, alive, k)
        else:
            _reach_regular(way, alive, k)
    return found


def _first(way: Continuation, start: Array) -> list[Strand]:
    found, special = way.solutions(0)
    if not special and not way.redundant:
        return [Strand([q], q, 0.0) for q in found]
    if len(way.path) > 1 and not way.redundant and not way.solutions(BRIDGE)[1]:
        # just after a singular first pose the branches are apart; each is read back to where it comes from
        out: list[Strand] = []
        for q in way.solutions(BRIDGE)[0]:
            first, ok = way.project(q, 0)
            if ok:
                out.append(Strand([first], q, BRIDGE, crossings=[0]))
        if out:
            return out
    # every pose near by has a continuum too: representatives of it begin a branch each
    if len(found) == 0 or not way.redundant:
        found = ik(way.plan, way.path[0]).all_q
    out = [Strand([q], q, 0.0) for q in found]
    own, ok = way.project(start, 0)
    if ok and all(np.abs(way.gap(own, q)).max() > BRANCH_ROUNDING for q in found):
        out.insert(0, Strand([own], own, 0.0))
    return out


def _by_place(alive: list[Strand]) -> list[list[Strand]]:
    places: dict[float, list[Strand]] = {}
    for strand in alive:
        places.setdefault(strand.x, []).append(strand)
    return list(places.values())


def _carry(way: Continuation, group: list[Strand], x: float) -> list[Strand]:
    """Carry strands that stand at one place to x; end those that do not arrive; return those that do."""
    q, place, met, unresolved = way.carry(np.array([s.at for s in group]), group[0].x, x)
    arrived: list[Strand] = []
    for i, strand in enumerate(group):
        if met[i] >= 0:
            strand.crossings.append(float(met[i]))
        if place[i] == x:
            strand.at, strand.x = q[i], x
            arrived.append(strand)
        else:
            strand.at, strand.x, strand.end = q[i], float(place[i]), float(place[i])
            strand.unresolved = bool(unresolved[i])
    return arrived


def _reach_regular(way: Continuation, alive: list[Strand], k: int) -> None:
    for group in _by_place(alive):
        if group[0].x < k - 1:  # it waits before a singular point and must cross that first
            group = _cross(way, group, k - 1)
        if not group:
            continue
        if way.solutions(k - 1)[1] and group[0].x == k - 1:
            group = _leave_continuum(way, group, k)
        for strand in _carry(way, group, k) if group else ():
            strand.q.append(strand.at)


def _cross(way: Continuation, group: list[Strand], k: int) -> list[Strand]:
    """Take strands that stand just before the singular point k to just after it; the way may have a corner there."""
    out: list[Strand] = []
    found, _ = way.solutions(k + BRIDGE)
    for strand in group:
        moved, sure = way.step(strand.at[None], strand.x, k + BRIDGE)
        if not sure[0] and len(found):
            size = np.sort(np.linalg.norm(way.gap(found, strand.at), axis=-1))
            if size[0] <= BRANCHES_MET and (len(size) == 1 or size[1] > 3 * size[0] + BRANCH_ROUNDING):
                moved, sure = way.step(strand.at[None], strand.x, k + BRIDGE, loose=True)
        if sure[0]:
            strand.at, strand.x = moved[0], k + BRIDGE
            strand.crossings.append(k)
            out.append(strand)
        else:
            strand.end = float(k)
    return _regroup(out)


def _regroup(group: list[Strand]) -> list[Strand]:
    """Return the strands of a group that stand at the first one's place (they all do, unless the group is empty)."""
    return [s for s in group if s.x == group[0].x]


def _leave_continuum(way: Continuation, group: list[Strand], k: int) -> list[Strand]:
    """Start strands that stand on a continuum of solutions at k - 1 into the regular stretch before k."""
    out: list[Strand] = []
    found, _ = way.solutions(k - 1 + BRIDGE)
    for strand in group:
        size = np.linalg.norm(way.gap(found, strand.at), axis=-1)
        if len(found) and size.min() <= BRANCHES_MET:
            moved = strand.at + way.gap(found[np.argmin(size)], strand.at) * way.unit
            strand.at, strand.x = moved, k - 1 + BRIDGE
            out.append(strand)
        else:
            strand.end = float(k - 1)
    return out


def _reach_special(way: Continuation, alive: list[Strand], k: int) -> None:
    """Reach a point whose pose is singular or redundant: isolated branches as ever, others by the nearest member."""
    before = k - BRIDGE
    for group in _by_place(alive):
        if group[0].x < k - 1:
            group = _cross(way, group, k - 1)
            if not group:
                continue
        rest: list[Strand] = []
        moved, sure = way.step(np.array([s.at for s in group]), group[0].x, k)
        for i, strand in enumerate(group):
            if sure[i] and not way.is_singular(moved[i], k):
                strand.at, strand.x = moved[i], float(k)
                strand.q.append(moved[i])
            else:
                rest.append(strand)
        if not rest:
            continue
        if way.solutions(before)[1]:
            for strand in rest:
                _carry_on_continuum(way, strand, k)
            continue
        if way.solutions(k - 1)[1] and rest[0].x == k - 1:
            rest = _leave_continuum(way, rest, k)
        for strand in _carry(way, rest, before) if rest else ():
            _read(way, strand, k)


def _read(way: Continuation, strand: Strand, k: int) -> None:
    """Read a strand that stands just before the singular point k at that point itself."""
    found, _ = way.solutions(k)
    if len(found):
        d = way.gap(found, strand.at)
        best = np.argmin(np.linalg.norm(d, axis=-1))
        if np.linalg.norm(d[best]) <= BRANCHES_MET:
            strand.q.append(strand.at + d[best] * way.unit)
            return
    q, ok = way.project(strand.at, k)
    if ok and np.linalg.norm(way.gap(q, strand.at)) <= READING:
        strand.q.append(q)
    else:
        strand.end = float(k)


def _carry_on_continuum(way: Continuation, strand: Strand, k: int) -> None:
    """Carry a strand to k where every pose on the way has a continuum of solutions: least joint motion, verified."""
    x, h = strand.x, k - strand.x
    q = strand.at
    smallest = h * 2.0**-PROJECTED_HALVINGS
    while x < k:
        x_next = min(x + h, float(k))
        predicted = way.predict(q, x, x_next)
        moved, ok = way.project(predicted, x_next)
        size = np.linalg.norm((moved - q) / way.unit)
        miss = np.linalg.norm((moved - predicted) / way.unit)
        if ok and size <= 0.3 and miss <= AGREEMENT * size + BRANCH_ROUNDING:
            q, x = moved, x_next
        elif h <= smallest:
            strand.at, strand.x, strand.end = q, x, x
            return
        else:
            h /= 2
    strand.at, strand.x = q, float(k)
    strand.q.append(q)
