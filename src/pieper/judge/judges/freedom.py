"""Judge of freedom: in how many directions a pose can move, which joints it leaves free, what can be completed."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np

from pieper.judge.claim import Claim
from pieper.judge.evidence import Evidence
from pieper.judge.model import ArmModel
from pieper.judge.samples import pose_of
from pieper.judge.verdict import Verdict
from pieper.kinematics.arrays import Array
from pieper.kinematics.joints import short_way
from pieper.tolerances import CENTRAL_STEP, DAMPED_AT_LEAST, DAMPED_BY_MISS, JUDGED_HOLDS, JUDGED_RANK, PART_OF_FREEDOM


def pose_jacobian(model: ArmModel, q: np.ndarray) -> np.ndarray:
    """Return derivatives (K, 6, n) of the pose by central differences: position per length, then rotation, rad."""
    K, n = q.shape
    moved = np.repeat(np.repeat(q[:, None, None], n, axis=1), 2, axis=2)
    for k in range(n):
        moved[:, k, 0, k] += CENTRAL_STEP
        moved[:, k, 1, k] -= CENTRAL_STEP
    T = pose_of(model, moved.reshape(-1, n)).reshape(K, n, 2, 4, 4)
    here = pose_of(model, q)
    dT = (T[:, :, 0] - T[:, :, 1]) / (2 * CENTRAL_STEP)
    W = dT[..., :3, :3] @ np.swapaxes(here[:, None, :3, :3], -1, -2)
    spin = np.stack([W[..., 2, 1], W[..., 0, 2], W[..., 1, 0]], axis=-1)
    return np.concatenate([dT[..., :3, 3] / model.length(), spin], axis=-1).transpose(0, 2, 1)


def undetermined(ev: Evidence, known: Collection[int] = ()) -> list[set[int]]:
    """Return the sets of joints (1-based) that a pose leaves free together, at every sampled pose.

    Args:
        ev: the arm; joints that the claim holds are known.
        known: further joints whose value is known.
    """
    J = pose_jacobian(ev.model, ev.samples.q[ev.samples.nominal][:12])
    for joint in {*known, *ev.held}:
        J[:, :, joint - 1] = 0.0
    free = np.zeros(ev.model.n)
    fixed = [j - 1 for j in {*known, *ev.held}]
    for Jk in J:
        Jk = np.vstack([Jk, np.eye(ev.model.n)[fixed]])  # a known joint does not move
        _, s, V = np.linalg.svd(Jk)
        null = V[np.count_nonzero(s > JUDGED_RANK * s[0]) :]
        if not len(null):
            return []
        free += (np.abs(null) > PART_OF_FREEDOM).any(0)
    joints = {k + 1 for k in range(ev.model.n) if free[k] == len(J)}
    return [joints] if joints else []


def judge_freedom(ev: Evidence, claim: Claim) -> Verdict:
    """Judge how many degrees of freedom the tool has and which joints it leaves free (keys dof, free, at_deg)."""
    ev = ev.holding(claim)
    dof = claim.whole("dof")
    J = pose_jacobian(ev.model, ev.samples.q[ev.samples.nominal][:24])
    values = np.linalg.svd(J, compute_uv=False)
    rank = int(np.max(np.count_nonzero(values > JUDGED_RANK * values[:, :1], axis=1)))
    shown = ", ".join(f"{v if v > JUDGED_RANK else 0:.3g}" for v in values[0])
    details = [("singular values", f"of the Jacobian at {ev.at(0)}: {shown}")]
    free = undetermined(ev)
    names = " and ".join(f"theta{j}" for j in sorted(free[0])) if free else "none"
    if free:
        details.append(
            (
                "the slip",
                f"a pose does not determine {names} one by one: they turn about the same line or move together",
            )
        )
    text = f"the tool has {dof} degrees of freedom"
    if "free" in claim:
        claim = claim.reads(text + ", and " + " and ".join(f"theta{j}" for j in claim["free"]) + " are free")
        if set(claim["free"]) != (free[0] if free else set()):
            return claim.wrong(f"Wrong: the joints a pose leaves free are {names}.", details, "index", names)
    else:
        claim = claim.reads(text)
    if rank == dof:
        return claim.holds(f"Holds: the Jacobian has rank {rank} at {len(J)} random poses.", details)
    return claim.wrong(f"Wrong: the Jacobian has rank {rank}, never more, at {len(J)} random poses.", details)


def completes(
    model: ArmModel,
    T: np.ndarray,
    fixed: dict[int, float],
    q: np.ndarray,
    *,
    sums: Sequence[dict[int, int]] = (),
    position: bool = False,
    starts: int = 40,
) -> bool:
    """Say whether a pose can be reached with some joints (1-based) held at given values.

    Levenberg's method from many starts; exact enough to tell a solution from none.

    Args:
        model: the arm.
        T: (4, 4) pose, in the arm's unit.
        fixed: joint -> value held.
        q: (n,) a solution: where the sums get their values from, and how far slides go.
        sums: sums of joints, joint -> factor, that stay what they are at q.
        position: the task fixes the position only.
        starts: number of random starts.
    """
    rng = np.random.default_rng(5)
    x = rng.uniform(-np.pi, np.pi, (starts, model.n))
    free = [k for k in range(model.n) if k + 1 not in fixed]
    for joint in range(1, model.n + 1):
        if model.sliding(joint):
            x[:, joint - 1] = rng.uniform(-1, 2, starts) * (abs(q[joint - 1]) + 0.1 * model.length())
    for joint, value in fixed.items():
        x[:, joint - 1] = value
    size = model.length()

    rows = np.zeros((len(sums), model.n))
    for row, members in zip(rows, sums, strict=True):
        row[[j - 1 for j in members]] = list(members.values())

    def gap(points: Array) -> tuple[Array, Array]:
        error, flip = missed(points)
        held = (rows @ (q - points).T).T
        return np.concatenate([error, short_way(held)], axis=1), flip

    def missed(points: Array) -> tuple[Array, Array]:
        now = pose_of(model, points)
        R = T[:3, :3] @ np.swapaxes(now[:, :3, :3], 1, 2)
        spin = 0.5 * np.stack([R[:, 2, 1] - R[:, 1, 2], R[:, 0, 2] - R[:, 2, 0], R[:, 1, 0] - R[:, 0, 1]], axis=1)
        # half turns have no spin of their own; the trace keeps them from passing for solutions
        flip = (3 - np.trace(R, axis1=1, axis2=2))[:, None]
        if position:
            return (T[:3, 3] - now[:, :3, 3]) / size, np.zeros((len(points), 1))
        return np.concatenate([(T[:3, 3] - now[:, :3, 3]) / size, spin], axis=1), flip

    if not free:
        error, flip = gap(x[:1])
        return bool(np.abs(error).max() < JUDGED_HOLDS and flip[0, 0] < JUDGED_HOLDS)
    for _ in range(60):
        error, flip = gap(x)
        good = (np.abs(error).max(1) < JUDGED_HOLDS) & (flip[:, 0] < JUDGED_HOLDS)
        if good.any():
            return True
        J = pose_jacobian(model, x)[:, : 3 if position else 6]
        J = np.concatenate([J, np.broadcast_to(rows, (len(x), *rows.shape))], axis=1)[:, :, free]
        JT = np.swapaxes(J, 1, 2)
        damp = DAMPED_BY_MISS * (error**2).sum(1)[:, None, None] * np.eye(len(free)) + DAMPED_AT_LEAST * np.eye(
            len(free)
        )
        step = np.linalg.solve(JT @ J + damp, (JT @ error[..., None]))[..., 0]
        x[:, free] += np.clip(step, -0.5, 0.5)
    return False
