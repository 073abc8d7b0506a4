"""What a calibration gives back: the arm, how sure it is, what could not be seen, and the error on held-out poses."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from pieper import arguments
from pieper.calibration.axes_file import text_of_axes
from pieper.calibration.measurements import Measurements
from pieper.calibration.model import AxesModel
from pieper.calibration.parameters import Parameters
from pieper.calibration.terms import inside_limits, joint_values, nearest_of, of_the_chain
from pieper.description.axes import described_by_axes
from pieper.description.carry import carried
from pieper.description.dh import Description
from pieper.document.writing import whole_file
from pieper.errors import InputError, PlanError
from pieper.kinematics.arrays import Array, ArrayLike, Indices
from pieper.kinematics.forward import checked_joints, checked_weights
from pieper.kinematics.pose import PoseLike, as_pose
from pieper.solver.redundant.choice import Redundancy
from pieper.tolerances import ENOUGH_HELD, FAR_LESS, MOSTLY_SEEN, NO_NOISE
from pieper.words_by_number import plural

if TYPE_CHECKING:
    from pieper.collision.scene import Scene


class HeldOut(NamedTuple):
    """The error on poses that the fit has not seen, root mean square and largest; None where nothing was measured.

    Attributes:
        metres: Of positions, distances or heights.
        radians: Of orientations.
        worst_metres: The largest.
        worst_radians: The largest.
        predicted_metres: What covariance and noise together predict for `metres` (Cramer and Rao).
        predicted_radians: The same of `radians`.
        nominal_metres: The same error of the arm as it was described.
        nominal_radians: The same.
        count: Rows that were judged.
        of: Rows that were held out; those beyond `count` were outliers.
    """

    metres: float
    radians: float | None
    worst_metres: float
    worst_radians: float | None
    predicted_metres: float
    predicted_radians: float | None
    nominal_metres: float
    nominal_radians: float | None
    count: int
    of: int

    def as_dict(self) -> dict[str, float | int | None]:
        """Return the numbers by their names."""
        return dict(zip(HELD_OUT, self, strict=True))


#: The names of what `HeldOut` holds, in order.
HELD_OUT = tuple(HeldOut.__annotations__)


@dataclass(frozen=True, eq=False)
class Fit:
    """A calibrated arm.

    Attributes:
        nominal: The arm as it was described.
        model: The fitted axes, tool and joint terms.
        parameters: Names, units and plausible sizes of the fitted numbers.
        covariance: (k, k) of the fitted numbers, in their units; zero along what could not be seen or was held.
        unobservable: What the measurements cannot see, in words; it stays as the nominal arm has it.
        held_out: The error on held-out poses; None where none were.
        sigma: The noise (m, rad) that was said, or else estimated.
        sigma_said: Whether it was said.
        shares: (k,) which part of each number the measurements see, 0 to 1.
        spread: Residuals over noise: far above 1 something else than these numbers is at work.
        outliers: Indices of the rows that were left out as no noise (loss "huber"), held-out ones too.
        rows: How many poses were fitted and how many held out.
        kind: What was measured.
        set_up: Measurements with their set-up as fitted: fixed point, or plane.
        steps: Gauss-Newton steps.
        make: Makes an arm of a description.
    """

    nominal: Description
    model: AxesModel
    parameters: Parameters
    covariance: Array
    unobservable: tuple[str, ...]
    held_out: HeldOut | None
    sigma: tuple[float, float]
    sigma_said: bool
    shares: Array
    spread: float
    outliers: tuple[int, ...]
    rows: tuple[int, int]
    kind: str
    set_up: Measurements = field(repr=False)
    steps: int
    make: Callable[[Description], Any] = field(repr=False)

    @cached_property
    def arm(self) -> Any:
        """The calibrated arm, made of its axes; an arm as any other.

        With gains or couplings its joints are coupled: `ik` is complete in their own numbers and limits.

        Raises:
            PlanError: Harmonics were fitted: an arm's joints are linear in what moves them; see `ik` and `geometry`.
        """
        if self.model.harmonics.any():
            raise PlanError(
                f"{self.nominal.name} was fitted with harmonics, which no robot file and no solver of joints says. "
                "fit.ik(T) inverts them; fit.geometry is the same arm by its chain's values, and fit.chain_values(q) "
                "and fit.joint_values(values) lead there and back.",
                harmonics=self.model.harmonics,
            )
        return self.make(self._described(self.model.gears, self.nominal.limits))

    @cached_property
    def geometry(self) -> Any:
        """The calibrated arm by the values of its chain, joint terms left to `chain_values` and `joint_values`."""
        ends = self.chain_values(np.where(np.isfinite(self.nominal.limits), self.nominal.limits, 0.0).T).T
        limits = np.where(np.isfinite(self.nominal.limits), np.sort(ends, axis=1), self.nominal.limits)
        plain = np.eye(self.nominal.n)
        coupled = np.abs(self.model.gears - np.diag(np.diag(self.model.gears))).any()
        # limits of coupled joints are no limits of single values
        return self.make(self._described(plain, np.tile([-np.inf, np.inf], (len(ends), 1)) if coupled else limits))

    def chain_values(self, q: ArrayLike) -> Array:
        """Return the values (..., n) of the chain's joints at joint vectors q (..., n), rad or m."""
        return self.model.values(np.array(q, dtype=np.float64))

    def joint_values(self, values: ArrayLike) -> Array:
        """Return the joint vectors (..., n) at which the chain's joints have these values (..., n), rad or m."""
        return joint_values(self.model, np.array(values, dtype=np.float64))

    def ik(
        self, T: PoseLike, *, task: str | None = None, redundancy: Redundancy = None, scene: Scene | None = None
    ) -> Array:
        """Return every joint vector (m, n) inside the limits that reaches a pose, joint terms inverted.

        The chain is solved completely; then each of its values is tried with the whole turns that the limits leave room
        for. A joint without limits is given in (-pi, pi].

        Args:
            T: (4, 4), base to tool, m.
            task: As in `Arm.ik`.
            redundancy: As in `Arm.ik`; a joint's value is that of its own number.
            scene: What stands around the arm: only rows that touch neither it nor the arm itself are returned.

        Raises:
            PlanError: A joint is to be held whose axis others move too.
        """
        held = of_the_chain(self.geometry.plan_for(task), self.model, redundancy)
        values = self.geometry.ik(T, task=task, redundancy=held).all_q
        _, rows = inside_limits(self.model, self.nominal.limits, values)
        if scene is None or not len(rows):
            return rows
        return rows[np.asarray(self.geometry.distance(self.chain_values(rows), scene)) > 0]

    def ik_many(
        self,
        Ts: PoseLike,
        threads: int | None = None,
        near: ArrayLike | None = None,
        weights: ArrayLike | None = None,
        *,
        task: str | None = None,
        redundancy: Redundancy = None,
    ) -> tuple[Indices, Array]:
        """Return every joint vector inside the limits of N poses as `ik` does: whose pose (M,), and rows (M, n).

        Args:
            Ts: (N, 4, 4), base to tool, m.
            threads: As in `Arm.ik_many`.
            near: (n,) or (N, n): of each pose only the row nearest to it, none of a pose that has none.
            weights: (n,) what the squared differences of the joints count in the distance; None for one each. Sliding
                joints are measured in the arm's characteristic length.
            task: As in `Arm.ik`.
            redundancy: As in `ik`, one value or one a pose.
        """
        space = self.geometry.chain.joints
        counts = checked_weights(weights, self.nominal.n)
        held = of_the_chain(self.geometry.plan_for(task), self.model, redundancy)
        poses, values = self.geometry.ik_many(Ts, threads, task=task, redundancy=held).rows()
        of, q = inside_limits(self.model, self.nominal.limits, values)
        if near is None:
            return poses[of], q
        there, count = checked_joints(near, self.nominal.n, "near", self.model.prismatic), len(as_pose(Ts))
        if there.shape not in ((self.nominal.n,), (count, self.nominal.n)):
            raise InputError(
                f"near must be a joint vector ({self.nominal.n},) or one a pose ({count}, {self.nominal.n}), got "
                f"{there.shape}.",
                given=there.shape,
            )
        return nearest_of(poses[of], q, np.broadcast_to(there, (count, self.nominal.n)), space, counts)

    def _described(self, gears: Array, limits: Array) -> Description:
        same = np.array_equal(gears, np.eye(self.nominal.n))
        nominal, zero = self.nominal, np.zeros(self.nominal.n)
        described = described_by_axes(
            self.model.axes,
            self.model.points,
            self.model.home,
            joint_types=self.nominal.joint_types,
            joint_names=self.nominal.joint_names,
            limits=limits,
            coupling=None if same else gears,
            name=f"{self.nominal.name}-calibrated",
            manufacturer=self.nominal.manufacturer,
            source=f"Calibrated: {self.headline()}",
            postures=self.nominal.postures,
            actuator=nominal.actuator,
        )
        # with all joints at zero its bodies are where they were drawn, to what was measured
        bodies = carried(nominal, described, zero, zero)
        return replace(described, bodies=bodies, allowed=nominal.allowed, payload=nominal.payload, reach=nominal.reach)

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Write the calibrated arm as a robot file that keeps its axes, whole or not at all; not with harmonics.

        Raises:
            InputError: Another ending than .toml, or a place that cannot be written.
        """
        path = arguments.file_ending(path, (".toml", ""), "a calibrated arm")
        description = self.arm.description
        text = text_of_axes(description, self.model)
        with whole_file(path) as file:
            file.write(text.encode())
        return path

    def headline(self) -> str:
        """Return the error on held-out poses in one sentence."""
        if self.held_out is None:
            return "no pose was held out, so nothing is known of its accuracy."
        held = self.held_out
        error = f"{_mm(held.metres)}" + ("" if held.radians is None else f" and {_mrad(held.radians)}")
        return (
            f"on {held.count} held-out poses the error is {error} (root mean square), where the noise and "
            f"{self.rows[0]} fitted poses let one expect {_mm(held.predicted_metres)}"
            + ("" if held.predicted_radians is None else f" and {_mrad(held.predicted_radians)}")
            + f"; the nominal arm misses by {_mm(held.nominal_metres)}."
        )

    def _left(self) -> float:
        """What is left as a part of the noise that was said: of all numbers, or of lengths or turns held out alone."""
        held, parts = self.held_out, [self.spread]
        if held is not None and held.count >= ENOUGH_HELD and self.kind == "pose":
            parts.append(held.metres / held.predicted_metres)
            if held.radians is not None and held.predicted_radians is not None:
                parts.append(held.radians / held.predicted_radians)
        return min(parts)

    def _fitted(self) -> str:
        """Say how many numbers were fitted, and how many of those that may move were left as they were."""
        free = int(self.parameters.free.sum())
        left = min(len(self.unobservable), free)
        if left == free:
            return f"None of {plural(free, 'number')} was seen beyond the noise in"
        of = f" of {free}" if left else ""
        return f"{free - left}{of} {'number was' if free == 1 else 'numbers were'} fitted to"

    def explain(self) -> str:
        """Tell what was fitted, how well, and what was not seen."""
        used, held = self.rows
        headline = self.headline()
        lines = [
            f"{self.nominal.name}: {headline[0].upper()}{headline[1:]}",
            f"{self._fitted()} {plural(used, 'pose')} ({self.kind}), {held} more "
            f"{'was' if held == 1 else 'were'} held out; {plural(self.steps, 'step')}. Noise"
            f"{'' if self.sigma_said else ', as the data show it'}: {_mm(self.sigma[0])}"
            + (f", {_mrad(self.sigma[1])}." if self.kind == "pose" else "."),
        ]
        if self.spread > 1.5:
            lines.append(
                f"What is left is {self.spread:z.1f} times the noise: these numbers do not say all that this arm does "
                "(bending, play, joint terms), or the noise is larger than was said. The covariance counts it as noise."
            )
        left = self._left()
        if self.sigma_said and left < FAR_LESS:
            lines.append(
                f"What is left is {1 / left:z.0f} times less than the noise that was said: numbers held back by "
                "it may be wrong. Was sigma meant in other units? Where none is said it is found from the data."
            )
        elif max(self.sigma[: 2 if self.kind == "pose" else 1]) <= NO_NOISE:
            lines.append("The data hold no noise but rounding, as a simulation's do.")
        if self.outliers:
            which = ", ".join(str(i + 1) for i in self.outliers)
            lines.append(f"Left out as no noise: measurement{'s' if len(self.outliers) > 1 else ''} {which}.")
        if held and self.held_out is not None and self.held_out.count < self.held_out.of:
            lines.append(f"Held out of them, and not in the error: {self.held_out.of - self.held_out.count}.")
        if self.unobservable:
            lines.append(
                "These measurements cannot see, and the fit left as it was: " + "; ".join(self.unobservable) + "."
            )
            for name, (a, b) in zip(self.nominal.joint_names, self.model.beside, strict=True):
                if any(f"{name} {what} " in f"{text} " for text in self.unobservable for what in ("tilt", "shift")):
                    lines.append(
                        f"Of {name}, a is the direction {_direction(a)} and b {_direction(b)}, in the base frame with "
                        "all joints at zero."
                    )
        told = np.where(self.shares > MOSTLY_SEEN, np.diag(self.covariance), 0.0)
        largest = np.argsort(-np.sqrt(told) / self.parameters.sizes)[:3]
        units = ["" if unit == "1" else f" {unit}" for unit in self.parameters.units]
        sure = "; ".join(
            f"{self.parameters.names[k]} to {np.sqrt(self.covariance[k, k]):.1e}{units[k]}"
            for k in largest
            if told[k] > 0
        )
        if sure:
            lines.append(f"Least sure among what was seen: {sure}.")
        return "\n".join(lines)

    def __repr__(self) -> str:
        return f"<Fit of {self.nominal.name}: {self.headline()}>"


def _direction(v: Array) -> str:
    return f"({', '.join(f'{x + 0.0:.3g}' for x in np.round(v, 3))})"


def _mm(metres: float) -> str:
    return f"{metres * 1e3:.3g} mm"


def _mrad(radians: float) -> str:
    return f"{radians * 1e3:.3g} mrad"
