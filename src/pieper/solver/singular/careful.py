"""The careful look for any plan without spare joints: short arms and partial tasks through their virtual joints."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace

import numpy as np

from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.bounded import nearer
from pieper.kinematics.chain import Chain
from pieper.kinematics.newton import missed, newton, singular_values, size_of
from pieper.solver.arm_rows import arm_rows
from pieper.solver.families import named
from pieper.solver.plan.plan import Plan
from pieper.solver.plan.six_joints import sample_joints
from pieper.solver.rows import Flag
from pieper.solver.singular.examine import HOLDS, SLOW_STEPS, examine, side_steps
from pieper.solver.singular.examined import Examined
from pieper.solver.singular.four_parallel import about_four_parallel
from pieper.solver.singular.merged_roots import few_apart
from pieper.solver.singular.self_motion import FREE, SelfMotion
from pieper.solver.singular.trace import second_smallest
from pieper.tolerances import (
    CLEARLY_REGULAR,
    CROSSING_FOUND,
    HOLDS_EXACTLY,
    NEAR_INSIDE,
    NEARLY_HELD,
    PRECISE_RANK,
    SAME_AFTER_CUT,
    SAME_ROW,
    SAME_VOUCHED,
    SINGULAR_TO_ROUNDING,
    SLOW_RANK,
    SURE_ASIDE,
    UNFOLDING_WIDEST,
)

#: Postures all over the joints' ranges from which a singular pose is sought that nothing else leads to.
ALL_OVER = 80
#: Poses beside one that vouch for it. A double root shows on one side of its fold alone, so that one that neither the
#: rows nor other starts lead to hides from all of them in one of 2**6 directions.
VOUCHING = 6
#: Places along a self-motion beside which poses are taken that may vouch.
PLACES = (0.06, 0.31, 0.57, 0.83)


def near_rows(plan: Plan, poses: Array) -> Array:
    """Return the joint vectors (m, k) of all solutions of poses (N, 4, 4), the task's virtual joints included.

    Virtual joints that must come out as zero may have any value: on a singularity of the six-joint chain they are free.
    So the arm is solved as it is filled up in other ways too; and where its own eliminations vanish, arms beside it.
    """
    rows = plan.solver.all_rows(poses)[:, plan.reduction.real]
    others = [solver.all_rows(poses)[:, real] for solver, real in plan.refilled]
    others += [solver.all_rows(poses) for solver in plan.arms_beside]
    return np.concatenate([rows, *others]) if others else rows


def every_solution(plan: Plan, T: Array, rows: Array) -> Examined:
    """Return all there is at a pose, of the arm's own joints.

    Args:
        plan: A plan without spare joints.
        T: (4, 4).
        rows: (k, n) solutions already known.
    """
    # values of the virtual joints are not known of given rows: all are solved for again
    full, own = plan.exact.full, plan.exact.full.n == plan.n
    known = rows if own and not plan.reduction.fill else _holding(plan, T)
    most = plan.max_solutions if own else None
    known = np.concatenate([rows, known]) if own and known is not rows else known
    found = looked_at(plan, T, known, most=most)
    if found.self_motions or not len(found.q) or regular(plan, found.q):
        # a self-motion that leaves poses beside in one and the same direction has no point near any of them
        anywhere = _from_all_over(full, T)
        more = anywhere[~_is_told(plan, found, anywhere)]
        found = looked_at(plan, T, np.concatenate([known, more]), most=most) if len(more) else found
    elif own and len(rows) == len(found.q) == plan.max_solutions and not _merged(plan, found.q):
        # rounding may leave open whether a root is two that both are rows: of as many as there can be each is one
        found = replace(found, multiplicity=np.ones(len(rows), np.int64))
    return (found if own else _own(plan, T, found)).within(plan.max_solutions)


def _merged(plan: Plan, rows: Array) -> bool:
    """Whether an elimination gave rows (m, n) of which one is singular to rounding: a simple one is to half the digits.

    Of as many rows as there can be none is merged: they are points of a curve. Closed forms tell roots apart there.
    """
    if not named(plan.family).eliminating:
        return False
    s = singular_values(plan.chain, rows)
    return bool(np.any(s[:, -1] < SINGULAR_TO_ROUNDING * s[:, 0]))


def left_open(plan: Plan, T: Array) -> bool:
    """Whether a pose without solutions may have one all the same, beside a posture where two directions are free.

    Newton's method stalls there, and descents come no nearer to the pose than rounding of the squares lets them. Where
    the posture has four parallel axes it was solved for in closed form.
    """
    full = plan.exact.full
    q, _ = _descended(full, T)
    q = q[missed(full, q, T) < NEARLY_HELD * size_of(full, T)]
    q = q[~about_four_parallel(full, q)]
    return bool(np.any(second_smallest(full, q) < CROSSING_FOUND)) if len(q) else False


def _descended(full: Chain, T: Array) -> tuple[Array, Array]:
    """Return where descents to T from postures all over the joints' ranges end (m, joints), and what is left (m,)."""
    return nearer(full, sample_joints(full, ALL_OVER), T, np.tile(FREE, (full.n, 1)), np.ones(ALL_OVER), SLOW_STEPS)


