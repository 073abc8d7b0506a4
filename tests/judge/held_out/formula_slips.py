"""Slips in formulas as they happen on paper: every way to make one of them in a tree."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

from tests.judge.held_out.arms import HeldOutArm
from tests.judge.held_out.tree import Tree, places, put

_POSE = [c + r for c in "noap" for r in "xyz"]
_TRANSPOSED = {c + r: "noa"["xyz".index(r)] + "xyz"["noa".index(c)] for c in "noa" for r in "xyz"}
_NINETY: Tree = ("/", ("v", "pi"), ("n", "2"))


def slips(arm: HeldOutArm, kind: str, tree: Tree) -> Iterator[tuple[str, Tree]]:
    """Every single slip: its name and the tree it makes. What it makes may be right by chance."""
    for path, node in places(tree):
        yield from ((name, put(tree, path, new)) for name, new in _at(arm, node))
    yield from _everywhere(arm, tree)
    if kind == "joint":
        yield "half turn", ("+", (tree, ("v", "pi")))


def _at(arm: HeldOutArm, x: Tree) -> Iterator[tuple[str, Tree]]:
    kind = x[0]
    if kind == "+":
        for k, part in enumerate(x[1]):
            rest = x[1][:k] + x[1][k + 1 :]
            yield "lost term", rest[0] if len(rest) == 1 else ("+", rest)
            if part[0] != "pm":
                turned = part[1] if part[0] == "-" else ("-", part)
                yield "sign", ("+", (*x[1][:k], turned, *x[1][k + 1 :]))
    if kind == "*" and len(x[1]) > 1:
        for k in range(len(x[1])):
            rest = x[1][:k] + x[1][k + 1 :]
            yield "lost factor", rest[0] if len(rest) == 1 else ("*", rest)
    if kind == "pm":
        yield "lost plus-minus", x[1]
    if kind == "^":
        yield "lost square", x[1]
    if kind == "f" and x[1] == "atan2":
        yield "arguments exchanged", ("f", "atan2", x[2][::-1])
    if kind == "f" and x[1] in ("acos", "atan2"):
        yield "degrees", ("*", (("/", ("n", "180"), ("v", "pi")), x))
    if x == _NINETY:
        yield "degrees", ("n", "90")
    if kind == "v":
        yield from _names(arm, str(x[1]))


def _names(arm: HeldOutArm, name: str) -> Iterator[tuple[str, Tree]]:
    turning = [str(k + 1) for k, s in enumerate(arm.slides) if not s]
    if name[0] in "cs" and name[1:].isdigit():
        other = "s" if name[0] == "c" else "c"
        yield "sine for cosine", ("v", other + name[1:])
        for k, digit in enumerate(name[1:], 1):
            if len(name) > 2:
                yield "index", ("v", name[:k] + name[k + 1 :])
            else:
                yield from (("index", ("v", name[0] + d)) for d in turning if d != digit)
    elif name.startswith("theta"):
        yield from (("index", ("v", "theta" + d)) for d in turning if d != name[5:])
    elif name in _POSE:
        same = [p for p in _POSE if p != name and (p[0] == name[0] or (p[1] == name[1] and "p" not in p[0] + name[0]))]
        yield from (("symbol", ("v", p)) for p in same)
    elif name in arm.values:
        yield from (("symbol", ("v", p)) for p in arm.values if p != name)
        yield "factor 1000", ("*", (("n", "1000"), ("v", name)))


def _everywhere(arm: HeldOutArm, tree: Tree) -> Iterator[tuple[str, Tree]]:
    used = {str(n[1]) for _, n in places(tree) if n[0] == "v"}
    for a, b in combinations(sorted(used & set(arm.values)), 2):
        yield "exchanged lengths", renamed(tree, {a: b, b: a})
    if any(u in _TRANSPOSED and _TRANSPOSED[u] != u for u in used):
        yield "transposed", renamed(tree, _TRANSPOSED)


def renamed(x: Tree, names: dict[str, str]) -> Tree:
    """The tree with its letters renamed."""
    for path, node in list(places(x)):
        if node[0] == "v" and node[1] in names:
            x = put(x, path, ("v", names[node[1]]))
    return x
