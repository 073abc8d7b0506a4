"""Where the true solutions of a rounded pose lie, with fifty digits: rounding told apart from a lost solution.

A pose in double precision is not the pose that a joint vector q makes, but one about 1e-16 away, and near a singular
posture its solutions lie 1e-16 / sigma away from q, or, where two merge, are no real ones at all. Newton's method in
fifty digits starts from q and from the rows that a solver gave, on the rounded pose as it stands (its rotation part
made a rotation in fifty digits), by a product of DH matrices of its own.
"""

from __future__ import annotations

import mpmath as mp
import numpy as np

DIGITS = 50
#: Two roots of the fifty-digit iteration this close are one.
ONE = mp.mpf(10) ** -20
#: What the rounding of a pose and of forward kinematics in double precision amounts to (per metre + 1; rad).
BLUR = mp.mpf("2e-15")


def verdict(arm, T: np.ndarray, q: np.ndarray, rows: np.ndarray, *, asked=range(6), held=()) -> str:
    """Say what became of a joint vector q whose pose was rounded to T.

    Args:
        arm: Anything with a DH `description`.
        T: (4, 4) the rounded pose.
        q: (n,) the joint vector the pose was made from.
        rows: (m, n) the solver's answers.
        asked: Rows of the pose equation (position, then rotation vector) that the task asks for.
        held: Joints (0-based) that keep their values.

    Returns:
        "rounding": the true solution of the rounded pose next to q is one of the rows, in double precision;
        "not real": next to q the rounded pose has no real solution (two have merged and left the real axis);
        "blurred": the rows next to it lead to another true solution, and everything between the two reaches the
        rounded pose to within `BLUR`: in double precision they are one;
        "lost": it has one, and no row leads to it; "unsettled": the iteration did not converge.
    """
    with mp.workdps(DIGITS):
        target = _rotation_made(T)
        free = [j for j in range(arm.n) if j not in held]
        root = _newton(arm, target, [mp.mpf(float(x)) for x in q], asked, free)
        if root is None:
            bent = [mp.mpc(float(x), 1e-8 * (1 + 0.3 * i)) for i, x in enumerate(q)]
            for j in held:
                bent[j] = mp.mpf(float(q[j]))
            root = _newton(arm, target, bent, asked, free)
            if root is None:
                return "unsettled"
            return "not real" if max(abs(mp.im(x)) for x in root) > ONE else "unsettled"
        near = sorted(rows, key=lambda row: float(_apart(arm, root, row)))[:2]
        for row in near:
            if _apart(arm, root, row) > 1e-3:
                break
            other = _newton(arm, target, [mp.mpf(float(x)) for x in row], asked, free)
            if other is not None and _apart(arm, root, other) < ONE:
                return "rounding"
        if near and _joined(arm, target, root, near[0], asked, free):
            return "blurred"
        return "lost"


def _joined(arm, target, root, row, asked, free) -> bool:
    """Whether a curve of joint vectors leads from a root to a row on which the pose is missed by rounding only."""
    if _apart(arm, root, row) > 1e-2:
        return False
    limit = BLUR * (1 + mp.norm(target[:3, 3]))
    end = []
    for x, y, kind in zip(root, row, arm.joint_types, strict=True):
        turns = 0 if kind == "P" else mp.nint((x - float(y)) / (2 * mp.pi))
        end.append(mp.mpf(float(y)) + 2 * mp.pi * turns)
    for k in range(1, 5):
        v = [x + (y - x) * k / 4 for x, y in zip(root, end, strict=True)]
        for _ in range(3):
            # a chord leaves a bent curve: back onto it by damped steps, which leave the weakest direction alone
            A, b = _linear(arm, target, v, asked, free)
            N = A.T * A
            for i in range(N.rows):
                N[i, i] += mp.mpf(10) ** -12
            for j, change in zip(free, mp.lu_solve(N, A.T * b), strict=True):
                v[j] += change
        if max(abs(x) for x in _linear(arm, target, v, asked, free)[1]) > limit:
            return False
    return True


