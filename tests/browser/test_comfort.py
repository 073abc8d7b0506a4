"""Usable by everybody: the keyboard alone, names and contrast, screens from a tablet to a 4k wall."""

from __future__ import annotations

from pathlib import Path

import pytest

TABS = [
    "Move",
    "Inverse",
    "DH table",
    "World",
    "Path",
    "Route",
    "Program",
    "Sequence",
    "Matrices",
    "Equations",
    "Analysis",
    "Share",
]

AUDIT = (Path(__file__).parent / "audit.js").read_text()


@pytest.mark.parametrize("dark", [False, True], ids=["light", "dark"])
def test_every_control_has_a_name_and_every_text_enough_contrast(people, dark):
    one = people(dark=dark).open()
    for name in TABS:
        one.tab(name)
        one.rest()
        found = one.value(AUDIT)
        assert found["nameless"] == [], name
        assert found["faint"] == [], name


def test_the_keyboard_alone_is_enough(bench):
    page = bench.page
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.className") == "skip"
    page.get_by_role("tab", name="Move").focus()
    page.keyboard.press("ArrowDown")
    assert page.evaluate("document.activeElement.textContent") == "Inverse"
    bench.answered(2)
    page.get_by_test_id("solution-2").focus()
    page.keyboard.press("Enter")
    bench.until("workbench.solutions.rows[1].q.every((v, i) => Math.abs(Math.sin((v - workbench.q[i]) / 2)) < 1e-6)")
    view = page.locator("#view")
    view.focus()
    for key in ("ArrowLeft", "ArrowUp", "+", "-", "2", "4", "1"):
        before = bench.value("workbench.camera")
        page.keyboard.press(key)
        bench.until("before => workbench.camera.some((v, i) => Math.abs(v - before[i]) > 1e-4)", before)


def test_frames_can_be_shown_one_by_one(bench):
    for name in ("Frame 1", "Frame 2", "Frame 3"):
        button = bench.page.get_by_role("button", name=name, exact=True)
        button.click()
        assert bench.page.get_by_role("button", name=name, exact=True).get_attribute("aria-pressed") == "true"
    bench.button("All frames or none")
    bench.shot("all-frames", both=True)


@pytest.mark.parametrize(("width", "height"), [(1100, 720), (1280, 800), (1920, 1080), (3840, 2160), (820, 1180)])
def test_nothing_is_cut_off(people, width, height):
    one = people(width=width, height=height).open()
    for name in TABS if width < 1700 else TABS[1:]:
        one.tab(name)
        one.rest()
        assert one.value(AUDIT)["cut"] == [], name
    one.tab("Inverse")
    one.shot(f"screen-{width}x{height}")
