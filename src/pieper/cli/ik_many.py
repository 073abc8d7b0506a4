"""A file of poses solved block by block, and solutions written as CSV, in constant memory."""

from __future__ import annotations

import sys
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import numpy.typing as npt

import pieper
from pieper.cli.failure import note
from pieper.cli.kept_rows import fingerprint, rows_to
from pieper.cli.many import progress
from pieper.cli.number_table import refuse_same
from pieper.cli.output import json_text, plural, si_units
from pieper.cli.pose_file import PoseFile
from pieper.cli.status import DONE, NO_SOLUTION
from pieper.cli.units import Units

#: Decimals of joint values in a CSV: finer than any unit's rounding noise.
DECIMALS = 12


@dataclass(frozen=True, eq=False)
class Request:
    """What is asked of a file of poses; the fields are those of `pieper ik`."""

    arm: pieper.Arm
    file: str
    units: Units
    order: str
    task: str | None
    redundancy: Any
    near: npt.NDArray[np.float64] | None
    everything: bool
    csv: str
    json: bool


def solve_file(request: Request) -> int:
    """Solve every pose of a file; the status is 1 when one of them has no solution inside the limits."""
    poses = PoseFile(request.file, request.units, request.order)
    refuse_same(request.file, request.csv)
    with progress(poses.size, "poses") as read, rows_to(request.csv, "pose", _question(request)) as out:
        if "task" in out.notes:
            request = replace(request, task=out.notes["task"])
        for block in poses.blocks(read, out.place):
            if not out.done and poses.bare:
                request = _of_positions(request, block)
                out.notes.update({"task": request.task} if request.task else {})
            many = request.arm.ik_many(block, near=request.near, task=request.task, redundancy=request.redundancy)
            if not out.done and not request.json:
                out.put(head(request.arm, request.units))
            lines, rows = (_json_lines if request.json else _csv_block)(request, many, block, out.done)
            out.put(lines)
            without = int(np.count_nonzero(~many.in_limits.any(1)))
            out.keep(poses.place, done=len(block), rows=rows, without=without)
    if poses.unused:
        note(f"not used of {request.file}: {', '.join(poses.unused)}.")
    without, rows = out.counts["without"], plural(out.counts["rows"], "row")
    said = f"{plural(out.done, 'pose')}, {without:,} of them without a solution inside the limits; {rows}"
    print(said + (f" written: {request.csv}" if request.csv else "."), file=sys.stderr)
    return NO_SOLUTION if without else DONE


def _question(request: Request) -> dict[str, Any]:
    """Return what makes the rows of a request these rows."""
    spare = request.redundancy
    return {
        "command": "ik",
        "version of pieper": pieper.__version__,
        "arm": fingerprint(request.arm),
        "unit": request.units.said,
        "--order": request.order,
        "--task": request.task,
        "--redundancy": spare.tolist() if isinstance(spare, np.ndarray) else spare,
        "--near": None if request.near is None else request.near.tolist(),
        "--all": request.everything,
        "choice of CSV or JSON": request.json,
    }


def _of_positions(request: Request, block: npt.NDArray[np.float64]) -> Request:
    """Return the request for positions alone where the arm cannot hold R = I at any of the first ones; says so."""
    arm, plan = request.arm, request.arm.plan_for(request.task)
    if request.task is not None or request.redundancy is not None or plan.task != "pose" or plan.rank >= 6:
        return request
    if np.any(arm.ik_many(block).status != pieper.Status.OUT_OF_REACH):
        return request
    try:
        arm.plan_for("position")
    except pieper.PlanError:
        return request
    note(f"x y z were taken as positions: {arm.name} cannot hold R = I there.")
    return replace(request, task="position")


def head(arm: pieper.Arm, units: Units) -> str:
    """Return the first line of a CSV of solutions: names with their units."""
    joints = [f"{name}_{unit}" for name, unit in zip(arm.joint_names, units.names_of_joints(arm), strict=True)]
    columns = ["pose", "solution", "status", *joints, "in_limits"]
    return ",".join([*columns, f"residual_{units.length}", f"residual_{units.angle}"]) + "\n"


