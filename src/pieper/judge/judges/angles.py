"""Judges of inverse kinematics: a formula for a joint with its branches, formulas that must hold together, a whole
procedure."""

from __future__ import annotations

import re

import numpy as np

from pieper.algebra.tree import ANGLE, NUMPY, Node, evaluate, substitute
from pieper.errors import InputError, PieperError
from pieper.judge.difference import agreeing_digits
from pieper.judge.evidence import SOLVER_POSES, Evidence, tried_text
from pieper.judge.judges.freedom import completes, undetermined
from pieper.judge.matrices import parse_product, value_of
from pieper.judge.model import evaluate_samples
from pieper.judge.regions import find_region, region_features, zero_denominators
from pieper.judge.search.search import ANGLE_TOLERANCE, search
from pieper.judge.slips.formula_slips import slips
from pieper.judge.verdict import HOLDS, PARTLY, WRONG, Verdict


def _wrap(x):
    return (x + np.pi) % (2 * np.pi) - np.pi


def _angle(ev: Evidence, claim: dict) -> tuple[str, Node]:
    """Read which angle a claim is about: joint = 4, or for = "theta1+theta2"."""
    if "joint" in claim:
        joint = claim["joint"]
        if not isinstance(joint, int) or not 1 <= joint <= ev.model.n:
            raise InputError(
                f"claim {claim['id']}: joint {joint!r} does not exist; the arm has joints 1 to {ev.model.n}",
                claim=claim["id"],
            )
        return f"theta{joint}", ev.parse(f"theta{joint}")
    if "for" not in claim:
        raise InputError(
            f'claim {claim["id"]}: say which joint, as joint = 4 or for = "theta1+theta2"', claim=claim["id"]
        )
    return str(claim["for"]), ev.parse(str(claim["for"]))


def judge_joint(ev: Evidence, claim: dict) -> Verdict:
    """Judge a formula for a joint angle, given the pose and the joints before it at their right values (keys joint or
    for, is, where, frame)."""
    ev = ev.holding(claim)
    name, angle = _angle(ev, claim)
    if not isinstance(claim["is"], str):
        raise InputError(f"claim {claim['id']}: is must be one formula; write its branches with +-", claim=claim["id"])
    node = ev.parse(claim["is"], claim.get("where"))
    text = f"{name} = {claim['is']}" + "".join(f", {k} = {v}" for k, v in (claim.get("where") or {}).items())
    frame = parse_product(claim["frame"], ev.model.n) if claim.get("frame") else None
    env = ev.environment(frame)
    wanted = np.asarray(evaluate(angle, env), dtype=float)
    good = _good(ev, node, env, wanted)
    says, own = claim.get("says", ""), ev.samples.nominal
    if good.all() or good[own].all():
        return _joint_holds(ev, claim, text, says, node, env, angle, wanted, frame)
    details: list[tuple[str, str]] = []
    vanish = zero_denominators(node, env, evaluate)
    bad = np.flatnonzero(~good & own)
    if vanish:
        details.append(("undefined", f"the denominator {vanish[0]} is zero for all joints"))
    elif len(bad):
        details.append(("counter-example", _angle_example(ev, node, env, wanted, int(bad[0]))))
    features = region_features(ev.model.n, env, list(ev.definitions))
    region = find_region(good, features)
    target = ev.target(wanted, angle=True, frame=frame)
    found = search(
        target, node, slips(node, ev.model.values, ev.model.n, tuple(ev.definitions), angle=True), seconds=ev.seconds
    )
    slip = reading = ""
    if found.best:
        slip, reading = found.best.kind, str(found.best.tree)
        details += [("nearest right reading", f"{name} = {reading}"), ("the slip", found.best.says)]
    else:
        near = (
            f"; closest: {found.nearest[0].says} (right at {100 * found.nearest[1]:.0f}% of the poses)"
            if found.nearest
            else ""
        )
        details.append(("the slip", "no single slip explains it" + near))
    details.append(("tried", tried_text(found)))
    if region:
        return Verdict(claim["id"], text, PARTLY, f"Holds only where {region}.", says, tuple(details), slip, reading)
    if good.mean() > 0.1:
        return Verdict(
            claim["id"],
            text,
            PARTLY,
            f"Holds at {100 * good.mean():.0f}% of the poses only; no simple region was found.",
            says,
            tuple(details),
            slip,
            reading,
        )
    sentence = f"Wrong: gives the joint's angle at {int(good.sum())} of {len(good)} poses."
    if vanish:
        sentence = "Wrong: undefined, because it divides by zero for all joints."
    return Verdict(claim["id"], text, WRONG, sentence, says, tuple(details), slip, reading)


