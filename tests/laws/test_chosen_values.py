"""A chosen value of a spare joint: the rows are those of the arm with the joint locked there, at round postures too."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from pieper import DH, Arm, Status
from tests.laws.test_round_short_arms import drawn

PI, H, K = np.pi, np.pi / 2, np.pi / 6


def spare_arms(rng: np.random.Generator, count: int):
    """Yield drawn arms with round numbers and a joint or more to spare for the whole pose."""
    while count:
        arm = drawn(rng)
        try:
            fits = arm.plan.task == "pose" and arm.plan.redundancy
        except pieper.PlanError:
            continue
        if fits:
            count -= 1
            yield arm


def round_posture(rng: np.random.Generator, arm: Arm) -> np.ndarray:
    return np.where(arm.chain.prismatic, rng.choice([0, 0.1, -0.1, 0.2], arm.n), K * rng.integers(-6, 7, arm.n))


def test_a_posture_is_among_the_rows_at_its_own_value_of_a_spare_joint():
    rng, tried = np.random.default_rng(5), 0
    for arm in spare_arms(rng, 25):
        names = [name for name in arm.plan.redundancy if name in arm.joint_names]
        at = [arm.joint_names.index(name) for name in names]
        rest = [i for i in range(arm.n) if i not in at]
        for _ in range(4):
            q = round_posture(rng, arm)
            s = np.linalg.svd(arm.jacobian(q)[:, rest], compute_uv=False)
            if s[min(arm.plan.rank, len(rest)) - 1] < 1e-3 * s[0]:
                continue  # a self-motion of what is left, of which any point stands there
            tried += 1
            chosen = dict(zip(names, q[at].tolist(), strict=True))
            T = arm.fk(q)
            rows, many = arm.ik(T, redundancy=chosen).all_q, arm.ik_many(T[None], redundancy=chosen)
            way = rows - q
            way = np.where(arm.chain.prismatic, way, np.remainder(way + PI, 2 * PI) - PI)
            assert np.abs(way).max(1).min(initial=np.inf) < 1e-6, (arm.description.rows, q, chosen)
            assert many.valid.sum() == len(rows)
    assert tried > 30


FIVE = [DH(0.25, H, 0.25, np.pi), DH(0.4, 0, 0.25, K), DH(0, np.pi, 0.1, np.pi), DH(0.4, H, 0.3), DH(-0.2, H)]
SLIDE = [DH(0.1, -H, -0.2, K), DH(0, 0, 0.4), DH(0, K), DH(0.1, -H, 0, -H), DH(0.25, H, 0.3)]
TWO_SLIDES = [
    DH(0.25, 0, 0.2, np.pi),
    DH(),
    DH(0.1, H, -0.2, H),
    DH(0.25, -H, 0.3, H),
    DH(0.4, K),
    DH(0.4, 0, 0, np.pi),
]


@pytest.mark.parametrize(
    ("types", "rows", "q", "held"),
    [
        ("RRRRR", FIVE, [0] * 5, 1),
        ("RRRPR", SLIDE, [-H, H, H, 0.1, 0], 0),
        ("PRRPRP", TWO_SLIDES, [0] * 6, 5),
    ],
)
def test_the_rows_at_a_value_are_those_of_the_arm_locked_there(types, rows, q, held):
    arm = Arm.from_dh(rows, convention="modified", joint_types=types)
    chosen = {arm.joint_names[held]: float(q[held])}
    T = arm.fk(q)
    other = arm.with_joints_locked(chosen).ik(T).all_q
    found = arm.ik(T, redundancy=chosen).all_q
    assert len(found) == len(other) > 0
    assert np.abs(np.delete(found, held, axis=1) - other).max() < 1e-6


def test_only_joints_that_self_motions_move_are_offered_and_all_of_those_can_be_chosen():
    for name in ("iiwa 14", "franka-panda", "sawyer"):
        arm = pieper.load(name)
        q = arm.limits.mean(axis=1) + 0.1
        moved = np.abs(np.linalg.svd(arm.jacobian(q))[2][6:]).max(0) > 1e-9
        assert {n for n in arm.plan.choices if n in arm.joint_names} == {
            arm.joint_names[i] for i in np.flatnonzero(moved)
        }
        for n in arm.plan.choices:
            arm.ik(arm.fk(q), redundancy={n: 0.1 if n == "arm angle" else float(q[arm.joint_names.index(n)])})
        for i in np.flatnonzero(~moved):
            with pytest.raises(pieper.InputError, match=f"pose alone decides {arm.joint_names[i]}.*Choose"):
                arm.ik(arm.fk(q), redundancy={arm.joint_names[i]: 0.3})


def test_a_chosen_value_without_a_row_inside_says_that_others_have_some():
    panda = pieper.load("franka-panda")
    T = pieper.pose(0.4, 0.1, 0.3, rpy=(np.pi, 0, 0))
    for chosen in ({"arm angle": 0.35}, {"panda_joint7": 2.8}, {"panda_joint4": -0.1}):
        found = panda.ik(T, redundancy=chosen)
        assert not len(found.q) and found.status in (Status.OUTSIDE_LIMITS, Status.REDUNDANT)
        assert "at the chosen" in found.why and "ther values have" in found.why
        assert any(motion.inside for motion in found.self_motions)


@pytest.mark.parametrize("seed", [0, 1, 3, 5])
def test_an_arm_that_is_nearly_special_at_a_chosen_value_is_solved_there(seed):
    given, rng = pieper.load("iiwa 14").description, np.random.default_rng(seed)
    off = 10.0 ** rng.uniform(-9, -5) * rng.uniform(-1, 1, (7, 3))
    rows = [DH(r.a + e[0], r.alpha + e[1], r.d + e[2], r.theta) for r, e in zip(given.rows, off, strict=True)]
    arm = Arm.from_dh(rows, convention=given.convention, limits=given.limits)
    for q in ([0, 0.3, 0, -1.2, 0, 0.7, 0], [0.1, 0.4, 0, -1.0, 0, 1e-7, 0.2]):
        T = arm.fk(q)
        found, many = arm.ik(T, redundancy={"joint_3": 0.0}), arm.ik_many(T[None], redundancy={"joint_3": 0.0})
        assert len(found.all_q) == many.valid.sum() > 0
