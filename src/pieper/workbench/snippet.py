"""What is on the screen as a Python script: arm, posture, target and solutions, path, world, program."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

import pieper
from pieper.workbench.answers import TASKS
from pieper.workbench.around import scene_of
from pieper.workbench.messages import MAX_POINTS, number, optional, pose, vector, vectors, whole, word
from pieper.workbench.programs import KINDS, MAX_THROUGH, Turn, build
from pieper.workbench.table import is_of_catalog


def python(arm: pieper.Arm, message: dict[str, Any]) -> dict[str, Any]:
    """Return a script that makes and computes what the page shows, in SI units and radians."""
    lines = ["import numpy as np", "", "import pieper", "", *arm_lines(arm)]
    q = vector(message.get("q"), arm.n, "q")
    lines += ["", f"q = {_array(q)}", "T = arm.fk(q)"]
    if message.get("target") is not None:
        task = optional(word, message.get("task"), "task", TASKS)
        held = message.get("redundancy")
        asked = [f"task={task!r}"] if task else []
        if isinstance(held, dict) and held:
            pairs = {word(k, "coordinate"): number(v, "redundancy") for k, v in held.items()}
            asked.append(f"redundancy={pairs!r}")
        lines += ["", f"target = {_array(pose(message['target'], 'target'))}"]
        lines += [f"solutions = arm.ik({', '.join(['target', *asked])})", "print(solutions.table())"]
    path = message.get("path")
    if isinstance(path, dict) and path.get("from") is not None and path.get("to") is not None:
        n = whole(path.get("n"), "N", 1, MAX_POINTS)
        lines += ["", f"start = {_array(pose(path['from'], 'from'))}", f"end = {_array(pose(path['to'], 'to'))}"]
        lines += [f"track = arm.follow(pieper.line(start, end, n={n}), start=q)", "print(track.explain())"]
    scene = scene_lines(message.get("world"))
    lines += scene
    lines += program_lines(arm, message.get("program"), bool(scene))
    return {"text": "\n".join(lines) + "\n"}


def arm_lines(arm: pieper.Arm) -> list[str]:
    """Return the lines that make the arm: by name where it is the catalogue's, else from its table."""
    name = is_of_catalog(arm)
    if name:
        return [f"arm = pieper.load({name!r})"]
    d = arm.description
    rows = [f"        pieper.DH({r.a!r}, {r.alpha!r}, {r.d!r}, {r.theta!r})," for r in d.rows]
    limits = ", ".join(f"({_bound(lo)}, {_bound(hi)})" for lo, hi in d.limits)
    lines = ["arm = pieper.Arm.from_dh(", "    [  # a, alpha, d, theta", *rows, "    ],"]
    lines += [f"    convention={d.convention!r},", f"    joint_types={''.join(d.joint_types)!r},"]
    lines += [f"    limits=[{limits}],", f"    base={_array(d.base)},", f"    tool={_array(d.tool)},"]
    lines += [f"    name={d.name!r},", f"    joint_names={list(d.joint_names)!r},"]
    lines += [f"    sign={_array(np.asarray(d.sign, float))},", f"    offset={_array(np.asarray(d.offset, float))},"]
    if d.coupling is not None:
        lines.append(f"    coupling={_array(np.asarray(d.coupling, float))},")
    return [*lines, ")"]


def scene_lines(world: object) -> list[str]:
    """Return the lines that make the obstacles of the page's world and ask how far the arm is from them, if any."""
    bodies = list(scene_of(world if world is not None else []))
    if not bodies:
        return []
    return [
        "",
        "scene = pieper.Scene([",
        *(f"    {_body(body)}," for body in bodies),
        "])",
        "print(arm.distance(q, scene))",
    ]


def _body(body: Any) -> str:
    if isinstance(body, pieper.Box):
        return f"pieper.Box({_array(body.T)}, {_array(np.asarray(body.size))}, {body.name!r})"
    return f"pieper.Cylinder({_array(body.T)}, {body.r!r}, {body.h!r}, {body.name!r})"


def program_lines(arm: pieper.Arm, program: object, around: bool) -> list[str]:
    """Return the lines of the page's program; none where it has no steps.

    Steps that cannot be done, and those behind them, stand there as comments.

    Args:
        arm: The arm.
        program: As the page sends it.
        around: Whether there is a scene that the motion is to keep clear of.
    """
    if not isinstance(program, dict) or not program.get("steps"):
        return []
    n, built = arm.n, build(arm, program)
    kept = {k: v for k, v in program["limits"].items() if v is not None and k in _LIMITS}
    said = ", ".join(f"{k}={number(v, k)!r}" if not isinstance(v, list) else f"{k}={v!r}" for k, v in kept.items())
    start = vector(program.get("start"), n, "start")
    lines = ["", f"limits = pieper.Limits({said})", f"program = pieper.Program(arm, limits, start={_array(start)})"]
    lines += [_called(turn, n) for turn in built.done]
    if built.failed is not None:
        lines.append(f"# {built.failed['name']} cannot be done: " + " ".join(built.failed["text"].split()))
        lines += [f"# {_called(turn, n)}" for turn in built.left if turn.step.get("kind") != "call"]
    lines += ["motion = program.motion()", "print(program.explain())"]
    return [*lines, "print(arm.clear(motion, scene).explain())"] if around else lines


def _called(turn: Turn, n: int) -> str:
    kind = word(turn.step.get("kind"), f"{turn.name}, kind", KINDS)
    return f"program.{_step(kind, turn.step, n, turn.name)}"


_LIMITS = ("speed", "acceleration", "jerk", "tool_speed", "tool_acceleration", "turn_speed")


def _step(kind: str, step: dict[str, Any], n: int, at: str) -> str:
    if kind == "wait":
        return f"wait({number(step.get('seconds'), at)!r})"
    if kind == "gripper":
        return f"gripper({number(step.get('value'), at)!r})"
    if kind == "output":
        return f"output({whole(step.get('port'), at, 0, 9999)}, {bool(step.get('value'))})"
    if kind == "frame":
        return f"frame({_array(pose(step.get('T'), at))})"
    how = [f"{key}={number(step[key], at)!r}" for key in ("speed", "blend") if step.get(key)]
    if kind == "joint" and step.get("q") is not None:
        return f"move_j({', '.join([_array(vector(step['q'], n, at)), *how])})"
    if kind == "spline":
        through = vectors(step.get("through"), 16, at, MAX_THROUGH).reshape(-1, 4, 4)
        return f"move_s({', '.join([_array(through), *how])})"
    T = _array(pose(step.get("T"), at))
    if kind == "circle" and step.get("centre") is not None:
        about = f"centre={_array(vector(step['centre'], 3, at))}"
        way = f"the_long_way={bool(step.get('long_way'))}"
        return f"move_c({', '.join(['None', T, about, way, *how])})"
    if kind == "circle":
        return f"move_c({', '.join([_array(pose(step.get('via'), at)), T, *how])})"
    return f"move_{'j' if kind == 'joint' else 'l'}({', '.join([T, *how])})"


def _array(value: npt.NDArray[np.float64]) -> str:
    """Return numbers as text that reads back to the last bit."""
    return f"np.array({np.asarray(value, float).tolist()!r})"


def _bound(value: float) -> str:
    return repr(float(value)) if np.isfinite(value) else "None"
