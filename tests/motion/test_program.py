"""Programs: one timed motion with its events, corners cut within their radius, and every bad input answered."""

import dataclasses

import numpy as np
import pytest

import pieper
from pieper.errors import InputError, NoSolutionError
from pieper.kinematics.pose import pose_error

ARM = pieper.load("denso-vp6242")
HOME = np.radians([0, 51.492738, -150.638208, 0, 99.14547, 0])
LIMITS = pieper.Limits(speed=3.0, acceleration=20.0)


def shifted(T, x=0.0, y=0.0, z=0.0):
    out = T.copy()
    out[:3, 3] += [x, y, z]
    return out


def program(limits=LIMITS):
    return pieper.Program(ARM, limits, start=HOME)


def in_time(motion, limits, rate):
    """Differences a fixed time apart, of positions alone, within each stretch of regular samples."""
    regular = np.flatnonzero(np.abs(np.diff(motion.t) - 1 / rate) < 1e-9)
    for order, limit in ((1, limits.speed), (2, limits.acceleration), (3, limits.jerk)):
        if limit is None:
            continue
        whole = regular[: len(regular) - order]
        ok = np.array(
            [np.array_equal(regular[i : i + order], regular[i] + np.arange(order)) for i in range(len(whole))]
        )
        differences = sum(
            (-1) ** (order - k)
            * np.array([1, 1] if order == 1 else [1, 2, 1] if order == 2 else [1, 3, 3, 1])[k]
            * motion.q[whole[ok] + k]
            for k in range(order + 1)
        )
        worst = np.abs(differences).max() * rate**order
        assert worst <= limit * (1 + 1e-9) + 8e-15 * rate**order


def test_a_program_is_one_motion_through_its_targets():
    T = ARM.fk(HOME)
    p = program()
    p.move_l(shifted(T, z=-0.05)).gripper(1.0).wait(0.3).move_l(T).move_j(HOME + 0.1).output(3, True)
    motion = p.motion(rate=1000.0)
    assert motion.margin <= 1
    assert [(kind, value) for _, kind, value in motion.events] == [
        ("gripper", 1.0),
        ("wait", 0.3),
        ("output", (3, True)),
    ]
    assert np.all(np.diff(motion.t) > 0) and np.abs(np.diff(motion.q, axis=0)).max() < 3.0 * 1.01e-3
    assert np.allclose(motion.q[-1], HOME + 0.1, atol=1e-14)
    down = motion.events[0][0]
    q = motion.q[motion.at(down)]
    assert (pose_error(ARM.fk(q), shifted(T, z=-0.05)) < 1e-6).all()
    assert motion.events[-1][0] == pytest.approx(motion.duration)
    in_time(motion, LIMITS, 1000.0)
    text = p.explain()
    assert "3 moves" in text and "wait 0.3 s" in text and "gripper 1" in text


def test_lines_are_straight_and_circles_round():
    T = ARM.fk(HOME)
    p = program()
    p.move_l(shifted(T, y=0.08))
    off = ARM.fk(p.motion().q)[:, :3, 3] - T[:3, 3]
    assert np.abs(off[:, [0, 2]]).max() < 1.1e-5
    p = program()
    p.move_c(shifted(T, x=-0.05, y=0.05), shifted(T, x=-0.1))
    round_ = ARM.fk(p.motion().q)[:, :3, 3] - (T[:3, 3] + [-0.05, 0, 0])
    assert np.abs(np.linalg.norm(round_, axis=1) - 0.05).max() < 1.1e-5
    assert round_[:, 1].max() > 0.0499


def test_corners_are_cut_within_their_radius_and_do_not_stop():
    T = ARM.fk(HOME)
    p = program()
    p.move_l(shifted(T, y=0.1), blend=0.02).move_l(shifted(T, x=-0.1, y=0.1))
    motion = p.motion(rate=1000.0)
    position = ARM.fk(motion.q)[:, :3, 3] - T[:3, 3]
    corner = np.array([0, 0.1, 0])
    near = np.linalg.norm(position - corner, axis=1)
    assert 0.003 < near.min() < 0.02
    lines = np.minimum(np.linalg.norm(position[:, [0, 2]], axis=1), np.linalg.norm(position[:, 1:] - [0.1, 0], axis=1))
    assert lines[near > 0.0201].max() < 5e-5
    speed = np.abs(motion.dq).max(1)
    assert speed[(motion.t > 0.05) & (motion.t < motion.duration - 0.05)].min() > 0.1
    assert motion.margin <= 1 and not motion.remarks
    in_time(motion, LIMITS, 1000.0)
    stopping = program().move_l(shifted(T, y=0.1)).move_l(shifted(T, x=-0.1, y=0.1)).motion()
    assert motion.duration < stopping.duration


def test_blends_shrink_and_reversals_stop_with_a_remark():
    T = ARM.fk(HOME)
    p = program().move_l(shifted(T, y=0.02), blend=0.05).move_l(shifted(T, x=-0.1, y=0.02))
    (remark,) = p.motion().remarks
    assert "shrinks to 10" in remark
    p = program().move_l(shifted(T, y=0.05), blend=0.01).move_l(T)
    motion = p.motion()
    assert "turns back" in motion.remarks[0]
    assert np.abs(motion.dq[motion.at(motion.arrivals[1])]).max() < 1e-9
    p = program().move_l(shifted(T, y=0.05), blend=0.01).wait(0.1).move_l(T)
    assert "left out" in p.motion().remarks[0]


