"""Where one joint brings four turning axes parallel: a planar linkage moves by itself there, whatever the family."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.chain import Chain
from pieper.kinematics.joints import TURN, short_way
from pieper.kinematics.newton import missed, newton, size_of
from pieper.kinematics.pose import rotation_about, rotation_z, translation
from pieper.solver.singular.linkage_motion import LinkageMotion
from pieper.solver.singular.self_motion import SelfMotion
from pieper.tolerances import (
    BLURRED_TO,
    GEOMETRY_EXACT,
    HOLDS_EXACTLY,
    LINKAGE_STARTS,
    LOOP_TOUCHES,
    ON_POLYLINE,
    PRECISE_RANK,
    SAME_ROW,
    TINY,
)

#: Newton steps onto a pose with the joint held: each halves what is left where the linkage is stretched.
STEPS = 40
#: How a linkage goes through its curve: the leading joint turns back, or goes round with the one opposite above its
#: phase or below it (kernels/singular/motions.hpp).
BACK, ABOVE, BELOW = 0, 1, 2


@dataclass(frozen=True)
class Parallel:
    """Where four turning axes become parallel.

    Args:
        joint: The joint (0-based) that brings them there.
        value: Where it stands, rad.
        four: The four joints (0-based), ascending.
    """

    joint: int
    value: float
    four: tuple[int, int, int, int]


def four_parallel(chain: Chain) -> tuple[Parallel, ...]:
    """Return where a turning joint of six brings the axes before and behind it parallel, four in all."""
    if chain.n != 6 or chain.coupling is not None:
        return ()
    return tuple(one for k in range(1, 5) if not chain.prismatic[k] for one in _brought(chain, k))


def _brought(chain: Chain, k: int) -> list[Parallel]:
    """Return where joint k brings four axes parallel: those side by side before it, and those behind it."""
    before, behind = _run(chain, range(k - 1, -1, -1)), _run(chain, range(k + 1, chain.n))
    four = (*reversed(before), *behind)
    if not (before and behind) or len(four) != 4:
        return []
    about, b, c = chain.axes[k], chain.axes[before[0]], chain.axes[behind[0]]
    wanted, turned = b - (b @ about) * about, c - (c @ about) * about
    if np.linalg.norm(wanted) < GEOMETRY_EXACT:
        return []
    found: list[Parallel] = []
    (rest,) = set(range(chain.n)) - {k, *four}
    for sense in (1.0, -1.0):
        value = float(np.arctan2(np.cross(turned, sense * wanted) @ about, turned @ (sense * wanted)))
        R = rotation_about(about, value)
        # a slide across the axes moves with them: that is a surface
        slides = chain.axes[rest] if rest < k else R @ chain.axes[rest]
        across = bool(chain.prismatic[rest]) and abs(slides @ b) < GEOMETRY_EXACT
        if np.linalg.norm(R @ c - sense * b) < GEOMETRY_EXACT and not across:
            found.append(Parallel(k, value, (four[0], four[1], four[2], four[3])))
    return found


def _run(chain: Chain, joints: range) -> list[int]:
    """Return the turning joints of `joints` with axes parallel to the first of them; slides turn none of them."""
    found: list[int] = []
    for joint in joints:
        if chain.prismatic[joint]:
            continue
        if found and np.linalg.norm(np.cross(chain.axes[joint], chain.axes[found[0]])) > GEOMETRY_EXACT:
            break
        found.append(joint)
    return found


def linkages(
    chain: Chain, T: Array, near: Array, limits: Array, names: tuple[str, ...], shown: int
) -> tuple[list[SelfMotion], Array]:
    """Return the self-motions of four parallel axes that hold a pose, and postures (k, n) where a linkage cannot move.

    Args:
        chain: The arm and the task's virtual joints.
        T: (4, 4) the pose.
        near: (k, n) joint vectors from which postures are sought.
        limits: (n, 2).
        names: Joint names.
        shown: Number of joints that are the arm's own.
    """
    motions: list[SelfMotion] = []
    stuck: list[Array] = []
    for at in four_parallel(chain):
        others = np.setdiff1d(np.arange(chain.n), at.four)
        told: list[Array] = []
        for through in _postures(chain, at, T, near):
            # the joints that stand still leave one linkage, and all its pieces are told at once
            still = np.where(np.isin(np.arange(chain.n), others), through, 0.0)
            if any(chain.joints.apart(still, other) < SAME_ROW for other in told):
                continue
            if any(motion.distance(through) < ON_POLYLINE for motion in motions):
                continue
            pieces = _pieces(chain, at, through)
            told.append(still)
            if pieces is None:
                stuck.append(through)
                continue
            motions += [LinkageMotion(chain, T, limits, names, shown, through, one) for one in pieces]
    found = np.array(stuck).reshape(-1, chain.n)
    return motions, found[chain.joints.distinct(found, LINKAGE_STARTS)]


def about_four_parallel(chain: Chain, q: Array) -> Bools:
    """Return which joint vectors (k, n) stand about where four axes are parallel (k,)."""
    found = np.zeros(len(q), bool)
    for at in four_parallel(chain):
        found |= np.abs(short_way(q[:, at.joint] - at.value)) < BLURRED_TO
    return found


def elsewhere(chain: Chain, q: Array, T: Array, moving: Sequence[SelfMotion], stuck: Array) -> Array:
    """Return singular rows q (k, n) without what only nearly holds the pose about a linkage.

    Its shortest link may be turned where it cannot move (m, n), or beyond where its curve turns back, and the pose is
    nearly held: of a link of 1e-9 m no row tells where it stands.
    """
    if not len(q) or not (moving or len(stuck)):
        return q
    about = np.full(len(q), len(stuck) > 0)
    for motion in moving:
        about |= motion.distances(q) < BLURRED_TO
    keep = ~about | (missed(chain, q, T) < HOLDS_EXACTLY * size_of(chain, T))
    if len(stuck):
        keep &= chain.joints.apart(q[:, None], stuck[None]).min(1) > BLURRED_TO
    return q[keep]


def _postures(chain: Chain, at: Parallel, T: Array, near: Array) -> Array:
    """Return postures (k, n) with four parallel axes that hold a pose, from joint vectors (m, n), the best first."""
    held = chain.locked(at.joint, at.value)
    q = newton(held, np.delete(near, at.joint, axis=1), T, steps=STEPS, cutoff=PRECISE_RANK)
    q = np.insert(q, at.joint, at.value, axis=1)
    q = q[missed(chain, q, T) < LINKAGE_STARTS]
    q = np.array([*q, *(_closed(chain, at, one, T) for one in q)]).reshape(-1, chain.n)
    miss = missed(chain, q, T)
    q = q[np.argsort(miss, kind="stable")]
    return q[: int(np.count_nonzero(miss < HOLDS_EXACTLY * size_of(chain, T)))]


def _pieces(chain: Chain, at: Parallel, q: Array) -> list[tuple[Any, ...]] | None:
    """Return what `LinkageMotion` is told of every piece of the curve through q (n,); None where it cannot move.

    Where courses cross, or a link has no length, it is nothing that is told here.
    """
    axes, spots, senses, _ = _seen(chain, at, q)
    told = np.array(at.four), axes, spots, senses
    best: tuple[int, float, float, float] | None = None
    for lead in range(4):
        (middle, size, phase), (other_middle, other_size, _) = _sides(spots, senses, lead)
        if min(size, other_size) <= LOOP_TOUCHES:
            continue
        top = (other_middle + other_size - middle) / size
        bottom = (other_middle - other_size - middle) / size
        blur = LOOP_TOUCHES * (1 + abs(middle) + size + other_size) / size
        if min(abs(top + 1), abs(bottom - 1)) < blur:
            return None
        if min(abs(top - 1), abs(bottom + 1)) < blur:
            continue
        least = 0.0 if top >= 1 else float(np.arccos(max(top, -1.0)))
        most = np.pi if bottom <= -1 else float(np.arccos(min(bottom, 1.0)))
        if best is None or (most - least > best[3] - best[2]):
            best = lead, phase, least, most
    if best is None:
        return []
    lead, phase, least, most = best
    if least == 0 and most == np.pi:
        return [(*told, lead, phase - np.pi, phase + np.pi, course) for course in (ABOVE, BELOW)]
    if least == 0:
        return [(*told, lead, phase - most, phase + most, BACK)]
    if most == np.pi:
        return [(*told, lead, phase + least, phase + TURN - least, BACK)]
    ends = sorted((phase + least, phase + most)), sorted((phase - least, phase - most))
    return [(*told, lead, low, high, BACK) for low, high in ends]


def _seen(chain: Chain, at: Parallel, q: Array) -> tuple[Array, Array, Array, Array]:
    """Return the four axes (4, 3) at q (n,), their spots (4,) in the plane across, their senses (4,), and the plane.

    Spots are complex numbers, per length. The plane is two ways across the axes and the point where it starts, (3, 3).
    """
    frame, axes, points = chain.links[0], np.empty((chain.n, 3)), np.empty((chain.n, 3))
    for j in range(chain.n):
        axes[j], points[j] = frame[:3, 2], frame[:3, 3]
        frame = frame @ (translation(z=q[j]) if chain.prismatic[j] else rotation_z(q[j])) @ chain.links[j + 1]
    axes, points = axes[list(at.four)], points[list(at.four)]
    n = axes[0]
    x = np.cross(n, np.eye(3)[int(np.argmin(np.abs(n)))])
    x /= np.linalg.norm(x)
    y, away = np.cross(n, x), (points - points[0]) / chain.length
    return axes, away @ x + 1j * (away @ y), np.where(axes @ n < 0, -1.0, 1.0), np.array([x, y, points[0]])


def _sides(spots: Array, senses: Array, lead: int) -> list[tuple[float, float, float]]:
    """Return middle, size and phase of what must be equal: of the leading joint's angle, and of the one opposite."""
    found: list[tuple[float, float, float]] = []
    second, fourth = (lead + 1) % 4, (lead + 3) % 4
    for i, sign in ((lead, -1.0), ((lead + 2) % 4, 1.0)):
        m = 2 * np.conj(spots[i] - spots[second]) * (spots[fourth] - spots[i])
        sine = -sign * senses[i] * m.imag
        middle = abs(spots[i] - spots[second]) ** 2 + abs(spots[fourth] - spots[i]) ** 2
        found.append((float(middle), float(np.hypot(m.real, sine)), float(np.arctan2(sine, m.real))))
    return found


