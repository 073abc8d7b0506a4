"""The fit itself: Gauss-Newton in the tangent of the current arm, what cannot be seen left where it is.

Numbers are scaled by their plausible sizes and measurements by their noise, so that a singular value says how many
noises a plausible departure moves the measurements; below one it is not followed. Outliers lose weight as Huber's
function says and are left out of a last fit when they are none of the noise.

Source: Huber (1981); Hollerbach and Wampler (1996) on what can be seen.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper.calibration.measurements import SETUP, Measurements
from pieper.calibration.model import AxesModel
from pieper.calibration.parameters import Parameters
from pieper.kinematics.arrays import Array, Bools
from pieper.tolerances import CALIBRATED, CALIBRATION_STEPS, COST_NO_WORSE, COST_ROUNDING, HUBER, OUTLIER

#: Halvings of a step that makes things worse, before it is taken as it is.
HALVINGS = 8
#: Median of the length of a vector of 1 and of 3 Gaussian numbers.
MEDIAN_NORM = {1: 0.6745, 3: 1.5382}


@dataclass(frozen=True, eq=False)
class Weighed:
    """What is fitted, at which postures, and in which units it counts.

    Args:
        parameters: What may move.
        q: (N, n) joint vectors, rad or m.
        sigma: Noise of positions, m, and of turns, rad.
        sizes: (k,) plausible sizes of the numbers, see `sizes_of`.
    """

    parameters: Parameters
    q: Array
    sigma: tuple[float, float]
    sizes: Array

    def free(self, kind: str) -> Bools:
        """Return which numbers may move (k,), all of the set-up of a kind of measurements among them."""
        return np.concatenate([self.parameters.free, np.ones(SETUP[kind], bool)])


@dataclass(frozen=True, eq=False)
class Fitted:
    """Where a fit ended.

    Args:
        model: The arm.
        data: The measurements, their set-up fitted.
        seen: (r, k) orthonormal directions that were fitted, of scaled numbers: the set-up's after the arm's.
        strength: (r,) by how many noises a plausible departure along each moves the measurements.
        unseen: (k - r, k) the directions that were not.
        outliers: (N,) rows that were left out.
        spread: Root of chi square per freedom: 1 where residuals are as large as the noise said.
        steps: Gauss-Newton steps.
    """

    model: AxesModel
    data: Measurements
    seen: Array
    strength: Array
    unseen: Array
    outliers: Bools
    spread: float
    steps: int


def sizes_of(parameters: Parameters, data: Measurements, length: float) -> Array:
    """Return (k,) the plausible sizes of all numbers, the set-up's too, which nothing is known of."""
    setup = {"distance": [length] * 3, "plane": [1.0, 1.0, length]}.get(data.kind, [])
    return np.concatenate([parameters.sizes, setup])


def linearised(model: AxesModel, data: Measurements, by: Weighed) -> tuple[list[Array], list[Array]]:
    """Return residuals (N, m) and derivatives (N, m, k), in noises and plausible sizes: of positions, of turns."""
    T, twists = model.pose_and_jacobian(by.q, by.parameters)
    misses, slopes = data.misses(T), data.derivatives(T, twists)
    scale = np.where(by.free(data.kind), by.sizes, 0.0)
    parts = [k for k in range(2) if misses[k].shape[1]]
    columns = [
        np.concatenate([slopes[k], np.zeros((*slopes[k].shape[:2], len(scale) - slopes[k].shape[2]))], 2) for k in parts
    ]
    sigma = by.sigma
    return [misses[k] / sigma[k] for k in parts], [c * scale / sigma[k] for k, c in zip(parts, columns, strict=True)]


