"""What is said about an arm, checked one thing after the other, becomes a Description."""

from __future__ import annotations

import math
import warnings
from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike

from pieper import arguments
from pieper.description.coupling import checked_coupling, linked_axes, numbers_of
from pieper.description.dh import CONVENTIONS, DH, MAX_JOINTS, Actuator, Check, Description, Linked
from pieper.errors import InputError, PieperWarning
from pieper.kinematics.chain import Chain
from pieper.kinematics.meant import remark_long, remark_turned
from pieper.kinematics.pose import PoseLike, checked_pose
from pieper.tolerances import FARTHEST, WHOLE_TURN
from pieper.words_by_number import plural


def describe(
    rows: Sequence[DH],
    *,
    convention: str,
    joint_types: str | None = None,
    limits: Sequence[Sequence[float | None] | None] | ArrayLike | None = None,
    base: PoseLike | None = None,
    tool: PoseLike | None = None,
    name: str = "arm",
    joint_names: Sequence[str] | None = None,
    sign: ArrayLike | None = None,
    offset: ArrayLike | None = None,
    actuator: Actuator | None = None,
    manufacturer: str = "",
    source: str = "",
    notes: str = "",
    departures: Sequence[str] = (),
    postures: Mapping[str, ArrayLike] | None = None,
    checks: Sequence[Check] = (),
    coupling: ArrayLike | None = None,
    tools: Mapping[str, PoseLike] | None = None,
    frames: Mapping[str, PoseLike] | None = None,
    remarks: Sequence[str] = (),
    linked: Sequence[int] | None = None,
) -> Description:
    """Check what was said about an arm and return it as a Description.

    Args:
        rows: DH rows in joint order; a row may also be four numbers a, alpha, d, theta.
        convention: "standard" or "modified"; there is no default on purpose.
        joint_types: Letters R and P, one a row; all revolute when left out.
        limits: One (lower, upper) pair a joint, rad or m; None for a joint or a side without one.
        base: (4, 4) pose before the first row.
        tool: (4, 4) pose after the last row.
        name: Name of the arm.
        joint_names: One name a joint, or one a row; joint_1 ... when left out.
        sign: +1 or -1 a row: the maker's sense.
        offset: rad or m a row: what the table's variable reads at the maker's zero.
        actuator: A tool's own actuator.
        manufacturer: Maker.
        source: Where the numbers come from.
        notes: Anything a user should know.
        departures: Where the numbers depart from their source and why.
        postures: Named joint vectors.
        checks: Known poses.
        coupling: (n, n): values of the table's variables = coupling @ joint values, before sign and offset. More rows
            than columns where a linkage moves axes that have no joint of their own.
        tools: Named poses of other tools, in the table's last frame.
        frames: Named poses of places, in the frame of `base`.
        remarks: What was read differently from a file.
        linked: The rows (0-based) that have no joint of their own; found by the coupling when left out.

    Returns:
        The Description.

    Raises:
        InputError: Something said is impossible; the message names the joint and what is allowed.
    """
    if not isinstance(convention, str) or convention not in CONVENTIONS:
        raise InputError(
            f"convention {arguments.kind_of(convention)} is unknown: say 'standard' (distal DH) or 'modified' "
            "(proximal DH, Craig).",
            given=convention,
            allowed=CONVENTIONS,
        )
    table = tuple(_row(row, index) for index, row in enumerate(arguments.several(rows, "rows", "DH rows")))
    m = len(table)
    if not 1 <= m <= MAX_JOINTS:
        raise InputError(f"an arm has 1 to {MAX_JOINTS} joints, got {m} DH rows.", given=m)
    types = ("R" * m if joint_types is None else str(joint_types)).upper()
    if len(types) != m or set(types) - {"R", "P"}:
        raise InputError(
            f"joint_types {arguments.kind_of(joint_types)} must be {plural(m, 'letter')}, one a DH row: R revolute, P "
            "prismatic.",
            given=joint_types,
        )
    for i, row in enumerate(table):
        if max(abs(row.a), abs(row.d)) > FARTHEST:
            raise InputError(
                f"row {i + 1} of the DH table has a = {row.a:g}, d = {row.d:g}; lengths are metres, at most "
                f"{FARTHEST:g}.",
                row=i,
                given=row,
            )
    n = numbers_of(coupling, m)
    names = tuple(f"joint_{i + 1}" for i in range(n)) if joint_names is None else _words(joint_names, "joint_names")
    if len(names) not in (n, m):
        raise InputError(f"joint_names has {plural(len(names), 'name')} for {plural(n, 'joint')}.", given=names)
    twice = sorted({s for s in names if names.count(s) > 1})
    if twice:
        raise InputError(f"joint name {twice[0]!r} is used twice; names must differ.", joint=twice[0])
    senses = np.ones(m) if sign is None else _vector(sign, m, "sign")
    if not np.all(np.abs(senses) == 1.0):
        raise InputError(f"sign must be +1 or -1 for each joint, got {senses.tolist()}.", given=senses)
    zeros = np.zeros(m) if offset is None else _vector(offset, m, "offset")
    joints = names if len(names) == n else tuple(f"joint_{i + 1}" for i in range(n))
    gears = checked_coupling(coupling, joints, m)
    linked = linked_axes(gears) if linked is None else tuple(linked)
    own = [i for i in range(m) if i not in linked]
    if len(own) != n or (gears is not None and np.linalg.matrix_rank(gears[own]) < n):
        raise InputError(
            f"the coupling speaks of {plural(n, 'joint')}, and {plural(len(own), 'row')} of {m} would have one of its "
            "own: say as linked the rows whose motion follows from the others, and no more.",
            given=linked,
        )
    by_axis = list(names)
    if len(names) < m:
        for i in linked:
            by_axis.insert(i, _free_name(f"axis_{i + 1}", names))
    names, kinds = tuple(by_axis[i] for i in own), "".join(types[i] for i in own)
    for i, row in enumerate(table):
        if max(abs(row.alpha), abs(row.theta)) > 2 * math.pi + WHOLE_TURN:
            warnings.warn(
                f"{by_axis[i]}: alpha = {row.alpha:g}, theta = {row.theta:g} are taken as radians; more than a turn "
                "looks like degrees. Use math.radians(...) if degrees were meant.",
                PieperWarning,
                stacklevel=3,
            )
    bounds = _limits(limits, names, kinds)
    named = {} if postures is None else {k: _vector(v, n, f"posture {k!r}") for k, v in postures.items()}
    return Description(
        name=arguments.text(name, "name"),
        convention=convention,
        rows=table,
        joint_types=kinds,
        joint_names=names,
        limits=_frozen(bounds),
        sign=_frozen(senses),
        offset=_frozen(zeros),
        base=_frozen(np.eye(4) if base is None else checked_pose(base, "base")),
        tool=_frozen(np.eye(4) if tool is None else checked_pose(tool, "tool")),
        actuator=actuator,
        manufacturer=manufacturer,
        source=source,
        notes=notes,
        departures=tuple(departures),
        postures=named,
        checks=tuple(checks),
        coupling=gears,
        linked=tuple(Linked(i, by_axis[i], types[i]) for i in linked),
        tools={str(k): _frozen(checked_pose(T, f"tool {k!r}")) for k, T in (tools or {}).items()},
        frames={str(k): _frozen(checked_pose(T, f"frame {k!r}")) for k, T in (frames or {}).items()},
        remarks=tuple(remarks),
    )


