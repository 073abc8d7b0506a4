"""The search for the one slip that explains a wrong formula.

Every near formula and every near arm is tried, and what is right everywhere is kept.
"""

from __future__ import annotations

import time
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np

from pieper.algebra.arithmetics import NumpyField
from pieper.algebra.expression import Expr
from pieper.algebra.formula import Equation, has_branch, unordered
from pieper.judge.search.lookup import Lost, Shelf
from pieper.judge.search.required import required_values
from pieper.judge.search.shared import slips_in_shared
from pieper.judge.slips.slip import Slip
from pieper.kinematics.joints import short_way
from pieper.tolerances import FLOOR_OF_SEARCH, NEED_MET, ROUNDING, SEARCH_ARC, VALUE_TOLERANCE

MAX_SEARCHED = 4000  # nodes; a formula of several pages has more slips than anyone waits for
ENOUGH = 3  # of the probes; on another branch the value at a place is another one
PROBES = 12  # samples at which a candidate is tried first
MAX_LOST = 200  # nodes; in longer formulas a lost term is looked for by its letters only
LIKELY = 1.05  # cost of a slip that may be one of two at once
FIRST_OF_TWO = 400  # of them that are tried
NODES_OF_TWO = 5_000  # in all the formulas that are tried for a second slip


@dataclass
class Goal:
    """What a formula should give.

    Attributes:
        env: values of all symbols, (K,) each.
        wanted: (K,) right values; for an equation (``eq`` tree) it is left out and both sides are compared.
        angle: compare modulo a whole turn, and accept either sign of +-.
        floor: size below which a number counts as rounding of zero, before the relative tolerance.
    """

    env: dict[str, np.ndarray]
    wanted: np.ndarray | None = None
    angle: bool = False
    floor: float = FLOOR_OF_SEARCH

    @cached_property
    def _scale(self) -> np.ndarray:
        size = np.abs(0.0 if self.wanted is None else self.wanted)
        return size + np.median(size) + self.floor

    def restrict(self, rows: Any) -> Goal:
        """Return the same target on some of the samples only."""
        wanted = None if self.wanted is None else self.wanted[rows]
        return Goal({k: v[rows] for k, v in self.env.items()}, wanted, self.angle, self.floor)

    def residual(self, node: Expr, branch: int = 1, cache: dict | None = None, learn: bool = True) -> np.ndarray:
        """Return how far the formula is off at every sample, in units of the tolerance; inf where it is undefined."""
        with np.errstate(all="ignore"):
            if isinstance(node, Equation):
                left, right = (a.evaluate(self.env, NumpyField, branch, cache, learn) for a in node.args)
                off = np.abs(left - right) / (VALUE_TOLERANCE * (np.abs(left) + np.abs(right) + self.floor))
            else:
                gap = node.evaluate(self.env, NumpyField, branch, cache, learn) - self.wanted
                if self.angle:
                    off = np.abs(short_way(gap)) / SEARCH_ARC
                else:
                    off = np.abs(gap) / (VALUE_TOLERANCE * self._scale)
        off = np.broadcast_to(np.asarray(off, dtype=float), np.shape(self.env["theta1"]))
        return np.where(np.isfinite(off), off, np.inf)

    def fits(self, node: Expr, cache: dict | None = None, learn: bool = True) -> np.ndarray:
        """Say at which samples the formula is right, on either branch of its +-."""
        good = self.residual(node, 1, cache, learn) < 1
        if has_branch(node) and not good.all():
            good = good | (self.residual(node, -1, None) < 1)
        return good


@dataclass
class Explanation:
    """What a search found.

    Attributes:
        found: slips whose undoing makes the claim right at every sample, likeliest first.
        nearest: the slip that makes it right most often when none makes it right always, and how often.
        tried: how many variants of each kind were tried.
        complete: False when the time allowed ran out.
    """

    found: list[Slip] = field(default_factory=list)
    nearest: tuple[Slip, float] | None = None
    tried: dict[str, int] = field(default_factory=dict)
    complete: bool = True

    @property
    def best(self) -> Slip | None:
        """Return the likeliest explanation, or None."""
        return self.found[0] if self.found else None

    def closest(self, what: str) -> str:
        """Say which slip comes nearest, of joint vectors or of poses; "" when none comes near."""
        if not self.nearest:
            return ""
        return f"; closest: {self.nearest[0].says} (right at {100 * self.nearest[1]:z.0f}% of the {what})"


