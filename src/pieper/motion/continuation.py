"""Carrying solutions along a path by continuity: predict with the Jacobian, match with the solver, halve when in doubt.

A step from one pose to the next is believed only when the solution found at the far end agrees with what the Jacobians
of *both* ends predict, is small, is clearly better than every other solution, and when the determinant of the Jacobian
keeps its sign: that changes where a singularity is crossed, and only there does one branch become another. Otherwise
the step is halved, down to `SMALLEST_STEP`. That is what keeps a fast but continuous swing (near a wrist singularity)
apart from a jump to another branch, whatever the spacing of the points.
"""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arrays import Array, Bools, Indices
from pieper.kinematics.newton import newton, pose_difference, scaled_jacobian
from pieper.kinematics.pose import rotation_vector
from pieper.motion.path import between
from pieper.solver.arm_rows import arm_rows
from pieper.solver.coupled import rows_of
from pieper.solver.plan.plan import Plan
from pieper.solver.rows import Flag, Rows
from pieper.solver.verbs import ik
from pieper.tolerances import (
    BRANCH_PASSED,
    BRANCH_ROUNDING,
    BRANCHES_MET,
    FOLLOWED_RANK,
    SINGULAR_EXAMINED,
    SINGULAR_POINT,
    TASK_RANK,
    VERIFIED,
)

#: A step (rad, or per length) above which it is halved whatever the prediction says.
LARGEST_STEP = 0.6
#: How far a step may depart from either prediction, as a fraction of the step.
AGREEMENT = 0.25
#: How much worse the second best solution must be.
CLEARANCE = 3.0
#: Where nearness decides, as a fraction of the spacing of the points.
SMALLEST_STEP = 2.0**-18
#: Where halving ends for those that not even nearness can decide: a swing within a hair of a singularity.
LAST_STEP = 2.0**-30
#: Steps allowed between two neighbouring points before a branch is given up as unresolved.
BUDGET = 600
#: Values of a spare joint at which a point is tried before it counts as out of reach.
SPARE_VALUES = 25


#: Picks the whole of a twist.
WHOLE = np.eye(6)
WHOLE.setflags(write=False)