def _good(ev: Evidence, node: Node, env: dict, wanted) -> np.ndarray:
    good = np.zeros(len(wanted), dtype=bool)
    for branch in (1, -1):
        with np.errstate(all="ignore"):
            off = np.abs(_wrap(np.asarray(evaluate(node, env, NUMPY, branch), dtype=float) - wanted))
        good |= np.where(np.isfinite(off), off, 9.0) < ANGLE_TOLERANCE
    return good


def _angle_example(ev: Evidence, node: Node, env: dict, wanted, k: int) -> str:
    values = []
    for branch in (1, -1) if node.has_branch() else (1,):
        with np.errstate(all="ignore"):
            value = np.degrees(_wrap(np.broadcast_to(evaluate(node, env, NUMPY, branch), wanted.shape)[k]))
        values.append("nothing (undefined)" if not np.isfinite(value) else f"{value:.4f}")
    return (
        f"at {ev.at(k)}: the formula gives {' or '.join(values)} deg, right is {np.degrees(_wrap(wanted[k])):.4f} deg"
    )


def _joint_holds(ev: Evidence, claim, text, says, node, env, angle, wanted, frame) -> Verdict:
    digits = agreeing_digits(ev.model, ev.samples, ev.definitions, node, angle, angle=True) if frame is None else None
    more = f"; at 50-digit arithmetic it agrees to {digits} digits" if digits else ""
    free = [group for group in undetermined(ev) if any(f"theta{j}" == str(angle) for j in group)]
    held = f"right at {len(wanted)} of {len(wanted)} poses{more}"
    if free:
        names = " and ".join(f"theta{j}" for j in sorted(free[0]))
        sentence = (
            f"True, but it determines nothing: a pose does not tell {names} apart; any value of one fits with another."
        )
        return Verdict(claim["id"], text, PARTLY, sentence, says, digits=digits)
    if not node.has_branch():
        return Verdict(claim["id"], text, HOLDS, f"Holds: {held}.", says, digits=digits)
    with np.errstate(all="ignore"):
        upper = np.abs(_wrap(evaluate(node, env, NUMPY, 1) - wanted)) < ANGLE_TOLERANCE
    region = find_region(upper, region_features(ev.model.n, env, list(ev.definitions)))
    details = [
        (
            "branch",
            f"the upper sign belongs to {region}"
            if region
            else "which sign belongs to a solution follows no simple region",
        )
    ]
    verdict, why = _both_signs(ev, node, angle, frame, claim.get("task") == "position")
    if why:
        details.append(("both signs", why))
    if verdict is False:
        return Verdict(
            claim["id"],
            text,
            PARTLY,
            f"Holds on one branch only: the right angle is always one of the two ({held}), but the other sign is no "
            "solution with the joints before it; the formula does not say which.",
            says,
            tuple(details),
            "branch",
            digits=digits,
        )
    return Verdict(
        claim["id"], text, HOLDS, f"Holds with its two branches: {held}.", says, tuple(details), digits=digits
    )


