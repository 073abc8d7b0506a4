"""The tool's pose as one elementary matrix after the other, from a description: slow, obvious, no code of pieper."""

from __future__ import annotations

import numpy as np


def product(arm, q):
    """Return the tool's pose (4, 4) of a description at one joint vector q (n,), coupling, sense and zero included."""

    def turn(axis, angle):
        c, s = np.cos(angle), np.sin(angle)
        i, j = (axis + 1) % 3, (axis + 2) % 3
        M = np.eye(4)
        M[i, i], M[i, j], M[j, i], M[j, j] = c, -s, s, c
        return M

    def move(axis, length):
        M = np.eye(4)
        M[axis, 3] = length
        return M

    if arm.coupling is not None:
        q = [sum(c * x for c, x in zip(row, q, strict=True)) for row in arm.coupling.tolist()]
    T = np.array(arm.base)
    for i, row in enumerate(arm.rows):
        said = arm.sign[i] * q[i] + arm.offset[i]
        theta = row.theta + (said if arm.axis_types[i] == "R" else 0)
        d = row.d + (said if arm.axis_types[i] == "P" else 0)
        z_part = [turn(2, theta), move(2, d)]
        x_part = [move(0, row.a), turn(0, row.alpha)]
        for M in z_part + x_part if arm.convention == "standard" else x_part + z_part:
            T = T @ M
    return T @ arm.tool
