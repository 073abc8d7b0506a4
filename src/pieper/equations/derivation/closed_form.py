"""The derivation of the inverse as data: numbered steps that can be evaluated, with every branch, at any precision."""

from __future__ import annotations

import functools
import itertools
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

import numpy as np

from pieper.algebra.arithmetics import DigitsField, NumpyField
from pieper.algebra.exact import exact_inverse
from pieper.algebra.expression import Expr, Num, Sym, Trig, add, angle_symbol, mul
from pieper.description.coupling import joint_values
from pieper.description.dh import Description
from pieper.description.fold import chain_of
from pieper.equations.derivation.degenerate import ELSEWHERE, FREE, MIXED, Array, Case, usual_size, visit
from pieper.equations.derivation.elimination import Eliminator, Move
from pieper.equations.derivation.step import Step, step_of, steps_of
from pieper.equations.derivation.telling import Condition, telling
from pieper.equations.derivation.witness import branch_values
from pieper.equations.table import SymbolTable
from pieper.equations.target import pretty_names
from pieper.equations.vanishing import pose_gap
from pieper.kinematics.chain import Chain
from pieper.kinematics.forward import fk
from pieper.tolerances import (
    BRANCH_MISSES,
    BRANCH_SAME_ANGLE,
    CASE_SAME,
    DEGENERATE_NOISE,
    LED_BACK,
    ROOT_ARGUMENT,
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


#: How a step was decided: by its own formula, by another one, by a value that was chosen, or by nothing on the page.
REGULAR, INSTEAD, CHOSEN, UNDECIDED = WAYS = range(4)


@dataclass(frozen=True, eq=False)
class Branches:
    """Every branch at some poses.

    Attributes:
        q: (branches, N, n) joint vectors, NaN where a branch is no solution.
        values: Every letter of the page, (branches, N) or less.
        ways: Step -> (branches, N) which of `WAYS` decided it; steps that never degenerate are left out.
    """

    q: Array
    values: dict
    ways: dict[int, np.ndarray]


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
        self.steps = steps_of(eliminator, self.renamed)
        self.given = eliminator.target.given
        self._eliminator = eliminator
        self._cases: dict[int, Case] = {}
        self._sizes: dict[int, Array] = {}
        self.conditions: tuple[Condition, ...] = ()
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
        return self.solved(T, chosen).q

    def solved(self, T: Array, chosen: Any = None, *, checked: bool = True) -> Branches:
        """Every branch at poses T with every letter of the page, see `evaluate`.

        Args:
            T: (N, 4, 4) poses.
            chosen: (N, n) as of `evaluate`.
            checked: Whether branches on which a step degenerates must lead back to the pose: where coefficients
                vanish, a step's own equation says no more whether there is a solution.
        """
        T = np.asarray(T, float).reshape(-1, 4, 4)
        q = np.zeros((len(T), self.n)) if chosen is None else np.asarray(chosen, float).reshape(len(T), self.n)
        values = self._values(T, q)
        with np.errstate(all="ignore"):
            size = max(1.0, float(np.abs(T[:, :3]).max(initial=0.0)))
            ways = self._run(values, _Rounded(ROOT_ARGUMENT * size**2), q)
        shape = (self.branches, len(T))
        found = [np.broadcast_to(self._joint(values, j, NumpyField), shape) for j in range(1, self.n + 1)]
        found = joint_values(np.stack(found, axis=-1), self.description.coupling)
        for left, right, _ in self.conditions:
            miss = np.abs(left.evaluate(values, NumpyField) - right.evaluate(values, NumpyField))
            found = np.where((miss < SIDE_CONDITION * (1 + np.abs(T[:, :3]).max()))[..., None], found, np.nan)
        ways = {number: np.broadcast_to(way, shape) for number, way in ways.items()}
        if checked and ways:
            lost = np.any([way != REGULAR for way in ways.values()], axis=0) & ~(self.missed(found, T) < LED_BACK)
            found = np.where(lost[..., None], np.nan, found)
        return Branches(found, values, ways)

    def missed(self, q: Array, T: Array) -> Array:
        """By how much joint vectors (branches, N, n) miss what is given of poses (N, 4, 4); NaN where they are.

        Of the position it is the part of its size, where that is more than one.
        """
        miss = pose_gap(self.poses(np.nan_to_num(q)), T, self.given)
        return np.where(np.isfinite(q).all(axis=2), miss, np.nan)

    def _side_conditions(self) -> tuple:
        """Equations that no step used and that some real branches violate (arms with fewer joints than T has freedoms).

        They are found by trying: at random postures, a branch that does not lead back to the pose is one too many, and
        the shortest equation that holds for the others and not for it is the condition that a page must state.
        """
        e = self._eliminator
        q = np.random.default_rng(11).uniform(-2.5, 2.5, (6, self.n))
        T = self.poses(q)
        found = self.solved(T, q, checked=False)
        miss = self.missed(found.q, T)
        wrong = miss > BRANCH_MISSES
        if not wrong.any():
            return ()
        return telling(e, self.renamed, found.values, np.isfinite(miss) & ~wrong, wrong)

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
        """What happens where a step degenerates: what is said is tried at the postures that were visited."""
        number = step.number
        if number not in self._cases:
            case = visit(self, step)
            self._cases[number] = case
            for option in case.options:
                self._cases[number] = replace(case, chosen=option)
                if self._gives_back(case):
                    break
            else:
                self._cases[number] = case
            if case.kind in (FREE, MIXED, ELSEWHERE):
                self._cases[number] = replace(self._cases[number], conditions=self._told_apart(step, case))
        return self._cases[number]

    def _gives_back(self, case: Case) -> bool:
        """Whether the formulas lead to the postures at which a case was visited."""
        rows = self.solved(self.poses(case.postures), case.postures).q
        gap = rows - case.postures
        turning = [j for j in range(self.n) if j + 1 not in self.table.prismatic]
        gap[..., turning] = np.angle(np.exp(1j * gap[..., turning]))
        return bool((np.nan_to_num(np.abs(gap).max(axis=2), nan=np.inf).min(axis=0) < CASE_SAME).all())

    def _told_apart(self, step: Step, case: Case) -> tuple[Condition, ...] | None:
        """What tells solutions from other choices where a step degenerates; None where all are solutions."""
        rng = np.random.default_rng(17)
        T, q = (np.repeat(x, 3, axis=0) for x in (self.poses(case.postures), case.postures))
        held = [j - 1 for j in self.chosen]
        q[1::3, held] += rng.uniform(-1, 1, (len(case.postures), len(held)))
        found = self.solved(T, q, checked=False)
        miss, here = self.missed(found.q, T), found.ways[step.number] != REGULAR
        wrong = here & (miss > CASE_SAME)
        if not wrong.any():
            return None
        right = here & (miss < LED_BACK)
        return telling(self._eliminator, self.renamed, found.values, right, wrong, LED_BACK / BRANCH_SAME_ANGLE)

    def instead(self, step: Step) -> tuple[Step, ...]:
        """The steps that decide where this one degenerates, () where none do."""
        case = self.case(step) if step.degenerate else None
        if case is None or case.chosen is None:
            return ()
        moves, eliminator = case.chosen
        renamed = {**pretty_names([n for m in [*self.moves, *moves] for n in m.names]), **self.renamed}
        found = [step_of(eliminator, renamed, step.number, move) for move in moves]
        signs = {one.sigma for one in found if one.sigma is not None}
        if not signs or case.sigma is None:
            return tuple(found)
        swap = dict.fromkeys(signs, case.sigma)
        return tuple(
            replace(one, formula=one.formula.substitute(swap), sigma=case.sigma if one.sigma in signs else None)
            for one in found
        )

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

    def _run(self, values: dict, field: Any, chosen: Array | None = None) -> dict[int, np.ndarray]:
        """Fill in every letter; return how each step that degenerates somewhere was decided, number -> `WAYS`."""
        ways: dict[int, np.ndarray] = {}
        for step in self.steps:
            for symbol, expression in step.names:
                values[symbol] = expression.evaluate(values, field)
            value = step.formula.evaluate(values, field)
            if step.degenerate and chosen is not None:
                value, ways[step.number] = self._where_degenerate(step, value, values, chosen)
            values[step.symbol] = value
            (joint, factor), *others = step.angle
            if others or factor != 1:
                group = self.table.groups[joint - 1]
                values[Trig("c", step.angle, group)] = field.cos(value)
                values[Trig("s", step.angle, group)] = field.sin(value)
        return ways

    def _where_degenerate(self, step: Step, value: Any, values: dict, chosen: Array) -> tuple[Array, np.ndarray]:
        """The value of a step, where it degenerates that of the step which decides instead, or the chosen one."""
        usual = self._usual(step.number)
        sizes = [np.abs(c.evaluate(values, NumpyField)) / u for c, u in zip(step.degenerate, usual, strict=True)]
        gone = np.max(np.broadcast_arrays(*sizes), axis=0) < DEGENERATE_NOISE
        if not gone.any():
            return value, gone.astype(int)
        case, instead = self.case(step), self.instead(step)
        if instead:
            here = dict(values)
            for other in instead:
                for symbol, expression in other.names:
                    here.setdefault(symbol, expression.evaluate(here, NumpyField))
                if other.sigma is not None:
                    here.setdefault(other.sigma, 1.0)
                here[other.symbol] = other.formula.evaluate(here, NumpyField)
            values |= {symbol: v for symbol, v in here.items() if symbol not in values and symbol.rank == 4}
            return np.where(gone, here[step.symbol], value), gone * INSTEAD
        if case.kind not in (FREE, MIXED):
            return value, gone * UNDECIDED
        here = self.table.values(chosen.T, NumpyField)
        group = self.table.variable(step.angle[0][0])
        free = here[group] if len(step.angle) == 1 else sum(k * here[angle_symbol(j)] for j, k in step.angle)
        return np.where(gone, free, value), gone * CHOSEN

    def _usual(self, number: int) -> Array:
        """The size of a step's coefficients at random postures (m,), in which lengths of any unit count alike."""
        if number not in self._sizes:
            self._sizes[number] = usual_size(self, self.steps[number - 1])
        return self._sizes[number]

    def _joint(self, values: dict, joint: int, field: Any) -> Any:
        """The value of an axis from its table variable: theta = sign value + constant."""
        return (values[self.table.variable(joint)] - self.table.constant(joint, field)) * int(
            round(float(self.description.sign[joint - 1]))
        )
