"""A joint curve by the way that its tool's point goes in sections of it, where one speed of both is one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.kinematics.chain import Chain
from pieper.motion.curve import JointCurve
from pieper.motion.tool_bounds import point_derivatives
from pieper.tolerances import EVEN_SPEED, ONE_POINT_OF_PATH

#: Points on the curve at first, and how often twice as many are taken until speeds are even.
POINTS, FINER = 1500, 5
#: How far beside a section, as a part of the path, the parameter turns into the path's own again, at most.
BESIDE = 0.1
#: Places and weights of the rule by which lengths are added up on a cell.
_PLACES, _WEIGHTS = np.polynomial.legendre.leggauss(4)


@dataclass(frozen=True, eq=False)
class ToolWay:
    """A curve in another parameter, which runs as the tool's point goes in sections, and as s does elsewhere.

    Attributes:
        curve: The curve through dense points of the one given.
        s: (k + 1,) the path's own parameter where its pieces meet.
        rate: (k + 1,) how fast the new one runs there, by s.
        metres: What the tool's point goes, m a unit of the new parameter, in sections.
        sections: Where they begin and end in the new parameter.
    """

    curve: JointCurve
    s: Array
    rate: Array
    metres: float
    sections: tuple[tuple[float, float], ...]

    def own(self, at: Array) -> Array:
        """Return the path's own parameter (m,) at values (m,) of the new one: cubics with the slopes that are known."""
        k = self.curve.piece(at)
        h = np.diff(self.curve.s)[k]
        u = (at - self.curve.s[k]) / h
        a, b, da, db = self.s[k], self.s[k + 1], h / self.rate[k], h / self.rate[k + 1]
        rise = b - a
        out = a + u * (da + u * (3 * rise - 2 * da - db + u * (da + db - 2 * rise)))
        return np.asarray(np.clip(out, 0.0, 1.0), np.float64)


def tool_way(chain: Chain, curve: JointCurve, sections: Sequence[tuple[float, float]]) -> ToolWay:
    """Return a curve by its tool's way in sections (s0, s1), in order and apart, in which the tool does not stand."""
    out = _on_points(chain, curve, sections, POINTS)
    for finer in range(1, FINER):
        middles = (out.curve.s[1:] + out.curve.s[:-1]) / 2
        inside = np.any([(middles > a) & (middles < b) for a, b in out.sections], axis=0)
        speed = np.linalg.norm(point_derivatives(chain, out.curve, middles[inside])[0], axis=1)
        if np.abs(speed / out.metres - 1).max(initial=0.0) <= EVEN_SPEED:
            break
        out = _on_points(chain, curve, sections, POINTS * 2**finer)
    return out


def _on_points(chain: Chain, curve: JointCurve, sections: Sequence[tuple[float, float]], count: int) -> ToolWay:
    ends = np.array(sections).ravel()
    must = np.union1d(curve.s, ends)
    must = must[np.append(True, np.diff(must) > ONE_POINT_OF_PATH)]
    each = np.maximum(np.ceil(np.diff(must) * count).astype(int), 1)
    pieces: list[Array] = [
        np.linspace(a, b, n + 1)[:-1]
        for a, b, n in zip(must[:-1].tolist(), must[1:].tolist(), each.tolist(), strict=True)
    ]
    s = np.append(np.concatenate(pieces), 1.0)
    h = np.diff(s)
    inner = s[:-1, None] + h[:, None] * (1 + _PLACES) / 2
    metres = float(h @ (_size(chain, curve, inner) @ _WEIGHTS) / 2)
    grown = np.concatenate([[0.0], np.cumsum(h * (_rate(chain, curve, sections, inner, metres) @ _WEIGHTS) / 2)])
    total = float(grown[-1])
    at = grown / total
    at[-1] = 1.0
    rate = _rate(chain, curve, sections, s, metres) / total
    along = [(float(np.interp(a, s, at)), float(np.interp(b, s, at))) for a, b in sections]
    return ToolWay(JointCurve.through(at, curve.at(s)[0]), s, rate, metres * total, tuple(along))


def _size(chain: Chain, curve: JointCurve, s: Array) -> Array:
    """Return |p'| (...) at s (...), m."""
    return np.asarray(np.linalg.norm(point_derivatives(chain, curve, s.ravel())[0], axis=1).reshape(s.shape), float)


def _rate(chain: Chain, curve: JointCurve, sections: Sequence[tuple[float, float]], s: Array, metres: float) -> Array:
    """Return how fast the new parameter runs by s: as the tool over its mean in sections, 1 far from them."""
    part = np.zeros_like(s)
    for k, (a, b) in enumerate(sections):
        before = a - (sections[k - 1][1] if k else 0.0)
        behind = (sections[k + 1][0] if k + 1 < len(sections) else 1.0) - b
        for off, room in ((a - s, before), (s - b, behind)):
            # half of what lies between two sections belongs to each
            width = max(min(BESIDE, room / 2), ONE_POINT_OF_PATH)
            z = np.clip(1 - off / width, 0.0, 1.0)
            side = z**3 * (10 + z * (6 * z - 15))
            mine = (s >= a - width) & (s <= b + width)
            part = np.where(mine & (off > 0), np.maximum(part, side), part)
        part = np.where((s >= a) & (s <= b), 1.0, part)
    return 1 - part + part * _size(chain, curve, s) / metres
