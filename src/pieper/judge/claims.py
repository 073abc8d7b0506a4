"""A claims file: an arm and what somebody says about it. `check` reads one and judges every claim.

The format is described in docs/claims_files.md. Reading is strict: everything that is not understood is an error that
names the place.
"""

from __future__ import annotations

import difflib
import json
import os
import tomllib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, Protocol

import numpy as np

from pieper import arguments
from pieper.algebra.formula_error import FormulaError
from pieper.description.dh import Description
from pieper.errors import InputError
from pieper.judge import keys
from pieper.judge.arms import describe_arm, read_arm
from pieper.judge.claim import Claim
from pieper.judge.evidence import Evidence
from pieper.judge.excerpt import guesses
from pieper.judge.excerpt_file import claims_file, of_the_page
from pieper.judge.judges.angles import judge_joint, judge_together
from pieper.judge.judges.counts import judge_count
from pieper.judge.judges.formulas import judge_entry, judge_equation
from pieper.judge.judges.freedom import judge_freedom
from pieper.judge.judges.jacobians import judge_determinant, judge_jacobian, judge_singular
from pieper.judge.judges.limits import judge_bounds, judge_limit
from pieper.judge.judges.matrices import judge_matrix, judge_product
from pieper.judge.judges.poses import judge_pose
from pieper.judge.judges.procedure import judge_procedure
from pieper.judge.judges.solutions import judge_solutions
from pieper.judge.judges.tables import judge_errors, judge_number, judge_range, judge_table
from pieper.judge.lines import in_its_line, standing
from pieper.judge.model import ArmModel, model_from_description
from pieper.judge.solver import Solver
from pieper.judge.symbols import in_order, plain
from pieper.judge.verdict import Judgement, Verdict
from pieper.solver.plan.plan import Plan

MAX_BYTES = 2_000_000


class Described(Protocol):
    """An arm that can be judged against, such as a `pieper.Arm`."""

    @property
    def description(self) -> Description:
        """What is known of it."""
        ...

    def plan_for(self, task: str | None) -> Plan:
        """How it is solved."""
        ...


@dataclass(frozen=True)
class Judge:
    """How one kind of claim is judged.

    Attributes:
        judge: makes the verdict.
        needs: keys that the claim must have.
        may: keys that it may have besides.
        own: what keys that differ from kind to kind may hold here.
    """

    judge: Callable[[Evidence, Claim], Verdict]
    needs: set[str]
    may: set[str]
    own: Mapping[str, keys.Check] = field(default_factory=dict)


JUDGES = {
    "entry": Judge(judge_entry, {"of", "is"}, {"where", "at_deg", "when"}, {"is": keys.formula}),
    "matrix": Judge(judge_matrix, {"of", "is"}, {"where"}, {"is": keys.ANY_MATRIX}),
    "equation": Judge(judge_equation, {"is"}, {"where", "frame", "at_deg", "when"}, {"is": keys.text}),
    "jacobian": Judge(judge_jacobian, {"is"}, {"of", "where", "at_deg", "when"}, {"is": keys.FORMULA_OR_MATRIX}),
    "determinant": Judge(judge_determinant, {"is"}, {"rows", "where"}, {"is": keys.formula, "rows": keys.ROW_NUMBERS}),
    "singular": Judge(judge_singular, {"is"}, {"where", "rows"}, {"is": keys.text, "rows": keys.ROW_NUMBERS}),
    "product": Judge(judge_product, {"is"}, set(), {"is": keys.text}),
    "joint": Judge(
        judge_joint,
        {"is"},
        {"joint", "for", "where", "frame", "at_deg", "when", "task", "unit"},
        {"is": keys.FORMULAS, "unit": keys.ANGLE_UNIT},
    ),
    "together": Judge(judge_together, {"is"}, {"where", "frame", "at_deg", "when"}, {"is": keys.TOGETHER}),
    "procedure": Judge(judge_procedure, {"steps"}, {"where", "task"}),
    "pose": Judge(judge_pose, set(), {"q", "q_deg", "q_rad", "of", "matrix", "position", "unit", "rounded"}),
    "solutions": Judge(
        judge_solutions,
        {"solutions_deg"},
        {"matrix", "q", "q_deg", "q_rad", "complete", "unit", "task"},
    ),
    "count": Judge(judge_count, {"count"}, {"at_most", "task", "when", "where"}),
    "freedom": Judge(judge_freedom, {"dof"}, {"free", "at_deg"}),
    "errors": Judge(judge_errors, {"rows", "percent"}, set(), {"rows": keys.ERROR_ROWS}),
    "table": Judge(judge_table, {"rows"}, {"unit", "within", "search_zeros"}, {"rows": keys.POSITION_ROWS}),
    "limit": Judge(judge_limit, {"joint", "range_deg"}, {"path", "unit"}),
    "bounds": Judge(judge_bounds, {"is", "between"}, {"where", "frame", "when", "at_deg"}, {"is": keys.formula}),
    "range": Judge(judge_range, {"joint", "range_deg", "values_deg"}, set()),
    "number": Judge(
        judge_number,
        {"is", "value"},
        {"q", "q_deg", "q_rad", "unit", "where"},
        {"is": keys.formula, "unit": keys.NUMBER_UNIT},
    ),
}
ALWAYS = {"id", "kind", "says", "arm"}


