"""Slips of whole angles and of units: half turns, branches, degrees for radians, millimetres for metres."""

from __future__ import annotations

from collections.abc import Iterator

from pieper.algebra.tree import Node, add, call, mul, negated, num, positions, sym
from pieper.judge.slips.slip import Slip


def angle_slips(root: Node, joints: int) -> Iterator[Slip]:
    """Yield the slips that only formulas for a joint angle can have."""
    half = sym("pi")
    quarter = Node("div", (half, num(2)))

    def whole(kind: str, words: str, new: Node, cost: float) -> Slip:
        return Slip(kind, (words,), root, (), new, cost)

    yield whole("half turn", "half a turn", add(root, half), 0.9)
    yield whole("half turn", "the supplement of the angle", add(half, negated(root)), 1.0)
    yield whole("half turn", "a quarter of a turn", add(root, quarter), 1.4)
    yield whole("half turn", "a quarter of a turn", add(root, negated(quarter)), 1.4)
    yield whole("branch", "the second branch (+-) left out", Node("pm", (root,), 1), 1.0)
    second = add(root, quarter, Node("pm", (quarter,), 1))
    yield whole("branch", "the second branch (half a turn on) left out", second, 1.1)
    if root.op == "add" and any(t.op == "pm" and str(t.args[0]) == "pi" for t in root.args):
        rest = add(*[t for t in root.args if t.op != "pm"])
        both = add(rest, quarter, Node("pm", (quarter,), 1))
        yield whole("branch", "+-pi for {{0, pi}}: the principal value is lost", both, 0.5)
    for path, node, _ in positions(root):
        y, x = _sine_and_cosine(node)
        if y is None:
            continue
        for joint in range(1, joints + 1):
            for name in ("sin", "cos"):
                k = call("sign", call(name, sym(f"theta{joint}")))
                for negative in (False, True):
                    parts = (negated(mul(k, y)), negated(mul(k, x))) if negative else (mul(k, y), mul(k, x))
                    words = (
                        "the sign of the branch: both arguments of atan2 go with " + ("-" if negative else "") + "{}"
                    )
                    cost = 0.7 + 0.05 * (name == "cos")
                    yield Slip("branch", (words, k), root, path, call("atan2", *parts), cost)


def _sine_and_cosine(node: Node) -> tuple[Node, Node] | tuple[None, None]:
    """Return y and x of atan2(y, x) or atan(y/x)."""
    if node.op == "call" and node.value == "atan2":
        return node.args
    if node.op == "call" and node.value == "atan" and node.args[0].op == "div":
        return node.args[0].args
    return None, None


def unit_slips(root: Node) -> Iterator[Slip]:
    """Yield the slips of units, of the whole formula and of its numbers."""
    if root.op == "eq":
        return
    degree, thousand = Node("div", (sym("pi"), num(180))), num(1000)
    for kind, words, new in (
        ("degrees", "degrees for radians", mul(root, degree)),
        ("degrees", "radians for degrees", Node("div", (root, degree))),
        ("millimetres", "millimetres for metres", Node("div", (root, thousand))),
        ("millimetres", "metres for millimetres", mul(root, thousand)),
    ):
        yield Slip(kind, (words,), root, (), new, 1.1)
    for path, node, _ in positions(root):
        if node.op == "num" and len(node.value) > 1:
            for kind, words, new in (
                ("degrees", "{} in degrees for radians", mul(node, degree)),
                ("millimetres", "{} in millimetres for metres", Node("div", (node, thousand))),
                ("millimetres", "{} in metres for millimetres", mul(node, thousand)),
            ):
                yield Slip(kind, (words, node), root, path, new, 2.0)
