"""How the judge does on planted slips: `python -m tests.judge.planted.measure 200 --seed 1`."""

from __future__ import annotations

import argparse
import collections
import time

import numpy as np

import pieper
from pieper.algebra.expression import Call, Expr
from pieper.algebra.parser import parse as parse_formula
from pieper.judge import Verdict

from .arms import ARMS, PlantedArm
from .formula import paper
from .generate import Planted, claims_file, one_slip, right_claims, two_slips
from .unusual import rewritings


def as_judge_writes(arm: PlantedArm, text: str) -> str:
    """A formula in the judge's own spelling, to compare readings with."""
    names = {*arm.lengths, *("p" + c for c in "xyz"), *(f"r{i}{j}" for i in "123" for j in "1234")}
    names |= {f"b{i + 1}" for i, row in enumerate(arm.rows) if row.kind == "P"}
    return _sorted(parse_formula(text, names, arm.n))


def _sorted(node: Expr) -> str:
    """A formula with the order of terms and factors, and where a minus stands, left out."""
    inner = sorted(_sorted(a) for a in node.args) if node.op in ("sum", "product") else [_sorted(a) for a in node.args]
    if node.op == "product":
        minus = sum(a.startswith("-(") for a in inner) % 2
        text = f"product({', '.join(sorted(a[2:-1] if a.startswith('-(') else a for a in inner))})"
        return f"-({text})" if minus else text
    if node.op == "minus":
        return inner[0][2:-1] if inner[0].startswith("-(") else f"-({inner[0]})"
    head = node.name if isinstance(node, Call) else node.op
    return f"{head}({', '.join(inner)})" if inner else str(node)


#: What the judge calls the slips that are planted.
CALLED = {
    "sign": {"sign", "branch", "half turn"},
    "lost term": {"missing term"},
    "lost factor": {"missing factor"},
    "upside down": {"fraction"},
    "lost power": {"power", "missing factor"},
    "power as factor": {"power"},
    "lost branch": {"branch"},
    "arguments swapped": {"atan"},
    "atan for atan2": {"atan"},
    "asin for acos": {"inverse function"},
    "lost root": {"power"},
    "sine for cosine": {"sine for cosine", "swapped factor"},
    "index": {"index", "swapped factor"},
    "length": {"index", "swapped factor"},
    "transposed": {"index", "swapped factor"},
    "entry": {"index", "swapped factor"},
    "axis": {"index", "swapped factor"},
    "slide's index": {"index", "swapped factor"},
}


def explained_by(claim: Planted, verdict: Verdict) -> bool:
    """Whether a verdict undoes the planted slip.

    Its reading is the formula before the slip, be its terms and factors in another order; or one of equal value for
    everything, made by a slip of the same kind (c1 s2 px lost, where px was lost inside a bracket).
    """
    if not verdict.reading:
        return False
    if as_judge_writes(claim.arm, verdict.reading) == as_judge_writes(claim.arm, claim.right):
        return True
    return verdict.slip in CALLED[claim.slip]


def single(count: int, seed: int) -> list[Planted]:
    """So many wrong claims with one slip each, over all arms evenly."""
    rng = np.random.default_rng(seed)
    out: list[Planted] = []
    for arm in ARMS:
        pool = [slip for claim in right_claims(arm) for slip in one_slip(claim)]
        take = rng.permutation(len(pool))[: -(-count // len(ARMS))]
        out += [pool[k] for k in take]
    return out


def double(count: int, seed: int) -> list[Planted]:
    """So many wrong claims with two slips each."""
    rng = np.random.default_rng(seed)
    out: list[Planted] = []
    while len(out) < count:
        arm = ARMS[int(rng.integers(len(ARMS)))]
        claims = right_claims(arm)
        made = two_slips(claims[int(rng.integers(len(claims)))], rng)
        out += [made] if made else []
    return out


def unusual(count: int, seed: int) -> list[Planted]:
    """So many right claims in unusual forms."""
    rng = np.random.default_rng(seed)
    pool = [
        Planted(arm, claim.kind, claim.target, paper(tree), claim.text, kind, tree, claim.tree)
        for arm in ARMS
        for claim in right_claims(arm)
        for kind, tree in rewritings(claim.tree)
    ]
    return [pool[k] for k in rng.permutation(len(pool))[:count]]


def judged(claims: list[Planted]) -> list[tuple[Planted, Verdict]]:
    """Every claim with its verdict."""
    by_arm: dict[str, list[Planted]] = collections.defaultdict(list)
    for claim in claims:
        by_arm[claim.arm.name].append(claim)
    out = []
    for group in by_arm.values():
        verdicts = pieper.check(claims_file(group[0].arm, group)).verdicts
        out += list(zip(group, verdicts, strict=True))
    return out


def main() -> None:
    """Print how many were called what."""
    parser = argparse.ArgumentParser()
    parser.add_argument("count", type=int)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kind", choices=("single", "double", "unusual", "right"), default="single")
    parser.add_argument("--show", type=int, default=40)
    args = parser.parse_args()
    if args.kind == "right":
        claims = [claim for arm in ARMS for claim in right_claims(arm)]
    else:
        claims = {"single": single, "double": double, "unusual": unusual}[args.kind](args.count, args.seed)
    start = time.process_time()
    status: collections.Counter[str] = collections.Counter()
    missed: collections.Counter[str] = collections.Counter()
    explained = same = shown = 0
    for claim, verdict in judged(claims):
        status[verdict.status] += 1
        if args.kind in ("unusual", "right"):
            bad = not verdict.holds
        else:
            exact = explained_by(claim, verdict) if args.kind == "single" else bool(verdict.reading)
            explained += exact
            bad = verdict.holds or not exact
            missed[claim.slip] += bad
            same += bool(verdict.reading)
        if bad and shown < args.show:
            shown += 1
            print(f"[{verdict.status}] {claim.arm.name} {claim.target} ({claim.slip})")
            print(f"   claimed {claim.text}\n   right   {claim.right}\n   reading {verdict.reading}")
            print(f"   {verdict.sentence} {dict(verdict.details).get('the slip', '')}")
    print(len(claims), dict(status), "explained by the planted slip first:", explained, "with a reading:", same)
    print(
        {k: v for k, v in missed.items() if v}, f"{(time.process_time() - start) / max(len(claims), 1):.2f} s a claim"
    )


if __name__ == "__main__":
    main()
