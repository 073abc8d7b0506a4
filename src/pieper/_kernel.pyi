"""The native kernels: forward kinematics, and the inverse of every family, several poses per instruction."""

from collections.abc import Callable, Iterable
from enum import IntFlag
from typing import Any, Final

from pieper.kinematics.arrays import Array, ArrayLike, Bits, Bools, Indices, Slots

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

    def __init__(self, links: ArrayLike, prismatic: ArrayLike, frames_after: ArrayLike) -> None: ...
    def fk(self, q: ArrayLike) -> Array: ...
    def frames(self, q: ArrayLike, base: ArrayLike) -> Array: ...
    def jacobian(self, q: ArrayLike) -> Array: ...

class Collision:
    """Bodies on a chain and around it, and the pairs of them that must keep apart."""

    def __init__(
        self,
        *,
        links: ArrayLike,
        prismatic: ArrayLike,
        link: ArrayLike,
        place: ArrayLike,
        half: ArrayLike,
        radius: ArrayLike,
        kind: ArrayLike,
        pair: ArrayLike,
        outer: ArrayLike,
    ) -> None: ...
    pairs: Final[int]
    def nearest(self, q: Array, points: bool = True) -> tuple[Array, Slots, Array, Array]: ...
    def each(self, q: Array) -> Array: ...
    def sweep(
        self, q: Array, margin: float, gap: float, slack: float
    ) -> tuple[bool, float, int, float, int, float, int, float, int, list[tuple[int, int]]]: ...

class Geometry:
    """What a family is told of an arm: made from keyword arguments, unchangeable, picklable."""

    name: Final[str]
    joints: Final[int]
    slots: Final[int]

