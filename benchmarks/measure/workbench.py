"""Measure the workbench as a person meets it: a real server, a real Chromium with software WebGL, a table of medians.

Usage: python -m benchmarks.measure.workbench [--repeats 40] [--loads 7] [--only joint gizmo load ...] [--out FILE]

The machine is measured in the same run (a loop in the page's JavaScript, a loop in Python, the load average), because
other work on it slows everything here alike: judge the numbers beside those loops. Needs Playwright and a Chromium, as
the browser stories do; CHROMIUM may name the executable.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import statistics
import subprocess
import sys
import tempfile
import time
import urllib.request
from pathlib import Path

import numpy as np

import pieper
from benchmarks.kept import RESULTS
from benchmarks.measure import workbench_parts as parts_of
from benchmarks.measure.probes import GIZMO, JOINT, WATCH
from benchmarks.measure.workbench_people import measure_fuzz, measure_people, spread
from benchmarks.pages.workbench_measured import TARGETS, rows_of
from oracle.browser import FLAGS, chromium, free_port

#: A spherical-wrist arm and a pose of it with eight solutions, degrees.
DRAGGED, POSTURE = "unimation-puma-560", (20, -40, 30, 20, 50, 30)
SIZE = {"width": 1280, "height": 800}


class Served:
    """`pieper workbench` as a process of its own, as a person starts it."""

    def __init__(self, arm: str | None = None) -> None:
        self.arm = arm
        self.port = free_port()
        self.url = f"http://localhost:{self.port}/"
        self.said = Path(tempfile.mkdtemp(prefix="pieper-workbench-")) / "said"
        self.seconds = self.start()

    def start(self) -> float:
        """Start it and return the seconds until it answers."""
        began = time.perf_counter()
        command = [sys.executable, "-m", "pieper", "workbench", *([self.arm] if self.arm else [])]
        command += ["--no-browser", "--port", str(self.port)]
        with self.said.open("ab") as said:
            self.process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=said)
        while True:
            try:
                urllib.request.urlopen(self.url, timeout=5).read()
                return time.perf_counter() - began
            except OSError:
                if self.process.poll() is not None or time.perf_counter() - began > 60:
                    raise SystemExit("the workbench did not start") from None
                time.sleep(0.005)

    def tracebacks(self) -> int:
        """Return how many tracebacks the server has written."""
        return self.said.read_text(errors="replace").count("Traceback")

    def stop(self) -> None:
        self.process.terminate()
        self.process.wait(10)


def python_loop() -> float:
    """Return the milliseconds of a fixed loop in Python."""
    began, x = time.perf_counter(), 0
    for i in range(1_000_000):
        x = (x * 1664525 + i) & 0xFFFFFFFF
    return 1e3 * (time.perf_counter() - began)


def processor_ms() -> dict[str, float]:
    """Return the processor time that this benchmark's processes have used, by what they do; zeros but on Linux."""
    children: dict[int, list[tuple[int, float, str]]] = {}
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            words = (folder / "stat").read_text().rpartition(")")[2].split()
            command = (folder / "cmdline").read_text()
        except OSError:
            continue
        spent = (int(words[11]) + int(words[12])) * 1e3 / os.sysconf("SC_CLK_TCK")
        children.setdefault(int(words[1]), []).append((int(folder.name), spent, command))
    spent_by = {"drawing": 0.0, "page": 0.0, "server": 0.0, "rest of the browser": 0.0}
    parts = {"type=gpu-process": "drawing", "type=renderer": "page", "pieper\0workbench": "server"}
    waiting = [os.getpid()]
    while waiting:
        for number, spent, command in children.get(waiting.pop(), []):
            waiting.append(number)
            spent_by[next((name for sign, name in parts.items() if sign in command), "rest of the browser")] += spent
    return spent_by


def opened(browser, url: str):
    """Return a page of its own context, hence with an empty cache, that is ready for use."""
    page = browser.new_context(viewport=SIZE, reduced_motion="reduce").new_page()
    page.set_default_timeout(60_000)
    page.add_init_script(WATCH)
    page.goto(url)
    until(page, "window.watch.ready !== null")
    return page


