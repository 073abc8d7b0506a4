"""State that one can trust: layout through widths, reload, one history, edited arms, typed digits, coupled arms."""

from __future__ import annotations

import json

import numpy as np
import pytest

import pieper

WIDTHS = (820, 900, 1000, 1280, 1700, 1920, 3840, 1920, 1280, 900, 820, 1280)

#: Each part of the room as it lies on the screen, and whether one lies over another.
OVERLAPS = """() => {
  const box = (s) => { const e = document.querySelector(s); const r = e && !e.hidden ? e.getBoundingClientRect() : null;
    return r && r.width > 0 && r.height > 0 ? [s, r] : null; };
  const parts = ['#view canvas', '#dock', '#rail', '#panels', '#bar'].map(box).filter(Boolean), found = [];
  for (let i = 0; i < parts.length; i++) {
    const [name, r] = parts[i];
    if (r.right > innerWidth + 1 || r.left < -1) found.push(`${name} leaves the window`);
    for (let k = i + 1; k < parts.length; k++) {
      const [other, o] = parts[k];
      const w = Math.min(r.right, o.right) - Math.max(r.left, o.left),
        h = Math.min(r.bottom, o.bottom) - Math.max(r.top, o.top);
      if (w > 1 && h > 1 && innerWidth > 900) found.push(`${name} over ${other} by ${w} x ${h}`);
    }
  }
  return found;
}"""


def plan_a_line(bench) -> None:
    bench.tab("Path")
    bench.plan((350, 0, 400, 0, 0, 0), (200, 100, 500, 0, 0, 0))
    bench.page.get_by_test_id("chart").wait_for()


def apart(bench, where: object) -> None:
    """Wait until no part lies over another; a picture of many pixels takes a moment to be drawn at its new size."""
    for _ in range(100):
        found = bench.value(OVERLAPS)
        if not found:
            return
        bench.page.wait_for_timeout(100)
    raise AssertionError((where, found))


def test_nothing_covers_anything_through_all_widths_and_back(people):
    one = people(width=820, height=1100).open()
    plan_a_line(one)
    for width in WIDTHS:
        one.page.set_viewport_size({"width": width, "height": 900})
        apart(one, width)
        if width == 1280:
            one.shot("widened-with-chart")
    one.page.get_by_label("Close the curves").click()
    for width in WIDTHS:
        one.page.set_viewport_size({"width": width, "height": 900})
        apart(one, width)
    for tab in ("Inverse", "DH table", "Share"):
        one.tab(tab)
        apart(one, tab)


def test_a_reload_gives_back_exactly_the_posture(bench):
    bench.joints([20, 60, -150, 10, 40, 25])
    bench.tab("Inverse")
    bench.fill("target-2", 420)
    bench.until("Math.abs(workbench.frames.at(-1)[11] - 0.42) < 1e-9")
    bench.joints([10, 50, -140, 10, 40, 25])
    bench.tab("Inverse")
    bench.answered()
    q, target = bench.value("workbench.q"), bench.value("workbench.target")
    bench.page.reload()
    bench.page.wait_for_selector("html[data-ready=yes]")
    bench.answered()
    bench.rest()
    assert bench.value("workbench.q") == q and bench.value("workbench.target") == target


def test_a_link_a_task_and_a_reconnection_leave_the_posture_alone(people, server):
    one = people().open()
    one.joints([20, 60, -150, 10, 40, 25])
    one.tab("Inverse")
    one.fill("target-2", 420)
    one.until("Math.abs(workbench.frames.at(-1)[11] - 0.42) < 1e-9")
    one.joints([10, 50, -140, 10, 40, 25])
    q = one.value("workbench.q")
    one.tab("Inverse")
    one.answered()
    one.page.get_by_label("Task").select_option("position")
    one.rest()
    assert one.value("workbench.q") == q, "another task is no other target"
    one.page.get_by_label("Task").select_option("")
    server.stop()
    one.page.get_by_text("Server away").wait_for()
    server.start()
    one.page.locator("[data-testid=online]:not(.away)").wait_for(state="attached")
    one.answered()
    one.rest()
    assert one.value("workbench.q") == q, "a new connection is no other target"
    one.tab("Share")
    one.until("document.querySelector('[data-testid=link]').value.includes('#s=')")
    one.page.get_by_test_id("copy-link").click()
    one.page.get_by_text("Copied").wait_for()
    other = people().open(one.value("navigator.clipboard.readText()").removeprefix(one.url))
    other.tab("Inverse")
    other.answered()
    other.rest()
    assert other.value("workbench.q") == q
    one.expected_errors = [e for e in one.errors if "WebSocket" in e or "ERR_CONNECTION" in e]


