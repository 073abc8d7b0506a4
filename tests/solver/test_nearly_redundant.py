"""Arms that are redundant but for what an angle was typed with, and poses beside what a short arm can do."""

import warnings

import numpy as np
import pytest

import pieper
from pieper import DH, Status


def arm(*rows):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return pieper.Arm.from_dh([DH(*row) for row in rows], convention="standard", limits=[(-3.1, 3.1)] * len(rows))


MADE = {
    "turn, four parallel, turn": lambda p: arm(
        (0, np.pi / 2, 0.1, 0),
        (0.3, p, 0, 0),
        (0.3, p, 0.1, 0),
        (0.25, p, 0, 0),
        (0.2, np.pi / 2, 0.1, 0),
        (0.1, 0, 0.1, 0),
    ),
    "four between two": lambda p: arm(
        (0, np.pi / 2, 0.1, 0),
        (0.3, np.pi - p, 0, 0),
        (0.3, np.pi - p, 0.1, 0),
        (0.25, np.pi - p, 0, 0),
        (0.2, np.pi / 2, 0.1, 0),
        (0.1, 0, 0.1, 0),
    ),
    "five and a turn across": lambda p: arm(
        (0.3, p, 0, 0),
        (0.3, p, 0.1, 0),
        (0.25, p, 0, 0),
        (0.2, p, 0.1, 0),
        (0.15, np.pi / 2, 0.05, 0),
        (0.1, 0, 0.1, 0),
    ),
    "planar": lambda p: arm((0.3, p, 0, 0), (0.3, p, 0.1, 0), (0.25, 0, 0, 0), (0.2, 0, 0.1, 0)),
    "one line": lambda p: arm((0, p, 0.4, 0), (0, 1.57079, 0.1, 0), (0.3, 0, 0, 0), (0.2, 0, 0, 0)),
    "twisted": lambda p: arm(
        (0.2, 0, 0.3, 1.5708), (0, p, 0.1, 3.1416), (0.1, 0.7854, 0.1, -1.5708), (0, 1.0472, 0, 1.5708)
    ),
}


@pytest.mark.parametrize("p", [3.1416, 3.14159])
@pytest.mark.parametrize("name", MADE)
def test_an_arm_that_only_looks_redundant_is_solved_as_it_is(name, p):
    a = MADE[name](p)
    for q in np.random.default_rng(1).uniform(-2, 2, (8, a.n)):
        found = a.ik(a.fk(q))
        assert found.status is Status.SOLVED
        assert np.abs(a.fk(found.q) - found.T).max() < 1e-9
        # 1e-15 of the pose is as much as 1e-9 of such a posture
        assert np.abs(found.nearest(q) - q).max() < 1e-6


def test_tilts_of_a_millionth_are_counted_by_the_signs_of_a_noisy_determinant():
    a = MADE["four between two"](np.pi - 1e-6)
    for q in np.random.default_rng(3).uniform(-2, 2, (12, 6)):
        found = a.ik(a.fk(q))
        assert found.status is Status.SOLVED and np.abs(found.nearest(q) - q).max() < 1e-6
        assert np.abs(a.fk(found.q) - found.T).max() < 1e-12


def test_six_nearly_parallel_turns_are_certain_more_often_than_not():
    rows = zip((0.3, 0.3, 0.25, 0.2, 0.15, 0.1), [3.1416] * 5 + [0], (0, 0.1, 0, 0.1, 0.05, 0.1), strict=True)
    a = arm(*((length, twist, offset, 0) for length, twist, offset in rows))
    T = a.fk(np.random.default_rng(1).uniform(-2, 2, (10, 6)))
    assert sum(status == Status.UNCERTAIN for status in a.ik_many(T).status) <= 3


