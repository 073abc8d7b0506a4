"""More of the workbench measured in the page: a long path, a big table, the report, playback, meshes."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]

#: Moves the first slider for 2.5 s as fast as pictures come, and counts them.
SLIDE = """
() => new Promise((done) => {
  const s = document.querySelector('[data-testid=slider-1]');
  const began = performance.now(), before = workbench.pictures;
  let k = 0;
  (function go() {
    s.value = String(Math.sin(k++ / 20));
    s.dispatchEvent(new Event('input', { bubbles: true }));
    const spent = (performance.now() - began) / 1000;
    if (spent < 2.5) requestAnimationFrame(go);
    else done((workbench.pictures - before) / spent);
  })();
})
"""
#: Bytes of the meshes that the arm of meshes has, over its seven links.
MESH_BYTES = 20e6


def seconds_until(page: Any, until: Callable[[Any, str], None], act: Callable[[], None], condition: str) -> float:
    """Return the seconds from an act to a condition."""
    began = time.perf_counter()
    act()
    until(page, condition)
    return time.perf_counter() - began


def measure_path(page: Any, until: Callable[[Any, str], None]) -> dict[str, float]:
    """A line of 1,000 points planned and shown."""
    page.get_by_test_id("catalog").select_option("denso-vp6242")
    until(page, "workbench.table.name === 'denso-vp6242'")
    page.get_by_role("tab", name="Path", exact=True).click()
    for key, p in (("from", (350, 0, 400)), ("to", (200, 100, 500))):
        for i, value in enumerate((*p, 0, 0, 0)):
            page.get_by_test_id(f"path-{key}-{i}").fill(str(value))
    page.get_by_test_id("path-n").fill("1000")
    plan = page.get_by_test_id("plan")
    return {"seconds": seconds_until(page, until, plan.click, "workbench.motion && workbench.motion.q.length === 1000")}


def measure_playback(browser: Any, opened: Callable[..., Any], url: str, until: Callable[[Any, str], None]) -> dict:
    """Pictures a second while that path plays on a screen of 1920 pixels."""
    page = opened(browser, url)
    page.set_viewport_size({"width": 1920, "height": 1080})
    measure_path(page, until)
    page.wait_for_timeout(800)
    before, began = page.evaluate("() => workbench.pictures"), time.perf_counter()
    page.get_by_test_id("play").click()
    page.wait_for_timeout(4000)
    drawn = page.evaluate("() => workbench.pictures") - before
    spent = time.perf_counter() - began
    page.context.close()
    return {"pictures": drawn / spent}


def measure_table(page: Any, until: Callable[[Any, str], None]) -> dict[str, float]:
    """The 30th joint added to a table of 29."""
    page.get_by_role("tab", name="DH table", exact=True).click()
    page.get_by_role("button", name="Blank", exact=True).click()
    add = page.get_by_test_id("add-joint")
    for k in range(29):
        add.click()
        until(page, f"workbench.table.joints.length === {k + 1}")
    page.wait_for_timeout(1500)
    # one joint more, its row on the screen and a picture of it
    drawn = page.evaluate("() => workbench.pictures")
    condition = f"workbench.table.joints.length === 30 && workbench.pictures > {drawn}"
    return {"seconds": seconds_until(page, until, add.click, condition)}


def measure_report(page: Any) -> dict[str, float]:
    """The report written and handed over."""
    page.get_by_role("tab", name="Share", exact=True).click()
    began = time.perf_counter()
    with page.expect_download(timeout=120_000):
        page.get_by_test_id("report").click()
    return {"seconds": time.perf_counter() - began}


def measure_mesh(opened: Callable[..., Any], browser: Any, served: Any, until: Callable[[Any, str], None]) -> dict:
    """An arm of 20 MB of meshes: seconds to the last of them drawn, and pictures a second while a joint moves."""
    page = opened(browser, served.url)
    ready = page.evaluate("() => window.watch.ready") / 1000
    began = time.perf_counter()
    until(page, "workbench.looks.shapes === 7 && workbench.looks.loading === 0")
    meshes = time.perf_counter() - began
    page.get_by_role("tab", name="Move", exact=True).click()
    page.wait_for_timeout(800)
    found = {"seconds": ready + meshes, "pictures": page.evaluate(SLIDE)}
    page.get_by_test_id("look").get_by_text("Sketch").click()
    page.wait_for_timeout(800)
    found["sketch_pictures"] = page.evaluate(SLIDE)
    page.context.close()
    return found


def mesh_arm(size: float = MESH_BYTES) -> str:
    """Write a six-joint URDF with seven round links of so many bytes of binary STL, and return its path."""
    folder = Path(tempfile.mkdtemp(prefix="pieper-meshes-"))
    n = int(np.sqrt(size / 7 / 50 / 2 / 2.2))
    sizes = [(140, 120, 250), (100, 90, 300), (90, 75, 500), (75, 60, 250), (60, 50, 350), (50, 45, 150), (45, 35, 100)]
    links, joints = [], []
    for i, (r0, r1, h) in enumerate(sizes):
        rows = np.zeros(2 * n * int(2.2 * n), dtype=[("n", "<f4", 3), ("c", "<f4", (3, 3)), ("r", "<u2")])
        rows["c"] = _barrel(r0 / 1e3, r1 / 1e3, h / 1e3, n, int(2.2 * n))
        (folder / f"l{i}.stl").write_bytes(b"\0" * 80 + np.uint32(len(rows)).tobytes() + rows.tobytes())
        links.append(f'<link name="l{i}"><visual><geometry><mesh filename="l{i}.stl"/></geometry></visual></link>')
    for i, (z, axis) in enumerate(zip((0.2, 0.28, 0.48, 0.22, 0.32, 0.13), "zyyzyz", strict=True)):
        about = " ".join(str(int(axis == a)) for a in "xyz")
        joints.append(
            f'<joint name="j{i + 1}" type="revolute"><parent link="l{i}"/><child link="l{i + 1}"/>'
            f'<origin xyz="0 0 {z}"/><axis xyz="{about}"/>'
            '<limit lower="-2.8" upper="2.8" effort="1" velocity="1"/></joint>'
        )
    file = folder / "arm.urdf"
    file.write_text(f'<robot name="mesh-arm">{"".join(links + joints)}</robot>')
    return str(file)


def _barrel(r0: float, r1: float, h: float, n: int, m: int) -> Array:
    """Return the triangles (2 n m, 3, 3) of a closed, slightly rippled surface of revolution along z."""
    u, v = np.linspace(0, 2 * np.pi, n + 1), np.linspace(0, 1, m + 1)
    ends = np.sqrt(np.clip(1 - (2 * np.clip(np.abs(v - 0.5) - 0.42, 0, 1) / 0.16) ** 2, 0, 1))
    r = (r0 + (r1 - r0) * v) * ends * (1 + 0.03 * np.cos(14 * np.pi * v))
    P = np.stack([np.outer(r, np.cos(u)), np.outer(r, np.sin(u)), np.outer(h * v, np.ones(n + 1))], -1)
    a, b, c, d = P[:-1, :-1], P[:-1, 1:], P[1:, 1:], P[1:, :-1]
    return np.concatenate([np.stack(t, 2).reshape(-1, 3, 3) for t in ((a, b, c), (a, c, d))])
