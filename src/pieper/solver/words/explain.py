"""How an arm is solved and why, told as a teacher would."""

from __future__ import annotations

from pieper.solver.counted import POSTURES, most_met
from pieper.solver.families import named
from pieper.solver.plan.plan import Plan
from pieper.words_by_number import plural


def how_many(plan: Plan) -> list[str]:
    """Return how many solutions a pose has at most, why, and how many are met, a sentence each."""
    count, met = plan.count, most_met(plan)
    spare = f" for a chosen value of {' and '.join(plan.redundancy)}" if plan.redundancy else ""
    said = [f"A pose has at most {plural(count.most, 'solution')}{spare}: {count.argument}."]
    if met >= count.most > 1:
        said += ["There are poses that have them all."]
    elif met < count.most:
        near = f"{POSTURES:,} postures spread over all joints, and of others near the fullest"
        said += [f"Of the poses of {near}, the fullest has {met}."]
    return said


def explain(plan: Plan) -> str:
    """Tell how an arm is solved and why, as a teacher would."""
    family = named(plan.family)
    kinds = "".join("P" if p else "R" for p in plan.prismatic)
    lines = [f"{plan.name}: {plan.count.kind}; {plural(plan.n, 'joint')} ({kinds}), task: {plan.task}."]
    if axes := plan.geometry.sentences(plan.description.axis_names):
        lines += ["", "What the axes do:", *(f"  {sentence}" for sentence in axes)]
    if plan.snapped:
        lines += ["", "Made special to be solved: " + "; ".join(plan.snapped) + "."]
        lines += ["Each solution of that nominal arm is then refined on the arm as described."]
    reduction = plan.reduction
    steps: list[str] = []
    if plan.chain.linked:
        moved = [f"{axis.name} = {plan.description.moved_by(axis.at, plan.names)}" for axis in plan.description.linked]
        axes = plural(plan.chain.axis_count, "axis", "axes")
        steps.append(
            f"{plural(plan.n, 'joint')} and a linkage ({', '.join(moved)}) move {axes}: the axes are solved for as if "
            "each moved by itself, and the postures are kept that the linkage holds"
        )
    elif plan.chain.coupling is not None:
        steps.append(
            "coupled joints: the axes' own angles are solved for, and the joints' numbers, to which limits apply, "
            "follow from them by the inverse of the coupling"
        )
    if reduction.full.n > plan.n:
        steps.append(
            f"the task leaves {plural(reduction.full.n - plan.n, 'freedom')} of the tool open, "
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
            f"the arm can do {plural(6 - len(reduction.fill), 'thing')} at once: "
            f"{plural(len(reduction.fill), 'virtual joint')} that must come out as zero "
            f"{'is' if len(reduction.fill) == 1 else 'are'} added"
        )
    if steps:
        lines += ["", "Made a six-joint problem: " + "; ".join(steps) + "."]
    lines += ["", f"Solved by: {plan.family.replace('_', ' ')}, for {family.arrangement}.", f"  {family.words}"]
    lines += [f"  {fact}" for fact in plan.spec.facts]
    lines += [f"  {sentence}" for sentence in how_many(plan)]
    if (
        plan.direct and plan.max_solutions > 8 and plan.cuspidal is not None
    ):  # more than three pairs of words can tell apart
        lines += [
            f"  Posture names: this arm is {plan.cuspidal}." if plan.cuspidal.found else f"  Cuspidal? {plan.cuspidal}."
        ]
    return "\n".join(lines)
