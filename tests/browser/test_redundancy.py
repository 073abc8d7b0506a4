"""Arms with joints to spare: each redundant coordinate by name, chosen or free, and the self-motions of a pose."""

from __future__ import annotations

import json
from math import pi

import numpy as np
import pytest

import pieper


@pytest.fixture
def eight() -> pieper.Arm:
    """A spherical shoulder and wrist, an elbow with an offset, and a link beyond the wrist."""
    rows = [(0, 1, 0.3), (0, -1, 0), (0, 1, 0.4), (0.05, -1, 0), (0, 1, 0.4), (0, -1, 0), (0, 1, 0.1), (0.1, 0, 0.1)]
    return pieper.Arm.from_dh(
        [pieper.DH(a, turn * pi / 2, d, 0) for a, turn, d in rows],
        convention="standard",
        joint_types="R" * 8,
        limits=[None] * 7 + [(-pi / 2, pi / 2)],
        name="eight",
    )


def chosen(page):
    return page.get_by_role("group", name="Redundant coordinates of the arm")


def test_two_redundant_joints_are_held_by_slider_and_by_field(bench, eight, tmp_path):
    page = bench.page
    eight.save(tmp_path / "eight.toml")
    bench.tab("DH table")
    page.get_by_test_id("robot-file").set_input_files(tmp_path / "eight.toml")
    bench.until("document.querySelector('[data-testid=arm-kind]').textContent.includes('joint_1, joint_8')")
    bench.joints([12, 25, 30, 60, 40, 50, 20, 35])
    bench.tab("Inverse")
    bench.answered()
    assert chosen(page).get_by_text("\u221290° … 90°").count() == 1, "the limits of the redundant joint are shown"
    chosen(page).get_by_label("Value of joint_8").fill("20")
    chosen(page).get_by_label("Value of joint_8").press("Enter")
    bench.until("Math.abs(workbench.q[7] - 20 * Math.PI / 180) < 1e-9")
    slider = chosen(page).get_by_role("slider", name="Slide joint_1")
    slider.focus()
    target = np.array(bench.value("workbench.target"))
    for k in range(1, 4):
        slider.press("ArrowRight")
        bench.until("v => Math.abs(workbench.q[0] - v) < 1e-9", np.radians(12 + k))
        assert np.allclose(bench.value("workbench.frames.at(-1)"), target, atol=1e-6), "the tool stands still"
    bench.answered()
    rows = np.array([row["q"] for row in bench.value("workbench.solutions.rows")])
    assert len(rows) == 8 and np.allclose(rows[:, 0], np.radians(15)) and np.allclose(rows[:, 7], np.radians(20))
    assert np.allclose(eight.fk(rows), np.reshape(target, (4, 4)), atol=1e-9)
    assert page.get_by_test_id("self-motions").get_by_role("slider").first.is_visible()
    bench.shot("redundant-eight", both=True)
    field = chosen(page).get_by_label("Value of joint_8")
    field.fill("120")
    assert field.get_attribute("aria-invalid") == "true" and "above the limit" in field.get_attribute("title")


def test_the_spare_turns_of_a_position_task(bench):
    page = bench.page
    bench.joints([20, 60, -150, 10, 40, 25])
    bench.tab("Inverse")
    bench.answered()
    page.get_by_label("Task").select_option("position")
    bench.answered()
    names = [el.get_attribute("aria-label") for el in chosen(page).get_by_role("slider").all()]
    assert names == ["Slide tool turn 1", "Slide tool turn 2", "Slide tool turn 3"]
    point = np.array(bench.value("workbench.target"))[[3, 7, 11]]
    slider = chosen(page).get_by_role("slider", name="Slide tool turn 2")
    slider.focus()
    for _ in range(3):
        slider.press("PageUp")
    bench.answered()
    for row in bench.value("workbench.solutions.rows"):
        assert np.allclose(pieper.load("denso-vp6242").fk(row["q"])[:3, 3], point, atol=1e-9)
    assert page.get_by_test_id("self-motions").get_by_text("the tool point stands still").count() > 0
    slider = page.get_by_test_id("self-motions").get_by_role("slider").first
    slider.focus()
    before = np.array(bench.value("workbench.q"))
    slider.press("PageUp")
    assert len(bench.value("workbench.q")) == 6
    assert np.abs(np.array(bench.value("workbench.q")) - before).max() > 1e-3
    bench.shot("redundant-position")


def test_a_seven_joint_arm_slides_along_its_self_motion(bench):
    page = bench.page
    bench.arm("kuka-lbr-iiwa-14-r820")
    bench.joints([15, 40, 10, -70, 20, 50, 30])
    bench.tab("Inverse")
    bench.answered()
    slider = page.get_by_test_id("self-motions").get_by_role("slider").first
    target, start = np.array(bench.value("workbench.target")), np.array(bench.value("workbench.q"))
    slider.focus()
    moved = 0.0
    for _ in range(5):
        slider.press("PageUp")
        assert np.allclose(bench.value("workbench.frames.at(-1)"), target, atol=1e-6)
        moved = max(moved, np.abs(np.array(bench.value("workbench.q")) - start).max())
    assert moved > 0.2
    bench.shot("redundant-seven", both=True)


def test_the_green_parts_of_a_self_motion_are_inside_the_limits_whichever_way_one_came(bench):
    """A closed curve that turns joints all the way round: what it has turned on the red part is taken off again."""
    arm = pieper.load("kuka-lbr-iiwa-7-r800")
    bench.arm(arm.name)
    bench.tab("Inverse")
    bench.button("Take the present pose")
    page = bench.page
    motions = page.get_by_test_id("self-motions")
    bench.answered()
    for fold in motions.locator("summary").all():
        fold.click()
    lower, upper = np.transpose(arm.limits)
    visited = 0
    for slider in motions.get_by_role("slider").all():
        inside = json.loads(slider.get_attribute("data-inside") or "[]")
        for way in (np.linspace(0, 1, 31), np.linspace(1, 0, 31), [0.999, 0.001, 0.5, 0.0, 0.7]):
            for at in way:
                slider.fill(str(at))
                if any(a + 0.01 < at < b - 0.01 for a, b in inside):
                    q = np.array(bench.value("workbench.q"))
                    assert (q > lower - 1e-3).all() and (q < upper + 1e-3).all(), (at, inside, np.degrees(q))
                    visited += 1
    assert visited > 30


@pytest.mark.parametrize("value", [{"joint_9": 0.1}, {"joint_1": 99.0}, [1.0], {}, {"joint_1": None}])
def test_a_redundancy_that_cannot_be_is_refused_with_a_reason(value):
    from pieper.workbench import answers
    from pieper.workbench.messages import Refused

    arm = pieper.load("kuka-lbr-iiwa-14-r820")
    T = arm.fk(np.zeros(7)).ravel().tolist()
    with pytest.raises((Refused, pieper.InputError), match="redundan|coordinate|finite|object|can be held"):
        answers.ik(arm, {"T": T, "redundancy": value})
