"""Write docs/benchmarks.md from benchmarks/results/speed.json: the measurements as ratios."""

from __future__ import annotations

from benchmarks.kept import read

#: Ours once more, without the wide registers.
BASELINE = "pieper-baseline"
#: What the columns of ours are.
WHAT = [
    "New arrays for each answer, then arrays that are kept (`out=`), these again out of reach, and on two",
    "threads; then the same processor without its wide registers (`PIEPER_ISA=baseline`). One thread's work is",
    "in processor time; what two threads gain is not told where others had the processor too.",
    "",
]


def ratio(theirs: float | None, ours: float | None) -> str:
    """Return how many times faster ours is, or a dash."""
    return f"{theirs / ours:.1f}" if theirs and ours else "-"


def number(value: float | None) -> str:
    """Return a number, or a dash where it was not measured."""
    return f"{value:.4g}" if value else "-"


def page() -> str:
    """Return the page."""
    result = read("speed")
    measured = {(m["arm"], m["contestant"]): m for m in result["measured"]}
    arms = list(dict.fromkeys(m["arm"] for m in result["measured"]))
    peers = sorted({m["contestant"] for m in result["measured"]} - {"pieper", BASELINE})
    lines = [
        "# Benchmarks",
        "",
        "Written by `make pages` from `benchmarks/results/speed.json`, which `make bench` measures: every contestant",
        "in its own environment and process, rounds interleaved, the best of them counted. Absolute times",
        "are of one shared machine; the ratios are the result.",
        "",
        f"Commit {result['commit']}, {result['cpu']}, instruction set {result['instruction_set']}, "
        f"Python {result['python']}, NumPy {result['numpy']}.",
        "",
        *([result["remeasured"], ""] if "remeasured" in result else []),
        "## Speed, one thread",
        "",
        *(WHAT if "shared" in result else []),
        "| arm | one pose, us | batch, ns a pose | kept arrays | out of reach | two threads | baseline: one pose | "
        "baseline: batch | "
        + " | ".join(f"one pose: times faster than {p}" for p in peers)
        + " | "
        + " | ".join(f"batch: times faster than {p}" for p in peers)
        + " |",
        "|---|---|---|---|---|---|---|---|" + "---|" * (2 * len(peers)),
    ]
    for arm in arms:
        ours = measured.get((arm, "pieper"), {})
        if "single_us" not in ours:
            continue
        theirs = [measured.get((arm, p), {}) for p in peers]
        cells = [
            ratio(t.get("single_us"), ours["single_us"]) if "unsupported" not in t else "not taken" for t in theirs
        ]
        cells += [
            ratio(t.get("batch_ns_1"), ours["batch_ns_1"]) if "unsupported" not in t else "not taken" for t in theirs
        ]
        plain = measured.get((arm, BASELINE), {})
        own = [
            f"{ours['single_us']:.3g}",
            f"{ours['batch_ns_1']:.4g}",
            number(ours.get("into_ns_1")),
            number(ours.get("away_ns")),
            "not told" if result.get("shared") else f"{ours['batch_ns_1'] / ours['batch_ns_2']:.2f} times",
            number(plain.get("single_us")),
            number(plain.get("into_ns_1")),
        ]
        lines.append(f"| {arm} | " + " | ".join([*own, *cells]) + " |")
    best = [m for m in result["measured"] if m["contestant"] == "pieper" and "fk_per_s" in m]
    lines += [
        "",
        f"Forward kinematics: {max(m['fk_per_s'] for m in best) / 1e6:.1f} million a second at best; Jacobians: "
        f"{max(m['jacobian_per_s'] for m in best) / 1e6:.1f} million a second.",
        "",
        "## Recall",
        "",
        "Generating joint vectors, uniform over the whole turn, not found again within 1e-6 rad; poses with an odd",
        "number of solutions; poses marked uncertain; worst residual over the first 50,000 poses; at commit "
        f"{result.get('recalled_at', result['commit'])}.",
        "",
        "| arm | family | poses | missed | odd | uncertain | worst, m | worst, rad | us a pose |",
        "|---|---|---|---|---|---|---|---|---|",
    ]
    for r in result["recall"]:
        lines.append(
            f"| {r['arm']} | {r['family']} | {r['poses']} | {r['missed']} | {r['odd']} | {r['uncertain']} | "
            f"{r['worst_m']:.2g} | {r['worst_rad']:.2g} | {r['us_a_pose']:.3g} |"
        )
    start = result["start_up"]
    lines += [
        "",
        "## Start-up",
        "",
        f"`import pieper` beyond NumPy: {start['import_beyond_numpy_ms']:.0f} ms. "
        f"Installed size: {start['installed_mb']:.1f} MB. "
        + (f"`pieper ik` as a whole process: {start['cli_ik_s']:.2f} s." if "cli_ik_s" in start else ""),
    ]
    return "\n".join(lines) + "\n"
