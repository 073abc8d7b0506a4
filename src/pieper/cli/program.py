"""`pieper program`: a program timed, told, drawn, and written for a controller."""

from __future__ import annotations

from pathlib import Path

import click

import pieper
from pieper.cli.arguments import joints
from pieper.cli.options import (
    TakesNumbers,
    animate,
    as_csv,
    as_json,
    figure,
    rate,
    start,
    takes_arm,
    takes_limits,
    takes_units,
)
from pieper.cli.output import say
from pieper.cli.status import DONE
from pieper.cli.timed import print_data, tell_limits, write
from pieper.cli.units import Units
from pieper.tolerances import SAME_SPEED


@click.command("program", cls=TakesNumbers, short_help="Time a program, draw it, write it for a controller.")
@takes_arm
@click.argument("file", metavar="FILE")
@click.option(
    "--write",
    "out",
    default="",
    metavar="FILE",
    help="Write it for a controller: .mod .script .src .ls .jbi .pcs, or .yaml (ROS), .csv, or .toml.",
)
@click.option("--dialect", default=None, metavar="NAME", help="Its language, where the ending does not say it.")
@click.option("--cartesian", is_flag=True, help="Poses with the maker's configuration words, not joint values.")
@start
@rate
@as_csv
@figure
@animate
@as_json
@takes_units
@takes_limits
def command(
    arm: pieper.Arm,
    file: str,
    out: str,
    dialect: str | None,
    cartesian: bool,
    start: str,
    rate: float,
    csv: str,
    figure: str,
    animate: str,
    json: bool,
    units: Units,
    limits: pieper.Limits | None,
) -> int:
    """Read a program (.toml of pieper, or of a controller as pieper writes it), time it and tell it.

    A controller's file holds no limits of the joints and no start: say --speed, --acceleration and --start for one.
    """
    program = _read(arm, file, limits, start, units)
    motion = program.motion(rate=rate)
    written = write(arm, motion, units, csv=csv, figure=figure, animate=animate)
    if out:
        if Path(out).suffix.lower() == ".toml":
            pieper.save_program(program, out)
        else:
            program.write(out, dialect=dialect, cartesian=cartesian)
        written.append(f"program: {out}")
    if json:
        print_data(arm, motion, moves=len(program.moves))
        return DONE
    say(program.explain() + "\n")
    tell_limits(arm, motion)
    for sentence in [*_unread(arm, file, limits), *written]:
        say(sentence)
    return DONE


def _unread(arm: pieper.Arm, file: str, limits: pieper.Limits | None) -> list[str]:
    """Return what of a controller's file is taken otherwise than its controller would, in sentences."""
    if Path(file).suffix.lower() == ".toml" or limits is None:
        return []
    targets, name, out = pieper.read_program(file), Path(file).name, list[str]()
    if any(target.kind == "point" for target in targets):
        return [f"Of {name} the points are read, not their times: they are moves of all joints that stop at each."]
    if any(target.kind == "move_j" and target.speed is not None for target in targets):
        out.append(f"Parts of the full speed of joints in {name} are taken of the limits typed.")
    most = float(limits.of(arm.n, arm.joint_names).speed.min()) * (1 + SAME_SPEED)
    if any((target.joint_speed or 0.0) > most for target in targets):
        out.append(f"Joint moves of {name} are faster than the limits typed, and cut to them.")
    if any(target.blend is None and target.kind != "stay" for target in targets):
        out.append(f"Corners of {name} that are cut by no radius (CNT, PL, C_PTP) are stopped at.")
    return out


def _read(arm: pieper.Arm, file: str, limits: pieper.Limits | None, start: str, units: Units) -> pieper.Program:
    if Path(file).suffix.lower() == ".toml":
        if limits is not None:
            raise pieper.InputError(
                f"{file} holds its own limits; change them there, or leave --speed and the like out."
            )
        return pieper.load_program(arm, file)
    targets = pieper.read_program(file)
    if limits is None:
        raise pieper.InputError(f"{file} holds no limits of the joints: say --speed and --acceleration.")
    if not targets:
        raise pieper.InputError(f"{file} holds no moves.", path=file)
    program = pieper.Program(arm, limits, start=joints(arm, [start], units, "--start"))
    try:
        return program.take(targets)
    except pieper.NoSolutionError as error:
        if program.moves:
            raise
        asked = f"{Path(file).name} does not say where the arm is when it begins: is --start {start} right?"
        raise pieper.NoSolutionError(f"{error} {asked}", **error.data) from None
