"""A smooth curve through taught poses: cubic splines of the position and of the quaternion, over the way's length."""

from __future__ import annotations

import numpy as np

from pieper.errors import InputError
from pieper.kinematics.arrays import Array
from pieper.kinematics.orientation import quaternion_of
from pieper.kinematics.pose import pose_error
from pieper.kinematics.spoken_many import poses
from pieper.motion.curve import JointCurve
from pieper.tolerances import ONE_POSE

#: A turn of one radian counts as this much way, m, in how the curve's parameter is shared out between the poses.
METRES_A_RADIAN = 0.1


def spline(T0: Array, through: Array, s: Array) -> Array:
    """Return the poses (m, 4, 4) at s (m,) of the curve from T0 (4, 4) through poses (k, 4, 4).

    Raises:
        InputError: Fewer than two poses, or two in a row that are one.
    """
    if len(through) < 2:
        raise InputError("a spline goes through at least 2 poses; use move_l for one.", given=len(through))
    T = np.concatenate([T0[None], through])
    off = pose_error(T[1:], T[:-1])
    if (off < ONE_POSE).all(1).any():
        k = int(np.argmax((off < ONE_POSE).all(1)))
        first = "the pose the arm is in" if k == 0 else f"pose {k}"
        raise InputError(f"{first} and pose {k + 1} of the spline are one; leave one out.", pose=k + 1)
    way = np.concatenate([[0.0], np.cumsum(np.hypot(off[:, 0], METRES_A_RADIAN * off[:, 1]))])
    way /= way[-1]
    turned = np.array([quaternion_of(R) for R in T[:, :3, :3]])
    # of the two quaternions of a rotation the one on the side of the pose before
    for k in range(1, len(turned)):
        if turned[k] @ turned[k - 1] < 0:
            turned[k] = -turned[k]
    at = JointCurve.through(way, np.hstack([T[:, :3, 3], turned])).at(s)[0]
    out = poses(at[..., :3], "quat_wxyz", at[..., 3:] / np.linalg.norm(at[..., 3:], axis=-1, keepdims=True))
    out[s == 0.0] = T0
    out[s == 1.0] = through[-1]
    return out
