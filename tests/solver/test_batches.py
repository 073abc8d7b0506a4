"""What is asked of a batch beside its poses: a chosen row, arrays to write into, bad poses, progress."""

from __future__ import annotations

import copy
import dataclasses
import itertools
import pickle
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context

import numpy as np
import pytest

import pieper
from pieper import Status
from pieper.errors import InputError

ARMS = ["denso-vs6577", "universal-robots-ur5e", "stanford-arm", "motoman-ea1400n", "franka-panda", "three-r"]
TURN = 2 * np.pi


def wide(name: str) -> pieper.Arm:
    """An arm whose joints may turn more than once, and one of them less."""
    arm = pieper.load(name)
    rng = np.random.default_rng(len(name))
    limits = {}
    for joint, kind, (lower, upper) in zip(arm.joint_names, arm.joint_types, arm.limits, strict=True):
        if kind == "P":
            limits[joint] = (float(np.clip(lower, -2, 2)), float(np.clip(upper, -2, 2)))
        else:
            limits[joint] = tuple(np.sort(rng.uniform([-9, 2], [-2, 9])))
    limits[arm.joint_names[1]] = (-2.5, 2.2)
    return arm.with_limits(limits)


def poses(arm: pieper.Arm, count: int, seed: int = 0) -> np.ndarray:
    """Poses of which some are singular and some out of reach."""
    rng = np.random.default_rng(seed)
    lower, upper = np.clip(arm.limits, -3, 3).T
    q = rng.uniform(lower, upper, (count, arm.n))
    q[1:100:29] = 0.0
    T = arm.fk(q)
    T[7::61, :3, 3] *= 40
    return T


def best_of_all(arm: pieper.Arm, rows: np.ndarray, near: np.ndarray, weights: np.ndarray) -> tuple[float, int]:
    """The least distance over every whole-turn variant of every row, and how many variants there are."""
    least, count = np.inf, 0
    for row in rows:
        choices = []
        for value, (lower, upper), kind in zip(row, arm.limits, arm.joint_types, strict=True):
            turns = range(-4, 5) if kind == "R" else [0]
            choices.append([v for k in turns if lower - 1e-9 <= (v := value + TURN * k) <= upper + 1e-9])
        variants = np.array(list(itertools.product(*choices)))
        count += len(variants)
        gaps = (variants - near) / arm.chain.joints.unit
        least = min(least, float(np.sqrt((weights * gaps**2).sum(1)).min()))
    return least, count


@pytest.mark.parametrize("name", ARMS)
@pytest.mark.parametrize("one_a_pose", [False, True])
def test_the_chosen_row_is_the_nearest_of_every_winding_of_every_row(name, one_a_pose):
    arm = wide(name)
    T = poses(arm, 40)
    rng = np.random.default_rng(5)
    near = rng.uniform(-8, 8, (40, arm.n) if one_a_pose else arm.n)
    weights = rng.uniform(0, 2, arm.n) * (np.arange(arm.n) != 2)
    many = arm.ik_many(T, near=near, weights=weights)
    unit, seen = arm.chain.joints.unit, 0
    for i, now in enumerate(np.broadcast_to(near, (40, arm.n))):
        least, count = best_of_all(arm, many.q[i][many.in_limits[i]], now, weights)
        assert bool(many.has_nearest[i]) == (count > 0)
        if count:
            seen += 1
            away = np.sqrt(np.sum(weights * ((many.nearest[i] - now) / unit) ** 2))
            assert away == pytest.approx(least, abs=1e-9)
            assert (many.nearest[i] >= arm.limits[:, 0] - 1e-8).all()
            assert (many.nearest[i] <= arm.limits[:, 1] + 1e-8).all()
            assert arm.plan.residual(many.nearest[i], T[i]).max() < 1e-8
        else:
            assert not many.nearest[i].any()
    assert seen > 10


