"""The list of commands; each does its work in a module of its own, imported when it is called."""

from __future__ import annotations

from typing import Annotated

import typer

from pieper.cli.options import NUMBERS, Angle, ArmName, Json, Length, Order

app = typer.Typer(
    name="pieper",
    no_args_is_help=True,
    add_completion=False,
    rich_markup_mode="rich",
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
    help="Kinematics of serial arms: every inverse solution of a pose, verified, labelled and followed along paths. "
    "Degrees and millimetres unless said otherwise. Exit status: 0 done, 1 no solution, 2 misuse.",
)


def _version(wanted: bool) -> None:
    if wanted:
        import pieper

        print(f"pieper {pieper.__version__}")
        raise typer.Exit()


@app.callback()
def options(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Print the version.")
    ] = False,
) -> None:
    """Nothing is done without a command."""


@app.command()
def robots(
    pattern: Annotated[str, typer.Argument(help="Only names that contain this.")] = "",
    json: Json = False,
) -> None:
    """List the arms that ship."""
    from pieper.cli.arms import robots as run

    raise typer.Exit(run(pattern, json))


@app.command()
def show(
    arm: ArmName,
    json: Json = False,
    figure: Annotated[str, typer.Option("--figure", help="Draw the arm into this .png, .svg or .pdf.")] = "",
    length: Length = "mm",
    angle: Angle = "deg",
) -> None:
    """Show an arm: its DH table, limits, postures, and how it is solved."""
    from pieper.cli.arms import show as run

    raise typer.Exit(run(arm, json, figure, length, angle))


@app.command(context_settings=NUMBERS)
def fk(
    arm: ArmName,
    joints: Annotated[
        list[str], typer.Argument(metavar="JOINTS...", help="One number a joint, a posture's name, or @file.")
    ],
    frames: Annotated[bool, typer.Option("--frames", help="Every frame on the way, not only the tool.")] = False,
    json: Json = False,
    length: Length = "mm",
    angle: Angle = "deg",
) -> None:
    """Forward kinematics: from joints to the tool's pose.

    Example: pieper fk denso-vp6242 0 51.5 -150.6 0 99.1 0
    """
    from pieper.cli.solve import fk as run

    raise typer.Exit(run(arm, joints, frames, json, length, angle))


@app.command(context_settings=NUMBERS)
def ik(
    arm: ArmName,
    pose: Annotated[
        list[str],
        typer.Argument(
            metavar="POSE...", help="x y z, or x y z and an orientation (see --order), or 16 numbers, or @file."
        ),
    ],
    order: Order = "rpy",
    near: Annotated[
        str, typer.Option("--near", help="Mark the solution nearest to these joints (quoted), turns resolved.")
    ] = "",
    task: Annotated[
        str, typer.Option("--task", help='"pose", "position" or "position+axis"; the arm has a default.')
    ] = "",
    redundancy: Annotated[
        str, typer.Option("--redundancy", help="Value of a redundant joint, in the arm's units.")
    ] = "",
    all_: Annotated[bool, typer.Option("--all", help="Also solutions outside the joint limits.")] = False,
    figure: Annotated[str, typer.Option("--figure", help="Draw all solutions into this .png, .svg or .pdf.")] = "",
    json: Json = False,
    length: Length = "mm",
    angle: Angle = "deg",
) -> None:
    """Inverse kinematics: every solution of a pose, with labels, limits and residuals.

    Example: pieper ik denso-vp6242 350 0 400
    """
    from pieper.cli.solve import ik as run

    raise typer.Exit(run(arm, pose, order, near, task, redundancy, all_, figure, json, length, angle))


