"""Does a claim hold for every arm of its build, or only because two lengths of this one happen to be equal?

A Puma's a2 and d4 are both 0.4318 m: a page that exchanges them agrees with every number. So lengths are varied, and
what holds only for the arm's own is varied again with some lengths tied together, until the tie is found.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Collection, Iterator
from dataclasses import dataclass

import numpy as np

from pieper.algebra.expression import Expr, Num
from pieper.algebra.formula import Mention, replaced_everywhere
from pieper.judge.evidence import Evidence
from pieper.judge.model import ArmModel
from pieper.tolerances import EQUAL_LENGTHS

RATIOS = ((1.0, ""), (-1.0, "-"), (2.0, "2 "), (-2.0, "-2 "), (0.5, "1/2 "), (-0.5, "-1/2 "))
MOST_READINGS = 64  # of numbers as lengths
TRIED = 48  # joint vectors, half of them with other lengths
ZERO = "0"  # what a length is tied to that is zero here

Judged = Callable[[Evidence, Expr], np.ndarray]
Tie = tuple[str, str, str]


@dataclass(frozen=True)
class Standing:
    """How a formula that is right for the arm's own lengths stands with others.

    Attributes:
        partly: whether it names lengths that it should not, so that it is right by chance.
        words: "only because a2 = d4", or "".
    """

    partly: bool
    words: str


def standing(ev: Evidence, node: Expr, judged: Judged) -> Standing:
    """Say how a formula stands that is right for the arm's own lengths and not for all others; see `coincidence`."""
    root = node.substitute(ev.definitions)
    used = root.symbols() & set(ev.model.values)
    numbers = decimals(root)
    if numbers and only_for_used(ev, node, judged):
        return Standing(False, "")
    readings = list(as_lengths(node, ev)) if numbers else [root]
    if numbers and any(judged(ev, reading).all() for reading in readings):
        return Standing(False, "")
    if numbers and not used & ev.varied_zeros:
        # numbers are about this arm, whose zeros they leave out
        build = ev.drawn(TRIED, 7, {name: name for name, value in ev.model.values.items() if value})
        if any(judged(build, reading).all() for reading in readings):
            return Standing(False, "")
    for reading in readings:
        because = coincidence(ev, reading, judged)
        if because:
            named = reading.symbols() & set(ev.model.values) or (ev.model.zeros and not numbers)
            return Standing(bool(named), f"only because {because}")
    if used and not numbers:
        return Standing(True, "only, and not for others of its build")
    return Standing(False, "")


def coincidence(ev: Evidence, node: Expr, judged: Judged) -> str:
    """Return the equality of lengths on which a formula rests, such as "a2 = d4"; "" when none explains it.

    Args:
        ev: the arm.
        node: a formula that is right for the arm's own lengths and not for others.
        judged: evidence and a formula -> where it is right, (K,) bool.
    """
    ties = list(_ties(ev.model, ev.varied_zeros))

    def right(kept: list[Tie]) -> bool:
        return bool(judged(ev.drawn(TRIED, 5, _groups(ev.model, kept)), node).all())

    if not ties or not right(ties):
        return ""
    for tie in list(ties):
        rest = [t for t in ties if t != tie]
        if right(rest):
            ties = rest
    return " and ".join(f"{a} = {ratio}{b}" for a, ratio, b in ties)


def only_for_used(ev: Evidence, node: Expr, judged: Judged) -> bool:
    """Whether a formula that holds numbers is right however the lengths that it names are varied."""
    used = {name: name for name in node.substitute(ev.definitions).symbols() & set(ev.model.values)}
    return bool(used) and bool(judged(ev.drawn(TRIED, 6, used), node).all())


def as_lengths(node: Expr, ev: Evidence) -> Iterator[Expr]:
    """Yield the formula with its decimal numbers read as the lengths whose values they have, in every way."""
    root = node.substitute(ev.definitions)
    options: dict[int, list[Expr]] = {}
    for leaf in decimals(root):
        options[id(leaf)] = [
            Mention(name) for name, value in ev.model.values.items() if value and _same(value, float(leaf.value))
        ]
    known = {key: found for key, found in options.items() if found}
    for choice in itertools.islice(itertools.product(*known.values()), MOST_READINGS):
        yield replaced_everywhere(root, dict(zip(known, choice, strict=True)))


def decimals(root: Expr) -> list[Num]:
    """The numbers of a formula that are printed with a decimal point, exponents left out."""
    found: dict[int, Num] = {}
    stack = [root]
    while stack:
        node = stack.pop()
        if isinstance(node, Num) and not node.args and ("." in node.written or "e" in node.written.lower()):
            found[id(node)] = node
        stack.extend(node.args[:1] if node.op == "power" else node.args)
    return list(found.values())


def _same(x: float, y: float) -> bool:
    return abs(x - y) <= EQUAL_LENGTHS * max(abs(x), abs(y))


def _ties(model: ArmModel, zeros: Collection[str]) -> Iterator[Tie]:
    """Yield (a, ratio in words, b) for the lengths in a simple ratio, and (a, "", "0") for those that are zero here."""
    yield from ((name, "", ZERO) for name in model.values if name in zeros)
    lengths = {name: value for name, value in model.values.items() if value}
    for (a, x), (b, y) in itertools.combinations(lengths.items(), 2):
        for ratio, words in RATIOS:
            if _same(x, ratio * y):
                yield a, words, b


def _groups(model: ArmModel, ties: list[Tie]) -> dict[str, str]:
    """Name -> group for every length, tied ones in one group; those that are to be zero are left out."""
    none = {a for a, _, b in ties if b == ZERO}
    group = {name: name for name in model.values if name not in none}
    for a, _, b in ties:
        if b == ZERO:
            continue
        old, new = group[b], group[a]
        group = {name: new if g == old else g for name, g in group.items()}
    return group
