"""Write docs/completeness.md from the JSON files of the completeness checks.
Read are completeness.json, followed_roots.json, random_arms.json, other_arms.json and hard_arms.json of the results, as
the modules of the same names in benchmarks/measure/ write them, and the open cases of tests/oracle/found_losses.json.
"""

from __future__ import annotations

import json
from collections import Counter

from benchmarks.kept import ROOT, read

CASES = ROOT / "tests" / "oracle" / "found_losses.json"

INTRO = """\
# Completeness

Is every solution found, on every arm? Written by `make pages`. Nothing here trusts the solver: poses, residuals,
Jacobians and the search for solutions are the oracle's own (oracle/), which was written without sight of the kernels.
"""
SEARCHED = """\
## Whole sets against a multi-start search

`python -m benchmarks.measure.completeness`: each pose is searched from at least {starts} random starts (damped Newton
on the oracle's own product of matrices), and from more while its rarest solution was met fewer than eight times.
*Missing*: solutions of the search that the solver does not give, within 1e-6 + 1e-14 / sigma, sigma the smallest
singular value there. *Extra*: rows that do not close, or one solution given twice. *Not met*: rows that close and
that the search did not find: a weakness of the search. *Fewest hits*: of the rarest solution of all poses; one with a
basin as small would have been passed over with a probability of e to the minus that. `ik` was compared with `ik_many`
at every twentieth pose.
"""
FOLLOWED = """\
## Whole sets against sixteen complex paths

`python -m benchmarks.measure.followed_roots`: all sixteen complex solutions of a generic arm are carried along the
straight line to the arm and pose (oracle/homotopy.py). Every isolated solution is the end of a path; the ends that do
not arrive have left for infinity, or met a singular one. Nothing is drawn at random, so no small basin can be
overlooked. *Doubtful*: poses at which a path stopped halfway in all three attempts.
"""
AT_RANDOM = """\
## Random arms

`python -m benchmarks.measure.random_arms`: {joints} joints, revolute and prismatic in any order (0 to 6 slides),
standard and modified tables, half of them with base, tool, senses and zeros; {poses} poses each from random joint
vectors. Redundant arms are asked at the generating values of their spare joints. *Missed*: the joint vector that made
the pose is neither a row within 1e-6 + 1e-14 / sigma nor on a family. *Odd*: poses with an odd number of solutions on
arms of rank six; *far away*: the other one of the pair lies far out along nearly parallel slides, where the solver
does not give it. Residuals by the arm's size.
"""
OTHERS = """\
## Shorter and longer arms

`python -m benchmarks.measure.other_arms`: random arms of the same kinds against the multi-start search on the task
itself, at the generating values of what is to spare.
"""
HARD = """\
## Nearly special, tiny, huge and far away

`python -m benchmarks.measure.hard_arms`: six arms of the catalogue, changed; {poses} poses each, {searched} of them
searched as above (*missing*, *unseen*). Lengths in metres, angles in radians.
"""
KNOWN = """\
## Known losses

Every loss that was found is a test (tests/oracle/test_found_losses.py): {cases} cases, {open} of them open.
"""


def table(head: tuple[str, ...], rows: list[tuple]) -> list[str]:
    """Return the lines of a table."""
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return [*lines, *("| " + " | ".join(str(cell) for cell in row) + " |" for row in rows), ""]


def searched(result: dict) -> list[str]:
    """Whole sets against the multi-start search."""
    rows = []
    for name, a in result["arms"].items():
        counts = Counter({int(k): v for k, v in a["counts"].items()})
        span = f"{min(counts)} to {max(counts)}" if counts else "-"
        odd = f"{a['odd']}, {a['odd_at_double_root']}"
        rows.append(
            (name, a["types"], a["family"], a["poses"], a["solutions"], span, a["missing"], a["generating_missed"])
            + (a["extra"], a["unseen"], odd, a["uncertain"], a["ik_differs"], a["fewest"])
        )
    head = ("arm", "joints", "family", "poses", "solutions", "a pose", "missing", "generating missed")
    head += ("extra", "not met by the search", "odd, at a double root", "uncertain", "`ik` differs", "fewest hits")
    return [
        *SEARCHED.format(starts=result["starts"]).split("\n"),
        *table(head, rows),
    ]


def followed(result: dict) -> list[str]:
    """Whole sets against the sixteen paths."""
    rows = []
    for name, a in result["arms"].items():
        ends = ", ".join(f"{k} ({v})" for k, v in a["ends"].items())
        rows.append((name, a["family"], a["poses"], ends, a["real"], a["missing"], a["unseen"], a["doubtful"]))
    head = ("arm", "family", "poses", "ends that arrived (poses)", "real solutions", "missing", "not met by a path")
    return [
        *FOLLOWED.split("\n"),
        *table((*head, "doubtful"), rows),
    ]


