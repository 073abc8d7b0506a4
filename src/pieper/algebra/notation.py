"""The field's notation on paper: text (derived and typed), LaTeX and presentation MathML of the nodes of a formula.

c1, s23, c(2-3) for sines and cosines; a2, d4 for lengths; n_x ... p_z for the target; sigma1 = +1 or -1 for a branch.
The MathML needs no script and no style sheet.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from html import escape
from typing import Any

from pieper.algebra.exact import decimal_text

GREEK = {"theta": "θ", "alpha": "α", "sigma": "σ", "beta": "β", "gamma": "γ", "phi": "φ", "rho": "ρ", "Delta": "Δ"}
LATEX_FUNCTION = {
    "acos": r"\arccos",
    "asin": r"\arcsin",
    "atan": r"\arctan",
    "cos": r"\cos",
    "sin": r"\sin",
    "tan": r"\tan",
}
MATHML_FUNCTION = {"acos": "arccos", "asin": "arcsin", "atan": "arctan"}
THIN = "<mspace width='0.17em'/>"
Printer = Callable[[Any], str]
TERMS = ("sum", "minus", "plus-minus")
TURNS = ("sin", "cos")


def subscript(angle: tuple) -> tuple[str, bool]:
    """The index of an angle combination: ("23", True), ("2-3", False); True when it needs no brackets in text."""
    plain = all(factor == 1 and joint < 10 for joint, factor in angle)
    if plain:
        return "".join(str(joint) for joint, _ in angle), True
    parts = []
    for place, (joint, factor) in enumerate(angle):
        sign = "-" if factor < 0 else ("+" if place else "")
        parts.append(sign + ("" if abs(factor) == 1 else f"{abs(factor)}·") + str(joint))
    return "".join(parts), len(angle) == 1 and angle[0][1] == 1


# -- text ----------------------------------------------------------------------------------------------------
def text(expr: Any) -> str:
    """One line of plain text, products with a star."""
    return _plain(expr, text, "*")


def typed(expr: Any) -> str:
    """One line of plain text as papers write it, products side by side; typed formulas come back as they were."""
    return _plain(expr, typed, " ")


def _plain(expr: Any, printer: Printer, times: str) -> str:
    if expr.op == "num":
        return expr.written or _number(expr.value)
    if expr.op == "pi":
        return _pi_text(expr.value)
    if expr.op == "trig":
        index, plain = subscript(expr.angle)
        return f"{expr.kind}{index}" if plain else f"{expr.kind}({index})"
    if expr.op == "sym":
        return expr.name
    if expr.op in TERMS:
        return _sum(expr, printer)
    if expr.op == "product":
        return _product(expr, printer, times)
    if expr.op == "quotient":
        return f"{_wrapped(expr.args[0], printer, 2)}/{_wrapped(expr.args[1], printer, 4)}"
    if expr.op == "power":
        return f"{_wrapped(expr.args[0], printer, 9)}^{_wrapped(expr.args[1], printer, 9)}"
    if expr.op == "equation":
        return " = ".join(map(printer, expr.args))
    if expr.op == "call":
        if expr.name == "quartic":
            *e, k = map(printer, expr.args)
            powers = "*t^4", "*t^3", "*t^2", "*t", ""
            return (
                f"2*atan(t), t real root number {k} of {' + '.join(a + p for a, p in zip(e, powers, strict=True))} = 0"
            )
        return _turn(expr) or f"{expr.name}({', '.join(map(printer, expr.args))})"
    raise TypeError(f"cannot print {type(expr).__name__}")


def joint_sum(node: Any) -> tuple[tuple[int, int], ...] | None:
    """Read a node as a signed sum of joint angles: ((sign, joint), ...), or None when it is something else."""
    parts = []
    for term in node.args if node.op == "sum" else (node,):
        sign = 1
        if term.op == "minus":
            sign, term = -1, term.args[0]
        if term.op != "sym" or term.base != "theta" or not term.sub.isdigit():
            return None
        parts.append((sign, int(term.sub)))
    return tuple(parts)


def turned_joints(node: Any) -> tuple[tuple[int, int], ...] | None:
    """The signed sum of joint angles whose sine or cosine the node is, or None."""
    return joint_sum(node.args[0]) if node.op == "call" and node.name in TURNS else None


def _turn(expr: Any) -> str:
    """c23 for cos(theta2 + theta3); "" for other calls."""
    parts = turned_joints(expr)
    if parts and all(s > 0 for s, _ in parts):
        return expr.name[0] + "".join(str(j) for _, j in parts)
    if parts and len(parts) > 1 and parts[0][0] > 0:
        return f"{expr.name[0]}({''.join(('+' if s > 0 else '-') + str(j) for s, j in parts)[1:]})"
    return ""


# -- LaTeX ---------------------------------------------------------------------------------------------------
def latex(expr: Any) -> str:
    """LaTeX for math mode."""
    if expr.op == "num":
        return _number_latex(expr.value)
    if expr.op == "pi":
        return _pi_latex(expr.value)
    if expr.op == "trig":
        return f"{expr.kind}_{{{subscript(expr.angle)[0].replace('·', ' ')}}}"
    if expr.op == "sym":
        base = expr.base if len(expr.base) == 1 else _latex_base(expr.base)
        return f"{base}_{{{expr.sub}}}" if expr.sub else base
    if expr.op in TERMS:
        return _sum(expr, latex)
    if expr.op == "product":
        return _product(expr, latex, " ")
    if expr.op == "quotient":
        return rf"\frac{{{latex(expr.args[0])}}}{{{latex(expr.args[1])}}}"
    if expr.op == "power":
        return f"{_wrapped(expr.args[0], latex, 9)}^{{{latex(expr.args[1])}}}"
    if expr.op == "equation":
        return " = ".join(map(latex, expr.args))
    if expr.op == "call":
        if expr.name == "sqrt":
            return rf"\sqrt{{{latex(expr.args[0])}}}"
        if expr.name == "quartic":
            e4, e3, e2, e1, e0, k = map(latex, expr.args)
            return rf"2\arctan t_{{{k}}},\quad {e4} t^4 + {e3} t^3 + {e2} t^2 + {e1} t + {e0} = 0"
        if expr.name == "abs":
            return rf"\left|{latex(expr.args[0])}\right|"
        name = LATEX_FUNCTION.get(expr.name, rf"\operatorname{{{expr.name}}}")
        return rf"{name}\left({', '.join(map(latex, expr.args))}\right)"
    raise TypeError(f"cannot print {type(expr).__name__}")


# -- MathML --------------------------------------------------------------------------------------------------
def mathml(expr: Any) -> str:
    """Presentation MathML without the outer <math> element."""
    if expr.op == "num":
        return _number_mathml(expr.value)
    if expr.op == "pi":
        return _pi_mathml(expr.value)
    if expr.op == "trig":
        return f"<msub><mi>{expr.kind}</mi><mn>{subscript(expr.angle)[0].replace('-', '−')}</mn></msub>"
    if expr.op == "sym":
        return _symbol_mathml(expr)
    if expr.op in TERMS:
        return f"<mrow>{_sum(expr, mathml)}</mrow>"
    if expr.op == "product":
        return f"<mrow>{_product(expr, mathml, THIN)}</mrow>"
    if expr.op == "quotient":
        return f"<mfrac>{mathml(expr.args[0])}{mathml(expr.args[1])}</mfrac>"
    if expr.op == "power":
        return f"<msup><mrow>{_wrapped(expr.args[0], mathml, 9)}</mrow>{mathml(expr.args[1])}</msup>"
    if expr.op == "equation":
        return "<mo>=</mo>".join(map(mathml, expr.args))
    if expr.op == "call":
        if expr.name == "sqrt":
            return f"<msqrt>{mathml(expr.args[0])}</msqrt>"
        if expr.name == "quartic":
            *e, k = map(mathml, expr.args)
            powers = [f"<msup><mi>t</mi><mn>{p}</mn></msup>" for p in (4, 3, 2)] + ["<mi>t</mi>", ""]
            sum_ = "<mo>+</mo>".join(a + p for a, p in zip(e, powers, strict=True))
            return (
                f"<mrow><mn>2</mn><mi>arctan</mi><msub><mi>t</mi>{k}</msub><mo>,</mo><mspace width='1em'/>"
                f"{sum_}<mo>=</mo><mn>0</mn></mrow>"
            )
        if expr.name == "abs":
            return f"<mrow><mo>|</mo>{mathml(expr.args[0])}<mo>|</mo></mrow>"
        name = MATHML_FUNCTION.get(expr.name, expr.name)
        return f"<mrow><mi>{name}</mi><mo>(</mo>{'<mo>,</mo>'.join(map(mathml, expr.args))}<mo>)</mo></mrow>"
    raise TypeError(f"cannot print {type(expr).__name__}")


# -- pieces --------------------------------------------------------------------------------------------------
def negative(expr: Any) -> bool:
    """Whether the expression starts with a minus sign when printed (and not with one that stands in brackets)."""
    if expr.op in ("num", "pi"):
        return expr.value < 0
    if expr.op in ("product", "sum", "quotient"):
        return expr.args[0].op != "minus" and negative(expr.args[0])
    return expr.op == "minus"


def _sum(expr: Any, printer: Printer) -> str:
    """Terms with their signs; a term with a sign of its own is a sum of one."""
    plus, minus, plus_minus, minus_plus = _SIGNS[printer]
    terms = expr.args if expr.op == "sum" else (expr,)
    parts = []
    for place, term in enumerate(terms):
        tight = not place and printer in (text, typed, latex)
        if term.op == "plus-minus":
            sign = plus_minus if term.sign > 0 else minus_plus
            parts.append((sign.strip() if tight else sign) + _wrapped(term.args[0], printer, 2))
        elif term.op == "minus":
            parts.append((minus.strip() if tight else minus) + _wrapped(term.args[0], printer, 2))
        elif place and negative(term):
            parts.append(minus + _wrapped(-term, printer, 2))
        else:
            parts.append((plus if place else "") + printer(term))
    return "".join(parts)


def _wrapped(expr: Any, printer: Printer, least: int) -> str:
    left, right = _BRACKETS[printer]
    body = printer(expr)
    weak = expr.precedence < least or (least > 2 and expr.op in ("num", "pi") and expr.value < 0)
    return left + body + right if weak else body


def _product(expr: Any, printer: Printer, times: str) -> str:
    factors = list(expr.args)
    sign = ""
    if factors[0].op == "num" and factors[0].value < 0:
        sign = _SIGNS[printer][1].strip()
        factors[0] = -factors[0]
        if factors[0].value == 1:
            factors.pop(0)
    # what stands side by side would run into a quotient before it
    pieces = [_wrapped(f, printer, 4 if place and printer is typed else 2) for place, f in enumerate(factors)]
    return sign + times.join(pieces)


_SIGNS: dict[Printer, tuple[str, str, str, str]] = {
    text: (" + ", " - ", " +- ", " -+ "),
    typed: (" + ", " - ", " +- ", " -+ "),
    latex: (" + ", " - ", r" \pm ", r" \mp "),
    mathml: ("<mo>+</mo>", "<mo>−</mo>", "<mo>±</mo>", "<mo>∓</mo>"),
}
_BRACKETS: dict[Printer, tuple[str, str]] = {
    text: ("(", ")"),
    typed: ("(", ")"),
    latex: (r"\left(", r"\right)"),
    mathml: ("<mo>(</mo>", "<mo>)</mo>"),
}


def _number(value: Fraction) -> str:
    return decimal_text(value) or f"{value.numerator}/{value.denominator}"


def _number_latex(value: Fraction) -> str:
    decimal = decimal_text(value)
    if decimal is not None and value.denominator not in (2, 4):
        return decimal
    sign = "-" if value < 0 else ""
    return rf"{sign}\frac{{{abs(value.numerator)}}}{{{value.denominator}}}"


def _number_mathml(value: Fraction) -> str:
    sign = "<mo>−</mo>" if value < 0 else ""
    decimal = decimal_text(abs(value))
    if decimal is not None and value.denominator not in (2, 4):
        body = f"<mn>{decimal}</mn>"
    else:
        body = f"<mfrac><mn>{abs(value.numerator)}</mn><mn>{value.denominator}</mn></mfrac>"
    return f"<mrow>{sign}{body}</mrow>" if sign else body


def _pi_text(value: Fraction) -> str:
    sign, over = ("-" if value < 0 else ""), abs(value.numerator)
    return f"{sign}{'' if over == 1 else f'{over}*'}pi" + ("" if value.denominator == 1 else f"/{value.denominator}")


def _pi_latex(value: Fraction) -> str:
    sign, over = ("-" if value < 0 else ""), abs(value.numerator)
    top = r"\pi" if over == 1 else rf"{over}\pi"
    return sign + (top if value.denominator == 1 else rf"\frac{{{top}}}{{{value.denominator}}}")


def _pi_mathml(value: Fraction) -> str:
    sign, over = ("<mo>−</mo>" if value < 0 else ""), abs(value.numerator)
    top = "<mi>π</mi>" if over == 1 else f"<mrow><mn>{over}</mn><mi>π</mi></mrow>"
    body = top if value.denominator == 1 else f"<mfrac>{top}<mn>{value.denominator}</mn></mfrac>"
    return f"<mrow>{sign}{body}</mrow>" if sign else body


def _latex_base(base: str) -> str:
    if base in GREEK:
        return "\\" + base
    if base[:1] in "cs" and base[1:] in GREEK:  # cos/sin of a twist: c_alpha
        return rf"{base[0]}\{base[1:]}"
    return rf"\mathrm{{{base}}}"


def _symbol_mathml(symbol: Any) -> str:
    base = symbol.base
    if base in GREEK:
        base = GREEK[base]
    elif base[:1] in "cs" and base[1:] in GREEK:
        base = base[0] + GREEK[base[1:]]
    letter = f"<mi>{escape(base)}</mi>"
    if not symbol.sub:
        return letter
    tag = "mn" if symbol.sub.isdigit() else "mi"
    return f"<msub>{letter}<{tag}>{escape(symbol.sub)}</{tag}></msub>"
