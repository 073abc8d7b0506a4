"""Judge planted claims and count: called right, explained by the planted slip first, by another one, by none.

Run as ``python -m tests.judge.held_out.measure formulas|double|numbers|unusual SEED COUNT [RESULTS.json]``; what is not
as it should be is printed, and the counts are added to the results.
"""

from __future__ import annotations

import collections
import json
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pieper
from pieper.judge import Verdict
from tests.judge.held_out import number_slips, plant, unusual
from tests.judge.held_out.arms import ARMS
from tests.judge.held_out.oracle import shares
from tests.judge.held_out.plant import Planted
from tests.judge.held_out.tree import read, write, written_alike

Outcome = tuple[str, str, str]  # what came out, which slip or form, the case in one line


def outcome(p: Planted, verdict: Verdict) -> str:
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


def formulas(seed: int, count: int, twice: bool = False) -> Iterator[Outcome]:
    """Formulas with one slip each, or two."""
    found = plant.drawn(seed, count, twice)
    for arm in ARMS:
        mine = [p for p in found if p.arm is arm]
        verdicts = pieper.check(plant.claims_file(arm, mine)).verdicts if mine else ()
        for p, v in zip(mine, verdicts, strict=True):
            told = (
                arm.name,
                p.kind,
                p.of,
                write(p.right),
                write(p.wrong),
                f"{p.share:.2f}",
                v.status,
                v.slip,
                v.reading,
            )
            yield outcome(p, v), p.slip, " | ".join((*told, v.sentence[:160]))


def numbers(seed: int, count: int) -> Iterator[Outcome]:
    """Numbers with one slip each; the explanation must name the place and the slip."""
    for w in number_slips.drawn(seed, count):
        v = pieper.check(number_slips.claims_file(w)).verdicts[0]
        said = " ".join((v.sentence, v.slip, *(text for head, text in v.details if head != "tried")))
        named = all(any(word in said for word in group) for group in w.names)
        got = "called right" if v.holds else "none" if not v.slip else "planted" if named else "another"
        yield got, w.slip, f"{w.arm.name} | {w.text} | {w.names} | {v.sentence} | {v.details}"


def forms(seed: int, count: int) -> Iterator[Outcome]:
    """Right formulas in unusual forms."""
    found = unusual.drawn(seed, count)
    for arm in ARMS:
        mine = [Planted(arm, kind, of, tree, tree, form, 1.0) for a, kind, of, tree, form in found if a is arm]
        verdicts = pieper.check(plant.claims_file(arm, mine)).verdicts if mine else ()
        for p, v in zip(mine, verdicts, strict=True):
            yield v.status, p.slip, f"{arm.name} | {p.kind} {p.of} | {write(p.wrong)} | {v.sentence}"


def double(seed: int, count: int) -> Iterator[Outcome]:
    """Formulas with two slips each."""
    return formulas(seed, count, twice=True)


KINDS: dict[str, Callable[[int, int], Iterator[Outcome]]] = {
    "formulas": formulas,
    "double": double,
    "numbers": numbers,
    "unusual": forms,
}


def run(what: str, seed: int, count: int) -> dict[str, Any]:
    """Judge `count` claims of a kind and tell what came out."""
    counts: collections.Counter[str] = collections.Counter()
    by_slip: dict[str, collections.Counter[str]] = collections.defaultdict(collections.Counter)
    started = time.process_time()
    for got, slip, told in KINDS[what](seed, count):
        counts[got] += 1
        by_slip[slip][got] += 1
        if got not in ("planted", "holds"):
            print(f"{got} | {slip} | {told}", flush=True)
    out: dict[str, Any] = {"what": what, "seed": seed, "claims": count, "outcomes": dict(counts)}
    if what != "unusual":
        out["by slip"] = {k: dict(v) for k, v in sorted(by_slip.items())}
    out["seconds"] = round(time.process_time() - started, 1)
    return out


def keep(result: dict[str, Any], path: Path) -> None:
    """Add a result to a file of results, in the place of an earlier one of the same seed."""
    runs = json.loads(path.read_text(encoding="utf-8")) if path.exists() else []
    same = ("what", "seed", "claims")
    runs = [r for r in runs if any(r[k] != result[k] for k in same)] + [result]
    path.write_text(json.dumps(sorted(runs, key=lambda r: (r["what"], r["seed"])), indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    made = run(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]))
    print(json.dumps(made["outcomes"]), made["seconds"], "s")
    if len(sys.argv) > 4:
        keep(made, Path(sys.argv[4]))
