"""Arms whose links are nothing beside the way their slides go: gantries with errors of calibration for lengths."""

from __future__ import annotations

import numpy as np
import pytest

from oracle import slow_forward
from oracle.joints import around
from pieper import DH, Arm, Status

H = np.pi / 2
#: Kinds of joints, twists and zeros of gantries and portals whose axes would meet in a point without the errors.
ARMS = [
    ("PRPRRR", [0, H, 0, H, -H, 0], [0, 0, 0, 0, 0, 0]),
    ("RPPRRR", [0, H, 0, H, H, 0], [0, H, 0, 0, 0, 0]),
    ("RPPRRR", [0, 1.0, 0.4, H, H, 0], [0, H, 0, 0, 0, 0]),
    ("PPPRRR", [H, H, 0, H, -H, 0], [H, H, 0, 0, 0, 0]),
    ("RRPRRR", [H, -H, 0, H, -H, 0], [0, 0, 0, 0, 0, 0]),
]


def erring(kinds: str, twists: list[float], zeros: list[float], size: float, seed: int) -> Arm:
    """Return an arm without lengths, but for errors up to a size (m; rad) in every number of its table."""
    error = size * np.random.default_rng(seed).uniform(-1, 1, (6, 4))
    rows = [DH(e[0], w + e[1], e[2], z + e[3]) for e, w, z in zip(error, twists, zeros, strict=True)]
    return Arm.from_dh(rows, convention="standard", joint_types=kinds, name=f"{kinds} off by {size:g}")


def missed(arm: Arm, q: np.ndarray, rows: np.ndarray) -> float:
    """Return how far the nearest of rows is from q: rad, and parts of the longest slide."""
    slide = arm.chain.prismatic
    gap = np.where(slide, (rows - q) / np.abs(q[slide]).max(), around(rows - q))
    return float(np.abs(gap).max(-1).min(initial=np.inf))


def posed(arm: Arm, far: float, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Return joint vectors (count, 6), slides up to `far` metres, and their poses by the oracle."""
    rng = np.random.default_rng(5)
    q = np.where(arm.chain.prismatic, far, 3.0) * rng.uniform(-1, 1, (count, 6))
    return q, slow_forward.fk(arm.chain, q)


@pytest.mark.parametrize("size", [1e-9, 3e-7, 1e-5, 1e-4])
@pytest.mark.parametrize(("kinds", "twists", "zeros"), ARMS)
def test_a_gantry_with_errors_for_lengths_finds_what_made_a_pose(kinds, twists, zeros, size):
    arm = erring(kinds, twists, zeros, size, seed=3)
    for far in (1.0, 30.0):
        q, T = posed(arm, far, 4)
        many = arm.ik_many(T, threads=1)
        assert max(missed(arm, a, many.q[i][many.valid[i]]) for i, a in enumerate(q)) < 1e-9
        one = arm.ik(T[0])
        assert one.status == many.status[0]
        assert np.array_equal(one.all_q, many.q[0][many.valid[0]])
        assert arm.chain.length < 1e-2
        assert np.abs(slow_forward.fk(arm.chain, one.all_q) - T[0]).max() < 1e-12 * far


@pytest.mark.parametrize("size", [1e-9, 3e-7])
@pytest.mark.parametrize(("kinds", "twists", "zeros"), ARMS[:4])
def test_and_is_certain_of_it_where_it_is_nearly_special(kinds, twists, zeros, size):
    arm = erring(kinds, twists, zeros, size, seed=3)
    assert (arm.ik_many(posed(arm, 1.0, 8)[1], threads=1).status == Status.SOLVED).all()


def test_near_poses_of_the_same_arm_are_solved_by_its_own_lengths():
    arm = erring(*ARMS[1], size=1e-6, seed=3)
    q, T = posed(arm, 1e-6, 8)
    many = arm.ik_many(T, threads=1)
    assert (many.status == Status.SOLVED).all() and not arm.plan.seen_from
    assert max(missed(arm, a, many.q[i][many.valid[i]]) for i, a in enumerate(q)) < 1e-6


@pytest.mark.parametrize("kinds", ["RRRRRP", "RRRRPP", "PRRRRP", "RPRRPR", "RRPRPP"])
def test_what_joints_do_alike_from_afar_raises_nothing(kinds):
    arm = erring(kinds, [H, -H, H, H, -H, 0], [0, H, 0, 0, H, 0], 2e-5, seed=4)
    for far in (1.0, 1e4):
        T = posed(arm, far, 3)[1]
        many = arm.ik_many(T, threads=1)
        assert [arm.ik(pose).status for pose in T] == many.status.tolist()
