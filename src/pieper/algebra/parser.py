"""The formula language: the papers' own notation, read by a recursive-descent parser into an expression tree.

Understood: ``C1 s23 c(2-3) S345 cq2q3``, ``cos t1``, ``sin(q2+q3)``, ``atan2(y, x)``, ``tan^-1``, products written
side by side
(``2a2a3 C1``), ``+-`` and ``-+`` (all signs of one formula go together), ``90 deg``, ``a_2``, ``theta_4``, ``r12`` and
names the caller allows. Text never reaches Python's evaluator.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Collection

from pieper.algebra.expression import Add, Call, Div, Expr, Mul, PiFraction, Power
from pieper.algebra.formula import Mention, Neg, PlusMinus, angle_sum, number
from pieper.algebra.formula_error import FormulaError
from pieper.algebra.formula_error import fail as _fail
from pieper.algebra.parser_words import (
    DEGREES,
    FUNCTION_NAMES,
    FUNCTIONS,
    INVERSE,
    JOINT_NAME,
    TOKEN,
    TRIG_NAME,
    called,
)
from pieper.algebra.spelling import plain
from pieper.words_by_number import plural

MAX_CHARACTERS = 200_000  # a page of algebra has 5,000; beyond this it is not a formula
MAXTOKENS = 60_000
MAX_DEPTH = 60  # brackets inside brackets
MAX_TREE_DEPTH = 300
MAX_EXPONENT = 250  # of a number such as 1e-9; doubles end near 308


class Parser:
    """One formula on its way to a tree.

    Args:
        text: the formula.
        names: the symbols the formula may use, besides joints, functions and pi.
        joints: number of joints; theta1 .. theta<joints> and their sines and cosines are allowed.
    """

    def __init__(self, text: str, names: Collection[str], joints: int) -> None:
        if not isinstance(text, str):
            raise FormulaError(f"a formula is text in quotes, but this is {text!r} ({type(text).__name__})")
        text = plain(text)
        if len(text) > MAX_CHARACTERS:
            raise FormulaError(
                f"the formula has {len(text):,} characters; at most {MAX_CHARACTERS:,} are read. Split it "
                f"with symbols of your own."
            )
        self.text, self.names, self.joints = text, names, joints
        self.lower = {n.lower(): n for n in sorted(names)}
        self.tokens = self._tokenize()
        self.at = 0
        self.depth = 0

    def _tokenize(self) -> list[tuple[str, str, int]]:
        tokens, position = [], 0
        odd = sorted((n for n in self.names if not TOKEN.fullmatch(n)), key=len, reverse=True)
        own = re.compile(r"(?P<name>" + "|".join(map(re.escape, odd)) + r")(?![A-Za-z\d])") if odd else None
        while position < len(self.text):
            found = (own and own.match(self.text, position)) or TOKEN.match(self.text, position)
            if not found:
                word = re.match(r"\w+", self.text[position:])
                what = (
                    f"{word.group()!r} is no symbol"
                    if word
                    else f"the character {self.text[position]!r} has no meaning in a formula"
                )
                raise _fail(
                    self.text, position, what + "; a formula holds symbols, numbers, brackets and known functions only"
                )
            if found.lastgroup != "space":
                tokens.append((found.lastgroup, found.group(), position))
                if len(tokens) > MAXTOKENS:
                    raise FormulaError(
                        f"the formula has more than {MAXTOKENS:,} symbols; split it with symbols of your own."
                    )
            position = found.end()
        tokens.append(("end", "", len(self.text)))
        return tokens

    def _peek(self) -> tuple[str, str, int]:
        return self.tokens[self.at]

    def _take(self) -> tuple[str, str, int]:
        token = self.tokens[self.at]
        self.at += 1
        return token

    def parse(self) -> Expr:
        """Read the whole formula as one expression."""
        node = self._sum()
        kind, text, position = self._peek()
        if kind != "end":
            hint = " (this closing bracket was never opened)" if text in ")]}" else ""
            hint = " (a formula here has no equals sign: write the right-hand side only)" if text == "=" else hint
            raise _fail(self.text, position, f"{text!r} is not expected here{hint}")
        return self._checked(node)

    def _checked(self, node: Expr) -> Expr:
        """Refuse trees too deep to walk (a chain of divisions, say); long sums and products are flat and pass."""
        depth: dict[Expr, int] = {}
        for n in node.walk():
            depth[n] = 1 + max((depth[a] for a in n.args), default=0)
        if depth[node] > MAX_TREE_DEPTH:
            raise FormulaError(
                f"the formula is nested {depth[node]:,} levels deep; at most {MAX_TREE_DEPTH} are read. "
                f"Split it with symbols of your own."
            )
        return node

    def parse_equation(self) -> tuple[Expr, Expr]:
        """Read ``left = right``."""
        left = self._sum()
        kind, text, position = self._take()
        if text != "=":
            raise _fail(self.text, position, "an equation needs one '='")
        right = self._sum()
        kind, text, position = self._peek()
        if kind != "end":
            raise _fail(self.text, position, f"{text!r} is not expected here")
        return self._checked(left), self._checked(right)

    def _sum(self) -> Expr:
        terms = [self._term()]
        while True:
            kind, text, _ = self._peek()
            if kind == "pm":
                self._take()
                terms.append(PlusMinus(self._term(), 1 if text.startswith("+") else -1))
            elif text in ("+", "-") and kind == "op":
                self._take()
                term = self._term()
                terms.append(Neg.of(term) if text == "-" else term)
            else:
                return Add.of(*terms)

    def _term(self) -> Expr:
        kind, text, position = self._peek()
        if kind == "op" and text in "+-":
            self._take()
            self._deeper(position)
            inner = self._term()
            self.depth -= 1
            return Neg.of(inner) if text == "-" else inner
        if kind == "pm":
            self._take()
            self._deeper(position)
            inner = self._term()
            self.depth -= 1
            return PlusMinus(inner, 1 if text.startswith("+") else -1)
        factors: list[Expr] = [self._power()]
        while True:
            kind, text, position = self._peek()
            if text == "*":
                self._take()
                factors.append(self._signed_power())
            elif text == "/":
                self._take()
                factors = [Div(Mul.of(*factors), self._signed_power())]
            elif kind in ("num", "name", "trig") or text in ("(", "[", "{"):
                if kind == "num" and self.tokens[self.at - 1][0] == "num":
                    raise _fail(self.text, position, "two numbers stand side by side; write * between them")
                factors.append(self._power())
            else:
                return Mul.of(*factors)

    def _signed_power(self) -> Expr:
        if self._peek()[1] in ("-", "+"):
            sign = self._take()[1]
            inner = self._power()
            return Neg.of(inner) if sign == "-" else inner
        return self._power()

    def _power(self) -> Expr:
        base = self._primary()
        if self._peek()[1] in ("^", "**"):
            self._take()
            return Power(base, self._exponent())
        return base

    def _exponent(self) -> Expr:
        kind, text, position = self._peek()
        if text == "-":
            self._take()
            return Neg.of(self._primary())
        return self._primary()

    def _deeper(self, position: int) -> None:
        self.depth += 1
        if self.depth > MAX_DEPTH:
            raise _fail(self.text, position, f"more than {MAX_DEPTH} brackets or signs inside one another")

    def _primary(self) -> Expr:
        kind, text, position = self._take()
        if kind == "num":
            return self._number(text, position)
        if text in ("(", "[", "{"):
            return self._bracket(text, position)
        if kind == "trig":
            return self._shorthand(text[0], re.findall(r"\d", text), position)
        if kind == "name":
            return self._name(text, position)
        if kind == "end":
            raise _fail(self.text, position, "the formula stops here, but something must follow")
        raise _fail(
            self.text, position, f"{text!r} is not expected here; a symbol, a number or a bracket must stand here"
        )

    def _number(self, text: str, position: int) -> Expr:
        _, _, exponent = text.lower().partition("e")
        if len(text) > MAX_EXPONENT or abs(int(exponent or 0)) > MAX_EXPONENT:
            raise _fail(self.text, position, f"{text[:40]} is out of range; {MAX_EXPONENT} digits are read")
        return number(text)

    def _bracket(self, opened: str, position: int) -> Expr:
        self._deeper(position)
        inner = self._sum()
        self._close(opened, position)
        self.depth -= 1
        return inner

    def _close(self, opened: str, position: int) -> None:
        wanted = {"(": ")", "[": "]", "{": "}"}[opened]
        kind, text, at = self._take()
        if text != wanted:
            if kind == "end":
                raise _fail(self.text, position, f"this bracket {opened!r} is never closed")
            raise _fail(
                self.text,
                at,
                f"{text!r} is not expected here; {wanted!r} would close the bracket opened at character {position + 1}",
            )

    def _shorthand(self, letter: str, digits: list[str], position: int, signs: list[int] | None = None) -> Expr:
        parts = []
        for k, digit in enumerate(digits):
            joint = int(digit)
            if not 1 <= joint <= self.joints:
                raise _fail(
                    self.text, position, f"joint {joint} does not exist; the arm has {plural(self.joints, 'joint')}"
                )
            parts.append((signs[k] if signs else 1, joint))
        return Call("cos" if letter in "cC" else "sin", angle_sum(tuple(parts)))

    def _name(self, raw: str, position: int) -> Expr:
        text = re.sub(r"[_{}]", "", raw)
        lowered, following = text.lower(), self._peek()[1]
        if lowered == "degrees" and following == "(" and (self.at < 2 or self.tokens[self.at - 2][0] != "num"):
            return self._call("rad2deg", position)  # np.degrees(x), and not the unit of 90 degrees (..)
        found = self._known(text)
        if found is not None:
            return found
        if FUNCTION_NAMES.get(lowered, lowered) in DEGREES and following == "(":
            return self._of_degrees(FUNCTION_NAMES.get(lowered, lowered)[:-1], position)
        if lowered in FUNCTION_NAMES:
            return self._call(FUNCTION_NAMES[lowered], position)
        if text in ("c", "C", "s", "S") and following == "(":
            digits = self._digit_list()
            if digits:
                return self._shorthand(text, [d for _, d in digits], position, [s for s, _ in digits])
        joined = self._split(text)
        if joined:
            return joined
        raise self._unknown(raw, text, position)

    def _known(self, text: str) -> Expr | None:
        if text == "pi":
            return PiFraction(1)
        if text in self.names:
            return Mention(text)
        if text in ("deg", "degrees"):
            return Div(PiFraction(1), number(180))
        if text == "rad":
            return number(1)
        joint = JOINT_NAME.match(text)
        if joint and 1 <= int(joint.group(1)) <= self.joints:
            return Mention(f"theta{int(joint.group(1))}")
        digits = joint.group(1) if joint else ""
        if 1 < len(digits) and self.joints < 10 and all(a < b for a, b in zip(digits, digits[1:] + ":", strict=True)):
            if 1 <= int(digits[0]) and int(digits[-1]) <= self.joints:
                return angle_sum(tuple((1, int(d)) for d in digits))  # theta234
        trig = TRIG_NAME.match(text)
        if trig and all(1 <= int(d) <= self.joints for d in re.findall(r"\d", trig.group(2))):
            return self._shorthand(trig.group(1), re.findall(r"\d", trig.group(2)), 0)
        return None

    def _split(self, text: str) -> Expr | None:
        """Read names that stand without a space, as in a4C34 or axS23, longest first."""
        pieces, rest = [], text
        while rest:
            for length in range(len(rest), 0, -1):
                # a piece never ends in the middle of a number: C345 is not C34 times 5
                if length < len(rest) and rest[length].isdigit():
                    continue
                piece = self._known(rest[:length])
                if piece is not None:
                    pieces.append(piece)
                    rest = rest[length:]
                    break
            else:
                return None
        return Mul.of(*pieces)

    def _digit_list(self) -> list[tuple[int, str]] | None:
        """Read the inside of c(2-3) when the bracket holds nothing but joint numbers; otherwise leave it alone."""
        inside, k = [], self.at + 1
        while self.tokens[k][1] != ")":
            inside.append(self.tokens[k][:2])
            k += 1
            if len(inside) > 20 or self.tokens[k][0] == "end":
                return None
        joined = "".join(t for _, t in inside)
        if not re.fullmatch(r"[-+]?\d([-+]\d|\d)*", joined):
            return None
        self.at = k + 1
        return [(-1 if s == "-" else 1, d) for s, d in re.findall(r"([-+]?)(\d)", joined)]

    def _of_degrees(self, name: str, position: int) -> Expr:
        """Read MATLAB's cosd(x) and acosd(x): functions whose angles are in degrees."""
        call = self._call(name, position)
        if name in ("sin", "cos", "tan"):
            return Call(name, called("deg2rad", [Mul.of(*call.args)])) if isinstance(call, Call) else call
        return called("rad2deg", [call])

    def _call(self, name: str, position: int) -> Expr:
        power = None
        if self._peek()[1] in ("^", "**"):
            self._take()
            power = self._exponent()
            if str(power) == "-1" and name in INVERSE:
                name, power = INVERSE[name], None
        opened = self._peek()[1]
        if opened in ("(", "[", "{"):
            start = self._take()[2]
            self._deeper(start)
            args = [self._sum()]
            while self._peek()[1] == ",":
                self._take()
                args.append(self._sum())
            self._close(opened, start)
            self.depth -= 1
        else:
            self._deeper(position)
            args = [self._primary()]
            self.depth -= 1
        if len(args) != FUNCTIONS[name]:
            wanted = "one value" if FUNCTIONS[name] == 1 else "two values"
            wanted += ", atan2(sine part, cosine part)" if name == "atan2" else ""
            raise _fail(
                self.text, position, f"{name} takes {wanted}, but {len(args)} {'is' if len(args) == 1 else 'are'} given"
            )
        node = called(name, args)
        return Power(node, power) if power is not None else node

    def _unknown(self, raw: str, text: str, position: int) -> FormulaError:
        pool = list(self.names) + list(FUNCTIONS) + [f"theta{i + 1}" for i in range(self.joints)]
        pool += [f"{c}{i + 1}" for c in "cs" for i in range(self.joints)]
        near = difflib.get_close_matches(text, pool, 3, 0.5)
        if text.lower() in self.lower and self.lower[text.lower()] not in near:
            near.insert(0, self.lower[text.lower()])
        joint = JOINT_NAME.match(text) or re.match(r"[cCsS]\d*?(\d)$", text)
        if joint:
            message = f"{raw!r}: joint {joint.group(1)} does not exist; the arm has {plural(self.joints, 'joint')}"
        elif text.startswith("__") or raw.startswith("_"):
            message = f"{raw!r} is not a symbol; formulas hold symbols, numbers and known functions only"
        else:
            message = f"{raw!r} is not a known symbol"
        if near and not joint:
            message += "; did you mean " + " or ".join(near) + "?"
        return _fail(self.text, position, message, symbol=text, suggestions=near)


def parse(text: str, names: Collection[str] = (), joints: int = 9) -> Expr:
    """Read a formula.

    Args:
        text: the formula in the notation of the module.
        names: symbols it may use (lengths, pose entries, symbols of one's own).
        joints: number of joints of the arm.

    Returns:
        The expression tree.

    Raises:
        FormulaError: the text is no formula; the message points at the character.
    """
    return Parser(text, names, joints).parse()


def parse_equation(text: str, names: Collection[str] = (), joints: int = 9) -> tuple[Expr, Expr]:
    """Read ``left = right``; see `parse`."""
    return Parser(text, names, joints).parse_equation()
