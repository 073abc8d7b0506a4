"""Room for the picture: splitter, presenting, the picture as a file, the catalogue searched, DH frames step by step."""

from __future__ import annotations

import numpy as np

import pieper


def width(bench, part: str) -> float:
    return bench.page.locator(part).bounding_box()["width"]


def test_the_splitter_gives_the_picture_room_and_keeps_it(bench):
    page = bench.page
    before = width(bench, "#view")
    x, y = (lambda b: (b["x"] + b["width"] / 2, b["y"] + 200))(page.get_by_test_id("splitter").bounding_box())
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 90, y, steps=4)
    page.mouse.up()
    assert abs(width(bench, "#view") - before - 90) < 4
    page.get_by_test_id("splitter").focus()
    page.keyboard.press("Shift+ArrowLeft")
    assert width(bench, "#view") < before + 60
    kept = width(bench, "#view")
    page.reload()
    page.wait_for_selector("html[data-ready=yes]")
    assert abs(width(bench, "#view") - kept) < 3
    page.get_by_test_id("splitter").focus()
    page.keyboard.press("Home")
    assert abs(width(bench, "#view") - before) < 3


def test_presenting_shows_picture_matrix_and_one_panel_in_large_type(bench):
    page = bench.page
    size = "parseFloat(getComputedStyle(document.documentElement).fontSize)"
    before = bench.value(size)
    page.get_by_test_id("present").click()
    assert bench.value(size) > 1.2 * before
    shown = page.get_by_test_id("present-pose")
    card, view = shown.bounding_box(), page.locator("#view").bounding_box()
    assert card["y"] >= view["y"] + view["height"], "the matrix lies under the picture, not over the arm"
    assert shown.is_visible()
    bench.shot("present", both=True)
    page.locator("#view").focus()
    page.keyboard.press("Escape")
    assert bench.value(size) == before and shown.is_hidden()


def test_long_numbers_are_written_as_large_as_the_others_when_presenting(bench):
    bench.joints((-123.4567, -88.1234, 101.2345, -100.123, -89.99, 35.123))
    for tab in ("Inverse", "Path"):
        bench.tab(tab)
        bench.page.get_by_test_id("present").click()
        fields = ".pose-field input.number"
        bench.until(f"[...document.querySelectorAll('{fields}')].some((f) => f.offsetParent && f.value.length > 6)")
        sizes = bench.value(
            f"[...document.querySelectorAll('{fields}')].filter((f) => f.offsetParent)"
            ".map((f) => getComputedStyle(f).fontSize)"
        )
        assert len(sizes) >= 6
        assert len(set(sizes)) == 1, f"{tab}: some numbers are written smaller to be seen whole: {sizes}"
        bench.page.get_by_test_id("present").click()


def test_the_picture_is_saved_as_it_stands(bench):
    bench.settle()
    with bench.page.expect_download() as saved:
        bench.page.get_by_test_id("save-picture").click()
    content = saved.value.path().read_bytes()
    assert content.startswith(b"\x89PNG") and len(content) > 20_000


def test_the_catalogue_is_searched_by_maker_name_joints_payload_and_reach(bench):
    page = bench.page
    page.get_by_test_id("find-arm").click()
    found = page.get_by_test_id("arms-found").get_by_role("option")
    found.first.wait_for()
    assert found.count() == len(pieper.catalog())
    bench.shot("catalogue", both=False)
    page.get_by_test_id("search-arms").fill("kuka 7r")
    names = [el.get_attribute("data-name") for el in found.all()]
    wanted = [n for n in pieper.catalog() if n.startswith("kuka") and pieper.load(n).n == 7]
    assert names == wanted and names
    for said, figures in (("5 kg 900mm", (5, 0.9)), ("fanuc 1.2 m", (0, 1.2)), (">2,5kg abb", (2.5, 0))):
        page.get_by_test_id("search-arms").fill(said)
        names = [el.get_attribute("data-name") for el in found.all()]
        maker = next((w for w in ("fanuc", "abb") if w in said), "")
        entries = pieper.find_arms(maker, payload=figures[0] or None, reach=figures[1] or None)
        assert names == [e.name for e in entries] and names, "as pieper.find_arms answers"
    for said in ("7 joints", "7-axis", "7 DOF"):
        page.get_by_test_id("search-arms").fill(said)
        names = [el.get_attribute("data-name") for el in found.all()]
        assert names == [n for n in pieper.catalog() if pieper.load(n).n == 7], said
    page.get_by_test_id("search-arms").fill("kuka 7r")
    page.keyboard.press("ArrowDown")
    page.keyboard.press("Enter")
    bench.until("name => workbench.table.name === name", wanted[0])


