"""What may be missing from a formula about an arm."""

from __future__ import annotations

from collections.abc import Mapping

from pieper.algebra.expression import Call, Expr, Mul
from pieper.algebra.formula import angle_sum
from pieper.judge.circular import axis_senses
from pieper.judge.evidence import Evidence
from pieper.judge.search.lookup import AMONG, FACTORS, Lost, letters_of
from pieper.judge.search.search import Goal
from pieper.judge.slips.formula_slips import factor_pool

RUN = 4  # parallel joints whose sum may have been lost


def lost_from(ev: Evidence, node: Expr, goal: Goal, angle: Expr | None = None) -> Lost:
    """What may be missing from a formula.

    Args:
        ev: The arm.
        node: The formula as printed.
        goal: What it should give.
        angle: The angle that it is for; None for other formulas.
    """
    own = frozenset(angle.symbols()) if angle is not None else frozenset[str]()
    pool = factor_pool(node, ev.lengths, ev.model.n)
    turning = [j for j in range(1, ev.model.n + 1) if not ev.model.sliding(j)]
    senses = axis_senses(ev.model)
    for k, first in enumerate(turning):
        for last in range(k, min(k + RUN, len(turning))):
            signs = [(senses[first - 1][j - 1], j) for j in turning[k : last + 1]]
            if all(sign for sign, _ in signs):
                for name in ("cos", "sin"):
                    call = Call(name, angle_sum(tuple(signs)))
                    pool.setdefault(str(call), call)
    slides: dict[str, str] = {}
    for name, to in ev.model.aliases.items():
        if to not in own and name not in ev.model.values and (to not in slides or name in node.symbols()):
            slides[to] = name
    sliding = set(slides.values())
    letters = letters_of(node, pool, goal.env, own, sliding)
    return Lost(letters, ev.model.n, own, angle is not None, _long(node, letters, ev))


def _long(node: Expr, letters: Mapping[str, Expr], ev: Evidence) -> tuple[str, ...]:
    """Letters of a lost term of more than three: none where no term is long, else sines, cosines and lengths.

    Those of single joints and those that the formula has come first: of a term that was lost no letter need stand
    elsewhere.
    """
    if not any(isinstance(x, Mul) and len(x.args) >= FACTORS for x in node.walk()):
        return ()
    inside = {str(x) for x in node.walk()}
    kept = [text for text, x in letters.items() if isinstance(x, Call) or (text in ev.lengths and text in inside)]
    kept.sort(key=lambda text: (text not in inside, len(str(letters[text]))))
    return tuple(kept[:AMONG])