def _closed(chain: Chain, at: Parallel, q: Array, T: Array) -> Array:
    """Return q (n,) with the four joints put where their links close, which Newton's method nears slowly if stretched.

    The shortest link keeps its way as far as the others reach, and they make a triangle with what is left.
    """
    _, spots, senses, (x, y, origin) = _seen(chain, at, q)
    off = T @ np.linalg.inv(chain.native.fk(q))
    turn = float(np.arctan2(off[:3, :3] @ x @ y, off[:3, :3] @ x @ x))
    away = (off[:3, :3] @ origin + off[:3, 3] - origin) / chain.length
    moved = complex(away @ x, away @ y) + np.exp(1j * turn) * spots[3]
    links, whole = np.diff(spots), moved - spots[0]
    lengths = np.abs(links)
    short = int(np.argmin(lengths))
    a, b = (k for k in range(3) if k != short)
    ways = np.angle(links)
    left = whole - links[short]
    if not abs(lengths[a] - lengths[b]) <= abs(left) <= lengths[a] + lengths[b]:
        too_far = abs(left) > lengths[a] + lengths[b]
        ways[short] = np.angle(whole if too_far else -whole)
        left = whole - lengths[short] * np.exp(1j * ways[short])
    r = max(abs(left), TINY)
    cosine = (lengths[a] ** 2 + r**2 - lengths[b] ** 2) / max(2 * lengths[a] * r, TINY)
    side = 1.0 if (np.conj(left) * links[a]).imag >= 0 else -1.0
    ways[a] = np.angle(left) + side * np.arccos(np.clip(cosine, -1.0, 1.0))
    ways[b] = np.angle(left - lengths[a] * np.exp(1j * ways[a]))
    turned = np.asarray(short_way(ways - np.angle(links)))
    out = q.copy()
    out[list(at.four)] += senses * short_way(np.diff(np.concatenate([[0.0], turned, [turn]])))
    return out
