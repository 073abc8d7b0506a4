"""What a wrong formula lacks: the value that must stand at a place is known, and is looked up among what people write.

A list of near formulas can hold the slips of one letter. A lost term or a lost factor may be any product of a few
letters, so it is found the other way round: what must be added (or multiplied) at a place is a number at every sample,
and the products of up to three letters are kept in order of size, so that finding those with that value is a search in
a sorted list.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations, combinations_with_replacement, permutations, product
from typing import Any

import numpy as np

from pieper.algebra.expression import Add, Call, Div, Expr, Mul, Num, PiFraction, Power, Sym
from pieper.algebra.formula import ANGLE, Equation, Mention, Neg, PlusMinus, is_call, number, positions, unordered
from pieper.judge.slips.slip import Slip
from pieper.kinematics.joints import short_way
from pieper.tolerances import CONSTANT_GAP, SEARCH_ARC, SEARCH_SAME

FACTORS = 3  # letters in a lost term
LONG = 5  # letters in a lost term of a sum whose other terms are long
AMONG = 20  # letters of which long products are made: sines, cosines and lengths, each once
FIRST = 52  # letters of which products are made; more are seldom in one formula
MOST_TERMS = 6  # of a sum whose neighbours may share a lost factor
ENOUGH = 3  # samples at which a product must have the value; the others may be on another branch
ANCHORS = 4  # samples at which a product is looked up; on a wrong branch a value is of no use
ENTRIES = ("noa", "r", "p", "P")  # letters of a pose that go together
COEFFICIENTS = (Fraction(1), Fraction(2), Fraction(1, 2))


@dataclass(frozen=True)
class Found:
    """A product of letters: a coefficient and the letters' places on the shelf."""

    coefficient: Fraction
    letters: tuple[int, ...]


class Shelf:
    """Products of up to three letters in the order of their size at each of some samples.

    Args:
        letters: What may stand in a product.
        env: Values of all symbols at a few samples, (P,) each.
        values: Values of subexpressions already known.
        long: Letters that may also stand in products of four and five, as texts.
    """

    def __init__(
        self,
        letters: Mapping[str, Expr],
        env: dict[str, np.ndarray],
        values: dict[Expr, Any],
        long: tuple[str, ...] = (),
    ) -> None:
        self.shape = shape = np.shape(env["theta1"])
        self.letters: list[Expr] = []
        logs, signs = [], []
        with np.errstate(all="ignore"):
            for letter in list(letters.values())[:FIRST]:
                value = np.broadcast_to(np.asarray(letter.evaluate(env, cache=values, learn=False), dtype=float), shape)
                if np.all(np.isfinite(value)) and np.all(value != 0):
                    self.letters.append(letter)
                    logs.append(np.log(np.abs(value)))
                    signs.append(np.sign(value))
        self._logs, self._signs, self._products = (
            [np.zeros((1, *shape))],
            [np.ones((1, *shape))],
            [np.zeros((1, 0), int)],
        )
        if logs:
            kept = [k for k, letter in enumerate(self.letters) if str(letter) in long]
            self._angles = [str(x.args[0]) if isinstance(x, Call) else "" for x in self.letters]
            for size in range(1, (LONG if len(kept) >= LONG else FACTORS) + 1):
                made = (
                    combinations_with_replacement(range(len(logs)), size)
                    if size <= FACTORS
                    else combinations(kept, size)
                )
                chosen = np.array([row for row in made if size <= FACTORS or self._may_be(row)])
                if not len(chosen):
                    break
                self._products.append(chosen)
                self._logs.append(np.array(logs)[chosen].sum(1))
                self._signs.append(np.array(signs)[chosen].prod(1))
        self._order = [[np.argsort(part[:, p], kind="stable") for p in range(ANCHORS)] for part in self._logs]
        self._sorted = [
            [part[order, p] for p, order in enumerate(orders)]
            for part, orders in zip(self._logs, self._order, strict=True)
        ]

    def _may_be(self, row: tuple[int, ...]) -> bool:
        """Whether no sine goes with the cosine of the same angle: entries of products of matrices have none such."""
        angles = [angle for k in row if (angle := self._angles[k])]
        return len(set(angles)) == len(angles)

    def find(
        self, value: np.ndarray, most: int = FACTORS, least: int = 0, *, unsigned: bool = False
    ) -> Iterator[Found]:
        """Yield the products, fewest letters first, that have a value (P,) at a few of the samples.

        Args:
            value: What is wanted, nan where unknown.
            most: Letters at most.
            least: Letters at least.
            unsigned: Whether the size alone is known, as of what is squared.
        """
        size, sign = np.log(np.abs(value)), np.sign(value)
        for letters in range(least, min(most, len(self._logs) - 1) + 1):
            logs, signs, products = self._logs[letters], self._signs[letters], self._products[letters]
            for coefficient in COEFFICIENTS:
                wanted = size - np.log(float(coefficient))
                seen: set[int] = set()
                for anchor in range(ANCHORS):
                    if not np.isfinite(wanted[anchor]):
                        continue
                    ends = wanted[anchor] - SEARCH_SAME, wanted[anchor] + SEARCH_SAME
                    first, last = self._sorted[letters][anchor].searchsorted(ends)
                    for k in self._order[letters][anchor][first:last].tolist():
                        if k in seen:
                            continue
                        seen.add(k)
                        near = np.abs(logs[k] - wanted) < SEARCH_SAME
                        for sense in (1, -1):
                            if np.count_nonzero(near & ((signs[k] * sense == sign) | unsigned)) >= ENOUGH:
                                yield Found(sense * coefficient, tuple(products[k].tolist()))

    def product(self, found: Found, before: Expr | None = None) -> Expr:
        """Write a product, its sign left out: coefficient, lengths, what stood there before, and the rest."""
        letters = [self.letters[k] for k in found.letters]
        if before is not None:
            letters.append(before)
        parts: list[Expr] = []
        size = abs(found.coefficient)
        if size != 1 or not letters:
            parts.append(number(str(size)) if size.denominator == 1 else Num(size))
        seen: dict[str, int] = {}
        for letter in letters:
            seen[str(letter)] = seen.get(str(letter), 0) + 1
        parts += [
            Power(letter, number(seen[str(letter)])) if seen[str(letter)] > 1 else letter
            for letter in {str(x): x for x in letters}.values()
        ]
        return Mul.of(*parts)


