"""A slide all but drawn in: four positions lie as near to each other as it is out, none in the place of another."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from oracle.arms.known import free
from pieper import DH, Arm, Status

H = pi / 2


def drawn(rng: np.random.Generator) -> Arm:
    """Return an arm whose wrist comes to stand on its second axis as its slide is drawn in, as Stanford's does."""
    rows = [
        DH(0, -H, rng.uniform(0.2, 0.6)),
        DH(0, H, rng.uniform(0.1, 0.3)),
        DH(rng.uniform(0.01, 0.05), 0, 0, -H),
        *(DH(0, -H), DH(0, H), DH(0, 0, rng.uniform(0, 0.2))),
    ]
    return Arm.from_dh(rows, convention="standard", joint_types="RRPRRR")


ARMS = {
    "stanford": lambda: free("stanford-arm"),
    **{f"drawn {k}": lambda k=k: drawn(np.random.default_rng(k)) for k in range(2)},
}


OUT = [1e-3, 1e-5, 1e-6, 1e-7, 1e-9, 0.0]


def drawn_in(name: str, out: float) -> tuple[Arm, np.ndarray]:
    """Return an arm and postures (8, 6) with the slide drawn in to about `out`, m."""
    rng = np.random.default_rng(4)
    q = rng.uniform(-3, 3, (8, 6))
    q[:, 2] = out * rng.uniform(0.5, 2, 8) * rng.choice([-1, 1], 8)
    return ARMS[name](), q


@pytest.mark.parametrize("out", OUT)
@pytest.mark.parametrize("name", ARMS)
def test_the_posture_that_made_the_pose_is_told_however_far_the_slide_is_drawn_in(name, out):
    arm, q = drawn_in(name, out)
    T = arm.fk(q)
    told = 1e-6 + 1e-14 / np.maximum(np.linalg.svd(arm.jacobian(q), compute_uv=False)[:, -1], 1e-300)
    many = arm.ik_many(T, threads=1)
    for i, pose in enumerate(T):
        sols = arm.ik(pose)
        near = arm.chain.joints.apart(sols.all_q, q[i]).min(initial=np.inf) < told[i]
        assert near or any(motion.contains(q[i], min(told[i], 1e-3)) for motion in sols.self_motions), q[i].tolist()
        assert many.status[i] == sols.status
        assert np.abs(many.q[i][many.valid[i]] - sols.all_q).max(initial=0.0) < 1e-9


@pytest.mark.parametrize("out", OUT)
@pytest.mark.parametrize("name", ARMS)
def test_poses_with_the_slide_drawn_in_are_not_doubted(name, out):
    arm, q = drawn_in(name, out)
    assert np.isin(arm.ik_many(arm.fk(q), threads=1).status, [Status.SOLVED, Status.SINGULAR]).all()
