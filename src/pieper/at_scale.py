"""The part of Arm that goes beyond one pose: calibrated arms, solvers in other languages. Its methods delegate."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from pieper.description.dh import Description
from pieper.kinematics.arrays import ArrayLike, Indices
from pieper.kinematics.chain import Chain
from pieper.kinematics.pose import PoseLike
from pieper.solver.plan.plan import Plan

if TYPE_CHECKING:
    from pieper.calibration.fit import Fit


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
            language: "c", "c++", "python" (NumPy alone) or "javascript".
            path: The file; written whole or not at all. A .mjs is a module, any other JavaScript a script.
            name: What C's functions begin with: NAME_ik, NAME_fk.

        Raises:
            InputError: An unknown language, or a name that is no word.
            PlanError: The arm has no closed form that can be written down; the message says why.
        """
        from pieper.code.export import write

        return write(self, language, path, name)
