"""`pieper report`: everything about an arm on one page."""

from __future__ import annotations

from pathlib import Path

import click

import pieper
from pieper.cli.arguments import target
from pieper.cli.options import TakesNumbers, order, start, takes_arm, takes_units
from pieper.cli.status import DONE
from pieper.cli.straight import Straight, takes_straight
from pieper.cli.units import Units


@click.command("report", cls=TakesNumbers, short_help="Write everything about an arm on one page.")
@takes_arm
@click.option("--out", "-o", default="", metavar="FILE", help="The HTML page; named after the arm when left out.")
@click.option("--latex", default="", metavar="FILE", help="Also write LaTeX source into this .tex, figures beside it.")
@click.option("--pose", default="", metavar="POSE", help="The pose to solve, quoted, as for ik; chosen when left out.")
@click.option(
    "--verify-with", "toolbox", default="", metavar="TOOLBOX", help="Also compare with a toolbox, as `verify` does."
)
@click.option(
    "--letters",
    type=click.Choice(["noap", "r"]),
    default="noap",
    help="The entries of a pose in the equations: n, o, a, p (Paul) or r11 to r33 (Craig).",
)
@takes_straight
@start
@order
@takes_units
def command(
    arm: pieper.Arm,
    out: str,
    latex: str,
    pose: str,
    toolbox: str,
    letters: str,
    straight: Straight,
    start: str,
    order: str,
    units: Units,
) -> int:
    """Write everything that can be said about an arm on one page, as HTML that prints well, and as LaTeX."""
    track = None
    if straight.typed:
        from pieper.cli.path import followed

        track, _ = followed(arm, straight, start, units, order, "a path study needs both --from and --to.")
    T = target([pose], units, order, "--pose").T if pose else None
    found = arm.verify(toolbox) if toolbox else None
    place = Path(out or f"{arm.name}.html")
    into = Path(latex) if latex else None
    for file in pieper.write_report(arm, place, latex=into, pose=T, track=track, comparison=found, letters=letters):
        print(file)
    return DONE