def write_rows(
    arm: pieper.Arm,
    file: str,
    q: npt.NDArray[np.float64],
    inside: npt.NDArray[np.bool_],
    residual: npt.NDArray[np.float64],
    units: Units,
    status: str,
) -> None:
    """Write the solutions of one pose as CSV, whole or not at all."""
    values = np.column_stack([q / units.of_joints(arm), inside.astype(float), residual / [units.metres, units.radians]])
    lines = _lines(np.ones(len(q), int), np.arange(1, len(q) + 1), [status] * len(q), values)
    with pieper.whole_file(file) as out:
        out.write((head(arm, units) + lines).encode())


def _chosen(
    request: Request, many: pieper.SolutionBatch
) -> tuple[npt.NDArray[np.int_], npt.NDArray[np.float64], npt.NDArray[np.bool_]]:
    """Return the pose (0-based), joints and whether inside the limits, of each row that is asked for."""
    if request.near is not None:
        found = many.has_nearest
        return np.flatnonzero(found), many.nearest[found], np.ones(np.count_nonzero(found), bool)
    mask = many.valid if request.everything else many.in_limits
    return np.nonzero(mask)[0], many.q[mask], many.in_limits[mask]


def _csv_block(
    request: Request, many: pieper.SolutionBatch, T: npt.NDArray[np.float64], before: int
) -> tuple[str, int]:
    """Return lines of CSV, and how many of them are solutions."""
    arm, units = request.arm, request.units
    pose, q, inside = _chosen(request, many)
    residual = arm.plan_for(request.task).residual(q, T[pose]) / [units.metres, units.radians]
    values = np.column_stack([q / units.of_joints(arm), inside.astype(float), residual])
    without = np.setdiff1d(np.arange(len(T)), pose)
    counts = np.bincount(pose, minlength=len(T))
    solution = np.arange(len(pose)) - np.repeat(np.cumsum(counts) - counts, counts) + 1
    # a pose without a row gets a line of its own that says why, in its place
    pose, solution = np.concatenate([pose, without]), np.concatenate([solution, np.zeros(len(without), int)])
    values = np.vstack([values, np.full((len(without), values.shape[1]), np.nan)])
    sorted_ = np.argsort(pose, kind="stable")
    names = {int(s): s.name for s in pieper.Status}
    status = [names[int(s)] for s in many.status[pose[sorted_]]]
    return _lines(pose[sorted_] + before + 1, solution[sorted_], status, values[sorted_]), len(q)


def _lines(
    pose: npt.NDArray[np.int_], solution: npt.NDArray[np.int_], status: list[str], values: npt.NDArray[np.float64]
) -> str:
    """Return lines of CSV, cells empty where there is no solution; what is smaller than rounding is 0."""
    n = values.shape[1] - 3
    form = "%d,%d,%s," + "%r," * n + "%d,%.3g,%.3g\n"
    empty = "%d,0,%s," + "," * n + ",,\n"
    values[:, :n] = np.round(values[:, :n], DECIMALS) + 0.0
    rows = values.tolist()
    return "".join(
        form % (p, k, s, *row) if k else empty % (p, s)
        for p, k, s, row in zip(pose.tolist(), solution.tolist(), status, rows, strict=True)
    )


def _json_lines(
    request: Request, many: pieper.SolutionBatch, T: npt.NDArray[np.float64], before: int
) -> tuple[str, int]:
    """Return one object a pose, in SI units, and how many solutions they hold."""
    pose, q, inside = _chosen(request, many)
    lines = []
    for i in range(len(T)):
        mine = pose == i if len(T) < 64 else slice(*np.searchsorted(pose, [i, i + 1]))
        data = {
            "pose": before + i + 1,
            "status": pieper.Status(int(many.status[i])).name,
            "units": si_units(request.arm),
            "q": q[mine],
            "in_limits": inside[mine],
        }
        lines.append(json_text(data, indent=None) + "\n")
    return "".join(lines), len(q)
