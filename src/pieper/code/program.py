"""A closed form as a list of operations: the kernel itself, run once with a number type that records."""

from __future__ import annotations

import re
from collections import Counter
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
#: How tightly a sign holds the values beside it; a truth's signs hold nothing, a value alone or in brackets is whole.
_HOLDS = {"add": 1, "sub": 1, "mul": 2, "div": 2, "neg": 2}
_WHOLE = 3
#: How tightly an argument must hold together beside a sign that is none of arithmetic.
_ASKS = {"and": _WHOLE, "or": _WHOLE, "not": _WHOLE}
#: Operations that take their time: a choice does not wait for them, it is made between values that are there.
_SLOW = ("div", "sqrt", "sin", "cos", "atan2", "angle")
#: A value that is used once is written where it is used, up to so many signs.
_INSIDE = 90


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
    used = Counter(a for i in program.order for a in program.nodes[i][1:4])
    used.update((*program.q, *program.valid, program.unclear) * 2)
    chosen = {a for i in program.order if program.nodes[i][0] == "select" for a in program.nodes[i][2:4]}
    inside: dict[int, tuple[str, int]] = {}
    slow: set[int] = set()
    names: dict[int, str] = {}

    def held(i: int) -> tuple[str, int]:
        """Return a node as text, and how tightly that holds together."""
        op, a, _, _, value = program.nodes[i]
        if op == "const":
            return (repr(value) if value >= 0 else f"({value!r})"), _WHOLE
        if op == "in":
            return entry(a), _WHOLE
        if op in ("true", "false"):
            return words[op], _WHOLE
        return inside.get(i) or (names[i], _WHOLE)

    lines: list[str] = []
    for i in program.order:
        op, *arguments, _ = program.nodes[i]
        given = [a for a in arguments if a >= 0]
        texts, apart = [], []
        for k, a in enumerate(given):
            text, holds = held(a)
            apart.append(re.search(rf"[(,] ?\{{{k}\}}[),]", words[op]) is not None)
            asked = 0 if apart[k] else _HOLDS[op] + (k > 0) if op in _HOLDS else _ASKS.get(op, 1)
            texts.append(f"({text})" if holds < asked or (op == "neg" and text[0] == "-") else text)
        text = words[op].format(*texts)
        if op in _SLOW or not slow.isdisjoint(given):
            slow.add(i)
        if used[i] == 1 and len(text) <= _INSIDE and not (i in chosen and i in slow):
            inside[i] = text, _WHOLE if all(apart) else _HOLDS.get(op, 0)
        else:
            slow.discard(i)
            names[i] = f"v{_short(len(names))}"
            lines.append(assign(names[i], op in TRUTHS, text))
    return lines, lambda i: held(i)[0]


def _short(number: int) -> str:
    """Return a number in few signs, none of them a small letter: no word of a language ends so."""
    first, last = divmod(number, 36)
    return ("" if not first else _short(first)) + "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ"[last]
