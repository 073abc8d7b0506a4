"""An arm's bodies and a scene as the kernel knows them, and the pairs that must keep apart."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from pieper import _kernel
from pieper.collision.bodies import Bodies
from pieper.collision.scene import Scene
from pieper.description.dh import Description
from pieper.description.shapes import Box, Capsule, Convex, Cylinder, Shape, corners
from pieper.errors import InputError
from pieper.kinematics.chain import Chain
from pieper.tolerances import DISTANCE_ROUNDING, NO_LENGTH

Array = npt.NDArray[np.float64]
SEGMENT, BOX, CYLINDER = range(3)


@dataclass(frozen=True, eq=False)
class Solid:
    """A body as the kernel knows it.

    Args:
        link: How many joints move it.
        place: (4, 4) in the frame just after its last joint has moved; of what stands still, in the world.
        half: (3,) as the kernel's kinds want it.
        radius: A layer about it, m.
        kind: SEGMENT, BOX or CYLINDER.
        exact: Whether it is the shape itself, or a box that encloses it.
    """

    link: int
    place: Array
    half: Array
    radius: float
    kind: int
    exact: bool = True


@dataclass(frozen=True, eq=False)
class Model:
    """What must keep apart.

    Args:
        chain: The arm.
        bodies: The arm's bodies.
        scene: What stands around it.
        names: Of all bodies, the arm's first.
        shapes: Of all bodies, each in its link's frame.
        on: (bodies,) the frame each shape is said in: as `Arm.frames` counts them, -1 the world.
        links: (bodies,) how many joints move each.
        base: (4, 4) the frame of what is on the base.
        pairs: (k, 2) which bodies; the one on the higher link first; those the kernel has no distance of come last.
        native: The kernel's, of all pairs; of the last ones it knows enclosing boxes.
        exact: The kernel's, of the first pairs alone, whose distances it has; None where there is none.
        boxed: The kernel's, of the last ones alone; None where there is none.
        slack: What a distance may be off by rounding, m.
    """

    chain: Chain
    bodies: Bodies
    scene: Scene
    names: tuple[str, ...]
    shapes: tuple[Shape, ...]
    on: npt.NDArray[np.int64]
    links: npt.NDArray[np.int64]
    base: Array
    pairs: npt.NDArray[np.int64]
    native: _kernel.Collision
    exact: _kernel.Collision | None
    boxed: _kernel.Collision | None
    slack: float

    @property
    def known(self) -> int:
        """How many pairs, the first ones, the kernel has the distance of."""
        return 0 if self.exact is None else self.exact.pairs

    def names_of(self, pair: int) -> tuple[str, str]:
        """Return what the two of a pair are called: the arm's body first."""
        i, j = self.pairs[pair]
        return self.names[i], self.names[j]

    def chain_values(self, q: Array) -> Array:
        """Return what the chain's own joints are at (N, n) where the arm's are at q (N, n)."""
        return np.ascontiguousarray(q if self.chain.coupling is None else q @ self.chain.coupling.T)


def model_of(arm: Description, chain: Chain, bodies: Bodies, scene: Scene) -> Model:
    """Return what must keep apart: every body from every obstacle, and from every body that is no neighbour.

    Raises:
        InputError: A pair that may touch names no body of this arm.
    """
    _check_allowed(bodies, scene)
    n = len(arm.rows)
    after = [np.eye(4), *chain.frames_after, chain.links[n]]
    place = [arm.base, *after[1:]]
    links = [min(body.on, n) for body in bodies] + [0] * len(scene)
    places = np.array([place[body.on] for body in bodies] + [np.eye(4)] * len(scene)).reshape(-1, 4, 4)
    shapes = (*(body.shape for body in bodies), *scene)
    names = (*bodies.names, *scene.names)
    solids = [_solid(shape, T, link) for shape, T, link in zip(shapes, places, links, strict=True)]
    every = _pairs(bodies, scene, links)
    known = [(i, j) for i, j in every if not _beyond(solids[i], solids[j])]
    beyond = [(i, j) for i, j in every if _beyond(solids[i], solids[j])]
    boxes: dict[int, int] = {}
    boxed = [(_boxed(i, solids, boxes), _boxed(j, solids, boxes)) for i, j in beyond]
    # the kernel walks bodies in the order of their links
    order = sorted(range(len(solids)), key=lambda k: solids[k].link)
    at = {k: new for new, k in enumerate(order)}
    ordered = [solids[k] for k in order]

    def native(pairs: list[tuple[int, int]], outer: int) -> _kernel.Collision:
        return _kernel.Collision(
            chain.plain,
            link=[s.link for s in ordered],
            place=np.array([s.place for s in ordered]).reshape(-1, 4, 4),
            half=np.array([s.half for s in ordered]).reshape(-1, 3),
            radius=[s.radius for s in ordered],
            kind=[s.kind for s in ordered],
            pair=np.array([[at[i], at[j]] for i, j in pairs], int).reshape(-1, 2),
            outer=np.arange(len(pairs)) >= len(pairs) - outer,
        )

    size = sum(float(np.linalg.norm(link[:3, 3])) for link in chain.links)
    size += max((float(np.abs(s.place[:3, 3]).max()) + float(np.abs(s.half).max()) for s in solids), default=0.0)
    size += float(np.abs(arm.limits[chain.prismatic][np.isfinite(arm.limits[chain.prismatic])]).sum())
    return Model(
        chain=chain,
        bodies=bodies,
        scene=scene,
        names=names,
        shapes=shapes,
        on=np.array([body.on for body in bodies] + [-1] * len(scene), np.int64),
        links=np.array(links, np.int64),
        base=arm.base,
        pairs=np.array(known + beyond, np.int64).reshape(-1, 2),
        native=native(known + boxed, len(boxed)),
        exact=native(known, 0) if known else None,
        boxed=native(boxed, len(boxed)) if boxed else None,
        slack=DISTANCE_ROUNDING * max(size, 1.0),
    )


