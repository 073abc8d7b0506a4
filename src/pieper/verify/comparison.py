"""What a toolbox and pieper say of the same arm, side by side: poses, Jacobians, inverse solutions."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper import arguments
from pieper.description.dh import Description
from pieper.errors import PlanError
from pieper.kinematics import forward
from pieper.kinematics.arrays import Array, Indices
from pieper.kinematics.newton import settled, shortest
from pieper.kinematics.pose import pose_error, rotation_vector
from pieper.solver import verbs
from pieper.solver.plan.planned_arm import PlannedArm
from pieper.tolerances import (
    TINY,
    VERIFY_AGREES,
    VERIFY_KNOWN,
    VERIFY_ON_CURVE,
    VERIFY_PER_SIGMA,
    VERIFY_SETTLED,
    VERIFY_SHORTEST,
)
from pieper.verify.toolboxes import Toolbox, open_toolbox
from pieper.words_by_number import plural

#: Starts from which the toolbox looks for solutions of one pose.
STARTS = 4
#: Joints without limits are drawn from this far on both sides, rad or m.
ENDLESS = np.pi


@dataclass(frozen=True, eq=False)
class Line:
    """One thing that was compared.

    Attributes:
        what: What it is.
        worst: The worst difference.
        unit: Its unit.
        count: How many were compared.
        q: (n,) where the worst was met.
        agrees: Whether it is rounding.
    """

    what: str
    worst: float
    unit: str
    count: int
    q: Array
    agrees: bool


@dataclass(frozen=True, eq=False)
class Comparison:
    """An arm compared with a toolbox.

    Attributes:
        arm: The arm's name.
        toolbox: The toolbox and its version.
        conventions: How the toolbox was given the arm, and in which conventions both answer, in sentences.
        lines: What was compared.
        missing: (k, n) solutions that the toolbox found and pieper did not give.
        remarks: What one should know beside the numbers, in sentences.
    """

    arm: str
    toolbox: str
    conventions: str
    lines: tuple[Line, ...]
    missing: Array
    remarks: tuple[str, ...]

    @property
    def agrees(self) -> bool:
        """Whether every difference is rounding and no solution is missing."""
        return all(line.agrees for line in self.lines) and not len(self.missing)

    def cells(self) -> list[tuple[str, str, str]]:
        """Return the table: what was compared, of how many, the worst difference with its unit."""
        return [(line.what, f"{line.count:,}", f"{line.worst:.1e} {line.unit}") for line in self.lines]

    def explain(self) -> str:
        """Return the verdict, the conventions and the remarks as sentences."""
        verdict = f"{self.arm} and {self.toolbox} {'agree' if self.agrees else 'do not agree'}."
        off = [line.what for line in self.lines if not line.agrees]
        if off:
            verdict += f" More than rounding: {', '.join(off)}."
        if len(self.missing):
            is_or_are = "is" if len(self.missing) == 1 else "are"
            verdict += f" {plural(len(self.missing), 'solution')} of the toolbox {is_or_are} missing here."
        return "\n".join([verdict, self.conventions, *self.remarks])

    def __str__(self) -> str:
        wide = max(len(what) for what, _, _ in self.cells())
        rows = [f"{what:<{wide}}  {count:>6}  {worst}" for what, count, worst in self.cells()]
        return "\n".join([*rows, self.explain()])


def compare(arm: PlannedArm, toolbox: str | Toolbox, *, poses: int = 100, seed: int = 0) -> Comparison:
    """Compare an arm with what a toolbox makes of it, at random postures inside the limits.

    Args:
        arm: The arm.
        toolbox: "roboticstoolbox", "pinocchio", "mujoco", or anything that answers as `toolboxes.Toolbox` does.
        poses: How many postures; inverse solutions are compared at a quarter of them.
        seed: Of the random numbers.

    Raises:
        InputError: The toolbox is not known, not installed, or cannot read the arm.
    """
    arguments.whole(poses, "poses", 1)
    if not isinstance(toolbox, Toolbox):
        toolbox = open_toolbox(arguments.text(toolbox, "toolbox"), arm.description)
    other, rng = toolbox, np.random.default_rng(arguments.whole(seed, "seed", 0))
    q = _postures(arm.description, poses, rng)
    lines, remarks = _forward(arm, other, q), list(arm.description.remarks)
    found, missing = [], np.empty((0, arm.chain.n))
    try:
        found, missing, said = _inverse(arm, other, q[: max(1, poses // 4)], rng)
        remarks += said
    except PlanError as error:
        remarks.append(f"No inverse solutions are compared: {error}")
    ours = (
        " pieper's poses are of the tool in the base frame; its Jacobians are of the tool point in the base frame, "
        "linear rows first, in metres and radians."
    )
    return Comparison(arm.description.name, other.name, other.words + ours, (*lines, *found), missing, tuple(remarks))


def _postures(arm: Description, count: int, rng: np.random.Generator) -> Array:
    low, high = arm.limits.T
    low = np.where(np.isfinite(low), low, np.minimum(-ENDLESS, np.where(np.isfinite(high), high - ENDLESS, -ENDLESS)))
    high = np.where(np.isfinite(high), high, np.maximum(ENDLESS, low + ENDLESS))
    return low + (high - low) * rng.random((count, arm.n))


def _forward(arm: PlannedArm, other: Toolbox, q: Array) -> list[Line]:
    length = arm.chain.length
    apart = pose_error(forward.fk(arm.chain, q), np.array([other.fk(row) for row in q]))
    J = forward.jacobian(arm.chain, q) - np.array([other.jacobian(row) for row in q])
    lines = [
        _line("forward kinematics, position", apart[:, 0], "m", q, length),
        _line("forward kinematics, orientation", apart[:, 1], "rad", q, 1.0),
    ]
    kinds = np.array([kind == "P" for kind in arm.description.joint_types])
    for rows, what in ((slice(0, 3), "linear"), (slice(3, 6), "angular")):
        for chosen, joint, unit in ((~kinds, "turning", "rad"), (kinds, "sliding", "m")):
            if chosen.any():
                size = np.abs(J[:, rows][:, :, chosen]).reshape(len(q), -1).max(1)
                of = f"{'m' if what == 'linear' else 'rad'}/{unit}"
                scale = length if of == "m/rad" else 1.0 / length if of == "rad/m" else 1.0
                lines.append(_line(f"Jacobian, {what} rows, {joint} joints", size, of, q, scale))
    return lines


def _line(what: str, off: Array, unit: str, q: Array, scale: float) -> Line:
    at = int(np.argmax(off))
    return Line(what, float(off[at]), unit, len(off), q[at], bool(off[at] <= VERIFY_AGREES * scale))


def _inverse(
    arm: PlannedArm, other: Toolbox, q: Array, rng: np.random.Generator
) -> tuple[list[Line], Array, list[str]]:
    """Put pieper's solutions through the toolbox, and look for the toolbox's among pieper's."""
    task, joints = arm.plan.task, arm.chain.joints
    back, rows, near, missing, met, on_curves, own = [], [], [], [], 0, 0, 0
    for start, T in zip(q, np.array([other.fk(row) for row in q]), strict=True):
        sols = verbs.ik(arm.plan, T, _held(arm, start))
        # where the joints to spare are held, what is left of a self-motion are points
        curves = () if _held(arm, start) else sols.self_motions
        every = np.concatenate([sols.all_q, *(sm.samples for sm in curves)])
        back += [_left(other.fk(row), T, task) for row in every]
        rows += list(every)
        theirs, solved = _theirs(arm, other, T, start, rng)
        own += solved
        met += len(theirs)
        for row, slack in theirs:
            # of an arm with joints to spare, what it gives where these are the toolbox's
            given = sols if _held(arm, row) is None else verbs.ik(arm.plan, T, _held(arm, row))
            apart = float(joints.apart(given.all_q, row).min()) if len(given.all_q) else np.inf
            if apart <= slack:
                near.append(apart)
            elif any(sm.contains(row, VERIFY_ON_CURVE) for sm in (curves if given is sols else ())):
                on_curves += 1
            else:
                missing.append(row)
    lines = []
    if back:
        off, at = np.array(back), np.array(rows)
        length = arm.chain.length
        lines.append(_line("pieper's solutions put back, position", off[:, 0], "m", at, length))
        if task != "position":
            lines.append(_line("pieper's solutions put back, orientation", off[:, 1], "rad", at, 1.0))
    if near:
        lines.append(Line("its solutions beside pieper's, joints", max(near), "rad or m", len(near), q[0], True))
    said = [
        f"Of {plural(len(q), 'pose')}, the toolbox solved from {STARTS} starts each: {plural(met, 'solution')}, "
        f"{len(near):,} of them among pieper's isolated ones, {on_curves:,} on self-motions, {len(missing):,} missing."
    ]
    if own:
        said.append(f"{plural(own, 'of these was', 'of these were')} met by its own inverse kinematics.")
    return lines, np.array(missing).reshape(-1, arm.chain.n), said


