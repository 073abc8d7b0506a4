"""Work that may take longer than a blink: paths, clouds of reachable points, equations, reports; with progress and a stop."""

from __future__ import annotations

import base64
import threading
from collections.abc import Callable
from typing import Any

import numpy as np

import pieper
from pieper.workbench.messages import MAX_CLOUD, MAX_POINTS, pose, vector, whole, word

CHUNK = 5_000
Progress = Callable[[dict[str, Any]], None]


class Stopped(Exception):
    """The page no longer wants the result."""


def _go_on(stop: threading.Event) -> None:
    if stop.is_set():
        raise Stopped


def follow(arm: pieper.Arm, message: dict[str, Any], progress: Progress, stop: threading.Event) -> dict[str, Any]:
    """Follow a straight line from a start posture; every event with its cause, and the other branches."""
    start_pose, end_pose = pose(message.get("T0"), "start pose"), pose(message.get("T1"), "end pose")
    n = whole(message.get("n"), "N", 1, MAX_POINTS)
    path = pieper.line(start_pose, end_pose, n=n)
    start = vector(message.get("start"), arm.n, "start")
    _go_on(stop)
    track = arm.follow(path, start=start)
    return {
        "path": path.reshape(n, 16).tolist(),
        "q": np.asarray(track.q).tolist(),
        "complete": bool(track.complete),
        "events": [
            {"s": float(e.s), "joint": None if e.joint is None else str(e.joint), "cause": str(e.cause)} for e in track.events
        ],
        "branches": [branch_row(b) for b in track.branches],
    }


def branch_row(branch: Any) -> dict[str, Any]:
    """Return one starting branch and how far it goes."""
    out: dict[str, Any] = {}
    for key in ("label", "complete", "reached", "s", "cause"):
        value = getattr(branch, key, None)
        out[key] = value if value is None or isinstance(value, (str, bool)) else float(value)
    q = getattr(branch, "start", None)
    out["q"] = None if q is None else np.asarray(q, dtype=float).reshape(-1).tolist()
    return out


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
        _go_on(stop)
        size = min(CHUNK, count - done)
        q = rng.uniform(lower, upper, (size, arm.n))
        points = arm.fk(q)[:, :3, 3]
        values = _values(arm, q, points, colour, lower, upper)
        done += size
        block = np.column_stack([points, values]).astype("<f4")
        progress({"points": base64.b64encode(block.tobytes()).decode("ascii"), "done": done, "of": count})
    return {"done": done, "of": count}


def _ranges(arm: pieper.Arm) -> tuple[np.ndarray, np.ndarray]:
    """Return limits with a full turn, or one length of the arm, where there is none."""
    slides = np.array([t == "P" for t in arm.joint_types])
    size = max(sum(abs(r.a) + abs(r.d) for r in arm.description.rows), 0.1)
    free = np.where(slides, size, np.pi)
    lower = np.where(np.isfinite(arm.limits[:, 0]), arm.limits[:, 0], -free)
    upper = np.where(np.isfinite(arm.limits[:, 1]), arm.limits[:, 1], free)
    return np.minimum(lower, upper), upper


def _values(arm, q: np.ndarray, points: np.ndarray, colour: str, lower: np.ndarray, upper: np.ndarray) -> np.ndarray:
    if colour == "height":
        return points[:, 2]
    if colour == "limits":
        span = np.where(upper > lower, upper - lower, 1.0)
        return 2 * np.min(np.minimum(q - lower, upper - q) / span, axis=1)
    J = arm.jacobian(q).copy()
    J[:, :3] /= max(sum(abs(r.a) + abs(r.d) for r in arm.description.rows), 1e-9)
    values = np.linalg.svd(J, compute_uv=False)
    if colour == "manipulability":
        return np.prod(values, axis=1)
    return values[:, -1] / np.maximum(values[:, 0], 1e-300)


def equations(arm: pieper.Arm, message: dict[str, Any], progress: Progress, stop: threading.Event) -> dict[str, Any]:
    """Return the arm's equations as LaTeX, symbols or present numbers."""
    which = word(message.get("which"), "which", ("forward", "inverse"))
    progress({"note": "Deriving …"})
    result = arm.symbolic.fk() if which == "forward" else arm.symbolic.ik()
    _go_on(stop)
    return {"latex": result.latex()}


KINDS: dict[str, Callable] = {"follow": follow, "cloud": cloud, "equations": equations}
