"""Laws of redundant arms: self-motions are met however small; limits, turns and nearest agree with a slow oracle."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from oracle.joints import around, flips
from pieper import DH, Arm, Status
from pieper.kinematics.newton import scaled_jacobian
from pieper.kinematics.pose import rotation_about
from pieper.solver.singular.trace import trace

POSTURE = np.array([0.4, -0.7, 0.5, 1.1, -0.6, 0.9, 0.3])


def turned(a, b):
    """Return angles a - b around the circle."""
    return around(np.asarray(a) - b)


def random_seven(rng) -> Arm:
    """Return seven revolute joints of no special kind."""
    rows = [DH(rng.uniform(-0.5, 0.5), rng.uniform(-3, 3), rng.uniform(-0.5, 0.5), 0.0) for _ in range(7)]
    return Arm.from_dh(rows, convention="standard", name="random seven")


def turning_point(chain, rng):
    """Return a posture where all seven joints together lose one direction, that direction, and how the pose bends.

    There the distance of the tool along that direction has a maximum or a minimum (the two bends have one sign): a
    pose a little inside has a closed self-motion around the posture, and a pose a little outside has none there.
    """
    for _ in range(200):
        q = rng.uniform(-3, 3, chain.n)
        u = np.linalg.svd(scaled_jacobian(chain, q))[0][:, -1]
        for _ in range(40):
            J = scaled_jacobian(chain, q)
            r = np.append(J.T @ u, u @ u - 1)
            if np.linalg.norm(r) < 1e-13:
                break
            A = np.zeros((chain.n + 1, chain.n + 6))
            for j, d in enumerate(1e-6 * np.eye(chain.n)):
                A[:-1, j] = (scaled_jacobian(chain, q + d) - scaled_jacobian(chain, q - d)).T @ u / 2e-6
            A[:-1, chain.n :], A[-1, chain.n :] = J.T, 2 * u
            step = -np.linalg.pinv(A, rcond=1e-6) @ r
            step *= min(1.0, 0.3 / np.linalg.norm(step))
            q, u = q + step[: chain.n], u + step[chain.n :]
        if np.linalg.norm(r) > 1e-10:
            continue
        null = np.linalg.svd(scaled_jacobian(chain, q))[2][5:]
        H = np.array(
            [u @ (scaled_jacobian(chain, q + d) - scaled_jacobian(chain, q - d)) / 2e-4 for d in 1e-4 * np.eye(chain.n)]
        )
        bends = np.linalg.eigvalsh(null @ (H + H.T) @ null.T / 2)
        if bends[0] * bends[1] > 1e-4 and np.abs(bends).max() < 100 * np.abs(bends).min():
            return q, u, np.sign(bends[0])
    raise AssertionError("no turning point was found")


def small_self_motion(arm, rng, depth):
    """Return a pose with a self-motion so small that its joints hardly move, and a point of it."""
    chain = arm.chain
    q, u, side = turning_point(chain, rng)
    twist = side * depth * u
    T = arm.fk(q)
    angle = np.linalg.norm(twist[3:])
    T[:3, :3] = rotation_about(twist[3:] / angle, angle) @ T[:3, :3]
    T[:3, 3] += twist[:3] * chain.length
    for start in q + rng.normal(0, 0.02, (200, chain.n)):
        x = start
        for _ in range(40):
            now = arm.fk(x)
            R = T[:3, :3] @ now[:3, :3].T
            turn = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) / 2
            e = np.concatenate([(T[:3, 3] - now[:3, 3]) / chain.length, turn])
            if np.linalg.norm(e) < 1e-14:
                break
            step = np.linalg.pinv(scaled_jacobian(chain, x), rcond=1e-4) @ e
            x = x + step * min(1.0, 0.1 / max(np.linalg.norm(step), 1e-300))
        if np.linalg.norm(e) < 1e-12 and np.abs(x - q).max() < 0.3:
            return T, x
    raise AssertionError("the self-motion that must be there was not met")


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("name", ["random", "franka-panda", "rethink-sawyer"])
def test_a_self_motion_that_lies_between_two_slices_is_found(name, seed):
    rng = np.random.default_rng(seed)
    arm = random_seven(rng) if name == "random" else pieper.load(name)
    T, q = small_self_motion(arm, rng, (1e-3, 1e-4, 1e-5, 1e-6)[seed])
    motion = trace(arm.chain, q, T, arm.limits, arm.joint_names)
    held = motion.samples[:, arm.plan.reduction.locked[0]]
    assert motion.closed
    if seed >= 2:
        assert np.ptp(held) < 2 * np.pi / 20, "this self-motion is not small"
    found = arm.ik(T).self_motions
    assert any(f.contains(q, 1e-4) for f in found)


def on_the_slice(arm, T, joint, value, starts, rng):
    """Return the distinct solutions with one joint held that Newton's method finds from many random starts."""
    found = []
    free = [j for j in range(7) if j != joint]
    q = rng.uniform(-np.pi, np.pi, (starts, 7))
    q[:, joint] = value
    for _ in range(60):
        now = arm.fk(q)
        R = T[:3, :3] @ np.swapaxes(now[:, :3, :3], 1, 2)
        turn = np.stack([R[:, 2, 1] - R[:, 1, 2], R[:, 0, 2] - R[:, 2, 0], R[:, 1, 0] - R[:, 0, 1]], -1) / 2
        turn *= np.where(np.trace(R, axis1=1, axis2=2) < 1, 2.0, 1.0)[:, None]
        e = np.concatenate([T[:3, 3] - now[:, :3, 3], turn], 1)
        step = np.einsum("bij,bj->bi", np.linalg.pinv(arm.jacobian(q)[:, :, free], rcond=1e-8), e)
        step *= np.minimum(1.0, 0.5 / np.maximum(np.linalg.norm(step, axis=1, keepdims=True), 1e-300))
        q[:, free] += step
    good = np.abs(arm.fk(q) - T).max((1, 2)) < 1e-9
    for row in q[good]:
        if not any(np.abs(turned(row, other)).max() < 1e-5 for other in found):
            found.append(turned(row, 0.0))
    return np.array(found).reshape(-1, 7)


