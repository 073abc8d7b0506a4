"""A DH table and everything else one says about an arm, as plain frozen data."""

from __future__ import annotations

import math
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt
from numpy.typing import ArrayLike

from pieper import arguments
from pieper.description.coupling import checked_coupling, moved_by
from pieper.description.shapes import Body, Unmeasured
from pieper.errors import InputError, PieperWarning
from pieper.kinematics.pose import PoseLike, checked_pose
from pieper.tolerances import TYPED_DIGITS, WHOLE_TURN
from pieper.words_by_number import plural

CONVENTIONS = ("standard", "modified")
MAX_JOINTS = 60


_COLUMNS = {"a": "m", "alpha": "rad", "d": "m", "theta": "rad"}


@dataclass(frozen=True, slots=True)
class DH:
    """One row of a DH table, columns in the order a, alpha, d, theta.

    In the modified (Craig) convention the row stores a_{i-1} and alpha_{i-1}. The column of the joint variable holds
    its constant part: `theta` of a revolute joint, `d` of a prismatic one.

    Args:
        a: Link length, m.
        alpha: Link twist, rad.
        d: Joint offset along z, m.
        theta: Joint angle about z, rad.
    """

    a: float = 0.0
    alpha: float = 0.0
    d: float = 0.0
    theta: float = 0.0

    def __post_init__(self) -> None:
        for name in ("a", "alpha", "d", "theta"):
            object.__setattr__(self, name, arguments.number(getattr(self, name), f"DH {name}", _COLUMNS[name]))


@dataclass(frozen=True, slots=True)
class Actuator:
    """A tool's own actuator, a gripper for one: it has a value and limits and moves no frame."""

    name: str
    lower: float
    upper: float
    value: float
    unit: str


@dataclass(frozen=True, slots=True, eq=False)
class Check:
    """A pose that is known from elsewhere, to test the table against.

    Args:
        q: Joint vector (n,), rad or m.
        T: Pose (4, 4) of the tool in the base frame; entries the source does not give are NaN.
        source: Where the numbers come from.
        tolerance: How well the source's digits can hold, in the unit of the entry.
    """

    q: np.ndarray
    T: np.ndarray
    source: str
    tolerance: float = TYPED_DIGITS


@dataclass(frozen=True, slots=True)
class Origin:
    """The robot file of another format that an arm was read from, as long as nothing about the arm was changed.

    Args:
        file: Its path.
        kind: "URDF" or "MJCF".
        base: Link or body the chain begins at.
        tip: Link, body or site it ends at.
    """

    file: str
    kind: str
    base: str
    tip: str


