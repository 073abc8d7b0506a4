"""The field's notation on paper: text (derived and typed), LaTeX and presentation MathML of the nodes of a formula.

c1, s23, c(2-3) for sines and cosines; a2, d4 for lengths; n_x ... p_z for the target; sigma1 = +1 or -1 for a branch.
The MathML needs no script and no style sheet.
"""

from __future__ import annotations

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


def negative(expr: Any) -> bool:
    """Whether the expression starts with a minus sign when printed (and not with one that stands in brackets)."""
    if expr.op in ("num", "pi"):
        return expr.value < 0
    if expr.op in ("product", "sum", "quotient"):
        return expr.args[0].op != "minus" and negative(expr.args[0])
    return expr.op == "minus"


class Writer:
    """How nodes are written, here as one line of plain text, products with a star."""

    #: Between terms: plus, minus, and the two signs of a branch.
    signs = (" + ", " - ", " +- ", " -+ ")
    brackets = ("(", ")")
    times, equals = "*", " = "
    #: How strong a second factor must be to stand without brackets.
    second_factor = 2

    def __call__(self, expr: Any) -> str:
        """Return a node as text."""
        if expr.op == "num":
            return self._number(expr)
        if expr.op == "pi":
            return self._pi(expr.value)
        if expr.op == "trig":
            return self._trig(expr)
        if expr.op == "sym":
            return self._symbol(expr)
        if expr.op in TERMS:
            return self._sum(expr)
        if expr.op == "product":
            return self._product(expr)
        if expr.op == "quotient":
            return self._quotient(*expr.args)
        if expr.op == "power":
            return self._power(*expr.args)
        if expr.op == "equation":
            return self.equals.join(map(self, expr.args))
        if expr.op != "call":
            raise TypeError(f"cannot print {type(expr).__name__}")
        if expr.name == "quartic":
            *coefficients, root = map(self, expr.args)
            return self._quartic(coefficients, root)
        return self._call(expr)

    def _number(self, expr: Any) -> str:
        return expr.written or decimal_text(expr.value) or f"{expr.value.numerator}/{expr.value.denominator}"

    def _pi(self, value: Fraction) -> str:
        sign, over = ("-" if value < 0 else ""), abs(value.numerator)
        return f"{sign}{'' if over == 1 else f'{over}*'}pi" + (
            "" if value.denominator == 1 else f"/{value.denominator}"
        )

    def _trig(self, expr: Any) -> str:
        index, plain = subscript(expr.angle)
        return f"{expr.kind}{index}" if plain else f"{expr.kind}({index})"

    def _symbol(self, expr: Any) -> str:
        return expr.name

    def _quotient(self, over: Any, under: Any) -> str:
        return f"{self._wrapped(over, 2)}/{self._wrapped(under, 4)}"

    def _power(self, base: Any, exponent: Any) -> str:
        return f"{self._wrapped(base, 9)}^{self._wrapped(exponent, 9)}"

    def _quartic(self, coefficients: list[str], root: str) -> str:
        powers = "*t^4", "*t^3", "*t^2", "*t", ""
        said = " + ".join(a + p for a, p in zip(coefficients, powers, strict=True))
        return f"2*atan(t), t real root number {root} of {said} = 0"

    def _call(self, expr: Any) -> str:
        return _turn(expr) or f"{expr.name}({', '.join(map(self, expr.args))})"

    def _sum(self, expr: Any) -> str:
        """Return terms with their signs; a term with a sign of its own is a sum of one."""
        plus, minus, plus_minus, minus_plus = self.signs
        parts = []
        for place, term in enumerate(expr.args if expr.op == "sum" else (expr,)):
            if term.op in ("plus-minus", "minus"):
                sign = minus if term.op == "minus" else plus_minus if term.sign > 0 else minus_plus
                parts.append((sign if place else sign.strip()) + self._wrapped(term.args[0], 2))
            elif place and negative(term):
                parts.append(minus + self._wrapped(-term, 2))
            else:
                parts.append((plus if place else "") + self(term))
        return "".join(parts)

    def _product(self, expr: Any) -> str:
        factors, sign = list(expr.args), ""
        if factors[0].op == "num" and factors[0].value < 0:
            sign = self.signs[1].strip()
            factors[0] = -factors[0]
            if factors[0].value == 1:
                factors.pop(0)
        return sign + self.times.join(self._wrapped(f, self.second_factor if k else 2) for k, f in enumerate(factors))

    def _wrapped(self, expr: Any, least: int) -> str:
        """Return a node in brackets where it binds less than it must here."""
        left, right = self.brackets
        weak = expr.precedence < least or (least > 2 and expr.op in ("num", "pi") and expr.value < 0)
        return left + self(expr) + right if weak else self(expr)


class _Typed(Writer):
    times = " "
    # what stands side by side would run into a quotient before it
    second_factor = 4


