"""Numbers of a robot file's tables: the unit in the key, one key a quantity, finite unless said otherwise."""

from __future__ import annotations

import math
from collections.abc import Iterable

from pieper.description.place import Place, kind_of
from pieper.description.quantity import UNITS, UNITS_OF, ExpressionError, evaluate
from pieper.words_by_number import plural


def quantity(table: dict, stem: str, kind: str, place: Place, default: float | None = None) -> float:
    """Return a length or angle of a table, SI; without a default one of its keys must be there."""
    key, unit = one_key(table, stem, UNITS_OF[kind], place, required=default is None)
    if key is None:
        return 0.0 if default is None else default
    return number(table[key], unit, place, key)


def one_key(table: dict, stem: str, units: Iterable[str], place: Place, required: bool) -> tuple[str | None, str]:
    """Return the key of this stem that the table has, and its unit; two of them, or a missing one, are refused."""
    keys = {f"{stem}_{unit}": unit for unit in units}
    present = [key for key in keys if key in table]
    if len(present) > 1:
        place.fail(f"{' and '.join(present)} say the same thing twice; keep one.", present[-1], given=present)
    if present:
        return present[0], keys[present[0]]
    if required:
        place.fail(f"the key for {stem} is missing: give {' or '.join(keys)}.", None, missing=stem, allowed=list(keys))
    return None, ""


def needed_key(table: dict, stem: str, units: Iterable[str], place: Place) -> tuple[str, str]:
    """Return the key of this stem, which must be there, and its unit."""
    key, unit = one_key(table, stem, units, place, required=True)
    return key or "", unit


def number(value: object, unit: str, place: Place, key: str, *, infinite: bool = False, unknown: bool = False) -> float:
    """Return one number of a file in SI; unit "" leaves it alone. NaN only where it means unknown."""
    if isinstance(value, str):
        try:
            value = evaluate(value)
        except ExpressionError as error:
            place.fail(
                f"{value!r} is not a number: {str(error).rstrip('.')}. Expressions may use numbers, pi, sqrt( ), "
                "+ - * / ( ).",
                key,
                given=value,
            )
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        place.fail(f"must be a number, got {kind_of(value)}.", key, given=value)
    try:
        value = float(value)
    except OverflowError:
        place.fail("the number is too large.", key)
    if math.isnan(value) and not unknown:
        place.fail("nan is not allowed here; give a number.", key, given=value)
    if math.isinf(value) and not infinite:
        place.fail("an infinite number is not allowed here.", key, given=value)
    return UNITS[unit][1](value) if unit else value


def numbers(value: object, unit: str, count: int, place: Place, key: str, **allowed: bool) -> list[float]:
    """Return a list of `count` numbers in SI."""
    if not isinstance(value, list) or len(value) != count:
        place.fail(f"must be a list of {plural(count, 'number')}, got {kind_of(value)}.", key, given=value)
    return [number(item, unit, place, key, **allowed) for item in value]
