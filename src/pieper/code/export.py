"""What every exported file holds beside the program: links, limits, self-test, provenance; and how it is written."""

from __future__ import annotations

import hashlib
import re
import warnings
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from pieper import arguments
from pieper.code.between import Between, between, solved_by
from pieper.code.labels import Labels, labels_of
from pieper.code.program import Program, recorded
from pieper.errors import InputError, PieperWarning, PlanError
from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.forward import fk
from pieper.kinematics.pose import checked_pose
from pieper.made_by import installed_version
from pieper.solver.plan.plan import Plan
from pieper.solver.plan.planned_arm import PlannedArm
from pieper.solver.rows import Flag
from pieper.solver.verbs import ik_many
from pieper.tolerances import LIMIT_SLACK, SAME_SOLUTION, VERIFIED

TESTS = 20
#: How many of them are poses rounded to so many digits after the point, as people write them down.
ROUNDED, DIGITS = 5, 6
#: Limits that lie further apart than this many half turns, or lengths of the arm, are not drawn from whole.
DRAWN = 10.0
#: C and MATLAB tell names apart by their first 63 letters, of which functions' endings take up to fifteen.
_LONGEST = 48
_WORD = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
LICENCE = "MIT licence, as pieper itself."


@dataclass(frozen=True, eq=False)
class Export:
    """Everything that a printer writes.

    Args:
        name: The prefix of functions, where a language needs one.
        plan: How the arm is solved.
        solved: The plan whose six joints are solved; another one where a linkage moves axes or joints are held.
        links: (axes + 1, 3, 4) constant links of the chain, m.
        slides: (axes,) which axes slide.
        lower: (n,) limits, rad or m, a rounding wider than said; infinite where there is none.
        upper: (n,) the same.
        q: (20, n) joint vectors of the self-test.
        T: (20, 4, 4) their poses, the last of them rounded where the arm holds rounded poses.
        counts: (20,) how many rows lie inside the limits there.
        header: Lines of provenance.
        verified: By how much a row may miss its pose, largest entry, where the program is unsure.
        between: What lies between the arm's joints and the six that are solved.
    """

    name: str
    plan: Plan
    solved: Plan
    links: Array
    slides: tuple[bool, ...]
    lower: Array
    upper: Array
    q: Array
    T: Array
    counts: tuple[int, ...]
    header: tuple[str, ...]
    verified: float
    between: Between

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.lower)

    @property
    def axis_count(self) -> int:
        """Number of axes, more than joints where a linkage moves some."""
        return len(self.slides)

    @property
    def joints_slide(self) -> tuple[bool, ...]:
        """(n,) which joints slide."""
        return self.slides if self.between.joints_slide is None else self.between.joints_slide

    @cached_property
    def program(self) -> Program:
        """From pose to rows, as a list of operations.

        Raises:
            PlanError: The family cannot be written so.
        """
        return recorded(self.solved)

    @cached_property
    def labels(self) -> Labels:
        """How its postures are named."""
        return labels_of(self.plan.uncoupled or self.plan)


def _refuse_what_is_no_formula(plan: Plan, solved: Plan) -> None:
    name = plan.name
    if plan.snapped:
        raise PlanError(f"{name}: its geometry was snapped, and the polishing that follows is a loop: give exact axes.")
    if solved.solver.ends is not None:
        raise PlanError(f"{name}: its base or tool is too far away to be written into one formula; take it off.")


