"""Letters of a formula that are computed from matrices: an entry of a product, a length of one, roll, pitch and yaw.

`R36[3,3]`, `(T A6^-1)[1,4]`, `R36(3,3)` and `norm(P05 - P01)` become letters of their own, whose values are worked
out at every sample; what a page calls r33 of R36 is known once the joints outside 3..6 are.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from pieper.errors import InputError
from pieper.judge.matrices import value_of
from pieper.judge.products import Product, parse_product

_PICKED = re.compile(r"[\[(]\s*(\d)\s*,\s*(\d)\s*[\])]|_?\{\s*(\d)\s*,?\s*(\d)\s*\}|\[\s*(\d)\s*\](?!\s*\[)")
_NORM = re.compile(r"(?:\b(?:norm|dot)\s*\(|\\?\|\\?\|)")


@dataclass(frozen=True)
class MatrixLetter:
    """A letter of a formula that is an entry, or the length, of a product of matrices.

    Attributes:
        product: The product; with an entry, or a whole vector whose length is meant.
        length: Whether its length is meant.
    """

    product: Product
    length: bool = False

    def value(self, frames: Mapping[str, np.ndarray]) -> np.ndarray:
        """Its value at every sample, (K,)."""
        found = value_of(self.product, dict(frames))
        return np.linalg.norm(found, axis=-1) if self.length else found


def pick_letters(text: str, joints: int, own: frozenset[str]) -> tuple[str, dict[str, MatrixLetter]]:
    """Replace entries of matrices in a formula by letters of their own.

    Args:
        text: The formula.
        joints: How many joints the arm has.
        own: Names of matrices that the file defines.

    Returns:
        The formula with the entries spelled in one way, and what those spellings stand for.
    """
    found: dict[str, MatrixLetter] = {}
    at = 0
    while hit := _NORM.search(text, at):
        start, inner = hit.start(), hit.end()
        end = _closing(text, inner - 1) if text[inner - 1] == "(" else text.find("||", inner)
        if end < 0:
            break
        dotted = hit.group().startswith("dot")
        body = text[start : end + 1] if dotted else text[inner:end]
        name = _named(found, MatrixLetter(parse_product(body, joints, own), not dotted))
        after = end + (1 if text[end] == ")" else 2)
        text = f"{text[:start]} {name} {text[after:]}"
        at = start + len(name)
    at = 0
    while hit := _PICKED.search(text, at):
        start = _matrix_before(text, hit.start(), own)
        if start is None:
            at = hit.end()
            continue
        body = text[start : hit.start()]
        row, column = (hit.group(1) or hit.group(3) or hit.group(5)), (hit.group(2) or hit.group(4) or "1")
        try:
            made = parse_product(f"{body}[{row},{column}]", joints, own)
        except InputError:
            if hit.group(1) and text[hit.start()] == "[":
                raise
            at = hit.end()
            continue
        name = _named(found, MatrixLetter(made))
        text = f"{text[:start]} {name} {text[hit.end() :]}"
        at = start + len(name) + 1
    return text, found


def _named(found: dict[str, MatrixLetter], letter: MatrixLetter) -> str:
    name = f"norm({letter.product})" if letter.length else str(letter.product)
    found[name] = letter
    return name


def neighbours(letter: MatrixLetter) -> dict[str, MatrixLetter]:
    """The other entries of the same product, of which one may have been meant."""
    out: dict[str, MatrixLetter] = {}
    if letter.product.entry is not None and not letter.length:
        for i, j in product(range(1, 4), range(1, 5)):
            _named(out, MatrixLetter(replace(letter.product, entry=(i, j))))
    return out


def _matrix_before(text: str, at: int, own: frozenset[str]) -> int | None:
    """Where the matrix begins whose entry is picked at a place; None where no matrix stands before it."""
    before = text[:at].rstrip()
    bare = re.sub(r"(?:\s*\^\s*(?:-1|\(-1\)|\{-1\}|T)|')+$", "", before)
    if bare.endswith(")"):
        depth = 0
        for k in range(len(bare) - 1, -1, -1):
            depth += (bare[k] == ")") - (bare[k] == "(")
            if not depth:
                inside = bare[k + 1 : -1]
                called = re.search(r"cross\s*$", bare[:k])
                return (
                    (called.start() if called else k)
                    if re.search(r"\b(?:[AQTRP]\d{0,2}|R[xyz]|J)\b", inside) or own & set(re.findall(r"\w+", inside))
                    else None
                )
        return None
    last = re.search(r"[A-Za-z]\w*$", bare)
    if last is None:
        return None
    word = last.group()
    return last.start() if re.fullmatch(r"[AQTRP]\d{0,2}|J", word) or word in own else None


def _closing(text: str, opened: int) -> int:
    depth = 0
    for k in range(opened, len(text)):
        depth += (text[k] == "(") - (text[k] == ")")
        if not depth:
            return k
    return -1
