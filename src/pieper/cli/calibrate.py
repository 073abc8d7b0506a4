"""`pieper calibrate`: from a table of joints and measurements to the arm as it is."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import click
import numpy as np
import numpy.typing as npt

import pieper
from pieper import InputError
from pieper.cli import pipes
from pieper.cli.arguments import number, read_text
from pieper.cli.decimal_sign import DecimalSign
from pieper.cli.failure import note
from pieper.cli.number_table import cells_of, delimiter_of, name_and_unit
from pieper.cli.options import as_json, order, takes_arm, takes_units
from pieper.cli.output import as_json as print_json
from pieper.cli.output import plural, say
from pieper.cli.pose_file import POSITION, PoseFile
from pieper.cli.status import DONE
from pieper.cli.units import ANGLES, LENGTHS, Units

#: The column of what is one number a row.
COLUMN = {"distance": "distance", "plane": "height"}

#: Where units are said.
_UNITS = "The name of a column may say its unit (x_mm or x_m, q1_deg or q1_rad); without, --length and --angle do."

Numbers = npt.NDArray[np.float64]


@click.command("calibrate", short_help="Fit an arm to what was measured.")
@takes_arm
@click.argument("data", metavar="DATA.csv")
@click.option("--out", "-o", default="", metavar="FILE", help="Write the calibrated arm into this robot file (.toml).")
@click.option(
    "--kind",
    default="pose",
    show_default=True,
    type=click.Choice(["pose", "position", "distance", "plane"]),
    help="What was measured: x y z and an orientation, x y z, a distance from one unknown fixed point (column "
    "distance), or a height over one unknown plane (column height; none when it was touched).",
)
@click.option(
    "--sigma", default="", metavar="NOISE", help='Noise of one number, such as "0.05 0.01"; estimated without.'
)
@click.option("--hold", multiple=True, metavar="NAME", help="A joint, or tool, that stays as it is; may be repeated.")
@click.option("--terms", default="", metavar="LIST", help="gain, coupling, harmonic, apart by commas.")
@click.option(
    "--loss", default="linear", show_default=True, type=click.Choice(["linear", "huber"]), help="huber: outliers."
)
@click.option("--holdout", default=0.25, show_default=True, help="Part of the rows that only judges.")
@click.option("--report", default="", metavar="FILE", help="Write the arm's report with this calibration (.html).")
@order
@as_json
@takes_units
def command(
    arm: pieper.Arm,
    data: str,
    out: str,
    kind: str,
    sigma: str,
    hold: tuple[str, ...],
    terms: str,
    loss: str,
    holdout: float,
    report: str,
    order: str,
    json: bool,
    units: Units,
) -> int:
    """Calibrate an arm: fit it to measurements, and judge it on those that were held out.

    DATA.csv has one row a pose: the joints by name (joint_1_deg or q1_deg, ...), and what was measured (x_mm, y_mm,
    z_mm, roll_deg, ...). Columns without a unit are in --angle and --length.

    Example: pieper calibrate denso-vp6242 measured.csv --out my-denso.toml
    """
    table = _Data.of(data)
    q = _joints(arm, table, units)
    measured = _measured(table, kind, units, order)
    if unused := [head for j, head in enumerate(table.heads) if j not in table.used]:
        note(f"not used of {table.name}: {', '.join(unused)}.")
    try:
        fit = arm.calibrate(
            q,
            measured,
            kind=kind,
            sigma=_noise(sigma, units),
            hold=hold,
            joint_terms=tuple(term for term in terms.replace(",", " ").split() if term),
            loss=loss,
            holdout=holdout,
        )
    except InputError as error:
        if "unit" not in error.data:
            raise
        raise InputError(f"{error} {_UNITS}", **error.data) from None
    if out:
        fit.save(out)
    if report:
        pieper.write_report(arm, Path(report), fit=fit)
    if json:
        held = None if fit.held_out is None else fit.held_out.as_dict()
        print_json(
            {
                "arm": arm.name,
                "held_out": held,
                "unobservable": fit.unobservable,
                "outliers": [index + 1 for index in fit.outliers],
                "sigma": fit.sigma,
                "spread": fit.spread,
                "axes": fit.model.axes,
                "points_m": fit.model.points,
                "home_m": fit.model.home,
            }
        )
        return DONE
    for line in fit.explain().splitlines():
        say(line)
    if out:
        print(out)
    return DONE


@dataclass(frozen=True)
class _Data:
    """A table of measurements: names of its columns, its lines by their number, and the sign before decimals."""

    name: str
    heads: list[str]
    lines: dict[int, list[str]]
    sign: DecimalSign | None
    used: set[int] = field(default_factory=set[int])

    @staticmethod
    def of(name: str) -> _Data:
        text = read_text(name, "DATA.csv")
        pipes.keep(name, text.encode())  # poses are read of it too
        given = [raw.split("#")[0].strip() for raw in text.splitlines()]
        numbers = [at for at, line in enumerate(given, 1) if line]
        if len(numbers) < 2:
            raise InputError(f"{name} needs a line of column names and a line a pose.", path=name)
        mark = delimiter_of(given[numbers[0] - 1])
        cells = {at: cells_of(given[at - 1], mark) for at in numbers}
        return _Data(name, cells.pop(numbers[0]), cells, DecimalSign(name) if mark in ";\t" else None)

    def value(self, at: int, column: int) -> float:
        cells, what = self.lines[at], f"{self.name}, line {at}"
        if len(cells) != len(self.heads):
            said = f"{what}: {plural(len(cells), 'cell')} where the first line has {len(self.heads)}."
            raise InputError(said, path=self.name, line=at)
        if self.sign is None:
            return number(cells[column], what)
        self.sign.look(at, [cells[column]])
        return number(self.sign.with_points(cells[column]), what)


def _measured(table: _Data, kind: str, units: Units, order: str) -> Numbers | None:
    """Return what was measured, and remark columns that are not used."""
    if kind in COLUMN:
        return _column(table, COLUMN[kind], LENGTHS, units.metres, required=kind == "distance")
    names = [name_and_unit(head)[0] for head in table.heads]
    other = next((other for other, name in COLUMN.items() if name in names), None)
    if other and not set(POSITION) <= set(names):
        raise InputError(
            f"{table.name} has the column {COLUMN[other]} and no position: say --kind {other}.", path=table.name
        )
    file = PoseFile(table.name, units, order)
    poses = np.concatenate(list(file.blocks()))
    if kind == "pose" and file.bare:
        raise InputError(
            f"{table.name} has positions and no orientation: say --kind position.", path=table.name, missing="rpy"
        )
    table.used.update(j for j, head in enumerate(table.heads) if head not in file.unused)
    return poses if kind == "pose" else poses[:, :3, 3]


def _joints(arm: pieper.Arm, table: _Data, units: Units) -> Numbers:
    columns = []
    for i, (joint, kind) in enumerate(zip(arm.joint_names, arm.joint_types, strict=True)):
        sizes, own = (ANGLES, units.radians) if kind == "R" else (LENGTHS, units.metres)
        found = _column(table, joint, sizes, own, required=False)
        if found is None:
            found = _column(table, f"q{i + 1}", sizes, own, required=False)
        if found is None:
            raise InputError(
                f"{table.name}: there is no column for {joint}: call it {joint}_{next(iter(sizes))}, or q{i + 1}. "
                f"It has {', '.join(table.heads)}.",
                path=table.name,
                missing=joint,
            )
        columns.append(found)
    return np.stack(columns, 1)


def _column(table: _Data, stem: str, sizes: dict[str, float], own: float, *, required: bool) -> Numbers | None:
    """Return a column (N,), SI, by its name with or without a unit."""
    for j, head in enumerate(table.heads):
        said = head.lower()
        unit = said.removeprefix(f"{stem.lower()}_")
        if said != stem.lower() and not (said.startswith(f"{stem.lower()}_") and unit in sizes):
            continue
        table.used.add(j)
        return np.array([table.value(at, j) for at in table.lines]) * (own if said == stem.lower() else sizes[unit])
    if required:
        said = f"{table.name}: there is no column {stem}; it has {', '.join(table.heads)}."
        raise InputError(said, path=table.name, missing=stem)
    return None


def _noise(text: str, units: Units) -> tuple[float, float] | None:
    if not text:
        return None
    said = [number(word, "--sigma") for word in text.replace(",", " ").split()]
    if len(said) not in (1, 2):
        raise InputError(f"--sigma takes one or two numbers ({units.length}, {units.angle}), got {text!r}.", given=text)
    return said[0] * units.metres, said[-1] * units.radians
