"""What is seen in the picture: names, ghosts by their limits, maps, sizes of letters and windows; a finger on it."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

import pieper
from tests.browser.conftest import Workbench

OUTER = "(() => { const r = document.querySelector('%s').getBoundingClientRect(); return [r.right, r.bottom]; })()"
VIEWS = ("Iso", "Front", "Side", "Top")


def overlapping(bench: Workbench) -> list[tuple[str, str]]:
    """Return the pairs of names of which one lies over the other."""
    shown = [(name["text"], name["box"]) for name in bench.value("workbench.labels") if name["box"]]
    return [
        (a, b)
        for (a, A), (b, B) in itertools.combinations(shown, 2)
        if min(A[2], B[2]) > max(A[0], B[0]) and min(A[3], B[3]) > max(A[1], B[1])
    ]


def test_names_stand_beside_what_they_name_and_never_over_each_other(bench):
    bench.page.get_by_role("button", name="All frames or none").click()
    for view, posture in itertools.product(VIEWS, ([-22, 71, -184, -5, -34, 5], [0, 90, -180, 0, 0, 0])):
        bench.joints(posture)
        bench.button(view)
        bench.settle()
        names = bench.value("workbench.labels")
        assert [name["text"] for name in names] == ["base", *"123456", "tool"]
        assert overlapping(bench) == []
        for name in names:
            middle = np.reshape(name["box"], (2, 2)).mean(0)
            assert np.linalg.norm(middle - name["point"]) < 70, "no further than a few letters from what it names"
    bench.shot("names", both=True)


@pytest.mark.parametrize(("name", "inside"), [("denso-vp6242", 1), ("universal-robots-ur5e", 8)])
def test_ghosts_are_outlined_by_whether_they_lie_inside_the_limits(bench, name, inside):
    bench.arm(name)
    bench.joints([-22, 71, -184, -5, -34, 5] if inside == 1 else [20, -60, 80, -50, 40, 30])
    bench.tab("Inverse")
    bench.until("workbench.ghosts === 7")
    assert sum(r["inside"] for r in bench.value("workbench.solutions.rows")) == inside
    assert bench.value("workbench.ghostsOutside") == 8 - inside, "the arm itself stands in one that is inside"
    bench.shot(f"ghosts-{inside}-inside", both=True)
    bench.page.get_by_role("group", name="Ghosts").get_by_role("button", name="In limits").click()
    bench.until(f"workbench.ghosts === {inside - 1}")
    assert bench.value("workbench.ghostsOutside") == 0


def test_a_map_of_voxels_is_drawn_cut_and_coloured(bench):
    bench.tab("Analysis")
    page = bench.page
    page.get_by_test_id("reach-kind").get_by_role("button", name="Map").click()
    page.get_by_test_id("reach-size").select_option("coarse")
    page.get_by_test_id("reach-start").click()
    page.get_by_text("voxels of").wait_for()
    assert f"{bench.value('workbench.voxels'):,} voxels" in bench.text("reach-note")
    whole = bench.value("workbench.voxels")
    assert whole > 200
    page.get_by_test_id("reach-cut").get_by_role("button", name="Cut open").click()
    page.get_by_test_id("reach-cut-at").focus()
    bench.shot("map-cut", both=True)
    page.get_by_test_id("reach-colour").select_option("manipulability")
    page.get_by_test_id("reach-start").click()
    page.get_by_text("coloured by best manipulability").wait_for()
    assert bench.value("workbench.voxels") == whole
    bench.arm("abb-irb120")
    assert bench.value("workbench.voxels") == 0, "another arm reaches elsewhere"


def test_manipulability_is_the_same_measure_live_and_in_the_library_and_scales_are_in_the_units_of_the_page(bench):
    page = bench.page
    bench.tab("Analysis")
    for name in ("denso-vp6242", "three-r", "franka-panda"):
        bench.arm(name)
        want = float(pieper.load(name).aspects(bench.value("workbench.q")).manipulability)
        bench.until(
            "w => Math.abs(Number(document.querySelector('[data-testid=fact-manipulability]').textContent) - w) < 6e-5",
            want,
        )
    bench.arm("denso-vp6242")
    page.get_by_test_id("reach-size").select_option("5000")
    page.get_by_test_id("reach-colour").select_option("height")
    page.get_by_test_id("reach-start").click()
    page.get_by_text("coloured by height of the tool").wait_for()
    ends = page.locator(".legend-scale").inner_text().replace("\n", " ")
    assert ends.startswith("≤") and "≥" in ends and ends.endswith("mm")
    page.get_by_test_id("unit-length").get_by_role("button", name="m", exact=True).click()
    assert page.locator(".legend-scale").inner_text().endswith(" m")


@pytest.mark.parametrize("size", ["1", "1.5"])
def test_nothing_is_cut_off_at_any_size_of_letters_and_window(bench, size):
    page = bench.page
    page.get_by_test_id("text-size").select_option(size)
    letters = bench.value("parseFloat(getComputedStyle(document.documentElement).fontSize)")
    assert letters == pytest.approx(14.4 * float(size), abs=0.2)
    for width, height in ((1280, 800), (1280, 600), (820, 1180), (1180, 820), (1920, 1080), (1280, 800)):
        page.set_viewport_size({"width": width, "height": height})
        for tab in ("Inverse", "DH table", "Program"):
            bench.tab(tab)
            assert bench.value("document.documentElement.scrollWidth <= innerWidth"), (width, tab)
            stage = bench.value(OUTER % "#stage")
            assert stage[0] <= width + 1
            if bench.value("document.documentElement.dataset.layout") != "tablet":  # which is longer than its window
                assert max(stage[1], bench.value(OUTER % "#panels")[1]) <= height + 1, (width, height, tab)
            corner = bench.value(OUTER % ".corner.bottom")
            assert corner[1] <= stage[1] and corner[0] <= stage[0], "what lies over the picture stays in it"


def test_the_camera_comes_back_when_the_window_has_room_again(bench):
    bench.settle()
    before = bench.value("workbench.camera")
    bench.page.set_viewport_size({"width": 820, "height": 4000})
    bench.until("c => workbench.camera[0] !== c", before[0])
    bench.page.set_viewport_size({"width": 1280, "height": 800})
    bench.until("c => Math.abs(workbench.camera[0] - c) < 1e-6", before[0])
    assert bench.value("workbench.camera") == pytest.approx(before)


class Finger:
    """One finger on a screen that takes touches, by the browser's own input."""

    def __init__(self, page) -> None:
        self.page = page
        self.line = page.context.new_cdp_session(page)

    def drag(self, a, b, steps: int = 6) -> None:
        for k in range(steps + 1):
            x, y = (p + (q - p) * k / steps for p, q in zip(a, b, strict=True))
            kind = "touchStart" if k == 0 else "touchMove"
            self.line.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [{"x": x, "y": y}]})
            self.page.wait_for_timeout(40)
        self.line.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})