def _both_signs(ev: Evidence, node: Node, angle: Node, frame, position: bool) -> tuple[bool | None, str]:
    """Say whether, with the joints the formula uses held, both signs can be completed to solutions of the pose."""
    target = ANGLE.match(str(angle))
    part = ev.model.between(str(frame)) if frame is not None else (ev.model, 0)
    if not target or part is None:
        return None, ""
    model, before = part
    joint = int(target.group(1)) - before
    poses = value_of(frame, ev.samples.frames) if frame is not None else ev.samples.frames["T"]
    given = {int(ANGLE.match(s).group(1)) for s in substitute(node, ev.definitions).symbols() if ANGLE.match(s)}
    given = {j for j in given if before < j <= before + model.n and j - before != joint}
    env = ev.environment(frame)
    checked = both = 0
    with np.errstate(all="ignore"):
        values = np.array([np.broadcast_to(_wrap(evaluate(node, env, NUMPY, b)), len(poses)) for b in (1, -1)])
    for k in np.flatnonzero(ev.samples.nominal)[:SOLVER_POSES]:
        q = ev.samples.q[k, before : before + model.n]
        if not np.all(np.isfinite(values[:, k])) or abs(_wrap(values[0, k] - values[1, k])) < 1e-6:
            continue
        other = max(values[:, k], key=lambda v: abs(_wrap(v - q[joint - 1])))
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


def judge_together(ev: Evidence, claim: dict) -> Verdict:
    """Judge formulas for several joints that must be right at the same time (key is: a table of joint = formula;
    where, frame)."""
    frame = parse_product(claim["frame"], ev.model.n) if claim.get("frame") else None
    env = ev.environment(frame)
    masks, features = {}, region_features(ev.model.n, env, list(ev.definitions))
    for name, text in claim["is"].items():
        node = ev.parse(str(text), claim.get("where"))
        wanted = np.asarray(evaluate(ev.parse(name), env), dtype=float)
        masks[name] = _good(ev, node, env, wanted)
    good = np.logical_and.reduce(list(masks.values()))
    text = "; ".join(f"{k} = {v}" for k, v in claim["is"].items())
    says = claim.get("says", "")
    if good.all():
        return Verdict(
            claim["id"], text, HOLDS, f"Holds together: all are right at {len(good)} of {len(good)} poses.", says
        )
    details = []
    for name, mask in masks.items():
        region = find_region(mask, features)
        details.append(
            (name, f"right at {int(mask.sum())} of {len(mask)} poses" + (f", those with {region}" if region else ""))
        )
    k = int(np.flatnonzero(~good)[0])
    details.append(
        (
            "counter-example",
            f"at {ev.at(k)}: " + ", ".join(f"{n} {'right' if m[k] else 'wrong'}" for n, m in masks.items()),
        )
    )
    region = find_region(good, features)
    if not good.any():
        return Verdict(
            claim["id"],
            text,
            WRONG,
            f"Wrong: never right together, at 0 of {len(good)} poses.",
            says,
            tuple(details),
            "branch",
        )
    where = f"where {region}" if region else f"at {100 * good.mean():.0f}% of the poses"
    return Verdict(claim["id"], text, PARTLY, f"Holds together only {where}.", says, tuple(details), "branch")


