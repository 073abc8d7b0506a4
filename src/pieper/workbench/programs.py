"""Programs of the page: steps as JSON become a `pieper.Program`, its motion, its files and where it fails."""

from __future__ import annotations

import tempfile
import threading
from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

import pieper
from pieper.tolerances import NO_MOVE
from pieper.workbench import around
from pieper.workbench.messages import Refused, number, optional, pose, vector, vectors, whole, word

MAX_STEPS = 200
#: Samples of a motion that are sent, at most.
MAX_SAMPLES = 4_000
MOVES = ("joint", "line", "circle", "spline")
KINDS = (*MOVES, "wait", "gripper", "output", "frame", "call")
#: Poses of one spline, and how often a part of a program is done again, at most.
MAX_THROUGH, MAX_TIMES = 100, 50
#: Steps that are done, those called again counted each time.
MAX_DONE = 1_000
DIALECTS = {
    "rapid": ".mod",
    "urscript": ".script",
    "krl": ".src",
    "fanuc-ls": ".ls",
    "inform": ".jbi",
    "pacscript": ".pcs",
    "ros": ".yaml",
    "csv": ".csv",
}
Progress = Callable[[dict[str, Any]], None]


def limits_of(given: object, n: int) -> pieper.Limits:
    """Return the limits that a page asks for: one number or one a joint, SI; null where one does not matter."""
    if not isinstance(given, dict):
        raise Refused("limits must be an object of speed, acceleration and what else is to be kept.")

    def joints(key: str) -> Any:
        value = given.get(key)
        return vector(value, n, f"limits, {key}") if isinstance(value, list) else number(value, f"limits, {key}")

    jerk = None if given.get("jerk") is None else joints("jerk")
    tool = {
        key: optional(number, given.get(key), f"limits, {key}")
        for key in ("tool_speed", "tool_acceleration", "turn_speed")
    }
    return pieper.Limits(speed=joints("speed"), acceleration=joints("acceleration"), jerk=jerk, **tool)


def add_step(program: pieper.Program, step: object, n: int, at: str) -> None:
    """Add one step of the page to a program, or say what is wrong with it."""
    if not isinstance(step, dict):
        raise Refused(f"{at} must be an object.")
    kind = word(step.get("kind"), f"{at}, kind", KINDS)
    if kind == "wait":
        program.wait(number(step.get("seconds"), f"{at}, seconds"))
    elif kind == "gripper":
        program.gripper(number(step.get("value"), f"{at}, value"))
    elif kind == "output":
        program.output(whole(step.get("port"), f"{at}, port", 0, 9999), bool(step.get("value")))
    elif kind == "call":
        wanted = f"steps {step['first']} to {step['last']}" if step["first"] < step["last"] else f"step {step['first']}"
        raise pieper.InputError(f"it calls {wanted} again, and only what comes before it can be: move it down.")
    elif kind == "frame":
        program.frame(pose(step.get("T"), f"{at}, T"))
    else:
        speed = optional(number, step.get("speed"), f"{at}, speed")
        blend = number(step.get("blend", 0), f"{at}, blend")
        if kind == "joint":
            posture = step.get("q") is not None
            to = vector(step["q"], n, f"{at}, q") if posture else pose(step.get("T"), f"{at}, T")
            program.move_j(to, speed=speed, blend=blend)
        elif kind == "line":
            program.move_l(pose(step.get("T"), f"{at}, T"), speed=speed, blend=blend)
        elif kind == "spline":
            through = vectors(step.get("through"), 16, f"{at}, pose", MAX_THROUGH).reshape(-1, 4, 4)
            program.move_s(through, speed=speed, blend=blend)
        elif step.get("centre") is not None:
            centre, far = vector(step["centre"], 3, f"{at}, centre"), bool(step.get("long_way"))
            T = pose(step.get("T"), f"{at}, T")
            program.move_c(None, T, centre=centre, the_long_way=far, speed=speed, blend=blend)
        else:
            via = pose(step.get("via"), f"{at}, via")
            program.move_c(via, pose(step.get("T"), f"{at}, T"), speed=speed, blend=blend)


class Turn(NamedTuple):
    """A step as it comes to be done: its place in the list from 0, what it says, and the step that calls it again."""

    place: int
    step: dict[str, Any]
    caller: int | None = None

    @property
    def name(self) -> str:
        """Return the step's number for a reader, and whose call it is done by."""
        again = "" if self.caller is None else f" (called again by step {self.caller + 1})"
        return f"step {self.place + 1}{again}"


@dataclass(frozen=True)
class Built:
    """A page's program as far as it can be gone.

    Attributes:
        program: Its steps, up to the one that cannot be done.
        failed: That step: its place from 0, its name and the reason; None where all can.
        done: Every step in the order it is done; what is called again is there again, and what asks for where the arm
            is already is not.
        idle: Names of steps that ask for where the arm is already.
        left: The step that cannot be done and all that would follow, as `done`.
    """

    program: pieper.Program
    failed: dict[str, Any] | None
    done: tuple[Turn, ...]
    idle: tuple[str, ...]
    left: tuple[Turn, ...]