def at_random(result: dict) -> list[str]:
    """The random arms."""
    rows = []
    for kind, t in result["kinds"].items():
        odd = f"{t['odd']}, {t['odd_at_double_root']}, {t['odd_far_away']}"
        rows.append(
            (kind, t["arms"], t["poses"], t["missed"], t["found_within_rounding"], odd, t["uncertain"], t["singular"])
            + (t["wrong"], t["twice"], t["refused"], t["failed"], f"{t['worst']:.1e}")
        )
    rows.sort(key=lambda row: row[0] == "all")
    head = ("kind", "arms", "poses", "missed", "within rounding", "odd, double root, far away", "uncertain", "singular")
    head += ("do not close", "given twice", "no plan", "raised", "worst residual")
    lines = [
        *AT_RANDOM.format(**result).split("\n"),
        *table(head, rows),
        *table(("family", "arms"), sorted(result["family"].items(), key=lambda x: -x[1])),
        *table(("rank of the Jacobian", "arms"), sorted(result["rank"].items(), reverse=True)),
    ]
    for key, what, unit in (("plan_ms", "Making a plan", "ms"), ("us_a_pose", "A pose in `ik_many`", "us")):
        parts = ", ".join(
            f"{v} up to {k} {unit}" for k, v in sorted(result[key]["up_to"].items(), key=lambda x: int(x[0]))
        )
        worst, number = result[key]["worst"]
        lines += [f"{what}, processor time: {parts}; worst {worst:.0f} {unit} (arm {number}).", ""]
    told = [n for n in result["notable"] if n.get("refused") or n.get("failed")]
    if told:
        lines += ["Arms without a plan, or that raised, with their rank as the oracle's Jacobian has it:", ""]
        rows = []
        for n in told:
            said = n.get("refused") or n["failed"]
            true = "-" if "rank" not in n or "depend on each other" not in said else "yes" if n["rank"] < 6 else "no"
            rows.append((n["number"], n["kind"], n["types"], n.get("rank", "-"), said, true))
        lines += table(("arm", "kind", "joints", "rank", "what is said", "true"), rows)
    lost = [n for n in result["notable"] if n["missed"] or n.get("odd_poses") or n["uncertain"]]
    rows = [
        (
            n["number"],
            n["kind"],
            n["types"],
            n["rank"],
            n["family"],
            n["missed"],
            n["uncertain"],
            len(n.get("odd_poses", ())),
        )
        for n in lost
    ]
    if rows:
        lines += ["Arms with a loss, an unexplained odd count or an uncertain pose:", ""]
        lines += table(("arm", "kind", "joints", "rank", "family", "missed", "uncertain", "odd unexplained"), rows)
    return lines


def others(result: dict) -> list[str]:
    """Shorter and longer arms."""
    keys = ("arms", "poses", "solutions", "missing", "generating_missed", "extra", "unseen", "on_self_motions")
    keys += ("uncertain", "refused", "failed")
    rows = [(name, *(row[key] for key in keys)) for name, row in sorted(result["rows"].items())]
    head = ("joints, task", *(key.replace("_", " ").replace("self m", "self-m") for key in keys))
    return [
        *OTHERS.split("\n"),
        *table(head, rows),
    ]


def hard(result: dict) -> list[str]:
    """Arms that are nearly special."""
    keys = ("poses", "missed", "found_within_rounding", "odd", "uncertain", "singular", "missing", "unseen", "failed")
    rows = []
    for name, row in result["rows"].items():
        recall = f"{1 - row['missed'] / row['poses']:.5f}" if row["poses"] else "-"
        rows.append((name, *(row[key] for key in keys), recall, f"{row['worst']:.1e}"))
    return [
        *HARD.format(**result).split("\n"),
        *table(("change", *(key.replace("_", " ") for key in keys), "recall", "worst residual"), rows),
    ]


def known() -> list[str]:
    """What is lost and known to be."""
    cases = json.loads(CASES.read_text())
    open_ones = [c for c in cases if c["open"]]
    lines = KNOWN.format(cases=len(cases), open=len(open_ones)).split("\n")
    if open_ones:
        lines += table(("case", "joints", "what is wrong"), [(c["name"], c["types"], c["open"]) for c in open_ones])
    return lines


def page() -> str:
    """Return the page."""
    lines = INTRO.split("\n")
    parts = {"completeness": searched, "followed_roots": followed, "random_arms": at_random}
    parts |= {"other_arms": others, "hard_arms": hard}
    for name, part in parts.items():
        result = read(name)
        lines += part(result) if result else [f"`benchmarks/measure/{name}.py` has not been run.", ""]
        if result:
            lines += [f"Measured at commit {result.get('commit', 'unknown')}.", ""]
    lines += known()
    return "\n".join(lines).rstrip() + "\n"
