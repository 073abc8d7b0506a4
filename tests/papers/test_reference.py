"""Reference poses and complete sets of solutions of the five papers' arms, found by two other methods in 50 digits."""

from __future__ import annotations

import numpy as np
import pytest

from tests.papers.reference_arms import TO_METRES, arm_of, pose_of, read, same

FORWARD, INVERSE = read("forward.json"), read("inverse.json")
SETS = [(name, i) for name, entry in INVERSE["robots"].items() for i in range(len(entry["ik"]))]


def in_metres(entry, q):
    """Return joint vectors with their slides in metres."""
    slides = np.array([row[0] == "P" for row in entry["rows"]])
    return np.where(slides, np.asarray(q, float) * TO_METRES[entry["unit"]], q), slides


@pytest.mark.parametrize("name", FORWARD["robots"])
def test_forward_kinematics_gives_the_reference_poses(name):
    entry = FORWARD["robots"][name]
    arm = arm_of(entry, name)
    for given, expected in entry["fk"]:
        q, slides = in_metres(entry, given)
        T = arm.fk(np.where(slides, q, np.radians(q)))
        np.testing.assert_allclose(T, pose_of(entry, expected), atol=3e-15 * max(1, arm.chain.length), rtol=0)


@pytest.mark.parametrize(("name", "index"), SETS)
def test_inverse_kinematics_gives_the_whole_reference_set_and_nothing_else(name, index):
    entry = INVERSE["robots"][name]
    arm, case = arm_of(entry, name), entry["ik"][index]
    if "pose" in case:
        sols = arm.ik(pose_of(entry, case["pose"]))
    else:
        T = np.eye(4)
        T[:3, 3] = np.array(case["position"]) * TO_METRES[entry["unit"]]
        sols = arm.ik(T, task="position")
    expected, slides = in_metres(entry, case["solutions"])
    gap = same(sols.all_q, expected, slides)
    assert len(sols.all_q) == len(expected), f"{len(sols.all_q)} solutions, not {len(expected)}"
    assert gap.min(0).max() < 1e-9 and gap.min(1).max() < 1e-9
    assert sols.status.name == "SOLVED" and not sols.self_motions


@pytest.mark.parametrize("name", [n for n, e in INVERSE["robots"].items() if all("pose" in c for c in e["ik"])])
def test_many_poses_at_once_give_the_same_sets(name):
    entry = INVERSE["robots"][name]
    arm = arm_of(entry, name)
    many = arm.ik_many(np.stack([pose_of(entry, c["pose"]) for c in entry["ik"]]), threads=1)
    for i, case in enumerate(entry["ik"]):
        expected, slides = in_metres(entry, case["solutions"])
        gap = same(many.q[i][many.valid[i]], expected, slides)
        assert gap.shape == (len(expected),) * 2 and gap.min(0).max() < 1e-9 and gap.min(1).max() < 1e-9


@pytest.mark.parametrize("name", INVERSE["unreachable"])
def test_targets_out_of_reach_are_said_to_be_out_of_reach(name):
    entry = INVERSE["robots"][name]
    arm = arm_of(entry, name)
    down = np.diag([1.0, -1.0, -1.0])
    for case in INVERSE["unreachable"][name]:
        T = np.eye(4)
        T[:3, :3] = down if case["R"] == "Rx(180deg)" else np.eye(3)
        T[:3, 3] = np.array(case["position"]) * TO_METRES[entry["unit"]]
        sols = arm.ik(T) if case["R"] else arm.ik(T, task="position")
        assert len(sols.all_q) == 0 and sols.status.name == "OUT_OF_REACH"
        assert any(ch.isdigit() for ch in sols.why), sols.why
