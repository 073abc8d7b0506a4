"""From joint vectors and measurements to the arm as it is, judged on poses that were held out."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import numpy.typing as npt

from pieper import arguments
from pieper.calibration.departure import refuse_another_arm
from pieper.calibration.fit import Fit, HeldOut
from pieper.calibration.least_squares import Fitted, Weighed, fit, linearised, outlying, sizes_of
from pieper.calibration.measurements import BLIND, SETUP, WIDTH, Measurements, measured_as, noise_of, spread
from pieper.calibration.misreadings import refuse_misreadings
from pieper.calibration.model import AxesModel
from pieper.calibration.parameters import Parameters, parameters_of
from pieper.calibration.strange_rows import refuse_strange_rows
from pieper.calibration.unseen import in_words
from pieper.description.dh import Description
from pieper.errors import InputError
from pieper.kinematics.arrays import Array, ArrayLike, Bools
from pieper.kinematics.forward import checked_joints
from pieper.kinematics.pose import PoseLike
from pieper.solver.plan.planned_arm import NominalArm
from pieper.tolerances import EXPLAINS_NOTHING, FIRST_NOISE, LEAST_NOISE, SAME_MEASUREMENT, SUSPICIOUS
from pieper.words_by_number import plural

LOSSES = ("linear", "huber")
#: How often the noise of a fit is estimated, where none is said.
ESTIMATES = 3


def calibrate(
    arm: NominalArm,
    q: ArrayLike,
    measured: PoseLike | None,
    *,
    kind: str = "pose",
    sigma: Sequence[float] | float | None = None,
    hold: Sequence[str] = (),
    joint_terms: Sequence[str] = (),
    loss: str = "linear",
    holdout: float = 0.25,
    make: Callable[[Description], Any],
) -> Fit:
    """Fit an arm; see `pieper.Arm.calibrate`, which hands in how an arm is made of a description.

    Raises:
        InputError: Shapes, names, too few or identical poses, or data that must have been meant otherwise.
    """
    chain = arm.chain
    joints = checked_joints(q, chain.n)
    if joints.ndim != 2:
        raise InputError(f"q must have shape (N, {chain.n}), one row a pose, got {joints.shape}.", given=joints.shape)
    arguments.word(loss, "loss", LOSSES)
    data, noise = measured_as(kind, measured, len(joints)), noise_of(sigma)
    parameters = parameters_of(chain, arm.description.joint_names, hold, joint_terms)
    nominal = AxesModel.of(chain)
    tested = _held_out(joints, holdout)
    fitted_on = np.setdiff1d(np.arange(len(joints)), tested)
    _refuse_too_few(joints[fitted_on], parameters, data, len(tested))
    refuse_misreadings(nominal, joints, data, arm.description.joint_names, chain.length)
    if loss == "linear":
        refuse_strange_rows(nominal, joints, data, chain.length)
    start = data.rows(fitted_on).placed(nominal.fk(joints[fitted_on])[:, :3, 3])
    by = Weighed(parameters, joints[fitted_on], noise or FIRST_NOISE, sizes_of(parameters, data, chain.length))
    found, by = _fitted(nominal, start, by, loss, estimate=noise is None)
    _refuse_strangers(found, joints[fitted_on])
    refuse_another_arm(nominal, found.model, joints[fitted_on])
    # noise that was said too small would make the prediction too good
    covariance = (found.seen.T / found.strength**2) @ found.seen * max(1.0, found.spread) ** 2
    free = by.sizes * by.free(kind)
    covariance *= free[:, None] * free
    held = replace(found.data, values=data.values[tested])
    begun = replace(start, values=data.values[tested])
    error, strange = None, np.zeros(len(tested), bool)
    if len(tested):
        error, strange = _judged(nominal, begun, found, held, covariance, replace(by, q=joints[tested]), loss)
    return Fit(
        nominal=arm.description,
        model=found.model,
        parameters=parameters,
        covariance=covariance[: parameters.count, : parameters.count],
        unobservable=in_words(found.model, parameters, found.unseen, by.sizes),
        held_out=error,
        sigma=by.sigma,
        sigma_said=noise is not None,
        shares=np.sum(found.seen[:, : parameters.count] ** 2, axis=0),
        spread=found.spread,
        outliers=tuple(sorted(int(i) for i in (*fitted_on[found.outliers], *tested[strange]))),
        rows=(len(fitted_on), len(tested)),
        kind=kind,
        set_up=found.data,
        steps=found.steps,
        make=make,
    )


def _held_out(q: Array, holdout: float) -> npt.NDArray[np.int64]:
    """Return the rows that are held out, evenly spread: of a posture that was measured several times all or none."""
    arguments.number(holdout, "holdout, a part of the poses,", least=0.0, below=1.0)
    if not len(q):
        return np.zeros(0, np.int64)
    _, first, which = np.unique(np.round(q / SAME_MEASUREMENT), axis=0, return_index=True, return_inverse=True)
    # in the order in which they were measured
    turn = np.argsort(np.argsort(first))[which.reshape(-1)]
    held = round(holdout * len(first))
    chosen = ((np.arange(held) + 0.5) * len(first) / max(held, 1)).astype(np.int64)
    return np.flatnonzero(np.isin(turn, chosen)).astype(np.int64)


def _refuse_too_few(q: Array, parameters: Parameters, data: Measurements, held: int) -> None:
    unknown = max(int(parameters.free.sum()) + SETUP[data.kind] - BLIND[data.kind], 1)
    needed = -(-unknown // WIDTH[data.kind])
    distinct = len(np.unique(np.round(q / SAME_MEASUREMENT), axis=0)) if len(q) else 0
    if distinct >= needed:
        return
    beside = f" ({held} more {'is' if held == 1 else 'are'} held out)" if held else ""
    few = f"{plural(len(q), 'pose')} to fit{beside}"
    if distinct < len(q):
        few += f", of which only {distinct} {'is' if distinct == 1 else 'are'} different"
    raise InputError(
        f"{few}; {plural(unknown, 'number')} {'is' if unknown == 1 else 'are'} unknown and each {data.kind} measured "
        f"gives {WIDTH[data.kind]}: at least {plural(needed, 'different pose')} {'is' if needed == 1 else 'are'} "
        "needed, twice as many for an answer worth having. Measure more, hold= what is known, or fit fewer "
        "joint_terms.",
        distinct=distinct,
        needed=needed,
    )


def _refuse_strangers(found: Fitted, q: Array) -> None:
    """Refuse measurements that even the fitted arm tells next to nothing about."""
    T = found.model.fk(q)
    way, _ = found.data.misses(T)
    missed = float(np.median(np.linalg.norm(way[~found.outliers], axis=1))) if (~found.outliers).any() else 0.0
    moved, measured = spread(T[:, :3, 3]), spread(found.data.values.reshape(len(q), -1))
    vary = measured if found.data.kind == "distance" else moved
    explains_nothing = missed > EXPLAINS_NOTHING * vary
    if found.data.kind == "plane" and missed > EXPLAINS_NOTHING * measured > 0 and missed > SUSPICIOUS * moved:
        # on a plane that was touched heights are noise, and the arm is there
        vary, explains_nothing = measured, True
    if vary > LEAST_NOISE and explains_nothing:
        raise InputError(
            f"even the fitted arm misses the data by {missed:.3g} m (median), where they vary by {vary:.3g} m: "
            "read so, joints and measurements do not belong together. Rows may be shuffled or out of step by "
            "many, several things may be meant otherwise at once (units, senses, offsets), or it is another arm.",
            missed=missed,
            vary=vary,
        )


def _fitted(
    nominal: AxesModel, data: Measurements, by: Weighed, loss: str, *, estimate: bool
) -> tuple[Fitted, Weighed]:
    """Return the fit and what it was weighted with: the noise that was said, or an estimate that residuals show."""
    for _ in range(ESTIMATES if estimate else 0):
        found = fit(nominal, data, by, loss)
        residuals, _ = linearised(found.model, found.data, by)
        kept = ~found.outliers
        rows = int(kept.sum()) * sum(part.shape[1] for part in residuals)
        freedom = max(rows - len(found.seen), 1) / rows
        sizes_now = [float(np.sqrt(np.mean(part[kept] ** 2) / freedom)) for part in residuals]
        used = by.sigma
        by = replace(by, sigma=(max(used[0] * sizes_now[0], LEAST_NOISE), max(used[1] * sizes_now[-1], LEAST_NOISE)))
    return fit(nominal, data, by, loss), by


def _judged(
    nominal: AxesModel,
    begun: Measurements,
    found: Fitted,
    held: Measurements,
    covariance: Array,
    by: Weighed,
    loss: str,
) -> tuple[HeldOut, Bools]:
    """Return the error on held-out rows, what covariance predicts for it (Cramer and Rao), and which are no noise."""
    q = by.q
    residuals, slopes = linearised(found.model, held, by)
    kept = ~outlying(residuals) if loss == "huber" else np.ones(len(q), bool)
    before = begun.misses(nominal.fk(q))
    scaled = covariance / np.outer(by.sizes, by.sizes)
    spread, said = max(1.0, found.spread), []
    for part, J, unit, first in zip(residuals, slopes, by.sigma, before, strict=False):
        size = np.linalg.norm(part[kept] * unit, axis=1)
        own = np.einsum("nik,kl,nil->n", J[kept], scaled, J[kept]) + part.shape[1] * spread**2
        said.append(
            (
                float(np.sqrt(np.mean(size**2))),
                float(size.max()),
                float(np.sqrt(np.mean(own))) * unit,
                float(np.sqrt(np.mean(np.sum(first[kept] ** 2, axis=1)))),
            )
        )
    turns = said[1] if len(said) > 1 else (None,) * 4
    error = HeldOut(
        said[0][0], turns[0], said[0][1], turns[1], said[0][2], turns[2], said[0][3], turns[3], int(kept.sum()), len(q)
    )
    return error, ~kept
