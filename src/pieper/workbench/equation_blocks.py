"""The arm's equations as blocks for the page: headings, sentences, formulas, entries of the pose."""

from __future__ import annotations

import itertools
from collections.abc import Iterable
from typing import Any

import pieper
from pieper.document import json
from pieper.document.blocks import Block, Document, Equation, Equations, Note
from pieper.document.formulas import Written, equals, joined

#: Formulas longer than this are not typeset: the browser would stand still for seconds.
LONGEST_FORMULA = 30_000


def forward_blocks(arm: pieper.Arm, lengths: str) -> list[dict[str, Any]]:
    """Return A_i, the partial products and the twelve entries of the pose."""
    fk = arm.symbolic.fk(lengths=lengths)
    page = Document("")
    if fk.relation_equations:
        page.heading("Joint angles of the table")
        page.add(*fk.relation_equations)
    if fk.meaning_equations:
        page.heading("Constants, in metres")
        page.show(joined([equals(*row.sides) for row in fk.meaning_equations], Written(", ", r",\quad ", "<mo>,</mo>")))
    page.heading("The pose, entry by entry")
    first = len(page.blocks)
    page.add(*fk.pose.entry_equations.rows)
    page.heading("Link matrices and products")
    page.add(*(matrix.equation for matrix in (*fk.A, *fk.halves)))
    blocks = _data(page.blocks)
    for k, (column, row) in enumerate(itertools.product(range(4), range(3))):
        blocks[first + k] |= {
            "entry": 4 * row + column,
            "symbols": [
                {"latex": symbol.latex(), "is": kind, "joints": joints}
                for symbol, kind, joints in fk.motions(fk.pose[row, column])
            ],
        }
    return blocks


def inverse_blocks(arm: pieper.Arm) -> list[dict[str, Any]]:
    """Return the derivation of the inverse, step by step."""
    return _data(arm.symbolic.ik().page.blocks)


def singular_blocks(arm: pieper.Arm) -> list[dict[str, Any]]:
    """Return the determinant's factors and what each means."""
    return _data(arm.symbolic.singularities().page.blocks)


def _data(blocks: Iterable[Block]) -> list[dict[str, Any]]:
    out: list[dict[str, Any]] = []
    for item in blocks:
        for block in item.rows if isinstance(item, Equations) else (item,):
            found = json.block(block)
            if isinstance(block, Equation) and len(found["latex"]) > LONGEST_FORMULA:
                words = f"(A formula of {len(found['latex']):,} characters is left out here; the library has it.)"
                found = json.block(Note((words,)))
            out.append(found)
    return out
