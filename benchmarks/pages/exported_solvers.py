"""Write docs/exported_solvers.md from exports.json: which arm was run in which language, and what differed."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from benchmarks.kept import read

HEAD = """\
# Exported solvers beside the native one

Which arm was run in which language: random poses inside the limits, half of them rounded (to 6, 8, 10 and 12 digits
and to float32), rows inside the limits beside `arm.ik_many`'s, to 1e-7 rad. Measured by `python -m
benchmarks.measure.exports`, which goes on where it was left; written by `make pages` (see [code](code.md)).

Where a number of poses stands alone, no pose differed. *+k*: k poses differ; *~k*: k poses differ where the file
says `unclear`, next to singular ones: rows are known to fewer digits there, and some may be missing. *no*: refused in
words, as a family that is no list of operations. Arms that are not listed were not run. Times are of processors that
others used as well.
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
#: Of each arm's name what was found in one language.
Found = dict[str, dict[str, Any]]
#: The goals of C: us a pose, kB of source, s to write it.
GOALS = {"us": 1.5, "kB": 40.0, "written_s": 1.0}


def cell(found: dict[str, Any] | None) -> str:
    """Return what is said of an arm in a language."""
    if found is None:
        return ""
    if "refused" in found:
        return "no"
    more = [f"{sign}{found[key]}" for sign, key in (("+", "differ"), ("~", "differ_unclear")) if found[key]]
    return " ".join([f"{found['poses']:,}", *more])


def middle_and_most(quantity: str) -> Callable[[Found], str]:
    """Return what says a quantity's value at the middle arm, and the largest with its arm."""

    def say(found: Found) -> str:
        values = sorted((one[quantity], name) for name, one in found.items() if quantity in one)
        most, name = values[-1]
        return f"{values[len(values) // 2][0]:.3g}; {most:.3g} ({name})"

    return say


def within(found: Found) -> str:
    """Return at how many arms each of the goals of C holds."""
    holds = [sum(one.get(key, 0.0) <= most for one in found.values()) for key, most in GOALS.items()]
    return f"{', '.join(map(str, holds))} of {len(found)}"


#: What is said over the arms, and how.
SUMMED: dict[str, Callable[[Found], str]] = {
    "all": lambda found: f"{len(found)} arms, {sum(one['poses'] for one in found.values()):,}",
    "poses that differ": lambda found: " and ~".join(
        str(sum(one[key] for one in found.values())) for key in ("differ", "differ_unclear")
    ),
    "us a pose: middle arm; slowest": middle_and_most("us"),
    "kB: middle arm; largest": middle_and_most("kB"),
    "s to write: middle arm; longest": middle_and_most("written_s"),
    "arms within 1.5 us, 40 kB, 1 s (the goals of C)": within,
}


def page() -> str:
    """Return the page."""
    arms = read("exports")["arms"]
    ran = [key for key in NAMES if any("poses" in own.get(key, {}) for own in arms.values())]
    lines = [HEAD, "| | " + " | ".join(NAMES[key] for key in ran) + " |", "|---" * (1 + len(ran)) + "|"]
    every = {key: {name: own[key] for name, own in arms.items() if "poses" in own.get(key, {})} for key in ran}
    for name, say in SUMMED.items():
        said = [say(every[key]) if say is not within or key == "c" else "" for key in ran]
        lines.append(f"| *{name}* | " + " | ".join(said) + " |")
    for name, own in sorted(arms.items()):
        if any("poses" in found for found in own.values()):
            lines.append(f"| {name} | " + " | ".join(cell(own.get(key)) for key in ran) + " |")
    return "\n".join(lines) + "\n"
