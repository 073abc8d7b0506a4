"""Posture labels that a person uses: front or rear, elbow up or down, wrist flip."""

from __future__ import annotations

import numpy as np

from pieper.inverse.plan import Plan


def labels(plan: Plan, q: np.ndarray) -> list[str]:
    """Return a posture label for each row of q (m, n)."""
    if not len(q):
        return []
    from pieper.inverse.posture import posture_words

    return posture_words(plan, q)