def _from_all_over(full: Chain, T: Array) -> Array:
    """Return joint vectors (m, joints) that hold T, from postures all over the joints' ranges."""
    q, left = _descended(full, T)
    q = q[left < NEAR_INSIDE**2]
    q = newton(full, q, T, steps=SLOW_STEPS, cutoff=PRECISE_RANK)
    # next to a self-motion whole curves nearly hold the pose: what no kernel gave must hold it to rounding
    return q[missed(full, q, T) < HOLDS_EXACTLY * size_of(full, T)]


def _is_told(plan: Plan, found: Examined, q: Array) -> Bools:
    """Return which joint vectors q (m, joints) are one of the rows found or lie on a self-motion."""
    told = np.zeros(len(q), bool)
    if len(found.q):
        told |= plan.exact.full.joints.apart(q[:, None], found.q[None]).min(1) < SAME_VOUCHED
    for motion in found.self_motions:
        told |= motion.distances(q) < UNFOLDING_WIDEST  # where it is crossed its points are known as little
    return told


def looked_at(
    plan: Plan, T: Array, known: Array, near: Callable[[Plan, Array], Array] = near_rows, most: int | None = None
) -> Examined:
    """Return all there is at a pose of the arm's and the task's joints, of which rows (k, joints) are known.

    Args:
        plan: A plan without spare joints.
        T: (4, 4).
        known: (k, joints) what to begin with.
        near: Gives the joint vectors to begin with near poses (N, 4, 4).
        most: How many isolated solutions there are at the most, where that is known.
    """
    return examine(
        plan.exact.full,
        T,
        known,
        lambda poses: near(plan, poses),
        plan.full_limits,
        plan.full_names,
        shown=plan.n,
        # closed forms lose nothing next to a self-motion: only what an elimination gives is searched for more
        hiding=named(plan.family).eliminating,
        most=most,
    )


def _holding(plan: Plan, T: Array) -> Array:
    """Return what of the rows at a pose holds it: virtual joints that must be zero are put there, the others follow."""
    full, rows = plan.exact.full, near_rows(plan, T[None])
    if plan.reduction.fill:
        rows = newton(full, rows, T, steps=SLOW_STEPS, cutoff=SLOW_RANK)
        rows = rows[missed(full, rows, T) < HOLDS]
    return rows


def _own(plan: Plan, T: Array, found: Examined) -> Examined:
    """Cut the virtual joints off: curves that move only those are points, and points that differ in them are one."""
    moving = [i for i, motion in enumerate(found.self_motions) if motion.free]
    index = np.array([moving.index(i) if i in moving else -1 for i in found.self_motion], np.int64)
    q = found.q[:, : plan.n]
    keep = plan.chain.joints.distinct(q, SAME_AFTER_CUT)
    alone = keep[index[keep] < 0]
    few = few_apart(plan.chain, q[alone], missed(plan.exact.full, found.q[alone], T), plan.max_solutions)
    keep = np.sort(np.concatenate([keep[index[keep] >= 0], alone[few]]))
    motions = tuple(found.self_motions[i] for i in moving)
    return Examined(q[keep], index[keep], found.multiplicity[keep], found.direction[keep, : plan.n], motions)


def clear(plan: Plan, rows: Array) -> bool:
    """Whether all rows are far enough from singular ones that nothing merges there and no self-motion passes.

    Closed forms mark poses generously. Twins of a root at sigma lie about 2 sigma apart, which they tell apart well
    above 1e-8; a self-motion needs sigma to vanish. The general kernel marks poses where its elimination itself is
    nearly singular, and there clear rows say nothing about those that it may have lost; nor do they where a virtual
    joint that must be zero may be free.
    """
    six_alone = plan.task == "pose" and not plan.reduction.fill and not named(plan.family).eliminating
    if not six_alone or not len(rows) or len(rows) % 2:
        return False
    return regular(plan, rows)


