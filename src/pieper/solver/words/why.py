"""Why a pose came out as it did, and why an arm is solved as it is: sentences with numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pieper.kinematics.armangle import POLE
from pieper.solver.families import named
from pieper.solver.results import AT_ARM_ANGLE, COUNT_CHANGES, NO_ARM_ANGLE, OUT_OF_REACH_FLAG, Status

if TYPE_CHECKING:
    from pieper.solver.plan.plan import Plan
    from pieper.solver.results import Solutions


def why(plan: Plan, sols: Solutions) -> str:
    """Return one sentence, with a number, on how a pose came out."""
    status, k, m = sols.status, len(sols.all_q), len(sols.q)
    if status == Status.OUT_OF_REACH:
        return _out_of_reach(plan, sols)
    if status == Status.OUTSIDE_LIMITS:
        return _outside_limits(plan, sols)
    if status == Status.UNCERTAIN and sols._flag & NO_ARM_ANGLE:
        return (
            "The arm angle is undefined at this pose: the line from shoulder to wrist points along the pole of the "
            f"reference or the elbow lies on it, within {POLE:g} rad. Choose {', '.join(plan.redundancy)} instead."
        )
    if status == Status.UNCERTAIN and sols._flag & COUNT_CHANGES:
        return (
            f"{k} solution(s) of the arm as described were found and verified, another number than its nominal arm has "
            f"here: solutions merge or appear within the {plan.drift * plan.chain.length * 1e3:.3g} mm by which the "
            "two differ."
        )
    if status == Status.UNCERTAIN:
        return f"{k} solution(s) were found and verified, but the check that none is missing failed at this pose."
    isolated = int(np.sum(sols.in_family < 0))
    if status == Status.SINGULAR:
        text = "; ".join(str(f) for f in sols.families)
        count = f"{len(sols.families)} continuous family(ies)"
        return f"The pose is singular: {count} ({text}) and {isolated} isolated solution(s)."
    if status == Status.REDUNDANT:
        held = _held(plan, sols)
        return (
            f"{m} solution(s) at the chosen {held}; the arm has {len(plan.redundancy)} joint(s) to spare for this task."
        )
    double = int(np.sum(sols.multiplicity > 1))
    merged = f", {double} of them double (two branches meet there)" if double else ""
    return f"{m} of {k} solution(s) lie inside the joint limits{merged}."


def _held(plan: Plan, sols: Solutions) -> str:
    return "arm angle" if sols._flag & AT_ARM_ANGLE else ", ".join(plan.redundancy)


def _out_of_reach(plan: Plan, sols: Solutions) -> str:
    from pieper.solver.words.closest import nearest_reachable

    _, metres, radians = nearest_reachable(plan.exact.full, sols.T)
    miss = f"misses it by {metres * 1e3:.4g} mm"
    if radians > 5e-3:
        miss += f" and {np.degrees(radians):.3g} deg"
    if plan.redundancy and metres < 1e-7 * plan.chain.length and radians < 1e-7:
        held = _held(plan, sols)
        return f"No solution at the chosen {held}, though the arm can take the pose with other values."
    what = {"pose": "The pose", "position": "The position", "position+axis": "The position with this tool axis"}[
        plan.task
    ]
    if sols._flag & OUT_OF_REACH_FLAG or radians <= 5e-3:
        return f"{what} is out of reach: the nearest one the arm can take {miss}."
    return f"{what} is out of reach: the arm cannot turn the tool this way there; the nearest one it can take {miss}."


def _outside_limits(plan: Plan, sols: Solutions) -> str:
    least, sentence = np.inf, "No solution lies inside the joint limits."
    for q in sols.all_q:
        over = np.maximum(plan.limits[:, 0] - q, q - plan.limits[:, 1])
        turn = 2 * np.pi
        for k in (-1, 1):
            moved = np.where(plan.prismatic, q, q + k * turn)
            over = np.minimum(over, np.maximum(plan.limits[:, 0] - moved, moved - plan.limits[:, 1]))
        worst = int(np.argmax(over))
        if over[worst] < least:
            least = over[worst]
            by = f"{over[worst] * 1e3:.4g} mm" if plan.prismatic[worst] else f"{np.degrees(over[worst]):.4g} deg"
            sentence = (
                f"All {len(sols.all_q)} solution(s) break a joint limit; the least offending one exceeds "
                f"{plan.names[worst]} by {by}."
            )
    return sentence


def explain(plan: Plan) -> str:
    """Tell how an arm is solved and why, as a teacher would."""
    family = named(plan.family)
    lines = [f"{plan.name}: {plan.n} joints ({''.join('P' if p else 'R' for p in plan.prismatic)}), task: {plan.task}."]
    lines += ["", "What the axes do:"]
    lines += [f"  {sentence}" for sentence in plan.geometry.sentences(plan.names)]
    if plan.snapped:
        lines += ["", "Made special, because asked to: " + "; ".join(plan.snapped) + "."]
        lines += ["Each solution of that nominal arm is then refined on the arm as described."]
    reduction = plan.reduction
    steps = []
    if reduction.full.n > plan.n:
        steps.append(
            f"the task leaves {reduction.full.n - plan.n} freedom(s) of the tool open, "
            "which become virtual joints at the tool"
        )
    if reduction.locked:
        values = ", ".join(f"{n} = {v:.4g}" for n, v in zip(plan.redundancy, plan.defaults, strict=True))
        steps.append(
            f"more joints than the task needs: {', '.join(plan.redundancy)} held at a chosen value "
            f"(by default {values})"
        )
    if plan.arm_angle:
        steps.append(f"instead of it the arm angle may be chosen ({plan.arm_angle.words})")
    if reduction.fill:
        steps.append(
            f"the arm can do {6 - len(reduction.fill)} things at once: {len(reduction.fill)} virtual joint(s) are "
            "added "
            "that must come out as zero"
        )
    if steps:
        lines += ["", "Made a six-joint problem: " + "; ".join(steps) + "."]
    lines += ["", f"Solved by: {plan.family.replace('_', ' ')}, for {family.arrangement}.", f"  {family.words}"]
    lines += [
        f"  At most {plan.max_solutions} solutions a pose"
        + (" and choice of the spare joints." if plan.redundancy else ".")
    ]
    if plan.direct and plan.max_solutions > 8:  # more than three pairs of words can tell apart
        lines += [
            f"  Posture names: this arm is {plan.cuspidal}." if plan.cuspidal.found else f"  Cuspidal? {plan.cuspidal}."
        ]
    for key, value in plan.spec.info.items():
        if isinstance(value, (str, int, float)):
            lines.append(f"  {key.replace('_', ' ')}: {value}")
    return "\n".join(lines)
