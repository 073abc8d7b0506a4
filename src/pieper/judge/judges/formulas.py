"""Judges of formulas that must be equal: an entry of a matrix, an equation."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from pieper.algebra.expression import Add, Expr, Mul, Num
from pieper.algebra.formula import Equation, Neg, has_branch, on_branch
from pieper.errors import InputError
from pieper.judge.claim import Claim
from pieper.judge.difference import (
    IDENTICAL,
    agreeing_digits,
    difference_from_matrix,
    digits_wanted,
    simplified_difference,
)
from pieper.judge.evidence import Evidence, number, under
from pieper.judge.lengths import standing
from pieper.judge.matrices import value_of
from pieper.judge.model import POSE_NAMES
from pieper.judge.products import Product, parse_product
from pieper.judge.regions import region_of, zero_denominators
from pieper.judge.rounding import unrounded, with_rounding
from pieper.judge.search.search import MAX_SEARCHED, Explanation, Goal, says_nothing, search
from pieper.judge.search.tried import tried_text
from pieper.judge.slips.formula_slips import slips
from pieper.judge.slips.lost_parts import lost_from
from pieper.judge.verdict import HOLDS, Verdict
from pieper.tolerances import NEARLY, NEARLY_ROUNDED

_ENTRY_OF = {name: (i, j) for name, i, j in POSE_NAMES}


def judge_entry(ev: Evidence, claim: Claim) -> Verdict:
    """Judge one entry of a matrix given as a formula (keys of, is, where)."""
    ev = ev.holding(claim)
    product = _entry_product(ev, claim)
    left, equals, right = str(claim["is"]).partition("=")
    written_out = equals and "=" not in right and _same_entry(left, str(claim["of"]))
    node = ev.parse(right if written_out else str(claim["is"]), claim.where)
    with under("of"):
        wanted = value_of(product, ev.samples.frames)
    if wanted.ndim != 1:
        raise claim.error(f"{claim['of']!r} is a whole matrix; say which entry, as in {claim['of']}[1,4]", "of")
    text = right.strip() if written_out else claim["is"]
    return judge_equal(ev, claim.reads(f"{claim['of']} = {text}"), node, wanted, product=product)


def _same_entry(left: str, entry: str) -> bool:
    """Whether the left side that is written out is the entry's name."""
    bare = [re.sub(r"[\s_{}\\]", "", name).lower() for name in (left, entry)]
    return bare[0] == bare[1]


def judge_equation(ev: Evidence, claim: Claim) -> Verdict:
    """Judge an equation between two formulas, with the pose letters of the frame it names (keys is, where, frame)."""
    ev = ev.holding(claim)
    text = str(claim["is"])
    local = ev.local(claim.where)
    with under("is"):
        sides = ev.read_equation(text, local)
    frame, claim = ev.frame(claim), claim.reads(text)
    node = Equation(*sides).substitute(local)
    if has_branch(node):
        # the one sign or the other: the product of both differences vanishes
        sided = [on_branch(node, sign).args for sign in (1, -1)]
        both = [Add.of(left, Neg.of(right)) for left, right in sided]
        one = judge_equal(ev, claim, Equation(Mul.of(*both), Num(0)), None, frame=frame)
        if one.status == HOLDS:
            said = f"Holds with the one sign or the other: right at {one.tried} of {one.tried} joint vectors."
            return claim.holds(said, digits=one.digits, right=one.right, tried=one.tried)
    return judge_equal(ev, claim, node, None, frame=frame)