def test_one_history_of_everything_and_it_says_what(bench):
    page = bench.page
    bench.joints([20, 60, -150, 10, 40, 25])
    bench.tab("Inverse")
    bench.fill("target-2", 420)
    bench.until("Math.abs(workbench.frames.at(-1)[11] - 0.42) < 1e-9")
    bench.tab("DH table")
    bench.fill("dh-2-a", "215")
    bench.tab("Path")
    bench.fill("path-to-0", "300")
    undo = page.get_by_role("button", name="Undo", exact=True)
    said = []
    for _ in range(4):
        said.append(undo.get_attribute("title"))
        undo.click()
    assert ["path" in said[0], "a of joint 2" in said[1], "target" in said[2], "q6" in said[3]] == [True] * 4
    assert np.allclose(np.degrees(bench.value("workbench.q"))[:5], [20, 60, -150, 10, 40])
    assert bench.value("workbench.table.joints[1].a") == pytest.approx(0.21)
    page.keyboard.press("Control+Shift+z")
    page.keyboard.press("Control+Shift+z")
    assert bench.value("workbench.target")[11] == pytest.approx(0.42)
    assert bench.value("workbench.frames.at(-1)")[11] == pytest.approx(0.42), "the arm that followed belongs to it"
    before = bench.value("[workbench.q, workbench.target, workbench.table]")
    bench.arm("abb-irb140")
    assert "open abb-irb140" in undo.get_attribute("title")
    undo.click()
    assert bench.value("[workbench.q, workbench.target, workbench.table]") == before
    assert "Undone: open abb-irb140" in page.locator("#remark").inner_text()
    bench.shot("history", both=True)


def test_an_edited_arm_of_the_catalogue_says_so(bench):
    page = bench.page
    picker = page.get_by_test_id("catalog")
    bench.tab("DH table")
    bench.fill("dh-2-a", "215")
    chosen = picker.evaluate("e => e.selectedOptions[0].textContent")
    assert "denso-vp6242-edited" in chosen and "edited" in chosen
    with page.expect_download() as saved:
        bench.button("Save")
    text = saved.value.path().read_text()
    arm = pieper.load(saved.value.path().rename(saved.value.path().with_suffix(".toml")))
    assert "Derived from denso-vp6242" in text and arm.name == "denso-vp6242-edited"
    assert not arm.description.manufacturer and not arm.description.source
    bench.tab("Share")
    with page.expect_download() as saved:
        page.get_by_test_id("report").click()
    html = saved.value.path().read_text()
    assert "denso-vp6242-edited" in html
    bench.button("Undo")
    assert picker.input_value() == "denso-vp6242"


@pytest.mark.parametrize("name", ["dfrobot-rob0036-as-printed", "denso-vp6242", "motoman-ea1400n"])
@pytest.mark.parametrize("notation", ["rpy", "matrix"])
def test_a_pose_typed_with_the_digits_shown_is_solved_to_those_digits(bench, name, notation):
    """Seed 001: the pose of the panel, typed into the inverse, for an arm whose poses are five-dimensional too."""
    page = bench.page
    bench.arm(name)
    arm = pieper.load(name)
    q = arm.postures.get("figure-5", np.radians(np.linspace(12, 47, arm.n)))
    bench.joints(np.degrees(q))
    T = arm.fk(np.array(bench.value("workbench.q")))
    bench.tab("Inverse")
    bench.answered()
    if notation == "matrix":
        bench.button("Matrix")
        shown = T.copy()
        shown[:3, 3] *= 1000
        rows = [" ".join(f"{v:.{2 if k == 3 else 4}f}" for k, v in enumerate(row)) for row in shown[:3]]
        page.get_by_test_id("target-matrix").fill("\n".join(rows))
    else:
        for i, value in enumerate(pieper.read_pose(T, "rpy", degrees=True, mm=True)):
            bench.fill(f"target-{i}", f"{value:.2f}")
    bench.answered()
    rows = np.array([r["q"] for r in bench.value("workbench.solutions.rows")])
    reached = arm.fk(rows)
    assert np.abs(reached[:, :3, 3] - T[:3, 3]).max() < 3e-5, "within the digits"
    assert np.abs(reached[:, :3, :3] - T[:3, :3]).max() < 4e-4
    if name.startswith("dfrobot"):
        assert "was rounded" in bench.text("ik-verdict")
        bench.shot(f"typed-digits-{notation}", both=True)