def test_the_frames_of_a_table_are_built_one_motion_at_a_time(bench):
    """As RoboAnalyzer's students know it: theta, d, a, alpha in turn, joint after joint."""
    page = bench.page
    bench.tab("DH table")
    page.get_by_test_id("dh-steps").locator("summary").click()
    # what opens says so in an event of its own, after the click
    bench.until("document.querySelector('[data-testid=dh-step-said]').textContent !== ''")
    assert "Joint 1, 1 of 4: turn by θ1" in bench.text("dh-step-said")
    assert bench.value("workbench.framesDrawn") == ["base", "→ 1"]
    on = page.get_by_role("button", name="One step on")
    for said in ("go d1 = 125.00 mm along z0", "go a1 = 0.00 mm along x", "turn by α1 = 90.00° about x"):
        on.click()
        assert said in bench.text("dh-step-said")
    for _ in range(4):
        on.click()
    F = np.array(bench.value("workbench.frames"))
    assert np.allclose(bench.value("workbench.stepFrame"), F[2], atol=1e-12), "after four motions it is the next frame"
    bench.shot("dh-steps", both=True)
    page.get_by_role("button", name="To the end").click()
    assert np.allclose(bench.value("workbench.stepFrame"), F[6], atol=1e-12)
    bench.tab("Move")
    assert bench.value("workbench.framesDrawn") == ["base", "tool"]


def test_the_ellipsoid_of_velocities_is_that_of_the_jacobian(bench):
    bench.joints([20, 60, -150, 10, 40, 25])
    bench.tab("Analysis")
    bench.page.get_by_test_id("ellipsoid").get_by_role("button", name="Velocities").click()
    arm, q = pieper.load("denso-vp6242"), np.radians([20, 60, -150, 10, 40, 25])
    left, values, _ = np.linalg.svd(arm.jacobian(q)[:3])
    drawn = bench.value("workbench.ellipsoid")
    assert np.allclose([a["length"] for a in drawn], values, atol=1e-12)
    assert np.allclose([abs(np.dot(a["axis"], left[:, k])) for k, a in enumerate(drawn)], 1, atol=1e-9)
    bench.shot("ellipsoid", both=True)
    bench.page.get_by_test_id("ellipsoid").get_by_role("button", name="Forces").click()
    assert f"{values[0] * 1000:.2f} mm" in bench.text("ellipsoid-axes")


def test_the_nearest_two_bodies_are_shown_live(bench):
    page = bench.page
    bench.joints([20, 60, -150, 10, 40, 25])
    bench.tab("World")
    page.get_by_test_id("add-obstacle-box").click()
    bench.fill("world-1-0", 420)
    bench.until("workbench.clearance?.metres > 0")
    arm = pieper.load("denso-vp6242")
    box = bench.value("workbench.world[0]")
    scene = pieper.Scene([pieper.Box(np.reshape(box["T"], (4, 4)), box["size"], box["name"])])
    bench.rest()
    said = arm.distance(np.array(bench.value("workbench.q")), scene)
    assert abs(bench.value("workbench.clearance.metres") - float(said)) < 1e-9
    assert f"{float(said) * 1000:.2f} mm apart" in bench.text("clearance")
    page.get_by_test_id("show-bodies").check()
    bench.until("workbench.bodies > 3")
    bench.shot("clearance", both=True)
    T = arm.fk(np.array(bench.value("workbench.q")))
    for i, v in enumerate(T[:3, 3] * 1000):
        bench.fill(f"world-1-{i}", round(v, 3))
    bench.until("workbench.clearance?.metres < 0")
    assert "overlap by" in bench.text("clearance")
