"""A claims file: an arm and what somebody says about it. `check` reads one and judges every claim.

The format is described in docs/claims_files.md. Reading is strict: everything that is not understood is an error that
names the place.
"""

from __future__ import annotations

import difflib
import os
import tomllib
from collections.abc import Callable
from pathlib import Path

import numpy as np

from pieper.algebra.parser import FormulaError, parse
from pieper.algebra.tree import Node, evaluate, num, substitute, sym
from pieper.errors import InputError
from pieper.judge.evidence import Evidence
from pieper.judge.judges import angles as judge_angles
from pieper.judge.judges import formulas as judge_formulas
from pieper.judge.judges import freedom as judge_freedom
from pieper.judge.judges import matrices as judge_matrices
from pieper.judge.judges import poses as judge_poses
from pieper.judge.judges import solutions as judge_solutions
from pieper.judge.judges import tables as judge_tables
from pieper.judge.model import ArmModel, Row, model_from_description
from pieper.judge.printed import UNITS
from pieper.judge.verdict import Report, Verdict

MAX_BYTES = 2_000_000

JUDGES: dict[str, tuple[Callable[[Evidence, dict], Verdict], set[str], set[str]]] = {
    # kind: (judge, keys it needs, keys it may have)
    "entry": (judge_formulas.judge_entry, {"of", "is"}, {"where"}),
    "matrix": (judge_matrices.judge_matrix, {"of", "is"}, {"where"}),
    "equation": (judge_formulas.judge_equation, {"is"}, {"where", "frame", "at_deg"}),
    "product": (judge_matrices.judge_product, {"is"}, set()),
    "joint": (judge_angles.judge_joint, {"is"}, {"joint", "for", "where", "frame", "at_deg", "task"}),
    "together": (judge_angles.judge_together, {"is"}, {"where", "frame"}),
    "procedure": (judge_angles.judge_procedure, {"steps"}, {"where"}),
    "pose": (judge_poses.judge_pose, set(), {"q", "q_deg", "q_rad", "of", "matrix", "position", "unit", "rounded"}),
    "solutions": (
        judge_solutions.judge_solutions,
        {"solutions_deg"},
        {"matrix", "q", "q_deg", "q_rad", "complete", "unit", "task"},
    ),
    "count": (judge_solutions.judge_count, {"count"}, {"task"}),
    "freedom": (judge_freedom.judge_freedom, {"dof"}, {"free", "at_deg"}),
    "errors": (judge_tables.judge_errors, {"rows", "percent"}, set()),
    "table": (judge_tables.judge_table, {"rows"}, {"unit", "within", "search_zeros"}),
    "limit": (judge_tables.judge_limit, {"joint", "range_deg"}, {"path", "unit"}),
    "range": (judge_tables.judge_range, {"joint", "range_deg", "values_deg"}, set()),
    "number": (judge_tables.judge_number, {"is", "value"}, {"q", "q_deg", "q_rad", "unit", "where"}),
}
_ALWAYS = {"id", "kind", "says", "arm"}
_FILE_KEYS = {"title", "source", "notes", "arm", "arms", "symbols", "claim", "seconds"}
_ARM_KEYS = {
    "name",
    "robot",
    "file",
    "convention",
    "length_unit",
    "columns",
    "rows",
    "values",
    "base",
    "tool",
    "limits_deg",
    "words",
}
_COLUMNS = {"a", "alpha", "d", "theta"}


def check(path_or_text: str | os.PathLike, arm=None) -> Report:
    """Judge every claim of a claims file.

    Args:
        path_or_text: path of a TOML file, or its text (anything with a line break or an equals sign).
        arm: a `pieper.Arm` to judge against instead of the file's own `[arm]`.

    Returns:
        The report, one verdict per claim in the file's order.

    Raises:
        InputError: the file cannot be read; the message names the claim, the key and, in a formula, the character.
    """
    name, text = _read(path_or_text)
    try:
        data = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise InputError(f"{name}: this is not TOML: {error}") from None
    _only(data, _FILE_KEYS, f"{name}: the file")
    arms = _arms(name, data, arm)
    claims = data.get("claim", [])
    if not isinstance(claims, list) or not claims:
        raise InputError(f"{name}: there is no claim; write at least one [[claim]] table")
    benches = {}
    for key, model in arms.items():
        benches[key] = Evidence(model, seconds=float(data.get("seconds", 2.0)))
        for symbol, body in _symbols(data, key).items():
            try:
                benches[key].define(symbol, body)
            except InputError as error:
                raise InputError(f"{name}: [symbols] {symbol}: {error}") from None
    seen: set[str] = set()
    verdicts = []
    for position, claim in enumerate(claims, 1):
        ident = str(claim.get("id", position))
        if ident in seen:
            raise InputError(f"{name}: two claims are called {ident!r}; every id stands once", claim=ident)
        seen.add(ident)
        verdicts.append(_judge(name, {**claim, "id": ident}, benches))
    words = tuple(_describe(key, model, data) for key, model in arms.items())
    return Report(
        str(data.get("title", name)), str(data.get("source", "")), words, tuple(verdicts), str(data.get("notes", ""))
    )


