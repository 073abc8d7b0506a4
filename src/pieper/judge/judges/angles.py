"""Judges of inverse kinematics: a formula for a joint with its branches, and formulas that must hold together."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from pieper.algebra.arithmetics import NumpyField
from pieper.algebra.expression import Expr
from pieper.algebra.formula import ANGLE, has_branch
from pieper.judge.claim import Claim
from pieper.judge.difference import agreeing_digits
from pieper.judge.evidence import SOLVER_POSES, Evidence, tried_text, wrapped
from pieper.judge.judges.freedom import completes, undetermined
from pieper.judge.matrices import Product, parse_product, value_of
from pieper.judge.regions import find_region, region_features, zero_denominators
from pieper.judge.search.search import ANGLE_TOLERANCE, search
from pieper.judge.slips.formula_slips import slips
from pieper.judge.verdict import Verdict


def read_angle(ev: Evidence, claim: Claim) -> tuple[str, Expr]:
    """Read which angle a claim is about: joint = 4, or for = "theta1+theta2"."""
    if "joint" in claim:
        name = f"theta{claim.joint(ev.model.n)}"
    elif "for" in claim:
        name = str(claim["for"])
    else:
        raise claim.error('say which joint, as joint = 4 or for = "theta1+theta2"')
    return name, ev.parse(name)


def branch_values(node: Expr, env: dict[str, np.ndarray], shape: tuple[int, ...]) -> Iterator[np.ndarray]:
    """Yield the values of a formula at all samples, one array a branch; nan where it is undefined."""
    for branch in (1, -1) if has_branch(node) else (1,):
        with np.errstate(all="ignore"):
            yield np.broadcast_to(np.asarray(node.evaluate(env, NumpyField, branch), dtype=float), shape)


def _right(node: Expr, env: dict[str, np.ndarray], wanted: np.ndarray) -> np.ndarray:
    """Say at which samples one of the formula's branches is the angle."""
    good = np.zeros(len(wanted), dtype=bool)
    for value in branch_values(node, env, wanted.shape):
        off = np.abs(wrapped(value - wanted))
        good |= np.where(np.isfinite(off), off, 9.0) < ANGLE_TOLERANCE
    return good


def judge_joint(ev: Evidence, claim: Claim) -> Verdict:
    """Judge a formula for a joint angle, given the pose and the joints before it at their right values.

    Keys: joint or for, is, where, frame.
    """
    ev = ev.holding(claim)
    name, angle = read_angle(ev, claim)
    if not isinstance(claim["is"], str):
        raise claim.error("is must be one formula; write its branches with +-")
    node = ev.parse(claim["is"], claim.where)
    claim = claim.reads(f"{name} = {claim['is']}" + "".join(f", {k} = {v}" for k, v in claim.where.items()))
    frame = parse_product(claim["frame"], ev.model.n) if claim.get("frame") else None
    env = ev.environment(frame)
    wanted = np.asarray(angle.evaluate(env), dtype=float)
    good = _right(node, env, wanted)
    own = ev.samples.nominal
    if good.all() or good[own].all():
        return _joint_holds(ev, claim, node, env, angle, wanted, frame)
    details: list[tuple[str, str]] = []
    vanish = zero_denominators(node, env)
    bad = np.flatnonzero(~good & own)
    if vanish:
        details.append(("undefined", f"the denominator {vanish[0]} is zero for all joints"))
    elif len(bad):
        details.append(("counter-example", _angle_example(ev, node, env, wanted, int(bad[0]))))
    region = find_region(good, region_features(ev.model.n, env, list(ev.definitions)))
    goal = ev.goal(wanted, angle=True, frame=frame)
    near = slips(node, ev.model.values, ev.model.n, tuple(ev.definitions), angle=True)
    found = search(goal, node, near, seconds=ev.seconds)
    slip = reading = ""
    if found.best:
        slip, reading = found.best.kind, str(found.best.tree)
        details += [("nearest right reading", f"{name} = {reading}"), ("the slip", found.best.says)]
    else:
        details.append(("the slip", "no single slip explains it" + found.closest("poses")))
    details.append(("tried", tried_text(found)))
    if region:
        return claim.partly(f"Holds only where {region}.", details, slip, reading)
    if good.mean() > 0.1:
        share = f"{100 * good.mean():.0f}% of the poses"
        return claim.partly(f"Holds at {share} only; no simple region was found.", details, slip, reading)
    sentence = f"Wrong: gives the joint's angle at {int(good.sum())} of {len(good)} poses."
    if vanish:
        sentence = "Wrong: undefined, because it divides by zero for all joints."
    return claim.wrong(sentence, details, slip, reading)


def _angle_example(ev: Evidence, node: Expr, env: dict[str, np.ndarray], wanted: np.ndarray, k: int) -> str:
    values = [np.degrees(wrapped(v[k])) for v in branch_values(node, env, wanted.shape)]
    shown = " or ".join(f"{v:.4f}" if np.isfinite(v) else "nothing (undefined)" for v in values)
    return f"at {ev.at(k)}: the formula gives {shown} deg, right is {np.degrees(wrapped(wanted[k])):.4f} deg"


