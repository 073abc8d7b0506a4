"""What would let a track that stops pass: another start, the tool turned or tilted, the path shifted; each tried."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.kinematics.pose import rotation_about, translation
from pieper.motion.following import followed, passing
from pieper.motion.stops import LIMIT
from pieper.motion.track import Branch, Cure, Track
from pieper.solver.plan.plan import Plan
from pieper.solver.verbs import ik_many

#: Turns (deg) and shifts (mm) that are tried, the least first, each way.
TURNS = (2, 5, 10, 15, 20, 30, 45, 60, 90, 120, 150, 180)
SHIFTS = (2, 5, 10, 20, 35, 50, 75, 100, 150, 200, 300)
#: How often the step between what fails and what passes is halved.
HALVINGS = 3
#: Points with which a change is tried first: one that fails there is not followed through all points.
COARSE = 20
_AXES = np.eye(3)
_TRIED = {
    "tool turned": tuple((TURNS, "deg", axis) for axis in (2,)),
    "tool tilted": tuple((TURNS[:8], "deg", axis) for axis in (0, 1)),
    "path shifted": tuple((SHIFTS, "mm", axis) for axis in (0, 1, 2)),
}


def cures(track: Track) -> tuple[Cure, ...]:
    """Return what lets a track pass that stops, the least change of each kind; empty where nothing tried does.

    Tried are the other branches and other whole turns of the start; the tool turned about its z axis; tilted about its
    x or y axis; the path shifted along an axis of the base. Each is followed from its first point to its last.
    """
    if track.complete:
        return ()
    plan = track.plan
    alone = _start(plan, track)
    found = [alone]
    for kind, ways in _TRIED.items():
        if plan.task == "position" and kind != "path shifted":
            continue
        some = [
            cure
            for amounts, unit, axis in ways
            if (cure := _least(plan, track, kind, amounts, unit, axis, alone is None))
        ]
        found.append(min(some, key=lambda cure: cure.amount, default=None))
    return tuple(cure for cure in found if cure is not None)


# ---------------------------------------------------------------------------------------------- another start


def _start(plan: Plan, track: Track) -> Cure | None:
    """Return the nearest other start from which the same path passes."""
    for q, words in _starts(plan, track):
        again = followed(plan, track.path, start=q)
        if again.complete:
            apart = plan.chain.joints
            amount = float(np.abs((again.q[0] - track.start) / apart.unit).max())
            joints = _joints(plan, again.q[0])
            return Cure("start", f"Start {words}: {joints}.", amount, again.q[0], track.path, again)
    return None


def _starts(plan: Plan, track: Track) -> Iterator[tuple[Array, str]]:
    complete = [b for b in track.branches if b.complete]
    for branch in sorted(complete, key=lambda b: _apart(plan, b, track.start)):
        yield branch.q[0], f"on branch {branch.index + 1} ({branch.label})"
    if track.stop is None or track.stop.cause != LIMIT or track.chosen is None:
        return
    chosen = track.branches[track.chosen]
    if not chosen.points:
        return
    first = chosen.q[0]
    others = plan.chain.joints.first(plan.n).variants(first, plan.limits)
    size = np.abs(others - first).max(1)
    for q in others[np.argsort(size, kind="stable")][1:]:
        yield q, "another whole turn away"


def _apart(plan: Plan, branch: Branch, start: Array) -> float:
    return float(np.abs((branch.q[0] - start) / plan.chain.joints.unit).max())


def _joints(plan: Plan, q: Array) -> str:
    return ", ".join(
        f"{value * 1e3:z.1f} mm" if slides else f"{np.degrees(value):z.1f} deg"
        for value, slides in zip(q, plan.prismatic, strict=True)
    )


# ---------------------------------------------------------------------------------------------- another path


def _changed(path: Array, kind: str, axis: int, amount: float) -> Array:
    """Return poses (N, 4, 4), the tool turned about its own axis (deg) or the path shifted along the base's (mm)."""
    if kind == "path shifted":
        return translation(*(amount / 1000 * _AXES[axis])) @ path
    turn = np.eye(4)
    turn[:3, :3] = rotation_about(_AXES[axis], np.radians(amount))
    return path @ turn


def _least(
    plan: Plan, track: Track, kind: str, amounts: tuple[int, ...], unit: str, axis: int, others: bool
) -> Cure | None:
    """Return the least of some changes that lets the path pass, made smaller by halving.

    From the branch the track began on if any change does; from another start only where no start alone is a cure, and
    then it is a part of this one.
    """
    for own in (True, False) if others else (True,):
        if cure := _least_from(plan, track, kind, amounts, unit, axis, own):
            return cure
    return None


def _least_from(
    plan: Plan, track: Track, kind: str, amounts: tuple[int, ...], unit: str, axis: int, own: bool
) -> Cure | None:
    failed = 0.0
    for size in amounts:
        for amount in (float(size), -float(size)):
            start = _start_that_passes(plan, track, _changed(track.path, kind, axis, amount), own)
            if start is None:
                continue
            least, passes = np.copysign(failed, amount), amount
            for _ in range(HALVINGS):
                middle = _rounded(least + (passes - least) / 2)
                if middle in (least, passes):
                    break
                better = _start_that_passes(plan, track, _changed(track.path, kind, axis, middle), own)
                if better is None:
                    least = middle
                else:
                    passes, start = middle, better
            if cure := _followed(plan, track, kind, axis, passes, unit, start, own):
                return cure
        failed = float(size)
    return None


def _rounded(amount: float) -> float:
    return float(np.sign(amount) * np.ceil(np.abs(amount)))


def _start_that_passes(plan: Plan, track: Track, path: Array, own: bool) -> Array | None:
    """Return the start nearest to the track's from which a branch passes a path; None where there is none.

    Args:
        plan: How the arm is solved.
        track: The track that stops.
        path: (N, 4, 4) the changed path.
        own: Only the branch that begins nearest to where the arm is counts.
    """
    # where the track stops first: one pose tells most changes off, and each of a short arm may cost a careful look
    stopped = path[min(track.points, len(path) - 1)]
    if not ik_many(plan, stopped[None], 1).in_limits.any() or not ik_many(plan, path, 1).in_limits.any(1).all():
        return None
    step = -(-len(path) // COARSE)
    if step > 1 and passing(plan, path[::step], track.start, nearest=own) is None:
        return None
    return passing(plan, path, track.start, nearest=own)


def _followed(
    plan: Plan, track: Track, kind: str, axis: int, amount: float, unit: str, start: Array, own: bool
) -> Cure | None:
    """Return a change as a cure once more followed from its start to its end; None where that fails."""
    path = _changed(track.path, kind, axis, amount)
    again = followed(plan, path, start=start)
    if not again.complete:
        return None
    words = _SAID[kind](amount, unit, "xyz"[axis])
    if not own:
        label = again.branches[again.chosen or 0].label
        words += f", starting {f'{label}: ' if label else 'at '}{_joints(plan, again.q[0])}"
    si = np.radians(abs(amount)) if unit == "deg" else abs(amount) / 1000
    return Cure(kind, words + ".", float(si), again.q[0], path, again)


_SAID: dict[str, Callable[[float, str, str], str]] = {
    "tool turned": lambda amount, unit, name: f"Turn the tool by {amount:+.3g} {unit} about its own {name} axis",
    "tool tilted": lambda amount, unit, name: f"Tilt the tool by {amount:+.3g} {unit} about its own {name} axis",
    "path shifted": lambda amount, unit, name: f"Shift the path by {amount:+.4g} {unit} along the base's {name} axis",
}
