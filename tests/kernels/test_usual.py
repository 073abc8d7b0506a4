"""What is taken as it is, without words or a copy, is what the checked road takes too and would not have changed."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from pieper import InputError, PieperWarning, _kernel
from pieper.kinematics import forward, pose
from pieper.tolerances import FARTHEST, ROTATION_EXACT

BELOW = forward.DEGREES_LIKELY


@pytest.mark.parametrize("shape", [(6,), (1, 6), (3, 6), (2, 5, 6), (0, 6)])
@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf, BELOW, -BELOW, 1e300])
def test_one_number_that_wants_words_is_seen_wherever_it_stands(shape, value):
    q = np.random.default_rng(3).uniform(-BELOW, BELOW, shape)
    assert _kernel.usual_joints(q, 6, BELOW)
    for index in np.ndindex(shape):
        bad = q.copy()
        bad[index] = value
        assert not _kernel.usual_joints(bad, 6, BELOW)


@pytest.mark.parametrize(
    "q",
    [
        np.zeros(5),
        np.zeros((6, 1)),
        np.zeros(()),
        np.zeros(6, np.float32),
        np.zeros(6, int),
        np.zeros(6, ">f8"),
        np.zeros(12)[::2],
        np.zeros((6, 3)).T,
        [0.0] * 6,
        "zero",
        None,
    ],
    ids=lambda q: f"{type(q).__name__} of {getattr(q, 'dtype', 'no dtype')} {np.shape(q)}",
)
def test_what_is_no_plain_array_of_joint_vectors_goes_the_checked_road(q):
    assert not _kernel.usual_joints(q, 6, BELOW)


def test_a_joint_vector_is_taken_alike_by_either_road():
    arm = pieper.load("denso-vp6242")
    q = np.random.default_rng(4).uniform(-3, 3, (5, 6))
    for given in (q.tolist(), np.asfortranarray(q), q.astype(object)):
        assert np.array_equal(arm.fk(given), arm.fk(q))
    assert np.array_equal(arm.fk(q[:, ::-1]), arm.fk(q[:, ::-1].copy()))
    with pytest.warns(PieperWarning, match="looks like degrees"):
        arm.fk(np.array([90.0, 0, 0, 0, 0, 0]))
    with pytest.raises(InputError, match=r"got nan at index \(1, 2\)"):
        arm.fk(np.where(np.arange(12).reshape(2, 6) == 8, np.nan, 0.0))


def test_of_many_joint_vectors_too_each_number_counts():
    arm = pieper.load("denso-vp6242")
    q = np.random.default_rng(6).uniform(-3, 3, (500, 6))
    one_by_one = np.array([arm.fk(row) for row in q])
    np.testing.assert_allclose(arm.fk(q), one_by_one, atol=1e-14)
    for value, kind in ((np.nan, InputError), (-np.inf, InputError), (90.0, PieperWarning), (-90.0, PieperWarning)):
        bad = q.copy()
        bad[357, 4] = value
        with pytest.raises(InputError, match="index") if kind is InputError else pytest.warns(kind, match="degrees"):
            arm.fk(bad)


def _said(T, batch):
    try:
        return pose.checked_pose(T, batch=batch)
    except InputError as error:
        return str(error)


def _spoilt(rng):
    """Yield poses (k, 4, 4), one of them departed from by something of any size at one of its numbers."""
    for size in (
        *10.0 ** np.arange(-17, 3),
        ROTATION_EXACT,
        ROTATION_EXACT / 2,
        FARTHEST,
        2 * FARTHEST,
        np.nan,
        np.inf,
    ):
        for i, j in np.ndindex(4, 4):
            T = np.tile(np.eye(4), (3, 1, 1))
            T[:, :3, :3] = np.linalg.qr(rng.normal(size=(3, 3, 3)))[0]
            T[:, :3, 0] *= np.linalg.det(T[:, :3, :3])[:, None]
            T[:, :3, 3] = rng.normal(size=(3, 3))
            T[rng.integers(3), i, j] += size * rng.choice([-1, 1])
            yield T
    T[:, :3, 0] *= -1
    yield T


def test_a_pose_that_is_taken_as_it_is_would_have_been_taken_so(monkeypatch):
    known = list(_spoilt(np.random.default_rng(5)))
    taken = [pose.is_exact(T) for T in known]
    quick = [_said(T, True) for T in known] + [_said(T[1], False) for T in known]
    monkeypatch.setattr(pose, "is_exact", lambda T: False)
    slow = [_said(T, True) for T in known] + [_said(T[1], False) for T in known]
    assert 20 < sum(taken) < len(taken) - 200
    for one, other in zip(quick, slow, strict=True):
        assert one == other if isinstance(other, str) else np.array_equal(one, other)


def test_the_pose_handed_back_is_a_new_one():
    T = np.eye(4)
    assert pose.is_exact(T) and pose.checked_pose(T) is not T
    assert not pose.is_exact(T.tolist()) and not pose.is_exact(T[:3]) and not pose.is_exact(T.astype(np.float32))


@pytest.mark.parametrize("count", [1, 63, 64, 65, 200])
def test_every_pose_of_many_is_looked_at(count):
    T = np.tile(np.eye(4), (count, 1, 1))
    assert pose.is_exact(T)
    for k in {0, count // 2, count - 1}:
        bad = T.copy()
        bad[k, 0, 0] += 1e-6
        assert not pose.is_exact(bad)
