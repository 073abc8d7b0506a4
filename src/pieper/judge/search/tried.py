"""What a search for slips tried, in words."""

from __future__ import annotations

from pieper.judge.search.search import Explanation
from pieper.judge.slips.arm_slips import ARM_KINDS
from pieper.judge.slips.slip import KINDS


def tried_text(explanation: Explanation, arms_tried: dict[str, int] | None = None) -> str:
    """Say what a search tried, by kind."""
    parts = [f"{KINDS.get(kind, kind)} ({count})" for kind, count in explanation.tried.items()]
    parts += [f"{ARM_KINDS.get(kind, kind)} ({count})" for kind, count in (arms_tried or {}).items()]
    text = ", ".join(parts)
    return text + ("" if explanation.complete else "; the search stopped at its limit of time or length")
