"""Formulas as pages, papers and programs spell them, rewritten in the plain notation that the parser reads.

LaTeX, Greek letters and raised or lowered digits, NumPy's and MATLAB's functions, strokes for a size: only the spelling
changes here, never what stands where.
"""

from __future__ import annotations

import re

GREEK = {
    "α": "alpha",
    "β": "beta",
    "γ": "gamma",
    "δ": "delta",
    "ε": "epsilon",
    "η": "eta",
    "θ": "theta",
    "ϑ": "theta",
    "κ": "kappa",
    "λ": "lambda",
    "μ": "mu",
    "ν": "nu",
    "ξ": "xi",
    "ρ": "rho",
    "σ": "sigma",
    "τ": "tau",
    "φ": "phi",
    "ϕ": "phi",
    "χ": "chi",
    "ψ": "psi",
    "ω": "omega",
    "Δ": "Delta",
    "Φ": "Phi",
    "Ψ": "Psi",
    "Θ": "Theta",
}
MARKS = {
    "\u00b1": "+-",
    "\u2213": "-+",
    "\u2212": "-",
    "\u2013": "-",
    "\u00b7": "*",
    "\u22c5": "*",
    "\u00d7": "*",
    "\u2217": "*",
    "\u03c0": " pi ",
    "\u221a": " sqrt ",
    "\u00b0": " deg ",
    "\u00ba": " deg ",
    "\u2032": "'",
    "\u2019": "'",
    "\u2044": "/",
    "\u2215": "/",
    "\u00bd": " (1/2) ",
    "\u00bc": " (1/4) ",
    "\u2264": "<=",
    "\u2265": ">=",
    "\u2005": " ",
    "\u2009": " ",
    "\u00a0": " ",
}
RAISED = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺", "0123456789-+", strict=True))
LOWERED = dict(zip("₀₁₂₃₄₅₆₇₈₉₊₋ₓ", "0123456789+-x", strict=True))
_RAISED = re.compile(f"[{''.join(RAISED)}]+")
_LOWERED = re.compile(f"[{''.join(LOWERED)}]+")
_PROGRAM = re.compile(r"\b(?:np|numpy|math|sp|sympy|torch|jnp|casadi|Math|std)\s*(?:\.|::)\s*(?=[A-Za-z])")
_MATLAB = re.compile(r"\.(?=[*/^'])")
_WORDS = re.compile(
    r"\\(?:left|right|bigl?|bigr|Bigl?|Bigr|biggl?|biggr|displaystyle|textstyle|limits|quad|qquad|nonumber)(?![A-Za-z])"
    r"|\\[!,;:> ]|\\(?:label|tag)\s*\{[^{}]*\}"
)
_STYLE = re.compile(
    r"\\(?:mathrm|mathbf|mathit|mathsf|text|textrm|textit|operatorname\*?|boldsymbol|bm|hat|bar|tilde)\s*\{([^{}]*)\}"
)
_FRACTION = re.compile(r"\\[dtc]?frac\s*")
_ROOT = re.compile(r"\\sqrt\s*(?:\[\s*2\s*\])?")
_INVERSE = {"arccos": "acos", "arcsin": "asin", "arctan": "atan", "operatorname": ""}
_COMMAND = re.compile(r"\\([A-Za-z]+)")
_COMMANDS = {
    "cdot": "*",
    "times": "*",
    "ast": "*",
    "pm": "+-",
    "mp": "-+",
    "circ": "deg",
    "degree": "deg",
    "lvert": "|",
    "rvert": "|",
    "vert": "|",
    "prime": "'",
    "leq": "<=",
    "le": "<=",
    "geq": ">=",
    "ge": ">=",
    "varphi": "phi",
    "vartheta": "theta",
    "lbrace": "{",
    "rbrace": "}",
    "lbrack": "[",
    "rbrack": "]",
}
_DEGREE = re.compile(r"\^\s*(?:\{\s*deg\s*\}|deg)")
_OF_ANGLE = re.compile(r"\b([cCsS])_?\s*\{?\s*(?:theta|th|q)\s*_?\s*\{?\s*(\d)\s*\}?\s*\}?(?![A-Za-z\d])")
_SUM_INDEX = re.compile(r"\b([cCsS])_\{\s*(\d(?:\s*[-+]\s*\d)+)\s*\}")
_COMMA_INDEX = re.compile(r"\b([cCsS])_?\{\s*(\d(?:\s*,\s*\d)+)\s*\}")
_SUM_OF_ANGLES = re.compile(r"\btheta_?(?:\{\s*(\d(?:\s*[-+]\s*\d)+)\s*\}|(\d(?:[-+]\d)+)(?![\d.*/^]))")
#: The cosine or sine of a twist, a letter of its own: calpha2 for c_alpha_{2}.
_OF_TWIST = re.compile(r"\b([cs])_?alpha\s*_?\s*\{?\s*(\d)\s*\}?")
_STROKES = re.compile(r"\|([^|]+)\|")


