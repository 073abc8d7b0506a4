"""What is right: formulas against poses multiplied out in mpmath, at random joints and lengths of one's own."""

from __future__ import annotations

import random
from collections.abc import Iterator
from typing import Any

import mpmath as mp

from tests.judge.held_out.arms import HeldOutArm, quarter
from tests.judge.held_out.tree import Tree, read, real, value

mp.mp.dps = 30
_LETTERS = {f"{c}{r}": (i, j) for j, c in enumerate("noap") for i, r in enumerate("xyz")}


class Posture:
    """One posture of an arm with lengths of its own, and what the letters of a formula are there."""

    def __init__(self, arm: HeldOutArm, rng: random.Random, vary: bool = True) -> None:
        """Draw the joints and, where `vary`, the lengths."""
        self.arm = arm
        self.lengths = {k: mp.mpf(v) * (rng.uniform(0.6, 1.6) if vary else 1) for k, v in arm.values.items()}
        self.joints = [mp.mpf(rng.uniform(-0.8, 0.8) if s else rng.uniform(-3.1, 3.1)) for s in arm.slides]
        self.T = arm.pose(self.joints, self.lengths)

    def __call__(self, name: str) -> Any:
        """The value of a letter."""
        if name == "pi":
            return mp.pi
        low = name.lower() if name[0] == "P" else name
        if low in _LETTERS:
            return self.T[_LETTERS[low]]
        if name in self.lengths:
            return self.lengths[name]
        if name.startswith("theta"):
            return self.angle(name[5:])
        if name[0] in "cs" and name[1:].isdigit():
            return (mp.cos if name[0] == "c" else mp.sin)(self.angle(name[1:]))
        for k, row in enumerate(self.arm.rows):
            if self.arm.slides[k] and row[1] == name:
                return self.joints[k]
        raise KeyError(name)

    def angle(self, indices: str) -> Any:
        """The sum of DH angles of these joints."""
        ks = [int(i) - 1 for i in indices]
        return mp.fsum(self.joints[k] + quarter(self.arm.rows[k][0]) * mp.pi / 2 for k in ks)


def right_at(kind: str, of: str, tree: Tree, at: Posture) -> bool:
    """Say whether a claim is right at a posture: an entry, both sides of an equation, a branch of a joint's formula."""
    for sign in (1, -1):
        try:
            got = value(tree, at, sign, real)
        except ZeroDivisionError:
            continue
        if mp.isnan(got):
            continue
        if kind == "entry":
            off = got - at(of)
        elif kind == "equation":
            off = got
        else:
            k = int(of) - 1
            slide = at.arm.slides[k]
            off = got - (at.joints[k] if slide else at.angle(of))
            off = off if slide else mp.sin(off / 2)
        if abs(off) < mp.mpf("1e-14"):
            return True
    return False


def shares(kind: str, of: str, tree: Tree, arm: HeldOutArm, seed: int, tries: int = 24) -> float:
    """The share of postures at which a claim is right."""
    rng = random.Random(seed)
    return sum(right_at(kind, of, tree, Posture(arm, rng)) for _ in range(tries)) / tries


def facts(arm: HeldOutArm) -> Iterator[tuple[str, str, Tree]]:
    """Every right formula of an arm: kind, what it is of, its tree (an equation's has two sides)."""
    for of in arm.entries:
        yield "entry", of, entry_tree(arm, of)
    for of, text in arm.facts:
        yield "entry", of, read(text)
    for of, text in arm.joints:
        yield "joint", of, read(text)
    for text in arm.equations:
        yield "equation", "", read(text)


Poly = dict[tuple[str, ...], int]


def entry_tree(arm: HeldOutArm, of: str) -> Tree:
    """An entry of the pose multiplied out, as a sum of products of named sines, cosines and lengths."""
    i, j = _LETTERS[of.lower()]
    vector: list[Poly] = [{}, {}, {}]
    if j < 3:
        vector[j] = {(): 1}
    for group in reversed(_groups(arm)):
        vector = _behind(group, vector, j == 3)
    parts: list[Tree] = []
    for names, k in sorted(vector[i].items()):
        if not k:
            continue
        factors: list[Tree] = [("n", str(abs(k)))] if abs(k) != 1 or not names else []
        factors += [("v", n) for n in names]
        node: Tree = factors[0] if len(factors) == 1 else ("*", tuple(factors))
        parts.append(("-", node) if k < 0 else node)
    if not parts:
        return ("n", "0")
    return parts[0] if len(parts) == 1 else ("+", tuple(parts))


def _groups(arm: HeldOutArm) -> list[list[tuple[str, int, str, str, int]]]:
    """Rows gathered while the twist is zero: digits of the joints turned so far, quarter turns, d, a, twist."""
    groups: list[list[tuple[str, int, str, str, int]]] = [[]]
    digits, turns = "", 0
    for k, (theta, d, a, alpha) in enumerate(arm.rewritten()):
        digits += "" if arm.slides[k] else str(k + 1)
        turns += quarter(theta)
        groups[-1].append((digits, turns, d, a, alpha))
        if alpha:
            digits, turns = "", 0
            groups.append([])
    return [g for g in groups if g]


def _behind(group: list[tuple[str, int, str, str, int]], v: list[Poly], shift: bool) -> list[Poly]:
    digits, turns, _, _, alpha = group[-1]
    y, z = v[1], v[2]
    if alpha == 90:
        y, z = _scaled(z, -1), y
    elif alpha == -90:
        y, z = z, _scaled(y, -1)
    c, s = _turned(digits, turns)
    x = v[0]
    out = [
        _plus(_by(x, c), _scaled(_by(y, s), -1)),
        _plus(_by(x, s), _by(y, c)),
        dict(z),
    ]
    if shift:
        for digits, turns, d, a, _ in group:
            c, s = _turned(digits, turns)
            if a != "0":
                out[0] = _plus(out[0], _by(c, {(a,): 1}))
                out[1] = _plus(out[1], _by(s, {(a,): 1}))
            if d != "0":
                out[2] = _plus(out[2], {(d,): 1})
    return out


def _turned(digits: str, turns: int) -> tuple[Poly, Poly]:
    c: Poly = {(f"c{digits}",): 1} if digits else {(): 1}
    s: Poly = {(f"s{digits}",): 1} if digits else {}
    for _ in range(turns % 4):
        c, s = _scaled(s, -1), c
    return c, s


def _plus(a: Poly, b: Poly) -> Poly:
    out = dict(a)
    for names, k in b.items():
        out[names] = out.get(names, 0) + k
    return out


def _scaled(a: Poly, k: int) -> Poly:
    return {names: k * v for names, v in a.items()}


def _by(a: Poly, b: Poly) -> Poly:
    out: Poly = {}
    for n, v in a.items():
        for m, w in b.items():
            key = tuple(sorted(n + m, key=_order))
            out[key] = out.get(key, 0) + v * w
    return out


def _order(name: str) -> tuple[int, int, str]:
    trig = name[0] in "cs" and name[1:].isdigit()
    return (1, int(name[1]), name) if trig else (0, 0, name)
