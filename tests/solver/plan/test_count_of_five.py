"""Arms of five joints that the pose needs all: at most four solutions, and poses that have them."""

from __future__ import annotations

import numpy as np
import pytest

from pieper import Status
from tests.solver.plan.test_count import made, never_more

H = np.pi / 2


def test_four_turns_of_no_special_kind_have_four_ways_to_a_position_and_axis():
    rows = [(0.16, 2.01, 0.1, 0), (0.32, 2.48, 0.1, 0), (0.16, 2.09, 0.3, 0), (0.54, 0.75, 0.48, 0)]
    arm = made("RRRR", rows)
    plan = arm.plan_for("position+axis")
    # postures of one position and axis, which a search over four postures at once found
    T = arm.fk([-1.3074266295076657, 2.9174293019824207, -0.183558679037532, 3.05307027754848])
    sols = arm.ik(T, task="position+axis")
    assert plan.count.most == 4 == len(sols) and sols.status == Status.SOLVED
    assert np.abs(arm.fk(sols.q)[:, :3, 2:] - T[:3, 2:]).max() < 1e-9
    assert "Segre" in plan.count.argument


@pytest.mark.parametrize(
    ("kinds", "rows", "most"),
    [
        ("RRRRR", [(0.3, 1.1, 0.1, 0), (0.2, H, 0.3, 0), (0, H, 0, 0), (0, H, 0, 0), (0, 0, 0.1, 0)], 4),
        ("RPRRR", [(0.3, 1.1, 0.1, 0), (0.2, H, 0.3, 0), (0, H, 0, 0), (0, H, 0, 0), (0, 0, 0.1, 0)], 4),
        ("RRRRR", [(0.3, 1.1, 0.1, 0), (0, H, 0, 0), (0, H, 0, 0), (0.2, 0.7, 0.3, 0), (0.1, 0, 0.1, 0)], 4),
    ],
)
def test_a_wrist_beside_two_joints_says_so(kinds, rows, most):
    count = made(kinds, rows).plan_for("pose").count
    assert count.most == most and "wrist" in count.argument


KINDS = [
    "RRRRR",
    "PRRRR",
    "RPRRR",
    "RRPRR",
    "RRRPR",
    "RRRRP",
    "PRRRP",
    "RPRPR",
    "RPPRR",
    "PPRRR",
    "RRPPR",
    "PRRR",
    "RRRP",
]


@pytest.mark.parametrize("kinds", KINDS)
def test_no_pose_of_an_arm_of_five_joints_has_more(kinds):
    never_more(kinds, 3, 60, seed=7, task="pose")


@pytest.mark.slow
@pytest.mark.parametrize("kinds", KINDS)
def test_none_of_many_poses_of_an_arm_of_five_joints_has_more(kinds):
    never_more(kinds, 12, 1000, seed=8, task="pose")


def test_two_parallel_turns_beside_slides_are_counted_and_a_double_root_of_them_is_certain():
    rows = [(0, H, 0, 2.9194), (0.3, 0.5705, 0, 0), (0.2372, 1.5016, 0, 0), (-0.2, 0, 0, H), (0, np.pi, 0, H)]
    arm = made("RPPRR", rows)
    assert arm.plan_for("pose").count.most == 2
    sols = arm.ik(arm.fk([0.0, -0.3, 0.5, H, -2.03205496]), task="pose")
    assert sols.status == Status.SOLVED and sols.multiplicity.tolist() == [2]


def test_self_motions_for_a_position_and_axis_are_certain_by_postures_beside_them():
    rows = [(0.5, 0, 0, 0.8045), (0.5, -H, 0, 0), (0.5, H, 0.4, H), (0.5, 0, 0.2, 0), (0.4649, H, 0.7164, 0)]
    arm = made("RRRPR", rows)
    T = arm.fk([-H, 2.46374024, np.pi, 0.5, H])
    sols = arm.ik(T, task="position+axis")
    assert sols.status == Status.SINGULAR and len(sols.self_motions) == 2
