"""The options that several commands share, each said once."""

from __future__ import annotations

import functools
import sys
from collections.abc import Callable
from typing import Any

import click

import pieper
from pieper.cli.arguments import ALSO, NOTATIONS
from pieper.cli.units import ANGLES, LENGTHS, Units

#: For commands that take numbers: a negative one is a number, not an option.
NUMBERS = {"ignore_unknown_options": True}

Command = Callable[..., Any]

as_json = click.option("--json", is_flag=True, help="Print JSON, in metres and radians, for machines.")
as_csv = click.option(
    "--csv", default="", metavar="FILE", help="Write the rows into this .csv, in the units asked for."
)
figure = click.option("--figure", default="", metavar="FILE", help="Draw into this .png, .svg or .pdf.")
order = click.option(
    "--order",
    default="rpy",
    show_default=True,
    metavar="NOTATION",
    type=click.Choice([*NOTATIONS, *ALSO]),
    help="What the numbers after x y z mean: rpy (roll, pitch, yaw about the fixed x, y, z), abc (KUKA's A, B, C), "
    "wpr (Fanuc's W, P, R), zyz, rotvec (UR's rotation vector), staubli, yaskawa, quat_wxyz (ABB) or quat_xyzw.",
)
first = click.option("--from", "first", default="", metavar="POSE", help="First pose, quoted, as for ik; or @file.")
last = click.option("--to", "last", default="", metavar="POSE", help="Last pose, quoted, as for ik; or @file.")
points = click.option(
    "--points", "-n", default=50, show_default=True, help="Poses on each straight stretch, ends included."
)
start = click.option(
    "--start",
    default="zero",
    show_default=True,
    metavar="JOINTS",
    help="Joints the arm is in (quoted), or a posture's name.",
)


def takes_arm(command: Command, *, default: str | None = None) -> Command:
    """Add the argument ARM, and where in its file it begins and ends; the command is given the arm itself as `arm`."""

    @functools.wraps(command)
    def with_arm(arm: str, base: str | None, tip: str | None, missing_limits: str, **rest: Any) -> Any:
        loaded = pieper.load(arm, base=base, tip=tip, missing_limits=missing_limits)
        for note in loaded.notes:
            print(f"pieper: note: {note}", file=sys.stderr)
        return command(arm=loaded, **rest)

    made: Command = with_arm
    for option in (
        click.option(
            "--missing-limits",
            default="refuse",
            show_default=True,
            type=click.Choice(["refuse", "unlimited"]),
            help="What to do where a robot file says no limits of a joint.",
        ),
        click.option("--tip", default=None, metavar="LINK", help="Link (or named tool) of a robot file to end at."),
        click.option("--base", default=None, metavar="LINK", help="Link (or named frame) of a robot file to begin at."),
        click.argument("arm", metavar="ARM")
        if default is None
        else click.argument("arm", metavar="[ARM]", default=default),
    ):
        made = option(made)
    return made


def takes_units(command: Command) -> Command:
    """Add --angle and --length; the command is given `units`."""

    @functools.wraps(command)
    def with_units(angle: str, length: str, **rest: Any) -> Any:
        return command(units=Units(length, angle), **rest)

    made: Command = with_units
    for name, choices in (("--angle", tuple(ANGLES)), ("--length", tuple(LENGTHS))):
        made = click.option(
            name, default=choices[0], show_default=True, type=click.Choice(choices), help="Unit, typed and printed."
        )(made)
    return made
