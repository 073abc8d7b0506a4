"""Routes: a seam with the tool free to turn; the map, the curve dragged, what shuts it, the program."""

from __future__ import annotations

import numpy as np
import pytest

import pieper

SEAM = [(900, -300, 900, 180, 0, 0), (900, 300, 900, 180, 0, 0)]


def type_line(bench, ends) -> None:
    for key, numbers in zip(("from", "to"), ends, strict=True):
        for i, value in enumerate(numbers):
            bench.fill(f"route-{key}-{i}", value)


@pytest.fixture
def seam(bench):
    bench.arm("abb-irb2400")
    bench.tab("Route")
    type_line(bench, SEAM)
    bench.page.get_by_test_id("find-route").click()
    bench.page.get_by_test_id("route-verdict").get_by_text("Found").wait_for()
    return bench


def line() -> np.ndarray:
    return pieper.line(*(pieper.pose(*np.array(e[:3]) / 1e3, rpy=e[3:], degrees=True) for e in SEAM), n=50)


def test_a_seam_is_routed_with_the_tool_free_to_turn_and_the_curve_is_dragged(seam):
    arm, page = pieper.load("abb-irb2400"), seam.page
    found = seam.value("workbench.route")
    q, turn = np.array(found["q"]), np.array(found["turn"])
    turned = pieper.Freedom().turned(line(), turn)
    assert np.abs(arm.fk(q) - turned).max() < 1e-9, "the route is the line, turned as the map's curve says"
    assert np.isclose(found["cost"], arm.route(line(), pieper.Freedom()).cost, rtol=1e-6)
    seam.shot("route", both=True)
    # a hand takes the first point and turns it by 40 degrees
    x, y = seam.value("workbench.routePlace('start')")
    _, up = seam.value(f"workbench.routePlace('start', {turn[0] + np.radians(40)})")
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x, (y + up) / 2, steps=3)
    assert "elbow" in seam.text("route-word"), "what is open there stands beside the hand"
    page.mouse.move(x, up, steps=3)
    page.mouse.up()
    put = turn[0] + np.radians(40)
    seam.until("put => Math.abs(workbench.route.turn[0] - put) < Math.PI / 90", put)
    page.get_by_test_id("route-end").focus()
    page.keyboard.press("PageDown")
    page.keyboard.press("Enter")
    seam.until("cost => workbench.route.cost > cost * 1.01", found["cost"])
    again = seam.value("workbench.route")
    assert np.isclose(again["turn"][0], put, atol=np.radians(2)), "it still begins where it was put"
    assert np.abs(arm.fk(np.array(again["q"])) - pieper.Freedom().turned(line(), np.array(again["turn"]))).max() < 1e-9
    # and it plays
    page.get_by_test_id("scrub").focus()
    page.keyboard.press("End")
    assert np.allclose(seam.value("workbench.q"), again["q"][-1])
    for _ in range(2):
        page.keyboard.press("Control+z")
    seam.until("cost => Math.abs(workbench.route.cost - cost) < 1e-9", found["cost"])


def test_the_end_is_turned_by_the_keyboard_and_let_free_again(seam):
    page = seam.page
    before = seam.value("workbench.route.turn.at(-1)")
    page.get_by_test_id("route-end").focus()
    for key in ("PageUp", "PageUp", "ArrowUp", "Enter"):
        page.keyboard.press(key)
    seam.until("turn => Math.abs(workbench.route.turn.at(-1) - turn - 21 * Math.PI / 180) < 1e-6", before)
    page.get_by_test_id("free-ends").click()
    seam.until("turn => Math.abs(workbench.route.turn.at(-1) - turn) < 1e-6", before)


def test_a_route_goes_to_the_program_and_is_run(seam):
    arm, page = pieper.load("abb-irb2400"), seam.page
    found = seam.value("workbench.route")
    page.get_by_test_id("route-to-program").click()
    seam.until("workbench.program.length === 1")
    assert "strays by at most" in page.locator("#remark").inner_text()
    page.get_by_test_id("run-program").click()
    page.get_by_test_id("program-verdict").get_by_text("1 move of abb-irb2400").wait_for()
    q = np.array(seam.value("workbench.motion.q"))
    assert np.allclose(q[0], found["q"][0]) and np.allclose(q[-1], found["q"][-1], atol=1e-6)
    p = arm.fk(q)[:, :3, 3]
    assert np.abs(p[:, [0, 2]] - [0.9, 0.9]).max() < 3e-4, "the tool stays on the seam"


def test_what_shuts_a_route_is_said_where_and_why_and_what_would_open_it(bench):
    bench.arm("abb-irb2400")
    bench.tab("Route")
    type_line(bench, [(900, -300, 900, 180, 0, 0), (900, 300, 900, 180, 0, 0)])
    page = bench.page
    page.get_by_test_id("route-turn").get_by_text("Within").click()
    bench.fill("route-turn-0", 60)
    bench.fill("route-turn-1", 61)
    bench.fill("route-to-3", 20)
    page.get_by_test_id("find-route").click()
    bench.until("workbench.route !== null")
    found = bench.value("workbench.route")
    arm = pieper.load("abb-irb2400")
    T0, T1 = (pieper.pose(0.9, y, 0.9, rpy=(r, 0, 0), degrees=True) for y, r in ((-0.3, 180), (0.3, 20)))
    free = pieper.Freedom(turn=tuple(np.radians([60, 61])))
    own = arm.route(pieper.line(T0, T1, 50), free)
    assert found["verdict"] == own.verdict.name and not own.found
    assert bench.text("route-verdict").split() == own.explain().split()
    assert own.blocked is not None and np.allclose(found["blocked"]["s"], own.blocked.s)
    bench.shot("route-blocked", both=True)
    page.get_by_test_id("route-others").click()
    # some eight seconds of search
    page.get_by_test_id("route-list").locator("p").first.wait_for(timeout=240_000)


def test_a_route_travels_with_the_state(seam, people):
    page = seam.page
    page.get_by_test_id("route-start").focus()
    page.keyboard.press("PageDown")
    page.keyboard.press("Enter")
    seam.until("location.hash.length > 10 && document.querySelector('.route-end.start.pinned')")
    turn = seam.value("workbench.route.turn[0]")
    seam.tab("Share")
    page.get_by_test_id("copy-link").click()
    page.get_by_text("Copied").wait_for()
    other = people().open(seam.value("navigator.clipboard.readText()").removeprefix(seam.url))
    other.tab("Route")
    other.page.get_by_test_id("find-route").click()
    other.until("turn => workbench.route && Math.abs(workbench.route.turn[0] - turn) < 1e-9", turn)
