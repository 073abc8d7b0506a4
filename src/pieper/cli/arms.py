"""`pieper robots` and `pieper show`: which arms ship, and what is known of one."""

from __future__ import annotations

import numpy as np

from pieper.cli import DONE
from pieper.cli.given import Units
from pieper.cli.given import arm as load
from pieper.cli.printed import as_json, console, joint_cells, number, table


def robots(pattern: str, json: bool) -> int:
    """List the arms whose name contains the pattern."""
    import pieper

    names = [name for name in pieper.catalog() if pattern.lower() in name]
    rows = []
    for name in names:
        d = pieper.load(name).description
        rows.append((name, d.n, d.joint_types, d.convention, d.manufacturer, d.source))
    if json:
        keys = ("name", "joints", "joint_types", "convention", "manufacturer", "source")
        as_json([dict(zip(keys, row, strict=True)) for row in rows])
        return DONE
    made = table(f"{len(rows)} arms", "name", "joints", "DH", "maker", left=(0, 2, 3))
    for name, _, types, convention, maker, _ in rows:
        made.add_row(name, types, convention, maker)
    console().print(made)
    return DONE


def show(name: str, json: bool, figure: str, length: str, angle: str) -> int:
    """Show one arm."""
    units = Units(length, angle)
    arm = load(name)
    d = arm.description
    plan, beyond = None, ""
    from pieper.errors import PlanError

    try:
        plan = arm.plan
    except PlanError as error:
        beyond = str(error)
    if figure:
        from pieper.presentation.plot_arm import arm_figure
        from pieper.presentation.style import save_figure

        posture = next(iter(d.postures.values()), np.zeros(arm.n))
        save_figure(arm_figure(arm, posture, title=arm.name), figure)
    if json:
        as_json(_as_data(arm, plan, beyond))
        return DONE
    out = console()
    a, th = units.metres, units.radians
    kind = "standard (distal)" if d.convention == "standard" else "modified (proximal, Craig)"
    made = table(
        f"{arm.name}: {arm.n} joints {arm.joint_types}, {kind} DH",
        "joint", f"a, {length}", f"alpha, {angle}", f"d, {length}", f"theta, {angle}",
        "sense", "zero", "lower", "upper",
        left=(0,),
    )  # fmt: skip
    for i, row in enumerate(d.rows):
        unit = th if arm.joint_types[i] == "R" else a
        cells = [number(row.a / a), number(row.alpha / th), number(row.d / a), number(row.theta / th)]
        variable = 3 if arm.joint_types[i] == "R" else 2
        cells[variable] = f"q{i + 1}" + (
            f" {'+' if float(cells[variable]) > 0 else '-'} {abs(float(cells[variable])):g}"
            if float(cells[variable])
            else ""
        )
        limits = [number(v / unit, 2) for v in d.limits[i]]
        made.add_row(d.joint_names[i], *cells, "+" if d.sign[i] > 0 else "-", number(d.offset[i] / unit, 2), *limits)
    out.print(made)
    for what, T in (("base", arm.base), ("tool", arm.tool)):
        if not np.array_equal(T, np.eye(4)):
            from pieper.cli.printed import pose_table

            out.print(pose_table(T, units, what))
    if d.actuator:
        g = d.actuator
        out.print(f"actuator {g.name}: {g.lower:g} to {g.upper:g} {g.unit}, now {g.value:g}; it moves no frame\n")
    if d.postures:
        postures = table("postures", "name", *(f"{n}" for n in d.joint_names), left=(0,))
        for key, q in d.postures.items():
            postures.add_row(key, *joint_cells(arm, q, units))
        out.print(postures)
    for text in (plan.explain() if plan else beyond, f"Source: {d.source}" if d.source else "", d.notes):
        if text:
            out.print(text.strip() + "\n", markup=False)
    if figure:
        out.print(f"figure: {figure}", markup=False)
    return DONE


def _as_data(arm, plan, beyond: str) -> dict:
    d = arm.description
    return {
        "name": arm.name,
        "convention": d.convention,
        "joint_types": arm.joint_types,
        "joint_names": arm.joint_names,
        "dh": [{"a_m": r.a, "alpha_rad": r.alpha, "d_m": r.d, "theta_rad": r.theta} for r in d.rows],
        "sign": d.sign,
        "offset": d.offset,
        "limits": d.limits,
        "units": ["rad" if kind == "R" else "m" for kind in arm.joint_types],
        "base": arm.base,
        "tool": arm.tool,
        "postures": d.postures,
        "manufacturer": d.manufacturer,
        "source": d.source,
        "notes": d.notes,
        "plan": {"family": plan.family, "max_solutions": plan.max_solutions, "task": plan.task, "text": plan.explain()}
        if plan
        else {"beyond": beyond},
    }
