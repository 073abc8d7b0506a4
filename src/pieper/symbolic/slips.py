"""Every formula one slip away from a given one: the errors people make when they copy, type or derive.

Each slip is a small change of the tree. The change named is the one that was (probably) made; the tree yielded is the formula
with that change *undone*, so the first tree that is right is the nearest right reading.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from pieper.symbolic.tree import (
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
    replaced,
    replaced_everywhere,
    sym,
)


@dataclass(frozen=True)
class Slip:
    """One slip and the formula without it.

    Attributes:
        kind: the family of slips it belongs to, one of `KINDS`.
        says: what was done, in words.
        tree: the formula with the slip undone.
        cost: how far-fetched it is, smaller is likelier; ranks equally good explanations.
    """

    kind: str
    says: str
    tree: Node
    cost: float


KINDS = {
    "sign": "a sign",
    "index": "an index",
    "sine for cosine": "sine for cosine",
    "swapped factor": "a swapped factor",
    "missing factor": "a missing factor",
    "extra factor": "a factor too many",
    "extra term": "a term too many",
    "product": "a product written as a sum, or a sum as a product",
    "power": "a square or a root",
    "atan": "atan for atan2, or its arguments exchanged",
    "branch": "the sign of a branch",
    "half turn": "half a turn",
    "inverse function": "arcsine for arccosine",
    "fraction": "a fraction upside down",
    "number": "a number",
    "degrees": "degrees for radians",
    "millimetres": "millimetres for metres",
}


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
        yield from _angle_slips(root, joints)
    shared = _shared(root)
    done: set[Node] = set()
    for path, node, parent in positions(root):
        if node in shared:
            if node in done:
                continue
            done.add(node)

        def slip(kind, says, new, cost=1.0, path=path, node=node):
            tree = replaced_everywhere(root, node, new) if node in shared else replaced(root, path, new)
            return Slip(kind, says, tree, cost)

        if _is_term(node, parent):
            yield slip("sign", f"the sign of {_short(node)}", negated(node), 0.5)
        if node.op in ("pm",):
            yield slip("sign", f"the sign of {_short(node.args[0])}", Node("pm", node.args, -node.value), 0.6)
        if node.op == "call":
            yield from _call_slips(node, slip, joints)
        if node.op == "sym":
            yield from _symbol_slips(node, slip, lengths, others, joints)
        if node.op == "num":
            for value in numbers:
                if value != node.value:
                    yield slip("number", f"{node.value} for {value}", num(value), 2.0)
        if node.op == "mul":
            yield from _product_slips(node, slip)
        if node.op == "add":
            yield from _sum_slips(node, slip)
        if node.op == "div":
            yield slip("fraction", f"{_short(node)} upside down", Node("div", (node.args[1], node.args[0])), 1.5)
        if node.op == "pow":
            yield slip("power", f"the power of {_short(node.args[0])}", node.args[0], 1.2)
        elif node.op in ("sym", "call") and (parent is None or parent.op != "pow"):
            yield slip("power", f"a lost square of {node}", Node("pow", (node, num(2))), 1.6)
        if node.op in ("sym", "call") and (str(node) in pool):
            for text, factor in pool.items():
                if text != str(node):
                    yield slip("swapped factor", f"{node} for {text}", factor, 1.5)
        if _is_term(node, parent) or (parent is not None and parent.op in ("neg", "div") and node.op != "add"):
            for text, factor in pool.items():
                yield slip("missing factor", f"{text} lost from {_short(node)}", mul(node, factor), 1.3)
            yield slip("missing factor", f"a factor 2 lost from {_short(node)}", mul(num(2), node), 1.3)
            yield slip("extra factor", f"a factor 2 too many in {_short(node)}", Node("div", (node, num(2))), 1.8)
    yield from _unit_slips(root)


def _shared(root: Node) -> set[Node]:
    """Return the nodes that occur more than once: a symbol defined once and used twice carries its slip to both places."""
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


def _short(node: Node) -> str:
    text = str(node)
    return text if len(text) <= 48 else text[:45] + "..."


def _factor_pool(root: Node, lengths: dict[str, float], joints: int) -> dict[str, Node]:
    """Return what may have been lost or swapped: sines and cosines of every joint and of the sums that occur, and the lengths."""
    used = {int(ANGLE.match(s).group(1)) for s in root.symbols() if ANGLE.match(s)}
    sums = {((1, j),) for j in (used or range(1, joints + 1))}
    for node in root.walk():
        if node.op == "call" and node.value in ("sin", "cos"):
            parts = joint_sum(node.args[0])
            if parts:
                sums.add(parts)
    factors = [call(f, angle_sum(p)) for p in sorted(sums) for f in ("cos", "sin")]
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
        yield slip("sine for cosine", f"{node} for {call(other, *args)}", call(other, *args), 0.7)
        parts = joint_sum(args[0])
        if parts:
            for new in _index_variants(parts, joints):
                made = call(name, angle_sum(new))
                yield slip("index", f"{node} for {made}", made, 0.8 if len(new) == len(parts) else 0.9)
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
        yield slip("extra factor", f"{_short(factor)} too many in {_short(node)}", mul(*rest), 1.2)
        if k:
            for sign, word in ((1, "+"), (-1, "-")):
                right = mul(*node.args[k:]) if sign > 0 else negated(mul(*node.args[k:]))
                yield slip(
                    "product",
                    f"a lost {word} between {_short(mul(*node.args[:k]))} and {_short(mul(*node.args[k:]))}",
                    add(mul(*node.args[:k]), right),
                    1.6,
                )


def _sum_slips(node: Node, slip) -> Iterator[Slip]:
    for k, term in enumerate(node.args):
        rest = node.args[:k] + node.args[k + 1 :]
        yield slip("extra term", f"{_short(term)} too many", add(*rest), 1.4)
        if k and node.args[k - 1].op != "pm" and term.op != "pm":
            left, right = node.args[k - 1], term.args[0] if term.op == "neg" else term
            merged = negated(mul(left.args[0], right)) if left.op == "neg" else mul(left, right)
            yield slip(
                "product",
                f"a sign between {_short(left)} and {_short(right)} where they are multiplied",
                add(*node.args[: k - 1], merged, *node.args[k + 1 :]),
                1.1,
            )


def _angle_slips(root: Node, joints: int) -> Iterator[Slip]:
    half = sym("pi")
    yield Slip("half turn", "half a turn", add(root, half), 0.9)
    yield Slip("half turn", "the supplement of the angle", add(half, negated(root)), 1.0)
    quarter = Node("div", (half, num(2)))
    yield Slip("half turn", "a quarter of a turn", add(root, quarter), 1.4)
    yield Slip("half turn", "a quarter of a turn", add(root, negated(quarter)), 1.4)
    yield Slip("branch", "the second branch (+-) left out", Node("pm", (root,), 1), 1.0)
    yield Slip(
        "branch",
        "the second branch (half a turn on) left out",
        add(root, Node("div", (half, num(2))), Node("pm", (Node("div", (half, num(2))),), 1)),
        1.1,
    )
    if root.op == "add" and any(t.op == "pm" and str(t.args[0]) == "pi" for t in root.args):
        rest = add(*[t for t in root.args if t.op != "pm"])
        yield Slip(
            "branch",
            "+-pi for {0, pi}: the principal value is lost",
            add(rest, quarter, Node("pm", (quarter,), 1)),
            0.5,
        )
    for path, node, _ in positions(root):
        if node.op == "call" and node.value in ("atan", "atan2"):
            if node.value == "atan2":
                y, x = node.args
            elif node.args[0].op == "div":
                y, x = node.args[0].args
            else:
                continue
            for joint in range(1, joints + 1):
                for name in ("sin", "cos"):
                    for negative in (False, True):
                        k = call("sign", call(name, sym(f"theta{joint}")))
                        k = negated(k) if negative else k
                        new = call(
                            "atan2",
                            mul(k, y) if not negative else negated(mul(k.args[0], y)),
                            mul(k, x) if not negative else negated(mul(k.args[0], x)),
                        )
                        yield Slip(
                            "branch",
                            f"the sign of the branch: both arguments of atan2 go with {k}",
                            replaced(root, path, new),
                            0.7 + 0.05 * (name == "cos"),
                        )


def _unit_slips(root: Node) -> Iterator[Slip]:
    if root.op == "eq":
        return
    degree, thousand = Node("div", (sym("pi"), num(180))), num(1000)
    yield Slip("degrees", "degrees for radians", mul(root, degree), 2.0)
    yield Slip("degrees", "radians for degrees", Node("div", (root, degree)), 2.0)
    yield Slip("millimetres", "millimetres for metres", Node("div", (root, thousand)), 2.0)
    yield Slip("millimetres", "metres for millimetres", mul(root, thousand), 2.0)
    for path, node, _ in positions(root):
        if node.op == "num" and len(node.value) > 1:
            yield Slip("degrees", f"{node.value} in degrees for radians", replaced(root, path, mul(node, degree)), 2.0)
            yield Slip(
                "millimetres",
                f"{node.value} in millimetres for metres",
                replaced(root, path, Node("div", (node, thousand))),
                2.0,
            )
            yield Slip(
                "millimetres", f"{node.value} in metres for millimetres", replaced(root, path, mul(node, thousand)), 2.0
            )
