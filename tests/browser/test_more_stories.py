"""Stories around the arm itself: editing and undoing, sharing, restarting, sequences, clouds, equations, every arm."""

from __future__ import annotations

import json
import re

import numpy as np
import pytest

import pieper

from .conftest import SEED_003


def test_a_wrong_entry_is_marked_and_the_last_good_arm_stays(bench):
    bench.tab("DH table")
    before = bench.value("workbench.table")
    field = bench.page.get_by_test_id("dh-2-a")
    field.fill("210 +")
    assert field.get_attribute("aria-invalid") == "true"
    assert "Joint 2, a" in bench.text("dh-wrong")
    assert bench.value("workbench.table") == before
    bench.shot("wrong-entry", both=True)
    field.fill("2*150")
    field.press("Enter")
    assert bench.value("workbench.table.joints[1].a") == pytest.approx(0.3)
    assert bench.text("dh-wrong") == ""
    bench.button("Undo")
    assert bench.value("workbench.table.joints[1].a") == pytest.approx(0.21)
    bench.button("Redo")
    assert bench.value("workbench.table.joints[1].a") == pytest.approx(0.3)
    bench.page.keyboard.press("Control+z")
    assert bench.value("workbench.table.joints[1].a") == pytest.approx(0.21)


def test_joints_are_added_removed_reordered_and_made_prismatic(bench):
    bench.tab("DH table")
    bench.page.get_by_test_id("dh-3-type").click()
    assert bench.value("workbench.table.joints.map((j) => j.type).join('')") == "RRPRRR"
    bench.button("Move joint 3 up")
    assert bench.value("workbench.table.joints.map((j) => j.type).join('')") == "RPRRRR"
    bench.button("Remove joint 6")
    bench.page.get_by_test_id("add-joint").click()
    bench.page.get_by_test_id("add-joint").click()
    assert bench.value("workbench.table.joints.length") == 7
    bench.until("document.querySelector('[data-testid=arm-kind]').textContent.length > 20")
    bench.shot("prismatic", both=True)


def test_limits_zeros_base_and_tool_are_edited(bench):
    bench.tab("DH table")
    bench.button("Limits and zeros")
    bench.fill("dh-1-lower", "-90")
    bench.fill("dh-1-upper", "pi/2")
    bench.fill("dh-2-offset", "10")
    bench.fill("dh-1-lower", "120")
    assert "above the upper limit" in bench.text("dh-wrong")
    table = bench.value("workbench.table")
    assert table["joints"][0]["lower"] == pytest.approx(-np.pi / 2)
    assert table["joints"][0]["upper"] == pytest.approx(np.pi / 2)
    assert table["joints"][1]["offset"] == pytest.approx(np.radians(10))
    bench.page.get_by_text("Base and tool").click()
    bench.fill("tool-2", "100")
    bench.fill("base-0", "0.5 m")
    assert bench.value("workbench.table.tool[11]") == pytest.approx(0.1)
    assert bench.value("workbench.table.base[3]") == pytest.approx(0.5)
    bench.shot("limits-base-tool")


def test_converting_the_convention_keeps_the_arm_where_it_is(bench):
    before = bench.value("workbench.frames.at(-1)")
    bench.tab("DH table")
    bench.button("Modified (Craig)")
    assert bench.value("workbench.table.convention") == "modified"
    assert np.allclose(bench.value("workbench.frames.at(-1)"), before, atol=1e-12)
    bench.page.get_by_text("Up to 8 solutions").first.wait_for()


def test_units_are_those_that_the_person_picks(bench):
    bench.joints([30, 60, -150, 0, 40, 0])
    bench.page.get_by_test_id("unit-angle").get_by_role("button", name="rad").click()
    bench.page.get_by_test_id("unit-length").get_by_role("button", name="m", exact=True).click()
    assert float(bench.page.get_by_test_id("q-1").input_value()) == pytest.approx(np.pi / 6, abs=1e-4)
    x = float(re.sub("−", "-", bench.text("pose-x")))
    assert x == pytest.approx(bench.value("workbench.frames.at(-1)[3]"), abs=1e-5)


