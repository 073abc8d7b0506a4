"""Many poses at once are the poses that are said one by one."""

from __future__ import annotations

import numpy as np
import pytest

import pieper

QUARTERS = np.array([0.0, np.pi / 2, -np.pi / 2, np.pi])


@pytest.mark.parametrize("notation", ["rpy", "wpr", "abc", "zyz", "rotvec", "staubli", "yaskawa", "quat_wxyz", "abb"])
def test_many_poses_are_those_said_one_by_one(notation):
    rng = np.random.default_rng(2)
    p = rng.normal(size=(20, 3))
    v = rng.normal(size=(20, 4 if notation in ("quat_wxyz", "abb") else 3))
    if v.shape[1] == 4:
        v /= np.linalg.norm(v, axis=1, keepdims=True)
    else:
        v[:5] = rng.choice(QUARTERS, (5, 3))
    single = [pieper.pose(*x, **{notation: row}) for x, row in zip(p, v, strict=True)]
    assert np.allclose(pieper.poses(p, notation, v), single, atol=1e-15)


def test_an_impossible_orientation_is_refused():
    with pytest.raises(pieper.InputError, match="length 2"):
        pieper.poses(np.zeros((2, 3)), "quat_wxyz", [[1, 0, 0, 0], [2, 0, 0, 0]])
    with pytest.raises(pieper.InputError, match="got 'xyz'"):
        pieper.poses(np.zeros(3), "xyz", np.zeros(3))
