"""Claims files about the twenty arms: right claims, one slip each, two slips at once, and numbers."""

from __future__ import annotations

import ast
import copy
import re
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from oracle.joints import around

from .arms import PlantedArm
from .formula import evaluate, names_at, paper, parse
from .slips import planted

_SLIDE = re.compile(r"\bb(\d)\b")
#: Slips of angle formulas that lose a branch: right on one of them.
PARTLY = frozenset({"lost branch", "atan for atan2"})


@dataclass(frozen=True)
class Planted:
    """One claim with what was done to it.

    Attributes:
        arm: Whose arm.
        kind: "entry" or "joint".
        target: An entry's name, or a joint's number.
        text: What is claimed, as a paper prints it.
        right: The formula before the slip, as a paper prints it.
        slip: Kind of the slip; "" for a right claim.
        tree: The claimed formula.
        right_tree: The formula before the slip.
    """

    arm: PlantedArm
    kind: str
    target: str
    text: str
    right: str
    slip: str
    tree: ast.expr
    right_tree: ast.expr

    def toml(self, number: int) -> list[str]:
        """The claim as part of a claims file."""
        out = ["", "[[claim]]", f'id = "{number}"', f'kind = "{self.kind}"']
        out.append(f'of = "{self.target}"' if self.kind == "entry" else f"joint = {self.target}")
        if self.kind == "joint" and self.arm.task == "position":
            out.append('task = "position"')
        return [*out, f'is = "{self.text}"']


def right_claims(arm: PlantedArm) -> list[Planted]:
    """The arm's formulas, right."""
    out: list[Planted] = []
    for kind, items in (("entry", list(arm.entries.items())), ("joint", [(str(j), text) for j, text in arm.joints])):
        for target, text in items:
            tree = parse(text)
            out.append(Planted(arm, kind, target, paper(tree), paper(tree), "", tree, tree))
    return out


def one_slip(claim: Planted) -> list[Planted]:
    """Every wrong claim one slip away from a right one; identities are left out.

    Args:
        claim: A right claim.
    """
    out: list[Planted] = []
    seen = {claim.text}
    slides = {i for i, row in enumerate(claim.arm.rows, start=1) if row.kind == "P"}
    for slip, tree in planted(claim.tree, tuple(claim.arm.lengths), claim.arm.n):
        text = paper(tree)
        names = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
        asked = {
            int(digit)
            for name in names
            for digit in (re.findall(r"\d", name) if re.match(r"[cs]\d|theta\d", name) else [])
        }
        moved = {int(m.group(1)) for name in names if (m := _SLIDE.match(name))}
        if text in seen or asked & slides or not moved <= slides:
            continue
        if claim.kind == "joint" and int(claim.target) in asked | moved:
            continue
        seen.add(text)
        if not agrees(claim.arm, claim.tree, tree, claim.kind):
            out.append(Planted(claim.arm, claim.kind, claim.target, text, claim.text, slip, tree, claim.tree))
    return out


def two_slips(claim: Planted, rng: np.random.Generator) -> Planted | None:
    """A claim with two slips at once.

    Args:
        claim: A right claim.
        rng: Chooses them.
    """
    first = one_slip(claim)
    if not first:
        return None
    once = first[int(rng.integers(len(first)))]
    second = [
        x
        for x in one_slip(
            Planted(claim.arm, claim.kind, claim.target, once.text, once.right, "", copy.deepcopy(once.tree), once.tree)
        )
    ]
    second = [x for x in second if not agrees(claim.arm, claim.tree, x.tree, claim.kind)]
    if not second:
        return None
    twice = second[int(rng.integers(len(second)))]
    return Planted(
        claim.arm,
        claim.kind,
        claim.target,
        twice.text,
        claim.text,
        f"{once.slip} and {twice.slip}",
        twice.tree,
        claim.tree,
    )


def agrees(arm: PlantedArm, a: ast.expr, b: ast.expr, kind: str, samples: int = 24) -> bool:
    """Whether two formulas are the same at random postures with random lengths, branch by branch.

    Args:
        arm: Whose names they use.
        a: One formula.
        b: The other.
        kind: "joint" compares angles modulo a turn, as sets over the branches.
        samples: How many postures.
    """
    rng = np.random.default_rng(7)
    for _ in range(samples):
        q, lengths = posture(arm, rng)
        values = names_at(arm, q, lengths)
        mine = [evaluate(a, values, branch) for branch in (1.0, -1.0)]
        theirs = [evaluate(b, values, branch) for branch in (1.0, -1.0)]
        if not (_within(mine, theirs, kind) and _within(theirs, mine, kind)):
            return False
    return True


def posture(arm: PlantedArm, rng: np.random.Generator) -> tuple[npt.NDArray[np.float64], dict[str, float]]:
    """Random joint values (rad, m) and random lengths (m)."""
    q = np.array([rng.uniform(-3, 3) if row.kind == "R" else rng.uniform(0.1, 0.9) for row in arm.rows])
    return q, {name: value * rng.uniform(0.7, 1.4) for name, value in arm.lengths.items()}


def _within(some: list[float], others: list[float], kind: str) -> bool:
    for x in some:
        if np.isnan(x):
            continue
        gaps = np.array([x - y for y in others if not np.isnan(y)])
        if kind == "joint":
            gaps = around(gaps)
        if gaps.size == 0 or np.abs(gaps).min() > 1e-6:
            return False
    return True


def claims_file(arm: PlantedArm, claims: list[Planted]) -> str:
    """A claims file about one arm."""
    lines = [f'title = "{arm.name}"', *arm.toml()]
    for number, claim in enumerate(claims):
        lines += claim.toml(number)
    return "\n".join(lines) + "\n"
