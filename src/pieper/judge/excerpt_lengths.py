"""Which of an arm's lengths a page means by letters of its own: the reading with which most lines are right."""

from __future__ import annotations

import itertools
from collections.abc import Iterator

import numpy as np

from pieper.algebra.expression import Expr
from pieper.algebra.parser import parse_equation
from pieper.errors import InputError
from pieper.judge.judges.angle_formula import branch_values
from pieper.judge.matrices import value_of
from pieper.judge.model import ArmModel
from pieper.judge.products import parse_product
from pieper.judge.samples import Samples, sample
from pieper.tolerances import JUDGED_HOLDS

MOST = 2000  # readings that are tried
TRIED = 8  # joint vectors, half of them with other lengths

Line = tuple[frozenset[str], list[tuple[Expr, np.ndarray, bool]]]


def lengths_meant(model: ArmModel, letters: list[str], claims: list[dict[str, object]]) -> dict[str, str]:
    """Return letter -> length of the arm, {} where no reading stands out.

    Args:
        model: The arm.
        letters: Letters that the page uses and never defines.
        claims: The keys of its claims; those that use a symbol of the page are passed over.
    """
    samples = sample(model, TRIED)
    lines = [line for keys in claims for line in _lines(model, set(letters), keys, samples)]
    lines = [line for line in lines if line[0]]
    used = sorted(set().union(*(names for names, _ in lines)))
    lengths = [name for name, value in model.values.items() if value]
    if not used or len(lengths) ** len(used) > MOST:
        return {}
    scores: list[tuple[int, dict[str, str]]] = []
    known: dict[tuple[int, tuple[str, ...]], bool] = {}
    for choice in itertools.product(lengths, repeat=len(used)):
        meant = dict(zip(used, choice, strict=True))
        score = 0
        for k, (names, pieces) in enumerate(lines):
            key = k, tuple(meant[name] for name in sorted(names))
            if key not in known:
                env = samples.env | {name: samples.env[meant[name]] for name in names}
                known[key] = all(_right(tree, wanted, turning, env) for tree, wanted, turning in pieces)
            score += known[key]
        scores.append((score, meant))
    scores.sort(key=lambda found: -found[0])
    best, meant = scores[0]
    alone = len(scores) == 1 or best > scores[1][0]
    return meant if alone and best * 2 > len(lines) else {}


def _lines(model: ArmModel, letters: set[str], keys: dict[str, object], samples: Samples) -> Iterator[Line]:
    """What a claim says, each formula with the values (K,) that it should have, and whether those are angles."""
    what, kind = keys.get("is"), keys.get("kind")
    try:
        if kind == "entry":
            pieces = [(model.parse(str(what), letters), samples.env[str(keys["of"])], False)]
        elif kind == "joint" and "joint" in keys and isinstance(what, str):
            joint = int(str(keys["joint"]))
            turning = not model.sliding(joint)
            pieces = [(model.parse(what, letters), samples.env[f"theta{joint}"], turning)]
        elif kind == "equation":
            left, right = parse_equation(str(what), model.names() | letters, model.n)
            pieces = [(left - right, np.zeros(TRIED), False)]
        elif kind == "matrix" and isinstance(what, list):
            M = value_of(parse_product(str(keys["of"]), model.n), samples.frames)
            cells = [(i, j, str(cell)) for i, row in enumerate(what) for j, cell in enumerate(row) if cell]
            pieces = [(model.parse(cell, letters), M[:, i, j], False) for i, j, cell in cells]
        else:
            return
    except (InputError, KeyError, IndexError):
        return
    for tree, wanted, turning in pieces:
        yield frozenset(tree.symbols() & letters), [(tree, wanted, turning)]


def _right(tree: Expr, wanted: np.ndarray, turning: bool, env: dict[str, np.ndarray]) -> bool:
    hit = np.zeros(TRIED, dtype=bool)
    for value in branch_values(tree, env, (TRIED,)):
        gap = value - wanted
        gap = np.abs(np.angle(np.exp(1j * gap)) if turning else gap)
        hit |= gap <= JUDGED_HOLDS * (1 + np.abs(wanted))
    # an arc sine or cosine without its second value is right at some of them
    return bool(hit.all()) if not turning else bool(2 * hit.sum() >= TRIED)
