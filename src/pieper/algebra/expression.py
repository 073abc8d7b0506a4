"""Small immutable expression trees: what a formula is before it is printed, evaluated or handed to sympy.

A computer algebra system rewrites what it is given; the pages written here must keep the form a person would choose
(Horner order along the chain, one atan2, one branch sign). So formulas are plain trees, and one method, `evaluate`,
serves floats, numpy arrays, 50-digit arithmetic and sympy alike: the arithmetic is passed in.
"""

from __future__ import annotations

import functools
from fractions import Fraction


class Expr:
    """A node of a formula. Arithmetic builds new nodes and folds only what no reader would write (x*1, x+0)."""

    __slots__ = ()
    precedence = 9  # printing: 1 sum, 2 product, 3 quotient, 9 atom

    def __add__(self, other):
        return add(self, other)

    def __radd__(self, other):
        return add(other, self)

    def __sub__(self, other):
        return add(self, -as_expr(other))

    def __rsub__(self, other):
        return add(other, -self)

    def __mul__(self, other):
        return mul(self, other)

    def __rmul__(self, other):
        return mul(other, self)

    def __truediv__(self, other):
        return div(self, other)

    def __rtruediv__(self, other):
        return div(other, self)

    def __neg__(self):
        return mul(Num(-1), self)

    def __pow__(self, power: int):
        return Power(self, power)

    def evaluate(self, values, field):
        """Evaluate with `values` (symbol -> number) in the arithmetic `field` (see `fields.py`)."""
        raise NotImplementedError

    def atoms(self) -> set:
        """Every symbol that occurs, trigonometric symbols included."""
        found = set()
        for child in self.children():
            found |= child.atoms()
        return found

    def children(self) -> tuple:
        return ()

    def substitute(self, table: dict) -> Expr:
        """Replace symbols by expressions."""
        return self

    def text(self) -> str:
        from pieper.algebra.notation import text

        return text(self)

    def latex(self) -> str:
        from pieper.algebra.notation import latex

        return latex(self)

    def mathml(self) -> str:
        from pieper.algebra.notation import mathml

        return mathml(self)

    def sympy(self):
        """The same formula for sympy: theta1 as a symbol, c23 as cos(theta2 + theta3), exact rationals."""
        from pieper.algebra.arithmetics import SympyField

        return self.evaluate(SympyField.symbols, SympyField())

    def __repr__(self) -> str:
        return self.text()


class Num(Expr):
    """An exact rational number."""

    __slots__ = ("value",)

    def __init__(self, value):
        self.value = Fraction(value)

    def evaluate(self, values, field):
        return field.rational(self.value)

    def __eq__(self, other):
        return isinstance(other, Num) and other.value == self.value

    def __hash__(self):
        return hash(("Num", self.value))


class PiFraction(Expr):
    """A rational multiple of pi."""

    __slots__ = ("value",)

    def __init__(self, value):
        self.value = Fraction(value)

    def evaluate(self, values, field):
        return field.rational(self.value) * field.pi


class Sym(Expr):
    """A named quantity: a length (a2), a target entry (n_x), a joint (theta1, d3, q2), a branch sign (sigma1).

    Args:
        base: the letter, e.g. "a", "theta", "w".
        sub: the subscript, e.g. "2", "x".
        rank: place inside a product (numbers 0, lengths 1, constants 2, trigonometry 3, target entries 4).
    """

    __slots__ = ("base", "sub", "rank", "order")
    _pool: dict = {}

    def __new__(cls, base: str, sub: str = "", rank: int = 1):
        key = (cls, base, sub)
        found = cls._pool.get(key)
        if found is None:
            found = cls._pool[key] = object.__new__(cls)
            found.base, found.sub, found.rank = base, sub, rank
            found.order = (rank, base if rank != 4 else {"p": "0", "w": "0"}.get(base, base), _natural(sub))
        return found

    def evaluate(self, values, field):
        try:
            return values[self]
        except KeyError:
            raise KeyError(f"no value for the symbol {self.text()}") from None

    def atoms(self):
        return {self}

    def substitute(self, table):
        return table.get(self, self)

    @property
    def name(self) -> str:
        """Plain name used by sympy and in text: a2, theta1, n_x."""
        return self.base + ("_" if self.sub and not self.sub[0].isdigit() else "") + self.sub


class Trig(Expr):
    """The sine or cosine of a whole-number combination of joint angles; prints as c1, s23, c(2-3).

    Args:
        kind: "c" or "s".
        angle: ((joint, factor), ...) with ascending 1-based joints and non-zero integers, the first one positive.
        group: first joint of the run of parallel axes that these joints belong to.
        letter: "theta" (angle of the DH table) or "q" (the maker's joint coordinate).
    """

    __slots__ = ("kind", "angle", "group", "letter", "rank", "order")
    _pool: dict = {}

    def __new__(cls, kind, angle, group, letter="theta"):
        key = (kind, angle, group, letter)
        found = cls._pool.get(key)
        if found is None:
            found = cls._pool[key] = object.__new__(cls)
            found.kind, found.angle, found.group, found.letter, found.rank = kind, angle, group, letter, 3
            found.order = (3, group, len(angle), angle, kind)
        return found

    def argument(self) -> tuple:
        return tuple((factor, angle_symbol(joint, self.letter)) for joint, factor in self.angle)

    def evaluate(self, values, field):
        if self in values:
            return values[self]
        total = field.rational(Fraction(0))
        for factor, symbol in self.argument():
            total = total + field.rational(Fraction(factor)) * symbol.evaluate(values, field)
        return field.cos(total) if self.kind == "c" else field.sin(total)

    def atoms(self):
        return {self}

    def substitute(self, table):
        return table.get(self, self)


