"""Ten thousand broken messages over routes, programs and films: each is answered or refused in words, never a fault."""

from __future__ import annotations

import copy
import random
import threading

import numpy as np
import pytest

import pieper
from pieper.workbench import films, programs, reach, routes, snippet
from pieper.workbench.messages import Refused
from tests.workbench.test_messages import table

ODD = [None, True, -1, 0, 1.5, 1e7, 1e-300, "free", "joint", "", [], {}, [1, 2], [[0] * 16], "x" * 90, [None] * 16]
POSE = np.eye(4).ravel().tolist()


def arm():
    from pieper.workbench.table import arm_from_table

    return arm_from_table(table(2))


def wholes() -> dict:
    """Return a whole message of each kind, small enough to be answered at once."""
    steps = [
        {"kind": "joint", "q": [0.1, 0.2]},
        {"kind": "line", "T": POSE, "speed": 0.1, "blend": 0},
        {"kind": "circle", "T": POSE, "centre": [0.1, 0, 0], "long_way": True},
        {"kind": "circle", "T": POSE, "via": POSE},
        {"kind": "spline", "through": [POSE, POSE], "T": POSE},
        {"kind": "frame", "T": POSE},
        {"kind": "call", "first": 1, "last": 2, "times": 2},
        {"kind": "gripper", "value": 0.5},
        {"kind": "output", "port": 1, "value": True},
        {"kind": "wait", "seconds": 0.1},
    ]
    limits = {"speed": [1, 1], "acceleration": 2, "jerk": None, "tool_speed": 0.5}
    program = {"steps": steps, "start": [0, 0], "limits": limits}
    route = {"T0": POSE, "T1": POSE, "n": 3, "free": {"turn": [0, 1], "cone": 0, "axis": "z"}, "cost": "motion"}
    route = {
        **route,
        "start": [0, 0],
        "end": None,
        "world": [{"kind": "box", "name": "b", "T": POSE, "size": [1, 1, 1]}],
    }
    return {
        "route": route,
        "route_posture": {"T": POSE, "turn": 0.1, "free": {"turn": "free"}, "near": [0, 0], "branch": "a"},
        "program": {**program, "rate": 50, "world": []},
        "program_file": {**program, "dialect": "csv", "name": "p"},
        "python": {"q": [0, 0], "target": POSE, "path": {"from": POSE, "to": POSE, "n": 3}, "program": program},
        "voxels": {"step": 2e-4, "colour": "margin"},
        "film": {"kind": "gif", "q": [[0, 0], [0, 0.1]], "t": [0, 0.01], "view": [20, 30], "speed": 1},
    }


def broken(message: dict, rng: random.Random) -> dict:
    """Return a message with one to three of its values, at any depth, put out of order or taken out."""
    message = copy.deepcopy(message)
    for _ in range(rng.randint(1, 3)):
        at: object = message
        while True:
            keys = list(at) if isinstance(at, dict) else list(range(len(at))) if isinstance(at, list) else []
            if not keys:
                break
            key = rng.choice(keys)
            inside = at[key]  # type: ignore[index]
            if isinstance(inside, (dict, list)) and inside and rng.random() < 0.7:
                at = inside
                continue
            if rng.random() < 0.2:
                del at[key]  # type: ignore[attr-defined]
            else:
                at[key] = copy.deepcopy(rng.choice(ODD))  # type: ignore[index]
            break
    return message


def answer(kind: str, one: pieper.Arm, message: dict) -> None:
    stop = threading.Event()
    long = {**routes.LONG, **reach.LONG, "program": programs.run, "film": films.film}
    if kind in long:
        long[kind](one, message, lambda part: None, stop)
    else:
        {**routes.QUICK, "program_file": programs.write, "python": snippet.python}[kind](one, message)


#: How many of each: what is refused late, or comes through and draws, takes longer.
COUNTS = {
    "route": 4500,
    "route_posture": 4500,
    "python": 400,
    "program": 250,
    "program_file": 250,
    "film": 100,
    "voxels": 60,
}


# numbers that look like degrees are warned of, as everywhere
@pytest.mark.filterwarnings("ignore::pieper.PieperWarning")
@pytest.mark.parametrize("kind", list(wholes()))
def test_a_broken_message_is_refused_in_words_and_is_no_fault(kind):
    whole, one, rng = wholes()[kind], arm(), random.Random(kind)
    refused = 0
    for _ in range(COUNTS[kind]):
        message = broken(whole, rng)
        try:
            answer(kind, one, message)
        except (Refused, pieper.PieperError) as error:
            refused += 1
            assert str(error).strip(), message
        except Exception as error:
            raise AssertionError(f"{type(error).__name__}: {error}\n{message}") from error
    assert refused > COUNTS[kind] / 2
