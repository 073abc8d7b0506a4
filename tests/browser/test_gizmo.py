"""The handles on the target: picked at any view, in the page's colours, with steps and numbers."""

from __future__ import annotations

import numpy as np
import pytest

AXES = "xyz"


def target(bench) -> np.ndarray:
    return np.reshape(bench.value("workbench.target"), (4, 4))


def ready(bench) -> None:
    bench.joints([10, 70, -140, 25, 50, 30])
    bench.tab("Inverse")
    bench.answered()
    bench.settle()


def drag(bench, start, by, *, steps: int = 6, shift: bool = False) -> str:
    """Drag from a point of the screen and return what was said on the way."""
    x, y = start
    if shift:
        bench.page.keyboard.down("Shift")
    bench.page.mouse.move(x, y)
    bench.page.mouse.down()
    for k in range(1, steps + 1):
        bench.page.mouse.move(x + by[0] * k / steps, y + by[1] * k / steps)
    said = bench.page.get_by_test_id("gizmo-readout").inner_text()
    bench.page.mouse.up()
    if shift:
        bench.page.keyboard.up("Shift")
    return said


@pytest.mark.parametrize("view", ["Iso", "Front", "Side", "Top"])
def test_every_handle_can_be_picked_at_any_view(bench, view):
    ready(bench)
    bench.button(view)
    bench.settle()
    handles = bench.value("workbench.handles()")
    turns = [name for name in handles if name.startswith("turn")]
    moves = [name for name in handles if name.startswith("move")]
    assert len(turns) == 4 and len(moves) >= 3, handles
    camera = bench.value("workbench.camera")
    for name in moves + turns:
        before = target(bench)
        at = bench.value("workbench.handles()")[name]
        said = drag(bench, at, (14, -11))
        after = target(bench)
        moved = np.linalg.norm(after[:3, 3] - before[:3, 3])
        turned = np.degrees(np.arccos(np.clip((np.trace(before[:3, :3].T @ after[:3, :3]) - 1) / 2, -1, 1)))
        what, which = name.split("-")
        if what == "move":
            assert moved > 1e-5 and np.allclose(after[:3, :3], before[:3, :3], atol=1e-12), name
            if which in AXES:
                off = np.cross(before[:3, AXES.index(which)], after[:3, 3] - before[:3, 3])
                assert np.abs(off).max() < 1e-9 and f"along tool {which}" in said, "along its own axis and no other"
        else:
            assert turned > 0.05 and moved < 1e-12, name
            if which in AXES:
                axis = before[:3, AXES.index(which)]
                assert np.allclose(after[:3, :3].T @ axis, before[:3, :3].T @ axis, atol=1e-9)
                assert f"about tool {which}" in said
        bench.page.keyboard.press("Control+z")
        bench.until("T => workbench.target.every((v, i) => Math.abs(v - T[i]) < 1e-12)", before.ravel().tolist())
    assert np.allclose(bench.value("workbench.camera"), camera, atol=1e-3), "the picture did not turn meanwhile"
    bench.shot(f"gizmo-{view.lower()}", both=view == "Iso")


def test_steps_of_the_snap_and_numbers_while_dragging(bench):
    ready(bench)
    before = target(bench)
    said = drag(bench, bench.value("workbench.handles()")["move-x"], (37, 12), shift=True)
    by = np.linalg.norm(target(bench)[:3, 3] - before[:3, 3]) * 1000
    assert by > 1 and by % 5 == pytest.approx(0, abs=1e-6) or by % 5 == pytest.approx(5, abs=1e-6)
    assert f"{by:.2f} mm" in said.replace("−", "-")
    bench.page.get_by_test_id("snap").select_option("45")
    before = target(bench)
    said = drag(bench, bench.value("workbench.handles()")["turn-view"], (-70, 90))
    after = target(bench)
    turned = np.degrees(np.arccos(np.clip((np.trace(before[:3, :3].T @ after[:3, :3]) - 1) / 2, -1, 1)))
    assert turned > 1 and min(turned % 45, 45 - turned % 45) < 1e-5 and "line of sight" in said


def test_escape_while_dragging_puts_the_target_back(bench):
    ready(bench)
    before = bench.value("workbench.target")
    x, y = bench.value("workbench.handles()")["move-z"]
    bench.page.mouse.move(x, y)
    bench.page.mouse.down()
    bench.page.mouse.move(x + 20, y + 30, steps=4)
    assert bench.value("workbench.target") != before
    bench.page.keyboard.press("Escape")
    bench.page.mouse.up()
    assert bench.value("workbench.target") == before


def test_the_handles_have_the_colours_of_the_page_and_the_tools_own_arrows_are_away(bench):
    ready(bench)
    shown = bench.value("workbench.framesDrawn")
    assert "tool" not in shown and "base" in shown
    bench.tab("Move")
    assert "tool" in bench.value("workbench.framesDrawn")
