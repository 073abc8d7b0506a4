"""The derivation of the inverse as data: numbered steps that can be evaluated, with every branch, at any precision."""

from __future__ import annotations

import functools
import itertools
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np

from pieper.algebra.arithmetics import DigitsField, NumpyField
from pieper.algebra.exact import exact_inverse
from pieper.algebra.expression import Expr, Num, Sym, Trig, add, angle_symbol, mul
from pieper.description.coupling import joint_values
from pieper.description.dh import Description
from pieper.description.fold import chain_of
from pieper.equations.derivation.degenerate import FREE, MIXED, Array, Case, visit
from pieper.equations.derivation.elimination import Eliminator, Move, Source
from pieper.equations.derivation.step import Step
from pieper.equations.derivation.witness import branch_values
from pieper.equations.table import SymbolTable
from pieper.equations.target import pretty_names
from pieper.kinematics.chain import Chain
from pieper.kinematics.forward import fk
from pieper.tolerances import (
    BRANCH_MISSES,
    BRANCH_OTHER_ANGLE,
    BRANCH_SAME_ANGLE,
    DEGENERATE_NOISE,
    ROOT_ARGUMENT,
    ROUNDING,
    SIDE_CONDITION,
)


class _Rounded(NumpyField):
    """Double precision in which a root that rounding pushed below zero is zero: two branches meet there."""

    def __init__(self, slack: float) -> None:
        self._slack = slack

    def sqrt(self, x: Any) -> Any:  # pyright: ignore[reportIncompatibleMethodOverride]
        """Square root; of numbers just below zero, zero."""
        x = np.asarray(x, dtype=float)
        return np.sqrt(np.where((x < 0) & (x > -self._slack), 0.0, x))


