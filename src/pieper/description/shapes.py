"""Shapes of bodies: boxes, capsules, cylinders, convex points with a layer about them."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from pieper import arguments
from pieper.errors import InputError
from pieper.kinematics.pose import PoseLike, checked_pose
from pieper.tolerances import FLAT_SHAPE

Array = npt.NDArray[np.float64]


@dataclass(frozen=True, eq=False, init=False)
class Box:
    """A box.

    Args:
        T: (4, 4) pose of its middle, m; or (3,) a position.
        size: (3,) its sides along the x, y, z of T, m.
        name: What messages call it.
    """

    T: Array
    size: Array
    name: str = ""

    def __init__(self, T: PoseLike, size: npt.ArrayLike, name: str = "") -> None:
        sides = _vector(size, "the size of a box")
        for side in sides:
            if side <= 0:
                raise InputError(f"the sides of a box must be above zero, m, got {sides.tolist()}.", given=sides)
        _put(self, T=_pose(T, "the pose of a box"), size=sides, name=_word(name))

    def moved(self, T: Array) -> Box:
        """Return the box seen from a frame in which its own frame is T (4, 4)."""
        return Box(T @ self.T, self.size, self.name)


@dataclass(frozen=True, eq=False, init=False)
class Capsule:
    """All points within r of the segment from a to b; where a and b are one point, a sphere.

    Args:
        a: (3,) one end, m.
        b: (3,) the other.
        r: Radius, m.
        name: What messages call it.
    """

    a: Array
    b: Array
    r: float
    name: str = ""

    def __init__(self, a: npt.ArrayLike, b: npt.ArrayLike, r: float, name: str = "") -> None:
        _put(
            self,
            a=_vector(a, "the end a of a capsule"),
            b=_vector(b, "the end b of a capsule"),
            r=_length(r, "the radius of a capsule"),
            name=_word(name),
        )

    def moved(self, T: Array) -> Capsule:
        """Return the capsule seen from a frame in which its own frame is T (4, 4)."""
        R, p = T[:3, :3], T[:3, 3]
        return Capsule(R @ self.a + p, R @ self.b + p, self.r, self.name)


@dataclass(frozen=True, eq=False, init=False)
class Cylinder:
    """A cylinder about the z axis of T, its middle at T.

    Args:
        T: (4, 4) pose of its middle, m; or (3,) a position.
        r: Radius, m.
        h: Height, m.
        name: What messages call it.
    """

    T: Array
    r: float
    h: float
    name: str = ""

    def __init__(self, T: PoseLike, r: float, h: float, name: str = "") -> None:
        _put(
            self,
            T=_pose(T, "the pose of a cylinder"),
            r=_length(r, "the radius of a cylinder"),
            h=_length(h, "the height of a cylinder"),
            name=_word(name),
        )

    def moved(self, T: Array) -> Cylinder:
        """Return the cylinder seen from a frame in which its own frame is T (4, 4)."""
        return Cylinder(T @ self.T, self.r, self.h, self.name)


@dataclass(frozen=True, eq=False, init=False)
class Convex:
    """The convex hull of points, and all within r of it.

    Args:
        points: (k, 3) at least four that are not in one plane, m; those inside the hull do no harm.
        r: A layer about it, m.
        name: What messages call it.
    """

    points: Array
    r: float = 0.0
    name: str = ""

    def __init__(self, points: npt.ArrayLike, r: float = 0.0, name: str = "") -> None:
        given = np.array(arguments.numbers(points, "points of a convex body", "(k, 3) finite numbers, m"))
        if given.ndim != 2 or given.shape[-1] != 3 or not np.isfinite(given).all():
            said = "none" if not given.size else f"shape {given.shape}"
            raise InputError(f"points of a convex body must be (k, 3) finite numbers, m, got {said}.", given=points)
        if len(given) < 4:
            raise InputError(
                f"a convex body needs at least four points, got {len(given)}. Give a Box for a plate, or a Capsule for "
                "a rod.",
                given=len(given),
            )
        spread = np.linalg.svd(given - given.mean(0), compute_uv=False)
        if spread[2] <= FLAT_SHAPE * spread[0] or spread[0] == 0:
            raise InputError(
                "the points of a convex body are in one plane: there is nothing inside. Give a Box for a plate, or a "
                "Capsule for a rod.",
                given=given,
            )
        given.setflags(write=False)
        _put(self, points=given, r=_length(r, "the layer of a convex body", zero=True), name=_word(name))

    def moved(self, T: Array) -> Convex:
        """Return the body seen from a frame in which its own frame is T (4, 4)."""
        return Convex(self.points @ T[:3, :3].T + T[:3, 3], self.r, self.name)


Shape = Box | Capsule | Cylinder | Convex
KINDS = {Box: "box", Capsule: "capsule", Cylinder: "cylinder", Convex: "convex body"}


@dataclass(frozen=True, eq=False)
class Body:
    """A shape that an arm carries.

    Args:
        name: What messages call it.
        on: What carries it: 0 the base, k the link that joint k (1-based) moves, n + 1 the tool.
        shape: In the frame of `Arm.frames` of that number.
        source: Where it comes from: "measured ...", "guessed ...", or empty where the user said it.
    """

    name: str
    on: int
    shape: Shape
    source: str = ""

    def moved(self, T: Array, on: int | None = None) -> Body:
        """Return the body on another link, in whose frame its own frame is T (4, 4)."""
        return replace(self, shape=self.shape.moved(T), on=self.on if on is None else on)


@dataclass(frozen=True, eq=False)
class Unmeasured:
    """A file whose shapes have not been looked at: meshes are read when somebody asks for bodies.

    Args:
        data: The text of the URDF; nothing of an MJCF, which is read again from its place.
        file: Its place.
        exact_angles: How it was read.
        base: Link of the base.
        tip: Link of the tool.
        at: (4, 4) the arm's first frame when it was read.
    """

    data: bytes
    file: str
    exact_angles: bool
    base: str
    tip: str
    at: Array


def corners(shape: Shape) -> tuple[Array, float]:
    """Return points (k, 3) and a radius: the shape lies inside the hull of balls of that radius about the points."""
    if isinstance(shape, Capsule):
        return np.array([shape.a, shape.b]), shape.r
    if isinstance(shape, Convex):
        return shape.points, shape.r
    half = shape.size / 2 if isinstance(shape, Box) else np.array([shape.r, shape.r, shape.h / 2])
    signs = np.array([[i, j, k] for i in (-1.0, 1.0) for j in (-1.0, 1.0) for k in (-1.0, 1.0)])
    return (signs * half) @ shape.T[:3, :3].T + shape.T[:3, 3], 0.0


def unique_names(names: list[str]) -> list[str]:
    """Return the names with a number after those that are there already."""
    out: list[str] = []
    for name in names:
        count, said = 1, name
        while said in out:
            count += 1
            said = f"{name} {count}"
        out.append(said)
    return out


def _put(shape: object, **said: object) -> None:
    for name, value in said.items():
        object.__setattr__(shape, name, value)


def _pose(T: PoseLike, what: str) -> Array:
    given = arguments.numbers(T, what) if isinstance(T, (list, tuple, np.ndarray)) else None
    if given is not None and given.shape == (3,):
        pose = np.eye(4)
        pose[:3, 3] = _vector(given, what)
    else:
        pose = checked_pose(T, what)
    pose.setflags(write=False)
    return pose


def _vector(given: npt.ArrayLike, what: str) -> Array:
    vector = np.array(arguments.numbers(given, what, "three finite numbers, m"))
    if vector.shape != (3,) or not np.isfinite(vector).all():
        raise InputError(f"{what} must be three finite numbers, m, got {given!r}.", given=given)
    vector.setflags(write=False)
    return vector


def _length(given: float, what: str, *, zero: bool = False) -> float:
    return arguments.number(given, what, "m", least=0.0) if zero else arguments.number(given, what, "m", above=0.0)


def _word(name: str) -> str:
    return arguments.text(name, "the name of a shape")
