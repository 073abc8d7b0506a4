"""What somebody else's equations are worth."""

from pieper.judge.claims import check, guess_claims
from pieper.judge.verdict import Judgement, Verdict

__all__ = ["Judgement", "Verdict", "check", "guess_claims"]