def export(arm: PlannedArm, name: str) -> Export:
    """Return what is written of an arm.

    Raises:
        InputError: The name is none a language takes.
        PlanError: The arm cannot be exported.
    """
    if not isinstance(name, str) or not _WORD.fullmatch(name) or len(name) > _LONGEST:
        raise InputError(
            f"name must be a word of at most {_LONGEST} letters, digits and _ that begins with no digit, got "
            f"{arguments.kind_of(name)}.",
            given=name,
        )
    plan = arm.plan
    solved = solved_by(plan)
    _refuse_what_is_no_formula(plan, solved)
    own = between(plan)
    with warnings.catch_warnings():
        # limits far from zero were remarked where they were said; postures inside them are no news
        warnings.simplefilter("ignore", PieperWarning)
        q, T, counts = _postures(plan, own)
    made_by = f"pieper {installed_version()}".rstrip()
    coupling = np.zeros(0) if plan.chain.coupling is None else plan.chain.coupling
    said = np.ascontiguousarray(np.concatenate([plan.chain.links.ravel(), plan.limits.ravel(), coupling.ravel()]))
    header = (
        f"Inverse and forward kinematics of {' '.join(plan.name.split())}: every solution of a pose.",
        f"Written by {made_by} from its own kernel, family {solved.family}; do not edit.",
        f"Links, limits and couplings: sha256 {hashlib.sha256(said.tobytes()).hexdigest()[:16]}. Metres and radians.",
        f"Source of the numbers: {' '.join((arm.description.source or 'not said').split())}",
        LICENCE,
    )
    return Export(
        name,
        plan,
        solved,
        plan.chain.links[:, :3],
        tuple(bool(s) for s in plan.chain.sliding),
        plan.limits[:, 0] - LIMIT_SLACK,
        plan.limits[:, 1] + LIMIT_SLACK,
        q,
        T,
        counts,
        header,
        VERIFIED * max(1.0, plan.chain.length),
        own,
    )


def _postures(plan: Plan, own: Between) -> tuple[Array, Array, tuple[int, ...]]:
    """Return joint vectors (20, n) inside the limits, always the same, their poses, and how many rows lie there.

    The last poses are rounded, and their joint vectors are rows of the rotation nearest to what was rounded; of an arm
    that holds no rounded pose (one of five joints, for one) none is.
    """
    rng = np.random.default_rng(20)
    limits = _tried(plan)
    # six digits of a joint vector and twelve of what follows are enough for the test, and short in the file
    q = np.round(rng.uniform(limits[:, 0], limits[:, 1], (40 * TESTS, plan.n)), DIGITS)
    q = np.clip(q, *plan.limits.T)  # a joint may be held at half a turn, which no six digits are
    for j in own.fixed:
        q[:, j] = own.columns[j]
    T = np.round(fk(plan.chain, q), 12)
    count, clear, back = _asked(plan, q, T)
    clear &= np.abs(back - q).max(1) < 0.1 * SAME_SOLUTION  # not next to a singular one, where digits are lost
    some = np.flatnonzero(clear)[: 2 * ROUNDED]
    rounded = np.round(T[some], DIGITS)
    again, held, nearest = _asked(plan, q[some], rounded)
    # of an arm that was asked for less than a pose the whole of it is not what rows return
    meant = np.abs(fk(plan.chain, nearest) - checked_pose(rounded, batch=True)).max((1, 2)) < VERIFIED
    kept = np.flatnonzero(held & meant)[:ROUNDED]
    last = some[kept]
    first = np.setdiff1d(np.flatnonzero(clear), last)[: TESTS - len(last)]
    if not len(first) + len(last):
        raise PlanError(
            f"no posture of {plan.name} inside its limits is clear of singular ones, so its code would say unclear of "
            "every pose. Widen the limits of the joint that holds it there, or ask arm.ik.",
            arm=plan.name,
        )
    return (
        np.concatenate([q[first], np.round(nearest[kept], 12)]),
        np.concatenate([T[first], rounded[kept]]),
        tuple(int(k) for k in (*count[first], *again[kept])),
    )


def _tried(plan: Plan) -> Array:
    """Return where joint vectors are drawn (n, 2): inside the limits, a turn of those that are endless or far apart."""
    half = np.where(plan.prismatic, plan.chain.length, np.pi)
    lower, upper = plan.limits.T
    # the turn about zero, or, where the limits lie beyond it, the one that begins at the limit next to zero
    low = np.where(lower >= half, lower, np.where(upper <= -half, upper - 2 * half, -half))
    near = np.asarray(np.abs(plan.limits) <= DRAWN * half[:, None], np.bool_).all(axis=1, keepdims=True)
    window = np.stack([np.maximum(lower, low), np.minimum(upper, low + 2 * half)], 1)
    return np.where(near, plan.limits, window)


def _asked(plan: Plan, q: Array, T: Array) -> tuple[Array, Bools, Array]:
    """Return how many rows of poses lie inside (N,), at which there is a clear one, and the row nearest to q (N, n)."""
    locked = list(plan.reduction.locked)
    found = ik_many(plan, T, 1, q[:, locked] if locked else None, near=q)
    count = found.in_limits.sum(1)
    clear = ((found.flag & int(Flag.DEGENERATE | Flag.UNCERTAIN)) == 0) & (count > 0)
    return count, clear, found.nearest
