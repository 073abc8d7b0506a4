"""Forward kinematics as equations: every A_i, every partial product, the whole pose, the numbers that check them."""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from pieper.algebra.arithmetics import DigitsField, NumpyField, SympyField
from pieper.algebra.expression import Expr, Num
from pieper.algebra.harmonic import matmul
from pieper.algebra.notation import equation, formula, latex, mathml, text
from pieper.equations.table import SymbolTable, symbol_table
from pieper.errors import InputError

ENTRY_NAMES = tuple(tuple(f"{c}_{r}" for c in "noap") for r in "xyz")


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


@dataclass(frozen=True)
class MatrixEquation:
    """A named 4x4 matrix of formulas.

    Attributes:
        name: Plain name, e.g. "A1", "T03", "T06".
        entries: 4x4 tuple of expressions.
    """

    name: str
    entries: tuple

    def __getitem__(self, place) -> Expr:
        """Entry at (row, column), 0-based."""
        row, column = place
        return self.entries[row][column]

    def text(self) -> str:
        """The rows, columns aligned."""
        cells = [[text(e) for e in row] for row in self.entries]
        widths = [max(len(row[c]) for row in cells) for c in range(4)]
        lines = ["[ " + "   ".join(cell.ljust(w) for cell, w in zip(row, widths, strict=True)) + " ]" for row in cells]
        margin = " " * (len(self.name) + 3)
        return f"{self.name} = " + ("\n" + margin).join(lines)

    def latex(self) -> str:
        rows = r" \\ ".join(" & ".join(latex(e) for e in row) for row in self.entries)
        return rf"{_matrix_name(self.name)} = \begin{{bmatrix}} {rows} \end{{bmatrix}}"

    def mathml(self) -> str:
        rows = "".join(f"<mtr>{''.join(f'<mtd>{mathml(e)}</mtd>' for e in row)}</mtr>" for row in self.entries)
        name = f"<msub><mi>{self.name[0]}</mi><mn>{self.name[1:]}</mn></msub>"
        return formula(f"{name}<mo>=</mo><mrow><mo>[</mo><mtable>{rows}</mtable><mo>]</mo></mrow>", block=True)

    def sympy(self):
        """A sympy Matrix (4, 4) with real symbols theta1, a2, ... inside cos and sin."""
        import sympy

        field, symbols = SympyField(), SympyField.symbols
        return sympy.Matrix([[e.evaluate(symbols, field) for e in row] for row in self.entries])

    def equations(self, style: str = "text") -> list[str]:
        """The twelve entries as n_x = ..., o_x = ..., column by column, in "text", "latex" or "mathml"."""
        found = []
        for column, letter in enumerate("noap"):
            for row, axis in enumerate("xyz"):
                left = {
                    "text": f"{letter}_{axis}",
                    "latex": f"{letter}_{{{axis}}}",
                    "mathml": f"<msub><mi>{letter}</mi><mi>{axis}</mi></msub>",
                }[style]
                found.append(equation(left, self.entries[row][column], style))
        return found

    def evaluate(self, values: dict, field) -> list[list]:
        return [[e.evaluate(values, field) for e in row] for row in self.entries]


