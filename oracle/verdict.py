"""Judge an arm's solutions of a pose by the multi-start search."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from oracle.model import equations, gap, machine, polish
from oracle.starts import Found, search


@dataclass
class Verdict:
    """The judgement of one pose.

    Attributes:
        missing: Solutions of the oracle that the arm does not give, (q, hits, sigma).
        wrong: Answers of the arm that do not close under the oracle's own forward kinematics.
        unseen: True answers of the arm that the oracle has not found: a weakness of the oracle.
        found: What the oracle found.
        theirs: What the arm answered (k, n).
    """

    missing: list = field(default_factory=list)
    wrong: list = field(default_factory=list)
    unseen: list = field(default_factory=list)
    found: Found | None = None
    theirs: np.ndarray | None = None

    def __bool__(self):
        """Whether arm and oracle agree."""
        return not (self.missing or self.wrong)


def judge(arm, T, *, rows=None, self_motions=None, task="pose", tolerance=1e-5, m=None, **how) -> Verdict:
    """Compare the arm's answers to the oracle's.

    Args:
        arm: The arm.
        T: Pose.
        rows: Its answers (k, n), or None to call `arm.ik`.
        self_motions: Its self-motions; a solution of the oracle on one is not missing.
        task: As in `arm.ik`.
        tolerance: Largest difference of two equal solutions; wider where the pose is nearly singular.
        m: The arm's machine.
        how: Passed on to `search`.
    """
    m = m or machine(arm)
    if rows is None:
        given = arm.ik(T, task=task) if task != "pose" else arm.ik(T)
        rows, self_motions = given.all_q, given.self_motions
    found = search(arm, T, task=task, m=m, **how)
    verdict = Verdict(found=found, theirs=rows)
    pose, code = m.pose(T), {"pose": 0, "position": 1, "position+axis": 2}[task]
    mine, theirs = m.inner(found.q), m.inner(np.asarray(rows).reshape(-1, m.n))
    if len(theirs):
        left = np.linalg.norm(equations(m, theirs, pose, code)[0], axis=1)
        sigma = polish(m, pose, theirs, code, rounds=0)[2]
        for i in np.flatnonzero(left > 1e-8):
            verdict.wrong.append((rows[i], left[i]))
        for i in range(len(theirs)):
            wide = blur(tolerance, sigma[i])
            if left[i] <= 1e-8 and not (len(mine) and (gap(m, mine, theirs[i]) < wide).any()):
                verdict.unseen.append((rows[i], sigma[i]))
    for i in range(len(mine)):
        wide = blur(tolerance, found.sigma[i])
        if len(theirs) and (gap(m, theirs, mine[i]) < wide).any():
            continue
        if self_motions and any(motion.contains(found.q[i], 1e-4) for motion in self_motions):
            continue
        verdict.missing.append((found.q[i], int(found.hits[i]), float(found.sigma[i])))
    return verdict


def blur(tolerance, sigma):
    """Return how far equal solutions may lie apart at a smallest singular value."""
    return max(tolerance, min(3e-3, 1e-11 / max(sigma, 1e-300)))
