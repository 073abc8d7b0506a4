"""Right formulas in forms that nobody expects: half angles, products to sums, functions turned about."""

from __future__ import annotations

import random
from collections.abc import Iterator

from tests.judge.held_out.arms import ARMS, HeldOutArm
from tests.judge.held_out.oracle import facts, shares
from tests.judge.held_out.tree import Tree, places, put, read, write

Form = tuple[HeldOutArm, str, str, Tree, str]


def _of(template: str, **parts: Tree) -> Tree:
    """A template with trees put in for its letters."""
    tree = read(template)
    for path, node in list(places(tree)):
        if node[0] == "v" and node[1] in parts:
            tree = put(tree, path, parts[node[1]])
    return tree


def forms(x: Tree) -> Iterator[tuple[str, Tree]]:
    """The same thing in other words: a name and a tree."""
    kind = x[0]
    if kind == "v" and x[1][0] in "cs" and x[1][1:].isdigit():
        turn, digits = x[1][0], x[1][1:]
        angle = read(" + ".join(f"theta{d}" for d in digits))
        yield "half angle", _of("1 - 2 sin(A/2)^2" if turn == "c" else "2 sin(A/2) cos(A/2)", A=angle)
        tangent = "(1 - T^2)/(1 + T^2)" if turn == "c" else "2 T/(1 + T^2)"
        yield "tangent of half the angle", _of(tangent, T=_of("sin(A/2)/cos(A/2)", A=angle))
        yield "quarter turn", _of("sin(A + pi/2)" if turn == "c" else "cos(A - pi/2)", A=angle)
        if len(digits) > 1:
            a, b = digits[0], digits[1:]
            yield "addition", read(f"c{a} c{b} - s{a} s{b}" if turn == "c" else f"s{a} c{b} + c{a} s{b}")
    if kind == "*" and len(x[1]) >= 2:
        names = [k for k, f in enumerate(x[1]) if f[0] == "v" and f[1][0] in "cs" and f[1][1:].isdigit()]
        if len(names) >= 2:
            i, j = names[:2]
            rest = tuple(f for k, f in enumerate(x[1]) if k not in (i, j))
            yield "product to sum", ("*", (*rest, _product_to_sum(str(x[1][i][1]), str(x[1][j][1]))))
        sums = [k for k, f in enumerate(x[1]) if f[0] == "+"]
        if sums:
            rest = tuple(f for k, f in enumerate(x[1]) if k != sums[0])
            terms = tuple(_by(rest, part) for part in x[1][sums[0]][1])
            yield "multiplied out", ("+", terms)
    if kind == "^" and x[2] == 2:
        if x[1][0] == "+" and len(x[1][1]) == 2 and all(p[0] != "pm" for p in x[1][1]):
            a, b = x[1][1]
            yield "square written out", _of("A^2 + B^2 + 2 A B", A=a, B=b)
        yield "square as a product", ("*", (x[1], x[1]))
    if kind == "f" and x[1] == "atan2":
        y, r = x[2]
        yield "atan with half the angle", _of("2 atan(Y/(sqrt(X^2 + Y^2) + X))", Y=y, X=r)
        yield "sine and a sign", _of("sign(Y) acos(X/sqrt(X^2 + Y^2))", Y=y, X=r)
        yield "quarter turn of atan2", _of("pi/2 - atan2(X, Y)", Y=y, X=r)
        yield "scaled", _of("atan2(3 Y, 3 X)", Y=y, X=r)
    if kind == "f" and x[1] == "acos":
        a = x[2][0]
        yield "arcsine", _of("pi/2 - asin(A)", A=a)
        yield "root and atan2", _of("atan2(sqrt(1 - A^2), A)", A=a)
        yield "half an arccosine", _of("2 atan(sqrt((1 - A)/(1 + A)))", A=a)
        yield "supplement", _of("pi - acos(-A)", A=a)
    if kind == "f" and x[1] == "sqrt":
        yield "root of a quotient", _of("2 sqrt(A/4)", A=x[2][0])
    if kind == "/":
        yield "turned over", _of("A (1/B)", A=x[1], B=x[2])
        yield "with a minus", _of("(-A)/(-B)", A=x[1], B=x[2])
    if kind == "eq":
        yield "sides exchanged", ("eq", x[2], x[1])
        yield "zero on the right", ("eq", _of("A - B", A=x[1], B=x[2]), ("n", "0"))
        yield "both sides doubled", ("eq", _of("2 A", A=x[1]), _of("2 B", B=x[2]))
    if kind == "+" and len(x[1]) > 1:
        yield "backwards", ("+", x[1][::-1])


def _by(factors: tuple[Tree, ...], term: Tree) -> Tree:
    inner = ("*", (*factors, term[1] if term[0] in ("-", "pm") else term))
    return (term[0], inner) if term[0] in ("-", "pm") else inner


def _product_to_sum(a: str, b: str) -> Tree:
    A, B = (" + ".join(f"theta{d}" for d in n[1:]) for n in (a, b))
    if a[0] == "c" and b[0] == "c":
        return read(f"(cos({A} - ({B})) + cos({A} + {B}))/2")
    if a[0] == "s" and b[0] == "s":
        return read(f"(cos({A} - ({B})) - cos({A} + {B}))/2")
    if a[0] == "s":
        return read(f"(sin({A} + {B}) + sin({A} - ({B})))/2")
    return read(f"(sin({A} + {B}) - sin({A} - ({B})))/2")


def drawn(seed: int, count: int) -> list[Form]:
    """Draw right formulas in unusual forms, one to three changes each; the oracle confirms each."""
    rng = random.Random(seed)
    out: list[Form] = []
    while len(out) < count:
        arm = ARMS[len(out) % len(ARMS)]
        kind, of, tree = rng.choice(list(facts(arm)))
        names = []
        for _ in range(rng.randint(1, 3)):
            made = [(name, put(tree, path, new)) for path, node in places(tree) for name, new in forms(node)]
            if made:
                name = rng.choice(sorted({m[0] for m in made}))
                tree = rng.choice([m[1] for m in made if m[0] == name])
                names.append(name)
        if names and len(write(tree)) < 900 and shares(kind, of, tree, arm, rng.randrange(10**9), 12) == 1:
            out.append((arm, kind, of, tree, ", ".join(names)))
    return out
