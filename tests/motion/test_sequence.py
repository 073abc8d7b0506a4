"""Moves in time, sequences with holds, and the comparison of tool positions."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pieper.errors import InputError
from pieper.motion.sequence import compare, move, sequence

# Khawlaor and Nakphan (2021), Table 2: reference and simulated tool positions in mm
REFERENCE = np.array([[0, 790, 597], [96.8, 58.6, 549.0], [0, 790, 597], [0.97, 610.2, 5.51], [0, 790, 597]]) / 1e3
SIMULATED = (
    np.array([[0.01, 793, 594], [96.4, 58.9, 548.6], [0.01, 793, 594], [0.95, 610.18, 5.53], [0.01, 793, 594]]) / 1e3
)


def test_a_move_begins_and_ends_at_rest_in_the_postures_themselves():
    q0, q1 = np.array([0.1, -0.7, 1.3]), np.array([1.1, 0.9, -2.0])
    motion = move(q0, q1, 0.7, rate=130)
    assert np.array_equal(motion.q[0], q0)
    assert np.array_equal(motion.q[-1], q1)
    assert motion.t[-1] == 0.7
    for curve in (motion.dq, motion.ddq):
        assert np.abs(curve[[0, -1]]).max() == 0.0


def test_the_largest_rate_and_acceleration_are_those_of_the_quintic():
    motion = move([0.0], [2.0], 4.0, rate=2000)
    assert motion.dq.max() == pytest.approx(15 / 8 * 2 / 4, rel=1e-6)
    assert motion.ddq.max() == pytest.approx(10 / np.sqrt(3) * 2 / 16, rel=1e-6)


def test_rates_are_the_derivatives_of_positions():
    motion = sequence([[0.0, 1], [2, -1], [1, 1]], [1.0, 2.0], [0.5, 0.25], rate=4000)
    dt = np.diff(motion.t)[:, None]
    middle = (motion.dq[1:] + motion.dq[:-1]) / 2
    assert np.abs(np.diff(motion.q, axis=0) / dt - middle).max() < 1e-5
    middle = (motion.ddq[1:] + motion.ddq[:-1]) / 2
    assert np.abs(np.diff(motion.dq, axis=0) / dt - middle).max() < 1e-2


def test_the_sequence_of_the_paper_takes_twenty_seconds_a_leg_and_ten_to_settle():
    P = np.radians([[0] * 6, [-170, -100, -119, -180, -120, -360], [0] * 6, [170, -90, 75, 180, 120, 360], [0] * 6])
    motion = sequence(P, 20.0, 10.0, rate=50)
    assert np.array_equal(motion.arrivals, [0, 20, 50, 80, 110])
    assert np.array_equal(motion.departures, [0, 30, 60, 90, 120])
    assert motion.duration == 120.0
    for posture, arrival, departure in zip(P, motion.arrivals, motion.departures, strict=True):
        held = (motion.t >= arrival) & (motion.t <= departure)
        assert np.array_equal(motion.q[held], np.broadcast_to(posture, (held.sum(), 6)))
        assert np.abs(motion.dq[held]).max() == 0.0


@settings(max_examples=40, deadline=None)
@given(
    st.lists(st.floats(0.01, 3), min_size=1, max_size=5),
    st.floats(0, 2),
    st.floats(3, 333),
)
def test_times_increase_and_every_arrival_is_a_sample(durations, hold, rate):
    postures = np.random.default_rng(1).normal(size=(len(durations) + 1, 4))
    motion = sequence(postures, durations, hold, rate=rate)
    assert np.all(np.diff(motion.t) > 0)
    assert np.diff(motion.t).max() <= 1 / rate * (1 + 1e-9)
    for posture, arrival in zip(postures, motion.arrivals, strict=True):
        k = motion.at(arrival)
        assert motion.t[k] == arrival
        assert np.array_equal(motion.q[k], posture)


@pytest.mark.parametrize(
    ("arguments", "noun"),
    [
        (dict(postures=[[0, 1]], durations=1.0), "postures"),
        (dict(postures=[[0, 1], [np.nan, 1]], durations=1.0), "finite"),
        (dict(postures=[[0, 1], [1]], durations=1.0), "postures"),
        (dict(postures=[[0], [1]], durations=0.0), "durations"),
        (dict(postures=[[0], [1]], durations=[1.0, 2.0]), "durations"),
        (dict(postures=[[0], [1]], durations=np.inf), "durations"),
        (dict(postures=[[0], [1]], durations=1.0, holds=-1.0), "holds"),
        (dict(postures=[[0], [1]], durations=1.0, rate=0.0), "rate"),
        (dict(postures=[[0], [1]], durations=1e9), "samples"),
        (dict(postures=[[0], [1]], durations="long"), "durations"),
    ],
)
def test_impossible_requests_are_refused_by_name(arguments, noun):
    with pytest.raises(InputError, match=noun):
        sequence(**arguments)


def test_the_papers_table_has_its_errors_and_zero_has_none_in_percent():
    table = compare(REFERENCE, SIMULATED)
    assert table.largest_relative == pytest.approx([2.0619, 0.5119, 0.5025], abs=5e-5)
    assert not table.defined[0, 0]
    assert table.percent(0, 0) == "undefined"
    assert table.absolute[0, 0] == pytest.approx(1e-5)
    assert "undefined" in table.table()[1]


def test_tables_of_different_shape_cannot_be_compared():
    with pytest.raises(InputError, match="reference and simulated"):
        compare(REFERENCE, SIMULATED[:3])
    with pytest.raises(InputError, match="1 name was given"):
        compare(REFERENCE, SIMULATED, names=("one",))
