"""How many solutions a pose is said to have: everywhere, at most, or where a condition holds."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

import numpy as np

from pieper.errors import PieperError
from pieper.judge.claim import Claim
from pieper.judge.climbing import climbed
from pieper.judge.evidence import Evidence
from pieper.judge.numbers import UNITS
from pieper.judge.samples import Samples, pose_symbols, samples_at
from pieper.judge.verdict import HOLDS, Verdict
from pieper.tolerances import CONDITION_MET
from pieper.words_by_number import plural

COUNTED = 40  # random poses
MORE = 400  # of them, where a largest number was not met
FULL = 6  # joints of an arm that can take every pose
LOOKED = 2048  # joint vectors at which a condition said to leave no solution is tried


def judge_count(ev: Evidence, claim: Claim) -> Verdict:
    """Judge how many solutions a pose has, at random poses the arm can reach (keys count, at_most, task, when).

    A page about a short arm counts the solutions of a position and seldom says so; where its number is that of the
    positions and the claim names no task, the verdict says which it is.
    """
    count, most = claim.whole("count"), bool(claim.get("at_most"))
    if ev.model.solver is None:
        raise claim.error("this arm's table cannot be given to the solver, so its solutions cannot be counted")
    task = claim.get("task")
    where = f" where {claim['when']}" if "when" in claim else ""
    much = f"{'at most ' if most else ''}{plural(count, 'solution') if count else 'no solution'}"
    claim = claim.reads(f"a {'position' if task == 'position' else 'pose'} has {much}{where}")
    if not count:
        return _none(ev, claim)
    if where:
        held = ev.holding(claim)
        ev = held.on(held.draw(vary={}))
    try:
        first = _of(ev, claim, count, most, task)
        if task is None and ev.model.n < FULL and first.status != HOLDS:
            return _of_positions(ev, claim, count, most, first)
    except PieperError as error:
        return claim.partly(f"Could not be checked: {error}")
    return first


def _of(ev: Evidence, claim: Claim, count: int, most: bool, task: str | None) -> Verdict:
    """The verdict for one task."""
    found = _counted(ev, task or "pose")
    total = sum(found.values())
    what = "positions" if task == "position" else "poses"
    details = [("solutions found", f"{_spread(found)} of {total} random {what}")]
    if most:
        return _at_most(ev, claim, count, task or "pose", found, details)
    if set(found) == {count}:
        return claim.holds(f"Holds: {plural(count, 'solution')} at {total} of {total} random {what}.", details)
    if max(found) == count:
        return claim.partly(f"Holds as the largest number only; there are {_spread(found)} of the {what}.", details)
    never = "" if count in found else f", never {count}"
    return claim.wrong(f"Wrong: there are {_spread(found)} of {total} random {what}{never}.", details)


def _at_most(
    ev: Evidence, claim: Claim, count: int, task: str, found: Mapping[int, int], details: list[tuple[str, str]]
) -> Verdict:
    """The verdict on a largest number: it is met somewhere, or it is too large or too small."""
    what = "positions" if task == "position" else "poses"
    if max(found) < count:
        more = ev.on(ev.draw(MORE, seed=77, vary={}))
        found = _counted(more, task, MORE)
        details = [("solutions found", f"{_spread(found)} of {sum(found.values())} random {what}")]
    largest, share = max(found), 100 * found[max(found)] / sum(found.values())
    if largest > count:
        return claim.wrong(f"Wrong: there are up to {largest}, at {share:z.0f}% of the random {what}.", details)
    if largest == count:
        return claim.holds(f"Holds: never more, and {count} at {share:z.0f}% of the random {what}.", details)
    assert ev.model.solver is not None
    tight = ev.model.solver.most(task)
    if tight == count:
        said = f"Holds as the bound that the solver has; {largest} is the most at {sum(found.values())} random {what}."
        return claim.holds(said, details)
    if tight < count:
        return claim.partly(
            f"True, but not the largest number: no {what[:-1]} of this arm has more than {tight}.", details
        )
    return claim.partly(f"True at every random one of the {what}; more than {largest} at none of them.", details)


def _of_positions(ev: Evidence, claim: Claim, count: int, most: bool, first: Verdict) -> Verdict:
    """The verdict for positions where it holds for them, else that for poses with what is so of positions."""
    T = ev.samples.frames["T"][int(np.flatnonzero(ev.samples.nominal)[0])].copy()
    T[:3, 3] *= UNITS[ev.model.unit]
    try:
        if ev.model.solver is None or ev.model.solver.endless(T, "position"):
            return first
        verdict = _of(ev, claim, count, most, "position")
        poses = _spread(_counted(ev, "pose"))
    except PieperError:
        return first
    if verdict.status != HOLDS:
        told = [("positions", f'{words} (task = "position")') for _, words in verdict.details[:1]]
        return replace(first, details=(*first.details, *told))
    return claim.holds(
        f"{verdict.sentence.replace('Holds:', 'Holds for positions:')} With the orientation of a pose asked for too "
        f'there are {poses} of the poses; task = "position" says which is meant.',
        verdict.details,
    )


def _none(ev: Evidence, claim: Claim) -> Verdict:
    """The verdict on a condition under which there is said to be no solution: no reachable pose may meet it.

    It is tried at random joint vectors, and then approached from those that come nearest to it.
    """
    if "when" not in claim:
        return claim.wrong("Wrong: every pose that some joint vector makes has a solution.")
    held = ev.holding(claim)
    conditions = held.when

    def margin(env: Mapping[str, np.ndarray]) -> np.ndarray:
        with np.errstate(all="ignore"):
            sides = [
                (np.asarray(c.more.evaluate(env), float), np.asarray(c.less.evaluate(env), float)) for c in conditions
            ]
            gaps = [more - less for more, less in sides]
            return np.nan_to_num(np.min(np.broadcast_arrays(env["theta1"], *gaps)[1:], axis=0), nan=-np.inf)

    drawn = ev.draw(LOOKED, seed=404, vary={})
    best = margin(drawn.env)
    q, reached = climbed(ev.model, lambda tried: margin(_filled(ev, tried).env), drawn.q)
    size = 1.0 + max((abs(float(v)) for v in ev.model.values.values()), default=0.0) ** 2
    share = float((best > CONDITION_MET * size).mean())
    if reached.max() > CONDITION_MET * size:
        at = ev.on(_filled(ev, q[[int(reached.argmax())]])).at(0)
        often = f"at {100 * share:z.0f}% of {LOOKED} random joint vectors" if share else "by joint vectors searched for"
        return claim.wrong(
            f"Wrong: the condition is met {often}, and what a joint vector makes has a solution.",
            [("counter-example", at)],
        )
    return _outside(ev, claim, margin)


def _outside(ev: Evidence, claim: Claim, margin: Callable[[Mapping[str, np.ndarray]], np.ndarray]) -> Verdict:
    """The verdict where no reachable pose was found to meet the condition: others that meet it are looked for."""
    rng = np.random.default_rng(9)
    drawn = ev.draw(MORE, seed=405, vary={})
    T = drawn.frames["T"].copy()
    T[:, :3, 3] *= rng.uniform(0.0, 3.0, (len(T), 1))
    env = {**drawn.env, **pose_symbols(T)}
    ev.fill(env)
    others = env | {f"theta{j + 1}": rng.permutation(env[f"theta{j + 1}"]) for j in range(ev.model.n)}
    ev.fill(others)
    of_pose = np.array_equal(margin(env), margin(others))  # what speaks of joints says nothing of a pose without any
    met = np.flatnonzero(margin(env) > 0)[:COUNTED] if of_pose else []
    details = [("tried", f"{LOOKED} random joint vectors and those nearest to the condition")]
    said = f"Holds: no joint vector meets the condition, of {LOOKED} and those searched for"
    task = claim.get("task") or ("position" if ev.model.n < FULL else "pose")
    try:
        solved = sum(len(ev.solved(T[k], task)) > 0 for k in met)
    except PieperError:
        met, solved = [], 0
    if solved:
        return claim.wrong(
            f"Wrong: {solved} of {len(met)} random {task}s that meet the condition have solutions.", details
        )
    if not len(met):
        return claim.holds(f"{said}.", details)
    return claim.holds(f"{said}, and none of {len(met)} random {task}s that meet it has a solution.", details)


def _filled(ev: Evidence, q: np.ndarray) -> Samples:
    samples = samples_at(ev.model, q)
    ev.pick(samples.env, samples.frames)
    ev.fill(samples.env)
    return samples


def _counted(ev: Evidence, task: str, most: int = COUNTED) -> dict[int, int]:
    """How many solutions there are, and at how many random poses."""
    poses = [ev.samples.frames["T"][k] for k in np.flatnonzero(ev.samples.nominal)[:most]]
    counts = [len(ev.solved(T, task)) for T in poses]
    return {c: counts.count(c) for c in sorted(set(counts))}


def _spread(found: Mapping[int, int]) -> str:
    total = sum(found.values())
    return ", ".join(f"{c} at {100 * m / total:z.0f}%" for c, m in found.items())
