"""The arms of a claims file: one of the catalogue, a robot file, or a DH table as a source prints it."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from pieper.algebra.expression import Expr, Num
from pieper.algebra.formula import Mention, number
from pieper.algebra.parser import parse
from pieper.description import source as door
from pieper.description.axes import from_axes
from pieper.description.dh import DH, Description
from pieper.description.said import describe
from pieper.errors import InputError
from pieper.judge.evidence import under
from pieper.judge.keys import ARM, MAX_SIZE, UNITS, look, only_known
from pieper.judge.model import ArmModel, Row, model_from_description
from pieper.judge.solver import Solver
from pieper.tolerances import ROUNDING
from pieper.words_by_number import plural

COLUMNS = {"a", "alpha", "d", "theta"}


def read_arm(place: str, table: dict[str, Any]) -> ArmModel:
    """Read an [arm] table; `place` names it in messages."""
    only_known(table, ARM, place)
    look(table, ARM, place)
    if "rows" not in table:
        source = table.get("robot") or table.get("file") or table.get("name")
        if not source:
            raise InputError(
                f'{place}: name a catalogue arm (robot = "denso-vp6242"), a robot file (file = ..), or give rows'
            )
        try:
            description = door.read(source)
        except InputError as error:
            raise InputError(f"{place}: {error}") from None
        description = _as_the_page_has_it(place, description, table)
        return model_from_description(description, Solver.of(description.by_axes()))
    convention = table.get("convention")
    if convention not in ("standard", "modified"):
        raise InputError(f'{place}: convention = {convention!r}; say "standard" or "modified"', key="convention")
    unit = table.get("length_unit")
    if unit not in UNITS:
        raise InputError(f"{place}: length_unit = {unit!r}; say one of {', '.join(UNITS)}", key="length_unit")
    return _table(place, table, convention, unit)


def _as_the_page_has_it(place: str, d: Description, table: dict[str, Any]) -> Description:
    """The arm by the table's angles where theta stands for them, and without what the page takes off its poses."""
    if table.get("angles") == "table":
        if d.coupling is not None:
            raise InputError(
                f"{place}: angles = 'table' goes with arms whose joints are not coupled; of {d.name}, whose are, "
                "theta1, theta2 .. are the values of the axes whatever is said: leave angles out",
                key="angles",
            )
        turns = np.array([kind == "R" for kind in d.joint_types])
        zero = d.offset + np.where(turns, [row.theta for row in d.rows], [row.d for row in d.rows])
        limits = np.sort(d.limits * d.sign[:, None] + zero[:, None], axis=1)
        rows = tuple(replace(row, **{"theta" if t else "d": 0.0}) for row, t in zip(d.rows, turns, strict=True))
        d = replace(d, rows=rows, sign=np.ones(d.n), offset=np.zeros(d.n), limits=limits, postures={}, checks=())
    off = {part: np.eye(4) for part in table.get("taken_off", ())}
    return replace(d, **off) if off else d