def judge_equal(
    ev: Evidence,
    claim: Claim,
    node: Expr,
    wanted: np.ndarray | None,
    *,
    product: Product | None = None,
    frame: Product | None = None,
    source: Callable[[Evidence], np.ndarray] | None = None,
) -> Verdict:
    """Judge a formula against right values (or an `Equation` against itself) at every sample.

    Args:
        ev: the arm and its samples.
        claim: the claim, with its text.
        node: the formula, or an equation.
        wanted: (K,) right values; None for an equation.
        product: where the right values come from, to name it and to find it for other arms.
        frame: the frame whose letters the formula uses.
        source: where the right values come from, if neither from a product nor from the formula itself.
    """
    right = _Right(product, frame, source)
    named = ev.naming(node)
    if named is not ev:
        ev, wanted = named, None if wanted is None else right.wanted(named)
    goal = ev.goal(wanted, frame=frame)
    off, own = goal.residual(node), ev.samples.nominal
    good = off < 1
    if good[own].all():
        return _equal_holds(ev, claim, node, good, right)
    nearly = _nearly(ev, node, off[good & own])
    if nearly:
        good = off < nearly  # a small difference that is there everywhere, and below the tolerance at some
    exact = unrounded(ev, node, right.gap, right.judged)
    if exact:
        off = f"as printed it is off by {exact.off:.2g} at most"
        verdict = _equal_holds(ev, claim, exact.tree, right.judged(ev, exact.tree), right, rounding=off)
        return with_rounding(verdict, exact, off)
    vanish = zero_denominators(node, goal.env)
    details: list[tuple[str, str]] = []
    if vanish:
        details.append(("undefined", f"the denominator {vanish[0]} is zero for all joints"))
    else:
        details.append(("counter-example", _counter_example(ev, node, goal, good, wanted)))
    region = "" if nearly else region_of(ev, lambda at: (right.judged(at, node), at.environment(frame)))
    found = _explanation(ev, node, goal, good, product, frame)
    details += found.details
    said: dict[str, Any] = {
        "details": details,
        "slip": found.slip,
        "reading": found.reading,
        "difference": found.difference,
    }
    said |= {"right": int(good.sum()), "tried": len(good)}
    if region:
        return claim.partly(f"Holds only where {region}.", **said)
    if good.mean() > 0.1:
        share = f"{100 * good.mean():z.0f}% of the joint vectors"
        return claim.partly(f"Holds at {share} only; no simple region was found.", **said)
    sentence = f"Wrong: right at {int(good.sum())} of {len(good)} joint vectors."
    if vanish:
        sentence = "Wrong: undefined, because it divides by zero for all joints."
    return claim.wrong(sentence, **said)


def _nearly(ev: Evidence, node: Expr, off: np.ndarray) -> float:
    """The size below which a formula is right that is off by little where it seems right; 0 where it is off by none.

    Args:
        ev: The arm.
        node: The formula.
        off: How far it is off, in units of the tolerance, where that is below one.
    """
    rounded = digits_wanted(ev.model, node.substitute(ev.definitions)) < IDENTICAL
    size = NEARLY_ROUNDED if rounded else NEARLY
    return size if len(off) and float(np.median(off)) > size else 0.0


@dataclass(frozen=True)
class _Right:
    """Where a formula's right values come from: an entry of a product, or, of an equation, its other side."""

    product: Product | None
    frame: Product | None
    source: Callable[[Evidence], np.ndarray] | None = None

    def wanted(self, ev: Evidence) -> np.ndarray | None:
        """The right values at every sample."""
        if self.source is not None:
            return self.source(ev)
        return None if self.product is None else value_of(self.product, ev.samples.frames)

    def off(self, ev: Evidence, node: Expr) -> np.ndarray:
        """How far the formula is off, in units of the tolerance."""
        return ev.goal(self.wanted(ev), frame=self.frame).residual(node)

    def judged(self, ev: Evidence, node: Expr) -> np.ndarray:
        """Where the formula is right."""
        return self.off(ev, node) < 1

    def gap(self, ev: Evidence, node: Expr, more: dict[str, np.ndarray]) -> np.ndarray:
        """The formula minus what is right; of an equation, the left side minus the right one."""
        wanted = self.wanted(ev)
        value = node.evaluate({**ev.environment(self.frame), **more})
        off = value if wanted is None else value - wanted
        return np.broadcast_to(np.asarray(off, dtype=float), (len(ev.samples.q),))