@dataclass(frozen=True)
class Lost:
    """What may be missing from one formula.

    Attributes:
        letters: What a lost product may be made of.
        joints: How many joints the arm has.
        own: Names of the angles that the formula is for, which it may not use.
        angle: Whether it is a formula for an angle.
        long: Letters of which terms of more than three may be made, as texts.
    """

    letters: Mapping[str, Expr]
    joints: int
    own: frozenset[str] = frozenset()
    angle: bool = False
    long: tuple[str, ...] = ()

    def shelf(self, env: dict[str, np.ndarray], values: dict[Expr, Any]) -> Shelf:
        """The products of its letters at a few samples."""
        return Shelf(self.letters, env, values, self.long)

    def slips(
        self,
        root: Expr,
        shelf: Shelf,
        needed: Mapping[tuple[int, ...], np.ndarray],
        values: Mapping[Expr, Any],
        *,
        any_slip: bool = False,
    ) -> Iterator[Slip]:
        """Yield the formulas with a lost term or a lost factor put back.

        Args:
            root: The formula as printed.
            shelf: Products of letters.
            needed: Path -> value that must stand there, (P,).
            values: Values of all subexpressions as printed, (P,) each.
            any_slip: Also signs and exchanged letters, which a list of near formulas has otherwise.
        """
        seen: set[Expr] = set()
        for path, node, parent in positions(root):
            if path not in needed or node in seen or isinstance(node, Equation):
                continue
            seen.add(node)
            with np.errstate(all="ignore"):
                need = np.broadcast_to(np.asarray(needed[path], dtype=float), shelf.shape)
                value = np.broadcast_to(np.asarray(values[node], dtype=float), shelf.shape)
                if not isinstance(parent, Add | Neg) and (parent is None or not isinstance(node, PlusMinus)):
                    inside = isinstance(parent, Mul) and not isinstance(node, Add)
                    yield from _terms(root, path, node, shelf, need - value, 0.4 * inside)
                if not isinstance(parent, Mul) and not isinstance(node, Neg | Num):
                    yield from _factors(root, path, node, shelf, need / value)
                if isinstance(node, Add):
                    yield from _parts_of_sum(root, path, node, shelf, need - value, values)
                if isinstance(node, Mul):
                    yield from _parts_of_product(root, path, node, shelf, need, values)
                squared = isinstance(parent, Power) and isinstance(parent.power, int) and not parent.power % 2
                yield from _letters(root, path, node, shelf, need, squared=squared)
                if any_slip and np.count_nonzero(np.abs(need + value) < SEARCH_SAME * np.abs(value)) >= ENOUGH:
                    yield Slip("sign", ("the sign of {}", node), root, path, Neg.of(node), 0.5)

    def angles(self, root: Expr, gap: np.ndarray, env: Mapping[str, np.ndarray]) -> Iterator[Slip]:
        """Yield the formulas for an angle from which another joint's angle is missing.

        Args:
            root: The formula.
            gap: What is missing, rad, modulo a turn, (P,).
            env: Values of all symbols.
        """
        for name in (f"theta{j}" for j in range(1, self.joints + 1)):
            for sign in (1, -1):
                off = np.abs(short_way(gap - sign * env[name]))
                if name not in self.own and np.count_nonzero(off < SEARCH_ARC) * 2 >= len(off):
                    term = Mention(name)
                    new = Add.of(root, term if sign > 0 else Neg.of(term))
                    yield Slip("missing term", ("{} lost", term), root, (), new, 1.0)
        if np.ptp(np.cos(gap)) + np.ptp(np.sin(gap)) < CONSTANT_GAP:
            return  # the same at every sample: half a turn, say
        entries = [e for e in self.letters.values() if isinstance(e, Sym) and _any_entry(e.name)]
        # of one that is zero for this arm atan2 is no angle, but a half turn here and there
        entries = [e for e in entries if np.abs(env[e.name]).max() > CONSTANT_GAP]
        for y, x in permutations(entries, 2):
            for sy, sx in product((1, -1), repeat=2):
                arc = np.arctan2(sy * env[y.name], sx * env[x.name])
                if np.count_nonzero(np.abs(short_way(gap - arc)) < SEARCH_ARC) >= ENOUGH:
                    term = Call("atan2", y if sy > 0 else Neg.of(y), x if sx > 0 else Neg.of(x))
                    yield Slip("missing term", ("{} lost", term), root, (), Add.of(term, root), 1.1)


