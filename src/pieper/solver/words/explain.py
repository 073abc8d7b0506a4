"""How an arm is solved and why, told as a teacher would."""

from __future__ import annotations

from pieper.solver.plan.plan import Plan
from pieper.words_by_number import plural

FAMILY_WORDS = {
    "spherical_wrist_parallel": (
        "a spherical wrist and parallel second and third axes",
        "The wrist centre fixes the first three joints: two ways to face it, two ways to bend the elbow. The last "
        "three then turn the tool, in two ways.",
    ),
    "spherical_wrist": (
        "three neighbouring axes that meet in one point",
        "The point where they meet depends on the other three joints alone: a positioning problem with at most four "
        "solutions. The three meeting axes then turn the tool, in at most two ways each.",
    ),
    "three_parallel": (
        "three neighbouring parallel axes",
        "The parallel joints move within a plane; what happens across that plane fixes the other joints, and a "
        "two-link triangle in it fixes the three.",
    ),
    "offset_wrist": (
        "parallel second and third axes and a wrist of which only two neighbouring axes meet",
        "With the last joint's angle chosen, the point where axes 4 and 5 meet is known, and with it shoulder and "
        "elbow: two sides, two shapes of the triangle. That axes 4 and 5 meet under their own angle is then one "
        "equation for the last joint, a trigonometric polynomial, of which every real root is isolated.",
    ),
    "two_slides": (
        "two sliding joints, which turn nothing, so that the four turning ones alone make the orientation",
        "With the angle of one turning joint chosen, the other three follow like a wrist, in two ways; the slides must "
        "undo what is then left along their two directions. That is one equation for the chosen angle, a "
        "trigonometric polynomial, of which every real root is isolated.",
    ),
    "general": (
        "no special arrangement that a closed form could use",
        "Five of the six joints are eliminated (Raghavan and Roth, 1993); the roots of the remaining equation, of "
        "degree sixteen at most, are found as eigenvalues, and each gives the other joints.",
    ),
}


def explain(plan: Plan) -> str:
    """Tell how an arm is solved and why, as a teacher would."""
    geometry, words = FAMILY_WORDS[plan.family]
    lines = [f"{plan.name}: {plan.n} joints ({''.join('P' if p else 'R' for p in plan.prismatic)}), task: {plan.task}."]
    lines += ["", "What the axes do:"]
    lines += [f"  {sentence}" for sentence in plan.geometry.sentences(plan.names)]
    if plan.snapped:
        lines += ["", "Made special, because asked to: " + "; ".join(plan.snapped) + "."]
        lines += ["Each solution of that nominal arm is then refined on the arm as described."]
    reduction = plan.reduction
    steps: list[str] = []
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
    lines += ["", f"Solved by: {plan.family.replace('_', ' ')}, for {geometry}.", f"  {words}"]
    lines += [
        f"  At most {plan.max_solutions} solutions a pose"
        + (" and choice of the spare joints." if plan.redundancy else ".")
    ]
    if (
        plan.direct and plan.max_solutions > 8 and plan.cuspidal is not None
    ):  # more than three pairs of words can tell apart
        lines += [
            f"  Posture names: this arm is {plan.cuspidal}." if plan.cuspidal.found else f"  Cuspidal? {plan.cuspidal}."
        ]
    for key, value in plan.spec.info.items():
        if isinstance(value, (str, int, float)):
            lines.append(f"  {key.replace('_', ' ')}: {value}")
    return "\n".join(lines)
