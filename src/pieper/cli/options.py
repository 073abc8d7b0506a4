"""The options that several commands share, each said once."""

from __future__ import annotations

import functools
from collections.abc import Callable
from pathlib import Path
from typing import Any

import click
import numpy as np

import pieper
from pieper.cli.arguments import ALSO, NOTATIONS, numbers
from pieper.cli.failure import note
from pieper.cli.units import ANGLES, LENGTHS, Units

Command = Callable[..., Any]


class TakesNumbers(click.Command):
    """A command that takes numbers: -5 and -pi/2 are numbers and no options; --word is an option or a mistake."""

    ignore_unknown_options = True

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Read the words, after an option that does not exist is said to be one."""
        known = [name for parameter in self.get_params(ctx) for name in (*parameter.opts, *parameter.secondary_opts)]
        typed = args[: args.index("--")] if "--" in args else args
        for word in (word.split("=")[0] for word in typed):
            if word.startswith("--") and word not in known:
                raise click.UsageError(f"There is no option {word}.{_meant(word, known)}", ctx)
        return super().parse_args(ctx, args)


def _meant(word: str, known: list[str]) -> str:
    if "--order" in known and word[2:] in (*NOTATIONS, *ALSO):
        return f" Say --order {word[2:]}, and the numbers after x y z."
    import difflib

    near = difflib.get_close_matches(word, known, n=1)
    return (
        f" Did you mean {near[0]}?" if near else f" There are {', '.join(name for name in known if name[:2] == '--')}."
    )


as_json = click.option("--json", is_flag=True, help="Print JSON, in metres and radians, for machines.")
#: Endings of tables; a pipe or a device has none.
TABLES = (".csv", ".tsv", ".txt", "")


def csv_file(_context: click.Context, _option: click.Parameter, file: str) -> str:
    """Return the name of a table to write.

    Raises:
        InputError: It is "-", which names no file, or its ending says that it is something else.
    """
    if file == "-":
        raise pieper.InputError("--csv - names no file: give it a name, such as --csv rows.csv.", given=file)
    ending = Path(file).suffix
    if ending.lower() not in TABLES:
        raise pieper.InputError(
            f"{file}: a table is written as {' or '.join(TABLES[:-1])}, not as {ending!r}.",
            given=ending,
            allowed=TABLES,
        )
    return file


as_csv = click.option(
    "--csv",
    default="",
    metavar="FILE",
    callback=csv_file,
    help="Write the rows into this .csv, in the units asked for.",
)
figure = click.option("--figure", default="", metavar="FILE", help="Draw into this .png, .svg or .pdf.")
animate = click.option(
    "--animate",
    default="",
    metavar="FILE",
    help="Write a moving picture: .gif, .webp, .mp4, or .html, a page that plays it.",
)
rate = click.option("--rate", default=500.0, show_default=True, help="Samples a second.")
order = click.option(
    "--order",
    default="rpy",
    show_default=True,
    metavar="NOTATION",
    type=click.Choice([*NOTATIONS, *ALSO]),
    help="What the numbers after x y z mean: rpy (roll, pitch, yaw about the fixed x, y, z), abc (KUKA's A, B, C), "
    "wpr (Fanuc's W, P, R), zyz, rotvec (UR's rotation vector), staubli, yaskawa, quat_wxyz (ABB) or quat_xyzw.",
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
        for said in loaded.notes:
            note(said)
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


#: Option -> field of `pieper.Limits`, one number a joint or one for all, and what it is.
_LIMITS = {
    "speed": "Largest speeds of the joints a second",
    "acceleration": "Largest accelerations of the joints a second and second",
    "jerk": "Largest jerks of the joints",
}
_TOOL_LIMITS = {
    "tool_speed": "Largest speed of the tool's point",
    "tool_acceleration": "Largest acceleration of the tool's point",
    "turn_speed": "Largest speed at which the tool turns",
}


def takes_limits(command: Command) -> Command:
    """Add --speed, --acceleration, --jerk and those of the tool; the command is given `limits`, or None.

    Stands between `takes_arm` and `takes_units`, whose arm and units it needs.
    """

    @functools.wraps(command)
    def with_limits(arm: pieper.Arm, units: Units, **rest: Any) -> Any:
        given: dict[str, Any] = {}
        for name in (*_LIMITS, *_TOOL_LIMITS):
            text = rest.pop(name)
            if text:
                given[name] = _limit(arm, units, name, text)
        missing = [name for name in ("speed", "acceleration") if name not in given]
        if given and missing:
            raise pieper.InputError(
                f"say --{missing[0]} too, one number for all joints or one a joint, quoted: limits of a motion are at "
                "least --speed and --acceleration.",
                missing=missing,
            )
        return command(arm=arm, units=units, limits=pieper.Limits(**given) if given else None, **rest)

    made: Command = with_limits
    for name, words in reversed((_LIMITS | _TOOL_LIMITS).items()):
        many = " One number for all joints, or one a joint, quoted." if name in _LIMITS else ""
        made = click.option(
            f"--{name.replace('_', '-')}",
            name,
            default="",
            metavar="NUMBERS",
            help=f"{words}, in the units typed.{many}",
        )(made)
    return made


def _limit(arm: pieper.Arm, units: Units, name: str, text: str) -> Any:
    option = f"--{name.replace('_', '-')}"
    values = numbers([text], option)
    if name in _LIMITS and len(values) not in (1, arm.n):
        raise pieper.InputError(f"{option} takes one number or {arm.n}, one a joint, got {len(values)}.", given=values)
    if name not in _LIMITS and len(values) != 1:
        raise pieper.InputError(f"{option} takes one number, got {len(values)}.", given=values)
    for j, value in enumerate(values):
        if value <= 0:
            which = f" of {arm.joint_names[j]}" if len(values) > 1 else ""
            must = name in ("speed", "acceleration")
            cure = "no joint is held still by its limits" if must else "leave it out for none"
            raise pieper.InputError(f"{option}{which} must be more than zero, got {value:g}; {cure}.", given=values)
    if name in _LIMITS:
        return np.broadcast_to(np.array(values), (arm.n,)) * units.of_joints(arm)
    return values[0] * (units.radians if name == "turn_speed" else units.metres)


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
