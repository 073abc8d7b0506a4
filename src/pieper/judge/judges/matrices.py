"""Judges of matrices: a whole matrix of formulas, an equation between products of matrices."""

from __future__ import annotations

import numpy as np

from pieper.algebra.expression import Expr
from pieper.errors import InputError
from pieper.judge.claim import Claim
from pieper.judge.evidence import Evidence, number, under
from pieper.judge.judges.formulas import judge_equal
from pieper.judge.matrices import product_slips, value_of
from pieper.judge.products import Product, parse_product
from pieper.judge.search.search import Goal
from pieper.judge.slips.arm_slips import two_twists
from pieper.judge.verdict import Verdict
from pieper.tolerances import FLOOR_OF_SEARCH, MATRIX_ENTRY
from pieper.words_by_number import plural


def judge_matrix(ev: Evidence, claim: Claim) -> Verdict:
    """Judge a whole matrix of formulas; empty strings claim nothing (keys of, is)."""
    product = ev.product(claim, "of")
    with under("of"):
        right = value_of(product, ev.samples.frames)
    if right.ndim == 1:
        raise claim.error(f'{claim["of"]!r} is one entry; judge it with kind = "entry"', "of")
    right = right if right.ndim == 3 else right[:, :, None]
    shape = right.shape[1:]
    given = [list(r) if isinstance(r, list) else [r] for r in claim["is"]]
    if len(given) != shape[0] or any(len(r) != shape[1] for r in given):
        sizes = " x ".join(str(len(r)) for r in given[:1]) if given else "0"
        raise claim.error(
            f"{claim['of']} has {shape[0]} rows of {shape[1]} entries, but {len(given)} rows "
            f"(the first of {sizes}) are given",
            "is",
        )
    wrong: list[tuple[int, int, Verdict]] = []
    ev = ev.on(ev.samples)
    ev.seconds = min(ev.seconds, max(0.3, 2 * ev.seconds / sum(map(len, given))))
    nodes: dict[tuple[int, int], Expr] = {}
    by_chance = 0  # entries that are right for this arm's own lengths only
    for i, row in enumerate(given):
        for j, text in enumerate(row):
            if str(text).strip() in ("", "*", '"'):
                continue
            node = nodes[i, j] = ev.parse(str(text), claim.where, f"is, entry ({i + 1},{j + 1})")
            entry = Product(product.terms, (i + 1, j + 1))
            part = claim.part(f"{claim.id}[{i + 1},{j + 1}]", {}).reads(f"{entry} = {text}")
            one = judge_equal(ev, part, node, right[:, i, j], product=entry)
            if not one.holds:
                wrong.append((i + 1, j + 1, one))
                by_chance += bool(ev.goal(right[:, i, j]).fits(node)[ev.samples.nominal].all())
    count = len(nodes)
    claim = claim.reads(f"{claim['of']} = [" + "; ".join(", ".join(map(str, r)) for r in given) + "]")
    if not wrong:
        return claim.holds(
            "Holds identically: "
            + (f"all {count} entries that are given." if count > 1 else "the one entry that is given.")
        )
    details = [
        (f"entry ({i},{j})", f"{v.claim}: {v.sentence}" + "".join(f"\n{h}: {b}" for h, b in v.details if h != "tried"))
        for i, j, v in wrong
    ]
    first = wrong[0][2]
    slip, reading = (first.slip, first.reading) if 2 * len(wrong) <= count else ("", "")
    other = _arm_of(ev, product, nodes) if len(wrong) > 1 else None
    if other:
        # one cause of all: what would put each entry right by itself is beside the point
        slip, reading = other
        details = [
            (f"entry ({i},{j})", f"{v.claim}: {v.sentence}" + "".join(f"\n{h}: {b}" for h, b in v.details[:1]))
            for i, j, v in wrong
        ]
        details.insert(0, ("the slip", f"{reading}: every entry is right for that arm"))
    places = ", ".join(f"({i},{j})" for i, j, _ in wrong)
    if by_chance == len(wrong):
        entries = plural(by_chance, "entry", "entries")
        return claim.partly(
            f"Holds for this arm's lengths; for others of its build {entries} of {count} would be wrong: {places}.",
            details,
            slip,
            reading,
        )
    return claim.wrong(f"Wrong in {len(wrong)} of {count} entries: {places}.", details, slip, reading)


def _arm_of(ev: Evidence, product: Product, nodes: dict[tuple[int, int], Expr]) -> tuple[str, str] | None:
    """Return (kind, words) of the arm one slip away for which every given entry is right, None when there is none."""
    floor = FLOOR_OF_SEARCH * max(1.0, ev.model.length())
    for kind, words, samples in (*ev.other_arms, *ev.arms(two_twists(ev.model))):
        right = value_of(product, samples.frames)
        right = right if right.ndim == 3 else right[:, :, None]
        if all(Goal(samples.env, right[:, i, j], floor=floor).fits(node).all() for (i, j), node in nodes.items()):
            return kind, words
    return None


def judge_product(ev: Evidence, claim: Claim) -> Verdict:
    """Judge an equation between products of matrices (key is)."""
    claim = claim.reads(str(claim["is"]))
    if claim.text.count("=") != 1:
        raise claim.error("an equation of matrices needs exactly one '=', as in \"A1 A2 = T A3^-1\"", "is")
    with under("is"):
        sides = [parse_product(side, ev.model.n, frozenset(ev.matrices)) for side in claim.text.split("=")]
        values = [value_of(side, ev.samples.frames) for side in sides]
    if values[0].shape != values[1].shape:
        raise claim.error(f"the left side is {values[0].shape[1:]}, the right side {values[1].shape[1:]}", "is")
    slack = MATRIX_ENTRY * max(1.0, float(np.abs(values[1]).max()))

    def same(x: np.ndarray, y: np.ndarray) -> bool:
        return x.shape == y.shape and np.allclose(x, y, rtol=0, atol=slack)

    if same(*values):
        return claim.holds(f"Holds identically: equal at {len(values[0])} joint vectors.")
    tried, best, words, kind = 0, "", "", ""
    for which in (0, 1):
        for kind_tried, says, variant in product_slips(sides[which], ev.model.n):
            tried += 1
            try:
                value = value_of(variant, ev.samples.frames)
            except (InputError, np.linalg.LinAlgError):
                continue
            if same(value, values[1 - which]):
                pair = [str(s) for s in sides]
                pair[which] = str(variant)
                best, words, kind = " = ".join(pair), says, kind_tried
                break
        if best:
            break
    gap = np.abs(values[0] - values[1])
    k = int(np.argmax(gap.reshape(len(gap), -1).max(1) * ev.samples.nominal))
    index = tuple(int(p) for p in np.unravel_index(int(np.argmax(gap[k])), gap.shape[1:]))
    left, right = (number(v[(k, *index)]) for v in values)
    place = ", ".join(str(p + 1) for p in index)
    details = [("counter-example", f"at {ev.at(k)}: entry ({place}) is {left} on the left, {right} on the right")]
    if best:
        details += [("nearest right reading", best), ("the slip", words)]
    details.append(("tried", f"other orders, inverses, a matrix lost or too many ({tried} variants)"))
    return claim.wrong("Wrong: the two sides are different matrices.", details, kind, best)
