"""A sweep of a redundant joint: slices hold the pose, what continues what is mutually nearest, finer in doubt."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import pieper
from oracle.joints import turns_apart
from pieper.solver.redundant.sweep import FAR, HALVINGS, HALVINGS_PREPARED, LOST, beside, sweep

ARMS = ["kuka-lbr-iiwa-14-r820", "rethink-sawyer", "motoman-sia10d"]


@pytest.mark.parametrize("name", ARMS)
def test_slices_hold_the_pose_and_what_continues_a_row_is_mutually_nearest_to_it(name):
    arm = pieper.load(name)
    plan, rng = arm.plan, np.random.default_rng(4)
    joint = arm.joint_names.index(plan.redundancy[0])
    for q in rng.uniform(-1.5, 1.5, (2, arm.n)):
        T = arm.fk(q)
        swept = sweep(plan, T, 0, plan.defaults)
        steps = np.diff(swept.values)
        assert (steps > 0).all() and len(swept.after) == len(steps)
        assert np.isclose(swept.values[0], -np.pi) and np.isclose(swept.values[-1], np.pi)
        rows = swept.q[swept.valid]
        assert len(rows) and np.abs(arm.fk(rows) - T).max() < 1e-9
        at = np.broadcast_to(swept.values[:, None], swept.valid.shape)[swept.valid]
        assert turns_apart(rows[:, joint], at).max() < 1e-12
        for i in range(len(steps)):
            ok, ok_next = swept.valid[i], swept.valid[i + 1]
            distance = np.linalg.norm(turns_apart(swept.q[i][:, None], swept.q[i + 1][None]), axis=2)
            distance[~(ok[:, None] & ok_next[None])] = np.inf
            wanted = np.full(len(ok), -1)
            for row in np.flatnonzero(ok):
                near = int(distance[row].argmin())
                if distance[row, near] < LOST and int(distance[:, near].argmin()) == row:
                    wanted[row] = near
            assert (swept.after[i] == wanted).all()
            assert all(swept.before[i, wanted[row]] == row for row in np.flatnonzero(wanted >= 0))
            # in doubt where rows end or go far: halved as often as it may be
            kept = wanted >= 0
            far = any(distance[row, wanted[row]] > FAR for row in np.flatnonzero(kept))
            least = steps.max() / 2 ** (HALVINGS_PREPARED if plan.reduction.at_ends is None else HALVINGS)
            assert not (far or kept.sum() != ok.sum() or kept.sum() != ok_next.sum()) or steps[i] < 1.01 * least


@pytest.mark.parametrize("name", ARMS)
def test_curves_that_no_slice_met_are_met_from_poses_beside(name):
    arm, rng = pieper.load(name), np.random.default_rng(5)
    q = rng.uniform(-1.5, 1.5, arm.n)
    T = arm.fk(q)
    swept = sweep(arm.plan, T, 0, arm.plan.defaults)
    unseen = replace(swept, valid=np.zeros_like(swept.valid))
    points = beside(arm.plan, T, 0, arm.plan.defaults, unseen)
    assert len(points) and np.abs(arm.fk(points) - T).max() < 1e-9
    assert all(any(m.contains(p) for m in arm.ik(T).self_motions) for p in points[::20])
