"""The DH table as symbols: A_i with exact entries, what each symbol stands for, and which axes run parallel."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from pieper.algebra.exact import decimal_text, pi_fraction, quarter_turns, rational
from pieper.algebra.expression import Call, Expr, Num, PiFraction, Sym, add, angle_symbol
from pieper.algebra.harmonic import Poly, matmul, trig
from pieper.description.dh import Description, Slid
from pieper.errors import InputError
from pieper.kinematics.arrays import Array
from pieper.tolerances import ALL_BUT_ZERO

LENGTHS = ("symbols", "numbers")
ANGLES = ("theta", "q")
QUARTER = ((1, 0), (0, 1), (-1, 0), (0, -1))  # cosine and sine of whole quarter turns

Matrix = list[list[Poly]]


@dataclass(frozen=True)
class SymbolTable:
    """A Description turned into symbols.

    Attributes:
        A: The n link matrices, 4x4 of polynomials.
        base, tool: The constant matrices before and after them.
        meaning: symbol -> expression of exact numbers, for lengths and for twists that are not quarter turns.
        relation: joint (1-based) -> (its symbol in the equations, expression in terms of q).
        prismatic: joints (1-based) that slide.
        groups: group[i-1] is the first joint of the run of parallel axes to which joint i belongs.
        letter: How angles are written.
        joints: How many joints the arm has: fewer than axes where a linkage moves some.
    """

    A: tuple
    base: Matrix
    tool: Matrix
    meaning: dict
    relation: dict
    prismatic: frozenset
    groups: tuple
    letter: str
    joints: int

    @property
    def n(self) -> int:
        """Number of axes."""
        return len(self.A)

    def variable(self, joint: int) -> Sym:
        """The symbol that stands for a joint in the equations: theta2, d3 or q2 (1-based joint)."""
        return self.relation[joint][0]

    def values(self, q: Any, field: Any) -> dict:
        """Numbers for every symbol at the joint vector `q` (sequence over joints, each of any shape)."""
        values = {angle_symbol(i + 1, "q"): q[i] for i in range(self.joints)}
        for symbol, expression in self.relation.values():
            values[symbol] = expression.evaluate(values, field)
        return self.constants(field) | values

    def constants(self, field: Any) -> dict:
        """Numbers for the lengths and twists alone."""
        return {symbol: expression.evaluate({}, field) for symbol, expression in self.meaning.items()}

    def constant(self, joint: int, field: Any) -> Any:
        """The number that a joint's symbol stands for at the joint vector zero."""
        none = {angle_symbol(k, "q"): field.rational(Num(0).value) for k in range(1, self.joints + 1)}
        return self.relation[joint][1].evaluate(none, field)


def angle_expr(angle: float) -> Expr:
    """An angle as a fraction of pi when it is one, else as the decimal number of radians."""
    multiple = pi_fraction(angle)
    return Num(rational(angle)) if multiple is None else (PiFraction(multiple) if multiple else Num(0))


def symbol_table(description: Description, *, lengths: str = "symbols", angles: str = "theta") -> SymbolTable:
    """Read a Description into symbols.

    Args:
        description: `pieper.description.Description`.
        lengths: "symbols" keeps a2, d4; "numbers" puts the table's numbers in, as exact decimals.
        angles: "theta" writes the angle of the DH table (constant part, sense and zero of the joint included);
            "q" writes the joint coordinate that the maker and the user speak, constants worked in.
    """
    for name, value, allowed in (("lengths", lengths, LENGTHS), ("angles", angles, ANGLES)):
        if value not in allowed:
            raise InputError(f"{name} must be one of {', '.join(allowed)}, got {value!r}.", given=value)
    if angles == "q" and description.coupling is not None:
        raise InputError(
            f'{description.name} has coupled joints, whose numbers are no angles between links: write angles="theta"; '
            "how the angles follow from the joints is said beside them.",
            given=angles,
        )
    return _Reader(description, lengths == "symbols", angles).read()


