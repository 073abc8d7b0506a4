"""What a kernel says of a pose without solutions: whether poses beside it may have some."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from pieper import Status
from pieper.solver.rows import Flag
from pieper.solver.singular.overlooked import overlooked
from tests.kernels.test_solver import PI

ARMS = ["denso-vp6242", "puma-560", "fanuc-r2000ic-165f", "ur5e", "stanford", "motoman-ea1400n", "fanuc-crx-10ia"]


def random_six(seed=5):
    rng = np.random.default_rng(seed)
    rows = rng.uniform([0.05, -1.5, 0.05], [0.4, 1.5, 0.4], (6, 3))
    table = [pieper.DH(a=a, alpha=alpha, d=d, theta=0.0) for a, alpha, d in rows]
    return pieper.Arm.from_dh(table, convention="standard")


def arm_of(name):
    return random_six() if name == "random" else pieper.load(name)


def at_the_edge(arm, count, rng):
    """Poses that just have solutions, and the way along which these are lost (count, 3), per metre of it."""
    plan = arm.plan
    q = rng.uniform(-PI, PI, (count, 6)) * np.where(plan.chain.prismatic, plan.chain.length / PI, 1)
    T = arm.fk(q)
    way = rng.normal(size=(count, 3))
    way /= np.linalg.norm(way, axis=1)[:, None]
    inside, outside = np.zeros(count), np.full(count, 3 * plan.chain.length)
    for _ in range(60):
        middle = (inside + outside) / 2
        some = plan.solver.many(moved(T, way, middle), 1)[1].any(1)
        inside, outside = np.where(some, middle, inside), np.where(some, outside, middle)
    return moved(T, way, inside), way


def moved(T, way, by):
    T = T.copy()
    T[:, :3, 3] += way * np.asarray(by)[..., None]
    return np.ascontiguousarray(T)


@pytest.mark.parametrize("name", [*ARMS, "random"])
def test_what_is_said_to_be_clearly_out_of_reach_has_no_neighbour_with_solutions(name):
    arm, rng = arm_of(name), np.random.default_rng(3)
    plan = arm.plan
    edge, way = at_the_edge(arm, 60, rng)
    said, silent = 0, 0
    for size in (1e-12, 1e-10, 1e-9, 3e-9, 1e-8, 1e-6, 1e-4):
        T = moved(edge, way, np.full(len(edge), size * plan.chain.length))
        rows = [plan.solver.one(pose) for pose in T]
        none = np.array([not len(row[0]) for row in rows])
        flags = np.array([row[3] for row in rows])
        told = (flags & (Flag.EDGE | Flag.DEGENERATE | Flag.UNCERTAIN)) > 0
        near = overlooked(plan, T)
        assert told[none & near].all(), (name, size)
        said, silent = said + int((none & told).sum()), silent + int((none & ~told).sum())
    assert said and silent  # both were met


@pytest.mark.parametrize("name", ["denso-vp6242", "ur5e", "motoman-ea1400n", "random"])
def test_far_out_of_reach_most_poses_are_clearly_so(name):
    arm, rng = arm_of(name), np.random.default_rng(4)
    T = arm.fk(rng.uniform(-PI, PI, (300, 6)))
    T[:, :3, 3] *= 4
    rows = [arm.plan.solver.one(np.ascontiguousarray(pose)) for pose in T]
    told = [bool(row[3] & Flag.EDGE) for row in rows if not len(row[0])]
    assert len(told) > 250 and np.mean(told) < 0.2


@pytest.mark.parametrize("name", ["puma-560", "staubli-tx2-60", "stanford", "ur5e", "ur10e"])
def test_poses_inside_the_cylinder_about_axis_1_that_an_offset_closes_are_not_looked_at_again(name):
    """Nothing is singular there, and nothing beside: each was searched for a tenth of a second."""
    arm, rng = arm_of(name), np.random.default_rng(7)
    T = arm.fk(rng.uniform(-PI, PI, (4000, 6)) * np.where(arm.plan.chain.prismatic, arm.plan.chain.length / PI, 1))
    # the tool is drawn in until its wrist stands near axis 1, where most of these arms have a hole
    T[:, :2, 3] *= rng.uniform(0, 0.1, (len(T), 1))
    _, valid, _, flags = arm.plan.solver.many(np.ascontiguousarray(T), 1)
    none = ~valid.any(1)
    assert none.sum() > 100
    marked = (flags[none] & (Flag.DEGENERATE | Flag.UNCERTAIN)) > 0
    assert marked.mean() < 0.01, f"{marked.sum()} of {none.sum()}"


def test_the_word_is_the_kernels_alone():
    arm = arm_of("puma-560")
    edge, way = at_the_edge(arm, 40, np.random.default_rng(6))
    T = moved(edge, way, np.full(len(edge), 2e-9))
    many = arm.ik_many(T)
    assert not (many.flag & Flag.EDGE).any()
    for pose, flag, status in zip(T, many.flag, many.status, strict=True):
        alone = arm.ik(pose)
        assert alone.flag == flag and alone.status == Status(status)


def test_what_is_farther_than_the_links_laid_end_to_end_is_out_of_reach_at_once():
    arm, rng = random_six(), np.random.default_rng(9)
    T = arm.fk(rng.uniform(-PI, PI, (50, 6)))
    far = T.copy()
    far[:, :3, 3] *= 20
    mixed = np.ascontiguousarray(np.stack([T, far], 1).reshape(-1, 4, 4))  # some of either in every group of lanes
    q, valid, _, flags = arm.plan.solver.many(mixed, 1)
    assert (flags[1::2] == Flag.OUT_OF_REACH).all() and not valid[1::2].any()
    alone = arm.plan.solver.many(np.ascontiguousarray(T), 1)
    assert np.array_equal(valid[::2], alone[1]) and np.abs(q[::2] - alone[0]).max() < 1e-9
    straight = arm.plan.farthest  # the bound is no smaller than what the arm reaches
    assert np.linalg.norm(arm.fk(rng.uniform(-PI, PI, (20000, 6)))[:, :3, 3], axis=1).max() < straight


@pytest.mark.parametrize("name", ["rob0036", "xarm5"])
def test_a_typed_pose_far_from_where_postures_merge_is_not_looked_at_with_care(name):
    arm, rng = pieper.load(name), np.random.default_rng(3)
    q = rng.uniform(-1.5, 1.5, (300, arm.n))
    T = np.round(arm.fk(q), 6)
    s = np.linalg.svd(arm.jacobian(q), compute_uv=False)
    strength = s[:, -1] / s[:, 0]
    far = strength > np.median(strength)
    batch = arm.ik_many(T)
    out = batch.status == Status.OUT_OF_REACH
    assert out.mean() > 0.9  # it misses by some 1e-6, and five joints cannot make up for that
    assert overlooked(arm.plan, T[far & out]).mean() < 0.02 and overlooked(arm.plan, T[out]).mean() < 0.1
