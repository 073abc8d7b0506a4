"""Sections of constant speed of the tool's point: how they are asked for, the fastest one, and why one cannot be."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from pieper import arguments
from pieper.errors import InputError
from pieper.kinematics.arrays import Array
from pieper.motion.curve import JointCurve
from pieper.motion.ratios import peak_ratios
from pieper.motion.timed_path import TimedPath
from pieper.motion.tool_bounds import tool_curve
from pieper.tolerances import EVEN_SPEED, SPEED_ABOVE, SPEED_LOWERED, SPEED_SETTLED, TOOL_STANDS

Section = tuple[float, float, float]

#: Doublings of a section's grid at most.
FINEST = 8
#: Halvings of the interval of speeds.
HALVINGS = 60


class Fastest(float):
    """A speed, m/s, with what forbids a higher one.

    Attributes:
        s: Where.
        limit: Which limit: "speed", "acceleration", "tool speed", ..., "run-up" or "run-out".
        joint: Name of the joint, or None.
        why: A sentence.
    """

    s: float
    limit: str
    joint: str | None
    why: str

    @classmethod
    def of(cls, speed: float, s: float, limit: str, joint: str | None) -> Fastest:
        """Return a speed with its sentence."""
        out = cls(speed)
        out.s, out.limit, out.joint = s, limit, joint
        if limit == "run-up":
            out.why = f"the run-up to s = {s:.4g} allows {speed:.6g} m/s."
        elif limit == "run-out":
            out.why = f"the run-out from s = {s:.4g} allows {speed:.6g} m/s."
        else:
            out.why = f"at s = {s:.4g} the {limit}{f' of {joint}' if joint else ''} allows {speed:.6g} m/s."
        return out


def checked_sections(sections: Sequence[tuple[float, float, float]]) -> list[Section]:
    """Return sections in order of s, or say what is wrong with one."""
    out: list[Section] = []
    for k, section in enumerate(arguments.several(sections, "constant_speed", "sections (s0, s1, v)")):
        try:
            s0, s1, v = (float(number) for number in section)
        except (TypeError, ValueError):
            raise InputError(
                f"section {k + 1} of constant speed must be (s0, s1, v), got {arguments.kind_of(section)}.",
                given=section,
            ) from None
        if not 0 <= s0 < s1 <= 1:
            raise InputError(
                f"section {k + 1} of constant speed goes from {s0:g} to {s1:g}; s goes from 0 to 1, forward.",
                given=section,
            )
        if not (np.isfinite(v) and v > 0):
            raise InputError(f"the speed of section {k + 1} must be finite and positive, m/s, got {v:g}.", given=v)
        out.append((s0, s1, v))
    out.sort()
    for a, b in zip(out, out[1:], strict=False):
        if b[0] < a[1]:
            raise InputError(
                f"sections of constant speed overlap: {a[0]:g} to {a[1]:g} and {b[0]:g} to {b[1]:g}.", given=(a, b)
            )
    return out


def section_grid(timed: TimedPath, curve: JointCurve, sections: Sequence[Section]) -> tuple[TimedPath, Array]:
    """Return the path on a grid so fine that speeds are even, and x (k + 1,) that is wanted, NaN where it is free."""
    if timed.tool is None:
        raise InputError(
            "a constant speed of the tool needs an arm: give a track or a route instead of points, or say arm=.",
            given="points",
        )
    plan_curve = timed.tool
    for _ in range(FINEST):
        s = timed.curve.s
        size = np.linalg.norm(plan_curve.point, axis=1)
        inside = [(s[:-1] >= a) & (s[1:] <= b) for a, b, _ in sections]
        coarse = np.zeros(len(s) - 1, bool)
        middle = (s[1:] + s[:-1]) / 2
        # |p'| between: linear to h^2 / 8 |p'''|; what matters is 1 / |p'|^2 against its own line
        between = np.linalg.norm(_point_at(timed, curve, middle), axis=1)
        with np.errstate(divide="ignore", invalid="ignore"):
            even = (size[1:] ** -2.0 + size[:-1] ** -2.0) / 2 * between**2
            coarse = np.any(inside, axis=0) & ~(np.abs(even - 1) / 2 <= EVEN_SPEED)
        if not coarse.any() or (size[:-1][coarse] < TOOL_STANDS).any() or (size[1:][coarse] < TOOL_STANDS).any():
            break
        grid = np.sort(np.append(s, middle[coarse]))
        i = np.clip(np.searchsorted(s, grid[:-1], side="right") - 1, 0, len(s) - 2)
        split = curve.split(grid)
        plan_curve = tool_curve(timed.chain, split)
        timed = replace(timed, curve=split, tool=plan_curve, share=timed.share[i], tool_speed=timed.tool_speed[i])
    return timed, wanted_x(timed, sections)


def _point_at(timed: TimedPath, curve: JointCurve, s: Array) -> Array:
    q, d1, _, _ = curve.at(s)
    J = timed.chain.native.jacobian(q)
    return np.einsum("kij,kj->ki", J[:, :3], d1)


def wanted_x(timed: TimedPath, sections: Sequence[Section]) -> Array:
    """Return x (k + 1,) at which the tool has the speeds of its sections, NaN elsewhere."""
    assert timed.tool is not None
    s, size = timed.curve.s, np.linalg.norm(timed.tool.point, axis=1)
    out = np.full(len(s), np.nan)
    for s0, s1, v in sections:
        at = (s >= s0) & (s <= s1)
        still = at & (size < TOOL_STANDS)
        if still.any():
            where = float(s[np.argmax(still)])
            raise InputError(
                f"the tool's point stands still at s = {where:.4g}: no constant speed leads through there. "
                "Leave that place out of the section.",
                s=where,
            )
        both = at & ~np.isnan(out)
        if both.any() and not np.allclose(out[both], (v / size[both]) ** 2):
            raise InputError(
                f"two sections meet at s = {s0:g} with different speeds; leave room between them to change speed.", s=s0
            )
        out[at] = (v / size[at]) ** 2
    return out


def highest(timed: TimedPath, section: Section) -> Fastest:
    """Return the highest speed of a section; lower ones all do, so that halving finds it."""
    s0, s1, _ = section
    most, s, limit, joint = _by_limits(timed, section)

    def can(v: float) -> bool:
        return timed.run(wanted_x(timed, [(s0, s1, v)]))[2]

    if s0 <= 0 or s1 >= 1:
        most, s, limit, joint = 0.0, (0.0 if s0 <= 0 else 1.0), ("run-up" if s0 <= 0 else "run-out"), None
    elif not can(most):
        low, high = 0.0, most
        for _ in range(HALVINGS):
            v = (low + high) / 2
            low, high = (v, high) if can(v) else (low, v)
            if high - low <= SPEED_SETTLED * high:
                break
        if low < most * (1 - SPEED_LOWERED):
            # not the section's own limits then, but what lies before or behind it
            _, sets, _, _ = timed.run()
            at = int(np.searchsorted(timed.curve.s, s1))
            x = wanted_x(timed, [(s0, s1, high * (1 + SPEED_ABOVE))])[at]
            limit, s, joint = ("run-out", s1, None) if x > sets[at] else ("run-up", s0, None)
        most = low
    return Fastest.of(most, s, limit, joint)


def _by_limits(timed: TimedPath, section: Section) -> tuple[float, float, str, str | None]:
    """Return the speed that the limits inside a section allow, where, and which limit; everything scales with it."""
    x = wanted_x(timed, [(section[0], section[1], 1.0)])
    inside = ~np.isnan(x[1:]) & ~np.isnan(x[:-1])
    filled = np.where(np.isnan(x), 0.0, x)
    ratios = peak_ratios(timed, filled)
    values = ratios.values[:, inside] ** (1 / ratios.powers[:, None])
    row, column = np.unravel_index(int(values.argmax()), values.shape)
    limit, joint = ratios.kinds[row]
    place = float(timed.curve.s[:-1][inside][column])
    return 1 / float(values[row, column]), place, limit, joint


def apart_or_one(sections: Sequence[Section]) -> list[Section]:
    """Return sections of which those that meet with one speed are one."""
    out: list[Section] = []
    for section in sections:
        if out and out[-1][1] == section[0] and out[-1][2] == section[2]:
            section = (out.pop()[0], *section[1:])
        out.append(section)
    return out


def refused(sections: Sequence[Section], highest_of: Callable[[Section], Fastest]) -> InputError:
    """Return the error that says which section cannot be, where, because of what, and what would do."""
    for section in sections:
        best = highest_of(section)
        if section[2] > best:
            return InputError(
                f"the tool cannot keep {section[2]:g} m/s from s = {section[0]:g} to {section[1]:g}: {best.why} "
                "The highest speed that would do is "
                f"{float(best):.6g} m/s.",
                given=section,
                s=best.s,
                joint=best.joint,
                limit=best.limit,
                fastest=float(best),
            )
    return InputError(
        "the sections of constant speed cannot be had together: there is too little room between two of them to change "
        "speed. Take speeds that differ less, or shorter sections.",
        given=list(sections),
    )
