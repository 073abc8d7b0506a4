"""The joints between two links of a robot's tree, written as an arm: axes at zero, limits, couplings, remarks."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from pieper.description.axes import described_by_axes
from pieper.description.dh import Description, Origin
from pieper.description.ends import Ends, find_ends
from pieper.description.fold import chain_of
from pieper.description.said import remark_sizes
from pieper.description.tree import MOVING, Joint, Tree, has_range, some
from pieper.errors import InputError
from pieper.tolerances import LIMIT_IS_NONE, SAME_AXIS_LINE

MISSING = ("refuse", "unlimited")
#: Lower and upper limit, None on a side without one.
Pair: TypeAlias = "tuple[float | None, float | None]"


@dataclass(slots=True, eq=False)
class _Axis:
    """A moving joint of the chain: its line at zero, its sense, and what its value is of the joints' numbers."""

    joint: Joint
    direction: npt.NDArray[np.float64]
    point: npt.NDArray[np.float64]


def arm_of(
    tree: Tree, *, base: str | None = None, tip: str | None = None, missing_limits: str = "refuse"
) -> Description:
    """Return the arm between two links of a robot.

    Args:
        tree: The robot.
        base: Link whose frame is the base; the root of the tree when left out.
        tip: Link whose frame is the tool; the one end of the arm when left out.
        missing_limits: "refuse" a joint without a range, or take it as "unlimited".

    Raises:
        InputError: There is no such arm, or more than one; the message lists the choices, or names joint and cure.
    """
    if missing_limits not in MISSING:
        raise InputError(
            f"missing_limits {missing_limits!r} is unknown: say 'refuse' or 'unlimited'.",
            given=missing_limits,
            allowed=MISSING,
        )
    ends = find_ends(tree, base, tip)
    path = tree.path(ends.base, ends.tip)
    _check_kinds(tree, path, ends)
    axes, home = _axes(tree, path)
    if not axes:
        raise InputError(
            f"{tree.file}: no moving joint between {ends.base!r} and {ends.tip!r}.", base=ends.base, tip=ends.tip
        )
    lines, coupling, constants, notes = _coupled(tree, axes)
    own = [axis.joint for axis in lines if axis.joint.mimic is None]
    limits, noted = _all_limits(tree, own, missing_limits)
    limits, narrowed = _with_followers(tree, own, limits, [axis.joint for axis in axes if axis.joint.mimic])
    arm = described_by_axes(
        np.array([axis.direction for axis in lines]),
        np.array([axis.point for axis in lines]),
        home,
        joint_types="".join(MOVING[axis.joint.kind] for axis in lines),
        joint_names=[axis.joint.name for axis in lines],
        linked=[i for i, axis in enumerate(lines) if axis.joint.mimic is not None],
        limits=limits,
        offset=constants,
        coupling=coupling,
        name=tree.name,
        source=f"{tree.format} {Path(tree.file).name}, from {ends.base} to {ends.tip}",
        remarks=(*ends.notes, *notes, *noted, *narrowed, *tree.remarks([joint for joint, _ in path])),
        postures={"zero": np.zeros(len(own))}
        | {name: np.array([values[joint.name] for joint in own]) for name, values in tree.postures.items()},
    )
    remark_sizes(arm, chain_of(arm))
    return replace(arm, origin=Origin(str(tree.file), tree.format, ends.base, ends.tip))


def _check_kinds(tree: Tree, path: list[tuple[Joint, bool]], ends: Ends) -> None:
    for joint, _ in path:
        if joint.bound:
            tree.fail(
                f"joint {joint.name!r} {joint.bound}; joints of an arm are tied by sums of their values alone. End the "
                f"arm before it with tip={joint.parent!r}, or take the constraint out to move it by itself.",
                joint,
                base=ends.base,
                tip=ends.tip,
            )
        if joint.kind not in MOVING and joint.kind != "fixed":
            if (small := joint.kind.strip().lower()) in (*MOVING, "fixed"):
                tree.fail(f"joint {joint.name!r} is of type {joint.kind!r}: write {small!r}.", joint)
            tree.fail(
                f"joint {joint.name!r} is of type {joint.kind!r}; a serial arm may have revolute, continuous, "
                f"prismatic and fixed joints. Begin after it with base={joint.child!r}, or end before it with "
                f"tip={joint.parent!r}.",
                joint,
                base=ends.base,
                tip=ends.tip,
            )


