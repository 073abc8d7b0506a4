"""A turn of the first joint answers for voxels that it takes to each other: the same bits, counts and measures."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from pieper.maps.grid import fold_of, grid_of, orientations_of
from pieper.maps.images import first_joint_turns, images_of

ARMS = ("denso-vp6242", "universal-robots-ur5e", "fanuc-crx-10ia", "stanford-arm", "unimation-puma-560", "abb-irb140")
EVEN = ((-0.6, 0.6), (-0.6, 0.6), (-0.2, 0.8))
#: Boxes whose voxels are images of each other: about the axis, beside it, and one of their corners on it.
BOXES = (EVEN, ((-0.75, 0.45), (-0.45, 0.45), (0.0, 0.6)), ((0.0, 0.6), (-0.3, 0.9), (0.1, 0.4)))


def both(arm, box, orientations, step=0.3, **more):
    return (arm.reach_map(box, step, orientations, symmetry=s, **more) for s in ("auto", "none"))


@pytest.mark.parametrize("name", ARMS)
@pytest.mark.parametrize("count", [4, 6, 5])
def test_first_joint_changes_no_bit_and_no_count(name, count):
    arm, first = pieper.load(name), pieper.load(name).joint_names[0]
    turned = pieper.pose(0.3, -0.15, 0.1, rpy=(0.0, 0.0, 0.4))
    over = pieper.pose(-0.15, 0.3, 0.5, rpy=(np.pi, 0.0, 0.7))
    for other in (
        arm,
        arm.with_base(turned),
        arm.with_base(over),
        arm.with_limits({first: (-0.5, 1.0)}),
        arm.with_limits({first: (-9.0, -4.0)}),
        arm.with_limits({first: (2.0, 2.0), arm.joint_names[-1]: (-0.4, 3.0)}),
    ):
        for box in BOXES:
            a, b = both(other, box, (count, 3))
            assert np.array_equal(a.bits, b.bits) and np.array_equal(a.count, b.count)
    told = arm.reach_map(EVEN, 0.3, (count, 3)).symmetry
    assert ("first joint" in told) == (fold_of(count) > 1)


@pytest.mark.parametrize("name", ["denso-vp6242", "universal-robots-ur5e", "stanford-arm"])
def test_first_joint_changes_no_measure(name):
    arm = pieper.load(name)
    for other in (arm, arm.with_limits({arm.joint_names[0]: (-0.5, 1.0), arm.joint_names[-1]: (-1.0, 1.5)})):
        a, b = both(other, EVEN, (8, 3), measure=True)
        assert a.measures == pytest.approx(b.measures, rel=1e-6, abs=1e-7)
        assert a.aspects.sum(-1) == pytest.approx(a.count, abs=0)


@pytest.mark.parametrize(("box", "count"), [(EVEN, 4), (EVEN, 6), (BOXES[1], 4), (BOXES[1], 6), (BOXES[2], 4)])
def test_each_voxel_is_told_once_and_images_are_turned(box, count):
    chain = pieper.load("denso-vp6242").chain
    grid = grid_of(box, 0.15, (count, 2), "pose", 1.0)
    images = images_of(grid, chain)
    told = images.of(0, images.count)
    assert images.fold == fold_of(count) and sorted(told[told >= 0]) == list(range(grid.count))
    turns = grid.turns
    for k in range(images.fold):
        there = told[:, k] >= 0
        R = pieper.pose(0, 0, 0, rpy=(0, 0, 2 * np.pi * k / images.fold))[:3, :3]
        assert grid.centres(told[there, k]) == pytest.approx(grid.centres(told[there, 0]) @ R.T, abs=1e-12)
        other = (np.arange(len(turns)) + k * len(turns) // images.fold) % len(turns)
        assert R @ turns == pytest.approx(turns[other], abs=1e-12)


def test_what_answers_for_what_is_said():
    arm = pieper.load("denso-vp6242")
    assert "first joint" in arm.reach_map(EVEN, 0.3, (4, 2)).explain()
    assert "first joint" not in arm.reach_map(((-0.61, 0.6), (-0.6, 0.6), (0, 0.6)), 0.3, (4, 2)).symmetry
    assert arm.reach_map(EVEN, 0.3, (4, 2), symmetry="none").symmetry == "every pose was solved"
    assert first_joint_turns(arm.with_base(pieper.pose(0, 0, 0, rpy=(0.5, 0, 0))).chain) == 0.0
    assert first_joint_turns(arm.chain) == 1.0
    # a scene stands still while the arm turns
    assert "first joint" not in arm.reach_map(EVEN, 0.6, (4, 2), scene=pieper.Scene()).symmetry


def test_directions_are_even_and_turn_into_each_other():
    for count in (64, 62, 63, 4, 2, 1):
        z = orientations_of(count, 2)[::2, :, 2]
        assert z.shape == (count, 3) and abs(np.linalg.norm(z, axis=1) - 1).max() < 1e-12
        if count > 60:
            assert np.linalg.norm(z.mean(0)) < 0.02
            gap = np.sort(np.linalg.norm(z[:, None] - z[None], axis=2), axis=1)[:, 1]
            assert gap.min() > 0.55 * np.sqrt(4 * np.pi / count)


def test_aspects_tell_the_side_of_each_posture_and_its_nearness_to_a_singular_one():
    arm = pieper.load("universal-robots-ur5e")
    q = np.random.default_rng(5).uniform(-3, 3, (40, 6))
    found = arm.aspects(q.reshape(5, 8, 6))
    J = arm.jacobian(q)
    assert np.array_equal(found.sign.ravel(), np.sign(np.linalg.det(J)))
    J[:, :3] /= arm.chain.length
    assert found.smallest.ravel() == pytest.approx(np.linalg.svd(J)[1][:, -1], abs=1e-12)
    assert arm.aspects(np.zeros(6)).smallest < 1e-12
    m = arm.reach_map(((0.2, 0.5), (0.1, 0.4), (0.2, 0.5)), 0.3, (6, 4), measure=True)
    rows = arm.ik_many(m.grid.poses(np.arange(1), m.grid.turns))
    here = arm.aspects(rows.q[rows.in_limits])
    assert m.aspects.ravel().tolist() == [(here.sign < 0).sum(), (here.sign > 0).sum()]
    assert m.least_singular.item() == pytest.approx(here.smallest.min(), rel=1e-6)
    assert m.most_singular.item() == pytest.approx(here.smallest.max(), rel=1e-6)
