"""While an answer is awaited nothing of an earlier question passes for it: the server's line is held meanwhile."""

from __future__ import annotations

import contextlib

import numpy as np
import pytest

import pieper

from .conftest import Server
from .slow_machine import Line


@pytest.fixture(scope="module")
def line():
    return Line()


@pytest.fixture(scope="module")
def served(line):
    one = Server(line=line)
    yield one
    one.stop()


@pytest.fixture
def bench(people, served):
    return people(url=served.url).open()


@contextlib.contextmanager
def held(line):
    """Let no answer through meanwhile."""
    line.held = True
    try:
        yield
    finally:
        line.held = False


def test_the_solutions_of_an_earlier_target_are_marked_and_then_taken_back(bench, line):
    page = bench.page
    bench.joints([20, 60, -150, 10, 40, 25])
    bench.tab("Inverse")
    bench.answered(8)
    assert bench.value("workbench.ghosts") == 7
    answer, verdict = page.get_by_test_id("ik-answer"), page.get_by_test_id("ik-verdict")
    with held(line):
        bench.fill("target-2", 420)
        assert answer.get_attribute("aria-busy") == verdict.get_attribute("aria-busy") == "true"
        assert answer.evaluate("e => e.inert"), "nobody goes to a solution of another target"
        verdict.get_by_text("Solving").wait_for()
        assert bench.value("workbench.ghosts") == 0 and answer.evaluate("e => e.classList.contains('stale')")
        # another panel and back: what stands there is still of the target before
        bench.tab("Move")
        bench.tab("Inverse")
        verdict.get_by_text("Solving").wait_for()
    bench.answered()
    assert answer.get_attribute("aria-busy") is None and not answer.evaluate("e => e.inert")
    assert "Solving" not in bench.text("ik-verdict")
    T = np.reshape(bench.value("workbench.target"), (4, 4))
    rows = np.array([row["q"] for row in bench.value("workbench.solutions.rows")])
    assert T[2, 3] == pytest.approx(0.42) and np.allclose(pieper.load("denso-vp6242").fk(rows), T, atol=1e-9)
    assert bench.value("workbench.ghosts") == len(rows) - 1


def test_a_target_changed_on_another_panel_has_no_solutions_until_it_is_asked(bench):
    bench.joints([20, 60, -150, 10, 40, 25])
    bench.tab("Inverse")
    bench.answered(8)
    bench.fill("target-2", 420)
    bench.answered()
    bench.tab("Matrices")
    bench.page.keyboard.press("Control+z")
    bench.until("Math.abs(workbench.target[11] - 0.42) > 1e-3")
    assert bench.value("workbench.solutions") is None
    bench.tab("Inverse")
    bench.answered(8)
    T = np.reshape(bench.value("workbench.target"), (4, 4))
    rows = np.array([row["q"] for row in bench.value("workbench.solutions.rows")])
    assert np.allclose(pieper.load("denso-vp6242").fk(rows), T, atol=1e-9)


def test_how_an_arm_is_solved_is_not_said_of_the_arm_that_it_became(bench, line):
    bench.tab("Equations")
    page = bench.page
    page.get_by_role("button", name="Inverse", exact=True).click()
    page.get_by_test_id("formula-values").wait_for()
    bench.tab("DH table")
    bench.rest()
    with held(line):
        bench.fill("dh-1-a", 31)
        for testid in ("sentence", "arm-kind"):
            page.get_by_test_id(testid).get_by_text("Looking how it is solved").wait_for()
        bench.tab("Equations")
        page.get_by_test_id("equations-note").get_by_text("Deriving").wait_for()
        assert page.get_by_test_id("formula-values").count() == 0
        assert page.get_by_test_id("equations").inner_text() == ""
    bench.until("!document.querySelector('[data-testid=sentence]').textContent.includes('Looking how')")
    bench.rest()
    assert "Up to" in bench.text("sentence") and bench.text("equations") != ""


def test_a_distance_of_an_earlier_posture_is_taken_back(bench, line):
    page = bench.page
    bench.tab("World")
    page.get_by_test_id("watch").check()
    bench.until("workbench.clearance?.metres > 0")
    bench.rest()
    with held(line):
        bench.tab("Move")
        bench.fill("q-2", 40)
        bench.tab("World")
        page.get_by_test_id("clearance").get_by_text("Measuring").wait_for()
    bench.until("workbench.clearance?.metres > 0")
    assert "apart" in bench.text("clearance")


def test_a_question_that_is_changed_before_its_answer_leaves_nothing_of_the_one_before(bench, line):
    page = bench.page
    bench.tab("Path")
    bench.plan((350, 0, 400, 0, 0, 0), (200, 100, 500, 0, 0, 0))
    page.get_by_text("All 50 points were reached.").wait_for()
    assert page.get_by_test_id("branches").get_by_role("button").count() == 8
    with held(line):
        page.get_by_test_id("plan").click()
        verdict = page.get_by_test_id("path-verdict")
        assert verdict.get_attribute("aria-busy") == "true"
        bench.fill("path-to-0", 210)
        bench.until("document.querySelector('[data-testid=path-verdict]').hidden")
        assert page.get_by_test_id("branches").get_by_role("button").count() == 0
        assert not page.get_by_test_id("chart").is_visible()
    verdict.get_by_text("What was asked was changed meanwhile").wait_for()
    assert verdict.get_attribute("aria-busy") is None


def test_pieces_of_another_arms_cloud_are_not_taken(bench, line):
    page = bench.page
    bench.tab("Analysis")
    with held(line):
        page.get_by_test_id("reach-start").click()
        bench.tab("DH table")
        bench.fill("dh-1-a", 31)
    bench.rest()
    bench.tab("Analysis")
    page.get_by_test_id("reach-note").get_by_text("changed meanwhile").wait_for()
    assert bench.value("workbench.cloud") == 0
    assert not page.locator(".legend-scale").is_visible()


def test_self_motions_stay_unfolded_and_their_thumbs_follow_the_arm(bench):
    page = bench.page
    bench.arm("kuka-lbr-iiwa-7-r800")
    bench.tab("Inverse")
    bench.button("Take the present pose")
    bench.answered()
    motions = page.get_by_test_id("self-motions")
    assert motions.locator("summary").count() == 1
    motions.locator("summary").click()
    shown = motions.get_by_role("slider").count()
    assert shown > 1
    bench.button("Take the present pose")
    bench.answered()
    assert motions.get_by_role("slider").count() == shown, "what was unfolded is not folded by an answer"
    first = motions.get_by_role("slider").first
    at = first.evaluate("e => [e.dataset.testid, e.value]")
    first.focus()
    for _ in range(2):
        first.press("PageUp")
    q = bench.value("workbench.q")
    moved = first.evaluate("e => [e.dataset.testid, e.value]")
    page.keyboard.press("Control+z")
    bench.until("q => workbench.q.some((v, i) => Math.abs(v - q[i]) > 1e-6)", q)
    at_rest = "at => Math.abs(document.querySelector(`[data-testid=${at[0]}]`).value - at[1]) < 1e-3"
    bench.until(at_rest, [at[0], float(at[1])])
    assert moved != at
