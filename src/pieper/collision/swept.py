"""Whether a path keeps clear: proved on the whole of it, seen to hit at a place, or too near to say."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

import numpy as np
import numpy.typing as npt

from pieper import arguments
from pieper.collision.distance import nearest
from pieper.collision.hulls import Hulls
from pieper.collision.levers import levers
from pieper.collision.model import Model
from pieper.errors import InputError
from pieper.kinematics.arrays import ArrayLike
from pieper.kinematics.forward import checked_joints
from pieper.tolerances import CLEARANCE_GAP, HULL_ROUNDING

Array = npt.NDArray[np.float64]
#: Points of a path at most: what is longer is a mistake in a sampling rate, and takes minutes.
MOST_POINTS = 10_000_000
#: Points whose distances are held at once.
AT_ONCE = 4096
#: Places at least at which the deepest of a path is looked for; how often, and at how many, it is looked closer.
PLACES, CLOSER, CLOSE = 256, 8, 17


class Clearance(Enum):
    """What a look at a whole path comes to."""

    CLEAR = "clear: proved"
    HIT = "hit"
    UNCERTAIN = "too near to the margin to say"


@dataclass(frozen=True, eq=False)
class Swept:
    """What was found of a path between whose points every joint moves evenly.

    Attributes:
        verdict: Clearance.CLEAR, HIT or UNCERTAIN.
        s: Where it first hits, or first is too near to say, in [0, 1] of the path, points evenly spread; 1 where clear.
        q: (n,) the posture there.
        pair: The names of the two bodies; empty where clear.
        depth: By how much that pair misses the margin at the deepest place of the path, m; 0 where nothing hits.
        margin: What was asked for, m.
        gap: How near to the margin a distance may be without being decided, m.
        looked: How many postures were looked at.
    """

    verdict: Clearance
    s: float
    q: Array
    pair: tuple[str, ...]
    depth: float
    margin: float
    gap: float
    looked: int

    def explain(self) -> str:
        """Return what was found in a sentence or two."""
        kept = (
            "any two bodies touch"
            if self.margin == 0
            else f"any two bodies come nearer than {1e3 * self.margin:.6g} mm"
        )
        if self.verdict is Clearance.CLEAR:
            return f"Clear: nowhere on the path, the ways between its points included, do {kept}; proved."
        pair = " and ".join(self.pair)
        if self.verdict is Clearance.HIT:
            how = "overlap by" if self.margin == 0 else "miss the margin by"
            where = "The path begins where" if self.s == 0 else f"Hit: at s = {self.s:.6g}"
            return f"{where} {pair} come too near; at worst they {how} {1e3 * self.depth:.6g} mm."
        return (
            f"Uncertain: at s = {self.s:.6g} {pair} are within {1e3 * self.gap:.3g} mm of the margin of "
            f"{1e3 * self.margin:.6g} mm, and nothing was found to be nearer."
        )

    def __repr__(self) -> str:
        return f"<Swept: {self.explain()}>"


def clear(model: Model, given: ArrayLike, margin: float = 0.0, *, gap: float = CLEARANCE_GAP) -> Swept:
    """Prove that a path (N, n) keeps bodies more than a margin apart, or say where it does not.

    Args:
        model: What must keep apart.
        given: (N, n) joint vectors, rad or m; between two of them every joint moves evenly. One posture (n,) is a path.
        margin: Distance to keep, m.
        gap: How near to the margin may remain undecided, m.

    Raises:
        InputError: A path that is none or longer than `MOST_POINTS`, a margin or gap that is no length.
    """
    for name, value in (("margin", margin), ("gap", gap)):
        if not isinstance(value, (int, float, np.floating)) or not np.isfinite(value) or value < 0:
            raise InputError(
                f"{name} must be a length of at least zero, m, got {arguments.kind_of(value)}.", given=value
            )
    q = np.atleast_2d(checked_joints(given, model.chain.n, "the path", prismatic=model.chain.prismatic))
    if q.ndim != 2 or not len(q):
        raise InputError(f"a path is (N, {model.chain.n}) joint vectors, at least one, got {q.shape}.", given=q.shape)
    if len(q) > MOST_POINTS:
        raise InputError(
            f"the path has {len(q):,} points; at most {MOST_POINTS:,} are looked at. Give it in parts, or fewer: "
            "the ways between them are proved too.",
            given=len(q),
        )
    margin, gap = float(margin), max(float(gap), 10 * model.slack)
    if not len(model.pairs):
        return Swept(Clearance.CLEAR, 1.0, q[-1].copy(), (), 0.0, margin, gap, 0)
    first = _first(model, q, margin, gap)
    if first is not None:
        return first
    hit, s, pair, metres, doubtful, doubtful_s, doubtful_pair, _, looked, left = model.native.sweep(
        model.chain_values(q), margin, gap, model.slack
    )
    place = (Clearance.HIT, s, pair, metres) if hit else None
    doubt = (Clearance.UNCERTAIN, doubtful_s, doubtful_pair, margin) if doubtful else None
    if left:
        search = _Search(model, q, margin, gap)
        for segment, k in sorted(left):
            if place is not None and segment > place[1]:
                break
            found = search.segment(segment, k)
            if found is not None and found[0] is Clearance.HIT and (place is None or found[1] < place[1]):
                place = found
            elif found is not None and found[0] is Clearance.UNCERTAIN and (doubt is None or found[1] < doubt[1]):
                doubt = found
        looked += search.looked
    found = place or doubt
    if found is None:
        return Swept(Clearance.CLEAR, 1.0, q[-1].copy(), (), 0.0, margin, gap, looked)
    verdict, s, pair, metres = found
    depth = margin - min(metres, _least(model, q, pair)) if verdict is Clearance.HIT else 0.0
    return Swept(verdict, _share(s, len(q)), _at(q, s), model.names_of(pair), depth, margin, gap, looked)


Found = tuple[Clearance, float, int, float]


def _first(model: Model, q: Array, margin: float, gap: float) -> Swept | None:
    """Return what is found where the path begins in what it must keep clear of."""
    metres, which, _, _ = nearest(model, q[:1])
    close = model.slack if which[0] < model.known else HULL_ROUNDING
    if metres[0] >= margin - close:
        return None
    depth = margin - min(float(metres[0]), _least(model, q, int(which[0])))
    return Swept(Clearance.HIT, 0.0, q[0].copy(), model.names_of(int(which[0])), depth, margin, gap, 1)


def _share(s: float, count: int) -> float:
    return float(s) / (count - 1) if count > 1 else 0.0


def _at(q: Array, s: float) -> Array:
    return postures_on(q, np.array([s]))[0]


def _least(model: Model, q: Array, pair: int) -> float:
    """Return the least distance of one pair on a path, m: at its points, between them, and closer about the least."""
    last = len(q) - 1
    each = max(1, -(-PLACES // max(last, 1)))
    at = np.linspace(0, last, last * each + 1)
    here = _apart(model, postures_on(q, at), pair)
    for _ in range(CLOSER if last else 0):
        k = int(np.argmin(here))
        at = np.linspace(at[max(k - 1, 0)], at[min(k + 1, len(at) - 1)], CLOSE)
        new = _apart(model, postures_on(q, at), pair)
        if new.min() > here.min():
            break
        here = new
    return float(here.min())


def postures_on(q: Array, at: Array) -> Array:
    """Return the postures (k, n) of a path (N, n) at places (k,), counted in its points."""
    i = np.clip(at.astype(int), 0, max(len(q) - 2, 0))
    return q[i] + (at - i)[:, None] * (q[np.minimum(i + 1, len(q) - 1)] - q[i])


def _apart(model: Model, q: Array, pair: int) -> Array:
    """Return the distances (N,) of one pair at postures (N, n), m."""
    if model.exact is not None and pair < model.known:
        parts = [model.exact.each(model.chain_values(q[i : i + AT_ONCE]))[:, pair] for i in range(0, len(q), AT_ONCE)]
        return np.concatenate(parts)
    hulls = Hulls(model)
    return np.array([hulls.between(pair, frames).least for frames in model.chain.native.frames(q, model.base)])


class _Search:
    """Halves segments until a pair beyond the kernel is proved clear on each, seen to hit, or too near to say."""

    def __init__(self, model: Model, q: Array, margin: float, gap: float) -> None:
        self._model, self._q, self._margin, self._gap = model, q, margin, max(gap, HULL_ROUNDING)
        self._hulls = Hulls(model)
        self.looked = 0

    def segment(self, segment: int, pair: int) -> Found | None:
        """Return the first place of a segment where the pair hits, or is too near to say; None where it is clear."""
        doubt: Found | None = None
        a, b = self._q[segment], self._q[min(segment + 1, len(self._q) - 1)]
        stack = [(0.0, 1.0)]
        hit: Found | None = None
        while stack:
            low, high = stack.pop()
            if hit is not None and segment + low >= hit[1]:
                continue
            middle = (low + high) / 2
            at, widths = a + middle * (b - a), np.abs(b - a) * (high - low) / 2
            self.looked += 1
            frames = self._model.chain.native.frames(at, self._model.base)
            found = self._hulls.between(pair, frames)
            way = self._way(pair, at, widths)
            if found.least - way > self._margin + self._model.slack:
                continue
            if found.said < self._margin - HULL_ROUNDING:
                hit = (Clearance.HIT, segment + middle, pair, found.least)
                if way > self._gap:
                    stack.append((low, middle))
                continue
            if way <= self._gap:
                doubt = doubt or (Clearance.UNCERTAIN, segment + middle, pair, found.least)
                continue
            stack += [(middle, high), (low, middle)]
        return hit or doubt

    def _way(self, pair: int, q: Array, widths: Array) -> float:
        """Return how far the two can come towards each other in a box of joint values about q."""
        coupling = self._model.chain.coupling
        change = widths if coupling is None else np.abs(coupling) @ widths
        return float(change @ levers(self._model, pair, q[None], change[None])[0])
