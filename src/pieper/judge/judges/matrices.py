"""Judges of matrices: a whole matrix of formulas, an equation between products of matrices."""

from __future__ import annotations

import numpy as np

from pieper.errors import InputError
from pieper.judge.evidence import Evidence, number
from pieper.judge.judges.formulas import judge_equal
from pieper.judge.matrices import Product, parse_product, product_slips, value_of
from pieper.judge.search.search import Target
from pieper.judge.verdict import HOLDS, WRONG, Verdict


def judge_matrix(ev: Evidence, claim: dict) -> Verdict:
    """Judge a whole matrix of formulas; empty strings claim nothing (keys of, is)."""
    product = parse_product(str(claim["of"]), ev.model.n)
    right = value_of(product, ev.samples.frames)
    rows = claim["is"]
    shape = right.shape[1:] if right.ndim == 3 else (right.shape[1], 1)
    given = [list(r) if isinstance(r, list) else [r] for r in rows]
    if len(given) != shape[0] or any(len(r) != shape[1] for r in given):
        sizes = " x ".join(str(len(r)) for r in given[:1]) if given else "0"
        raise InputError(
            f"claim {claim['id']}: {claim['of']} has {shape[0]} rows of {shape[1]} entries, but {len(given)} rows "
            f"(the first of {sizes}) are given",
            claim=claim["id"],
        )
    wrong, nodes = [], {}
    for i, row in enumerate(given):
        for j, text in enumerate(row):
            if str(text).strip() in ("", "*", '"'):
                continue
            node = ev.parse(str(text), claim.get("where"))
            nodes[i, j] = node
            wanted = right[:, i, j] if right.ndim == 3 else right[:, i]
            entry = Product(product.terms, (i + 1, j + 1))
            one = judge_equal(
                ev, f"{claim['id']}[{i + 1},{j + 1}]", f"{entry} = {text}", "", node, wanted, product=entry
            )
            if not one.holds:
                wrong.append((i + 1, j + 1, one))
    count = len(nodes)
    text = f"{claim['of']} = [" + "; ".join(", ".join(map(str, r)) for r in given) + "]"
    if not wrong:
        return Verdict(
            claim["id"], text, HOLDS, f"Holds identically: all {count} entries that are given.", claim.get("says", "")
        )
    details = tuple(
        (f"entry ({i},{j})", f"{v.claim}: {v.sentence}" + "".join(f"\n{h}: {b}" for h, b in v.details if h != "tried"))
        for i, j, v in wrong
    )
    first = wrong[0][2]
    slip, reading = (first.slip, first.reading) if 2 * len(wrong) <= count else ("", "")
    other = _arm_of(ev, product, nodes) if len(wrong) > 1 else None
    if other:
        slip, reading = other
        details = (("the slip", f"{reading}: every entry is right for that arm"), *details)
    return Verdict(
        claim["id"],
        text,
        WRONG,
        f"Wrong in {len(wrong)} of {count} entries: " + ", ".join(f"({i},{j})" for i, j, _ in wrong) + ".",
        claim.get("says", ""),
        details,
        slip,
        reading,
    )


def _arm_of(ev: Evidence, product: Product, nodes: dict) -> tuple[str, str] | None:
    """Return (kind, words) of the arm one slip away for which every given entry is right, None when there is none."""
    for kind, words, samples in ev.other_arms:
        right = value_of(product, samples.frames)
        floor = 1e-3 * max(1.0, ev.model.length())
        entries = ((node, right[:, i, j] if right.ndim == 3 else right[:, i]) for (i, j), node in nodes.items())
        if all(Target(samples.env, wanted, floor=floor).fits(node).all() for node, wanted in entries):
            return kind, words
    return None


def judge_product(ev: Evidence, claim: dict) -> Verdict:
    """Judge an equation between products of matrices (key is)."""
    text = str(claim["is"])
    if text.count("=") != 1:
        raise InputError(
            f"claim {claim['id']}: an equation of matrices needs exactly one '=', as in \"A1 A2 = T A3^-1\"",
            claim=claim["id"],
        )
    sides = [parse_product(side, ev.model.n) for side in text.split("=")]
    values = [value_of(side, ev.samples.frames) for side in sides]
    if values[0].shape != values[1].shape:
        raise InputError(
            f"claim {claim['id']}: the left side is {values[0].shape[1:]}, the right side {values[1].shape[1:]}",
            claim=claim["id"],
        )

    def same(x, y) -> bool:
        return x.shape == y.shape and np.allclose(x, y, rtol=0, atol=1e-9 * max(1.0, float(np.abs(values[1]).max())))

    if same(*values):
        return Verdict(
            claim["id"],
            text,
            HOLDS,
            f"Holds identically: equal at {len(values[0])} joint vectors.",
            claim.get("says", ""),
        )
    tried, best, words, kind = 0, "", "", ""
    for which in (0, 1):
        for slip_kind, says, variant in product_slips(sides[which], ev.model.n):
            tried += 1
            try:
                value = value_of(variant, ev.samples.frames)
            except (InputError, np.linalg.LinAlgError):
                continue
            if same(value, values[1 - which]):
                kind, words = slip_kind, says
                pair = [str(s) for s in sides]
                pair[which] = str(variant)
                best = " = ".join(pair)
                break
        if best:
            break
    gap = np.abs(values[0] - values[1])
    k = int(np.argmax(gap.reshape(len(gap), -1).max(1) * ev.samples.nominal))
    place = np.unravel_index(int(np.argmax(gap[k])), gap.shape[1:])
    index = tuple(int(p) for p in place)
    details = [
        (
            "counter-example",
            f"at {ev.at(k)}: entry ({', '.join(str(p + 1) for p in index)}) is "
            f"{number(values[0][(k, *index)])} on the left, "
            f"{number(values[1][(k, *index)])} on the right",
        )
    ]
    if best:
        details += [("nearest right reading", best), ("the slip", words)]
    details.append(("tried", f"other orders, inverses, a matrix lost or too many ({tried} variants)"))
    return Verdict(
        claim["id"],
        text,
        WRONG,
        "Wrong: the two sides are different matrices.",
        claim.get("says", ""),
        tuple(details),
        kind,
        best,
    )
