"""The reach map of an arm: asked tile by tile, by any executor, kept and resumed; and what it says."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Executor, Future, wait
from dataclasses import dataclass, field, fields
from functools import cached_property, partial
from pathlib import Path
from typing import Any, NamedTuple, Protocol, runtime_checkable
from uuid import uuid4

import numpy as np

from pieper import arguments
from pieper.errors import InputError, PlanError
from pieper.kinematics.arrays import Array, ArrayLike, Bits, Bools, Indices
from pieper.kinematics.meant import remark_long, remark_turned
from pieper.kinematics.pose import PoseLike, checked_pose, rotation_z
from pieper.maps.around import Around
from pieper.maps.export import export
from pieper.maps.grid import Grid, grid_of
from pieper.maps.store import Store, identity, refuse_too_much
from pieper.maps.tile import MEASURES, Question, Tile, question_of, reached_exactly, shares, solved
from pieper.solver.plan.plan import Plan
from pieper.words_by_number import plural

#: Poses a tile has, about: long enough to be worth sending, short enough to be done again.
TILE_POSES = 1_000_000
#: Tiles an executor holds at a time.
AHEAD = 64
SYMMETRIES = ("auto", "none")
#: What one orientation of a task is called.
WORDS = {"pose": "orientation", "position+axis": "direction", "position": "place"}
_BITS_OF_BYTE = np.unpackbits(np.arange(256, dtype=np.uint8)[:, None], axis=1).sum(1, dtype=np.uint8)


@runtime_checkable
class Submits(Protocol):
    """What executors have."""

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Any:
        """Begin a call."""
        ...


class Voxels(NamedTuple):
    """Voxels reached in some orientation: centres (k, 3), m; share of orientations (k,); solutions (k,)."""

    points: Array
    fraction: Array
    count: Indices


@dataclass(frozen=True, eq=False)
class ReachMap:
    """What an arm reaches inside its limits, asked at voxels' centres.

    Attributes:
        plan: How the arm is solved.
        grid: Voxels and orientations.
        bits: (voxels, ceil(k / 8)) one bit an orientation.
        solutions: (voxels,) inside the limits.
        measures: (voxels, 6) of the solutions inside the limits where they were asked for, (voxels, 0) where not.
        symmetry: What answered for what, in words.
        around: The arm's bodies and the scene that solutions keep clear of; None where neither was asked.
        computed: Tiles that were solved now; the others came from the store.
    """

    plan: Plan = field(repr=False)
    grid: Grid = field(repr=False)
    bits: Bits = field(repr=False)
    solutions: Indices = field(repr=False)
    measures: Array = field(repr=False)
    symmetry: str = ""
    around: Around | None = field(repr=False, default=None)
    computed: int = 0

    @cached_property
    def fraction(self) -> Array:
        """(nx, ny, nz) share of the orientations that is reached in each voxel."""
        hits = _BITS_OF_BYTE[self.bits].sum(1, dtype=np.int64)
        return (hits / len(self.grid.turns)).reshape(self.grid.shape)

    @property
    def count(self) -> Indices:
        """(nx, ny, nz) solutions inside the limits in each voxel, all orientations together."""
        return self.solutions.reshape(self.grid.shape)

    @property
    def manipulability(self) -> Array:
        """(nx, ny, nz) best manipulability sqrt(det(J J^T)) of the solutions inside the limits in each voxel."""
        return self.measured("manipulability")

    @property
    def margin(self) -> Array:
        """(nx, ny, nz) share of half a joint's range that the nearest limit is away, of the best solution; 0 to 1."""
        return self.measured("margin")

    @property
    def aspects(self) -> Indices:
        """(nx, ny, nz, 2) solutions inside the limits with a negative and with a positive determinant of the Jacobian.

        Where the Jacobian is not square all are told as positive.
        """
        return np.stack([self.measured("negative"), self.measured("positive")], -1).astype(np.int64)

    @property
    def least_singular(self) -> Array:
        """(nx, ny, nz) smallest singular value of the Jacobian of the solution nearest to singular; 0 where `count` is.

        Lengths are in units of the arm; it is small on the singular surfaces.
        """
        return self.measured("least_singular")

    @property
    def most_singular(self) -> Array:
        """(nx, ny, nz) the same of the solution farthest from singular."""
        return self.measured("most_singular")

    def measured(self, name: str) -> Array:
        """Return a measure (nx, ny, nz) by its name.

        Raises:
            InputError: The map was not measured, or another name.
        """
        if not self.measures.shape[1]:
            raise InputError("this map was not measured: ask for it with measure=True.")
        arguments.word(name, "name", MEASURES)
        return self.measures[:, list(MEASURES).index(name)].reshape(self.grid.shape)

    def minus(self, other: ReachMap) -> Array:
        """Return by how much more of the orientations this map reaches than another arm's or tool's (nx, ny, nz).

        Raises:
            InputError: The other map has other voxels or orientations.
        """
        arguments.like(ReachMap, other, "other", "a reach map")
        a, b = self.grid, other.grid
        same = a.shape == b.shape and a.step == b.step and np.array_equal(a.low, b.low)
        if not same or not np.array_equal(a.turns, b.turns):
            raise InputError("two maps are compared voxel by voxel: ask both with the same box, step and orientations.")
        return self.fraction - other.fraction

    @property
    def volume(self) -> float:
        """Volume of the voxels that are reached in some orientation, m^3."""
        return float((self.fraction > 0).sum()) * self.grid.step**3

    @property
    def axes(self) -> tuple[Array, Array, Array]:
        """Centres of the voxels along x, y and z, m."""
        x, y, z = (
            low + (np.arange(n) + 0.5) * self.grid.step for low, n in zip(self.grid.low, self.grid.shape, strict=True)
        )
        return x, y, z

    def reached(self, T: PoseLike, *, cell: bool = False) -> Bools:
        """Return whether poses (..., 4, 4) are reached inside the limits.

        Args:
            T: Poses, base to tool.
            cell: Look it up at the nearest voxel and orientation instead of solving the pose: a cell's centre is not
                the cell, so near the border that is sometimes wrong; outside the box it is False.
        """
        poses = checked_pose(T, batch=True)
        flat = np.ascontiguousarray(poses.reshape(-1, 4, 4))
        if cell:
            inside, voxel = self.grid.voxel_of(flat[:, :3, 3])
            turn = self.grid.turn_of(flat[:, :3, :3])
            found = inside & ((self.bits[voxel, turn // 8] >> (7 - turn % 8)) & 1).astype(bool)
        else:
            found = reached_exactly(self.plan, flat, self.around)
        return np.asarray(found.reshape(poses.shape[:-2]))

    def slice(self, *, x: float | None = None, y: float | None = None, z: float | None = None) -> Array:
        """Return the share of orientations on the layer of voxels at one coordinate, m: z= gives (nx, ny).

        Raises:
            InputError: Not exactly one coordinate, or one outside the box.
        """
        said = [(axis, value) for axis, value in enumerate((x, y, z)) if value is not None]
        if len(said) != 1:
            raise InputError("slice takes exactly one of x, y, z, in metres.", given=said)
        axis, value = said[0][0], arguments.number(said[0][1], "xyz"[said[0][0]], "m")
        index = int(np.floor((value - self.grid.low[axis]) / self.grid.step))
        if not 0 <= index < self.grid.shape[axis]:
            high = self.grid.low[axis] + self.grid.shape[axis] * self.grid.step
            raise InputError(
                f"{'xyz'[axis]} = {value:g} m is outside the map: {self.grid.low[axis]:g} to {high:g} m.",
                given=value,
            )
        return np.take(self.fraction, index, axis=axis)

    def voxels(self) -> Voxels:
        """Return the voxels that are reached in some orientation."""
        which = np.flatnonzero(self.fraction.ravel() > 0)
        return Voxels(self.grid.centres(which), self.fraction.ravel()[which], self.solutions[which])

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Write the map for other programs: .npz, .parquet (an extra), .vtk (voxels as cells).

        Raises:
            InputError: Another ending, or a place that cannot be written.
        """
        return export(self, path)

    def explain(self) -> str:
        """Tell what was asked and what came out."""
        nx, ny, nz = self.grid.shape
        reached, whole = int((self.fraction > 0).sum()), int((self.fraction == 1).sum())
        each, some = "", "reached"
        if self.plan.task != "position":
            each = f", {plural(len(self.grid.turns), WORDS[self.plan.task])} each"
            some = f"reached in some {WORDS[self.plan.task]}"
        every = f", {whole:,} in every one" if each else ""
        return (
            f"{self.plan.name}: {nx} x {ny} x {nz} voxel{'s' * (self.grid.count != 1)} of {self.grid.step * 1e3:g} mm"
            f"{each}, "
            f"{plural(self.grid.count * len(self.grid.turns), 'question')}; {self.symmetry}. {self._asked}"
            f"{plural(reached, 'voxel')} {'is' if reached == 1 else 'are'} {some} ({self.volume:.4g} m^3){every}. "
            f"{self._counts} A voxel is asked at its centre."
        )

    @property
    def _asked(self) -> str:
        """What was asked of an arm that cannot hold every pose."""
        plan = self.plan
        if plan.description.linked:
            return f"The whole pose was asked, of which its {plural(plan.n, 'joint')} hold {plan.n} of 6 numbers. "
        if plan.task == "pose" and plan.reduction.fill:
            # coupled joints of which one is to spare have no inverse for the place alone
            coupled = plan.chain.coupling is not None
            instead = "give orientations that it can hold" if coupled else 'task="position" asks for the place alone'
            return (
                f"The whole pose was asked, of which the arm's {plural(plan.n, 'joint')} hold {plan.rank} of 6 "
                f"numbers: {instead}. "
            )
        if plan.task == "pose" or self.plan.n >= 6:
            return ""
        what = "The position alone was asked" if plan.task == "position" else "Position and the tool's axis were asked"
        return f"{what}, since {plural(plan.n, 'joint')} hold{'s' if plan.n == 1 else ''} no pose in general. "

    @property
    def _counts(self) -> str:
        if self.around is None:
            return "Limits count, collisions do not."
        bodies = "guessed from its table" if self.around.bodies.guessed else "known"
        stands = plural(len(self.around.scene), "obstacle") if len(self.around.scene) else "no obstacle"
        return f"Limits count, and what touches: the arm's own bodies, which are {bodies}, and {stands}."


def task_of_samples(plan_for: Callable[[str | None], Plan], task: str | None, orientations: Any) -> Plan:
    """Return the plan that a map asks: as said, or of sampled directions the most that the arm holds in any of them.

    A pose of six numbers taken at random is none that an arm of fewer joints holds: the map would be empty. An arm
    that does not hold every position either, as one that moves in a plane, is asked for positions all the same.

    Raises:
        InputError: A linkage holds the arm's tool, which sampled orientations know nothing of.
    """
    plan = plan_for(task)
    if plan.description.linked and np.ndim(orientations) == 1:
        raise InputError(
            f"sampled orientations are none that {plan.name} holds, whose linkage guides its tool: give its own, "
            "orientations= rotations (k, 3, 3), such as arm.fk(q)[..., :3, :3] of postures q.",
            given=orientations,
        )
    if task is None and plan.reduction.fill and np.ndim(orientations) == 1:
        for less in ("position+axis", "position"):
            try:
                other = plan_for(less)
            except PlanError:
                continue
            if less == "position" or not other.reduction.fill:
                return other
    return plan


def reach_map(
    plan: Plan,
    box: Sequence[Sequence[float]],
    step: float,
    orientations: Sequence[int] | ArrayLike,
    symmetry: str,
    store: str | os.PathLike[str] | None,
    executor: Executor | None,
    progress: Callable[[int, int], None] | None,
    measure: bool,
    around: Around | None,
) -> ReachMap:
    """Ask for a map; see `pieper.Arm.reach_map`.

    Raises:
        InputError: A box, step, orientations or symmetry that is none, another map's store, too much without one.
    """
    arguments.word(symmetry, "symmetry", SYMMETRIES)
    arguments.told(progress)
    arguments.flag(measure, "measure")
    if executor is not None:
        arguments.like(Submits, executor, "executor", "one of concurrent.futures, or have a method submit")
    fits = partial(refuse_too_much, measure=measure, stored=store is not None)
    grid = grid_of(box, step, orientations, plan.task, plan.chain.length, fits)
    question = question_of(plan, grid, symmetry, measure, around)
    per_tile = max(1, TILE_POSES // (len(grid.turns) * question.images.fold))
    kept = None if store is None else Store.opened(store, identity(question, per_tile))
    bits = np.zeros((grid.count, -(-len(grid.turns) // 8)), np.uint8)
    solutions = np.zeros(grid.count, np.int64)
    whole = Tile(bits, solutions, np.zeros((grid.count, len(MEASURES) if measure else 0)))
    tiles = -(-question.images.count // per_tile)
    missing = []
    for number in range(tiles):
        known = kept.get(number) if kept is not None else None
        if known is None:
            missing.append(number)
        else:
            _place(whole, question, number, per_tile, known)
    done = tiles - len(missing)
    for number, tile in _each(question, missing, per_tile, kept, executor):
        _place(whole, question, number, per_tile, tile)
        done += 1
        if progress is not None:
            progress(done, tiles)
    return ReachMap(plan, grid, bits, solutions, whole.measures, question.words, around, len(missing))


def tile_of(
    question: Question, number: int, per_tile: int, kept: Store | None, threads: int | None, call: str = ""
) -> Tile:
    """Solve one tile and put it into its store, where there is one; what an executor runs.

    `call` is another one each time a map is asked: dask knows tasks by their arguments, and would answer with what an
    earlier call's task came to, the error of a disk that was full then, too.
    """
    if kept is not None and (known := kept.get(number)) is not None:
        # done by somebody else meanwhile: executors run some tasks twice
        return known
    tile = solved(question, question.images.of(number * per_tile, (number + 1) * per_tile), threads)
    if kept is not None:
        kept.put(number, tile)
    return tile


def _each(
    question: Question, missing: list[int], per_tile: int, kept: Store | None, executor: Executor | None
) -> Iterator[tuple[int, Tile]]:
    if executor is None:
        for number in missing:
            yield number, tile_of(question, number, per_tile, kept, None)
        return
    waiting: dict[Future[Tile], int] = {}
    left, call = iter(missing), uuid4().hex
    try:
        while True:
            for number in left:
                waiting[executor.submit(tile_of, question, number, per_tile, kept, 1, call)] = number
                if len(waiting) >= AHEAD:
                    break
            if not waiting:
                return
            finished, _ = wait(waiting, return_when=FIRST_COMPLETED)
            for future in finished:
                yield waiting.pop(future), future.result()
    finally:
        for future in waiting:
            future.cancel()


def _place(whole: Tile, question: Question, number: int, per_tile: int, tile: Tile) -> None:
    images = question.images.of(number * per_tile, (number + 1) * per_tile)
    at = images[images >= 0]
    for entry in fields(Tile):
        getattr(whole, entry.name)[at] = getattr(tile, entry.name)


def base_places(plan: Plan, Ts: PoseLike, x: ArrayLike, y: ArrayLike, z: ArrayLike, yaw: ArrayLike) -> Array:
    """Return the share (nx, ny, nz, nyaw) of poses reached from each base; see `pieper.Arm.base_places`."""
    poses = checked_pose(Ts, "Ts", batch=True).reshape(-1, 4, 4)
    named = (("x", x), ("y", y), ("z", z), ("yaw", yaw))
    said = [np.atleast_1d(arguments.numbers(v, name)) for name, v in named]
    if not len(poses):
        raise InputError(
            "base_places was given no pose: Ts must have shape (N, 4, 4), N at least 1.", given=poses.shape
        )
    for (name, _), values in zip(named, said, strict=True):
        if values.ndim != 1 or not len(values) or not np.isfinite(values).all():
            raise InputError(
                f"{name} must be a list of finite numbers, {'rad' if name == 'yaw' else 'm'}, at least one, got "
                f"{values.tolist()}.",
                given=values,
            )
    remark_turned(said[3], "yaw")
    remark_long(max(float(np.abs(v).max()) for v in said[:3]), "a place of the base is as far away as")
    X, Y, Z, A = (v.ravel() for v in np.meshgrid(*said, indexing="ij"))
    B = rotation_z(A)
    B[:, :3, 3] = np.stack([X, Y, Z], -1)
    nearest = [float(np.linalg.norm(B[:, :3, 3] - p, axis=1).min()) for p in poses[:, :3, 3]]
    remark_long(max(nearest), "a pose lies from every place of the base at least as far away as")
    return shares(plan, poses, B).reshape(tuple(len(v) for v in said))