def _equal_holds(
    ev: Evidence, claim: Claim, node: Expr, good: np.ndarray, right: _Right, *, rounding: str = ""
) -> Verdict:
    digits = None if ev.held or rounding else _digits(ev, node, right.product, right.frame)
    where = f" where {claim['when']}" if "when" in claim else ""
    if digits is not None and 0 < digits < digits_wanted(ev.model, node.substitute(ev.definitions)):
        gap = ""
        if right.product is not None and right.product.entry and str(Product(right.product.terms)) == "T":
            gap = difference_from_matrix(node, ev.model, right.product.entry, ev.varied_zeros)
        details = [("difference", f"printed minus right = {gap}")] if gap else []
        sentence = f"Wrong, if only just: at 50-digit arithmetic it agrees to {digits} digits and no more."
        return claim.wrong(sentence, details, digits=digits, difference=gap)
    off = right.off(ev, node) if digits is None and not rounding else np.zeros(0)
    if _nearly(ev, node, off[ev.samples.nominal[: len(off)]]):
        example = _counter_example(
            ev, node, ev.goal(right.wanted(ev), frame=right.frame), np.zeros(len(off), dtype=bool), right.wanted(ev)
        )
        return claim.wrong(
            "Wrong, if only just: it misses by more than the rounding of numbers.", [("counter-example", example)]
        )
    if good.all():
        lengths = ", for any lengths" if _uses_lengths(ev, node) else ""
        more = f"; at 50-digit arithmetic it agrees to {digits} digits" if digits else ""
        empty = (
            " It says nothing of the arm: it is true of any values of its letters."
            if says_nothing(node.substitute(ev.definitions))
            else ""
        )
        sentence = f"Holds identically{where}: right at {len(good)} of {len(good)} joint vectors{lengths}{more}.{empty}"
        return claim.holds(sentence, digits=digits, right=len(good), tried=len(good))
    stand = standing(ev, node, right.judged)
    own = int(ev.samples.nominal.sum())
    more = f", to {digits} digits at 50-digit arithmetic" if digits else ""
    if stand.partly:
        goal = ev.goal(right.wanted(ev), frame=right.frame)
        found = _explanation(ev, node, goal, good, right.product, right.frame)
        example = ("counter-example", _counter_example(ev, node, goal, good, goal.wanted))
        sentence = f"Holds for this arm {stand.words}: right at {own} of {own} joint vectors with its lengths."
        return claim.partly(
            sentence,
            [example, *found.details],
            found.slip,
            found.reading,
            right=int(good.sum()),
            tried=len(good),
            digits=digits,
        )
    tied = f", {stand.words}" if stand.words else ""
    sentence = f"Holds for this arm's lengths{tied}{where}: right at {own} of {own} joint vectors{more}."
    return claim.holds(sentence, digits=digits, right=own, tried=own)


@dataclass(frozen=True)
class _Explained:
    """The one slip that explains a wrong formula, if there is one, and what to say of it."""

    details: list[tuple[str, str]]
    slip: str = ""
    reading: str = ""
    difference: str = ""


def _explanation(
    ev: Evidence, node: Expr, goal: Goal, good: np.ndarray, product: Product | None, frame: Product | None
) -> _Explained:
    """Look for the one slip that explains a wrong formula."""
    own, model = ev.samples.nominal, ev.model
    if good[own].all():
        goal, good, own = goal.restrict(~own), good[~own], own[~own]  # what is wrong shows with other lengths only

    def searched(aim: Goal, pairs: bool = False) -> Explanation:
        near = slips(node, ev.lengths, model.n, ev.own_names)
        return search(aim, node, near, lost=lost_from(ev, node, aim), seconds=ev.seconds, pairs=pairs)

    found = searched(goal)
    if not found.best and own.any() and not good[~own].any() and not _uses_lengths(ev, node):
        nominal = searched(goal.restrict(own))
        found = nominal if nominal.best else found
    short = node.size() <= MAX_SEARCHED
    elsewhere = _other_entry(ev, node, product) if short and product is not None and not found.best else ""
    arms_tried: dict[str, int] = {}
    other = None
    if short and not found.best and not elsewhere:
        other = _other_arm(ev, node, goal.wanted, product, frame, arms_tried)
    if short and not found.best and not elsewhere and not other:
        # two slips at once are the last thing to think of
        found = searched(goal, pairs=True)
    tried = ("tried", tried_text(found, arms_tried))
    if elsewhere:
        says = f"the formula is right for another entry, {elsewhere}"
        return _Explained([("the slip", says), tried], "index", elsewhere)
    if found.best:
        best, rest = found.best, [s.says for s in found.found[1:4]]
        as_good = "; as good: " + "; ".join(rest) if rest else ""
        details = [("nearest right reading", str(best.tree)), ("the slip", best.says + as_good)]
        gap = simplified_difference(node, best.tree)
        if gap:
            what = "the sides differ by" if isinstance(node, Equation) else "printed minus right"
            details.append(("difference", f"{what} = {gap}"))
        return _Explained([*details, tried], best.kind, str(best.tree), gap)
    if other:
        return _Explained([("the slip", f"{other[1]}: the formula is right for that arm"), tried], other[0])
    details, gap = [], ""
    if product is not None and product.entry and str(Product(product.terms)) in ("T", f"T0{model.n}"):
        gap = difference_from_matrix(node, model, product.entry, ev.varied_zeros)
        if gap:
            details.append(("difference", f"printed minus right = {gap}"))
    details.append(("the slip", "no single slip explains it" + found.closest("joint vectors")))
    return _Explained([*details, tried], difference=gap)