def until(page, condition: str) -> None:
    """Wait for a condition, asked from outside: the page's policy forbids it to evaluate text itself."""
    end = time.monotonic() + 60
    while not page.evaluate(f"() => Boolean({condition})"):
        if time.monotonic() > end:
            raise SystemExit(f"still not so after a minute: {condition}")
        page.wait_for_timeout(20)


def measure_joint(page, repeats: int) -> dict:
    """From a key on a slider to the number in the matrix and to the picture."""
    page.get_by_role("tab", name="Move", exact=True).click()
    page.get_by_test_id("slider-2").focus()
    page.evaluate(JOINT)
    for k in range(repeats):
        page.keyboard.press("ArrowRight" if k % 2 else "ArrowLeft")
        page.wait_for_timeout(120)
    heard = page.evaluate("() => window.heard")
    return {"number_ms": spread(heard["number"]), "picture_ms": spread(heard["picture"])}


def measure_gizmo(page, seconds: float) -> dict:
    """Solved and drawn updates a second while the mouse drags the target with all ghosts shown."""
    page.get_by_test_id("catalog").select_option(DRAGGED)
    until(page, f"workbench.table.name === '{DRAGGED}'")
    page.get_by_role("tab", name="Move", exact=True).click()
    for i, value in enumerate(POSTURE):
        field = page.get_by_test_id(f"q-{i + 1}")
        field.fill(str(value))
        field.press("Enter")
    page.get_by_role("tab", name="Inverse", exact=True).click()
    until(page, "workbench.ghosts === 7")
    page.wait_for_timeout(800)
    x, y = page.evaluate("() => workbench.toScreen([3, 7, 11].map((i) => workbench.target[i]))")
    page.mouse.move(x, y)
    page.mouse.down()
    rounds = []
    for _ in range(3):
        page.evaluate(GIZMO)
        spent, began, moves = processor_ms(), time.perf_counter(), 0
        while (now := time.perf_counter() - began) < seconds:
            turn = 2 * np.pi * now / 2.5
            page.mouse.move(x + 24 * np.sin(turn), y - 16 * np.sin(2 * turn))
            moves += 1
        found = page.evaluate("() => window.seen.stop()")
        each = {k: (v - spent[k]) / max(len(found["gaps"]), 1) for k, v in processor_ms().items()}
        rounds.append({**found, "moves": moves / seconds, "processor_ms": each})
    page.mouse.up()
    gaps = [gap for r in rounds for gap in r.pop("gaps")]
    costs = [r.pop("processor_ms") for r in rounds]
    middle = {key: statistics.median(r[key] for r in rounds) for key in rounds[0]}
    cost = {key: statistics.median(c[key] for c in costs) for key in costs[0]}
    return {**middle, "gap_ms": spread(gaps), "processor_ms": cost, "rounds": rounds}


def measure_loads(browser, url: str, loads: int) -> dict:
    """First loads with an empty cache: milliseconds to a usable page, and what was sent for it."""
    ready, parts, sent = [], [], 0
    for _ in range(loads):
        page = opened(browser, url)
        ready.append(page.evaluate("() => window.watch.ready") / 1000)
        entries = page.evaluate(
            "() => [...performance.getEntriesByType('navigation'), ...performance.getEntriesByType('resource')]"
            ".map((e) => [e.name.split('/').pop() || 'page', e.startTime, e.responseEnd, e.transferSize])"
        )
        parts, sent = entries, sum(entry[3] for entry in entries)
        page.context.close()
    shipped = sum(
        p.stat().st_size for p in (Path(pieper.__file__).parent / "workbench/page/dist").rglob("*") if p.is_file()
    )
    return {"seconds": spread(ready), "sent_MB": sent / 1e6, "shipped_MB": shipped / 1e6, "requests": parts}


def measure_idle(page) -> dict:
    """Pictures drawn in three seconds in which nothing changes."""
    page.wait_for_timeout(1500)
    before = page.evaluate("() => workbench.pictures")
    page.wait_for_timeout(3000)
    return {"pictures": page.evaluate("() => workbench.pictures") - before}


