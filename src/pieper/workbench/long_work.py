"""Work that may take longer than a blink: paths, clouds, equations, reports; with progress and a stop."""

from __future__ import annotations

import base64
import tempfile
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

import pieper
from pieper.tolerances import NO_DIRECTION, SLOWEST_RATE, TINY
from pieper.workbench import answers, equation_blocks, films, programs, routes
from pieper.workbench.messages import (
    MAX_CLOUD,
    MAX_POINTS,
    MAX_POSTURES,
    Refused,
    number,
    pose,
    vector,
    vectors,
    whole,
    word,
)

CHUNK = 5_000
#: Seconds of a whole sequence, and samples that are sent of one.
LONGEST_SEQUENCE, MAX_SAMPLES = 3_600, 4_000
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
        "q": np.asarray(track.followed).tolist(),
        "complete": bool(track.complete),
        "chosen": track.chosen,
        "explain": track.explain(),
        "events": [
            {"s": float(e.s), "joint": e.joint, "cause": e.cause, "stop": bool(e.stop), "text": str(e)}
            for e in track.events
        ],
        "branches": [
            {
                "label": b.label,
                "complete": bool(b.complete),
                "s": float(b.s),
                "points": b.points,
                "cause": "" if b.stop is None else str(b.stop),
                "q": b.q[0].tolist() if len(b.q) else None,
            }
            for b in track.branches
        ],
        "residual": [float(v) for v in (track.residual.max(0) if len(track.residual) else (0.0, 0.0))],
    }


def self_motions(arm: pieper.Arm, message: dict[str, Any], progress: Progress, stop: threading.Event) -> dict[str, Any]:
    """Return the self-motions of a pose of a redundant arm."""
    found = answers.solve(arm, message).self_motions
    _go_on(stop)
    return {"self_motions": [answers.motion_points(motion, arm.n) for motion in found]}


def motion(arm: pieper.Arm, message: dict[str, Any], progress: Progress, stop: threading.Event) -> dict[str, Any]:
    """Move from posture to posture in time, at rest in each; joint values and rates at every sample."""
    postures = vectors(message.get("postures"), arm.n, "posture", MAX_POSTURES)
    legs = len(postures) - 1
    if legs < 1:
        raise Refused("A sequence needs at least two postures.")
    seconds = vector(message.get("seconds"), legs, "seconds")
    holds = vector(message.get("holds"), legs, "holds")
    total = float(seconds.sum() + holds.sum())
    if np.any(seconds <= 0) or np.any(holds < 0) or total > LONGEST_SEQUENCE:
        raise Refused(f"Legs take more than 0 s, rests 0 s or more, and all together at most {LONGEST_SEQUENCE} s.")
    rate = min(number(message.get("rate", 50), "rate", largest=1000), MAX_SAMPLES / total)
    moved = pieper.sequence(postures, seconds, holds, rate=max(rate, SLOWEST_RATE))
    _go_on(stop)
    return {
        "t": moved.t.tolist(),
        "q": moved.q.tolist(),
        "dq": moved.dq.tolist(),
        "arrivals": moved.arrivals.tolist(),
        "departures": moved.departures.tolist(),
    }


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


def _ranges(arm: pieper.Arm) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
    """Return limits with a full turn, or one length of the arm, where there is none."""
    slides = np.array([t == "P" for t in arm.joint_types])
    size = max(sum(abs(r.a) + abs(r.d) for r in arm.description.rows), 0.1)
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
    J = arm.jacobian(q).copy()
    J[:, :3] /= max(sum(abs(r.a) + abs(r.d) for r in arm.description.rows), NO_DIRECTION)
    values = np.linalg.svd(J, compute_uv=False)
    if colour == "manipulability":
        return np.prod(values, axis=1)
    return values[:, -1] / np.maximum(values[:, 0], TINY)


def equations(arm: pieper.Arm, message: dict[str, Any], progress: Progress, stop: threading.Event) -> dict[str, Any]:
    """Return the arm's equations as blocks for the page: forward, inverse, or its singular configurations."""
    which = word(message.get("which"), "which", ("forward", "inverse", "singular"))
    numbers = word(message.get("numbers", "symbols"), "numbers", ("symbols", "numbers"))
    progress({"note": "Deriving …"})
    try:
        if which == "forward":
            return {"blocks": equation_blocks.forward_blocks(arm, numbers)}
        return {
            "blocks": equation_blocks.inverse_blocks(arm)
            if which == "inverse"
            else equation_blocks.singular_blocks(arm)
        }
    except ImportError as missing:
        raise Refused(f"These equations are not available in this installation ({missing}).") from None


def report(arm: pieper.Arm, message: dict[str, Any], progress: Progress, stop: threading.Event) -> dict[str, Any]:
    """Return the report of the arm at a posture, as one HTML page."""
    q = vector(message.get("q"), arm.n, "q")
    progress({"note": "Writing the report …"})
    with tempfile.TemporaryDirectory(prefix="pieper-") as folder:
        _go_on(stop)
        path = Path(folder) / "report.html"
        try:
            pieper.write_report(arm, path, pose=arm.fk(q))
        except ImportError as missing:
            raise Refused(f"Reports are not available in this installation ({missing}).") from None
        return {"html": path.read_text(encoding="utf-8"), "name": f"{_file_name(arm.name)}-report.html"}


def _file_name(name: str) -> str:
    return "".join(c if c.isalnum() or c in "-_." else "-" for c in name)[:60] or "arm"


KINDS: dict[str, Callable] = {
    "follow": follow,
    "self_motions": self_motions,
    "motion": motion,
    "cloud": cloud,
    "equations": equations,
    "report": report,
    "program": programs.run,
    "film": films.film,
    **routes.LONG,
}