@pytest.mark.parametrize(("width", "height"), [(820, 1180), (1180, 820)])
def test_a_finger_does_what_a_mouse_does(people, width, height):
    bench = people(width=width, height=height, touch=True).open()
    page, finger = bench.page, Finger(bench.page)
    box = page.get_by_test_id("slider-1").bounding_box()
    q = bench.value("workbench.q[0]")
    share = bench.value(
        "(() => { const s = document.querySelector('[data-testid=slider-1]'); "
        "return (s.value - s.min) / (s.max - s.min); })()"
    )
    at, y = box["x"] + box["width"] * share, box["y"] + box["height"] / 2
    finger.drag((at, y), (at + 60, y))
    assert bench.value("workbench.q[0]") > q + 0.2, "a slider"
    view = page.locator("#view").bounding_box()
    left = (view["x"] + 60, view["y"] + view["height"] * 0.6)
    camera = bench.value("workbench.camera")
    finger.drag(left, (left[0] + 90, left[1]))
    bench.until("c => Math.abs(workbench.camera[0] - c) > 1e-3", camera[0])
    assert bench.value("scrollY") == 0, "the view is turned and the page stays"
    bench.button("Iso")
    page.get_by_role("tab", name="Inverse", exact=True).tap()
    bench.until("workbench.ghosts > 0")
    bench.settle()
    target = bench.value("workbench.target")
    start = bench.value("workbench.toScreen([3, 7, 11].map((i) => workbench.target[i]))")
    finger.drag(start, (start[0] + 20, start[1] - 14))
    bench.until("t => Math.hypot(...[3, 7, 11].map((i) => workbench.target[i] - t[i])) > 1e-3", target)
    assert "target" in bench.value("workbench.history[0]"), "the target"
    for name in ("Undo", "Redo"):
        box = page.get_by_role("button", name=name, exact=True).bounding_box()
        assert min(box["width"], box["height"]) >= 24, "wide enough for a finger"


@pytest.mark.parametrize("size", ["1.15", "1.3", "1.5"])
def test_larger_letters_lay_the_page_out_as_a_smaller_window(bench, size):
    """At every width the picture keeps room, the curves can be closed and every tab be pressed."""
    page = bench.page
    bench.tab("Path")
    bench.button("Plan the line")
    page.get_by_role("button", name="Close the curves").wait_for()
    page.get_by_test_id("text-size").select_option(size)
    for width, height in ((1280, 800), (1920, 1080), (1024, 768), (820, 1180), (2560, 1440), (1280, 800)):
        page.set_viewport_size({"width": width, "height": height})
        bench.tab("Program")
        bench.until("w => document.documentElement.clientWidth <= w", width)
        view = page.locator("#view").bounding_box()
        assert view["width"] > 0.25 * width and view["height"] > 0.2 * height, (width, view)
        close = page.get_by_role("button", name="Close the curves").bounding_box()
        stage = page.locator("#stage").bounding_box()
        assert stage["x"] <= close["x"] and close["x"] + close["width"] <= stage["x"] + stage["width"], (width, close)
        page.get_by_role("tab", name="Share", exact=True).click(timeout=5000)
