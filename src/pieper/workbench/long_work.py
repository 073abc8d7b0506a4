"""Work that may take longer than a blink: paths, sequences, equations, reports; with progress and a stop."""

from __future__ import annotations

import contextlib
import importlib
import tempfile
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

import pieper
from pieper.tolerances import SLOWEST_RATE
from pieper.workbench import answers, equation_blocks, films, programs, reach, routes
from pieper.workbench.messages import (
    MAX_POINTS,
    MAX_POSTURES,
    Refused,
    go_on,
    number,
    pose,
    vector,
    vectors,
    whole,
    word,
)

#: Seconds of a whole sequence, and samples that are sent of one.
LONGEST_SEQUENCE, MAX_SAMPLES = 3_600, 4_000
Progress = Callable[[dict[str, Any]], None]


def _track(arm: pieper.Arm, message: dict[str, Any], stop: threading.Event) -> pieper.Track:
    """Return a straight line followed from a start posture."""
    start_pose, end_pose = pose(message.get("T0"), "start pose"), pose(message.get("T1"), "end pose")
    n = whole(message.get("n"), "N", 1, MAX_POINTS)
    path = pieper.line(start_pose, end_pose, n=n)
    start = vector(message.get("start"), arm.n, "start")
    go_on(stop)
    return arm.follow(path, start=start)


def cures(arm: pieper.Arm, message: dict[str, Any], progress: Progress, stop: threading.Event) -> dict[str, Any]:
    """Return what is said of a line that stops, with what would let it pass, which takes longer than following it."""
    return {"explain": _track(arm, message, stop).explain()}


def follow(arm: pieper.Arm, message: dict[str, Any], progress: Progress, stop: threading.Event) -> dict[str, Any]:
    """Follow a straight line from a start posture; every event with its cause, and the other branches."""
    track = _track(arm, message, stop)
    return {
        "path": track.path.reshape(-1, 16).tolist(),
        "q": np.asarray(track.followed).tolist(),
        "complete": bool(track.complete),
        "chosen": track.chosen,
        "explain": track.explain(cures=False),
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
    go_on(stop)
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
    go_on(stop)
    return {
        "t": moved.t.tolist(),
        "q": moved.q.tolist(),
        "dq": moved.dq.tolist(),
        "arrivals": moved.arrivals.tolist(),
        "departures": moved.departures.tolist(),
    }


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


def prepare() -> None:
    """Import what figures are drawn with, so that the first report does not wait for it."""
    with contextlib.suppress(ImportError):
        importlib.import_module("mpl_toolkits.mplot3d")
        importlib.import_module("matplotlib.backends.backend_svg")


def report(arm: pieper.Arm, message: dict[str, Any], progress: Progress, stop: threading.Event) -> dict[str, Any]:
    """Return the report of the arm at a posture, as one HTML page."""
    q = vector(message.get("q"), arm.n, "q")
    progress({"note": "Writing the report …"})
    with tempfile.TemporaryDirectory(prefix="pieper-") as folder:
        go_on(stop)
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
    "cures": cures,
    "self_motions": self_motions,
    "motion": motion,
    "equations": equations,
    "report": report,
    "program": programs.run,
    "film": films.film,
    **reach.LONG,
    **routes.LONG,
}
