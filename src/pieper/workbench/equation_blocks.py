"""The arm's equations as blocks for the page: headings, sentences, formulas, entries of the pose."""

from __future__ import annotations

import itertools
from typing import Any

import pieper
from pieper import sections

#: Formulas longer than this are not typeset: the browser would stand still for seconds.
LONGEST_FORMULA = 30_000


def forward_blocks(arm: pieper.Arm, lengths: str) -> list[dict[str, Any]]:
    """Return the twelve entries of the pose, each with what of it moves, then A_i and the partial products."""
    fk = arm.symbolic.fk(lengths=lengths)
    page = sections.Document("")
    if fk.relation_equations:
        page.heading("Joint angles of the table")
        page.add(*fk.relation_equations)
    if fk.meaning_equations:
        page.heading("Constants, in metres")
        page.say(*sections.in_line(fk.meaning_equations))
    page.heading("The pose, entry by entry")
    first = len(page.blocks)
    page.add(*fk.pose.entry_equations.rows)
    page.heading("Link matrices and products")
    page.add(*(matrix.shown for matrix in (*fk.A, *fk.halves)))
    blocks = sections.as_data(page.blocks)
    for block, (column, row) in zip(blocks[first:], itertools.product(range(4), range(3)), strict=False):
        moving = fk.motions(fk.pose[row, column])
        block["entry"] = 4 * row + column
        block["symbols"] = [{"latex": s.latex(), "is": kind, "joints": joints} for s, kind, joints in moving]
    return _readable(blocks)


def inverse_blocks(arm: pieper.Arm) -> list[dict[str, Any]]:
    """Return the derivation of the inverse, step by step."""
    return _readable(arm.symbolic.ik().json()["blocks"])


def singular_blocks(arm: pieper.Arm) -> list[dict[str, Any]]:
    """Return the determinant's factors and what each means."""
    return _readable(arm.symbolic.singularities().json()["blocks"])


def _readable(blocks: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Return blocks with a note in the place of what is too long to be typeset."""
    for place, block in enumerate(blocks):
        if (long := len(block.get("latex", ""))) > LONGEST_FORMULA:
            words = f"(A formula of {long:,} characters is left out here; the library has it.)"
            blocks[place] = {"kind": "note", "pieces": [words]}
    return blocks
