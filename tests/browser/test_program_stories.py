"""Seeds 000 and 003 as programs, splines, circles about a centre, work frames, steps called again, moving pictures."""

from __future__ import annotations

import numpy as np
import pytest

import pieper

from .conftest import SEED_003


def add(bench, kind: str) -> None:
    bench.page.get_by_test_id(f"step-add-{kind}").click()


def type_pose(bench, step: int, numbers, key: str = "T") -> None:
    for i, value in enumerate(numbers):
        bench.fill(f"step-{step}-{key}-{i}", value)


def run(bench) -> dict:
    bench.page.get_by_test_id("run-program").click()
    bench.until("document.querySelector('[data-testid=program-verdict]').dataset.tone === 'good' && workbench.motion")
    return bench.value("workbench.motion")


def start_at(bench, degrees) -> None:
    bench.joints(degrees)
    bench.tab("Program")
    bench.page.get_by_test_id("start-here").click()


def test_seed_000_its_line_is_a_program(bench):
    """The line from (350, 0, 400) to (200, 100, 500) of the Denso, in the branch of the paper, with its true times."""
    arm = pieper.load("denso-vp6242")
    first = arm.ik(pieper.pose(0.35, 0, 0.4)).nearest(np.radians([0, 51.49, -150.64, 0, 99.15, 0]))
    start_at(bench, np.degrees(first).round(9))
    add(bench, "line")
    type_pose(bench, 1, (200, 100, 500, 0, 0, 0))
    motion = run(bench)
    q = np.array(motion["q"])
    assert np.allclose(np.degrees(q[-1]), [26.565051, 83.867278, -167.963671, 0, 84.096393, -26.565051], atol=1e-5)
    p = arm.fk(q)[:, :3, 3]
    along = (p - p[0]) @ (p[-1] - p[0]) / np.linalg.norm(p[-1] - p[0]) ** 2
    assert np.abs(p - (p[0] + along[:, None] * (p[-1] - p[0]))).max() < 1e-6, "the tool stays on its line"


def test_seed_003_its_postures_are_a_program_with_rests(bench):
    """P0 to P4 of the VS-6577, each joint move with a rest of 10 s, seen in the gripper's and the arm's true times."""
    bench.arm("denso-vs6577")
    postures = SEED_003
    start_at(bench, postures[0])
    for posture in postures[1:]:
        bench.joints(posture)
        bench.tab("Program")
        add(bench, "joint")
        add(bench, "wait")
        bench.fill(f"step-{len(bench.value('workbench.program'))}-seconds", 10)
    motion = run(bench)
    q, t = np.array(motion["q"]), np.array(motion["seconds"])
    rests = [when for when, kind, _ in motion["happens"] if kind == "wait"]
    assert len(rests) == 4
    for when, posture in zip(rests, postures[1:], strict=True):
        for moment in (when + 0.1, when + 5, when + 9.9):
            assert np.allclose(np.degrees(q[np.abs(t - moment).argmin()]), posture, atol=1e-6)
    bench.shot("seed-003-program", both=True)


@pytest.fixture
def irb(bench):
    bench.arm("abb-irb2400")
    arm = pieper.load("abb-irb2400")
    home = arm.ik(pieper.pose(0.9, -0.2, 0.9, rpy=(np.pi, 0, 0))).q[0]
    start_at(bench, np.degrees(home).round(9))
    return arm, home


def test_a_circle_about_its_centre_and_a_spline_through_poses(bench, irb):
    arm, home = irb
    add(bench, "circle")
    type_pose(bench, 1, (900, 200, 900, 180, 0, 0))
    bench.page.get_by_test_id("step-1-by").get_by_text("its centre").click()
    for i, value in enumerate((900, 0, 800)):
        bench.fill(f"step-1-centre-{i}", value)
    add(bench, "spline")
    bench.page.get_by_test_id("step-2-through").click()
    type_pose(bench, 2, (1000, 100, 1000, 180, 0, 0))
    bench.shot("program-steps", both=True)
    motion = run(bench)
    q = np.array(motion["q"])
    limits = pieper.Limits(speed=np.full(6, np.pi), acceleration=np.full(6, np.radians(600)), tool_speed=0.5)
    program = pieper.Program(arm, limits, start=home)
    program.move_c(None, pieper.pose(0.9, 0.2, 0.9, rpy=(np.pi, 0, 0)), centre=[0.9, 0, 0.8])
    through = np.reshape(bench.value("workbench.program[1].through"), (-1, 4, 4))
    program.move_s(through)
    own = program.motion(rate=200)
    assert np.isclose(motion["seconds"][-1], own.duration, rtol=1e-6) and np.allclose(q[-1], own.q[-1], atol=1e-6)
    bench.tab("Share")
    bench.until("document.querySelector('[data-testid=python]').value.includes('move_s')")
    space: dict = {}
    exec(bench.page.get_by_test_id("python").input_value(), space)  # the page's own words
    assert np.allclose(space["motion"].q[-1], q[-1])


def test_steps_are_called_again_in_another_work_frame(bench, irb):
    """What was taught in one frame is done again in another one beside it; moving steps keeps calling the same ones."""
    arm, _ = irb
    add(bench, "frame")
    type_pose(bench, 1, (900, -200, 900, 180, 0, 0))
    add(bench, "line")
    type_pose(bench, 2, (0, 0, 50, 0, 0, 0))
    add(bench, "line")
    type_pose(bench, 3, (50, 0, 50, 0, 0, 0))
    add(bench, "frame")
    type_pose(bench, 4, (900, 200, 900, 180, 0, 0))
    add(bench, "call")
    bench.fill("step-5-first", 2)
    bench.fill("step-5-last", 3)
    q = np.array(run(bench)["q"])
    p = arm.fk(q)[:, :3, 3]
    for corner in ((0.9, -0.2, 0.85), (0.95, -0.2, 0.85), (0.9, 0.2, 0.85), (0.95, 0.2, 0.85)):
        assert np.linalg.norm(p - corner, axis=1).min() < 1e-4
    # a step put before them all: the call names the same steps by their new numbers
    bench.page.get_by_test_id("step-5").click()
    add(bench, "wait")
    page = bench.page
    page.get_by_test_id("step-6").focus()
    for _ in range(5):
        page.keyboard.press("Alt+ArrowUp")
    call = bench.value("workbench.program.find((s) => s.kind === 'call')")
    assert (call["first"], call["last"]) == (3, 4)


def test_a_motion_is_drawn_as_gif_and_mp4(bench):
    bench.sequence(40, 1)
    bench.page.get_by_test_id("chart").wait_for()
    for name, begins in (("GIF", b"GIF89a"), ("MP4", None)):
        with bench.page.expect_download() as saved:
            bench.button(f"Save as {name}")
        content = saved.value.path().read_bytes()
        assert content.startswith(begins) if begins else content[4:8] == b"ftyp"
