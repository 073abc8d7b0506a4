"""What is asked of a batch beside its poses: near what a row is chosen, bad poses, arrays to write into, progress."""

from __future__ import annotations

import math
import numbers
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from pieper import _kernel, arguments
from pieper.errors import InputError
from pieper.kinematics.arrays import Array, ArrayLike, Bools, Indices
from pieper.kinematics.forward import checked_joints, checked_weights
from pieper.kinematics.pose import PoseLike, as_pose, checked_pose, is_exact, reason_against, unsound
from pieper.solver.batch import SolutionBatch
from pieper.solver.coupled_selection import CoupledSelection, RowSelection
from pieper.solver.large_rooms import large_room
from pieper.solver.plan.plan import Plan
from pieper.solver.results import Status
from pieper.solver.rows import Chosen, Refused, Rows
from pieper.tolerances import LIMIT_SLACK

#: Called with how many poses are done and how many there are.
Progress: TypeAlias = Callable[[int, int], object]

#: The word for choosing near the row of the pose before.
PREVIOUS = "previous"
#: Poses that are solved together where rows are made of rows in Python: it bounds the memory.
BLOCK = 4096
#: Bytes of a line of the cache.
_LINE = 64
#: Poses between two looks at the progress where the kernels' rows are the answer.
LARGE_BLOCK = 1 << 16


@dataclass(frozen=True, eq=False, slots=True)
class Near:
    """Near what a row a pose is chosen.

    Args:
        select: How rows are compared.
        to: (n,) or (N, n), rad or m; None where each is near the one before.
        start: (n,) what the first is near to then; None for the first row inside the limits.
    """

    select: RowSelection
    to: Array | None
    start: Array | None

    def part(self, at: slice) -> Near:
        """Return the same for some of the poses."""
        return self if self.to is None or self.to.ndim == 1 else Near(self.select, self.to[at], self.start)

    def choose(self, rows: Rows, into: Chosen) -> None:
        """Choose a row a pose, unless each is near the one before."""
        if self.to is not None:
            self.select.choose(rows.q, rows.inside, self.to, into.q, into.found)

    def choose_again(self, rows: Rows, at: Indices, into: Chosen) -> None:
        """Choose once more for poses whose rows have changed."""
        if self.to is None or not len(at):
            return
        some = Chosen(np.empty((len(at), into.q.shape[1])), np.empty(len(at), bool))
        to = self.to if self.to.ndim == 1 else self.to[at]
        self.select.choose(rows.q[at], rows.inside[at], to, some.q, some.found)
        into.q[at], into.found[at] = some.q, some.found

    def choose_in_turn(self, rows: Rows, into: Chosen) -> None:
        """Choose for all poses, where each is near the one before."""
        if self.to is None:
            self.select.in_turn(rows.q, rows.inside, self.start, into.q, into.found)


def near_what(
    plan: Plan, near: ArrayLike | str | None, start: ArrayLike | None, weights: ArrayLike | None, count: int
) -> Near | None:
    """Return near what rows of `count` poses are chosen, checked; None where nothing was asked for.

    Raises:
        InputError: A wrong length, word or weight.
    """
    if near is None:
        for name, given in (("start", start), ("weights", weights)):
            if given is not None:
                raise InputError(f"{name}= says how a row is chosen: say near= too, or leave it out.", given=given)
        return None
    joints = plan.chain.joints.first(plan.n)
    weight = checked_weights(weights, plan.n) / joints.unit**2
    select: RowSelection = (
        _kernel.Selection(
            lower=plan.limits[:, 0] - LIMIT_SLACK,
            upper=plan.limits[:, 1] + LIMIT_SLACK,
            weight=weight,
            prismatic=joints.prismatic,
        )
        if joints.coupled is None
        else CoupledSelection(joints.coupled, plan.limits, weight)
    )
    if isinstance(near, str):
        if near != PREVIOUS:
            raise InputError(
                f'near must be a joint vector (n,), one a pose (N, n) or "{PREVIOUS}", got {near!r}.', given=near
            )
        return Near(select, None, None if start is None else _joints(start, plan, "start", ((plan.n,),)))
    if start is not None:
        raise InputError(
            f'start= is for near="{PREVIOUS}"; leave it out, near= says where each is near to.', given=start
        )
    return Near(select, _joints(near, plan, "near", ((plan.n,), (count, plan.n))), None)