class _Latex(Writer):
    signs = (" + ", " - ", r" \pm ", r" \mp ")
    brackets = (r"\left(", r"\right)")
    times = " "

    def _number(self, expr: Any) -> str:
        value, decimal = expr.value, decimal_text(expr.value)
        if decimal is not None and (value.denominator not in (2, 4) or "." in expr.written):
            return decimal
        return rf"{'-' if value < 0 else ''}\frac{{{abs(value.numerator)}}}{{{value.denominator}}}"

    def _pi(self, value: Fraction) -> str:
        sign, over = ("-" if value < 0 else ""), abs(value.numerator)
        top = r"\pi" if over == 1 else rf"{over}\pi"
        return sign + (top if value.denominator == 1 else rf"\frac{{{top}}}{{{value.denominator}}}")

    def _trig(self, expr: Any) -> str:
        return f"{expr.kind}_{{{subscript(expr.angle)[0].replace('·', ' ')}}}"

    def _symbol(self, expr: Any) -> str:
        base = expr.base if len(expr.base) == 1 else _latex_base(expr.base)
        return f"{base}_{{{expr.sub}}}" if expr.sub else base

    def _quotient(self, over: Any, under: Any) -> str:
        return rf"\frac{{{self(over)}}}{{{self(under)}}}"

    def _power(self, base: Any, exponent: Any) -> str:
        return f"{self._wrapped(base, 9)}^{{{self(exponent)}}}"

    def _quartic(self, coefficients: list[str], root: str) -> str:
        e4, e3, e2, e1, e0 = coefficients
        return rf"2\arctan t_{{{root}}},\quad {e4} t^4 + {e3} t^3 + {e2} t^2 + {e1} t + {e0} = 0"

    def _call(self, expr: Any) -> str:
        if expr.name == "sqrt":
            return rf"\sqrt{{{self(expr.args[0])}}}"
        if expr.name == "abs":
            return rf"\left|{self(expr.args[0])}\right|"
        name = LATEX_FUNCTION.get(expr.name, rf"\operatorname{{{expr.name}}}")
        return rf"{name}\left({', '.join(map(self, expr.args))}\right)"


class _Mathml(Writer):
    signs = ("<mo>+</mo>", "<mo>−</mo>", "<mo>±</mo>", "<mo>∓</mo>")
    brackets = ("<mo>(</mo>", "<mo>)</mo>")
    times, equals = THIN, "<mo>=</mo>"

    def _number(self, expr: Any) -> str:
        value, decimal = expr.value, decimal_text(abs(expr.value))
        if decimal is not None and (value.denominator not in (2, 4) or "." in expr.written):
            return _signed(value, f"<mn>{decimal}</mn>")
        return _signed(value, f"<mfrac><mn>{abs(value.numerator)}</mn><mn>{value.denominator}</mn></mfrac>")

    def _pi(self, value: Fraction) -> str:
        over = abs(value.numerator)
        top = "<mi>π</mi>" if over == 1 else f"<mrow><mn>{over}</mn><mi>π</mi></mrow>"
        return _signed(value, top if value.denominator == 1 else f"<mfrac>{top}<mn>{value.denominator}</mn></mfrac>")

    def _trig(self, expr: Any) -> str:
        return f"<msub><mi>{expr.kind}</mi><mn>{subscript(expr.angle)[0].replace('-', '−')}</mn></msub>"

    def _symbol(self, expr: Any) -> str:
        base = expr.base
        if base in GREEK:
            base = GREEK[base]
        elif base[:1] in "cs" and base[1:] in GREEK:
            base = base[0] + GREEK[base[1:]]
        letter = f"<mi>{escape(base)}</mi>"
        if not expr.sub:
            return letter
        tag = "mn" if expr.sub.isdigit() else "mi"
        return f"<msub>{letter}<{tag}>{escape(expr.sub)}</{tag}></msub>"

    def _sum(self, expr: Any) -> str:
        return f"<mrow>{super()._sum(expr)}</mrow>"

    def _product(self, expr: Any) -> str:
        return f"<mrow>{super()._product(expr)}</mrow>"

    def _quotient(self, over: Any, under: Any) -> str:
        return f"<mfrac>{self(over)}{self(under)}</mfrac>"

    def _power(self, base: Any, exponent: Any) -> str:
        return f"<msup><mrow>{self._wrapped(base, 9)}</mrow>{self(exponent)}</msup>"

    def _quartic(self, coefficients: list[str], root: str) -> str:
        powers = [f"<msup><mi>t</mi><mn>{p}</mn></msup>" for p in (4, 3, 2)] + ["<mi>t</mi>", ""]
        said = "<mo>+</mo>".join(a + p for a, p in zip(coefficients, powers, strict=True))
        return (
            f"<mrow><mn>2</mn><mi>arctan</mi><msub><mi>t</mi>{root}</msub><mo>,</mo><mspace width='1em'/>"
            f"{said}<mo>=</mo><mn>0</mn></mrow>"
        )

    def _call(self, expr: Any) -> str:
        if expr.name == "sqrt":
            return f"<msqrt>{self(expr.args[0])}</msqrt>"
        if expr.name == "abs":
            return f"<mrow><mo>|</mo>{self(expr.args[0])}<mo>|</mo></mrow>"
        name = MATHML_FUNCTION.get(expr.name, expr.name)
        return f"<mrow><mi>{name}</mi><mo>(</mo>{'<mo>,</mo>'.join(map(self, expr.args))}<mo>)</mo></mrow>"


def _signed(value: Fraction, body: str) -> str:
    return f"<mrow><mo>−</mo>{body}</mrow>" if value < 0 else body


def _latex_base(base: str) -> str:
    if base in GREEK:
        return "\\" + base
    if base[:1] in "cs" and base[1:] in GREEK:  # cos/sin of a twist: c_alpha
        return rf"{base[0]}\{base[1:]}"
    return rf"\mathrm{{{base}}}"


#: One line of plain text, products with a star.
text = Writer()
#: One line of plain text as papers write it, products side by side; typed formulas come back as they were.
typed = _Typed()
#: LaTeX for math mode.
latex = _Latex()
#: Presentation MathML without the outer <math> element.
mathml = _Mathml()
