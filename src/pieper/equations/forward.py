"""Forward kinematics as equations: every A_i, every partial product, the whole pose, the numbers that check them."""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from pieper.algebra.arithmetics import DigitsField, NumpyField, SympyField
from pieper.algebra.expression import Expr, Num, Sym, Trig, angle_symbol
from pieper.algebra.harmonic import Poly, matmul
from pieper.description.dh import Description
from pieper.description.slid import slid_rows
from pieper.document import text
from pieper.document.blocks import Document, Equation, Equations
from pieper.document.formulas import equals, in_line, matrix, named
from pieper.document.mathml_fit import displayed, fits
from pieper.document.readable import Readable
from pieper.equations.lettering import checked_letters, in_letters
from pieper.equations.named_parts import broken_lines
from pieper.equations.table import SymbolTable, symbol_table
from pieper.errors import InputError
from pieper.kinematics.arrays import Array
from pieper.tolerances import FORMULA_AGREES

#: Columns of a pose.
COLUMNS = "noap"


@dataclass(frozen=True)
class Check:
    """How well equations held against the numbers.

    Attributes:
        n: Poses tried.
        worst: Largest deviation of any entry (m, or dimensionless for a rotation entry).
        what: One sentence.
    """

    n: int
    worst: float
    what: str

    def __str__(self) -> str:
        return self.what

    @staticmethod
    def of(
        equations: Callable[[Array], Array],
        numeric: Callable[[Array], Array] | None,
        joints: int,
        n: int,
        rng: np.random.Generator | None,
        says: tuple[str, str, str],
    ) -> Check:
        """Compare equations with numbers at n random joint vectors (rad, m).

        Args:
            equations: Takes joint vectors (n, joints).
            numeric: The numbers likewise; None where the equations were made without an arm.
            joints: How many.
            n: Joint vectors tried.
            rng: Random numbers.
            says: The argument that an arm would have been given as; what is counted; what it is compared with.
        """
        argument, entries, what = says
        if numeric is None:
            raise InputError(f"These equations were made without an arm; pass {argument}= to check them.")
        q = (rng or np.random.default_rng(20260)).uniform(-np.pi, np.pi, (n, joints))
        worst = float(np.max(np.abs(equations(q) - numeric(q))))
        agree = f"All {entries} entries agree with the numeric {what} at {n} random joint vectors to {worst:.1e}"
        differ = f"The equations differ from the numeric {what} by up to {worst:.1e}"
        return Check(n, worst, f"{agree if worst < FORMULA_AGREES else differ} (metres or direction cosines).")


@dataclass(frozen=True)
class MatrixEquation:
    """A named 4x4 matrix of formulas.

    Attributes:
        name: Plain name, e.g. "A1", "T03", "T06".
        entries: 4x4 tuple of expressions.
    """

    name: str
    entries: tuple[tuple[Expr, ...], ...]

    def __getitem__(self, place: tuple[int, int]) -> Expr:
        """Entry at (row, column), 0-based."""
        row, column = place
        return self.entries[row][column]

    @functools.cached_property
    def equation(self) -> Equation:
        """The name, an equals sign and the matrix."""
        return Equation((named(self.name[0], self.name[1:]), matrix(self.entries)), name=self.name)

    @property
    def shown(self) -> Equation | Equations:
        """The matrix, or entry by entry where it is too wide for a page: browsers shrink every page for one such."""
        cells = matrix(self.entries)
        if fits(cells.mathml()):
            return self.equation
        return Equations(
            tuple(
                Equation((named(self.name[0], f"{self.name[1:]},{r + 1}{c + 1}"), self.entries[r][c]))
                for c in range(4)
                for r in range(3)
            )
        )

    @property
    def entry_equations(self) -> Equations:
        """The twelve entries as n_x = ..., o_x = ..., column by column."""
        return Equations(
            tuple(
                Equation((Sym(letter, axis, 4), self.entries[row][column]), name=f"{letter}_{axis}")
                for column, letter in enumerate(COLUMNS)
                for row, axis in enumerate("xyz")
            )
        )

    def text(self) -> str:
        """The rows, columns aligned."""
        return text.equation(*self.equation.sides)

    def latex(self) -> str:
        """LaTeX for math mode."""
        return equals(*self.equation.sides).latex()

    def mathml(self) -> str:
        """A <math> element that stands on its own."""
        return displayed(equals(*self.equation.sides).mathml())

    def sympy(self) -> Any:
        """A sympy Matrix (4, 4) with real symbols theta1, a2, ... inside cos and sin."""
        import sympy

        field, symbols = SympyField(), SympyField.symbols
        return sympy.Matrix([[e.evaluate(symbols, field) for e in row] for row in self.entries])

    def equations(self) -> list[str]:
        """The twelve entries as lines of text."""
        return [text.equation(*row.sides) for row in self.entry_equations.rows]

    def evaluate(self, values: dict, field: Any) -> list[list]:
        """The entries in an arithmetic, see `algebra.arithmetics`."""
        return [[e.evaluate(values, field) for e in row] for row in self.entries]


