"""What the keys of a claims file may hold.

Everything is looked at before a judge begins, so that no judge meets a list where it expects a text.

A `Check` looks at one value: it returns "" when the value will do, and otherwise what it must be.
"""

from __future__ import annotations

import difflib
import math
from collections.abc import Callable, Collection, Mapping
from typing import Any

from pieper.errors import InputError
from pieper.tolerances import MAX_SIZE, TINY

Check = Callable[[Any], str]
UNITS = {"m": 1.0, "mm": 0.001, "cm": 0.01}
MAX_DIGITS = 60  # of a printed number; arithmetic here has 50


def only_known(table: Any, allowed: Collection[str], what: str) -> None:
    """Refuse keys that mean nothing, and what is no table."""
    if not isinstance(table, dict):
        raise InputError(f"{what} must be a table of keys and values, not {shown(table)}")
    for key in table:
        if key not in allowed:
            near = difflib.get_close_matches(key, allowed, 1)
            hint = f"; did you mean {near[0]!r}?" if near else "."
            keys = ", ".join(sorted(allowed))
            raise InputError(f"{what}: the key {key!r} is not known{hint} Keys are {keys}.", key=key)


def look(table: Mapping[str, Any], checks: Mapping[str, Check], what: str, claim: str = "") -> None:
    """Look at every key of a table that has a check; `what` names the place.

    Raises:
        InputError: A value is not what its key needs; the message says where, what was given and what is allowed.
    """
    for key, check in checks.items():
        if key in table:
            wrong = check(table[key])
            if wrong:
                more = {"claim": claim} if claim else {}
                raise InputError(f"{what}: {key} must be {wrong}; it is {shown(table[key])}", key=key, **more)


def shown(value: Any) -> str:
    """A value as a message can hold it."""
    text = repr(value)
    return text if len(text) <= 80 else text[:77] + "..."


# -- single values -------------------------------------------------------------------------------------------
def text(value: Any) -> str:
    """A text in quotes."""
    return "" if isinstance(value, str) else "a text in quotes"


def name(value: Any) -> str:
    """A text that is not empty."""
    return "" if isinstance(value, str) and value.strip() else "a name in quotes"


def finite(value: Any) -> str:
    """A plain number."""
    good = isinstance(value, (int, float)) and not isinstance(value, bool) and abs(value) <= MAX_SIZE
    return "" if good else f"a number, no larger than {MAX_SIZE:g}"


def whole(value: Any) -> str:
    """A whole number."""
    return "" if isinstance(value, int) and not isinstance(value, bool) else "a whole number"


def flag(value: Any) -> str:
    """True or false."""
    return "" if isinstance(value, bool) else "true or false"


def formula(value: Any) -> str:
    """A formula: a text, or a number."""
    return "" if isinstance(value, str) or not finite(value) else "a formula in quotes, or a number"


def printed(value: Any) -> str:
    """A printed number: a number, or a text of digits."""
    wanted = f'a number, or its digits in quotes as in "0.5370", no larger than {MAX_SIZE:g}'
    if not isinstance(value, str):
        return wanted if finite(value) else ""
    digits = value.strip().replace("\u2212", "-")
    try:
        size = float(digits)
    except ValueError:
        return wanted
    if not math.isfinite(size) or abs(size) > MAX_SIZE or len(digits) > MAX_DIGITS or "_" in digits:
        return wanted
    return wanted if size and abs(size) < TINY else ""


def blank_or_printed(value: Any) -> str:
    """A printed number, or nothing."""
    return "" if isinstance(value, str) and value.strip() in ("", "*") else printed(value)


def quantity(value: Any) -> str:
    """A number, or a text that may be a formula with a unit."""
    return "" if isinstance(value, str) and value.strip() else printed(value)


# -- lists and tables ----------------------------------------------------------------------------------------
def one_of(*allowed: str) -> Check:
    """One of some words."""
    return lambda v: "" if isinstance(v, str) and v in allowed else "one of " + ", ".join(map(repr, allowed))


def several(each: Check, count: int | None = None, *, plural: str = "") -> Check:
    """A list, not empty, of so many values."""

    def check(value: Any) -> str:
        size = "" if count is None else f" of {count}"
        wanted = f"a list{size}" + (f", {plural}" if plural else "")
        if not isinstance(value, list) or not value or (count is not None and len(value) != count):
            return wanted
        for k, one in enumerate(value):
            wrong = each(one)
            if wrong:
                return f"{wanted}; its entry {k + 1}, {shown(one)}, must be {wrong}"
        return ""

    return check


def either(*checks: Check) -> Check:
    """What one of some checks takes."""

    def check(value: Any) -> str:
        said = [c(value) for c in checks]
        return "" if "" in said else ", or ".join(said)

    return check


def table_of(each: Check, *, size: int = 1) -> Check:
    """A table of `size` entries at least."""

    def check(value: Any) -> str:
        if not isinstance(value, dict) or len(value) < size:
            return "a table, as in { theta5 = .. }"
        for key, one in value.items():
            wrong = each(one)
            if wrong:
                return f"a table; its {key} = {shown(one)} must be {wrong}"
        return ""

    return check


