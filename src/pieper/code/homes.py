"""Under which truths each value of a program is asked for: a row that does not exist then costs no arctangent.

Every value is asked for under truths: those of a row that holds, of a doubt that counts, of a choice. A value's home is
what all that ask for it agree on.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from pieper.code.program import SLOW, Program

#: A choice is made with `if` where that spares an operation that takes its time, or so many others.
_SPARED = 6
Path = tuple[int, ...]


def common(a: Path, b: Path) -> Path:
    """Return how two paths begin alike."""
    k = 0
    while k < min(len(a), len(b)) and a[k] == b[k]:
        k += 1
    return a[:k]


class Homes:
    """Under which truths each value is asked for.

    Attributes:
        home: Node, or loop (their numbers follow the nodes'), -> path.
        ends: (path, what is done there): ("row", m) or ("doubt", node).
        alike: Choices that are made already where they stand -> what is chosen.
        guarded: Choices that are made with `if` -> path of what is chosen then.
    """

    def __init__(self, program: Program, plain: set[int]) -> None:
        self.program, self.plain = program, plain
        self.loops = len(program.nodes)
        self.bodies = {i for loop in program.loops for i in loop.body}
        self.home: dict[int, Path] = {}
        self.ends: list[tuple[Path, tuple[str, int]]] = []
        self.alike: dict[int, int] = {}
        self.guarded: dict[int, Path] = {}
        for m, valid in enumerate(program.valid):
            if program.nodes[valid][0] != "false":
                path = self._under((), self.conjuncts(valid))
                self.ends.append((path, ("row", m)))
                for i in program.q[6 * m : 6 * m + 6]:
                    self._ask(i, path)
        for term in self._terms(program.unclear):
            atoms = self.conjuncts(term)
            path = self._under((), atoms[:-1])
            if atoms:
                self._ask(atoms[-1], path)
            self.ends.append((path, ("doubt", atoms[-1] if atoms else term)))
        for i in reversed(program.order):
            if i in self.home and i not in self.bodies:
                self._pass_on(i)

    def loop_behind(self, i: int) -> int | None:
        """Return the loop that leaves a node, if one does."""
        op, loop = self.program.nodes[i][:2]
        return self.loops + loop if op == "after" else None

    def arguments(self, i: int) -> tuple[int, ...]:
        """Return what a node, or a loop, is made of; leaves left out."""
        program = self.program
        if i >= self.loops:
            loop = program.loops[i - self.loops]
            given: Sequence[int] = [*loop.start, *program.invariants(loop)]
        else:
            loop_behind = self.loop_behind(i)
            given = program.arguments(i) if loop_behind is None else (loop_behind,)
        return tuple(a for a in given if a >= self.loops or self._is_value(a))

    def _is_value(self, i: int) -> bool:
        return self.program.nodes[i][0] not in ("in", "const", "true", "false", "carry")

    def conjuncts(self, i: int) -> list[int]:
        """Return the truths that make one, in the order in which they are found."""
        seen: set[int] = set()
        waiting = [i]
        while waiting:
            k = waiting.pop()
            if self.program.nodes[k][0] == "and":
                waiting += self.program.arguments(k)
            elif self.program.nodes[k][0] != "true":
                seen.add(k)
        return sorted(seen)

    def _terms(self, i: int) -> list[int]:
        if self.program.nodes[i][0] != "or":
            return [] if self.program.nodes[i][0] == "false" else [i]
        return [term for a in self.program.arguments(i) for term in self._terms(a)]

    def _under(self, path: Path, atoms: Sequence[int]) -> Path:
        for atom in atoms:
            if atom not in path:
                self._ask(atom, path)
                path = (*path, atom)
        return path

    def _ask(self, i: int, path: Path) -> None:
        if i >= self.loops or self._is_value(i):
            self.home[i] = common(self.home[i], path) if i in self.home else path

    def _pass_on(self, i: int) -> None:
        path, arguments = self.home[i], self.program.arguments(i)
        if self.program.nodes[i][0] != "select":
            for a in self.arguments(i):
                self._ask(a, path)
                if a >= self.loops:  # what a loop carries has its names for all that follows
                    self.home[a] = ()
                    for given in self.arguments(a):
                        self._ask(given, ())
            return
        truth, then, other = arguments
        atoms = [a for a in self.conjuncts(truth) if a not in path]
        if not atoms:
            self.alike[i] = then
            self._ask(then, path)
            return
        self._ask(other, path)
        if i in self.plain:
            self._ask(truth, path)
            self._ask(then, path)
        else:
            self.guarded[i] = self._under(path, atoms)
            self._ask(then, self.guarded[i])


def homes_of(program: Program) -> Homes:
    """Return where values are found; choices that spare little are made between values that are there."""
    plain: set[int] = set()
    while True:
        homes = Homes(program, plain)
        spared: Counter[Path] = Counter()
        for i, path in homes.home.items():
            weight = _SPARED if i >= homes.loops or program.nodes[i][0] in SLOW else 1
            for k in range(len(path) + 1):
                spared[path[:k]] += weight
        dear = {i for i, path in homes.guarded.items() if spared[path] < _SPARED}
        if not dear:
            return homes
        plain |= dear
