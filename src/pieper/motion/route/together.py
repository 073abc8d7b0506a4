"""Whether the points of a chain hang together, and, where nothing is free, every branch carried from end to end.

A path that passes a singular posture by a hair defeats nearness: the joints swing between two points, and another
branch is nearer than where the swing leads. So a stretch is halved until it is short beside how far its Jacobian is
from losing rank, and where nothing is free the branch is carried (`pieper.motion.continuation`).
"""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.joints import TURN, inside
from pieper.kinematics.newton import singular_values
from pieper.kinematics.pose import rotation_z
from pieper.motion.between_points import outside_between
from pieper.motion.branches import strands
from pieper.motion.continuation import Continuation
from pieper.motion.route.grid import Grid
from pieper.motion.route.ladder import fitted
from pieper.motion.route.setting import Setting
from pieper.tolerances import NO_LOOK_BETWEEN, NO_SWING, SHORT_BESIDE_RANK

#: How far the point of a route half way between two others may be off their middle, as a part of their distance, and
#: how often a stretch is halved to see.
STRAIGHT, HALVINGS = 0.3, 18


def continuous(setting: Setting, x: Array) -> bool:
    """Whether the points (N, m) of a route hang together: half way between two lies a point of the path near both.

    A stretch whose middle is not where its ends say is halved; one that jumps to another branch never gets straight.
    So is one that is not short beside the least singular value in its middle, by which the Jacobian would have to
    change to lose rank: it could pass from one sheet of postures to another unseen. What is left of a stretch that
    passes a singular posture itself is as short as `NO_SWING`.
    """
    s0, s1, a, b = setting.s[:-1], setting.s[1:], x[:-1], x[1:]
    unit = setting.chain.joints.unit
    for _ in range(HALVINGS):
        middle = (a + b) / 2
        at = (s0 + s1) / 2
        there, on = setting.on(middle, setting.at(at))
        gap = np.abs((there - middle) / unit).max(1)
        size = np.abs((b - a) / unit).max(1)
        doubt = ~on | (gap > STRAIGHT * size + NO_LOOK_BETWEEN)
        long = ~doubt & (size > NO_SWING)
        if long.any():
            least = singular_values(setting.chain, there[long])[:, -1]
            doubt[long] = size[long] > SHORT_BESIDE_RANK * least
        if not doubt.any():
            return True
        if (~on & (size < NO_LOOK_BETWEEN)).any():
            return False
        s0, s1 = np.concatenate([s0[doubt], at[doubt]]), np.concatenate([at[doubt], s1[doubt]])
        a, b = np.concatenate([a[doubt], there[doubt]]), np.concatenate([there[doubt], b[doubt]])
    return False


def way_of(setting: Setting) -> Continuation:
    """Return what carries branches of the arm along the poses, turned by what the turn is held at."""
    turn, _ = setting.free.interval if setting.turn_on_grid else (0.0, 0.0)
    return Continuation(setting.carried, setting.path @ rotation_z(np.asarray(turn)))


def one_branch(setting: Setting, x: Array) -> bool:
    """Whether the points (N, m) of a chain are one branch: steps that pass a singular posture lead where they say.

    Only there does one branch become another, and the determinant of the Jacobian changes its sign.
    """
    way, q = way_of(setting), setting.carried_at(x[:, : setting.n])
    side = way.sides(q)
    for k in np.flatnonzero((side[1:] != side[:-1]) | (side[1:] == 0)).tolist():
        there, place, _, given_up = way.carry(q[k : k + 1], float(k), float(k + 1))
        if given_up[0] or place[0] != k + 1 or np.abs(way.gap(there[0], q[k + 1])).max() > NO_LOOK_BETWEEN:
            return False
    return True


def branches(setting: Setting, cells: Grid, ends: tuple[Array | None, Array | None]) -> list[Array]:
    """Return every branch (N, m) that is carried from the first pose to the last inside the limits.

    Args:
        setting: What is solved.
        cells: Its one cell.
        ends: Joint vectors (m,) to begin and to end with, or None.
    """
    way, n = way_of(setting), setting.n
    low, high = np.clip(setting.carried.limits, -np.pi, np.pi).T
    start = (low + high) / 2 if ends[0] is None else setting.carried_at(ends[0][:n])
    rows, valid = cells.rows(setting.path)
    out: list[Array] = []
    for strand in strands(way, start):
        if strand.end is not None or len(strand.q) < len(way.path):
            continue
        q = np.array(strand.q) if setting.carried is setting.plan else setting.joints_at(np.array(strand.q))
        moved = _wound(setting, _whole(setting, q, rows[:, 0], valid[:, 0]), ends)
        if moved is None or not inside(moved, setting.limits).all():
            continue
        if outside_between(way, setting.carried_at(moved[:, :n])) is None:
            out.append(moved)
    return out


def _whole(setting: Setting, q: Array, rows: Array, valid: Bools) -> Array:
    """Return joints q (N, n) with the virtual coordinates of the rows (N, B, m) that have these joints, continuous."""
    n, joints = setting.n, setting.chain.joints
    if setting.m == n:
        return q
    out: list[Array] = []
    for k in range(len(q)):
        now = np.concatenate([q[k], out[-1][n:] if out else np.zeros(setting.m - n)])
        gap = joints.difference(rows[k], now)
        far = np.linalg.norm(gap[:, :n], axis=1) / NO_LOOK_BETWEEN + np.linalg.norm(gap[:, n:], axis=1)
        best = int(np.argmin(np.where(valid[k], far, np.inf)))
        out.append(np.concatenate([q[k], now[n:] + (gap[best] * joints.unit)[n:]]))
    return np.array(out)


def _wound(setting: Setting, x: Array, ends: tuple[Array | None, Array | None]) -> Array | None:
    """Return a branch (N, m) by whole turns inside the limits and from one end to the other; None where it is not."""
    for at, end in zip((0, -1), ends, strict=True):
        if end is not None:
            turns = np.asarray(np.round((end - x[at]) / TURN), np.float64)
            x = x + TURN * turns * ~setting.chain.prismatic
            break
    else:
        return fitted(setting, x)
    unit = setting.chain.joints.unit
    for at, end in zip((0, -1), ends, strict=True):
        if end is not None and (np.abs(x[at] - end) / unit).max() > NO_LOOK_BETWEEN:
            return None
    return x
