"""States taken while a page is open: a link put into its address, back and forward, a file; undone again."""

from __future__ import annotations

import json


def given_link(people) -> tuple[str, list[float]]:
    """Return the address of another arm's state behind the host, and the posture that it holds."""
    other = people().open()
    other.arm("abb-irb140")
    other.joints([11, 22, 33, 10, 40, 25])
    other.rest()
    return other.value("location.hash"), other.value("workbench.q")


def test_a_link_put_into_the_address_of_an_open_page_is_opened_and_can_be_undone(people):
    hash_, posture = given_link(people)
    bench = people().open()
    bench.joints([20, 60, -150, 10, 40, 25])
    bench.rest()
    before = bench.value("[workbench.table, workbench.q]")
    bench.value(f"(location.hash = {json.dumps(hash_)})")
    bench.until("workbench.table.name === 'abb-irb140'")
    assert bench.value("workbench.q") == posture
    undo = bench.page.get_by_role("button", name="Undo", exact=True)
    assert "open a link" in undo.get_attribute("title")
    undo.click()
    assert bench.value("[workbench.table, workbench.q]") == before
    # the browser's own way back leads to the state before, too
    bench.page.keyboard.press("Control+Shift+z")
    bench.until("workbench.table.name === 'abb-irb140'")
    bench.rest()
    bench.page.go_back()
    bench.until("workbench.table.name === 'denso-vp6242'")
    assert bench.value("[workbench.table, workbench.q]")[1] == before[1]


def test_a_spoilt_link_says_so_and_changes_nothing(bench):
    bench.joints([20, 60, -150, 10, 40, 25])
    before = bench.value("[workbench.table, workbench.q]")
    bench.value("(location.hash = '#s=AAAA')")
    bench.page.get_by_text("The link could not be read").first.wait_for()
    assert bench.value("[workbench.table, workbench.q]") == before


def test_opening_a_state_file_is_one_step_that_can_be_undone(bench, tmp_path):
    bench.tab("Program")
    for kind in ("joint", "wait", "gripper"):
        bench.page.get_by_test_id(f"step-add-{kind}").click()
    steps = bench.value("workbench.program")
    file = tmp_path / "state.json"
    bench.tab("Share")
    with bench.page.expect_download() as saved:
        bench.page.get_by_role("button", name="Save the state").click()
    kept = json.loads(saved.value.path().read_text())
    kept["program"]["steps"] = []
    file.write_text(json.dumps(kept))
    bench.page.get_by_test_id("state-file").set_input_files(file)
    bench.until("workbench.program.length === 0")
    undo = bench.page.get_by_role("button", name="Undo", exact=True)
    assert "open a state" in undo.get_attribute("title")
    undo.click()
    assert bench.value("workbench.program") == steps
    undo.click()
    assert [s["kind"] for s in bench.value("workbench.program")] == ["joint", "wait"], "what was done before stands too"


def test_a_call_moved_before_what_it_calls_stays_and_says_why(bench):
    bench.tab("Program")
    for kind in ("joint", "wait", "call"):
        bench.page.get_by_test_id(f"step-add-{kind}").click()
    call = {"kind": "call", "first": 1, "last": 2, "times": 1}
    assert bench.value("workbench.program")[2] == call
    bench.page.get_by_test_id("step-3").focus()
    bench.page.keyboard.press("Alt+ArrowUp")
    bench.page.keyboard.press("Alt+ArrowUp")
    assert bench.value("workbench.program")[0] == call | {"first": 2, "last": 3}
    bench.page.get_by_text("Only steps before it can be done again").wait_for()
    bench.page.get_by_test_id("run-program").click()
    bench.page.get_by_text("Step 1 cannot be done: it calls steps 2 to 3 again").wait_for()
    bench.page.get_by_test_id("step-1").focus()
    bench.page.keyboard.press("Alt+ArrowDown")
    bench.page.keyboard.press("Alt+ArrowDown")
    assert bench.value("workbench.program")[2] == call
