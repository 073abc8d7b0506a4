"""Ctrl-C ends every call that can take over a second, and soon."""

from __future__ import annotations

import os
import signal
import threading
import time
import warnings
from collections.abc import Callable

import numpy as np
import pytest

import pieper
from benchmarks.measure import soak
from pieper import PieperWarning

PI = np.pi
#: A call that is not stopped by the signal takes longer than what is waited for, on any machine.
BEFORE, WAITED = 0.5, 5.0


def poses_of(arm: pieper.Arm, count: int) -> np.ndarray:
    low, high = np.clip(arm.limits, -PI, PI).T
    some = arm.fk(np.random.default_rng(1).uniform(low, high, (1000, arm.n)))
    return np.tile(some, (count // 1000, 1, 1))


def general() -> Callable[[], object]:
    rng = np.random.default_rng(5)
    rows = rng.uniform([0.05, -1.5, 0.05], [0.4, 1.5, 0.4], (6, 3))
    table = [pieper.DH(a=a, alpha=alpha, d=d, theta=0.0) for a, alpha, d in rows]
    arm = pieper.Arm.from_dh(table, convention="standard")
    T = poses_of(arm, 200_000)
    return lambda: arm.ik_many(T, threads=1)


def redundant() -> Callable[[], object]:
    arm = pieper.load("franka-panda")
    T = poses_of(arm, 60_000)
    return lambda: arm.ik_many(T, threads=1)


def nearest() -> Callable[[], object]:
    arm = pieper.load("franka-panda")
    sols = [arm.ik(T) for T in poses_of(arm, 1000)[:40]]
    now = arm.limits.mean(1)
    return lambda: [s.nearest(now) for s in sols * 20]


def near_previous() -> Callable[[], object]:
    arm = pieper.load("kuka-lbr-iiwa-14-r820")
    T = poses_of(arm, 60_000)
    return lambda: arm.ik_many(T, threads=1, near="previous")


def reach_map() -> Callable[[], object]:
    arm = pieper.load("denso-vp6242")
    return lambda: arm.reach_map(((-0.6, 0.6), (-0.6, 0.6), (-0.2, 0.9)), 0.02)


def route() -> Callable[[], object]:
    arm = pieper.load("abb-irb2400")
    start = arm.fk(np.array([0.1, 0.2, 0.1, 0.3, 0.6, 0.2]))
    seam = np.tile(start, (4000, 1, 1))
    seam[:, 1, 3] += np.linspace(0, 0.3, 4000)
    return lambda: arm.route(seam, free=pieper.Freedom())


def calibrate() -> Callable[[], object]:
    arm = pieper.load("universal-robots-ur5e")
    rng = np.random.default_rng(1)
    q = rng.uniform(-3, 3, (20_000, 6))
    measured = arm.with_tool(pieper.pose(0.001, 0, 0.002)).fk(q)
    measured[:, :3, 3] += rng.normal(0, 5e-5, (len(q), 3))
    return lambda: arm.calibrate(q, measured, joint_terms=("gain", "harmonic"), loss="huber")


def a_soak() -> Callable[[], object]:
    return lambda: [soak.one_round(seed) for seed in range(100)]


@pytest.mark.parametrize("call", [general, redundant, nearest, near_previous, reach_map, route, calibrate, a_soak])
def test_ctrl_c_ends_it(call: Callable[[], Callable[[], object]]):
    work = call()
    sent: list[float] = []

    def send() -> None:
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(BEFORE, send)
    # a process started in the background ignores the signal until somebody handles it
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    began = time.monotonic()
    try:
        with pytest.raises(KeyboardInterrupt), warnings.catch_warnings():
            warnings.simplefilter("ignore", PieperWarning)
            timer.start()
            work()
            timer.cancel()
            pytest.skip(f"this took no longer than {time.monotonic() - began:.1f} s")
    finally:
        timer.join()
        signal.signal(signal.SIGINT, before)
    assert time.monotonic() - sent[0] < WAITED
