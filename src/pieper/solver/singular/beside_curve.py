"""Which postures lie on a followed curve of seven joints: by the point in which it meets the plane across it there.

Where one direction is free and no more a curve is a line in joint space, however near another of the same pose passes.
Chords between samples say where to look; Newton's method within the plane across the chord says what is there.
"""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arrays import Array, Bools, Indices
from pieper.kinematics.chain import Chain
from pieper.kinematics.newton import pose_difference, scaled_jacobian, singular_values
from pieper.tolerances import BOTH_WEAK, CLOSES, FOLLOW_EXACT, FOLLOW_NONE, LED_AWAY, ON_CURVE, SAME_VOUCHED, TINY

#: So many stretches of a curve are looked at that come near a posture: one that bends back may pass it twice.
STRETCHES = 3
#: Samples of a curve at which it is asked whether solutions merge all along it.
LOOKED_AT = 5
#: Steps of Newton's method within a plane, from a cubic through four samples.
STEPS, LONGEST = 6, 0.1
#: A curve is no farther from a chord than this part of the chord's length.
SAG = 0.25
#: Postures whose distances to a curve are taken at once: it bounds the memory.
CHUNK = 256


def one_free(chain: Chain) -> bool:
    """Whether what holds a pose is a curve wherever it is regular: seven joints, none of which moves others."""
    return chain.n == 7 and chain.coupling is None


def is_known_exactly(chain: Chain, samples: Array) -> bool:
    """Whether a curve (k, n) is one of an arm of which `one_free` holds, and solutions do not merge all along it.

    Where they do, as with an elbow stretched between axes in one line, it is known to half the digits only.
    """
    some = samples[np.linspace(0, len(samples) - 1, LOOKED_AT).astype(int)]
    s = singular_values(chain, some) if one_free(chain) else np.zeros((1, 6))
    return bool(np.any(s[:, 5] > FOLLOW_NONE * s[:, 0]))


def on_followed(chain: Chain, T: Array, samples: Array, q: Array, closed: bool, within: float) -> Bools:
    """Return which of the postures q (m, n) lie within a distance of a curve (m,).

    Args:
        chain: An arm of which `one_free` holds.
        T: (4, 4) the pose.
        samples: (k, n) points along the curve, in order.
        q: The postures.
        closed: Whether the last sample is the first again.
        within: rad or lengths.
    """
    if len(samples) < 2:
        return np.linalg.norm(chain.joints.difference(q[:, None], samples), axis=-1).min(1, initial=np.inf) <= within
    return how_often_passed(chain, T, samples, q, closed, within) > 0


def how_often_passed(chain: Chain, T: Array, samples: Array, q: Array, closed: bool, within: float) -> Indices:
    """Return how often a curve of at least two samples passes postures q (m, n) within a distance (m,), as above."""
    out = np.zeros(len(q), np.int64)
    for i in range(0, len(q), CHUNK):
        which, segment, part = _stretches(chain, samples, q[i : i + CHUNK], within)
        if len(which):
            on = _meets(chain, T, _Place(samples, segment, part, closed), q[i + which], within)
            np.add.at(out, i + which, on)
    return out


class _Place:
    """Places on the chords of a curve: the chord's direction (m, n), and a point of the cubic through four samples."""

    def __init__(self, samples: Array, segment: Indices, part: Array, closed: bool) -> None:
        last = len(samples) - 1
        self.samples, self.segment = samples, segment
        self.before, self.after = segment - 1, segment + 2
        self.whole = samples[-1] - samples[0] if closed else np.zeros(samples.shape[1])
        self.closed, self.last, self.part = closed, last, part

    def four(self) -> Array:
        """Return (m, 4, n) the samples before, at both ends of and behind the chord; at an open end one twice."""
        s, last = self.samples, self.last
        if self.closed:
            first = np.where((self.before < 0)[:, None], s[last - 1] - self.whole, s[self.before])
            behind = np.where((self.after > last)[:, None], s[1] + self.whole, s[np.minimum(self.after, last)])
        else:
            first, behind = s[np.maximum(self.before, 0)], s[np.minimum(self.after, last)]
        return np.stack([first, s[self.segment], s[self.segment + 1], behind], 1)


def _stretches(chain: Chain, samples: Array, q: Array, within: float) -> tuple[Indices, Indices, Array]:
    """Return pairs of a posture (p,) and a chord (p,) that comes near it, and where on the chord (p,), 0 to 1."""
    gap = chain.joints.difference(q[:, None], samples)
    way = np.diff(samples / chain.joints.unit, axis=0)
    square = np.maximum(np.einsum("kn,kn->k", way, way), TINY)
    part = np.clip(np.einsum("mkn,kn->mk", gap[:, :-1], way) / square, 0.0, 1.0)
    away = np.linalg.norm(gap[:, :-1] - part[..., None] * way, axis=-1)
    lowest = np.minimum(np.roll(away, 1, 1), np.roll(away, -1, 1))
    lowest[:, 0], lowest[:, -1] = away[:, 1 % away.shape[1]], away[:, -2 % away.shape[1]]
    # a chord is no farther from the curve than a part of its own length
    near = (away <= lowest) & (away < SAME_VOUCHED + within + SAG * np.sqrt(square))
    away = np.where(near, away, np.inf)
    best = np.argsort(away, axis=1)[:, :STRETCHES]
    which, slot = np.nonzero(np.isfinite(np.take_along_axis(away, best, 1)))
    segment = best[which, slot]
    return which, segment, part[which, segment]


