"""Another order of steps where a step degenerates: with the sine that vanishes put to zero, other joints come first.

Where s2 = 0 axes 1, 3 and 4 of an arm may be parallel, and no equation holds theta1 alone; but theta3 follows from the
distance to axis 1, and then theta1. The elimination is taken up where it stood, at postures where the step degenerates.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from pieper.algebra.expression import Expr, Mul, Num, Sym, Trig
from pieper.algebra.harmonic import Poly
from pieper.equations.derivation.elimination import Eliminator, Move
from pieper.equations.derivation.witness import Witness

MOST = 3  # steps in place of one


def detour(
    e: Eliminator, angle: tuple, conditions: tuple[Expr, ...], postures: npt.NDArray[np.float64], *, two: bool
) -> tuple[Move, ...]:
    """Return the moves that end with an angle where its own step degenerates, () where none are found.

    Args:
        e: The elimination as it stood before the step; it goes on from there.
        angle: The angle that the step is for.
        conditions: What vanishes there, in the elimination's own names.
        postures: (m, n) joint vectors at which it does, rad or m.
        two: Whether one of the moves may have two branches.
    """
    gone = [atom for atom in map(_atom, conditions) if atom is not None]
    if len(gone) != len(conditions) or not gone:
        return ()
    e.splits.put(_values(gone))
    e.letter = "f"
    e.witness = Witness(e, postures)
    for move in e.moves:
        if move.equations and not e.witness.confirms(move.angle, move.solved, move.sigma or Sym("sigma", "0", 0)):
            return ()
    before = len(e.moves)
    while len(e.moves) - before < MOST:
        move = e.best()
        if move is None or (move.sigma is not None and not two) or move.solved.branches > 2:
            return ()
        two = two and move.sigma is None
        e.take(move)
        if any(m.angle == angle for m in e.moves[before:]):
            return _needed(e, e.moves[before:], angle)
    return ()


def _atom(condition: Expr) -> Sym | Trig | None:
    """The one sine, cosine or letter of the pose in a condition, None where there are more."""
    parts = condition.args if isinstance(condition, Mul) else (condition,)
    moving = [p for p in parts if not isinstance(p, Num) and not (isinstance(p, Sym) and p.rank < 3)]
    return moving[0] if len(moving) == 1 and isinstance(moving[0], (Sym, Trig)) else None


def _values(gone: list[Sym | Trig]) -> dict[Sym | Trig, Poly]:
    """What becomes of symbols where some vanish: s2 = 0 makes c(2 theta2) one."""
    found: dict[Sym | Trig, Poly] = {}
    for atom in gone:
        found[atom] = Poly()
        if isinstance(atom, Trig):
            twice = tuple((j, 2 * k) for j, k in atom.angle)
            found[Trig("s", twice, atom.group, atom.letter)] = Poly()
            found[Trig("c", twice, atom.group, atom.letter)] = Poly.number(1 if atom.kind == "s" else -1)
    return found


def _needed(e: Eliminator, moves: list[Move], angle: tuple) -> tuple[Move, ...]:
    """The moves of which the last one makes use, that for the angle."""
    last = next(k for k, m in enumerate(moves) if m.angle == angle)
    kept = [moves[last]]
    for move in reversed(moves[:last]):
        joints = {j for j, _ in move.angle}
        if any(joints & _joints(e, later) for later in kept):
            kept.insert(0, move)
    return tuple(kept)


def _joints(e: Eliminator, move: Move) -> set[int]:
    """The joints of a move's formulas and equations, and of what stands behind their names."""
    named = [e.target.definitions[name].expr() for name in move.names]
    exprs = [move.solved.formula, *(x for _, x in move.solved.definitions), *named]
    used = {j for x in exprs for a in x.atoms() if isinstance(a, Trig) for j, _ in a.angle}
    return used | {j for q in move.equations for p in (q.left, q.right) for j in p.joints()}