def _joints(given: ArrayLike, plan: Plan, what: str, shapes: Sequence[tuple[int, ...]]) -> Array:
    joints = np.ascontiguousarray(checked_joints(given, plan.n, what, plan.prismatic))
    if joints.shape not in shapes:
        allowed = " or ".join(map(str, shapes))
        raise InputError(f"{what} must have shape {allowed}, got {joints.shape}.", given=joints.shape)
    return joints


# ---------------------------------------------------------------------------------------------- poses that are none


def marking(invalid: object) -> bool:
    """Return whether a pose that is none is marked in the result rather than refused.

    Raises:
        InputError: Another word than "raise" or "mark".
    """
    if not isinstance(invalid, str) or invalid not in ("raise", "mark"):
        raise InputError(f'invalid must be "raise" or "mark", got {arguments.kind_of(invalid)}.', given=invalid)
    return invalid == "mark"


def without_refused(Ts: PoseLike) -> tuple[Array, Refused | None]:
    """Return poses (N, 4, 4) with those that are none replaced by one of the others, and what was refused.

    Raises:
        InputError: No array of shape (N, 4, 4); that is no matter of one pose.
    """
    told: dict[int, str] = {}
    try:
        given = np.asarray(as_pose(Ts))
        if np.iscomplexobj(given):
            raise TypeError
        poses = np.ascontiguousarray(given, dtype=np.float64)
        if poses.shape[1:] != (4, 4) and _items(Ts):
            raise TypeError
    except (TypeError, ValueError):
        poses, told = _one_by_one(Ts)
    if poses.shape == (0,):
        poses = poses.reshape(0, 4, 4)  # an empty list holds no pose of a wrong shape
    if poses.ndim != 3 or poses.shape[1:] != (4, 4):
        raise InputError(f"Ts must have shape (N, 4, 4), got {poses.shape}.", given=poses.shape)
    bad = unsound(poses, _kernel.deviations(poses))
    if not bad.any():
        return poses, None
    index, poses = np.flatnonzero(bad), poses.copy()
    refused = Refused(index, poses[index], tuple(told.get(int(k), "") for k in index))
    poses[index] = np.eye(4) if bad.all() else poses[np.argmin(bad)]
    return poses, refused


def _items(given: Any) -> list[Any] | None:
    """Return what is in a list that is meant for one of poses; None of one of numbers, and of the rows of one pose."""
    if not isinstance(given, (list, tuple)) or not given:
        return None
    items: list[Any] = list(given)  # pyright: ignore[reportUnknownArgumentType]  # anything at all
    try:
        one = np.shape(items) == (4, 4)
    except (TypeError, ValueError):
        one = False  # ragged
    return None if one or all(isinstance(item, numbers.Number) for item in items) else items


def _one_by_one(Ts: PoseLike) -> tuple[Array, dict[int, str]]:
    """Return the poses (N, 4, 4) of a list, not finite where something is no matrix, and what is to be said of that."""
    items = _items(Ts)
    if items is None:
        raise InputError(f"Ts must be real numbers of shape (N, 4, 4), got {arguments.kind_of(Ts)}.", given=Ts)
    given = [as_pose(item) for item in items]
    told: dict[int, str] = {}
    poses = np.full((len(given), 4, 4), np.nan)
    for k, pose in enumerate(given):
        try:
            matrix = arguments.numbers(pose, "")
            if matrix.shape != (4, 4):
                raise InputError(f"{matrix.shape}")
        except InputError:
            told[k] = reason_against(pose, "").strip()
            continue
        poses[k] = matrix
    return poses, told


def straightened(poses: Array) -> tuple[Array, Bools]:
    """Return poses (N, 4, 4) with exact rotation parts, and which of them were rounded (N,).

    Raises:
        InputError: One of them is no pose; the message says which and why.
    """
    if is_exact(poses):
        return poses, np.zeros(len(poses), bool)
    straight = checked_pose(poses, "Ts", batch=True)
    return straight, (straight != poses).any((1, 2))


# ---------------------------------------------------------------------------------------------- where answers go


