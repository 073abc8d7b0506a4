"""Any arm and task as a six-joint problem: task freedoms become joints, spare joints are locked, missing ones filled.

A task that leaves something free (the roll about the tool axis, the whole orientation) is a full pose for the arm with
that freedom added as a virtual joint at the tool. An arm that can do less than six things gets virtual joints that must
come out as zero. An arm that can do more has joints locked at chosen values.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache, cached_property

import numpy as np

from pieper.kinematics.arrays import Array, Indices, median
from pieper.kinematics.chain import Chain
from pieper.kinematics.newton import scaled_jacobian, singular_values
from pieper.kinematics.pose import inverse, rotation_about, transform
from pieper.solver.plan.unlike import unlike
from pieper.tolerances import RANK

TASKS = ("pose", "position", "position+axis")
#: Most sets of an arm's own joints that are looked at to find which to lock beside a task's.
MOST_CHOICES = 84
#: Ways that are made ready where that takes time.
BEST_WAYS = 6
#: Where joints that are to be locked stand while others are chosen: of no special kind.
SOME_VALUE = 0.37
#: Orientation of the virtual wrist of a position task; generic, so that no ordinary pose makes it singular.
_GENERIC = transform(rotation_about(np.array([0.48, 0.6, 0.64]), 0.83))
_X = rotation_about(np.array([0.0, 1.0, 0.0]), np.pi / 2)
_Y = rotation_about(np.array([1.0, 0.0, 0.0]), -np.pi / 2)


def with_task_joints(chain: Chain, task: str) -> Chain:
    """Return the chain with the freedoms a task leaves added as virtual revolute joints at the tool."""
    if task == "position+axis":
        return appended(chain, [(np.eye(3), False)])
    if task == "position":
        wrist = [(np.eye(3), False), (_X, False), (np.eye(3), False)]
        # an arm of six joints can turn its tool as it is told: the wrist is held, and zero means the orientation given
        return appended(chain, wrist, last=None if chain.axis_count >= 6 else _GENERIC)
    return chain


def appended(
    chain: Chain, joints: Sequence[tuple[Array, bool]], last: Array | None = None, at: int | None = None
) -> Chain:
    """Return the chain with virtual joints at the tool, or before an axis; at zero they change nothing but `last`.

    Args:
        chain: The arm.
        joints: For each its orientation (3, 3) in the frame of the tool or axis (it acts along its z), and whether
            it is prismatic.
        last: (4, 4) constant pose after the last of them; identity if None.
        at: The axis (0-based) before which they stand, of a chain without coupling; at the tool if None.
    """
    links, place = list(chain.links), chain.axis_count if at is None else at
    for k, (R, _) in enumerate(joints):
        frame = transform(R)
        links[place + k] = links[place + k] @ frame
        links.insert(place + k + 1, inverse(frame))
    if last is not None:
        links[-1] = links[-1] @ last
    coupling, own = chain.coupling, ()
    if coupling is not None:
        coupling = np.eye(chain.axis_count + len(joints), chain.n + len(joints))
        coupling[: chain.axis_count, : chain.n] = chain.coupling
        coupling[chain.axis_count :, chain.n :] = np.eye(len(joints))
        # no list stands for every axis, and goes on doing so
        own = (*chain.own, *range(chain.axis_count, len(coupling))) if chain.own else ()
    sliding = np.concatenate([chain.sliding[:place], [p for _, p in joints], chain.sliding[place:]])
    return Chain.of(np.stack(links), sliding, coupling=coupling, own=own, scale=chain.scale)


def sample_joints(chain: Chain, count: int, seed: int = 1) -> Array:
    """Return generic joint vectors (count, n): angles over the whole turn, prismatic over the arm's length.

    Multiples of square roots of primes (Weyl's sequence) spread evenly and are the same every time, and spare the
    command line the start-up of a random generator.
    """
    steps = np.sqrt(np.array(_primes(chain.n), float))
    spread = (np.arange(1, count + 1)[:, None] + 1009.0 * seed) * steps % 1.0
    return np.asarray(np.where(chain.prismatic, chain.length, np.pi) * (2 * spread - 1), np.float64)


@cache
def _primes(count: int) -> tuple[int, ...]:
    found: list[int] = []
    candidate = 2
    while len(found) < count:
        if all(candidate % p for p in found):
            found.append(candidate)
        candidate += 1
    return tuple(found)


def generic_rank(chain: Chain) -> int:
    """Return how many things the arm can do at once: the rank of its Jacobian away from singular postures."""
    # without base and tool: how far away they are changes the numbers but not the rank
    bare = chain.section(0, chain.n - 1)
    s = singular_values(bare, sample_joints(chain, 12))
    return int(np.max(np.sum(s > RANK * s[:, :1], axis=1)))


def default_task(chain: Chain) -> str:
    """Return the task an arm is asked for when nobody says: the fullest that it can do at every reachable place."""
    if chain.n >= 6 or generic_rank(chain) != chain.n:
        return "pose"
    for task in ("position+axis", "position"):
        full = with_task_joints(chain, task)
        if full.n == 6 and generic_rank(full) == 6:
            return task
    return "pose"


@dataclass(frozen=True, eq=False)
class Held:
    """What a linkage holds of a chain's axes.

    Args:
        postures: (k, axes) values of the axes that it holds, rad or m.
        before: The first axis (0-based) behind those that it moves; None where they are the last.
    """

    postures: Array
    before: int | None


@dataclass(frozen=True, eq=False)
class Reduction:
    """How an arm and a task become one six-joint chain.

    Args:
        arm: The arm's chain.
        task: One of TASKS.
        full: The arm's joints followed by the task's virtual ones.
        locked: Joints (0-based, in full) that are held at chosen values.
        fill: Virtual joints, as for `appended`, that must come out as zero.
        fill_at: The axis (0-based) before which they stand; at the tool if None.
    """

    arm: Chain
    task: str
    full: Chain
    locked: tuple[int, ...]
    fill: tuple[tuple[Array, bool], ...]
    fill_at: int | None = None

    @cached_property
    def filled(self) -> Indices:
        """Joints of the six that are virtual and must come out as zero."""
        first = 6 - len(self.fill) if self.fill_at is None else self.fill_at
        return np.arange(first, first + len(self.fill))

    @cached_property
    def real(self) -> Indices:
        """The other joints of the six."""
        return np.array([j for j in range(6) if j not in self.filled], np.int64)

    @property
    def trivial(self) -> bool:
        """Whether the arm itself is the six-joint chain."""
        return self.full is self.arm and not self.locked and not self.fill

    @cached_property
    def kept(self) -> Indices:
        """Joints of full that are solved for."""
        held = set(self.locked)  # numpy.setdiff1d would load numpy.ma
        return np.array([j for j in range(self.full.n) if j not in held], np.int64)

    @cached_property
    def at_ends(self) -> tuple[int, int] | None:
        """(number locked at the base, at the tool) when all locked joints are there and nothing is filled."""
        if self.fill:
            return None
        first = next((i for i in range(self.full.n) if i not in self.locked), self.full.n)
        tail = len(self.locked) - first
        if set(self.locked) == set(range(first)) | set(range(self.full.n - tail, self.full.n)):
            return first, tail
        return None

    def with_locked(self, values: Array) -> Chain:
        """Return full with the locked joints held at values (k,), nothing filled."""
        chain = self.full
        for joint, value in sorted(zip(self.locked, values, strict=True), reverse=True):
            chain = chain.locked(joint, float(value))
        return chain

    def six(self, values: Array) -> Chain:
        """Return the six-joint chain for locked values (k,); with the locked joints at the ends it is one for all."""
        if self.at_ends is not None and self.locked:
            first, tail = self.at_ends
            links = self.full.links[first : self.full.n - tail + 1].copy()
            return Chain.of(links, self.full.prismatic[self.kept].copy(), scale=self.full.scale)
        chain = self.with_locked(values)
        return appended(chain, self.fill, at=self.fill_at) if self.fill else chain

    @cached_property
    def _back(self) -> Array:
        """Inverse links (n + 1, 4, 4) of full."""
        return inverse(self.full.links)

    def moved_pose(self, T: Array, values: Array) -> Array:
        """Return the poses (N, 4, 4) the six-joint chain must reach, locked values (N, k) at the ends taken off."""
        if self.at_ends is None or not self.locked:
            return T
        first, tail = self.at_ends
        n, left = self.full.n, T
        # from the base inwards: T = L Z T' with T' what is left, hence T' = Z^-1 L^-1 T
        for j in range(first):
            left = np.einsum("ij,njk->nik", self._back[j], left)
            left = _taken_off(left, values[:, j], bool(self.full.prismatic[j]))
        # from the tool inwards the same, seen from the other side: T = T' Z L
        for k in range(tail - 1, -1, -1):
            j = n - tail + k
            left = (left.reshape(-1, 4) @ self._back[j + 1]).reshape(-1, 4, 4)
            left = np.swapaxes(
                _taken_off(np.swapaxes(left, 1, 2), -values[:, first + k], bool(self.full.prismatic[j]), column=True),
                1,
                2,
            )
        return left


def reduce(chain: Chain, task: str, hold: Held | None = None) -> list[Reduction]:
    """Return the ways to make an arm and a task a six-joint chain, best conditioned first.

    Args:
        chain: The arm.
        task: One of TASKS.
        hold: What a linkage holds of it; None where each axis moves by itself.
    """
    full = with_task_joints(chain, task)
    rank = generic_rank(full)
    spare = full.n - rank
    if spare == 0:
        if hold is not None and full.n == chain.n:
            return [Reduction(chain, task, full, (), _filling_held(full, 6 - rank, hold), hold.before)]
        return [Reduction(chain, task, full, (), _filling(full, 6 - rank, full.n > chain.n))]
    J = scaled_jacobian(full, sample_joints(full, 12))
    choices = _choices(full, chain, J, spare)
    kept = np.array([[j for j in range(full.n) if j not in locked] for locked in choices])
    s = np.linalg.svd(np.moveaxis(J[:, :, kept], 2, 0), compute_uv=False)  # ways, postures, singular values
    smallest = median(s[..., rank - 1] / s[..., 0])
    ways = [(float(value), locked) for value, locked in zip(smallest, choices, strict=True) if value > RANK]
    ways.sort(key=lambda way: -way[0])
    # filling takes time, and so does comparing ways: of many, only the best few are made ready
    few = ways if rank == 6 and full.n <= 9 else ways[:BEST_WAYS]
    return [_way(chain, task, full, locked, rank) for _, locked in few]


def holding(way: Reduction, locked: tuple[int, ...]) -> Reduction | None:
    """Return the same arm and task with other joints locked; None where the pose alone decides what these are.

    Args:
        way: Any way to make the arm and task a six-joint chain.
        locked: As many joints (0-based, virtual ones included), ascending.
    """
    full, rank = way.full, way.full.n - len(way.locked)
    kept = [j for j in range(full.n) if j not in locked]
    s = np.linalg.svd(scaled_jacobian(full, sample_joints(full, 12))[:, :, kept], compute_uv=False)
    if median(s[:, rank - 1] / s[:, 0]) <= RANK:
        return None
    return _way(way.arm, way.task, full, locked, rank)


def refilled(way: Reduction) -> tuple[Reduction, ...]:
    """Return the same arm and task filled with other virtual joints along no special directions: turns, slides, both.

    Where the arm itself is regular the six joints may be singular all the same, as a virtual joint lies along what the
    arm can do there. Round postures and level hands do that to joints along the tool's own axes, not to these.
    """
    if not way.fill:
        return ()
    held = way.with_locked(unlike(len(way.locked), SOME_VALUE)) if way.locked else way.full
    count, sliding = len(way.fill), int(held.prismatic.sum())
    kinds = (False, True, None) if count + sliding <= 3 else (False, False, None)
    return tuple(
        replace(way, fill=_filling(held, count, True, seed=11 + k, only=p), fill_at=None) for k, p in enumerate(kinds)
    )


def _way(chain: Chain, task: str, full: Chain, locked: tuple[int, ...], rank: int) -> Reduction:
    way = Reduction(chain, task, full, tuple(locked), ())
    if rank == 6:
        return way
    held = way.with_locked(unlike(len(locked), SOME_VALUE))
    return replace(way, fill=_filling(held, 6 - rank, full.n > chain.n))


def _choices(full: Chain, arm: Chain, J: Array, spare: int) -> list[tuple[int, ...]]:
    """Return sets of joints worth locking: all of them for a few joints, a greedy good one and others for many."""
    if full.n <= 9 and spare <= 3:
        return list(itertools.combinations(range(full.n), spare))
    greedy = _greedy(full, J, spare)
    # an arm that can do everything turns its tool as it is told: what the task adds is held, and some of its own joints
    task = tuple(range(arm.n, full.n))
    own = spare - len(task)
    if not task or own < 0 or math.comb(arm.n, own) > MOST_CHOICES:
        return [greedy]
    return list(dict.fromkeys([greedy, *((*joints, *task) for joints in itertools.combinations(range(arm.n), own))]))


def _greedy(full: Chain, J: Array, spare: int) -> tuple[int, ...]:
    """Return joints worth locking so that those that are left do most."""
    kept: list[int] = []
    for _ in range(full.n - spare):
        best, gain = -1, -np.inf
        for j in range(full.n):
            if j in kept:
                continue
            s = np.linalg.svd(J[:, :, [*kept, j]], compute_uv=False)
            value = float(median(s[:, -1]))
            if value > gain:
                best, gain = j, value
        kept.append(best)
    return tuple(j for j in range(full.n) if j not in kept)


def _filling_held(chain: Chain, count: int, hold: Held) -> tuple[tuple[Array, bool], ...]:
    """Choose virtual joints that make axes able to do everything, well conditioned where a linkage holds them.

    What it holds is special for the axes: a level hand has its last axis parallel to the first, and a virtual joint
    behind the last one lies along another axis at some of its turns. Before it there is one that never does.
    """
    chosen: list[tuple[Array, bool]] = []
    for _ in range(count):
        best, most = None, -1.0
        for candidate in ((R, p) for p in (False, True) for R in (_X, _Y, np.eye(3))):
            tried = appended(chain, [*chosen, candidate], at=hold.before)
            place = chain.n if hold.before is None else hold.before
            q = np.insert(hold.postures, [place] * (len(chosen) + 1), 0.0, axis=1)
            value = float(np.quantile(np.linalg.svd(scaled_jacobian(tried, q), compute_uv=False)[:, -1], 0.1))
            if value > most * 1.05:
                best, most = candidate, value
        if best is not None:
            chosen.append(best)
    return tuple(chosen)


def _filling(
    chain: Chain, count: int, virtual: bool, *, seed: int = 3, only: bool | None = None
) -> tuple[tuple[Array, bool], ...]:
    """Choose `count` virtual joints at the tool that make the chain able to do everything, well conditioned.

    Behind the virtual joints of a task they are tilted: along the tool's own axes they would be tangent to the arm's
    motion whenever the wanted orientation happens to be the arm's. `only` slides (true) or turns are chosen from, and
    others the tilted ones, by another seed.
    """
    if count == 0:
        return ()
    rng = np.random.default_rng(seed)
    tilted = [rotation_about(v / np.linalg.norm(v), 1.1) for v in rng.standard_normal((3, 3))]
    kinds = (True, False) if only is None else (only,)
    pool = [(R, p) for p in kinds for R in (*(() if virtual else (np.eye(3), _X, _Y)), *tilted)]
    sliding = int(chain.prismatic.sum())
    # at zero, where the virtual joints are to come out, not at values of no special kind: there a virtual joint turns
    # about, or slides along, an axis through the tool point
    tried = appended(chain, pool[:1])
    q = sample_joints(tried, 15, seed=2)[:, : chain.n]
    so_far = scaled_jacobian(tried, np.pad(q, ((0, 0), (0, 1))))[..., : chain.n]
    axes = chain.native.fk(q)[:, :3, :3] @ np.array([R[:, 2] for R, _ in pool]).T  # postures, xyz, pool
    slides = np.array([p for _, p in pool])
    columns = np.concatenate([np.where(slides, axes, 0.0), np.where(slides, 0.0, axes)], 1)
    chosen: list[tuple[Array, bool]] = []
    for _ in range(count):
        tables = np.concatenate([np.repeat(so_far[None], len(pool), 0), np.moveaxis(columns, 2, 0)[..., None]], -1)
        worst = np.sort(np.linalg.svd(tables, compute_uv=False)[..., -1], axis=1)
        value = worst[:, 4] + 0.2 * (worst[:, 5] - worst[:, 4])  # the 0.3 quantile of fifteen
        best, gain = 0, -1.0
        for k, (_, p) in enumerate(pool):
            if p and sliding + sum(p for _, p in chosen) >= 3:
                continue
            if value[k] > gain * 1.05:
                best, gain = k, float(value[k])
        chosen.append(pool[best])
        so_far = np.concatenate([so_far, columns[:, :, best : best + 1]], -1)
    return tuple(chosen)


def _taken_off(T: Array, values: Array, prismatic: bool, *, column: bool = False) -> Array:
    """Return Z(values)^-1 T for poses (N, 4, 4), or Z(values)^T T when `column` (poses handed over transposed)."""
    out = np.array(T, order="K")
    if prismatic:
        # Z^-1 T takes the slide off the third row; transposed, Z^T adds it to the last row
        if column:
            out[:, 3] += values[:, None] * T[:, 2]
        else:
            out[:, 2] -= values[:, None] * T[:, 3]
        return out
    c, s = np.cos(values)[:, None], np.sin(values)[:, None]
    out[:, 0] = c * T[:, 0] + s * T[:, 1]
    out[:, 1] = c * T[:, 1] - s * T[:, 0]
    return out
