"""The page's routes: a line with something left free becomes a `Route`, its map, and steps of a program."""

from __future__ import annotations

import base64
import re
import threading
from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

import pieper
from pieper.tolerances import ROUTE_STRAYS_M, ROUTE_STRAYS_RAD, TINY
from pieper.workbench import around
from pieper.workbench.messages import MAX_POINTS, Refused, number, optional, pose, vector, whole, word

COSTS = ("motion", "time")
AXES = ("x", "y", "z")
#: Poses of a spline that stands for a route, tried from few to many.
KNOTS = (4, 8, 16, 32, 64)
#: What postures are called where an arm has no names for them: a number among the rows of one pose, which is no branch.
#: An arm with joints to spare has thousands.
NUMBERED = re.compile(r"solution \d+")
UNNAMED = "all postures"
Progress = Callable[[dict[str, Any]], None]


def freedom_of(given: object) -> pieper.Freedom:
    """Return what a page leaves free: {turn: "free" or [lo, hi], cone, axis}, rad."""
    if not isinstance(given, dict):
        raise Refused("free must be an object of turn, cone and axis.")
    turn = given.get("turn", "free")
    interval = "free" if turn == "free" else vector(turn, 2, "free, turn")
    return pieper.Freedom(
        turn=interval if isinstance(interval, str) else (float(interval[0]), float(interval[1])),
        cone=number(given.get("cone", 0), "free, cone"),
        axis=word(given.get("axis", "z"), "free, axis", AXES),
    )


def _path(message: dict[str, Any]) -> npt.NDArray[np.float64]:
    n = whole(message.get("n"), "N", 2, MAX_POINTS)
    return pieper.line(pose(message.get("T0"), "start pose"), pose(message.get("T1"), "end pose"), n=n)


def route_of(arm: pieper.Arm, message: dict[str, Any]) -> pieper.Route:
    """Return the route that a message asks for."""
    free = freedom_of(message.get("free"))
    clearance = number(message.get("clearance", 0), "clearance")
    scene = around.scene_of(message.get("world") or [])
    return arm.route(
        _path(message),
        free,
        start=optional(vector, message.get("start"), arm.n, "start"),
        end=optional(vector, message.get("end"), arm.n, "end"),
        cost=word(message.get("cost", "motion"), "cost", COSTS),
        singularity=number(message.get("singularity", 0), "singularity"),
        turn_rate=optional(number, message.get("turn_rate"), "turn rate"),
        clearance=clearance,
        scene=scene if len(scene) else None,
    )


def run(arm: pieper.Arm, message: dict[str, Any], progress: Progress, stop: threading.Event) -> dict[str, Any]:
    """Return a route with its map, its verdict in words, and where it is shut."""
    progress({"note": "Looking at every branch and every turn …"})
    route = route_of(arm, message)
    known = None
    if route.free.turns:
        try:
            known = route.map
        except pieper.InputError:  # the arm's own joints decide the turn: there is no map of it
            known = None
    if stop.is_set():
        return {"stopped": True}
    labels = [_told(label) for label in route.labels]
    packed = None if known is None else _packed(known)
    branches = list(dict.fromkeys([*(packed["branches"] if packed is not None else ()), *labels]))
    at = {label: k for k, label in enumerate(branches)}
    return {
        "verdict": route.verdict.name,
        "found": route.found,
        "text": route.explain(),
        "points": route.path[:, :3, 3].tolist(),
        "s": route.s.tolist(),
        "q": route.q.tolist(),
        "turn": route.turn.tolist(),
        "tilt": route.tilt.tolist(),
        "labels": [at[label] for label in labels],
        "branches": branches,
        "cost": float(route.cost) if route.found else None,
        "bound": float(route.bound),
        "map": packed,
        "blocked": None if route.blocked is None else _blocked(route.blocked),
    }


def _packed(known: Any) -> dict[str, Any]:
    """Return a map with its open cells as bits, one string a branch: station after station, turn after turn."""
    open_at: dict[str, npt.NDArray[np.bool_]] = {}
    for name, cells in zip(known.branches, known.open, strict=True):
        told = _told(name)
        open_at[told] = open_at[told] | cells if told in open_at else cells
    bits = [base64.b64encode(np.packbits(cells.ravel()).tobytes()).decode("ascii") for cells in open_at.values()]
    return {"s": known.s.tolist(), "turn": known.turn.tolist(), "branches": list(open_at), "open": bits}


def _told(label: str) -> str:
    """Return the name of a branch, one for all that have only numbers."""
    return UNNAMED if NUMBERED.fullmatch(label) else label


def _blocked(blocked: Any) -> dict[str, Any]:
    closed = [
        {"branch": c.branch, "joint": c.joint, "side": c.side, "limit": float(c.limit), "excess": float(c.excess)}
        for c in blocked.closed
    ]
    return {"s": [float(v) for v in blocked.s], "why": blocked.why, "closed": closed}