class ForwardEquations:
    """The forward kinematics of one arm as equations.

    Args:
        description: The arm.
        fk: Its numeric forward kinematics, q (..., n) -> (..., 4, 4), against which `check` measures.
        lengths: "symbols" or "numbers".
        angles: "theta" (angles of the DH table) or "q" (the maker's joint coordinates).
    """

    def __init__(self, description, *, fk: Callable | None = None, lengths: str = "symbols", angles: str = "theta"):
        self.description, self._fk = description, fk
        self.table: SymbolTable = symbol_table(description, lengths=lengths, angles=angles)

    @property
    def n(self) -> int:
        return self.table.n

    @functools.cached_property
    def A(self) -> tuple[MatrixEquation, ...]:
        """The link matrices A1 .. An."""
        return tuple(_named(f"A{i + 1}", m) for i, m in enumerate(self.table.A))

    @functools.cache  # noqa: B019 - one small table per arm, dropped with it
    def product(self, first: int, last: int) -> list:
        """A_{first+1} ... A_last as polynomials (0 <= first < last <= n)."""
        if not 0 <= first < last <= self.n:
            raise InputError(f"T needs 0 <= i < j <= {self.n}, got i={first}, j={last}.", first=first, last=last)
        if last - first == 1:
            return self.table.A[first]
        # Short factors on the left keep a run of parallel axes together, so its angle sums form at once.
        return matmul(self.table.A[first], self.product(first + 1, last))

    @functools.cache  # noqa: B019
    def T(self, first: int, last: int) -> MatrixEquation:
        """The partial product from frame `first` to frame `last`, T(0, 3) for T03."""
        return _named(f"T{first}{last}", self.product(first, last))

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
        d = self.description
        return not (np.array_equal(d.base, np.eye(4)) and np.array_equal(d.tool, np.eye(4)))

    @property
    def split(self) -> int:
        """Where the arm ends and the wrist begins in the partial products that are shown."""
        return self.n - 3 if self.n > 4 else max(self.n // 2, 1)

    # -- what the symbols mean -------------------------------------------------------------------------------
    def relations(self, style: str = "text") -> list[str]:
        """Joint angle of the table against joint coordinate, where they differ: theta2 = q2 + pi/2."""
        printer = {"text": text, "latex": latex, "mathml": mathml}[style]
        found = []
        for symbol, expression in self.table.relation.values():
            if symbol.base == "theta" and expression is _q(symbol) or symbol.base == "q":
                continue
            found.append(equation(printer(symbol), expression, style))
        return found

    def meanings(self, style: str = "text") -> list[str]:
        """What each length and twist symbol stands for: a2 = 0.21 (metres)."""
        found = []
        for symbol, expression in self.table.meaning.items():
            line = equation({"text": text, "latex": latex, "mathml": mathml}[style](symbol), expression, style)
            found.append(line)
        return found

    # -- everything at once ----------------------------------------------------------------------------------
    def matrices(self) -> list[MatrixEquation]:
        """What a paper prints: A_i, the two halves, the product, and the pose when there is a base or a tool."""
        shown = list(self.A)
        if self.n > 1:
            if 0 < self.split < self.n and self.n > 2:
                shown += [self.T(0, self.split), self.T(self.split, self.n)]
            shown.append(self.flange)
        if self.has_base_or_tool:
            shown.append(self.pose)
        return shown

    def text(self) -> str:
        """Plain text: matrices, then the pose entry by entry."""
        blocks = [f"Forward kinematics of {self.description.name} ({self.description.convention} DH)"]
        if self.relations():
            blocks.append("Joint angles of the table: " + "; ".join(self.relations()))
        if self.meanings():
            blocks.append("Constants (m): " + "; ".join(self.meanings()))
        blocks += [m.text() for m in self.matrices()[: self.n + 2 if self.n > 2 else self.n]]
        blocks.append("\n".join(self.pose.equations()))
        return "\n\n".join(blocks) + "\n"

    def latex(self) -> str:
        r"""LaTeX: display equations, the pose as one aligned block (needs amsmath)."""
        shown = [rf"\[ {m.latex()} \]" for m in self.matrices()[: self.n + 2 if self.n > 2 else self.n]]
        rows = " \\\\\n".join(line.replace(" = ", " &= ", 1) for line in self.pose.equations("latex"))
        return "\n".join(shown) + "\n\\begin{align*}\n" + rows + "\n\\end{align*}\n"

    def mathml(self) -> str:
        """MathML: one <math> element per matrix and per entry of the pose."""
        shown = [m.mathml() for m in self.matrices()[: self.n + 2 if self.n > 2 else self.n]]
        shown += [formula(line, block=True) for line in self.pose.equations("mathml")]
        return "\n".join(shown)

    def sympy(self):
        """Base-to-tool pose as a sympy Matrix (4, 4)."""
        return self.pose.sympy()

    # -- numbers that check ----------------------------------------------------------------------------------
    def evaluate(self, q) -> np.ndarray:
        """The pose by these equations, q (..., n) -> (..., 4, 4)."""
        q = np.asarray(q, float)
        values = self.table.values(np.moveaxis(q, -1, 0), NumpyField)
        entries = self.pose.evaluate(values, NumpyField)
        shape = q.shape[:-1]
        return np.moveaxis(np.array([[np.broadcast_to(e, shape) for e in row] for row in entries]), (0, 1), (-2, -1))

    def evaluate_digits(self, q, digits: int = 50) -> list[list]:
        """The pose as 4x4 nested lists of mpmath numbers; q may hold mpmath numbers or strings."""
        import mpmath

        with mpmath.workdps(digits + 10):
            field = DigitsField()
            return self.pose.evaluate(self.table.values([mpmath.mpf(x) for x in q], field), field)

    def check(self, n: int = 200, *, rng: np.random.Generator | None = None) -> Check:
        """Compare with the numeric forward kinematics at `n` random joint vectors."""
        if self._fk is None:
            raise InputError("These equations were made without an arm; pass fk= to check them.")
        rng = rng or np.random.default_rng(20260)
        q = rng.uniform(-np.pi, np.pi, (n, self.n))
        worst = float(np.max(np.abs(self.evaluate(q) - self._fk(q))))
        return Check(
            n,
            worst,
            f"All twelve entries agree with the numeric pose at {n} of {n} random joint vectors "
            f"to {worst:.1e} (metres or direction cosines)."
            if worst < 1e-9
            else f"The equations differ from the numeric pose by up to {worst:.1e}.",
        )


def forward_matrices(description, *, lengths: str = "symbols", angles: str = "theta") -> list:
    """The link matrices A1 .. An as sympy matrices in the field's symbols (theta1, a2, d4; d3 for a sliding joint)."""
    return [m.sympy() for m in ForwardEquations(description, lengths=lengths, angles=angles).A]


def _named(name: str, matrix) -> MatrixEquation:
    return MatrixEquation(
        name, tuple(tuple(p.expr() for p in row) for row in matrix[:3]) + ((Num(0),) * 3 + (Num(1),),)
    )


def _matrix_name(name: str) -> str:
    return f"{name[0]}_{{{name[1:]}}}" if len(name) > 1 else name


def _q(symbol):
    from pieper.algebra.expression import angle_symbol

    return angle_symbol(int(symbol.sub), "q")
