"""Every formula one slip away from a given one: the errors people make when they copy, type or derive.

Each slip is a small change of the tree. The change named is the one that was (probably) made; the tree yielded is the
formula
with that change *undone*, so the first tree that is right is the nearest right reading.
"""

from __future__ import annotations

from collections.abc import Iterator

from pieper.algebra.tree import (
    ANGLE,
    Node,
    add,
    angle_sum,
    call,
    joint_sum,
    mul,
    negated,
    num,
    positions,
    replaced_everywhere,
    sym,
)
from pieper.judge.slips.angle_slips import angle_slips, unit_slips
from pieper.judge.slips.slip import Slip


def slips(
    root: Node, lengths: dict[str, float], joints: int, others: tuple[str, ...] = (), *, angle: bool = False
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
    pool = _factor_pool(root, lengths, joints) | {name: sym(name) for name in others[:8]}
    numbers = _numbers(root, lengths)
    if angle:
        yield from angle_slips(root, joints)
    shared = _shared(root)
    done: set[Node] = set()
    inside: set[Node] = set()  # what stands inside a sine or cosine of joints is varied with it, as an index
    for path, node, parent in positions(root):
        if node in inside:
            continue
        if node.op == "call" and node.value in ("sin", "cos") and joint_sum(node.args[0]):
            inside.update(node.args[0].walk())
        if node in shared:
            if node in done:
                continue
            done.add(node)

        def slip(kind, says, new, cost=1.0, path=path, node=node):
            words = (says,) if isinstance(says, str) else says
            if root.op == "eq" and path[:1] == (0,):
                cost += 0.05  # the left side of an equation is what it is about, seldom what is wrong
            if node in shared:
                return Slip(kind, words, root, None, new, cost, node)
            return Slip(kind, words, root, path, new, cost)

        if _is_term(node, parent):
            yield slip("sign", ("the sign of {}", node), negated(node), 0.5)
        if node.op in ("pm",):
            yield slip("sign", ("the sign of {}", node.args[0]), Node("pm", node.args, -node.value), 0.6)
        if node.op == "call":
            yield from _call_slips(node, slip, joints)
        if node.op == "sym":
            yield from _symbol_slips(node, slip, lengths, others, joints)
        if node.op == "num":
            for value in numbers:
                if value != node.value:
                    yield slip("number", ("{} for " + value, node), num(value), 2.0)
        if node.op == "mul":
            yield from _product_slips(node, slip)
        if node.op == "add":
            yield from _sum_slips(node, slip)
        if node.op == "div":
            yield slip("fraction", ("{} upside down", node), Node("div", (node.args[1], node.args[0])), 1.5)
        if node.op == "pow":
            yield slip("power", ("the power of {}", node.args[0]), node.args[0], 1.2)
        elif node.op in ("sym", "call") and (parent is None or parent.op != "pow"):
            yield slip("power", ("a lost square of {}", node), Node("pow", (node, num(2))), 1.6)
        if node.op in ("sym", "call") and (str(node) in pool):
            for text, factor in pool.items():
                if text != str(node):
                    yield slip("swapped factor", ("{} for {}", node, factor), factor, 1.5)
        if _is_term(node, parent) or (parent is not None and parent.op in ("neg", "div") and node.op != "add"):
            for factor in pool.values():
                yield slip("missing factor", ("{} lost from {}", factor, node), mul(node, factor), 1.3)
            yield slip("missing factor", ("a factor 2 lost from {}", node), mul(num(2), node), 1.3)
            yield slip("extra factor", ("a factor 2 too many in {}", node), Node("div", (node, num(2))), 1.8)
    yield from _throughout(root, joints)
    yield from unit_slips(root)


def _throughout(root: Node, joints: int) -> Iterator[Slip]:
    """Yield formulas in which one angle is another one everywhere: s2 and c2 for s12 and c12, say."""
    angles = {}
    for node in root.walk():
        if node.op == "call" and node.value in ("sin", "cos"):
            parts = joint_sum(node.args[0])
            if parts:
                angles.setdefault(parts, []).append(node)
    for parts, nodes in angles.items():
        if len(nodes) < 2:
            continue
        for new in _index_variants(parts, joints):
            tree = replaced_everywhere(root, {node: call(node.value, angle_sum(new)) for node in nodes})
            words = ("{} for {} throughout", angle_sum(parts), angle_sum(new))
            yield Slip("index", words, root, (), tree, 1.0)


def _shared(root: Node) -> set[Node]:
    """Return the nodes that occur more than once: a symbol defined once and used twice carries its slip to both
    places."""
    seen: set[Node] = set()
    twice: set[Node] = set()
    for node in root.walk():
        (twice if node in seen else seen).add(node)
    return twice


def _is_term(node: Node, parent: Node | None) -> bool:
    if node.op == "eq" or (parent is not None and parent.op == "pm"):
        return False
    if node.op == "num" and float(node.value if "/" not in node.value else 1) == 0:
        return False
    return parent is None or parent.op in ("add", "eq", "call")


def _factor_pool(root: Node, lengths: dict[str, float], joints: int) -> dict[str, Node]:
    """Return what may have been lost or swapped: sines and cosines of every joint and of the sums that occur, and the
    lengths."""
    used = {int(ANGLE.match(s).group(1)) for s in root.symbols() if ANGLE.match(s)}
    sums = {((1, j),) for j in (used or range(1, joints + 1))}
    for node in root.walk():
        if node.op == "call" and node.value in ("sin", "cos"):
            parts = joint_sum(node.args[0])
            if parts:
                sums.add(parts)
    factors = [call(f, angle_sum(p)) for p in sorted(sums) for f in ("cos", "sin")]
    # angles that are shifted by a constant are written out, and lost or swapped like the others
    factors += [n for n in root.walk() if n.op == "call" and n.value in ("sin", "cos") and not joint_sum(n.args[0])]
    factors += [sym(name) for name, value in lengths.items() if value or name in root.symbols()]
    return {str(f): f for f in factors}


def _numbers(root: Node, lengths: dict[str, float]) -> list[str]:
    found = {n.value for n in root.walk() if n.op == "num"}
    if not found:
        return []
    return sorted(found | {f"{abs(v):g}" for v in lengths.values() if v} | {"1", "2"})


def _call_slips(node: Node, slip, joints: int) -> Iterator[Slip]:
    name, args = node.value, node.args
    if name in ("sin", "cos"):
        other = "cos" if name == "sin" else "sin"
        made = call(other, *args)
        yield slip("sine for cosine", ("{} for {}", node, made), made, 0.7)
        parts = joint_sum(args[0])
        if parts:
            for new in _index_variants(parts, joints):
                made = call(name, angle_sum(new))
                yield slip("index", ("{} for {}", node, made), made, 0.8 if len(new) == len(parts) else 0.9)
    if name in ("asin", "acos"):
        other = "acos" if name == "asin" else "asin"
        yield slip("inverse function", f"{name} for {other}", call(other, *args), 1.0)
    if name == "atan" and args[0].op == "div":
        y, x = args[0].args
        yield slip("atan", "atan for atan2", call("atan2", y, x), 0.4)
        yield slip("atan", "atan for atan2, and both signs", call("atan2", negated(y), negated(x)), 0.9)
    if name == "atan2":
        y, x = args
        yield slip("atan", "the arguments of atan2 exchanged", call("atan2", x, y), 0.7)
        yield slip("branch", "both signs inside atan2", call("atan2", negated(y), negated(x)), 0.6)
        yield slip("atan", "atan2 for atan", call("atan", Node("div", (y, x))), 1.5)
    if name in ("sqrt",):
        yield slip("power", "a root too many", args[0], 1.5)


def _index_variants(parts, joints: int) -> Iterator[tuple]:
    """Yield the sums of joints that differ in one index, added ones in rising order as they are written."""
    seen = {parts}
    for new in _variants(parts, joints):
        new = tuple(sorted(new, key=lambda p: p[1])) if all(s > 0 for s, _ in new) else new
        if new not in seen:
            seen.add(new)
            yield new


def _variants(parts, joints: int) -> Iterator[tuple]:
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


def _symbol_slips(node: Node, slip, lengths, others, joints: int) -> Iterator[Slip]:
    name = node.value
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
    elif name in others:
        family = [m for m in others if m != name and m[0] == name[0]] + [m for m, v in lengths.items() if v]
    for other in family:
        yield slip("index", f"{name} for {other}", sym(other), 0.8 if other[0] == name[0] else 1.0)


def _product_slips(node: Node, slip) -> Iterator[Slip]:
    for k, factor in enumerate(node.args):
        rest = node.args[:k] + node.args[k + 1 :]
        kind = {"1000": "millimetres", "180/pi": "degrees", "pi/180": "degrees"}.get(str(factor), "extra factor")
        yield slip(kind, ("{} too many in {}", factor, node), mul(*rest), 1.2 if kind == "extra factor" else 1.0)
        if k:
            for sign, word in ((1, "+"), (-1, "-")):
                right = mul(*node.args[k:]) if sign > 0 else negated(mul(*node.args[k:]))
                yield slip(
                    "product",
                    ("a lost " + word + " between {} and {}", mul(*node.args[:k]), mul(*node.args[k:])),
                    add(mul(*node.args[:k]), right),
                    1.6,
                )


def _sum_slips(node: Node, slip) -> Iterator[Slip]:
    if len(node.args) <= 8:
        for first in range(len(node.args)):
            for last in range(first + 1, len(node.args)):
                inside = add(*node.args[first : last + 1])
                root = Node("pm", (call("sqrt", inside),), 1)
                words = ("a lost root over {}", inside)
                yield slip("power", words, add(*node.args[:first], root, *node.args[last + 1 :]), 1.7)
    for k, term in enumerate(node.args):
        rest = node.args[:k] + node.args[k + 1 :]
        yield slip("extra term", ("{} too many", term), add(*rest), 1.4)
        if k and node.args[k - 1].op != "pm" and term.op != "pm":
            left, right = node.args[k - 1], term.args[0] if term.op == "neg" else term
            merged = negated(mul(left.args[0], right)) if left.op == "neg" else mul(left, right)
            yield slip(
                "product",
                ("a sign between {} and {} where they are multiplied", left, right),
                add(*node.args[: k - 1], merged, *node.args[k + 1 :]),
                1.1,
            )
