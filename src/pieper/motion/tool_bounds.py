"""How fast the tool moves and turns along a joint curve, with bounds that hold between the grid's points."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.kinematics.chain import Chain
from pieper.motion.curve import JointCurve


@dataclass(frozen=True, eq=False)
class ToolCurve:
    """Derivatives by s of the tool's point and orientation at the points of a curve's pieces, and bounds on them.

    A vector f(s) departs from the line between its values at a piece's ends by at most h^2 / 8 max|f''|. The
    derivatives of a pose by joints are crossed products of unit axes with the lever of the last joint named, so that
    |p'''| and the like are bounded by sums of levers times the joints' own derivatives, which are exact on a piece.

    Attributes:
        point: (k + 1, 3) p', m.
        bend: (k + 1, 3) p'', m.
        turn: (k + 1, 3) the tool's turning a unit of s, rad.
        point_strays: (k,) how far p' can be from the line between its ends, m.
        turn_strays: (k,) the same of `turn`, rad.
        third: (k,) bound of |p'''|, m.
        turn_third: (k,) bound of the second derivative of `turn`, rad.
        fourth: (k,) bound of |p''''|, m.
    """

    point: Array
    bend: Array
    turn: Array
    point_strays: Array
    turn_strays: Array
    third: Array
    turn_third: Array
    fourth: Array


def tool_curve(chain: Chain, curve: JointCurve) -> ToolCurve:
    """Return what the tool does along a curve.

    Args:
        chain: The arm; coupled joints are looked at as the chain's own.
        curve: The joint curve; each piece is looked at on its own.
    """
    C = np.eye(chain.axis_count) if chain.coupling is None else chain.coupling
    chain = chain.uncoupled
    h = np.diff(curve.s)
    last = [curve.end, *(x[-1] for x in curve.at(curve.s[-1:])[1:])]
    q, d1, d2, d3 = (
        np.vstack([a, b]) @ C.T for a, b in zip((curve.q, curve.d1, curve.d2, curve.d3), last, strict=True)
    )
    J = chain.native.jacobian(q)
    point, bend = _point(J, d1, d2)
    turn = np.einsum("kij,kj->ki", J[:, 3:], d1)
    e1, e2 = d1[:-1] + h[:, None] * (d2[:-1] + h[:, None] * d3[:-1] / 2), d2[:-1] + h[:, None] * d3[:-1]
    middle = d1[:-1] + h[:, None] / 2 * d2[:-1]
    Q1 = np.max(np.abs([d1[:-1], middle, e1]), 0)
    Q2, Q3 = np.maximum(np.abs(d2[:-1]), np.abs(e2)), np.abs(d3[:-1])
    lever = levers(chain, q)
    third = _third(lever, Q1, Q2, Q3)
    turns = _third(np.where(chain.prismatic, 0.0, 1.0), Q1, Q2, Q3)
    return ToolCurve(point, bend, turn, h**2 / 8 * third, h**2 / 8 * turns, third, turns, _fourth(lever, Q1, Q2, Q3))


def point_derivatives(chain: Chain, curve: JointCurve, s: Array) -> tuple[Array, Array]:
    """Return p' and p'' (k, 3) of the tool's point by s, m, at s (k,) of a curve.

    Args:
        chain: The arm; coupled joints are looked at as the chain's own.
        curve: The joint curve.
        s: Places on it.
    """
    C = np.eye(chain.axis_count) if chain.coupling is None else chain.coupling
    q, d1, d2, _ = (values @ C.T for values in curve.at(s))
    return _point(chain.uncoupled.native.jacobian(q), d1, d2)


def turn_derivatives(chain: Chain, curve: JointCurve, s: Array) -> tuple[Array, Array]:
    """Return the tool's turning w and w' (k, 3) a unit of s, rad, at s (k,) of a curve: as `point_derivatives`.

    Equation: w' = the sum over k of a_k q''_k + (the sum over j < k of a_j q'_j) x a_k q'_k
    """
    C = np.eye(chain.axis_count) if chain.coupling is None else chain.coupling
    q, d1, d2, _ = (values @ C.T for values in curve.at(s))
    axes = chain.uncoupled.native.jacobian(q)[:, 3:]
    turning = axes * d1[:, None, :]
    crossed = np.cross(np.cumsum(turning, -1), turning, axis=1).sum(-1)
    return turning.sum(-1), np.einsum("kij,kj->ki", axes, d2) + crossed


def levers(chain: Chain, q: Array) -> Array:
    """Return bounds (n,) of the tool point's distance from each revolute axis over q (k, n); 1 for slides.

    Lengths behind the joint are added up, slides at their farthest.
    """
    reach = np.zeros(chain.n)
    total = 0.0
    for j in reversed(range(chain.n)):
        total += float(np.linalg.norm(chain.links[j + 1][:3, 3]))
        reach[j] = 1.0 if chain.prismatic[j] else total
        if chain.prismatic[j]:
            total += float(np.abs(q[:, j]).max())
    return reach


def _point(J: Array, d1: Array, d2: Array) -> tuple[Array, Array]:
    """Return p' and p'' (k, 3): p'' = J q'' + sum over k of (2 sum over j < k of a_j q'_j + a_k q'_k) x J_k q'_k."""
    linear = J[:, :3] * d1[:, None, :]
    turning = J[:, 3:] * d1[:, None, :]
    before = 2 * np.cumsum(turning, -1) - turning
    crossed = np.cross(before, linear, axis=1).sum(-1)
    return linear.sum(-1), np.einsum("kij,kj->ki", J[:, :3], d2) + crossed


def _grown(lever: Array, product: Array) -> Array:
    """Return the sum over all index tuples of the lever of the largest index, from products of cumulative sums."""
    return np.diff(product, axis=-1, prepend=0.0) @ lever


def _third(lever: Array, Q1: Array, Q2: Array, Q3: Array) -> Array:
    C1, C2, C3 = (np.cumsum(Q, -1) for Q in (Q1, Q2, Q3))
    return _grown(lever, C3 + 3 * C1 * C2 + C1**3)


def _fourth(lever: Array, Q1: Array, Q2: Array, Q3: Array) -> Array:
    C1, C2, C3 = (np.cumsum(Q, -1) for Q in (Q1, Q2, Q3))
    return _grown(lever, 4 * C1 * C3 + 3 * C2**2 + 6 * C1**2 * C2 + C1**4)
