"""`pieper fk` and `pieper ik`: from joints to a pose, and from a pose to every solution."""

from __future__ import annotations

import numpy as np

from pieper.cli import DONE, NO_SOLUTION
from pieper.cli.given import Units, joints, numbers, pose
from pieper.cli.given import arm as load
from pieper.cli.printed import (
    as_json,
    console,
    joint_cells,
    joint_columns,
    pose_table,
    rpy_text,
    small,
    table,
)


def fk(name: str, words: list[str], frames: bool, json: bool, length: str, angle: str) -> int:
    """Print the pose of a joint vector."""
    units = Units(length, angle)
    arm = load(name)
    q = joints(arm, words, units)
    T = arm.fk(q)
    beyond = _outside(arm, q, units)
    every = arm.frames(q) if frames else None
    if json:
        data = {
            "arm": arm.name,
            "q": q,
            "T": T,
            "position_m": T[:3, 3],
            "rpy_rad": rpy_text(T),
            "outside_limits": beyond,
        }
        as_json(data | ({"frames": every} if frames else {}))
        return DONE
    out = console()
    if frames:
        for i, F in enumerate(every[:-1]):
            out.print(pose_table(F, units, "base" if i == 0 else f"after {arm.joint_names[i - 1]}"))
    out.print(pose_table(T, units, f"{arm.name}: tool"))
    for sentence in beyond:
        out.print(sentence, markup=False)
    return DONE


def _outside(arm, q: np.ndarray, units: Units) -> list[str]:
    out = []
    for i, (value, (lower, upper)) in enumerate(zip(q, arm.limits, strict=True)):
        if not lower - 1e-9 <= value <= upper + 1e-9:
            unit, word = units.of_joints(arm)[i], units.names_of_joints(arm)[i]
            out.append(
                f"note: {arm.joint_names[i]} = {value / unit:.4g} {word} is outside its limits "
                f"{lower / unit:.4g} to {upper / unit:.4g} {word}."
            )
    return out


def ik(
    name: str,
    words: list[str],
    order: str,
    near: str,
    task: str,
    redundancy: str,
    everything: bool,
    figure: str,
    json: bool,
    length: str,
    angle: str,
) -> int:
    """Print every solution of a pose."""
    units = Units(length, angle)
    arm = load(name)
    T = pose(words, units, order)
    plan = arm.plan_for(task or None)
    spare = _redundancy(plan, redundancy, units)
    sols = arm.ik(T, task=task or None, redundancy=spare)
    closest = sols.nearest(joints(arm, [near], units, "--near")) if near and len(sols) else None
    rows = sols.all_q if everything else sols.q
    labels = sols.all_labels if everything else sols.labels
    inside = sols.in_limits if everything else np.ones(len(sols), bool)
    residual = plan.residual(rows, sols.T) if len(rows) else np.zeros((0, 2))
    status = DONE if len(sols) or sols.self_motions else NO_SOLUTION
    if figure and len(sols):
        from pieper.presentation.plot_arm import solutions_figure
        from pieper.presentation.style import save_figure

        save_figure(solutions_figure(arm, sols), figure)
    if json:
        as_json(_as_data(arm, sols, rows, labels, inside, residual, closest, plan))
        return status
    out = console()
    title = f"{arm.name}: {len(sols)} of {len(sols.all_q)} solutions inside the limits"
    made = table(
        title,
        "#",
        *joint_columns(arm, units),
        "posture",
        "limits",
        "residual",
        "",
        left=(arm.n + 1, arm.n + 2, arm.n + 4),
    )
    motions = sols.in_self_motion if not everything else _all_self_motions(sols, rows)
    for i, row in enumerate(rows):
        remark = f"self-motion {motions[i] + 1}" if motions[i] >= 0 else ""
        made.add_row(
            str(i + 1),
            *joint_cells(arm, row, units),
            labels[i],
            "inside" if inside[i] else _which_limit(arm, row),
            f"{small(residual[i, 0] * 1e3, 'mm')}, {small(np.degrees(residual[i, 1]), 'deg')}",
            remark,
        )
    out.print(pose_table(sols.T, units, "pose"))
    if len(rows):
        out.print(made)
    for i, motion in enumerate(sols.self_motions):
        out.print(f"self-motion {i + 1}: {motion}", markup=False)
    if closest is not None:
        out.print(f"nearest to {near}: {', '.join(joint_cells(arm, closest, units))}", markup=False)
    out.print(f"{sols.status.name}: {sols.why}", markup=False)
    hidden = len(sols.all_q) - len(sols.q)
    if hidden and not everything:
        out.print(f"{hidden} more outside the limits: add --all to see them.", markup=False)
    if sols.rounded:
        out.print("note: the rotation was rounded; the nearest exact rotation was solved.", markup=False)
    return status


def _redundancy(plan, text: str, units: Units) -> object:
    """Read "20", "20 30" or "arm angle=20; joint_1=30": angles and lengths in the units said."""
    if not text:
        return None
    if "=" in text:
        given = {}
        for part in text.split(";"):
            name, _, value = part.partition("=")
            given[name.strip()] = numbers([value], "--redundancy")[0] * _unit(plan, name.strip(), units)
        return given
    values = numbers([text], "--redundancy")
    names = [*plan.redundancy, *[""] * len(values)]
    scaled = [v * _unit(plan, name, units) for v, name in zip(values, names, strict=False)]
    return scaled[0] if len(scaled) == 1 else np.array(scaled)


def _unit(plan, name: str, units: Units) -> float:
    sliding = name in plan.names and plan.prismatic[plan.names.index(name)]
    return units.metres if sliding else units.radians


def _all_self_motions(sols, rows: np.ndarray) -> np.ndarray:
    out = np.full(len(rows), -1)
    out[sols.in_limits] = sols.in_self_motion
    return out


def _which_limit(arm, row: np.ndarray) -> str:
    over = np.maximum(arm.limits[:, 0] - row, row - arm.limits[:, 1])
    return f"{arm.joint_names[int(np.argmax(over))]} outside"


def _as_data(arm, sols, rows, labels, inside, residual, closest, plan) -> dict:
    motions = _all_self_motions(sols, rows) if len(rows) != len(sols.q) else sols.in_self_motion
    return {
        "arm": arm.name,
        "T": sols.T,
        "task": plan.task,
        "status": sols.status.name,
        "why": sols.why,
        "joint_names": arm.joint_names,
        "units": ["rad" if kind == "R" else "m" for kind in arm.joint_types],
        "solutions": [
            {
                "q": q,
                "label": label,
                "in_limits": bool(ok),
                "residual_m": r[0],
                "residual_rad": r[1],
                "self_motion": int(motion) if motion >= 0 else None,
            }
            for q, label, ok, r, motion in zip(rows, labels, inside, residual, motions, strict=True)
        ],
        "solutions_before_limits": len(sols.all_q),
        "self_motions": [str(motion) for motion in sols.self_motions],
        "nearest": closest,
    }
