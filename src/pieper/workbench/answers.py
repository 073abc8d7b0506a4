"""The quick answers of a session: tables from names and files, what kind of arm a table is, inverse kinematics."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

import pieper
from pieper.workbench.looks import Looks, named_only
from pieper.workbench.messages import MAX_JOINTS, Refused, number, optional, pose, vector, word
from pieper.workbench.table import arm_from_table, is_of_catalog, table_from_arm

FIRST_ARM = "denso-vp6242"
LONGEST_FILE = 200_000
TASKS = ("pose", "position", "position+axis")
#: Points of a self-motion that are sent, at most.
MOTION_POINTS = 241


def hello(message: dict[str, Any], start: pieper.Arm | None, looks: Looks) -> dict[str, Any]:
    """Return what a new page needs first: the version, the catalogue, and an arm unless it brings its own."""
    out: dict[str, Any] = {"version": pieper.__version__, "catalog": pieper.catalog()}
    if message.get("wants_arm"):
        first = start or pieper.load(FIRST_ARM)
        out["table"] = table_from_arm(first, is_of_catalog(first))
        out["looks"] = looks.of(first)
    return out


def load(message: dict[str, Any], start: pieper.Arm | None, looks: Looks) -> dict[str, Any]:
    """Return the table of a catalogue arm."""
    name = word(message.get("name"), "name")
    if name not in pieper.catalog():
        raise Refused(f"{name!r} is not in the catalogue.")
    return {"table": table_from_arm(pieper.load(name), name)}


def catalogue(message: dict[str, Any], start: pieper.Arm | None, looks: Looks) -> dict[str, Any]:
    """Return what a person chooses an arm by: name, maker, joints, payload (kg), reach (m), points of its frames."""
    return {"arms": _catalogue()}


@cache
def _catalogue() -> list[dict[str, Any]]:
    found = []
    for entry in pieper.find_arms():
        arm = pieper.load(entry.name)
        lower, upper = np.clip(arm.limits.T, -1.2, 1.2)
        named = next((arm.postures[k] for k in ("ready", "home", "work") if k in arm.postures), None)
        q = np.clip(np.full(arm.n, 0.6), lower, upper) if named is None else np.asarray(named)
        points = arm.frames(q)[:, :3, 3]
        found.append(
            {
                "name": entry.name,
                "maker": entry.manufacturer,
                "joints": entry.joint_types,
                "payload": entry.payload,
                "reach": entry.reach,
                "points": np.round(points, 4).tolist(),
            }
        )
    return found


def open_file(message: dict[str, Any], start: pieper.Arm | None, looks: Looks) -> dict[str, Any]:
    """Return the table of a robot file whose text the page sends."""
    text, name = message.get("text"), word(message.get("name", "robot.toml"), "file name")
    if not isinstance(text, str) or len(text) > LONGEST_FILE:
        raise Refused(f"A robot file is a text of at most {LONGEST_FILE} characters.")
    suffix = ".urdf" if name.endswith((".urdf", ".xml")) else ".toml"
    with tempfile.TemporaryDirectory(prefix="pieper-") as folder:
        path = Path(folder) / f"robot{suffix}"
        path.write_text(text, encoding="utf-8")
        try:
            arm = pieper.load(path)
            return {"table": table_from_arm(arm), "looks": named_only(arm)}
        except pieper.InputError as error:
            raise Refused(str(error).replace(str(path), name)) from None


def take_arm(message: dict[str, Any]) -> tuple[pieper.Arm, dict[str, Any]]:
    """Return the arm of the page's table and what kind of arm it is."""
    arm = arm_from_table(message.get("table"))
    try:
        plan = arm.plan
    except pieper.PlanError as error:
        return arm, {"plan": {"family": None, "max_solutions": 0, "explain": str(error), "solvable": False}}
    explain = plan.explain()
    return arm, {
        "plan": {
            "family": plan.family,
            "max_solutions": int(plan.count.most),
            "explain": explain,
            "solvable": True,
            "task": plan.task,
            "redundancy": list(plan.redundancy),
        }
    }


