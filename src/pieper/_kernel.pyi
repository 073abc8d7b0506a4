"""The native kernels: forward kinematics, and the inverse of every family, several poses per instruction."""

from collections.abc import Callable, Iterable
from enum import IntFlag

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]

isa: str
isa_available: str
lanes: int

class Flag(IntFlag):
    """What a solver says of a pose; bits of `flag`."""

    DEGENERATE = 1
    UNCERTAIN = 2
    OUT_OF_REACH = 4
    ROUNDED = 8
    NO_ARM_ANGLE = 16
    COUNT_CHANGES = 32
    AT_ARM_ANGLE = 64

class Forward:
    """Forward kinematics of a chain."""

    def __init__(self, links: npt.ArrayLike, prismatic: npt.ArrayLike, frames_after: npt.ArrayLike) -> None: ...
    def fk(self, q: npt.ArrayLike) -> Array: ...
    def frames(self, q: npt.ArrayLike, base: npt.ArrayLike) -> Array: ...
    def jacobian(self, q: npt.ArrayLike) -> Array: ...

class Geometry:
    """What a family is told of an arm: made from keyword arguments, unchangeable, picklable."""

    name: str
    joints: int
    slots: int

class SphericalWristParallel(Geometry):
    """Parallel second and third axes, the first across them, a spherical wrist of right angles at the end."""

    def __init__(
        self,
        *,
        base: npt.ArrayLike,
        tool: npt.ArrayLike,
        origin: npt.ArrayLike,
        centre: npt.ArrayLike,
        a1: float,
        b: float,
        upper: float,
        fore: float,
        cos_psi: float,
        sin_psi: float,
        cos_tau: float,
        sin_tau: float,
        offset2: float,
        offset3: float,
        offset4: float,
        offset5: float,
        sign3: float,
        cos_offset4: float,
        sin_offset4: float,
        scale: float,
        tilted: bool,
    ) -> None: ...
    @property
    def base(self) -> Array: ...
    @property
    def tool(self) -> Array: ...
    @property
    def origin(self) -> Array: ...
    @property
    def centre(self) -> Array: ...
    @property
    def a1(self) -> float: ...
    @property
    def b(self) -> float: ...
    @property
    def upper(self) -> float: ...
    @property
    def fore(self) -> float: ...
    @property
    def cos_psi(self) -> float: ...
    @property
    def sin_psi(self) -> float: ...
    @property
    def cos_tau(self) -> float: ...
    @property
    def sin_tau(self) -> float: ...
    @property
    def offset2(self) -> float: ...
    @property
    def offset3(self) -> float: ...
    @property
    def offset4(self) -> float: ...
    @property
    def offset5(self) -> float: ...
    @property
    def sign3(self) -> float: ...
    @property
    def cos_offset4(self) -> float: ...
    @property
    def sin_offset4(self) -> float: ...
    @property
    def scale(self) -> float: ...
    @property
    def tilted(self) -> bool: ...

class SphericalWrist(Geometry):
    """Three neighbouring revolute axes through one point; in `loop` their frames stand there."""

    def __init__(
        self,
        *,
        length: float,
        links: npt.ArrayLike,
        loop: npt.ArrayLike,
        slides: Iterable[bool] | npt.NDArray[np.bool_],
        first: int,
        hide_c: bool,
        first_c: bool,
        apart: bool,
    ) -> None: ...
    @property
    def length(self) -> float: ...
    @property
    def links(self) -> Array: ...
    @property
    def loop(self) -> Array: ...
    @property
    def slides(self) -> tuple[bool, ...]: ...
    @property
    def first(self) -> int: ...
    @property
    def hide_c(self) -> bool: ...
    @property
    def first_c(self) -> bool: ...
    @property
    def apart(self) -> bool: ...

class ThreeParallel(Geometry):
    """Three neighbouring joints of a plane; in `loop` their frames lie in it, z along its normal."""

    def __init__(
        self,
        *,
        length: float,
        links: npt.ArrayLike,
        loop: npt.ArrayLike,
        slides: Iterable[bool] | npt.NDArray[np.bool_],
        first: int,
        hide_c: bool,
        first_c: bool,
        apart: bool,
        sense: npt.ArrayLike,
    ) -> None: ...
    @property
    def length(self) -> float: ...
    @property
    def links(self) -> Array: ...
    @property
    def loop(self) -> Array: ...
    @property
    def slides(self) -> tuple[bool, ...]: ...
    @property
    def first(self) -> int: ...
    @property
    def hide_c(self) -> bool: ...
    @property
    def first_c(self) -> bool: ...
    @property
    def apart(self) -> bool: ...
    @property
    def sense(self) -> Array: ...

