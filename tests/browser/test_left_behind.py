"""What a hand leaves behind: texts that cannot be read, questions under way, presses that outlast what they were on."""

from __future__ import annotations

import pytest

from .conftest import Server

#: A panel, what is pressed to have something in it, a field of it, and what changes its rows.
FIELDS = {
    "joints": ("Move", [], "q-1", lambda b: b.fill("q-2", 50)),
    "table": ("DH table", [], "dh-1-a", lambda b: b.fill("dh-2-a", 10)),
    "one joint more": ("DH table", [], "dh-1-a", lambda b: b.page.get_by_test_id("add-joint").click(delay=200)),
    "world": (
        "World",
        ["add-object-box"],
        "world-1-size-0",
        lambda b: b.page.get_by_test_id("add-obstacle-box").click(),
    ),
    "place": ("World", ["add-object-box"], "world-1-2", lambda b: b.page.get_by_test_id("add-obstacle-box").click()),
    "limits": (
        "Program",
        ["step-add-joint"],
        "limit-turn_speed",
        lambda b: b.page.get_by_test_id("step-add-wait").click(),
    ),
    "points": ("Path", [], "path-n", lambda b: (b.tab("Move"), b.tab("Path"))),
    "ends": ("Path", [], "path-from-0", lambda b: (b.tab("Move"), b.tab("Path"))),
    "sequence": (
        "Sequence",
        ["add-posture"] * 2,
        "seq-1-seconds",
        lambda b: b.page.get_by_test_id("add-posture").click(),
    ),
    "units": ("World", ["add-object-box"], "world-1-size-0", lambda b: (b.button("rad"), b.button("m"))),
    "bounds": ("Route", [], "route-from-1", lambda b: b.button("Within")),
}


@pytest.mark.parametrize("what", FIELDS)
def test_what_cannot_be_read_stays_as_it_was_typed_until_it_is_put_right(bench, what):
    panel, presses, testid, change = FIELDS[what]
    bench.tab(panel)
    for press in presses:
        bench.page.get_by_test_id(press).click()
    field = bench.page.get_by_test_id(testid)
    before = field.input_value()
    field.press_sequentially("5..a")
    assert field.get_attribute("aria-invalid") == "true"
    text = field.input_value()
    change(bench)
    bench.rest()
    assert field.input_value() == text and field.get_attribute("aria-invalid") == "true"
    field.fill(before)
    assert field.get_attribute("aria-invalid") is None


def test_a_step_that_cannot_be_read_stays_open_and_nothing_is_run_or_written(bench):
    page = bench.page
    bench.tab("Program")
    for kind in ("joint", "wait"):
        page.get_by_test_id(f"step-add-{kind}").click()
    field = page.get_by_test_id("step-2-seconds")
    field.fill("x")
    for press in ("step-1", "step-add-line"):
        page.get_by_test_id(press).click(delay=200)
        assert "Step 2, seconds cannot be read" in page.locator("#remark").inner_text()
        assert field.input_value() == "x" and page.evaluate("document.activeElement.dataset.testid") == "step-2-seconds"
    bench.button("Move step 2 up")
    assert bench.value("workbench.program.map((s) => s.kind)") == ["joint", "wait"]
    for press, line, end in (
        ("run-program", "program-verdict", "Nothing was computed."),
        ("save-program", "save-verdict", "Nothing was written."),
    ):
        page.get_by_test_id(press).click(delay=200)
        said = bench.text(line)
        assert said.startswith("Step 2, seconds cannot be read") and said.endswith(end)
    field.press("Escape")
    page.get_by_test_id("step-1").click()
    assert field.count() == 0, "closed, now that it can be read"


def test_numbers_of_the_arm_and_the_world_hold_up_a_plan_from_their_own_panels(bench):
    page = bench.page
    bench.tab("World")
    page.get_by_test_id("add-obstacle-box").click()
    page.get_by_test_id("world-1-size-1").fill("1 +")
    bench.tab("Program")
    page.get_by_test_id("step-add-joint").click()
    page.get_by_test_id("run-program").click()
    assert bench.text("program-verdict").startswith("World: box 1, y cannot be read")
    bench.tab("DH table")
    page.get_by_test_id("dh-2-a").fill("abc")
    for panel, press, verdict in (("Path", "plan", "path-verdict"), ("Share", "report", "report-note")):
        bench.tab(panel)
        page.get_by_test_id(press).click()
        assert bench.text(verdict).startswith("DH table: Joint 2, a cannot be read")
    bench.tab("DH table")
    assert "The arm stays as it was" in bench.text("dh-wrong")


def test_the_reason_under_a_field_lets_the_press_through_to_the_field_below(bench):
    bench.page.get_by_test_id("q-1").fill("abc")
    bench.page.get_by_test_id("q-2").click(timeout=5000)
    assert bench.page.evaluate("document.activeElement.dataset.testid") == "q-2"


