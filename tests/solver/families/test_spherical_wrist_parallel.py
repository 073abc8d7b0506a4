"""Spherical wrists behind parallel axes: every solution is found again and closes, also where it is singular."""

from __future__ import annotations

import numpy as np
import pytest

from oracle import slow_forward
from oracle.arms.wrists import ARMS, arm, solver, specification
from oracle.joints import turns_apart
from pieper.kinematics.forward import jacobian
from pieper.kinematics.pose import pose_error

PI = np.pi


def solved(chain, q):
    """Return what the kernel finds for the poses of q, and how far its answers miss them (N, 8, 2)."""
    T = slow_forward.fk(chain, q)
    found, valid, _, flag = solver(chain).many(np.ascontiguousarray(T))
    error = pose_error(slow_forward.fk(chain, found), T[:, None])
    error[~valid] = 0.0
    return found, valid, flag, error


def found_again(chain, q, found, valid):
    """Return which rows of q are among the solutions, as closely as their conditioning lets a rounded pose tell."""
    J = jacobian(chain, q)
    J[:, :3] /= specification(chain).geometry.scale
    smallest = np.linalg.svd(J, compute_uv=False)[:, -1]
    distance = np.where(valid, turns_apart(found, q[:, None]).max(2), np.inf).min(1)
    return distance <= 1e-6 + 1e-14 / np.maximum(smallest, 1e-30)


@pytest.mark.parametrize("name", ARMS)
def test_a_joint_vector_is_found_again_from_its_pose_and_every_solution_closes(name):
    chain = ARMS[name]
    q = np.random.default_rng(3).uniform(-PI, PI, (5000, 6))
    found, valid, _, error = solved(chain, q)
    assert found_again(chain, q, found, valid).all()
    size = specification(chain).geometry.scale
    assert error[..., 0].max() < 1e-12 * size
    assert error[..., 1].max() < 1e-12
    assert (valid.sum(1) % 2 == 0).all()
    assert ((found > -PI) & (found <= PI)).all()


def strata(chain):
    """Yield names and functions that move joint vectors onto a singularity, at a distance d."""
    p = specification(chain).geometry
    a1, L2, L3, offset2, offset3, offset5, sign3 = p.a1, p.upper, p.fore, p.offset2, p.offset3, p.offset5, p.sign3

    def wrist(q, d, bent):
        q[:, 4] = bent + d - offset5

    def elbow(q, d, bent):
        q[:, 2] = sign3 * (bent + d - offset3)

    def shoulder(q, d, _):
        th3 = sign3 * q[:, 2] + offset3
        along, across = L2 + L3 * np.cos(th3), L3 * np.sin(th3)
        ratio = -a1 / np.hypot(along, across)
        q[:, 1] = np.arccos(np.clip(ratio, -1, 1)) - np.arctan2(across, along) - offset2 + d
        q[np.abs(ratio) > 1, 1] = 0.5

    yield "wrist straight", wrist, 0.0
    yield "wrist folded", wrist, PI
    yield "elbow stretched", elbow, 0.0
    yield "elbow folded", elbow, PI
    yield "wrist centre over the first axis", shoulder, 0.0


def moved_onto(chain, rng, apart):
    """Yield names and random joint vectors (k, 6) at distances (k,) from a singularity."""
    for stratum, move, bent in strata(chain):
        q = rng.uniform(-PI, PI, (len(apart), 6))
        move(q, apart, bent)
        yield stratum, (q + PI) % (2 * PI) - PI


@pytest.mark.parametrize("name", ARMS)
def test_near_a_singularity_solutions_are_found_again_at_every_distance(name):
    chain = ARMS[name]
    rng = np.random.default_rng(4)
    for stratum, q in moved_onto(chain, rng, 10 ** rng.uniform(-10, -2, 2000) * rng.choice([-1, 1], 2000)):
        found, valid, _, error = solved(chain, q)
        assert found_again(chain, q, found, valid).mean() >= 0.9999, stratum
        assert error[..., 1].max() < 1e-12, stratum


