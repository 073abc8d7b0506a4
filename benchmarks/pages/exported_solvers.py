"""Write docs/exported_solvers.md from exports.json: which arm was run in which language, and what differed."""

from __future__ import annotations

from typing import Any

from benchmarks.kept import read

HEAD = """\
# Exported solvers beside the native one

Which arm was run in which language: random poses inside the limits, half of them rounded (to 6, 8, 10 and 12 digits
and to float32), rows inside the limits beside `arm.ik_many`'s, to 1e-7 rad. Measured by `python -m
benchmarks.measure.exports`, which goes on where it was left; written by `make pages` (see [code](code.md)).

Where a number of poses stands alone, no pose differed. *+k*: k poses differ; *~k*: k poses differ where the file
says `unclear`, next to singular ones: rows are known to fewer digits there, and some may be missing. *no*: refused in
words, as a family that is no list of operations. Arms that are not listed were not run.
"""
NAMES = {
    "c": "C",
    "c++": "C++",
    "python": "Python",
    "javascript": "JavaScript",
    "jax": "JAX",
    "wasm": "wasm",
    "matlab": "Octave",
}


def cell(found: dict[str, Any] | None) -> str:
    """Return what is said of an arm in a language."""
    if found is None:
        return ""
    if "refused" in found:
        return "no"
    more = [f"{sign}{found[key]}" for sign, key in (("+", "differ"), ("~", "differ_unclear")) if found[key]]
    return " ".join([f"{found['poses']:,}", *more])


def page() -> str:
    """Return the page."""
    arms = read("exports")["arms"]
    ran = [key for key in NAMES if any("poses" in own.get(key, {}) for own in arms.values())]
    lines = [HEAD, "| | " + " | ".join(NAMES[key] for key in ran) + " |", "|---" * (1 + len(ran)) + "|"]
    every = {key: [own[key] for own in arms.values() if "poses" in own.get(key, {})] for key in ran}
    total = {key: f"{len(found)} arms, {sum(one['poses'] for one in found):,}" for key, found in every.items()}
    bad = {key: f"{sum(o['differ'] for o in f)} and ~{sum(o['differ_unclear'] for o in f)}" for key, f in every.items()}
    took = {key: sorted(one["us"] for one in found) for key, found in every.items()}
    middle = {key: f"{us[len(us) // 2]:.3g}" for key, us in took.items()}
    for name, row in (("all", total), ("poses that differ", bad), ("us a pose, middle arm", middle)):
        lines.append(f"| *{name}* | " + " | ".join(row[key] for key in ran) + " |")
    for name, own in sorted(arms.items()):
        if any("poses" in found for found in own.values()):
            lines.append(f"| {name} | " + " | ".join(cell(own.get(key)) for key in ran) + " |")
    return "\n".join(lines) + "\n"
