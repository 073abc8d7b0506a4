"""The list of commands; each does its work in a module of its own, imported when it is called."""

from __future__ import annotations

from collections.abc import Callable

import click

#: Negative numbers are numbers, not options.
NUMBERS = {"ignore_unknown_options": True}

arm_name = click.argument("arm", metavar="ARM")
as_json = click.option("--json", is_flag=True, help="Print JSON, in metres and radians, for machines.")
figure = click.option("--figure", default="", metavar="FILE", help="Draw into this .png, .svg or .pdf.")
order = click.option(
    "--order",
    default="rpy",
    show_default=True,
    metavar="NOTATION",
    help="What the numbers after x y z mean: rpy (roll, pitch, yaw about the fixed x, y, z), zyx (KUKA's A, B, C), "
    "zyz, rotation_vector, quaternion_wxyz or quaternion_xyzw.",
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


def units(command: Callable) -> Callable:
    """Add the options for units."""
    for name, choices in (("--angle", ("deg", "rad")), ("--length", ("mm", "m"))):
        command = click.option(
            name, default=choices[0], show_default=True, type=click.Choice(choices), help="Unit, typed and printed."
        )(command)
    return command


def _version(context: click.Context, _option: click.Parameter, wanted: bool) -> None:
    if wanted and not context.resilient_parsing:
        import pieper

        click.echo(f"pieper {pieper.__version__}")
        context.exit()


@click.group(context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 110})
@click.option(
    "--version", is_flag=True, is_eager=True, expose_value=False, callback=_version, help="Print the version."
)
def app() -> None:
    """Kinematics of serial arms: every inverse solution of a pose, verified, labelled and followed along paths.

    Degrees and millimetres unless said otherwise. ARM is a catalogue name (see `pieper robots`) or a robot file.

    Exit status: 0 done, 1 no solution, 2 misuse.
    """


@app.command(short_help="List the arms that ship.")
@click.argument("pattern", default="")
@as_json
def robots(pattern: str, json: bool) -> int:
    """List the arms that ship, or those whose name contains PATTERN."""
    from pieper.cli.arms import robots as run

    return run(pattern, json)


@app.command(short_help="Show an arm and how it is solved.")
@arm_name
@figure
@as_json
@units
def show(arm: str, figure: str, json: bool, length: str, angle: str) -> int:
    """Show an arm: its DH table, limits, postures, and how it is solved."""
    from pieper.cli.arms import show as run

    return run(arm, json, figure, length, angle)


@app.command(context_settings=NUMBERS, short_help="From joints to the pose of the tool.")
@arm_name
@click.argument("joints", nargs=-1, required=True)
@click.option("--frames", is_flag=True, help="Every frame on the way, not only the tool.")
@as_json
@units
def fk(arm: str, joints: tuple[str, ...], frames: bool, json: bool, length: str, angle: str) -> int:
    """Forward kinematics: from joints to the tool's pose.

    JOINTS is one number a joint, a posture's name, or @file.

    Example: pieper fk denso-vp6242 0 51.5 -150.6 0 99.1 0
    """
    from pieper.cli.solve import fk as run

    return run(arm, list(joints), frames, json, length, angle)


@app.command(context_settings=NUMBERS, short_help="From a pose to every solution.")
@arm_name
@click.argument("pose", nargs=-1, required=True)
@order
@click.option(
    "--near", default="", metavar="JOINTS", help="Name the solution nearest to these (quoted), turns resolved."
)
@click.option(
    "--task", default="", metavar="TASK", help='"pose", "position" or "position+axis"; the arm has a default.'
)
@click.option(
    "--redundancy", default="", metavar="VALUE", help="Value of a redundant joint, or by name: 'arm angle=20'."
)
@click.option("--all", "everything", is_flag=True, help="Also solutions outside the joint limits.")
@figure
@as_json
@units
def ik(
    arm: str,
    pose: tuple[str, ...],
    order: str,
    near: str,
    task: str,
    redundancy: str,
    everything: bool,
    figure: str,
    json: bool,
    length: str,
    angle: str,
) -> int:
    """Inverse kinematics: every solution of a pose, with labels, limits and residuals.

    POSE is x y z (orientation R = I), or x y z and an orientation (see --order), or the 12 or 16 numbers of a matrix
    row by row, or @file.

    Example: pieper ik denso-vp6242 350 0 400 --all
    """
    from pieper.cli.solve import ik as run

    return run(arm, list(pose), order, near, task, redundancy, everything, figure, json, length, angle)


