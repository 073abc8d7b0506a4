"""What a singular configuration looks like: facts about axes and points that hold on it and not in general.

The sentences are found by measuring sampled configurations, not by pattern-matching formulas, so they are true of the
arm at hand whatever its table looks like.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from pieper.algebra.arithmetics import NumpyField
from pieper.algebra.expression import Expr
from pieper.description.dh import Description
from pieper.document.blocks import listed
from pieper.kinematics.arrays import Array
from pieper.tolerances import (
    NO_DIRECTION,
    OFF_THE_GRID,
    PARALLEL_SAMPLED,
    SAMPLED_ANGLE,
    SAMPLED_GEOMETRY,
    SAMPLED_MOVES,
    SAMPLED_RANK,
)

SAMPLES = 8


def roots_on_factor(value: Any, joints: list[int], n: int, description: Description) -> np.ndarray:
    """Joint vectors (k, n) at which `value(q)` vanishes, the joints it does not mention drawn at random.

    Args:
        value: q (..., n) -> (...).
        joints: 1-based joints on which it depends.
        n: How many joints the arm has.
        description: The arm.
    """
    rng = np.random.default_rng(7)
    reach = 1.5 * sum(abs(row.a) + abs(row.d) for row in description.rows) + 0.5
    wide = np.array([reach if kind == "P" else np.pi for kind in description.joint_types])
    found = []
    for trial in range(40 * SAMPLES):
        if len(found) == SAMPLES:
            break
        q = rng.uniform(-1, 1, n) * wide
        joint = joints[trial % len(joints)] - 1
        grid = np.repeat(q[None], 361, axis=0)
        grid[:, joint] = np.linspace(-wide[joint], wide[joint], 361) + OFF_THE_GRID
        y = np.asarray(value(grid))
        changes = np.flatnonzero(np.sign(y[:-1]) * np.sign(y[1:]) <= 0)
        if not len(changes):
            continue
        place = changes[rng.integers(len(changes))]
        low, high = grid[place].copy(), grid[place + 1].copy()
        side = np.sign(value(low))
        for _ in range(60):
            middle = (low + high) / 2
            if np.sign(value(middle)) == side:
                low = middle
            else:
                high = middle
        found.append(high)
    return np.array(found).reshape(-1, n)


def facts_on(samples: np.ndarray, frames: Callable[..., Array], description: Description) -> list[str]:
    """Sentences that hold at every sample and not at a random posture."""
    rng = np.random.default_rng(8)
    generic = [_facts(frames(q), description) for q in rng.uniform(-1, 1, (3, samples.shape[1]))]
    always = set.union(*generic)
    special = set.intersection(*(_facts(frames(q), description) for q in samples)) - always
    best = min((rank for rank, _ in special), default=0)
    return [sentence for rank, sentence in sorted(special) if rank == best][:2]


def still_joints(samples: np.ndarray, rows: Any) -> str:
    """Which joints can move at once without moving the tool, when it is the same joints at every sample."""
    moving: frozenset[int] = frozenset()
    for q in samples:
        _, s, vt = np.linalg.svd(rows(q))
        n = vt.shape[0]
        rank = int(np.sum(s > SAMPLED_RANK * s[0]))
        if n - rank != 1:
            return ""
        null = np.abs(vt[-1]) / np.max(np.abs(vt[-1]))
        moving |= {int(j) + 1 for j in np.flatnonzero(null > SAMPLED_MOVES)}
    names = [str(j) for j in sorted(moving)]
    if len(names) == 1:
        return f"Joint {names[0]} alone does not move what the task asks for."
    if len(names) == samples.shape[1] and len(names) > 3:
        return "All joints take part in the motion that, at first order, leaves the tool where it is."
    return f"Joints {''.join(listed(names))} can move together without moving the tool (at first order)."


def _facts(F: np.ndarray, description: Description) -> set[tuple[int, str]]:
    """(priority, sentence) facts of one posture from its frames (n + 2, 4, 4)."""
    modified = description.convention == "modified"
    n = len(description.rows)
    axes = [F[j + 1 if modified else j][:3, 2] for j in range(n)]
    points = [F[j + 1 if modified else j][:3, 3] for j in range(n)]
    turning = [j for j in range(n) if description.joint_types[j] == "R"]
    size = max(sum(abs(r.a) + abs(r.d) for r in description.rows), NO_DIRECTION)
    centre = _wrist_centre(axes, points, turning, size)
    facts = set()
    for i, j in itertools.combinations(turning, 2):
        between = points[j] - points[i]
        cross = np.cross(axes[i], axes[j])
        sine = np.linalg.norm(cross)
        if sine < SAMPLED_ANGLE:
            apart = np.linalg.norm(between - (between @ axes[i]) * axes[i])
            if apart < SAMPLED_GEOMETRY * size:
                facts.add((0, f"Axes {i + 1} and {j + 1} lie on one line."))
            else:
                facts.add((3, f"Axes {i + 1} and {j + 1} are parallel."))
        elif abs(between @ cross) / sine < SAMPLED_GEOMETRY * size:
            facts.add((4, f"Axes {i + 1} and {j + 1} meet."))
    if centre is not None:
        what, where = centre
        for i in turning:
            offset = where - points[i]
            offset = offset - (offset @ axes[i]) * axes[i]
            if np.linalg.norm(offset) < SAMPLED_GEOMETRY * size and i < turning[-3]:
                facts.add((1, f"{what} lies on axis {i + 1}."))
        for i, j in itertools.combinations(turning[:-3], 2):
            normal = np.cross(axes[i], axes[j])
            if np.linalg.norm(normal) < SAMPLED_ANGLE:
                normal = np.cross(axes[i], points[j] - points[i])
            if np.linalg.norm(normal) > NO_DIRECTION and max(
                abs((where - points[i]) @ normal), abs((where - points[j]) @ normal)
            ) < SAMPLED_GEOMETRY * size * np.linalg.norm(normal):
                facts.add((2, f"{what} lies in the plane of axes {i + 1} and {j + 1}."))
        if len(turning) > 3 and abs(axes[0] @ axes[1]) < PARALLEL_SAMPLED:
            ahead = np.cross(axes[1], axes[0])
            if abs((where - points[0]) @ ahead) < SAMPLED_GEOMETRY * size:
                facts.add((3, f"{what} lies in the plane through axis 1 that runs along axis 2."))
    for i, j, k in itertools.combinations(turning, 3):
        if max(np.linalg.norm(np.cross(axes[i], axes[x])) for x in (j, k)) < SAMPLED_ANGLE:
            one, two = points[j] - points[i], points[k] - points[i]
            one, two = one - (one @ axes[i]) * axes[i], two - (two @ axes[i]) * axes[i]
            if np.linalg.norm(np.cross(one, two)) < SAMPLED_GEOMETRY * size**2:
                facts.add((1, f"The parallel axes {i + 1}, {j + 1} and {k + 1} lie in one plane: stretched or folded."))
    return facts


def _wrist_centre(axes: Sequence[Any], points: Sequence[Any], turning: Any, size: float) -> tuple[str, Any] | None:
    """(name, point) where the last three turning axes meet, or the last two."""
    for count, name in ((3, "The wrist centre"), (2, "The point where the last two axes meet")):
        if len(turning) < count + 1:
            continue
        chosen = turning[-count:]
        N = [np.eye(3) - np.outer(axes[j], axes[j]) for j in chosen]
        if np.linalg.svd(sum(N), compute_uv=False)[-1] < PARALLEL_SAMPLED:
            continue
        point = np.linalg.solve(sum(N), sum(M @ points[j] for M, j in zip(N, chosen, strict=True)))
        if (
            max(np.linalg.norm(M @ (point - points[j])) for M, j in zip(N, chosen, strict=True))
            < SAMPLED_GEOMETRY * size
        ):
            return name, point
    return None


def first_harmonic(expr: Expr, symbol: Any, constants: dict) -> tuple[float, float, float]:
    """a, b, c of a cos x + b sin x + c."""
    x = np.arange(8) * np.pi / 4
    y = np.broadcast_to(expr.evaluate(constants | {symbol: x}, NumpyField), x.shape)
    return float(2 * np.mean(y * np.cos(x))), float(2 * np.mean(y * np.sin(x))), float(np.mean(y))
