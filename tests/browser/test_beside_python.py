"""Python beside the page: what a script sets is shown, what a person does is read, and the screen as a script."""

from __future__ import annotations

import numpy as np
import pytest

import pieper

from .conftest import Workbench


@pytest.fixture
def beside(browser):
    """A script's bench with one page open on it."""
    script = pieper.workbench("denso-vp6242", open_browser=False)
    context = browser.new_context(viewport={"width": 1280, "height": 800}, reduced_motion="reduce")
    yield script, Workbench(context.new_page(), script.url).open()
    context.close()
    script.close()


def heard(script, so) -> None:
    """Wait until what a person did has come to Python."""
    for _ in range(100):
        if so():
            return
        script.wait(0.2)
    raise AssertionError("Python has not heard of it")


def test_a_script_moves_the_page_and_reads_what_a_person_did(beside):
    script, page = beside
    q = np.radians([10, 70, -140, 25, 50, 30])
    script.q = q
    page.until("v => Math.abs(workbench.q[0] - v) < 1e-15", float(q[0]))
    assert page.value("workbench.q") == q.tolist()
    page.fill("q-1", 42)
    assert script.wait(20) and script.q[0] == pytest.approx(np.radians(42))
    T = script.arm.fk(np.radians([20, 60, -150, 10, 40, 25]))
    script.target = T
    page.until("v => workbench.target.every((x, i) => Math.abs(x - v[i]) < 1e-12)", T.ravel().tolist())
    page.until("v => workbench.frames.at(-1).every((x, i) => Math.abs(x - v[i]) < 1e-9)", T.ravel().tolist())
    assert len(script.solutions) > 0 and np.allclose(script.T, T, atol=1e-9)
    page.tab("DH table")
    page.fill("dh-2-a", 215)
    page.until("workbench.table.joints[1].a === 0.215")
    for _ in range(50):
        if script.arm.description.rows[1].a == 0.215:
            break
        script.wait(0.2)
    assert script.arm.description.rows[1].a == 0.215, "the arm that a person edited is Python's too"
    page.shot("beside-python")


def test_what_a_script_adds_is_drawn_and_a_motion_plays(beside):
    script, page = beside
    arm = script.arm
    frame = script.add(pieper.pose(0.3, 0.1, 0.2))
    path = pieper.line(pieper.pose(0.35, 0, 0.4), pieper.pose(0.2, 0.1, 0.5), n=30)
    script.add(path, "line")
    page.until("workbench.things === 2")
    start = arm.ik(path[0]).nearest(np.radians([0, 50, -150, 0, 90, 0]))
    script.add(arm.follow(path, start=start), "walk")
    page.page.get_by_test_id("chart").wait_for()
    assert np.allclose(page.value("workbench.q"), start, atol=1e-9)
    script.remove(frame)
    page.until("workbench.things === 1")
    program = pieper.Program(arm, pieper.Limits(speed=3, acceleration=10), start=start)
    program.move_j(start + 0.1).gripper(1.0).wait(0.1)
    script.add(program, "walk")
    page.page.get_by_text("gripper").first.wait_for(state="attached")
    script.clear()
    page.until("workbench.things === 0")
    assert page.page.get_by_test_id("chart").is_hidden()


def test_a_script_reads_the_program_and_the_world_that_a_person_made(beside):
    script, page = beside
    page.joint_steps([20, 60, -150, 10, 40, 25], [40, 60, -150, 10, 40, 25])
    page.page.get_by_test_id("step-add-gripper").click()
    page.page.get_by_test_id("step-add-line").click()
    page.fill("step-4-T-2", 300)
    page.tab("World")
    page.page.get_by_test_id("add-obstacle-box").click()
    page.fill("world-1-0", 420)
    heard(script, lambda: len(script.scene) == 1 and script.scene[0].T[0, 3] == pytest.approx(0.42))
    heard(script, lambda: script.program is not None and len(script.program.instructions) == 3)
    taught = script.program
    assert np.allclose(taught.start, np.radians([20, 60, -150, 10, 40, 25]))
    assert np.allclose(taught.moves[0].q, np.radians([40, 60, -150, 10, 40, 25]))
    assert script.arm.fk(taught.motion().q[-1])[2, 3] == pytest.approx(0.3, abs=1e-9)
    page.tab("Program")
    for _ in range(40):
        if page.value("workbench.program.length") == 0:
            break
        page.page.keyboard.press("Control+z")
    heard(script, lambda: script.program is None)


