"""Inverse kinematics that PyTorch differentiates: `pieper.torch.ik(arm)`."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from pieper.code.differentiable import Lends, Solvable, checked_plan, framework, pose_gradient, rows


def ik(arm: Solvable) -> Callable[[Any], Any]:
    """Return a function from poses (..., 4, 4) to (q (..., slots, 6), inside (..., slots)), with a backward pass.

    The native solver runs on the processor; tensors come back on the device and with the number type of the poses
    (float64 where that is none for fractions). Rows are zeros where `inside` is false. It may be mapped and
    differentiated by torch.func. Derivatives follow from the implicit function theorem; see docs/code.md for what
    happens at singular poses. There is one derivative, no second.

    Raises:
        PlanError: The arm has not six joints.
        ModuleNotFoundError: PyTorch is not installed.
    """
    torch: Any = framework("torch", "PyTorch")
    plan = checked_plan(arm)

    def numbers(tensor: Any) -> Any:
        return tensor.detach().cpu().numpy()

    class Whole(torch.autograd.Function):
        """Maps over poses by asking for all of them at once."""

        @classmethod
        def vmap(cls, info: Any, in_dims: Any, *given: Any) -> Any:
            first = [
                x.expand(info.batch_size, *x.shape) if dim is None else x.movedim(dim, 0)
                for x, dim in zip(given, in_dims, strict=True)
            ]
            found = cls.apply(*first)
            return found, (0,) * len(found) if isinstance(found, tuple) else 0

    class Slope(Whole):
        """The backward pass as a function of its own: it is mapped, and its derivative is not taken for zero."""

        @staticmethod
        def forward(T: Any, q: Any, inside: Any, g: Any) -> Any:
            return torch.from_numpy(pose_gradient(plan.chain, *map(numbers, (T, q, inside, g)))).to(T.device)

        @staticmethod
        def setup_context(ctx: Any, inputs: Any, output: Any) -> None:
            """Nothing is kept."""

        @staticmethod
        def backward(ctx: Any, *cotangents: Any) -> Any:
            raise NotImplementedError(
                "pieper.torch.ik gives first derivatives; a second one was asked for. Take differences of the first."
            )

    class Solve(Whole):
        @staticmethod
        def forward(T: Any) -> Any:
            q, inside = rows(plan, numbers(T))
            return torch.from_numpy(q).to(T.device), torch.from_numpy(inside).to(T.device)

        @staticmethod
        def setup_context(ctx: Any, inputs: Any, output: Any) -> None:
            ctx.mark_non_differentiable(output[1])
            ctx.save_for_backward(*inputs, *output)

        @staticmethod
        def backward(ctx: Any, *cotangents: Any) -> Any:
            return Slope.apply(*ctx.saved_tensors, cotangents[0])

    def solve(T: Any) -> Any:
        if not isinstance(T, torch.Tensor):
            T = torch.from_dlpack(T) if isinstance(T, Lends) else torch.tensor(np.asarray(T, np.float64))
        # solved in double precision: single precision loses rows
        q, inside = Solve.apply(T.double())
        return q.to(T.dtype) if T.is_floating_point() else q, inside

    return solve
