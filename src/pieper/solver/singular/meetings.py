"""Where a joint brings the two beside it into one line, which then turn against one another: always a self-motion."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.chain import Chain
from pieper.kinematics.joints import short_way
from pieper.kinematics.newton import missed, newton, size_of
from pieper.kinematics.pose import rotation_about
from pieper.tolerances import BLURRED_TO, GEOMETRY_EXACT, LINKAGE_STARTS, UNNOTICED

#: Newton steps by which a row that all but stands there is put there: each halves what is left where branches merge.
STEPS = 40


@dataclass(frozen=True)
class Meeting:
    """Where two joints come to turn about one line.

    Args:
        between: The joint (0-based) between the two.
        value: Where it stands, rad.
        sense: 1 where the two then turn the same way about the line, else -1.
    """

    between: int
    value: float
    sense: float


def meetings(chain: Chain) -> tuple[Meeting, ...]:
    """Return where a turning joint brings its neighbours, turning joints too, into one line."""
    found: list[Meeting] = []
    for k in range(1, chain.n - 1):
        if not chain.prismatic[k - 1 : k + 2].any():
            found += _brought(chain, k)
    return tuple(found)


def _brought(chain: Chain, k: int) -> list[Meeting]:
    """Return where joint k brings the axis behind it onto the one before it."""
    before, about, behind = chain.axes[k - 1 : k + 2]
    place, there = chain.points[k - 1] - chain.points[k], chain.points[k + 1] - chain.points[k]
    wanted, turned = _across(before, about), _across(behind, about)
    found: list[Meeting] = []
    if np.linalg.norm(wanted) < GEOMETRY_EXACT:
        # of three parallel axes the outer two meet where links of one length are folded upon one another
        senses, wanted, turned = (float(np.sign(before @ behind)),), _across(place, about), _across(there, about)
        if np.linalg.norm(turned) < GEOMETRY_EXACT * chain.length:
            return found
    else:
        senses = (1.0, -1.0)
    for sense in senses:
        to = wanted if len(senses) == 1 else sense * wanted
        value = float(np.arctan2(np.cross(turned, to) @ about, turned @ to))
        R = rotation_about(about, value)
        off = R @ there - place
        apart = np.linalg.norm(R @ behind - sense * before)
        if apart < GEOMETRY_EXACT and np.linalg.norm(_across(off, before)) < GEOMETRY_EXACT * chain.length:
            found.append(Meeting(k, value, sense))
    return found


def _across(v: Array, axis: Array) -> Array:
    return v - (v @ axis) * axis


def put_in_line(chain: Chain, at: Meeting, q: Array, T: Array) -> Array | None:
    """Return a row (n,) put to where a meeting is, if it all but stands there and the pose is held there too.

    Where branches merge a row is known to half the digits or fewer, and so is whether it stands there.
    """
    moved, held = all_put_in_line(chain, at, q[None], T)
    return moved[0] if held[0] else None


def all_put_in_line(chain: Chain, at: Meeting, q: Array, T: Array) -> tuple[Array, Bools]:
    """Return rows (m, n) of which those are put to where a meeting is that `put_in_line` says, and which (m,)."""
    if chain.coupling is not None:
        return q, np.zeros(len(q), bool)
    near = np.flatnonzero(np.abs(short_way(q[:, at.between] - at.value)) <= LINKAGE_STARTS)
    out, held = q.copy(), np.zeros(len(q), bool)
    if len(near):
        rest = newton(chain.locked(at.between, at.value), np.delete(q[near], at.between, axis=1), T, steps=STEPS)
        there = np.insert(rest, at.between, at.value, axis=1)
        # farther away it is another solution, that lies on the line where this one lies beside it
        close = chain.joints.apart(there, q[near]) < BLURRED_TO
        good = close & (missed(chain, there, T) < UNNOTICED * size_of(chain, T))
        out[near[good]], held[near[good]] = there[good], True
    return out, held
