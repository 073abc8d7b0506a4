"""`pieper clear`: whether a path keeps an arm clear of itself and of what stands around it, proved."""

from __future__ import annotations

import csv
from pathlib import Path

import click
import numpy as np
import numpy.typing as npt

import pieper
from pieper.cli.arguments import joints
from pieper.cli.options import TakesNumbers, as_json, takes_arm, takes_units
from pieper.cli.output import as_json as print_json
from pieper.cli.output import number, say
from pieper.cli.status import DONE, NO_SOLUTION
from pieper.cli.units import Units
from pieper.tolerances import LIMIT_SLACK


@click.command("clear", cls=TakesNumbers, short_help="Prove that a path touches nothing.")
@takes_arm
@click.option("--scene", default="", metavar="FILE", help="What stands around the arm; without it the arm alone.")
@click.option("--from", "first", default="", metavar="JOINTS", help="Joints at the beginning (quoted), or a posture.")
@click.option("--via", multiple=True, metavar="JOINTS", help="Joints on the way; may be repeated.")
@click.option(
    "--to", "last", default="", metavar="JOINTS", help="Joints at the end; without it one posture is looked at."
)
@click.option("--path", "file", default="", metavar="FILE", help="A .csv with a column a joint, by name or in order.")
@click.option("--margin", default=0.0, show_default=True, help="Distance to keep, in --length.")
@click.option("--bodies", is_flag=True, help="Say what the arm's bodies are and which may touch.")
@as_json
@takes_units
def command(
    arm: pieper.Arm,
    scene: str,
    first: str,
    via: tuple[str, ...],
    last: str,
    file: str,
    margin: float,
    bodies: bool,
    json: bool,
    units: Units,
) -> int:
    """Prove that a path keeps an arm clear, everywhere between its points too; status 1 where it is not proved.

    Every joint moves evenly from point to point. A scene file has a table [[bodies]] an obstacle: docs/collision.md.

    Example: pieper clear denso-vp6242 --from home --to "60 90 -180 0 0 0" --margin 5
    """
    if not (np.isfinite(margin) and margin >= 0):
        raise pieper.InputError(
            f"--margin must be a length of at least 0 {units.length}, got {margin:g}.", given=margin
        )
    around = pieper.Scene.load(scene) if scene else pieper.Scene()
    if bodies and not (first or last or file):
        say(arm.bodies.explain())
        return DONE
    path = _path(arm, first, via, last, file, units)
    found = arm.clear(path, around, margin * units.metres)
    apart = arm.distance(path, around)
    at = int(np.argmin(apart))
    status = DONE if found.verdict is pieper.Clearance.CLEAR else NO_SOLUTION
    if json:
        print_json(
            {
                "arm": arm.name,
                "verdict": found.verdict.name,
                "s": found.s,
                "q": found.q,
                "pair": list(found.pair),
                "depth_m": found.depth,
                "margin_m": found.margin,
                "gap_m": found.gap,
                "nearest_point": at,
                "nearest_m": float(apart[at]),
                "nearest_pair": [str(name) for name in apart.pair[at]],
                "guessed": arm.bodies.guessed,
            }
        )
        return status
    if bodies:
        say(arm.bodies.explain() + "\n")
    say(found.explain())
    if len(arm.bodies) and any(apart.pair[at]):
        one, other = apart.pair[at]
        metres = number(float(apart[at]) / units.metres, 3 if units.length == "mm" else 6)
        which = f"Of its {len(path)} points, number {at + 1} is" if len(path) > 1 else "The posture is"
        say(f"{which} {metres} {units.length} from touching, the nearest: {one} and {other}.")
    if arm.bodies.guessed:
        say("The arm's bodies are guessed from its table: --bodies lists them.")
    for sentence in _outside(arm, path, units):
        say(sentence)
    return status


def _outside(arm: pieper.Arm, path: npt.NDArray[np.float64], units: Units) -> list[str]:
    """Return where a path (N, n) leaves the limits of joints, which clearances do not ask about, a sentence a joint."""
    out: list[str] = []
    scale, names = units.of_joints(arm), units.names_of_joints(arm)
    for j, (low, high) in enumerate(arm.limits):
        beyond = np.maximum(path[:, j] - high, low - path[:, j])
        k = int(np.argmax(beyond))
        if beyond[k] > LIMIT_SLACK:
            out.append(
                f"{arm.joint_names[j]} is at {path[k, j] / scale[j]:.6g} {names[j]} at point {k + 1}, outside its "
                f"limits of {low / scale[j]:.6g} to {high / scale[j]:.6g} {names[j]}: the arm cannot go there."
            )
    return out


def _path(
    arm: pieper.Arm, first: str, via: tuple[str, ...], last: str, file: str, units: Units
) -> npt.NDArray[np.float64]:
    if bool(first) == bool(file):
        raise pieper.InputError('give the path as --from and --to, as --from home --to "60 90 0 0 0 0", or --path.')
    if file:
        return _of_file(arm, file, units)
    words = [("--from", first), *(("--via", v) for v in via), *([("--to", last)] if last else [])]
    return np.array([joints(arm, [text], units, what) for what, text in words])


def _of_file(arm: pieper.Arm, file: str, units: Units) -> npt.NDArray[np.float64]:
    """Return the joint vectors (N, n) of a CSV: columns named as `pieper path --csv` writes them, or one a joint."""
    try:
        rows = [row for row in csv.reader(Path(file).read_text(encoding="utf-8-sig").splitlines()) if row]
    except (OSError, UnicodeDecodeError) as error:
        raise pieper.InputError(
            f"--path: cannot read {file}: {error.strerror if isinstance(error, OSError) else error}.", path=file
        ) from None
    if not rows:
        raise pieper.InputError(f"--path: {file} holds no point.", path=file)
    named = [f"{name}_{unit}" for name, unit in zip(arm.joint_names, units.names_of_joints(arm), strict=True)]
    columns = list(range(arm.n))
    if not _numeric(rows[0]):
        missing = [name for name in named if name not in rows[0]]
        if missing:
            raise pieper.InputError(
                f"--path: {file} has no column {missing[0]}; it has {', '.join(rows[0])}.", path=file, missing=missing
            )
        columns, rows = [rows[0].index(name) for name in named], rows[1:]
    out = []
    for at, row in enumerate(rows, 1):
        if len(row) <= max(columns) or not _numeric([row[c] for c in columns]):
            raise pieper.InputError(f"--path: {file}, point {at} is no {arm.n} numbers: {', '.join(row)}.", path=file)
        out.append([float(row[c]) for c in columns])
    return np.array(out).reshape(-1, arm.n) * units.of_joints(arm)


def _numeric(cells: list[str]) -> bool:
    try:
        return bool(np.isfinite([float(cell) for cell in cells]).all())
    except ValueError:
        return False
