"""Every formula one slip away from a given one: the errors people make when they copy, type or derive.

Each slip is a small change of the tree. The change named is the one that was (probably) made; the tree yielded is the
formula with that change *undone*, so the first tree that is right is the nearest right reading.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

from pieper.algebra.expression import Add, Call, Div, Expr, Mul, Num, PiFraction, Power, Sym
from pieper.algebra.formula import (
    ANGLE,
    Equation,
    Mention,
    Neg,
    PlusMinus,
    angle_sum,
    is_call,
    number,
    positions,
    replaced_everywhere,
)
from pieper.algebra.notation import TURNS, turned_joints
from pieper.judge.slips.angle_slips import angle_slips, unit_slips
from pieper.judge.slips.slip import Slip

_ENTRY = re.compile(r"\[(\d),(\d)\]$")
FACTORS = (Sym, Call)  # what people lose or swap as one letter


def slips(
    root: Expr, lengths: dict[str, float], joints: int, others: tuple[str, ...] = (), *, angle: bool = False
) -> Iterator[Slip]:
    """Yield the formulas that are one slip away, likelier slips first within each position.

    Args:
        root: the formula as printed.
        lengths: length symbols of the arm and their values.
        joints: number of joints.
        others: symbols the claims file defines.
        angle: the formula is one for a joint angle.

    Yields:
        Slips with their formulas.
    """
    pool = factor_pool(root, lengths, joints) | {name: Mention(name) for name in others[:8]}
    numbers = _numbers(root, lengths)
    if angle:
        yield from angle_slips(root, joints)
    shared = _shared(root)
    done: set[int] = set()
    inside: set[int] = set()  # what stands inside a sine or cosine of joints is varied with it, as an index
    for path, node, parent in positions(root):
        if id(node) in inside:
            continue
        if turned_joints(node):
            inside.update(map(id, node.args[0].walk()))
        if id(node) in shared:
            if id(node) in done:
                continue
            done.add(id(node))

        def slip(kind: str, says: Any, new: Any, cost: float = 1.0, path: Any = path, node: Any = node) -> Slip:
            words = (says,) if isinstance(says, str) else says
            if isinstance(root, Equation) and path[:1] == (0,):
                cost += 0.05  # the left side of an equation is what it is about, seldom what is wrong
            if id(node) in shared:
                return Slip(kind, words, root, None, new, cost, node)
            return Slip(kind, words, root, path, new, cost)

        if _is_term(node, parent):
            # a whole side that is negative is seldom meant; of two sides, the one that is shorter without its sign
            side = isinstance(parent, Equation) and isinstance(node, Neg)
            yield slip("sign", ("the sign of {}", node), Neg.of(node), 0.42 if side else 0.5)
        if isinstance(node, PlusMinus):
            yield slip("sign", ("the sign of {}", node.args[0]), PlusMinus(node.args[0], -node.sign), 0.6)
        if isinstance(node, Call):
            yield from _call_slips(node, slip, joints)
        if isinstance(node, Sym):
            yield from _symbol_slips(node, slip, lengths, others, joints)
        if isinstance(node, Num):
            for value in numbers:
                if value != str(node):
                    yield slip("number", ("{} for " + value, node), number(value), 2.0)
        if isinstance(node, Mul):
            yield from _product_slips(node, slip)
        if isinstance(node, Add):
            yield from _sum_slips(node, slip)
        if isinstance(node, Div):
            yield slip("fraction", ("{} upside down", node), Div(node.args[1], node.args[0]), 1.5)
        if isinstance(node, Power):
            yield slip("power", ("the power of {}", node.args[0]), node.args[0], 1.2)
            if isinstance(node.args[1], Num):
                yield slip(
                    "power", ("a factor for the power of {}", node.args[0]), Mul.of(node.args[1], node.args[0]), 1.4
                )
        elif isinstance(node, (*FACTORS, PiFraction)) and not isinstance(parent, Power):
            yield slip("power", ("a lost square of {}", node), Power(node, number(2)), 1.25)
        if isinstance(node, FACTORS) and str(node) in pool:
            for text, factor in pool.items():
                if text != str(node):
                    yield slip("swapped factor", ("{} for {}", node, factor), factor, 1.5)
        factor_place = _is_term(node, parent) or (isinstance(parent, (Neg, Div)) and not isinstance(node, Add))
        if factor_place and not isinstance(node, Neg):
            for factor in pool.values():
                yield slip("missing factor", ("{} lost from {}", factor, node), Mul.of(node, factor), 1.3)
            yield slip("missing factor", ("a factor 2 lost from {}", node), Mul.of(number(2), node), 1.3)
            yield slip("extra factor", ("a factor 2 too many in {}", node), Div(node, number(2)), 1.8)
        if angle and isinstance(node, Call) and node.name in ("sqrt", "acos", "asin") and path:
            yield slip("branch", ("a lost +- before {}", node), PlusMinus(node), 1.0)
    yield from _throughout(root, joints)
    yield from _everywhere(root, lengths)
    yield from unit_slips(root)


def _throughout(root: Expr, joints: int) -> Iterator[Slip]:
    """Yield formulas in which one angle is another one everywhere: s2 and c2 for s12 and c12, say."""
    angles: dict[tuple, list[Call]] = {}
    for node in root.walk():
        parts = turned_joints(node)
        if parts and isinstance(node, Call):
            angles.setdefault(parts, []).append(node)
    for parts, nodes in angles.items():
        if len(nodes) < 2:
            continue
        for new in _index_variants(parts, joints):
            tree = replaced_everywhere(root, {id(n): Call(n.name, angle_sum(new)) for n in nodes})
            words = ("{} for {} throughout", angle_sum(parts), angle_sum(new))
            yield Slip("index", words, root, (), tree, 1.0)


def _everywhere(root: Expr, lengths: dict[str, float]) -> Iterator[Slip]:
    """Yield formulas in which two lengths are exchanged, or the rotation is transposed, at every place."""
    symbols: dict[str, list[Expr]] = {}
    for node in root.walk():
        if isinstance(node, Sym):
            symbols.setdefault(node.name, []).append(node)

    def exchanged(new: dict[str, str], words: str) -> Slip:
        table = {id(n): Mention(new[name]) for name, nodes in symbols.items() if name in new for n in nodes}
        return Slip("index", (words,), root, (), replaced_everywhere(root, table), 1.3)

    used = [name for name in symbols if lengths.get(name)]
    for k, a in enumerate(used):
        for b in used[k + 1 :]:
            yield exchanged({a: b, b: a}, f"{a} and {b} exchanged throughout")
    entries = {
        name: name[0] + name[2] + name[1] for name in symbols if len(name) == 3 and name[0] == "r" and name[2] in "123"
    }
    for name in symbols:
        if len(name) == 2 and name[0] in "noa" and name[1] in "xyz":
            entries[name] = "noa"["xyz".index(name[1])] + "xyz"["noa".index(name[0])]
    if any(a != b for a, b in entries.items()):
        yield exchanged(entries, "the rotation transposed")


def _shared(root: Expr) -> set[int]:
    """Return the `id` of nodes that occur more than once.

    A symbol defined once and used twice carries its slip to both places.
    """
    seen: set[int] = set()
    twice: set[int] = set()
    for node in root.walk():
        (twice if id(node) in seen else seen).add(id(node))
    return twice


def _is_term(node: Expr, parent: Expr | None) -> bool:
    if isinstance(node, Equation) or isinstance(parent, PlusMinus) or (isinstance(node, Num) and not node.value):
        return False
    return parent is None or isinstance(parent, (Add, Equation, Call))


def factor_pool(root: Expr, lengths: dict[str, float], joints: int) -> dict[str, Expr]:
    """What may have been lost or swapped.

    That is sines and cosines of every joint and of the sums that occur, and the lengths.
    """
    used = {int(found.group(1)) for found in map(ANGLE.match, root.symbols()) if found}
    sums: set[tuple[tuple[int, int], ...]] = {((1, j),) for j in (used or range(1, joints + 1))}
    sums.update(parts for parts in map(turned_joints, root.walk()) if parts)
    factors: list[Expr] = [Call(f, angle_sum(p)) for p in sorted(sums) for f in ("cos", "sin")]
    # angles that are shifted by a constant are written out, and lost or swapped like the others
    factors += [n for n in root.walk() if is_call(n, *TURNS) and not turned_joints(n)]
    factors += [Mention(name) for name, value in lengths.items() if value or name in root.symbols()]
    return {str(f): f for f in factors}


def _numbers(root: Expr, lengths: dict[str, float]) -> list[str]:
    found = {str(n) for n in root.walk() if isinstance(n, Num)}
    if not found:
        return []
    return sorted(found | {f"{abs(v):g}" for v in lengths.values() if v} | {"1", "2"})


def _call_slips(node: Call, slip: Any, joints: int) -> Iterator[Slip]:
    name, args = node.name, node.args
    if name in TURNS:
        other = "cos" if name == "sin" else "sin"
        made = Call(other, *args)
        yield slip("sine for cosine", ("{} for {}", node, made), made, 0.7)
        parts = turned_joints(node)
        if parts:
            for new in _index_variants(parts, joints):
                made = Call(name, angle_sum(new))
                yield slip("index", ("{} for {}", node, made), made, _index_cost(parts, new))
    if name in ("asin", "acos"):
        other = "acos" if name == "asin" else "asin"
        yield slip("inverse function", f"{name} for {other}", Call(other, *args), 1.0)
    if name == "atan" and isinstance(args[0], Div):
        y, x = args[0].args
        yield slip("atan", "atan for atan2", Call("atan2", y, x), 0.4)
        yield slip("atan", "atan for atan2, and both signs", Call("atan2", Neg.of(y), Neg.of(x)), 0.9)
    if name == "atan2":
        y, x = args
        yield slip("atan", "the arguments of atan2 exchanged", Call("atan2", x, y), 0.7)
        yield slip("branch", "both signs inside atan2", Call("atan2", Neg.of(y), Neg.of(x)), 0.6)
        yield slip("atan", "atan2 for atan", Call("atan", Div(y, x)), 1.5)
    if name in ("sqrt",):
        yield slip("power", "a root too many", args[0], 1.2 if isinstance(args[0], Sym) else 1.5)


def _index_cost(parts: Any, new: Any) -> float:
    """How far-fetched an index is; a difference such as c(1-2) for a sum is only where the axes oppose each other."""
    turned = any(s < 0 for s, _ in new) and not any(s < 0 for s, _ in parts)
    return 1.9 if turned else 0.8 if len(new) == len(parts) else 0.9


def _index_variants(parts: Any, joints: int) -> Iterator[tuple]:
    """Yield the sums of joints that differ in one index, added ones in rising order as they are written."""
    seen = {parts}
    for new in _variants(parts, joints):
        new = tuple(sorted(new, key=lambda p: p[1])) if all(s > 0 for s, _ in new) else new
        if new not in seen:
            seen.add(new)
            yield new


def _variants(parts: Any, joints: int) -> Iterator[tuple]:
    used = {j for _, j in parts}
    for k, (s, j) in enumerate(parts):
        for other in range(1, joints + 1):
            if other not in used:
                yield parts[:k] + ((s, other),) + parts[k + 1 :]
        if len(parts) > 1:
            yield parts[:k] + parts[k + 1 :]
            if k:
                yield parts[:k] + ((-s, j),) + parts[k + 1 :]
    for other in range(1, joints + 1):
        if other not in used and (other - 1 in used or other + 1 in used):
            yield tuple(sorted(parts + ((1, other),), key=lambda p: p[1]))
            if len(parts) == 1:
                yield tuple(sorted(parts + ((-1, other),), key=lambda p: -p[0]))


def _symbol_slips(node: Sym, slip: Any, lengths: Any, others: Any, joints: int) -> Iterator[Slip]:
    name = node.name
    angle = ANGLE.match(name)
    family: list[str] = []
    if name in lengths:
        family = [m for m, v in lengths.items() if m != name and (v or m[0] == name[0])]
    elif angle:
        family = [f"theta{j}" for j in range(1, joints + 1) if f"theta{j}" != name]
    elif len(name) == 2 and name[0] in "noap" and name[1] in "xyz":
        family = [name[0] + c for c in "xyz" if c != name[1]] + [c + name[1] for c in "noap" if c != name[0]]
    elif len(name) == 2 and name[0] == "P" and name[1] in "xyz":
        family = ["P" + c for c in "xyz" if c != name[1]]
    elif len(name) == 3 and name[0] == "r" and name[1:].isdigit():
        i, j = name[1], name[2]
        family = [f"r{i}{c}" for c in "1234" if c != j] + [f"r{c}{j}" for c in "123" if c != i]
        family += [f"r{j}{i}"] if i != j and j != "4" else []
    elif entry := _ENTRY.search(name):
        i, j = entry.groups()
        stem = name[: entry.start()]
        family = [f"{stem}[{c},{d}]" for c in "123" for d in "1234" if (c, d) != (i, j) and (c == i or d == j)]
        family += [f"{stem}[{j},{i}]"] if i != j and j != "4" else []
    elif name in others:
        family = [m for m in others if m != name and m[0] == name[0]] + [m for m, v in lengths.items() if v]
    for other in family:
        yield slip("index", f"{name} for {other}", Mention(other), 0.8 if other[0] == name[0] else 1.0)


def _product_slips(node: Expr, slip: Any) -> Iterator[Slip]:
    for k, factor in enumerate(node.args):
        rest = node.args[:k] + node.args[k + 1 :]
        if isinstance(factor, Num) and len(rest) == 1 and factor.value in (2, 3):
            yield slip("power", ("a power of {} for a factor", rest[0]), Power(rest[0], factor), 1.1)
        kind = {"1000": "millimetres", "180/pi": "degrees", "pi/180": "degrees"}.get(str(factor), "extra factor")
        yield slip(kind, ("{} too many in {}", factor, node), Mul.of(*rest), 1.2 if kind == "extra factor" else 1.0)
        if k:
            for sign, word in ((1, "+"), (-1, "-")):
                right = Mul.of(*node.args[k:]) if sign > 0 else Neg.of(Mul.of(*node.args[k:]))
                yield slip(
                    "product",
                    ("a lost " + word + " between {} and {}", Mul.of(*node.args[:k]), Mul.of(*node.args[k:])),
                    Add.of(Mul.of(*node.args[:k]), right),
                    1.6,
                )


def _sum_slips(node: Expr, slip: Any) -> Iterator[Slip]:
    yield slip("power", ("a lost root over {}", node), Call("sqrt", node), 1.3)
    if len(node.args) <= 8:
        for first in range(len(node.args)):
            for last in range(first + 1, len(node.args)):
                inside = Add.of(*node.args[first : last + 1])
                root = PlusMinus(Call("sqrt", inside))
                words = ("a lost root over {}", inside)
                yield slip("power", words, Add.of(*node.args[:first], root, *node.args[last + 1 :]), 1.7)
    for k, term in enumerate(node.args):
        rest = node.args[:k] + node.args[k + 1 :]
        yield slip("extra term", ("{} too many", term), Add.of(*rest), 1.25)
        if k and not isinstance(node.args[k - 1], PlusMinus) and not isinstance(term, PlusMinus):
            left, right = node.args[k - 1], term.args[0] if isinstance(term, Neg) else term
            merged = Neg.of(Mul.of(left.args[0], right)) if isinstance(left, Neg) else Mul.of(left, right)
            yield slip(
                "product",
                ("a sign between {} and {} where they are multiplied", left, right),
                Add.of(*node.args[: k - 1], merged, *node.args[k + 1 :]),
                1.1,
            )
