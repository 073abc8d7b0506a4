"""The options that several commands share, each said once."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any

import click

import pieper
from pieper.cli.given import ALSO, NOTATIONS
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
    "wpr (Fanuc's W, P, R), zyz, rotvec, quat_wxyz or quat_xyzw.",
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


def takes_arm(command: Command) -> Command:
    """Add the argument ARM with --base and --tip; the command is given the arm itself as `arm`."""

    @functools.wraps(command)
    def with_arm(arm: str, base: str, tip: str, **rest: Any) -> Any:
        return command(arm=load(arm, base, tip), **rest)

    made = click.argument("arm", metavar="ARM")(with_arm)
    made = click.option("--tip", default="", metavar="LINK", help="Link of a robot file where the arm ends.")(made)
    return click.option("--base", default="", metavar="LINK", help="Link of a robot file where the arm begins.")(made)


def load(name: str, base: str = "", tip: str = "") -> pieper.Arm:
    """Return the arm of a catalogue name, a part of one, or a robot file, between two of its links if they are named.

    Raises:
        InputError: There is no such arm or file, or no such link.
    """
    links: dict[str, Any] = {key: link for key, link in (("base", base), ("tip", tip)) if link}
    return pieper.load(name, **links)


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
