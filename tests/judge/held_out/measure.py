"""Judge planted claims and count: called right, explained by the planted slip first, by another one, by none.

Run as ``python -m tests.judge.held_out.measure SEED COUNT``.
"""

from __future__ import annotations

import collections
import json
import sys
import time
from typing import Any

import pieper
from tests.judge.held_out.arms import ARMS
from tests.judge.held_out.oracle import shares
from tests.judge.held_out.plant import Planted, claims_file, drawn
from tests.judge.held_out.tree import read, write, written_alike


def outcome(p: Planted, verdict: Any) -> str:
    """What the judge made of a planted claim: "called right", "planted", "another", "a wrong one", "none"."""
    if verdict.holds:
        return "called right"
    if not verdict.reading:
        return "none"
    try:
        tree = read(verdict.reading)
        if written_alike(tree, p.right):
            return "planted"
        return "another" if shares(p.kind, p.of, tree, p.arm, 7) == 1 else "a wrong one"
    except (ValueError, KeyError, IndexError, TypeError):
        return "not read"


def run(seed: int, count: int) -> dict[str, Any]:
    """Judge `count` planted claims and tell what came out."""
    found = drawn(seed, count)
    counts: collections.Counter[str] = collections.Counter()
    by_slip: dict[str, collections.Counter[str]] = collections.defaultdict(collections.Counter)
    started = time.process_time()
    for arm in ARMS:
        mine = [p for p in found if p.arm is arm]
        for p, verdict in zip(mine, pieper.check(claims_file(arm, mine)).verdicts, strict=True) if mine else ():
            what = outcome(p, verdict)
            counts[what] += 1
            by_slip[p.slip][what] += 1
            if what != "planted":
                told = (what, p.slip, arm.name, p.kind, p.of, write(p.right), write(p.wrong), f"{p.share:.2f}")
                print(" | ".join((*told, verdict.status, verdict.slip, verdict.reading, verdict.sentence[:160])))
    seconds = time.process_time() - started
    return {
        "seed": seed,
        "claims": count,
        "outcomes": dict(counts),
        "by slip": {k: dict(v) for k, v in sorted(by_slip.items())},
        "seconds": round(seconds, 1),
    }


if __name__ == "__main__":
    print(json.dumps(run(int(sys.argv[1]), int(sys.argv[2])), indent=1))