@app.command(context_settings=NUMBERS)
def path(
    arm: ArmName,
    first: Annotated[str, typer.Option("--from", help="First pose, quoted, as for ik; or @file.")] = "",
    last: Annotated[str, typer.Option("--to", help="Last pose, quoted, as for ik; or @file.")] = "",
    via: Annotated[list[str] | None, typer.Option("--via", help="A pose on the way; may be repeated.")] = None,
    points: Annotated[
        int, typer.Option("--points", "-n", help="Poses on each straight stretch, both ends included.")
    ] = 50,
    start: Annotated[str, typer.Option("--start", help="Joints the arm is in (quoted), or a posture's name.")] = "zero",
    csv: Annotated[str, typer.Option("--csv", help="Write the joints and the poses into this .csv.")] = "",
    figures: Annotated[str, typer.Option("--figures", help="Write the figures into this folder.")] = "",
    order: Order = "rpy",
    json: Json = False,
    length: Length = "mm",
    angle: Angle = "deg",
) -> None:
    """Follow straight lines with one continuous branch; say where it stops, why, and which branches would have passed.

    Example: pieper path denso-vp6242 --from "350 0 400" --to "200 100 500" --start line-start
    """
    from pieper.cli.follow import path as run

    raise typer.Exit(run(arm, first, last, via or [], points, start, csv, figures, order, json, length, angle))


@app.command(context_settings=NUMBERS)
def report(
    arm: ArmName,
    out: Annotated[str, typer.Option("--out", "-o", help="The HTML page; named after the arm when left out.")] = "",
    latex: Annotated[
        str, typer.Option("--latex", help="Also write LaTeX source into this .tex, figures beside it.")
    ] = "",
    pose: Annotated[
        str, typer.Option("--pose", help="The pose to solve, quoted, as for ik; chosen when left out.")
    ] = "",
    first: Annotated[str, typer.Option("--from", help="First pose of a path study.")] = "",
    last: Annotated[str, typer.Option("--to", help="Last pose of a path study.")] = "",
    points: Annotated[int, typer.Option("--points", "-n", help="Poses on the path.")] = 50,
    start: Annotated[str, typer.Option("--start", help="Joints the arm is in (quoted), or a posture's name.")] = "zero",
    order: Order = "rpy",
    length: Length = "mm",
    angle: Angle = "deg",
) -> None:
    """Write everything that can be said about an arm on one page, as HTML that prints well, and as LaTeX."""
    from pieper.cli.pages import report as run

    raise typer.Exit(run(arm, out, latex, pose, first, last, points, start, order, length, angle))


@app.command()
def check(
    claims: Annotated[str, typer.Argument(metavar="CLAIMS", help="A claims file (.toml).")],
    brief: Annotated[bool, typer.Option("--brief", help="One line a claim, without counter-examples.")] = False,
    json: Json = False,
) -> None:
    """Judge the equations and numbers that someone claims about an arm; status 1 when one does not hold."""
    from pieper.cli.judged import check as run

    raise typer.Exit(run(claims, json, brief))


@app.command()
def workbench(
    arm: Annotated[str, typer.Argument(metavar="[ARM]", help="The arm to begin with.")] = "denso-vp6242",
    host: Annotated[str, typer.Option("--host", help="Address to listen on.")] = "127.0.0.1",
    port: Annotated[int, typer.Option("--port", help="Port to listen on; 0 for a free one.")] = 8123,
    browser: Annotated[bool, typer.Option("--browser/--no-browser", help="Whether to open a browser.")] = True,
    open_to_network: Annotated[
        bool, typer.Option("--open-to-network", help="Allow an address that other machines reach; there is no password.")
    ] = False,
) -> None:
    """Open the workbench: the arm, its joints, poses and equations, live in the browser."""
    from pieper.cli.pages import workbench as run

    raise typer.Exit(run(arm, host, port, browser, open_to_network))


@app.command()
def tour(
    out: Annotated[str, typer.Option("--out", "-o", help="Folder for the page and the figures.")] = "pieper-tour",
) -> None:
    """Run a whole study on the Denso VP-6242 and write it up on one page."""
    from pieper.cli.pages import tour as run

    raise typer.Exit(run(out))