def _terms(root: Expr, path: tuple[int, ...], node: Expr, shelf: Shelf, gap: np.ndarray, more: float) -> Iterator[Slip]:
    for found in shelf.find(gap, most=LONG):
        term = shelf.product(found)
        if unordered(term) in (unordered(Mul.of(number(2), node)), unordered(node)):
            continue  # a sign, or a factor
        gone = unordered(term if found.coefficient < 0 else Neg.of(term))
        rest = [a for a in node.args if unordered(a) != gone] if isinstance(node, Add) else []
        if rest and len(rest) < len(node.args):
            yield Slip("extra term", ("{} too many", term), root, path, Add.of(*rest), 1.25)
            continue
        new = Add.of(node, Neg.of(term) if found.coefficient < 0 else term)
        cost = 1.2 + more + 0.15 * len(found.letters) + 0.2 * (abs(found.coefficient) != 1) + 0.5 * (not found.letters)
        cost += _foreign(root, shelf, found)
        yield Slip("missing term", ("{} lost after {}", term, node), root, path, new, cost)


def _foreign(root: Expr, shelf: Shelf, found: Found) -> float:
    """What it costs that a product has letters of the pose's rotation where the formula has none."""
    if any(_entry(name, letters) for name in root.symbols() for letters in ("noa", "r")):
        return 0.0
    letters = [shelf.letters[k] for k in found.letters]
    return 0.1 * sum(isinstance(x, Sym) and (_entry(x.name, "noa") or _entry(x.name, "r")) for x in letters)


def _factors(root: Expr, path: tuple[int, ...], node: Expr, shelf: Shelf, ratio: np.ndarray) -> Iterator[Slip]:
    for found in shelf.find(ratio, most=2):
        if found.coefficient < 0 and not found.letters and abs(found.coefficient) == 1:
            continue  # a sign, which has its own words
        factor = shelf.product(found)
        new = shelf.product(found, node)
        cost = 1.05 + 0.25 * len(found.letters) + 0.25 * (abs(found.coefficient) != 1) + 0.4 * (found.coefficient < 0)
        cost += _foreign(root, shelf, found)
        yield Slip(
            "missing factor",
            ("{} lost from {}", factor, node),
            root,
            path,
            Neg.of(new) if found.coefficient < 0 else new,
            cost,
        )
    for found in shelf.find(1 / ratio, most=2, least=1):
        if found.coefficient > 0:
            under = shelf.product(found)
            cost = 1.2 + 0.25 * len(found.letters) + 0.1 * (found.coefficient != 1) + _foreign(root, shelf, found)
            yield Slip(
                "missing factor", ("the division by {} lost from {}", under, node), root, path, Div(node, under), cost
            )


def _parts_of_sum(
    root: Expr, path: tuple[int, ...], node: Add, shelf: Shelf, gap: np.ndarray, values: Mapping[Expr, Any]
) -> Iterator[Slip]:
    """Yield sums of which some neighbours have lost the factor before their bracket."""
    count = len(node.args)
    for first in range(min(count, MOST_TERMS)):
        for last in range(first + 2, min(count, MOST_TERMS) + 1):
            if last - first == count:
                continue
            inside = node.args[first:last]
            part = sum(np.asarray(values[a], dtype=float) for a in inside)
            if np.count_nonzero(np.abs(gap + part - part**2) < SEARCH_SAME * part**2) >= ENOUGH:
                new = Add.of(*node.args[:first], Power(Add(*inside), number(2)), *node.args[last:])
                yield Slip("power", ("a lost square of {}", Add(*inside)), root, path, new, 1.3)
            for found in shelf.find((gap + part) / part, most=1, least=1):
                if found.coefficient == 1:
                    bracket = shelf.product(found, Add(*inside))
                    new = Add.of(*node.args[:first], bracket, *node.args[last:])
                    words = ("{} lost before {}", shelf.product(found), Add(*inside))
                    yield Slip("missing factor", words, root, path, new, 1.3)


