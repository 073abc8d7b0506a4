"""Every panel, filled, in both themes, before the accessibility rules of axe (Deque): no violation."""

from __future__ import annotations

from pathlib import Path

import pytest

import pieper

PAGE = Path(pieper.__file__).parent / "workbench" / "page"
#: It is the page's development that needs axe, not its users: there where the page was built, or beside the sources.
PLACES = [PAGE, Path(__file__).resolve().parents[2] / "src" / "pieper" / "workbench" / "page"]
SCRIPT = next((p for root in PLACES if (p := root / "node_modules" / "axe-core" / "axe.min.js").exists()), None)


def inverse(bench) -> None:
    bench.answered(2)


def world(bench) -> None:
    bench.page.get_by_test_id("add-object-box").click()


def path(bench) -> None:
    bench.page.get_by_test_id("plan").click()
    bench.page.get_by_test_id("path-verdict").wait_for()


def route(bench) -> None:
    page = bench.page
    page.get_by_test_id("panel-route").locator("summary").nth(1).click()
    bench.fill("route-to-1", 100)
    page.get_by_test_id("find-route").click()
    page.get_by_test_id("route-verdict").wait_for()


def program(bench) -> None:
    for kind in ("joint", "frame", "line", "circle", "spline", "wait", "gripper", "output", "call"):
        bench.page.get_by_test_id(f"step-add-{kind}").click()
    bench.page.get_by_test_id("step-4").click()
    bench.page.get_by_test_id("run-program").click()
    bench.page.get_by_test_id("program-verdict").wait_for()


def sequence(bench) -> None:
    bench.page.get_by_test_id("add-posture").click()


RUN = "axe.run(%s, {resultTypes: ['violations']}).then((r) => r.violations)"

PANELS = {
    "Move": None,
    "Inverse": inverse,
    "DH table": None,
    "World": world,
    "Path": path,
    "Route": route,
    "Program": program,
    "Sequence": sequence,
    "Matrices": None,
    "Equations": None,
    "Analysis": None,
    "Share": None,
}


@pytest.mark.skipif(SCRIPT is None, reason="axe is not here: npm ci in the page's folder")
@pytest.mark.parametrize("dark", [False, True], ids=["light", "dark"])
def test_axe_finds_no_violation_in_any_panel(people, dark):
    assert SCRIPT is not None
    bench = people(dark=dark).open()
    bench.page.evaluate(SCRIPT.read_text())
    found: dict[str, list[str]] = {}
    for name, fill in PANELS.items():
        bench.tab(name)
        if fill is not None:
            fill(bench)
        bench.rest()
        # the page around the panels is looked at once, with the curves under the picture
        where = "document" if name == "Sequence" else "document.getElementById('panels')"
        for rule in bench.value(RUN % where):
            places = "; ".join(n["html"][:140] for n in rule["nodes"][:3])
            found.setdefault(f"{rule['id']}: {rule['help']}", []).append(f"{name}: {places}")
    assert not found, "\n".join(f"{rule}\n  " + "\n  ".join(where) for rule, where in found.items())
