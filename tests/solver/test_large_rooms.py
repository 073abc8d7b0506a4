"""Large answers stand in rooms that are used again: never while anybody holds one, and nothing of the last is seen."""

import copy
import multiprocessing
import os
import pickle
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import pieper
from pieper.solver import large_rooms

COUNT = 12_000  # poses whose answers are 4.6 MB

pytestmark = pytest.mark.skipif(not large_rooms._KEEPING, reason="this system tells nobody that memory is free")


@pytest.fixture(scope="module")
def arm():
    return pieper.load("denso-vp6242")


@pytest.fixture(scope="module")
def poses(arm):
    lower, upper = arm.limits.T
    return arm.fk(np.random.default_rng(3).uniform(lower, upper, (COUNT, 6)))


@pytest.fixture(autouse=True)
def _no_room_kept():
    large_rooms.let_go()
    yield
    large_rooms.let_go()


def place(array):
    """Return where an array's numbers stand."""
    return array.__array_interface__["data"][0]


def test_a_room_that_nobody_holds_is_used_again_and_one_that_somebody_holds_is_not(arm, poses):
    first = arm.ik_many(poses)
    at = place(first.q)
    second = arm.ik_many(poses)
    assert place(second.q) != at
    part = first.q[7, 2:4].T  # a view of a view holds it too
    kept = part.copy()
    del first
    third = arm.ik_many(poses[::-1])
    assert place(third.q) not in (at, place(second.q))
    assert np.array_equal(part, kept)
    del part
    assert place(arm.ik_many(poses).q) == at


def test_nothing_of_what_stood_there_is_seen(arm, poses):
    far = poses.copy()
    far[::3, :3, 3] *= 50  # no solutions: zeros
    small = arm.ik_many(far[:300])
    room = large_rooms.large_room(COUNT * 8 * 48 + 64)
    at = place(room)
    room.view(float)[:] = np.nan
    del room
    found = arm.ik_many(far)
    assert at <= place(found.q) < at + large_rooms.PAGE
    assert np.isfinite(found.q).all()
    assert not found.q[~found.valid].any()
    assert np.array_equal(found.q[:300], small.q)


def test_some_rooms_are_kept_and_none_that_is_too_large():
    def kept():
        return [len(room) for room in large_rooms._kept]

    whole = (40 << 20) + large_rooms.PAGE
    rooms = [large_rooms.large_room(40 << 20) for _ in range(5)]
    assert not kept()
    del rooms
    assert kept() == [whole] * (large_rooms.MOST_KEPT // whole)
    large = large_rooms.large_room(large_rooms.MOST_KEPT + 1)
    del large
    assert kept() == [whole] * (large_rooms.MOST_KEPT // whole)
    large_rooms.let_go()
    assert not kept()
    small = [large_rooms.large_room(large_rooms.LARGE) for _ in range(large_rooms.MOST_ROOMS + 3)]
    del small
    assert len(kept()) == large_rooms.MOST_ROOMS
    assert large_rooms.large_room(1000).flags.owndata  # what is smaller is NumPy's own


def test_a_room_much_too_large_is_not_taken():
    large = large_rooms.large_room(64 << 20)
    at = place(large)
    del large
    assert place(large_rooms.large_room(8 << 20)) != at


def test_none_of_an_answers_arrays_meets_fresh_memory_again(arm, poses):
    poses = np.tile(poses, (6, 1, 1))  # 72,000: of as many the flags of rows take half a MB
    many = [poses[:k] for k in (72_000, 71_000, 72_000)]
    names = ("q", "valid", "in_limits")
    first = {name: place(getattr(arm.ik_many(many[0]), name)) for name in names}
    places = set(first.values())
    for T in many:
        found = arm.ik_many(T)
        assert {place(getattr(found, name)) for name in names} == places
        del found


def test_copies_and_pickles_stand_alone(arm, poses):
    found = arm.ik_many(poses)
    expected = found.q.copy()
    copied, pickled = copy.deepcopy(found), pickle.loads(pickle.dumps(found))
    del found
    arm.ik_many(poses[::-1])
    for other in (copied, pickled):
        assert np.array_equal(other.q, expected)


def test_threads_do_not_share_a_room(arm, poses):
    expected = arm.ik_many(poses, threads=1)

    def many(shift):
        return all(
            np.array_equal(arm.ik_many(np.roll(poses, shift, 0), threads=1).q, np.roll(expected.q, shift, 0))
            for _ in range(8)
        )

    with ThreadPoolExecutor(4) as pool:
        assert all(pool.map(many, (0, 1, 2, 3)))


def _in_child(arm, poses, expected, queue):
    found = arm.ik_many(poses)
    queue.put(bool(np.array_equal(found.q, expected)))
    found.q[:] = -1.0


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork here")
@pytest.mark.filterwarnings("ignore:.*multi-threaded.*fork:DeprecationWarning")
def test_a_forked_process_has_a_room_of_its_own(arm, poses):
    expected = arm.ik_many(poses, threads=1).q.copy()  # its room is kept now
    context = multiprocessing.get_context("fork")
    queue = context.SimpleQueue()
    child = context.Process(target=_in_child, args=(arm, poses, expected, queue))
    child.start()
    own = arm.ik_many(poses, threads=1)
    assert queue.get()
    child.join()
    assert child.exitcode == 0
    assert np.array_equal(own.q, expected)


def test_the_end_of_the_program_is_quiet():
    program = (
        "import numpy as np, pieper\n"
        "arm = pieper.load('denso-vp6242')\n"
        "kept = arm.ik_many(np.tile(arm.fk(np.ones(6)), (20000, 1, 1)))\n"
        "q = kept.q[3]\n"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)
    assert done.returncode == 0
    assert not done.stderr