def _angles(match: re.Match[str]) -> str:
    """theta1+2-4 and theta_{1+2-4} as the sum of angles that they name."""
    indices = re.sub(r"\s", "", match.group(1) or match.group(2))
    return "(" + re.sub(r"(\d)", r"theta\1", indices) + ")"


def plain(text: str) -> str:
    """The formula in the parser's notation.

    Args:
        text: A formula as somebody typed or typeset it.

    Returns:
        The same formula: `atan2(..)`, `sqrt(..)`, `a/b`, `theta1`, `c23`, `+-`, `abs(..)`.
    """
    for mark, word in MARKS.items():
        text = text.replace(mark, word)
    text = _RAISED.sub(lambda m: _power("".join(RAISED[c] for c in m.group())), text)
    text = _LOWERED.sub(lambda m: "_{" + "".join(LOWERED[c] for c in m.group()) + "}", text)
    text = _latex(text) if "\\" in text else text
    for letter, word in GREEK.items():
        if letter in text:
            # a letter of its own: cθ1 is the cosine of theta1 and not a name of five letters
            text = re.sub(f"(?<=[A-Za-z]){letter}", f"_{word}", text).replace(letter, f" {word}")
    text = _PROGRAM.sub("", text)
    text = _MATLAB.sub("", text)
    text = _OF_ANGLE.sub(r"\1\2", text)
    text = _OF_TWIST.sub(r"\1alpha\2", text)
    text = _SUM_OF_ANGLES.sub(_angles, text)
    text = _SUM_INDEX.sub(lambda m: _index(m.group(1), m.group(2)), text)
    text = _COMMA_INDEX.sub(lambda m: m.group(1) + re.sub(r"\D", "", m.group(2)), text)
    return _STROKES.sub(r" abs(\1) ", text)


def _power(digits: str) -> str:
    return "^" + (digits if digits.isdigit() and len(digits) == 1 else f"({digits})")


def _index(letter: str, body: str) -> str:
    body = re.sub(r"\s", "", body)
    return letter + body.replace("+", "") if "-" not in body else f"{letter}({body})"


def _latex(text: str) -> str:
    text = text.replace("\\\\", " ").replace("&", " ").replace("$", " ").replace("~", " ")
    text = _WORDS.sub(" ", text)
    for _ in range(4):
        text = _STYLE.sub(r" \1 ", text)
    text = _arguments(text, _FRACTION, 2, lambda a: f"(({a[0]})/({a[1]}))")
    text = _arguments(text, _ROOT, 1, lambda a: f" sqrt({a[0]})")
    text = text.replace("\\{", "(").replace("\\}", ")").replace("\\|", "|")
    text = re.sub(r"\s+_", "_", text)
    text = _COMMAND.sub(_command, text)
    text = _DEGREE.sub(" deg ", text)
    text = re.sub(r"\b(atan|arctan)\s*_?\s*\{?2\}?\s*(?=[({\[])", "atan2", text)
    # theta _ {1} and theta_{i}: a subscript belongs to the name before it
    text = re.sub(r"([A-Za-z])\s*_\s*\{\s*([A-Za-z\d]+)\s*\}", r"\1_{\2}", text)
    return re.sub(r"([A-Za-z])\s*_\s*([A-Za-z\d])", r"\1_\2", text)


def _command(match: re.Match[str]) -> str:
    word = match.group(1)
    if word in _COMMANDS:
        return f" {_COMMANDS[word]} "
    before = match.string[: match.start()]
    # c\theta_1 is the cosine of theta1, and c\alpha one of a twist: the letter goes with what follows
    glued = "_" if re.search(r"(?:^|[^A-Za-z])[cCsS]$", before) and word in GREEK.values() else " "
    return glued + _INVERSE.get(word, word)


def _arguments(text: str, command: re.Pattern[str], count: int, write: object) -> str:
    """Replace a command and the groups after it, the innermost last."""
    at = 0
    while found := command.search(text, at):
        end, groups = found.end(), []
        for _ in range(count):
            group, end = _group(text, end)
            groups.append(group)
        made = write(groups)  # pyright: ignore[reportCallIssue]
        text = text[: found.start()] + made + text[end:]
        at = found.start()
    return text


def _group(text: str, at: int) -> tuple[str, int]:
    """The group in braces at a place, or the one character; and where it ends."""
    while at < len(text) and text[at] == " ":
        at += 1
    if at >= len(text):
        return "", at
    if text[at] != "{":
        return text[at], at + 1
    depth = 0
    for k in range(at, len(text)):
        depth += (text[k] == "{") - (text[k] == "}")
        if not depth:
            return text[at + 1 : k], k + 1
    return text[at + 1 :], len(text)
