"""What a family hands to the native solver: which kernel, and the numbers it needs."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np


@dataclass(frozen=True, eq=False)
class KernelSpec:
    """A prepared kernel.

    Args:
        kind: Name of the kernel in `pieper._kernel`.
        max_solutions: Slots a pose has; a slot keeps its meaning where the family says so.
        params: float64 parameters, laid out as the kernel's header says.
        iparams: int32 parameters.
        info: What the preparation found that a person may want to read (conditioning, chosen split, ...).
        slot_labels: A posture label a slot, where slots have a fixed meaning; else None.
    """

    kind: str
    max_solutions: int
    params: np.ndarray
    iparams: np.ndarray = field(default_factory=lambda: np.zeros(1, np.int32))
    info: dict = field(default_factory=dict)
    slot_labels: tuple[str, ...] | None = None