def arrays_of(plan: Plan, out: object, count: int, slots: int, near: Near | None) -> SolutionBatch:
    """Return a batch to write into: one of new arrays, or `out`'s.

    Raises:
        InputError: `out` is no batch, or its arrays have another shape or type or cannot be written to.
    """
    shape = (count, slots, plan.n)
    chosen = None
    if out is None:
        valid, inside = (large_room(math.prod(shape[:2])).view(np.bool_).reshape(shape[:2]) for _ in range(2))
        rows, status = Rows(_on_lines(shape), valid, inside, large_room(count)), large_room(count)
    else:
        if not isinstance(out, SolutionBatch):
            raise InputError(
                f"out must be a SolutionBatch, an earlier answer of ik_many, got {type(out).__name__}.", given=out
            )
        rows, status, chosen = out.found, out.status, out.chosen
        _writable(rows.q, "q", shape, np.float64)
        _writable(rows.valid, "valid", shape[:2], np.bool_)
        _writable(rows.inside, "in_limits", shape[:2], np.bool_)
        _writable(rows.flags, "flag", shape[:1], np.uint8)
        _writable(status, "status", shape[:1], np.uint8)
    if near is None:
        return SolutionBatch(plan, rows, status)
    if chosen is None:
        chosen = Chosen(np.empty((count, plan.n)), np.empty(count, bool))
    else:
        _writable(chosen.q, "nearest", (count, plan.n), np.float64)
        _writable(chosen.found, "has_nearest", shape[:1], np.bool_)
    return SolutionBatch(plan, rows, status, chosen)


def _on_lines(shape: tuple[int, ...]) -> Array:
    """Return a new array that begins with a line of the cache, so that the kernels write whole lines of it."""
    size = 8 * math.prod(shape)
    room = large_room(size + _LINE)
    first = -room.ctypes.data % _LINE
    return room[first : first + size].view(np.float64).reshape(shape)


def _writable(array: npt.NDArray[np.generic], name: str, shape: tuple[int, ...], kind: type[np.generic]) -> None:
    if array.shape != shape or array.dtype != kind:
        got = f"{array.shape} of {array.dtype}"
        raise InputError(
            f"out.{name} must have shape {shape} of {np.dtype(kind)} for these poses and this arm, got {got}. Leave "
            "out= away, or give the answer to as many poses of the same arm.",
            given=got,
        )
    if not (array.flags.c_contiguous and array.flags.writeable and array.flags.aligned):
        raise InputError(
            f"out.{name} cannot be written to: it must be writable and in C order. Give a copy.", given=name
        )


def joined(plan: Plan, parts: Sequence[SolutionBatch], out: SolutionBatch | None, near: Near | None) -> SolutionBatch:
    """Return the answers to blocks of poses as one, each with the slots of the largest; rows are chosen here."""
    if len(parts) == 1 and out is None and near is None:
        return parts[0]
    count, slots = sum(map(len, parts)), max(part.q.shape[1] for part in parts)
    whole, first = arrays_of(plan, out, count, slots, near), 0
    for part in parts:
        at, width = slice(first, first + len(part)), part.q.shape[1]
        into = whole.part(at)
        into.q[:, :width], into.valid[:, :width], into.in_limits[:, :width] = part.q, part.valid, part.in_limits
        into.q[:, width:], into.valid[:, width:], into.in_limits[:, width:] = 0.0, False, False
        into.flag[:], into.status[:] = part.flag, part.status
        if near is not None and into.chosen is not None:
            near.part(at).choose(into.found, into.chosen)
        first += len(part)
    return whole


def finished(batch: SolutionBatch, near: Near | None, refused: Refused | None) -> SolutionBatch:
    """Return a batch with what was refused marked, and rows chosen in turn where that was asked for."""
    if refused is not None:
        at = refused.index
        batch.q[at], batch.valid[at], batch.in_limits[at] = 0.0, False, False
        batch.flag[at], batch.status[at] = 0, np.uint8(Status.INVALID)
        if batch.chosen is not None:
            batch.chosen.q[at], batch.chosen.found[at] = 0.0, False
    if near is not None and batch.chosen is not None:
        near.choose_in_turn(batch.found, batch.chosen)
    return SolutionBatch(batch.plan, batch.found, batch.status, batch.chosen, refused)


def tell(progress: Progress, count: int, done: int) -> None:
    """Tell how many poses of a call are done."""
    progress(done, count)


def after(told: Callable[[int], None], before: int, done: int) -> None:
    """Tell how many poses are done after those before."""
    told(before + done)
