"""Whole messages of a workbench's page, one of every kind, and the same put out of order: for fuzzing its server."""

from __future__ import annotations

import copy
import random
from typing import Any

import numpy as np
import numpy.typing as npt

#: What is put where something else belongs.
ODD = [None, True, -1, 0, 1.5, 1e7, 1e-300, "free", "joint", "", [], {}, [1, 2], [[0] * 16], "x" * 90, [None] * 16]


def wholes(q: npt.ArrayLike, T: npt.ArrayLike, T1: npt.ArrayLike) -> dict[str, dict[str, Any]]:
    """Return a whole message of each kind about an arm, small enough to be answered at once.

    Args:
        q: (n,) A posture, rad or m.
        T: (4, 4) The pose there.
        T1: (4, 4) A pose near it.
    """
    here, there = (np.asarray(v, float).ravel().tolist() for v in (T, T1))
    posture = np.asarray(q, float).tolist()
    n, aside = len(posture), [v + 0.05 for v in posture]
    steps = [
        {"kind": "joint", "q": aside},
        {"kind": "line", "T": here, "speed": 0.1, "blend": 0},
        {"kind": "circle", "T": there, "centre": [0.1, 0, 0], "long_way": True},
        {"kind": "circle", "T": there, "via": there},
        {"kind": "spline", "through": [here, there], "T": there},
        {"kind": "frame", "T": np.eye(4).ravel().tolist()},
        {"kind": "call", "first": 1, "last": 2, "times": 2},
        {"kind": "gripper", "value": 0.5},
        {"kind": "output", "port": 1, "value": True},
        {"kind": "wait", "seconds": 0.1},
    ]
    limits = {"speed": [1] * n, "acceleration": 2, "jerk": None, "tool_speed": 0.5}
    program = {"steps": steps, "start": posture, "limits": limits}
    world = [{"kind": "box", "name": "b", "T": here, "size": [1, 1, 1]}]
    free = {"turn": [0, 1], "cone": 0, "axis": "z"}
    route = {"T0": here, "T1": there, "n": 3, "free": free, "cost": "motion", "start": posture, "end": None}
    return {
        "route": {**route, "world": world},
        "route_others": {**route, "world": []},
        "route_program": {**route, "world": []},
        "route_posture": {"T": here, "turn": 0.1, "free": {"turn": "free"}, "near": posture, "branch": "a"},
        "program": {**program, "rate": 50, "world": []},
        "program_file": {**program, "dialect": "csv", "name": "p"},
        "python": {"q": posture, "target": here, "path": {"from": here, "to": there, "n": 3}, "program": program},
        "voxels": {"step": 2e-4, "colour": "margin"},
        "film": {"kind": "gif", "q": [posture, aside], "t": [0, 0.01], "view": [20, 30], "speed": 1},
        "ik": {"T": here, "q": posture, "brief": False, "digits": {"metres": 1e-5, "radians": 1e-4}},
        "nearest": {"T": here, "task": "position"},
        "formulas": {"T": here},
        "save": {},
        "clearance": {"q": posture, "world": world},
        "bodies": {},
        "follow": {"T0": here, "T1": there, "n": 5, "start": posture},
        "cures": {"T0": here, "T1": there, "n": 5, "start": posture},
        "self_motions": {"T": here, "q": posture},
        "motion": {"postures": [posture, aside], "seconds": [0.5], "holds": [0.1], "rate": 50},
        "equations": {"which": "forward", "numbers": "symbols"},
        "report": {"q": posture},
        "cloud": {"count": 500, "colour": "height", "seed": 1},
        "hello": {"wants_arm": True},
        "load": {"name": "denso-vp6242"},
        "open": {"name": "robot.toml", "text": "name = 1"},
        "catalog": {},
        "cancel": {"kind": "cloud"},
    }


def broken(message: dict[str, Any], rng: random.Random) -> dict[str, Any]:
    """Return a message with one to three of its values, at any depth, put out of order or taken out."""
    message = copy.deepcopy(message)
    for _ in range(rng.randint(1, 3)):
        at: Any = message
        while True:
            keys = list(at) if isinstance(at, dict) else list(range(len(at))) if isinstance(at, list) else []
            if not keys:
                break
            key = rng.choice(keys)
            inside = at[key]
            if isinstance(inside, (dict, list)) and inside and rng.random() < 0.7:
                at = inside
                continue
            if rng.random() < 0.2:
                del at[key]
            else:
                at[key] = copy.deepcopy(rng.choice(ODD))
            break
    return message
