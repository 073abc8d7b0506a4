"""Number fields, redundant arms and the camera: what is typed, pasted and slid, and where the picture stands."""

from __future__ import annotations

import numpy as np
import pytest

import pieper


def paste(bench, testid: str, text: str) -> None:
    """Put a text on the clipboard and paste it into a field."""
    bench.page.evaluate("t => navigator.clipboard.writeText(t)", text)
    bench.page.get_by_test_id(testid).focus()
    bench.page.keyboard.press("Control+v")


def test_a_field_says_why_restores_and_understands_a_comma(bench):
    page = bench.page
    field = page.get_by_test_id("q-1")
    before = field.input_value()
    field.fill("12,5,3")
    assert (
        "comma is the decimal sign" in bench.text("why") and page.get_by_test_id("why").get_attribute("role") == "alert"
    )
    assert field.get_attribute("aria-describedby") == "why"
    bench.shot("reason-under-the-field", both=True)
    field.press("Escape")
    assert field.input_value() == before and page.get_by_test_id("why").is_hidden()
    field.fill("12,5")
    assert bench.value("workbench.q[0]") == pytest.approx(np.radians(12.5))
    field.press("Escape")
    assert bench.value("workbench.q[0]") == pytest.approx(np.radians(float(before)), abs=1e-4)
    for leave in ("Enter", "Tab"):
        field.fill("12..3")
        assert "“.3” is not expected" in bench.text("why"), "the words are the person's own"
        field.press(leave)
        field.focus()
        field.press("Escape")
        assert field.input_value() == before, "Escape puts back what could be read, also after Enter and from elsewhere"


@pytest.mark.parametrize("form", ["tabs", "python", "matlab"])
def test_a_table_is_pasted_over_the_cells_as_one_step(bench, form):
    page = bench.page
    rows = [("0", "90", "125", "0"), ("210", "0", "0", "90"), ("-75", "-90", "0", "-90"), ("0", "90", "210", "0")]
    text = {
        "tabs": "\n".join("\t".join(r).replace(".", ",") for r in rows),
        "python": str([[float(v) for v in r] for r in rows]),
        "matlab": "[" + "; ".join(" ".join(r) for r in rows) + "]",
    }[form]
    bench.tab("DH table")
    bench.button("Blank")
    page.get_by_test_id("add-joint").click()
    paste(bench, "dh-1-a", text)
    bench.until("workbench.table.joints.length === 4")
    got = bench.value(
        "workbench.table.joints.map((j) => [j.a * 1000, j.alpha * 180 / Math.PI, j.d * 1000, j.theta * 180 / Math.PI])"
    )
    assert np.allclose(got, [[float(v) for v in r] for r in rows])
    assert bench.value("workbench.history")[0] == "paste a table"
    page.keyboard.press("Control+z")
    assert bench.value("workbench.table.joints.length") == 1, "one step, not sixteen"


def test_arrows_and_enter_go_from_cell_to_cell_and_no_digit_is_cut(bench):
    page = bench.page
    bench.tab("DH table")
    page.get_by_test_id("dh-1-a").focus()
    for key, there in (
        ("ArrowDown", "dh-2-a"),
        ("ArrowRight", "dh-2-alpha"),
        ("Enter", "dh-3-alpha"),
        ("ArrowUp", "dh-2-alpha"),
    ):
        page.keyboard.press(key)
        assert page.evaluate("document.activeElement.dataset.testid") == there
    page.keyboard.press("Alt+ArrowUp")
    assert bench.value("workbench.table.joints[1].alpha") == pytest.approx(np.radians(1))
    bench.fill("dh-2-d", "-123.456789")
    bench.fill("dh-2-alpha", "90 deg")
    uncut = """width => innerWidth === width && ![...document.querySelectorAll('input.number')].some(
        (e) => e.checkVisibility() && e.scrollWidth > e.clientWidth + 1)"""
    for width in (1280, 960, 1280):
        page.set_viewport_size({"width": width, "height": 800})  # a field that becomes narrower is measured anew
        bench.until(uncut, width)


