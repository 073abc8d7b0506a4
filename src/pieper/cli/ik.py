"""`pieper ik`: from a pose, or a file of poses, to every solution."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import click
import numpy as np
import numpy.typing as npt

import pieper
from pieper.cli.arguments import Target, joints, numbers, target
from pieper.cli.layout import Column
from pieper.cli.options import TakesNumbers, as_csv, as_json, figure, order, takes_arm, takes_units
from pieper.cli.output import as_json as print_json
from pieper.cli.output import (
    joint_cells,
    joint_columns,
    plural,
    print_pose,
    print_position,
    print_table,
    say,
    si_units,
    small,
)
from pieper.cli.status import DONE, NO_SOLUTION
from pieper.cli.units import Units
from pieper.tolerances import LIMIT_SLACK


@click.command("ik", cls=TakesNumbers, short_help="From a pose, or a file of poses, to every solution.")
@takes_arm
@click.argument("pose", nargs=-1, required=True)
@order
@click.option(
    "--near", default="", metavar="JOINTS", help="Mark the solution nearest to these (quoted), turns resolved."
)
@click.option(
    "--task", default="", metavar="TASK", help='"pose", "position" or "position+axis"; the arm has a default.'
)
@click.option(
    "--redundancy", default="", metavar="VALUE", help="Value of a redundant joint, or by name: 'arm angle=20'."
)
@click.option("--all", "everything", is_flag=True, help="Also solutions outside the joint limits.")
@as_csv
@figure
@as_json
@takes_units
def command(
    arm: pieper.Arm,
    pose: tuple[str, ...],
    order: str,
    near: str,
    task: str,
    redundancy: str,
    everything: bool,
    csv: str,
    figure: str,
    json: bool,
    units: Units,
) -> int:
    """Inverse kinematics: every solution of a pose, with labels, limits and residuals.

    POSE is x y z (orientation R = I; of an arm that cannot hold it, the position alone), or x y z and an orientation
    (see --order), or the 12 or 16 numbers of a matrix row by row, or @file.

    A file @poses.csv is a table with one pose a row. Its columns may be named, in any order: x_mm or x_m, y, z, and
    roll, pitch, yaw (_deg or _rad), or qw, qx, qy, qz, or r11 to r33, and so on. With --csv the solutions are written
    into a file, without it to the standard output; with --json one object a line. A run with --csv that was stopped
    keeps its rows in FILE.part: the same command goes on there.

    Examples: pieper ik denso-vp6242 350 0 400 --all; pieper ik ur5e @poses.csv --csv out.csv
    """
    plan = arm.plan_for(task or None)
    spare = _redundancy(plan, redundancy, units)
    now = joints(arm, [near], units, "--near") if near else None
    if len(pose) == 1 and _is_table(pose[0]):
        from pieper.cli.ik_many import Request, solve_file

        if figure:
            raise pieper.InputError("--figure draws one pose, not a file of poses.")
        if csv and json:
            raise pieper.InputError("the solutions of a table go into --csv FILE or out as --json: leave one out.")
        return solve_file(Request(arm, pose[0][1:], units, order, task or None, spare, now, everything, csv, json))
    solved = _solve(arm, target(pose, units, order), task or None, spare)
    found = _Rows.of(arm, solved.sols, solved.plan, everything)
    held = solved.sols.status in (pieper.Status.SOLVED, pieper.Status.SINGULAR, pieper.Status.REDUNDANT)
    status = DONE if held or len(solved.sols) else NO_SOLUTION
    if figure and len(solved.sols):
        pieper.plot.save_figure(pieper.plot.solutions_figure(arm, solved.sols), figure)
    if csv:
        from pieper.cli.ik_many import write_rows

        write_rows(arm, csv, found.q, found.inside, found.residual, units, solved.sols.status.name)
    if json:
        print_json(_as_data(arm, solved, found, _closest(solved.sols, now)[1]))
        return status
    _print(arm, solved, found, near, now, everything, units)
    for file in (name for name in (csv, figure if len(solved.sols) else "") if name):
        say(f"written: {file}")
    return status


def _is_table(word: str) -> bool:
    """Return whether a typed pose names a table of poses; what reads them is imported for a file alone."""
    if not word.startswith("@"):
        return False
    from pieper.cli.pose_file import is_table

    return is_table(word)


@dataclass(frozen=True, eq=False)
class _Solved:
    """What was answered, by which plan, and what was taken differently from how it was typed."""

    sols: pieper.Solutions
    plan: pieper.Plan
    note: str = ""


@dataclass(frozen=True, eq=False)
class _Rows:
    """Rows to show: q (k, n), labels, which lie inside the limits, residuals (k, 2), self-motions (-1 for none)."""

    q: npt.NDArray[np.float64]
    labels: Sequence[str]
    inside: npt.NDArray[np.bool_]
    residual: npt.NDArray[np.float64]
    motion: npt.NDArray[np.int_]

    @staticmethod
    def of(arm: pieper.Arm, sols: pieper.Solutions, plan: pieper.Plan, everything: bool) -> _Rows:
        q = sols.all_q if everything else sols.q
        inside = np.asarray(sols.in_limits) if everything else np.ones(len(sols), bool)
        motion = np.full(len(q), -1)
        motion[inside] = sols.in_self_motion
        residual = plan.residual(q, sols.T) if len(q) else np.zeros((0, 2))
        return _Rows(q, sols.all_labels if everything else sols.labels, inside, residual, motion)


def _solve(arm: pieper.Arm, given: Target, task: str | None, spare: Any) -> _Solved:
    """Solve a pose; x y z alone is a position for an arm that cannot hold R = I there."""
    plan = arm.plan_for(task)
    sols = arm.ik(given.T, task=task, redundancy=spare)
    free = given.bare and task is None and spare is None and plan.task == "pose" and plan.rank < 6
    if free and sols.status == pieper.Status.OUT_OF_REACH:
        try:
            position = arm.plan_for("position")
        except pieper.PlanError:
            return _Solved(sols, plan)
        note = (
            f"note: x y z was taken as a position: with its {plural(arm.n, 'joint')} {arm.name} cannot hold R = I "
            "there. Give an orientation to ask for one."
        )
        return _Solved(arm.ik(given.T, task="position"), position, note)
    return _Solved(sols, plan)


def _closest(
    sols: pieper.Solutions, now: npt.NDArray[np.float64] | None
) -> tuple[int | None, npt.NDArray[np.float64] | None]:
    """Return the row of q nearest to a posture, or None where a continuous set comes nearer, and the nearest."""
    if now is None or not (len(sols) or sols.self_motions):
        return None, None
    try:
        nearest = sols.nearest(now)
    except pieper.NoSolutionError:
        return None, None
    if not len(sols):
        return None, nearest
    row, unwound = sols.nearest_row(now)
    return (row if np.allclose(unwound, nearest, atol=LIMIT_SLACK) else None), nearest


def _print(
    arm: pieper.Arm,
    solved: _Solved,
    found: _Rows,
    near: str,
    now: npt.NDArray[np.float64] | None,
    everything: bool,
    units: Units,
) -> None:
    sols = solved.sols
    if solved.note:
        say(solved.note + "\n")
    if solved.plan.task == "position":
        print_position(sols.T, units)
        print()
    else:
        print_pose(sols.T, units, "pose")
    row, nearest = _closest(sols, now)
    marked = int(np.flatnonzero(sols.in_limits)[row]) if row is not None and everything else row
    if len(found.q):
        _print_rows(arm, sols, found, marked, units)
    # every pose of an arm with a joint to spare has them, and to trace them takes as long as all else
    told = everything or not (solved.plan.redundancy and len(sols))
    texts = [str(motion) for motion in sols.self_motions] if told else []
    for text in dict.fromkeys(texts):
        which = [str(i + 1) for i, other in enumerate(texts) if other == text]
        say(f"{'self-motion' if len(which) == 1 else 'self-motions'} {', '.join(which)}: {text}.")
    if nearest is not None:
        which = "on a continuous set of solutions" if marked is None else f"solution {marked + 1}"
        values = ", ".join(joint_cells(arm, nearest, units))
        say(f"nearest to {near}: {which}, at {values} ({units.said_of_joints(arm)})")
    say(f"{sols.status.name}: {sols.why}")
    if sols.status == pieper.Status.OUT_OF_REACH:
        cells = ", ".join(joint_cells(arm, sols.closest.q, units))
        say(f"The posture inside the limits that comes nearest: {cells} ({units.said_of_joints(arm)}).")
    if not told:
        say("Its self-motions, along which the spare joint moves, are told with --all.")
    hidden = len(sols.all_q) - len(sols.q)
    if hidden and not everything:
        say(f"{hidden} more outside the limits: add --all to see {'it' if hidden == 1 else 'them'}.")
    if sols.rounded:
        say("note: the rotation was rounded; the nearest exact rotation was solved.")


def _print_rows(arm: pieper.Arm, sols: pieper.Solutions, found: _Rows, marked: int | None, units: Units) -> None:
    columns = [
        Column("#", True),
        *joint_columns(arm, units),
        Column("posture", True),
        Column("limits", True),
        Column("residual", True),
        Column("", True),
    ]
    rows = []
    for i, q in enumerate(found.q):
        rows.append(
            [
                f"{i + 1} *" if i == marked else f"{i + 1}",
                *joint_cells(arm, q, units),
                found.labels[i],
                "inside" if found.inside[i] else _which_limit(arm, q),
                ", ".join(
                    small(v / unit, name)
                    for v, unit, name in zip(
                        found.residual[i], (units.metres, units.radians), (units.length, units.angle), strict=True
                    )
                ),
                f"self-motion {found.motion[i] + 1}" if found.motion[i] >= 0 else "",
            ]
        )
    title = f"{arm.name}: {len(sols)} of {plural(len(sols.all_q), 'solution')} inside the limits"
    print_table(title, columns, rows, strong=marked)


def _which_limit(arm: pieper.Arm, row: npt.NDArray[np.float64]) -> str:
    over = np.maximum(arm.limits[:, 0] - row, row - arm.limits[:, 1])
    return f"{arm.joint_names[int(np.argmax(over))]} outside"


def _redundancy(
    plan: pieper.Plan, text: str, units: Units
) -> float | dict[str, float] | npt.NDArray[np.float64] | None:
    """Read "20", "20 30" or "arm angle=20; joint_1=30": angles and lengths in the units said."""
    if not text:
        return None
    if "=" in text:
        pairs = [part.partition("=") for part in text.split(";") if part.strip()]
        return {name.strip(): _one(value, name.strip()) * _unit(plan, name.strip(), units) for name, _, value in pairs}
    values = numbers([text], "--redundancy")
    names = [*plan.redundancy, *[""] * len(values)]
    scaled = [v * _unit(plan, name, units) for v, name in zip(values, names, strict=False)]
    return scaled[0] if len(scaled) == 1 else np.array(scaled)


def _one(text: str, name: str) -> float:
    values = numbers([text], f"--redundancy, {name}")
    if len(values) != 1:
        raise pieper.InputError(f"--redundancy, {name}: give one number, got {len(values)}.", given=text)
    return values[0]


def _unit(plan: pieper.Plan, name: str, units: Units) -> float:
    sliding = name in plan.names and plan.prismatic[plan.names.index(name)]
    return units.metres if sliding else units.radians


def _as_data(arm: pieper.Arm, solved: _Solved, found: _Rows, closest: npt.NDArray[np.float64] | None) -> dict[str, Any]:
    sols = solved.sols
    rows = zip(found.q, found.labels, found.inside, found.residual, found.motion, strict=True)
    return {
        "arm": arm.name,
        "T": sols.T,
        "task": solved.plan.task,
        "status": sols.status.name,
        "why": sols.why,
        "note": solved.note or None,
        "joint_names": arm.joint_names,
        "units": si_units(arm),
        "solutions": [
            {
                "q": q,
                "label": label,
                "in_limits": bool(ok),
                "residual_m": r[0],
                "residual_rad": r[1],
                "self_motion": int(motion) if motion >= 0 else None,
            }
            for q, label, ok, r, motion in rows
        ],
        "solutions_before_limits": len(sols.all_q),
        "self_motions": [str(motion) for motion in sols.self_motions],
        "nearest": closest,
        "closest": None if len(sols) else _as_closest(sols.closest),
    }


def _as_closest(found: pieper.Closest) -> dict[str, Any]:
    """Return the posture inside the limits that comes nearest to a pose without a solution."""
    return {"q": found.q, "T": found.T, "missed_m": found.metres, "missed_rad": found.radians}
