"""Write docs/route_verdicts.md: verdicts and costs of routes on random seams, an arm a line."""

from __future__ import annotations

from typing import Any

import numpy as np

from benchmarks.kept import read

HEAD = """\
# Verdicts of routes

Random seams before twenty arms: rings and lines of 24 points with a tool tilted off joint 6, the turn free, limits as
the arms ship and, every third seam, those of one joint narrowed. Measured by `python -m
benchmarks.measure.route_verdicts`, which goes on where it was left; written by `make pages`.

- *found*, *impossible*, *uncertain*: the verdicts. *Wrong*: FOUND routes that, looked at ten times between points
  from their own neighbours, leave the path or the limits or jump, and IMPOSSIBLE seams on which a flood over 7,200
  turns of the tool, from everything inside the limits where the proof begins, gets past the place where it ends.
- *at a pole*: seams, out of all, on which what holds the tool's point and axis is nearly singular somewhere (least
  singular value below 3e-3, lengths per length of the arm); *uncertain there*: how many of the uncertain ones are
  among them.
- *cost*: of as many found routes as were measured, how many cost at most 1 percent more than a ladder of 1,440 turns
  that was made short by another method, and the largest excess. The ladder takes joints that can turn all the way
  round as if they had no limits, and steps from branch to branch where rows of two are near: where it costs less and
  its chain does not fit the limits, or is torn when it is looked at between its points, nothing is compared, nor where
  it leads nowhere: it turns by 6 degrees at most from point to point and lets go what costs half as much again as the
  route.
- *s*: processor time of a verdict on a machine shared by many, middle and largest.

"""
POLE = 3e-3


def line(name: str, seams: list[dict[str, Any]]) -> str:
    """Return an arm's row."""
    count = {v: sum(s["verdict"] == v for s in seams) for v in ("FOUND", "IMPOSSIBLE", "UNCERTAIN")}
    wrong = sum(bool(s["wrong"]) for s in seams)
    pole = sum(s["least"] < POLE for s in seams)
    there = sum(s["least"] < POLE and s["verdict"] == "UNCERTAIN" for s in seams)
    both = [s for s in seams if s.get("ladder") is not None]
    sound = [s for s in both if (s.get("fits", True) and not s.get("torn")) or s["cost"] <= s["ladder"]]
    excess = [s["cost"] / s["ladder"] - 1 for s in sound]
    cost = f"{sum(e <= 0.01 for e in excess)} of {len(excess)}, {100 * max(excess):+.2g} %" if excess else "-"
    took = np.array([s["seconds"] for s in seams])
    said = [name, len(seams), *count.values(), wrong, pole, there, cost, f"{np.median(took):.2f}, {took.max():.1f}"]
    return "| " + " | ".join(str(v) for v in said) + " |"


def table(kept: dict[str, Any]) -> str:
    """Return the results as a Markdown table, one line an arm, and all together."""
    heads = "arm, seams, found, impossible, uncertain, wrong, at a pole, uncertain there, cost, s".split(", ")
    lines = ["| " + " | ".join(heads) + " |", "|---" * len(heads) + "|"]
    every: list[dict[str, Any]] = []
    for name, seams in kept["seams"].items():
        every += seams.values()
        lines.append(line(name, list(seams.values())))
    return "\n".join([*lines, line("all", every)]) + "\n"


def page() -> str:
    """Return the page."""
    return HEAD + table(read("route_verdicts"))
