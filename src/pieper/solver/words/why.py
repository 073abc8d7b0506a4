"""Why a pose came out as it did: one sentence with a number."""

from __future__ import annotations

import numpy as np

from pieper.solver.plan.plan import Plan
from pieper.solver.results import Solutions, Status
from pieper.solver.rows import Flag
from pieper.solver.words.closest import closest, typed
from pieper.tolerances import ARM_ANGLE_POLE, CLOSES, MOST_OPEN, TOLD_AS_TURN, TURN_FOR_PLACE
from pieper.words_by_number import plural

#: From here on (m) a slide's miss is said in metres.
FAR = 10.0


def why(plan: Plan, sols: Solutions) -> str:
    """Return one sentence, with a number, on how a pose came out."""
    status, k, m = sols.status, len(sols.all_q), len(sols.q)
    if status == Status.OUT_OF_REACH:
        return _out_of_reach(plan, sols)
    if status == Status.OUTSIDE_LIMITS:
        return _outside_limits(plan, sols)
    if status == Status.UNCERTAIN and sols.flag & Flag.NO_ARM_ANGLE:
        return (
            "The arm angle is undefined at this pose: the line from shoulder to wrist points along the pole of the "
            f"reference or the elbow lies on it, within {ARM_ANGLE_POLE:g} rad. "
            f"Choose {', '.join(plan.redundancy)} instead."
        )
    if status == Status.UNCERTAIN and sols.flag & Flag.COUNT_CHANGES:
        apart = plan.drift * plan.chain.length * 1e3
        return (
            f"{plural(k, 'solution')} of the arm as described {_were(k)} found and verified, another number than its "
            f"nominal arm has here: solutions merge or appear within the {apart:.3g} mm by which the two differ."
        )
    if status == Status.UNCERTAIN:
        return f"{plural(k, 'solution')} {_were(k)} found and verified, but the check that none is missing failed here."
    isolated = int(np.sum(sols.in_self_motion < 0))
    if status == Status.SINGULAR:
        text = "; ".join(str(motion) for motion in sols.self_motions)
        count = plural(len(sols.self_motions), "self-motion")
        return f"The pose is singular: {count} ({text}) and {plural(isolated, 'isolated solution')}."
    if status == Status.REDUNDANT:
        spare = plural(len(plan.redundancy), "joint")
        if not m:
            named = ", ".join(sols.named) or _held(plan, sols)
            return f"No solution inside the limits at the chosen {named}; other values have some."
        return f"{plural(m, 'solution')} at the chosen {_held(plan, sols)}; the arm has {spare} to spare for this task."
    where = "lies" if m == 1 else "lie"
    return f"{m} of {plural(k, 'solution')} {where} inside the joint limits{_merged(sols)}."


def _merged(sols: Solutions) -> str:
    """Say in how many rows branches meet, and how many branches."""
    branches, rows = np.unique(sols.multiplicity[sols.multiplicity > 1], return_counts=True)
    parts = [
        f"{count} of them double (two branches meet there)" if many == 2 else f"{count} of them of {many} branches"
        for many, count in zip(branches.tolist(), rows.tolist(), strict=True)
    ]
    return "".join(f", {part}" for part in parts)


def _were(count: int) -> str:
    return "was" if count == 1 else "were"


def _held(plan: Plan, sols: Solutions) -> str:
    return "arm angle" if sols.flag & Flag.AT_ARM_ANGLE else ", ".join(plan.redundancy)


def _out_of_reach(plan: Plan, sols: Solutions) -> str:
    near = sols.closest
    metres, radians = near.metres, near.radians
    if plan.redundancy and metres < CLOSES * plan.chain.length and radians < CLOSES:
        held = ", ".join(sols.named) or _held(plan, sols)
        return f"No solution at the chosen {held}, though the arm can take the pose with other values."
    # a turn is told where it is one, or all that is missing
    way = metres / plan.chain.length
    by_turn = radians > min(TOLD_AS_TURN, way)
    linkage = _by_linkage(plan) if by_turn else ""
    what = {"pose": "The pose", "position": "The position", "position+axis": "The position with this tool axis"}[
        plan.task
    ]
    turned = f"{np.degrees(radians):.3g} deg"
    explained = _by_rounding(plan, sols)
    if by_turn and way <= min(TOLD_AS_TURN, radians):
        missing = f"at best {turned} are missing.{linkage}{explained}"
        return f"{what} is out of reach: the arm gets there, but not turned this way; {missing}"
    also = f" and {turned}" if by_turn else ""
    missing = f"misses it by {metres * 1e3:.4g} mm{also}.{linkage}{explained}"
    return f"{what} is out of reach: the nearest one the arm can take {missing}"


def _by_rounding(plan: Plan, sols: Solutions) -> str:
    """Return, a sentence, that a pose of the arm has the decimals that were typed, where one has.

    A matrix that is typed has as many decimals in its turn as in its place. The posture that comes nearest meets the
    place first, and what that costs of the turn may be more: so the posture is asked for that misses both by little.
    """
    near, (digits, open_by) = sols.closest, typed(sols.T)
    open_by = min(open_by, MOST_OPEN * plan.chain.length)
    missed = max(near.metres, near.radians)
    if open_by < missed < TURN_FOR_PLACE * open_by:
        both = closest(plan, sols.T, weights=(1.0, 1.0), seeds=near.q[None])
        missed = max(both.metres, both.radians)
    if missed > open_by:
        return ""
    return f" Rounding explains it: the position has {plural(digits, 'decimal')}, in metres."


def _by_linkage(plan: Plan) -> str:
    """Return what a linkage moves, a sentence, where there is one."""
    names = [axis.name for axis in plan.description.linked]
    if not names:
        return ""
    return f" Its linkage turns {' and '.join(names)} as the joints move: no joint turns the tool freely there."


def _outside_limits(plan: Plan, sols: Solutions) -> str:
    sentence = "No solution lies inside the joint limits."
    elsewhere = bool(plan.redundancy) and any(motion.inside for motion in sols.self_motions)
    held = f" at the chosen {_held(plan, sols)}" if plan.redundancy else ""
    if count := len(sols.all_q):
        joints = plan.chain.joints.first(plan.n)
        over = joints.least_over(sols.all_q, plan.limits)
        # turns and slides are compared per length of the arm
        worst = np.argmax(over / joints.unit, axis=1)
        row = int(np.argmin((over / joints.unit).max(1)))
        joint = int(worst[row])
        by = over[row, joint]
        far = f"{by * 1e3:.4g} mm" if by < FAR else f"{by:.4g} m"
        said = far if plan.prismatic[joint] else f"{np.degrees(by):.4g} deg"
        what = f"The only solution{held} breaks" if count == 1 else f"All {count} solutions{held} break"
        which = "it" if count == 1 else "the least offending one"
        sentence = f"{what} a joint limit; {which} exceeds {plan.names[joint]} by {said}."
    return f"{sentence} Other values have solutions inside." if elsewhere else sentence