def _judge(name: str, claim: dict, benches: dict[str, Evidence]) -> Verdict:
    ident = claim["id"]
    kind = claim.get("kind")
    if kind not in JUDGES:
        near = difflib.get_close_matches(str(kind), JUDGES, 1)
        raise InputError(
            f"{name}: claim {ident}: kind = {kind!r} is not known"
            + (f"; did you mean {near[0]!r}?" if near else "")
            + f" Kinds are {', '.join(JUDGES)}.",
            claim=ident,
        )
    judge, needs, may = JUDGES[kind]
    _only(claim, _ALWAYS | needs | may, f"{name}: claim {ident} ({kind})")
    for key in needs:
        if key not in claim:
            raise InputError(
                f"{name}: claim {ident} ({kind}) lacks the key {key!r}; it needs {', '.join(sorted(needs))}",
                claim=ident,
            )
    which = claim.get("arm", next(iter(benches)))
    if which not in benches:
        raise InputError(
            f"{name}: claim {ident} names the arm {which!r}; the file has {', '.join(benches)}", claim=ident
        )
    try:
        return judge(benches[which], claim)
    except FormulaError as error:
        raise FormulaError(f"{name}: claim {ident}: {error}", claim=ident, **getattr(error, "data", {})) from None
    except InputError as error:
        message = str(error)
        raise InputError(
            f"{name}: {message}" if message.startswith("claim ") else f"{name}: claim {ident}: {message}", claim=ident
        ) from None


def _read(source) -> tuple[str, str]:
    if isinstance(source, str) and ("\n" in source or ("=" in source and not os.path.isfile(source))):
        return "claims", source
    path = Path(source)
    try:
        if path.stat().st_size > MAX_BYTES:
            raise InputError(f"{path}: {path.stat().st_size:,} bytes; a claims file has at most {MAX_BYTES:,}")
        return path.name, path.read_text(encoding="utf-8")
    except UnicodeDecodeError:
        raise InputError(f"{path}: this is not a text file in UTF-8") from None
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror or error}") from None


def _only(table: dict, allowed: set[str], what: str):
    if not isinstance(table, dict):
        raise InputError(f"{what} must be a table of keys and values")
    for key in table:
        if key not in allowed:
            near = difflib.get_close_matches(key, allowed, 1)
            raise InputError(
                f"{what}: the key {key!r} is not known"
                + (f"; did you mean {near[0]!r}?" if near else "")
                + f" Keys are {', '.join(sorted(allowed))}.",
                key=key,
            )


def _symbols(data: dict, arm: str) -> dict[str, str]:
    """Return the file's symbols; a table inside [symbols] belongs to the arm of its name only."""
    out = {}
    for name, body in data.get("symbols", {}).items():
        if isinstance(body, dict):
            if name == arm:
                out.update(body)
        else:
            out[name] = body
    return out


def _arms(name: str, data: dict, given) -> dict[str, ArmModel]:
    if given is not None:
        return {"arm": model_from_description(given.description, given)}
    tables = data.get("arms") or ({"arm": data["arm"]} if "arm" in data else {})
    if not tables:
        raise InputError(
            f'{name}: no arm is named; write [arm] with name = "denso-vp6242", or file, or a DH table in rows'
        )
    return {key: _arm(f"{name}: [{'arms.' if 'arms' in data else ''}{key}]", table) for key, table in tables.items()}


def _arm(place: str, table: dict) -> ArmModel:
    _only(table, _ARM_KEYS, place)
    if "rows" not in table:
        import pieper

        source = table.get("robot") or table.get("file") or table.get("name")
        if not source:
            raise InputError(
                f'{place}: name a catalogue arm (robot = "denso-vp6242"), a robot file (file = ..), or give rows'
            )
        try:
            loaded = pieper.load(source)
        except InputError as error:
            raise InputError(f"{place}: {error}") from None
        return model_from_description(loaded.description, loaded)
    convention = table.get("convention")
    if convention not in ("standard", "modified"):
        raise InputError(f'{place}: convention = {convention!r}; say "standard" or "modified"')
    unit = table.get("length_unit")
    if unit not in UNITS:
        raise InputError(f"{place}: length_unit = {unit!r}; say one of {', '.join(UNITS)}")
    return _inline(place, table, convention, unit)