def regular(plan: Plan, rows: Array) -> bool:
    """Whether all rows (m, n) are far enough from singular ones that none is a double root or on a self-motion."""
    s = singular_values(plan.chain, rows[:, : plan.n])
    return bool(np.all(s[:, -1] > CLEARLY_REGULAR * s[:, 0]))


def sure_beside(plan: Plan, poses: Array) -> Bools:
    """Return of which poses (N, 4, 4) others may vouch for what is found (N,).

    Those are poses at small generic side steps that are solved for certain, or the special arm that this one nearly is.
    """
    if not plan.whole:
        # of an arm that is filled up as many as its own axes allow, merged ones counted, are all (`settled`)
        return np.full(len(poses), bool(plan.reduction.fill) and plan.count.most < plan.max_solutions)
    if plan.nearly is not None:
        return np.ones(len(poses), bool)
    return np.array([_certain_beside(plan, T) is not None for T in poses], bool)


def _certain_beside(plan: Plan, T: Array) -> Array | None:
    """Return the solutions (m, 6) of as many poses beside T as vouch, the nearest that are certain; None if too few.

    Where the arm's own eliminations vanish no pose of it is certain, and arms beside it are asked for T itself.
    """
    count, rows = 0, [np.empty((0, 6))]
    for solver in plan.arms_beside:
        q, valid, _, flags = solver.many(np.ascontiguousarray(T[None]), 1)
        if not flags[0] & Flag.UNCERTAIN and count < VOUCHING:
            rows.append(q[0][valid[0]])
            count += 1
    if plan.arms_beside:
        return np.concatenate(rows) if count == VOUCHING else None
    return _certain_of(plan, (side_steps(plan.chain, T, (size,)) for size in SURE_ASIDE))


def _certain_of(plan: Plan, poses: Iterable[Array]) -> Array | None:
    """Return the solutions (m, 6) of the first poses (k, 4, 4) of each set that are certain; None where too few are."""
    count, rows = 0, [np.empty((0, 6))]
    for some in poses:
        q, valid, _, flags = plan.solver.many(np.ascontiguousarray(some), 1)
        certain = np.flatnonzero((flags & Flag.UNCERTAIN) == 0)[: VOUCHING - count]
        rows.append(q[certain][valid[certain]])
        count += len(certain)
        if count == VOUCHING:
            return np.concatenate(rows)
    return None


def _certain_around(plan: Plan, T: Array, postures: Array) -> Array | None:
    """Return the solutions (m, 6) of poses near T that postures a little beside some (k, n) have, where certain."""
    rng = np.random.default_rng(31)
    which = postures[rng.integers(len(postures), size=2 * VOUCHING)]
    ways = rng.standard_normal(which.shape) * plan.chain.joints.unit
    return _certain_of(plan, (_turned_as(plan, T, plan.chain.native.fk(which + size * ways)) for size in SURE_ASIDE))


def _turned_as(plan: Plan, T: Array, poses: Array) -> Array:
    """Return poses (k, 4, 4) that are turned as near to T as the task leaves them free."""
    if plan.task == "pose":
        return poses
    out = np.array(poses)
    out[:, :3, :3] = T[:3, :3]
    if plan.task == "position+axis":
        z, there = T[:3, 2], poses[:, :3, 2]
        v, c = np.cross(z, there), there @ z
        K = np.zeros((len(poses), 3, 3))
        K[:, [2, 0, 1], [1, 2, 0]], K[:, [1, 2, 0], [2, 0, 1]] = v, -v
        out[:, :3, :3] = (np.eye(3) + K + K @ K / (1 + c)[:, None, None]) @ T[:3, :3]
    return out


def all_there(plan: Plan, T: Array, rows: Array, flag: int) -> bool:
    """Whether rows (m, n) of a pose that was marked with a flag are certainly all there is, and none is singular.

    What lies on a self-motion or next to one has neighbours beside T that lead back to it, and it is none of the rows.
    """
    if not (plan.direct or plan.arms_beside) or not len(rows):
        return False
    if not (flag & Flag.UNCERTAIN or named(plan.family).eliminating):
        return False
    plain = not flag & Flag.DEGENERATE and not plan.arms_beside
    return (plain or regular(plan, rows)) and vouched(plan, T, rows, each=True)