class _Reader:
    def __init__(self, description: Description, keep: bool, letter: str) -> None:
        self.d, self.keep, self.letter = description, keep, letter
        self.modified = description.convention == "modified"
        self.meaning: dict = {}
        self.relation: dict = {}
        self.twists: dict = {}  # |angle| -> (cos symbol, sin symbol)

    def read(self) -> SymbolTable:
        d = self.d
        n = len(d.rows)
        self.groups = self._groups()
        prismatic = frozenset(i + 1 for i, kind in enumerate(d.axis_types) if kind == "P")
        links = tuple(self._link(i) for i in range(n))
        base, tool = self._constant("b", d.base), self._constant("t", d.tool)
        meaning = dict(sorted(self.meaning.items(), key=lambda item: (item[0].rank, item[0].order[2], item[0].base)))
        return SymbolTable(links, base, tool, meaning, self.relation, prismatic, self.groups, self.letter, d.n)

    def _groups(self) -> tuple:
        groups = [1]
        for i in range(1, len(self.d.rows)):
            twist = self.d.rows[i if self.modified else i - 1].alpha
            groups.append(groups[-1] if quarter_turns(twist) in (0, 2) else i + 1)
        return tuple(groups)

    def _link(self, i: int) -> Matrix:
        row, index = self.d.rows[i], str(i if self.modified else i + 1)
        slides = self.d.axis_types[i] == "P"
        ca, sa = self._twist(row.alpha, "alpha", index)
        a = self._length("a", index, row.a)
        sign, zero = int(round(float(self.d.sign[i]))), float(self.d.offset[i])
        if slides:
            c, s = self._twist(row.theta, "theta", str(i + 1))
            d = self._slide(i + 1, sign, row.d + zero)
        else:
            c, s = self._turn(i + 1, sign, row.theta + zero)
            d = self._length("d", str(i + 1), row.d)
        one, nil = Poly.number(1), Poly()
        spin = [[c, -s, nil, nil], [s, c, nil, nil], [nil, nil, one, d], [nil, nil, nil, one]]
        bend = [[one, nil, nil, a], [nil, ca, -sa, nil], [nil, sa, ca, nil], [nil, nil, nil, one]]
        if isinstance(row, Slid):
            bend[1][3] = self._length("f", index, row.f)
        return matmul(bend, spin) if self.modified else matmul(spin, bend)

    def _length(self, base: str, index: str, value: float) -> Poly:
        if value == 0:
            return Poly()
        exact = rational(value)
        if not self.keep:
            return Poly.number(exact)
        symbol = Sym(base, index)
        self.meaning[symbol] = Num(exact, decimal_text(exact) or "")  # a length of 0.5 m is no half
        return Poly.symbol(symbol)

    def _twist(self, angle: float, base: str, index: str) -> tuple[Poly, Poly]:
        """Cosine and sine of a constant angle: numbers for quarter turns, otherwise named constants."""
        quarter = quarter_turns(angle)
        if quarter is not None:
            cosine, sine = QUARTER[quarter]
            return Poly.number(cosine), Poly.number(sine)
        size, sense = angle_expr(abs(angle)), (1 if angle > 0 else -1)
        key = round(abs(angle), 14)
        if key not in self.twists:
            pair = Sym("c" + base, index, 2), Sym("s" + base, index, 2)
            self.meaning[pair[0]], self.meaning[pair[1]] = Call("cos", size), Call("sin", size)
            self.twists[key] = pair
        c, s = self.twists[key]
        return Poly.symbol(c), Poly.symbol(s, sense)

    def _turn(self, joint: int, sign: int, constant: float) -> tuple[Poly, Poly]:
        q = angle_symbol(joint, "q")
        if self.letter == "theta":
            self.relation[joint] = (angle_symbol(joint), add(*self._moved_by(joint, sign), angle_expr(constant)))
            group = self.groups[joint - 1]
            return trig("c", {joint: 1}, group), trig("s", {joint: 1}, group)
        self.relation[joint] = (q, q)
        cosine, sine = (trig(kind, {joint: sign}, self.groups[joint - 1], "q") for kind in "cs")
        c0, s0 = self._twist(constant, "theta", str(joint))
        return cosine * c0 - sine * s0, sine * c0 + cosine * s0

    def _slide(self, joint: int, sign: int, constant: float) -> Poly:
        q = angle_symbol(joint, "q")
        if self.letter == "theta":
            symbol = Sym("d", str(joint))
            self.relation[joint] = (symbol, add(*self._moved_by(joint, sign), Num(rational(constant))))
            return Poly.symbol(symbol)
        self.relation[joint] = (q, q)
        return Poly.symbol(q, sign) + self._length("l", str(joint), constant)

    def _moved_by(self, joint: int, sign: int) -> list[Expr]:
        """What moves an axis, in the joints' numbers: q3 alone, or q2 + q3."""
        if self.d.coupling is None:
            return [Num(sign) * angle_symbol(joint, "q")]
        row = enumerate(self.d.coupling[joint - 1], 1)
        return [Num(sign * rational(float(c))) * angle_symbol(k, "q") for k, c in row if c]

    def _constant(self, base: str, T: Array) -> Matrix:
        """A constant pose; entries that are 0 or 1 within rounding stay so, others are named (or put in)."""
        T = np.asarray(T, float)
        rows = []
        for r in range(4):
            row = []
            for c in range(4):
                value, nearest = T[r, c], round(T[r, c])
                if r == 3 or (abs(value - nearest) < ALL_BUT_ZERO and (c < 3 or nearest == 0)):
                    row.append(Poly.number(Fraction(int(nearest))))
                else:
                    row.append(self._length(base, "xyz"[r] if c == 3 else f"{r + 1}{c + 1}", value))
            rows.append(row)
        return rows


def inverse(matrix: Matrix) -> Matrix:
    """Inverse of a rigid displacement: transposed rotation, turned-back translation."""
    turned = [[matrix[c][r] for c in range(3)] for r in range(3)]
    p = [matrix[r][3] for r in range(3)]
    shift = [-(row[0] * p[0] + row[1] * p[1] + row[2] * p[2]) for row in turned]
    last = [Poly(), Poly(), Poly(), Poly.number(1)]
    return [[*turned[r], shift[r]] for r in range(3)] + [last]
