"""Which joints must be known before an entry of matrices in a formula is.

R03 is worked out from the joints that it is made of. R36 is what the pose leaves of them, and P05 of an arm whose last
joint turns about the line through it is known from the pose alone. A1, R01 and P12 are of one joint, and known when it
is: a formula that finds the joint in them finds what was put in.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from pieper.algebra.expression import Expr
from pieper.algebra.formula import ANGLE
from pieper.algebra.notation import joint_sum
from pieper.judge.evidence import Evidence
from pieper.judge.letters import MatrixLetter
from pieper.judge.model import POSE_NAMES
from pieper.judge.products import Factor, Product, factors_of
from pieper.tolerances import ENTRY_MATTERS


def known_in(ev: Evidence, node: Expr, angle: Expr, frame: Product | None = None) -> dict[str, set[int]]:
    """For every entry of matrices in a formula for an angle the joints (1-based) that it must be known for.

    Args:
        ev: The arm and its samples.
        node: The formula.
        angle: What it is for.
        frame: The frame whose letters it uses; those of a single row are made of its joint.
    """
    own = {j for _, j in joint_sum(angle) or ()}
    known = {name: known_for(ev, name, own) for name in ev.picks(node)}
    part = _alone(frame, ev.model.n, frozenset(ev.matrices)) if frame is not None else set[int]()
    if len(part) == 1:
        letters = {name for name, _, _ in POSE_NAMES} & node.substitute(ev.definitions).symbols()
        known |= dict.fromkeys(letters, part)
    return known


def known_for(ev: Evidence, name: str, own: Iterable[int] = ()) -> set[int]:
    """The joints (1-based) that must be known before a letter taken from matrices is.

    (T A6^-1)[1,4] is computed with theta6, but it is the wrist centre, which does not depend on it.

    Args:
        ev: The arm and its samples.
        name: The letter.
        own: The joints that a formula with it is for.
    """
    letter, n = ev.letters[name], ev.model.n
    matrices = frozenset(ev.matrices)
    joints = known_from(letter, n, frozenset(own), matrices)
    in_own: set[int] = set()
    for factor in factors_of(letter.product):
        for cell in (cell for row in ev.matrices.get(factor.name, ()) for cell in row):
            in_own |= {int(found.group(1)) for found in map(ANGLE.match, cell.symbols()) if found}
            in_own = in_own.union(*(known_for(ev, inside, own) for inside in ev.picks(cell)))
    drawn = replace(ev, when=()).draw(len(ev.samples.q), seed=77)
    here, other = ev.samples.frames, drawn.frames
    rows = ev.samples.nominal & drawn.nominal

    def moves(joint: int, value: np.ndarray) -> bool:
        changed = letter.value({**here, f"A{joint}": other[f"A{joint}"]})
        return not np.allclose(changed[rows], value[rows], rtol=0, atol=ENTRY_MATTERS)

    part = _alone(letter.product, n, matrices)
    if part and joints.isdisjoint(part):
        if min(part) > 1:
            return in_own | joints
        # where a frame stands, seen from the last one: what moves it must be known to take it off the pose
        return in_own | {j for j in joints if _moves_from_behind(here, other, j, max(part), n, rows)}
    value = letter.value(here)
    return in_own | {j for j in joints if moves(j, value)}


def _moves_from_behind(
    here: dict[str, np.ndarray], other: dict[str, np.ndarray], joint: int, last: int, n: int, rows: np.ndarray
) -> bool:
    """Whether a joint moves the origin of frame `last` as the last frame sees it."""

    def origin(swapped: bool) -> np.ndarray:
        M = np.broadcast_to(np.eye(4), here["T"].shape)
        for k in range(last + 1, n + 1):
            M = M @ (other if swapped and k == joint else here)[f"A{k}"]
        return np.linalg.inv(M)[rows, :3, 3]

    return not np.allclose(origin(True), origin(False), rtol=0, atol=ENTRY_MATTERS)


def known_from(letter: MatrixLetter, n: int, own: frozenset[int], matrices: frozenset[str]) -> set[int]:
    """The joints (1-based) that must be known before an entry of matrices can be computed.

    Args:
        letter: The entry, or the length of a vector.
        n: How many joints the arm has.
        own: The joints that are to be found.
        matrices: Names of matrices that the file defines; what they use is another matter.
    """
    every = set(range(1, n + 1))
    part = _alone(letter.product, n, matrices)
    if not part:
        return set[int]().union(*(p for p in _spans(letter.product, n, matrices) if p != every))
    if len(part) == 1 or own.isdisjoint(part):
        return part  # worked out from its own joints
    if min(part) == 1 and not _position(letter):
        return part  # nobody has the first frames' rotation from the last ones'
    return every - part


def _position(letter: MatrixLetter) -> bool:
    """Whether a letter is where a frame's origin is, and not how it is turned."""
    name = next(factor.name for factor in factors_of(letter.product) if re.fullmatch(r"[TRP]\d+", factor.name))
    return name[0] == "P" or (name[0] == "T" and letter.product.entry is not None and letter.product.entry[1] == 4)


def _alone(of: Product, joints: int, own: frozenset[str]) -> set[int]:
    """The joints of a product that is one part of the arm's chain, such as R36; empty for anything else."""
    made = [(factor, span) for factor in factors_of(of) for span in _span(factor, joints, own)]
    if len(made) != 1 or len(made[0][1]) == joints or made[0][0].name[0] not in "TRP":
        return set()
    return made[0][1]


def _spans(of: Product, joints: int, own: frozenset[str]) -> list[set[int]]:
    """The joints inside every matrix of a product."""
    return [span for factor in factors_of(of) for span in _span(factor, joints, own)]


def _span(factor: Factor, joints: int, own: frozenset[str]) -> list[set[int]]:
    name = factor.name
    if not name or factor.constant or factor.of or name == "I" or name in own:
        return []
    digits = [int(d) for d in re.findall(r"\d", name)]
    if name == "J":
        return [{j} for j in range(1, joints + 1)]  # it takes every joint, and is not part of the pose
    if name[0] in "AQv" and digits:
        return [{digits[0]}]
    first, last = (0, joints) if not digits else (0, digits[0]) if len(digits) == 1 else (digits[0], digits[1])
    return [set(range(min(first, last) + 1, max(first, last) + 1))]
