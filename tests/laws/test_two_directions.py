"""Two directions free at once: read off in closed form, and complete beside an independent search."""

from __future__ import annotations

import numpy as np
import pytest

from oracle import judge, machine
from oracle.arms.known import free
from pieper import Arm
from pieper.kinematics.newton import missed
from pieper.solver.singular.traced_motion import TracedMotion


def wrist_on_axis_1(arm: Arm, q: np.ndarray, joint: int) -> np.ndarray | None:
    """Return q with one joint so that the wrist's centre lies on axis 1, by halving; None where it cannot."""

    def aside(value: float) -> float:
        point = q.copy()
        point[joint] = value
        frames = arm.chain.native_axes.frames(point[None], np.eye(4))[0]
        return float((frames[5, :3, 3] - frames[1, :3, 3]) @ np.cross(frames[2, :3, 2], frames[1, :3, 2]))

    values = np.linspace(-3, 3, 241)
    side = np.sign([aside(v) for v in values])
    turns = np.flatnonzero(side[1:] != side[:-1])
    if not len(turns):
        return None
    turn = int(turns[0])
    low, high = values[turn], values[turn + 1]
    for _ in range(80):
        middle = (low + high) / 2
        low, high = (middle, high) if np.sign(aside(middle)) == side[turn] else (low, middle)
    return np.where(np.arange(6) == joint, (low + high) / 2, q)


def cases():
    """Yield arms with joint vectors where two directions are free, or one is and a root is double."""
    rng = np.random.default_rng(31)
    for name in ("denso-vp6242", "abb-irb2400"):
        found = 0
        while found < 3:
            q = wrist_on_axis_1(free(name), np.where(np.arange(6) == 4, 0.0, rng.uniform(-1.5, 1.5, 6)), 2)
            if q is not None:
                found += 1
                yield name, "shoulder and wrist", q
    for slide, second, fifth in ((0.0, 0.4, 0.0), (0.5, 0.0, 0.0), (0.0, 0.8, 0.4), (0.0, 0.0, 0.0)):
        yield "stanford-arm", f"slide {slide}, joint 2 {second}", np.array([0.3, second, slide, 0.5, fifth, 0.2])
    for q in ([0.3, 0.4, 0.0, 0.3, 0.0, 0.2], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0]):
        yield "universal-robots-ur5e", "elbow and wrist", np.array(q)


CASES = list(cases())


@pytest.mark.parametrize(("name", "what", "q"), CASES, ids=[f"{c[0]}: {c[1]}, {k}" for k, c in enumerate(CASES)])
def test_all_there_is_where_two_directions_are_free_is_read_off(name, what, q):
    arm = free(name)
    T = arm.fk(q)
    sols = arm.ik(T)
    motions = sols.self_motions
    assert sols.status.name == "SINGULAR" and motions
    assert not any(isinstance(motion, TracedMotion) for motion in motions)
    assert any(motion.contains(q, 1e-6) for motion in motions)
    for motion in motions:
        points = np.array([motion.at(u) for u in np.linspace(0, 1, 29)])
        assert missed(arm.chain, points, T).max() < 2e-12
        jumps = arm.chain.joints.apart(points[1:], points[:-1])
        assert jumps.max() < 1.6, "a motion is one course, without a jump"
    verdict = judge(arm, T, rows=sols.all_q, self_motions=motions, m=machine(arm), starts=500)
    assert not verdict.wrong and not verdict.missing


@pytest.mark.parametrize(("name", "what", "q"), CASES[::3], ids=[f"{c[0]}: {c[1]}" for c in CASES[::3]])
def test_a_batch_says_the_same_of_them_in_any_order(name, what, q):
    arm = free(name)
    rng = np.random.default_rng(3)
    T = arm.fk(np.concatenate([q[None], rng.uniform(-2, 2, (5, 6)), q[None]]))
    many, one = arm.ik_many(T, threads=1), [arm.ik(pose) for pose in T]
    back = arm.ik_many(T[::-1].copy(), threads=1)
    for i, sols in enumerate(one):
        for batch, k in ((many, i), (back, len(T) - 1 - i)):
            assert batch.status[k] == int(sols.status) and batch.flag[k] == sols.flag
            assert len(batch.q[k][batch.valid[k]]) == len(sols.all_q)
            apart = np.abs(batch.q[k][batch.valid[k]] - sols.all_q).max(initial=0.0)
            # a regular pose has its last digit from the lanes, a singular one takes one road alone
            assert apart == 0.0 if sols.flag & 1 else apart < 1e-12
            assert np.array_equal(batch.in_limits[k][batch.valid[k]], sols.in_limits)