def test_a_pose_nothing_reaches_is_offered_the_nearest_posture(bench):
    bench.arm("dfrobot-rob0036-as-printed")
    bench.button("figure-5")
    bench.tab("Inverse")
    bench.fill("target-3", "20")
    near = bench.page.get_by_test_id("ik-nearest")
    bench.until("workbench.settled")
    text = bench.text("ik-verdict").lower()
    assert text.count("out of reach") == 1, "said once"
    near.get_by_role("button", name="Go there").click()
    arm = pieper.load("dfrobot-rob0036-as-printed")
    T = np.reshape(bench.value("workbench.target"), (4, 4))
    best = arm.closest(T)
    assert np.allclose(arm.fk(bench.value("workbench.q")), best.T, atol=1e-6)


def test_an_arm_with_coupled_joints_is_shown_and_solved(bench, tmp_path):
    """Joint numbers are the motors'; the angles of the chain stand beside them."""
    plain = pieper.load("denso-vp6242")
    d = plain.description
    C = np.eye(6)
    C[2, 1] = 1.0
    arm = pieper.Arm.from_dh(
        list(d.rows), convention=d.convention, joint_types="RRRRRR", limits=[None] * 6, name="coupled", coupling=C
    )
    arm.save(tmp_path / "coupled.toml")
    bench.tab("DH table")
    bench.page.get_by_test_id("robot-file").set_input_files(tmp_path / "coupled.toml")
    bench.until("workbench.table.name === 'coupled'")
    q = np.radians([20, 60, -150, 10, 40, 25])
    bench.joints(np.degrees(q))
    assert np.allclose(bench.value("workbench.frames.at(-1)"), arm.fk(q).ravel(), atol=1e-12)
    assert "chain −90" in bench.text("joint-3")
    bench.tab("Inverse")
    bench.answered()
    rows = np.array([r["q"] for r in bench.value("workbench.solutions.rows")])
    assert np.abs(np.angle(np.exp(1j * (rows - q)))).max(1).min() < 1e-9
    for k, frame in enumerate(json.loads(json.dumps(bench.value("workbench.frames")))):
        assert np.allclose(np.reshape(frame, (4, 4)), arm.frames(q)[k], atol=1e-12)
    bench.shot("coupled")


def test_radians_are_not_kept_as_metres_where_a_turning_joint_becomes_a_slide(bench):
    """What was taught keeps the joints that are of one kind on both arms, and undo brings all back."""
    bench.tab("Program")
    bench.page.get_by_test_id("start-here").click()
    bench.page.get_by_test_id("step-add-joint").click()
    bench.joints([10, 60, -150, 10, 40, 25])
    bench.tab("Sequence")
    bench.page.get_by_test_id("add-posture").click()
    before = bench.value("workbench.said")
    assert before["program"]["steps"][0]["q"] and before["program"]["start"] and before["sequence"]["postures"]
    bench.arm("stanford-arm")
    after = bench.value("workbench.said")
    slide = bench.value("workbench.table.joints[2]")
    assert slide["type"] == "P"
    for was, now in (
        (before["program"]["start"], after["program"]["start"]),
        (before["program"]["steps"][0]["q"], after["program"]["steps"][0]["q"]),
        (before["sequence"]["postures"][0]["q"], after["sequence"]["postures"][0]["q"]),
    ):
        assert slide["lower"] <= now[2] <= slide["upper"]
        assert [v for i, v in enumerate(now) if i != 2] == [v for i, v in enumerate(was) if i != 2]
    bench.page.keyboard.press("Control+z")
    bench.until("workbench.table.name === 'denso-vp6242'")
    again = bench.value("workbench.said")
    for key in ("program", "sequence"):
        assert again[key] == before[key]


def test_the_picker_names_the_arm_that_is_shown_where_another_is_refused(bench):
    page = bench.page
    page.get_by_test_id("catalog").select_option("dobot-mg400")
    page.get_by_text("has a linkage that moves").wait_for()
    assert "pieper.workbench(arm.uncoupled())" in page.inner_text("#remark")
    assert page.get_by_test_id("catalog").input_value() == bench.value("workbench.table.name") == "denso-vp6242"
