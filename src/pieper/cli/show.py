"""`pieper show`: what is known of one arm, and how it is solved."""

from __future__ import annotations

from typing import Any

import click
import numpy as np

import pieper
from pieper.cli.layout import Column
from pieper.cli.options import as_json, figure, takes_arm, takes_units
from pieper.cli.output import as_json as print_json
from pieper.cli.output import (
    joint_cells,
    joint_columns,
    number,
    plural,
    print_pose,
    print_table,
    say,
    short,
    si_units,
)
from pieper.cli.status import DONE
from pieper.cli.units import Units
from pieper.tolerances import TYPED_DIGITS


@click.command("show", short_help="Show an arm and how it is solved.")
@takes_arm
@figure
@as_json
@takes_units
def command(arm: pieper.Arm, figure: str, json: bool, units: Units) -> int:
    """Show an arm: its DH table, limits, postures, and how it is solved."""
    plan, beyond = None, ""
    try:
        plan = arm.plan
    except pieper.PlanError as error:
        beyond = str(error)
    if figure:
        posture = next((q for name, q in arm.postures.items() if name != "zero"), np.zeros(arm.n))
        pieper.plot.save_figure(pieper.plot.arm_figure(arm, posture, title=arm.name), figure)
    if json:
        print_json(_as_data(arm, plan, beyond))
        return DONE
    d = arm.description
    _print_dh(arm, units)
    for what, T in (("base", arm.base), ("tool", arm.tool)):
        if not np.array_equal(T, np.eye(4)):
            print_pose(T, units, what)
    if d.actuator:
        g = d.actuator
        say(f"Actuator {g.name}: {g.lower:g} to {g.upper:g} {g.unit}, now {g.value:g}; it moves no frame.\n")
    if arm.postures:
        rows = [[name, *joint_cells(arm, q, units)] for name, q in arm.postures.items()]
        print_table("postures", [Column("name", True), *joint_columns(arm, units)], rows)
    for text in (plan.explain() if plan else beyond, f"Source: {d.source}" if d.source else "", d.notes):
        if text:
            say(text.strip() + "\n")
    if figure:
        say(f"figure: {figure}")
    return DONE


def _print_dh(arm: pieper.Arm, units: Units) -> None:
    d = arm.description
    length, angle, digits = units.length, units.angle, 3 if units.length == "mm" else 6
    fine = 3 if angle == "deg" else 6
    rows = []
    for i, row in enumerate(d.rows):
        revolute = d.axis_types[i] == "R"
        cells = [
            number(row.a / units.metres, digits),
            number(row.alpha / units.radians, fine),
            number(row.d / units.metres, digits),
            number(row.theta / units.radians, fine),
        ]
        constant = row.theta / units.radians if revolute else row.d / units.metres
        shown = short(abs(constant), fine if revolute else digits)
        sign = "+" if constant > 0 else "-"
        cells[3 if revolute else 2] = d.moved_by(i) + ("" if shown == "0" else f" {sign} {shown}")
        unit, places = (units.radians, fine) if revolute else (units.metres, digits)
        own = d.own_axes.index(i) if i in d.own_axes else None
        limits = ["by linkage", ""] if own is None else [number(v / unit, max(places - 1, 2)) for v in d.limits[own]]
        sense = "+" if d.sign[i] > 0 else "-"
        rows.append([d.axis_names[i], *cells, sense, number(d.offset[i] / unit, max(places - 1, 2)), *limits])
    kind = "standard (distal)" if d.convention == "standard" else "modified (proximal, Craig)"
    heads = [f"a, {length}", f"alpha, {angle}", f"d, {length}", f"theta, {angle}", "sense", "zero", "lower", "upper"]
    title = f"{arm.name}: {plural(arm.n, 'joint')} {arm.joint_types}, {kind} DH"
    print_table(title, [Column("joint", True), *(Column(head) for head in heads)], rows)
    near = arm.symbolic.table
    if near is not d:
        _print_short(near, units)
        for what, T, own in (("base", near.base, d.base), ("tool", near.tool, d.tool)):
            if np.abs(T - own).max() > TYPED_DIGITS:
                print_pose(T, units, f"{what} of that table")


def _print_short(d: Any, units: Units) -> None:
    """Print a table with slid rows: common normals of nearly parallel axes lie far away."""
    length, angle, digits = units.length, units.angle, 3 if units.length == "mm" else 6
    fine = 3 if angle == "deg" else 6
    rows = []
    for i, row in enumerate(d.rows):
        across = number(row.across / units.metres, digits) if row.across else ""
        cells = [row.a / units.metres, row.alpha / units.radians, row.d / units.metres, row.theta / units.radians]
        shown = [number(value, places) for value, places in zip(cells, (digits, fine, digits, fine), strict=True)]
        k = 3 if d.axis_types[i] == "R" else 2
        constant = short(abs(cells[k]), fine if k == 3 else digits)
        shown[k] = d.moved_by(i) + ("" if constant == "0" else f" {'+' if cells[k] > 0 else '-'} {constant}")
        rows.append([d.axis_names[i], shown[0], across, *shown[1:]])
    heads = [f"a, {length}", f"f, {length}", f"alpha, {angle}", f"d, {length}", f"theta, {angle}"]
    title = "the same arm without the way to far common normals: f leads along y, before the turn alpha"
    print_table(title, [Column("joint", True), *(Column(head) for head in heads)], rows)


def _as_data(arm: pieper.Arm, plan: pieper.Plan | None, beyond: str) -> dict[str, Any]:
    d = arm.description
    return {
        "name": arm.name,
        "convention": d.convention,
        "joint_types": arm.joint_types,
        "joint_names": arm.joint_names,
        "linked": [axis.name for axis in d.linked],
        "dh": [{"a_m": r.a, "alpha_rad": r.alpha, "d_m": r.d, "theta_rad": r.theta} for r in d.rows],
        "sign": d.sign,
        "offset": d.offset,
        "coupling": arm.coupling,
        "limits": d.limits,
        "units": si_units(arm),
        "base": arm.base,
        "tool": arm.tool,
        "postures": arm.postures,
        "manufacturer": d.manufacturer,
        "source": d.source,
        "notes": d.notes,
        "plan": {
            "family": plan.family,
            "max_solutions": plan.max_solutions,
            "kind": plan.count.kind,
            "most": plan.count.most,
            "task": plan.task,
            "text": plan.explain(),
        }
        if plan
        else {"beyond": beyond},
    }