def inside(arm, q):
    """Return the whole-turn variants of q (7,) inside the limits."""
    rows = [[]]
    for value, (lower, upper) in zip(q, arm.limits, strict=True):
        turns = [value + 2 * np.pi * k for k in (-2, -1, 0, 1, 2)]
        rows = [[*row, v] for row in rows for v in turns if lower - 1e-9 <= v <= upper + 1e-9]
    return np.array(rows).reshape(-1, 7)


def wide(name) -> Arm:
    """Return a redundant arm whose limits let some joints turn more than once, and hold others short."""
    from dataclasses import replace

    d = pieper.load(name).description
    limits = np.tile([-2.9, 2.9], (7, 1))
    limits[2], limits[4], limits[6] = (-4.5, 4.5), (-0.5, 4.0), (-7.0, 5.0)
    return Arm(replace(d, limits=limits))


@pytest.mark.parametrize("name", ["franka-panda", "kuka-lbr-iiwa-14-r820"])
def test_limits_turns_and_nearest_of_a_batch_are_those_of_the_oracle(name):
    arm = wide(name)
    rng = np.random.default_rng(6)
    joint = arm.plan.reduction.locked[0]
    q = rng.uniform(-2.5, 2.5, (3, 7))
    T = arm.fk(q)
    now = rng.uniform(-3, 3, 7)
    many = arm.ik_many(T, threads=1, near=now, redundancy=q[:, joint])
    nearest, there = many.nearest, many.has_nearest
    for i in range(3):
        found = on_the_slice(arm, T[i], joint, q[i, joint], 1500, rng)
        rows = many.q[i][many.valid[i]]
        assert len(rows) == len(found)
        assert max(np.abs(turned(rows, other)).max(1).min() for other in found) < 1e-6
        variants = [v for v in (inside(arm, row) for row in found) if len(v)]
        assert many.in_limits[i].sum() == len(variants)
        one = arm.ik(T[i], redundancy=q[i, joint])
        assert len(one.windings()) == sum(len(v) for v in variants)
        assert there[i] == bool(variants)
        if variants:
            # the spare joint keeps the value that was chosen
            best = min((v for v in np.concatenate(variants)), key=lambda v: np.linalg.norm(v - now))
            assert np.linalg.norm(nearest[i] - now) < np.linalg.norm(best - now) + 1e-6
            assert np.abs(arm.fk(nearest[i]) - T[i]).max() < 1e-9