def _joint_holds(
    ev: Evidence, claim: Claim, node: Expr, env: dict, angle: Expr, wanted: np.ndarray, frame: Product | None
) -> Verdict:
    digits = agreeing_digits(ev.model, ev.samples, ev.definitions, node, angle, angle=True) if frame is None else None
    more = f"; at 50-digit arithmetic it agrees to {digits} digits" if digits else ""
    held = f"right at {len(wanted)} of {len(wanted)} poses{more}"
    free = [group for group in undetermined(ev) if any(f"theta{j}" == str(angle) for j in group)]
    if free:
        names = " and ".join(f"theta{j}" for j in sorted(free[0]))
        return claim.partly(
            f"True, but it determines nothing: a pose does not tell {names} apart; any value of one fits with another.",
            digits=digits,
        )
    if not has_branch(node):
        return claim.holds(f"Holds: {held}.", digits=digits)
    upper = np.abs(wrapped(next(branch_values(node, env, wanted.shape)) - wanted)) < ANGLE_TOLERANCE
    region = find_region(upper, region_features(ev.model.n, env, list(ev.definitions)))
    known = f"the upper sign belongs to {region}" if region else ""
    details = [("branch", known or "which sign belongs to a solution follows no simple region")]
    both, why = _both_signs(ev, node, angle, frame, claim.get("task") == "position")
    if why:
        details.append(("both signs", why))
    if both is False:
        return claim.partly(
            f"Holds on one branch only: the right angle is always one of the two ({held}), but the other sign is no "
            "solution with the joints before it; the formula does not say which.",
            details,
            "branch",
            digits=digits,
        )
    return claim.holds(f"Holds with its two branches: {held}.", details, digits=digits)


def _both_signs(
    ev: Evidence, node: Expr, angle: Expr, frame: Product | None, position: bool
) -> tuple[bool | None, str]:
    """Say whether, with the joints the formula uses held, both signs can be completed to solutions of the pose."""
    wanted = ANGLE.match(str(angle))
    part = ev.model.between(str(frame)) if frame is not None else (ev.model, 0)
    if not wanted or part is None:
        return None, ""
    model, before = part
    joint = int(wanted.group(1)) - before
    poses = value_of(frame, ev.samples.frames) if frame is not None else ev.samples.frames["T"]
    used = {int(m.group(1)) for m in map(ANGLE.match, node.substitute(ev.definitions).symbols()) if m}
    given = {j for j in used if before < j <= before + model.n and j - before != joint}
    values = wrapped(np.array(list(branch_values(node, ev.environment(frame), (len(poses),)))))
    checked = both = 0
    for k in np.flatnonzero(ev.samples.nominal)[:SOLVER_POSES]:
        q = ev.samples.q[k, before : before + model.n]
        if not np.all(np.isfinite(values[:, k])) or abs(wrapped(values[0, k] - values[1, k])) < 1e-6:
            continue
        other = max(values[:, k], key=lambda v: abs(wrapped(v - q[joint - 1])))
        held = {j - before: q[j - before - 1] for j in given} | {joint: other}
        checked += 1
        both += completes(model, poses[k], held, q, position=position)
    if not checked:
        return None, ""
    words = "for the same " + " and ".join(f"theta{j}" for j in sorted(given)) if given else "of the pose"
    if both == checked:
        return True, f"both are solutions {words}, at {both} of {checked} poses"
    if both == 0:
        return False, f"only one is a solution {words}, at all of {checked} poses"
    return None, f"both are solutions {words} at {both} of {checked} poses"


def judge_together(ev: Evidence, claim: Claim) -> Verdict:
    """Judge formulas for several joints that must be right at the same time.

    Keys: is, a table of joint = formula; where; frame.
    """
    frame = parse_product(claim["frame"], ev.model.n) if claim.get("frame") else None
    env = ev.environment(frame)
    features = region_features(ev.model.n, env, list(ev.definitions))
    right = {}
    for name, text in claim["is"].items():
        wanted = np.asarray(ev.parse(name).evaluate(env), dtype=float)
        right[name] = _right(ev.parse(str(text), claim.where), env, wanted)
    good = np.logical_and.reduce(list(right.values()))
    claim = claim.reads("; ".join(f"{k} = {v}" for k, v in claim["is"].items()))
    if good.all():
        return claim.holds(f"Holds together: all are right at {len(good)} of {len(good)} poses.")
    details = []
    for name, mask in right.items():
        region = find_region(mask, features)
        where = f", those with {region}" if region else ""
        details.append((name, f"right at {int(mask.sum())} of {len(mask)} poses{where}"))
    k = int(np.flatnonzero(~good)[0])
    each = ", ".join(f"{name} {'right' if mask[k] else 'wrong'}" for name, mask in right.items())
    details.append(("counter-example", f"at {ev.at(k)}: {each}"))
    if not good.any():
        return claim.wrong(f"Wrong: never right together, at 0 of {len(good)} poses.", details, "branch")
    region = find_region(good, features)
    where = f"where {region}" if region else f"at {100 * good.mean():.0f}% of the poses"
    return claim.partly(f"Holds together only {where}.", details, "branch")
