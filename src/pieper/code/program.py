"""A closed form as a list of operations: the kernel itself, run once with a number type that records."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, cast

from pieper import _code
from pieper.errors import PlanError
from pieper.solver.plan.plan import Plan

#: The families whose straight road has no loop that a value ends.
RECORDED = ("spherical_wrist_parallel", "spherical_wrist", "three_parallel")
#: Operations that give a truth, not a number.
TRUTHS = ("lt", "le", "gt", "ge", "eq", "ne", "and", "or", "not")
_LEAVES = ("in", "const", "true", "false")


@dataclass(frozen=True)
class Program:
    """The operations that lead from a pose to its rows, in order, without those that lead nowhere.

    Args:
        nodes: (operation, a, b, c, value) by number; a, b, c are numbers of nodes, of "in" the entry of the pose.
        order: The numbers of the nodes that are needed, leaves left out.
        q: 8 times 6 numbers of nodes, rad or m.
        valid: 8 numbers of nodes, truths.
        unclear: A truth: the straight road cannot vouch for its rows.
    """

    nodes: tuple[tuple[str, int, int, int, float], ...]
    order: tuple[int, ...]
    q: tuple[int, ...]
    valid: tuple[int, ...]
    unclear: int


def recorded(plan: Plan) -> Program:
    """Return the program of a plan.

    Raises:
        PlanError: The arm's family cannot be recorded; the message says why.
    """
    name = plan.name
    if plan.family not in RECORDED:
        raise PlanError(
            f"{name} is solved by the family {plan.family!r}, an iteration that ends when its numbers say so: that is "
            f"no list of operations. Families that are: {', '.join(RECORDED)}. C++ and wasm take every "
            "family.",
            family=plan.family,
            allowed=RECORDED,
        )
    tape = _code.record(plan.family, cast("dict[str, Any]", plan.spec.geometry.__getstate__()))
    if tape is None:
        raise PlanError(
            f"{name}: the straight road is closed to this geometry, it is solved pose by pose with care. C++ and wasm "
            "take it."
        )
    nodes, q, valid, unclear = tape
    return Program(tuple(nodes), _needed(nodes, [*q, *valid, unclear]), tuple(q), tuple(valid), unclear)


def _needed(nodes: list[tuple[str, int, int, int, float]], ends: list[int]) -> tuple[int, ...]:
    seen: set[int] = set()
    waiting = list(ends)
    while waiting:
        i = waiting.pop()
        if i in seen or i < 0:
            continue
        seen.add(i)
        if nodes[i][0] not in _LEAVES:
            waiting += nodes[i][1:4]
    return tuple(i for i in sorted(seen) if nodes[i][0] not in _LEAVES)


def statements(
    program: Program,
    words: Mapping[str, str],
    entry: Callable[[int], str],
    assign: Callable[[str, bool, str], str],
) -> tuple[list[str], Callable[[int], str]]:
    """Return the program's lines in a language, and how a node is said there.

    Args:
        program: What is written.
        words: An operation -> how it is said, with {0} {1} {2} for its arguments.
        entry: Says an entry (0 to 15, row by row) of the pose.
        assign: Takes a name, whether it is a truth, and an expression.
    """
    names = {i: f"v{_short(k)}" for k, i in enumerate(program.order)}

    def said(i: int) -> str:
        op, a, _, _, value = program.nodes[i]
        if op == "const":
            return repr(value) if value >= 0 else f"({value!r})"
        if op == "in":
            return entry(a)
        return words[op] if op in ("true", "false") else names[i]

    lines = []
    for i in program.order:
        op, *arguments, _ = program.nodes[i]
        text = words[op].format(*(said(a) if a >= 0 else "" for a in arguments))
        lines.append(assign(names[i], op in TRUTHS, text))
    return lines, said


def _short(number: int) -> str:
    """Return a number in few signs, none of them a small letter: no word of a language ends so."""
    first, last = divmod(number, 36)
    return ("" if not first else _short(first)) + "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ"[last]
