"""Judges of inverse kinematics: a formula for a joint with its branches, and formulas that must hold together."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from pieper.algebra.expression import Expr
from pieper.algebra.formula import ANGLE, has_branch
from pieper.errors import PieperError
from pieper.judge.circular import given_angles, uses_itself
from pieper.judge.claim import Claim, Numbers
from pieper.judge.degrees import angles_among, from_degrees
from pieper.judge.difference import agreeing_digits, digits_wanted
from pieper.judge.evidence import SOLVER_POSES, Evidence, wrapped
from pieper.judge.judges.angle_formula import AngleFormula, branch_values, either_of, read_angle, right_side, signed
from pieper.judge.judges.freedom import completes, undetermined
from pieper.judge.known import known_in
from pieper.judge.lengths import decimals, standing
from pieper.judge.matrices import value_of
from pieper.judge.model import POSE_NAMES
from pieper.judge.products import Product
from pieper.judge.regions import region_of, zero_denominators
from pieper.judge.rounding import unrounded, with_rounding
from pieper.judge.samples import pose_of
from pieper.judge.search.search import Explanation, Goal, search
from pieper.judge.search.tried import tried_text
from pieper.judge.slips.formula_slips import slips
from pieper.judge.slips.lost_parts import lost_from
from pieper.judge.verdict import Verdict
from pieper.tolerances import JUDGED_HOLDS, JUDGED_SAME_JOINTS

MOST_JOINTS = 6  # an arm of fewer cannot take every pose


def judge_joint(ev: Evidence, claim: Claim) -> Verdict:
    """Judge a formula for a joint angle, given the pose and the joints before it at their right values.

    Keys: joint or for, is, where, frame, at_deg, when, task.
    """
    ev = ev.holding(claim)
    name, angle = read_angle(ev, claim)
    printed = claim["is"] if isinstance(claim["is"], list) else [claim["is"]]
    nodes = [ev.parse(right_side(ev, str(text), angle), claim.where) for text in printed]
    if claim.get("unit") == "deg":
        nodes = [from_degrees(node.substitute(angles_among(ev.definitions))) for node in nodes]
    if len(nodes) > 2:
        raise claim.error("is: two branches at most stand in a list; a sign +- goes with each of them", "is")
    node = nodes[0] if len(nodes) == 1 else either_of(*nodes)
    claim = claim.reads(
        f"{name} = {' or '.join(right_side(ev, str(text), angle) for text in printed)}"
        + (" in degrees" if claim.get("unit") == "deg" else "")
        + "".join(f", {k} = {v}" for k, v in claim.where.items())
        + (f", where {claim['when']}" if "when" in claim else "")
    )
    node = signed(ev, claim, node, angle)
    ev = ev.naming(node)
    frame = ev.frame(claim)
    circle = uses_itself(ev.model, angle, node, ev.definitions, known_in(ev, node, angle, frame))
    form = AngleFormula.of(ev, angle, frame)
    good, own = form.judged(ev, node), ev.samples.nominal
    if circle:
        return _circular(ev, claim, node, form, name, circle, good)
    if good[own].all():
        return _joint_holds(ev, claim, node, form, good)
    exact = unrounded(ev, node, form.gap, form.judged)
    if exact:
        off = f"as printed it is off by {exact.off * form.unit:.2g} {ev.model.unit if form.slides else 'deg'} at most"
        verdict = _joint_holds(ev, claim, exact.tree, form, form.judged(ev, exact.tree), rounding=off)
        return with_rounding(verdict, exact, off)
    return _joint_fails(ev, claim, node, form, good)


def _circular(
    ev: Evidence, claim: Claim, node: Expr, form: AngleFormula, name: str, circle: str, good: np.ndarray
) -> Verdict:
    """Say that a formula uses what it is for; where it is not even true, the slip that made it so is looked for."""
    says = f"Wrong: circular. A formula that is to give {name} uses {name} itself, in {circle}"
    if good.all():
        return claim.wrong(f"{says}; it is true and gives nothing.", slip="circular")
    found, _ = _slip(ev, node, form)
    says += f", and it is right at {int(good.sum())} of {len(good)} poses only."
    if not found.best:
        details = [("the slip", "no single slip explains it"), ("tried", tried_text(found))]
        return claim.wrong(says, details, slip="circular")
    reading = str(found.best.tree)
    details = [("nearest right reading", f"{name} = {reading}"), ("the slip", found.best.says)]
    return claim.wrong(says, [*details, ("tried", tried_text(found))], slip=found.best.kind, reading=reading)


def _joint_fails(ev: Evidence, claim: Claim, node: Expr, form: AngleFormula, good: np.ndarray) -> Verdict:
    name, own = str(claim.get("for", form.angle)), ev.samples.nominal
    env = ev.environment(form.frame)
    details: list[tuple[str, str]] = []
    vanish = zero_denominators(node, env)
    bad = np.flatnonzero(~good & own)
    if vanish:
        details.append(("undefined", f"the denominator {vanish[0]} is zero for all joints"))
    elif len(bad):
        details.append(("counter-example", _angle_example(ev, node, form, env, int(bad[0]))))
    region = region_of(ev, form.with_symbols(node))
    found, where = _slip(ev, node, form, branch=not region)
    slip = reading = ""
    best = found.best
    if best:
        slip, reading = best.kind, str(best.tree)
        where = where and f", where {where}"
        details += [("nearest right reading", f"{name} = {reading}{where}"), ("the slip", best.says)]
    else:
        details.append(("the slip", "no single slip explains it" + found.closest("poses")))
    details.append(("tried", tried_text(found)))
    counts: Numbers = {"right": int(good.sum()), "tried": len(good)}
    if region:
        return claim.partly(f"Holds only where {region}.", details, slip, reading, **counts)
    if good.mean() > 0.1:
        share = f"{100 * good.mean():z.0f}% of the poses"
        return claim.partly(f"Holds at {share} only; no simple region was found.", details, slip, reading, **counts)
    sentence = (
        f"Wrong: gives the joint's {'value' if form.slides else 'angle'} at {int(good.sum())} of {len(good)} poses."
    )
    if vanish:
        sentence = "Wrong: undefined, because it divides by zero for all joints."
    return claim.wrong(sentence, details, slip, reading, **counts)


def _slip(ev: Evidence, node: Expr, form: AngleFormula, *, branch: bool = False) -> tuple[Explanation, str]:
    """What explains a wrong formula, and, of one for a single branch, the region in which it is right then.

    Args:
        ev: The arm and its samples.
        node: The formula.
        form: What it is to give.
        branch: Whether a slip counts that makes it right on one branch only.
    """
    goal = ev.goal(form.wanted(ev), angle=not form.slides, frame=form.frame)
    other = ~ev.samples.nominal
    if form.judged(ev, node)[~other].all() and other.any():
        goal = goal.restrict(other)  # what is wrong shows with other lengths only

    def searched(aim: Goal, pairs: bool = False) -> Explanation:
        near = slips(node, ev.lengths, ev.model.n, ev.own_names, angle=True)
        lost = lost_from(ev, node, aim, form.angle)
        found = search(aim, node, near, lost=lost, seconds=ev.seconds, pairs=pairs)
        # an explanation that uses what it explains is none
        known = known_in(ev, node, form.angle, form.frame)
        found.found = [s for s in found.found if not uses_itself(ev.model, form.angle, s.tree, ev.definitions, known)]
        return found

    found = searched(goal)
    if not found.best and decimals(node.substitute(ev.definitions)):
        # numbers stand for this arm's lengths only
        nominal = searched(goal.restrict(ev.samples.nominal))
        found = nominal if nominal.best else found
    if found.best:
        return found, ""
    if branch and found.nearest:
        known = known_in(ev, node, form.angle, form.frame)
        one = found.nearest[0]
        if not uses_itself(ev.model, form.angle, one.tree, ev.definitions, known):
            where = region_of(ev, form.with_symbols(one.tree))
            if where:
                return replace(found, found=[one]), where
    return searched(goal, pairs=True), ""


def _angle_example(ev: Evidence, node: Expr, form: AngleFormula, env: dict[str, np.ndarray], k: int) -> str:
    wanted = form.wanted(ev)
    unit = ev.model.unit if form.slides else "deg"

    def shown(value: float) -> str:
        return f"{(value if form.slides else np.degrees(wrapped(value))):z.4f}"

    values = [v[k] for v in branch_values(node, env, wanted.shape)]
    given = " or ".join(shown(v) if np.isfinite(v) else "nothing (undefined)" for v in values)
    return f"at {ev.at(k)}: the formula gives {given} {unit}, right is {shown(wanted[k])} {unit}"


def _joint_holds(
    ev: Evidence, claim: Claim, node: Expr, form: AngleFormula, good: np.ndarray, *, rounding: str = ""
) -> Verdict:
    """The verdict on a formula that gives the right angle for the arm's own lengths."""
    angle, own = form.angle, ev.samples.nominal
    digits = None
    if form.frame is None and not ev.held and not rounding and not ev.picks(node):
        digits = agreeing_digits(ev.model, ev.samples, ev.definitions, node, angle, angle=not form.slides)
        if 0 < digits < digits_wanted(ev.model, node.substitute(ev.definitions)):
            return claim.wrong(
                f"Wrong, if only just: at 50-digit arithmetic it agrees to {digits} digits and no more.", digits=digits
            )
    count = len(good) if good.all() else int(own.sum())
    more = f"; at 50-digit arithmetic it agrees to {digits} digits" if digits else ""
    held = f"right at {count} of {count} poses{more}"
    tied = ""
    if not good.all():
        stand = standing(ev, node, form.judged)
        if stand.partly:
            found, _ = _slip(ev, node, form)
            slip, reading = (found.best.kind, str(found.best.tree)) if found.best else ("", "")
            details = [("nearest right reading", reading), ("the slip", found.best.says)] if found.best else []
            return claim.partly(f"Holds for this arm {stand.words}: {held}.", details, slip, reading, digits=digits)
        tied = f" for this arm's lengths{stand.words and ', '}{stand.words}"
    given, _ = given_angles(node, ev.definitions)
    free = [group for group in undetermined(ev, given) if any(f"theta{j}" == str(angle) for j in group)]
    if free:
        names = " and ".join(f"theta{j}" for j in sorted(free[0]))
        return claim.partly(
            f"True, but it determines nothing: a pose does not tell {names} apart; any value of one fits with another.",
            digits=digits,
        )
    where = f" where {claim['when']}" if "when" in claim else ""
    if not has_branch(node):
        return claim.holds(f"Holds{tied}{where}: {held}.", digits=digits)

    def upper(at: Evidence) -> tuple[np.ndarray, dict[str, np.ndarray]]:
        env, wanted = at.environment(form.frame), form.wanted(at)
        return np.abs(form.off(next(branch_values(node, env, wanted.shape)), wanted)) < form.tolerance, env

    region = region_of(ev, upper)
    known = f"the upper sign belongs to {region}" if region else ""
    details = [("branch", known or "which sign belongs to a solution follows no simple region")]
    both, why = _both_signs(ev, node, angle, form.frame, claim.get("task"))
    if why:
        details.append(("both signs", why))
    if both is False and "task" not in claim and form.frame is None and _of_position(ev, node):
        # short arms: a page that works with px, py and pz alone is about positions
        both, why = _both_signs(ev, node, angle, None, "position")
        if both:
            told = 'with the orientation of a pose asked for too only one is (task = "position" says what is meant)'
            details[-1] = ("both signs", f"{why}; {told}")
            held = f"{held}; both signs are solutions of a position, which is all that the formula uses"
    if both is False:
        return claim.partly(
            f"Holds on one branch only: the right angle is always one of the two ({held}), but the other sign is no "
            "solution with the joints before it; the formula does not say which.",
            details,
            "branch",
            digits=digits,
        )
    return claim.holds(f"Holds{tied}{where} with its two branches: {held}.", details, digits=digits)


