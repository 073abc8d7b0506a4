"""Capsules guessed from a DH table: along each axis and each common normal, thinner towards the tool."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from pieper.description.carry import carried
from pieper.description.dh import Description, Slid
from pieper.description.fold import chain_of, frames_of
from pieper.description.shapes import Body, Capsule, unique_names
from pieper.description.slid import with_short_rows
from pieper.kinematics.pose import inverse
from pieper.tolerances import SHORTEST_ARM, TINY

#: Radius of a guessed capsule at the base and at the tool, as a part of the links' lengths together. Measured links of
#: industrial arms are from 0.03 to 0.07.
THICK, THIN = 0.06, 0.03
#: Capsules shorter than this part of the lengths together are left out: the neighbours cover them.
SHORT = 0.01
#: Guessed capsules shall overlap in no more than this part of the postures inside the limits; they are made thinner for
#: it, down to this part of their first radius,
OFTEN = 0.1
THINNEST = 0.6
#: leaving this part of what is between them,
ROOM = 0.9
#: and where they overlap in more than this part all the same, they are one piece, which may touch itself.
MOSTLY = 0.3
POSTURES = 256
SOURCE = "guessed from the DH table"

Array = npt.NDArray[np.float64]


@dataclass(slots=True, eq=False)
class _Line:
    """A stretch of the table: its link, name and ends (3,) in the link's frame, m; and the radius about it."""

    on: int
    name: str
    a: Array
    b: Array
    radius: float = 0.0

    @property
    def length(self) -> float:
        return float(np.linalg.norm(self.b - self.a))


def guessed(arm: Description) -> tuple[tuple[Body, ...], set[frozenset[str]]]:
    """Return capsules about the lines of an arm's table, and the pairs of them that count as one piece.

    What lies along a joint's axis does not move with it in space, so that it may be said of either link; a slide is a
    rod as long as its way, and a sleeve as long as its shortest.
    """
    short = with_short_rows(arm)
    if short is not arm:
        # a table that leads to far common normals is no picture of the arm
        own, one_piece = guessed(short)
        zero = np.zeros(arm.n)
        return carried(replace(short, bodies=own, unmeasured=None), arm, zero, zero), one_piece
    lines = _lines(arm)
    total = max(sum(line.length for line in lines), SHORTEST_ARM)
    thick = [line for line in lines if line.length >= SHORT * total]
    for line in thick:
        line.radius = (THICK + (THIN - THICK) * min(line.on / len(arm.rows), 1.0)) * total
    least = {line.name: THINNEST * line.radius for line in thick}
    pairs = [(a, b) for i, a in enumerate(thick) for b in thick[i + 2 :] if min(b.on, len(arm.rows)) > a.on]
    one_piece: set[frozenset[str]] = set()
    for (a, b), apart in zip(pairs, _apart(arm, pairs).T, strict=True):
        wanted = ROOM * float(np.quantile(apart, OFTEN)) / (a.radius + b.radius)
        if wanted < 1.0:
            a.radius, b.radius = (max(line.radius * wanted, least[line.name]) for line in (a, b))
    for (a, b), apart in zip(pairs, _apart(arm, pairs).T, strict=True):
        if np.mean(apart < a.radius + b.radius) > MOSTLY:
            one_piece.add(frozenset((a.name, b.name)))
    return tuple(Body(x.name, x.on, Capsule(x.a, x.b, x.radius), SOURCE) for x in thick), one_piece


def _apart(arm: Description, pairs: list[tuple[_Line, _Line]]) -> Array:
    """Return how far pairs of lines are apart in postures inside the limits, (postures, pairs), m."""
    if not pairs:
        return np.empty((POSTURES, 0))
    free = [
        sorted(arm.sign[j] * x for x in _way(arm, j)) if kind == "P" else (-np.pi, np.pi)
        for j, kind in zip(arm.own_axes, arm.joint_types, strict=True)
    ]
    low, high = np.where(np.isfinite(arm.limits), arm.limits, np.array(free)).T
    q = np.random.default_rng(0).uniform(np.minimum(low, high), np.maximum(low, high), (POSTURES, arm.n))
    frames = chain_of(arm).native.frames(q, arm.base)
    lines = list({id(line): line for pair in pairs for line in pair}.values())
    ends = {}
    for line in lines:
        R, p = frames[:, line.on, :3, :3], frames[:, line.on, :3, 3]
        ends[line.name] = np.stack([R @ line.a + p, R @ line.b + p], 1)
    return np.stack([segment_distance(ends[a.name], ends[b.name]) for a, b in pairs], 1)