@pytest.mark.parametrize("name", ARMS)
def test_on_a_singularity_there_is_an_answer_and_a_flag(name):
    chain = ARMS[name]
    rng = np.random.default_rng(5)
    for stratum, q in moved_onto(chain, rng, np.zeros(600)):
        on = np.ones(len(q), bool) if "first axis" not in stratum else turns_apart(q[:, 1], 0.5) > 1e-9
        _, valid, flag, error = solved(chain, q)
        assert valid.any(1).all(), stratum
        assert (flag[on] & 1).mean() >= 0.999, stratum
        assert error[..., 1].max() < 1e-12, stratum


def test_a_slot_keeps_its_meaning():
    chain = ARMS["no offsets"]
    p = specification(chain).geometry
    q = np.random.default_rng(6).uniform(-PI, PI, (3000, 6))
    found, valid, _, _ = solved(chain, q)
    th3, th5 = p.sign3 * found[..., 2] + p.offset3, found[..., 4] + p.offset5
    for slot in range(8):
        side, elbow, wrist = slot >> 2, slot >> 1 & 1, slot & 1
        ok = valid[:, slot]
        assert ok.any()
        assert (np.sign(np.sin(th3[ok, slot])) == (-1 if side == elbow else 1)).all()
        assert (np.sign(np.sin(th5[ok, slot])) == (1 if wrist == 0 else -1)).all()
    # the first four slots and the last four look at the wrist centre from opposite sides of the first axis
    assert np.allclose(turns_apart(found[:, 0, 0], found[:, 4, 0])[valid[:, 0] & valid[:, 4]], PI)


def test_beyond_reach_nothing_is_valid_and_the_flag_says_so():
    chain = ARMS["no offsets"]
    T = np.eye(4)
    T[:3, 3] = 2.0, 0.1, 0.3
    q, valid, in_limits, flag = solver(chain).many(T[None])
    assert not valid.any() and not in_limits.any() and not q.any()
    assert flag[0] == 4


def test_a_stretched_arm_is_one_root_a_hair_beyond_is_still_the_edge_and_a_micrometre_beyond_is_not():
    chain = ARMS["no offsets"]
    p = specification(chain).geometry
    q = np.array([0.3, 0.4, (0.0 - p.offset3) / p.sign3, 0.5, 0.6, 0.7])
    T = slow_forward.fk(chain, q)
    forearm = T[:3, 3] - 0.07 * T[:3, 2] - np.array([0, 0, 0.125])
    outward = forearm / np.linalg.norm(forearm)
    counts = []
    for beyond in (0.0, 1e-14, 1e-6):
        moved = T.copy()
        moved[:3, 3] += beyond * outward
        rows, slots, _, flag = solver(chain).one(moved)
        counts.append((len(rows), bool(flag & 1), bool(flag & 4)))
        assert set(slots) <= {0, 1, 4, 5}
    assert counts == [(4, True, False), (4, True, False), (0, False, True)]


def test_random_members_of_the_family_have_all_their_solutions():
    rng = np.random.default_rng(8)

    for _ in range(25):
        twist = rng.choice([-PI / 2, PI / 2], 4)
        chain = arm(
            (rng.choice([0, 0.2]) * rng.normal(), rng.uniform(-1, 1), rng.choice([0, 0.2]) * rng.normal(), 0, 0, 0),
            (twist[0], rng.choice([0.0, PI]), twist[1], twist[2], twist[3], 0.0),
            (
                rng.normal(),
                rng.choice([0, 0.2]) * rng.normal(),
                rng.choice([0, 0.2]) * rng.normal(),
                rng.uniform(-1, 1),
                0,
                rng.normal(),
            ),
            theta=rng.uniform(-PI, PI, 6),
            sign=rng.choice([-1, 1], 6),
        )
        q = rng.uniform(-PI, PI, (200, 6))
        found, valid, _, error = solved(chain, q)
        assert found_again(chain, q, found, valid).all()
        assert error.max() < 1e-11
