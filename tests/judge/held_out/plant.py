"""Claims with one slip each, drawn by a seed, and the claims file that holds them."""

from __future__ import annotations

import random
from dataclasses import dataclass

from tests.judge.held_out.arms import ARMS, HeldOutArm
from tests.judge.held_out.formula_slips import slips
from tests.judge.held_out.oracle import facts, shares
from tests.judge.held_out.tree import Tree, write, written_alike


@dataclass(frozen=True)
class Planted:
    """A claim with one slip.

    Attributes:
        arm: Whose it is.
        kind: "entry", "joint", "equation".
        of: What the formula is of.
        right: The right formula.
        wrong: With the slip.
        slip: The slip's name.
        share: The share of postures at which it is right all the same.
    """

    arm: HeldOutArm
    kind: str
    of: str
    right: Tree
    wrong: Tree
    slip: str
    share: float


def drawn(seed: int, count: int, twice: bool = False) -> list[Planted]:
    """Draw planted claims: an arm, a fact, a kind of slip, a place; what is right by chance is drawn again.

    Two slips in one formula (`twice`) are of any two kinds at any two places, each wrong by itself.
    """
    rng = random.Random(seed)
    out: list[Planted] = []
    while len(out) < count:
        arm = ARMS[len(out) % len(ARMS)]
        kind, of, right = rng.choice([f for f in facts(arm) if f[2][0] not in "nv"])
        made = list(slips(arm, kind, right))
        if not made:
            continue
        name = rng.choice(sorted({m[0] for m in made}))
        wrong = rng.choice([m[1] for m in made if m[0] == name])
        if twice:
            more = [m for m in slips(arm, kind, wrong) if not written_alike(m[1], right)]
            if not more:
                continue
            second, wrong = rng.choice(more)
            name = " and ".join(sorted((name, second)))
        share = shares(kind, of, wrong, arm, rng.randrange(10**9))
        if share < 1:
            out.append(Planted(arm, kind, of, right, wrong, name, share))
    return out


def claims_file(arm: HeldOutArm, planted: list[Planted]) -> str:
    """The text of a claims file of one arm."""
    lines = [head(arm)]
    for k, p in enumerate(planted):
        lines += ["[[claim]]", f'id = "{k}"', f'kind = "{p.kind}"']
        if p.kind == "joint":
            lines += [f"joint = {p.of}", *([f'task = "{arm.task}"'] if arm.task else [])]
        elif p.kind == "entry":
            lines.append(f'of = "{p.of}"')
        lines.append(f'is = "{write(p.wrong)}"')
    return "\n".join(lines)


def head(arm: HeldOutArm) -> str:
    """The part of a claims file that says the arm."""
    if arm.modified:
        rows = [[a, f"{alpha} deg", d, theta] for theta, d, a, alpha in arm.rows]
        columns = ["a", "alpha", "d", "theta"]
    else:
        rows = [[theta, d, a, f"{alpha} deg"] for theta, d, a, alpha in arm.rows]
        columns = ["theta", "d", "a", "alpha"]
    quoted = ", ".join("[" + ", ".join(f'"{c}"' for c in row) + "]" for row in rows)
    values = ", ".join(f"{k} = {v}" for k, v in arm.values.items())
    return "\n".join(
        [
            f'title = "{arm.name}"',
            "[arm]",
            f'name = "{arm.name}"',
            f'convention = "{"modified" if arm.modified else "standard"}"',
            'length_unit = "m"',
            f"columns = {columns}".replace("'", '"'),
            f"rows = [{quoted}]",
            f"values = {{ {values} }}",
            "",
        ]
    )
