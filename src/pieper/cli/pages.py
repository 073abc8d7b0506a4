"""`pieper report | check | workbench | tour`: commands that end in a page."""

from __future__ import annotations

from pathlib import Path

from pieper.cli import DONE, NO_SOLUTION
from pieper.cli.given import Units, joints, pose
from pieper.cli.given import arm as load
from pieper.errors import InputError


def report(
    name: str,
    out: str,
    latex: str,
    pose_text: str,
    first: str,
    last: str,
    points: int,
    start: str,
    order: str,
    length: str,
    angle: str,
) -> int:
    """Write the report of an arm."""
    from pieper.motion.path import line
    from pieper.presentation.report import write_report

    units = Units(length, angle)
    arm = load(name)
    if bool(first) != bool(last):
        raise InputError("a path study needs both --from and --to.")
    track = None
    if first:
        way = line(pose([first], units, order, "--from"), pose([last], units, order, "--to"), points)
        track = arm.follow(way, start=joints(arm, [start], units, "--start"))
    T = pose([pose_text], units, order, "--pose") if pose_text else None
    written = write_report(
        arm, Path(out or f"{arm.name}.html"), latex=Path(latex) if latex else None, pose=T, track=track
    )
    for file in written:
        print(file)
    return DONE


def workbench(name: str, host: str, port: int, browser: bool, open_to_network: bool) -> int:
    """Serve the workbench until it is interrupted."""
    load(name)
    from pieper.workbench.server import serve

    serve(host=host, port=port, arm=name, open_to_network=open_to_network, open_browser=browser)
    return DONE


def tour(out: str) -> int:
    """Run the tour and print where its page is."""
    from pieper.cli.tour import run

    page, complete = run(Path(out), say=print)
    print(f"\nThe page: {page.resolve()}")
    return DONE if complete else NO_SOLUTION