def build(arm: pieper.Arm, message: dict[str, Any]) -> Built:
    """Return the program of a message as far as it can be gone."""
    steps = message.get("steps")
    if not isinstance(steps, list) or not 1 <= len(steps) <= MAX_STEPS:
        raise Refused(f"steps must be a list of 1 to {MAX_STEPS} steps.")
    limits = limits_of(message.get("limits"), arm.n)
    program = pieper.Program(arm, limits, start=vector(message.get("start"), arm.n, "start"))
    done: list[Turn] = []
    idle: dict[str, None] = {}
    failed = None
    ordered = expanded(steps)
    tried = len(ordered)
    for place, turn in enumerate(ordered):
        if _is_there(arm, program, turn.step, turn.name):
            idle[turn.name] = None
            continue
        try:
            add_step(program, turn.step, arm.n, turn.name)
        except (pieper.NoSolutionError, pieper.InputError) as error:
            failed, tried = {"step": turn.place, "name": turn.name, "text": str(error)}, place
            break
        done.append(turn)
    return Built(program, failed, tuple(done), tuple(idle), tuple(ordered[tried:]))


def expanded(steps: list[Any]) -> list[Turn]:
    """Return steps as they come to be done, in the frame of then: for a call what it calls, if that comes before it."""
    out: list[Turn] = []

    def put(first: int, last: int, caller: int | None) -> None:
        for k in range(first, last):
            step = steps[k]
            if not isinstance(step, dict):
                raise Refused(f"step {k + 1} must be an object.")
            if step.get("kind") == "call":
                at = f"step {k + 1}"
                begin = whole(step.get("first"), f"{at}, first", 1, len(steps))
                end = whole(step.get("last"), f"{at}, last", begin, len(steps))
                times = whole(step.get("times"), f"{at}, times", 1, MAX_TIMES)
                if end > k:
                    out.append(Turn(k, step, caller))
                    continue
                for _ in range(times):
                    put(begin - 1, end, k if caller is None else caller)
            else:
                out.append(Turn(k, step, caller))
            if len(out) > MAX_DONE:
                raise Refused(f"The program does more than {MAX_DONE} steps when it calls some again; at most so many.")

    put(0, len(steps), None)
    return out


def _is_there(arm: pieper.Arm, program: pieper.Program, step: object, at: str) -> bool:
    """Return whether a move asks for where the arm is already, as the first one taught does as a rule."""
    if not isinstance(step, dict) or step.get("kind") not in ("joint", "line"):
        return False
    now = program.moves[-1].q if program.moves else program.start
    if step.get("q") is not None:
        return bool(np.allclose(vector(step["q"], arm.n, f"{at}, q"), now, rtol=0, atol=NO_MOVE))
    wanted = program.work @ pose(step.get("T"), f"{at}, T")
    return bool(np.allclose(wanted, arm.fk(now), rtol=0, atol=NO_MOVE))


def run(arm: pieper.Arm, message: dict[str, Any], progress: Progress, stop: threading.Event) -> dict[str, Any]:
    """Return the timed motion of a program with its events, what binds it, and where and why it fails."""
    built = build(arm, message)
    program = built.program
    if stop.is_set():
        return {"stopped": True}
    motion = program.motion(rate=number(message.get("rate", 200), "rate", largest=1000))
    every = max(1, -(-len(motion.t) // MAX_SAMPLES))
    idle = (f"{name.capitalize()}: the arm is there already." for name in built.idle)
    kept = np.unique(np.append(np.arange(0, len(motion.t), every), len(motion.t) - 1))
    return {
        "t": motion.t[kept].tolist(),
        "q": motion.q[kept].tolist(),
        "dq": motion.dq[kept].tolist(),
        "ddq": motion.ddq[kept].tolist(),
        "duration": float(motion.t[-1]),
        "events": [[float(t), kind, value] for t, kind, value in motion.events],
        "tight": [asdict(x) | {"text": str(x)} for x in motion.tight],
        "margin": float(motion.margin),
        "explain": "\n".join([program.explain(), *idle]),
        "failed": built.failed,
        "clear": around.proved(arm, np.asarray(motion.q[kept], float), message.get("world")),
    }


def write(arm: pieper.Arm, message: dict[str, Any]) -> dict[str, Any]:
    """Return a program as the text of a file for a maker's controller."""
    dialect = word(message.get("dialect"), "dialect", tuple(DIALECTS))
    name = word(message.get("name", "program"), "name")
    built = build(arm, message)
    if built.failed is not None:
        raise Refused(f"{built.failed['name'].capitalize()} cannot be written: {built.failed['text']}")
    with tempfile.TemporaryDirectory(prefix="pieper-") as folder:
        path = Path(folder) / f"{name}{DIALECTS[dialect]}"
        try:
            built.program.write(path, dialect=dialect, name=name)
        except pieper.InputError as error:
            move = error.data.get("move")
            if not isinstance(move, int):
                raise Refused(str(error)) from error
            moves = [turn.name for turn in built.done if turn.step["kind"] in MOVES]
            raise Refused(f"{moves[move - 1].capitalize()} {error.data['why']}") from error
        return {"text": path.read_text(encoding="utf-8"), "name": path.name}
