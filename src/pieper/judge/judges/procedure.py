"""Judge of a whole procedure: its formulas followed in their order, every combination of branches, and counted."""

from __future__ import annotations

import numpy as np

from pieper.algebra.formula import ANGLE
from pieper.errors import PieperError
from pieper.judge.claim import Claim
from pieper.judge.evidence import Evidence, wrapped
from pieper.judge.judges.angle_formula import branch_values, read_angle
from pieper.judge.samples import pose_of
from pieper.judge.verdict import Verdict
from pieper.tolerances import JUDGED_HOLDS
from pieper.words_by_number import plural

MAX_COMBINATIONS = 512


def judge_procedure(ev: Evidence, claim: Claim) -> Verdict:
    """Follow formulas in their order and count the solutions that close under forward kinematics.

    Keys: steps, a list of {joint, is} where `is` may be a list of alternatives; where.
    """
    n, samples = ev.model.n, ev.samples
    rows = np.flatnonzero(samples.nominal)[:40]
    fixed = {k: v[rows] for k, v in samples.env.items() if not ANGLE.match(k)}
    candidates: list[dict[str, np.ndarray]] = [{}]
    lines = []
    for keys in claim["steps"]:
        step = claim.part(claim.id, keys)
        name, angle = read_angle(ev, step)
        texts = step["is"] if isinstance(step["is"], list) else [step["is"]]
        lines.append(f"{name} = " + " or ".join(map(str, texts)))
        if not ANGLE.match(str(angle)):
            raise claim.error(f"a step solves for one joint, not for {name}")
        where = {**claim.where, **step.where}
        grown = []
        for known in candidates:
            for node in [ev.parse(str(t), where).substitute(ev.definitions) for t in texts]:
                missing = {s for s in node.symbols() if ANGLE.match(s)} - set(known)
                if missing:
                    raise claim.error(
                        f"the step for {name} uses {', '.join(sorted(missing))}, which no step before it gives"
                    )
                for value in branch_values(node, {**fixed, **known}, rows.shape):
                    grown.append({**known, str(angle): wrapped(value)})
        candidates = grown
        if len(candidates) > MAX_COMBINATIONS:
            raise claim.error(f"more than {MAX_COMBINATIONS} combinations of branches")
    if any(len(c) != n for c in candidates):
        raise claim.error(f"the steps give {len(candidates[0])} of {plural(n, 'joint')}")
    claim = claim.reads("; ".join(lines))
    found, truth = _closing(ev, rows, candidates), _existing(ev, rows)
    spread = ", ".join(f"{v} at {100 * np.mean(found == v):.0f}%" for v in sorted(set(found.tolist())))
    there = "how many there are was not checked" if truth is None else f"there are {sorted(set(truth.tolist()))}"
    details = [
        (
            "candidates",
            f"{plural(len(candidates), 'combination')} of branches at {len(rows)} poses: {int(found.sum())} of "
            f"{len(rows) * len(candidates)} close under forward kinematics",
        ),
        ("solutions", f"found {spread} of the poses; {there}"),
    ]
    if truth is not None and np.array_equal(found, truth):
        every = f"all {int(truth.max())} solutions" if truth.max() > 1 else "the one solution"
        return claim.holds(f"Holds: finds {every} at {len(rows)} of {len(rows)} poses.", details)
    if not found.any():
        return claim.wrong(f"Wrong: finds no solution at any of {len(rows)} poses.", details)
    none = np.mean(found == 0)
    rest = f", none at {100 * none:.0f}% of them" if none else ""
    return claim.partly(f"Finds {found.min()} to {found.max()} solutions of a pose{rest}.", details)


def _closing(ev: Evidence, rows: np.ndarray, candidates: list[dict[str, np.ndarray]]) -> np.ndarray:
    """Return the number of distinct candidates that reproduce each pose."""
    model = ev.model
    want = ev.samples.frames["T"][rows]
    tried = []
    for known in candidates:
        q = np.stack([known[f"theta{j}"] for j in range(1, model.n + 1)], axis=1)
        T = pose_of(model, np.nan_to_num(q, nan=0.3))
        close = np.abs(T - want).reshape(len(rows), -1).max(1) < JUDGED_HOLDS * max(1.0, model.length())
        tried.append((q, close & np.isfinite(q).all(1)))
    counts = np.zeros(len(rows), dtype=int)
    for k in range(len(rows)):
        kept: list[np.ndarray] = []
        for q, good in tried:
            if good[k] and all(np.abs(wrapped(q[k] - other)).max() > JUDGED_HOLDS for other in kept):
                kept.append(q[k])
        counts[k] = len(kept)
    return counts


def _existing(ev: Evidence, rows: np.ndarray) -> np.ndarray | None:
    """Return the number of solutions of each pose; None when the solver cannot say."""
    try:
        return np.array([len(ev.solutions_at(int(k))) for k in rows])
    except PieperError:
        return None
