"""The frame, the tool, or both, that bring an arm's poses nearest to measured ones; closed forms."""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.kinematics.pose import inverse, rotation_vector


def rotation_near(M: Array) -> Array:
    """Return the rotation (3, 3) nearest to a matrix: R that makes trace(R^T M) largest (Kabsch, 1976)."""
    U, _, V = np.linalg.svd(M)
    return U @ np.diag([1, 1, np.sign(np.linalg.det(U @ V))]) @ V


def tool_between(T: Array, measured: Array) -> Array:
    """Return the motion (4, 4) that, put after poses T (N, 4, 4), comes nearest to measured ones (N, 4, 4)."""
    there = inverse(T) @ measured
    return _motion(rotation_near(there[:, :3, :3].sum(0)), np.median(there[:, :3, 3], axis=0))


def frame_between(a: Array, b: Array, mirrored: bool = False) -> Array:
    """Return the motion (4, 4) that takes points a (N, 3) nearest to b; a mirror as well where asked."""
    A, B = a - a.mean(0), b - b.mean(0)
    U, _, V = np.linalg.svd(B.T @ A)
    sense = np.sign(np.linalg.det(U @ V)) * (-1 if mirrored else 1)
    R = U @ np.diag([1, 1, sense]) @ V
    return _motion(R, b.mean(0) - R @ a.mean(0))


def frame_and_tool(T: Array, measured: Array) -> tuple[Array, Array]:
    """Return X and Y (4, 4) so that X T Y comes nearest to measured poses (N, 4, 4), or to positions (N, 3).

    Of poses the turns between them show the frame's (Park and Martin, 1994: a turn seen from another frame is turned
    about the turned axis), then the tool's; places are linear in what is left. Of positions all is linear but that the
    frame's turn is one, and the tool is the point alone.
    """
    R, p = T[:, :3, :3], T[:, :3, 3]
    if measured.ndim == 2:
        # X^-1 measured = p + R y, with X^-1 = (A, c): A m + c - R y = p
        m = measured
        rows = np.concatenate(
            [np.einsum("ij,nk->nijk", np.eye(3), m).reshape(-1, 9), np.tile(np.eye(3), (len(m), 1)), -R.reshape(-1, 3)],
            axis=1,
        )
        A = np.asarray(np.linalg.lstsq(rows, p.ravel(), rcond=None)[0], np.float64)
        RX, RY = rotation_near(A[:9].reshape(3, 3)).T, np.eye(3)
        place = m
    else:
        M = measured[:, :3, :3]
        apart = np.roll(np.arange(len(T)), 1)
        seen, own = (rotation_vector(Q @ np.swapaxes(Q[apart], 1, 2)) for Q in (M, R))
        RX = rotation_near(seen.T @ own)
        RY = rotation_near(np.einsum("nji,jk,nkl->il", R, RX.T, M))
        place = measured[:, :3, 3]
    # R_X^T place = p + R y + R_X^T x
    rows = np.concatenate([R.reshape(-1, 3), np.tile(np.eye(3), (len(T), 1))], axis=1)
    found = np.asarray(np.linalg.lstsq(rows, (place @ RX - p).ravel(), rcond=None)[0], np.float64)
    return _motion(RX, RX @ found[3:]), _motion(RY, found[:3])


def _motion(R: Array, p: Array) -> Array:
    X = np.eye(4)
    X[:3, :3], X[:3, 3] = R, p
    return X
