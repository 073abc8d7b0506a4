"""Motions of the page as moving pictures that can be mailed and shown: GIF, WebP and MP4, drawn by the library."""

from __future__ import annotations

import base64
import tempfile
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

import pieper
from pieper.workbench.messages import Refused, number, vector, vectors, word

KINDS = ("gif", "webp", "mp4")
#: Samples of a motion, seconds of a picture, and pictures a second.
MAX_SAMPLES, LONGEST, RATE = 1_500, 60.0, 15.0
SIZE = (640, 480)
Progress = Callable[[dict[str, Any]], None]


def film(arm: pieper.Arm, message: dict[str, Any], progress: Progress, stop: threading.Event) -> dict[str, Any]:
    """Return a motion as the bytes of a moving picture, base64; progress tells how many pictures are drawn."""
    kind = word(message.get("kind"), "kind", KINDS)
    q = vectors(message.get("q"), arm.n, "posture", MAX_SAMPLES)
    t = vector(message.get("t"), len(q), "t")
    view = vector(message.get("view", [22, -58]), 2, "view")
    speed = number(message.get("speed", 1), "speed")
    if len(t) < 2 or np.any(np.diff(t) <= 0):
        raise Refused("times of a motion must rise, and there must be two at least.")
    t = t - t[0]
    if not 0 < speed <= 100 or t[-1] / speed > LONGEST:
        raise Refused(f"A moving picture lasts at most {LONGEST:g} s; play it faster.")
    dq = np.gradient(q, t, axis=0)
    ends = np.array([0.0, t[-1]])
    motion = pieper.Motion(t, q, dq, np.zeros_like(q), ends, ends, description=arm.description)

    def drawn(done: int, of: int) -> None:
        progress({"done": done, "of": of})

    with tempfile.TemporaryDirectory(prefix="pieper-") as folder:
        path = Path(folder) / f"motion.{kind}"
        try:
            motion.animate(
                path, rate=RATE, speed=speed, size=SIZE, view=(float(view[0]), float(view[1])), progress=drawn
            )
        except ImportError as missing:
            raise Refused(f"Moving pictures are not available in this installation ({missing}).") from None
        return {"data": base64.b64encode(path.read_bytes()).decode("ascii"), "name": f"motion.{kind}"}
