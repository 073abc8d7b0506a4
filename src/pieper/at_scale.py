"""The part of Arm that goes beyond one pose: reach maps, calibration, solvers in other languages; it delegates."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from pieper.description.dh import Description
from pieper.kinematics.arrays import Array, ArrayLike, Indices
from pieper.kinematics.chain import Chain
from pieper.kinematics.pose import PoseLike
from pieper.solver.plan.plan import Plan

if TYPE_CHECKING:
    from concurrent.futures import Executor

    from pieper.calibration.fit import Fit
    from pieper.maps.reach_map import ReachMap


class AtScale:
    """What an arm does at scale; `pieper.Arm` has it all."""

    description: Description
    chain: Chain

    @property
    def plan(self) -> Plan:
        """How the arm is solved for its default task."""
        raise NotImplementedError

    def calibrate(
        self,
        q: ArrayLike,
        measured: PoseLike | None,
        *,
        kind: str = "pose",
        sigma: Sequence[float] | float | None = None,
        hold: Sequence[str] = (),
        joint_terms: Sequence[str] = (),
        loss: str = "linear",
        holdout: float = 0.25,
    ) -> Fit:
        """Fit the arm to what was measured, and judge it on poses that were held out; see docs/calibration.md.

        Args:
            q: (N, n) joint vectors, rad or m.
            measured: Kind "pose": (N, 4, 4) in the base frame; "position": (N, 3), m; "distance": (N,) from one unknown
                fixed point, m; "plane": (N,) heights over one unknown plane, m, None for touching it.
            kind: What was measured.
            sigma: Noise (m, rad) of one number; estimated from what is left when not said.
            hold: Joints, "tool", or single numbers (`fit.parameters.names`) that stay nominal.
            joint_terms: Any of "gain", "coupling", "harmonic": what joints do beside their geometry.
            loss: "linear", or "huber" against outliers, which are named and left out.
            holdout: Part of the poses, evenly spread, that only judges.

        Raises:
            InputError: Too few or identical poses, or data in degrees, millimetres, another frame, with a joint's
                sense wrong or rows out of step: the message says which.
        """
        from pieper.calibration.calibrate import calibrate

        return calibrate(
            self,
            q,
            measured,
            kind=kind,
            sigma=sigma,
            hold=hold,
            joint_terms=joint_terms,
            loss=loss,
            holdout=holdout,
            make=type(self),
        )

    def choose_poses(
        self, k: int, candidates: ArrayLike, *, kind: str = "pose", sigma: Sequence[float] | None = None
    ) -> Indices:
        """Choose k of joint vectors (N, n) whose measurements together say most about the arm; returns rows (k,)."""
        from pieper.calibration.choose import choose_poses

        return choose_poses(self, k, candidates, kind=kind, sigma=sigma)

    def code(self, language: str, path: str | os.PathLike[str], name: str = "arm") -> Path:
        """Write the arm's solver in another language, to be used without pieper; see docs/code.md.

        Args:
            language: "c", "c++", "python" (NumPy alone), "matlab" (and Octave), "javascript", "jax" or "wasm".
            path: The file; written whole or not at all. A .mjs is a module, any other JavaScript a script; for wasm
                a .mjs holds the code within. MATLAB wants a file a function: a folder, or a .m they stand beside.
            name: What the functions begin with: NAME_ik, NAME_fk (ik, fk in Python and JavaScript).

        Raises:
            InputError: An unknown language, or a name that is no word.
            PlanError: The arm has no closed form that can be written down; the message says why.
        """
        from pieper.code.write import write

        return write(self, language, path, name)

    def reach_map(
        self,
        box: Sequence[Sequence[float]],
        step: float,
        orientations: Sequence[int] | ArrayLike = (128, 16),
        symmetry: str = "auto",
        store: str | os.PathLike[str] | None = None,
        executor: Executor | None = None,
        progress: Callable[[int, int], None] | None = None,
        measure: bool = False,
    ) -> ReachMap:
        """Fill a box with answers: where the tool gets inside the limits, in which orientations; see docs/maps.md.

        Args:
            box: ((x0, x1), (y0, y1), (z0, z1)), m, base frame.
            step: Side of a voxel, m.
            orientations: (directions of the tool's z axis, rolls about it), or rotations (k, 3, 3).
            symmetry: "auto" uses that the last joint rolls the tool, where it does, limits kept; "none" solves all.
            store: A folder that keeps finished tiles: asked again, the same map goes on where it stopped.
            executor: Any `concurrent.futures` executor, dask.distributed's among them; all cores of this machine
                without one.
            progress: Told after each tile how many of how many are done.
            measure: Also keep the best manipulability and distance to limits of each voxel.

        Raises:
            InputError: A box or step that is none or in millimetres, a store of another map, a map too large to hold.
        """
        from pieper.maps.reach_map import reach_map

        return reach_map(self.plan, box, step, orientations, symmetry, store, executor, progress, measure)

    def base_places(self, Ts: PoseLike, x: ArrayLike, y: ArrayLike, z: ArrayLike, yaw: ArrayLike) -> Array:
        """Return the share (nx, ny, nz, nyaw) of poses Ts (N, 4, 4) reached from each base at x, y, z, m, yaw, rad.

        Poses are in the world; the base stands upright, and the arm's own base pose counts from there.
        """
        from pieper.maps.reach_map import base_places

        return base_places(self.plan, Ts, x, y, z, yaw)
