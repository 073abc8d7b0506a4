"""Judge of a whole procedure: its formulas followed in their order, every combination of branches, and counted."""

from __future__ import annotations

import numpy as np

from pieper.algebra.formula import ANGLE, Mention
from pieper.errors import PieperError
from pieper.judge.claim import Claim
from pieper.judge.evidence import Evidence, wrapped
from pieper.judge.judges.angle_formula import branch_values, read_angle
from pieper.judge.known import known_in
from pieper.judge.samples import pose_of
from pieper.judge.verdict import Verdict
from pieper.tolerances import JUDGED_HOLDS
from pieper.words_by_number import plural

MAX_COMBINATIONS = 512
MOST_JOINTS = 6  # an arm of fewer cannot take every pose


def judge_procedure(ev: Evidence, claim: Claim) -> Verdict:
    """Follow formulas in their order and count the solutions that close under forward kinematics.

    Keys: steps, a list of {joint, is} where `is` may be a list of alternatives; where; task. Of a short arm whose task
    nobody names, a method that finds every solution of a position is right, and the verdict says that it is meant so.
    """
    n, samples = ev.model.n, ev.samples
    rows = np.flatnonzero(samples.nominal)[:40]
    moving = {*ev.letters, *ev.definitions, *ev.model.aliases}
    fixed = {k: v[rows] for k, v in samples.env.items() if not ANGLE.match(k) and k not in moving}
    candidates: list[dict[str, np.ndarray]] = [{}]
    given: set[str] = set()
    lines = []
    for keys in claim["steps"]:
        step = claim.part(claim.id, keys)
        name, angle = read_angle(ev, step)
        texts = step["is"] if isinstance(step["is"], list) else [step["is"]]
        lines.append(f"{name} = " + " or ".join(map(str, texts)))
        if not ANGLE.match(str(angle)):
            raise claim.error(f"a step solves for one joint, not for {name}", "steps")
        if str(angle) in given:
            raise claim.error(f"two steps give {name}; branches of one joint stand in its list", "steps")
        given.add(str(angle))
        where = {**claim.where, **step.where}
        grown = []
        for known in candidates:
            for node in [ev.parse(str(t), where).substitute(ev.definitions) for t in texts]:
                node = node.substitute({b: Mention(joint) for b, joint in ev.model.aliases.items()})
                picked = known_in(ev, node, angle)
                used = {s for s in node.symbols() if ANGLE.match(s)}
                missing = (used | {f"theta{j}" for joints in picked.values() for j in joints}) - set(known)
                if missing:
                    raise claim.error(
                        f"the step for {name} uses {', '.join(sorted(missing))}, which no step before it gives",
                        "steps",
                    )
                env = {**fixed, **known}
                env |= {letter: _letter(ev, letter, rows, env) for letter in picked}
                slides = ev.model.sliding(int(str(angle).removeprefix("theta")))
                for value in branch_values(node, env, rows.shape):
                    grown.append({**known, str(angle): value if slides else wrapped(value)})
        candidates = grown
        if len(candidates) > MAX_COMBINATIONS:
            raise claim.error(f"more than {MAX_COMBINATIONS} combinations of branches", "steps")
    if any(len(c) != n for c in candidates):
        raise claim.error(f"the steps give {len(candidates[0])} of {plural(n, 'joint')}", "steps")
    claim = claim.reads("; ".join(lines))
    task = claim.get("task")
    found, truth = _closing(ev, rows, candidates, task), _existing(ev, rows, task or "pose")
    said = "pose"
    if task == "position":
        said = "position"
    elif task is None and n < MOST_JOINTS and not (truth is not None and np.array_equal(found, truth)):
        positions = _closing(ev, rows, candidates, "position"), _existing(ev, rows, "position")
        if positions[1] is not None and np.array_equal(positions[0], positions[1]):
            (found, truth), said = positions, 'position (task = "position" says so; not of a pose with its orientation)'
    spread = ", ".join(f"{v} at {100 * np.mean(found == v):z.0f}%" for v in sorted(set(found.tolist())))
    there = "how many there are was not checked"
    if truth is not None:
        there = "there are " + " or ".join(map(str, sorted(set(truth.tolist()))))
    what = said.partition(" ")[0]
    combinations = plural(len(candidates), "combination")
    details = [
        (
            "candidates",
            f"{combinations} of branches at {len(rows)} {what}s: {int(found.sum())} of {len(rows) * len(candidates)} "
            "close under forward kinematics",
        ),
        ("solutions", f"found {spread} of the {what}s; {there}"),
    ]
    if truth is not None and np.array_equal(found, truth):
        every = f"all {int(truth.max())} solutions" if truth.max() > 1 else "the one solution"
        return claim.holds(f"Holds: finds {every} of a {said} at {len(rows)} of {len(rows)} {what}s.", details)
    if not found.any():
        return claim.wrong(f"Wrong: finds no solution at any of {len(rows)} {what}s.", details)
    none = np.mean(found == 0)
    rest = f", none at {100 * none:z.0f}% of them" if none else ""
    least, most = int(found.min()), int(found.max())
    number = plural(most, "solution") if least == most else f"{least} to {plural(most, 'solution')}"
    missing = f", {there}" if truth is not None else f"; {there}"
    return claim.partly(f"Finds {number} of a {what}{rest}{missing}.", details)


