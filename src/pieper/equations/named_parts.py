"""Long formulas broken by named parts, so that no line of a page is wider than the page."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from pieper.algebra.expression import Add, Expr, Mul, Sym
from pieper.algebra.formula import with_args
from pieper.algebra.notation import Writer
from pieper.document.blocks import Block, Document, Equation, Equations, Paragraph

WIDE = 112  # characters of a formula in plain text that a page is wide
INNER = WIDE - 6  # of a part, its name and the equals sign before it
SMALL = 24  # characters of the smallest part that is worth a name
LETTER = "h"


class _Remembering(Writer):
    """Plain text of nodes that share their parts: each node is written once."""

    def __init__(self) -> None:
        self._written: dict[Any, str] = {}

    def __call__(self, expr: Any) -> str:
        found = self._written.get(expr)
        if found is None:
            found = self._written[expr] = super().__call__(expr)
        return found


class Parts:
    """Names of parts that a page has used so far; what occurs again keeps its name."""

    def __init__(self, letter: str = LETTER) -> None:
        self.letter = letter
        self.text = _Remembering()
        self.names: dict[Expr, Sym] = {}
        self.texts: dict[str, Sym] = {}

    def named(self, part: Expr) -> tuple[Sym, bool]:
        """The name of a part, and whether it is new."""
        text = self.text(part)
        if text in self.texts:
            return self.texts[text], False
        self.texts[text] = Sym(self.letter, str(len(self.texts) + 1), 4)
        return self.texts[text], True

    def broken(self, formula: Expr, room: int) -> tuple[list[tuple[Sym, Expr]], Expr]:
        """Names and their parts, each defined before it is used, and the formula with them.

        The parts are found from the inside out, so that what is looked at is never longer than a few lines.

        Args:
            formula: What is too long.
            room: How many characters it may have.
        """
        defined: list[tuple[Sym, Expr]] = []
        return defined, self._shrunk(formula, room, defined, {})

    def _shrunk(self, node: Expr, room: int, defined: list[tuple[Sym, Expr]], seen: dict[Expr, Expr]) -> Expr:
        if not node.args:
            return node
        args = [seen[a] if a in seen else seen.setdefault(a, self._shrunk(a, INNER, defined, seen)) for a in node.args]
        if not all(x is y for x, y in zip(args, node.args, strict=True)):
            node = with_args(node, args)
        while len(self.text(node)) > room:
            part = self._part_of(node)
            if part is None:
                break
            name, new = self.named(part)
            if new:
                defined.append((name, part))
            node = self._put(node, part, name)
        return node

    def _part_of(self, formula: Expr) -> Expr | None:
        """The part to be named next: the longest sum inside that fits a line, else as many members as fit one."""
        sums = {self.text(n): n for n in formula.walk() if isinstance(n, Add) and n is not formula}
        fits = {text: n for text, n in sums.items() if SMALL <= len(text) <= INNER}
        if fits:
            return fits[max(fits, key=len)]
        if isinstance(formula, (Add, Mul)):
            for count in range(len(formula.args) - 1, 1, -1):
                part = with_args(formula, formula.args[:count])
                if len(self.text(part)) <= INNER:
                    return part
        return None

    def _put(self, formula: Expr, part: Expr, name: Sym) -> Expr:
        """The formula with a part replaced by its name at every place."""
        text = self.text(part)
        if isinstance(formula, type(part)) and isinstance(formula, (Add, Mul)):
            count = len(part.args)
            if len(formula.args) > count and self.text(with_args(formula, formula.args[:count])) == text:
                return with_args(formula, [name, *formula.args[count:]])
        if not formula.args:
            return formula
        if self.text(formula) == text:
            return name
        inside = [self._put(a, part, name) for a in formula.args]
        return formula if all(x is y for x, y in zip(inside, formula.args, strict=True)) else with_args(formula, inside)


def broken_lines(page: Document) -> Document:
    """The page with every formula that is wider than it broken by named parts, which stand above it."""
    parts = Parts()
    blocks: list[Block] = []
    for block in page.blocks:
        rows = [block] if isinstance(block, Equation) else list(block.rows) if isinstance(block, Equations) else []
        made: list[Equation] = []
        defined: list[tuple[Sym, Expr]] = []
        for row in rows:
            new, short = _row(row, parts)
            defined += new
            made.append(short)
        if not defined:
            blocks.append(block if all(a is b for a, b in zip(rows, made, strict=True)) else _same(block, made))
            continue
        blocks.append(Paragraph(("With the parts" if len(defined) > 1 else "With the part",)))
        blocks += [Equation((name, part)) for name, part in defined]
        blocks.append(_same(block, made))
    return replace(page, blocks=blocks)


def _same(block: Block, rows: list[Equation]) -> Block:
    return replace(block, rows=tuple(rows)) if isinstance(block, Equations) else rows[0]


def _row(row: Equation, parts: Parts) -> tuple[list[tuple[Sym, Expr]], Equation]:
    """A line and the parts that it is broken into; lines of other things than expressions stay as they are."""
    texts = [side.text() for side in row.sides]
    if sum(map(len, texts)) + 3 * (len(texts) - 1) <= WIDE or not isinstance(row.sides[-1], Expr):
        return [], row
    room = max(WIDE - sum(len(t) + 3 for t in texts[:-1]), SMALL)
    defined, short = parts.broken(row.sides[-1], room)
    return defined, replace(row, sides=(*row.sides[:-1], short))