def _meets(chain: Chain, T: Array, place: _Place, q: Array, within: float) -> Bools:
    """Return whether a curve meets the planes across it through postures q (m, n) within a distance of these (m,)."""
    unit = chain.joints.unit
    four = place.four()
    along = (four[:, 2] - four[:, 1]) / unit
    along /= np.maximum(np.linalg.norm(along, axis=1, keepdims=True), TINY)
    # angles as the curve has them there
    q = four[:, 1] + chain.joints.difference(q, four[:, 1]) * unit
    point = _cubic(four, place.part, unit)
    held = np.full(len(q), np.inf)
    for _ in range(STEPS):
        e = pose_difference(chain, point, T)
        held = np.linalg.norm(e, axis=1)
        off = np.einsum("mn,mn->m", (q - point) / unit, along)
        A = np.concatenate([scaled_jacobian(chain, point), along[:, None]], 1)
        step = _solved(A, np.concatenate([e, off[:, None]], 1))
        size = np.linalg.norm(step, axis=1, keepdims=True)
        # where solutions merge all along a curve what is missed is rounding, and steps made of it lead away
        size[(held < ON_CURVE) & (np.abs(off) < within) & (size[:, 0] > LED_AWAY)] = np.inf
        step *= np.minimum(1.0, LONGEST / np.maximum(size, TINY))
        point = point + step * unit
        if np.abs(step).max() < within / 10 and held.max() < ON_CURVE:
            break
    away = np.linalg.norm((q - point) / unit, axis=1)
    # a double root is known to half the digits: it counts where the pose is missed ever less on the way to the curve
    blurred = np.flatnonzero((away > within) & (away < SAME_VOUCHED))
    ways = q[blurred] - point[blurred]
    missed_by = [np.linalg.norm(pose_difference(chain, point[blurred] + k * ways, T), axis=1) for k in (1.0, 0.5)]
    near = away <= within
    near[blurred] = (missed_by[0] < CLOSES) & (missed_by[1] <= np.maximum(missed_by[0], FOLLOW_EXACT))
    if not near.any():
        return near
    held = np.linalg.norm(pose_difference(chain, point, T), axis=1)
    near &= held < 10 * ON_CURVE
    # Newton's method may have slipped onto another curve that passes as near: it is on another side than both samples
    some = np.flatnonzero(near)
    there = bordered(chain, point[some], along[some])
    for end in (1, 2):
        other = ~same_side(bordered(chain, four[some, end], along[some]), there)
        some, there = some[other], there[other]
        if not len(some):
            return near
    near[some] = False
    return near


def _cubic(four: Array, part: Array, unit: Array) -> Array:
    """Return the points (m, n) at parts of the middle chords of cubics through four points each (m, 4, n)."""
    steps = np.linalg.norm(np.diff(four, axis=1) / unit, axis=2)
    at = np.stack([-steps[:, 0], np.zeros(len(four)), steps[:, 1], steps[:, 1] + steps[:, 2]], 1)
    x = part * steps[:, 1]
    chord = four[:, 1] + part[:, None] * (four[:, 2] - four[:, 1])
    weights = np.ones((len(four), 4))
    for i in range(4):
        for j in range(4):
            if i != j:
                gap = at[:, i] - at[:, j]
                weights[:, i] *= (x - at[:, j]) / np.where(gap == 0, np.inf, gap)
    whole = (np.diff(at, axis=1) > 0.02 * steps[:, 1:2]).all(1) & (steps[:, [0, 2]] < 50 * steps[:, 1:2]).all(1)
    return np.where(whole[:, None], np.einsum("mi,min->mn", weights, four), chord)


def _solved(A: Array, b: Array) -> Array:
    try:
        return np.asarray(np.linalg.solve(A, b[..., None])[..., 0], np.float64)
    except np.linalg.LinAlgError:
        return np.einsum("mij,mj->mi", np.linalg.pinv(A, rcond=FOLLOW_NONE), b)


def bordered(chain: Chain, q: Array, along: Array) -> Array:
    """Return the Jacobians (m, 7, 7) at q (m, 7), the way `along` (m, 7) of a curve beneath."""
    return np.concatenate([scaled_jacobian(chain, q), along[:, None]], 1)


def same_side(one: Array, other: Array) -> Bools:
    """Return whether what `bordered` gives at two places (m, 7, 7) is of curves on one side; rounding is on either.

    On the way along a curve it stays regular. Of two curves that pass each other beside a singular posture a direction
    is turned round between them, an elbow nearly straight bends either way: the one has a negative eigenvalue relative
    to the other, and the determinant another sign. With shoulder and wrist both all but in line two are turned round,
    and the determinant has one sign on both.
    """
    (sign, size), (other_sign, other_size) = np.linalg.slogdet(one), np.linalg.slogdet(other)
    known = np.minimum(size, other_size) > np.log(FOLLOW_NONE)
    same = ~known | (sign * other_sign > 0)
    both = np.flatnonzero(known & same & (np.minimum(size, other_size) < np.log(BOTH_WEAK)))
    if len(both):
        same[both] = (np.linalg.eigvals(np.linalg.solve(one[both], other[both])).real > 0).all(1)
    return same