@pytest.mark.parametrize("name", ["franka-panda", "kuka-lbr-iiwa-14-r820", "ufactory-xarm7"])
def test_the_nearest_point_of_the_self_motions_is_not_beaten_on_any_slice(name):
    arm = wide(name)
    rng = np.random.default_rng(7)
    joint = arm.plan.reduction.locked[0]
    q = rng.uniform(-1.5, 1.5, 7)
    T = arm.fk(q)
    now = q + rng.normal(0, 0.5, 7)
    nearest = arm.ik(T).nearest(now)
    assert np.abs(arm.fk(nearest) - T).max() < 1e-9
    assert (nearest >= arm.limits[:, 0] - 1e-8).all() and (nearest <= arm.limits[:, 1] + 1e-8).all()
    values = np.linspace(*np.clip(arm.limits[joint], -np.pi, np.pi), 721)
    many = arm.ik_many(np.tile(T, (len(values), 1, 1)), threads=1, near=now, redundancy=values)
    rows, there = many.nearest, many.has_nearest
    assert np.linalg.norm(nearest - now) < np.linalg.norm(rows[there] - now, axis=1).min() + 1e-3


@pytest.mark.parametrize("name", ["franka-panda", "kuka-lbr-iiwa-14-r820"])
def test_what_the_limits_leave_of_the_self_motions_is_what_slices_leave(name):
    arm = wide(name)
    joint = arm.plan.reduction.locked[0]
    T = arm.fk(POSTURE)
    motions = arm.ik(T).self_motions
    for value in (-2.0, -0.6, 0.1, 0.9, 2.3):
        sols = arm.ik(T, redundancy=value)
        points = np.concatenate([f.at_joint(joint, value) for f in motions])
        for row, ok in zip(sols.all_q, sols.in_limits, strict=True):
            assert np.abs(turned(points, row)).max(1).min() < 1e-6
            motion = min(motions, key=lambda f: f.distance(row))
            near = int(np.argmin(np.abs(turned(motion.samples, row)).max(1)))
            s = motion.u[near]
            inner = any(a + 0.02 < s < b - 0.02 for a, b in motion.inside)
            outer = not any(a - 0.02 < s < b + 0.02 for a, b in motion.inside)
            assert (ok or not inner) and (not ok or not outer)


def test_the_default_value_gives_way_to_one_with_an_answer_alone_and_in_a_batch():
    arm = pieper.load("kuka-lbr-iiwa-14-r820")
    T = arm.fk(np.random.default_rng(8).uniform(arm.limits[:, 0], arm.limits[:, 1], (40, 7)))
    many = arm.ik_many(T, threads=1)
    assert (many.status == Status.REDUNDANT).all() and many.in_limits.any(1).all()
    for i in range(0, 40, 5):
        one = arm.ik(T[i])
        np.testing.assert_allclose(one.all_q, many.q[i][many.valid[i]], atol=1e-9)
        assert one.status == many.status[i]


