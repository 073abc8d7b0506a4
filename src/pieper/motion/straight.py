"""A path whose points lie on one straight joint line: its motion in closed form."""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.motion.curve import JointCurve
from pieper.motion.in_time import sampled
from pieper.motion.joint_move import margin_of_line, straight_profile, tight_pieces
from pieper.motion.motion import Motion
from pieper.motion.profile import Profile
from pieper.motion.timed_path import TimedPath
from pieper.tolerances import ON_A_LINE

#: Halvings after which a place on a curve is known to the last digit.
HALVINGS = 60


def straight_motion(timed: TimedPath, curve: JointCurve, rate: float) -> Motion | None:
    """Return the fastest motion along a straight joint line within the joints' limits.

    None where the path is no such line, goes back on it, or has limits of the tool or parts of its speeds that differ.
    """
    found = closed_form(timed, curve)
    if found is None or timed.limits.of_the_tool or np.isfinite(timed.tool_speed).any():
        return None
    profile, names = found
    start, way = curve.q[0], curve.end - curve.q[0]
    still = np.zeros((1, len(way)))
    line = JointCurve(np.array([0.0, 1.0]), start[None], way[None], still, still)
    t, q, dq, ddq, dddq, along = sampled(line, profile, rate)
    q[-1], along[-1] = start + way, 1.0
    share = float(timed.share[0])
    samples = t, q, dq, ddq, dddq, along if is_even(curve) else _places(curve, along)
    margin = margin_of_line(way, profile, timed.limits, share)
    return timed.motion(samples, tight_pieces(profile, names), margin, profile.duration, curve.between_points())


def closed_form(timed: TimedPath, curve: JointCurve) -> tuple[Profile, list[str]] | None:
    """Return how the part of a straight joint line that is behind the arm runs in time, and which joint binds what."""
    way = curve.end - curve.q[0]
    if not (timed.share == timed.share[0]).all() or not way.any():
        return None
    off = curve.q - curve.q[0] - _along(curve)[:, None] * way
    if np.abs(off).max() > ON_A_LINE * np.abs(curve.q).max():
        return None
    per, h = way / (way @ way), np.diff(curve.s)
    begins, bends, sharp = curve.d1 @ per, curve.d2 @ per, curve.d3 @ per
    # a slope is a quadratic: with these three numbers above zero it is so on all of a piece
    middles, ends = begins + h * bends / 2, begins + h * (bends + h * sharp / 2)
    if min(begins.min(), middles.min(), ends.min()) < 0:
        return None
    profile, names = straight_profile(way, timed.limits, timed.names, float(timed.share[0]))
    return None if profile is None else (profile, names)


def is_even(curve: JointCurve) -> bool:
    """Whether a straight line's parameter is the part of it that is behind the arm."""
    return bool(np.abs(_along(curve) - curve.s[:-1]).max() <= ON_A_LINE)


def _along(curve: JointCurve) -> Array:
    """Return the part of the way (k,) that is behind the arm at each piece's beginning."""
    way = curve.end - curve.q[0]
    return np.asarray((curve.q - curve.q[0]) @ (way / (way @ way)), np.float64)


def _places(curve: JointCurve, along: Array) -> Array:
    """Return s (m,) where parts of the way (m,) are behind the arm: halving, for they ascend with s."""
    way = curve.end - curve.q[0]
    per = way / (way @ way)
    low, high = np.full(len(along), curve.s[0]), np.full(len(along), curve.s[-1])
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        before = (curve.at(middle)[0] - curve.q[0]) @ per < along
        low, high = np.where(before, middle, low), np.where(before, high, middle)
    out = (low + high) / 2
    out[0], out[-1] = curve.s[0], curve.s[-1]
    return out