class Add(Expr):
    """A sum, in the order it is to be read."""

    __slots__ = ("terms",)
    precedence = 1

    def __init__(self, terms):
        self.terms = tuple(terms)

    def children(self):
        return self.terms

    def evaluate(self, values, field):
        return functools.reduce(lambda x, y: x + y, (t.evaluate(values, field) for t in self.terms))

    def substitute(self, table):
        return add(*(t.substitute(table) for t in self.terms))


class Mul(Expr):
    """A product, in the order it is to be read."""

    __slots__ = ("factors",)
    precedence = 2

    def __init__(self, factors):
        self.factors = tuple(factors)

    def children(self):
        return self.factors

    def evaluate(self, values, field):
        return functools.reduce(lambda x, y: x * y, (t.evaluate(values, field) for t in self.factors))

    def substitute(self, table):
        return mul(*(t.substitute(table) for t in self.factors))


class Div(Expr):
    """A quotient."""

    __slots__ = ("over", "under")
    precedence = 3

    def __init__(self, over, under):
        self.over, self.under = over, under

    def children(self):
        return (self.over, self.under)

    def evaluate(self, values, field):
        return self.over.evaluate(values, field) / self.under.evaluate(values, field)

    def substitute(self, table):
        return div(self.over.substitute(table), self.under.substitute(table))


class Power(Expr):
    """A whole-number power."""

    __slots__ = ("base", "power")
    precedence = 4

    def __init__(self, base, power):
        self.base, self.power = as_expr(base), int(power)

    def children(self):
        return (self.base,)

    def evaluate(self, values, field):
        return self.base.evaluate(values, field) ** self.power

    def substitute(self, table):
        return Power(self.base.substitute(table), self.power)


class Call(Expr):
    """A function of expressions: sqrt, atan2, acos, sign."""

    __slots__ = ("name", "args")
    precedence = 9

    def __init__(self, name, *args):
        self.name, self.args = name, tuple(as_expr(a) for a in args)

    def children(self):
        return self.args

    def evaluate(self, values, field):
        return getattr(field, self.name)(*(a.evaluate(values, field) for a in self.args))

    def substitute(self, table):
        return Call(self.name, *(a.substitute(table) for a in self.args))


ZERO, ONE = Num(0), Num(1)


def as_expr(value) -> Expr:
    return value if isinstance(value, Expr) else Num(value)


def angle_symbol(joint: int, letter: str = "theta") -> Sym:
    """The symbol of a joint's angle, theta3 or q3."""
    return Sym(letter, str(joint), 1)


def add(*terms) -> Expr:
    """Sum of expressions; nested sums are joined, exact zeros dropped."""
    flat = []
    for term in map(as_expr, terms):
        flat.extend(term.terms if isinstance(term, Add) else (term,))
    number = sum((t.value for t in flat if isinstance(t, Num)), Fraction(0))
    rest = [t for t in flat if not isinstance(t, Num)]
    if number:
        place = next(i for i, t in enumerate(flat) if isinstance(t, Num))
        rest.insert(min(place, len(rest)), Num(number))
    if not rest:
        return ZERO
    return rest[0] if len(rest) == 1 else Add(rest)


def mul(*factors) -> Expr:
    """Product of expressions; nested products are joined, numbers gathered in front."""
    flat = []
    for factor in map(as_expr, factors):
        flat.extend(factor.factors if isinstance(factor, Mul) else (factor,))
    number = Fraction(1)
    rest = []
    for factor in flat:
        if isinstance(factor, Num):
            number *= factor.value
        else:
            rest.append(factor)
    if not number:
        return ZERO
    if len(rest) == 1 and isinstance(rest[0], PiFraction):
        return PiFraction(number * rest[0].value)
    if number == -1 and len(rest) == 1 and isinstance(rest[0], Add):
        return Add([mul(Num(-1), t) for t in rest[0].terms])
    if number != 1:
        rest.insert(0, Num(number))
    if not rest:
        return ONE
    return rest[0] if len(rest) == 1 else Mul(rest)


def div(over, under) -> Expr:
    over, under = as_expr(over), as_expr(under)
    if isinstance(under, Num):
        return mul(Num(1 / under.value), over)
    return over if over == ZERO else Div(over, under)


def sqrt(value) -> Expr:
    return Call("sqrt", value)


def atan2(y, x) -> Expr:
    return Call("atan2", y, x)


def negative(expr: Expr) -> bool:
    """Whether the expression starts with a minus sign when printed."""
    if isinstance(expr, (Num, PiFraction)):
        return expr.value < 0
    if isinstance(expr, Mul):
        return negative(expr.factors[0])
    if isinstance(expr, Add):
        return negative(expr.terms[0])
    return isinstance(expr, Div) and negative(expr.over)


def _natural(sub: str):
    return (0, int(sub), "") if sub.isdigit() else (1, 0, sub)
