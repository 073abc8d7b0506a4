"""`pieper fk`: from joints to the pose of the tool."""

from __future__ import annotations

import click
import numpy as np
import numpy.typing as npt

import pieper
from pieper.cli.arguments import joints as read_joints
from pieper.cli.options import TakesNumbers, as_json, csv_file, takes_arm, takes_units
from pieper.cli.output import as_json as print_json
from pieper.cli.output import print_pose, say, short
from pieper.cli.status import DONE
from pieper.cli.units import Units
from pieper.tolerances import LIMIT_SLACK


@click.command("fk", cls=TakesNumbers, short_help="From joints to the pose of the tool.")
@takes_arm
@click.argument("joints", nargs=-1, required=True)
@click.option("--frames", is_flag=True, help="Every frame on the way, not only the tool.")
@click.option("--csv", metavar="FILE", default="", callback=csv_file, help="Write the poses of a table there.")
@as_json
@takes_units
def command(arm: pieper.Arm, joints: tuple[str, ...], frames: bool, csv: str, json: bool, units: Units) -> int:
    """Forward kinematics: from joints to the tool's pose.

    JOINTS is one number a joint, a posture's name, or @file. A file @joints.csv is a table with one joint vector a row,
    its columns named (shoulder_deg, or q1_deg, q2_deg, ...), in any order, or in the joints' order without names; out
    come position, rotation matrix and whether it lies inside the limits, row by row. A run with --csv that was stopped
    keeps its rows in FILE.part: the same command goes on there.

    Examples: pieper fk denso-vp6242 0 51.5 -150.6 0 99.1 0; pieper fk ur5e @joints.csv --csv poses.csv
    """
    if len(joints) == 1 and _is_table(joints[0], arm):
        if frames or json:
            raise pieper.InputError(
                "a table of joint vectors is written as CSV, the tool's pose a row: leave "
                f"{'--frames' if frames else '--json'} out."
            )
        from pieper.cli.fk_many import pose_file

        return pose_file(arm, joints[0][1:], units, csv)
    if csv:
        raise pieper.InputError("--csv takes the poses of a table: pieper fk ARM @joints.csv --csv FILE.", given=csv)
    q = read_joints(arm, joints, units)
    T = arm.fk(q)
    beyond = _outside(arm, q, units)
    every = arm.frames(q) if frames else np.zeros((0, 4, 4))
    if json:
        data = {
            "arm": arm.name,
            "q": q,
            "T": T,
            "position_m": T[:3, 3],
            "rpy_rad": pieper.read_pose(T, "rpy")[3:],
            "outside_limits": beyond,
        }
        print_json(data | ({"frames": every} if frames else {}))
        return DONE
    for i, F in enumerate(every[:-1]):
        print_pose(F, units, "base" if i == 0 else f"after {arm.joint_names[i - 1]}")
    print_pose(T, units, f"{arm.name}: tool")
    for sentence in beyond:
        say(sentence)
    return DONE


def _is_table(word: str, arm: pieper.Arm) -> bool:
    if not word.startswith("@"):
        return False
    from pieper.cli.joint_file import is_table

    return is_table(word, arm)


def _outside(arm: pieper.Arm, q: npt.NDArray[np.float64], units: Units) -> list[str]:
    out = []
    names = zip(arm.joint_names, units.of_joints(arm), units.names_of_joints(arm), strict=True)
    for (name, unit, word), value, (lower, upper) in zip(names, q, arm.limits, strict=True):
        if not lower - LIMIT_SLACK <= value <= upper + LIMIT_SLACK:
            out.append(
                f"note: {name} = {short(value / unit)} {word} is outside its limits "
                f"{short(lower / unit)} to {short(upper / unit)} {word}."
            )
    return out
