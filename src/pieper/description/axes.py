"""An arm said as joint axes and the tool's pose at zero (product of exponentials), written as a DH table."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike

from pieper import arguments
from pieper.description.commonnormal import standard_table
from pieper.description.dh import Actuator, Description
from pieper.description.said import describe
from pieper.errors import InputError
from pieper.kinematics.pose import PoseLike, checked_pose
from pieper.tolerances import NO_DIRECTION, PARALLEL_AXES, ROUNDING, UNIT_SLACK


def from_axes(
    axes: ArrayLike,
    points: ArrayLike,
    home: PoseLike,
    *,
    joint_types: str | None = None,
    limits: Sequence[Sequence[float | None] | None] | ArrayLike | None = None,
    name: str = "arm",
    joint_names: Sequence[str] | None = None,
) -> Description:
    """Describe an arm by its joint axes with all joints at zero: T(q) = exp(S1 q1) ... exp(Sn qn) home.

    Args:
        axes: (n, 3) unit directions, base frame.
        points: (n, 3) a point on each axis, m; of a prismatic joint it does not matter.
        home: (4, 4) pose of the tool with all joints at zero.
        joint_types: Letters R and P, one a joint; all revolute when left out.
        limits: One (lower, upper) a joint, rad or m; None for a joint or a side without one.
        name: Name of the arm.
        joint_names: One name a joint.

    Raises:
        InputError: An axis without direction or not of unit length, arrays of other shapes, not a pose.

    Source: Brockett (1984); Lynch and Park (2017), section 4.1.
    """
    directions, at = _vectors(axes, "axes"), _vectors(points, "points")
    if len(directions) != len(at) or not len(at):
        raise InputError(
            f"axes and points must be as many, one a joint, got {len(directions)} and {len(at)}.",
            given=(len(directions), len(at)),
        )
    for i, length in enumerate(np.linalg.norm(directions, axis=1)):
        if length < NO_DIRECTION:
            raise InputError(f"the axis of joint {i + 1} has no direction: {directions[i].tolist()}.", index=i)
        if abs(length - 1) > UNIT_SLACK:
            raise InputError(
                f"the axis of joint {i + 1} has length {length:.6g}; axes are unit vectors (within {UNIT_SLACK:g}). "
                "Divide it by its length.",
                index=i,
                given=directions[i],
            )
    return described_by_axes(
        directions,
        at,
        checked_pose(home, "home"),
        joint_types=joint_types,
        limits=limits,
        name=name,
        joint_names=joint_names,
    )


def described_by_axes(
    axes: np.ndarray,
    points: np.ndarray,
    home: np.ndarray,
    *,
    remarks: Sequence[str] = (),
    joint_types: str | None = None,
    limits: Sequence[Sequence[float | None] | None] | ArrayLike | None = None,
    name: str = "arm",
    joint_names: Sequence[str] | None = None,
    sign: ArrayLike | None = None,
    offset: ArrayLike | None = None,
    coupling: ArrayLike | None = None,
    linked: Sequence[int] | None = None,
    actuator: Actuator | None = None,
    manufacturer: str = "",
    source: str = "",
    postures: Mapping[str, ArrayLike] | None = None,
) -> Description:
    """Return the arm of checked axes (n, 3), points (n, 3) and tool pose at zero as a standard DH table.

    `sign` and `offset` say how the joints' numbers lead to the angles about the axes: sign q + offset.
    """
    table = standard_table(axes, points, home)
    if table.largest_turn > ROUNDING:
        remarks = (
            *remarks,
            f"Neighbouring axes within {PARALLEL_AXES:g} rad were taken for parallel; the largest angle was "
            f"{table.largest_turn:.1e} rad.",
        )
    return describe(
        table.rows,
        convention="standard",
        base=table.base,
        tool=table.tool,
        joint_types=joint_types,
        limits=limits,
        name=name,
        joint_names=joint_names,
        sign=sign,
        offset=offset,
        coupling=coupling,
        linked=linked,
        actuator=actuator,
        manufacturer=manufacturer,
        source=source,
        notes=" ".join(remarks),
        remarks=remarks,
        postures=postures,
    )


def _vectors(given: ArrayLike, what: str) -> np.ndarray:
    array = np.array(arguments.numbers(given, what, "(n, 3) finite numbers, one row a joint"))
    if array.ndim != 2 or array.shape[-1] != 3 or not np.isfinite(array).all():
        raise InputError(f"{what} must be (n, 3) finite numbers, one row a joint.", given=given)
    return array