def others(arm: pieper.Arm, message: dict[str, Any], progress: Progress, stop: threading.Event) -> dict[str, Any]:
    """Return the cheapest routes by the posture they begin with; of a blocked one, what would let it through."""
    progress({"note": "Looking for others …"})
    route = route_of(arm, message)
    if stop.is_set():
        return {"stopped": True}
    if route.blocked is not None:
        return {"relaxations": [str(r) for r in route.blocked.relaxations], "alternatives": []}
    ways = [
        {"branch": _told(a.branch), "cost": float(a.cost), "q": a.q[0].tolist(), "turn": float(a.turn[0])}
        for a in route.alternatives
    ]
    return {"relaxations": [], "alternatives": ways}


def posture(arm: pieper.Arm, message: dict[str, Any]) -> dict[str, Any]:
    """Return the posture at an end of the line with the tool turned by an angle: on a branch, nearest to `near`."""
    free = freedom_of(message.get("free"))
    turn = number(message.get("turn"), "turn")
    T = free.turned(pose(message.get("T"), "pose"), np.asarray(turn))
    near = vector(message.get("near"), arm.n, "near")
    solutions = arm.ik(T)
    if not len(solutions):
        return {"q": None, "label": None, "why": solutions.why}
    wanted = optional(word, message.get("branch"), "branch")
    rows = solutions.windings()
    gap = arm.chain.joints.apart(rows[:, None], solutions.q[None])
    labels = np.array(solutions.labels)[gap.argmin(1)]
    mine = np.flatnonzero(labels == wanted) if wanted in labels else np.arange(len(rows))
    best = mine[int(np.argmin(np.linalg.norm(rows[mine] - near, axis=1)))]
    return {"q": rows[best].tolist(), "label": _told(str(labels[best])), "why": ""}


def to_program(arm: pieper.Arm, message: dict[str, Any], progress: Progress, stop: threading.Event) -> dict[str, Any]:
    """Return the steps of a program that goes a route: the joints to its first posture, a spline through its poses.

    A spline goes through what it is given and its own way between: as many poses are given as it takes to stay within
    ROUTE_STRAYS_M and ROUTE_STRAYS_RAD of the route's own; by how much it strays is measured and said.
    """
    progress({"note": "Writing it as steps …"})
    route = route_of(arm, message)
    if not route.found:
        raise Refused("There is no route to send: " + route.reason)
    poses = arm.fk(route.q)
    best: tuple[float, float, npt.NDArray[np.intp]] | None = None
    for count in KNOTS:
        if stop.is_set():
            return {"stopped": True}
        knots = np.unique(np.linspace(0, len(poses) - 1, min(count + 1, len(poses))).round().astype(np.intp))[1:]
        if len(knots) < 2:
            knots = np.array([len(poses) - 1], np.intp)
        metres, radians = _strays(arm, route, poses, knots)
        if best is None or (metres, radians) < best[:2]:
            best = metres, radians, knots
        if (metres <= ROUTE_STRAYS_M and radians <= ROUTE_STRAYS_RAD) or len(knots) == len(poses) - 1:
            break
    assert best is not None
    metres, radians, knots = best
    through = [T.ravel().tolist() for T in poses[knots]]
    step = {"kind": "spline", "through": through, "T": through[-1], "blend": 0}
    if len(through) < 2:
        step = {"kind": "line", "T": through[-1], "blend": 0}
    first = {"kind": "joint", "q": route.q[0].tolist(), "T": poses[0].ravel().tolist(), "blend": 0}
    return {"steps": [first, step], "metres": metres, "radians": radians, "poses": len(knots)}


def _strays(
    arm: pieper.Arm, route: pieper.Route, poses: npt.NDArray[np.float64], knots: npt.NDArray[np.intp]
) -> tuple[float, float]:
    """Return by how much a spline through some poses of a route leaves it: m from its line, rad at the joints worst."""
    limits = pieper.Limits(speed=np.ones(arm.n), acceleration=np.full(arm.n, 10.0))
    program = pieper.Program(arm, limits, start=route.q[0])
    try:
        if len(knots) > 1:
            program.move_s(poses[knots])
        else:
            program.move_l(poses[knots[-1]])
    except pieper.PieperError:
        return np.inf, np.inf
    q = program.motion(rate=200).q
    p, points = arm.fk(q)[:, :3, 3], route.path[:, :3, 3]
    return float(_off(p, points).max()), float(_off(q, route.q).max())


def _off(x: npt.NDArray[np.float64], chain: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """Return the distance (k,) of points x (k, d) from a chain of straight pieces (N, d)."""
    along = np.diff(chain, axis=0)
    size = np.maximum((along**2).sum(1), TINY)
    out = np.empty(len(x))
    for k, point in enumerate(x):
        share = np.clip(((point - chain[:-1]) * along).sum(1) / size, 0, 1)
        out[k] = np.sqrt((((chain[:-1] + share[:, None] * along) - point) ** 2).sum(1).min())
    return out


QUICK: dict[str, Callable] = {"route_posture": posture}
LONG: dict[str, Callable] = {"route": run, "route_others": others, "route_program": to_program}
