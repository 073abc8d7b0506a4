"""Write docs/arms.md: every arm of the catalogue with its plan, number of solutions, recall and speed."""

from __future__ import annotations

from benchmarks.kept import read

HEAD = """\
# The arms of the catalogue

One line an arm, written by `make pages` from what `python -m benchmarks.measure.catalogue` measured. *Most*: the
bound by the arm's own axes (`plan.count`). *Counts*: how many solutions random joint vectors' poses have (limits not
applied), as smallest to largest and mean. *Missed*: generating joint vectors not found again within 1e-6. *us*: time
a pose in `ik_many`, one thread, on shared and busy machines, lines at different times; it tells families apart and no
more. Redundant arms: at the generating value of the spare joint. What an arm's numbers are from, and where no second
source was found for them (the links of Epson's G6-651S and LS20-BA04S), stands in its file and in `pieper show`.

| arm | joints | task | family | spare | most | counts (mean) | missed | us |
|---|---|---|---|---|---|---|---|---|
"""


def row(r: dict) -> str:
    """Return the line of one arm."""
    counts = f"{r['fewest']} to {r['largest']} ({r['mean']:.2f})"
    plan = f"{r['joints']} | {r['task']} | {r['family']} | {', '.join(r['spare'])} | {r['most']}"
    return f"| {r['arm']} | {plan} | {counts} | {r['missed']} of {r['poses']} | {r['us_a_pose']:.3g} |\n"


def page() -> str:
    """Return the page."""
    return HEAD + "".join(map(row, read("catalogue")["rows"]))
