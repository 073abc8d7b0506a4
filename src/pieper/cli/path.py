"""`pieper path`: straight lines followed by one branch, as a table, a CSV file and figures."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click
import numpy as np
import numpy.typing as npt

import pieper
from pieper.cli.arguments import Target, joints
from pieper.cli.layout import Column
from pieper.cli.options import (
    TakesNumbers,
    as_csv,
    as_json,
    order,
    start,
    takes_arm,
    takes_units,
)
from pieper.cli.output import as_json as print_json
from pieper.cli.output import joint_cells, joint_columns, number, print_table, say, si_units, small
from pieper.cli.status import DONE, NO_SOLUTION
from pieper.cli.straight import Straight, takes_straight
from pieper.cli.units import Units

#: Decimals in a CSV: finer than rounding noise.
DECIMALS = 12
#: Points of the track that are printed.
FEW = 12
NO_ENDS = 'a path needs --from and --to, for example --from "350 0 400" --to "200 100 500".'


@click.command("path", cls=TakesNumbers, short_help="Follow straight lines with one branch.")
@takes_arm
@takes_straight
@start
@as_csv
@click.option("--figures", default="", metavar="FOLDER", help="Write the figures into this folder.")
@order
@as_json
@takes_units
def command(
    arm: pieper.Arm,
    straight: Straight,
    start: str,
    csv: str,
    figures: str,
    order: str,
    json: bool,
    units: Units,
) -> int:
    """Follow straight lines with one continuous branch; say where it stops, why, and which branches would have passed.

    Example: pieper path denso-vp6242 --from "350 0 400" --to "200 100 500" --start line-start
    """
    track, note = followed(arm, straight, start, units, order)
    if csv:
        write_csv(arm, track, csv, units)
    written = write_figures(arm, track, figures) if figures else []
    status = DONE if track.complete else NO_SOLUTION
    if json:
        print_json(_as_data(arm, track, written, note))
        return status
    if note:
        say(note + "\n")
    _print_points(arm, track, units)
    _print_branches(track)
    say(track.explain())
    if csv:
        say(f"joints and poses: {csv}")
    for file in written:
        say(f"figure: {file}")
    return status


def followed(
    arm: pieper.Arm, straight: Straight, start: str, units: Units, order: str, missing: str = NO_ENDS
) -> tuple[pieper.Track, str]:
    """Follow straight lines; return the track, and what was taken differently from how it was typed."""
    given = straight.targets(units, order, missing)
    q = joints(arm, [start], units, "--start")
    poses, note = held(arm, given, q)
    return arm.follow(straight.through(poses), start=q), note


def held(
    arm: pieper.Arm, targets: list[Target], q: npt.NDArray[np.float64]
) -> tuple[list[npt.NDArray[np.float64]], str]:
    """Return the poses of a path, and what was taken differently from how it was typed.

    Where every pose is x y z alone and the arm cannot hold R = I at the first, the tool is held as it is in q.
    """
    poses = [t.T for t in targets]
    if not all(t.bare for t in targets) or arm.plan.task != "pose" or arm.plan.rank >= 6:
        return poses, ""
    if arm.ik(poses[0]).status != pieper.Status.OUT_OF_REACH:
        return poses, ""
    R = arm.fk(q)[:3, :3]
    turned = [np.vstack([np.column_stack([R, T[:3, 3]]), T[3]]) for T in poses]
    note = (
        f"note: x y z were taken as positions: {arm.name} cannot hold R = I there, so that the tool is held as it is "
        "at --start. Give orientations to ask for others."
    )
    return turned, note


def _print_points(arm: pieper.Arm, track: pieper.Track, units: Units) -> None:
    if not track.points:
        return
    columns = [Column("point"), Column("s"), *(Column(f"{axis}, {units.length}") for axis in "xyz")]
    columns += [*joint_columns(arm, units), Column(f"residual, {units.length}")]
    rows = []
    for k in _few(track.points):
        position = [number(v / units.metres, 2 if units.length == "mm" else 5) for v in track.path[k, :3, 3]]
        residual = small(track.residual[k, 0] / units.metres, "").strip()
        rows.append(
            [str(k + 1), number(track.s[k], 4), *position, *joint_cells(arm, track.followed[k], units), residual]
        )
    shown = f"; {len(rows)} of them shown" if len(rows) < track.points else ""
    title = f"{arm.name}: {track.points} of {len(track.path)} points reached{shown}"
    print_table(title, columns, rows)


def _few(n: int) -> list[int]:
    return sorted(set(np.linspace(0, n - 1, min(n, FEW)).round().astype(int).tolist())) if n else []


def _print_branches(track: pieper.Track) -> None:
    if not track.branches:
        return
    columns = [Column("#"), Column("posture", True), Column("points"), Column("ends at s"), Column("why", True)]
    rows = []
    for b in track.branches:
        chosen = " (followed)" if b.index == track.chosen else ""
        why = f"{b.stop.cause}: {b.stop.detail}" if b.stop else "reaches the end"
        rows.append([str(b.index + 1), b.label + chosen, str(b.points), number(b.s, 4), why])
    print_table("branches that start at the first pose", columns, rows)


def write_csv(arm: pieper.Arm, track: pieper.Track, file: str, units: Units) -> None:
    """Write a track as CSV, whole or not at all: point, s, joints, position, and rotation row by row."""
    joint_names = [f"{name}_{unit}" for name, unit in zip(arm.joint_names, units.names_of_joints(arm), strict=True)]
    head = ["point", "s", *joint_names, *(f"{axis}_{units.length}" for axis in "xyz")]
    head += [f"r{i}{j}" for i in (1, 2, 3) for j in (1, 2, 3)]
    with pieper.whole_file(file) as out:
        out.write((",".join(head) + "\n").encode())
        for k, q in enumerate(track.followed):
            T = track.path[k]
            values = [track.s[k], *(q / units.of_joints(arm)), *(T[:3, 3] / units.metres), *T[:3, :3].ravel()]
            out.write(
                (",".join([str(k + 1), *(repr(round(float(v), DECIMALS) + 0.0) for v in values)]) + "\n").encode()
            )


def write_figures(arm: pieper.Arm, track: pieper.Track, folder: str) -> list[Path]:
    """Write the figures of a track into a folder, made when missing; return the files."""
    place, plot = Path(folder), pieper.plot
    try:
        place.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise pieper.InputError(f"cannot make the folder {place}: {error.strerror}.", path=place) from None
    made = {"path": plot.path_figure(track, arm=arm), "coordinates": plot.coordinates_figure(track)}
    if track.points:
        made["joints"] = plot.joints_figure(track)
        made["configurations"] = plot.configuration_figure(arm, track)
    return [
        plot.save_figure(figure, place / f"{name}.{suffix}")
        for name, figure in made.items()
        for suffix in ("png", "svg")
    ]


def _as_data(arm: pieper.Arm, track: pieper.Track, written: list[Path], note: str) -> dict[str, Any]:
    return {
        "arm": arm.name,
        "note": note or None,
        "joint_names": arm.joint_names,
        "units": si_units(arm),
        "complete": track.complete,
        "points": len(track.path),
        "s": track.s,
        "q": track.followed,
        "path": track.path,
        "residual_m": track.residual[:, 0],
        "residual_rad": track.residual[:, 1],
        "events": [
            {"s": e.s, "joint": e.joint, "cause": e.cause, "stop": e.stop, "detail": e.detail} for e in track.events
        ],
        "chosen": track.chosen,
        "branches": [
            {
                "label": b.label,
                "points": b.points,
                "s": b.s,
                "complete": b.complete,
                "cause": b.stop.cause if b.stop else None,
                "joint": b.stop.joint if b.stop else None,
                "meets": b.meets,
            }
            for b in track.branches
        ],
        "figures": [str(file) for file in written],
    }
