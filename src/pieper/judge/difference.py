"""The difference between a printed formula and the right one, and the digits to which two formulas agree."""

from __future__ import annotations

import numpy as np

from pieper.algebra.tree import HighPrecisionArithmetic, Node, SymbolicArithmetic, evaluate, joint_sum, substitute
from pieper.judge.model import POSE_NAMES, ArmModel, Samples

MAX_NODES = 600  # expanding more takes longer than a reader waits
DIGITS = 50


class _Polynomial(SymbolicArithmetic):
    """Symbols for every sine and cosine of one joint; sums of angles are written out, so that equal formulas become
    equal polynomials."""

    def sin(self, x):
        return self._trig(x)[1]

    def cos(self, x):
        return self._trig(x)[0]

    def _trig(self, x):
        sp = self.sp
        c, s = sp.Integer(1), sp.Integer(0)
        for term in sp.Add.make_args(x):
            factor, angle = term.as_coeff_Mul()
            if angle.is_Symbol and str(angle).startswith("theta") and factor in (1, -1):
                ci, si = sp.Symbol(f"c{str(angle)[5:]}"), factor * sp.Symbol(f"s{str(angle)[5:]}")
            else:
                ci, si = sp.cos(term), sp.sin(term)
            c, s = c * ci - s * si, s * ci + c * si
        return c, s

    def __init__(self):
        super().__init__()
        del self.__dict__["sin"], self.__dict__["cos"]


def simplified_difference(printed: Node, right: Node) -> str:
    """Return printed minus right as a factored polynomial in c1, s1, ...; "" when it is not one or takes too long."""
    if printed.size() + right.size() > MAX_NODES or any(
        n.op == "pm" or (n.op == "call" and n.value not in ("sin", "cos")) for t in (printed, right) for n in t.walk()
    ):
        return ""
    if any(
        n.op == "call" and n.value in ("sin", "cos") and joint_sum(n.args[0]) is None and n.args[0].symbols() - {"pi"}
        for t in (printed, right)
        for n in t.walk()
    ):
        return ""
    arithmetic = _Polynomial()
    sp = arithmetic.sp

    def value(tree):
        env = {name: sp.Symbol(name) for name in tree.symbols()}
        env["pi"] = sp.pi
        return evaluate(tree, env, arithmetic)

    if printed.op == "eq" and right.op == "eq":
        gap = [value(p) - value(r) for p, r in zip(printed.args, right.args, strict=True)]
        total = gap[1] if gap[1] != 0 else gap[0]
    else:
        total = value(printed) - value(right)
    total = sp.expand(total)
    if len(sp.Add.make_args(total)) > 60:
        return ""
    return str(sp.factor(total)).replace("**", "^").replace("*", " ")


def difference_from_matrix(printed: Node, model: ArmModel, i: int, j: int) -> str:
    """Return a printed entry minus the entry of T, simplified; "" when that is too long to be of use."""
    if printed.size() > 150 or model.n > 6:
        return ""
    arithmetic = _Polynomial()
    sp = arithmetic.sp
    env = {f"theta{k + 1}": sp.Symbol(f"theta{k + 1}") for k in range(model.n)}
    env |= {name: sp.Symbol(name) for name in set(model.values) | printed.symbols() if not name.startswith("theta")}
    env |= {name: sp.Integer(0) for name, value in model.values.items() if value == 0}
    env["pi"] = sp.pi
    total = sp.expand(evaluate(printed, env, arithmetic) - model.pose_exact(env, arithmetic)[i][j])
    if len(sp.Add.make_args(total)) > 12:
        return ""
    return str(sp.factor(total)).replace("**", "^").replace("*", " ")


def exact_environment(model: ArmModel, samples: Samples, k: int, definitions: dict[str, Node], arithmetic) -> dict:
    """Return every symbol at sample k with 50 digits; joint angles are the tenths of a degree they were drawn as."""
    env = {"pi": arithmetic.pi}
    for name in model.values:
        env[name] = arithmetic.number(repr(float(samples.env[name][k])))
    for joint in range(1, model.n + 1):
        value = samples.q[k, joint - 1]
        if model.sliding(joint):
            env[f"theta{joint}"] = arithmetic.number(repr(float(value)))
        else:
            env[f"theta{joint}"] = arithmetic.number(f"{np.degrees(value):.1f}") * arithmetic.pi / 180
    for alias, target in model.aliases.items():
        env[alias] = env[target]
    T = model.pose_exact(env, arithmetic)
    for name, i, j in POSE_NAMES:
        env[name] = T[i][j]
    for name in samples.env:
        if name.endswith("?"):
            env[name] = arithmetic.number(repr(float(samples.env[name][k])))
    for name, tree in definitions.items():
        env[name] = evaluate(substitute(tree, definitions), env, arithmetic)
    return env


def agreeing_digits(
    model: ArmModel,
    samples: Samples,
    definitions: dict[str, Node],
    left: Node,
    right: Node | tuple[int, int],
    *,
    angle: bool = False,
    at: tuple[int, ...] = (0, 1),
) -> int:
    """Return to how many digits two formulas (or a formula and an entry of T) agree, at 50-digit arithmetic.

    The least over the samples `at`; at most 48, because the last digits are rounding.
    """
    import mpmath

    worst = DIGITS - 2
    with mpmath.workdps(DIGITS):
        arithmetic = HighPrecisionArithmetic()
        for k in at:
            env = exact_environment(model, samples, k, definitions, arithmetic)
            wanted = (
                env[f"r{right[0] + 1}{right[1] + 1}"] if isinstance(right, tuple) else evaluate(right, env, arithmetic)
            )
            gaps = []
            for branch in (1, -1):
                gap = abs(evaluate(left, env, arithmetic, branch) - wanted)
                if angle:
                    gap = gap % (2 * arithmetic.pi)
                    gap = min(gap, abs(gap - 2 * arithmetic.pi))
                gaps.append(gap)
            gap = min(gaps) / (abs(wanted) + mpmath.mpf("1e-6"))
            worst = min(worst, DIGITS - 2 if gap == 0 else int(-mpmath.log10(gap)))
    return max(worst, 0)
