"""Which poses to measure: those that say most about the arm together (greedy D-optimal design; Federov, 1972)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from pieper import arguments
from pieper.calibration.least_squares import Weighed, linearised, sizes_of
from pieper.calibration.measurements import KINDS, Measurements, measured_as, noise_of
from pieper.calibration.model import AxesModel
from pieper.calibration.parameters import parameters_of
from pieper.errors import InputError
from pieper.kinematics.arrays import ArrayLike
from pieper.kinematics.forward import checked_joints
from pieper.solver.plan.planned_arm import NominalArm
from pieper.tolerances import USUAL_NOISE


def choose_poses(
    arm: NominalArm,
    k: int,
    candidates: ArrayLike,
    *,
    kind: str = "pose",
    sigma: Sequence[float] | None = None,
    joint_terms: tuple[str, ...] = (),
) -> npt.NDArray[np.int64]:
    """Choose poses to measure; see `pieper.Arm.choose_poses`.

    Raises:
        InputError: More poses than candidates, or candidates that are no joint vectors.
    """
    q = checked_joints(candidates, arm.chain.n, "candidates", prismatic=arm.chain.prismatic)
    if q.ndim != 2:
        raise InputError(f"candidates must have shape (N, {arm.chain.n}), got {q.shape}.", given=q.shape)
    arguments.whole(k, "k, how many candidates to choose,", 1, len(q))
    model, parameters = AxesModel.of(arm.chain), parameters_of(arm.chain, arm.description.joint_names, (), joint_terms)
    T = model.fk(q)
    seen_from = np.zeros(3) + T[:, :3, 3].mean(0) + [0.0, 0.0, arm.chain.length]
    arguments.word(kind, "kind", KINDS)
    values = {
        "pose": T,
        "position": T[:, :3, 3],
        "distance": np.linalg.norm(T[:, :3, 3] - seen_from, axis=1),
        "plane": T[:, 2, 3],
    }
    data = measured_as(kind, values.get(kind, T), len(q))
    data = Measurements(kind, data.values, seen_from if kind == "distance" else data.point)
    sizes = sizes_of(parameters, data, arm.chain.length)
    _, slopes = linearised(model, data, Weighed(parameters, q, noise_of(sigma) or USUAL_NOISE, sizes))
    J = np.concatenate(slopes, axis=1)
    # what nothing known beforehand says, a plausible departure does: the unit matrix
    information = np.eye(J.shape[2])
    chosen: list[int] = []
    for _ in range(k):
        gain = J @ np.linalg.inv(information) @ np.swapaxes(J, 1, 2)
        _, size = np.linalg.slogdet(np.eye(J.shape[1]) + gain)
        size[chosen] = -np.inf
        chosen.append(int(np.argmax(size)))
        information += J[chosen[-1]].T @ J[chosen[-1]]
    return np.array(chosen, np.int64)
