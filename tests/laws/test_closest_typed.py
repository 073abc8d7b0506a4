"""Law of the closest posture of short arms: a pose typed with some digits is met to those, not turned for them."""

from __future__ import annotations

from math import pi
from typing import Any

import numpy as np
import pytest

from pieper import DH, Arm, load
from pieper.kinematics.pose import pose_error

ARMS = {
    "4R palletizer": [(0.1, pi / 2, 0.4), (0.5,), (0.4,), (0.1, -pi / 2)],
    "4R across": [(0.1, pi / 2, 0.4), (0.5,), (0.4, pi / 2), (0.1, -pi / 2, 0.1)],
    "3R skew": [(0.1, 0.7, 0.2), (0.3, -1.1, 0.1), (0.25, 0.4, 0.05)],
    "5R": [(0.1, pi / 2, 0.4, 0.1), (0.5, 0.3), (0.4, pi / 2, 0.2), (0.1, -pi / 2, 0.1), (0.1, 0.4, 0.1)],
}


def arm_of(name: str) -> Arm:
    rows = [DH(*row) for row in ARMS[name]]
    return Arm.from_dh(rows, convention="standard", limits=[(-3, 3)] * len(rows))


@pytest.mark.parametrize("name", ARMS)
def test_typed_digits_do_not_turn_the_closest_posture(name: str):
    arm, rng = arm_of(name), np.random.default_rng(1)
    tried = 0
    for digits in (9, 8, 7, 6, 5, 4):
        for k in range(25):
            q = rng.uniform(-3, 3, arm.n)
            if k % 2:
                q = np.clip(np.round(q / (pi / 4)) * pi / 4, -3, 3)
            T = np.round(arm.fk(q), digits)
            T[:3, :3] = np.round(arm.fk(q)[:3, :3], max(digits, 6))  # coarser ones are refused
            sols = arm.ik(T, task="pose")
            if len(sols):
                continue
            tried += 1
            near, (metres, _) = sols.closest, pose_error(arm.fk(q), T)
            assert near.metres <= max(metres, 10.0**-digits)
            # of a place met to rounding the turn may be open by more than the digits, never by a degree
            assert near.radians < max(1e3 * 10.0**-digits, 1e-6), (digits, q)
    assert tried > 60


def test_the_posture_that_rounding_took_beyond_its_limit_is_told():
    arm = arm_of("4R palletizer")
    q = np.array([3.0, -pi / 2, -pi / 2, -3 * pi / 4])
    sols = arm.ik(np.round(arm.fk(q), 7), task="pose")
    assert np.abs(sols.closest.q - q).max() < 1e-6 and sols.closest.metres < 5e-8
    assert "7 decimals" in sols.why and "180 deg" not in sols.why


@pytest.mark.parametrize("name", ARMS)
def test_why_tells_what_rounding_explains_and_no_more(name: str):
    """A pose that was made and typed is explained by its decimals; one that is ten times them away is not."""
    arm, rng = arm_of(name), np.random.default_rng(2)
    told = tried = 0
    for digits in (8, 7, 6):
        for _ in range(12):
            T = np.round(arm.fk(rng.uniform(-2.5, 2.5, arm.n)), digits)
            sols = arm.ik(T, task="pose")
            if len(sols):
                continue
            tried += 1
            told += f"Rounding explains it: the position has {digits} decimals" in sols.why
            off = T.copy()
            off[:3, 3] += np.round(rng.choice([-1, 1], 3) * 40 * 10.0**-digits, digits)
            both = arm.closest(off, task="pose", weights=(1, 1))
            if max(both.metres, both.radians) > 2 * 10.0**-digits:
                assert "Rounding explains" not in arm.ik(off, task="pose").why
    assert told >= 0.95 * tried > 20


@pytest.mark.parametrize("digits", [8, 7, 6])
def test_the_posture_in_a_corner_of_its_limits_is_told(digits: int):
    """Three joints at their stops: descents end beside them, but what almost solves the pose is where they begin."""
    arm = load("interbotix-viperx-300")
    q = np.array([3.0, *arm.limits[1:4, 0], -3.0])
    near = arm.ik(np.round(arm.fk(q), digits), task="pose").closest
    assert np.abs(near.q - q).max() < 1e2 * 10.0**-digits
    assert near.metres < 10.0**-digits and near.radians < 1e2 * 10.0**-digits


def test_a_position_that_was_meant_is_met_first():
    """Full digits, and few that no rounding explains: the place is met to rounding whatever the turn costs."""
    arm = arm_of("4R palletizer")
    for place in ([0.4, 0.2, 0.3], [0.41, -0.13, 0.52], [1 / 3, 0.2 * pi / 3, 0.7 / 1.7]):
        T = np.eye(4)
        T[:3, 3] = place
        assert arm.ik(T, task="pose").closest.metres < 1e-14
    # a fifth of a millimetre that was typed with one decimal is no rounding of four
    q = np.array([3.0, -pi / 2, -pi / 2, -3 * pi / 4])
    assert arm.closest(arm.fk(q + np.array([2e-3, 0, 0, 0])), task="pose").metres < 1e-14


def test_weights_find_the_posture_that_made_a_pose():
    """A pose of a short arm that rounding alone takes from it: next to nothing is missed, however a turn counts."""
    arm, q = arm_of("5R"), np.array([3.0, -3 * pi / 4, pi / 4, -3.0, -3 * pi / 4])
    for radian in (0.1, 1.0, 10.0):
        near = arm.closest(np.round(arm.fk(q), 6), task="pose", weights=(1.0, radian))
        assert near.metres < 2e-6 and near.radians < 2e-6


COUPLED = [[1, 0, 0], [0, 1, 0], [0, -1, 1]]


@pytest.mark.parametrize("name", ["dobot-mg400", "dobot-magician", "kuka-kr120-r3200-pa", "coupled 3R"])
def test_the_closest_posture_of_coupled_and_linked_arms(name: str):
    """Their axes are solved, not their joints: out of reach, and where decimals alone take a pose away."""
    arm = load(name) if name != "coupled 3R" else Arm.from_dh(
        [DH(0.2, pi / 2, 0.1), DH(0.3), DH(0.25)], convention="standard", limits=[(-2, 2)] * 3, coupling=COUPLED
    )  # fmt: skip
    tasks = [None] if name != "coupled 3R" else ["pose", "position+axis", "position"]
    q = arm.limits @ (0.6, 0.4)
    for task in tasks:
        how: dict[str, Any] = {} if task is None else {"task": task}
        away = arm.fk(q)
        away[:3, 3] *= 3
        sols = arm.ik(away, **how)
        near = sols.closest
        assert "misses it by" in sols.why and near.metres > 0.1
        assert ((near.q >= arm.limits[:, 0]) & (near.q <= arm.limits[:, 1])).all()
        near = arm.closest(np.round(arm.fk(q), 6), **how)
        assert near.metres < 2e-6 and near.radians < 1e-5