def _axes(tree: Tree, path: list[tuple[Joint, bool]]) -> tuple[list[_Axis], npt.NDArray[np.float64]]:
    """Return the axes of the moving joints and the pose of the tip, all joints at zero, in the base's frame."""
    T, axes = np.eye(4), []
    for joint, upward in path:
        origin, axis = tree.geometry(joint)
        if not upward:
            T = T @ origin
        if joint.moves:
            axes.append(_Axis(joint, T[:3, :3] @ (-axis if upward else axis), T[:3, 3].copy()))
        if upward:
            T = T @ _inverse(origin)
    return axes, T


def _inverse(T: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    out = np.eye(4)
    out[:3, :3] = T[:3, :3].T
    out[:3, 3] = -T[:3, :3].T @ T[:3, 3]
    return out


def _coupled(
    tree: Tree, axes: list[_Axis]
) -> tuple[list[_Axis], npt.NDArray[np.float64] | None, list[float], list[str]]:
    """Return the axes of the arm, the coupling, the constants it adds, and sentences.

    A joint that mimics another one is folded into a neighbour on the same line (a slide: in the same direction), where
    only the sum of the two moves anything. About an axis of its own it is one that a linkage moves.
    """
    index = {axis.joint.name: k for k, axis in enumerate(a for a in axes if a.joint.mimic is None)}
    into = [at if axis.joint.mimic is None else _neighbour(axes, at) for at, axis in enumerate(axes)]
    lines = [axis for at, axis in enumerate(axes) if into[at] == at]
    row_of = {at: row for row, at in enumerate(at for at in range(len(axes)) if into[at] == at)}
    C, constants, notes = np.zeros((len(lines), len(index))), [0.0] * len(lines), []
    for at, axis in enumerate(axes):
        row, neighbour = row_of[into[at]], axes[into[at]]
        if axis.joint.mimic is None:
            C[row, index[axis.joint.name]] += 1.0
            continue
        master, multiplier, offset = _master(tree, axis.joint)
        if master not in index:
            tree.fail(
                f"joint {axis.joint.name!r} mimics {axis.joint.mimic.joint!r} and {master!r} is not between base and "
                f"tip. End the arm before it with tip={axis.joint.parent!r}, or take the <mimic> out to move it by "
                "itself.",
                axis.joint,
            )
        sense = 1.0 if axis.direction @ neighbour.direction > 0 else -1.0
        C[row, index[master]] += sense * multiplier
        constants[row] += sense * offset
        name, other = axis.joint.name, axis.joint.mimic.joint
        if neighbour is axis:
            notes.append(f"Joint {name!r} mimics {other!r} about an axis of its own: a linkage moves it.")
        elif neighbour.joint.mimic is None:
            on = neighbour.joint.name
            notes.append(f"Joint {name!r} mimics {other!r} on the axis of {on!r}: the two are one coupled joint.")
        else:
            notes.append(f"Joint {name!r} mimics {other!r} on the axis of {neighbour.joint.name!r}, which does too.")
    for name, k in index.items():
        if not C[:, k].any():
            tree.fail(
                f"joint {name!r} moves nothing: the joints that mimic it on its axis undo it. Correct their "
                "multipliers, or end the arm before it.",
                next(axis.joint for axis in lines if axis.joint.name == name),
            )
    return lines, (C if notes else None), constants, notes


def _neighbour(axes: list[_Axis], at: int) -> int:
    """Return the place of the joint that a mimic joint is folded into: on the same line, all joints between on it too.

    The nearest with a number of its own, or else the first of those that have none.
    """
    alike = at
    for step in (1, -1):
        i = at + step
        while 0 <= i < len(axes) and _one_line(axes[at], axes[i]):
            if axes[i].joint.mimic is None:
                return i
            alike = min(alike, i)
            i += step
    return alike


def _one_line(a: _Axis, b: _Axis) -> bool:
    kinds = MOVING[a.joint.kind], MOVING[b.joint.kind]
    if kinds[0] != kinds[1] or np.abs(np.cross(a.direction, b.direction)).max() > SAME_AXIS_LINE:
        return False
    return kinds[0] == "P" or bool(np.abs(np.cross(b.point - a.point, a.direction)).max() <= SAME_AXIS_LINE)


def _master(tree: Tree, joint: Joint) -> tuple[str, float, float]:
    """Return the joint with a number of its own that a mimic joint follows, and value = multiplier * it + offset."""
    by_name = {other.name: other for other in tree.joints}
    multiplier, offset, name, seen = 1.0, 0.0, joint.name, {joint.name}
    at = joint
    while at.mimic is not None:
        for value, what in ((at.mimic.multiplier, "multiplier"), (at.mimic.offset, "offset")):
            if not math.isfinite(value):
                tree.fail(f"the {what} of the mimic joint {at.name!r} is not a finite number.", at)
        offset += multiplier * at.mimic.offset
        multiplier *= at.mimic.multiplier
        name = at.mimic.joint
        if name in seen or name not in by_name:
            in_turn = name in seen and name != at.name
            why = "which mimics it in turn" if in_turn else "which is not another joint of this file"
            tree.fail(
                f"joint {at.name!r} mimics {name!r}, {why}. "
                f"Correct the name, or take the <mimic> out to move {at.name!r} by itself.",
                at,
            )
        seen.add(name)
        at = by_name[name]
    return name, multiplier, offset


def _all_limits(tree: Tree, joints: list[Joint], missing: str) -> tuple[list[Pair], list[str]]:
    limits, silent, endless = [], [], []
    for joint in joints:
        if not has_range(joint):
            if missing == "refuse":
                said = "needs limits (lower, upper)" if joint.upper is None else "cannot move: its limits are 0 and 0"
                tree.fail(
                    f"joint {joint.name!r} is {joint.kind} and {said}. "
                    "Write its limits into the file, or load it with missing_limits='unlimited'.",
                    joint,
                )
            silent.append(joint.name)
            limits.append((None, None))
            continue
        pair = _limits(tree, joint)
        limits.append(pair)
        if joint.kind != "continuous" and any(
            said is None and math.isfinite(value or 0.0)
            for said, value in zip(pair, (joint.lower, joint.upper), strict=True)
        ):
            endless.append(joint.name)
    notes = []
    if silent:
        notes.append(f"No range is given for {some(silent)}: taken as unlimited.")
    if endless:
        notes.append(f"Limits beyond {LIMIT_IS_NONE:g} were taken as none: {some(endless)}.")
    return limits, notes


def _with_followers(
    tree: Tree, own: list[Joint], limits: list[Pair], followers: list[Joint]
) -> tuple[list[Pair], list[str]]:
    """Return limits at which the joints that follow others stay inside their own, and a sentence for each change."""
    limits, notes = list(limits), []
    at = {joint.name: i for i, joint in enumerate(own)}
    for follower in followers:
        leader, multiplier, offset = _master(tree, follower)
        if follower.kind == "continuous" or not has_range(follower) or not multiplier:
            continue
        lower, upper = _limits(tree, follower)
        sides = -math.inf if lower is None else lower, math.inf if upper is None else upper
        low, high = sorted((side - offset) / multiplier for side in sides)
        was = limits[at[leader]]
        both = max(low, -math.inf if was[0] is None else was[0]), min(high, math.inf if was[1] is None else was[1])
        if not both[0] < both[1]:
            notes.append(
                f"No value of {leader!r} keeps {follower.name!r}, which mimics it, inside its own limits: those of "
                f"{follower.name!r} were left out."
            )
            continue
        now = both[0] if math.isfinite(both[0]) else None, both[1] if math.isfinite(both[1]) else None
        if now != was:
            limits[at[leader]] = now
            notes.append(
                f"The limits of {leader!r} are {_span(now)} (the file's own: {_span(was)}): beyond, {follower.name!r}, "
                "which mimics it, would leave its own."
            )
    return limits, notes


def _span(pair: Pair) -> str:
    """Return limits in words."""
    low, high = (("none" if value is None else f"{value:.6g}") for value in pair)
    return f"{low} to {high}"


def _limits(tree: Tree, joint: Joint) -> tuple[float | None, float | None]:
    if joint.kind == "continuous":
        return None, None
    # what a file leaves out on one side is zero there
    lower, upper = joint.lower or 0.0, joint.upper or 0.0
    for value in (lower, upper):
        if math.isnan(value):
            tree.fail(f"a limit of joint {joint.name!r} is not a number: write lower and upper in rad or m.", joint)
    if lower > upper:
        tree.fail(
            f"the limits of joint {joint.name!r} are swapped: {lower:g} is above {upper:g}. Write the smaller one as "
            "the lower limit; what a file leaves out on one side is 0.",
            joint,
        )
    return (None if lower < -LIMIT_IS_NONE else lower), (None if upper > LIMIT_IS_NONE else upper)
