"""Products of matrices evaluated at samples, and the products one slip away; `products` reads them."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from pieper.errors import InputError
from pieper.judge.products import Factor, Product
from pieper.words_by_number import plural


def value_of(product: Product, frames: dict[str, np.ndarray]) -> np.ndarray:
    """Evaluate a product at all samples, (K, 4, 4), (K, 3, 3) or (K, 3); with an entry, or a dot product, (K,)."""
    parts = [(-1 if k in product.minus else 1) * _chain(term, frames) for k, term in enumerate(product.terms)]
    total = parts[0]
    for part in parts[1:]:
        if part.shape != total.shape:
            raise InputError(f"{product}: a {total.shape[1:]} and a {part.shape[1:]} matrix cannot be added")
        total = total + part
    if product.entry is None:
        return total
    row, column = product.entry
    if total.ndim < 2:
        raise InputError(f"{product}: a number has no entries")
    shape = (*total.shape[1:], 1)[:2]
    if row > shape[0] or column > shape[1]:
        raise InputError(f"{product}: this matrix has {plural(shape[0], 'row')} and {plural(shape[1], 'column')}")
    return total[:, row - 1] if total.ndim == 2 else total[:, row - 1, column - 1]


def _chain(factors: tuple[Factor, ...], frames: dict[str, np.ndarray]) -> np.ndarray:
    out: np.ndarray | None = None
    for factor in factors:
        M = _value(factor, frames)
        if out is None:
            out = M
        else:
            if out.ndim == M.ndim == 3 and {out.shape[1], M.shape[1]} == {3, 4} and any(f.constant for f in factors):
                out, M = out[:, :3, :3], M[:, :3, :3]  # a constant turn beside a rotation is one
            try:
                out = (out @ M[..., None])[..., 0] if M.ndim == 2 else out @ M
            except ValueError:
                raise InputError(
                    f"{' '.join(map(str, factors))}: a {out.shape[1:]} and a {M.shape[1:]} matrix cannot be multiplied"
                ) from None
    assert out is not None  # a term has a factor at least
    return out


def _value(factor: Factor, frames: dict[str, np.ndarray]) -> np.ndarray:
    """One factor at all samples, with its inverse, transpose and part taken."""
    if factor.constant:
        M = np.broadcast_to(np.array(factor.constant), frames["T"].shape)
    elif factor.of:
        M = _of_vectors(factor, [value_of(part, frames) for part in factor.of])
    else:
        M = _named(factor.name, frames) if factor.name else value_of(factor.inside, frames)
    if factor.part:
        M = _part(factor, factor.part, M)
    if (factor.inverse or factor.transpose) and M.ndim != 3:
        raise InputError(f"{factor}: a vector has no inverse and is not transposed here")
    if factor.inverse:
        M = np.linalg.inv(M)
    return np.swapaxes(M, -1, -2) if factor.transpose else M


def _of_vectors(factor: Factor, vectors: list[np.ndarray]) -> np.ndarray:
    """The cross or the dot product of two vectors."""
    columns = [v[:, :, 0] if v.ndim == 3 and v.shape[2] == 1 else v for v in vectors]
    if any(v.ndim != 2 or v.shape[1] != 3 for v in columns):
        raise InputError(f"{factor}: {factor.name} takes two vectors of three entries, such as R03[:,3] or P06 - P03")
    a, b = columns
    return np.cross(a, b) if factor.name == "cross" else (a * b).sum(1)


def _part(factor: Factor, part: tuple[int, int, int], M: np.ndarray) -> np.ndarray:
    """The rows first .. last of one column."""
    first, last, column = part
    if M.ndim != 3 or column > M.shape[2] or (last or 1) > M.shape[1]:
        raise InputError(f"{factor}: this matrix has no such part")
    return M[:, first - 1 : last or M.shape[1], column - 1]


def _named(name: str, frames: dict[str, np.ndarray]) -> np.ndarray:
    if name in frames and name != "T":
        return frames[name]
    if name == "I":
        return np.broadcast_to(np.eye(4), frames["T"].shape)
    if name[0] in "AQv" and len(name) == 2:
        M = frames["A" + name[1]]
    elif len(name) == 1:
        M = frames["T"]
    else:
        first, last = (0, int(name[1])) if len(name) == 2 else (int(name[1]), int(name[2]))
        M = np.broadcast_to(np.eye(4), frames["T"].shape)
        for k in range(min(first, last), max(first, last)):
            M = M @ frames[f"A{k + 1}"]
        if first > last:
            M = np.linalg.inv(M)
    if name[0] in "RQ":
        return M[:, :3, :3]
    return M[:, :3, 3] if name[0] in "Pv" else M


def product_slips(product: Product, joints: int) -> Iterator[tuple[str, str, Product]]:
    """Yield (kind, words, product) for products one slip away: another order, an inverse, a factor lost or too many."""
    for k, term in enumerate(product.terms):
        for kind, words, factors in _term_slips(term, joints):
            yield kind, words, replace(product, terms=product.terms[:k] + (factors,) + product.terms[k + 1 :])


def _term_slips(term: tuple[Factor, ...], joints: int) -> Iterator[tuple[str, str, tuple[Factor, ...]]]:
    inverses = [i for i, f in enumerate(term) if f.inverse and f.name]
    if 2 <= len(inverses) <= 5:
        for order in itertools.permutations(inverses):
            if list(order) != inverses:
                new = list(term)
                for place, taken in zip(inverses, order, strict=True):
                    new[place] = term[taken]
                yield "order", "the inverses in the wrong order", tuple(new)
    for i, (f, g) in enumerate(itertools.pairwise(term)):
        yield "order", f"{f} and {g} exchanged", (*term[:i], g, f, *term[i + 2 :])
    for i, f in enumerate(term):
        before, after = term[:i], term[i + 1 :]
        yield "inverse", f"{f} for its inverse", (*before, replace(f, inverse=not f.inverse), *after)
        if f.transpose:
            yield "inverse", f"{f} transposed", (*before, replace(f, transpose=False), *after)
    for i in range(len(term) + 1):
        for joint in range(1, joints + 1):
            for inverse in (False, True):
                extra = Factor(f"A{joint}", inverse=inverse)
                yield "missing factor", f"{extra} lost", (*term[:i], extra, *term[i:])
    for i, f in enumerate(term):
        if len(term) > 1:
            yield "extra factor", f"{f} too many", term[:i] + term[i + 1 :]