def _of_position(ev: Evidence, node: Expr) -> bool:
    """Whether a formula about a short arm uses the position of the tool and nothing else of the pose."""
    used = node.substitute(ev.definitions).symbols()
    letters = {name: column for name, _, column in POSE_NAMES if name in used}
    turned = used & {"roll", "pitch", "yaw"} or ev.picks(node)
    return ev.model.n < MOST_JOINTS and bool(letters) and set(letters.values()) == {3} and not turned


def _both_signs(
    ev: Evidence, node: Expr, angle: Expr, frame: Product | None, task: str | None
) -> tuple[bool | None, str]:
    """Say whether, with the joints the formula uses held, both signs can be completed to solutions of the pose."""
    wanted = ANGLE.match(str(angle))
    part = ev.model.between(str(frame)) if frame is not None else (ev.model, 0)
    if not wanted or part is None:
        return None, ""
    model, before = part
    joint = int(wanted.group(1)) - before
    poses = value_of(frame, ev.samples.frames) if frame is not None else ev.samples.frames["T"]
    used, known = given_angles(node, ev.definitions)
    used |= set(ev.held)
    used = used.union(*known_in(ev, node, angle).values())
    given = {j for j in used if before < j <= before + model.n and j - before != joint}
    sums = [{j - before: k for j, k in s.items()} for s in known if all(before < j <= before + model.n for j in s)]
    values = wrapped(np.array(list(branch_values(node, ev.environment(frame), (len(poses),)))))
    checked = both = 0
    for k in np.flatnonzero(ev.samples.nominal)[:SOLVER_POSES]:
        q = ev.samples.q[k, before : before + model.n]
        if not np.all(np.isfinite(values[:, k])) or abs(wrapped(values[0, k] - values[1, k])) < JUDGED_HOLDS:
            continue
        other = max(values[:, k], key=lambda v: abs(wrapped(v - q[joint - 1])))
        held = {j - before: q[j - before - 1] for j in given} | {joint: other}
        checked += 1
        among = _among(ev, int(k), held, sums, task) if frame is None else None
        both += completes(model, poses[k], held, q, sums=sums, position=task == "position") if among is None else among
    if not checked:
        return None, ""
    same = [f"theta{j}" for j in sorted(given)] + [" + ".join(f"theta{j}" for j in s) for s in known]
    place = "position" if task == "position" else "pose"
    words = "for the same " + " and ".join(same) if same else f"of the {place}"
    if both == checked:
        return True, f"both are solutions {words}, at {both} of {checked} poses"
    if both == 0:
        return False, f"only one is a solution {words}, at all of {checked} poses"
    return None, f"both are solutions {words} at {both} of {checked} poses"