def test_an_answer_for_the_arm_before_is_not_shown_on_the_arm_that_is(bench):
    page = bench.page
    bench.tab("Path")
    bench.fill("path-n", 2000)
    bench.fill("path-to-0", 150)
    page.get_by_test_id("plan").click()
    bench.arm("kuka-lbr-iiwa-7-r800")
    bench.until("!document.querySelector('[data-testid=plan]').disabled")
    assert bench.value("workbench.motion") is None and bench.value("workbench.q.length") == 7
    assert "the answer is not shown" in bench.text("path-verdict")
    bench.arm("denso-vp6242")
    page.get_by_test_id("plan").click()
    bench.until("workbench.motion")
    assert bench.value("workbench.motion.q[0].length") == 6


@pytest.mark.parametrize("when", ["while it is computed", "afterwards"])
def test_a_verdict_goes_with_what_it_was_about(bench, when):
    page = bench.page
    bench.tab("Path")
    bench.fill("path-n", 500)
    bench.fill("path-to-0", 150)
    page.get_by_test_id("plan").click()
    if when == "afterwards":
        bench.until("workbench.motion")
        page.get_by_test_id("path-verdict").filter(has_text="reached").wait_for()
    bench.fill("path-to-1", -60)
    bench.until("!document.querySelector('[data-testid=plan]').disabled")
    verdict = page.get_by_test_id("path-verdict")
    assert "reached" not in verdict.inner_text()
    page.get_by_test_id("plan").click()
    verdict.filter(has_text="reached").wait_for()


def test_a_press_held_while_its_row_is_made_anew_is_not_lost(bench):
    page = bench.page
    bench.tab("World")
    for _ in range(2):
        page.get_by_test_id("add-obstacle-box").click()
    page.get_by_label("Name of box 1").fill("table")
    page.get_by_role("button", name="Remove box 2").click(delay=250)  # the name is taken as the field is left
    assert bench.value("workbench.world.map((t) => t.name)") == ["table"]
    assert page.get_by_label("Name of table").is_visible()


def test_two_things_have_two_names_and_each_has_one(bench):
    page = bench.page
    bench.tab("World")
    for _ in range(2):
        page.get_by_test_id("add-obstacle-box").click()
    for text, said in (("box 1", "There is a box 1 already"), ("  ", "A thing needs a name")):
        name = page.get_by_label("Name of box 2")
        name.fill(text)
        name.press("Enter")
        assert name.input_value() == "box 2" and said in page.locator("#remark").inner_text()


def test_a_matrix_that_cannot_be_read_goes_when_the_target_is_another(bench):
    page = bench.page
    bench.tab("Inverse")
    bench.button("Matrix")
    area = page.get_by_test_id("target-matrix")
    area.fill("1 2 3")
    bench.button("Position and angles")
    bench.button("Matrix")
    assert area.input_value() == "1 2 3" and area.get_attribute("aria-invalid") == "true"
    bench.button("Take the present pose")
    assert area.get_attribute("aria-invalid") is None and area.input_value().count("[") == 4


@pytest.mark.parametrize("how", ["typed", "pasted"])
def test_an_entry_that_was_refused_is_not_the_next_arms(bench, how):
    page = bench.page
    bench.tab("DH table")
    if how == "typed":
        bench.fill("dh-1-a", "1e400")
    else:
        page.evaluate("navigator.clipboard.writeText('nan\\t90\\ninf\\t0')")
        page.get_by_test_id("dh-1-a").focus()
        page.keyboard.press("Control+v")
    assert "The arm stays as it was" in bench.text("dh-wrong")
    bench.arm("three-r")
    cells = "[...document.querySelectorAll('[data-testid=dh-table] input.number')]"
    shown = f"{cells}.map((f) => Number(f.value) / 1000)"
    rows = bench.value(shown)
    assert rows[::4] == [j["a"] for j in bench.value("workbench.table.joints")] and bench.text("dh-wrong") == ""
    assert page.locator(".number.wrong").count() == 0


def test_an_entry_that_was_refused_is_not_the_next_states(bench):
    page = bench.page
    bench.tab("World")
    page.get_by_test_id("add-object-box").click()
    bench.rest()  # the address holds it
    kept = bench.value("location.hash")
    bench.fill("world-1-size-0", 33)
    bench.rest()
    bench.fill("world-1-size-0", "5..a")
    bench.value(f"(location.hash = '{kept}')")
    bench.until("workbench.history[0] === 'open a link'")
    size = bench.value("workbench.world[0].size[0]")
    assert float(page.get_by_test_id("world-1-size-0").input_value()) == pytest.approx(1000 * size)
    assert page.locator(".number.wrong").count() == 0


def test_a_joint_that_cannot_be_read_stays_while_the_table_is_edited(bench):
    page = bench.page
    bench.fill("q-1", "5..a")
    bench.tab("DH table")
    bench.fill("dh-2-a", 215)
    bench.tab("Move")
    assert page.get_by_test_id("q-1").input_value() == "5..a"