def test_a_plan_never_runs_on_a_number_that_cannot_be_read(bench):
    bench.tab("Path")
    field, plan = bench.page.get_by_test_id("path-to-1"), bench.page.get_by_test_id("plan")
    field.fill("12 +")
    plan.click(delay=300)  # as long as a hand holds it down: the field is left before the button is let go
    said = bench.text("path-verdict")
    assert "To, Y cannot be read" in said and "Nothing was computed" in said
    # leaving the field neither puts the old number back nor lets another field speak for it
    to = bench.value("workbench.said.path.to")
    bench.fill("path-to-0", 1)
    assert field.input_value() == "12 +" and bench.value("workbench.said.path.to") == to
    bench.fill("path-to-1", 12)
    plan.click(delay=300)
    bench.until("!document.querySelector('[data-testid=path-verdict]').textContent.includes('read')")


def test_one_slider_of_a_redundant_arm_starts_where_the_arm_is_with_exact_intervals(bench):
    page = bench.page
    bench.arm("kuka-lbr-iiwa-14-r820")
    bench.joints([15, 40, 10, -70, 20, 50, 30])
    bench.tab("Inverse")
    motions = page.get_by_test_id("self-motions")
    first = motions.locator(":scope > .self-motion input")
    first.wait_for()
    assert first.count() == 1, "one slider; the others are folded away"
    arm, q = pieper.load("kuka-lbr-iiwa-14-r820"), np.array(bench.value("workbench.q"))
    found = arm.ik(arm.fk(q), redundancy={"joint_3": q[2]}).self_motions
    mine = [sm for sm in found if sm.contains(q)][0]
    assert np.allclose(
        bench.value("JSON.parse(document.querySelector('.self-motion input').dataset.inside)"), mine.inside
    )
    first.evaluate("e => e.dispatchEvent(new Event('input'))")
    assert np.abs(np.array(bench.value("workbench.q")) - q).max() < 2e-3, "it starts where the arm is"
    bench.shot("redundant-one-slider", both=True)


def test_a_wrist_turning_in_place_is_seen_and_a_limit_passed_is_red(bench):
    bench.joints([0, 60, -150, 0, 40, 0])
    bench.settle()
    picture = """() => { const c = document.querySelector('#view canvas'); return new Promise((done) => {
      const o = document.createElement('canvas'); o.width = c.width; o.height = c.height; const x = o.getContext('2d');
      workbench.withPicture(() => {
        x.drawImage(c, 0, 0); const d = x.getImageData(0, 0, o.width, o.height).data; let s = 0;
        for (let i = 0; i < d.length; i += 4) { s = (s * 31 + d[i]) % 1000003; }
        done(s); }); }); }"""
    before = bench.value(picture)
    bench.fill("q-6", 50)
    bench.settle()
    turned = bench.value(picture)
    assert turned != before, "the picture is another one"
    bench.fill("q-2", 220)
    bench.settle()
    assert bench.value("workbench.beyond") == [2], "a joint beyond its limit is drawn red"
    bench.shot("beyond-the-limit", both=True)
    bench.fill("q-2", 60)
    assert bench.value("workbench.beyond") == []


def test_the_camera_comes_back_when_the_cause_of_a_zoom_is_gone(bench):
    bench.settle()
    before = bench.value("workbench.camera")
    bench.tab("Inverse")
    bench.fill("target-0", 1500)
    bench.until("c => Math.hypot(...workbench.camera.map((v, i) => v - c[i])) > 0.2", before)
    bench.settle()
    bench.tab("Move")
    bench.until("c => Math.hypot(...workbench.camera.map((v, i) => v - c[i])) < 0.02", before)


def test_a_blank_table_opens_at_a_metre_and_scrolls_are_kept_a_tab(people):
    bench = people(height=500).open()
    bench.tab("DH table")
    bench.button("Blank")
    bench.settle()
    (_, top), (_, foot) = (bench.value(f"workbench.toScreen([0, 0, {z}])") for z in (1, 0))
    assert 100 < foot - top < 450, "a metre is most of the picture"
    bench.button("Undo")
    bench.settle()
    panels = bench.page.locator("#panels")
    panels.evaluate("e => { e.scrollTop = 120; }")
    bench.tab("Move")
    bench.tab("DH table")
    assert panels.evaluate("e => e.scrollTop") == 120