def _letter(ev: Evidence, name: str, rows: np.ndarray, env: dict[str, np.ndarray]) -> np.ndarray:
    """An entry of matrices at some samples, with the joints that a branch has found in place of the right ones.

    The joints it does not need may have any value, so one that is still unknown takes up what is left of the pose: T06
    is the pose's then, and R36 what remains of it when the first three joints are taken off.
    """
    model = ev.model
    right = {f"theta{j}": ev.samples.env[f"theta{j}"][rows] for j in range(1, model.n + 1)}
    frames = {**model.frames({**right, **env}), "T": ev.samples.frames["T"][rows]}
    unknown = min(j for j in range(1, model.n + 1) if f"theta{j}" not in env)
    left = np.linalg.inv(model.base) @ frames["T"] @ np.linalg.inv(model.tool)
    for joint in range(1, unknown):
        left = np.linalg.inv(frames[f"A{joint}"]) @ left
    for joint in range(model.n, unknown, -1):
        left = left @ np.linalg.inv(frames[f"A{joint}"])
    frames[f"A{unknown}"] = left
    found = {**right, **env}
    ev.pick(found, frames)
    return found[name]


def _closing(ev: Evidence, rows: np.ndarray, candidates: list[dict[str, np.ndarray]], task: str | None) -> np.ndarray:
    """Return the number of distinct candidates that reproduce each pose."""
    model = ev.model
    want = ev.samples.frames["T"][rows]
    tried = []
    for known in candidates:
        q = np.stack([known[f"theta{j}"] for j in range(1, model.n + 1)], axis=1)
        T = pose_of(model, np.nan_to_num(q, nan=0.3))
        off = np.abs(T - want)[:, :3, 3] if task == "position" else np.abs(T - want).reshape(len(rows), -1)
        close = off.max(1) < JUDGED_HOLDS * max(1.0, model.length())
        tried.append((q, close & np.isfinite(q).all(1)))
    counts = np.zeros(len(rows), dtype=int)
    for k in range(len(rows)):
        kept: list[np.ndarray] = []
        for q, good in tried:
            if good[k] and all(np.abs(wrapped(q[k] - other)).max() > JUDGED_HOLDS for other in kept):
                kept.append(q[k])
        counts[k] = len(kept)
    return counts


def _existing(ev: Evidence, rows: np.ndarray, task: str) -> np.ndarray | None:
    """Return the number of solutions of each pose for a task; None when the solver cannot say."""
    try:
        if task == "pose":
            return np.array([len(ev.solutions_at(int(k))) for k in rows])
        return np.array([len(ev.solved(ev.samples.frames["T"][k], task)) for k in rows])
    except PieperError:
        return None
