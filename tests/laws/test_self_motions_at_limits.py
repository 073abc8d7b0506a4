"""Self-motions of short arms inside limits: exact intervals, single points, and lines of slides that have no end."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

import pieper
from pieper import DH, Arm, Status

H, K = pi / 2, pi / 4

#: Arms of four turns and postures that are points of a self-motion.
FOUR_TURNS = {
    "round": ([DH(0.25, K, -0.15, pi), DH(0.25, -H, 0, H), DH(0.25, -H, 0, H), DH(0, 0, 0, pi)], [-H, H, H, -H]),
    "longer": ([DH(0.1, K, -0.15, pi), DH(0.4, -H, 0, H), DH(0.4, -H, 0, H), DH(0, 0, 0.2, pi)], [0.3, H, H, 0.4]),
}


def on_a_motion(name: str) -> tuple[Arm, np.ndarray]:
    rows, q = FOUR_TURNS[name]
    return Arm.from_dh(rows, convention="standard"), np.array(q)


@pytest.mark.parametrize("name", FOUR_TURNS)
def test_a_point_that_limits_leave_of_a_self_motion_is_inside(name):
    arm, q = on_a_motion(name)
    whole = arm.ik(arm.fk(q)).self_motions
    assert len(whole) == 1 and whole[0].contains(q)
    rng = np.random.default_rng(2)
    for u in [*rng.uniform(0, 1, 3), None]:
        there = q if u is None else whole[0].at(u)
        for joint in whole[0].free:
            stop = there[joint]
            for limits in ((stop, stop), (stop, stop + 0.4), (stop - 0.4, stop)):
                short = arm.with_limits({arm.joint_names[joint]: limits})
                sols = short.ik(arm.fk(q))
                assert sols.status == Status.SINGULAR and sols.self_motions[0].inside, (u, joint, limits)
                assert np.abs(sols.nearest(there) - there).max() < 1e-6
                for low, high in sols.self_motions[0].inside:
                    for place in (low, high):
                        assert short.chain.joints.inside_limits(sols.self_motions[0].at(place), short.limits)[1]


@pytest.mark.parametrize("name", FOUR_TURNS)
def test_two_stops_at_one_point_of_a_self_motion_leave_that_point(name):
    arm, q = on_a_motion(name)
    motion = arm.ik(arm.fk(q)).self_motions[0]
    i, j = motion.free
    tangent = motion.at(0.5 + 1e-3) - motion.at(0.5)
    there = motion.at(0.5)
    limits = {i: (there[i], there[i] + 0.5), j: (there[j] - 0.5, there[j])}
    if tangent[i] * tangent[j] < 0:  # one must forbid what the other allows
        limits[j] = (there[j], there[j] + 0.5)
    sols = arm.with_limits({arm.joint_names[k]: v for k, v in limits.items()}).ik(arm.fk(q))
    assert sols.status == Status.SINGULAR and np.abs(sols.q - there).max() < 1e-9
    (low, high), *more = sols.self_motions[0].inside
    assert high - low < 1e-9 and not more


def slides(width: float | None) -> Arm:
    """Return an arm of three slides in one plane and two turns, the slides within +-width m."""
    rows = [DH(-0.2, pi, 0.1), DH(0, -H, 0.2), DH(0, K, 0.1, pi), DH(0, H, -0.15), DH(-0.2, -H, 0.1)]
    arm = Arm.from_dh(rows, convention="modified", joint_types="PPRRP")
    return arm if width is None else arm.with_limits({f"joint_{k}": (-width, width) for k in (1, 2, 5)})


@pytest.mark.parametrize("width", [None, 1.0, 0.3])
def test_a_line_of_slides_is_one_self_motion_through_the_posture(width):
    arm, zero = slides(width), np.zeros(5)
    sols = arm.ik(arm.fk(zero))
    through = [motion for motion in sols.self_motions if motion.contains(zero)]
    assert len(through) == 1 and sols.status == Status.SINGULAR
    assert np.abs(sols.nearest(zero)).max() < 1e-9 and np.abs(sols.all_q).max() < 10
    assert all(np.abs(arm.fk(motion.at(u)) - arm.fk(zero)).max() < 1e-9 for motion in through for u in (0.2, 0.5, 0.9))
    if width is not None:
        (low, high), *more = through[0].inside
        ends = np.sort([through[0].at(u)[4] for u in (low, high)])
        # the third slide goes as far as the other two allow, or as its own limits do
        assert not more and np.abs(ends - [-width, width]).max() < 1e-9


def test_lines_of_slides_of_drawn_arms_are_told_once():
    rng, told = np.random.default_rng(8), 0
    while told < 6:
        twists = rng.choice([0.3, 0.9, 1.2, -0.7], 2)
        rows = [DH(0.1, H, 0.1), DH(0, twists[0], 0.2), DH(0.1, 0, 0.1), DH(0, twists[1], 0.15), DH(-0.2, -H, 0.1)]
        arm = Arm.from_dh(rows, convention="modified", joint_types="".join(rng.permutation(list("PPPRR"))))
        try:
            if arm.plan.redundancy:
                continue
        except pieper.PlanError:
            continue
        q = np.where(arm.chain.prismatic, rng.uniform(-0.3, 0.3, 5), rng.choice([0.0, H], 5))
        for motion in arm.ik(arm.fk(q)).self_motions:
            assert np.abs(motion.representative).max() < 20
        told += 1


SIX_TURNS = [DH(0, -H, -0.2, pi), DH(0.4, 0, 0.25), DH(0, -H, 0.2), DH(0.4, H), DH(-0.2, 0, 0, H), DH(0, H, 0, pi)]


def of_all_roads() -> list[tuple[Arm, np.ndarray]]:
    """Return arms whose self-motions are found in another way each, with a posture on one."""
    wrist = Arm.from_dh([DH(0, H), DH(0, -H), DH(0, 0, 0.1)], convention="standard")
    general = Arm.from_dh(SIX_TURNS, convention="modified")
    palletizer = pieper.load("dobot-mg400")
    return [
        (wrist, np.array([0.5, 0, 0.2])),
        (general, np.array([pi, H, pi, H, H, -H])),
        (palletizer, np.array([-K, 0, H, 7 * pi / 12])),
    ]


@pytest.mark.parametrize("which", range(3))
@pytest.mark.parametrize("width", [0.0, 1e-3, 0.03])
def test_no_window_that_limits_leave_of_a_self_motion_is_too_narrow(which, width):
    arm, q = of_all_roads()[which]
    T = arm.fk(q)
    motion = next(m for m in arm.ik(T).self_motions if m.contains(q))
    low, high = motion.inside[0]
    there = motion.at(low + 0.43 * (high - low))
    for joint in motion.free:
        window = (there[joint] - width / 2, there[joint] + width / 2)
        short = arm.with_limits({arm.joint_names[joint]: window})
        sols = short.ik(T)
        assert sols.status == Status.SINGULAR == short.ik_many(T[None]).status[0], (joint, sols.why)
        at = sols.nearest(there)
        assert np.abs(at - there).max() < 1e-6 + width and np.abs(arm.fk(at) - T).max() < 1e-9
        assert all(np.abs(arm.fk(p) - T).max() < 1e-9 for p in motion.at_joint(joint, there[joint]))
