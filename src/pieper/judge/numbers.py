"""Printed numbers: how many digits they carry, what rounding allows, and which single misprint explains a wrong one."""

from __future__ import annotations

from decimal import Decimal, InvalidOperation
from typing import Any

import numpy as np

from pieper.algebra.parser import parse
from pieper.errors import InputError
from pieper.judge.claim import Claim
from pieper.judge.keys import UNITS
from pieper.judge.keys import printed as not_printed
from pieper.judge.model import ArmModel
from pieper.words_by_number import plural

BLANK = ("", "*")  # an entry that claims nothing


def as_text(value: Any) -> str:
    """Return a number of a claims file as it was written (TOML floats keep their shortest form)."""
    if isinstance(value, bool) or not isinstance(value, (int, float, str)):
        raise InputError(f'{value!r} is not a number; write a number, or text to keep trailing zeros as in "0.5370"')
    return repr(value) if not isinstance(value, str) else value.strip().replace("\u2212", "-")


def read_number(value: Any) -> float:
    """Read a printed number."""
    try:
        return float(Decimal(as_text(value)))
    except InvalidOperation:
        raise InputError(f"{value!r} is not a number") from None


def last_digit(value: Any) -> float:
    """Return the size of one unit in the last printed digit: 0.01 for "2.06", 1 for "790"."""
    text = as_text(value)
    if isinstance(value, float) and value == int(value):
        return 1.0
    return float(Decimal(1).scaleb(_exponent(text)))


def _exponent(text: str) -> int:
    exponent = Decimal(text).as_tuple().exponent
    return exponent if isinstance(exponent, int) else 0


def cut_off(printed: Any, right: float) -> bool:
    """Whether every printed digit is one of the right number, the rest cut off and not rounded."""
    step, value = last_digit(printed), read_number(printed)
    return 0 <= (abs(right) - abs(value)) / step < 1 and (value * right > 0 or not value)


def misprint(printed: Any, right: float) -> str:
    """Return the one misprint that turns the right number into the printed one, "" when there is none."""
    if not_printed(printed):
        return ""  # a formula, as in solutions_deg = [["30 + 10"]], or a number with its unit
    text = as_text(printed)
    step = last_digit(printed)
    decimals = max(0, -_exponent(text))
    correct = f"{right:z.{decimals}f}"
    if cut_off(printed, right):
        return f"the last digit cut off, not rounded ({correct})"
    if abs(read_number(printed) - right) < step:
        return f"the last digit ({correct})"
    if abs(-read_number(printed) - right) <= 0.51 * step:
        return "a sign"
    for factor, words in ((1000.0, "millimetres for metres"), (0.001, "metres for millimetres")):
        if right and abs(read_number(printed) - factor * right) <= 0.51 * step * max(1.0, factor / 1000):
            return f"a factor of 1,000: {words} ({right:.6g})"
    if decimals == 0 and len(text.lstrip("-")) > 2 and _without_point(text, right):
        return f"the decimal point lost ({_without_point(text, right)})"
    a, b = text.lstrip("-").replace("+", ""), correct.lstrip("-")
    if a == b or (text[:1] == "-") != (correct[:1] == "-"):
        return ""
    if len(a) == len(b) and len(a) > 1:
        differ = [k for k in range(len(a)) if a[k] != b[k]]
        if len(differ) == 1:
            return f"one digit ({correct})"
        if (
            len(differ) == 2
            and differ[1] == differ[0] + 1
            and a[differ[0]] == b[differ[1]]
            and a[differ[1]] == b[differ[0]]
        ):
            return f"two digits exchanged ({correct})"
    more = f"{right:z.{decimals + 1}f}".lstrip("-")
    less = f"{right:z.{max(decimals - 1, 0)}f}".lstrip("-")
    for k in range(len(more)):
        if more[:k] + more[k + 1 :] == a:
            return f"a digit lost ({f'{right:z.{decimals + 1}f}'})"
    for k in range(len(a)):
        if a[:k] + a[k + 1 :] == less:
            return f"a digit too many ({f'{right:z.{max(decimals - 1, 0)}f}'})"
    return ""


def _without_point(text: str, right: float) -> str:
    """The right number with a whole number's digits, "" where no place of the point makes them its own."""
    for decimals in range(1, len(text.lstrip("-")) + 1):
        if f"{right:z.{decimals}f}".replace(".", "").lstrip("-0") == text.lstrip("-0") != "":
            return f"{right:z.{decimals}f}" if (right < 0) == text.startswith("-") else ""
    return ""


