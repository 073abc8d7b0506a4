"""The target pose and its images: T seen from frames that are already known, with short names for long entries.

Once theta1 is known, A1^-1 T is as good a target as T was. Its entries get names (r_x, u_13, ...), each with a formula
in terms of the entries before, so that no later formula has to repeat them.
"""

from __future__ import annotations

from typing import Any

from pieper.algebra.expression import Sym
from pieper.algebra.harmonic import Poly
from pieper.equations.derivation.unknowns import Knowledge
from pieper.equations.table import inverse

COLUMNS = "noap"
#: Letters for named columns, in the order in which a derivation first shows them.
ROTATION_LETTERS, POSITION_LETTERS = "uvghe", "wrmzylb"


class Target:
    """The wanted pose as named columns.

    Args:
        product: product(i, j) -> A_{i+1} ... A_j as polynomials.
        n: Number of joints.
        knowledge: What is known so far (shared with the solver; it grows).
        given: Columns of T that the task gives, a subset of "noap".
    """

    def __init__(self, product: Any, n: int, knowledge: Knowledge, given: str = COLUMNS) -> None:
        self.product, self.n, self.knowledge, self.given = product, n, knowledge, given
        self.definitions: dict[Sym, Poly] = {}
        self.shown: set[Sym] = set()
        self._named_before: dict[Poly, Sym] = {}
        self.stages: set[tuple] = set()
        self.hidden: set[Sym] = {Sym(c, x, 4) for c in COLUMNS if c not in given for x in "xyz"}
        self._columns: dict[tuple, list[Poly]] = {}
        self.rotation_of: dict[Sym, tuple] = {}

    def usable(self, poly: Poly) -> bool:
        """Whether the polynomial needs only what the task gives."""
        return not (poly.atoms() & self.hidden)

    def matrix(self, i: int, j: int) -> list[list[Poly]]:
        """(A1..Ai)^-1 T (A_{j+1}..An)^-1 for known outer joints, as named entries."""
        columns = [self.column(i, j, c) for c in range(4)]
        last = [Poly(), Poly(), Poly(), Poly.number(1)]
        return [[columns[c][r] for c in range(4)] for r in range(3)] + [last]

    def column(self, i: int, j: int, c: int) -> list[Poly]:
        """One column of that matrix; the position (c = 3) also where only the position does not need joints i+1..j."""
        key = (i, j, c)
        if key not in self._columns:
            self._columns[key] = self._named(key, self._raw(i, j, c))
        return self._columns[key]

    def position_is_known(self, j: int) -> bool:
        """Whether the position of T (A_{j+1}..An)^-1 needs no unknown joint."""
        return all(self.knowledge.knows(p) for p in self._raw(0, j, 3))

    def inverse_position(self, i: int, j: int) -> list[Poly]:
        """Position of (A_{j+1}..An) T^-1 (A1..Ai): frame i's origin seen from frame j; outer joints j+1..n known."""
        key = (i, j, "inverse")
        if key not in self._columns:
            P, here = self.matrix(0, j), self.product(0, i) if i else None
            shift = [here[r][3] if here else Poly() for r in range(3)]
            raw = []
            for r in range(3):
                total = Poly()
                for k in range(3):
                    total = total + P[k][r] * (shift[k] - P[k][3])
                raw.append(total)
            self._columns[key] = self._named(key, raw)
        return self._columns[key]

    def shifted(self, i: int, j: int, column: list[Poly]) -> list[Poly]:
        """A position with known terms of the other side taken off, named."""
        key = (i, j, "shifted", *column)
        if key not in self._columns:
            count = sum(k[2] == "shifted" for k in self._columns)
            self._columns[key] = self._named((i, j, f"shifted{count}"), column)
        return self._columns[key]

    def _raw(self, i: int, j: int, c: int) -> list[Poly]:
        if i == 0 and j == self.n:
            return [Poly.symbol(Sym(COLUMNS[c], x, 4)) for x in "xyz"]
        if i == 0:
            after = inverse(self.product(j, self.n))
            base = [self.column(0, self.n, k) for k in range(4)]
            return [sum((base[k][r] * after[k][c] for k in range(4)), Poly()) for r in range(3)]
        # by way of the last frame whose names the reader has seen
        nearest = max((k for k in range(i) if (k, j, c == 3) in self.stages), default=0)
        before = inverse(self.product(nearest, i))
        vector = self.column(nearest, j, c)
        shift = [before[r][3] if c == 3 else Poly() for r in range(3)]
        return [sum((before[r][k] * vector[k] for k in range(3)), Poly()) + shift[r] for r in range(3)]

    def _named(self, key: tuple, raw: list[Poly]) -> list[Poly]:
        i, j, c = key
        found = []
        for r, poly in enumerate(raw):
            if len(poly.terms) < 2 and all(abs(v) == 1 for v in poly.terms.values()):
                found.append(poly)
                continue
            turns = c in (0, 1, 2)
            kind = "rotation" if turns else "position" if c == 3 else str(c)
            symbol = Sym(f"{kind} {i} {j}", f"{r + 1}{c + 1}" if turns else "xyz"[r], 4)
            if poly in self._named_before:  # the same entry of another split has a name already
                found.append(Poly.symbol(self._named_before[poly]))
                continue
            self._named_before[poly] = symbol
            self.definitions[symbol] = poly
            if not self.usable(poly):
                self.hidden.add(symbol)
            found.append(Poly.symbol(symbol))
        if c in (0, 1, 2):
            for r, poly in enumerate(found):
                for atom in poly.atoms():
                    if len(poly.terms) == 1 and isinstance(atom, Sym):
                        self.rotation_of[atom] = (key, r)
        return found

    def column_mates(self, symbol: Sym) -> list[Poly] | None:
        """The other two entries of the rotation column in which a named entry stands."""
        place = self.rotation_of.get(symbol)
        if place is None:
            return None
        column = self._columns[place[0]]
        return [p for r, p in enumerate(column) if r != place[1]]

    def show(self, polys: Any) -> list[Sym]:
        """Names that the polynomials rest on and that were not shown before, in the order of evaluation."""
        wanted, queue = set(), [a for p in polys for a in p.atoms()]
        while queue:
            atom = queue.pop()
            if atom in self.definitions and atom not in wanted:
                wanted.add(atom)
                queue += list(self.definitions[atom].atoms())
        new = [s for s in self.definitions if s in wanted and s not in self.shown]
        self.shown |= set(new)
        for symbol in new:
            kind, i, j = symbol.base.split()
            if kind in ("position", "rotation"):
                self.stages.add((int(i), int(j), kind == "position"))
        return new


def pretty_names(symbols: Any) -> dict[Sym, Sym]:
    """Short names for named entries, a letter a matrix, in the order given."""
    letters: dict[str, str] = {}
    pools = {True: iter(ROTATION_LETTERS), False: iter(POSITION_LETTERS)}
    for symbol in symbols:
        if symbol.base not in letters:
            letters[symbol.base] = next(pools[symbol.base.startswith("rotation")])
    return {symbol: Sym(letters[symbol.base], symbol.sub, 4) for symbol in symbols}
