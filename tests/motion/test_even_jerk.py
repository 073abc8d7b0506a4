"""Jerk limits beside the tool's acceleration and sections of its constant speed, judged by differences in time."""

import numpy as np
import pytest

import pieper
from pieper.errors import InputError

UR = pieper.load("universal-robots-ur5e")
START = np.array([0.3, -1.4, 1.6, -1.2, -1.4, 0.4])
RATE = 2000.0


def wave(seed):
    rng = np.random.default_rng(seed)
    return START + np.cumsum(rng.uniform(-0.3, 0.3, (int(rng.integers(3, 9)), 6)), 0)


def seam():
    T = UR.fk(START)
    end = T.copy()
    end[1, 3] += 0.3
    return UR.follow(pieper.line(T, end, 60), start=START)


def tool_speed(motion):
    return np.linalg.norm(np.einsum("kij,kj->ki", UR.jacobian(motion.q)[:, :3], motion.dq), axis=1)


def keeps(motion, limits):
    assert motion.margin <= 1
    for order, limit in ((1, limits.speed), (2, limits.acceleration), (3, limits.jerk)):
        rounding = 2**order * 1e-15 * np.abs(motion.q).max() * RATE**order
        assert (np.abs(np.diff(motion.q[:-1], order, axis=0)) * RATE**order <= limit + rounding).all()


@pytest.mark.parametrize("seed", [0, 3, 7])
@pytest.mark.parametrize("most", [0.7, 3.0])
def test_the_tools_acceleration_is_kept_beside_a_jerk(seed, most):
    q, joints = wave(seed), (np.full(6, 3.0), np.full(6, 10.0), np.full(6, 60.0))
    motion = pieper.time_law(q, pieper.Limits(*joints, tool_acceleration=most), arm=UR, rate=RATE)
    keeps(motion, motion.limits)
    path = UR.fk(motion.q[:-1])[:, :3, 3]
    assert (np.linalg.norm(np.diff(path, 2, axis=0), axis=1) - 4e-15).max() * RATE**2 <= most * (1 + 1e-9)
    # neither limit makes it faster, and both together little slower than the slower one needs
    alone = [
        pieper.time_law(q, limits, arm=UR).duration
        for limits in (pieper.Limits(*joints), pieper.Limits(*joints[:2], tool_acceleration=most))
    ]
    assert 0.99 * max(alone) <= motion.duration <= 1.2 * max(alone)


@pytest.mark.parametrize("path", ["seam", *(pytest.param(seed, marks=pytest.mark.slow) for seed in (3, 4))])
@pytest.mark.parametrize("jerk", [60.0, 300.0])
def test_a_section_is_even_within_jerk_limits(path, jerk):
    q = seam() if path == "seam" else wave(path)
    limits = pieper.Limits(np.full(6, 3.0), np.full(6, 10.0), np.full(6, jerk))
    best = pieper.fastest_constant_speed(q, limits, 0.3, 0.7, arm=UR)
    free = pieper.fastest_constant_speed(q, pieper.Limits(3.0, 10.0), 0.3, 0.7, arm=UR)
    assert 0 < best <= free and best.why
    for part in (0.4, 0.97, 1.0):
        motion = pieper.time_law(q, limits, constant_speed=[(0.3, 0.7, part * best)], arm=UR, rate=RATE)
        keeps(motion, limits)
        inside = (motion.s > 0.3) & (motion.s < 0.7)
        assert inside.sum() > 50 and np.abs(tool_speed(motion)[inside] / (part * best) - 1).max() < 1e-6
        assert motion.s[0] == 0 and motion.s[-1] == 1 and (np.diff(motion.s) >= 0).all()
    with pytest.raises(InputError, match="highest speed that would do") as refused:
        pieper.time_law(q, limits, constant_speed=[(0.3, 0.7, 1.02 * best)], arm=UR)
    assert refused.value.fastest == pytest.approx(best)


def test_the_curve_with_sections_is_the_one_without():
    q = wave(3)
    limits = pieper.Limits(3.0, 10.0, 60.0)
    motion = pieper.time_law(q, limits, constant_speed=[(0.1, 0.4, 0.05), (0.5, 0.8, 0.08)], arm=UR, rate=RATE)
    plain = pieper.time_law(q, limits, arm=UR, rate=RATE)
    fine = pieper.time_law(q, pieper.Limits(0.05, 1.0), arm=UR, rate=RATE)
    assert motion.duration > plain.duration
    for j in range(6):
        assert np.abs(np.interp(motion.s, fine.s, fine.q[:, j]) - motion.q[:, j]).max() < 1e-6
    for s0, s1, v in ((0.1, 0.4, 0.05), (0.5, 0.8, 0.08)):
        inside = (motion.s > s0) & (motion.s < s1)
        assert np.abs(tool_speed(motion)[inside] / v - 1).max() < 1e-6


def test_a_section_from_the_very_beginning_is_refused_and_says_why():
    limits = pieper.Limits(3.0, 10.0, 60.0)
    with pytest.raises(InputError, match="run-up .* 0 m/s"):
        pieper.time_law(seam(), limits, constant_speed=[(0.0, 0.5, 0.1)])
    for section, place, limit in (((0.0, 0.5), 0.0, "run-up"), ((0.5, 1.0), 1.0, "run-out")):
        none = pieper.fastest_constant_speed(seam(), limits, *section)
        assert (float(none), none.s, none.limit) == (0.0, place, limit)


def test_what_binds_is_told_the_speed_that_is_given_in_its_section():
    limits = pieper.Limits(3.0, 10.0, 60.0)
    motion = pieper.time_law(seam(), limits, constant_speed=[(0.3, 0.7, 0.25)], rate=RATE)
    (given,) = [one for one in motion.tight if one.limit == "given speed"]
    inside = motion.t[(motion.s >= 0.3) & (motion.s <= 0.7)]
    assert abs(given.start - inside[0]) < 2 / RATE and abs(given.end - inside[-1]) < 2 / RATE
    ends = [(one.start, one.end) for one in motion.tight]
    assert all(a[1] <= b[0] + 1e-12 for a, b in zip(ends, ends[1:], strict=False))
    assert "jerk" in {one.limit for one in motion.tight}
