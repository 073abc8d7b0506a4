"""A page's program as far as it can be gone: steps called again, steps that move nothing, the first that fails."""

from __future__ import annotations

import threading
from typing import Any

import numpy as np
import pytest

import pieper
from pieper.workbench import programs, snippet
from pieper.workbench.messages import Refused

ARM = pieper.load("denso-vp6242")
START = np.radians([20, 60, -150, 10, 40, 25])
THERE = np.radians([40, 60, -150, 10, 40, 25])


def program(*steps: dict[str, Any]) -> dict[str, Any]:
    limits = {"speed": [2.0] * 6, "acceleration": [10.0] * 6}
    return {"steps": list(steps), "start": START.tolist(), "limits": limits}


def ran(*steps: dict[str, Any]) -> dict[str, Any]:
    return programs.run(ARM, program(*steps), lambda part: None, threading.Event())


def joints(q) -> dict[str, Any]:
    return {"kind": "joint", "q": np.asarray(q).tolist()}


FAR = {"kind": "line", "T": (np.eye(4) + 9 * np.eye(4, k=3)).ravel().tolist()}


def test_a_step_called_again_is_named_with_the_step_that_calls_it():
    again = {"kind": "call", "first": 1, "last": 1, "times": 1}
    told = ran(joints(THERE), again)["explain"].splitlines()
    assert told[-1] == "Step 1 (called again by step 2): the arm is there already."
    assert "Step 1: the arm is there already." not in told


def test_what_cannot_be_done_when_called_again_names_both():
    # in the second frame the pose that could be reached cannot
    near = {"kind": "line", "T": ARM.fk(THERE).ravel().tolist()}
    steps = near, {"kind": "frame", "T": FAR["T"]}, {"kind": "call", "first": 1, "last": 1, "times": 1}
    said = ran(*steps)
    assert said["failed"]["step"] == 0 and said["failed"]["name"] == "step 1 (called again by step 3)"
    script = "\n".join(snippet.program_lines(ARM, program(*steps), around=False))
    assert "# step 1 (called again by step 3) cannot be done: " in script


def test_nothing_before_the_step_that_cannot_be_done_is_no_motion():
    said = ran(FAR, joints(THERE))
    assert said["failed"]["step"] == 0 and said["duration"] == 0
    assert ran(joints(THERE), FAR)["duration"] > 0


def test_a_call_of_what_comes_after_it_is_where_the_program_ends():
    call = {"kind": "call", "first": 2, "last": 3, "times": 1}
    said = ran(joints(THERE), call, joints(START))
    assert said["failed"]["name"] == "step 2" and "calls steps 2 to 3 again" in said["failed"]["text"]
    assert said["duration"] > 0
    script = "\n".join(snippet.program_lines(ARM, program(joints(THERE), call, joints(START)), around=False))
    assert "# step 2 cannot be done" in script and "# program.move_j" in script


def test_a_file_that_is_refused_names_the_step_and_not_the_move():
    arm = pieper.load("abb-irb140")
    start = np.radians([10, 20, 10, 5, 40, 15])
    T = arm.fk(start)
    through = [(pieper.pose(0.01 * k, 0.01 * k * k, 0) @ T).ravel().tolist() for k in (1, 2, 3)]
    wait, grip = {"kind": "wait", "seconds": 1.0}, {"kind": "gripper", "value": 1.0}
    spline = {"kind": "spline", "through": through, "T": through[-1]}
    message = program(wait, grip, spline) | {"start": start.tolist(), "dialect": "rapid", "name": "program"}
    with pytest.raises(Refused, match="^Step 3 is a spline, which rapid"):
        programs.write(arm, message)
    aside = {"kind": "joint", "q": (start + 0.02).tolist()}
    back = {"kind": "joint", "q": start.tolist()}
    again = program(aside, back, {"kind": "call", "first": 1, "last": 2, "times": 1}, spline)
    with pytest.raises(Refused, match="^Step 4 is a spline, which rapid"):
        programs.write(arm, message | again)
    assert programs.write(arm, message | {"dialect": "csv"})["text"]
