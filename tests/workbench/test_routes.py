"""What a page asks of routes: the library's own answer, its map in bits, an end turned, steps of a program."""

from __future__ import annotations

import base64
import threading

import numpy as np
import pytest

import pieper
from pieper.tolerances import ROUTE_STRAYS_M, ROUTE_STRAYS_RAD
from pieper.workbench import routes
from pieper.workbench.messages import Refused

STOP = threading.Event()


@pytest.fixture(scope="module")
def arm():
    return pieper.load("abb-irb2400")


@pytest.fixture(scope="module")
def asked():
    T0, T1 = (pieper.pose(0.9, y, 0.9, rpy=(180, 0, 0), degrees=True) for y in (-0.3, 0.3))
    return {"T0": T0.ravel().tolist(), "T1": T1.ravel().tolist(), "n": 40, "free": {"turn": "free"}}


def nothing(part):
    return None


@pytest.fixture(scope="module")
def found(arm, asked):
    return routes.run(arm, asked, nothing, STOP)


def test_the_map_is_what_the_solver_says_of_poses_turned_so(arm, asked, found):
    known, rng = found["map"], np.random.default_rng(0)
    shape = len(known["s"]), len(known["turn"])
    cells = [np.unpackbits(np.frombuffer(base64.b64decode(b), np.uint8))[: shape[0] * shape[1]] for b in known["open"]]
    T0, T1 = (np.reshape(asked[k], (4, 4)) for k in ("T0", "T1"))
    path = pieper.line(T0, T1, n=shape[0])
    for i, k in zip(rng.integers(shape[0], size=60), rng.integers(shape[1], size=60), strict=True):
        there = arm.ik(pieper.Freedom().turned(path[i], known["turn"][k]))
        open_now = {known["branches"][b] for b in range(len(cells)) if cells[b].reshape(shape)[i, k]}
        assert open_now == set(there.labels)


def test_postures_without_names_are_one_branch_and_not_one_for_each_row_of_a_pose():
    """An arm with a joint to spare has thousands of rows in a map; their numbers name nothing that goes on."""
    panda = pieper.load("franka-panda")
    T = panda.fk([0, -0.785, 0, -2.356, 0, 1.571, 0.785])
    asked = {"T0": T.ravel().tolist(), "T1": (pieper.pose(0, 0, -0.1) @ T).ravel().tolist(), "n": 20}
    found = routes.run(panda, asked | {"free": {"turn": "free"}}, nothing, STOP)
    assert found["found"] and found["branches"] == [routes.UNNAMED] and set(found["labels"]) == {0}
    known = found["map"]
    assert known["branches"] == [routes.UNNAMED]
    cells = np.unpackbits(np.frombuffer(base64.b64decode(known["open"][0]), np.uint8))
    shape = len(known["s"]), len(known["turn"])
    cells = cells[: shape[0] * shape[1]].reshape(shape)
    path, rng = pieper.line(T, np.reshape(asked["T1"], (4, 4)), n=shape[0]), np.random.default_rng(1)
    for i, k in zip(rng.integers(shape[0], size=20), rng.integers(shape[1], size=20), strict=True):
        reached = bool(len(panda.ik(pieper.Freedom().turned(path[i], known["turn"][k]))))
        assert reached or not cells[i, k]


def test_an_end_is_turned_on_its_branch_to_the_nearest_whole_turns(arm, asked, found):
    branch = found["branches"][found["labels"][0]]
    for turn in np.radians([-100, -20, 35, 170]):
        message = {"T": asked["T0"], "free": asked["free"], "turn": turn, "near": found["q"][0], "branch": branch}
        got = routes.posture(arm, message)
        T = pieper.Freedom().turned(np.reshape(asked["T0"], (4, 4)), turn)
        solutions = arm.ik(T)
        same = solutions.windings()
        same = same[
            [
                np.abs(np.angle(np.exp(1j * (solutions.q - q)))).max(1).argmin() == solutions.labels.index(branch)
                for q in same
            ]
        ]
        assert got["label"] == branch
        nearest = same[np.linalg.norm(same - found["q"][0], axis=1).argmin()]
        assert np.allclose(got["q"], nearest)


def test_an_end_that_cannot_be_turned_so_is_refused_in_words(arm, asked, found):
    far = pieper.pose(5, 0, 0).ravel().tolist()
    got = routes.posture(arm, {"T": far, "free": asked["free"], "turn": 0, "near": found["q"][0]})
    assert got["q"] is None and "reach" in got["why"]


def test_a_route_becomes_steps_that_stay_on_it(arm, asked, found):
    got = routes.to_program(arm, asked, nothing, STOP)
    assert [s["kind"] for s in got["steps"]] == ["joint", "spline"]
    assert got["metres"] < ROUTE_STRAYS_M and got["radians"] < ROUTE_STRAYS_RAD
    limits = pieper.Limits(speed=np.ones(6), acceleration=np.full(6, 5.0))
    program = pieper.Program(arm, limits, start=np.array(got["steps"][0]["q"]))
    program.move_s(np.reshape(got["steps"][1]["through"], (-1, 4, 4)))
    q = program.motion(rate=100).q
    # every posture of the program is near one of the route, looked at densely
    dense = np.array([np.interp(np.linspace(0, 1, 4000), found["s"], joint) for joint in np.array(found["q"]).T]).T
    assert max(np.abs(dense - v).max(1).min() for v in q) < ROUTE_STRAYS_RAD + 1e-3


@pytest.mark.parametrize(
    ("change", "word"),
    [
        ({"n": 1}, "N"),
        ({"free": {"turn": [1, 0]}}, "lower end first"),
        ({"free": {"turn": "most"}}, "turn"),
        ({"free": {"axis": "w"}}, "axis"),
        ({"free": {"cone": 2}}, "cone"),
        ({"cost": "money"}, "cost"),
        ({"start": [0] * 6}, "start is not on the path"),
        ({"singularity": 2}, "singularity"),
        ({"free": None}, "free"),
    ],
)
def test_what_cannot_be_asked_is_refused_with_the_reason(arm, asked, change, word):
    with pytest.raises((Refused, pieper.PieperError), match=word):
        routes.run(arm, {**asked, **change}, nothing, STOP)