def _inline(place: str, table: dict, convention: str, unit: str) -> ArmModel:
    """Read a DH table as printed: cells are numbers, symbols with [values], and angles with their unit."""
    columns = table.get("columns")
    if not isinstance(columns, list) or set(columns) != _COLUMNS or len(columns) != 4:
        raise InputError(
            f'{place}: columns must name the four columns as printed, such as ["theta", "d", "a", "alpha"]; '
            f"got {columns!r}"
        )
    values = {str(k): float(v) for k, v in table.get("values", {}).items()}
    cells = table["rows"]
    n = len(cells)
    variables = {f"{c}{i + 1}" for i in range(n) for c in "dbq"} - set(values)
    rows, aliases = [], {}
    for i, cell_row in enumerate(cells):
        if not isinstance(cell_row, list) or len(cell_row) != 4:
            raise InputError(f"{place}: row {i + 1} must have four cells, {', '.join(columns)}; got {cell_row!r}")
        made = {}
        for column, cell in zip(columns, cell_row, strict=True):
            made[column] = _cell(f"{place}: row {i + 1}, {column}", column, cell, i, values, variables, n, convention)
        slides = [s for s in made["d"].symbols() if s in variables]
        for name in slides:
            aliases[name] = f"theta{i + 1}"
            made["d"] = substitute(made["d"], {name: sym(f"theta{i + 1}")})
        if not slides and f"theta{i + 1}" not in made["theta"].symbols():
            raise InputError(
                f"{place}: row {i + 1} has no joint variable; write q{i + 1} under theta, or b{i + 1} under "
                f"d for a sliding joint"
            )
        rows.append(Row(made["a"], made["alpha"], made["d"], made["theta"]))
    limits = np.radians(np.array(table["limits_deg"], dtype=float)) if "limits_deg" in table else None
    base, tool = (_pose(place, table, key) for key in ("base", "tool"))
    model = ArmModel(
        str(table.get("name", "the arm of the file")),
        convention,
        tuple(rows),
        values,
        unit,
        base,
        tool,
        limits,
        None,
        aliases,
    )
    return ArmModel(**{**model.__dict__, "solver": _solver(model)})


def _cell(place: str, column: str, cell, i: int, values: dict, variables: set, n: int, convention: str) -> Node:
    if isinstance(cell, bool) or not isinstance(cell, (int, float, str)):
        raise InputError(f"{place}: {cell!r} is neither a number nor a formula")
    if column in ("alpha", "theta"):
        if not isinstance(cell, str):
            if cell == 0:
                return num(0)
            raise InputError(f'{place}: the angle {cell!r} has no unit; write "{cell} deg" or "{cell} rad"')
        node = parse(cell, {"pi"} | set(values), n)
        if not node.symbols() and "rad" not in cell and any(x.op == "num" and float(x.value) for x in node.walk()):
            raise InputError(f'{place}: the angle {cell!r} has no unit; write "{cell} deg" or "{cell} rad"')
        return node
    if isinstance(cell, str):
        return parse(cell, set(values) | variables, n)
    name = f"{column}{i + 1 if convention == 'standard' or column == 'd' else i}"
    if name in values and values[name] != cell:
        raise InputError(f"{place}: the number {cell!r} and [values] {name} = {values[name]!r} contradict each other")
    values[name] = float(cell)
    variables.discard(name)
    return num(0) if cell == 0 else sym(name)


def _pose(place: str, table: dict, key: str) -> np.ndarray:
    if key not in table:
        return np.eye(4)
    T = np.array(table[key], dtype=float)
    if T.shape != (4, 4):
        raise InputError(f"{place}: {key} must be a 4 x 4 matrix, got shape {T.shape}")
    return T


def _solver(model: ArmModel):
    """Make the same arm for the solver, or None when its variables are not plain q, -q or q plus a constant."""
    from pieper import DH, Arm

    env = {**model.values, "pi": np.pi}
    at = [{f"theta{j + 1}": v for j in range(model.n)} for v in (0.0, 1.0)]
    to_metre = UNITS[model.unit]
    rows, kinds, sign = [], "", []
    for i, row in enumerate(model.rows):
        a, alpha = (float(evaluate(c, {**env, **at[0]})) for c in (row.a, row.alpha))
        d0, d1 = (float(evaluate(row.d, {**env, **p})) for p in at)
        t0, t1 = (float(evaluate(row.theta, {**env, **p})) for p in at)
        slides = model.sliding(i + 1)
        step = d1 - d0 if slides else t1 - t0
        if abs(abs(step) - 1) > 1e-12:
            return None
        sign.append(1 if step > 0 else -1)
        kinds += "P" if slides else "R"
        rows.append(DH(a=a * to_metre, alpha=alpha, d=d0 * to_metre, theta=t0))
    base, tool = model.base.copy(), model.tool.copy()
    base[:3, 3] *= to_metre
    tool[:3, 3] *= to_metre
    return Arm.from_dh(
        rows, convention=model.convention, joint_types=kinds, base=base, tool=tool, sign=sign, name=model.name
    )


def _describe(key: str, model: ArmModel, data: dict) -> str:
    table = data.get("arms", {}).get(key) or data.get("arm") or {}
    words = f" {table['words']}" if table.get("words") else ""
    shown = ", ".join(f"{k} = {v:g}" for k, v in model.values.items() if v)
    lengths = f", {shown} ({model.unit})" if shown else ""
    joints = "1 joint" if model.n == 1 else f"{model.n} joints"
    return f"{model.name}: {joints}, {model.convention} DH{lengths}.{words}"
