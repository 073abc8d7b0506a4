"""An arm changed into another: tool, base, limits, held joints, the other DH convention, seen from the other end."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TypeVar

import numpy as np
import numpy.typing as npt

from pieper import arguments
from pieper.description.carry import carried
from pieper.description.commonnormal import standard_table
from pieper.description.dh import CONVENTIONS, DH, Check, Description
from pieper.description.fold import chain_of
from pieper.description.said import describe
from pieper.errors import InputError
from pieper.kinematics.meant import remark_long, remark_turned
from pieper.kinematics.pose import PoseLike, checked_pose, inverse, rotation_x
from pieper.tolerances import LIMIT_SLACK, ROUNDING

_T = TypeVar("_T")


def with_tool(arm: Description, tool: PoseLike | str) -> Description:
    """Return the arm with another tool: a pose in the table's last frame, or the name of one of the arm's tools."""
    if isinstance(tool, str):
        if tool not in arm.tools:
            known = f"it has {', '.join(arm.tools)}" if arm.tools else "it has none by name; give a pose"
            raise InputError(f"{arm.name} has no tool {tool!r}: {known}.", given=tool, allowed=list(arm.tools))
        tool = arm.tools[tool]
    placed = checked_pose(tool, "tool")
    remark_long(float(np.linalg.norm(placed[:3, 3])), "the tool reaches")
    # check poses are those of the old tool
    return replace(arm, tool=_frozen(placed), checks=(), origin=None)


def with_base(arm: Description, base: PoseLike) -> Description:
    """Return the arm whose table begins at another pose of the world."""
    placed = checked_pose(base, "base")
    remark_long(float(np.linalg.norm(placed[:3, 3])), "the base stands away by")
    return replace(arm, base=_frozen(placed), checks=(), origin=None)


def with_limits(arm: Description, limits: Mapping[str, Sequence[float | None] | None]) -> Description:
    """Return the arm with other limits of some joints, rad or m.

    Args:
        arm: The arm.
        limits: Joint name -> (lower, upper); None for no limit, of one side or of both.
    """
    pairs: list[Sequence[float | None] | None] = [tuple(pair) for pair in arm.limits]
    for index, pair in _by_joint(arm, limits, "limits").items():
        pairs[index] = pair
    return _described_anew(arm, limits=pairs)


def uncoupled(arm: Description) -> Description:
    """Return the arm by its axes' own values, each joint moving one axis; the same where no joint is coupled.

    Limits of a joint stay where it alone moves its axis and no other joint does; those of coupled joints are no limits
    of single axes and are left out. Postures are kept.
    """
    if arm.coupling is None:
        return arm
    free = arm.by_axes()
    limits = np.array(free.limits)
    for joint, axis in enumerate(arm.own_axes):
        if np.array_equal(arm.coupling[axis], np.eye(arm.n)[joint]):
            limits[axis] = arm.limits[joint]
    return replace(free, limits=_frozen(limits))


def with_joints_locked(arm: Description, values: Mapping[str, float]) -> Description:
    """Return the arm with some joints held at values (rad or m); the others keep name, zero, sense and limits.

    Raises:
        InputError: No such joint, a value that is not finite or outside the joint's limits, no joint left, or another
            joint moves a held one's axis.
    """
    held = {
        index: arguments.number(value, f"the value {arm.joint_names[index]} is held at", "rad or m")
        for index, value in _by_joint(arm, values, "locked joints").items()
    }
    free = [i for i in range(arm.n) if i not in held]
    if not free:
        raise InputError("every joint would be held; an arm has at least one that moves.", given=dict(values))
    for i, value in held.items():
        _within_limits(arm, i, value)
    if not held:
        return arm
    axes = len(arm.rows)
    C = np.eye(arm.n) if arm.coupling is None else arm.coupling
    for i in held:
        movers = [arm.joint_names[j] for j in free if C[arm.own_axes[i], j] != 0.0]
        if movers:
            raise InputError(
                f"{arm.joint_names[i]} cannot be held: by the coupling its axis also moves with {', '.join(movers)}.",
                joint=arm.joint_names[i],
            )
    q = np.array([held.get(i, 0.0) for i in range(arm.n)])
    constants = C @ q
    # the chain in which only the free joints move: their axes where the held values put them
    still = [i for i in range(axes) if not C[i, free].any()]
    moving = [i for i in range(axes) if i not in still]
    chain = chain_of(replace(arm.by_axes(), sign=np.ones(axes), offset=np.zeros(axes)))
    start = arm.offset + arm.sign * constants
    for i in reversed(still):
        chain = chain.locked(i, float(start[i]))
    table = standard_table(chain.axes, chain.points, chain.home)
    kept = describe(
        table.rows,
        convention="standard",
        joint_types="".join(arm.axis_types[i] for i in moving),
        joint_names=[arm.axis_names[i] for i in moving],
        linked=[moving.index(axis.at) for axis in arm.linked if axis.at in moving],
        limits=arm.limits[free],
        sign=arm.sign[moving].tolist(),
        offset=(arm.offset[moving] + arm.sign[moving] * constants[moving]).tolist(),
        base=table.base,
        tool=table.tool,
        coupling=C[np.ix_(moving, free)],
        name=arm.name,
        manufacturer=arm.manufacturer,
        source=arm.source,
        notes=arm.notes,
        departures=arm.departures,
        postures={name: q[free] for name, q in arm.postures.items() if _agrees(q, held)},
        frames=arm.frames,
        actuator=arm.actuator,
        remarks=(*arm.remarks, *_held_words(arm, held)),
    )
    # named tools stand in the old table's last frame
    moved = {name: table.tool @ inverse(arm.tool) @ T for name, T in arm.tools.items()}
    bodies = carried(
        arm, kept, q, np.zeros(len(free)), lambda k: len(moving) + 1 if k > axes else sum(i < k for i in moving)
    )
    kept = replace(kept, bodies=bodies, allowed=arm.allowed, tools={k: _frozen(T) for k, T in moved.items()})
    return to_convention(kept, arm.convention)


def to_convention(arm: Description, convention: str) -> Description:
    """Return the same arm with its table in the other DH convention; every number is kept, none computed anew."""
    arguments.word(convention, "convention", CONVENTIONS)
    if convention == arm.convention:
        return arm
    a, alpha = [row.a for row in arm.rows], [row.alpha for row in arm.rows]
    if convention == "modified":
        a, alpha, first, last = [0.0, *a[:-1]], [0.0, *alpha[:-1]], np.eye(4), _link(a[-1], alpha[-1])
    else:
        a, alpha, first, last = [*a[1:], 0.0], [*alpha[1:], 0.0], _link(a[0], alpha[0]), np.eye(4)
    rows = tuple(DH(x, angle, row.d, row.theta) for x, angle, row in zip(a, alpha, arm.rows, strict=True))
    other = replace(
        arm,
        convention=convention,
        rows=rows,
        base=_frozen(arm.base @ first),
        tool=_frozen(last @ arm.tool),
        tools={name: _frozen(last @ T) for name, T in arm.tools.items()},
    )
    return replace(other, bodies=carried(arm, other, np.zeros(arm.n), np.zeros(arm.n)), unmeasured=None)


def reversed_arm(arm: Description) -> Description:
    """Return the arm seen from its tool, joints last to first: its pose is the inverse of the arm's."""
    # the inverse of a standard table is a modified one with every number's sign turned, and the other way round
    rows = tuple(DH(0.0 - row.a, 0.0 - row.alpha, 0.0 - row.d, 0.0 - row.theta) for row in arm.rows[::-1])
    other = "modified" if arm.convention == "standard" else "standard"
    whole = [check for check in arm.checks if np.isfinite(check.T).all()]
    turned = replace(
        arm,
        name=f"{arm.name} reversed",
        convention=other,
        rows=rows,
        joint_types=arm.joint_types[::-1],
        joint_names=arm.joint_names[::-1],
        linked=tuple(replace(axis, at=len(rows) - 1 - axis.at) for axis in arm.linked[::-1]),
        limits=_frozen(arm.limits[::-1]),
        sign=_frozen(-arm.sign[::-1]),
        offset=_frozen(-arm.offset[::-1] + 0.0),
        base=_frozen(inverse(arm.tool)),
        tool=_frozen(inverse(arm.base)),
        coupling=None if arm.coupling is None else _frozen(arm.coupling[::-1, ::-1]),
        postures={name: np.asarray(q)[::-1].copy() for name, q in arm.postures.items()},
        checks=tuple(Check(check.q[::-1].copy(), inverse(check.T), check.source, check.tolerance) for check in whole),
        tools={},
        frames={},
        actuator=None,
        origin=None,
    )
    q = np.zeros(arm.n)
    at_zero = chain_of(arm).native.fk(q)
    bodies = carried(arm, turned, q, q, lambda k: max(len(rows) - k, 0), inverse(at_zero))
    return to_convention(replace(turned, bodies=bodies, unmeasured=None), arm.convention)


