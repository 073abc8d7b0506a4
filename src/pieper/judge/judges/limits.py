"""Judges of ranges: a joint's printed one, against a path the arm is said to follow, and a formula's."""

from __future__ import annotations

import numpy as np

from pieper.judge.claim import Claim
from pieper.judge.evidence import Evidence, number
from pieper.judge.judges.tables import ZEROS
from pieper.judge.model import ArmModel
from pieper.judge.numbers import UNITS, unit_of
from pieper.judge.samples import pose_of
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
        raise claim.error(f"range_deg must be [lower, upper], got {claim['range_deg']}")
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

    What is said of an open interval holds when the formula comes as near to an end as one likes.
    """
    ev = ev.holding(claim)
    low, high = (float(v) for v in claim["between"])
    node, frame = ev.parse(str(claim["is"]), claim.where), ev.frame(claim)
    claim = claim.reads(f"{claim['is']} lies in {low:g} .. {high:g}")
    drawn = ev.drawn(BOUNDS, seed=271_828)
    with np.errstate(all="ignore"):
        values = np.broadcast_to(
            np.asarray(node.evaluate(drawn.environment(frame)), dtype=float), (len(drawn.samples.q),)
        )
    slack = JUDGED_ZERO * max(1.0, abs(low), abs(high))
    fine = (values > low - slack) & (values < high + slack)
    met = f"the values met go from {number(float(np.nanmin(values)))} to {number(float(np.nanmax(values)))}"
    right, tried = int(fine.sum()), len(fine)
    if fine.all():
        return claim.holds(f"Holds: inside at {tried} of {tried} joint vectors; {met}.", right=right, tried=tried)
    k = int(np.argmax(np.where(fine | ~np.isfinite(values), -np.inf, np.maximum(low - values, values - high))))
    details = [("counter-example", f"at {drawn.at(k)}{drawn.extra_lengths(k, node)}: it is {number(float(values[k]))}")]
    if fine.mean() < 1 / 2:
        said = f"Wrong: inside at {right} of {tried} joint vectors; {met}."
        return claim.wrong(said, details, right=right, tried=tried)
    share = f"{100 * fine.mean():.0f}% of the joint vectors"
    return claim.partly(f"Inside at {share} only; {met}.", details, right=right, tried=tried)


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
