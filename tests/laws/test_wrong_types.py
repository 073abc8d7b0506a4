"""Whatever of the wrong kind goes into a public function, the error is pieper's own and says what is allowed."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import pieper

QUARTER = np.pi / 2

#: What nobody means: none of it is right anywhere, though some of it may be taken (a number where a number goes).
WRONG: tuple[Any, ...] = (
    None,
    "nonsense",
    "1.4",
    b"bytes",
    object(),
    1 + 2j,
    np.array([1 + 2j] * 6),
    float("nan"),
    float("inf"),
    -1,
    3,
    1.5,
    True,
    [],
    {},
    {"joint_1": "x"},
    {1: 2},
    [[1, 2], [3]],
    ["a", "b"],
    [None],
    np.zeros(0),
    np.zeros((2, 3)),
    np.full(6, np.nan),
    np.array(["a"] * 6),
    (1, 2, 3),
    len,
    int,
    {1, 2},
)


class Calls:
    """Right calls of everything public, name -> (function, its arguments by name)."""

    def __init__(self, folder: Any) -> None:
        arm = self.arm = pieper.load("denso-vp6242")
        q = np.array([0.3, 0.5, -2.4, 0.6, 0.7, 0.2])
        T = arm.fk(q)
        Ts = arm.fk(q + np.linspace(0, 0.1, 5)[:, None])
        panda = pieper.load("panda")
        sols = arm.ik(T)
        limits = pieper.Limits(speed=1.0, acceleration=5.0, jerk=50.0)
        path = pieper.line(Ts[0], Ts[1], n=5)
        track = arm.follow(path, start=q)
        motion = pieper.time_law(track, limits)
        scene = pieper.Scene([pieper.Box(np.eye(4) + 3 * np.eye(4, k=3), (0.1, 0.1, 0.1))])
        rows = [pieper.DH(a=0.1, alpha=QUARTER, d=0.2, theta=0.0), pieper.DH(a=0.3, alpha=0.0, d=0.0, theta=0.0)]
        program = pieper.Program(arm, limits, start=q)
        near = T.copy()
        near[2, 3] += 0.01
        file = folder / "arm.toml"
        arm.save(file)
        calibrated = np.vstack([q + 0.05 * i * np.array([1, -1, 1, -1, 1, -1]) for i in range(30)])
        self.table: dict[str, tuple[Callable[..., Any], dict[str, Any]]] = {
            "DH": (pieper.DH, {"a": 0.1, "alpha": 0.0, "d": 0.0, "theta": 0.0}),
            "load": (
                pieper.load,
                {
                    "source": str(file),
                    "base": None,
                    "tip": None,
                    "snap": None,
                    "missing_limits": "refuse",
                    "xacro_args": None,
                },
            ),
            "find_arms": (pieper.find_arms, {"words": "", "maker": "kuka", "joints": 6, "payload": 1.0, "reach": 1.0}),
            "ur_calibrated": (pieper.ur_calibrated, {"path": str(file)}),
            "evaluate": (pieper.evaluate, {"text": "1"}),
            "from_dh": (
                pieper.Arm.from_dh,
                {
                    "rows": rows,
                    "convention": "standard",
                    "joint_types": "RR",
                    "limits": [(-1, 1), None],
                    "base": np.eye(4),
                    "tool": np.eye(4),
                    "name": "two",
                    "joint_names": ["a", "b"],
                    "sign": [1, -1],
                    "offset": [0, 0.1],
                    "coupling": np.eye(2),
                    "snap": None,
                },
            ),
            "from_axes": (
                pieper.Arm.from_axes,
                {
                    "axes": np.eye(3),
                    "points": np.zeros((3, 3)),
                    "home": np.eye(4),
                    "joint_types": "RRR",
                    "limits": [None] * 3,
                    "name": "three",
                    "joint_names": ["a", "b", "c"],
                    "snap": None,
                },
            ),
            "from_opw": (
                pieper.Arm.from_opw,
                {
                    "a1": 0.1,
                    "a2": -0.1,
                    "b": 0.0,
                    "c1": 0.5,
                    "c2": 0.6,
                    "c3": 0.7,
                    "c4": 0.1,
                    "offsets": [0.0] * 6,
                    "signs": [1] * 6,
                    "limits": None,
                    "name": "opw",
                },
            ),
            "pose": (
                pieper.pose,
                {"x": 0.1, "y": 0.2, "z": 0.3, "rpy": (0.1, 0.2, 0.3), "degrees": False, "mm": False},
            ),
            "pose quat": (pieper.pose, {"x": 0.1, "y": 0.2, "z": 0.3, "quat_wxyz": (1, 0, 0, 0)}),
            "pose R": (pieper.pose, {"x": 0.1, "y": 0.2, "z": 0.3, "R": np.eye(3)}),
            "read_pose": (pieper.read_pose, {"T": T, "notation": "rpy", "degrees": False, "mm": False}),
            "poses": (
                pieper.poses,
                {
                    "position": np.zeros((2, 3)),
                    "notation": "rpy",
                    "numbers": np.zeros((2, 3)),
                    "degrees": False,
                    "mm": False,
                },
            ),
            "line": (pieper.line, {"T0": Ts[0], "T1": Ts[1], "n": 5}),
            "fk": (arm.fk, {"q": q}),
            "frames": (arm.frames, {"q": q}),
            "jacobian": (arm.jacobian, {"q": q}),
            "ik": (arm.ik, {"T": T, "task": None, "redundancy": None, "scene": None}),
            "ik position": (arm.ik, {"T": T, "task": "position", "redundancy": {"joint_3": -2.4}}),
            "ik 7R": (panda.ik, {"T": panda.fk("zero"), "redundancy": {"panda_joint3": 0.1}}),
            "ik_many": (
                arm.ik_many,
                {
                    "Ts": Ts,
                    "threads": 1,
                    "near": q,
                    "start": None,
                    "weights": np.ones(6),
                    "invalid": "raise",
                    "out": None,
                    "progress": None,
                },
            ),
            "ik_many previous": (arm.ik_many, {"Ts": Ts, "near": "previous", "start": q}),
            "closest": (arm.closest, {"T": T, "task": None, "weights": None}),
            "nearest": (sols.nearest, {"q_now": q, "weights": np.ones(6)}),
            "nearest_row": (sols.nearest_row, {"q_now": q}),
            "plan_for": (arm.plan_for, {"task": "pose"}),
            "arm_angle": (panda.arm_angle, {"q": panda.fk("zero")[0, :3].repeat(3)[:7] * 0.1}),
            "with_tool": (arm.with_tool, {"tool": np.eye(4)}),
            "with_base": (arm.with_base, {"base": np.eye(4)}),
            "with_limits": (arm.with_limits, {"limits": {"joint_1": (-1, 1)}}),
            "with_joints_locked": (arm.with_joints_locked, {"values": {"joint_1": 0.1}}),
            "to": (arm.to, {"convention": "modified"}),
            "follow": (arm.follow, {"path": path, "start": q}),
            "configuration": (arm.configuration, {"q": q, "maker": "denso"}),
            "save": (arm.save, {"path": str(folder / "out.toml")}),
            "distance": (arm.distance, {"q": q, "scene": scene}),
            "clear": (arm.clear, {"q_path": [q, q + 0.1], "scene": scene, "margin": 0.0, "gap": None}),
            "with_bodies": (
                arm.with_bodies,
                {"where": {"tool": pieper.Box(np.eye(4), (0.1, 0.1, 0.1))}, "allowed": (), "instead": False},
            ),
            "calibrate": (
                arm.calibrate,
                {
                    "q": calibrated,
                    "measured": arm.fk(calibrated),
                    "kind": "pose",
                    "sigma": None,
                    "hold": (),
                    "joint_terms": (),
                    "loss": "linear",
                    "holdout": 0.25,
                },
            ),
            "choose_poses": (arm.choose_poses, {"k": 12, "candidates": calibrated, "kind": "pose", "sigma": None}),
            "code": (arm.code, {"language": "python", "path": str(folder / "c.py"), "name": "arm"}),
            "reach_map": (
                arm.reach_map,
                {
                    "box": ((0.2, 0.3), (0.0, 0.1), (0.2, 0.3)),
                    "step": 0.1,
                    "orientations": (4, 4),
                    "symmetry": "auto",
                    "store": None,
                    "executor": None,
                    "progress": None,
                    "measure": False,
                    "scene": None,
                },
            ),
            "base_places": (arm.base_places, {"Ts": Ts, "x": [0.0], "y": [0.0], "z": [0.0], "yaw": [0.0]}),
            "verify": (arm.verify, {"toolbox": "nonsense", "poses": 3, "seed": 0}),
            "Freedom": (pieper.Freedom, {"turn": "free", "cone": 0.0, "axis": "z"}),
            "route": (
                arm.route,
                {
                    "path": path,
                    "free": None,
                    "start": q,
                    "end": None,
                    "cost": "motion",
                    "clearance": 0.0,
                    "singularity": 0.0,
                    "turn_rate": None,
                    "scene": None,
                },
            ),
            "arcs": (arm.arcs, {"T": T, "free": pieper.Freedom(turn="free")}),
            "Limits": (
                pieper.Limits,
                {
                    "speed": 1.0,
                    "acceleration": 5.0,
                    "jerk": None,
                    "tool_speed": None,
                    "tool_acceleration": None,
                    "turn_speed": None,
                },
            ),
            "time_law": (pieper.time_law, {"path": track, "limits": limits, "constant_speed": (), "rate": 500.0}),
            "fastest_constant_speed": (
                pieper.fastest_constant_speed,
                {"path": track, "limits": limits, "s0": 0.2, "s1": 0.8},
            ),
            "Program": (pieper.Program, {"arm": arm, "limits": limits, "start": q}),
            "move_j": (
                lambda **k: pieper.Program(arm, limits, start=q).move_j(**k),
                {"target": q + 0.1, "speed": None, "blend": 0.0},
            ),
            "move_l": (
                lambda **k: pieper.Program(arm, limits, start=q).move_l(**k),
                {"T": near, "speed": 0.1, "blend": 0.0},
            ),
            "move_c": (
                lambda **k: pieper.Program(arm, limits, start=q).move_c(**k),
                {"via": near, "T": Ts[1], "speed": 0.1, "blend": 0.0},
            ),
            "move_s": (
                lambda **k: pieper.Program(arm, limits, start=q).move_s(**k),
                {"Ts": Ts[1:], "speed": 0.1, "blend": 0.0},
            ),
            "program frame": (lambda **k: pieper.Program(arm, limits, start=q).frame(**k), {"T": np.eye(4)}),
            "program call": (
                lambda **k: pieper.Program(arm, limits, start=q).call(**k),
                {"other": program, "times": 1},
            ),
            "wait": (lambda **k: pieper.Program(arm, limits, start=q).wait(**k), {"seconds": 0.1}),
            "output": (lambda **k: pieper.Program(arm, limits, start=q).output(**k), {"port": 1, "value": True}),
            "gripper": (lambda **k: pieper.Program(arm, limits, start=q).gripper(**k), {"value": 0.5}),
            "program motion": (pieper.Program(arm, limits, start=q).move_j(q + 0.1).motion, {"rate": 500.0}),
            "program write": (
                pieper.Program(arm, limits, start=q).move_j(q + 0.1).write,
                {"path": str(folder / "p.csv"), "dialect": "csv"},
            ),
            "read_program": (pieper.read_program, {"path": str(file)}),
            "load_program": (pieper.load_program, {"arm": arm, "path": str(file)}),
            "read_motion": (pieper.read_motion, {"path": str(file), "arm": arm}),
            "motion between": (motion.between, {"times": [0.0]}),
            "animate": (
                motion.animate,
                {
                    "path": str(folder / "m.nonsense"),
                    "arm": arm,
                    "rate": 25.0,
                    "speed": 1.0,
                    "size": (640, 480),
                    "view": (22.0, -58.0),
                },
            ),
            "Scene": (pieper.Scene, {"obstacles": [pieper.Box(np.eye(4), (1, 1, 1))], "allowed": ()}),
            "Scene.load": (pieper.Scene.load, {"path": str(file)}),
            "Box": (pieper.Box, {"T": np.eye(4), "size": (1, 1, 1)}),
            "Capsule": (pieper.Capsule, {"a": (0, 0, 0), "b": (0, 0, 1), "r": 0.1}),
            "Cylinder": (pieper.Cylinder, {"T": np.eye(4), "r": 0.1, "h": 0.2}),
            "Convex": (pieper.Convex, {"points": np.random.default_rng(0).normal(size=(8, 3)), "r": 0.0}),
            "check": (pieper.check, {"path_or_text": str(file)}),
            "move": (pieper.move, {"q0": q, "q1": q + 0.1, "duration": 1.0, "rate": 100.0}),
            "windings": (sols.windings, {}),
        }


@pytest.fixture(scope="module")
def calls(tmp_path_factory):
    return Calls(tmp_path_factory.mktemp("right"))


def trials(table):
    for name, (function, right) in table.items():
        for key in right:
            for wrong in WRONG:
                if key == "progress" and callable(wrong):
                    continue  # what it raises is its own
                yield name, function, right, key, wrong


def test_whatever_is_of_the_wrong_kind_is_refused_in_a_sentence_or_taken(calls, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)  # some of the words are good names of files
    wrong_words = []
    for name, function, right, key, wrong in trials(calls.table):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            try:
                function(**{**right, key: wrong})
            except pieper.PieperError as error:
                said = str(error)
                if " at 0x" in said or not said.endswith((".", "?", ")")):
                    wrong_words.append(f"{name}({key}={wrong!r}): {said}")
            except Exception as error:
                wrong_words.append(f"{name}({key}={wrong!r}): {type(error).__name__}: {error}")
    assert not wrong_words, "\n".join(wrong_words)


def test_a_posture_is_said_by_its_name_wherever_a_joint_vector_is(calls):
    sols = calls.arm.ik(calls.arm.fk("zero"))
    assert np.array_equal(sols.nearest("zero"), sols.nearest(np.zeros(6)))
    assert sols.nearest_row("zero")[0] == sols.nearest_row(np.zeros(6))[0]
    with pytest.raises(pieper.InputError, match="no posture 'zeroo'. Did you mean 'zero'"):
        sols.nearest("zeroo")
