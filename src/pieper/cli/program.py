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
    for sentence in [*_unread(file), *written]:
        say(sentence)
    return DONE


def _unread(file: str) -> list[str]:
    """Return what of a file is not in the program that was read from it, in a sentence."""
    if Path(file).suffix.lower() == ".toml":
        return []
    return [
        f"Of {Path(file).name} the targets, tools and frames are read, not its speeds, blends, waits, outputs and "
        "gripper: the times are those of stops at each target within the limits. A .toml keeps all."
    ]


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
    tool = arm.tool
    for target in targets:
        # none that is set is the arm's own
        if not target.means_tool(tool) and not (target.tool is None and tool is arm.tool):
            tool = arm.tool if target.tool is None else target.tool
            program.tool(tool)
        where = target.T if target.q is None else target.q
        if where is None:
            raise pieper.InputError(f"{file} has a move without a target.", path=file)
        if target.kind == "move_c" and target.T is not None:
            program.move_c(target.via, target.T)
        elif target.kind == "move_l":
            program.move_l(arm.fk(where) if target.T is None else where)
        else:
            program.move_j(where)
    return program