def measure_restart(page, served: Served) -> dict:
    """The server stopped and started again under an open page: what is lost, and seconds until it answers again."""
    table, q = page.evaluate("() => [workbench.table, workbench.q]")
    served.stop()
    until(page, "document.querySelector('[data-testid=online]').textContent !== ''")
    began = time.perf_counter()
    started = served.start()
    until(page, "document.querySelector('[data-testid=online]').textContent === ''")
    back = time.perf_counter() - began
    return {
        "same": page.evaluate("() => [workbench.table, workbench.q]") == [table, q],
        "server_start_s": started,
        "back_s": back,
    }


def machine(page) -> dict:
    """The fixed loops, best and median of five, and the load average."""
    return {
        "page_loop_ms": spread([page.evaluate("() => window.fixedWork()[0]") for _ in range(5)]),
        "python_loop_ms": spread([python_loop() for _ in range(5)]),
        "load_average": os.getloadavg()[0],
    }


def table_of(results: dict) -> str:
    """Return the results beside their targets."""
    return "\n".join(f"{name:48} {value:>22}   {TARGETS.get(name, '')}".rstrip() for name, value in rows_of(results))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    browsed = ("joint", "gizmo", "load", "idle", "restart", "path", "table", "report", "playback", "mesh")
    parts = (*browsed, "people", "programs", "fuzz")
    parser.add_argument("--repeats", type=int, default=40, help="keys pressed on a slider")
    parser.add_argument("--loads", type=int, default=7, help="first loads")
    parser.add_argument("--seconds", type=float, default=4.0, help="of each of three drags")
    parser.add_argument("--updates", type=int, default=60, help="of each of fifty sessions")
    parser.add_argument("--programs", type=int, default=2, help="that each of fifty sessions plans meanwhile")
    parser.add_argument("--messages", type=int, default=10_000, help="of the fuzz")
    parser.add_argument("--only", nargs="+", choices=parts, default=parts)
    parser.add_argument("--out", type=Path, default=RESULTS / "workbench.json")
    given = parser.parse_args()
    served = Served()
    results: dict = {"python": platform.python_version(), "cores": os.cpu_count(), "server_start_s": served.seconds}
    try:
        if set(browsed) & set(given.only):
            measure_in_browser(served, given, results)
        # after the browser has gone: the fifty share the two cores with nobody
        if "people" in given.only:
            results["people"] = measure_people(served.port, given.updates, 0)
        if "programs" in given.only:
            results["programs"] = measure_people(served.port, given.updates, given.programs)
        if "fuzz" in given.only:
            results["fuzz"] = measure_fuzz(served.port, given.messages) | {"tracebacks": served.tracebacks()}
    finally:
        served.stop()
    results.setdefault("machine", {"python_loop_ms": spread([python_loop() for _ in range(5)])})
    results["machine"]["load_average"] = os.getloadavg()[0]
    for part in set(parts) & set(results):
        results[part]["load_average"] = results["machine"]["load_average"]
    kept = json.loads(given.out.read_text()) if given.out.exists() else {}
    given.out.write_text(json.dumps(kept | results, indent=1) + "\n")
    print(table_of(results))


def measure_in_browser(served: Served, given: argparse.Namespace, results: dict) -> None:
    """Measure what needs a page, in one browser."""
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium(), args=FLAGS)
        results["chromium"] = browser.version
        if "load" in given.only:
            results["load"] = measure_loads(browser, served.url, given.loads)
        page = opened(browser, served.url)
        results["machine"] = machine(page)
        if "joint" in given.only:
            results["joint"] = measure_joint(page, given.repeats)
        if "gizmo" in given.only:
            results["gizmo"] = measure_gizmo(page, given.seconds)
        if "idle" in given.only:
            results["idle"] = measure_idle(page)
        if "path" in given.only:
            results["path"] = parts_of.measure_path(page, until)
        if "report" in given.only:
            results["report"] = parts_of.measure_report(page)
        if "table" in given.only:
            results["table"] = parts_of.measure_table(page, until)
        if "playback" in given.only:
            results["playback"] = parts_of.measure_playback(browser, opened, served.url, until)
        if "mesh" in given.only:
            meshes = Served(parts_of.mesh_arm())
            results["mesh"] = parts_of.measure_mesh(opened, browser, meshes, until)
            meshes.stop()
        if "restart" in given.only:
            results["restart"] = measure_restart(page, served)
        browser.close()


if __name__ == "__main__":
    main()
