"""Judges of formulas that must be equal: an entry of a matrix, an equation."""

from __future__ import annotations

import numpy as np

from pieper.algebra.tree import Node, evaluate, substitute
from pieper.errors import InputError
from pieper.judge.difference import agreeing_digits, difference_from_matrix, simplified_difference
from pieper.judge.evidence import Evidence, number, plain, tried_text
from pieper.judge.matrices import Product, parse_product, value_of
from pieper.judge.model import POSE_NAMES
from pieper.judge.regions import find_region, region_features, zero_denominators
from pieper.judge.search.search import MAX_SEARCHED, Target, search
from pieper.judge.slips.formula_slips import slips
from pieper.judge.verdict import HOLDS, PARTLY, WRONG, Verdict

_ENTRY_OF = {name: (i, j) for name, i, j in POSE_NAMES}


def judge_entry(ev: Evidence, claim: dict) -> Verdict:
    """Judge one entry of a matrix given as a formula (keys of, is, where)."""
    product = _entry_product(ev, str(claim["of"]))
    node = ev.parse(str(claim["is"]), claim.get("where"))
    wanted = value_of(product, ev.samples.frames)
    if wanted.ndim != 1:
        raise InputError(
            f"claim {claim['id']}: {claim['of']!r} is a whole matrix; say which entry, as in {claim['of']}[1,4]"
        )
    return judge_equal(
        ev, claim["id"], f"{claim['of']} = {claim['is']}", claim.get("says", ""), node, wanted, product=product
    )


def judge_equation(ev: Evidence, claim: dict) -> Verdict:
    """Judge an equation between two formulas, with the pose letters of the frame it names (keys is, where, frame)."""
    ev = ev.holding(claim)
    from pieper.algebra.parser import parse_equation

    text = str(claim["is"])
    model = ev.model
    where = {plain(k): v for k, v in (claim.get("where") or {}).items()}
    names = model.names() | set(model.aliases) | set(ev.definitions) | set(where)
    left, right = parse_equation(text, names, model.n)
    local = {
        name: ev.parse(
            str(body), {k: v for k, v in where.items() if k != name and k in list(where)[: list(where).index(name)]}
        )
        for name, body in where.items()
    }
    root = substitute(Node("eq", (left, right)), local)
    frame = parse_product(claim["frame"], model.n) if claim.get("frame") else None
    return judge_equal(ev, claim["id"], text, claim.get("says", ""), root, None, frame=frame)


def judge_equal(
    ev: Evidence, claim_id: str, text: str, says: str, node: Node, wanted, *, product: Product | None = None, frame=None
) -> Verdict:
    """Judge a formula against right values (or an ``eq`` tree against itself) at every sample.

    Args:
        ev: the arm and its samples.
        claim_id, text, says: what the verdict calls the claim.
        node: the formula, or an equation.
        wanted: (K,) right values; None for an equation.
        product: where the right values come from, to name it and to find it for other arms.
        frame: the frame whose letters the formula uses.

    Returns:
        The verdict.
    """
    samples = ev.samples
    target = ev.target(wanted, frame=frame)
    residual = target.residual(node)
    good, own = residual < 1, samples.nominal
    if good.all():
        digits = _digits(ev, node, product, frame)
        more = f"; at 50-digit arithmetic it agrees to {digits} digits" if digits else ""
        return Verdict(
            claim_id,
            text,
            HOLDS,
            f"Holds identically: right at {len(good)} of {len(good)} joint vectors{_lengths_word(ev, node)}{more}.",
            says,
            digits=digits,
            right=len(good),
            tried=len(good),
        )
    if good[own].all():
        digits = _digits(ev, node, product, frame)
        return Verdict(
            claim_id,
            text,
            HOLDS,
            f"Holds for this arm's lengths: right at {own.sum()} of {own.sum()} joint vectors"
            + (f", to {digits} digits at 50-digit arithmetic" if digits else "")
            + ".",
            says,
            digits=digits,
            right=int(own.sum()),
            tried=int(own.sum()),
        )
    rows = own if good[own].any() else np.ones_like(own)
    vanish = zero_denominators(node, target.env, evaluate)
    details: list[tuple[str, str]] = []
    if vanish:
        details.append(("undefined", f"the denominator {vanish[0]} is zero for all joints"))
    else:
        details.append(("counter-example", _counter_example(ev, node, target, good, wanted)))
    region = find_region(
        good[rows], [(n, v[rows]) for n, v in region_features(ev.model.n, target.env, list(ev.definitions))]
    )
    lengths = {m: v for m, v in ev.model.values.items()}
    found = search(target, node, slips(node, lengths, ev.model.n, tuple(ev.definitions)), seconds=ev.seconds)
    if not found.best and not good[~own].any() and not _uses_lengths(ev, node):
        nominal = search(
            target.restrict(own), node, slips(node, lengths, ev.model.n, tuple(ev.definitions)), seconds=ev.seconds
        )
        found = nominal if nominal.best else found
    short = node.size() <= MAX_SEARCHED
    elsewhere = _other_entry(ev, node, product) if short and product is not None and not found.best else ""
    arm_tried: dict[str, int] = {}
    arm_words = "" if found.best or elsewhere or not short else _other_arm(ev, node, wanted, product, frame, arm_tried)
    slip, reading, gap = "", "", ""
    if elsewhere:
        slip, reading = "index", elsewhere
        details.append(("the slip", f"the formula is right for another entry, {elsewhere}"))
    elif found.best:
        best = found.best
        slip, reading = best.kind, str(best.tree)
        details.append(("nearest right reading", reading))
        details.append(("the slip", best.says + _alternatives(found)))
        gap = simplified_difference(node, best.tree)
        if gap:
            details.append(
                ("difference", ("printed minus right" if node.op != "eq" else "the sides differ by") + f" = {gap}")
            )
    elif arm_words:
        slip = arm_words[0]
        details.append(("the slip", arm_words[1]))
    elif product is not None and product.entry and str(Product(product.terms)) in ("T", f"T0{ev.model.n}"):
        gap = difference_from_matrix(node, ev.model, product.entry[0] - 1, product.entry[1] - 1)
        if gap:
            details.append(("difference", f"printed minus right = {gap}"))
    if not slip:
        details.append(
            (
                "the slip",
                "no single slip explains it"
                + (
                    f"; closest: {found.nearest[0].says} (right at {100 * found.nearest[1]:.0f}% of the joint vectors)"
                    if found.nearest
                    else ""
                ),
            )
        )
    details.append(("tried", tried_text(found, arm_tried)))
    share = good.mean()
    numbers = {"right": int(good.sum()), "tried": len(good), "difference": gap}
    if region:
        return Verdict(
            claim_id, text, PARTLY, f"Holds only where {region}.", says, tuple(details), slip, reading, **numbers
        )
    if share > 0.1:
        return Verdict(
            claim_id,
            text,
            PARTLY,
            f"Holds at {100 * share:.0f}% of the joint vectors only; no simple region was found.",
            says,
            tuple(details),
            slip,
            reading,
            **numbers,
        )
    sentence = f"Wrong: right at {int(good.sum())} of {len(good)} joint vectors."
    if vanish:
        sentence = "Wrong: undefined, because it divides by zero for all joints."
    return Verdict(claim_id, text, WRONG, sentence, says, tuple(details), slip, reading, **numbers)