def check(path_or_text: str | os.PathLike[str], arm: Described | None = None) -> Judgement:
    """Judge every claim of a claims file.

    Args:
        path_or_text: path of a TOML file, or its text (anything with a line break or an equals sign).
        arm: a `pieper.Arm` to judge against instead of the file's own `[arm]`.

    Returns:
        The judgement, one verdict per claim in the file's order.

    Raises:
        InputError: the file cannot be read; the message names the line, the claim, the key and, in a formula, the
            character.
    """
    name, text = _read(path_or_text)
    try:
        data = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        last = f", line {1 + text.rstrip().count(chr(10))}" if str(error).endswith("(at end of document)") else ""
        raise InputError(f"{name}{last}: this is not TOML: {error}") from None
    try:
        with np.errstate(all="ignore"):  # a division by zero is a finding, and the judges look for it
            return judge_tables(name, data, arm)
    except InputError as error:
        raise in_its_line(error, name, text) from None


def guess_claims(text: str, arm: str | os.PathLike[str], source: str) -> tuple[str, int, int]:
    """Guess the claims of a plain text or LaTeX excerpt; see `excerpt`.

    Args:
        text: The excerpt.
        arm: A catalogue arm, or a robot file.
        source: The excerpt's name.

    Returns:
        A claims file to be looked through, how many claims and symbols were read, how many equations were not.
    """
    name = os.fspath(arm) if isinstance(arm, os.PathLike) else arm
    key = "file" if os.path.isfile(name) else "robot"
    model = read_arm(source, {key: name})
    found = guesses(text, model)
    read = sum(not guess.why for guess in found)
    about = "\n".join([f"{key} = {json.dumps(name)}", *of_the_page(text, found)])
    return claims_file(found, about, source), read, len(found) - read


def judge_tables(name: str, data: dict[str, Any], arm: Described | None = None) -> Judgement:
    """Judge the tables of a claims file that has been read; `name` is the file's, for messages."""
    with standing():
        keys.only_known(data, keys.FILE, f"{name}: the file")
        tables = data.get("claim", [])
        if tables == []:
            raise InputError(f"{name}: there is no claim; write at least one [[claim]] table")
        keys.look(data, keys.FILE, f"{name}: the file")
    arms = _arms(name, data, arm)
    benches = {}
    for key, model in arms.items():
        benches[key] = Evidence(model, seconds=float(data.get("seconds", 2.0)))
        _define(name, data, key, benches[key])
    verdicts: dict[str, Verdict] = {}
    for position, table in enumerate(tables, 1):
        with standing("claim", position):
            keys.look(table, {"id": keys.CLAIM["id"]}, f"{name}: claim {position}", str(position))
            claim = Claim(str(table.get("id", position)), table)
            if claim.id in verdicts:
                raise InputError(
                    f"{name}: two claims are called {claim.id!r}; every id stands once", claim=claim.id, key="id"
                )
            verdicts[claim.id] = _judged(name, claim, benches)
    words = [describe_arm(model, _own_words(data, key)) for key, model in arms.items()]
    title, source, notes = str(data.get("title", name)), str(data.get("source", "")), str(data.get("notes", ""))
    return Judgement(title, source, tuple(words), tuple(verdicts.values()), notes)