def search(
    goal: Goal,
    root: Expr,
    candidates: Iterable[Slip],
    *,
    lost: Lost | None = None,
    seconds: float = 2.0,
    pairs: bool = False,
) -> Explanation:
    """Try every candidate and keep those that are right at every sample.

    Args:
        goal: what the formula should give.
        root: the formula as printed; its subtrees are evaluated once and shared by the candidates.
        candidates: formulas one slip away.
        lost: what may be missing from the formula.
        seconds: time allowed.
        pairs: whether two slips at once are tried where no single one explains it.

    Returns:
        What was found and what was tried.
    """
    out = Explanation()
    if root.size() > MAX_SEARCHED:
        out.complete = False
        return out
    probe = goal.restrict(np.arange(min(PROBES, len(goal.env["theta1"]))))
    values: dict = {}
    probe.residual(root, 1, values)
    needed = required_values(root, probe.wanted, goal.angle, values)
    stop = time.thread_time() + seconds
    look = _Look(goal, float(np.mean(goal.fits(root))), out, of_one_letter=len(root.symbols()) == 1)
    likely: list[Slip] = []
    for k, slip in enumerate(candidates):
        out.tried[slip.kind] = out.tried.get(slip.kind, 0) + 1
        if k % 256 == 0 and time.thread_time() > stop:
            out.complete = False
            break
        if slip.cost < LIKELY and len(likely) < FIRST_OF_TWO:
            likely.append(slip)
        if _promising(slip, probe, needed, values, goal.angle):
            look.at(slip)
    if lost is not None and root.size() <= MAX_LOST and time.thread_time() < stop:
        look.stop = stop + seconds
        shelf = lost.shelf(probe.env, values)
        look.all(lost.slips(root, shelf, needed, values))
        if goal.angle and probe.wanted is not None:
            look.all(lost.angles(root, probe.wanted - values[root], probe.env))
        if not any(slip.cost <= LIKELY for slip in out.found):
            look.all(slips_in_shared(root, lost, shelf, probe.env, probe.wanted, values, angle=goal.angle))
        if pairs and not out.found:
            _two_at_once(look, probe, likely[: NODES_OF_TWO // root.size()], lost, shelf)
    out.found.sort(key=lambda s: (s.cost, s.tree.size()))
    return out


@dataclass
class _Look:
    """Slips looked at in full: those that make the formula right everywhere are kept."""

    goal: Goal
    share: float
    out: Explanation
    seen: set[str] = field(default_factory=set)
    stop: float = float("inf")
    #: A claim about one letter, as s2^2 + c2^2 = 1, can only be right for any value of it.
    of_one_letter: bool = False

    @cached_property
    def zero(self) -> frozenset[str]:
        """Names of what is zero at every sample."""
        return frozenset(name for name, value in self.goal.env.items() if not np.any(value))

    @property
    def late(self) -> bool:
        """Whether the time allowed is over."""
        return time.thread_time() > self.stop

    def at(self, slip: Slip) -> None:
        """Look at one."""
        share = float(np.mean(self.goal.fits(slip.tree)))
        if share == 1.0 and not self.of_one_letter and slip.kind != "atan" and says_nothing(slip.tree, self.zero):
            return
        text = unordered(slip.tree) if share == 1.0 else ""
        if share == 1.0 and text not in self.seen:
            self.seen.add(text)
            self.out.found.append(slip)
        elif self.share + 0.2 < share < 1.0:
            self.share = share
            self.out.nearest = (slip, share)
        elif self.out.nearest and share == self.out.nearest[1] and slip.cost < self.out.nearest[0].cost:
            self.out.nearest = (slip, share)

    def all(self, slips: Iterable[Slip]) -> None:
        """Look at some that were found by their value, while there is time."""
        for slip in slips:
            if self.late:
                self.out.complete = False
                return
            self.out.tried[slip.kind] = self.out.tried.get(slip.kind, 0) + 1
            self.at(slip)


def says_nothing(node: Expr, zero: frozenset[str] = frozenset()) -> bool:
    """Whether an equation is true of any values of its letters, as Px = Px is; some letters may be known to be zero."""
    if not isinstance(node, Equation):
        return False
    rng = np.random.default_rng(3)
    env = {name: rng.uniform(0.1, 2.0, 24) * (name not in zero) for name in sorted(node.symbols())}
    env.setdefault("theta1", rng.uniform(-3, 3, 24))
    return bool((Goal(env).residual(node) < 1).all())


def _two_at_once(look: _Look, probe: Goal, first: list[Slip], lost: Lost, shelf: Shelf) -> None:
    """Undo a likely slip, and look what else must change; the first pair that is right is kept with its equals."""
    for slip in first:
        if look.late or look.out.found:
            return
        tree, values = slip.tree, {}
        probe.residual(tree, 1, values)
        needed = required_values(tree, probe.wanted, probe.angle, values)
        second = lost.slips(tree, shelf, needed, values, any_slip=True)
        look.all(
            replace(s, kind="two slips", words=("{}, and {}", slip.says, s.says), cost=slip.cost + s.cost + 1)
            for s in second
        )


def _promising(slip: Slip, probe: Goal, needed: dict, values: dict, angle: bool) -> bool:
    """Say whether a candidate is right at some of the probes, as cheaply as the place allows."""
    need = needed.get(slip.path) if slip.path is not None else None
    if need is not None and not has_branch(slip.new):
        with np.errstate(all="ignore"):
            value = slip.new.evaluate(probe.env, NumpyField, 1, values, learn=False)
            close = np.abs(value - need) <= NEED_MET * (np.abs(value) + np.abs(need)) + ROUNDING
        return int(np.count_nonzero(close)) >= ENOUGH
    good = probe.residual(slip.tree, 1, values, learn=False) < 1
    if angle and has_branch(slip.tree):
        good = good | (probe.residual(slip.tree, -1) < 1)
    return int(np.count_nonzero(good)) >= ENOUGH