@pytest.mark.parametrize("name", ARMS)
@pytest.mark.parametrize("started", [False, True])
def test_in_turn_each_row_is_the_nearest_to_the_one_before(name, started):
    arm = wide(name)
    T = poses(arm, 30)
    start = np.full(arm.n, 0.7)
    many = arm.ik_many(T, near="previous", start=start if started else None)
    now, first = (start, False) if started else (np.zeros(arm.n), True)
    for i in range(30):
        rows = many.q[i][many.in_limits[i]]
        assert bool(many.has_nearest[i]) == (len(rows) > 0)
        if len(rows) and first:
            assert np.array_equal(many.nearest[i], rows[0])
            first = False
        elif len(rows):
            least, _ = best_of_all(arm, rows, now, np.ones(arm.n))
            unit = arm.chain.joints.unit
            assert np.sqrt((((many.nearest[i] - now) / unit) ** 2).sum()) == pytest.approx(least, abs=1e-9)
        else:
            assert np.array_equal(many.nearest[i], now)
        now = many.nearest[i]


@pytest.mark.parametrize("name", ARMS)
@pytest.mark.parametrize("near", [None, "previous", 0.3])
def test_no_answer_depends_on_threads_progress_or_reused_arrays(name, near):
    arm = wide(name)
    count = 300 if arm.plan.family in ("spherical_wrist_parallel", "three_parallel") else 30
    T = poses(arm, count, seed=3)
    near = np.full(arm.n, near) if isinstance(near, float) else near
    plain = arm.ik_many(T, threads=1, near=near)
    other = arm.ik_many(poses(arm, count, seed=4), threads=1, near=near)
    told = []
    again = arm.ik_many(T, threads=2, near=near, out=other, progress=lambda *said: told.append(said))
    assert again.q is other.q and again.status is other.status
    fields = ["q", "valid", "in_limits", "status", "flag"] + ["nearest", "has_nearest"] * (near is not None)
    for field in fields:
        assert np.array_equal(getattr(plain, field), getattr(again, field)), field
    assert told[-1] == (count, count) and told == sorted(told)


@pytest.mark.parametrize("chosen", [False, True])
@pytest.mark.parametrize("name", ["denso-vs6577", "universal-robots-ur5e"])
def test_a_large_batch_is_written_past_the_cache_alike(name, chosen):
    arm = pieper.load(name)
    rng = np.random.default_rng(9)
    T = arm.fk(rng.uniform(-3, 3, (100_003, 6)))
    T[7::1000, :3, 3] *= 20  # out of reach
    T[9::1000, :3, :3] = np.round(T[9::1000, :3, :3], 7)  # no rotation but for rounding
    near = rng.uniform(-3, 3, (len(T), 6)) if chosen else None
    large = arm.ik_many(T, near=near)
    elsewhere = np.empty(large.q.size + 1)[1:].reshape(large.q.shape)  # on no line of the cache
    out = dataclasses.replace(large, found=dataclasses.replace(large.found, q=elsewhere))
    arm.ik_many(T, near=near, out=out)
    for at in (slice(0, 999), slice(50_000, 51_111), slice(len(T) - 777, None)):
        small = arm.ik_many(T[at], threads=1, near=None if near is None else near[at])
        for field in ("q", "valid", "in_limits", "status", "flag") + ("nearest", "has_nearest") * chosen:
            assert np.array_equal(getattr(large, field)[at], getattr(small, field)), field
            assert np.array_equal(getattr(out, field)[at], getattr(small, field)), field


@pytest.mark.parametrize("name", ["denso-vs6577", "universal-robots-ur5e", "fanuc-crx-10ia"])
def test_few_unclear_poses_among_many_are_told_as_they_are_alone(name):
    arm = pieper.load(name)
    rng = np.random.default_rng(3)
    q = rng.uniform(-3, 3, (2000, 6))
    q[5::100, 4] = 0  # on or beside singular postures
    q[6::100, [2, 4]] = 1e-9
    T = arm.fk(q)
    T[7::100, :3, 3] *= 3
    many = arm.ik_many(T)
    for i in np.flatnonzero((many.status != Status.SOLVED) | (many.flag > 0))[:80].tolist():
        alone, one = arm.ik_many(T[i : i + 1]), many[i]
        for field in ("q", "valid", "in_limits", "status", "flag"):
            assert np.array_equal(getattr(many, field)[i], getattr(alone, field)[0]), (i, field)
        assert one.status == arm.ik(T[i]).status


def test_rows_are_the_valid_ones_with_their_pose():
    arm = pieper.load("universal-robots-ur5e")
    many = arm.ik_many(poses(arm, 50))
    pose, q = many.rows()
    assert np.array_equal(np.bincount(pose, minlength=50), many.count)
    assert np.array_equal(q, np.concatenate([many.q[i][many.valid[i]] for i in range(50)]))


