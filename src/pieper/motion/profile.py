"""How a path parameter runs in time: cubic pieces, and the closed form of the fastest one from rest to rest."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper.kinematics.arrays import Array


@dataclass(frozen=True, eq=False)
class Profile:
    """s(t) in pieces of third degree.

    Attributes:
        t: (k + 1,) where pieces begin and end, s.
        c: (k, 4) s, ds/dt, d2s/dt2 and d3s/dt3 at each piece's beginning.
    """

    t: Array
    c: Array

    @property
    def duration(self) -> float:
        """Total time, s."""
        return float(self.t[-1])

    def at(self, t: Array) -> tuple[Array, Array, Array, Array]:
        """Return s and its first three derivatives (...) at times (...), s."""
        i = np.clip(np.searchsorted(self.t, t, side="right") - 1, 0, len(self.c) - 1)
        s, v, a, j = self.c[i].T
        tau = t - self.t[i]
        return s + tau * (v + tau * (a / 2 + tau * j / 6)), v + tau * (a + tau * j / 2), a + tau * j, j

    def place(self, t: Array) -> Array:
        """Return s (...) at times (...), s."""
        i = np.clip(np.searchsorted(self.t, t, side="right") - 1, 0, len(self.c) - 1)
        s, v, a, j = self.c.T[:, i]
        tau = t - self.t[i]
        return np.asarray(s + tau * (v + tau * (a / 2 + tau * j / 6)), np.float64)

    @property
    def middles(self) -> Array:
        """(k,) s in the middle of each piece's time."""
        return self.place((self.t[1:] + self.t[:-1]) / 2)

    def slower(self, factor: float) -> Profile:
        """Return the same way, every time multiplied by a factor."""
        return Profile(self.t * factor, self.c / factor ** np.arange(4))


def phases(speed: Array, acceleration: Array, jerk: Array | None) -> tuple[Array, Array, Array]:
    """Return the fastest way of length 1 from rest to rest within positive limits (...).

    Equation: with jerk J, acceleration A and speed V the speed rises for Ta = Tj + V/A, Tj = A/J, where A is reached
    (V J >= A^2) and for Ta = 2 sqrt(V/J) where not; it stays for 1/V - Ta. Where that is negative, V is not reached:
    2 Ta is the time, from Ta^2 - Tj Ta = 1/A or, where A is not reached either, Ta = 2 (1/(2J))^(1/3).

    Args:
        speed: V (...).
        acceleration: A (...).
        jerk: J (...), or None for a trapezoid of speed.

    Returns:
        Tj, Ta and Tv (...), s: how long the acceleration rises, the speed rises and the speed stays; 2 Ta + Tv in all.
    """
    V, A = speed, acceleration
    if jerk is None:
        Ta = np.minimum(V / A, np.sqrt(1 / A))
        Tv = np.maximum(1 / V - V / A, 0.0)
        return np.zeros_like(Ta), Ta, np.where(V / A < np.sqrt(1 / A), Tv, 0.0)
    J = jerk
    full = V * J >= A**2
    Tj = np.where(full, A / J, np.sqrt(V / J))
    Ta = np.where(full, Tj + V / A, 2 * Tj)
    Tv = 1 / V - Ta
    # not up to V
    Tj_short = A / J
    Ta_short = Tj_short / 2 + np.sqrt((Tj_short / 2) ** 2 + 1 / A)
    Tj_least = np.cbrt(1 / (2 * J))
    reached = Ta_short >= 2 * Tj_short
    Tj_short, Ta_short = np.where(reached, Tj_short, Tj_least), np.where(reached, Ta_short, 2 * Tj_least)
    cruising = Tv >= 0
    return np.where(cruising, Tj, Tj_short), np.where(cruising, Ta, Ta_short), np.maximum(Tv, 0.0)


def rest_to_rest(speed: float, acceleration: float, jerk: float | None) -> Profile:
    """Return the fastest profile of s from 0 to 1, at rest at both ends, in three or seven pieces."""
    one = np.ones(1)
    Tj, Ta, Tv = (float(x[0]) for x in phases(speed * one, acceleration * one, None if jerk is None else jerk * one))
    if jerk is None:
        lengths, top = [Ta, Tv, Ta], 1 / (Ta + Tv)
        bend, sharp = [top / Ta, 0.0, -top / Ta], [0.0] * 3
    else:
        lengths = [Tj, Ta - 2 * Tj, Tj, Tv, Tj, Ta - 2 * Tj, Tj]
        top = 1 / (Ta + Tv)
        J = top / (Tj * (Ta - Tj))
        bend, sharp = [0.0, J * Tj, J * Tj, 0.0, 0.0, -J * Tj, -J * Tj], [J, 0.0, -J, 0.0, -J, 0.0, J]
    kept = [i for i, length in enumerate(lengths) if length > 0]
    t = np.concatenate([[0.0], np.cumsum([lengths[i] for i in kept])])
    c = np.zeros((len(kept), 4))
    c[:, 2], c[:, 3] = [bend[i] for i in kept], [sharp[i] for i in kept]
    for i in range(len(kept) - 1):
        s, v, a, j = c[i]
        tau = t[i + 1] - t[i]
        c[i + 1, 0] = s + tau * (v + tau * (a / 2 + tau * j / 6))
        c[i + 1, 1] = v + tau * (a + tau * j / 2)
    return Profile(t, c)
