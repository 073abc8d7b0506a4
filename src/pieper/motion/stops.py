"""Why a branch ends, and what else is worth saying about a track: events with a place, a joint and a cause."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.kinematics.joints import TURN, inside
from pieper.kinematics.newton import null_space
from pieper.motion.branches import Strand
from pieper.motion.continuation import SMALLEST_STEP, Continuation
from pieper.tolerances import AT_A_POINT
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
    """

    s: float
    joint: str | None
    cause: str
    stop: bool
    detail: str
    excess: float = 0.0

    def __str__(self) -> str:
        kind = "Stop" if self.stop else "Remark"
        return f"{kind} at s = {self.s:.4f} ({self.cause}{', ' + self.joint if self.joint else ''}): {self.detail}"


def amount(way: Continuation, joint: int, value: float) -> str:
    """Return a joint value with its unit, degrees or millimetres."""
    return f"{np.degrees(value):.2f} deg" if way.revolute[joint] else f"{value * 1e3:.2f} mm"


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


def _limit_place(way: Continuation, q: Array, k: int) -> tuple[int, float]:
    """Return the joint that passes its limit first between points k - 1 and k, and where, by halving."""
    good, outside, at, beyond = k - 1.0, float(k), q[k - 1], q[k]
    if not way.solutions(k - 1)[1]:
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
    if len(way.solutions(just_after)[0]) == 0:
        why = "The path leaves the reach and comes back before the next point."
        if len(way.solutions(after)[0]) == 0:
            why = f"At point {int(after) + 1}: {way.why(after)}"
        return Event(s, name, OUT_OF_REACH, True, f"no branch goes on. {why}")
    if meets is not None:
        return Event(
            s,
            name,
            BRANCH_ENDS,
            True,
            f"it runs into branch {meets + 1} and both end there; {name} would have to turn back.",
        )
    if way.solutions(float(np.round(x)))[1] and abs(x - np.round(x)) < AT_A_POINT:
        return Event(s, name, SINGULARITY, True, f"the path crosses a singularity on which {name} would have to jump.")
    if strand.crossings and x - strand.crossings[-1] < AT_A_POINT:
        return Event(
            s, name, BRANCH_ENDS, True, f"it meets another branch and the way on is not decided; {name} is stiff."
        )
    size = _gap(way, strand.at, just_after)
    return Event(
        s, name, JUMP, True, f"the nearest solution beyond is {size:.3g} (rad, or per metre of arm) away.", size
    )


def _gap(way: Continuation, q: Array, x: float) -> float:
    return float(np.abs(way.gap(way.solutions(x)[0], q)).max(-1).min())


def _stiff_joint(way: Continuation, q: Array) -> int:
    """Return the joint that moves most where the Jacobian at q (n,) is weakest: the one a singularity would spin."""
    return int(np.argmax(np.abs(null_space(way.chain, q)[1][-1])))


def remarks(way: Continuation, q: Array, crossings: list[float]) -> tuple[Event, ...]:
    """Return the remarks on a joint curve q (k, n): singularities it passes, and fast but continuous swings."""
    return (*_passed(way, [x for x in crossings if x <= len(q) - 1]), *_swings(way, q))


def _passed(way: Continuation, crossings: list[float]) -> list[Event]:
    out: list[Event] = []
    runs: list[list[float]] = []
    for x in crossings:
        if runs and x - runs[-1][1] <= 1.0:
            runs[-1][1] = x
        else:
            runs.append([x, x])
    for first, last in runs:
        where = f"at point {first + 1:.6g}" if first == last else f"from point {first + 1:.6g} to point {last + 1:.6g}"
        text = f"{where} the arm is singular; the track passes it without a jump."
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
        text = f"{name} swings {np.degrees(size):.1f} deg between points {k + 1} and {k + 2}, close to a singularity; "
        out.append(Event(_parameter(way, k), name, SINGULARITY, False, text + "the swing is continuous.", float(size)))
    return out