def _table(place: str, table: dict[str, Any], convention: str, unit: str) -> ArmModel:
    """Read a DH table as printed: cells are numbers, symbols with [values], and angles with their unit."""
    columns = table.get("columns")
    if columns is None or set(columns) != COLUMNS:
        raise InputError(
            f'{place}: columns must name the four columns as printed, such as ["theta", "d", "a", "alpha"]; '
            f"got {columns!r}",
            key="columns",
        )
    values = {str(k): float(v) for k, v in table.get("values", {}).items()}
    zeros = {name for name, value in values.items() if not value}
    cells = table["rows"]
    n = len(cells)
    variables = {f"{c}{i + 1}" for i in range(n) for c in "dbq"} - set(values)
    rows: list[Row] = []
    above: list[Row] = []  # constant rows before the first joint
    aliases = {}
    for i, cell_row in enumerate(cells):
        if not isinstance(cell_row, list) or len(cell_row) != 4:
            raise InputError(
                f"{place}: row {i + 1} must have four cells, {', '.join(columns)}; got {cell_row!r}", key="rows"
            )
        made = {}
        for column, cell in zip(columns, cell_row, strict=True):
            with under(f"{place}: row {i + 1}, {column}", "rows"):
                made[column] = _cell(column, cell, i, values, variables, n, convention)
                _look_at_value(made[column], values, n, variables)
        joint = len(rows) + 1
        _look_at_variables(f"{place}: row {i + 1}", made, joint, n, variables)
        slides = [s for s in made["d"].symbols() if s in variables]
        for name in slides:
            aliases[name] = f"theta{joint}"
            made["d"] = made["d"].substitute({name: Mention(f"theta{joint}")})
        row = Row(made["a"], made["alpha"], made["d"], made["theta"])
        if f"theta{joint}" in row.d.symbols() | row.theta.symbols():
            rows.append(row if rows else replace(row, before=tuple(above)))
        elif rows:
            rows[-1] = replace(rows[-1], after=(*rows[-1].after, row))
        else:
            above.append(row)
    if not rows:
        raise InputError(
            f"{place}: no row has a joint variable; write q1 under theta, or b1 under d for a sliding joint",
            key="rows",
        )
    base, tool = (_pose(place, table, key) for key in ("base", "tool"))
    name = str(table.get("name", "the arm of the file"))
    every = [r for row in rows for r in (*row.before, row, *row.after)]
    zeros &= {name for r in every for cell in (r.a, r.d) for name in cell.symbols()}
    model = ArmModel(name, convention, tuple(rows), values, unit, base, tool, None, aliases, frozenset(zeros))
    try:
        return replace(model, solver=_solver(model))
    except InputError as error:
        raise InputError(f"{place}: {error}") from None


def _cell(
    column: str, cell: Any, i: int, values: dict[str, float], variables: set[str], n: int, convention: str
) -> Expr:
    if isinstance(cell, bool) or not isinstance(cell, (int, float, str)):
        raise InputError(f"{cell!r} is neither a number nor a formula")
    if column in ("alpha", "theta"):
        bare = InputError(f'the angle {cell!r} has no unit; write "{cell} deg" or "{cell} rad"')
        if not isinstance(cell, str):
            if cell == 0:
                return number(0)
            raise bare
        node = parse(cell, set(values), n)
        atoms = [x for x in node.walk() if not x.args]
        if all(isinstance(x, Num) for x in atoms) and "rad" not in cell and any(x.value for x in atoms):
            raise bare
        return node
    if isinstance(cell, str):
        return parse(cell, set(values) | variables, n)
    name = f"{column}{i + 1 if convention == 'standard' or column == 'd' else i}"
    if name in values and values[name] != cell:
        raise InputError(f"the number {cell!r} and [values] {name} = {values[name]!r} contradict each other")
    values[name] = float(cell)
    variables.discard(name)
    return Mention(name)


def _look_at_variables(place: str, made: dict[str, Expr], joint: int, n: int, variables: set[str]) -> None:
    """Refuse a variable where none can stand, one of another joint, and a row with two."""
    joints = {f"theta{j + 1}" for j in range(n)}
    for column in ("a", "alpha"):
        moving = made[column].symbols() & (variables | joints)
        if moving:
            raise InputError(
                f"{place}, {column}: {moving.pop()} moves, but {column} is constant in a DH table", key="rows"
            )
    slides, turns = made["d"].symbols() & (variables | joints), made["theta"].symbols() & joints
    count = f"; this row is joint {joint}, for rows with a variable are counted"
    if slides - {f"{c}{joint}" for c in "dbq"} or len(slides) > 1:
        raise InputError(
            f"{place}, d: a slide of this row is called b{joint} or d{joint}, not {', '.join(sorted(slides))}{count}",
            key="rows",
        )
    if turns - {f"theta{joint}"}:
        raise InputError(f"{place}, theta: write q{joint}, not {', '.join(sorted(turns))}{count}", key="rows")
    if slides and turns:
        raise InputError(f"{place}: theta and d both move; a row has one variable", key="rows")