def _uses_lengths(ev: Evidence, node: Expr) -> bool:
    return bool(node.symbols() & set(ev.model.values))


def _digits(ev: Evidence, node: Expr, product: Product | None, frame: Product | None) -> int | None:
    if frame is not None or node.size() > 3000 or ev.picks(node):
        return None
    if isinstance(node, Equation):
        return agreeing_digits(ev.model, ev.samples, ev.definitions, node.args[0], node.args[1])
    if product is not None and product.entry and str(Product(product.terms)) == "T" and product.entry[0] <= 3:
        return agreeing_digits(ev.model, ev.samples, ev.definitions, node, (product.entry[0] - 1, product.entry[1] - 1))
    return None


def _counter_example(ev: Evidence, node: Expr, goal: Goal, good: np.ndarray, wanted: np.ndarray | None) -> str:
    bad = np.flatnonzero(~good & ev.samples.nominal)
    bad = bad if len(bad) else np.flatnonzero(~good)
    with np.errstate(all="ignore"):
        if wanted is None:
            left, right = (np.broadcast_to(a.evaluate(goal.env), good.shape) for a in node.args)
        else:
            left, right = np.broadcast_to(node.evaluate(goal.env), good.shape), wanted
    order = np.argsort(-np.nan_to_num(np.abs(left - right)[bad], nan=-1.0, posinf=-1.0))
    k = int(bad[order[len(order) // 4]])
    words = "left side {}, right side {}" if wanted is None else "the formula gives {}, right is {}"
    shown = [number(float(side[k])) for side in (left, right)]
    if shown[0] == shown[1]:
        shown = [f"{side[k]:.15g}" for side in (left, right)]
    return f"at {ev.at(k)}{ev.extra_lengths(k, node)}: {words.format(*shown)}"


def _other_arm(
    ev: Evidence,
    node: Expr,
    wanted: np.ndarray | None,
    product: Product | None,
    frame: Product | None,
    tried: dict[str, int],
) -> tuple[str, str] | None:
    """Return (kind, words) of an arm one slip away for which the formula is right, None when there is none."""
    for kind, words, samples in ev.other_arms:
        tried[kind] = tried.get(kind, 0) + 1
        if frame is not None or (wanted is not None and product is None):
            return None
        try:
            right = None if wanted is None or product is None else value_of(product, samples.frames)
        except (InputError, np.linalg.LinAlgError):
            continue
        if Goal(samples.env, right).fits(node).all():
            return kind, words
    return None


def _other_entry(ev: Evidence, node: Expr, product: Product) -> str:
    """Return the entry of the same matrix for which the formula is right, "" when there is none."""
    whole = value_of(Product(product.terms), ev.samples.frames)
    if whole.ndim != 3:
        return ""
    for i in range(3):
        for j in range(whole.shape[2]):
            if (i + 1, j + 1) != product.entry and ev.goal(whole[:, i, j]).fits(node).all():
                return str(Product(product.terms, (i + 1, j + 1)))
    return ""


def _entry_product(ev: Evidence, claim: Claim) -> Product:
    name = str(claim["of"]).replace("_", "")
    if name in _ENTRY_OF:
        i, j = _ENTRY_OF[name]
        return Product(parse_product("T", ev.model.n).terms, (i + 1, j + 1))
    return ev.product(claim, "of")