def test_an_arm_on_a_rail_far_from_its_zero_finds_the_rail_s_values():
    rows = [DH(0, -np.pi / 2, 0, 0)]
    rows += [DH(*row, 0) for row in ((0, np.pi / 2, 0.4), (0.5, 0, 0), (0, np.pi / 2, 0), (0, -np.pi / 2, 0.4))]
    rows += [DH(0, np.pi / 2, 0, 0), DH(0, 0, 0.1, 0)]
    limits = [(8.0, 12.0)] + [(-2.9, 2.9)] * 6
    arm = Arm.from_dh(rows, convention="standard", joint_types="PRRRRRR", limits=limits)
    q = np.array([9.7, 0.3, 0.6, 1.1, 0.4, 0.9, 0.2])
    T = arm.fk(q)
    sols = arm.ik(T)
    assert sols.status == Status.REDUNDANT and len(sols)
    assert (sols.q[:, 0] >= 8.0 - 1e-9).all() and (sols.q[:, 0] <= 12.0 + 1e-9).all()
    assert any(motion.contains(q, 1e-5) for motion in sols.self_motions)


def test_a_chosen_value_without_an_answer_is_told_from_a_pose_out_of_reach():
    arm = pieper.load("franka-panda")
    q = np.array([0.1, 0.9, 0.2, -0.6, 0.1, 1.3, 0.4])
    T = arm.fk(q)
    values = np.linspace(*arm.limits[6], 40)
    many = arm.ik_many(np.tile(T, (40, 1, 1)), threads=1, redundancy=values)
    none = np.flatnonzero(~many.valid.any(1))
    assert len(none), "every value has an answer: the pose is not one to test with"
    assert (many.status[none] == Status.REDUNDANT).all()
    one = arm.ik(T, redundancy=values[none[0]])
    assert one.status == Status.REDUNDANT and len(one) == 0
    far = T.copy()
    far[:3, 3] = [3.0, 0, 0]
    assert arm.ik_many(far[None], redundancy=0.4).status[0] == Status.OUT_OF_REACH


@pytest.mark.parametrize("elbow", [3e-3, 1e-3, 1e-4])
@pytest.mark.parametrize("name", ["kuka-lbr-iiwa-14-r820", "motoman-sia10d"])
def test_an_elbow_nearly_straight_bends_either_way_on_curves_of_their_own(name, elbow):
    """Two curves 2e-4 to 6e-3 rad apart, one of each sign of the elbow, were taken for one: half were not told."""
    arm = pieper.load(name)
    arm = arm.with_limits({joint: (-3.1, 3.1) for joint in arm.joint_names})
    q = np.array([0.3, 0.4, 0.5, elbow, 0.6, 0.7, 0.8])
    sols, postures = arm.ik(arm.fk(q)), flips(q)
    assert np.abs(arm.fk(postures) - arm.fk(q)).max() < 1e-14
    on = np.array([[motion.contains(p) for motion in sols.self_motions] for p in postures])
    assert on.shape == (8, 8) and (on.sum(0) == 1).all() and (on.sum(1) == 1).all()


@pytest.mark.parametrize("elbow", [1e-3, 1e-5, 1e-7, 0.0])
def test_a_posture_that_holds_the_pose_is_nearest_to_itself(elbow):
    arm = pieper.load("kuka-lbr-iiwa-14-r820")
    arm = arm.with_limits({joint: (-3.1, 3.1) for joint in arm.joint_names})
    for p in flips([0.3, 0.4, 0.5, elbow, 0.6, 0.7, 0.8]):
        assert np.abs(arm.ik(arm.fk(p)).nearest(p) - p).max() < 1e-12


@pytest.mark.parametrize("name", ["franka-panda", "kuka-lbr-iiwa-14-r820", "kinova-gen3-7dof"])
def test_rows_at_one_value_of_what_is_to_spare_are_not_called_all_there_are(name):
    arm, rng = pieper.load(name), np.random.default_rng(4)
    low, high = np.clip(arm.limits, -2.8, 2.8).T
    T, middle = arm.fk(rng.uniform(low, high)), rng.uniform(low + 0.15, high - 0.15)
    narrow = arm.with_limits({joint: (m - 0.15, m + 0.15) for joint, m in zip(arm.joint_names, middle, strict=True)})
    sols = narrow.ik(T)
    assert sols.status.name == "OUTSIDE_LIMITS" and "at the chosen" in sols.why
