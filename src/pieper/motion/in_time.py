"""A curve under a profile: its samples in time, and which limit binds when."""

from __future__ import annotations

import numpy as np

from pieper import _kernel
from pieper.kinematics.arrays import Array
from pieper.motion.curve import JointCurve
from pieper.motion.motion import Tight, sample_times
from pieper.motion.profile import Profile
from pieper.motion.ratios import Ratios
from pieper.tolerances import LIMIT_BINDS


def profile_of(s: Array, x: Array) -> Profile:
    """Return s(t) where x = (ds/dt)^2 is linear between the points s (k + 1,)."""
    h, v = np.diff(s), np.sqrt(x)
    t = np.concatenate([[0.0], np.cumsum(2 * h / (v[1:] + v[:-1]))])
    return Profile(t, np.stack([s[:-1], v[:-1], np.diff(x) / (2 * h), np.zeros(len(h))], 1))


def sampled(curve: JointCurve, profile: Profile, rate: float) -> tuple[Array, Array, Array, Array, Array, Array]:
    """Return t, q, dq, ddq, dddq and s of a curve under a profile."""
    t = sample_times(profile.duration, rate)
    s, q, dq, ddq, dddq = _kernel.in_time(
        s=curve.s, q=curve.q, d1=curve.d1, d2=curve.d2, d3=curve.d3, t=profile.t, c=profile.c, times=t
    )
    return t, q, dq, ddq, dddq, s


def binding(t: Array, ratios: Ratios, near: float = LIMIT_BINDS) -> list[Tight]:
    """Return which limit binds when, neighbouring pieces together; what comes so near to its limit, relative, binds."""
    runs = _kernel.tightest(ratios.values, 1 - near)
    return [Tight(float(t[a]), float(t[b]), *ratios.kinds[row]) for a, b, row in runs]