def remark_sizes(arm: Description, chain: Chain) -> None:
    """Warn where millimetres or degrees were probably said."""
    if not remark_long(chain.length, "the links between the joints of this arm add up to"):
        remark_long(float(np.linalg.norm(chain.links[-1][:3, 3])), "the tool stands from the last axis by")
        remark_long(float(np.linalg.norm(arm.base[:3, 3])), "the base stands away by")
    slides = np.array([kind == "P" for kind in arm.axis_types])
    remark_turned(arm.offset[~slides], "offset")
    sliding = arm.limits[[kind == "P" for kind in arm.joint_types]]
    remark_long(float(np.max(np.abs(sliding[np.isfinite(sliding)]), initial=0.0)), "a slide's limits go to")


def _free_name(name: str, taken: Sequence[str]) -> str:
    while name in taken:
        name += "_"
    return name


def _row(row: object, index: int) -> DH:
    if isinstance(row, DH):
        return row
    try:
        values = list(row)  # type: ignore[call-overload]
    except TypeError:
        values = []
    if len(values) != 4:
        raise InputError(
            f"row {index + 1} of the DH table must be a DH(a, alpha, d, theta) or four numbers in that order, "
            f"got {row!r}.",
            row=index,
            given=row,
        )
    return DH(*values)


def _vector(values: ArrayLike, n: int, what: str) -> np.ndarray:
    wanted = f"{plural(n, 'finite number')}, one a joint"
    vector = np.array(arguments.numbers(values, what, wanted))
    if vector.shape != (n,) or not np.all(np.isfinite(vector)):
        raise InputError(f"{what} must be {wanted}, got {values!r}.", given=values, allowed=wanted)
    return vector


def _words(names: object, what: str) -> tuple[str, ...]:
    return tuple(arguments.text(name, f"one of {what}") for name in arguments.several(names, what, "names"))


def _limits(limits: object, names: tuple[str, ...], types: str) -> np.ndarray:
    n = len(names)
    bounds = np.tile([-np.inf, np.inf], (n, 1))
    if limits is None:
        return bounds
    pairs = arguments.several(limits, "limits", "(lower, upper) or None, one a joint")
    if len(pairs) != n:
        raise InputError(
            f"limits has {plural(len(pairs), 'entry', 'entries')} for {plural(n, 'joint')}; give one "
            "(lower, upper) or None a joint.",
            given=limits,
        )
    for i, pair in enumerate(pairs):
        if pair is None:
            continue
        try:
            lower, upper = pair
            lower = -np.inf if lower is None else float(arguments.numbers(lower, "a limit"))
            upper = np.inf if upper is None else float(arguments.numbers(upper, "a limit"))
        except (TypeError, ValueError):
            raise InputError(
                f"limits of {names[i]} must be (lower, upper) or None, got {pair!r}.", joint=names[i], given=pair
            ) from None
        if math.isnan(lower) or math.isnan(upper):
            raise InputError(f"limits of {names[i]} contain NaN: {pair!r}.", joint=names[i], given=pair)
        if lower > upper:
            raise InputError(
                f"limits of {names[i]} are swapped: lower {lower:g} is above upper {upper:g}.",
                joint=names[i],
                given=pair,
            )
        bounds[i] = lower, upper
        finite = [abs(v) for v in (lower, upper) if math.isfinite(v)]
        if types[i] == "R" and finite and max(finite) > 8 * math.pi:
            warnings.warn(
                f"limits of {names[i]} are taken as radians: ({lower:g}, {upper:g}) is more than four turns "
                "and looks like degrees.",
                PieperWarning,
                stacklevel=4,
            )
    return bounds


def _frozen(array: np.ndarray) -> np.ndarray:
    out = np.array(array, dtype=float)
    out.setflags(write=False)
    return out
