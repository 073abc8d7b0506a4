"""The solver every family shares: one and many, threads, limits, poses that are none, instruction sets."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

from oracle import slow_forward
from oracle.arms.wrists import ARMS, solver
from pieper import InputError, _kernel

PI = np.pi
NAMES = list(ARMS)


def poses(chain, count, seed=0):
    q = np.random.default_rng(seed).uniform(-PI, PI, (count, 6))
    return np.ascontiguousarray(slow_forward.fk(chain, q))


@pytest.mark.parametrize("name", NAMES)
def test_one_pose_alone_gives_what_it_gives_among_many(name):
    chain = ARMS[name]
    T = poses(chain, 61)
    q, valid, in_limits, flag = solver(chain).many(T)
    for i in range(len(T)):
        rows, slots, inside, bits = solver(chain).one(T[i])
        assert list(slots) == list(np.flatnonzero(valid[i]))
        np.testing.assert_allclose(rows, q[i][valid[i]], atol=1e-9)
        assert list(inside) == list(in_limits[i][valid[i]])
        assert bits == flag[i]


@pytest.mark.parametrize("count", [0, 1, 2, 3, 4, 5, 7, 8, 9, 17, 255, 256, 257, 1025])
def test_any_number_of_poses_comes_out_in_order(count):
    chain = ARMS[NAMES[1]]
    T = poses(chain, 1025)
    q, valid, in_limits, flag = solver(chain).many(T)
    part = solver(chain).many(T[:count])
    assert part[0].shape == (count, 8, 6) and part[3].shape == (count,)
    np.testing.assert_allclose(part[0], q[:count], atol=1e-9)
    assert (part[1] == valid[:count]).all() and (part[2] == in_limits[:count]).all() and (part[3] == flag[:count]).all()


def test_threads_do_not_change_the_answer():
    chain = ARMS[NAMES[2]]
    T = poses(chain, 10000)
    alone, shared = solver(chain).many(T, 1), solver(chain).many(T, 3)
    for a, b in zip(alone, shared, strict=True):
        assert np.array_equal(a, b)


def test_limits_choose_the_turn_that_lies_inside():
    chain = ARMS["no offsets"]
    T = poses(chain, 500)
    free, valid, _, _ = solver(chain).many(T)
    limits = np.tile([-0.5, 2 * PI - 0.5], (6, 1))
    limits[1] = -1.0, 1.0
    limits[5] = -np.inf, 0.0
    q, same, inside, _ = solver(chain, limits).many(T)
    assert np.array_equal(valid, same)
    expected = free.copy()
    for j in (0, 2, 3, 4):
        expected[..., j] = np.where(free[..., j] < -0.5, free[..., j] + 2 * PI, free[..., j])
    expected[..., 5] = np.where(free[..., 5] > 0, free[..., 5] - 2 * PI, free[..., 5])
    np.testing.assert_allclose(q[valid], expected[valid], atol=1e-12)
    assert np.array_equal(inside, valid & (np.abs(free[..., 1]) <= 1.0))
    assert inside.any() and (valid & ~inside).any()


def test_a_value_rounded_past_its_limit_is_inside():
    chain = ARMS["no offsets"]
    q = np.array([0.3, 0.4, 0.5, 0.6, 0.7, 0.8])
    limits = np.stack([q, q], 1)
    _, _, inside, _ = solver(chain, limits).one(slow_forward.fk(chain, q))
    assert inside.sum() == 1


def broken(kind):
    T = np.eye(4)
    if kind == "nan":
        T[0, 3] = np.nan
    elif kind == "infinity":
        T[1, 1] = np.inf
    elif kind == "left-handed":
        T[2, 2] = -1.0
    elif kind == "scaled":
        T[:3, :3] *= 1.001
    elif kind == "sheared":
        T[0, 1] = 1e-3
    elif kind == "last row":
        T[3, 0] = 0.1
    return T


@pytest.mark.parametrize("kind", ["nan", "infinity", "left-handed", "scaled", "sheared", "last row"])
def test_what_is_not_a_pose_is_refused_with_its_index_and_deviation(kind):
    chain = ARMS["no offsets"]
    with pytest.raises(
        InputError, match="finite" if kind in ("nan", "infinity") else kind if kind == "left-handed" else "departs"
    ):
        solver(chain).one(broken(kind))
    T = poses(chain, 700)
    T[500] = broken(kind)
    with pytest.raises(InputError, match=r"Ts\[500\]") as caught:
        solver(chain).many(T)
    assert caught.value.index == 500
    assert not caught.value.deviation <= 1e-5


@pytest.mark.parametrize("shape", [(3, 3), (4,), (2, 4, 4), (16,)])
def test_one_pose_must_be_four_by_four(shape):
    with pytest.raises(InputError, match=r"shape \(4, 4\)"):
        solver(ARMS["no offsets"]).one(np.zeros(shape))


def test_a_pose_rounded_to_float32_is_solved_to_its_nearest_rotation_and_marked():
    chain = ARMS["no offsets"]
    exact = poses(chain, 50)
    rounded = exact.astype(np.float32)
    q, valid, _, flag = solver(chain).many(rounded)
    assert (flag & 8).all()
    again = slow_forward.fk(chain, q)
    R = rounded.astype(float)[:, :3, :3]
    U, _, Vt = np.linalg.svd(R)
    nearest = U @ Vt
    assert np.abs((again[..., :3, :3] - nearest[:, None])[valid]).max() < 1e-12
    assert not (solver(chain).many(exact)[3] & 8).any()


def test_views_lists_and_integers_are_taken_as_they_are_meant():
    chain = ARMS["no offsets"]
    T = poses(chain, 40)
    expected = solver(chain).many(np.ascontiguousarray(T[::2]))[0]
    assert np.array_equal(solver(chain).many(T[::2])[0], expected)
    assert np.array_equal(solver(chain).many(T[::2].tolist())[0], expected)
    assert np.array_equal(solver(chain).many(np.asfortranarray(T[::2]))[0], expected)
    with pytest.raises(InputError, match="numbers"):
        solver(chain).one("home")


def test_a_geometry_says_what_it_lacks_what_it_does_not_know_and_which_shape_it_wants():
    links = np.tile(np.eye(4), (7, 1, 1))
    with pytest.raises(TypeError, match="general needs 'slides'"):
        _kernel.General(links=links, scale=1.0)
    with pytest.raises(TypeError, match="general takes links, slides, scale"):
        _kernel.General(links=links, slides=(0,) * 6, scale=1.0, kind=1)
    with pytest.raises(ValueError, match=r"general.links: must have shape \(7, 4, 4\), got \(4, 4, 4\)"):
        _kernel.General(links=np.zeros((4, 4, 4)), slides=(0,) * 6, scale=1.0)


def test_the_interpreter_runs_on_while_many_poses_are_solved():
    chain = ARMS["no offsets"]
    T = np.tile(poses(chain, 1000), (200, 1, 1))
    ticks, done = [], threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(1)
            time.sleep(0.001)

    other = threading.Thread(target=tick)
    other.start()
    most = 0
    # a solver that kept the interpreter to itself would let one through at its end, and on a busy machine few come
    for _ in range(50):
        before = len(ticks)
        solver(chain).many(T, 1)
        most = max(most, len(ticks) - before)
        if most > 5:
            break
    done.set()
    other.join()
    assert most > 5


def test_ctrl_c_stops_the_work():
    chain = ARMS["no offsets"]
    T = np.broadcast_to(poses(chain, 1000), (300, 1000, 4, 4)).reshape(-1, 4, 4)
    timer = threading.Timer(0.03, os.kill, (os.getpid(), signal.SIGINT))
    # a process started in the background ignores the signal until somebody handles it
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        with pytest.raises(KeyboardInterrupt):
            timer.start()
            for _ in range(100):
                solver(chain).many(T, 2)
        timer.join()
    finally:
        signal.signal(signal.SIGINT, before)


PROGRAM = """
import sys
import numpy as np
from oracle.arms.wrists import ARMS, solver
from pieper import _kernel
from pieper.kinematics.forward import fk, jacobian
chain = ARMS[sys.argv[1]]
q = np.random.default_rng(5).uniform(-3, 3, (403, 6))
T = fk(chain, q)
found, valid, inside, flag = solver(chain).many(T)
np.savez(sys.argv[2], isa=_kernel.isa, T=T, J=jacobian(chain, q), q=found, valid=valid, flag=flag)
"""


@pytest.mark.parametrize("name", NAMES[:3])
def test_every_instruction_set_gives_the_same_answers(name, tmp_path):
    results = []
    for isa in _kernel.isa_available.split():
        target = tmp_path / f"{isa}.npz"
        subprocess.run(
            [sys.executable, "-c", PROGRAM, name, str(target)],
            check=True,
            env={**os.environ, "PIEPER_ISA": isa, "PYTHONPATH": os.pathsep.join(sys.path)},
        )
        results.append(np.load(target))
        assert str(results[-1]["isa"]) == isa
    for other in results[1:]:
        np.testing.assert_allclose(other["T"], results[0]["T"], atol=1e-14)
        np.testing.assert_allclose(other["J"], results[0]["J"], atol=1e-13)
        assert np.array_equal(other["valid"], results[0]["valid"])
        np.testing.assert_allclose(other["q"], results[0]["q"], atol=1e-8)


def test_an_instruction_set_this_machine_lacks_is_refused_with_the_list():
    ended = subprocess.run(
        [sys.executable, "-c", "import pieper._kernel"],
        capture_output=True,
        text=True,
        env={**os.environ, "PIEPER_ISA": "mmx", "PYTHONPATH": os.pathsep.join(sys.path)},
    )
    assert ended.returncode != 0
    assert _kernel.isa_available in ended.stderr
