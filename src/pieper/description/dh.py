"""A DH table and everything else one says about an arm, as plain frozen data."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np
import numpy.typing as npt

from pieper import arguments
from pieper.description.coupling import moved_by
from pieper.description.shapes import Body, Unmeasured
from pieper.errors import PlanError
from pieper.tolerances import TYPED_DIGITS

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

    @property
    def across(self) -> float:
        """What the link leads along y, m: nothing but in a slid row."""
        return 0.0


@dataclass(frozen=True, slots=True)
class Slid(DH):
    """A row between nearly parallel axes whose common normal lies far away: its frames are slid along their axes.

    A = Rot(z, theta) Trans(z, d) Trans(x, a) Trans(y, f) Rot(x, alpha), where d is that of a slide alone: x points as
    the common normal does, and f is the way across it that a table without it makes by going to the normal and back.

    Args:
        f: What the link leads along y, m.
    """

    f: float = 0.0

    @property
    def across(self) -> float:
        """What the link leads along y, m."""
        return self.f


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
class Linked:
    """An axis that no joint has for its own: a linkage moves it as the coupling says.

    Args:
        at: Its row in the table (0-based).
        name: What it is called.
        kind: R revolute, P prismatic.
    """

    at: int
    name: str
    kind: str


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
    and zero; limits are limits of q. Of a palletizer, whose linkage moves axes that have no joint of their own
    (`linked`), table, sense and zero are of m axes, and all else of n joints.

    Args:
        name: Name of the arm.
        convention: "standard" (distal) or "modified" (proximal, Craig).
        rows: One DH row an axis.
        joint_types: One letter a joint, R or P.
        joint_names: One name a joint.
        limits: (n, 2), rad or m; infinite where there is none.
        sign: (m,) of +1 or -1, one an axis.
        offset: (m,), rad or m, one an axis.
        base: (4, 4) pose of the DH table's first frame.
        tool: (4, 4) pose of the tool in the table's last frame.
        departures: Where the numbers depart from their source, one sentence each with its reason.
        postures: Named joint vectors (n,).
        checks: Known poses.
        coupling: (m, n), None where every joint moves its own row alone.
        tools: Named poses (4, 4) of other tools, in the table's last frame as `tool` is.
        frames: Named poses (4, 4) of places, in the frame in which `base` is.
        remarks: What was read differently from the file the arm came from, in sentences.
        origin: The URDF or MJCF that others can read too; None for any other arm.
        bodies: What the arm is made of; empty where nothing is known.
        allowed: Pairs of names of bodies that may touch, beside neighbours.
        unmeasured: Where bodies are to be had, when there are none yet.
        payload: What the maker says the arm carries, kg; None where it is not known.
        reach: How far the maker says the arm reaches, m; None where it is not known.
        linked: The axes that no joint has for its own, in the order of their rows.
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
    linked: tuple[Linked, ...] = ()

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.joint_names)

    @property
    def axis_types(self) -> str:
        """One letter an axis, R or P: those of the joints, and of the axes that a linkage moves."""
        return "".join(self._by_axis(self.joint_types, [axis.kind for axis in self.linked]))

    @property
    def axis_names(self) -> tuple[str, ...]:
        """One name an axis: its joint's, or its own where a linkage moves it."""
        return tuple(self._by_axis(self.joint_names, [axis.name for axis in self.linked]))

    @property
    def own_axes(self) -> tuple[int, ...]:
        """The axis (0-based) of each joint."""
        others = {axis.at for axis in self.linked}
        return tuple(i for i in range(len(self.rows)) if i not in others)

    def not_linked(self, what: str, cure: str = "Ask it of arm.uncoupled(), whose joints are the axes.") -> None:
        """Refuse what is done for arms of which every axis has a joint.

        Raises:
            PlanError: A linkage moves axes of this arm.
        """
        if self.linked:
            names = ", ".join(dict.fromkeys(axis.name for axis in self.linked))
            raise PlanError(f"{self.name} has a linkage that moves {names}; {what}. {cure}", linked=self.linked)

    def by_axes(self) -> Description:
        """Return the arm whose joints are the axes, each moving by itself, without limits; itself where they are."""
        if self.coupling is None:
            return self
        return replace(
            self,
            coupling=None,
            linked=(),
            joint_types=self.axis_types,
            joint_names=self.axis_names,
            limits=np.tile([-np.inf, np.inf], (len(self.rows), 1)),
            postures={name: self.coupling @ q for name, q in self.postures.items()},
            checks=(),
            origin=None,
        )

    def _by_axis(self, of_joints: Sequence[str], of_linked: Sequence[str]) -> list[str]:
        found = list(of_joints)
        for axis, word in zip(self.linked, of_linked, strict=True):
            found.insert(axis.at, word)
        return found

    def moved_by(self, joint: int, names: Sequence[str] = (), *, signed: bool = False) -> str:
        """Return what moves an axis (0-based) in words, "q2 + q3", with the maker's sense where signed."""
        row = np.eye(self.n)[joint] if self.coupling is None else self.coupling[joint]
        names = names or [f"q{k + 1}" for k in range(self.n)]
        return moved_by(row, names, float(self.sign[joint]) if signed else 1.0)