def _apart(arm, a, b):
    gaps = []
    for x, y, kind in zip(a, b, arm.joint_types, strict=True):
        d = mp.re(mp.mpmathify(x)) - mp.re(mp.mpmathify(float(y) if isinstance(y, np.floating) else y))
        gaps.append(abs(d) if kind == "P" else abs(d - 2 * mp.pi * mp.nint(d / (2 * mp.pi))))
    return max(gaps)


def _rotation_made(T):
    """Return the pose with the rotation nearest to its rotation part (Newton's iteration for the polar factor)."""
    M = mp.matrix(np.asarray(T, float).tolist())
    R = M[:3, :3]
    for _ in range(8):
        R = (R + (R**-1).T) / 2
    for i in range(3):
        for j in range(3):
            M[i, j] = R[i, j]
    return M


def _forward(arm, v):
    """Return the pose and each joint's axis and a point of it, by plain matrices."""
    d = arm.description
    F = mp.matrix(np.asarray(d.base, float).tolist())
    axes, points = [], []
    for i, row in enumerate(d.rows):
        slides = d.joint_types[i] == "P"
        value = int(d.sign[i]) * v[i] + mp.mpf(float(d.offset[i]))
        a, alpha = mp.mpf(float(row.a)), mp.mpf(float(row.alpha))
        length = mp.mpf(float(row.d)) + (value if slides else 0)
        theta = mp.mpf(float(row.theta)) + (0 if slides else value)
        c, s, ca, sa = mp.cos(theta), mp.sin(theta), mp.cos(alpha), mp.sin(alpha)
        motion = mp.matrix([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, length], [0, 0, 0, 1]])
        link = mp.matrix([[1, 0, 0, a], [0, ca, -sa, 0], [0, sa, ca, 0], [0, 0, 0, 1]])
        if d.convention != "standard":
            F = F * link
        axes.append([int(d.sign[i]) * F[k, 2] for k in range(3)])
        points.append([F[k, 3] for k in range(3)])
        F = F * motion * link if d.convention == "standard" else F * motion
    return F * mp.matrix(np.asarray(d.tool, float).tolist()), axes, points


def _cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def _newton(arm, target, v, asked, free):
    """Return a root (list) of the pose equation next to v, or None; least squares where there are too many rows."""
    for _ in range(80):
        A, b = _linear(arm, target, v, asked, free)
        try:
            step = mp.lu_solve(A, b) if A.rows == A.cols else mp.lu_solve(A.T * A, A.T * b)
        except ZeroDivisionError:
            return None
        size = max(abs(x) for x in step)
        if size > 0.3:
            step *= mp.mpf("0.3") / size
        v = list(v)
        for j, change in zip(free, step, strict=True):
            v[j] += change
        if size < ONE * mp.mpf(10) ** -8:
            return v
    return None


def _linear(arm, target, v, asked, free):
    """Return the matrix and the right side of one Newton step on the pose equation."""
    F, axes, points = _forward(arm, v)
    tip = [F[k, 3] for k in range(3)]
    e = [target[k, 3] - tip[k] for k in range(3)]
    turn = [mp.mpf(0)] * 3
    for column in range(3):
        one = _cross([F[k, column] for k in range(3)], [target[k, column] for k in range(3)])
        turn = [t + x / 2 for t, x in zip(turn, one, strict=True)]
    e += turn
    columns = []
    for j in free:
        if arm.joint_types[j] == "P":
            columns.append([*axes[j], 0, 0, 0])
        else:
            columns.append([*_cross(axes[j], [tip[k] - points[j][k] for k in range(3)]), *axes[j]])
    A = mp.matrix([[column[k] for column in columns] for k in asked])
    return A, mp.matrix([e[k] for k in asked])