class OffsetWrist(Geometry):
    """Parallel second and third axes across the first, the fourth and fifth meeting."""

    def __init__(
        self,
        *,
        length: float,
        links: npt.ArrayLike,
        general: General | None,
        backward: bool,
        alike: bool,
        to_base: npt.ArrayLike,
        base: npt.ArrayLike,
        from_tool: npt.ArrayLike,
        sixth: npt.ArrayLike,
        lever: npt.ArrayLike,
        lever_turned: npt.ArrayLike,
        fifth: npt.ArrayLike,
        axis6: npt.ArrayLike,
        shoulder: float,
        lateral: float,
        upper: float,
        fore: float,
        elbow_c: float,
        elbow_s: float,
        fore_c: float,
        fore_s: float,
        lean_c: float,
        lean_s: float,
        tilt_c: float,
        tilt_s: float,
        bend: float,
        sense3: float,
        axis4: npt.ArrayLike,
        across4: npt.ArrayLike,
        over4: npt.ArrayLike,
        across5: npt.ArrayLike,
        over5: npt.ArrayLike,
    ) -> None: ...
    @property
    def length(self) -> float: ...
    @property
    def links(self) -> Array: ...
    @property
    def general(self) -> General | None: ...
    @property
    def backward(self) -> bool: ...
    @property
    def alike(self) -> bool: ...
    @property
    def to_base(self) -> Array: ...
    @property
    def base(self) -> Array: ...
    @property
    def from_tool(self) -> Array: ...
    @property
    def sixth(self) -> Array: ...
    @property
    def lever(self) -> Array: ...
    @property
    def lever_turned(self) -> Array: ...
    @property
    def fifth(self) -> Array: ...
    @property
    def axis6(self) -> Array: ...
    @property
    def shoulder(self) -> float: ...
    @property
    def lateral(self) -> float: ...
    @property
    def upper(self) -> float: ...
    @property
    def fore(self) -> float: ...
    @property
    def elbow_c(self) -> float: ...
    @property
    def elbow_s(self) -> float: ...
    @property
    def fore_c(self) -> float: ...
    @property
    def fore_s(self) -> float: ...
    @property
    def lean_c(self) -> float: ...
    @property
    def lean_s(self) -> float: ...
    @property
    def tilt_c(self) -> float: ...
    @property
    def tilt_s(self) -> float: ...
    @property
    def bend(self) -> float: ...
    @property
    def sense3(self) -> float: ...
    @property
    def axis4(self) -> Array: ...
    @property
    def across4(self) -> Array: ...
    @property
    def over4(self) -> Array: ...
    @property
    def across5(self) -> Array: ...
    @property
    def over5(self) -> Array: ...

class TwoSlides(Geometry):
    """Four turning and two sliding joints in any order."""

    def __init__(
        self,
        *,
        length: float,
        links: npt.ArrayLike,
        general: General | None,
        slides: Iterable[bool] | npt.NDArray[np.bool_],
        hidden: Iterable[int],
    ) -> None: ...
    @property
    def length(self) -> float: ...
    @property
    def links(self) -> Array: ...
    @property
    def general(self) -> General | None: ...
    @property
    def slides(self) -> tuple[bool, ...]: ...
    @property
    def hidden(self) -> tuple[int, ...]: ...

class Position3(Geometry):
    """Three joints of any kinds that place the tool's point."""

    def __init__(
        self,
        *,
        length: float,
        links: npt.ArrayLike,
        slides: Iterable[bool] | npt.NDArray[np.bool_],
    ) -> None: ...
    @property
    def length(self) -> float: ...
    @property
    def links(self) -> Array: ...
    @property
    def slides(self) -> tuple[bool, ...]: ...

class Orientation3(Geometry):
    """Three revolute joints of which the orientation alone counts."""

    def __init__(
        self,
        *,
        links: npt.ArrayLike,
    ) -> None: ...
    @property
    def links(self) -> Array: ...