def _described_anew(arm: Description, **changes: object) -> Description:
    said = {
        "convention": arm.convention,
        "joint_types": arm.axis_types,
        "joint_names": arm.axis_names,
        "coupling": arm.coupling,
        "linked": [axis.at for axis in arm.linked],
        "limits": arm.limits,
    } | changes
    checked = describe(arm.rows, **said)  # type: ignore[arg-type]
    return replace(arm, limits=checked.limits)


def _by_joint(arm: Description, said: Mapping[str, _T], what: str) -> dict[int, _T]:
    """Return what was said by joint name, by the joints' indices."""
    if not isinstance(said, Mapping):
        raise InputError(f"{what} must be a dict from joint names, got {type(said).__name__}.", given=said)
    unknown = [name for name in said if name not in arm.joint_names]
    if unknown:
        raise InputError(
            f"{what}: {arm.name} has no joint {unknown[0]!r}; its joints are {', '.join(arm.joint_names)}.",
            given=unknown[0],
            allowed=arm.joint_names,
        )
    return {arm.joint_names.index(name): value for name, value in said.items()}


def _within_limits(arm: Description, joint: int, value: float) -> None:
    """Refuse a value at which a joint cannot be held, and say what was probably meant."""
    (lower, upper), name = arm.limits[joint], arm.joint_names[joint]
    turns = arm.joint_types[joint] == "R"
    if lower - LIMIT_SLACK <= value <= upper + LIMIT_SLACK:
        if turns:
            remark_turned(value, f"{name}, held,")
        return
    meant, unit = (np.radians(value), "rad") if turns else (value / 1000, "m")
    hint = ""
    if lower <= meant <= upper:
        hint = f" If {value:g} {'degrees' if turns else 'mm'} was meant, write {meant:.6g}."
    raise InputError(
        f"{name} cannot be held at {value:g} {unit}: it is outside its limits {lower:g} to {upper:g} {unit}.{hint} "
        "Wider limits are set by with_limits.",
        joint=name,
        given=value,
        allowed=(float(lower), float(upper)),
    )


def _agrees(q: npt.NDArray[np.float64], held: dict[int, float]) -> bool:
    return all(abs(q[i] - value) <= ROUNDING for i, value in held.items())


def _held_words(arm: Description, held: dict[int, float]) -> list[str]:
    return [
        f"{arm.joint_names[i]} is held at {value:.6g} {'rad' if arm.joint_types[i] == 'R' else 'm'}."
        for i, value in sorted(held.items())
    ]


def _link(a: float, alpha: float) -> npt.NDArray[np.float64]:
    T = rotation_x(alpha)
    T[0, 3] = a
    return T


def _frozen(array: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    out = np.array(array, float)
    out.setflags(write=False)
    return out
