"""The native kernels: forward kinematics, and the inverse of every family, several poses per instruction."""

from collections.abc import Callable, Sequence
from enum import IntFlag
from typing import Any, ClassVar, Final, TypeGuard, dataclass_transform

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
    EDGE = 128

class Forward:
    """A chain: its forward kinematics, and what functions of a chain are given."""

    def __init__(self, links: ArrayLike, prismatic: ArrayLike, frames_after: ArrayLike, length: float) -> None: ...
    def fk(self, q: ArrayLike) -> Array: ...
    def frames(self, q: ArrayLike, base: ArrayLike) -> Array: ...
    def jacobian(self, q: ArrayLike) -> Array: ...

class Collision:
    """Bodies on a chain and around it, and the pairs of them that must keep apart."""

    def __init__(
        self,
        chain: Forward,
        *,
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

@dataclass_transform(frozen_default=True, kw_only_default=True, eq_default=False)
class Geometry:
    """What a family is told of an arm: made from its fields as keyword arguments, unchangeable, picklable."""

    name: ClassVar[str]
    joints: ClassVar[int]
    slots: ClassVar[int]

class SphericalWristParallel(Geometry):
    """Parallel second and third axes, the first across them, a spherical wrist of right angles at the end."""

    base: Array
    tool: Array
    origin: Array
    centre: Array
    a1: float
    b: float
    upper: float
    fore: float
    cos_psi: float
    sin_psi: float
    cos_tau: float
    sin_tau: float
    offset2: float
    offset3: float
    offset4: float
    offset5: float
    sign3: float
    cos_offset4: float
    sin_offset4: float
    scale: float
    tilted: bool

class _Group(Geometry):
    length: float
    links: Array
    loop: Array
    slides: tuple[bool, ...]
    first: int
    hide_c: bool
    first_c: bool
    apart: bool

class SphericalWrist(_Group):
    """Three neighbouring revolute axes through one point; in `loop` their frames stand there."""

class ThreeParallel(_Group):
    """Three neighbouring joints of a plane; in `loop` their frames lie in it, z along its normal."""

    sense: Array

class OffsetWrist(Geometry):
    """Parallel second and third axes across the first, the fourth and fifth meeting."""

    length: float
    links: Array
    general: General | None
    backward: bool
    alike: bool
    to_base: Array
    base: Array
    from_tool: Array
    sixth: Array
    lever: Array
    lever_turned: Array
    fifth: Array
    axis6: Array
    shoulder: float
    lateral: float
    upper: float
    fore: float
    elbow_c: float
    elbow_s: float
    fore_c: float
    fore_s: float
    lean_c: float
    lean_s: float
    tilt_c: float
    tilt_s: float
    bend: float
    sense3: float
    axis4: Array
    across4: Array
    over4: Array
    across5: Array
    over5: Array

class TwoSlides(Geometry):
    """Four turning and two sliding joints in any order."""

    length: float
    links: Array
    general: General | None
    slides: tuple[bool, ...]
    hidden: tuple[int, ...]

class General(Geometry):
    """Any six joints; making it tries every way of elimination. `trials` and `usable` say how that went."""

    links: Array
    slides: tuple[bool, ...]
    scale: float
    @property
    def trials(self) -> Array: ...
    @property
    def usable(self) -> int: ...

class Selection:
    """How rows are compared with a joint vector: limits, weights, whole turns."""

    def __init__(self, *, lower: ArrayLike, upper: ArrayLike, weight: ArrayLike, prismatic: ArrayLike) -> None: ...
    def choose(self, q: Array, inside: Bools, near: ArrayLike, chosen: Array, has: Bools) -> None:
        """Of q (N, slots, n) and near (n,) or (N, n): writes chosen (N, n), has (N,)."""

    def in_turn(self, q: Array, inside: Bools, start: ArrayLike | None, chosen: Array, has: Bools) -> None:
        """The same, each near to the one chosen before it."""

class Linkage:
    """A self-motion of four joints that are a linkage, of six."""

    def __init__(
        self,
        chain: Forward,
        through: Array,
        joints: Indices,
        axes: Array,
        spots: Any,
        senses: Array,
        lead: int,
        low: float,
        high: float,
        course: int,
    ) -> None: ...
    def points(self, u: Array) -> Array:
        """(k,) -> (k, 6), angles the short way round from `through`."""

    def place(self, q: Array) -> float:
        """(6,) -> u; NaN where q is not on this piece of the curve."""

    def inside(self, lower: ArrayLike, upper: ArrayLike) -> Array:
        """(6,), (6,) -> intervals of u (k, 2)."""

class CarefulLook:
    """What is free at a singular pose of six joints, read off the axes of a solver's rows."""

    def __init__(
        self,
        solver: Solver,
        chain: Forward,
        *,
        lower: ArrayLike,
        upper: ArrayLike,
        closed_form: bool,
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
        images: ArrayLike,
        first_sense: float,
        links: ArrayLike | None,
        length: float,
        threads: int,
    ) -> tuple[Bits, Bits, Indices, Array]:
        """Voxels (v, 3), images (v, f), turns (k, 3, 3) -> bits, look (w, ceil(k / 8)), solutions, measures (w, 6)."""

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
def spline(s: ArrayLike, q: ArrayLike) -> tuple[Array, Array, Array]:
    """(N,), (N, n) -> three (N - 1, n): the derivatives at the beginning of each piece of the cubic spline."""

def strays(s: ArrayLike, d2: ArrayLike, d3: ArrayLike) -> float: ...
def tightest(values: ArrayLike, least: float) -> tuple[tuple[int, int, int], ...]:
    """Runs of pieces (first, one behind last, row) where one row of values (r, k) is largest, at least so much."""

def fastest(
    *,
    s: ArrayLike,
    d1: ArrayLike,
    d2: ArrayLike,
    d3: ArrayLike,
    speed: ArrayLike,
    acceleration: ArrayLike,
    share: ArrayLike,
    easing: ArrayLike,
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

def usual_joints(q: object, n: int, below: float) -> TypeGuard[Array]:
    """Whether q is a plain float64 array (..., n) of few numbers, all below a bound in size."""

def exact_poses(T: object, exact: float, farthest: float) -> TypeGuard[Array]:
    """Whether T is a plain float64 array (..., 4, 4) of rigid motions that are exact, none farther than a bound, m."""

def ladder(**given: Any) -> tuple[Array, Indices, float, int, int]: ...
def front(chain: Forward, **given: Any) -> tuple[int, float, float, Array, Array, Indices, int, float]: ...
def chain_of_blocks(diagonal: Array, beside: Array, right: Array) -> tuple[Array, bool]: ...
def posture_measures(J: ArrayLike, length: float) -> Array: ...
def sincos(x: ArrayLike) -> Array: ...
def atan2(yx: ArrayLike) -> Array: ...
def unit_angle(yx: ArrayLike) -> Array: ...
def descend(
    chain: Forward,
    *,
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
    chain: Forward,
    *,
    q: ArrayLike,
    T: ArrayLike,
    direction: ArrayLike,
    step: float,
    straight: float,
    most_steps: int,
) -> tuple[Array, bool]: ...
def onto(
    chain: Forward,
    *,
    q: ArrayLike,
    T: ArrayLike,
    steps: int,
    cutoff: float,
    longest: float,
) -> tuple[Array, Array]: ...
def parts_of_weakest(chain: Forward, *, q: ArrayLike) -> Array: ...
def unfold(chain: Forward, *, q: ArrayLike, T: ArrayLike, mixed: ArrayLike | None) -> tuple[Array, int]: ...
def nearer(
    chain: Forward,
    *,
    coupling: ArrayLike | None,
    lower: ArrayLike,
    upper: ArrayLike,
    q: ArrayLike,
    T: ArrayLike,
    turning: ArrayLike,
    steps: int,
) -> tuple[Array, Array]:
    """Go downhill from q (k, n) to T (4, 4): (k, n) and what is left (k,)."""

def closest(
    chain: Forward,
    *,
    coupling: ArrayLike | None,
    lower: ArrayLike,
    upper: ArrayLike,
    q: ArrayLike,
    poses: ArrayLike,
    seeds: ArrayLike,
    T: ArrayLike,
    turning: bool,
    stages: Sequence[tuple[float, int, int]],
    back: Sequence[tuple[float, int, int]],
    starts: int,
    spread: int,
    turned: int,
    more: int,
    more_kept: int,
    few_steps: int,
    in_place: int,
    led_back: int,
    alike: int,
    last_steps: int,
    near: tuple[float, ...],
    crawl: tuple[float, ...],
) -> Array:
    """Return postures (k, n) of which one comes nearest to T (4, 4), the position first."""