class Continuation:
    """Everything needed to carry solutions of an arm along a path.

    Args:
        plan: How the arm is solved.
        path: (N, 4, 4) checked poses, m.
    """

    def __init__(self, plan: Plan, path: Array) -> None:
        self.plan = plan
        self.path = path
        self.chain = plan.chain
        self.revolute = ~plan.prismatic
        #: what counts as one of each joint: radians, and slides per characteristic length
        self.unit = plan.chain.joints.unit
        #: whether every pose has a continuum of solutions, so that none of them can be matched
        self.redundant = bool(plan.redundancy)
        self._rows, self._inside, self._special = self._solve(path)
        self._solved: dict[float, tuple[Array, bool]] = {}
        self._why: dict[float, str] = {}
        self._poses: dict[float, Array] = {}
        self._steps = 0
        self._last: tuple[float, Array, Array, Array] | None = None
        self._turned: tuple[float, float, Array] | None = None
        self._legs = self._twists(path[:-1], path[1:])

    # ------------------------------------------------------------------ what is known at a place on the path

    def pose(self, x: float) -> Array:
        """Return the pose (4, 4) at x points from the start; between the points lies the straight line."""
        k = int(np.floor(x))
        if k == x:
            return self.path[k]
        if x not in self._poses:
            self._poses[x] = between(self.path[k], self.path[k + 1], x - k)
        return self._poses[x]

    def solutions(self, x: float) -> tuple[Array, bool]:
        """Return all solutions (m, n) at x, limits not applied, and whether the pose is singular or redundant."""
        if x not in self._solved:
            k = int(np.floor(x))
            rows, _, special = (self._rows, None, self._special) if k == x else self._solve(self.pose(x)[None])
            self._solved[x] = rows[k if k == x else 0], bool(special[k if k == x else 0])
        return self._solved[x]

    def _solve(self, poses: Array) -> tuple[list[Array], Bools, Bools]:
        """Return for N poses their solutions (m, n), whether one lies inside the limits (N,), which are special (N,).

        The kernel's own rows are enough here: on a singularity they are true solutions, and which of a continuum they
        are does not matter, since a branch that comes to one is carried across it.
        """
        plan = self.plan
        chain = plan.uncoupled or plan
        if chain.direct:
            rows = Rows(*chain.solver.many(np.ascontiguousarray(poses), 1))
        else:
            rows = arm_rows(chain, poses, np.tile(plan.defaults, (len(poses), 1)), 1)
        if chain is not plan:
            rows = rows_of(plan, rows)
        special = ((rows.flags & np.uint8(Flag.DEGENERATE)) > 0) | self.redundant
        return (
            [row[ok] for row, ok in zip(rows.q, rows.valid, strict=True)],
            np.logical_or.reduce(rows.inside, axis=1),
            special,
        )

    @property
    def reachable(self) -> Bools:
        """(N,) whether a point has a solution inside the limits, at some value of a spare joint if there is one."""
        if not self.redundant:
            return self._inside
        plan, reachable = self.plan, self._inside.copy()
        lower, upper = plan.full_limits[plan.reduction.locked[0]]
        lower, upper = (lower, upper) if np.isfinite(lower) and np.isfinite(upper) else (-np.pi, np.pi)
        for value in np.linspace(lower, upper, SPARE_VALUES):
            values = np.tile(plan.defaults, (len(self.path), 1))
            values[:, 0] = value
            reachable |= arm_rows(plan, self.path, values, 1).inside.any(1)
        return reachable

    def why(self, x: float) -> str:
        """Return why the pose at x came out as it did, asked once."""
        if x not in self._why:
            self._why[x] = ik(self.plan, self.pose(x)).why
        return self._why[x]

    def gap(self, q: Array, start: Array) -> Array:
        """Return joint differences q - start (..., n) without units, angles by the shorter way round."""
        return self.chain.joints.difference(q, start)

    def _task_rows(self, T: Array) -> Array:
        """Return the matrix (r, 6) that picks what the task asks for from a twist, lengths per length of the arm."""
        if self.plan.task == "pose":
            return WHOLE
        rows = np.eye(6)
        if self.plan.task == "position":
            return rows[:3]
        rows[3:, 3:] = T[:3, :3].T
        return rows[:5]

    def _asked(self, x: float, twists: Array) -> Array:
        """Return the rows (r, ...) of twists (..., 6, ...) that the task asks for at x."""
        return twists if self.plan.task == "pose" else self._task_rows(self.pose(x)) @ twists

    def _twists(self, start: Array, end: Array) -> Array:
        """Return the twists (..., 6) from poses to poses (..., 4, 4), lengths per length of the arm."""
        move = (end[..., :3, 3] - start[..., :3, 3]) / self.chain.length
        turn = rotation_vector(end[..., :3, :3] @ np.swapaxes(start[..., :3, :3], -1, -2))
        return np.concatenate([move, turn], -1)

    def _twist(self, xa: float, xb: float) -> Array:
        if xb == xa + 1 and xa == int(xa):
            return self._legs[int(xa)]
        # asked at both ends of a step
        if self._turned is None or self._turned[:2] != (xa, xb):
            self._turned = xa, xb, self._twists(self.pose(xa), self.pose(xb))
        return self._turned[2]

    def _jacobian(self, q: Array, x: float) -> Array:
        """Return the scaled Jacobians (..., r, n) of joint vectors q (..., n) at x, rows as the task asks."""
        return self._asked(x, scaled_jacobian(self.chain, q))

    def _steps_of(self, J: Array, xa: float, xb: float) -> Array:
        """Return the scaled joint steps (..., n) that scaled Jacobians predict from xa to xb."""
        return np.linalg.pinv(J, rcond=TASK_RANK) @ self._asked(xa, self._twist(xa, xb))

    def _inverses(self, q: Array, x: float) -> tuple[Array, Array]:
        """Return pseudo-inverses (B, n, r) of scaled Jacobians of q (B, n) at x, and the side of a singularity (B,).

        Where one step ended, as a rule the next begins: that is not worked out again.
        """
        last = self._last
        if last is None or last[0] != x or not np.array_equal(last[1], q):
            J = self._jacobian(q, x)
            last = self._last = x, q.copy(), _inverse(J), _side(J)
        return last[2], last[3]

    def sides(self, q: Array) -> Array:
        """Return on which side (N,) of singularities joint vectors q (N, n) at the points lie, +1 or -1; 0 unknown."""
        return np.concatenate([_side(self._jacobian(q[k : k + 1], float(k))) for k in range(len(q))])

    # ------------------------------------------------------------------ steps

    def step(self, q: Array, xa: float, xb: float, loose: bool = False) -> tuple[Array, Bools]:
        """Step joint vectors q (B, n) from xa to xb; return where they go and whether that is beyond doubt (B,).

        When loose, at the smallest step, the nearest solution within `BRANCHES_MET` is taken without asking the
        Jacobian: it has no inverse where branches meet.
        """
        self._steps += 1
        found, _ = self.solutions(xb)
        if len(found) == 0:
            return q, np.zeros(len(q), bool)
        D = self.gap(found[None], q[:, None])
        size = np.linalg.norm(D, axis=-1)
        if loose:
            best = np.argmin(size, axis=1)
            d = np.take_along_axis(D, best[:, None, None], 1)[:, 0]
            return q + d * self.unit, size[np.arange(len(q)), best] <= BRANCHES_MET
        back, side = self._inverses(q, xa)
        forward = back @ self._asked(xa, self._twist(xa, xb))
        miss = np.linalg.norm(D - forward[:, None], axis=-1)
        best = np.argmin(miss, axis=1)
        rows = np.arange(len(q))
        d = D[rows, best]
        step = size[rows, best]
        stepped = q + d * self.unit
        back, side_there = self._inverses(stepped, xb)
        backward = back @ self._asked(xa, self._twist(xa, xb))
        allowed = AGREEMENT * step + BRANCH_ROUNDING
        sure = (miss[rows, best] <= allowed) & (np.linalg.norm(d - backward, axis=-1) <= allowed)
        sure &= np.abs(d).max(-1) <= LARGEST_STEP
        if len(found) > 1:
            others = miss.copy()
            others[rows, best] = np.inf
            sure &= others.min(1) >= CLEARANCE * miss[rows, best] + BRANCH_ROUNDING
        counts = np.bincount(best, minlength=len(found))
        sure &= counts[best] == 1
        sure &= side == side_there
        return stepped, sure

    def is_singular(self, q: Array, x: float) -> bool:
        """Return whether the Jacobian at a joint vector q (n,) has lost rank."""
        sigma = np.linalg.svd(self._jacobian(q, x), compute_uv=False)
        return bool(sigma[-1] < SINGULAR_POINT * sigma[0])

    def nearly_singular(self, q: Array, x: float) -> bool:
        """Return whether a joint vector q (n,) at x lies on a singularity, but for how exactly x is known."""
        sigma = np.linalg.svd(self._jacobian(q, x), compute_uv=False)
        return bool(sigma[-1] < (SINGULAR_EXAMINED if x == int(x) else BRANCH_PASSED) * sigma[0])

    def predict(self, q: Array, xa: float, xb: float) -> Array:
        """Return where the Jacobian sends a joint vector q (n,) from xa to xb, with the least joint motion."""
        return q + self._steps_of(self._jacobian(q, xa), xa, xb) * self.unit

    def carry(self, q: Array, xa: float, xb: float) -> tuple[Array, Array, Array, Bools]:
        """Carry joint vectors q (B, n) from xa to xb.

        Returns:
            (B, n) where they got to; (B,) the place they got to, xb for those that arrived; (B,) where they met
            a singularity on the way, -1 where they did not; (B,) whether the budget of steps ran out.
        """
        self._steps = 0
        q, place = q.copy(), np.full(len(q), float(xa))
        met, unresolved = np.full(len(q), -1.0), np.zeros(len(q), bool)
        self._carry(q, place, met, unresolved, np.arange(len(q)), xa, xb)
        return q, place, met, unresolved

    def _carry(
        self, q: Array, place: Array, met: Array, unresolved: Bools, group: Indices, xa: float, xb: float
    ) -> None:
        stepped, sure = self.step(q[group], xa, xb)
        q[group[sure]] = stepped[sure]
        place[group[sure]] = xb
        doubtful = group[~sure]
        if len(doubtful) == 0:
            return
        if xb - xa <= SMALLEST_STEP:
            stepped, close = self.step(q[doubtful], xa, xb, loose=True)
            arrived = doubtful[close]
            q[arrived], place[arrived], met[arrived] = stepped[close], xb, xa
            doubtful = doubtful[~close]
            if len(doubtful) == 0 or xb - xa <= LAST_STEP:
                return
        if self._steps > BUDGET:
            unresolved[doubtful] = True
            return
        middle = xa + (xb - xa) / 2
        if self.solutions(middle)[1]:
            middle = xa + (xb - xa) * 0.4637
        self._carry(q, place, met, unresolved, doubtful, xa, middle)
        onward = doubtful[place[doubtful] == middle]
        if len(onward):
            self._carry(q, place, met, unresolved, onward, middle, xb)

    def project(self, q: Array, x: float) -> tuple[Array, bool]:
        """Move a joint vector q (n,) onto the solutions at x by the smallest steps (Newton, minimum norm).

        This is how a point of a self-motion is chosen: the one nearest to where the arm already is.

        Returns:
            (n,) joint vector, and whether forward kinematics confirms it.
        """
        T = self.pose(x)
        rows = None if self.plan.task == "pose" else self._task_rows(T)  # of a whole pose the kernel does it
        q = newton(self.chain, q, T, cutoff=FOLLOWED_RANK, max_step=np.inf, rows=rows)
        return q, bool(self.residual(q, x) <= VERIFIED)

    def residual(self, q: Array, x: float) -> float:
        """Return how far forward kinematics of q (n,) misses the pose at x, task rows only, per length and rad."""
        T = self.pose(x)
        return float(np.abs(self._task_rows(T) @ pose_difference(self.chain, q, T)).max())

    def residuals(self, q: Array) -> Array:
        """Return (k, 2) metres and radians by which q (k, n) misses the first k points, as far as the task asks."""
        return self.plan.residual(q, self.path[: len(q)])


def _inverse(J: Array) -> Array:
    """Return the pseudo-inverses (..., n, r) of Jacobians (..., r, n), of rank as `TASK_RANK` sees it."""
    if J.shape[-1] == J.shape[-2]:
        try:
            back: Array = np.asarray(np.linalg.inv(J), np.float64)
        except np.linalg.LinAlgError:
            pass
        else:
            # the product of both norms is at least the condition number: below it nothing is cut, and this is the same
            size = np.linalg.norm(J, axis=(-2, -1)) * np.linalg.norm(back, axis=(-2, -1))
            if np.all(size < 1 / TASK_RANK):
                return back
    return np.asarray(np.linalg.pinv(J, rcond=TASK_RANK), np.float64)


def _side(J: Array) -> Array:
    """Return on which side (...) of the singularities Jacobians (..., r, n) lie, +1 or -1; 0 when not square."""
    return np.sign(np.linalg.det(J)) if J.shape[-1] == J.shape[-2] else np.zeros(J.shape[:-2])
