"""Forward kinematics as plain matrix products in NumPy: the slow, obvious oracle of the kernel."""

from __future__ import annotations

import numpy as np


def fk(chain, q):
    """Return the tool poses (..., 4, 4) of joint vectors q (..., n)."""
    q = axes(chain, q)
    T = np.broadcast_to(chain.links[0], (*q.shape[:-1], 4, 4))
    for i in range(chain.axis_count):
        T = T @ motion(q[..., i], chain.sliding[i]) @ chain.links[i + 1]
    return T


def frames(chain, q, base):
    """Return the frames (..., n + 2, 4, 4): base, the DH frame after each joint, tool."""
    q = axes(chain, q)
    out = np.empty((*q.shape[:-1], chain.axis_count + 2, 4, 4))
    out[..., 0, :, :] = base
    T = np.broadcast_to(chain.links[0], (*q.shape[:-1], 4, 4))
    for i in range(chain.axis_count):
        T = T @ motion(q[..., i], chain.sliding[i])
        out[..., i + 1, :, :] = T @ chain.frames_after[i]
        T = T @ chain.links[i + 1]
    out[..., -1, :, :] = T
    return out


def jacobian(chain, q):
    """Return the geometric Jacobians (..., 6, n) of the tool point in the base frame, linear rows first."""
    q = axes(chain, q)
    z, o = np.empty((*q.shape[:-1], chain.axis_count, 3)), np.empty((*q.shape[:-1], chain.axis_count, 3))
    T = np.broadcast_to(chain.links[0], (*q.shape[:-1], 4, 4))
    for i in range(chain.axis_count):
        z[..., i, :], o[..., i, :] = T[..., :3, 2], T[..., :3, 3]
        T = T @ motion(q[..., i], chain.sliding[i]) @ chain.links[i + 1]
    J = np.empty((*q.shape[:-1], 6, chain.axis_count))
    P = chain.sliding[:, None]
    J[..., :3, :] = np.swapaxes(np.where(P, z, np.cross(z, T[..., None, :3, 3] - o)), -1, -2)
    J[..., 3:, :] = np.swapaxes(np.where(P, 0.0, z), -1, -2)
    return J if chain.coupling is None else J @ chain.coupling


def axes(chain, q):
    """Return the values (..., n) of the axes at joint vectors q (..., n), coupled or not."""
    q = np.asarray(q, float)
    return q if chain.coupling is None else np.einsum("ij,...j->...i", chain.coupling, q)


def motion(value, prismatic):
    """Return the joint's motion (..., 4, 4): about z, or along it."""
    Z = np.zeros((*np.shape(value), 4, 4))
    Z[..., 2, 2] = Z[..., 3, 3] = 1.0
    if prismatic:
        Z[..., 0, 0] = Z[..., 1, 1] = 1.0
        Z[..., 2, 3] = value
    else:
        Z[..., 0, 0] = Z[..., 1, 1] = np.cos(value)
        Z[..., 1, 0] = np.sin(value)
        Z[..., 0, 1] = -Z[..., 1, 0]
    return Z


def placed(quaternion, p):
    """Return the pose (4, 4) of a quaternion w, x, y, z of any length but zero, and a position."""
    w, x, y, z = quaternion / np.linalg.norm(quaternion)
    T = np.eye(4)
    T[:3, :3] = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    T[:3, 3] = p
    return T