def test_a_hand_on_the_handles_another_arm_and_a_second_page_are_read(beside, browser):
    script, page = beside
    page.tab("Inverse")
    page.answered()
    page.settle()
    x, y = page.value("workbench.handles()")["move-x"]
    page.page.mouse.move(x, y)
    page.page.mouse.down()
    page.page.mouse.move(x + 20, y + 8, steps=5)
    page.page.mouse.up()
    page.settle()
    said = page.value("workbench.target")
    heard(script, lambda: script.target is not None and script.target.ravel().tolist() == said)
    heard(script, lambda: script.q.tolist() == page.value("workbench.q"))
    page.arm("abb-irb140")
    heard(script, lambda: script.arm.name == "abb-irb140")
    script.add(pieper.pose(0.3, 0.1, 0.2), "here")
    script.q = "zero" if "zero" in script.arm.postures else np.full(6, 0.2)
    other = Workbench(browser.new_context(reduced_motion="reduce").new_page(), script.url).open()
    other.until("workbench.table.name === 'abb-irb140' && workbench.things === 1")
    assert other.value("workbench.q") == script.q.tolist(), "a page that opens later shows the same"
    other.page.reload()
    other.page.wait_for_selector("html[data-ready=yes]")
    other.until("workbench.table.name === 'abb-irb140' && workbench.things === 1")
    assert other.value("workbench.q") == script.q.tolist()
    other.page.context.close()
    with pytest.raises(pieper.InputError, match="6 finite numbers"):
        script.q = [1, 2]
    assert script.url in script._repr_html_() and "iframe" in script._repr_html_()


def test_the_screen_as_a_script_computes_what_is_on_the_screen(bench, capsys):
    bench.tab("DH table")
    bench.fill("dh-2-a", 215)
    bench.joint_steps([20, 60, -150, 10, 40, 25], [40, 60, -150, 10, 40, 25])
    bench.tab("Inverse")
    bench.answered()
    bench.tab("Share")
    bench.until("document.querySelector('[data-testid=python]').value.includes('program.motion()')")
    text = bench.page.get_by_test_id("python").input_value()
    found: dict = {}
    exec(text, found)
    assert found["q"].tolist() == bench.value("workbench.q")
    assert np.allclose(found["T"].ravel(), bench.value("workbench.frames.at(-1)"), atol=1e-12)
    rows = [row["q"] for row in bench.value("workbench.solutions.rows") if row["inside"]]
    assert np.allclose(found["solutions"].q, rows, atol=1e-9)
    assert len(found["program"].instructions) == 1, "the first step is where the arm stands"
    bench.shot("as-python", both=True)


@pytest.mark.parametrize("leave", ["Enter", "Tab"])
def test_a_field_shows_what_holds_after_a_script_has_moved_the_arm(beside, leave):
    script, page = beside
    page.fill("q-2", -33)
    field = page.page.get_by_test_id("q-2")
    q = np.radians([5, 60, -70, 5, 5, 5])
    script.q = q
    page.until("v => workbench.q[1] === v", float(q[1]))
    assert field.input_value() == "60", "nobody is typing: the hand has only not left the field"
    field.press("End")
    field.press_sequentially("5")  # 605, heard at once; then the script again, and the hand leaves
    page.until("v => workbench.q[1] === v", np.radians(605))
    assert script.wait(20)
    script.q = q + 0.5
    page.until("v => workbench.q[1] === v", float(q[1] + 0.5))
    assert field.input_value() == "605", "no text is changed under a hand that types"
    field.press(leave)
    assert float(field.input_value()) == pytest.approx(60 + np.degrees(0.5), abs=1e-3)
    assert page.value("workbench.q") == (q + 0.5).tolist()


def test_a_target_set_by_a_script_is_in_every_field_that_a_hand_is_not_in(beside):
    script, page = beside
    page.tab("Inverse")
    page.fill("target-0", 300)
    T = script.arm.fk(np.radians([20, 60, -150, 10, 40, 25]))
    script.target = T
    page.until("v => Math.abs(workbench.target[7] - v) < 1e-12", float(T[1, 3]))
    page.fill("target-2", 260)
    got = page.value("workbench.target")
    assert got[3] == pytest.approx(T[0, 3], abs=1e-6) and got[11] == pytest.approx(0.26), "no number of the old target"
