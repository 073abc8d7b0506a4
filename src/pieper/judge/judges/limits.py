"""Judges of ranges: a joint's printed one, against a path the arm is said to follow, and a formula's."""

from __future__ import annotations

import numpy as np

from pieper.algebra.expression import Expr
from pieper.judge.claim import Claim
from pieper.judge.climbing import climbed
from pieper.judge.dimensions import power_of_length
from pieper.judge.evidence import Evidence, number, wrapped
from pieper.judge.judges.tables import ZEROS
from pieper.judge.model import ArmModel
from pieper.judge.numbers import UNITS, unit_of
from pieper.judge.products import Product
from pieper.judge.samples import Samples, pose_of, samples_at
from pieper.judge.verdict import Verdict
from pieper.tolerances import CENTRAL_STEP, JUDGED_ZERO, LIMIT_DAMPING, LIMIT_FOUND, LIMIT_REACHED

BOUNDS = 1000  # joint vectors at which a formula's range is looked at


def judge_limit(ev: Evidence, claim: Claim) -> Verdict:
    """Judge a joint's printed range (keys joint, range_deg, path = {from, to, n}, unit).

    The tool's orientation is left free: what is out of reach then is out of reach for every orientation.
    """
    model, joint = ev.model, claim.joint(ev.model.n)
    low, high = (float(v) for v in claim["range_deg"])
    if low >= high:
        raise claim.error(f"range_deg must be [lower, upper], got {claim['range_deg']}", "range_deg")
    path = claim.get("path")
    if not isinstance(path, dict) or "from" not in path or "to" not in path:
        raise claim.error("a limit is judged against a path; give path = { from = [x, y, z], to = [x, y, z] }")
    unit = unit_of(claim, model)
    factor = UNITS[unit] / UNITS[model.unit]
    ends = np.array([path["from"], path["to"]], dtype=float) * factor
    tolerance = LIMIT_FOUND * model.length() / factor

    def gaps(lower: float, upper: float) -> np.ndarray:
        return np.array([_closest(model, p, joint, np.radians([lower, upper])) for p in ends]) / factor

    claim = claim.reads(
        f"joint {joint} stays in {low:g} .. {high:g} deg on the way {path['from']} to {path['to']} {unit}"
    )
    off = gaps(low, high)
    if (off < tolerance).all():
        return claim.holds("Holds: both ends can be reached inside the range with some orientation of the tool.")
    maps = []
    for sign in (1, -1):
        for zero in ZEROS:
            lo, hi = sorted(sign * v + zero for v in (low, high))
            if (gaps(lo, hi) < tolerance).all():
                shift = f" {zero:+d} deg" if zero else ""
                maps.append(f"theta{joint} = {'-' if sign < 0 else ''}J{joint}{shift} in {lo:g} .. {hi:g} deg")
    bad = int(np.argmax(off))
    details = [
        (
            "counter-example",
            f"with theta{joint} in {low:g} .. {high:g} deg the tool comes no closer than {off[bad]:.4g} {unit} to the "
            f"path's {'last' if bad else 'first'} point, whatever its orientation",
        )
    ]
    if maps:
        found = ", or ".join(maps)
        details.append(("the slip", f"the maker's zero and sense of the joint; the path can be reached with {found}"))
    details.append(("tried", "both senses and zeros at 0, 90, 180, -90 deg"))
    sentence = "Wrong: the range cannot be that of this table's joint, for the path leaves it."
    return claim.wrong(sentence, details, "zero" if maps else "")


def judge_bounds(ev: Evidence, claim: Claim) -> Verdict:
    """Judge between which values a formula stays at all poses (keys is, between = [low, high], where, frame, when).

    The bounds are numbers, so that they are about this arm's own lengths. What is said of an open interval holds when
    the formula comes as near to an end as one likes.
    """
    ev = ev.holding(claim)
    low, high = (float(v) for v in claim["between"])
    node, frame = ev.parse(str(claim["is"]), claim.where), ev.frame(claim)
    claim = claim.reads(f"{claim['is']} lies in {low:g} .. {high:g}")
    slack = JUDGED_ZERO * max(1.0, abs(low), abs(high))

    def inside(values: np.ndarray) -> np.ndarray:
        return (values > low - slack) & (values < high + slack)

    drawn = ev.drawn(BOUNDS, 271_828, {})
    values = _values(drawn, node, frame)
    fine = inside(values)
    ends = [_furthest(ev, node, frame, drawn.samples.q, sense) for sense in (-1, 1)]
    least, most = (float(_values(end, node, frame)[0]) for end in ends)
    met = f"the values met go from {number(least)} to {number(most)}"
    right, tried = int(fine.sum()), len(fine)
    found = not inside(np.array([least, most])).all()
    if fine.all() and not found:
        others = ev.drawn(BOUNDS, 271_828)
        any_arm = power_of_length(ev, node) == 0 and inside(_values(others, node, frame)).all()
        whose = "" if not ev.model.values else ", for any lengths" if any_arm else " with this arm's lengths"
        said = f"Holds: inside at {tried} of {tried} joint vectors{whose}, and at those searched for; {met}."
        return claim.holds(said, right=right, tried=tried)
    beyond = np.nan_to_num([low - least, most - high])
    at, k = (ends[int(np.argmax(beyond))], 0) if found else (drawn, int(np.argmin(fine)))
    worst = float(_values(at, node, frame)[k])
    example = f"at {at.at(k)}: it is {number(worst) if np.isfinite(worst) else 'undefined'}"
    details = [("counter-example", example)]
    if fine.mean() < 1 / 2:
        said = f"Wrong: inside at {right} of {tried} joint vectors; {met}."
        return claim.wrong(said, details, right=right, tried=tried)
    if fine.all():
        said = f"Inside at {tried} of {tried} random joint vectors, and outside at one that was searched for; {met}."
        return claim.partly(said, details, right=right, tried=tried)
    share = f"{100 * fine.mean():z.0f}% of the joint vectors"
    return claim.partly(f"Inside at {share} only; {met}.", details, right=right, tried=tried)


