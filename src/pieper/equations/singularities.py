"""Singular configurations read off from the factors of the Jacobian determinant, in equations and in words."""

from __future__ import annotations

import functools
import itertools
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from pieper.algebra.arithmetics import NumpyField
from pieper.algebra.determinant import Factored, TooLarge, blocks, determinant
from pieper.algebra.expression import Expr, Mul, Num, Trig, mul
from pieper.algebra.harmonic import Poly
from pieper.description.dh import Description
from pieper.document.blocks import Document, Piece
from pieper.document.formulas import ZERO, Written
from pieper.document.readable import Readable
from pieper.equations.forward import Check
from pieper.equations.jacobian import JacobianEquations
from pieper.equations.named_parts import broken_lines
from pieper.equations.one_block import one_long_block
from pieper.equations.singular_facts import facts_on, first_harmonic, roots_on_factor, still_joints
from pieper.equations.vanishing import vanish_together
from pieper.kinematics.arrays import Array
from pieper.tolerances import ROUNDING, TINY, WHOLE_TURN

NAMES = {
    "shoulder": "Shoulder singularity",
    "elbow": "Elbow singularity",
    "slide": "Singularity of the slide",
    "wrist": "Wrist singularity",
    "other": "Singular configurations",
}
TOO_LONG = (
    "The determinant does not split into small blocks and is too long to print; it is checked by its numbers only."
)


@dataclass(frozen=True)
class Singularity:
    """One way for the arm to become singular.

    Attributes:
        kind: "shoulder", "elbow", "slide", "wrist" or "other".
        factor: The factor of the determinant that vanishes.
        where: For a factor of one joint: the values of that joint's table angle (rad) or slide (m); else empty.
        words: What it means, one sentence each.
        samples: (k, n) joint vectors on it, found numerically.
    """

    kind: str
    factor: Expr
    where: tuple[float, ...]
    words: tuple[str, ...]
    samples: np.ndarray

    @property
    def possible(self) -> bool:
        """Whether the factor vanishes anywhere."""
        return len(self.samples) > 0