class ClosedForm:
    """Formulas for every joint that hold together, branch by branch.

    Attributes:
        steps: The derivation.
        chosen: Joints (1-based) whose value is chosen beforehand; then `free`: joints that come out as free.
    """

    def __init__(self, eliminator: Eliminator, description: Description, *, fold_tool: bool) -> None:
        self.table: SymbolTable = eliminator.table
        self.n = self.table.n
        self.description = description
        self.fold_tool = fold_tool
        self.chosen = tuple(sorted(set(eliminator.chosen)))
        self.free = tuple(eliminator.free)
        self.renamed = pretty_names([name for move in eliminator.moves for name in move.names])
        self.steps = _steps(eliminator, self.renamed)
        self.given = eliminator.target.given
        self._eliminator = eliminator
        self._cases: dict[int, Case] = {}
        self.conditions: tuple[tuple[Expr, Expr, Source], ...] = ()
        self.conditions = self._side_conditions()

    @property
    def sigmas(self) -> tuple[Sym, ...]:
        """The branch signs, in order."""
        return tuple(s.sigma for s in self.steps if s.sigma is not None)

    @property
    def branches(self) -> int:
        """How many combinations of branch signs there are."""
        return len(self._choices())

    def _choices(self) -> list[tuple[float, ...]]:
        """All combinations of the branch symbols' values."""
        return list(itertools.product(*(branch_values(s.branches) for s in self.steps if s.sigma is not None)))

    @property
    def formulas(self) -> dict[Sym, Expr]:
        """One formula a joint, in the order in which they are to be evaluated."""
        return {s.symbol: s.formula for s in self.steps}

    # -- evaluation ------------------------------------------------------------------------------------------
    def evaluate(self, T: Array, *, chosen: Any = None) -> np.ndarray:
        """Every branch at poses T.

        Args:
            T: (N, 4, 4) poses, base to tool.
            chosen: (N, n) joint vectors from which the values of chosen and free joints are taken; zero without.

        Returns:
            (branches, N, n) joint vectors; NaN where a branch is not real. The sign of branch b in `sigmas[k]` is the
            k-th of the b-th row of the product of (1, -1).
        """
        T = np.asarray(T, float).reshape(-1, 4, 4)
        q = np.zeros((len(T), self.n)) if chosen is None else np.asarray(chosen, float).reshape(len(T), self.n)
        values = self._values(T, q)
        with np.errstate(all="ignore"):
            size = max(1.0, float(np.abs(T[:, :3]).max(initial=0.0)))
            self._run(values, _Rounded(ROOT_ARGUMENT * size**2), q)
        shape = (self.branches, len(T))
        found = [np.broadcast_to(self._joint(values, j, NumpyField), shape) for j in range(1, self.n + 1)]
        found = joint_values(np.stack(found, axis=-1), self.description.coupling)
        for left, right, _ in self.conditions:
            miss = np.abs(left.evaluate(values, NumpyField) - right.evaluate(values, NumpyField))
            found = np.where((miss < SIDE_CONDITION * (1 + np.abs(T[:, :3]).max()))[..., None], found, np.nan)
        return found

    def _side_conditions(self) -> tuple:
        """Equations that no step used and that some real branches violate (arms with fewer joints than T has freedoms).

        They are found by trying: at random postures, a branch that does not lead back to the pose is one too many, and
        the shortest equation that holds for the others and not for it is the condition that a page must state.
        """
        e = self._eliminator
        q = np.random.default_rng(11).uniform(-2.5, 2.5, (6, self.n))
        truth = self.table.values(q.T, NumpyField)
        M = np.zeros((6, 4, 4))
        for r, c in itertools.product(range(4), range(4)):
            M[:, r, c] = e.product(0, self.n)[r][c].evaluate(truth)
        T = self.poses(q)
        found = self.evaluate(T, chosen=q)
        values = self._values(T, q)
        self._run(values, NumpyField)
        back = self.table.values(np.moveaxis(found, -1, 0), NumpyField)
        columns = ["noap".index(c) for c in self.given]
        miss = np.zeros(found.shape[:2])
        for r, c in itertools.product(range(3), columns):
            miss = np.maximum(miss, np.abs(e.product(0, self.n)[r][c].evaluate(back) - M[:, r, c]))
        real = np.isfinite(miss)
        wrong = real & (miss > BRANCH_MISSES)
        if not wrong.any():
            return ()
        chosen = []
        for equation in sorted(e.spare_equations(), key=lambda q: len(q.left.terms) + len(q.right.terms)):
            if not wrong.any() or len(chosen) == 3:
                break
            left, right = (p.expr().substitute(self.renamed) for p in (equation.left, equation.right))
            if not (left.atoms() | right.atoms()) <= set(values) | {
                t for t in left.atoms() | right.atoms() if isinstance(t, Trig)
            }:
                continue
            gap = np.broadcast_to(
                np.abs(left.evaluate(values, NumpyField) - right.evaluate(values, NumpyField)), real.shape
            )
            if (gap[real & ~(miss > BRANCH_MISSES)] < BRANCH_SAME_ANGLE).all() and (
                gap[wrong] > BRANCH_OTHER_ANGLE
            ).any():
                chosen.append((left, right, equation.source))
                wrong = wrong & ~(gap > BRANCH_OTHER_ANGLE)
        return tuple(chosen)

    @property
    def moves(self) -> list[Move]:
        """The moves that the steps were made of."""
        return self._eliminator.moves

    @property
    def constants(self) -> dict:
        """Numbers for the lengths and twists."""
        return self.table.constants(NumpyField)

    @property
    def cases(self) -> dict[int, Case]:
        """Step number -> what happens where that step degenerates, for the steps that can."""
        return {step.number: self.case(step) for step in self.steps if step.degenerate}

    def case(self, step: Step) -> Case:
        """What happens where a step degenerates."""
        if step.number not in self._cases:
            self._cases[step.number] = visit(self, step)
        return self._cases[step.number]

    def instead(self, step: Step) -> Step | None:
        """The step that decides where this one degenerates, None where none does."""
        case = self.case(step) if step.degenerate else None
        if case is None or case.other is None or case.eliminator is None:
            return None
        moves = [*self.moves[: step.number - 1], case.other]
        renamed = {**pretty_names([n for m in [*self.moves, case.other] for n in m.names]), **self.renamed}
        found = _step(case.eliminator, renamed, step.number, moves[-1])
        if found.sigma is None or case.sigma is None:
            return found
        swap = {found.sigma: case.sigma}
        return replace(found, formula=found.formula.substitute(swap), sigma=case.sigma)

    def replayed(self, moves: int) -> Eliminator:
        """The elimination as it stood after so many steps."""
        e = self._eliminator
        again = Eliminator(self.table, given=self.given, chosen=tuple(self.chosen), fold_tool=self.fold_tool)
        again.free = list(e.free)
        again.follow_sums()
        while len(again.moves) < moves and (move := again.best()) is not None:
            again.take(move)
        return again

    def poses(self, q: Array) -> Array:
        """Poses (N, 4, 4) of joint vectors (N, n)."""
        return fk(self._chain, q)

    @functools.cached_property
    def _chain(self) -> Chain:
        return chain_of(self.description)

    def values_on_branches(self, T: Array) -> dict:
        """Every letter of the page at poses T (N, 4, 4), shorthands and joints included: (branches, N) or less."""
        values = self._values(T, np.zeros((len(T), self.n)))
        with np.errstate(all="ignore"):
            self._run(values, NumpyField)
        return values

    def values_at(self, q: Array) -> dict:
        """Values (N,) of lengths, pose letters and every joint at joint vectors (N, n) and their own poses."""
        values = self._values(self.poses(q), q)
        return values | self.table.values(q.T, NumpyField)

    def _values(self, T: Array, q: Array) -> dict:
        signs = np.array(self._choices()).reshape(self.branches, -1)
        values = self.table.constants(NumpyField)
        values |= dict(zip(self.sigmas, (s[:, None] for s in signs.T), strict=True))
        M = np.linalg.inv(self.description.base) @ T
        if not self.fold_tool:
            M = M @ np.linalg.inv(self.description.tool)
        values |= {Sym(c, x, 4): M[:, r, k] for k, c in enumerate("noap") for r, x in enumerate("xyz")}
        return values | self._given_joints(q.T, NumpyField)

    def evaluate_digits(self, M: Any, *, chosen: Any = None, digits: int = 50) -> list[list]:
        """Every branch at one pose in many-digit arithmetic.

        Args:
            M: 4x4 nested lists of mpmath numbers, the pose in the table's frames (base and tool taken off).
            chosen: Values of chosen and free joints, one a joint of the arm.
            digits: How many digits the answers are to have.

        Returns:
            One list of n mpmath numbers (nan where not real) a branch.
        """
        import mpmath

        found = []
        with mpmath.workdps(digits + 10):
            field = DigitsField()
            start = self.table.constants(field)
            start |= {Sym(c, x, 4): M[r][k] for k, c in enumerate("noap") for r, x in enumerate("xyz")}
            start |= self._given_joints(chosen or [mpmath.mpf(0)] * self.n, field)
            for signs in self._choices():
                values = start | dict(zip(self.sigmas, map(mpmath.mpf, signs), strict=True))
                self._run(values, field)
                axes = [self._joint(values, j, field) for j in range(1, self.n + 1)]
                found.append(self._joints_of(axes, field))
        return found

    @functools.cached_property
    def of_axes(self) -> tuple[tuple[Fraction, ...], ...]:
        """Of coupled joints the rows that make a joint's number of the axes' values, exactly; else none."""
        coupling = self.description.coupling
        return () if coupling is None else exact_inverse(coupling.tolist())

    def _joints_of(self, axes: list[Any], field: Any) -> list[Any]:
        """The joints' numbers of the axes' values."""
        if not self.of_axes:
            return axes
        return [sum(field.rational(c) * v for c, v in zip(by, axes, strict=True) if c) for by in self.of_axes]

    @functools.cached_property
    def joint_formulas(self) -> dict[Sym, Expr]:
        """The number of each joint that is tied to others, in the equations' symbols: q3 = theta3 - theta2."""
        found: dict[Sym, Expr] = {}
        for joint, by in enumerate(self.of_axes, 1):
            if [c != 0 for c in by] == [k == joint for k in range(1, self.n + 1)] and by[joint - 1] == 1:
                continue
            terms: list[Expr] = []
            for k, c in enumerate(by, 1):
                if c:
                    symbol, expression = self.table.relation[k]
                    turn = c * int(round(float(self.description.sign[k - 1])))
                    none = {angle_symbol(j, "q"): Num(0) for j in range(1, self.n + 1)}
                    terms.append(mul(Num(turn), add(symbol, mul(Num(-1), expression.substitute(none)))))
            found[angle_symbol(joint, "q")] = add(*terms)
        return found

    def _given_joints(self, q: Any, field: Any) -> dict:
        values = {}
        for joint in (*self.chosen, *self.free):
            symbol, expression = self.table.relation[joint]
            values[symbol] = expression.evaluate({angle_symbol(k + 1, "q"): q[k] for k in range(self.n)}, field)
        return values

    def _run(self, values: dict, field: Any, chosen: Array | None = None) -> None:
        for step in self.steps:
            for symbol, expression in step.names:
                values[symbol] = expression.evaluate(values, field)
            value = step.formula.evaluate(values, field)
            if step.degenerate and chosen is not None:
                value = self._where_degenerate(step, value, values, chosen)
            values[step.symbol] = value
            (joint, factor), *others = step.angle
            if others or factor != 1:
                group = self.table.groups[joint - 1]
                values[Trig("c", step.angle, group)] = field.cos(value)
                values[Trig("s", step.angle, group)] = field.sin(value)

    def _where_degenerate(self, step: Step, value: Any, values: dict, chosen: Array) -> Array:
        """The value of a step, where it degenerates that of the step which decides instead, or the chosen one."""
        sizes = [np.abs(c.evaluate(values, NumpyField)) for c in step.degenerate]
        gone = np.max(np.broadcast_arrays(*sizes), axis=0) < DEGENERATE_NOISE
        if not gone.any():
            return value
        case, instead = self.case(step), self.instead(step)
        if instead is not None:
            for symbol, expression in instead.names:
                values.setdefault(symbol, expression.evaluate(values, NumpyField))
            if instead.sigma is not None:
                values.setdefault(instead.sigma, 1.0)
            return np.where(gone, instead.formula.evaluate(values, NumpyField), value)
        if case.kind not in (FREE, MIXED):
            return value
        here = self.table.values(chosen.T, NumpyField)
        group = self.table.variable(step.angle[0][0])
        free = here[group] if len(step.angle) == 1 else sum(k * here[angle_symbol(j)] for j, k in step.angle)
        return np.where(gone, free, value)

    def _joint(self, values: dict, joint: int, field: Any) -> Any:
        """The value of an axis from its table variable: theta = sign value + constant."""
        return (values[self.table.variable(joint)] - self.table.constant(joint, field)) * int(
            round(float(self.description.sign[joint - 1]))
        )