def ik(arm: pieper.Arm, message: dict[str, Any]) -> dict[str, Any]:
    """Return every solution of a pose with labels, limits and residuals, its self-motions, and the reason in words."""
    began = time.perf_counter()
    solutions, missed = within_digits(arm, message, solve(arm, message))
    spent = time.perf_counter() - began
    plan = arm.plan_for(message.get("task"))
    answer = {**solution_rows(arm, solutions, message), "ms": 1e3 * spent}
    if missed is not None:
        answer["missed"] = missed
    if plan.redundancy:
        # tracing what a redundant arm can do at a pose takes far longer than solving it: the page asks for that apart
        answer["self_motions"] = None
        if not message.get("brief"):
            answer["spare"] = spare_coordinates(arm, plan)
            answer["arm_angle"] = _arm_angle(arm, plan, answer["nearest"])
    elif not message.get("brief"):
        answer["self_motions"] = [motion_points(motion, arm.n) for motion in solutions.self_motions]
    return answer


def solve(arm: pieper.Arm, message: dict[str, Any]) -> pieper.Solutions:
    """Return what the library answers to the target, task and redundancy of a message.

    Where nobody chose the redundant joints, they stay where the page's posture has them if that has an answer: an arm
    whose target is dragged does not swing about.
    """
    T = pose(message.get("T"), "target")
    task = optional(word, message.get("task"), "task", TASKS)
    redundancy = optional(_redundancy, message.get("redundancy"))
    plan, now = arm.plan_for(task), message.get("q")
    if redundancy is None and plan.redundancy and isinstance(now, list) and len(now) == arm.n:
        q = dict(zip(arm.joint_names, np.clip(vector(now, arm.n, "q"), *arm.limits.T), strict=True))
        held = {name: float(q[name]) for name in plan.redundancy if name in q}
        solutions = arm.ik(T, task=task, redundancy=held)
        if len(solutions):
            return solutions
    return arm.ik(T, task=task, redundancy=redundancy)


def within_digits(
    arm: pieper.Arm, message: dict[str, Any], solutions: pieper.Solutions
) -> tuple[pieper.Solutions, dict[str, float] | None]:
    """Return the solutions of a pose that was typed with a few digits.

    Rounded numbers of a pose that an arm takes are as a rule no pose of an arm with fewer than six joints, nor of any
    arm at the edge of its reach. Where the arm comes as near as half of the last digit, it is solved where it gets.

    Returns:
        The solutions, and by how many metres and radians the pose they are for misses the typed one; None where it is
        met as typed.
    """
    digits = message.get("digits")
    if digits is None or len(solutions):
        return solutions, None
    if not isinstance(digits, dict):
        raise Refused("digits must be an object of metres and radians.")
    metres, radians = (number(digits.get(key), f"digits, {key}", largest=1.0) for key in ("metres", "radians"))
    task = optional(word, message.get("task"), "task", TASKS)
    near = arm.closest(solutions.T, task=task)
    # three rounded numbers each: the corner of the cube lies farther away than half a digit
    if near.metres > np.sqrt(3) * metres or near.radians > np.sqrt(3) * radians:
        return solutions, None
    there = solve(arm, {**message, "T": near.T.ravel().tolist()})
    return (there, {"metres": near.metres, "radians": near.radians}) if len(there) else (solutions, None)


def _redundancy(value: object) -> dict[str, float]:
    if not isinstance(value, dict) or not 1 <= len(value) <= MAX_JOINTS:
        raise Refused("redundancy must be an object of values by the name of their coordinate.")
    return {word(name, "name of a coordinate"): number(v, f"redundancy, {name[:40]}") for name, v in value.items()}


def spare_coordinates(arm: pieper.Arm, plan: pieper.Plan) -> list[dict[str, Any]]:
    """Return each coordinate that may be chosen: its name, whether it is a length, and its limits, null for none.

    The arm angle, where the arm has one, stands for its redundant joint: one of the two is chosen, not both.
    """
    lengths = {name for name, kind in zip(arm.joint_names, arm.joint_types, strict=True) if kind == "P"}
    found = []
    for name, limits in zip(plan.redundancy, plan.redundancy_limits, strict=True):
        lower, upper = (float(v) if np.isfinite(v) else None for v in limits)
        kind = "length" if name in lengths else "angle"
        found.append({"name": name, "kind": kind, "lower": lower, "upper": upper, "instead": False})
    if "arm angle" in plan.choices:
        found.append({"name": "arm angle", "kind": "angle", "lower": None, "upper": None, "instead": True})
    return found


