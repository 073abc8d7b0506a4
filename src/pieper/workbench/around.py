"""What stands around the arm: the page's bodies as a scene, the nearest two of them live, a motion proved clear."""

from __future__ import annotations

import json
from functools import lru_cache
from typing import Any

import numpy as np
import numpy.typing as npt

import pieper
from pieper.workbench.messages import Refused, number, pose, vector, word

MAX_THINGS = 60


def scene_of(world: object) -> pieper.Scene:
    """Return the obstacles of a page's world; objects that a gripper takes are none."""
    if not isinstance(world, list) or len(world) > MAX_THINGS:
        raise Refused(f"world must be a list of at most {MAX_THINGS} things.")
    # the same world again is the same scene, for which the library keeps what it has made ready
    return _scene(json.dumps([t for t in world if isinstance(t, dict) and t.get("role") != "object"]))


@lru_cache(maxsize=64)
def _scene(text: str) -> pieper.Scene:
    shapes = []
    for k, t in enumerate(json.loads(text)):
        at = f"thing {k + 1}"
        kind = word(t.get("kind"), f"{at}, kind", ("box", "cylinder", "frame"))
        name = word(t.get("name"), f"{at}, name")
        T = pose(t.get("T"), f"{at}, T")
        if kind == "box":
            shapes.append(pieper.Box(T, vector(t.get("size"), 3, f"{at}, size"), name))
        elif kind == "cylinder":
            shapes.append(pieper.Cylinder(T, number(t.get("r"), f"{at}, r"), number(t.get("h"), f"{at}, h"), name))
    return pieper.Scene(shapes)


def clearance(arm: pieper.Arm, message: dict[str, Any]) -> dict[str, Any]:
    """Return how far the arm is from touching itself or its world (m): which two bodies, and their nearest points."""
    found = arm.distance(vector(message.get("q"), arm.n, "q"), scene_of(message.get("world", [])))
    metres = float(found)
    if not np.isfinite(metres):
        return {"metres": None, "pair": [], "points": []}
    return {"metres": metres, "pair": [str(v) for v in found.pair], "points": np.asarray(found.points).tolist()}


def bodies(arm: pieper.Arm, message: dict[str, Any]) -> dict[str, Any]:
    """Return the bodies that distances are measured of, each in the frame that carries it, with its source."""
    shapes = []
    for body in arm.bodies:
        shape = body.shape
        if isinstance(shape, pieper.Capsule):
            said: dict[str, Any] = {"kind": "capsule", "a": shape.a.tolist(), "b": shape.b.tolist(), "r": shape.r}
        elif isinstance(shape, pieper.Box):
            said = {"kind": "box", "T": shape.T.ravel().tolist(), "size": np.asarray(shape.size).tolist()}
        elif isinstance(shape, pieper.Cylinder):
            said = {"kind": "cylinder", "T": shape.T.ravel().tolist(), "r": shape.r, "h": shape.h}
        else:
            said = {"kind": "curve", "points": np.asarray(shape.points).tolist()}
        shapes.append({**said, "name": body.name, "on": body.on, "source": body.source})
    return {"bodies": shapes, "explain": arm.bodies.explain()}


def proved(arm: pieper.Arm, q: npt.NDArray[np.float64], world: object) -> dict[str, Any] | None:
    """Return whether a motion keeps clear of itself and the world, in words; None where there are no obstacles."""
    scene = scene_of(world if world is not None else [])
    if not len(scene):
        return None
    swept = arm.clear(q, scene)
    return {"verdict": swept.verdict.name, "text": swept.explain(), "q": np.asarray(swept.q).tolist()}
