"""A sum of products written as a person would factor it: nested along the chain, the shortest of three nestings."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from pieper.algebra.expression import ONE, Expr, Num, Power, Sym, Trig, add, mul

Order = Callable[[Any, int], Any]


def shortest(rows: list) -> Expr:
    """The shortest nesting of rows (number, [symbols and functions])."""
    forms = [_nest(rows, order) for order in (_first_joint_first, _most_common_first, _last_joint_first)]
    return min(forms, key=_operations)


def whole(value: Any) -> int | Fraction:
    """Integers as int: sums of them are many times faster than of fractions."""
    return value.numerator if value.denominator == 1 else value


def _first_joint_first(atom: Sym | Trig, count: int) -> tuple[Any, ...]:
    return (atom.rank != 3, atom.order)


def _most_common_first(atom: Sym | Trig, count: int) -> tuple[Any, ...]:
    return (-count, atom.rank != 3, atom.order)


def _last_joint_first(atom: Sym | Trig, count: int) -> tuple[Any, ...]:
    return (atom.rank != 3, -atom.group if isinstance(atom, Trig) else 0, atom.order)


def _nest(rows: list, order: Order) -> Expr:
    if len(rows) == 1:
        value, atoms = rows[0]
        return _product(value, atoms)
    shared = list(rows[0][1])
    for _, atoms in rows[1:]:
        remaining = list(atoms)
        kept = []
        for atom in shared:
            if atom in remaining:
                remaining.remove(atom)
                kept.append(atom)
        shared = kept
    sizes = {abs(value) for value, _ in rows}
    content = sizes.pop() if len(sizes) == 1 else 1
    if all(value < 0 for value, _ in rows):
        content = -content
    if shared or content != 1:
        inner = [(whole(Fraction(value) / content), _without(atoms, shared)) for value, atoms in rows]
        body = _nest(inner, order)
        return _product(content, shared, body)
    counts: dict = {}
    for _, atoms in rows:
        for atom in dict.fromkeys(atoms):
            counts[atom] = counts.get(atom, 0) + 1
    candidates = [atom for atom, count in counts.items() if count > 1]
    if not candidates:
        return add(*(_product(v, a) for v, a in sorted(rows, key=_reading_order)))
    pivot = min(candidates, key=lambda atom: order(atom, counts[atom]))
    first = [row for row in rows if pivot in row[1]]
    rest = [row for row in rows if pivot not in row[1]]
    parts = [(min(map(_reading_order, first)), _nest(first, order))]
    if rest:
        inner = _nest(rest, order)
        parts.append((min(map(_reading_order, rest)), inner))
    return add(*(part for _, part in sorted(parts, key=lambda item: item[0])))


def _reading_order(row: Any) -> tuple[Any, ...]:
    """Lengths without angles first, then along the chain, cosine before sine."""
    _, atoms = row
    functions = [a for a in atoms if a.rank == 3]
    targets = [a for a in atoms if a.rank == 4]
    lengths = [a for a in atoms if a.rank not in (3, 4)]
    return (
        bool(lengths) and bool(targets),
        [(a.order[1:]) if isinstance(a, Trig) else (99, 0) for a in functions],
        [a.order[1:] for a in targets],
        [a.order for a in lengths],
    )


def _without(atoms: list, shared: list) -> list:
    rest = list(atoms)
    for atom in shared:
        rest.remove(atom)
    return rest


def _product(value: int | Fraction, atoms: list, body: Expr | None = None) -> Expr:
    ordered = sorted(atoms, key=lambda a: (a.rank, a.order))
    factors, index = [], 0
    while index < len(ordered):
        power = ordered.count(ordered[index])
        factors.append(ordered[index] if power == 1 else ordered[index] ** power)
        index += power
    if body is not None and body != ONE:
        factors.append(body)
    return mul(Num(value), *factors)


def _operations(expr: Expr) -> int:
    parts = expr.args[:1] if isinstance(expr, Power) else expr.args
    return len(parts) + sum(map(_operations, parts))