class SingularityEquations(Readable):
    """The Jacobian determinant in factors and what follows from each.

    Args:
        jacobian: The Jacobian equations.
        numeric: The numeric Jacobian, q (..., n) -> (..., 6, n).
        frames: Numeric frames, q (..., n) -> (..., n + 2, 4, 4).
        task: "pose", "position" or "position+axis": which rows of the Jacobian count.
    """

    def __init__(
        self,
        jacobian: JacobianEquations,
        *,
        numeric: Callable[..., Array],
        frames: Callable[..., Array],
        task: str = "pose",
    ) -> None:
        self.jacobian, self.numeric, self.frames, self.task = jacobian, numeric, frames, task
        self.table = jacobian.forward.table
        self.n = jacobian.n
        self.variables = frozenset(self.table.variable(j) for j in self.table.prismatic)

    # -- the determinant -------------------------------------------------------------------------------------
    @functools.cached_property
    def _choice(self) -> Any:
        """(linear frame, angular frame, point, rows of polynomials) with the smallest blocks, then the fewest terms."""
        n = self.n
        # The outermost frames never give more zeros than their neighbours; a long arm is looked at from its middle.
        middle = range(2, n - 1) if n > 6 else range(1, max(n, 2))
        points = [n + 1] if self.task != "pose" else (range(3, n - 1) if n > 6 else range(1, n + 1))
        linear = {(k, m): self._linear(k, m) for k in middle for m in points}
        angular = {k: self._angular(k) for k in ({"position": [], "position+axis": [n + 1]}.get(self.task, middle))}
        options = []
        for (k, m), rows in linear.items():
            for k2, more in angular.items() or [(None, [])]:
                matrix = rows + more
                terms = sum(len(p.terms) for row in matrix for p in row)
                zeros = sum(not p.terms for row in matrix for p in row)
                options.append((terms - 2 * zeros, k, k2, m))
        options.sort(key=lambda item: (item[0], item[1], item[2] or 0, item[3]))
        found = []
        for cost, k, k2, m in options[: 60 if n == 6 else 12]:
            matrix = linear[k, m] + (angular[k2] if k2 is not None else [])
            sizes = [self._size(matrix, rows, cols) for rows, cols in self._minors_of(len(matrix))]
            found.append(((max(sizes, default=0), sum(sizes), cost), k, k2, m, matrix))
        return min(found, key=lambda item: item[0])[1:]

    @functools.cached_property
    def _long(self) -> bool:
        return self.task == "pose" and one_long_block(self.jacobian.forward.description, self.numeric, self.frames)

    def _linear(self, frame: int, point: int) -> list[list[Poly]]:
        columns = [self.jacobian.column(j + 1, frame, point)[0] for j in range(self.n)]
        return [list(row) for row in zip(*columns, strict=True)]

    def _angular(self, frame: int) -> list[list[Poly]]:
        columns = [self.jacobian.column(j + 1, frame, frame)[1] for j in range(self.n)]
        rows = [list(row) for row in zip(*columns, strict=True)]
        return rows[:2] if self.task == "position+axis" else rows

    def _minors_of(self, height: int) -> list[tuple]:
        size = min(height, self.n)
        return [
            (rows, columns)
            for rows in itertools.combinations(range(height), size)
            for columns in itertools.combinations(range(self.n), size)
        ]

    @staticmethod
    def _size(matrix: Any, rows: Any, columns: Any) -> int:
        parts = blocks([[matrix[r][c] for c in columns] for r in rows])
        return 0 if parts is None else max(len(c) for _, c in parts) ** 2

    @functools.cached_property
    def minors(self) -> list[Factored] | None:
        """Every largest minor that is not identically zero; one when the Jacobian is square. None when too long."""
        if self._long:
            return None
        matrix = self._choice[3]
        found, seen = [], set()
        try:
            for rows, columns in self._minors_of(len(matrix)):
                value = determinant([[matrix[r][c] for c in columns] for r in rows], self.variables)
                if value.zero:
                    continue
                # columns of a minor are counted in the minor; name them by joint
                named = Factored(
                    value.scale,
                    tuple(type(f)(f.poly, tuple(columns[c] for c in f.columns)) for f in value.factors),
                    value.largest,
                )
                signature = tuple(sorted(hash(f.poly) for f in named.factors))
                if signature not in seen:
                    seen.add(signature)
                    found.append(named)
        except TooLarge:
            return None
        return found

    @property
    def square(self) -> bool:
        """Whether there is one determinant (as many joints as task coordinates)."""
        return self._long or len(self._choice[3]) == self.n

    @functools.cached_property
    def determinant(self) -> Expr | None:
        """The determinant by theta and d, in factors; None when there is none or it is too long to print."""
        if not self.square or not self.minors:
            return None
        return _product(self.minors[0])

    @functools.cached_property
    def common_factors(self) -> list[tuple[Poly, tuple[int, ...]]]:
        """Factors that all largest minors share, with the joints of their block."""
        if not self.minors:
            return []
        shared = [(f.poly, f.columns) for f in self.minors[0].factors]
        for other in self.minors[1:]:
            have = [f.poly for f in other.factors]
            shared = [(p, c) for p, c in shared if p in have or -p in have]
        unique = []
        for p, c in shared:
            if all(p != q for q, _ in unique):
                unique.append((p, c))
        return unique

    # -- the configurations ----------------------------------------------------------------------------------
    @functools.cached_property
    def configurations(self) -> tuple[Singularity, ...]:
        """One entry a factor, in the order shoulder, elbow, wrist, other."""
        found = [self._configuration(poly, columns) for poly, columns in self.common_factors]
        return tuple(sorted(found, key=lambda s: tuple(NAMES).index(s.kind)))

    def _configuration(self, poly: Poly, columns: tuple[int, ...]) -> Singularity:
        expr = poly.expr()
        value, joints = self._value_of(expr), self._joints_of(poly)
        samples = roots_on_factor(value, joints, self.n, self.jacobian.forward.description)
        words = facts_on(samples, self.frames, self.jacobian.forward.description) if len(samples) else []
        if len(samples):
            still = still_joints(samples, self._rows)
            if still:
                words.append(still)
        else:
            words.append("This factor never vanishes with the lengths of this arm.")
        return Singularity(self._kind(poly, columns, words), _bare(expr), self._where(poly), tuple(words), samples)

    def _rows(self, q: Array) -> np.ndarray:
        """The rows of the numeric Jacobian that count for the task, (..., r, n)."""
        J = self.numeric(q)
        if self.task == "position":
            return J[..., :3, :]
        if self.task == "position+axis":
            R = self.frames(q)[..., -1, :3, :3]
            turned = np.swapaxes(R, -1, -2) @ J[..., 3:, :]
            return np.concatenate([J[..., :3, :], turned[..., :2, :]], axis=-2)
        return J

    def _value_of(self, expr: Expr) -> Callable[[Array], Any]:
        return lambda q: expr.evaluate(
            self.table.values(np.moveaxis(np.asarray(q, float), -1, 0), NumpyField), NumpyField
        )

    def _joints_of(self, poly: Poly) -> list[int]:
        slides = [j for j in self.table.prismatic if self.table.variable(j) in poly.atoms()]
        return sorted(poly.joints() | set(slides))

    def _kind(self, poly: Poly, columns: tuple[int, ...], words: list[str]) -> str:
        joints = set(self._joints_of(poly))
        if any("stretched" in sentence for sentence in words):
            return "elbow"
        if self.n >= 5 and self.n - 1 in joints and joints <= set(range(self.n - 2, self.n + 1)):
            return "wrist"
        if joints <= set(self.table.prismatic):
            return "slide"
        if len(joints) == 1 and 0 not in columns and max(joints) > 1:
            return "elbow"
        return "shoulder" if 0 in columns and self.n >= 5 and len(columns) < 3 else "other"

    def _where(self, poly: Poly) -> tuple[float, ...]:
        joints = self._joints_of(poly)
        if len(joints) != 1:
            return ()
        symbol, joint = self.table.variable(joints[0]), joints[0]
        constants = self.table.constants(NumpyField)
        expr = poly.expr()
        if joint in self.table.prismatic:
            at = [float(expr.evaluate(constants | {symbol: x}, NumpyField)) for x in (0.0, 1.0)]
            return (at[0] / (at[0] - at[1]) + 0.0,) if at[0] != at[1] else ()
        a, b, c = first_harmonic(expr, symbol, constants)
        size = np.hypot(a, b)
        if size == 0 or abs(c) > size * (1 + ROUNDING):
            return ()
        middle, half = np.arctan2(b, a), np.arccos(np.clip(-c / size, -1, 1))
        turned = {round(float(np.angle(np.exp(1j * (middle + s * half)))), 12) + 0.0 for s in (1, -1)}
        return tuple(sorted(x if x > -np.pi + WHOLE_TURN else float(np.pi) for x in turned))

    # -- output ----------------------------------------------------------------------------------------------
    def sentences(self) -> list[str]:
        """What is true of the determinant as a whole."""
        if self.minors is None:
            return [TOO_LONG]
        k, k2, m, matrix = self._choice
        where = f"written at the origin of frame {m}, in frame {k}" if m <= self.n else f"at the tool, in frame {k}"
        if self.square:
            if not self.minors:
                return ["The determinant is identically zero: two joints do the same in every posture."]
            largest, count = self.minors[0].largest, len(self.minors[0].factors)
            if count == 1 and largest > 2:
                kept = f"keeps one block of {largest} by {largest}."
                return [f"The determinant does not factor: the Jacobian, {where}, {kept}"]
            told = "is block triangular; its determinant is the product of the blocks' determinants."
            return [f"The Jacobian, {where}, {told}"]
        if not self.minors:
            return ["The Jacobian never has full rank: joints repeat each other's motion in every posture."]
        if any(not minor.factors for minor in self.minors):
            return [f"The Jacobian is {len(matrix)} by {self.n} and keeps its rank in every posture."]
        which = (
            f"all its {len(self.minors)} different largest minors vanish"
            if len(self.minors) > 1
            else ("the one largest minor that is not always zero vanishes")
        )
        told = f"The Jacobian is {len(matrix)} by {self.n}; it loses rank where {which}"
        if len(self.minors) == 1:
            return [told + "."]
        shared = ", which they do together where a factor that they share does."
        return [told + (shared if self.common_factors else "; they share no factor.")]

    @functools.cached_property
    def page(self) -> Document:
        """Sentences and formulas in reading order."""
        page = Document(f"Singular configurations of {self.jacobian.forward.description.name}")
        page.add(*self.sentences())
        if self.determinant is not None and self.minors and len(self.minors[0].poly().terms) <= 200:
            page.show(Written("det J", r"\det J", "<mi>det</mi><mi>J</mi>"), self.determinant)
        for s in self.configurations:
            if not s.possible:
                page.say("The factor ", s.factor, " never vanishes with the lengths of this arm.")
                continue
            page.heading(NAMES[s.kind])
            if s.kind == "other" and len(s.factor.text()) > 150:
                page.say("They are where this determinant vanishes.")
            else:
                page.show(s.factor, ZERO)
            page.say(" ".join(s.words))
            if s.where:
                page.say("That is at ", *self._places(s), ".")
        rest = self._remaining() if not self.square and self.minors else []
        if rest:
            page.heading("Besides" if any(s.possible for s in self.configurations) else "Singular configurations")
            d, sliding = self.jacobian.forward.description, [j - 1 for j in self.table.prismatic]
            size = sum(abs(row.a) + abs(row.d) for row in d.rows) or 1.0
            can = vanish_together([self._value_of(expr) for expr in rest], self.n, sliding, size)
            page.say("Rank is lost where all of these vanish together:" if can else "Rank would be lost where")
            for minor in rest:
                page.show(minor, *([] if can else [ZERO]))
            if not can:
                page.say("together, which cannot be with the lengths of this arm.")
        return broken_lines(page)

    def _remaining(self) -> list[Expr]:
        """What is left of each minor without the shared factors, shortest first; nothing when one is a constant."""
        shared = [p for p, _ in self.common_factors]
        rest = []
        for minor in self.minors or []:
            kept = [f for f in minor.factors if all(f.poly != p and f.poly != -p for p in shared)]
            if not kept:
                return []
            rest.append(mul(*(p.expr() for p in dict.fromkeys(f.poly for f in kept))))
        once = {e.text(): e for e in reversed(rest)}
        return [once[words] for words in sorted(once, key=len) if len(words) < 400][:7]

    def _places(self, s: Singularity) -> list[Piece]:
        """[theta5, " = 0 deg or ", theta5, " = 180 deg"] for a paragraph."""
        joint = next(iter({j for a in s.factor.atoms() if isinstance(a, Trig) for j, _ in a.angle}), None)
        parts: list[Piece] = []
        for place, value in enumerate(s.where):
            size = f"{value * 1000:.6g} mm" if joint is None else f"{np.degrees(value):.6g} deg"
            symbol = s.factor if joint is None else self.table.variable(joint)
            parts += [*([" or "] if place else []), symbol, f" = {size}"]
        return parts

    def sympy(self) -> Any:
        """The factored determinant as a sympy expression, or the list of factors when the Jacobian is not square."""
        if self.determinant is not None:
            return self.determinant.sympy()
        return [p.expr().sympy() for p, _ in self.common_factors]

    def check(self, n: int = 100, *, rng: np.random.Generator | None = None) -> Check:
        """Compare the determinant with the numeric one, and look at the numeric rank on every configuration."""
        rng = rng or np.random.default_rng(20262)
        worst, said = 0.0, []
        if self.determinant is not None:
            q = rng.uniform(-np.pi, np.pi, (n, self.n))
            sense = 1.0 if self.table.letter == "q" else _sense(self.jacobian.forward.description)
            want = np.linalg.det(self._rows(q)) * sense
            got = self._value_of(self.determinant)(q)
            worst = float(np.max(np.abs(got - want)) / max(np.max(np.abs(want)), TINY))
            said.append(
                f"The determinant agrees with the numeric one at {n} random joint vectors to {worst:.1e} of its "
                "largest value."
            )
        count = 0
        for s in self.configurations:
            for q in s.samples:
                values = np.linalg.svd(self._rows(q), compute_uv=False)
                worst, count = max(worst, float(values[-1] / values[0])), count + 1
        if count:
            said.append(
                f"At {count} sampled configurations the numeric Jacobian has lost rank (smallest over largest "
                f"singular value at most {worst:.1e})."
            )
        return Check(n, worst, " ".join(said) or "There is no determinant to check.")


def _sense(d: Description) -> float:
    """What the determinant by the joints' numbers is to that by the table's angles: signs, and the coupling's own."""
    return float(np.prod(d.sign)) / (1.0 if d.coupling is None else float(np.linalg.det(d.coupling)))


def _product(value: Factored) -> Expr:
    pieces: dict = {}
    for f in sorted(value.factors, key=lambda f: len(f.poly.terms)):
        pieces[f.poly] = pieces.get(f.poly, 0) + 1
    return mul(value.scale.expr(), *(p.expr() if k == 1 else p.expr() ** k for p, k in pieces.items()))


def _bare(expr: Expr) -> Expr:
    """The factor without a number in front."""
    if isinstance(expr, Mul) and isinstance(expr.args[0], Num):
        return mul(*expr.args[1:])
    return expr