def _among(ev: Evidence, k: int, held: dict[int, float], sums: list[dict[int, int]], task: str | None) -> bool | None:
    """Whether one of the solver's solutions of sample k has the held joints and sums; None when it cannot say."""
    model, q = ev.model, ev.samples.q[k]
    if model.n > 6:
        return None
    try:
        rows = ev.in_unit(ev.solved(ev.samples.frames["T"][k], task))
    except PieperError:
        return None
    if not len(rows) or ev.apart(rows, q).max(1).min() > JUDGED_SAME_JOINTS:
        return None
    if task != "position":
        off = np.abs(pose_of(model, rows) - ev.samples.frames["T"][k]).reshape(len(rows), -1).max(1)
        rows = rows[off < JUDGED_SAME_JOINTS * max(1.0, model.length())]
    fine = np.ones(len(rows), dtype=bool)
    for joint, value in held.items():
        target = q.copy()
        target[joint - 1] = value
        fine &= ev.apart(rows, target)[:, joint - 1] < JUDGED_SAME_JOINTS
    for members in sums:
        total = sum(factor * (rows[:, j - 1] - q[j - 1]) for j, factor in members.items())
        fine &= np.abs(wrapped(total)) < JUDGED_SAME_JOINTS
    return bool(fine.any())


def judge_together(ev: Evidence, claim: Claim) -> Verdict:
    """Judge formulas for several joints that must be right at the same time.

    Keys: is, a table of joint = formula; where; frame.
    """
    ev = ev.holding(claim)
    frame = ev.frame(claim)
    forms: dict[str, tuple[AngleFormula, Expr]] = {}
    for name, text in claim["is"].items():
        _, angle = read_angle(ev, claim.part(claim.id, {"for": name}))
        forms[name] = AngleFormula.of(ev, angle, frame), ev.parse(str(text), claim.where, f"is {name}")
    claim = claim.reads("; ".join(f"{k} = {v}" for k, v in claim["is"].items()))
    ev = ev.naming(*(node for _, node in forms.values()))
    for name, (form, node) in forms.items():
        circle = uses_itself(ev.model, form.angle, node, ev.definitions, known_in(ev, node, form.angle, form.frame))
        if circle:
            return claim.wrong(
                f"Wrong: circular. The formula for {name} uses {name} itself, in {circle}.", (), "circular"
            )

    def together(at: Evidence) -> np.ndarray:
        return np.logical_and.reduce([form.judged(at, node) for form, node in forms.values()])

    good, own = together(ev), ev.samples.nominal
    if good.all():
        return claim.holds(f"Holds together: all are right at {len(good)} of {len(good)} poses.")
    if good[own].all():
        stands = [standing(ev, node, form.judged) for form, node in forms.values()]
        words = ", ".join(dict.fromkeys(s.words for s in stands if s.words))
        said = f"Holds together for this arm's lengths{words and ', '}{words}: all are right at {own.sum()} poses."
        return claim.partly(said) if any(s.partly for s in stands) else claim.holds(said)
    details = []
    for name, (form, node) in forms.items():
        mask = form.judged(ev, node)
        region = region_of(ev, form.with_symbols(node))
        where = f", those with {region}" if region else ""
        details.append((name, f"right at {int(mask.sum())} of {len(mask)} poses{where}"))
    k = int(np.flatnonzero(~good)[0])
    each = ", ".join(f"{n} {'right' if form.judged(ev, node)[k] else 'wrong'}" for n, (form, node) in forms.items())
    details.append(("counter-example", f"at {ev.at(k)}: {each}"))
    if not good.any():
        return claim.wrong(f"Wrong: never right together, at 0 of {len(good)} poses.", details, "branch")
    region = region_of(ev, lambda at: (together(at), at.environment(frame)))
    where = f"where {region}" if region else f"at {100 * good.mean():z.0f}% of the poses"
    return claim.partly(f"Holds together only {where}.", details, "branch")
