"""Why a branch ends, and what else is worth saying about a track: events with a place, a joint and a cause."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.kinematics.joints import TURN, inside
from pieper.kinematics.newton import null_space
from pieper.motion.branches import Strand
from pieper.motion.continuation import SMALLEST_STEP, Continuation
from pieper.motion.in_the_way import in_the_way
from pieper.tolerances import AT_A_POINT, SAID_AT_POINT
from pieper.words_by_number import plural

OUT_OF_REACH = "out of reach"
LIMIT = "limit"
SINGULARITY = "singularity"
BRANCH_ENDS = "branch ends"
JUMP = "jump"

#: A joint is said to swing when one step of it is at least this (rad) ...
SWING = np.radians(10.0)
#: ... and this many times its median step.
SWING_RATIO = 5.0
#: Halvings by which the place of a limit is found between two points.
LIMIT_HALVINGS = 20


@dataclass(frozen=True)
class Event:
    """Something that happened on the way.

    Attributes:
        s: Path parameter, 0 to 1.
        joint: Name of the joint it concerns, or None.
        cause: "out of reach", "limit", "singularity", "branch ends" or "jump".
        stop: Whether the track ends here; otherwise it is a remark.
        detail: One sentence with a number.
        excess: Size behind the sentence: rad or m beyond the limit, or of the swing; 0 when there is none.
        metres: How far along the path's positions that is, from its first, m.
        point: The same in points, from 0: 3.5 is half way between the fourth and the fifth.
    """

    s: float
    joint: str | None
    cause: str
    stop: bool
    detail: str
    excess: float = 0.0
    metres: float = 0.0
    point: float = 0.0

    def __str__(self) -> str:
        kind = "Stop" if self.stop else "Remark"
        where = f"s = {self.s:z.4f}, {self.metres * 1e3:z.1f} mm along the path, {_between(self.point)}"
        return f"{kind} at {where} ({self.cause}{', ' + self.joint if self.joint else ''}): {self.detail}"


def _between(point: float) -> str:
    """Return a place among the points in words, counted from 1."""
    nearest = round(point)
    if abs(point - nearest) < SAID_AT_POINT:
        return f"at point {nearest + 1}"
    return f"between points {int(point) + 1} and {int(point) + 2}"


def placed(way: Continuation, event: Event) -> Event:
    """Return an event with its place along the path."""
    point = event.s * (len(way.path) - 1)
    pieces = np.linalg.norm(np.diff(way.path[..., 3], axis=0), axis=1)
    k = min(int(point), max(len(pieces) - 1, 0))
    along = float(pieces[:k].sum() + (point - k) * (pieces[k] if len(pieces) else 0.0))
    return replace(event, metres=along, point=point)


def amount(way: Continuation, joint: int, value: float) -> str:
    """Return a joint value with its unit, degrees or millimetres."""
    return f"{np.degrees(value):z.2f} deg" if way.revolute[joint] else f"{value * 1e3:z.2f} mm"


def _parameter(way: Continuation, x: float) -> float:
    return x / (len(way.path) - 1) if len(way.path) > 1 else 0.0


def limit_stop(way: Continuation, q: Array, k: int) -> Event:
    """Return the event of a curve q (points, n) that is outside a limit at point k for the first time."""
    lower, upper = way.plan.limits[:, 0], way.plan.limits[:, 1]
    beyond = np.maximum(lower - q[k], q[k] - upper)
    where = float(k)
    joint = int(np.argmax(beyond / way.unit))
    if k > 0:
        joint, where = _limit_place(way, q, k)
    side, bound = ("lower", lower[joint]) if q[k][joint] < lower[joint] else ("upper", upper[joint])
    name = way.plan.names[joint]
    if k == 0:
        detail = f"{name} would begin at {amount(way, joint, q[0][joint])}, beyond its {side} limit of "
        detail += amount(way, joint, bound)
    else:
        detail = f"{name} passes its {side} limit of {amount(way, joint, bound)}"
        detail += f"; at point {k + 1} it would be at {amount(way, joint, q[k][joint])}"
    other = _other_turn(way, q, joint)
    if other:
        detail += f". Starting {other} it would stay inside"
    return Event(_parameter(way, where), name, LIMIT, True, detail + ".", float(beyond[joint]))


def limit_stop_between(way: Continuation, q: Array, k: int, where: float) -> Event:
    """Return the event of a curve q (points, n) that is inside at points k - 1 and k, and outside between them."""
    carried, _, _, _ = way.carry(q[k - 1 : k], k - 1.0, where)
    joint, place = _limit_place_by(way, q[k - 1], carried[0], k - 1.0, where)
    value, (lower, upper) = carried[0][joint], way.plan.limits[joint]
    side, bound = ("lower", lower) if value < lower else ("upper", upper)
    excess = float(max(lower - value, value - upper))
    detail = f"{way.plan.names[joint]} passes its {side} limit of {amount(way, joint, bound)} between points {k} and "
    detail += f"{k + 1}, by {amount(way, joint, excess)}, and comes back; at the points themselves it is inside."
    return Event(_parameter(way, place), way.plan.names[joint], LIMIT, True, detail, excess)


def _limit_place(way: Continuation, q: Array, k: int) -> tuple[int, float]:
    """Return the joint that passes its limit first between points k - 1 and k, and where, by halving."""
    return _limit_place_by(way, q[k - 1], q[k], k - 1.0, float(k))


def _limit_place_by(way: Continuation, at: Array, beyond: Array, good: float, outside: float) -> tuple[int, float]:
    """The same between two places of a curve, the first inside and the second outside."""
    if not way.solutions(good)[1]:
        for _ in range(LIMIT_HALVINGS):
            middle = good + (outside - good) / 2
            carried, place, _, _ = way.carry(at[None], good, middle)
            if place[0] != middle:
                break
            if not inside(carried[0], way.plan.limits).all():
                outside, beyond = middle, carried[0]
            else:
                good, at = middle, carried[0]
    past = np.maximum(way.plan.limits[:, 0] - beyond, beyond - way.plan.limits[:, 1]) / way.unit
    return int(np.argmax(past)), outside


def _other_turn(way: Continuation, q: Array, joint: int) -> str:
    """Return which other turn of the start would keep a joint inside all along, in words, or nothing."""
    if not way.revolute[joint] or way.chain.joints.coupled is not None:
        return ""
    for turns in (1, -1, 2, -2):
        moved = q[:, joint, None] + turns * TURN
        if inside(moved, way.plan.limits[joint, None]).all() and len(q) == len(way.path):
            return f"{plural(abs(turns), 'turn')} {'higher' if turns > 0 else 'lower'}"
    return ""


def geometric_stop(way: Continuation, strand: Strand, q: Array, meets: int | None) -> Event:
    """Return the event of a strand that cannot be carried on, its joint curve q (k, n)."""
    x = float(len(q) - 1) if strand.end is None else strand.end
    after = min(float(len(way.path) - 1), max(np.floor(x) + 1, 1.0))
    joint = _stiff_joint(way, strand.at)
    name = way.plan.names[joint]
    s = _parameter(way, x)
    just_after = min(x + SMALLEST_STEP, after)
    if strand.unresolved:
        return Event(s, name, JUMP, True, "the branch could not be followed for certain, however small the steps.")
    standing = in_the_way(way.plan, strand.at)
    if len(way.solutions(just_after)[0]) == 0:
        why = "The path leaves the reach and comes back before the next point."
        if len(way.solutions(after)[0]) == 0:
            why = f"At point {int(after) + 1}: {way.why(after)}{_back_in_reach(way, int(after))}"
        return Event(s, name, OUT_OF_REACH, True, f"no branch goes on: {standing.words}. {why}")
    if meets is not None:
        detail = (
            f"it runs into branch {meets + 1} and both end there: {standing.words}; {name} would have to turn back."
        )
        return Event(s, name, BRANCH_ENDS, True, detail)
    if way.solutions(float(np.round(x)))[1] and abs(x - np.round(x)) < AT_A_POINT:
        detail = f"the path crosses a singularity ({standing.words}) on which {name} would have to jump."
        return Event(s, name, SINGULARITY, True, detail)
    if strand.crossings and x - strand.crossings[-1] < AT_A_POINT:
        return Event(
            s, name, BRANCH_ENDS, True, f"it meets another branch and the way on is not decided; {name} is stiff."
        )
    size = _gap(way, strand.at, just_after)
    return Event(
        s, name, JUMP, True, f"the nearest solution beyond is {size:.3g} (rad, or per metre of arm) away.", size
    )


def _back_in_reach(way: Continuation, k: int) -> str:
    """Return in words where the path comes back into reach after point k (0-based), which is not."""
    for later in range(k + 1, len(way.path)):
        if len(way.solutions(float(later))[0]):
            return f" From point {later + 1} on the path is in reach again."
    return " The rest of the path is out of reach too." if k + 1 < len(way.path) else ""


def _gap(way: Continuation, q: Array, x: float) -> float:
    return float(np.abs(way.gap(way.solutions(x)[0], q)).max(-1).min())


def _stiff_joint(way: Continuation, q: Array) -> int:
    """Return the joint that moves most where the Jacobian at q (n,) is weakest: the one a singularity would spin."""
    return int(np.argmax(np.abs(null_space(way.chain, q)[1][-1])))


def remarks(way: Continuation, q: Array, crossings: list[float]) -> tuple[Event, ...]:
    """Return the remarks on a joint curve q (k, n): singularities it passes itself, and fast but continuous swings."""
    return (*_passed(way, q, [x for x in crossings if x <= len(q) - 1]), *_swings(way, q))


def _at(way: Continuation, q: Array, x: float) -> Array:
    """Return the joint vector (n,) of a curve q (k, n) at x points from its begin, as near as straight lines say."""
    k = min(int(x), len(q) - 1)
    return q[k] if k == x or k + 1 >= len(q) else way.project(q[k] + (x - k) * (q[k + 1] - q[k]), x)[0]


def _passed(way: Continuation, q: Array, crossings: list[float]) -> list[Event]:
    """Remarks on singularities of the branch itself; where only other branches have one, nothing happens to it."""
    out: list[Event] = []
    own = {x: at for x in crossings if way.nearly_singular(at := _at(way, q, x), x)}
    crossings = list(own)
    runs: list[list[float]] = []
    for x in crossings:
        if runs and x - runs[-1][1] <= 1.0:
            runs[-1][1] = x
        else:
            runs.append([x, x])
    for first, last in runs:
        where = f"at point {first + 1:.6g}" if first == last else f"from point {first + 1:.6g} to point {last + 1:.6g}"
        text = f"{where} the arm is singular ({in_the_way(way.plan, own[first]).words}); "
        text += "the track passes it without a jump."
        out.append(Event(_parameter(way, first), None, SINGULARITY, False, text))
    return out


def _swings(way: Continuation, q: Array) -> list[Event]:
    steps = np.abs(np.diff(q, axis=0))
    if len(steps) < 3:
        return []
    out: list[Event] = []
    typical = np.median(steps, axis=0)
    for joint in np.flatnonzero(way.revolute):
        k = int(np.argmax(steps[:, joint]))
        size = steps[k, joint]
        if size < SWING or size < SWING_RATIO * typical[joint]:
            continue
        name = way.plan.names[joint]
        text = f"{name} swings {np.degrees(size):z.1f} deg between points {k + 1} and {k + 2}, close to a singularity; "
        out.append(Event(_parameter(way, k), name, SINGULARITY, False, text + "the swing is continuous.", float(size)))
    return out