@pytest.mark.parametrize("p", [3.141592, 3.141593, 3.1415927, 3.14159265])
@pytest.mark.parametrize("name", MADE)
def test_what_all_but_redundant_arms_take_is_never_called_out_of_reach(name, p):
    a = MADE[name](p)
    T = a.fk(np.random.default_rng(2).uniform(-2, 2, (6, a.n)))
    for pose in T:
        assert a.ik(pose).status in (Status.SOLVED, Status.REDUNDANT, Status.UNCERTAIN)
    assert not (a.ik_many(T).status == Status.OUT_OF_REACH).any()


@pytest.mark.parametrize("p", [3.1416, 3.14159, 3.141593, np.pi])
def test_self_motions_of_an_arm_with_two_pairs_of_turns_about_one_line(p):
    half = 1.5708
    a = arm(
        (0, p, 0, 0),
        (0.2, -half, 0, -half),
        (-0.075, -half, 0.1, 0),
        (-0.075, -half, 0.3, half),
        (0, 0, 0, 0),
        (0.1, 1.0472, 0.1, 0),
    )
    q = np.array([0.3, -0.4, 0.5, 0.2, 0.7, 0.1])
    found = a.ik(a.fk(q))
    assert found.status is Status.REDUNDANT
    assert any({4, 5} <= set(motion.free) for motion in found.self_motions)
    assert np.abs(found.nearest(q) - q).max() < 1e-6


SHORT = {
    "planar 4R": [(0.3, 0, 0, 0)] * 4,
    "planar 5R": [(0.3, 0, 0, 0)] * 5,
    "4R on a turn": [(0, np.pi / 2, 0.1, 0)] + [(0.3, 0, 0, 0)] * 4,
    "two turns about one line": [(0, 0, 0.1, 0), (0, np.pi / 2, 0.1, 0), (0.3, 0, 0, 0), (0.2, 0, 0, 0)],
}


@pytest.mark.parametrize("off", [1e-12, 1e-11, 1e-10])
@pytest.mark.parametrize("name", SHORT)
def test_a_pose_beside_what_a_short_arm_can_do_has_the_self_motions_of_one_that_it_can(name, off):
    a = arm(*SHORT[name])
    q = np.random.default_rng(3).uniform(-1, 1, a.n)
    T = a.fk(q)
    exact = a.ik(T).self_motions
    T[:3, 3] += off * np.array([0.3, 0.5, -0.2])
    found = a.ik(T)
    assert found.status is Status.REDUNDANT
    assert [motion.free for motion in found.self_motions] == [motion.free for motion in exact]
    assert any(motion.contains(q, 1e-6) for motion in found.self_motions)
    for motion in found.self_motions:
        along = a.fk([motion.at(u) for u in (0.1, 0.35, 0.6, 0.9)])
        assert np.abs(along - T).max() < 10 * off


def test_a_pose_that_two_turns_about_one_line_miss_is_not_said_to_need_another_value():
    a = arm(*SHORT["two turns about one line"])
    for q in np.random.default_rng(3).uniform(-1, 1, (8, 4)):
        T = a.fk(q)
        T[:3, 3] += 3e-9 * np.array([0.3, 0.5, -0.2])
        found = a.ik(T)
        assert found.status is Status.REDUNDANT or "other values" not in found.why


@pytest.mark.parametrize("tolerance", [-1, np.nan, "much"])
def test_a_tolerance_that_is_none_is_refused(tolerance):
    motion = (
        pieper.load("denso-vp6242").ik(pieper.load("denso-vp6242").fk([0.1, 0.2, 0.3, 0.4, 0.0, 0.5])).self_motions[0]
    )
    with pytest.raises(pieper.InputError, match="tolerance"):
        motion.contains([0.0] * 6, tolerance)


def test_yes_and_no_are_no_value_of_a_spare_joint():
    a = pieper.load("franka-panda")
    T = a.fk([0.1, 0.2, 0.3, -1.5, 0.4, 1.5, 0.6])
    for said in (True, {"panda_joint7": False}, [True]):
        with pytest.raises(pieper.InputError, match="finite number"):
            a.ik(T, redundancy=said)
