"""`pieper report`: everything about an arm on one page."""

from __future__ import annotations

from pathlib import Path

import click

import pieper
from pieper.cli.arguments import joints, target
from pieper.cli.options import NUMBERS, first, last, order, points, start, takes_arm, takes_units
from pieper.cli.status import DONE
from pieper.cli.units import Units


@click.command("report", context_settings=NUMBERS, short_help="Write everything about an arm on one page.")
@takes_arm
@click.option("--out", "-o", default="", metavar="FILE", help="The HTML page; named after the arm when left out.")
@click.option("--latex", default="", metavar="FILE", help="Also write LaTeX source into this .tex, figures beside it.")
@click.option("--pose", default="", metavar="POSE", help="The pose to solve, quoted, as for ik; chosen when left out.")
@click.option(
    "--verify-with", "toolbox", default="", metavar="TOOLBOX", help="Also compare with a toolbox, as `verify` does."
)
@first
@last
@points
@start
@order
@takes_units
def command(
    arm: pieper.Arm,
    out: str,
    latex: str,
    pose: str,
    toolbox: str,
    first: str,
    last: str,
    points: int,
    start: str,
    order: str,
    units: Units,
) -> int:
    """Write everything that can be said about an arm on one page, as HTML that prints well, and as LaTeX."""
    if bool(first) != bool(last):
        raise pieper.InputError("a path study needs both --from and --to.")
    track = None
    if first:
        from pieper.cli.path import held, lines

        q = joints(arm, [start], units, "--start")
        ends = [target([text], units, order, what) for what, text in (("--from", first), ("--to", last))]
        track = arm.follow(lines(held(arm, ends, q)[0], points), start=q)
    T = target([pose], units, order, "--pose").T if pose else None
    found = arm.verify(toolbox) if toolbox else None
    place = Path(out or f"{arm.name}.html")
    into = Path(latex) if latex else None
    for file in pieper.write_report(arm, place, latex=into, pose=T, track=track, comparison=found):
        print(file)
    return DONE