def fit(model: AxesModel, data: Measurements, by: Weighed, loss: str) -> Fitted:
    """Fit an arm to measurements; see `Fitted`."""
    keep = np.ones(len(by.q), bool)
    model, data, steps = _descend(model, data, by, loss == "huber", keep)
    if loss == "huber":
        residuals, _ = linearised(model, data, by)
        keep = ~outlying(residuals)
        model, data, more = _descend(model, data, by, False, keep)
        steps += more
    residuals, slopes = linearised(model, data, by)
    r, J = _stacked(residuals, slopes, [keep.astype(np.float64)] * len(residuals))
    s, V = _decomposed(J)
    seen = s >= 1.0
    freedom = max(int(np.sum(keep)) * sum(part.shape[1] for part in residuals) - int(seen.sum()), 1)
    return Fitted(model, data, V[seen], s[seen], V[~seen], ~keep, float(np.sqrt(r @ r / freedom)), steps)


def outlying(residuals: list[Array]) -> Bools:
    """Return which rows (N,) are no noise: many times farther off than rows usually are."""
    out = np.zeros(len(residuals[0]), bool)
    for part in residuals:
        size = np.linalg.norm(part, axis=1)
        usual = max(1.0, float(np.median(size)) / MEDIAN_NORM[part.shape[1]])
        out |= size > OUTLIER * usual
    return out


def _descend(
    model: AxesModel, data: Measurements, by: Weighed, robust: bool, keep: Bools
) -> tuple[AxesModel, Measurements, int]:
    count = by.parameters.count
    reach = by.sizes * by.free(data.kind)
    residuals, slopes = linearised(model, data, by)
    for done in range(1, CALIBRATION_STEPS + 1):
        weights = [_weights(part, robust, keep) for part in residuals]
        r, J = _stacked(residuals, slopes, weights)
        s, V = _decomposed(J)
        seen = s >= 1.0
        step = -V[seen].T @ ((V[seen] @ (J.T @ r)) / s[seen] ** 2)
        cost = _cost(residuals, robust, keep)
        for halving in range(HALVINGS + 1):
            part = step * reach * 0.5**halving
            tried, placed = model.moved(part[:count], by.parameters), data.moved(part[count:])
            residuals, slopes = linearised(tried, placed, by)
            if _cost(residuals, robust, keep) <= cost * (1 + COST_NO_WORSE) + COST_ROUNDING:
                break
        model, data = tried, placed
        if np.abs(step).max(initial=0.0) < CALIBRATED:
            return model, data, done
    return model, data, CALIBRATION_STEPS


def _decomposed(J: Array) -> tuple[Array, Array]:
    """Return singular values (k,), zeros where there are fewer rows, and all right singular vectors (k, k)."""
    # from the products of the columns: what is looked at is whether a value is above 1, far above their rounding; and a
    # decomposition of the tall matrix would wake threads that cost more than they do
    _, square, V = np.linalg.svd(np.einsum("ri,rj->ij", J, J))
    return np.sqrt(square), V


def _stacked(residuals: list[Array], slopes: list[Array], weights: list[Array]) -> tuple[Array, Array]:
    r = np.concatenate([(part * w[:, None]).ravel() for part, w in zip(residuals, weights, strict=True)])
    J = np.concatenate([(J * w[:, None, None]).reshape(-1, J.shape[2]) for J, w in zip(slopes, weights, strict=True)])
    return r, J


def _weights(part: Array, robust: bool, keep: Bools) -> Array:
    """Return the roots (N,) of the weights of rows; zero where they are not kept."""
    kept = keep.astype(np.float64)
    if not robust:
        return kept
    size, threshold = np.linalg.norm(part, axis=1), HUBER * np.sqrt(part.shape[1])
    return kept * np.sqrt(np.where(size <= threshold, 1.0, threshold / np.maximum(size, threshold)))


def _cost(residuals: list[Array], robust: bool, keep: Bools) -> float:
    total = 0.0
    for part in residuals:
        size, threshold = np.linalg.norm(part[keep], axis=1), HUBER * np.sqrt(part.shape[1])
        square = size * size
        total += float(
            np.sum(np.where(size <= threshold, square, threshold * (2 * size - threshold)) if robust else square)
        )
    return total
