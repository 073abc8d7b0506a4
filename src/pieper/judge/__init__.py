"""What somebody else's equations are worth."""

from pieper.judge.claims import check
from pieper.judge.verdict import Judgement, Verdict

__all__ = ["Judgement", "Verdict", "check"]