def segment_distance(one: Array, other: Array) -> Array:
    """Return the distances (N,) of segments (N, 2, 3): where the lines are nearest, or from an end."""
    p, u = one[:, 0], one[:, 1] - one[:, 0]
    q, v = other[:, 0], other[:, 1] - other[:, 0]
    w = p - q
    A, E, B, C, D = (np.einsum("nc,nc->n", x, y) for x, y in ((u, u), (v, v), (u, v), (u, w), (v, w)))
    A, E = np.maximum(A, TINY), np.maximum(E, TINY)
    s = np.clip((B * D - C * E) / np.maximum(A * E - B * B, TINY), 0.0, 1.0)
    tries = [(s, np.clip((B * s + D) / E, 0.0, 1.0))]
    tries += [(np.full(len(A), end), np.clip((B * end + D) / E, 0.0, 1.0)) for end in (0.0, 1.0)]
    tries += [(np.clip((B * end - C) / A, 0.0, 1.0), np.full(len(A), end)) for end in (0.0, 1.0)]
    return np.min([np.linalg.norm(w + x[:, None] * u - y[:, None] * v, axis=1) for x, y in tries], axis=0)


def _lines(arm: Description) -> list[_Line]:
    """Return every stretch of the table that has a length, from the base to the tool."""
    at_zero = frames_of(arm, np.zeros(arm.n))
    out: list[_Line] = []

    def add(on: int, name: str, a: Array, b: Array) -> None:
        if np.linalg.norm(b - a) > 0.0:
            T = inverse(at_zero[on])
            out.append(_Line(on, name, T[:3, :3] @ a + T[:3, 3], T[:3, :3] @ b + T[:3, 3]))

    standard = arm.convention == "standard"
    for k, row in enumerate(arm.rows, 1):
        before, after = at_zero[k - 1], at_zero[k]
        # along the common normal, on the link behind the joint or, of a modified table, before it; and along the axis
        corner = after[:3, 3] - row.a * after[:3, 0] if standard else before[:3, 3] + row.a * before[:3, 0]
        if isinstance(row, Slid):
            corner = corner - row.f * np.cross(before[:3, 2], after[:3, 0])
        start, end = (before[:3, 3], corner) if standard else (corner, after[:3, 3])
        axis = before[:3, 2] if standard else after[:3, 2]
        name = arm.axis_names[k - 1]
        if not standard:
            add(k - 1, arm.axis_names[k - 2] if k > 1 else "base", before[:3, 3], corner)
        if arm.axis_types[k - 1] == "P":
            low, high = _way(arm, k - 1)
            add(k - 1, f"{name} sleeve", start, end + low * axis)
            add(k, f"{name} rod", end - (high - low) * axis, end)
        elif k == 1:
            add(0, "base", start, end)
        else:
            add(k, f"{name} axis", start, end)
        if standard:
            add(k, name, corner, after[:3, 3])
    add(len(arm.rows) + 1, "tool", at_zero[-2][:3, 3], at_zero[-1][:3, 3])
    for line, name in zip(out, unique_names([line.name for line in out]), strict=True):
        line.name = name
    return out


def _way(arm: Description, axis: int) -> tuple[float, float]:
    """Return how far a slide goes from zero along its axis, m; as the longest link where it has no limits."""
    own = arm.own_axes
    low, high = (float(v) for v in arm.limits[own.index(axis)]) if axis in own else (-np.inf, np.inf)
    if not (np.isfinite(low) and np.isfinite(high)):
        low, high = 0.0, max(SHORTEST_ARM, *(abs(row.d) + abs(row.a) for row in arm.rows))
    return (low, high) if arm.sign[axis] > 0 else (-high, -low)
