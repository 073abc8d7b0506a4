"""The smallest change that lets a route through where there is none: a wider limit, a cone, the path moved."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.motion.route.along_front import search_on_front
from pieper.motion.route.freedom import Freedom
from pieper.motion.route.result import Closed, Relaxation
from pieper.motion.route.search import Task, leads, search, stations
from pieper.motion.route.setting import Setting, limits_of_axes, setting

#: The largest changes that are tried: of a limit (rad), of a cone (rad), of the path's place (lengths of the arm).
WIDEST, WIDEST_CONE, FARTHEST = np.pi, np.radians(40.0), 0.3
#: How often a change is halved, and how many joints are tried.
HALVINGS, JOINTS = 5, 2
#: What was found is made smaller by routes themselves, between it and one of so many parts of it, until what lets none
#: through is nearer than `NEARLY`.
PARTS, PARTS_CONE, NEARLY = 1000, 20, 1.01
#: Points of the path that are looked at to see whether a change lets a route through; the change found is tried whole.
POINTS = 26
#: Changes that a ladder shows are tried this much larger; those that a route shows are told a little larger.
ROOM, TOLD = 1.02, 1.002
#: Part of a change that is tried with all ladders in the end, and again while it lets a route through.
LESS = 0.985


@dataclass(frozen=True, eq=False)
class Opening:
    """What is needed to look for changes.

    Attributes:
        task: What the route was to be like.
        closed: What closes the branches at the place that was not passed.
    """

    task: Task
    closed: tuple[Closed, ...]

    def __call__(self) -> tuple[Relaxation, ...]:
        """Return the smallest change of each kind that lets a route through, where one was found."""
        found = [self._limit(c) for c in self._joints()]
        found += [self._shift()] if all(end is None for end in self.task.ends) else []
        found.append(self._cone())
        return tuple(r for r in found if r is not None)

    def _joints(self) -> list[Closed]:
        seen: dict[tuple[str, str], Closed] = {}
        for closed in self.closed:
            if closed.joint in self.task.setting.plan.names:
                seen.setdefault((closed.joint, closed.side), closed)
        return list(seen.values())[:JOINTS]

    def _limit(self, closed: Closed) -> Relaxation | None:
        world = self.task.setting
        j, side = world.plan.names.index(closed.joint), ("lower", "upper").index(closed.side)
        sliding = bool(world.plan.prismatic[j])

        def wider(amount: float) -> Task:
            limits = world.plan.limits.copy()
            limits[j, side] += amount * (1 if side else -1)
            plan = replace(world.plan, limits=limits)
            curves = replace(world.curves, limits=limits_of_axes(plan.chain.coupling, limits))
            rows = plan if world.rows is world.plan else curves
            return replace(self.task, setting=replace(world, plan=plan, curves=curves, rows=rows))

        amount = _least(wider, WIDEST * (world.chain.length if sliding else 1.0), closed.excess)
        if amount is None:
            return None
        told = f"{amount * 1e3:.4g} mm" if sliding else f"{np.degrees(amount):.4g} deg"
        return Relaxation(
            "limit",
            amount,
            closed.joint,
            f"With the {closed.side} limit of {closed.joint} {told} wider there is a route.",
        )

    def _cone(self) -> Relaxation | None:
        world = self.task.setting
        if not world.turns or self.task.turn_step is not None:
            return None

        def tilted(amount: float) -> Task:
            free = Freedom(turn=world.free.turn, cone=world.free.cone + amount, axis=world.free.axis)
            return replace(self.task, setting=setting(world.plan, world.curves, free, world.asked, world.s))

        if any(end is not None for end in self.task.ends):
            return None
        most = min(WIDEST_CONE, np.pi / 2 - world.free.cone - 0.02)
        amount = _least(tilted, most, 0.0, halvings=3, parts=PARTS_CONE)
        if amount is None:
            return None
        told = np.degrees(world.free.cone + amount)
        return Relaxation(
            "cone",
            amount,
            "tool",
            f"With a cone of {told:.3g} deg for the tool's {world.free.axis} axis there is a route.",
        )

    def _shift(self) -> Relaxation | None:
        world = self.task.setting
        best: tuple[float, str] | None = None
        for axis, name in enumerate("xyz"):
            for sign in (1.0, -1.0):

                def moved(amount: float, axis: int = axis, sign: float = sign) -> Task:
                    asked, path = world.asked.copy(), world.path.copy()
                    asked[:, axis, 3] += sign * amount
                    path[:, axis, 3] += sign * amount
                    return replace(self.task, setting=replace(world, asked=asked, path=path))

                most = FARTHEST * world.plan.chain.length if best is None else best[0]
                amount = _least(moved, most, 0.0)
                if amount is not None and (best is None or amount < best[0]):
                    best = (amount, f"{'+' if sign > 0 else '-'}{name}")
        if best is None:
            return None
        return Relaxation(
            "shift",
            best[0],
            best[1],
            f"With the path moved by {best[0] * 1e3:.4g} mm along {best[1]} there is a route.",
        )


def _least(
    changed: Callable[[float], Task],
    most: float,
    least: float,
    halvings: int = HALVINGS,
    parts: int = PARTS,
) -> float | None:
    """Return the smallest change up to `most` with which there is a route, nearly; None where there is none."""
    if not _opens(changed(most)):
        return None
    low, high = least, most
    for _ in range(halvings):
        middle = (low + high) / 2
        if _opens(changed(middle)):
            high = middle
        else:
            low = middle

    def opens(amount: float) -> bool:
        task = changed(amount)
        if search(task, 1) is not None:
            return True
        # with a scene the front takes ten times as long as all of the ladders, and a cure is told nearly anyway
        return not task.keep.anything and search_on_front(task) is not None

    for amount in (high * ROOM, min(2 * high, most), most):
        if opens(amount):
            found = _smaller(opens, float(amount), least, parts)
            # the first ladder alone was asked so far: finer ones may lead through where it does not
            while found * LESS > least and search(changed(found * LESS)) is not None:
                found *= LESS
            return found
    return None


def _smaller(opens: Callable[[float], bool], amount: float, least: float, parts: int) -> float:
    """Return a change below one that lets a route through, which does too: even turns see only large ones."""
    low, high = max(least, amount / parts), amount
    while high > NEARLY * low:
        middle = float(np.sqrt(low * high))
        if opens(middle):
            high = middle
        else:
            low = middle
    return high * TOLD if high * TOLD < amount and opens(high * TOLD) else high


def _opens(task: Task) -> bool:
    """Whether a ladder leads along some of the points; what it found is not made short, and looked at whole later."""
    return leads(_thinned(task))


def _thinned(task: Task) -> Task:
    world: Setting = task.setting
    at = stations(len(world.path), POINTS)
    step: Array | None = task.turn_step
    if step is not None:
        travelled: Array = np.append(0.0, np.cumsum(step))
        step = np.diff(travelled[at])
    thin = replace(world, path=world.path[at], asked=world.asked[at], s=world.s[at])
    return replace(task, setting=thin, turn_step=step)