def _pairs(bodies: Bodies, scene: Scene, links: list[int]) -> list[tuple[int, int]]:
    out, count = [], len(bodies)
    allowed = bodies.allowed
    for i, name in enumerate(bodies.names):
        for j in range(i):
            if links[i] != links[j] and frozenset((name, bodies.names[j])) not in allowed:
                out.append((i, j) if links[i] > links[j] else (j, i))
        # what stands still beside what stands still says nothing about the arm
        if links[i] == 0:
            continue
        for k, other in enumerate(scene.names):
            if (name, other) not in scene.allowed and (other, name) not in scene.allowed:
                out.append((i, count + k))
    return out


def _check_allowed(bodies: Bodies, scene: Scene) -> None:
    for pair in scene.allowed:
        mine = [name for name in pair if name in bodies.names]
        if not mine:
            said = next(name for name in pair if name not in scene.names) if set(pair) - set(scene.names) else pair[0]
            raise InputError(
                f"the scene allows {said!r} to touch, but the arm has no such body; it has {', '.join(bodies.names)}.",
                given=pair,
                allowed=bodies.names,
            )


def _solid(shape: Shape, T: Array, link: int) -> Solid:
    """Return a shape, said in a link's frame T (4, 4), as the kernel knows it; a convex body as a box about it."""
    if isinstance(shape, Capsule):
        a, b = (T[:3, :3] @ x + T[:3, 3] for x in (shape.a, shape.b))
        half = float(np.linalg.norm(b - a)) / 2
        place = np.eye(4)
        place[:3, :3] = _along((b - a) / (2 * half)) if half > 0 else np.eye(3)
        place[:3, 3] = (a + b) / 2
        return Solid(link, place, np.array([0.0, 0.0, half]), shape.r, SEGMENT)
    if isinstance(shape, Box):
        return Solid(link, T @ shape.T, shape.size / 2, 0.0, BOX)
    if isinstance(shape, Cylinder):
        return Solid(link, T @ shape.T, np.array([shape.r, shape.r, shape.h / 2]), 0.0, CYLINDER)
    box, layer = enclosing_box(shape)
    return Solid(link, T @ box.T, box.size / 2, layer, BOX, exact=False)


def _beyond(one: Solid, other: Solid) -> bool:
    """Return whether the kernel has no distance of the two."""
    if not (one.exact and other.exact):
        return True
    return CYLINDER in (one.kind, other.kind) and SEGMENT not in (one.kind, other.kind)


def _boxed(k: int, solids: list[Solid], boxes: dict[int, int]) -> int:
    """Return the index of what encloses body k; a cylinder has a box of its own, made when it is first asked for."""
    if solids[k].kind != CYLINDER:
        return k
    if k not in boxes:
        old = solids[k]
        boxes[k] = len(solids)
        solids.append(Solid(old.link, old.place, old.half, old.radius, BOX, exact=False))
    return boxes[k]


def enclosing_box(shape: Convex) -> tuple[Box, float]:
    """Return a box along the main directions of a convex body's points, and the layer about it."""
    points, layer = corners(shape)
    middle = points.mean(0)
    _, _, axes = np.linalg.svd(points - middle, full_matrices=False)
    axes[2] = np.cross(axes[0], axes[1])
    seen = (points - middle) @ axes.T
    low, high = seen.min(0), seen.max(0)
    T = np.eye(4)
    T[:3, :3] = axes.T
    T[:3, 3] = middle + axes.T @ ((low + high) / 2)
    return Box(T, np.maximum(high - low, NO_LENGTH)), layer


def _along(z: Array) -> Array:
    """Return a rotation (3, 3) whose third column is the unit vector z."""
    x = np.cross(np.eye(3)[np.argmin(np.abs(z))], z)
    x /= np.linalg.norm(x)
    return np.stack([x, np.cross(z, x), z], 1)
