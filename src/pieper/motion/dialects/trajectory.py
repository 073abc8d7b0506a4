"""The timed motion itself: as a ROS JointTrajectory (YAML), and as a table (CSV)."""

from __future__ import annotations

import re

import numpy as np

from pieper.errors import InputError
from pieper.motion.dialects.dialect import Dialect, Script, Target, fixed, numbers
from pieper.motion.dialects.named_joints import UNITS, joint_columns, read_table
from pieper.words_by_number import plural


def write_ros(script: Script) -> str:
    """Return a trajectory_msgs/JointTrajectory in YAML: rad, m and s."""
    motion = script.motion()
    lines = [f"# {script.plan.name}: {script.name}; events are not part of a trajectory.", "header:"]
    lines += ["  frame_id: ''", "joint_names:", *(f"- {name}" for name in script.plan.names), "points:"]
    for t, q, dq, ddq in zip(motion.t, motion.q, motion.dq, motion.ddq, strict=True):
        seconds, nano = divmod(round(float(t) * 1e9), 10**9)
        for word, values in (("- positions", q), ("  velocities", dq), ("  accelerations", ddq)):
            lines.append(f"{word}: [{numbers([float(v) for v in values], 9, ', ')}]")
        lines += ["  time_from_start:", f"    sec: {seconds}", f"    nanosec: {nano}"]
    return "\n".join([*lines, ""])


def read_ros(text: str) -> list[Target]:
    """Return the points of a trajectory."""
    rows = re.findall(r"positions:\s*\[([^\]]*)\]", text)
    names = joint_names(text)
    points = [np.array([float(v) for v in row.split(",")]) for row in rows]
    for number, q in enumerate(points, 1):
        if len(q) != len(names):
            raise InputError(
                f"point {number} of the trajectory has {len(q)} positions for {plural(len(names), 'joint')}.", given=q
            )
    return [Target("point", q=q, joints=names) for q in points]


def joint_names(text: str) -> tuple[str, ...]:
    """Return the names of a trajectory's joints in their order.

    Raises:
        InputError: It names none.
    """
    listed = re.search(r"^\s*joint_names:\s*(?:\[([^\]]*)\]|((?:\n\s*- .*)+))", text, re.M)
    if listed is None:
        raise InputError("the trajectory names no joints: its joint_names are missing.", given="joint_names")
    names = listed[1].split(",") if listed[1] is not None else listed[2].strip().splitlines()
    return tuple(name.strip().removeprefix("- ").strip().strip("'\"") for name in names)


def write_csv(script: Script) -> str:
    """Return a table: time, s, joint values, rates and accelerations in degrees (millimetres of a slide)."""
    motion = script.motion()
    units = np.where(script.plan.prismatic, "mm", "deg")
    scale = np.where(script.plan.prismatic, 1e3, 180 / np.pi)
    head = ["t_s"]
    for what in ("", "_per_s", "_per_s2"):
        head += [f"{name}_{unit}{what}" for name, unit in zip(script.plan.names, units, strict=True)]
    lines = [",".join(head)]
    for t, *rows in zip(motion.t, motion.q, motion.dq, motion.ddq, strict=True):
        values = np.concatenate([row * scale for row in rows])
        lines.append(f"{fixed(float(t), 9)},{numbers([float(v) for v in values], 7, ',')}")
    return "\n".join([*lines, ""])


def read_csv(text: str) -> list[Target]:
    """Return the points of a table."""
    head, values = read_table(text)
    columns = [column for column in joint_columns(head) if column.order == 0]
    if not columns:
        raise InputError("the table has no joint columns: their names end in _deg, _rad, _mm or _m.", given=head)
    names = tuple(column.joint for column in columns)
    q = values[:, [column.at for column in columns]] * [UNITS[column.unit] for column in columns]
    return [Target("point", q=row, joints=names) for row in q]


ROS = Dialect("ros", (".yaml", ".yml"), None, 200, write_ros, read_ros)
CSV = Dialect("csv", (".csv",), None, 200, write_csv, read_csv)
