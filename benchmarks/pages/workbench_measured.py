"""Write docs/workbench_measured.md: the workbench as a person meets it, beside what was asked of it."""

from __future__ import annotations

from typing import Any

from benchmarks.kept import read

HEAD = """\
# The workbench measured

A server as a process of its own, a headless Chromium that draws WebGL in software, then fifty sessions at once and
messages of every kind, over half of them broken. Measured by `python -m benchmarks.measure.workbench`, one part again
by `--only PART`; written by `make pages`. The machine is measured in the same run (two fixed loops, the load): other
work on it slows everything here alike.

"""
#: What the measurements are held against.
TARGETS = {
    "slider to number, ms": "<= 5",
    "slider to picture, ms": "<= 35",
    "gizmo updates a second": ">= 30",
    "first load, s": "< 1.5",
    "shipped, MB": "< 3",
    "1,000-point path, s": "<= 0.5",
    "30th joint, s": "<= 0.3",
    "report, s": "<= 4",
    "playback at 1920 px, pictures a second": ">= 20",
    "20 MB of meshes drawn after, s": "<= 3",
    "  pictures a second as a joint moves": ">= 30",
    "pictures while nothing changes": "0",
    "messages lost": "0",
    "answers for another arm": "0",
    "faults, tracebacks, connections lost": "0, 0, 0",
    "restart: nothing lost": "yes",
}
Row = tuple[str, str]


def alone(results: dict[str, Any]) -> list[Row]:
    """Return what one person's page was measured to do, as names and values."""
    rows: list[Row] = []
    if "joint" in results:
        rows += [(f"slider to {k}, ms", f"{results['joint'][f'{k}_ms']['median']:.1f}") for k in ("number", "picture")]
    if "gizmo" in results:
        g = results["gizmo"]
        rows += [("gizmo updates a second", f"{g['updates']:.0f}"), ("  ghosts shown", f"{g['ghosts']:.0f}")]
        rows += [("  between updates, ms", f"{g['gap_ms']['median']:.0f} (95 %: {g['gap_ms']['p95']:.0f})")]
        rows += [(f"  processor, ms an update: {k}", f"{v:.1f}") for k, v in g["processor_ms"].items()]
    if "load" in results:
        s = results["load"]["seconds"]
        rows += [("first load, s", f"{s['median']:.2f} (best {s['best']:.2f})")]
        rows += [("  sent for it, MB", f"{results['load']['sent_MB']:.2f}")]
        rows += [("shipped, MB", f"{results['load']['shipped_MB']:.2f}")]
    if "idle" in results:
        rows += [("pictures while nothing changes", str(results["idle"]["pictures"]))]
    for part, name in (("path", "1,000-point path, s"), ("table", "30th joint, s"), ("report", "report, s")):
        if part in results:
            rows.append((name, f"{results[part]['seconds']:.2f}"))
    if "playback" in results:
        rows.append(("playback at 1920 px, pictures a second", f"{results['playback']['pictures']:.0f}"))
    if "mesh" in results:
        mesh = results["mesh"]
        rows.append(("20 MB of meshes drawn after, s", f"{mesh['seconds']:.2f}"))
        rows.append(("  pictures a second as a joint moves", f"{mesh['pictures']:.0f}"))
        rows.append(("  of the sketch, in the same page", f"{mesh['sketch_pictures']:.0f}"))
    return rows


def together(results: dict[str, Any]) -> list[Row]:
    """Return what many sessions, broken messages and a restart were measured to do."""
    rows: list[Row] = []
    for part in ("people", "programs"):
        if part in results:
            p = results[part]
            rows += [(f"{p['sessions']} sessions, {p['messages']} messages, {p['programs']} programs", "")]
            rows += [("messages lost", str(p["lost"])), ("answers for another arm", str(p["foreign"]))]
            rows += [("  latency, ms", f"{p['latency_ms']['median']:.1f} (95 %: {p['latency_ms']['p95']:.1f})")]
            if "program_ms" in p:
                rows += [("  a program, ms", f"{p['program_ms']['median']:.0f} (95 %: {p['program_ms']['p95']:.0f})")]
    if "fuzz" in results:
        f = results["fuzz"]
        broken = f"{len(f['faults'])}, {f['tracebacks']}, {f['connections_lost']}"
        rows += [(f"fuzz: {f['messages'] + f['not_json_or_binary']} messages", f"{f['refused']} refused")]
        rows += [("messages lost", str(f["lost"])), ("answers for another arm", str(len(f["foreign"])))]
        rows += [("faults, tracebacks, connections lost", broken)]
    if "restart" in results:
        r = results["restart"]
        rows += [("restart: nothing lost", "yes" if r["same"] else "NO"), ("  back after, s", f"{r['back_s']:.2f}")]
        rows += [("  server start, s", f"{r['server_start_s']:.2f}")]
    return rows


def machine(results: dict[str, Any]) -> list[Row]:
    """Return what the machine was measured to do."""
    rows: list[Row] = []
    for key, place in (("page_loop_ms", "the page"), ("python_loop_ms", "Python")):
        if key in (m := results["machine"]):
            rows += [(f"machine: loop in {place}, ms", f"{m[key]['median']:.0f} (best {m[key]['best']:.0f})")]
    load = f"{results['machine']['load_average']:.1f}, {results['cores']}"
    return [*rows, ("machine: load average, cores", load)]


def rows_of(results: dict[str, Any]) -> list[Row]:
    """Return everything measured, as names (those below another begin with spaces) and values."""
    return [*alone(results), *together(results), *machine(results)]


def table(results: dict[str, Any]) -> str:
    """Return the results as a Markdown table beside their targets."""
    rows = [f"| {name.strip()} | {value} | {TARGETS.get(name, '')} |" for name, value in rows_of(results)]
    return "\n".join(["| | measured | asked |", "|---|---|---|", *rows]) + "\n"


def page() -> str:
    """Return the page as Markdown."""
    results = read("workbench")
    return HEAD + (table(results) if results else "Nothing has been measured yet.\n")
