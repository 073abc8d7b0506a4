"""`pieper path`: straight lines followed by one branch, as a table, a CSV file and figures."""

from __future__ import annotations

import csv as csv_format
import io
from pathlib import Path

import numpy as np

from pieper.cli import DONE, NO_SOLUTION
from pieper.cli.given import Units, joints, pose
from pieper.cli.given import arm as load
from pieper.cli.printed import as_json, console, joint_cells, joint_columns, number, small, table
from pieper.errors import InputError
from pieper.motion.path import line


def lines(poses: list[np.ndarray], points: int) -> np.ndarray:
    """Return straight lines (k, 4, 4) through poses, `points` a stretch, corners once."""
    stretches = [line(a, b, points) for a, b in zip(poses[:-1], poses[1:], strict=True)]
    return np.concatenate([stretches[0], *(s[1:] for s in stretches[1:])])


def path(
    name: str,
    first: str,
    last: str,
    via: list[str],
    points: int,
    start: str,
    csv: str,
    figures: str,
    order: str,
    json: bool,
    length: str,
    angle: str,
) -> int:
    """Follow straight lines."""
    units = Units(length, angle)
    if not first or not last:
        raise InputError('a path needs --from and --to, for example --from "350 0 400" --to "200 100 500".')
    arm = load(name)
    words = [("--from", first), *(("--via", v) for v in via), ("--to", last)]
    poses = [pose([text], units, order, what) for what, text in words]
    track = arm.follow(lines(poses, points), start=joints(arm, [start], units, "--start"))
    if csv:
        write_csv(arm, track, csv)
    written = write_figures(arm, track, figures) if figures else []
    status = DONE if track.complete else NO_SOLUTION
    if json:
        as_json(_as_data(arm, track, written))
        return status
    out = console()
    made = table(
        f"{arm.name}: {len(track.q)} of {len(track.path)} points reached",
        "point", "s", f"x, {length}", f"y, {length}", f"z, {length}", *joint_columns(arm, units), "residual",
    )  # fmt: skip
    for k in _few(len(track.q)):
        position = [number(v / units.metres, 2 if length == "mm" else 5) for v in track.path[k, :3, 3]]
        residual = small(track.residual[k, 0] * 1e3, "mm")
        made.add_row(str(k + 1), number(track.s[k], 4), *position, *joint_cells(arm, track.q[k], units), residual)
    if len(track.q):
        out.print(made)
    out.print(_branch_table(track))
    out.print(track.explain(), markup=False)
    if csv:
        out.print(f"joints and poses: {csv}", markup=False)
    for file in written:
        out.print(f"figure: {file}", markup=False)
    return status


def _few(n: int, most: int = 12) -> list[int]:
    return sorted(set(np.linspace(0, n - 1, min(n, most)).round().astype(int).tolist())) if n else []


def _branch_table(track):
    made = table("branches that start at the first pose", "#", "posture", "points", "ends at s", "why", left=(1, 4))
    for b in track.branches:
        chosen = " (followed)" if b.index == track.chosen else ""
        why = "reaches the end" if b.complete else f"{b.stop.cause}: {b.stop.detail}"
        made.add_row(str(b.index + 1), b.label + chosen, str(b.points), number(b.s, 4), why)
    return made


def write_csv(arm, track, file: str) -> None:
    """Write a track as CSV, whole or not at all: point, s, joints (rad, m), position (m), rotation row by row."""
    from pieper.document.writing import write_whole

    text = io.StringIO()
    writer = csv_format.writer(text, lineterminator="\n")
    units = ["rad" if kind == "R" else "m" for kind in arm.joint_types]
    head = ["point", "s", *(f"{n}_{u}" for n, u in zip(arm.joint_names, units, strict=True)), "x_m", "y_m", "z_m"]
    writer.writerow(head + [f"r{i}{j}" for i in (1, 2, 3) for j in (1, 2, 3)])
    for k, q in enumerate(track.q):
        T = track.path[k]
        values = [repr(float(v)) for v in (track.s[k], *q, *T[:3, 3], *T[:3, :3].ravel())]
        writer.writerow([k + 1, *values])
    write_whole(file, text.getvalue())


def write_figures(arm, track, folder: str) -> list[Path]:
    """Write the figures of a track into a folder, made when missing; return the files."""
    from pieper.presentation import plot

    place = Path(folder)
    try:
        place.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"cannot make the folder {place}: {error.strerror}.", path=place) from None
    made = {"path": plot.path_figure(track, arm=arm), "coordinates": plot.coordinates_figure(track)}
    if len(track.q):
        made["joints"] = plot.joints_figure(track)
        made["configurations"] = plot.configuration_figure(arm, track)
    out = []
    for name, figure in made.items():
        for suffix in ("png", "svg"):
            out.append(plot.save_figure(figure, place / f"{name}.{suffix}"))
    return out


def _as_data(arm, track, written: list[Path]) -> dict:
    return {
        "arm": arm.name,
        "joint_names": arm.joint_names,
        "units": ["rad" if kind == "R" else "m" for kind in arm.joint_types],
        "complete": track.complete,
        "points": len(track.path),
        "s": track.s,
        "q": track.q,
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