def _held(arm: PlannedArm, q: Array) -> dict[str, float] | None:
    """Return the values that q has of the joints an arm has to spare; None where it has none."""
    names, spare = arm.description.joint_names, arm.plan.redundancy
    if not spare or not set(spare) <= set(names):
        return None
    return {name: float(q[names.index(name)]) for name in spare}


def _may_be_held(arm: PlannedArm, q: Array) -> bool:
    """Return whether the joints to spare are inside their limits, where alone they can be held."""
    held = _held(arm, q) or {}
    low, high = arm.description.limits.T
    return all(low[i] <= held[n] <= high[i] for i, n in enumerate(arm.description.joint_names) if n in held)


def _left(T: Array, wanted: Array, task: str) -> tuple[float, float]:
    """Return what is left of a pose that a solution should reach: metres, radians (of the tool's axis by task)."""
    metres, radians = (float(v) for v in pose_error(T, wanted))
    if task == "position+axis":
        radians = float(np.arctan2(np.linalg.norm(np.cross(T[:3, 2], wanted[:3, 2])), T[:3, 2] @ wanted[:3, 2]))
    return metres, radians


def _theirs(
    arm: PlannedArm, other: Toolbox, T: Array, near: Array, rng: np.random.Generator
) -> tuple[list[tuple[Array, float]], int]:
    """Return solutions (n,) of the toolbox, how well a pose pins each down, and how many its own solver met."""
    starts = [near + 0.1 * rng.standard_normal(arm.chain.n), *_postures(arm.description, STARTS - 1, rng)]
    solved = [other.solve(T, start) for start in starts]
    q = np.array([start if one is None else one for start, one in zip(starts, solved, strict=True)])
    length, unit = arm.chain.length, arm.chain.joints.unit

    def miss(at: Array, _: Indices) -> Array:
        now = np.array([other.fk(row) for row in at])
        turned = rotation_vector(T[:3, :3] @ np.swapaxes(now[:, :3, :3], 1, 2))
        return np.concatenate([(T[:3, 3] - now[:, :3, 3]) / length, turned], axis=1)

    def slope(at: Array, _: Indices) -> Array:
        J = np.array([other.jacobian(row) for row in at]) * unit
        J[:, :3] /= length
        return J

    found, left = settled(miss, slope, q, unit, steps=40, longest=0.5, step=shortest(VERIFY_SHORTEST))
    kept = []
    for row, size in zip(arm.chain.joints.wrapped(found), left, strict=True):
        sigma = np.linalg.svd(slope(row[None], np.zeros(1, np.int64))[0], compute_uv=False)[min(arm.chain.n, 6) - 1]
        if size <= VERIFY_SETTLED and _may_be_held(arm, row):
            kept.append((row, VERIFY_KNOWN + VERIFY_PER_SIGMA / max(float(sigma), TINY)))
    return kept, sum(one is not None for one in solved)
