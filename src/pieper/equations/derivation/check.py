"""Whether a derivation holds: every branch against every solution of the solver, each formula, and at 50 digits."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from pieper.algebra.arithmetics import DigitsField, NumpyField
from pieper.algebra.expression import Sym, angle_symbol
from pieper.description.coupling import chain_values
from pieper.equations.arm import Arm
from pieper.equations.derivation.closed_form import ClosedForm
from pieper.equations.derivation.witness import branch_values
from pieper.equations.vanishing import pose_gap
from pieper.errors import PieperError
from pieper.kinematics.arrays import Array
from pieper.tolerances import (
    CHOSEN_VALUE,
    DERIVED_AT_POSE,
    DERIVED_NEAR,
    DERIVED_SAME,
    MERGED_BRANCHES,
    UNLIMITED,
)

DIGITS_POSES = 3


@dataclass(frozen=True)
class DerivationCheck:
    """How often and how well a derivation held.

    Attributes:
        poses: Random poses tried.
        solutions: Solutions that the solver found at them, all together.
        reproduced: How many of those one choice of branch signs gives.
        worst: Largest joint deviation among those (rad or m).
        real: Branch combinations that were real, all together.
        valid: How many of those reach the pose.
        digits_worst: Largest deviation in 50-digit arithmetic (a number such as 1e-49); None when not tried.
        formulas: symbol -> (times evaluated, times held, largest deviation), with the joints before it from the solver.
    """

    poses: int
    solutions: int
    reproduced: int
    worst: float
    real: int
    valid: int
    digits_worst: float | None
    formulas: dict

    @property
    def what(self) -> str:
        """The result in sentences."""
        said = [
            f"At {self.poses} random poses the solver finds {self.solutions} solutions; "
            f"{_all(self.reproduced, self.solutions)} of them {'is' if self.reproduced == 1 else 'are'} given by one "
            f"choice of the branch signs, to {self.worst:.1e} rad (or m) at worst."
        ]
        if self.real:
            said.append(f"Of {self.real} real combinations of signs {_all(self.valid, self.real)} reach the pose.")
        if self.digits_worst is not None:
            said.append(f"In 50-digit arithmetic the joints come back to {self.digits_worst:.0e}.")
        return " ".join(said)

    @property
    def holds(self) -> bool:
        """Whether every solution was reproduced."""
        return self.solutions > 0 and self.reproduced == self.solutions

    def __str__(self) -> str:
        return self.what


def check(form: ClosedForm, arm: Arm, n: int, rng: np.random.Generator) -> DerivationCheck:
    """Compare a closed form with the arm's own solver and forward kinematics at `n` random poses."""
    d = arm.description
    q = rng.uniform(*_range(d, form), (n, form.n))
    T = arm.fk(q)
    values = form.evaluate(T, chosen=q)
    turning = np.array([kind == "R" for kind in d.joint_types])
    total = reproduced = real = valid = 0
    worst = 0.0
    told: list[tuple[Array, np.ndarray]] = []
    for k in range(n):
        found = _solutions(arm, T[k], q[k], form)
        branches = values[:, k]
        branches = branches[np.all(np.isfinite(branches), axis=1)]
        mine = _same_choice(found, q[k], form)
        total += len(mine)
        for solution in mine:
            gap = _gap(_axes(branches, form), _axes(solution, form), turning)
            if len(gap) and _same(branches[int(np.argmin(gap))], float(gap.min()), T[k], arm, form):
                reproduced += 1
                worst = max(worst, float(gap.min()))
        real += len(branches)
        if len(branches):
            valid += int(np.sum(pose_gap(arm.fk(branches), T[k], form.given) < DERIVED_SAME))
        told += [(T[k], np.array(mine))] if len(mine) else []
    formulas = _by_formula(form, told)
    return DerivationCheck(n, total, reproduced, worst, real, valid, _digits(form, arm, rng), formulas)


def _solutions(arm: Arm, T: Array, q: Array, form: ClosedForm) -> list[np.ndarray]:
    """All solutions the solver has for the pose and the chosen joints' values; q alone where there is no solver."""
    found = [q]
    try:
        values = [float(q[j - 1]) for j in form.chosen]
        rows = arm.ik(T, redundancy=values if len(values) > 1 else values[0] if values else None).all_q
    except PieperError:
        return found
    turning = np.array([kind == "R" for kind in arm.description.joint_types])
    for row in rows[pose_gap(arm.fk(rows), T, form.given) < DERIVED_SAME]:
        if _gap(_axes(np.array(found), form), _axes(row, form), turning).min() > MERGED_BRANCHES:
            found.append(np.asarray(row))
    return found


def _same_choice(found: Any, q: Array, form: ClosedForm) -> list:
    """Solutions with the same values of the chosen and free joints (formulas cannot give others)."""
    fixed = [j - 1 for j in (*form.chosen, *form.free)]
    return [row for row in found if all(abs(np.angle(np.exp(1j * (row[j] - q[j])))) < CHOSEN_VALUE for j in fixed)]


def _gap(rows: np.ndarray, solution: np.ndarray, turning: np.ndarray) -> np.ndarray:
    gap = np.abs(rows - solution)
    turn = np.abs(np.angle(np.exp(1j * (rows - solution))))
    return np.where(turning, turn, gap).max(axis=1) if len(rows) else np.zeros(0)


