"""What the kernels step by, held against slow kinematics: onto a pose, down to one in a box, along a self-motion."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from oracle import slow_forward
from pieper import DH, Arm, _kernel
from pieper.kinematics.newton import newton, pose_difference
from pieper.solver.redundant.box import descended
from pieper.solver.singular.self_motion import FREE
from pieper.solver.singular.trace import trace
from pieper.tolerances import CURVE_STEP

ARMS = ["denso-vp6242", "franka-panda", "rethink-sawyer", "stanford-arm", "general eight", "sliding seven"]
ARMS += ["rob0036", "pincherx-100"]  # with fewer joints than a pose has freedoms


def some(name: str) -> Arm:
    """Return an arm of the catalogue, or one of no special kind, a slide among its joints."""
    if name in pieper.catalog():
        return pieper.load(name)
    rng, types = np.random.default_rng(4), "RRRRRRRR" if name.endswith("eight") else "RRPRRRR"
    rows = [DH(rng.uniform(-0.5, 0.5), rng.uniform(-3, 3), rng.uniform(-0.5, 0.5), 0.0) for _ in types]
    return Arm.from_dh(rows, convention="standard", joint_types=types)


def miss(arm: Arm, q: np.ndarray, T: np.ndarray) -> np.ndarray:
    """Return how far postures (k, n) miss poses, the largest entry, lengths by the arm's."""
    gap = slow_forward.fk(arm.chain, q) - T
    gap[..., :3, 3] /= arm.chain.length
    return np.abs(gap).max((-1, -2))


@pytest.mark.parametrize("name", ARMS)
def test_newton_gets_onto_the_pose_and_a_row_depends_on_no_other(name):
    arm, rng = some(name), np.random.default_rng(1)
    unit = arm.chain.joints.unit
    q = rng.uniform(-1, 1, (40, arm.n)) * unit
    T = slow_forward.fk(arm.chain, q)
    start = q + rng.uniform(-0.02, 0.02, q.shape) * unit
    moved = newton(arm.chain, start, T, steps=12)
    assert np.median(miss(arm, moved, T)) < 1e-14
    assert (miss(arm, moved, T) <= miss(arm, start, T)).all()
    for i in (0, 17, 39):
        np.testing.assert_array_equal(newton(arm.chain, start[i], T[i], steps=12), moved[i])
    np.testing.assert_array_equal(newton(arm.chain, start[:5], T[0], steps=0), start[:5])


@pytest.mark.parametrize("name", ARMS)
def test_a_step_of_newton_is_the_shortest_there_is(name):
    arm, rng = some(name), np.random.default_rng(2)
    unit = arm.chain.joints.unit
    q = rng.uniform(-1, 1, (20, arm.n)) * unit
    start = q + rng.uniform(-1e-4, 1e-4, q.shape) * unit
    T = slow_forward.fk(arm.chain, q)
    moved = newton(arm.chain, start, T, steps=1)
    missing = pose_difference(arm.chain, start, T)
    J = slow_forward.jacobian(arm.chain, start)
    J[:, :3] /= arm.chain.length
    J = np.where(arm.chain.prismatic, J * arm.chain.length, J)
    for way, slope, e in zip((moved - start) / unit, J, missing, strict=True):
        assert np.abs(way - np.linalg.pinv(slope, rcond=1e-12) @ e).max() < 1e-9


@pytest.mark.parametrize("name", ARMS)
def test_the_weakest_direction_is_bounded_from_below(name):
    arm, rng = some(name), np.random.default_rng(7)
    q = rng.uniform(-1, 1, (200, arm.n)) * arm.chain.joints.unit
    q[:20, 1:] = 0.0  # singular ones among them
    J = slow_forward.jacobian(arm.chain, q)
    J[:, :3] /= arm.chain.length
    s = np.linalg.svd(np.where(arm.chain.prismatic, J * arm.chain.length, J), compute_uv=False)
    true, bound = s[:, -1] / s[:, 0], _kernel.parts_of_weakest(arm.chain.plain, q=q)
    assert (bound <= true + 1e-15).all() and (6.001 * bound >= true - 1e-14).all()


@pytest.mark.parametrize("name", ARMS)
def test_a_descent_never_leaves_its_box_and_says_what_it_misses(name):
    arm, rng = some(name), np.random.default_rng(3)
    unit = arm.chain.joints.unit
    centre = rng.uniform(-1, 1, (60, arm.n)) * unit
    low, high = centre - 0.4 * unit, centre + 0.4 * unit
    q = rng.uniform(low, high)
    T = slow_forward.fk(arm.chain, q)
    T[::4, :3, 3] += arm.chain.length  # some that lie elsewhere
    moved, off = descended(arm.chain, centre, T, low, high)
    assert ((moved >= low) & (moved <= high)).all()
    held = off < 1e-9
    assert held.sum() > 20
    assert miss(arm, moved[held], T[held]).max() < 1e-8
    assert (miss(arm, moved[~held], T[~held]) > 1e-9).all()
    np.testing.assert_array_equal(descended(arm.chain, centre[7:8], T[7:8], low[7:8], high[7:8])[0][0], moved[7])


@pytest.mark.parametrize("name", ["franka-panda", "rethink-sawyer", "sliding seven"])
def test_a_followed_self_motion_holds_its_pose_in_small_steps_until_it_is_home(name):
    arm, rng = some(name), np.random.default_rng(5)
    unit = arm.chain.joints.unit
    for _ in range(3):
        q = rng.uniform(-1, 1, arm.n) * unit
        T = slow_forward.fk(arm.chain, q)
        motion = trace(arm.chain, q, T, arm.limits, arm.joint_names)
        assert miss(arm, motion.samples, T).max() < 1e-11
        steps = np.linalg.norm(np.diff(motion.samples / unit, axis=0), axis=1)
        assert steps[:-1].max() < 1.1 * CURVE_STEP
        assert steps[-1] < 1.8 * CURVE_STEP  # the step home takes in what is left
        if motion.closed:
            home = arm.chain.joints.unwound(motion.samples[-1], motion.samples[0], np.tile(FREE, (arm.n, 1)))
            assert np.abs(home - motion.samples[0]).max() < 1e-12


def test_arrays_of_the_wrong_shape_are_refused():
    chain = pieper.load("denso-vp6242").chain.plain
    with pytest.raises(ValueError, match="q must be"):
        _kernel.onto(chain, q=np.zeros((3, 5)), T=np.eye(4), steps=1, cutoff=0.1, longest=0.5)
    with pytest.raises(ValueError, match="q and direction"):
        _kernel.follow_curve(
            chain, q=np.zeros(5), T=np.eye(4), direction=np.zeros(6), step=0.1, straight=0.9, most_steps=9
        )