def _arm_angle(arm: pieper.Arm, plan: pieper.Plan, q: list[float] | None) -> float | None:
    """Return the arm angle of a posture where the arm has one and it is defined there."""
    if q is None or "arm angle" not in plan.choices:
        return None
    value, defined = arm.arm_angle(q)
    return float(value) if np.all(defined) else None


def solution_rows(arm: pieper.Arm, solutions: pieper.Solutions, message: dict[str, Any]) -> dict[str, Any]:
    """Return Solutions as JSON: every row of all_q, those outside the limits marked."""
    inside = np.asarray(solutions.in_limits, dtype=bool)
    # A dragged target asks many times a second: words and self-motions wait for the hand to rest.
    brief = bool(message.get("brief"))
    labels = [None] * len(solutions.all_q) if brief else list(solutions.all_labels)
    motions = np.full(len(solutions.all_q), -1)
    motions[inside] = solutions.in_self_motion
    plan = arm.plan_for(message.get("task"))
    residual = plan.residual(solutions.all_q, solutions.T)
    now = message.get("q")
    near = None
    if isinstance(now, list) and len(now) == arm.n:
        near = _nearest(plan, solutions, vector(now, arm.n, "q"))
    return {
        "rows": [
            {
                "q": q.tolist(),
                "label": labels[i],
                "inside": bool(inside[i]),
                "residual": residual[i].tolist(),
                "self_motion": int(motions[i]),
            }
            for i, q in enumerate(solutions.all_q)
        ],
        "status": solutions.status.name,
        "why": solutions.why,
        "rounded": bool(solutions.rounded),
        "nearest": near,
        "self_motions": [],
    }


def _nearest(plan: pieper.Plan, solutions: pieper.Solutions, now: npt.NDArray[np.float64]) -> list[float] | None:
    """Return the solution nearest to a posture; of a redundant arm, at the coordinates that the rows are for."""
    try:
        near = solutions.nearest_row(now)[1] if plan.redundancy else solutions.nearest(now)
    except pieper.NoSolutionError:
        return None
    return near.tolist()


def motion_points(motion: pieper.SelfMotion, n: int) -> dict[str, Any]:
    """Return a self-motion as joint vectors (n,) along it, in order; between them the page finds its own way."""
    samples = np.asarray(motion.samples)
    kept = np.unique(np.linspace(0, len(samples) - 1, min(len(samples), MOTION_POINTS)).round().astype(int))
    names = list(motion.names)
    return {
        # a task that fixes less than a pose adds joints at the tool, which are none of the arm's
        "q": samples[kept, :n].tolist(),
        "s": np.asarray(motion.u)[kept].tolist(),
        "closed": bool(motion.closed),
        "moves": [names[j] for j in motion.free if j < n],
        "inside": [[float(a), float(b)] for a, b in motion.inside],
        "dimension": int(motion.dimension),
    }


def nearest_pose(arm: pieper.Arm, message: dict[str, Any]) -> dict[str, Any]:
    """Return the posture inside the limits nearest to a target that none reaches, and by how much it misses."""
    T = pose(message.get("T"), "target")
    near = arm.closest(T, task=optional(word, message.get("task"), "task", TASKS))
    return {"q": near.q.tolist(), "T": near.T.ravel().tolist(), "metres": near.metres, "radians": near.radians}


def formulas(arm: pieper.Arm, message: dict[str, Any]) -> dict[str, Any]:
    """Return what the formulas of the derivation give at a pose: one joint vector for each real branch."""
    T = pose(message.get("T"), "pose")
    equations = arm.symbolic.ik()
    if not equations.closed:
        return {"rows": []}
    branches = np.asarray(equations.evaluate(T[None]))[:, 0]
    return {"rows": branches[np.isfinite(branches).all(1)].tolist()}


def save(arm: pieper.Arm, message: dict[str, Any]) -> dict[str, Any]:
    """Return the arm as the text of a robot file."""
    with tempfile.TemporaryDirectory(prefix="pieper-") as folder:
        path = Path(folder) / "robot.toml"
        arm.save(path)
        return {"text": path.read_text(encoding="utf-8")}


TABLES: dict[str, Callable] = {"hello": hello, "load": load, "open": open_file, "catalog": catalogue}
QUICK: dict[str, Callable] = {"ik": ik, "formulas": formulas, "nearest": nearest_pose, "save": save}