def _same(branch: np.ndarray, gap: float, T: Array, arm: Arm, form: ClosedForm) -> bool:
    """Whether a branch is a solution: the same joints, or joints near them that take the pose to its last digits."""
    if gap < DERIVED_SAME:
        return True
    return gap < DERIVED_NEAR and float(pose_gap(arm.fk(branch), T, form.given)) < DERIVED_AT_POSE


def _axes(q: np.ndarray, form: ClosedForm) -> np.ndarray:
    """Values of the axes, in which whole turns count for nothing, at joint vectors (..., n)."""
    return chain_values(q, form.description.coupling)


def _by_formula(form: ClosedForm, told: list[tuple[Array, np.ndarray]]) -> dict:
    """Evaluate each formula with everything before it taken from the solver's solutions, at all poses at once.

    Args:
        form: The formulas.
        told: Poses (4, 4), each with its solutions (m, n).

    Returns:
        How often each formula was tried and held, and the largest gap where it held.
    """
    formulas: dict = {}
    if not told:
        return formulas
    d = form.description
    poses = np.concatenate([np.repeat(T[None], len(rows), axis=0) for T, rows in told])
    M = np.linalg.inv(d.base) @ poses @ (np.eye(4) if form.fold_tool else np.linalg.inv(d.tool))
    truth = form.table.values(np.concatenate([rows for _, rows in told]).T, NumpyField)
    values = dict(truth)
    values |= {Sym(c, x, 4): M[:, r, k] for k, c in enumerate("noap") for r, x in enumerate("xyz")}
    for step in form.steps:
        for symbol, expression in step.names:
            values[symbol] = expression.evaluate(values, NumpyField)
        want = truth.get(step.symbol)
        if want is None:
            want = np.sum([k * truth[angle_symbol(j)] for j, k in step.angle], axis=0)
        gaps, signs = [], branch_values(step.branches)
        for sign in signs:
            if step.sigma is not None:
                values[step.sigma] = sign
            gap = step.formula.evaluate(values, NumpyField) - want
            slides = step.angle[0][0] in form.table.prismatic
            gaps.append(np.broadcast_to(np.abs(gap if slides else np.angle(np.exp(1j * gap))), want.shape))
        gaps = np.where(np.isfinite(gaps), gaps, np.inf)
        if step.sigma is not None:
            values[step.sigma] = np.array(signs)[np.argmin(gaps, axis=0)]
        best = np.min(gaps, axis=0)
        good = best < DERIVED_SAME
        formulas[step.symbol] = (len(best), int(good.sum()), float(best[good].max(initial=0.0)))
        values[step.symbol] = want
    return formulas


def _digits(form: ClosedForm, arm: Arm, rng: np.random.Generator) -> float | None:
    """Largest deviation of the branch that is the joint vector the pose was made from, at 50 digits."""
    import mpmath

    from pieper.equations.forward import ForwardEquations

    equations = ForwardEquations(arm.description)
    worst = mpmath.mpf(0)
    with mpmath.workdps(60):
        for _ in range(DIGITS_POSES):
            q = [mpmath.mpf(round(x, 6)) for x in rng.uniform(-2.5, 2.5, form.n)]
            field_values = equations.table.values(q, DigitsField())
            M = equations.flange.evaluate(field_values, DigitsField())
            if form.fold_tool:
                tool = [[p.expr().evaluate(field_values, DigitsField()) for p in row] for row in form.table.tool]
                M = [[sum(M[r][k] * tool[k][c] for k in range(4)) for c in range(4)] for r in range(4)]
            gaps = []
            for branch in form.evaluate_digits(M, chosen=q):
                if all(x == x for x in branch):
                    here = equations.table.values(branch, DigitsField())
                    symbols = [equations.table.variable(j) for j in range(1, form.n + 1)]
                    apart = [here[symbol] - field_values[symbol] for symbol in symbols]
                    gaps.append(max(map(_turn, apart, arm.description.joint_types)))
            if not gaps:
                return None
            worst = max(worst, min(gaps))
        return float(worst)


def _turn(gap: Any, kind: str) -> Any:
    import mpmath

    return abs(gap) if kind == "P" else abs(mpmath.atan2(mpmath.sin(gap), mpmath.cos(gap)))


def _range(d: Any, form: ClosedForm) -> tuple[np.ndarray, np.ndarray]:
    """Lower and upper ends to draw joints from: a whole turn, but the limits of slides and of chosen joints."""
    slides = np.array([kind == "P" for kind in d.joint_types])
    reach = np.where(slides, sum(abs(r.a) + abs(r.d) for r in d.rows) + 0.1, np.pi)
    held = slides | np.isin(np.arange(form.n) + 1, form.chosen)
    limits = np.clip(np.asarray(d.limits, float), -UNLIMITED, UNLIMITED)
    lower = np.where(held & np.isfinite(d.limits[:, 0]), np.maximum(limits[:, 0], -reach), -reach)
    upper = np.where(held & np.isfinite(d.limits[:, 1]), np.minimum(limits[:, 1], reach), reach)
    return np.where(lower < upper, lower, -reach), np.where(lower < upper, upper, reach)


def _all(part: int, whole: int) -> str:
    return f"all {whole}" if part == whole else str(part)