@pytest.mark.parametrize("name", ARMS)
def test_a_batch_is_not_lost_to_bad_poses(name):
    arm = wide(name)
    T = poses(arm, 40)
    spoilt = T.copy()
    spoilt[3, 1, 2] = np.nan
    spoilt[11, :3, :3] *= 1.1
    spoilt[12, :3, 0] *= -1
    spoilt[39, 3] = [0.1, 0, 0, 1]
    with pytest.raises(InputError):
        arm.ik_many(spoilt)
    now = np.full(arm.n, 0.2)
    good = arm.ik_many(T, near=now)
    many = arm.ik_many(spoilt, invalid="mark", near=now)
    bad = np.isin(np.arange(40), [3, 11, 12, 39])
    assert (many.status[bad] == Status.INVALID).all() and not many.valid[bad].any() and not many.has_nearest[bad].any()
    assert np.isfinite(many.nearest).all()
    for field in ("q", "valid", "in_limits", "status", "nearest", "has_nearest"):
        assert np.array_equal(getattr(many, field)[~bad], getattr(good, field)[~bad]), field
    assert list(many.reasons) == [3, 11, 12, 39] and good.reasons == {}
    for index, words in zip(many.reasons, ["finite", "not a rotation", "left-handed", "last row"], strict=True):
        assert words in many.reasons[index] and f"Ts[{index}]" in many.reasons[index]
    assert "INVALID" in repr(many)
    all_bad = arm.ik_many(np.full((3, 4, 4), np.nan), invalid="mark", near="previous")
    assert (all_bad.status == Status.INVALID).all() and len(all_bad.reasons) == 3 and not all_bad.has_nearest.any()


@pytest.mark.parametrize("name", ARMS)
@pytest.mark.parametrize("near", [None, "previous"])
@pytest.mark.parametrize("invalid", ["raise", "mark"])
def test_an_empty_batch_has_an_empty_answer(name, near, invalid):
    arm = pieper.load(name)
    many = arm.ik_many(np.zeros((0, 4, 4)), near=near, invalid=invalid, progress=lambda done, count: None)
    assert len(many) == 0 and many.q.shape[0] == 0 and many.q.shape[2] == arm.n and many.status.shape == (0,)
    pose, q = many.rows()
    assert pose.shape == (0,) and q.shape == (0, arm.n)
    if near:
        assert many.nearest.shape == (0, arm.n) and many.has_nearest.shape == (0,)


@pytest.mark.parametrize("name", ["denso-vs6577", "franka-panda"])
@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        ({"near": [0.0, 1.0]}, "near"),
        ({"near": np.zeros((4, 9))}, "near"),
        ({"near": "prevoius"}, "prevoius"),
        ({"near": float("nan")}, "near"),
        ({"near": "previous", "start": [1.0]}, "start"),
        ({"near": 0.0, "start": 0.0}, "start"),
        ({"start": 0.0}, "near"),
        ({"weights": 1.0}, "near"),
        ({"near": 0.0, "weights": -1.0}, "weights"),
        ({"near": 0.0, "weights": 0.0}, "weights"),
        ({"near": 0.0, "weights": float("inf")}, "weights"),
        ({"near": "previous", "weights": [1.0, 2.0]}, "weights"),
        ({"near": 0.0, "weights": ["a"]}, "weights"),
        ({"invalid": "skip"}, "skip"),
        ({"invalid": None}, "invalid"),
        ({"out": 3}, "out"),
    ],
)
def test_what_cannot_be_asked_is_said(name, wrong, words):
    arm = pieper.load(name)
    # a number alone stands for one a joint
    wrong = {key: np.full(arm.n, value) if isinstance(value, float) else value for key, value in wrong.items()}
    with pytest.raises(InputError, match=words):
        arm.ik_many(poses(arm, 5), **wrong)