def read_joints(claim: Claim, model: ArmModel, key: str = "q") -> np.ndarray:
    """Read a joint vector (n,), rad or the unit of length, from ``q_deg``, ``q_rad`` or ``q`` with a unit an entry."""
    found = [k for k in (f"{key}_deg", f"{key}_rad", key) if k in claim]
    if len(found) != 1:
        raise claim.error(f'give the joints once, as {key}_deg = [..], {key}_rad = [..] or {key} = ["30 deg", ..]')
    values = claim[found[0]]
    if not isinstance(values, list) or len(values) != model.n:
        entries = plural(len(values), "entry", "entries") if isinstance(values, list) else "no entries"
        raise claim.error(f"{found[0]} has {entries}; the arm has {plural(model.n, 'joint')}", found[0])
    out = np.empty(model.n)
    for k, value in enumerate(values):
        if found[0] == key:
            if not isinstance(value, str) or not any(u in value for u in ("deg", "rad", "\u00b0", "pi", "mm", "m")):
                raise claim.error(
                    f'{key}[{k + 1}] = {value!r} has no unit; write "{value} deg" or "{value} rad", or use {key}_deg',
                    found[0],
                )
            out[k] = quantity(value)
        elif model.sliding(k + 1):
            out[k] = quantity(value) if isinstance(value, str) else float(value)
        else:
            formula = isinstance(value, str) and any(c in value for c in "pi/*(")
            angle = quantity(value) if formula else read_number(value)
            out[k] = np.radians(angle) if found[0].endswith("_deg") else angle
    if not np.all(np.isfinite(out)):
        raise claim.error(f"{found[0]} holds a value that is not finite", found[0])
    return out


def quantity(text: str) -> float:
    """Evaluate a constant formula with a unit: "180*25/98 deg", "pi/2 rad"; lengths stay in the unit they have."""
    return float(parse(text, {"mm", "m"}, 0).evaluate({"mm": 1.0, "m": 1.0}))


def unit_of(claim: Claim, model: ArmModel) -> str:
    """Return the unit of length of a claim, the arm's own where it says none."""
    unit = claim.get("unit", model.unit)
    if unit not in UNITS:
        raise claim.error(f"unit {unit!r} is not known; use one of {', '.join(UNITS)}", "unit")
    return unit


def digit_units(values: list[Any]) -> np.ndarray:
    """Return one unit of the last digit of each of some numbers that stand together; 0 for those given as formulas.

    A file's plain numbers lose their last zeros, so 250 beside 464.4252 has as many digits as that; text keeps its own.
    """
    own = [0.0 if isinstance(v, str) and any(c.isalpha() for c in v) else last_digit(v) for v in values]
    finest = min((unit for unit in own if unit), default=0.0)
    return np.array([unit if isinstance(v, str) else finest for v, unit in zip(values, own, strict=True)])


def joint_units(claim: Claim, model: ArmModel, key: str = "q") -> np.ndarray:
    """Return one unit of the last printed digit of each joint, in rad or the arm's unit of length."""
    found = next(k for k in (f"{key}_deg", f"{key}_rad", key) if k in claim)
    unit = digit_units(claim[found])
    turning = np.array([not model.sliding(k + 1) for k in range(model.n)])
    return np.where(turning, np.radians(unit), unit) if found.endswith("_deg") else unit


def read_matrix(claim: Claim, key: str = "matrix") -> list[list]:
    """Read a printed 4 by 4 (or 3 by 4, 3 by 3) matrix of numbers; "" marks an entry that is not claimed."""
    rows = claim.get(key)
    if not isinstance(rows, list) or not all(isinstance(r, list) for r in rows):
        raise claim.error(f"{key} must be a list of rows", key)
    shape = (len(rows), len(rows[0]) if rows else 0)
    if shape not in ((4, 4), (3, 4), (3, 3)) or any(len(r) != shape[1] for r in rows):
        raise claim.error(
            f"{key} has {len(rows)} rows of {', '.join(str(len(r)) for r in rows)} entries; a pose is 4 x 4 (or its "
            f"upper 3 x 4, or a 3 x 3 rotation)",
            key,
        )
    for r, row in enumerate(rows):
        for c, value in enumerate(row):
            if value not in BLANK:
                try:
                    read_number(value)
                except InputError as error:
                    raise claim.error(f"{key} entry ({r + 1},{c + 1}): {error}", key) from None
    return rows