@pytest.mark.parametrize("change", ["limit", "step", "sequence", "path", "seconds"])
def test_a_motion_goes_once_what_it_was_planned_for_is_changed(bench, change):
    page = bench.page
    if change in ("limit", "step"):
        bench.joint_steps([10, 70, -140, 25, 50, 30], [20, 60, -150, 10, 40, 25])
        page.get_by_test_id("run-program").click()
    elif change == "sequence":
        bench.sequence(30, 2)
    else:
        bench.tab("Path")
        bench.plan((350, 0, 400, 0, 0, 0), (200, 100, 500, 0, 0, 0))
    bench.until("workbench.motion")
    chart = page.get_by_test_id("chart")
    assert chart.is_visible()
    {
        "limit": lambda: bench.fill("limit-turn_speed", 10),
        "step": lambda: bench.button("Remove step 2"),
        "sequence": lambda: bench.fill("seq-1-seconds", 9),
        "path": lambda: bench.fill("path-to-1", 50),
        "seconds": lambda: bench.fill("path-seconds", 9),
    }[change]()
    bench.until("!workbench.motion")
    assert chart.is_hidden()


def test_presses_and_entries_are_steps_of_their_own_however_fast(bench):
    page = bench.page
    for v in (10, 20, 30):
        bench.fill("q-1", v)
    bench.button("Undo")
    assert float(page.get_by_test_id("q-1").input_value()) == 20
    bench.tab("Program")
    for kind in ("wait", "wait", "gripper", "output"):
        page.get_by_test_id(f"step-add-{kind}").click()
    kinds = "workbench.program.map((s) => s.kind)"
    bench.button("Remove step 1")
    bench.button("Remove step 1")
    assert bench.value(kinds) == ["gripper", "output"]
    bench.button("Undo")
    assert bench.value(kinds) == ["wait", "gripper", "output"]
    bench.button("Undo")
    bench.button("Undo")
    bench.button("Undo")
    assert bench.value(kinds) == ["wait", "wait"]
    bench.tab("Sequence")
    bench.button("+ Present posture")
    bench.button("+ All named postures")
    count = "workbench.said.sequence.postures.length"
    assert bench.value(count) > 2
    bench.button("Undo")
    assert bench.value(count) == 1, "all of one press"


def test_a_script_is_taken_only_of_the_screen_as_it_is(bench):
    page = bench.page
    bench.tab("Share")
    save, code = page.get_by_test_id("save-python"), page.get_by_test_id("python")
    bench.until("!document.querySelector('[data-testid=save-python]').disabled")
    assert "denso-vp6242" in code.input_value()
    page.get_by_test_id("catalog").select_option("abb-irb140")
    seen = """() => new Promise((done) => {
      const of = (id) => document.querySelector(`[data-testid=${id}]`);
      const code = of("python"), save = of("save-python");
      const look = () => save.disabled ? requestAnimationFrame(look) : done([code.value, workbench.table.name]);
      const wait = () => workbench.table.name === 'abb-irb140' ? look() : requestAnimationFrame(wait);
      wait(); })"""
    text, name = page.evaluate(seen)
    assert f"load('{name}')" in text.replace('"', "'")
    # undone while the panel is open: nothing of the screen before can be taken, from that moment on
    page.get_by_role("button", name="Undo", exact=True).evaluate("e => e.click()")
    before = page.evaluate("() => [document.querySelector('[data-testid=python]').value, workbench.table.name]")
    assert before[0] == "" or before[1] in before[0]
    bench.until("!document.querySelector('[data-testid=save-python]').disabled")
    assert "denso-vp6242" in code.input_value() and save.is_enabled()


def test_what_a_server_that_was_away_left_said_is_put_right_when_it_is_back(people):
    served = Server()
    bench = people(url=served.url).open()
    bench.expected_errors = AwayErrors()
    page = bench.page
    page.get_by_test_id("catalog").wait_for()
    bench.tab("Program")
    page.get_by_test_id("step-add-wait").click()
    served.stop()
    bench.until("document.body.innerText.includes('reconnecting')")
    page.get_by_test_id("run-program").click()
    assert "the server is away" in bench.text("program-verdict")
    bench.tab("Analysis")
    page.get_by_test_id("reach-start").click()
    assert "the server is away" in bench.text("reach-note")
    served.start()
    bench.until("!document.body.innerText.includes('reconnecting')")
    page.get_by_test_id("reach-note").get_by_text("this was not answered. Ask again.").wait_for()
    assert "is back" in bench.text("reach-note")
    bench.tab("Program")
    assert "is back" in bench.text("program-verdict")
    page.get_by_test_id("run-program").click()
    bench.until("!document.querySelector('[data-testid=program-verdict]').textContent.includes('is back')")
    served.stop()


class AwayErrors:
    """What a browser writes into its console while nobody answers."""

    def __contains__(self, text: str) -> bool:
        return "WebSocket" in text or "ERR_CONNECTION" in text
