"""An arm in Corke's Robotics Toolbox: its DH links made of the table's own columns."""

from __future__ import annotations

from importlib.metadata import version
from typing import Any

import numpy as np

from pieper.description.dh import Description
from pieper.kinematics.arrays import Array


class RoboticsToolbox:
    """A DHRobot; see `toolboxes.Toolbox`."""

    def __init__(self, arm: Description) -> None:
        import roboticstoolbox as rtb  # pyright: ignore[reportMissingImports]
        from spatialmath import SE3  # pyright: ignore[reportMissingImports]

        self.name = f"roboticstoolbox {version('roboticstoolbox-python')}"
        ending = "DH" if arm.convention == "standard" else "MDH"
        self.words = (
            f"roboticstoolbox was given the table's columns as {ending} links (its own {arm.convention} convention), "
            "the joints' zeros as `offset`, reversed senses as `flip`, base and tool as poses; it answers by `fkine` "
            "and `jacob0`, linear rows first, in the base frame, and solves by `ikine_LM`."
        )
        kinds: dict[str, Any] = {"R": getattr(rtb, f"Revolute{ending}"), "P": getattr(rtb, f"Prismatic{ending}")}
        links = []
        for i, row in enumerate(arm.rows):
            slides = arm.axis_types[i] == "P"
            fixed = {"theta": row.theta} if slides else {"d": row.d}
            zero = (row.d if slides else row.theta) + float(arm.offset[i])
            said = arm.limits[arm.own_axes.index(i)] if i in arm.own_axes else np.full(2, np.inf)
            limits = np.where(np.isfinite(said), said, [-10.0, 10.0])
            links.append(
                kinds[arm.axis_types[i]](
                    a=row.a, alpha=row.alpha, offset=zero, flip=bool(arm.sign[i] < 0), qlim=limits, **fixed
                )
            )
        base, tool = (SE3(np.asarray(T), check=False) for T in (arm.base, arm.tool))
        self._robot: Any = rtb.DHRobot(links, base=base, tool=tool, name="arm")
        self._pose: Any = SE3
        self._coupling: Array = np.eye(arm.n) if arm.coupling is None else arm.coupling

    def fk(self, q: Array) -> Array:
        """Pose (4, 4) of the tool."""
        return np.asarray(self._robot.fkine(self._coupling @ q).A, float)

    def jacobian(self, q: Array) -> Array:
        """Jacobian (6, n)."""
        return np.asarray(self._robot.jacob0(self._coupling @ q), float) @ self._coupling

    def solve(self, T: Array, start: Array) -> Array | None:
        """Joint values (n,) by `ikine_LM`."""
        if len(start) < 6 or self._coupling.shape[0] != len(start):
            return None  # it needs to be told which of six coordinates do not count
        begin = self._coupling @ start
        found = self._robot.ikine_LM(self._pose(T, check=False), q0=begin, slimit=1, joint_limits=False, seed=0)
        if not found.success:
            return None
        return np.asarray(np.linalg.solve(self._coupling, np.asarray(found.q, float)), np.float64)


def build(arm: Description) -> RoboticsToolbox:
    """Return the arm as the Robotics Toolbox has it."""
    return RoboticsToolbox(arm)
