"""Joint moves in closed form: the limits kept and reached, the time the least, integrated anew."""

import numpy as np
import pytest

import pieper
from pieper.errors import InputError
from pieper.motion.joint_move import joint_move, joint_move_time, straight_profile
from pieper.motion.profile import rest_to_rest

RNG = np.random.default_rng(7)


def cases(count):
    for _ in range(count):
        n = int(RNG.integers(1, 8))
        q0, q1 = RNG.uniform(-3, 3, (2, n)) * 10.0 ** RNG.uniform(-3, 0.5)
        scale = 10.0 ** RNG.uniform(-1, 1, 3)
        jerk = scale[2] * RNG.uniform(5, 90, n) if RNG.random() < 0.7 else None
        yield q0, q1, pieper.Limits(scale[0] * RNG.uniform(1, 3, n), scale[1] * RNG.uniform(2, 9, n), jerk)


def least_time(V, A, J):
    """The fastest way of length 1 by bisection on the speed that is reached: no case of the closed form is used."""

    def rise(v):
        return v / A + A / J if v * J >= A * A else 2 * np.sqrt(v / J)

    if rise(V) * V <= 1:
        return 2 * rise(V) + (1 - rise(V) * V) / V
    low, high = 0.0, V
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if rise(middle) * middle < 1 else (low, middle)
    return 2 * rise(low)


def test_the_time_is_the_least_one():
    for q0, q1, limits in cases(300):
        way = np.abs(q1 - q0)
        J = 1e9 * (limits.acceleration / way).min() if limits.jerk is None else (limits.jerk / way).min()
        wanted = least_time((limits.speed / way).min(), (limits.acceleration / way).min(), J)
        assert joint_move_time(q0, q1, limits) == pytest.approx(wanted, rel=1e-12 if limits.jerk is not None else 1e-6)


def test_jerk_integrated_three_times_gives_the_move():
    for q0, q1, limits in cases(60):
        if limits.jerk is None:
            continue  # the acceleration jumps: trapezoids say little
        profile = straight_profile(q1 - q0, limits)[0]
        motion = joint_move(q0, q1, limits, rate=min(100 / np.diff(profile.t).min(), 2e5 / profile.duration))
        # trapezoids of the sampled derivatives: each curve is the integral of the next
        for low, high in ((motion.q, motion.dq), (motion.dq, motion.ddq)):
            step = np.diff(motion.t)[:, None]
            grown = np.cumsum((high[1:] + high[:-1]) / 2 * step, 0)
            assert np.abs(low[0] + grown - low[1:]).max() <= 2e-3 * max(np.abs(low).max(), np.abs(low - low[0]).max())
        assert np.array_equal(motion.q[0], q0) and np.allclose(motion.q[-1], q1, atol=1e-15, rtol=1e-14)
        assert np.abs(motion.dq[[0, -1]]).max() < 1e-9 * np.abs(motion.dq).max()


def test_the_margin_is_one_and_no_difference_of_times_says_otherwise():
    for q0, q1, limits in cases(60):
        motion = joint_move(q0, q1, limits, rate=1000.0)
        assert 1 - 1e-9 < motion.margin <= 1
        regular = motion.q[:-1]
        for order, limit in ((1, limits.speed), (2, limits.acceleration), (3, limits.jerk)):
            if limit is None or len(regular) <= order:
                continue
            rounding = 2**order * 4e-16 * np.abs(motion.q).max() * 1000.0**order
            assert (np.abs(np.diff(regular, order, axis=0)) * 1000.0**order <= limit + rounding).all()


def test_the_pieces_of_a_profile_fit_together():
    for V, A, J in 10.0 ** RNG.uniform(-2, 2, (200, 3)):
        for jerk in (J, None):
            profile = rest_to_rest(V, A, jerk)
            for i in range(len(profile.c)):
                s, v, a, j = profile.c[i]
                tau = profile.t[i + 1] - profile.t[i]
                end = [s + v * tau + a * tau**2 / 2 + j * tau**3 / 6, v + a * tau + j * tau**2 / 2]
                after = profile.c[i + 1, :2] if i + 1 < len(profile.c) else [1.0, 0.0]
                assert np.allclose(end, after, atol=1e-12 * max(1, V))


def test_equal_postures_need_no_time_and_tight_says_which_joint_binds():
    limits = pieper.Limits(1.0, 1.0, 3.0)
    assert joint_move([1.0, 2.0], [1.0, 2.0], limits).duration == 0
    assert joint_move_time(np.zeros((4, 2)), np.zeros((4, 2)), limits).tolist() == [0] * 4
    long = joint_move([0.0, 0.0], [0.1, 9.0], limits)
    assert {(t.limit, t.joint) for t in long.tight} == {(k, "joint 2") for k in ("speed", "acceleration", "jerk")}
    assert "joint 2" in str(long.tight[0])


@pytest.mark.parametrize(
    "q0, q1, word",
    [
        ([0.0], [np.nan], "finite"),
        ([0.0], [1.0, 2.0], "joint"),
        ([[0.0]], [1.0], "shape"),
        ("a", [1.0], "joint vector"),
    ],
)
def test_what_is_no_posture_is_refused(q0, q1, word):
    with pytest.raises(InputError, match=word):
        joint_move(q0, q1, pieper.Limits(1.0, 1.0))
