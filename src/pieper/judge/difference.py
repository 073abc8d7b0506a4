"""The difference between a printed formula and the right one, and the digits to which two formulas agree."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from pieper.algebra.arithmetics import DigitsField, SympyField
from pieper.algebra.expression import Call, Expr, Num, Power
from pieper.algebra.formula import Equation, has_branch, is_call
from pieper.algebra.notation import TURNS, joint_sum
from pieper.judge.model import POSE_NAMES, ArmModel, decimal
from pieper.judge.samples import Samples

MAX_NODES = 600  # expanding more takes longer than a reader waits
DIGITS = 50
IDENTICAL = 30  # digits; equal formulas agree to all but the last few
FEW = 11  # where numbers of the arm are rounded to doubles
LONG = 10**10  # a decimal with more digits than this is a rounded one
MAX_POWER = 8  # higher ones are multiplied out into more terms than a reader can use


class _Polynomials(SympyField):
    """Symbols for every sine and cosine of one joint.

    Sums of angles are written out, so that equal formulas become equal polynomials.
    """

    def __init__(self) -> None:
        super().__init__()
        self.sin, self.cos = (lambda x: self._turn(x)[1]), (lambda x: self._turn(x)[0])

    def _turn(self, x: Any) -> tuple[Any, Any]:
        sp = self.sympy
        c, s = sp.Integer(1), sp.Integer(0)
        for term in sp.Add.make_args(x):
            factor, angle = term.as_coeff_Mul()
            if angle.is_Symbol and str(angle).startswith("theta") and factor in (1, -1):
                ci, si = sp.Symbol(f"c{str(angle)[5:]}"), factor * sp.Symbol(f"s{str(angle)[5:]}")
            else:
                ci, si = sp.cos(term), sp.sin(term)
            c, s = c * ci - s * si, s * ci + c * si
        return c, s

    def factored(self, total: Any, longest: int) -> str:
        """The expanded polynomial in factors; "" when it has too many terms to be of use, or no value."""
        total = self.sympy.expand(total)
        if len(self.sympy.Add.make_args(total)) > longest or total.has(self.sympy.zoo, self.sympy.nan):
            return ""
        return str(self.sympy.factor(total)).replace("**", "^").replace("*", " ")


def simplified_difference(printed: Expr, right: Expr) -> str:
    """Return printed minus right as a factored polynomial in c1, s1, ...; "" when it is not one or takes too long."""
    if printed.size() + right.size() > MAX_NODES or not (_polynomial(printed) and _polynomial(right)):
        return ""
    field = _Polynomials()

    def value(tree: Expr) -> Any:
        return tree.evaluate({name: field.sympy.Symbol(name) for name in tree.symbols()}, field)

    if isinstance(printed, Equation) and isinstance(right, Equation):
        gap = [value(p) - value(r) for p, r in zip(printed.args, right.args, strict=True)]
        return field.factored(gap[1] if gap[1] != 0 else gap[0], 60)
    return field.factored(value(printed) - value(right), 60)


def _polynomial(formula: Expr) -> bool:
    calls = [node for node in formula.walk() if isinstance(node, Call)]
    angles = [node.args[0] for node in calls if is_call(node, *TURNS)]
    powers = [node.power for node in formula.walk() if isinstance(node, Power)]
    return (
        all(type(p) is int and abs(p) <= MAX_POWER for p in powers)
        and len(angles) == len(calls)
        and not has_branch(formula)
        and not any(a.symbols() and not joint_sum(a) for a in angles)
    )


def difference_from_matrix(printed: Expr, model: ArmModel, entry: tuple[int, int], zeros: Collection[str]) -> str:
    """Return a printed entry minus the entry (1-based) of T, simplified; "" when that is too long to be of use.

    Lengths that are zero for this arm are left out, but for `zeros`, which stay letters.
    """
    if printed.size() > 150 or model.n > 6 or not _polynomial(printed):
        return ""
    field = _Polynomials()
    names = {*(f"theta{k + 1}" for k in range(model.n)), *model.values, *printed.symbols()}
    gone = {name for name, value in model.values.items() if not value and name not in zeros}
    env = {name: field.sympy.Integer(0) if name in gone else field.sympy.Symbol(name) for name in names}
    right = model.pose_exact(env, field)[entry[0] - 1][entry[1] - 1]
    return field.factored(printed.evaluate(env, field) - right, 12)


def _exact_environment(model: ArmModel, samples: Samples, k: int, definitions: dict[str, Expr], field: Any) -> dict:
    """Return every symbol at sample k with 50 digits; joint angles are the tenths of a degree they were drawn as."""
    env = {name: field.rational(decimal(samples.env[name][k])) for name in model.values}
    for joint in range(1, model.n + 1):
        value = samples.q[k, joint - 1]
        if model.sliding(joint):
            env[f"theta{joint}"] = field.rational(decimal(value))
        else:
            env[f"theta{joint}"] = field.rational(Fraction(f"{np.degrees(value):z.1f}")) * field.pi / 180
    for alias, target in model.aliases.items():
        env[alias] = env[target]
    T = model.pose_exact(env, field)
    env |= {name: T[i][j] for name, i, j in POSE_NAMES}
    env["roll"], env["yaw"] = field.atan2(T[2][1], T[2][2]), field.atan2(T[1][0], T[0][0])
    env["pitch"] = field.atan2(-T[2][0], field.hypot(T[0][0], T[1][0]))
    env |= {name: field.rational(decimal(v[k])) for name, v in samples.env.items() if name.endswith("?")}
    for name, tree in definitions.items():
        if tree.symbols() <= env.keys():  # entries of matrices are in double precision only
            env[name] = tree.evaluate(env, field)
    return env


def digits_wanted(model: ArmModel, node: Expr) -> int:
    """To how many digits a formula that is right agrees at 50-digit arithmetic.

    All of them, unless the arm or the formula holds numbers that are themselves rounded to double precision.
    """
    ends = np.concatenate([model.base[:3].ravel(), model.tool[:3].ravel()])
    long = any(_many_digits(decimal(v)) for v in ends)
    long |= any(_many_digits(decimal(v)) for v in model.values.values())
    numbers = [n for cells in model.rows for c in (cells.alpha, cells.theta) for n in c.walk()] + list(node.walk())
    long |= any(isinstance(n, Num) and _many_digits(n.value) for n in numbers)
    return FEW if long else IDENTICAL


def _many_digits(value: Fraction) -> bool:
    return min(abs(value.numerator), value.denominator) > LONG


def agreeing_digits(
    model: ArmModel,
    samples: Samples,
    definitions: dict[str, Expr],
    left: Expr,
    right: Expr | tuple[int, int],
    *,
    angle: bool = False,
    at: Sequence[int] = (0, 1),
) -> int:
    """Return to how many digits two formulas (or a formula and an entry of T) agree, at 50-digit arithmetic.

    The least over the samples `at`; at most 48, because the last digits are rounding.
    """
    import mpmath

    worst = DIGITS - 2
    with mpmath.workdps(DIGITS):
        field = DigitsField()
        for k in at:
            env = _exact_environment(model, samples, k, definitions, field)
            wanted = right.evaluate(env, field) if isinstance(right, Expr) else env[f"r{right[0] + 1}{right[1] + 1}"]
            gaps = []
            for branch in (1, -1):
                gap = abs(left.evaluate(env, field, branch) - wanted)
                if angle:
                    gap = gap % (2 * field.pi)
                    gap = min(gap, abs(gap - 2 * field.pi))
                if gap == gap:
                    gaps.append(gap)
            if not gaps:
                return 0
            gap = min(gaps) / (abs(wanted) + mpmath.mpf("1e-6"))
            worst = min(worst, DIGITS - 2 if gap == 0 else int(-mpmath.log10(gap)))
    return max(worst, 0)
