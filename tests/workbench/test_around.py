"""Programs, the world, the script of the screen and things from Python, asked without a browser."""

from __future__ import annotations

import contextlib
import io
import threading

import numpy as np
import pytest

import pieper
from pieper.workbench import around, programs, snippet
from pieper.workbench.bench import Bench
from pieper.workbench.messages import Refused
from pieper.workbench.things import thing

LIMITS = {"speed": 3.0, "acceleration": 10.0, "jerk": None, "tool_speed": 0.5}


@pytest.fixture(scope="module")
def arm() -> pieper.Arm:
    return pieper.load("denso-vp6242")


def posture(*degrees: float) -> list[float]:
    return np.radians(degrees).tolist()


START, NEXT = posture(20, 60, -150, 10, 40, 25), posture(40, 60, -150, 10, 40, 25)


def run(arm: pieper.Arm, steps: list, **more) -> dict:
    message = {"steps": steps, "limits": LIMITS, "start": START, **more}
    return programs.run(arm, message, lambda part: None, threading.Event())


def test_a_program_runs_within_its_limits_and_says_what_binds(arm):
    found = run(arm, [{"kind": "joint", "q": START}, {"kind": "joint", "q": NEXT}, {"kind": "gripper", "value": 1}])
    assert found["failed"] is None and "Step 1: the arm is there already." in found["explain"]
    assert np.allclose(found["q"][-1], NEXT) and np.abs(found["dq"]).max() <= 3.0 * (1 + 1e-6)
    assert found["events"][0][1] == "gripper" and found["tight"] and found["margin"] <= 1 + 1e-9
    assert found["clear"] is None


def test_a_step_that_cannot_be_done_ends_the_program_before_it(arm):
    far = np.eye(4)
    far[0, 3] = 3.0
    found = run(arm, [{"kind": "joint", "q": NEXT}, {"kind": "line", "T": far.ravel().tolist()}])
    assert found["failed"]["step"] == 1 and found["failed"]["text"]
    assert np.allclose(found["q"][-1], NEXT)


@pytest.mark.parametrize(
    ("steps", "reason"),
    [
        ([], "1 to 200"),
        ([{"kind": "dance"}], "step 1, kind"),
        ([{"kind": "wait"}], "step 1, seconds"),
        ([{"kind": "joint", "q": [1.0]}], "step 1, q"),
        ([{"kind": "output", "port": -1}], "step 1, port"),
        (["joint"], "step 1"),
    ],
)
def test_a_step_that_is_none_is_refused_by_its_number(arm, steps, reason):
    with pytest.raises(Refused, match=reason):
        run(arm, steps)


def test_the_nearest_two_bodies_and_a_motion_that_runs_into_one(arm):
    q = np.array(NEXT)
    tool = arm.fk(q)
    T = np.eye(4)
    T[:3, 3] = tool[:3, 3] + [0, 0, 0.3]
    box = {"kind": "box", "name": "shelf", "T": T.ravel().tolist(), "size": [0.1, 0.1, 0.1], "role": "obstacle"}
    near = around.clearance(arm, {"q": NEXT, "world": [box]})
    said = arm.distance(q, pieper.Scene([pieper.Box(T, [0.1, 0.1, 0.1], "shelf")]))
    assert near["metres"] == pytest.approx(float(said)) and near["pair"] == [str(v) for v in said.pair]
    gap = np.linalg.norm(np.subtract(*near["points"]))
    assert gap == pytest.approx(near["metres"], abs=1e-9), "the points are as far apart as is said"
    inside = {**box, "T": np.block([[np.eye(3), tool[:3, 3:]], [np.zeros((1, 3)), 1]]).ravel().tolist()}
    hit = run(arm, [{"kind": "joint", "q": NEXT}], world=[inside])
    assert hit["clear"]["verdict"] == "HIT" and "shelf" in hit["clear"]["text"]
    free = run(arm, [{"kind": "joint", "q": NEXT}], world=[{**inside, "role": "object"}])
    assert free["clear"] is None, "what a gripper takes is no obstacle"


def test_the_script_of_the_screen_makes_the_same_arm_to_the_last_bit(arm):
    C = np.eye(6)
    C[2, 1] = 1.0
    other = pieper.Arm.from_dh(
        list(arm.description.rows), convention="standard", joint_types="RRRRRR", coupling=C, name="mine"
    )
    for one in (arm, other, pieper.load("stanford-arm").to("modified")):
        found: dict = {}
        exec("\n".join(["import numpy as np", "import pieper", *snippet.arm_lines(one)]), found)
        q = np.linspace(0.1, 0.7, one.n)
        assert np.array_equal(found["arm"].fk(q), one.fk(q))