def judge_procedure(ev: Evidence, claim: dict) -> Verdict:
    """Follow formulas in their order with every combination of branches, and count the solutions that close under
    forward kinematics.

    Keys: steps, a list of {joint, is} where `is` may be a list of alternatives; where.
    """
    model, samples = ev.model, ev.samples
    rows = np.flatnonzero(samples.nominal)[:40]
    fixed = {k: v[rows] for k, v in samples.env.items() if not ANGLE.match(k)}
    candidates = [{}]
    lines = []
    for step in claim["steps"]:
        name, angle = _angle(ev, {**step, "id": claim["id"]})
        texts = step["is"] if isinstance(step["is"], list) else [step["is"]]
        lines.append(f"{name} = " + " or ".join(map(str, texts)))
        found = re.fullmatch(r"theta(\d+)", str(angle))
        if not found:
            raise InputError(f"claim {claim['id']}: a step solves for one joint, not for {name}", claim=claim["id"])
        nodes = [
            substitute(ev.parse(str(t), {**(claim.get("where") or {}), **(step.get("where") or {})}), ev.definitions)
            for t in texts
        ]
        grown = []
        for known in candidates:
            for node in nodes:
                missing = {s for s in node.symbols() if ANGLE.match(s)} - set(known)
                if missing:
                    raise InputError(
                        f"claim {claim['id']}: the step for {name} uses {', '.join(sorted(missing))}, which "
                        f"no step before it gives",
                        claim=claim["id"],
                    )
                for branch in (1, -1) if node.has_branch() else (1,):
                    with np.errstate(all="ignore"):
                        value = np.broadcast_to(
                            np.asarray(evaluate(node, {**fixed, **known}, NUMPY, branch), dtype=float), rows.shape
                        )
                    grown.append({**known, str(angle): _wrap(value)})
        candidates = grown
        if len(candidates) > 512:
            raise InputError(f"claim {claim['id']}: more than 512 combinations of branches", claim=claim["id"])
    if any(len(c) != model.n for c in candidates):
        raise InputError(
            f"claim {claim['id']}: the steps give {len(candidates[0])} of {model.n} joints", claim=claim["id"]
        )
    found, truth = _count_candidates(ev, rows, candidates)
    text = "; ".join(lines)
    says = claim.get("says", "")
    detail = [
        (
            "candidates",
            f"{len(candidates)} combinations of branches at {len(rows)} poses: {int(found.sum())} of "
            f"{len(rows) * len(candidates)} close under forward kinematics",
        )
    ]
    spread = ", ".join(f"{v} at {100 * np.mean(found == v):.0f}%" for v in sorted(set(found.tolist())))
    if truth is not None:
        detail.append(("solutions", f"found {spread} of the poses; there are {sorted(set(truth.tolist()))}"))
        if np.array_equal(found, truth):
            return Verdict(
                claim["id"],
                text,
                HOLDS,
                f"Holds: finds all {int(truth.max())} solutions at {len(rows)} of {len(rows)} poses.",
                says,
                tuple(detail),
            )
    else:
        detail.append(("solutions", f"found {spread} of the poses; how many there are was not checked"))
    if not found.any():
        return Verdict(
            claim["id"], text, WRONG, f"Wrong: finds no solution at any of {len(rows)} poses.", says, tuple(detail)
        )
    none = np.mean(found == 0)
    return Verdict(
        claim["id"],
        text,
        PARTLY,
        f"Finds {found.min()} to {found.max()} solutions of a pose"
        + (f", none at {100 * none:.0f}% of them" if none else "")
        + ".",
        says,
        tuple(detail),
    )


def _count_candidates(ev: Evidence, rows, candidates) -> tuple[np.ndarray, np.ndarray | None]:
    """Return the number of distinct candidates that reproduce each pose, and of solutions that exist (None when the
    solver cannot say)."""
    model = ev.model
    want = ev.samples.frames["T"][rows]
    valid = []
    for known in candidates:
        q = np.stack([known[f"theta{j}"] for j in range(1, model.n + 1)], axis=1)
        T = evaluate_samples(model, np.nan_to_num(q, nan=0.3)).frames["T"]
        close = np.abs(T - want).reshape(len(rows), -1).max(1) < 1e-6 * max(1.0, model.length())
        valid.append((q, close & np.isfinite(q).all(1)))
    counts = np.zeros(len(rows), dtype=int)
    for k in range(len(rows)):
        kept: list[np.ndarray] = []
        for q, good in valid:
            if good[k] and all(np.abs(_wrap(q[k] - other)).max() > 1e-6 for other in kept):
                kept.append(q[k])
        counts[k] = len(kept)
    try:
        truth = np.array([len(ev.solutions_at(int(k))) for k in rows]) if model.solver is not None else None
    except (PieperError, AttributeError, NotImplementedError, ImportError):
        truth = None
    return counts, truth
