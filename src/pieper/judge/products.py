"""Products of matrices as papers write them, read from text.

For example ``A1 A2^-1 T06``, ``(A1 A2 A3)^-1 T``, ``R03^T R06``, ``v1 + Q1 v2``, ``cross(R02[:,3], P06 - P02)``, and
entries ``T06[1,4]``.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from pieper.algebra.parser import parse
from pieper.errors import InputError
from pieper.tolerances import ALL_BUT_ZERO
from pieper.words_by_number import plural

_PIECE = re.compile(
    r"\s*(?:(?P<turn>(?:Rot|Trans|[RT])[xyzXYZ]\s*\([^()]*\))|(?P<call>(?:cross|dot)\s*\()|(?P<name>[A-Za-z]\w*)"
    r"|(?P<inv>\^\s*(?:-1|\(-1\)|\{-1\}))|(?P<tr>\^T|')|(?P<op>[()+*=,-])"
    r"|(?P<part>\[\s*\d?\s*:\s*\d?\s*,\s*\d\s*\])|(?P<entry>\[\s*\d\s*,\s*\d\s*\]\s*$))"
)

MAX_DEPTH = 40  # brackets inside brackets


@dataclass(frozen=True)
class Product:
    """A sum of products of matrices with an optional entry picked from it (1-based, None for the whole)."""

    terms: tuple[tuple[Factor, ...], ...]
    entry: tuple[int, int] | None = None
    minus: frozenset[int] = frozenset()

    def __str__(self) -> str:
        text = ""
        for k, term in enumerate(self.terms):
            sign = ("-" if k in self.minus else "") if not k else " - " if k in self.minus else " + "
            text += sign + " ".join(map(str, term))
        if not self.entry:
            return text
        single = len(self.terms) == len(self.terms[0]) == 1
        return f"{text if single else f'({text})'}[{self.entry[0]},{self.entry[1]}]"


NOTHING = Product(())


@dataclass(frozen=True)
class Factor:
    """A named matrix, a bracket, or a cross or dot product, perhaps inverted, transposed or one column of it.

    Attributes:
        name: The matrix, or cross and dot.
        inside: What a bracket holds.
        of: The two vectors of a cross or dot product.
        part: First and last row (0: the last there is) and column of a part, 1-based; empty for the whole.
        constant: The pose of a constant turn or shift.
    """

    name: str = ""
    inside: Product = NOTHING
    inverse: bool = False
    transpose: bool = False
    constant: tuple[tuple[float, ...], ...] = ()
    of: tuple[Product, ...] = ()
    part: tuple[int, int, int] | tuple[()] = ()

    def __str__(self) -> str:
        text = self.name or f"({self.inside})"
        if self.of:
            text += f"({', '.join(map(str, self.of))})"
        if self.part:
            first, last, column = self.part
            text += f"[{f'{first}:{last}' if last else ':'},{column}]"
        return text + ("^-1" if self.inverse else "") + ("^T" if self.transpose else "")


def factors_of(product: Product) -> list[Factor]:
    """Every factor of a product, those inside brackets and inside cross and dot products too."""
    out: list[Factor] = []
    stack = [product]
    while stack:
        for term in stack.pop().terms:
            for factor in term:
                out.append(factor)
                stack += [factor.inside, *factor.of]
    return out


def parse_product(text: str, joints: int, own: frozenset[str] = frozenset()) -> Product:
    """Read a product of matrices.

    Args:
        text: names A1.. (link), T06, T (base and tool included), R.. (its rotation), P.. (its position), Q1.. and v1..
            (rotation and position of a link), J (the Jacobian), I; side by side or with ``*``, sums with ``+``,
            ``^-1``, ``^T``, brackets, ``cross(..)``, ``dot(..)``, columns ``R03[:,3]``, ``[row,column]`` at the end;
            constant turns and shifts such as Rz(pi/2) and Tx(0.1).
        joints: number of joints.
        own: names of matrices that the file defines.

    Returns:
        The product.
    """
    return _Reader(text, joints, own).read()


class _Reader:
    """One product on its way."""

    def __init__(self, text: str, joints: int, own: frozenset[str]) -> None:
        self.source, self.joints, self.own = text, joints, own
        self.pieces: list[tuple[str, str, int]] = []
        self.at = self.depth = 0
        at = 0
        while text[at:].strip():
            m = _PIECE.match(text, at)
            if not m:
                raise self.fail(at, "this is no product of matrices:")
            kind = m.lastgroup or ""
            self.pieces.append((kind, m.group(kind), m.start(kind)))
            at = m.end()

    def fail(self, position: int, message: str) -> InputError:
        """The error with a caret under the place."""
        return InputError(f"{message}\n  {self.source}\n  {' ' * position}^", text=self.source, position=position)

    def read(self) -> Product:
        """Read all of it."""
        entry = None
        if self.pieces and self.pieces[-1][0] == "entry":
            row, column = re.findall(r"\d", self.pieces[-1][1])
            entry = int(row), int(column)
            if not (1 <= entry[0] <= 6 and 1 <= entry[1] <= 9):
                raise self.fail(self.pieces[-1][2], f"rows and columns count from 1; there is no entry {entry}")
            self.pieces.pop()
        found = self._sum()
        if self.at < len(self.pieces):
            _, word, where = self.pieces[self.at]
            raise self.fail(where, f"{word!r} is not expected here")
        return replace(found, entry=entry)

    def _next(self) -> str:
        return self.pieces[self.at][1] if self.at < len(self.pieces) else ""

    def _sum(self) -> Product:
        minus: set[int] = set()
        if self._next() == "-":
            minus.add(0)
            self.at += 1
        terms = [self._factors()]
        while self._next() in ("+", "-"):
            if self._next() == "-":
                minus.add(len(terms))
            self.at += 1
            terms.append(self._factors())
        return Product(tuple(terms), None, frozenset(minus))

    def _factors(self) -> tuple[Factor, ...]:
        out: list[Factor] = []
        while self._next() not in ("", ")", "+", "-", ","):
            kind, word, where = self.pieces[self.at]
            self.at += 1
            if word == "*" or (kind == "name" and word in ("x", "X") and word not in self.own):
                continue
            if kind == "turn":
                out.append(Factor(re.sub(r"\s", "", word), constant=_constant(word)))
            elif kind == "name":
                if word not in self.own:
                    check_name(word, self.joints, lambda message, w=where: self.fail(w, message))
                out.append(Factor(word))
            elif kind == "call":
                first = self._inside(where, ",")
                out.append(Factor(word.rstrip("( "), of=(first, self._inside(where, ")"))))
            elif word == "(":
                out.append(Factor("", self._inside(where, ")")))
            elif kind in ("inv", "tr") and out:
                last = out.pop()
                out.append(
                    replace(last, inverse=last.inverse ^ (kind == "inv"), transpose=last.transpose ^ (kind == "tr"))
                )
            elif kind == "part" and out and not out[-1].part:
                out.append(replace(out.pop(), part=self._part(word, where)))
            else:
                raise self.fail(where, f"{word!r} is not expected here")
        if not out:
            where = self.pieces[self.at][2] if self.at < len(self.pieces) else len(self.source)
            raise self.fail(where, "a matrix must stand here")
        return tuple(out)

    def _inside(self, where: int, end: str) -> Product:
        self.depth += 1
        if self.depth > MAX_DEPTH:
            raise self.fail(where, f"more than {MAX_DEPTH} brackets inside one another")
        inner = self._sum()
        if self._next() != end:
            raise self.fail(
                where, "this bracket is never closed" if end == ")" else "two vectors and a comma are needed"
            )
        self.at += 1
        self.depth -= 1
        return inner

    def _part(self, word: str, where: int) -> tuple[int, int, int]:
        rows, column = word.strip("[] ").split(",")
        first, last = (int(r) if r.strip() else 0 for r in rows.split(":"))
        first = first or 1
        if not int(column) or (last and last < first):
            raise self.fail(where, f"{word} is no part of a matrix; rows and columns count from 1")
        return first, last, int(column)


def _constant(text: str) -> tuple[tuple[float, ...], ...]:
    """The pose of a turn about, or a shift along, an axis: Rz(pi/2), RotX(-90 deg), Tx(0.1)."""
    word, _, inner = text.rstrip(") ").partition("(")
    axis = "xyz".index(word.strip()[-1].lower())
    value = float(parse(inner, (), 0).evaluate({}))
    M = np.eye(4)
    if word.startswith("T"):
        M[axis, 3] = value
    else:
        i, j = ((1, 2), (2, 0), (0, 1))[axis]
        c, s = (0.0 if abs(x) < ALL_BUT_ZERO else x for x in (np.cos(value), np.sin(value)))
        M[i, i] = M[j, j] = c
        M[i, j], M[j, i] = -s, s
    return tuple(map(tuple, M.tolist()))


def check_name(word: str, joints: int, fail: Callable[[str], InputError]) -> None:
    """Refuse names that are no matrix of this arm."""
    m = re.fullmatch(r"(?:[AQv](\d)|[TRP](\d)?(\d)?|I|J)", word)
    if not m:
        raise fail(f"{word!r} is no matrix; known are A1..A{joints}, Q1.., v1.., T, T0{joints}, R03, P03, J and I")
    for digit in m.groups():
        if digit is not None and int(digit) > joints:
            raise fail(f"{word!r}: the arm has {plural(joints, 'joint')}")
