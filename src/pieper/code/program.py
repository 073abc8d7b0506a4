"""A closed form as a list of operations: the kernel itself, run once with a number type that records."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, cast

from pieper import _code
from pieper.errors import PlanError
from pieper.solver.plan.plan import Plan

#: The families whose straight road has no loop that a value ends.
RECORDED = ("spherical_wrist_parallel", "spherical_wrist", "three_parallel")
#: Operations that give a truth, not a number.
TRUTHS = ("lt", "le", "gt", "ge", "eq", "ne", "and", "or", "not")
_LEAVES = ("in", "const", "true", "false", "carry")
#: How tightly a sign holds the values beside it; a truth's signs hold nothing, a value alone or in brackets is whole.
_HOLDS = {"add": 1, "sub": 1, "mul": 2, "div": 2, "neg": 2}
_WHOLE = 3
#: How tightly an argument must hold together beside a sign that is none of arithmetic.
_ASKS = {"and": _WHOLE, "or": _WHOLE, "not": _WHOLE}
#: Operations that take their time: a choice does not wait for them, it is made between values that are there.
SLOW = ("div", "sqrt", "sin", "cos", "atan2", "angle")
#: A value that is used once is written where it is used, up to so many signs.
_INSIDE = 90


Node = tuple[str, int, int, int, float]


@dataclass(frozen=True)
class Loop:
    """A step that is taken again and again, as long as something moves.

    Args:
        steps: How often at most.
        start: Numbers of the nodes that go in; inside they are called "carry", behind it "after" (loop, place).
        next: What one step makes of them.
        moving: A truth: whether to go on.
        body: The nodes that a step finds anew.
    """

    steps: int
    start: tuple[int, ...]
    next: tuple[int, ...]
    moving: int
    body: frozenset[int]


@dataclass(frozen=True)
class Program:
    """The operations that lead from a pose to its rows, in order, without those that lead nowhere.

    Args:
        nodes: (operation, a, b, c, value) by number; a, b, c are numbers of nodes, of "in" the entry of the pose.
        order: The numbers of the nodes that are needed, leaves left out.
        q: 8 times 6 numbers of nodes, rad or m.
        valid: 8 numbers of nodes, truths.
        unclear: A truth: the straight road cannot vouch for its rows.
        loops: The loops that "carry" and "after" speak of.
    """

    nodes: tuple[Node, ...]
    order: tuple[int, ...]
    q: tuple[int, ...]
    valid: tuple[int, ...]
    unclear: int
    loops: tuple[Loop, ...] = ()

    def arguments(self, i: int) -> tuple[int, ...]:
        """Return the nodes that a node is made of."""
        op, *given, _ = self.nodes[i]
        return () if op in _LEAVES or op == "after" else tuple(a for a in given if a >= 0)

    def invariants(self, loop: Loop) -> set[int]:
        """Return the nodes outside a loop that its steps look at."""
        seen = {a for i in loop.body for a in self.arguments(i)} | {*loop.next, loop.moving}
        return {i for i in seen - loop.body if self.nodes[i][0] not in _LEAVES}


def recorded(plan: Plan) -> Program:
    """Return the program of a plan.

    Raises:
        PlanError: The arm's family cannot be recorded; the message says why.
    """
    name = plan.name
    if plan.family not in RECORDED:
        raise PlanError(
            f"{name} is solved by the family {plan.family!r}, an iteration that ends when its numbers say so: that is "
            f"no list of operations. Families that are: {', '.join(RECORDED)}. C++ and wasm take every family: "
            "arm.code('c++', ...) writes one header for g++ and clang++, or 'wasm' what pages and Node run; on the "
            "command line, `pieper code ARM --to c++`.",
            family=plan.family,
            allowed=RECORDED,
        )
    tape = _code.record(plan.family, cast("dict[str, Any]", plan.spec.geometry.__getstate__()))
    if tape is None:
        raise PlanError(
            f"{name}: the straight road is closed to this geometry, it is solved pose by pose with care. C++ and wasm "
            "take it: arm.code('c++', ...) or arm.code('wasm', ...)."
        )
    nodes, q, valid, unclear, loops = tape
    return program_of(nodes, q, valid, unclear, loops)


def program_of(
    nodes: Sequence[Node],
    q: Sequence[int],
    valid: Sequence[int],
    unclear: int,
    loops: Sequence[tuple[int, list[int], list[int], int]],
) -> Program:
    """Return the program of a tape."""
    kept = [
        Loop(steps, tuple(start), tuple(after), moving, _body(nodes, k))
        for k, (steps, start, after, moving) in enumerate(loops)
    ]
    return Program(
        tuple(nodes), _needed(nodes, kept, [*q, *valid, unclear]), tuple(q), tuple(valid), unclear, tuple(kept)
    )


def _body(nodes: Sequence[Node], loop: int) -> frozenset[int]:
    """Return the nodes that hang on what a loop carries."""
    inside: set[int] = set()
    for i, (op, *given, _) in enumerate(nodes):
        if op == "carry":
            if given[0] == loop:
                inside.add(i)
        elif op not in _LEAVES and op != "after" and not inside.isdisjoint(given):
            inside.add(i)
    return frozenset(inside)


def _needed(nodes: Sequence[Node], loops: Sequence[Loop], ends: list[int]) -> tuple[int, ...]:
    seen: set[int] = set()
    waiting = list(ends)
    while waiting:
        i = waiting.pop()
        if i in seen or i < 0:
            continue
        seen.add(i)
        op, *given, _ = nodes[i]
        if op == "after":
            loop = loops[given[0]]
            waiting += [*loop.start, *loop.next, loop.moving]
        elif op not in _LEAVES:
            waiting += given
    return tuple(i for i in sorted(seen) if nodes[i][0] not in _LEAVES)


class Words:
    """A program's nodes as texts of a language: what is used once is written where it is used, the rest has names.

    Args:
        program: What is written.
        words: An operation -> how it is said, with {0} {1} {2} for its arguments.
        entry: Says an entry (0 to 15, row by row) of the pose.
        used: How often each node is used; None: as the program says, what it ends with under names.
    """

    def __init__(
        self,
        program: Program,
        words: Mapping[str, str],
        entry: Callable[[int], str],
        used: Counter[int] | None = None,
    ) -> None:
        self.program, self.words, self.entry = program, words, entry
        if used is None:
            used = Counter(a for i in program.order for a in program.arguments(i))
            used.update((*program.q, *program.valid, program.unclear) * 2)
        self.used = used
        for loop in program.loops:
            # what a step needs of outside is found once; what it leaves is given on when all of it is known
            used.update(loop.start)
            used.update([*program.invariants(loop), *loop.next, loop.moving] * 2)
        self.chosen = {a for i in program.order if program.nodes[i][0] == "select" for a in program.nodes[i][2:4]}
        self.names: dict[int, str] = {}
        self._inside: dict[int, tuple[str, int]] = {}
        self._slow: set[int] = set()

    def name(self, i: int) -> str:
        """Return a new name for a node."""
        self.names[i] = f"v{_short(len(self.names))}"
        return self.names[i]

    def put(self, i: int) -> tuple[str, bool, str] | None:
        """Say a node, after those it is made of: its name, whether it is a truth, its text; None if it has no name."""
        program = self.program
        op = program.nodes[i][0]
        if op == "after":
            loop, place = program.nodes[i][1:3]
            self.names[i] = self.carried(loop, place)
            return None
        given = program.arguments(i)
        text, holds = self._expression(op, given)
        if op in SLOW or not self._slow.isdisjoint(given):
            self._slow.add(i)
        if self.used[i] == 1 and len(text) <= _INSIDE and not (i in self.chosen and i in self._slow):
            self._inside[i] = text, holds
            return None
        self._slow.discard(i)
        return self.name(i), op in TRUTHS, text

    def put_as(self, i: int, same: int) -> None:
        """Say a node as another one is said."""
        self._inside[i] = self._held(same)

    def carried(self, loop: int, place: int) -> str:
        """Return how what a loop carries is called."""
        return f"w{_short(loop)}_{_short(place)}"

    def text(self, i: int) -> str:
        """Return a node as it is said."""
        return self._held(i)[0]

    def _expression(self, op: str, given: Sequence[int]) -> tuple[str, int]:
        texts, apart = [], []
        for k, a in enumerate(given):
            text, holds = self._held(a)
            apart.append(re.search(rf"[(,] ?\{{{k}\}}[),]", self.words[op]) is not None)
            asked = 0 if apart[k] else _HOLDS[op] + (k > 0) if op in _HOLDS else _ASKS.get(op, 1)
            texts.append(f"({text})" if holds < asked or (op == "neg" and text[0] == "-") else text)
        return self.words[op].format(*texts), _WHOLE if all(apart) else _HOLDS.get(op, 0)

    def _held(self, i: int) -> tuple[str, int]:
        """Return a node as text, and how tightly that holds together."""
        op, a, b, _, value = self.program.nodes[i]
        if op == "const":
            return (repr(value) if value >= 0 else f"({value!r})"), _WHOLE
        if op == "in":
            return self.entry(a), _WHOLE
        if op == "carry":
            return self.carried(a, b), _WHOLE
        if op in ("true", "false"):
            return self.words[op], _WHOLE
        return self._inside.get(i) or (self.names[i], _WHOLE)


def statements(
    words: Words,
    assign: Callable[[str, bool, str], str],
    loop_around: Callable[[LoopWords], list[str]],
) -> list[str]:
    """Return the program's lines in a language.

    Args:
        words: The program, and how its nodes are said.
        assign: Takes a name, whether it is a truth, and an expression.
        loop_around: Makes lines of a loop.
    """
    program = words.program
    bodies = {i for loop in program.loops for i in loop.body}
    lines: list[str] = []
    done: set[int] = set()
    for i in program.order:
        if i in bodies:
            continue
        loop = program.nodes[i][1]
        if program.nodes[i][0] == "after" and loop not in done:
            done.add(loop)
            lines += loop_around(loop_words(words, loop, assign))
        said = words.put(i)
        if said is not None:
            lines.append(assign(*said))
    return lines


@dataclass(frozen=True)
class LoopWords:
    """What a language says of a loop: the names of what it carries, how they start, a step's lines, what it leaves."""

    steps: int
    names: list[str]
    start: list[str]
    lines: list[str]
    next: list[str]
    moving: str


def loop_words(words: Words, number: int, assign: Callable[[str, bool, str], str]) -> LoopWords:
    """Return the words of a loop, whose invariants are said already."""
    program = words.program
    loop = program.loops[number]
    start = [words.text(i) for i in loop.start]
    lines = []
    for i in program.order:
        if i in loop.body:
            said = words.put(i)
            if said is not None:
                lines.append(assign(*said))
    names = [words.carried(number, k) for k in range(len(start))]
    # given on one after the other
    assert all(program.nodes[i][0] != "carry" for i in loop.next)
    return LoopWords(loop.steps, names, start, lines, [words.text(i) for i in loop.next], words.text(loop.moving))


def _short(number: int) -> str:
    """Return a number in few signs, none of them a small letter: no word of a language ends so."""
    first, last = divmod(number, 36)
    return ("" if not first else _short(first)) + "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ"[last]