def test_the_whole_state_travels_in_a_link_and_in_a_file(bench, people):
    bench.arm("stanford-arm")
    bench.joints([30, 20, 300, 10, 40, 50])
    bench.page.get_by_test_id("unit-length").get_by_role("button", name="m", exact=True).click()
    bench.tab("Share")
    bench.until("document.querySelector('[data-testid=link]').value.includes('#s=')")
    bench.page.get_by_test_id("copy-link").click()
    bench.page.get_by_text("Copied").wait_for()
    link = bench.value("navigator.clipboard.readText()")
    bench.shot("share", both=True)
    with bench.page.expect_download() as saved:
        bench.page.get_by_test_id("save-state").click()
    state = saved.value.path().read_text()
    other = people().open(link.removeprefix(bench.url))
    assert exactly(other) == exactly(bench)
    assert other.value("workbench.q") == bench.value("workbench.q")
    third = people().open()
    third.tab("Share")
    third.page.get_by_test_id("state-file").set_input_files(
        {"name": "s.json", "mimeType": "application/json", "buffer": state.encode()}
    )
    third.until("workbench.table.name === 'stanford-arm'")
    assert np.allclose(third.value("workbench.q"), bench.value("workbench.q"), atol=1e-9)


def exactly(bench) -> list:
    """What makes the motion, to the last bit."""
    table = bench.value("workbench.table")
    keys = ("type", "a", "alpha", "d", "theta", "lower", "upper", "sign", "offset")
    return [[joint[k] for k in keys] for joint in table["joints"]] + [table["convention"], table["base"], table["tool"]]


@pytest.mark.parametrize("junk", ["#s=AAAA", "#s=" + "x" * 70_000, "#s=%00", "#nothing"])
def test_a_damaged_link_opens_the_first_arm_and_says_so(people, junk):
    one = people().open(junk)
    assert one.value("workbench.table.name") == "denso-vp6242"


def test_a_robot_file_is_opened_and_a_bad_one_is_explained(bench, tmp_path):
    path = tmp_path / "crx.toml"
    pieper.load("fanuc-crx-10ia").save(path)
    bench.tab("DH table")
    bench.page.get_by_test_id("robot-file").set_input_files(path)
    bench.until("workbench.table.name === 'fanuc-crx-10ia'")
    bad = tmp_path / "bad.toml"
    bad.write_text(path.read_text().replace("alpha_deg", "alpha_degrees", 1))
    bench.page.get_by_test_id("robot-file").set_input_files(bad)
    bench.page.get_by_text("alpha_degrees").first.wait_for()
    assert bench.value("workbench.table.name") == "fanuc-crx-10ia"


def test_the_server_restarted_under_an_open_page_loses_nothing(people, server):
    one = people()
    one.open()
    one.tab("DH table")
    one.fill("dh-2-a", "250")
    one.joints([15, 50, -140, 5, 30, 10])
    table, q = one.value("workbench.table"), one.value("workbench.q")
    server.stop()
    one.page.get_by_text("Server away").wait_for()
    one.page.get_by_test_id("slider-1").focus()
    one.page.keyboard.press("ArrowRight")
    assert one.value("workbench.q[0]") > q[0], "the hand is not stopped by a missing server"
    one.shot("server-away")
    server.start()
    one.until("document.querySelector('[data-testid=online]').textContent === ''")
    assert one.value("workbench.table") == table
    one.tab("Inverse")
    one.until("workbench.settled && workbench.solutions.rows.length === 8")
    one.expected_errors = [e for e in one.errors if "WebSocket" in e or "ERR_CONNECTION" in e]


def test_a_closed_tab_frees_its_session(people, server):
    one = people().open()
    held = len(server.sessions)
    one.page.close()
    for _ in range(100):
        if len(server.sessions) < held:
            return
        people().page.wait_for_timeout(50)
    raise AssertionError("the session is still held")


def test_a_joint_sequence_with_times(bench):
    """Seed 003: P0 to P4, 20 s a leg and 10 s to settle."""
    bench.arm("denso-vs6577")
    bench.tab("Sequence")
    postures = SEED_003
    for k, q in enumerate(postures):
        bench.page.get_by_test_id("add-posture").click()
        for i, value in enumerate(q):
            bench.fill(f"seq-{k}-q{i + 1}", value)
    bench.fill("seq-1-seconds", 20)
    bench.fill("seq-1-hold", 10)
    bench.button("Same times for all legs")
    bench.page.get_by_test_id("run-sequence").click()
    bench.page.get_by_text("5 postures in 120.00 s").wait_for()
    scrub = bench.page.get_by_test_id("scrub")
    scrub.focus()
    scrub.press("End")
    assert np.allclose(np.degrees(bench.value("workbench.q")), postures[-1], atol=1e-6)
    bench.page.get_by_role("button", name="Joint speeds").click()
    bench.shot("sequence", both=True)


