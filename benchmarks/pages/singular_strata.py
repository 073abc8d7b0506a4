"""Write docs/singular_strata.md: recall near singular postures, an arm a line."""

from __future__ import annotations

from benchmarks.kept import read

VERDICTS = ("as told", "rounding", "not real", "blurred", "lost", "unsettled")
HEAD = """\
# Near singular postures

Joint vectors 1e-10 to 1e-2 away from a singular one (log-uniform, in a generic direction), and a tenth of them
exactly singular, of every family; measured by `python -m benchmarks.measure.singular_strata`, written by `make
pages`. *1e-6*: part that is found again within 1e-6 rad. *1e-6 + 1e-14/sigma*: within what a pose in double precision
tells. Every miss of the second kind is judged in fifty digits, and of those of the first alone the first two of each
chunk of 250:

- *as told*: within what a pose in double precision tells, and not judged;
- *rounding*: the true solution of the rounded pose is among the rows; it is not where the joint vector was;
- *not real*: the rounded pose has no real solution there any more;
- *blurred*: two true solutions between which the pose is missed by rounding only, given once;
- *lost*: none of these.

*Over 1e-12*: unmarked poses with a residual above 1e-12 per reach or rad. Times are processor time on a machine shared
by many (three-r's is of the clock, beside eight other processes), for these poses, more than half of which are looked
at with care. Of seven-joint arms the joint that is held is so at its
default value; an exactly singular posture at that value lies on one of the self-motions.

"""


def table(kept: dict) -> str:
    """Return the results as a Markdown table, one line an arm."""
    heads = ["arm", "family", "poses", "1e-6", "1e-6 + 1e-14/sigma", *VERDICTS, "over 1e-12", "ms a pose"]
    lines = ["| " + " | ".join(heads) + " |", "|---" * len(heads) + "|"]
    for name, arm in kept.items():
        chunks = list(arm["chunks"].values())
        poses = sum(sum(c["poses"]) for c in chunks)
        flat, told = (sum(sum(c[key]) for c in chunks) for key in ("flat", "told"))
        said = " | ".join(str(sum(sum(c[v]) for c in chunks)) for v in VERDICTS)
        over, ms = sum(c["over"] for c in chunks), 1e3 * sum(c["seconds"] for c in chunks) / poses
        shares = f"{flat / poses:.5f} | {told / poses:.5f}"
        lines.append(f"| {name} | {arm['family']} | {poses} | {shares} | {said} | {over} | {ms:.2f} |")
    return "\n".join(lines) + "\n"


def page() -> str:
    """Return the page."""
    kept = read("singular_strata")
    chunks = [chunk for arm in kept.values() for chunk in arm["chunks"].values()]
    poses, told = (sum(sum(chunk[key]) for chunk in chunks) for key in ("poses", "told"))
    whole = (
        f"In all {poses:,} poses, of which {poses - told} are not found within the second bound: {told / poses:.6f}."
    )
    return HEAD + whole + "\n\n" + table(kept)