def test_joint_moves_blend_and_outputs_fire_on_the_way():
    rng = np.random.default_rng(3)
    p = program()
    for k in range(4):
        q = HOME + rng.uniform(-0.25, 0.25, 6)
        p.move_j(q, blend=0.02 if k < 3 else 0.0, speed=0.5).output(k, True)
    motion = p.motion(rate=1000.0)
    assert motion.margin <= 1
    times = [t for t, _, _ in motion.events]
    assert np.all(np.diff(times) > 0) and times[-1] == pytest.approx(motion.duration)
    assert np.abs(motion.dq).max() <= 1.5 * (1 + 1e-9)
    slow = np.abs(motion.dq).max(1)[(motion.t > 0.1) & (motion.t < motion.duration - 0.1)]
    assert slow.min() > 0.01
    in_time(motion, LIMITS, 1000.0)


def test_a_line_keeps_its_tool_speed():
    T = ARM.fk(HOME)
    motion = program().move_l(shifted(T, y=0.1), speed=0.05).motion(rate=1000.0)
    p = ARM.fk(motion.q[:-1])[:, :3, 3]
    v = np.linalg.norm(np.diff(p, axis=0), axis=1) * 1000
    assert v.max() <= 0.05 * (1 + 1e-9) and np.median(v) > 0.0499


@pytest.mark.parametrize(
    "build, word",
    [
        (lambda p, T: p.move_j(np.zeros(5)), "T|shape|target"),
        (lambda p, T: p.move_j([np.nan] * 6), "finite"),
        (lambda p, T: p.move_j(HOME + 9), "joint_1"),
        (lambda p, T: p.move_j(HOME), "no length"),
        (lambda p, T: p.move_l(T), "no length"),
        (lambda p, T: p.move_l(np.eye(3)), "shape"),
        (lambda p, T: p.move_c(T, shifted(T, z=-0.1)), "one point"),
        (lambda p, T: p.move_c(shifted(T, z=-0.1), shifted(T, z=-0.1)), "one point"),
        (lambda p, T: p.move_c(shifted(T, z=-0.05), shifted(T, z=-0.1)), "in line"),
        (lambda p, T: p.move_l(shifted(T, z=-0.1), blend=-0.1), "at least 0"),
        (lambda p, T: p.move_l(shifted(T, z=-0.1), speed=0.0), "above 0"),
        (lambda p, T: p.move_j(HOME + 0.1, speed=2.0), "at most 1"),
        (lambda p, T: p.wait(-1.0), "above 0"),
        (lambda p, T: p.output(-1, True), "port"),
        (lambda p, T: p.gripper(3.0), "0 open to 1 closed"),
        (lambda p, T: p.move_j("nowhere"), "no posture"),
    ],
)
def test_bad_instructions_are_refused(build, word):
    with pytest.raises(InputError, match=word):
        build(program(), ARM.fk(HOME))


def test_what_cannot_be_reached_is_said_with_the_moves_number():
    p = program().move_l(shifted(ARM.fk(HOME), z=-0.02))
    with pytest.raises(NoSolutionError, match="move 2 cannot be followed"):
        p.move_l(shifted(ARM.fk(HOME), x=3.0))
    with pytest.raises(NoSolutionError, match="move 2 has no posture"):
        p.move_j(shifted(ARM.fk(HOME), x=3.0))
    with pytest.raises(InputError, match="start is outside the limits: joint_1"):
        pieper.Program(ARM, LIMITS, start=HOME + [9, 0, 0, 0, 0, 0])
    with pytest.raises(InputError, match="joint_6 has none"):
        pieper.Program(ARM, pieper.Limits([1.0] * 5, 1.0), start=HOME)
    assert p.motion().margin <= 1


def test_a_move_that_stops_does_not_say_that_there_is_no_cure_where_nobody_looked():
    arm = pieper.load("denso-vp6242")
    start, T = arm.postures["line-start"], pieper.pose(350, 0, 300, mm=True)
    with pytest.raises(NoSolutionError, match="move 1 cannot be followed") as told:
        pieper.Program(arm, LIMITS, start=start).move_l(T)
    # the same line alone: two changes let it pass, each followed to its end
    track = arm.follow(pieper.line(arm.fk(start), T, n=33), start=start)
    assert len(track.cures) == 2 and all(cure.track.complete for cure in track.cures)
    assert "No cure was found" not in str(told.value) and "not looked for" in str(told.value)
    assert not dataclasses.replace(track, seek=None).cures
    assert "cure" not in dataclasses.replace(track, seek=None).explain().lower()


def zigzag(rng, arm, home, blend, kind):
    p, T = pieper.Program(arm, LIMITS, start=home), arm.fk(home)
    for k in range(5):
        T = shifted(T, *(0.03 * (-1) ** (k + 1) * rng.integers(0, 2, 3) - [0.01, 0.0, 0.0]))
        p.move_l(T, blend=blend) if kind == "move_l" else p.move_j(T, blend=blend)
    return p


@pytest.mark.parametrize("kind", ["move_l", "move_j"])
def test_blends_that_both_shrink_to_the_half_of_a_way_meet_there(kind):
    rng, whole = np.random.default_rng(3), 0
    for _ in range(40):
        try:
            p = zigzag(rng, ARM, HOME, 0.1, kind)
        except (InputError, NoSolutionError):
            continue  # a move of no length, or out of reach
        motion = p.motion()
        assert motion.margin <= 1 and np.isfinite(motion.q).all()
        assert np.abs(motion.q[-1] - p.moves[-1].q).max() < 1e-9
        assert any("shrinks" in remark for remark in motion.remarks)
        # another formula: rates are differences of the positions, and nothing jumps
        off = np.abs(np.gradient(motion.q, motion.t, axis=0) - motion.dq)[1:-1]
        assert off.max() < 0.02 * np.abs(motion.dq).max()
        whole += 1
    assert whole > 10


def test_an_empty_program_rests():
    motion = program().output(1, True).motion()
    assert motion.duration == 0 and motion.events == ((0.0, "output", (1, True)),)