@pytest.mark.parametrize("name", ["denso-vs6577", "franka-panda"])
def test_arrays_that_cannot_be_written_into_are_refused(name):
    arm = pieper.load(name)
    T, near = poses(arm, 8), np.zeros(arm.n)
    given = arm.ik_many(T, near=near)
    with pytest.raises(InputError, match="shape"):
        arm.ik_many(T[:5], out=given)
    other = pieper.load("three-r")
    with pytest.raises(InputError, match="shape"):
        arm.ik_many(T, out=other.ik_many(other.fk(np.zeros((8, 3)))))
    half = dataclasses.replace(given, found=dataclasses.replace(given.found, q=given.q.astype(np.float32)))
    with pytest.raises(InputError, match="float64"):
        arm.ik_many(T, out=half)
    turned = dataclasses.replace(given, found=dataclasses.replace(given.found, q=np.asfortranarray(given.q)))
    with pytest.raises(InputError, match="C order"):
        arm.ik_many(T, out=turned)
    given.has_nearest.flags.writeable = False
    with pytest.raises(InputError, match=r"has_nearest.*writ"):
        arm.ik_many(T, near=near, out=given)


def test_nothing_chosen_is_said_and_the_nearest_may_be_written_over_itself():
    arm = wide("denso-vs6577")
    T = poses(arm, 50)
    with pytest.raises(InputError, match="near="):
        _ = arm.ik_many(T).nearest
    first = arm.ik_many(T, near=np.zeros(6))
    wanted = arm.ik_many(T, near=first.nearest.copy()).nearest
    assert np.array_equal(arm.ik_many(T, near=first.nearest, out=first).nearest, wanted)


def test_what_progress_raises_ends_the_call():
    def stop(done: int, count: int) -> None:
        raise RuntimeError("enough")

    for name in ("denso-vs6577", "franka-panda"):
        arm = pieper.load(name)
        with pytest.raises(RuntimeError, match="enough"):
            arm.ik_many(poses(arm, 20), progress=stop)


def _solved_elsewhere(arm: pieper.Arm, T: np.ndarray) -> pieper.SolutionBatch:
    return arm.ik_many(T, threads=1, near="previous", invalid="mark")


@pytest.mark.parametrize("name", ARMS)
def test_arms_used_or_not_go_to_other_processes_and_batches_come_back(name):
    fresh, used = pieper.load(name), pieper.load(name)
    T = poses(used, 20)
    T[2] = np.nan
    here = _solved_elsewhere(used, T)
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool:
        for there in pool.map(_solved_elsewhere, [fresh, used], [T, T]):
            for field in ("q", "valid", "in_limits", "status", "nearest", "has_nearest"):
                assert np.array_equal(getattr(there, field), getattr(here, field)), field
            assert there.reasons == here.reasons
    for twin in (pickle.loads(pickle.dumps(here)), copy.deepcopy(here), copy.copy(here)):
        assert np.array_equal(twin.nearest, here.nearest) and twin.reasons == here.reasons
    again = used.ik_many(T, invalid="mark", near="previous", out=pickle.loads(pickle.dumps(here)))
    assert np.array_equal(again.q, here.q)


def test_no_poses_are_an_empty_batch():
    arm = pieper.load("denso-vp6242")
    for none in ([], np.zeros((0,)), np.zeros((0, 4, 4))):
        many = arm.ik_many(none)
        assert many.q.shape[0] == len(many.status) == 0


def test_a_pose_farther_than_metres_can_be_meant_is_refused_or_marked():
    arm = pieper.load("denso-vp6242")
    both = np.tile(arm.fk(np.zeros(6)), (2, 1, 1))
    both[1, 0, 3] = 1e300
    with pytest.raises(pieper.InputError, match="metres"):
        arm.ik_many(both)
    assert arm.ik_many(both, invalid="mark").status[1] == pieper.Status.INVALID


@pytest.mark.parametrize("name", ["franka-panda", "kuka-lbr-iiwa-7-r800", "adept-cobra-600", "three-r"])
def test_a_rounded_pose_has_the_same_rows_alone_and_in_a_batch(name):
    arm = pieper.load(name)
    q = np.random.default_rng(4).uniform(*np.clip(arm.limits, -3, 3).T, (20, arm.n))
    spare = arm.plan.reduction.locked
    values = q[:, list(spare)] if spare else None
    for T in (np.round(arm.fk(q), 6), np.float32(arm.fk(q)).astype(float)):
        many = arm.ik_many(T, redundancy=values)
        for i, pose in enumerate(T):
            alone = arm.ik(pose, redundancy=None if values is None else values[i, 0])
            together = many.q[i][many.valid[i]]
            assert alone.all_q.shape == together.shape and np.abs(alone.all_q - together).max(initial=0.0) < 1e-9
