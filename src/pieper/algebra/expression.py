"""Small immutable expression trees: what a formula is, whether derived here or typed by somebody.

A computer algebra system rewrites what it is given; the pages written here must keep the form a person would choose
(Horner order along the chain, one atan2, one branch sign), and what somebody typed must be printed back as it was
typed. So formulas are plain trees, and one method, `evaluate`, serves floats, arrays, 50-digit arithmetic and sympy
alike: the arithmetic is passed in.

The operators and `add`, `mul`, `div` fold what no reader would write (x*1, x+0); the constructors `Add` and `Mul`
hold a formula as written (`formula` has what only typed formulas hold). Nodes compare by identity, numbers by value;
symbols of derived formulas are pooled.
"""

from __future__ import annotations

import operator
from collections.abc import Iterable, Mapping
from fractions import Fraction
from functools import reduce
from typing import Any

from pieper.algebra.node import Node


class Expr(Node):
    """A node of a formula."""

    __slots__ = ()

    def __add__(self, other: Any) -> Expr:
        return add(self, other)

    def __radd__(self, other: Any) -> Expr:
        return add(other, self)

    def __sub__(self, other: Any) -> Expr:
        return add(self, -as_expr(other))

    def __rsub__(self, other: Any) -> Expr:
        return add(other, -self)

    def __mul__(self, other: Any) -> Expr:
        return mul(self, other)

    def __rmul__(self, other: Any) -> Expr:
        return mul(other, self)

    def __truediv__(self, other: Any) -> Expr:
        return div(self, other)

    def __rtruediv__(self, other: Any) -> Expr:
        return div(other, self)

    def __neg__(self) -> Expr:
        return mul(Num(-1), self)

    def __pow__(self, power: int) -> Expr:
        return Power(self, Num(power))

    def atoms(self) -> set[Sym | Trig]:
        """Every symbol that occurs, trigonometric symbols included."""
        return {node for node in self.walk() if isinstance(node, (Sym, Trig))}

    def symbols(self) -> set[str]:
        """The names of all symbols."""
        return {node.name for node in self.walk() if isinstance(node, Sym)}


# -- atoms ---------------------------------------------------------------------------------------------------
class Num(Expr):
    """An exact rational number.

    Args:
        value: The number.
        written: Its digits as somebody typed them, "" for a derived number.
    """

    __slots__ = ("value", "written")
    op = "num"

    def __init__(self, value: Any, written: str = "") -> None:
        self.value, self.written = Fraction(value), written

    def _looked_up(self, values: Mapping[Any, Any], field: Any) -> Any:
        return field.rational(self.value)

    def __eq__(self, other: Any) -> bool:
        return isinstance(other, Num) and other.value == self.value

    def __hash__(self) -> int:
        return hash(("Num", self.value))


class PiFraction(Expr):
    """A rational multiple of pi."""

    __slots__ = ("value",)
    op = "pi"

    def __init__(self, value: Any) -> None:
        self.value = Fraction(value)

    def _looked_up(self, values: Mapping[Any, Any], field: Any) -> Any:
        return field.rational(self.value) * field.pi