@app.command(context_settings=NUMBERS, short_help="Follow straight lines with one branch.")
@arm_name
@first
@last
@click.option("--via", multiple=True, metavar="POSE", help="A pose on the way; may be repeated.")
@points
@start
@click.option("--csv", default="", metavar="FILE", help="Write the joints and the poses into this .csv.")
@click.option("--figures", default="", metavar="FOLDER", help="Write the figures into this folder.")
@order
@as_json
@units
def path(
    arm: str,
    first: str,
    last: str,
    via: tuple[str, ...],
    points: int,
    start: str,
    csv: str,
    figures: str,
    order: str,
    json: bool,
    length: str,
    angle: str,
) -> int:
    """Follow straight lines with one continuous branch; say where it stops, why, and which branches would have passed.

    Example: pieper path denso-vp6242 --from "350 0 400" --to "200 100 500" --start line-start
    """
    from pieper.cli.follow import path as run

    return run(arm, first, last, list(via), points, start, csv, figures, order, json, length, angle)


@app.command(context_settings=NUMBERS, short_help="Write everything about an arm on one page.")
@arm_name
@click.option("--out", "-o", default="", metavar="FILE", help="The HTML page; named after the arm when left out.")
@click.option("--latex", default="", metavar="FILE", help="Also write LaTeX source into this .tex, figures beside it.")
@click.option("--pose", default="", metavar="POSE", help="The pose to solve, quoted, as for ik; chosen when left out.")
@first
@last
@points
@start
@order
@units
def report(
    arm: str,
    out: str,
    latex: str,
    pose: str,
    first: str,
    last: str,
    points: int,
    start: str,
    order: str,
    length: str,
    angle: str,
) -> int:
    """Write everything that can be said about an arm on one page, as HTML that prints well, and as LaTeX."""
    from pieper.cli.pages import report as run

    return run(arm, out, latex, pose, first, last, points, start, order, length, angle)


@app.command(short_help="Judge the claims someone makes about an arm.")
@click.argument("claims")
@click.option("--brief", is_flag=True, help="One line a claim, without counter-examples.")
@as_json
def check(claims: str, brief: bool, json: bool) -> int:
    """Judge the equations and numbers that someone claims about an arm; status 1 when one does not hold.

    CLAIMS is a claims file (.toml).
    """
    from pieper.cli.judged import check as run

    return run(claims, json, brief)


@app.command(short_help="Open the workbench in the browser.")
@click.argument("arm", default="denso-vp6242")
@click.option("--host", default="127.0.0.1", show_default=True, help="Address to listen on.")
@click.option("--port", default=8123, show_default=True, help="Port to listen on; 0 for a free one.")
@click.option("--browser/--no-browser", default=True, help="Whether to open a browser.")
@click.option(
    "--open-to-network", is_flag=True, help="Allow an address that other machines reach; there is no password."
)
def workbench(arm: str, host: str, port: int, browser: bool, open_to_network: bool) -> int:
    """Open the workbench: the arm, its joints, poses and equations, live in the browser."""
    from pieper.cli.pages import workbench as run

    return run(arm, host, port, browser, open_to_network)


@app.command(short_help="Run a whole study and write it up.")
@click.option("--out", "-o", default="pieper-tour", show_default=True, help="Folder for the page and the figures.")
def tour(out: str) -> int:
    """Run a whole study on the Denso VP-6242 and write it up on one page."""
    from pieper.cli.pages import tour as run

    return run(out)