def _uses_lengths(ev: Evidence, node: Node) -> bool:
    return bool(node.symbols() & set(ev.model.values))


def _lengths_word(ev: Evidence, node: Node) -> str:
    return ", for any lengths" if _uses_lengths(ev, node) else ""


def _digits(ev: Evidence, node: Node, product: Product | None, frame) -> int | None:
    if frame is not None or node.size() > 3000:
        return None
    if node.op == "eq":
        return agreeing_digits(ev.model, ev.samples, ev.definitions, node.args[0], node.args[1])
    if product is not None and product.entry and str(Product(product.terms)) == "T" and product.entry[0] <= 3:
        return agreeing_digits(ev.model, ev.samples, ev.definitions, node, (product.entry[0] - 1, product.entry[1] - 1))
    return None


def _alternatives(found) -> str:
    others = [s for s in found.found[1:4]]
    return "" if not others else "; as good: " + "; ".join(s.says for s in others)


def _counter_example(ev: Evidence, node: Node, target: Target, good, wanted) -> str:
    bad = np.flatnonzero(~good & ev.samples.nominal)
    bad = bad if len(bad) else np.flatnonzero(~good)
    with np.errstate(all="ignore"):
        if node.op == "eq":
            left, right = (np.broadcast_to(evaluate(a, target.env), good.shape) for a in node.args)
        else:
            left, right = np.broadcast_to(evaluate(node, target.env), good.shape), wanted
    order = np.argsort(-np.nan_to_num(np.abs(left - right)[bad], nan=-1.0, posinf=-1.0))
    k = int(bad[order[len(order) // 4]])
    words = ("left side {}, right side {}" if node.op == "eq" else "the formula gives {}, right is {}").format(
        number(left[k]), number(right[k])
    )
    return f"at {ev.at(k)}{ev.extra_lengths(k, node)}: {words}"


def _other_arm(ev: Evidence, node: Node, wanted, product, frame, tried: dict[str, int]):
    """Look for an arm one slip away for which the formula is right; return (kind, words) or None."""
    rows = np.ones(len(ev.samples.q), dtype=bool)
    for kind, words, samples in ev.other_arms:
        tried[kind] = tried.get(kind, 0) + 1
        try:
            right = None if wanted is None else value_of(product, samples.frames) if product is not None else None
        except (InputError, np.linalg.LinAlgError):
            continue
        if wanted is not None and right is None:
            return None
        if frame is not None:
            return None
        if Target(samples.env, right).fits(node)[rows].all():
            return kind, f"{words}: the formula is right for that arm"
    return None


def _other_entry(ev: Evidence, node: Node, product: Product) -> str:
    """Return the entry of the same matrix for which the formula is right, "" when there is none."""
    whole = value_of(Product(product.terms), ev.samples.frames)
    if whole.ndim != 3:
        return ""
    for i in range(3):
        for j in range(whole.shape[2]):
            target = ev.target(whole[:, i, j])
            if (i + 1, j + 1) != product.entry and target.fits(node).all():
                return str(Product(product.terms, (i + 1, j + 1)))
    return ""


def _entry_product(ev: Evidence, text: str) -> Product:
    name = text.replace("_", "")
    if name in _ENTRY_OF:
        i, j = _ENTRY_OF[name]
        return Product(parse_product("T", ev.model.n).terms, (i + 1, j + 1))
    return parse_product(text, ev.model.n)
