"""A batch asked for one of its poses, for some of them, and one by one; lists in which something is no pose."""

from __future__ import annotations

import pickle
from typing import Any

import numpy as np
import pytest

import pieper
from pieper import InputError, Status

ARM = pieper.load("denso-vp6242")
Q = np.random.default_rng(0).uniform(*ARM.limits.T, (7, 6))
TS = ARM.fk(Q)
TS[5, :3, 3] *= 10


@pytest.mark.parametrize("name", ["denso-vp6242", "franka-panda", "three-r", "motoman-ea1400n"])
def test_what_a_batch_says_of_a_pose_is_what_ik_says(name: str):
    arm = pieper.load(name)
    Ts = arm.fk(np.random.default_rng(1).uniform(*np.clip(arm.limits, -3, 3).T, (6, arm.n)))
    Ts[2, :3, 3] += 9.0
    many = arm.ik_many(Ts)
    assert len(list(many)) == len(many) == 6
    for k, one in enumerate(many):
        alone = arm.ik(Ts[k])
        assert one.pose == k and one.status == alone.status and len(one) == len(alone)
        assert np.allclose(one.q, alone.q, 0, 1e-9) and np.allclose(one.all_q, alone.all_q, 0, 1e-9)
        assert np.array_equal(one.in_limits, alone.in_limits)
        assert one.labels == alone.labels and one.all_labels == alone.all_labels
        assert all(np.allclose(row, q, 0, 1e-9) for row, q in zip(one, alone.q, strict=True))
        again = pickle.loads(pickle.dumps(one))
        assert np.array_equal(again.q, one.q) and repr(again) == repr(one)


def test_poses_count_from_the_end_too_and_several_are_a_batch():
    many = ARM.ik_many(TS, near=Q)
    assert many[-1].pose == many[np.int64(6)].pose == 6
    assert np.allclose(many[0].nearest, Q[0]) and many[5].nearest is None and many[5].status == Status.OUT_OF_REACH
    assert np.array_equal(many[0][0], many[0].q[0]) and len(many[0][:1]) == 1
    for at in (slice(1, 4), slice(None, None, -2), [0, -2, 0], np.array([3, 1]), many.status == Status.SOLVED, []):
        some = many[at]
        rows = np.asarray(at, int) if isinstance(at, list) else at
        assert isinstance(some, pieper.SolutionBatch)
        assert np.array_equal(some.q, many.q[rows]) and np.array_equal(some.status, many.status[rows])
        assert np.array_equal(some.nearest, many.nearest[rows])
    before = many.q[0].copy()
    many[0].all_q[:] = 7.0
    assert np.array_equal(many.q[0], before)


@pytest.mark.parametrize("at", ["first", 1.5, None, [0.5], {}, np.zeros((2, 2), int), np.array([True])])
def test_what_is_no_place_in_a_batch_is_told(at: object):
    with pytest.raises(InputError, match="one pose by its number, or for some by a slice"):
        ARM.ik_many(TS)[at]  # type: ignore[index]


@pytest.mark.parametrize(("at", "count"), [(7, 7), (-8, 7), ([0, 7], 7), (0, 0)])
def test_beyond_the_last_pose_there_is_none(at: object, count: int):
    with pytest.raises(IndexError, match=f"{count} poses"):
        ARM.ik_many(TS[:count])[at]  # type: ignore[index]


NONE = [
    (TS[0, :3], r"must have shape \(4, 4\), got \(3, 4\)"),
    (TS[0, :3, :3], "looks like a rotation alone"),
    (None, "got None"),
    ("home", "got 'home'"),
    (TS[0] * 1j, "must be real"),
    (5.0, "got 5.0"),
    (TS[0] * np.nan, "must be finite"),
    (TS[0] * 2, "the last row of"),
]


@pytest.mark.parametrize(("what", "said"), NONE, ids=[said for _, said in NONE])
@pytest.mark.parametrize("at", [0, 1, 2])
def test_of_a_list_of_poses_it_is_told_which_is_none(what: object, said: str, at: int):
    given = [TS[0], TS[1]]
    given.insert(at, what)  # type: ignore[arg-type]
    complex_ones = isinstance(what, np.ndarray) and np.iscomplexobj(what)
    with pytest.raises(InputError, match=said) as told:
        ARM.ik_many(given)
    assert (
        complex_ones or f"Ts[{at}]" in str(told.value) or f"(at index {at})" in str(told.value) or np.size(what) == 16
    )
    many = ARM.ik_many(given, invalid="mark")
    assert many.status[at] == Status.INVALID and list(many.reasons) == [at] and f"Ts[{at}]" in many.reasons[at]
    assert many[at].reason == many.reasons[at] and len(many[at]) == 0
    others = [k for k in range(3) if k != at]
    assert np.array_equal(many.q[others], ARM.ik_many(TS[:2]).q)
    assert list(many[::-1].reasons) == [2 - at] and many[others].reasons == {}
    assert pickle.loads(pickle.dumps(many)).reasons == many.reasons


@pytest.mark.parametrize("given", [[None], [None, "x"], [np.zeros((3, 3))] * 2, [[]], ({},), [[1, 2, 3]] * 2])
def test_a_list_in_which_nothing_is_a_pose_is_marked(given: Any):
    many = ARM.ik_many(given, invalid="mark")
    assert (many.status == Status.INVALID).all() and list(many.reasons) == list(range(len(given)))
    with pytest.raises(InputError, match="Ts"):
        ARM.ik_many(given)


@pytest.mark.parametrize("given", [[1.0, 2.0, 3.0], np.eye(4).tolist(), np.zeros((2, 3, 3)), None, "x", {}])
def test_what_is_no_list_of_poses_is_refused_as_a_whole(given: Any):
    with pytest.raises(InputError, match="Ts"):
        ARM.ik_many(given, invalid="mark")


@pytest.mark.parametrize("name", ["franka-panda", "denso-vp6242", "three-r"])
def test_nothing_chosen_by_name_is_nothing_chosen(name: str):
    arm = pieper.load(name)
    T = arm.fk(np.clip(np.full(arm.n, 0.3), *arm.limits.T))
    plain, empty = arm.ik(T), arm.ik(T, redundancy={})
    assert len(plain.q) and np.array_equal(plain.q, empty.q)
    assert (plain.status, plain.why) == (empty.status, empty.why)
    assert np.array_equal(arm.ik_many(T[None], redundancy={}).q, arm.ik_many(T[None]).q)


def test_degrees_are_warned_of_wherever_a_posture_is_near_to_what():
    arm, q = pieper.load("denso-vp6242"), np.array([10.0, 20.0, -150.0, 10.0, 20.0, 30.0])
    T = arm.fk(np.radians(q))
    for ask in (
        lambda: arm.ik(T).nearest(q),
        lambda: arm.ik(T).nearest_row(q),
        lambda: arm.ik_many(T[None], near=q),
        lambda: arm.ik_many(T[None], near="previous", start=q),
    ):
        with pytest.warns(pieper.PieperWarning, match="-150|150.*looks like degrees"):
            ask()
