"""Inverse kinematics that PyTorch differentiates: `pieper.torch.ik(arm)`."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from pieper.code.differentiable import Solvable, checked_plan, framework, pose_gradient, rows


def ik(arm: Solvable) -> Callable[[Any], Any]:
    """Return a function from poses (..., 4, 4) to (q (..., slots, 6), inside (..., slots)), with a backward pass.

    The native solver runs on the processor; tensors come back on the device and with the number type of the poses. Rows
    are zeros where `inside` is false. Derivatives follow from the implicit function theorem; see docs/code.md for
    what happens at singular poses.

    Raises:
        PlanError: The arm has not six joints.
        ModuleNotFoundError: PyTorch is not installed.
    """
    torch: Any = framework("torch", "PyTorch")
    plan = checked_plan(arm)

    class Solve(torch.autograd.Function):
        @staticmethod
        def forward(ctx: Any, T: Any) -> Any:
            poses = T.detach().cpu().double().numpy()
            q, inside = rows(plan, poses)
            ctx.poses, ctx.q, ctx.inside = poses, q, inside
            found, mask = torch.from_numpy(q).to(T), torch.from_numpy(inside).to(T.device)
            ctx.mark_non_differentiable(mask)
            return found, mask

        @staticmethod
        def backward(ctx: Any, *cotangents: Any) -> Any:
            g = cotangents[0].detach().cpu().double().numpy()
            found = pose_gradient(plan.chain, ctx.poses, ctx.q, ctx.inside, np.asarray(g))
            return torch.from_numpy(found).to(cotangents[0])

    return lambda T: Solve.apply(T if isinstance(T, torch.Tensor) else torch.from_dlpack(T))