def _look_at_value(cell: Expr, values: dict[str, float], n: int, variables: set[str]) -> None:
    """Refuse a cell that has no finite value, such as 1/0 or the root of a negative number."""
    at = {**dict.fromkeys(variables, 0.3), **{f"theta{j + 1}": 0.3 for j in range(n)}, **values}
    value = float(cell.evaluate(at))
    if not np.isfinite(value) or abs(value) > MAX_SIZE:
        raise InputError(f"{str(cell)[:80]!r} has no value that a length or an angle could have; it is {value}")


def _pose(place: str, table: dict[str, Any], key: str) -> np.ndarray:
    if key not in table:
        return np.eye(4)
    T = np.array(table[key], dtype=float)
    if T.shape != (4, 4):
        raise InputError(f"{place}: {key} must be a 4 x 4 matrix, got shape {T.shape}", key=key)
    return T


def _solver(model: ArmModel) -> Solver | None:
    """Make the same arm for the solver, or None when its variables are not plain q, -q or q plus a constant."""
    zero, one = ({**model.values, **{f"theta{j + 1}": v for j in range(model.n)}} for v in (0.0, 1.0))
    to_metre = UNITS[model.unit]
    rows, kinds, sign = [], "", []
    for i, row in enumerate(model.rows):
        slides = model.sliding(i + 1)
        moves = row.d if slides else row.theta
        step = float(moves.evaluate(one)) - float(moves.evaluate(zero))
        others = moves.symbols() & {f"theta{j + 1}" for j in range(model.n) if j != i}
        if abs(abs(step) - 1) > ROUNDING or others:
            return None
        sign.append(1 if step > 0 else -1)
        kinds += "P" if slides else "R"
        a, alpha, d, theta = (float(c.evaluate(zero)) for c in row.cells)
        rows.append(DH(a=a * to_metre, alpha=alpha, d=d * to_metre, theta=theta))
    base, tool = model.base.copy(), model.tool.copy()
    base[:3, 3] *= to_metre
    tool[:3, 3] *= to_metre
    if any(row.before or row.after for row in model.rows):
        return Solver.of(_by_axes(model, zero, kinds, sign))
    description = describe(
        rows, convention=model.convention, joint_types=kinds, base=base, tool=tool, sign=sign, name=model.name
    )
    return Solver.of(description)


def _by_axes(model: ArmModel, zero: dict[str, float], kinds: str, sign: list[int]) -> Description:
    """The arm of a table with constant rows, by its axes with all joints at zero."""
    env: dict[str, Any] = {name: np.full(1, value) for name, value in zero.items()}
    frames = model.frames(env)
    T, axes, points = model.base, [], []
    for k, own in enumerate(model.axis_frames(frames, env)):
        axis = T @ own[0]
        axes.append(sign[k] * axis[:3, 2])
        points.append(axis[:3, 3] * UNITS[model.unit])
        T = T @ frames[f"A{k + 1}"][0]
    home = frames["T"][0].copy()
    home[:3, 3] *= UNITS[model.unit]
    return from_axes(np.array(axes), np.array(points), home, joint_types=kinds, name=model.name)


def describe_arm(model: ArmModel, words: str = "") -> str:
    """Say what an arm is, in a line; `words` are the file's own."""
    shown = ", ".join(f"{k} = {v:g}" for k, v in model.values.items() if v)
    lengths = f", {shown} ({model.unit})" if shown else ""
    remarks = "".join(f" {text}" for text in (model.remark, words) if text)
    return f"{model.name}: {plural(model.n, 'joint')}, {model.convention} DH{lengths}.{remarks}"