class General(Geometry):
    """Any six joints; making it tries every way of elimination. `trials` and `usable` say how that went."""

    def __init__(
        self,
        *,
        links: npt.ArrayLike,
        slides: Iterable[bool] | npt.NDArray[np.bool_],
        scale: float,
    ) -> None: ...
    @property
    def links(self) -> Array: ...
    @property
    def slides(self) -> tuple[bool, ...]: ...
    @property
    def scale(self) -> float: ...
    @property
    def trials(self) -> Array: ...
    @property
    def usable(self) -> int: ...

class Selection:
    """How rows are compared with a joint vector: limits, weights, whole turns."""

    def __init__(
        self, *, lower: npt.ArrayLike, upper: npt.ArrayLike, weight: npt.ArrayLike, prismatic: npt.ArrayLike
    ) -> None: ...
    def choose(
        self,
        q: Array,
        inside: npt.NDArray[np.bool_],
        near: npt.ArrayLike,
        chosen: Array,
        has: npt.NDArray[np.bool_],
    ) -> None:
        """Of q (N, slots, n) and near (n,) or (N, n): writes chosen (N, n), has (N,)."""

    def in_turn(
        self,
        q: Array,
        inside: npt.NDArray[np.bool_],
        start: npt.ArrayLike | None,
        chosen: Array,
        has: npt.NDArray[np.bool_],
    ) -> None:
        """The same, each near to the one chosen before it."""

class Solver:
    """Every solution of poses by the kernel of one family."""

    def __init__(
        self,
        geometry: Geometry,
        *,
        lower: npt.ArrayLike,
        upper: npt.ArrayLike,
        prismatic: npt.ArrayLike,
        slack: float,
        accepted: float,
        exact: float,
    ) -> None: ...
    @property
    def geometry(self) -> Geometry: ...
    def many(
        self, Ts: npt.ArrayLike, threads: int = 1
    ) -> tuple[Array, npt.NDArray[np.bool_], npt.NDArray[np.bool_], npt.NDArray[np.uint8]]:
        """(N, 4, 4) -> q (N, slots, joints), valid, in_limits (N, slots), flag (N,). threads 0: all cores."""

    def into(
        self,
        Ts: npt.ArrayLike,
        threads: int,
        q: Array,
        valid: npt.NDArray[np.bool_],
        in_limits: npt.NDArray[np.bool_],
        flag: npt.NDArray[np.uint8],
        outcome: npt.NDArray[np.uint8],
        selection: Selection | None = None,
        near: npt.ArrayLike | None = None,
        chosen: Array | None = None,
        has: npt.NDArray[np.bool_] | None = None,
        progress: Callable[[int], object] | None = None,
    ) -> None:
        """The same written into the caller's arrays; outcome (N,): 0 no rows, 1 outside the limits alone, 2 inside."""

    def reach(
        self,
        centres: npt.ArrayLike,
        turns: npt.ArrayLike,
        rolls: int,
        sense: float,
        links: npt.ArrayLike | None,
        threads: int,
    ) -> tuple[npt.NDArray[np.uint8], npt.NDArray[np.uint8], npt.NDArray[np.int64], Array | None, Array | None]:
        """Voxels (v, 3), turns (k, 3, 3) -> bits, look (v, ceil(k / 8)), solutions, manipulability, margin (v,)."""

    def one(self, T: npt.ArrayLike) -> tuple[Array, npt.NDArray[np.uint8], npt.NDArray[np.bool_], int]:
        """(4, 4) -> q (m, joints) of the valid slots in order, slots (m,), in_limits (m,), flag."""

def spline(s: npt.ArrayLike, q: npt.ArrayLike) -> Array:
    """(N,), (N, n) -> (N, n) second derivatives of the cubic spline through points."""

def fastest(
    *,
    s: npt.ArrayLike,
    d1: npt.ArrayLike,
    d2: npt.ArrayLike,
    d3: npt.ArrayLike,
    speed: npt.ArrayLike,
    acceleration: npt.ArrayLike,
    a: npt.ArrayLike,
    b: npt.ArrayLike,
    c: npt.ArrayLike,
    most: npt.ArrayLike,
    wanted: npt.ArrayLike,
    start: float,
    end: float,
) -> tuple[Array, Array, bool, int]:
    """Values x (N,), upper ends of the controllable sets (N,), whether it can be done, where not (-1: at the start)."""

def deviations(Ts: npt.ArrayLike) -> Array:
    """(N, 4, 4) -> (N,) how far each is from a rigid motion; NaN where it is not finite."""

def sincos(x: npt.ArrayLike) -> Array: ...
def atan2(yx: npt.ArrayLike) -> Array: ...