def test_playing_moves_the_arm_along_the_motion(bench):
    bench.sequence(80, 2)
    bench.page.get_by_test_id("speed").select_option("4")
    bench.page.get_by_test_id("play").click()
    bench.until("Math.abs(workbench.q[0] - 80 * Math.PI / 180) < 1e-9")
    assert bench.value("workbench.trace") > 0


def test_a_cloud_of_reachable_points_with_progress_and_cancel(bench):
    bench.tab("Analysis")
    bench.until("Number(document.querySelector('[data-testid=fact-condition]').textContent) > 1")
    bench.page.get_by_test_id("reach-size").select_option("5000")
    bench.page.get_by_test_id("reach-start").click()
    bench.until("workbench.cloud === 5000")
    bench.page.get_by_text("random postures inside the limits").wait_for()
    bench.shot("cloud", both=True)
    drawn = bench.value("workbench.pictures")
    bench.button("Cut open")
    bench.until("n => workbench.pictures > n", drawn)
    bench.shot("cloud-cut")
    bench.page.get_by_test_id("reach-size").select_option("100000")
    bench.page.get_by_test_id("reach-start").click()
    bench.page.get_by_role("button", name="Cancel").click()
    bench.page.get_by_text(re.compile("Cancelled after|100,000 random")).wait_for()


@pytest.mark.parametrize("which", ["Forward", "Singularities", "Inverse"])
def test_equations_are_typeset(bench, which):
    bench.tab("Equations")
    bench.page.get_by_test_id("which-equations").get_by_role("button", name=which).click()
    bench.page.get_by_test_id("equations").locator(".katex").first.wait_for()
    assert bench.page.get_by_test_id("equations").locator(".katex-error").count() == 0
    if which == "Forward":
        value = bench.page.locator("[data-entry='3']").inner_text()
        x = bench.value("workbench.frames.at(-1)[3]") * 1000
        assert float(re.sub("−", "-", value).strip("= m")) == pytest.approx(x, abs=0.006)
        bench.button("Numbers")
        cosine = f"{np.cos(bench.value('workbench.q[0]')):.4f}"
        bench.page.get_by_test_id("equations").get_by_text(cosine).first.wait_for()
    bench.shot(f"equations-{which.lower()}", both=which == "Forward")


def test_arms_of_every_family_open_and_move(bench):
    names = (
        "three-r adept-cobra-600 stanford-arm rrp-wrist dfrobot-rob0036 fanuc-crx-10ia universal-robots-ur5e".split()
    )
    names += "motoman-ea1400n kuka-lbr-iiwa-14-r820 franka-panda kinova-gen3-7dof".split()
    assert set(names) <= set(pieper.catalog())
    bench.tab("Inverse")
    for name in names:
        bench.arm(name)
        arm = pieper.load(name)
        bench.answered()
        tool = np.array(bench.value("workbench.frames.at(-1)"))
        assert np.allclose(tool, arm.fk(bench.value("workbench.q")).ravel(), atol=1e-9)
        miss = np.linalg.norm(
            np.reshape(tool, (4, 4))[:3, 3] - np.reshape(bench.value("workbench.target"), (4, 4))[:3, 3]
        )
        assert miss < 1e-6, "the arm stands at its own target"
        bench.shot(f"arm-{name}")


def test_the_report_of_this_arm_with_one_click(bench):
    bench.tab("Share")
    with bench.page.expect_download(timeout=60_000) as saved:
        bench.page.get_by_test_id("report").click()
    html = saved.value.path().read_text()
    assert "<html" in html and "<script" not in html and "denso" in html.lower()


def test_the_state_of_a_foreign_file_is_refused(bench):
    bench.tab("Share")
    for content in ("{}", "not json", json.dumps({"pieper": 1, "table": {"joints": [{}] * 5}})):
        bench.page.get_by_test_id("state-file").set_input_files(
            {"name": "s.json", "mimeType": "application/json", "buffer": content.encode()}
        )
        bench.page.wait_for_selector("#remark.shown[data-tone=wrong]")
    assert bench.value("workbench.table.name") == "denso-vp6242"
