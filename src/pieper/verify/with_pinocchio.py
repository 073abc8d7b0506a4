"""An arm in Pinocchio: read by its own reader from the URDF it came from, or built joint by joint of the table."""

from __future__ import annotations

from typing import Any

import numpy as np

from pieper.description.dh import Description
from pieper.errors import InputError
from pieper.kinematics.arrays import Array
from pieper.verify.placements import placements


class Pinocchio:
    """A model and its data; see `toolboxes.Toolbox`."""

    def __init__(self, arm: Description) -> None:
        import pinocchio as pin  # pyright: ignore[reportMissingImports]

        self._pin: Any = pin
        self.name = f"pinocchio {pin.__version__}"
        origin = arm.origin if arm.coupling is None else None
        self._base: Any = None
        if origin is not None and origin.kind == "URDF":
            try:
                self._model: Any = pin.buildModelFromUrdf(origin.file)
            except (ValueError, RuntimeError) as error:
                raise InputError(f"pinocchio cannot read {origin.file}: {error}", file=origin.file) from None
            said = f"pinocchio read {origin.file} itself, from link {origin.base} to link {origin.tip}"
            joints = [self._model.getJointId(name) for name in arm.joint_names]
            self._base, self._tip = (self._frame(link) for link in (origin.base, origin.tip))
        else:
            self._model, joints, self._tip = self._built(arm)
            said = "pinocchio was given one joint a row, placed by the table's constants (joint about its own z)"
        self._data: Any = self._model.createData()
        # a continuous joint of a URDF has two numbers, cosine and sine
        self._at = [(self._model.joints[j].idx_q, self._model.joints[j].nq) for j in joints]
        self._columns = [self._model.joints[j].idx_v for j in joints]
        self.words = (
            f"{said}; its Jacobian is asked for in LOCAL_WORLD_ALIGNED, linear rows first, and turned into the base "
            "frame. It has no inverse kinematics of its own: Newton's method runs on its poses and Jacobians."
        )

    def _built(self, arm: Description) -> tuple[Any, list[int], int]:
        pin, placed = self._pin, placements(arm)
        model, parent, joints = pin.Model(), 0, []
        coupled = np.eye(arm.n) if arm.coupling is None else arm.coupling
        self._mix = coupled * placed.sense[:, None]
        for i in range(len(placed.before)):
            kind = pin.JointModelPZ() if placed.slides[i] else pin.JointModelRZ()
            parent = model.addJoint(parent, kind, pin.SE3(placed.before[i]), f"joint {i}")
            joints.append(parent)
        tool = model.addFrame(pin.Frame("tool", parent, 0, pin.SE3(placed.tool), pin.FrameType.OP_FRAME))
        return model, joints, tool

    def _frame(self, link: str) -> int:
        if not self._model.existFrame(link):
            raise InputError(f"pinocchio has no link {link!r} in this file.", given=link)
        self._mix = None
        return int(self._model.getFrameId(link))

    def _full(self, q: Array) -> Array:
        values = q if self._mix is None else self._mix @ q
        out = np.array(self._pin.neutral(self._model))
        for (at, size), value in zip(self._at, values, strict=True):
            out[at : at + size] = value if size == 1 else (np.cos(value), np.sin(value))
        return out

    def fk(self, q: Array) -> Array:
        """Pose (4, 4) of the tool."""
        self._pin.framesForwardKinematics(self._model, self._data, self._full(q))
        tip = self._data.oMf[self._tip]
        return np.array((tip if self._base is None else self._data.oMf[self._base].inverse() * tip).homogeneous)

    def jacobian(self, q: Array) -> Array:
        """Jacobian (6, n)."""
        frame = self._pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
        full = self._full(q)
        J = np.array(self._pin.computeFrameJacobian(self._model, self._data, full, self._tip, frame))
        if self._base is not None:
            self._pin.framesForwardKinematics(self._model, self._data, full)
            J -= self._moved_base(full, self._data.oMf[self._tip].translation)
            R = np.array(self._data.oMf[self._base].rotation).T
            J = np.vstack([R @ J[:3], R @ J[3:]])
        J = J[:, self._columns]
        return J if self._mix is None else J @ self._mix

    def _moved_base(self, full: Array, tip: Array) -> Array:
        """Return the motion (6, nv) that the tip would have if it were fixed to the base, which may move too."""
        frame = self._pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
        J = np.array(self._pin.computeFrameJacobian(self._model, self._data, full, self._base, frame))
        arm = np.asarray(tip) - np.asarray(self._data.oMf[self._base].translation)
        return np.vstack([J[:3] + np.cross(J[3:].T, arm).T, J[3:]])

    def solve(self, T: Array, start: Array) -> Array | None:
        """Pinocchio has no inverse kinematics of its own."""
        return None


def build(arm: Description) -> Pinocchio:
    """Return the arm as Pinocchio has it."""
    return Pinocchio(arm)