class ForwardEquations(Readable):
    """The forward kinematics of one arm as equations.

    Args:
        description: The arm.
        fk: Its numeric forward kinematics, q (..., n) -> (..., 4, 4), against which `check` measures.
        lengths: "symbols" or "numbers".
        angles: "theta" (angles of the DH table) or "q" (the maker's joint coordinates).
        letters: "noap" or "r", in which the page names the entries of the pose.
    """

    def __init__(
        self,
        description: Description,
        *,
        fk: Callable[[np.ndarray], np.ndarray] | None = None,
        lengths: str = "symbols",
        angles: str = "theta",
        letters: str = "noap",
    ) -> None:
        self.description, self._fk, self.letters = description, fk, checked_letters(letters)
        self.table: SymbolTable = symbol_table(description, lengths=lengths, angles=angles)
        self._products: dict[tuple[int, int], list[list[Poly]]] = {}
        self._named: dict[tuple[int, int], MatrixEquation] = {}

    @property
    def n(self) -> int:
        """Number of joints."""
        return self.table.n

    @functools.cached_property
    def A(self) -> tuple[MatrixEquation, ...]:
        """The link matrices A1 .. An."""
        return tuple(_named(f"A{i + 1}", m) for i, m in enumerate(self.table.A))

    def product(self, first: int, last: int) -> list[list[Poly]]:
        """A_{first+1} ... A_last as polynomials (0 <= first < last <= n)."""
        if not 0 <= first < last <= self.n:
            raise InputError(f"T needs 0 <= i < j <= {self.n}, got i={first}, j={last}.", first=first, last=last)
        if last - first == 1:
            return self.table.A[first]
        if (first, last) not in self._products:
            # Short factors on the left keep a run of parallel axes together, so its angle sums form at once.
            self._products[first, last] = matmul(self.table.A[first], self.product(first + 1, last))
        return self._products[first, last]

    def T(self, first: int, last: int) -> MatrixEquation:
        """The partial product from frame `first` to frame `last`; 0 and 3 for T03."""
        if (first, last) not in self._named:
            self._named[first, last] = _named(f"T{first}{last}", self.product(first, last))
        return self._named[first, last]

    @functools.cached_property
    def pose(self) -> MatrixEquation:
        """Base to tool: base * A1 ... An * tool."""
        return _named("T", matmul(matmul(self.table.base, self.product(0, self.n)), self.table.tool))

    @functools.cached_property
    def flange(self) -> MatrixEquation:
        """A1 ... An, without base and tool."""
        return self.T(0, self.n)

    @property
    def has_base_or_tool(self) -> bool:
        """Whether the arm has a base or a tool that is not the identity."""
        d = self.description
        return not (np.array_equal(d.base, np.eye(4)) and np.array_equal(d.tool, np.eye(4)))

    @property
    def split(self) -> int:
        """Where the arm ends and the wrist begins in the partial products that are shown."""
        return self.n - 3 if self.n > 4 else max(self.n // 2, 1)

    # -- what the symbols mean -------------------------------------------------------------------------------
    @property
    def relation_equations(self) -> tuple[Equation, ...]:
        """Joint angle of the table against joint coordinate, where they differ: theta2 = q2 + pi/2."""
        return tuple(
            Equation((symbol, expression))
            for symbol, expression in self.table.relation.values()
            if symbol.base != "q" and not (symbol.base == "theta" and expression is angle_symbol(int(symbol.sub), "q"))
        )

    @property
    def meaning_equations(self) -> tuple[Equation, ...]:
        """What each length and twist symbol stands for: a2 = 0.21 (metres)."""
        return tuple(Equation(item) for item in self.table.meaning.items())

    def relations(self) -> list[str]:
        """`relation_equations` as lines of text."""
        return [text.equation(*row.sides) for row in self.relation_equations]

    def meanings(self) -> list[str]:
        """`meaning_equations` as lines of text."""
        return [text.equation(*row.sides) for row in self.meaning_equations]

    def motions(self, expression: Expr) -> list[tuple[Expr, str, tuple[tuple[int, int], ...]]]:
        """What of a formula changes with the posture: (symbol, "cos", "sin" or "slide", ((joint, factor), ...))."""
        slides = {self.table.variable(j): ((j, 1),) for j in self.table.prismatic}
        found: list[tuple[Expr, str, tuple[tuple[int, int], ...]]] = []
        for atom in expression.atoms():
            if isinstance(atom, Trig):
                found.append((atom, {"c": "cos", "s": "sin"}[atom.kind], atom.angle))
            elif atom in slides:
                found.append((atom, "slide", slides[atom]))
        return found

    # -- everything at once ----------------------------------------------------------------------------------
    @property
    def halves(self) -> tuple[MatrixEquation, ...]:
        """The partial products of arm and wrist, where both are products."""
        return (self.T(0, self.split), self.T(self.split, self.n)) if 0 < self.split < self.n and self.n > 2 else ()

    def matrices(self) -> list[MatrixEquation]:
        """What a paper prints: A_i, the two halves, the product, and the pose when there is a base or a tool."""
        shown = [*self.A, *self.halves]
        if self.n > 1:
            shown.append(self.flange)
        return [*shown, self.pose] if self.has_base_or_tool else shown

    @functools.cached_property
    def page(self) -> Document:
        """The symbols, the link matrices, the two halves, then the pose entry by entry."""
        page = Document(f"Forward kinematics of {self.description.name} ({self.description.convention} DH)")
        if slid := slid_rows(self.description):
            which = ", ".join(f"A{i}" for i in slid)
            page.say(
                "Some neighbouring axes are nearly parallel, and their common normal lies far outside the arm. "
                f"{which} {'lead' if len(slid) > 1 else 'leads'} straight across instead of going there and back by an "
                "offset d: Rot(z, theta) Trans(x, a) Trans(y, f) Rot(x, alpha)."
            )
        for words, equations in (
            ("Joint angles of the table: ", self.relation_equations),
            ("Constants (m): ", self.meaning_equations),
        ):
            if equations:
                page.say(words, *in_line(equations))
        page.add(*(m.shown for m in (*self.A, *self.halves)), self.pose.entry_equations)
        return in_letters(broken_lines(page), self.letters)

    def sympy(self) -> Any:
        """Base-to-tool pose as a sympy Matrix (4, 4)."""
        return self.pose.sympy()

    # -- numbers that check ----------------------------------------------------------------------------------
    def evaluate(self, q: Array) -> np.ndarray:
        """The pose by these equations, q (..., n) -> (..., 4, 4)."""
        q = np.asarray(q, float)
        values = self.table.values(np.moveaxis(q, -1, 0), NumpyField)
        entries = self.pose.evaluate(values, NumpyField)
        shape = q.shape[:-1]
        return np.moveaxis(np.array([[np.broadcast_to(e, shape) for e in row] for row in entries]), (0, 1), (-2, -1))

    def evaluate_digits(self, q: Array, digits: int = 50) -> list[list]:
        """The pose as 4x4 nested lists of mpmath numbers; q may hold mpmath numbers or strings."""
        import mpmath

        with mpmath.workdps(digits + 10):
            field = DigitsField()
            return self.pose.evaluate(self.table.values([mpmath.mpf(x) for x in q], field), field)

    def check(self, n: int = 200, *, rng: np.random.Generator | None = None) -> Check:
        """Compare with the numeric forward kinematics at `n` random joint vectors."""
        return Check.of(self.evaluate, self._fk, self.table.joints, n, rng, ("fk", "twelve", "pose"))


def forward_matrices(description: Description, *, lengths: str = "symbols", angles: str = "theta") -> list:
    """The link matrices A1 .. An as sympy matrices in the field's symbols (theta1, a2, d4; d3 for a sliding joint)."""
    return [m.sympy() for m in ForwardEquations(description, lengths=lengths, angles=angles).A]


def _named(name: str, rows: list[list[Poly]]) -> MatrixEquation:
    return MatrixEquation(name, tuple(tuple(p.expr() for p in row) for row in rows[:3]) + ((Num(0),) * 3 + (Num(1),),))