def settled(plan: Plan, T: Array, found: Examined, flag: int) -> int:
    """Return the flag of a pose that was looked at: whether what was found is certainly all there is.

    More branches than a six-joint arm can have, merged ones counted, are not believed: so near to an arm on which
    whole curves cross, a root is none of so many. Where an arm's own axes say how many there are at the most, as many,
    merged ones counted, are all.
    """
    if not plan.whole:
        every = not found.self_motions and found.multiplicity.sum() == plan.count.most < plan.max_solutions
        return flag & ~int(Flag.UNCERTAIN) if every else flag
    if not len(found.q) and plan.direct and named(plan.family).eliminating and left_open(plan, T):
        return flag | int(Flag.UNCERTAIN)
    if plan.direct and not found.self_motions and found.multiplicity.sum() > plan.max_solutions:
        return flag | int(Flag.UNCERTAIN)
    # Newton's method leads back to a root of more than two branches as near as rounding parts them, and no nearer
    within = np.where(found.multiplicity > 2, UNFOLDING_WIDEST, SAME_VOUCHED)
    doubted = flag & Flag.UNCERTAIN and not vouched(plan, T, found.q, found.self_motions, within)
    return flag if doubted else flag & ~int(Flag.UNCERTAIN)


def vouched(
    plan: Plan,
    T: Array,
    rows: Array,
    motions: Sequence[SelfMotion] = (),
    within: Array | float = SAME_VOUCHED,
    *,
    each: bool = False,
) -> bool:
    """Whether six poses beside T, each solved for certain, have no other solutions than rows (m, n) and self-motions.

    A solution of T in a regular posture has one of every pose beside it, near its own; a merged root of some of them.
    So what they lead back to is all there is, whatever the other poses beside T are solved like, where Newton's method
    leads a solution back at all. The special arm that this one nearly is may vouch as well (`counted_by_special`).
    Nearer to a fold than to the poses beside, they may have none of the solutions that meet there: where `each` is
    asked for they vouch only if they lead back to every row.
    """
    if counted_by_special(plan, T, rows):
        return True
    back = _led_back(plan, T)
    if back is None and plan.whole and not plan.arms_beside:
        # at the edge of reach nearly all poses beside have none: those that postures beside what was found have do not
        points = [rows, *(motion.at(u)[None] for motion in motions for u in PLACES)]
        every = np.concatenate(points)
        beside = _certain_around(plan, T, every) if len(every) else None
        back = None if beside is None else _onto(plan, T, beside)
    if back is None:
        return False
    if len(rows):
        near = plan.chain.joints.apart(back[:, None], rows[None]) < within
        if each and not near.any(0).all():
            return False
        back = back[~near.any(1)]
    return all(any(motion.contains(q, SAME_VOUCHED) for motion in motions) for q in back)


def _led_back(plan: Plan, T: Array) -> Array | None:
    """Return to what (m, n) of T the solutions of those lead that vouch for it; None where they are too few.

    Poses beside T that have none at all say nothing of T, which may lie at the edge of reach; arms beside that have
    none all of them do.
    """
    beside = _certain_beside(plan, T)
    if beside is None or not (len(beside) or plan.arms_beside):
        return None
    return _onto(plan, T, beside)


def _onto(plan: Plan, T: Array, beside: Array) -> Array:
    """Return to what (m, n) of T solutions beside (k, 6) lead."""
    full = plan.exact.full
    back = newton(full, beside, T, steps=SLOW_STEPS, cutoff=SLOW_RANK)
    return back[missed(full, back, T) < HOLDS][:, : plan.n]


def with_arms_beside(plan: Plan, T: Array, rows: Array) -> Array:
    """Return rows (m, n) of a pose with those that arms beside this one lead to, where its own eliminations vanish."""
    back = _led_back(plan, T) if plan.arms_beside else None
    if back is None or not len(back):
        return rows
    every = np.concatenate([rows, back])
    every = plan.chain.joints.wrapped(every[plan.chain.joints.distinct(every, SAME_ROW)])
    return every[np.lexsort(np.round(every, 6).T[::-1])]


def counted_by_special(plan: Plan, T: Array, rows: Array) -> bool:
    """Whether the special arm that this one nearly is has as many solutions as rows (m, n) of T and around it.

    A posture of this arm at T is one of the special arm at a pose no farther from T than the two arms ever differ.
    Where the special one has as many solutions all around, each leads to one of this arm, and there are no others.
    """
    if plan.nearly is None or not len(rows):
        return False
    found = arm_rows(plan.nearly, T[None], plan.nearly.defaults[None], 1)
    theirs = found.q[0][found.valid[0]]
    if found.flags[0] & Flag.UNCERTAIN or len(theirs) != len(rows):
        return False
    gap = plan.chain.joints.apart(theirs[:, None], rows[None])
    return bool(np.all(gap.min(0) < SAME_VOUCHED) and np.all(gap.min(1) < SAME_VOUCHED))
