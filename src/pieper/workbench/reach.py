"""Where the tool can be, for the picture: a cloud of random postures, or a map of voxels that are solved completely."""

from __future__ import annotations

import base64
import threading
import time
from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

import pieper
from pieper.tolerances import SMALLEST_VOXEL, TINY
from pieper.workbench.messages import MAX_CLOUD, Refused, go_on, number, whole, word

CHUNK = 5_000
#: Voxels of a map, at most; random postures that say how far it must go.
MAX_VOXELS, SOUNDINGS = 200_000, 4_000
#: Seconds that a page waits for a piece of a map, and poses that say how long one will take.
PATIENCE, TRIED = 1.0, 16
#: Directions of the tool's z axis that a voxel is asked in, and rolls about each.
ORIENTATIONS = (32, 4)
COLOURS = ("fraction", "count", "manipulability", "margin")
Progress = Callable[[dict[str, Any]], None]


def cloud(arm: pieper.Arm, message: dict[str, Any], progress: Progress, stop: threading.Event) -> dict[str, Any]:
    """Send reachable tool points of random postures inside the limits, each with the value it is coloured by.

    Points go out in pieces of CHUNK, four float32 each: x, y, z (m) and the value.
    """
    count = whole(message.get("count"), "number of points", 1, MAX_CLOUD)
    colour = word(message.get("colour", "height"), "colour", ("height", "manipulability", "condition", "limits"))
    seed = whole(message.get("seed", 1), "seed", 0, 2**31)
    lower, upper = _ranges(arm)
    rng = np.random.default_rng(seed)
    done = 0
    while done < count:
        go_on(stop)
        size = min(CHUNK, count - done)
        q = rng.uniform(lower, upper, (size, arm.n))
        points = arm.fk(q)[:, :3, 3]
        values = _values(arm, q, points, colour, lower, upper)
        done += size
        progress({"points": _packed(points, values), "done": done, "of": count})
    return {"done": done, "of": count}


def _ranges(arm: pieper.Arm) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
    """Return limits with a full turn, or one length of the arm, where there is none."""
    slides = np.array([t == "P" for t in arm.joint_types])
    size = max(arm.chain.length, 0.1)
    free = np.where(slides, size, np.pi)
    lower = np.where(np.isfinite(arm.limits[:, 0]), arm.limits[:, 0], -free)
    upper = np.where(np.isfinite(arm.limits[:, 1]), arm.limits[:, 1], free)
    return np.minimum(lower, upper), upper


def _values(
    arm: pieper.Arm,
    q: npt.NDArray[np.float64],
    points: npt.NDArray[np.float64],
    colour: str,
    lower: npt.NDArray[np.float64],
    upper: npt.NDArray[np.float64],
) -> npt.NDArray[np.float64]:
    if colour == "height":
        return points[:, 2]
    if colour == "limits":
        span = np.where(upper > lower, upper - lower, 1.0)
        return 2 * np.min(np.minimum(q - lower, upper - q) / span, axis=1)
    if colour == "manipulability":
        return arm.aspects(q).manipulability
    J = arm.jacobian(q).copy()
    J[:, :3] /= arm.chain.length
    values = np.linalg.svd(J, compute_uv=False)
    return values[:, -1] / np.maximum(values[:, 0], TINY)


def _packed(points: npt.NDArray[np.float64], values: npt.NDArray[np.float64]) -> str:
    """Return points and their values, four float32 each, in base64."""
    return base64.b64encode(np.column_stack([points, values]).astype("<f4").tobytes()).decode("ascii")


def voxels(arm: pieper.Arm, message: dict[str, Any], progress: Progress, stop: threading.Event) -> dict[str, Any]:
    """Send the voxels of a reach map layer by layer, each with the value it is coloured by.

    The first piece says the box: `low` (m), `shape` and `step` (m). Layers are solved one after another, so that a page
    sees the map grow and can stop it; of an arm whose poses take long, row by row.
    """
    step = number(message.get("step"), "voxel, m")
    colour = word(message.get("colour", "fraction"), "colour", COLOURS)
    if step < SMALLEST_VOXEL:
        raise Refused(f"A voxel's side must be at least {SMALLEST_VOXEL:g} m, not {step:g}.")
    low, shape = _box(arm, step)
    progress({"low": low.tolist(), "shape": list(shape), "step": step, "done": 0, "of": 1})
    x, y, z = (
        [(float(a + i * step), float(a + (i + 1) * step)) for i in range(n)] for a, n in zip(low, shape, strict=True)
    )
    per_layer = shape[0] * shape[1] * ORIENTATIONS[0] * ORIENTATIONS[1]
    rows = y if per_layer * _seconds_a_pose(arm) > PATIENCE else [(y[0][0], y[-1][1])]
    pieces = [(row, layer) for layer in z for row in rows]
    reached, volume = 0, 0.0
    for done, (row, layer) in enumerate(pieces):
        go_on(stop)
        box = ((x[0][0], x[-1][1]), row, layer)
        found = arm.reach_map(box, step, orientations=ORIENTATIONS, measure=colour in ("manipulability", "margin"))
        inside = np.flatnonzero(found.fraction.ravel() > 0)
        packed = _packed(found.voxels().points, np.asarray(getattr(found, colour), float).ravel()[inside])
        reached, volume = reached + len(inside), volume + found.volume
        progress({"points": packed, "done": done + 1, "of": len(pieces)})
    return {"reached": reached, "volume": volume, "orientations": ORIENTATIONS[0] * ORIENTATIONS[1]}


def _seconds_a_pose(arm: pieper.Arm) -> float:
    lower, upper = _ranges(arm)
    poses = arm.fk(np.random.default_rng(0).uniform(lower, upper, (TRIED, arm.n)))
    arm.ik_many(poses)  # the first call prepares
    began = time.perf_counter()
    arm.ik_many(poses)
    return (time.perf_counter() - began) / TRIED


def _box(arm: pieper.Arm, step: float) -> tuple[npt.NDArray[np.float64], tuple[int, int, int]]:
    """Return the lowest corner, whole steps from the origin, and how many voxels hold where the tool gets.

    Raises:
        Refused: More voxels than a page is sent.
    """
    lower, upper = _ranges(arm)
    q = np.random.default_rng(0).uniform(lower, upper, (SOUNDINGS, arm.n))
    points = arm.fk(q)[:, :3, 3]
    low, high = np.floor(points.min(0) / step) - 1, np.ceil(points.max(0) / step) + 1
    if (count := float(np.prod(high - low))) > MAX_VOXELS:
        raise Refused(f"Voxels of {step * 1e3:g} mm are {count:z,.0f}; at most {MAX_VOXELS:,}.")
    nx, ny, nz = (high - low).astype(int).tolist()
    return low * step, (nx, ny, nz)


LONG: dict[str, Callable[..., dict[str, Any]]] = {"cloud": cloud, "voxels": voxels}