class SphericalWristParallel(Geometry):
    """Parallel second and third axes, the first across them, a spherical wrist of right angles at the end."""

    def __init__(
        self,
        *,
        base: ArrayLike,
        tool: ArrayLike,
        origin: ArrayLike,
        centre: ArrayLike,
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
    base: Final[Array]
    tool: Final[Array]
    origin: Final[Array]
    centre: Final[Array]
    a1: Final[float]
    b: Final[float]
    upper: Final[float]
    fore: Final[float]
    cos_psi: Final[float]
    sin_psi: Final[float]
    cos_tau: Final[float]
    sin_tau: Final[float]
    offset2: Final[float]
    offset3: Final[float]
    offset4: Final[float]
    offset5: Final[float]
    sign3: Final[float]
    cos_offset4: Final[float]
    sin_offset4: Final[float]
    scale: Final[float]
    tilted: Final[bool]

class SphericalWrist(Geometry):
    """Three neighbouring revolute axes through one point; in `loop` their frames stand there."""

    def __init__(
        self,
        *,
        length: float,
        links: ArrayLike,
        loop: ArrayLike,
        slides: Iterable[bool] | Bools,
        first: int,
        hide_c: bool,
        first_c: bool,
        apart: bool,
    ) -> None: ...
    length: Final[float]
    links: Final[Array]
    loop: Final[Array]
    slides: Final[tuple[bool, ...]]
    first: Final[int]
    hide_c: Final[bool]
    first_c: Final[bool]
    apart: Final[bool]

class ThreeParallel(Geometry):
    """Three neighbouring joints of a plane; in `loop` their frames lie in it, z along its normal."""

    def __init__(
        self,
        *,
        length: float,
        links: ArrayLike,
        loop: ArrayLike,
        slides: Iterable[bool] | Bools,
        first: int,
        hide_c: bool,
        first_c: bool,
        apart: bool,
        sense: ArrayLike,
    ) -> None: ...
    length: Final[float]
    links: Final[Array]
    loop: Final[Array]
    slides: Final[tuple[bool, ...]]
    first: Final[int]
    hide_c: Final[bool]
    first_c: Final[bool]
    apart: Final[bool]
    sense: Final[Array]

class OffsetWrist(Geometry):
    """Parallel second and third axes across the first, the fourth and fifth meeting."""

    def __init__(
        self,
        *,
        length: float,
        links: ArrayLike,
        general: General | None,
        backward: bool,
        alike: bool,
        to_base: ArrayLike,
        base: ArrayLike,
        from_tool: ArrayLike,
        sixth: ArrayLike,
        lever: ArrayLike,
        lever_turned: ArrayLike,
        fifth: ArrayLike,
        axis6: ArrayLike,
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
        axis4: ArrayLike,
        across4: ArrayLike,
        over4: ArrayLike,
        across5: ArrayLike,
        over5: ArrayLike,
    ) -> None: ...
    length: Final[float]
    links: Final[Array]
    general: Final[General | None]
    backward: Final[bool]
    alike: Final[bool]
    to_base: Final[Array]
    base: Final[Array]
    from_tool: Final[Array]
    sixth: Final[Array]
    lever: Final[Array]
    lever_turned: Final[Array]
    fifth: Final[Array]
    axis6: Final[Array]
    shoulder: Final[float]
    lateral: Final[float]
    upper: Final[float]
    fore: Final[float]
    elbow_c: Final[float]
    elbow_s: Final[float]
    fore_c: Final[float]
    fore_s: Final[float]
    lean_c: Final[float]
    lean_s: Final[float]
    tilt_c: Final[float]
    tilt_s: Final[float]
    bend: Final[float]
    sense3: Final[float]
    axis4: Final[Array]
    across4: Final[Array]
    over4: Final[Array]
    across5: Final[Array]
    over5: Final[Array]

class TwoSlides(Geometry):
    """Four turning and two sliding joints in any order."""

    def __init__(
        self,
        *,
        length: float,
        links: ArrayLike,
        general: General | None,
        slides: Iterable[bool] | Bools,
        hidden: Iterable[int],
    ) -> None: ...
    length: Final[float]
    links: Final[Array]
    general: Final[General | None]
    slides: Final[tuple[bool, ...]]
    hidden: Final[tuple[int, ...]]

class Position3(Geometry):
    """Three joints of any kinds that place the tool's point."""

    def __init__(self, *, length: float, links: ArrayLike, slides: Iterable[bool] | Bools) -> None: ...
    length: Final[float]
    links: Final[Array]
    slides: Final[tuple[bool, ...]]

class Orientation3(Geometry):
    """Three revolute joints of which the orientation alone counts."""

    def __init__(self, *, links: ArrayLike) -> None: ...
    links: Final[Array]

class General(Geometry):
    """Any six joints; making it tries every way of elimination. `trials` and `usable` say how that went."""

    def __init__(self, *, links: ArrayLike, slides: Iterable[bool] | Bools, scale: float) -> None: ...
    links: Final[Array]
    slides: Final[tuple[bool, ...]]
    scale: Final[float]
    trials: Final[Array]
    usable: Final[int]

class Selection:
    """How rows are compared with a joint vector: limits, weights, whole turns."""

    def __init__(self, *, lower: ArrayLike, upper: ArrayLike, weight: ArrayLike, prismatic: ArrayLike) -> None: ...
    def choose(self, q: Array, inside: Bools, near: ArrayLike, chosen: Array, has: Bools) -> None:
        """Of q (N, slots, n) and near (n,) or (N, n): writes chosen (N, n), has (N,)."""

    def in_turn(self, q: Array, inside: Bools, start: ArrayLike | None, chosen: Array, has: Bools) -> None:
        """The same, each near to the one chosen before it."""

class CarefulLook:
    """What is free at a singular pose of six joints, read off the axes of a solver's rows."""

    def __init__(
        self,
        solver: Solver,
        *,
        links: ArrayLike,
        prismatic: ArrayLike,
        length: float,
        lower: ArrayLike,
        upper: ArrayLike,
    ) -> None: ...
    def one(self, T: ArrayLike, q: ArrayLike, flag: int) -> tuple[Any, ...] | None:
        """What `pieper.solver.native.Read` holds of a pose (4, 4), rows (m, 6), flag; None if not read off."""

    def into(self, Ts: ArrayLike, index: Indices, q: Array, valid: Bools, in_limits: Bools, flag: Bits) -> Bits:
        """Write rows of the poses that index (k,) names; (k,) 0: not read off, 2: with a self-motion, 1: else."""

class Solver:
    """Every solution of poses by the kernel of one family."""

    def __init__(
        self,
        geometry: Geometry,
        *,
        lower: ArrayLike,
        upper: ArrayLike,
        prismatic: ArrayLike,
        slack: float,
        accepted: float,
        exact: float,
    ) -> None: ...
    geometry: Final[Geometry]
    def many(self, Ts: ArrayLike, threads: int = 1) -> tuple[Array, Bools, Bools, Bits]:
        """(N, 4, 4) -> q (N, slots, joints), valid, in_limits (N, slots), flag (N,). threads 0: all cores."""

    def into(
        self,
        Ts: ArrayLike,
        threads: int,
        q: Array,
        valid: Bools,
        in_limits: Bools,
        flag: Bits,
        outcome: Bits,
        selection: Selection | None = None,
        near: ArrayLike | None = None,
        chosen: Array | None = None,
        has: Bools | None = None,
        progress: Callable[[int], object] | None = None,
    ) -> None:
        """The same written into the caller's arrays; outcome (N,): 0 no rows, 1 outside the limits alone, 2 inside."""

    def reach(
        self,
        centres: ArrayLike,
        turns: ArrayLike,
        rolls: int,
        sense: float,
        links: ArrayLike | None,
        threads: int,
    ) -> tuple[Bits, Bits, Indices, Array | None, Array | None]:
        """Voxels (v, 3), turns (k, 3, 3) -> bits, look (v, ceil(k / 8)), solutions, manipulability, margin (v,)."""

    def one(self, T: ArrayLike) -> tuple[Array, Bits, Bools, int]:
        """(4, 4) -> q (m, joints) of the valid slots in order, slots (m,), in_limits (m,), flag."""

def evened(t: Array, c: Array, window: float, moment: float) -> tuple[Array, Array]: ...
def jerk_ratios(
    *,
    s: Array,
    d1: Array,
    d2: Array,
    d3: Array,
    t: Array,
    c: Array,
    speed: Array,
    acceleration: Array,
    jerk: Array,
    grid: Array,
    share: Array,
    coefficients: Array,
    moment: float,
) -> tuple[Array, Array, Array, Array]: ...
def peak_ratios(
    *, s: Array, d1: Array, d2: Array, d3: Array, x: Array, speed: Array, acceleration: Array, share: Array
) -> Array: ...
def in_time(
    *, s: Array, q: Array, d1: Array, d2: Array, d3: Array, t: Array, c: Array, times: Array
) -> tuple[Array, Array, Array, Array, Array]: ...
def spline(s: ArrayLike, q: ArrayLike) -> Array:
    """(N,), (N, n) -> (N, n) second derivatives of the cubic spline through points."""

def fastest(
    *,
    s: ArrayLike,
    d1: ArrayLike,
    d2: ArrayLike,
    d3: ArrayLike,
    speed: ArrayLike,
    acceleration: ArrayLike,
    a: ArrayLike,
    b: ArrayLike,
    c: ArrayLike,
    most: ArrayLike,
    wanted: ArrayLike,
    start: float,
    end: float,
) -> tuple[Array, Array, bool, int]:
    """Values x (N,), upper ends of the controllable sets (N,), whether it can be done, where not (-1: at the start)."""

def deviations(Ts: ArrayLike) -> Array:
    """(N, 4, 4) -> (N,) how far each is from a rigid motion; NaN where it is not finite."""

def ladder(**given: Any) -> tuple[Array, Indices, float, int, int]: ...
def front(**given: Any) -> tuple[int, float, Array, Array, Indices, int, float]: ...
def chain_of_blocks(diagonal: Array, beside: Array, right: Array) -> tuple[Array, bool]: ...
def sincos(x: ArrayLike) -> Array: ...
def atan2(yx: ArrayLike) -> Array: ...
def descend(
    *,
    links: ArrayLike,
    prismatic: ArrayLike,
    length: float,
    q: ArrayLike,
    T: ArrayLike,
    lower: ArrayLike,
    upper: ArrayLike,
    steps: int,
    again: int,
    longest: float,
    damping: ArrayLike,
    done: float,
    idle: int,
    left: float,
) -> tuple[Array, Array]: ...
def follow_curve(
    *,
    links: ArrayLike,
    prismatic: ArrayLike,
    length: float,
    q: ArrayLike,
    T: ArrayLike,
    direction: ArrayLike,
    step: float,
    straight: float,
    most_steps: int,
) -> tuple[Array, bool]: ...
def onto(
    *,
    links: ArrayLike,
    prismatic: ArrayLike,
    length: float,
    q: ArrayLike,
    T: ArrayLike,
    steps: int,
    cutoff: float,
    longest: float,
) -> Array: ...
def nearer(
    *,
    links: ArrayLike,
    prismatic: ArrayLike,
    length: float,
    coupling: ArrayLike | None,
    lower: ArrayLike,
    upper: ArrayLike,
    q: ArrayLike,
    T: ArrayLike,
    turning: ArrayLike,
    steps: int,
) -> tuple[Array, Array]:
    """Go downhill from q (k, n) to T (4, 4): (k, n) and what is left (k,)."""
