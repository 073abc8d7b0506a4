"""Slips of whole angles and of units: half turns, branches, degrees for radians, millimetres for metres."""

from __future__ import annotations

from collections.abc import Iterator

from pieper.algebra.expression import Add, Call, Div, Expr, Mul, Num, PiFraction
from pieper.algebra.formula import Equation, Mention, Neg, PlusMinus, has_branch, is_call, number, positions
from pieper.judge.slips.slip import Slip


def angle_slips(root: Expr, joints: int) -> Iterator[Slip]:
    """Yield the slips that only formulas for a joint angle can have."""
    half = PiFraction(1)
    quarter = Div(half, number(2))

    def whole(kind: str, words: str, new: Expr, cost: float) -> Slip:
        return Slip(kind, (words,), root, (), new, cost)

    yield whole("half turn", "half a turn", Add.of(root, half), 0.9)
    yield whole("half turn", "the supplement of the angle", Add.of(half, Neg.of(root)), 1.0)
    yield whole("half turn", "a quarter of a turn", Add.of(root, quarter), 1.4)
    yield whole("half turn", "a quarter of a turn", Add.of(root, Neg.of(quarter)), 1.4)
    yield whole("branch", "the second branch (+-) left out", PlusMinus(root), 1.0)
    if is_call(root, "acos"):
        words = "the angle inside the triangle for the joint's, its supplement, and one branch of it"
        yield whole("half turn", words, PlusMinus(Add.of(half, Neg.of(root))), 1.6)
    second = Add.of(root, quarter, PlusMinus(quarter))
    yield whole("branch", "the second branch (half a turn on) left out", second, 1.1)
    if isinstance(root, Add):
        for k, term in enumerate(root.args):
            if str(term) in ("pi", "-pi"):
                rest = Add.of(*root.args[:k], *root.args[k + 1 :])
                yield whole("half turn", "half a turn too many", rest, 0.4)
    if isinstance(root, Add) and any(isinstance(t, PlusMinus) and str(t.args[0]) == "pi" for t in root.args):
        rest = Add.of(*(t for t in root.args if not isinstance(t, PlusMinus)))
        both = Add.of(rest, quarter, PlusMinus(quarter))
        yield whole("branch", "+-pi for {{0, pi}}: the principal value is lost", both, 0.5)
    for path, node, _ in positions(root):
        if is_call(node, "asin") and not has_branch(root):
            either = Add.of(quarter, PlusMinus(Add.of(node, Neg.of(quarter))))
            yield Slip("branch", ("the second branch, pi - {}, left out", node), root, path, either, 1.0)
        y, x = _sine_and_cosine(node)
        if y is None or x is None:
            continue
        for joint in range(1, joints + 1):
            for name in ("sin", "cos"):
                k = Call("sign", Call(name, Mention(f"theta{joint}")))
                for negative in (False, True):
                    parts = (Neg.of(Mul.of(k, y)), Neg.of(Mul.of(k, x))) if negative else (Mul.of(k, y), Mul.of(k, x))
                    words = (
                        "the sign of the branch: both arguments of atan2 go with " + ("-" if negative else "") + "{}"
                    )
                    cost = 0.7 + 0.05 * (name == "cos")
                    yield Slip("branch", (words, k), root, path, Call("atan2", *parts), cost)


def _sine_and_cosine(node: Expr) -> tuple[Expr, ...] | tuple[None, None]:
    """Return y and x of atan2(y, x) or atan(y/x)."""
    if is_call(node, "atan2"):
        return node.args
    return node.args[0].args if is_call(node, "atan") and isinstance(node.args[0], Div) else (None, None)


def unit_slips(root: Expr) -> Iterator[Slip]:
    """Yield the slips of units, of the whole formula and of its numbers."""
    if isinstance(root, Equation):
        return
    degree, thousand = Div(PiFraction(1), number(180)), number(1000)
    for kind, words, new in (
        ("degrees", "degrees for radians", Mul.of(root, degree)),
        ("degrees", "radians for degrees", Div(root, degree)),
        ("millimetres", "millimetres for metres", Div(root, thousand)),
        ("millimetres", "metres for millimetres", Mul.of(root, thousand)),
    ):
        yield Slip(kind, (words,), root, (), new, 1.1)
    for path, node, _ in positions(root):
        if isinstance(node, Num) and len(str(node)) > 1:
            for kind, words, new in (
                ("degrees", "{} in degrees for radians", Mul.of(node, degree)),
                ("millimetres", "{} in millimetres for metres", Div(node, thousand)),
                ("millimetres", "{} in metres for millimetres", Mul.of(node, thousand)),
            ):
                yield Slip(kind, (words, node), root, path, new, 2.0)