@dataclass(frozen=True, slots=True, eq=False)
class Description:
    """Everything that is said about an arm before any mathematics.

    The joint variable is theta_i = row.theta + sign_i v_i + offset_i (revolute) or d_i = row.d + sign_i v_i + offset_i
    (prismatic), with v = coupling @ q (v = q where joints are not coupled): `sign` and `offset` are the maker's sense
    and zero; limits are limits of q.

    Args:
        name: Name of the arm.
        convention: "standard" (distal) or "modified" (proximal, Craig).
        rows: One DH row a joint.
        joint_types: One letter a joint, R or P.
        joint_names: One name a joint.
        limits: (n, 2), rad or m; infinite where there is none.
        sign: (n,) of +1 or -1.
        offset: (n,), rad or m.
        base: (4, 4) pose of the DH table's first frame.
        tool: (4, 4) pose of the tool in the table's last frame.
        departures: Where the numbers depart from their source, one sentence each with its reason.
        postures: Named joint vectors (n,).
        checks: Known poses.
        coupling: (n, n), None where every joint moves its own row alone.
        tools: Named poses (4, 4) of other tools, in the table's last frame as `tool` is.
        frames: Named poses (4, 4) of places, in the frame in which `base` is.
        remarks: What was read differently from the file the arm came from, in sentences.
        origin: The URDF or MJCF that others can read too; None for any other arm.
        bodies: What the arm is made of; empty where nothing is known.
        allowed: Pairs of names of bodies that may touch, beside neighbours.
        unmeasured: Where bodies are to be had, when there are none yet.
        payload: What the maker says the arm carries, kg; None where it is not known.
        reach: How far the maker says the arm reaches, m; None where it is not known.
    """

    name: str
    convention: str
    rows: tuple[DH, ...]
    joint_types: str
    joint_names: tuple[str, ...]
    limits: np.ndarray
    sign: np.ndarray
    offset: np.ndarray
    base: np.ndarray
    tool: np.ndarray
    actuator: Actuator | None = None
    manufacturer: str = ""
    source: str = ""
    notes: str = ""
    departures: tuple[str, ...] = ()
    postures: dict[str, np.ndarray] = field(default_factory=dict)
    checks: tuple[Check, ...] = ()
    coupling: npt.NDArray[np.float64] | None = None
    tools: dict[str, npt.NDArray[np.float64]] = field(default_factory=dict)
    frames: dict[str, npt.NDArray[np.float64]] = field(default_factory=dict)
    remarks: tuple[str, ...] = ()
    origin: Origin | None = None
    bodies: tuple[Body, ...] = ()
    allowed: tuple[tuple[str, str], ...] = ()
    unmeasured: Unmeasured | None = None
    payload: float | None = None
    reach: float | None = None

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.rows)

    def moved_by(self, joint: int, names: Sequence[str] = (), *, signed: bool = False) -> str:
        """Return what moves the axis of a joint (0-based) in words, "q2 + q3", with the maker's sense where signed."""
        row = np.eye(self.n)[joint] if self.coupling is None else self.coupling[joint]
        names = names or [f"q{k + 1}" for k in range(self.n)]
        return moved_by(row, names, float(self.sign[joint]) if signed else 1.0)


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
) -> Description:
    """Check what was said about an arm and return it as a Description.

    Args:
        rows: DH rows in joint order; a row may also be four numbers a, alpha, d, theta.
        convention: "standard" or "modified"; there is no default on purpose.
        joint_types: Letters R and P, one a joint; all revolute when left out.
        limits: One (lower, upper) pair a joint, rad or m; None for a joint or a side without one.
        base: (4, 4) pose before the first row.
        tool: (4, 4) pose after the last row.
        name: Name of the arm.
        joint_names: One name a joint; joint_1 ... when left out.
        sign: +1 or -1 a joint: the maker's sense.
        offset: rad or m a joint: what the table's variable reads at the maker's zero.
        actuator: A tool's own actuator.
        manufacturer: Maker.
        source: Where the numbers come from.
        notes: Anything a user should know.
        departures: Where the numbers depart from their source and why.
        postures: Named joint vectors.
        checks: Known poses.
        coupling: (n, n): values of the table's variables = coupling @ joint values, before sign and offset.
        tools: Named poses of other tools, in the table's last frame.
        frames: Named poses of places, in the frame of `base`.
        remarks: What was read differently from a file.

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
    n = len(table)
    if not 1 <= n <= MAX_JOINTS:
        raise InputError(f"an arm has 1 to {MAX_JOINTS} joints, got {n} DH rows.", given=n)
    types = ("R" * n if joint_types is None else str(joint_types)).upper()
    if len(types) != n or set(types) - {"R", "P"}:
        raise InputError(
            f"joint_types {arguments.kind_of(joint_types)} must be {plural(n, 'letter')}, one a DH row: R revolute, P "
            "prismatic.",
            given=joint_types,
        )
    names = tuple(f"joint_{i + 1}" for i in range(n)) if joint_names is None else _words(joint_names, "joint_names")
    if len(names) != n:
        raise InputError(f"joint_names has {plural(len(names), 'name')} for {plural(n, 'joint')}.", given=names)
    twice = sorted({s for s in names if names.count(s) > 1})
    if twice:
        raise InputError(f"joint name {twice[0]!r} is used twice; names must differ.", joint=twice[0])
    senses = np.ones(n) if sign is None else _vector(sign, n, "sign")
    if not np.all(np.abs(senses) == 1.0):
        raise InputError(f"sign must be +1 or -1 for each joint, got {senses.tolist()}.", given=senses)
    zeros = np.zeros(n) if offset is None else _vector(offset, n, "offset")
    for i, row in enumerate(table):
        if max(abs(row.alpha), abs(row.theta)) > 2 * math.pi + WHOLE_TURN:
            warnings.warn(
                f"{names[i]}: alpha = {row.alpha:g}, theta = {row.theta:g} are taken as radians; more than a turn "
                "looks like degrees. Use math.radians(...) if degrees were meant.",
                PieperWarning,
                stacklevel=3,
            )
    bounds = _limits(limits, names, types)
    named = {} if postures is None else {k: _vector(v, n, f"posture {k!r}") for k, v in postures.items()}
    return Description(
        name=arguments.text(name, "name"),
        convention=convention,
        rows=table,
        joint_types=types,
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
        coupling=checked_coupling(coupling, names),
        tools={str(k): _frozen(checked_pose(T, f"tool {k!r}")) for k, T in (tools or {}).items()},
        frames={str(k): _frozen(checked_pose(T, f"frame {k!r}")) for k, T in (frames or {}).items()},
        remarks=tuple(remarks),
    )


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
