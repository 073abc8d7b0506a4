"""An arm in MuJoCo: the model it came from, or bodies and joints made of the table."""

from __future__ import annotations

from typing import Any

import numpy as np

from pieper.description import mjcf
from pieper.description.dh import Description
from pieper.description.mjcf_ties import Ties, body_names, name_of, ties_of
from pieper.kinematics.arrays import Array
from pieper.kinematics.pose import inverse
from pieper.verify.placements import placements


class MuJoCo:
    """A model and its data; see `toolboxes.Toolbox`."""

    def __init__(self, arm: Description) -> None:
        import mujoco  # pyright: ignore[reportMissingImports]

        self._mujoco: Any = mujoco
        self.name = f"mujoco {mujoco.__version__}"
        origin = arm.origin
        self._base, self._tip = None, ("site", "tool")
        self._mix: Array | None = None
        ties = Ties()
        if origin is not None and origin.kind == "MJCF":
            self._model: Any = mjcf.compiled(mujoco, origin.file)
            self._base, self._tip = self._place(origin.base), self._place(origin.tip)
            said = f"mujoco read {origin.file} itself, from {origin.base} to {origin.tip}"
            known = {name_of(self._model, j): j for j in range(self._model.njnt)}
            joints = [known[name] for name in arm.joint_names]
            ties = ties_of(self._model, mujoco)
        else:
            self._model = self._built(arm)
            said = "mujoco was given one body a row, placed by the table's constants (joint about its own z)"
            known = {str(self._model.joint(j).name): j for j in range(self._model.njnt)}
            joints = [known[f"joint {i}"] for i in range(len(arm.rows))]
        self._data: Any = mujoco.MjData(self._model)
        self._at = [int(self._model.jnt_qposadr[j]) for j in joints]
        self._columns = [int(self._model.jnt_dofadr[j]) for j in joints]
        self._rest = np.array(self._model.qpos0)
        for j, value in ties.held.items():
            self._rest[self._model.jnt_qposadr[j]] = value
        # a follower may follow a follower: as many rounds as there are followers reach the last
        self._follow = [(j, known[mimic.joint], mimic) for j, mimic in ties.mimics.items()] * len(
            ties.mimics
        )
        self.words = (
            f"{said}; poses are `xpos` and `xmat`, Jacobians `mj_jac` at the tool point, linear rows first, both "
            "turned into the base frame. It has no inverse kinematics of its own: Newton's method runs on its poses "
            "and Jacobians."
        )

    def _built(self, arm: Description) -> Any:
        mujoco, placed = self._mujoco, placements(arm)
        spec = mujoco.MjSpec()
        spec.compiler.degree = False
        body = spec.worldbody
        for i in range(len(arm.rows)):
            body = body.add_body(name=f"body {i}", pos=placed.before[i, :3, 3], quat=self._quaternion(placed.before[i]))
            body.mass, body.inertia, body.explicitinertial = 1.0, [1.0, 1.0, 1.0], True
            kind = mujoco.mjtJoint.mjJNT_SLIDE if placed.slides[i] else mujoco.mjtJoint.mjJNT_HINGE
            body.add_joint(name=f"joint {i}", type=kind, axis=[0, 0, placed.sense[i]])
        body.add_site(name="tool", pos=placed.tool[:3, 3], quat=self._quaternion(placed.tool))
        self._mix = arm.coupling
        return spec.compile()

    def _quaternion(self, T: Array) -> Array:
        out = np.empty(4)
        self._mujoco.mju_mat2Quat(out, np.ascontiguousarray(T[:3, :3]).reshape(9))
        return out

    def _place(self, name: str) -> tuple[str, str | int]:
        bodies = body_names(self._model)
        return ("body", bodies.index(name)) if name in bodies else ("site", name)

    def _pose(self, place: tuple[str, str | int]) -> Array:
        T = np.eye(4)
        thing = getattr(self._data, place[0])(place[1])
        T[:3, :3], T[:3, 3] = np.array(thing.xmat).reshape(3, 3), thing.xpos
        return T

    def _move(self, q: Array) -> None:
        self._data.qpos[:] = self._rest
        self._data.qpos[self._at] = q if self._mix is None else self._mix @ q
        for j, leader, mimic in self._follow:
            x = self._data.qpos[self._model.jnt_qposadr[leader]]
            self._data.qpos[self._model.jnt_qposadr[j]] = mimic.multiplier * x + mimic.offset
        self._mujoco.mj_kinematics(self._model, self._data)
        self._mujoco.mj_comPos(self._model, self._data)

    def fk(self, q: Array) -> Array:
        """Pose (4, 4) of the tool."""
        self._move(q)
        tip = self._pose(self._tip)
        return tip if self._base is None else inverse(self._pose(self._base)) @ tip

    def jacobian(self, q: Array) -> Array:
        """Jacobian (6, n)."""
        self._move(q)
        point = self._pose(self._tip)[:3, 3]
        J = self._slope(self._tip, point)
        if self._base is not None:
            R = self._pose(self._base)[:3, :3].T
            J = J - self._slope(self._base, point)
            J = np.vstack([R @ J[:3], R @ J[3:]])
        moved = np.zeros((J.shape[1], len(self._columns)))
        moved[self._columns, np.arange(len(self._columns))] = 1.0
        for j, leader, mimic in self._follow:
            moved[self._model.jnt_dofadr[j]] = mimic.multiplier * moved[self._model.jnt_dofadr[leader]]
        J = J @ moved
        return J if self._mix is None else J @ self._mix

    def _slope(self, place: tuple[str, str | int], point: Array) -> Array:
        """Return the Jacobian (6, nv) of a point (3,) that is fixed to a body or to a site's body."""
        body = self._model.body(place[1]).id if place[0] == "body" else self._model.site(place[1]).bodyid[0]
        linear, turning = np.zeros((3, self._model.nv)), np.zeros((3, self._model.nv))
        self._mujoco.mj_jac(self._model, self._data, linear, turning, point, int(body))
        return np.vstack([linear, turning])

    def solve(self, T: Array, start: Array) -> Array | None:
        """MuJoCo has no inverse kinematics of its own."""
        return None


def build(arm: Description) -> MuJoCo:
    """Return the arm as MuJoCo has it."""
    return MuJoCo(arm)