def _parts_of_product(
    root: Expr, path: tuple[int, ...], node: Mul, shelf: Shelf, need: np.ndarray, values: Mapping[Expr, Any]
) -> Iterator[Slip]:
    """Yield products of which the last factors were a bracket that has lost a term."""
    for first in range(1, min(len(node.args), MOST_TERMS) - 1):
        before = np.prod(np.broadcast_arrays(*(np.asarray(values[a], dtype=float) for a in node.args[:first])), axis=0)
        after = np.prod(np.broadcast_arrays(*(np.asarray(values[a], dtype=float) for a in node.args[first:])), axis=0)
        for found in shelf.find(need / before - after, least=1):
            term = shelf.product(found)
            bracket = Add.of(Mul(*node.args[first:]), Neg.of(term) if found.coefficient < 0 else term)
            cost = 1.22 + 0.15 * len(found.letters) + 0.2 * (abs(found.coefficient) != 1)
            words = ("{} lost after {}", term, Mul(*node.args[first:]))
            yield Slip("missing term", words, root, path, Mul(*node.args[:first], bracket), cost)


def _letters(
    root: Expr, path: tuple[int, ...], node: Expr, shelf: Shelf, need: np.ndarray, *, squared: bool
) -> Iterator[Slip]:
    if not isinstance(node, Sym) and not is_call(node, "sin", "cos"):
        return
    for found in shelf.find(need, most=1, least=1, unsigned=squared):
        if found.coefficient == 1:
            new = shelf.product(found)
            yield Slip("swapped factor", ("{} for {}", node, new), root, path, new, 1.0)


def letters_of(
    root: Expr, pool: Mapping[str, Expr], env: Mapping[str, np.ndarray], own: frozenset[str], more: set[str]
) -> dict[str, Expr]:
    """What may stand in a lost product: the letters of the formula first, what it is made of, then other letters.

    Args:
        root: The formula.
        pool: Sines, cosines, lengths and symbols of one's own that may have been lost.
        env: Values of all symbols; entries of the pose count when the formula has some.
        own: Names of angles that may not be used, because the formula is for them.
        more: Names of other symbols that may have been lost.
    """
    used = root.symbols()
    out: dict[str, Expr] = {str(e): e for e in pool.values() if not (e.symbols() and e.symbols() <= own)}
    kinds = [letters for letters in ENTRIES if any(_entry(name, letters) for name in used)]
    if own or isinstance(root, Equation):
        # who uses some letters of the pose has the others too: one that was lost need not stand elsewhere
        if own and not kinds:
            kinds = ["r", "p"]
        if kinds and not {"noa", "r"} & set(kinds):
            kinds.append("noa")
        if kinds and not {"p", "P"} & set(kinds):
            kinds.append("p")
    for name in env:
        if any(_entry(name, letters) for letters in kinds) or name in more or (name in used and not ANGLE.match(name)):
            out.setdefault(name, Mention(name))
    inside, more_sums = 0, dict[str, Expr]()
    for node in root.walk():
        small = isinstance(node, Add | Call) and 2 < node.size() <= 24 and not isinstance(node, PlusMinus | PiFraction)
        if small and inside < 12 and str(node) not in out and not isinstance(node, Equation) and node is not root:
            out[str(node)] = node
            inside += 1
            if isinstance(node, Add):
                likenesses = (_turned_to(node, x) for x in ("xy", "xz", "yz"))
                more_sums.update({str(sum_): sum_ for sum_ in likenesses if sum_ is not None})
    return out | {text: sum_ for text, sum_ in more_sums.items() if text not in out}


def _turned_to(node: Expr, pair: str) -> Expr | None:
    """A sum with two coordinates exchanged in the letters of the pose: px - d6 ax becomes py - d6 ay."""
    new = dict(zip(pair, pair[::-1], strict=True))
    names = {n: n[0] + new[n[1]] for n in node.symbols() if len(n) == 2 and n[0] in "noapP" and n[1] in new}
    return node.substitute({old: Mention(name) for old, name in names.items()}) if names else None


def _any_entry(name: str) -> bool:
    return any(_entry(name, letters) for letters in ENTRIES)


def _entry(name: str, letters: str) -> bool:
    if letters == "r":
        return len(name) == 3 and name[0] == "r" and name[1:].isdigit() and name[2] != "4"
    return len(name) == 2 and name[0] in letters and name[1] in "xyz"