class Sym(Expr):
    """A named quantity: a length (a2), a target entry (n_x), a joint (theta1, d3, q2), a branch sign (sigma1).

    Args:
        base: the letter, e.g. "a", "theta", "w".
        sub: the subscript, e.g. "2", "x".
        rank: place inside a product (numbers 0, lengths 1, constants 2, trigonometry 3, target entries 4).
    """

    __slots__ = ("base", "sub", "rank", "order", "name")
    op = "sym"
    _pool: dict = {}
    base: str
    sub: str
    rank: int
    order: tuple
    name: str  # plain, as sympy and text have it: a2, theta1, n_x

    def __new__(cls, base: str, sub: str = "", rank: int = 1) -> Sym:
        """Return the one symbol of this name and place."""
        key = (cls, base, sub, rank)
        found = cls._pool.get(key)
        if found is None:
            found = cls._pool[key] = object.__new__(cls)
            found.base, found.sub, found.rank = base, sub, rank
            found.name = base + ("_" if sub and not sub[0].isdigit() else "") + sub
            found.order = (rank, base if rank != 4 else {"p": "0", "w": "0"}.get(base, base), natural(sub))
        return found

    def __reduce__(self) -> tuple[Any, ...]:
        return Sym, (self.base, self.sub, self.rank)

    def _looked_up(self, values: Mapping[Any, Any], field: Any) -> Any:
        try:
            return values[self]
        except KeyError:
            raise KeyError(f"no value for the symbol {self.name}") from None

    def substitute(self, table: Mapping[Any, Any]) -> Any:
        """What the table has for this symbol."""
        return table.get(self, self)


class Trig(Expr):
    """The sine or cosine of a whole-number combination of joint angles; prints as c1, s23, c(2-3).

    Args:
        kind: "c" or "s".
        angle: ((joint, factor), ...) with ascending 1-based joints and non-zero integers, the first one positive.
        group: first joint of the run of parallel axes that these joints belong to.
        letter: "theta" (angle of the DH table) or "q" (the maker's joint coordinate).
    """

    __slots__ = ("kind", "angle", "group", "letter", "rank", "order")
    op = "trig"
    _pool: dict = {}
    kind: str
    angle: tuple[tuple[int, int], ...]
    group: int
    letter: str
    rank: int
    order: tuple

    def __new__(cls, kind: str, angle: tuple, group: int, letter: str = "theta") -> Trig:
        """Return the one function of this angle."""
        key = (kind, angle, group, letter)
        found = cls._pool.get(key)
        if found is None:
            found = cls._pool[key] = object.__new__(cls)
            found.kind, found.angle, found.group, found.letter, found.rank = kind, angle, group, letter, 3
            found.order = (3, group, len(angle), angle, kind)
        return found

    def __reduce__(self) -> tuple[Any, ...]:
        return Trig, (self.kind, self.angle, self.group, self.letter)

    def argument(self) -> tuple:
        """((factor, symbol), ...) of the angle."""
        return tuple((factor, angle_symbol(joint, self.letter)) for joint, factor in self.angle)

    def _looked_up(self, values: Mapping[Any, Any], field: Any) -> Any:
        if self in values:
            return values[self]
        total = field.rational(Fraction(0))
        for factor, symbol in self.argument():
            total = total + field.rational(Fraction(factor)) * symbol.evaluate(values, field)
        return field.cos(total) if self.kind == "c" else field.sin(total)

    def substitute(self, table: Mapping[Any, Any]) -> Any:
        """What the table has for this symbol."""
        return table.get(self, self)


# -- operations ----------------------------------------------------------------------------------------------
class Operation(Expr):
    """A node with arguments; `combine` takes the values of two."""

    __slots__ = ("args",)
    combine: Any

    def __init__(self, *args: Expr) -> None:
        self.args = args

    def _rebuilt(self, args: Iterable[Any]) -> Any:
        return type(self)(*args)

    def _combined(self, v: list[Any], field: Any, branch: int) -> Any:
        return reduce(type(self).combine, v)


class Chained(Operation):
    """An operation of any number of arguments, in the order it is to be read."""

    __slots__ = ()

    @classmethod
    def of(cls, *args: Expr) -> Expr:
        """The operation as written: the same one inside it is joined, nothing else is touched."""
        flat = [part for arg in args for part in (arg.args if isinstance(arg, cls) else (arg,))]
        return flat[0] if len(flat) == 1 else cls(*flat)

    def _rebuilt(self, args: Iterable[Any]) -> Any:
        return self.of(*args)


class Add(Chained):
    """A sum."""

    __slots__ = ()
    op, precedence, combine = "sum", 1, operator.add