def test_the_script_of_the_screen_keeps_the_world_and_what_of_the_program_cannot_be_done(arm):
    """Obstacles are made and asked after; the step that cannot be done and those behind it stand there as comments."""
    box = {"kind": "box", "name": "shelf", "T": pieper.pose(0.6, 0, 0).ravel().tolist(), "size": [0.1, 0.2, 0.3]}
    tube = {"kind": "cylinder", "name": "tube", "T": pieper.pose(0, 0.6, 0).ravel().tolist(), "r": 0.05, "h": 0.4}
    held = {**box, "name": "workpiece", "role": "object"}
    q = np.asarray(arm.postures["line-start"])
    far = pieper.pose(3, 0, 0).ravel().tolist()
    steps = [
        {"kind": "joint", "q": NEXT},
        {"kind": "line", "T": far},
        {"kind": "wait", "seconds": 0.5},
        {"kind": "output", "port": 3, "value": True},
    ]
    limits = {"speed": [2.0] * arm.n, "acceleration": [8.0] * arm.n}
    message = {"q": q.tolist(), "world": [box, tube, held], "program": {"steps": steps, "limits": limits}}
    message["program"]["start"] = q.tolist()
    text = snippet.python(arm, message)["text"]
    found: dict = {}
    with contextlib.redirect_stdout(io.StringIO()) as said:
        exec(text, found)
    assert found["scene"].names == ("shelf", "tube")
    assert float(found["arm"].distance(q, found["scene"])) == float(arm.distance(q, around.scene_of([box, tube])))
    assert "clear" in said.getvalue().lower() or "hit" in said.getvalue().lower()
    assert len(found["program"].instructions) == 1
    left = [line for line in text.splitlines() if line.startswith("#")]
    assert left[0].startswith("# step 2 cannot be done: ") and "reach" in left[0]
    assert [line.split("(")[0] for line in left[1:]] == ["# program.move_l", "# program.wait", "# program.output"]


@pytest.mark.parametrize(
    ("what", "kind"),
    [
        (np.eye(4), "frame"),
        (np.stack([np.eye(4)] * 3), "curve"),
        (np.zeros((5, 3)), "curve"),
        (np.zeros((5, 6)), "motion"),
        (pieper.Box(np.eye(4), [1, 2, 3]), "box"),
        (pieper.Capsule([0, 0, 0], [0, 0, 1], 0.1), "capsule"),
        (pieper.Cylinder(np.eye(4), 0.1, 0.2), "cylinder"),
    ],
)
def test_things_are_told_by_what_they_are(arm, what, kind):
    assert thing(arm, what, None, 0.1)["kind"] == kind


def test_what_could_be_two_things_or_none_is_asked_about(arm):
    three = pieper.load("three-r")
    with pytest.raises(pieper.InputError, match="points or postures: say kind="):
        thing(three, np.zeros((4, 3)), None, 0.1)
    assert thing(three, np.zeros((4, 3)), "postures", 0.1)["kind"] == "motion"
    with pytest.raises(pieper.InputError, match="nothing that can be shown"):
        thing(arm, np.zeros(5), None, 0.1)


def test_a_bench_reads_back_what_was_set_and_frames_only_this_machine():
    httpx = pytest.importorskip("httpx")
    with pieper.workbench("denso-vp6242", open_browser=False) as bench:
        assert isinstance(bench, Bench)
        bench.q = START
        assert np.array_equal(bench.q, START) and np.allclose(bench.T, bench.arm.fk(START))
        bench.target = bench.arm.fk(NEXT)
        assert np.allclose(bench.arm.fk(bench.q), bench.target, atol=1e-9) and len(bench.solutions)
        with pytest.raises(pieper.InputError, match="6 finite numbers"):
            bench.q = [1, 2]
        with pytest.raises(pieper.InputError, match="nothing shown|there is nothing"):
            bench.remove("no such thing")
        assert bench.wait(0.01) is False
        policy = httpx.get(bench.url).headers["content-security-policy"]
        assert "frame-ancestors http://localhost:* http://127.0.0.1:*" in policy
        assert bench.url in bench._repr_html_() and "<iframe" in bench._repr_html_()
        bench.arm = "abb-irb140"
        assert bench.arm.name == "abb-irb140" and bench.target is None and bench.q.shape == (6,)


def test_a_line_that_stops_is_told_at_once_and_its_cures_apart():
    from pieper.workbench import long_work

    arm = pieper.load("denso-vp6242")
    T0, T1 = (pieper.pose(x, y, z).ravel().tolist() for x, y, z in ((0.35, 0, 0.4), (0.9, 0.1, 0.5)))
    q = arm.ik(np.reshape(T0, (4, 4))).nearest(np.radians([0, 60, -150, 0, 90, 0]))
    line = {"T0": T0, "T1": T1, "n": 20, "start": q.tolist()}
    first, then = (
        long_work.KINDS[kind](arm, line, lambda part: None, threading.Event()) for kind in ("follow", "cures")
    )
    track = arm.follow(pieper.line(np.reshape(T0, (4, 4)), np.reshape(T1, (4, 4)), n=20), start=q)
    assert not first["complete"] and first["explain"] == track.explain(cures=False)
    assert then["explain"] == track.explain() and "ure" in then["explain"].replace(first["explain"], "")