def _steps(eliminator: Eliminator, table: dict) -> tuple[Step, ...]:
    return tuple(_step(eliminator, table, number, move) for number, move in enumerate(eliminator.moves, 1))


def _step(eliminator: Eliminator, table: dict, number: int, move: Move) -> Step:
    constants = eliminator.table.constants(NumpyField)

    def tidy(expr: Expr) -> Expr:
        return expr.substitute(table)

    names = [(table[s], tidy(eliminator.target.definitions[s].expr())) for s in move.names]
    names += [(s, tidy(x)) for s, x in move.solved.definitions]
    return Step(
        number,
        move.symbol,
        move.angle,
        tuple(e.source for e in move.equations),
        tuple(names),
        tuple((tidy(e.left.expr()), tidy(e.right.expr())) for e in move.equations),
        tidy(move.solved.formula),
        move.sigma,
        move.solved.kind,
        _vanishing([tidy(x) for x in move.solved.degenerate], constants),
        tidy(move.solved.merge) if move.solved.merge is not None else None,
    )


def _vanishing(conditions: list[Expr], constants: dict) -> tuple[Expr, ...]:
    """The conditions, or nothing when one of them is a length that does not vanish."""
    for condition in conditions:
        if condition.atoms() <= set(constants) and abs(condition.evaluate(constants, NumpyField)) > ROUNDING:
            return ()
    return tuple(c for c in conditions if not (isinstance(c, Num) and c.value == 0))