class Mul(Chained):
    """A product."""

    __slots__ = ()
    op, precedence, combine = "product", 2, operator.mul


class Div(Operation):
    """A quotient."""

    __slots__ = ()
    op, precedence, combine = "quotient", 3, operator.truediv

    def _combined(self, v: list[Any], field: Any, branch: int) -> Any:
        try:
            return v[0] / v[1]
        except ZeroDivisionError:  # plain numbers; arrays have an infinity or NaN there
            return field.undefined


class Power(Operation):
    """A power; derived formulas have whole-number powers only."""

    __slots__ = ()
    op = "power"
    precedence = 4

    @property
    def base(self) -> Expr:
        """What is raised."""
        return self.args[0]

    @property
    def power(self) -> int | Fraction | None:
        """The exponent where it is a number."""
        exponent = self.args[1]
        if not isinstance(exponent, Num):
            return None
        return exponent.value.numerator if exponent.value.denominator == 1 else exponent.value

    def _combined(self, v: list[Any], field: Any, branch: int) -> Any:
        return field.power(v[0], self.power if type(self.power) is int else v[1])


class Call(Operation):
    """A function of expressions: sqrt, atan2, acos, sgn."""

    __slots__ = ("name",)
    op = "call"

    def __init__(self, name: str, *args: Any) -> None:
        super().__init__(*map(as_expr, args))
        self.name = name

    def _rebuilt(self, args: Iterable[Any]) -> Any:
        return Call(self.name, *args)

    def _combined(self, v: list[Any], field: Any, branch: int) -> Any:
        return getattr(field, self.name)(*v)


# -- building ------------------------------------------------------------------------------------------------
ZERO, ONE = Num(0), Num(1)


def as_expr(value: Any) -> Expr:
    """The value itself when it is an expression, else the exact number."""
    return value if isinstance(value, Expr) else Num(value)


def angle_symbol(joint: int, letter: str = "theta") -> Sym:
    """The symbol of a joint's angle, theta3 or q3."""
    return Sym(letter, str(joint), 1)


def add(*terms: Any) -> Expr:
    """Sum of expressions; nested sums are joined, exact zeros dropped."""
    flat: list[Expr] = []
    for term in map(as_expr, terms):
        flat.extend(term.args if isinstance(term, Add) else (term,))
    number = sum((t.value for t in flat if isinstance(t, Num)), Fraction(0))
    rest = [t for t in flat if not isinstance(t, Num)]
    if number:
        place = next(i for i, t in enumerate(flat) if isinstance(t, Num))
        rest.insert(min(place, len(rest)), Num(number))
    return Add.of(*rest) if rest else ZERO


def mul(*factors: Any) -> Expr:
    """Product of expressions; nested products are joined, numbers gathered in front."""
    flat: list[Expr] = []
    for factor in map(as_expr, factors):
        flat.extend(factor.args if isinstance(factor, Mul) else (factor,))
    number = Fraction(1)
    rest: list[Expr] = []
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
        return Add(*(mul(Num(-1), t) for t in rest[0].args))
    if number != 1:
        rest.insert(0, Num(number))
    return Mul.of(*rest) if rest else ONE


def div(over: Any, under: Any) -> Expr:
    """Quotient of expressions; a division by a number becomes a product."""
    over, under = as_expr(over), as_expr(under)
    if isinstance(under, Num):
        return mul(Num(1 / under.value), over)
    return over if over == ZERO else Div(over, under)


def sqrt(value: Any) -> Expr:
    """Square root."""
    return Call("sqrt", value)


def atan2(y: Any, x: Any) -> Expr:
    """Angle of the point (x, y)."""
    return Call("atan2", y, x)


def natural(sub: str) -> tuple[int, int, str]:
    """Sort key of a subscript: numbers by size, letters after them."""
    return (0, int(sub), "") if sub.isdigit() else (1, 0, sub)