def _values(ev: Evidence, node: Expr, frame: Product | None) -> np.ndarray:
    with np.errstate(all="ignore"):
        value = np.asarray(node.evaluate(ev.environment(frame)), dtype=float)
    return np.broadcast_to(value, (len(ev.samples.q),))


def _furthest(ev: Evidence, node: Expr, frame: Product | None, q: np.ndarray, sense: int) -> Evidence:
    """Where a formula is largest (sense 1) or smallest (-1): one joint vector, of few digits where that is as good.

    Slides stay among those of the joint vectors `q` from which it is looked for: how far they go no table says.
    """
    turning = np.array([not ev.model.sliding(j + 1) for j in range(ev.model.n)])
    shortest, longest = (np.where(turning, end, limit) for end, limit in ((-np.inf, q.min(0)), (np.inf, q.max(0))))

    def value(tried: np.ndarray) -> np.ndarray:
        there = ev.on(_filled(ev, tried))
        reached = np.all((tried >= shortest) & (tried <= longest), axis=1)
        meant = np.logical_and.reduce([reached, *(c.met(there.samples.env) for c in ev.when)])
        return np.nan_to_num(np.where(meant, sense * _values(there, node, frame), -np.inf), nan=-np.inf)

    found, reached = climbed(ev.model, value, q, held=ev.held)
    best = found[[int(np.argmax(reached))]]
    best = np.where(turning, wrapped(best), best)
    shown = np.where(turning, np.radians(np.round(np.degrees(best), 1)), np.round(best, 6))
    same = number(float(value(shown)[0])) == number(float(reached.max()))
    return ev.on(_filled(ev, shown if same else best))


def _filled(ev: Evidence, q: np.ndarray) -> Samples:
    samples = samples_at(ev.model, q)
    ev.pick(samples.env, samples.frames)
    ev.fill(samples.env)
    return samples


def _closest(model: ArmModel, point: np.ndarray, joint: int, limits: np.ndarray) -> float:
    """Return the least distance of the tool from a point, any orientation, one joint limited.

    Damped Gauss-Newton from many starts.
    """
    rng = np.random.default_rng(7)
    k = joint - 1
    q = rng.uniform(-np.pi, np.pi, (64, model.n))
    q[:, k] = rng.uniform(limits[0], limits[1], len(q))
    step, size = CENTRAL_STEP, model.length()
    best = np.inf
    for _ in range(80):
        moved = np.repeat(q[:, None], model.n + 1, axis=1)
        moved[:, np.arange(model.n), np.arange(model.n)] += step
        p = pose_of(model, moved.reshape(-1, model.n))[:, :3, 3].reshape(len(q), model.n + 1, 3)
        here = p[:, -1]
        best = min(best, float(np.linalg.norm(here - point, axis=1).min()))
        if best < LIMIT_REACHED * model.length():
            break
        J = (p[:, :-1] - here[:, None]).transpose(0, 2, 1) / step
        pull = np.einsum("kij,ki->kj", J, point - here)[:, k]
        stuck = ((q[:, k] <= limits[0]) & (pull < 0)) | ((q[:, k] >= limits[1]) & (pull > 0))
        J[stuck, :, k] = 0  # at a stop the other joints must do it alone
        # damping that follows the error converges inside the reach and settles at its edge (Sugihara, 2011)
        damp = (0.5 * size * np.linalg.norm(point - here, axis=1) + LIMIT_DAMPING * size**2)[:, None, None] * np.eye(3)
        dq = np.einsum(
            "kji,kj->ki", J, np.linalg.solve(J @ J.transpose(0, 2, 1) + damp, (point - here)[..., None])[..., 0]
        )
        q += np.clip(dq, -0.5, 0.5)
        q[:, k] = np.clip(q[:, k], *limits)
    return best
