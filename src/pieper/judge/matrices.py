"""Products of matrices as papers write them.

For example ``A1 A2^-1 T06``, ``(A1 A2 A3)^-1 T``, ``R03^T R06``, ``v1 + Q1 v2``, and entries ``T06[1,4]``.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import numpy as np

from pieper.algebra.parser import parse
from pieper.errors import InputError
from pieper.tolerances import ALL_BUT_ZERO
from pieper.words_by_number import plural

_PIECE = re.compile(
    r"\s*(?:(?P<turn>(?:Rot|Trans|[RT])[xyzXYZ]\s*\([^()]*\))|(?P<name>[A-Za-z]\w*)|(?P<inv>\^\s*(?:-1|\(-1\)|\{-1\}))|(?P<tr>\^T|')|(?P<op>[()+*=-])|(?P<entry>\[\s*\d\s*,\s*\d\s*\]\s*$))"
)


@dataclass(frozen=True)
class Factor:
    """A named matrix or a bracket, perhaps inverted or transposed."""

    name: str = ""
    inside: tuple[Factor, ...] = ()
    inverse: bool = False
    transpose: bool = False
    constant: tuple[tuple[float, ...], ...] = ()

    def __str__(self) -> str:
        text = self.name or "(" + " ".join(map(str, self.inside)) + ")"
        return text + ("^-1" if self.inverse else "") + ("^T" if self.transpose else "")


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


def parse_product(text: str, joints: int, own: frozenset[str] = frozenset()) -> Product:
    """Read a product of matrices.

    Args:
        text: names A1.. (link), T06, T (base and tool included), R.. (its rotation), P.. (its position), Q1.. and v1..
            (rotation and position of a link), I; side by side or with ``*``, sums with ``+``, ``^-1``, ``^T``,
            brackets, ``[row,column]`` at the end; constant turns and shifts such as Rz(pi/2) and Tx(0.1).
        joints: number of joints.
        own: names of matrices that the file defines.

    Returns:
        The product.
    """
    pieces, at = [], 0
    source = text
    while text[at:].strip():
        m = _PIECE.match(text, at)
        if not m:
            raise InputError(f"this is no product of matrices:\n  {source}\n  {' ' * at}^", text=source, position=at)
        kind = m.lastgroup or ""
        pieces.append((kind, m.group(kind), m.start(kind)))
        at = m.end()

    def fail(position: int, message: str) -> InputError:
        return InputError(f"{message}\n  {source}\n  {' ' * position}^", text=source, position=position)

    entry = None
    if pieces and pieces[-1][0] == "entry":
        row, column = re.findall(r"\d", pieces[-1][1])
        entry = int(row), int(column)
        if not (1 <= entry[0] <= 4 and 1 <= entry[1] <= 4):
            raise fail(pieces[-1][2], f"a pose has rows and columns 1 to 4, not {entry}")
        pieces.pop()
    position = 0

    def factors() -> tuple[Factor, ...]:
        nonlocal position
        out = []
        while position < len(pieces):
            kind, word, where = pieces[position]
            if word in (")", "+", "-"):
                break
            position += 1
            if word == "*":
                continue
            if kind == "turn":
                out.append(Factor(re.sub(r"\s", "", word), constant=_constant(word)))
            elif kind == "name":
                if word in ("x", "X"):
                    continue
                if word not in own:
                    check_name(word, joints, lambda message, w=where: fail(w, message))
                out.append(Factor(word))
            elif word == "(":
                inner = factors()
                if position >= len(pieces) or pieces[position][1] != ")":
                    raise fail(where, "this bracket is never closed")
                position += 1
                out.append(Factor("", inner))
            elif kind in ("inv", "tr") and out:
                last = out.pop()
                out.append(
                    replace(last, inverse=last.inverse ^ (kind == "inv"), transpose=last.transpose ^ (kind == "tr"))
                )
            else:
                raise fail(where, f"{word!r} is not expected here")
        if not out:
            raise fail(pieces[position][2] if position < len(pieces) else len(source), "a matrix must stand here")
        return tuple(out)

    minus: set[int] = set()
    if pieces and pieces[0][1] == "-":
        minus.add(0)
        position = 1
    terms = [factors()]
    while position < len(pieces) and pieces[position][1] in ("+", "-"):
        if pieces[position][1] == "-":
            minus.add(len(terms))
        position += 1
        terms.append(factors())
    if position < len(pieces):
        raise fail(pieces[position][2], f"{pieces[position][1]!r} is not expected here")
    return Product(tuple(terms), entry, frozenset(minus))


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
    m = re.fullmatch(r"(?:[AQv](\d)|[TRP](\d)?(\d)?|I)", word)
    if not m:
        raise fail(f"{word!r} is no matrix; known are A1..A{joints}, Q1.., v1.., T, T0{joints}, R03, P03 and I")
    for digit in m.groups():
        if digit is not None and int(digit) > joints:
            raise fail(f"{word!r}: the arm has {joints} joints")


def value_of(product: Product, frames: dict[str, np.ndarray]) -> np.ndarray:
    """Evaluate a product at all samples, (K, 4, 4), (K, 3, 3) or (K, 3); with an entry, (K,)."""
    parts = [(-1 if k in product.minus else 1) * _chain(term, frames) for k, term in enumerate(product.terms)]
    total = parts[0]
    for part in parts[1:]:
        total = total + part
    if product.entry is None:
        return total
    row, column = product.entry
    if total.ndim == 2:
        return total[:, row - 1]
    if row > total.shape[1] or column > total.shape[2]:
        raise InputError(
            f"{product}: this matrix has {plural(total.shape[1], 'row')} and {plural(total.shape[2], 'column')}"
        )
    return total[:, row - 1, column - 1]


def _chain(factors: tuple[Factor, ...], frames: dict[str, np.ndarray]) -> np.ndarray:
    out: np.ndarray | None = None
    for factor in factors:
        if factor.constant:
            M = np.broadcast_to(np.array(factor.constant), frames["T"].shape)
        else:
            M = _named(factor.name, frames) if factor.name else _chain(factor.inside, frames)
        if factor.inverse:
            M = np.linalg.inv(M)
        if factor.transpose:
            M = np.swapaxes(M, -1, -2)
        if out is None:
            out = M
        else:
            if out.ndim == M.ndim == 3 and {out.shape[1], M.shape[1]} == {3, 4} and any(f.constant for f in factors):
                out, M = out[:, :3, :3], M[:, :3, :3]  # a constant turn beside a rotation is one
            try:
                out = (out @ M[..., None])[..., 0] if M.ndim == 2 else out @ M
            except ValueError:
                raise InputError(
                    f"{' '.join(map(str, factors))}: a {out.shape[1:]} and a {M.shape[1:]} matrix cannot be multiplied"
                ) from None
    assert out is not None  # a term has a factor at least
    return out


def _named(name: str, frames: dict[str, np.ndarray]) -> np.ndarray:
    if name in frames and name not in ("T",):
        return frames[name]
    if name == "I":
        return np.broadcast_to(np.eye(4), frames["T"].shape)
    if name[0] in "AQv" and len(name) == 2:
        M = frames["A" + name[1]]
    elif len(name) == 1:
        M = frames["T"]
    else:
        first, last = (0, int(name[1])) if len(name) == 2 else (int(name[1]), int(name[2]))
        M = np.broadcast_to(np.eye(4), frames["T"].shape)
        for k in range(min(first, last), max(first, last)):
            M = M @ frames[f"A{k + 1}"]
        if first > last:
            M = np.linalg.inv(M)
    if name[0] in "RQ":
        return M[:, :3, :3]
    return M[:, :3, 3] if name[0] in "Pv" else M


def product_slips(product: Product, joints: int) -> Iterator[tuple[str, str, Product]]:
    """Yield (kind, words, product) for products one slip away: another order, an inverse, a factor lost or too many."""
    for k, term in enumerate(product.terms):
        for kind, words, factors in _term_slips(term, joints):
            yield kind, words, replace(product, terms=product.terms[:k] + (factors,) + product.terms[k + 1 :])


def _term_slips(term: tuple[Factor, ...], joints: int) -> Iterator[tuple[str, str, tuple[Factor, ...]]]:
    inverses = [i for i, f in enumerate(term) if f.inverse and f.name]
    if 2 <= len(inverses) <= 5:
        for order in itertools.permutations(inverses):
            if list(order) != inverses:
                new = list(term)
                for place, taken in zip(inverses, order, strict=True):
                    new[place] = term[taken]
                yield "order", "the inverses in the wrong order", tuple(new)
    for i, (f, g) in enumerate(itertools.pairwise(term)):
        yield "order", f"{f} and {g} exchanged", (*term[:i], g, f, *term[i + 2 :])
    for i, f in enumerate(term):
        before, after = term[:i], term[i + 1 :]
        yield "inverse", f"{f} for its inverse", (*before, replace(f, inverse=not f.inverse), *after)
        if f.transpose:
            yield "inverse", f"{f} transposed", (*before, replace(f, transpose=False), *after)
    for i in range(len(term) + 1):
        for joint in range(1, joints + 1):
            for inverse in (False, True):
                extra = Factor(f"A{joint}", (), inverse)
                yield "missing factor", f"{extra} lost", (*term[:i], extra, *term[i:])
    for i, f in enumerate(term):
        if len(term) > 1:
            yield "extra factor", f"{f} too many", term[:i] + term[i + 1 :]
