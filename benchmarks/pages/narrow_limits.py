"""Write docs/narrow_limits.md: redundant arms inside narrow limits, an arm a line."""

from __future__ import annotations

from typing import Any

from benchmarks.kept import read

HEAD = """\
# Redundant arms inside narrow limits

Arms of seven and eight joints, of the catalogue and of no name (oracle/arms/spare.py), with limits c - w to c + w about
a random posture c (another for each 250 poses), w = 1, 0.5, 0.2, 0.1 and 0.05 rad, and poses that were made inside by
the oracle's product of matrices; measured by `python -m benchmarks.measure.narrow_limits`, written by `make pages`.

- *wrong*: poses of a batch that are not called REDUNDANT, or have no row inside the limits;
- *astray*: poses with a row that misses the pose by more than 1e-9, or is outside the limits that it is said to be in;
- *nearest*: postures asked for nearest to the joint vector that made the pose, and how many were not that (1e-6);
- *self-motions*: looked at in 600 samples each, and how many are inside the limits elsewhere than `inside` says (1e-6).

Times are processor time on a machine shared by many.

"""
HEADS = ("arm", "family", "poses", "wrong", "astray", "nearest", "not met", "self-motions", "torn", "ms a pose")


def total(arm: dict[str, Any], key: str) -> Any:
    """Return the sum of a count over an arm's chunks."""
    return sum(chunk[key] for chunk in arm["chunks"].values())


def table(kept: dict[str, Any]) -> str:
    """Return the results as a Markdown table, one line an arm."""
    lines = ["| " + " | ".join(HEADS) + " |", "|" + "---|" * len(HEADS)]
    for name, arm in kept.items():
        if not arm["chunks"]:
            continue
        counts = [total(arm, key) for key in ("poses", "wrong", "astray", "asked", "missed", "looked", "torn")]
        ms = 1e3 * total(arm, "seconds") / counts[0]
        lines.append(f"| {name} | {arm['family']} | {' | '.join(str(n) for n in counts)} | {ms:.2f} |")
    return "\n".join(lines) + "\n"


def page() -> str:
    """Return the page."""
    kept = read("narrow_limits")
    poses, wrong, asked, missed = (
        sum(total(arm, key) for arm in kept.values()) for key in ("poses", "wrong", "asked", "missed")
    )
    whole = f"In all {poses:,} poses, {wrong} of them wrong; {asked:,} nearest postures, {missed} of them not met."
    return HEAD + whole + "\n\n" + table(kept)