def table(needs: Mapping[str, Check], may: Mapping[str, Check] | None = None) -> Check:
    """A table with known keys."""
    known = {**needs, **(may or {})}

    def check(value: Any) -> str:
        keys = f"a table with {', '.join(needs)}" + (f", perhaps {', '.join(may)}" if may else "")
        if not isinstance(value, dict):
            return keys
        for key in needs:
            if key not in value:
                return f"{keys}; {key} is missing"
        for key, one in value.items():
            if key not in known:
                return f"{keys}; {key!r} is not known"
            wrong = known[key](one)
            if wrong:
                return f"{keys}; its {key} = {shown(one)} must be {wrong}"
        return ""

    return check


def interval(value: Any) -> str:
    """Two numbers, the lower first."""
    wrong = several(finite, 2, plural="[lower, upper]")(value)
    return wrong or ("" if value[0] < value[1] else "[lower, upper], the lower one first")


def grid(value: Any) -> str:
    """A printed matrix; an entry is a number or blank."""
    wrong = several(several(lambda _: ""), plural="the rows of a matrix")(value)
    for r, row in enumerate([] if wrong else value):
        for c, one in enumerate(row):
            if blank_or_printed(one):
                return f"a list of rows; its entry ({r + 1},{c + 1}), {shown(one)}, must be {blank_or_printed(one)}"
    return wrong


def nothing(value: Any) -> str:
    """An empty list."""
    return "" if value == [] else "an empty list"


UNIT = one_of(*UNITS)
TASK = one_of("pose", "position", "position+axis")
JOINTS = several(quantity, plural="one value a joint")
POINT = several(printed, 3, plural="x, y and z")
GRID = grid
WHERE = table_of(formula, size=0)
DEGREES = table_of(finite, size=0)
STEP = table({"is": either(formula, several(formula))}, {"joint": whole, "for": name, "where": WHERE})

#: Every key of a claim, whatever its kind; `is` differs and stands with the kinds.
CLAIM: dict[str, Check] = {
    "id": either(name, whole),
    "kind": name,
    "says": text,
    "arm": name,
    "of": name,
    "where": WHERE,
    "frame": name,
    "at_deg": DEGREES,
    "when": name,
    "task": TASK,
    "joint": whole,
    "for": name,
    "q": JOINTS,
    "q_deg": JOINTS,
    "q_rad": JOINTS,
    "matrix": GRID,
    "position": POINT,
    "rounded": flag,
    "complete": flag,
    "solutions_deg": several(JOINTS, plural="the joint vectors"),
    "count": whole,
    "at_most": flag,
    "dof": whole,
    "free": either(several(whole, plural="the numbers of joints"), nothing),
    "percent": table_of(printed),
    "within": finite,
    "search_zeros": several(whole, plural="the numbers of joints"),
    "range_deg": interval,
    "between": interval,
    "values_deg": several(printed),
    "path": table({"from": several(finite, 3), "to": several(finite, 3)}, {"n": whole}),
    "value": printed,
    "unit": UNIT,
    "steps": several(STEP, plural="the steps of a method"),
}

FORMULAS = either(formula, several(formula, plural="the formulas of the branches"))
ROW_NUMBERS = several(whole, plural="row numbers of the Jacobian, 1 to 6")
ANGLE_UNIT = one_of("deg", "rad")
ANY_MATRIX = several(either(several(formula), formula), plural="the rows of a matrix of formulas")
FORMULA_OR_MATRIX = either(formula, ANY_MATRIX)
TOGETHER = table_of(formula)
ERROR_ROWS = several(table({"reference": several(printed), "simulation": several(printed)}), plural="rows")
POSITION_ROWS = several(table({"position": POINT}, {"q": JOINTS, "q_deg": JOINTS, "q_rad": JOINTS}), plural="rows")
NUMBER_UNIT = one_of(*UNITS, "deg", "rad", "%")

SYMBOLS = table_of(either(formula, table_of(formula, size=0)), size=0)
FILE: dict[str, Check] = {
    "title": text,
    "source": text,
    "notes": text,
    "found": text,
    "seconds": finite,
    "arm": table_of(lambda _: ""),
    "arms": table_of(table_of(lambda _: "")),
    "symbols": SYMBOLS,
    "matrices": table_of(several(several(formula), plural="the rows of a matrix"), size=0),
    "claim": several(table_of(lambda _: ""), plural="of [[claim]] tables"),
}
ARM: dict[str, Check] = {
    "name": name,
    "robot": name,
    "file": name,
    "words": text,
    "angles": one_of("joint", "table"),
    "taken_off": several(one_of("base", "tool"), plural="base or tool"),
    "convention": one_of("standard", "modified"),
    "length_unit": UNIT,
    "columns": several(name, 4, plural='the columns as printed, such as ["theta", "d", "a", "alpha"]'),
    "rows": several(several(either(formula, finite)), plural="one row a joint"),
    "values": table_of(finite, size=0),
    "base": several(several(finite, 4), 4, plural="the rows of a pose"),
    "tool": several(several(finite, 4), 4, plural="the rows of a pose"),
    "limits_deg": several(interval, plural="one [lower, upper] a joint"),
}