def _define(name: str, data: dict[str, Any], arm: str, bench: Evidence) -> None:
    """Let the formulas of one arm use the file's matrices and symbols."""
    for matrix, rows in data.get("matrices", {}).items():
        try:
            bench.define_matrix(matrix, rows)
        except InputError as error:
            raise InputError(f"{name}: [matrices] {matrix}: {error}", place=("matrices", matrix)) from None
    given = _symbols(data, arm)
    stands = {
        plain(k): ("symbols", arm, k) if isinstance(data["symbols"].get(arm), dict) else ("symbols", k) for k in given
    }
    try:
        symbols = in_order({plain(k): str(v) for k, v in given.items()})
    except InputError as error:
        place = stands.get(str(error.data.get("symbol")), ("symbols",))
        raise InputError(f"{name}: [symbols] {error}", place=place) from None
    for symbol, body in symbols.items():
        try:
            bench.define(symbol, body)
        except InputError as error:
            raise InputError(f"{name}: [symbols] {symbol}: {error}", place=stands[symbol]) from None


def _judged(name: str, claim: Claim, benches: dict[str, Evidence]) -> Verdict:
    kind = claim.get("kind")
    if not isinstance(kind, str) or kind not in JUDGES:
        near = difflib.get_close_matches(str(kind), JUDGES, 1)
        hint = f"; did you mean {near[0]!r}?" if near else "."
        raise InputError(
            f"{name}: claim {claim.id}: kind = {keys.shown(kind)} is not known{hint} Kinds are {', '.join(JUDGES)}.",
            claim=claim.id,
            key="kind",
        )
    judge = JUDGES[kind]
    place = f"{name}: claim {claim.id} ({kind})"
    keys.only_known(claim.keys, ALWAYS | judge.needs | judge.may, place)
    for key in judge.needs:
        if key not in claim:
            raise InputError(
                f"{name}: claim {claim.id} ({kind}) lacks the key {key!r}; it needs {', '.join(sorted(judge.needs))}",
                claim=claim.id,
            )
    keys.look(claim.keys, {**keys.CLAIM, **judge.own}, place, claim.id)
    which = claim.get("arm", next(iter(benches)))
    if which not in benches:
        raise InputError(
            f"{name}: claim {claim.id} names the arm {keys.shown(which)}; the file has {', '.join(benches)}",
            claim=claim.id,
            key="arm",
        )
    try:
        return judge.judge(benches[which], claim)
    except FormulaError as error:
        raise FormulaError(f"{name}: claim {claim.id}: {error}", **{**error.data, "claim": claim.id}) from None
    except InputError as error:
        message = str(error)
        place = "" if message.startswith("claim ") else f"claim {claim.id}: "
        raise InputError(f"{name}: {place}{message}", **{**error.data, "claim": claim.id}) from None


def _read(source: str | os.PathLike[str]) -> tuple[str, str]:
    if isinstance(source, str) and ("\n" in source or ("=" in source and not os.path.isfile(source))):
        return "claims", source
    path = arguments.file(source)
    try:
        if path.is_dir():
            raise InputError(f"{path}: this is a folder; name a claims file")
        if path.stat().st_size > MAX_BYTES:
            raise InputError(f"{path}: {path.stat().st_size:,} bytes; a claims file has at most {MAX_BYTES:,}")
        return path.name, path.read_text(encoding="utf-8")
    except UnicodeDecodeError:
        raise InputError(f"{path}: this is not a text file in UTF-8") from None
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror or error}") from None


def _symbols(data: dict[str, Any], arm: str) -> dict[str, str]:
    """Return the file's symbols; a table inside [symbols] belongs to the arm of its name only."""
    out = {}
    for name, body in data.get("symbols", {}).items():
        if isinstance(body, dict):
            out.update(body if name == arm else {})
        else:
            out[name] = body
    return out


def _arms(name: str, data: dict[str, Any], given: Described | None) -> dict[str, ArmModel]:
    if given is not None:
        d = given.description
        solver = Solver(given.plan_for) if d.coupling is None else Solver.of(d.by_axes())
        return {"arm": model_from_description(d, solver)}
    tables = data.get("arms") or ({"arm": data["arm"]} if "arm" in data else {})
    if not tables:
        raise InputError(
            f'{name}: no arm is named; write [arm] with name = "denso-vp6242", or file, or a DH table in rows'
        )
    group = ("arms",) if "arms" in data else ()
    out = {}
    for key, table in tables.items():
        with standing(*group, key):
            out[key] = read_arm(f"{name}: [{'.'.join((*group, key))}]", table)
    return out


def _own_words(data: dict[str, Any], key: str) -> str:
    table = data.get("arms", {}).get(key) or data.get("arm") or {}
    return table.get("words", "")
