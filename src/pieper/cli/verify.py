"""`pieper verify`: an arm compared with an independent toolbox."""

from __future__ import annotations

import click

import pieper
from pieper.cli.layout import Column
from pieper.cli.options import as_json, takes_arm
from pieper.cli.output import as_json as print_json
from pieper.cli.output import print_table, say
from pieper.cli.status import DONE, NO_SOLUTION

TOOLBOXES = ("roboticstoolbox", "pinocchio", "mujoco")


@click.command("verify", short_help="Compare an arm with an independent toolbox.")
@takes_arm
@click.option(
    "--with", "toolbox", required=True, type=click.Choice(TOOLBOXES), help="The toolbox, an extra of its name."
)
@click.option("--poses", "-n", default=100, show_default=True, type=click.IntRange(1), help="Random postures.")
@click.option("--seed", default=0, show_default=True, help="Of the random numbers.")
@as_json
def command(arm: pieper.Arm, toolbox: str, poses: int, seed: int, json: bool) -> int:
    """Compare forward kinematics, Jacobian and inverse solutions with what a toolbox makes of the arm.

    A URDF is read again by Pinocchio's own reader, an MJCF by MuJoCo; any other arm is handed over as its table.
    Exit status 1 where more than rounding is between them.

    Example: pieper verify denso-vp6242 --with roboticstoolbox
    """
    found = arm.verify(toolbox, poses=poses, seed=seed)
    if json:
        lines = [
            {"what": x.what, "worst": x.worst, "unit": x.unit, "count": x.count, "q": x.q, "agrees": x.agrees}
            for x in found.lines
        ]
        print_json(
            {
                "arm": found.arm,
                "toolbox": found.toolbox,
                "agrees": found.agrees,
                "lines": lines,
                "missing": found.missing,
                "conventions": found.conventions,
                "remarks": found.remarks,
            }
        )
    else:
        columns = [Column("compared", True), Column("number"), Column("worst difference")]
        print_table(f"{found.arm} and {found.toolbox}", columns, [list(row) for row in found.cells()])
        for sentence in found.explain().splitlines():
            say(sentence)
    return DONE if found.agrees else NO_SOLUTION
