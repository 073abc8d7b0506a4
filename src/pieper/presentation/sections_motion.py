"""Sections about what an arm does: a pose with all its solutions, a path followed, a move in time."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pieper.document.blocks import Document
from pieper.drawing.style import MM, picture
from pieper.kinematics.orientation import rpy_of
from pieper.presentation.plot_arm import configuration_figure, solutions_figure
from pieper.presentation.plot_curves import coordinates_figure, joints_figure, time_figure
from pieper.presentation.plot_path import path_figure
from pieper.presentation.plot_route import route_figure
from pieper.presentation.sections_arm import fixed, joint_heads, joint_value
from pieper.tolerances import ROUNDING

if TYPE_CHECKING:
    from pieper.motion.route.result import Route
    from pieper.motion.sequence import Motion
    from pieper.motion.track import Track
    from pieper.presentation.arm import Arm
    from pieper.solver.results import Solutions


def scientific(value: float) -> str:
    """Return a small number as 3 × 10⁻¹⁶ would be read aloud, and zero as 0."""
    if value == 0:
        return "0"
    mantissa, exponent = f"{value:.1e}".split("e")
    sup = str(int(exponent)).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
    return f"{mantissa}·10{sup}"


def pose_words(T: np.ndarray) -> str:
    """Return a pose in words: position in mm and, unless it is the identity, roll, pitch, yaw."""
    p = ", ".join(fixed(v * MM, 2) for v in T[:3, 3])
    if np.allclose(T[:3, :3], np.eye(3), atol=ROUNDING):
        return f"({p}) mm with the orientation R = I"
    return f"({p}) mm, roll, pitch, yaw ({', '.join(fixed(v, 3) for v in np.degrees(rpy_of(T[:3, :3])))})°"


def add_solutions(page: Document, arm: Arm, sols: Solutions, *, name: str = "solutions") -> None:
    """Add a solved pose: every solution with its label, limits and residual, and their picture."""
    rows_q, labels, inside = sols.all_q, sols.all_labels, sols.in_limits
    page.add(f"The pose: {pose_words(sols.T)}. {sols.why}")
    if not len(rows_q):
        return
    residual = arm.plan.residual(rows_q, sols.T)
    rows = []
    for i, q in enumerate(rows_q):
        outside = np.maximum(arm.limits[:, 0] - q, q - arm.limits[:, 1])
        where = "none" if inside[i] else arm.joint_names[int(np.argmax(outside))]
        values = [joint_value(arm, j, v, 2) for j, v in enumerate(q)]
        rows.append([str(i + 1), *values, labels[i], where, scientific(residual[i, 0] * MM)])
    n = arm.n
    page.table(
        ["", *joint_heads(arm), "posture", "limit broken", "missing,\u00a0mm"],
        rows,
        "Every solution of the pose, each put back through forward kinematics: on the right what is then missing. "
        + (
            ""
            if arm.plan.task == "position"
            else f"The orientation is met to within {scientific(np.degrees(residual[:, 1].max()))}°."
        ),
        left=(0, n + 1, n + 2),
        strong=tuple(int(i) for i in np.flatnonzero(inside)) if not inside.all() else (),
    )
    texts = [str(motion) for motion in sols.self_motions]
    for text in dict.fromkeys(texts):
        which = [str(i + 1) for i, other in enumerate(texts) if other == text]
        page.add(f"{'Self-motion' if len(which) == 1 else 'Self-motions'} {', '.join(which)}: {text}.")
    few = rows_q[:16]
    page.add(
        picture(
            solutions_figure(arm, few, labels=labels[:16]),
            "The one solution."
            if len(few) == 1
            else f"The {'first ' if len(rows_q) > 16 else ''}{len(few)} solutions, each with the others as ghosts "
            "behind it. Postures that differ in the wrist alone look alike.",
            name,
            1.0,
        )
    )


def add_track(page: Document, arm: Arm, track: Track, *, prefix: str = "path") -> None:
    """Add a followed path: what happened, its figures, some of its points, all its branches."""
    N, first, last = len(track.path), track.path[0], track.path[-1]
    length = float(np.linalg.norm(np.diff(track.path[:, :3, 3], axis=0), axis=1).sum())
    page.add(
        f"The path leads from {pose_words(first)} to {pose_words(last)} in {N} points; it is {fixed(length * MM, 4)} "
        "mm long" + (f", {fixed(length / (N - 1) * MM, 5)} mm from point to point." if N > 1 else ".")
    )
    page.add(" ".join(track.explain().splitlines()))
    page.add(
        picture(path_figure(track), "The path in space with the tool's frame along it.", f"{prefix}-space", 0.66),
        picture(
            coordinates_figure(track), "The tool's coordinates against the point number.", f"{prefix}-coordinates", 0.78
        ),
    )
    if track.points:
        page.add(
            picture(joints_figure(track), "The joints against the point number.", f"{prefix}-joints", 0.8),
            picture(configuration_figure(arm, track), "The arm at the first and at the last point.", f"{prefix}-ends"),
            picture(path_figure(track, arm=arm), "The arm on its way, five postures of it.", f"{prefix}-swept", 0.66),
        )
        few = sorted(set(np.linspace(0, track.points - 1, min(track.points, 9)).round().astype(int).tolist()))
        rows = []
        for k in few:
            p = [fixed(v * MM, 2) for v in track.path[k, :3, 3]]
            q = [joint_value(arm, j, v, 3) for j, v in enumerate(track.followed[k])]
            rows.append([str(k + 1), *p, *q])
        worst = track.residual.max(0)
        page.table(
            ["point", "x, mm", "y, mm", "z, mm", *joint_heads(arm)],
            rows,
            f"Some of the points. Over all of them the tool misses the path by at most {scientific(worst[0] * MM)} mm "
            f"and {scientific(np.degrees(worst[1]))}°.",
        )
    if track.branches:
        rows = []
        for b in track.branches:
            end = "reaches the end" if b.stop is None else ", ".join(filter(None, (b.stop.cause, b.stop.joint)))
            mark = " (followed)" if b.index == track.chosen else ""
            rows.append([str(b.index + 1), b.label + mark, str(b.points), str(b.unlimited_points), fixed(b.s, 4), end])
        page.table(
            ["", "posture", "points", "without limits", "ends at s", "why"],
            rows,
            "Every branch that starts at the first pose: how many of the points it reaches inside the joint limits, "
            "how many it would reach without them, and what ends it.",
            left=(0, 1, 5),
            strong=() if track.chosen is None else (track.chosen,),
        )


def add_route(page: Document, route: Route, *, name: str = "route") -> None:
    """Add a route: its verdict, what closes each branch where there is none, and its map of path and turn."""
    reason, *more = route.explain().splitlines()
    page.add(f"The path leads from {pose_words(route.path[0])} to {pose_words(route.path[-1])}. {reason}")
    blocked = route.blocked
    if blocked is None:
        page.add(" ".join(more))
    else:
        page.add(blocked.why)
    if blocked is not None and blocked.closed:
        rows = []
        for closed in blocked.closed:
            slides = closed.joint in route.plan.names and route.plan.prismatic[route.plan.names.index(closed.joint)]
            scale, unit = (MM, "mm") if slides else (np.degrees(1.0), "°")
            values = [f"{fixed(v * scale, 3)} {unit}" for v in (closed.limit, closed.excess)]
            rows.append([closed.branch, closed.joint, closed.side, *values])
        page.table(
            ["posture", "joint", "side", "limit", "short by"],
            rows,
            "What closes each branch at that place: the joint that would pass a limit, and by how much at the best of "
            "the turns looked at.",
            left=(0, 1, 2),
        )
    if not (route.setting.turn_on_grid and route.free.turns):
        return
    if blocked is None:
        words = "the curve is the route, which goes on in another strip where its posture changes"
    else:
        words = "black is the place that nothing gets past; hatched, where everything was followed to it with proof"
    page.add(
        picture(route_figure(route), f"The open turns of the tool along the path, a strip a posture: {words}.", name)
    )


def add_motion(page: Document, arm: Arm, motion: Motion, words: str, *, name: str = "time") -> None:
    """Add a motion in time with its curves."""
    peak = np.abs(motion.dq).max(0)
    fastest = int(np.argmax(np.where([k == "R" for k in arm.joint_types], peak, 0)))
    page.add(
        f"{words} Every joint follows a quintic in time, at rest at both ends. The fastest is "
        f"{arm.joint_names[fastest]} with {fixed(np.degrees(peak[fastest]), 1)}°/s."
    )
    page.add(picture(time_figure(motion, arm=arm), "Joint positions, rates and accelerations over time.", name, 0.86))
