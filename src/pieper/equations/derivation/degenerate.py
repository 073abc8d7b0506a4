"""What happens where a step of a derivation degenerates: every such case is visited, not guessed.

Postures at which the step's coefficients vanish are looked for. Where there are some, the joint is moved and the joints
after it follow, if they can: then it is free. Where they cannot, another equation decides, and it is looked for. Where
there are none, the lengths rule them out, or no pose that the arm reaches is one.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
import numpy.typing as npt

from pieper.algebra.arithmetics import NumpyField
from pieper.algebra.expression import Expr, Sym, Trig, angle_symbol
from pieper.description.dh import Description
from pieper.equations.derivation.detour import detour
from pieper.equations.derivation.elimination import Eliminator, Move
from pieper.equations.derivation.patterns import Solved
from pieper.equations.derivation.splits import Equation
from pieper.equations.derivation.step import Step
from pieper.equations.derivation.witness import branch_values, single_joint
from pieper.equations.table import SymbolTable
from pieper.equations.vanishing import NEWTON, random_postures, scale_of, vanishing_near
from pieper.kinematics.joints import short_way
from pieper.tolerances import (
    COEFFICIENT_VANISHES,
    DAMPING_LEAST,
    DAMPING_OF_MISS,
    DEGENERATE_CLEAR,
    DEGENERATE_CLOSES,
    DEGENERATE_STEP,
    NO_DIRECTION,
)

Array = npt.NDArray[np.float64]

Instead = tuple[tuple[Move, ...], Eliminator]

FREE, ELSEWHERE, IMPOSSIBLE, UNREACHED, MIXED = "free", "elsewhere", "impossible", "unreached", "mixed"
STARTS = 16  # random postures from which a degenerate one is looked for
LOOKED = 4  # degenerate postures that are tried
MOVES = ((0.05, -0.03), (0.002, -0.0013))  # rad (or of the longest length) by which a joint is moved that may be free,
# there and back; how far it can go on is for the steps after it to say
OTHER_STARTS = 7  # random postures for the joints after it


class Form(Protocol):
    """What is needed of a derivation, see `ClosedForm`."""

    n: int
    steps: tuple[Step, ...]
    chosen: tuple[int, ...]
    table: SymbolTable
    description: Description

    given: str

    @property
    def moves(self) -> list[Move]:
        """The moves that the steps were made of."""
        ...

    @property
    def constants(self) -> dict:
        """Numbers for the lengths and twists."""
        ...

    def poses(self, q: Array) -> Array:
        """Poses (N, 4, 4) of joint vectors (N, n)."""
        ...

    def values_at(self, q: Array) -> dict:
        """Values (N,) of every symbol at joint vectors (N, n)."""
        ...

    def replayed(self, moves: int) -> Eliminator:
        """The elimination as it stood after so many steps."""
        ...


@dataclass(frozen=True, eq=False)
class Case:
    """One degenerate case of a derivation.

    Attributes:
        kind: FREE (any value will do), ELSEWHERE (another equation decides), IMPOSSIBLE (the lengths rule it out),
            UNREACHED (no pose that the arm reaches), MIXED (free at some of its poses).
        postures: (m, n) joint vectors, rad or m, at which it was visited.
        rest: What the step's equation then says, 0 = rest, as (left, right); None when it says nothing.
        options: Moves that may decide instead, the simplest first, each with the elimination that it belongs to; more
            than one where other joints must come first.
        chosen: The one of them that leads to every posture, None when none does.
        conditions: What tells solutions from other choices of signs there; None where all are solutions, () where it
            takes forward kinematics to tell.
        sigma: The branch sign that its two solutions go with: that of the step whose branches meet there.
    """

    kind: str
    postures: Array
    rest: Expr | None = None
    options: tuple[Instead, ...] = ()
    chosen: Instead | None = None
    conditions: tuple[Any, ...] | None = None
    sigma: Sym | None = None


def visit(form: Form, step: Step) -> Case:
    """Visit the degenerate case of a step (`step.degenerate` is not empty)."""
    rng = np.random.default_rng(29)
    postures = _postures(form, step, rng)
    if not len(postures):
        angles_only = all(isinstance(a, Trig) or a in form.constants for c in step.degenerate for a in c.atoms())
        return Case(IMPOSSIBLE if angles_only else UNREACHED, postures, _rest(form, step))
    free = _free(form, step, postures[:LOOKED], rng)
    if free.all():
        return Case(FREE, postures[:LOOKED])
    sigma = _meeting(form, step, postures[:LOOKED][~free])
    undecided = postures[:LOOKED][~free]
    options = tuple(_others(form, step, undecided, sigma is not None))
    e = form.replayed(step.number - 1)
    gone = form.moves[step.number - 1].solved.degenerate
    moves = detour(e, step.angle, gone, undecided, two=sigma is not None)
    options += ((moves, e),) if moves else ()
    return Case(MIXED if free.any() else ELSEWHERE, postures[:LOOKED], None, options, sigma=sigma)


def _meeting(form: Form, step: Step, postures: Array) -> Sym | None:
    """The sign of the earlier step whose two branches meet at degenerate postures (m, n)."""
    others = random_postures(STARTS, form.n, _sliding(form), _scale(form), np.random.default_rng(41))
    values = truth(form, np.concatenate([postures, others]), step.number - 1)
    for earlier in form.steps[: step.number - 1]:
        if earlier.sigma is not None and earlier.merge is not None and earlier.branches == 2:
            size = np.abs(np.broadcast_to(earlier.merge.evaluate(values, NumpyField), len(postures) + len(others)))
            if size[: len(postures)].max() < np.sqrt(COEFFICIENT_VANISHES) * size.max():
                return earlier.sigma
    return None


def _scale(form: Form) -> float:
    return max([NO_DIRECTION, *(abs(float(v)) for s, v in form.constants.items() if s.base in ("a", "d"))])


def _sliding(form: Form) -> list[int]:
    return [j - 1 for j in form.table.prismatic]


def truth(form: Form, q: Array, before: int, *, signs: bool = False) -> dict:
    """Values (N,) of every symbol that the first `before` steps know, at joint vectors (N, n) and their own poses.

    A branch sign has the value with which its own formula gives the joint vector: where later steps hold it, or `signs`
    of all steps are asked for.
    """
    values = form.values_at(q)
    for step in form.steps[:before]:
        for symbol, expression in step.names:
            values[symbol] = expression.evaluate(values, NumpyField)
        if single_joint(step.angle) is None:
            values[step.symbol] = sum(k * values[angle_symbol(j)] for j, k in step.angle)
        later = _later(form.steps[step.number :])
        if step.sigma is not None and (signs or any(step.sigma in x.atoms() for x in later)):
            values[step.sigma] = _sign(form, step, values, len(q))
    return values


def _later(steps: tuple[Step, ...]) -> Iterator[Expr]:
    """Every expression of some steps."""
    for step in steps:
        yield from (step.formula, *step.degenerate, *(x for _, x in step.names))
        if step.merge is not None:
            yield step.merge


def _sign(form: Form, step: Step, values: dict, count: int) -> Array:
    """The value (count,) of a step's branch symbol that gives its joint the value it has."""
    wanted = _wanted(form, step, values)
    choices, gaps = branch_values(step.branches), []
    with np.errstate(all="ignore"):
        for sign in choices:
            gap = np.broadcast_to(step.formula.evaluate({**values, step.sigma: sign}, NumpyField), count) - wanted
            gaps.append(np.nan_to_num(np.abs(gap if _slides(form, step) else np.angle(np.exp(1j * gap))), nan=np.inf))
    return np.array(choices)[np.argmin(gaps, axis=0)]


def _slides(form: Form, step: Step) -> bool:
    return single_joint(step.angle) in form.table.prismatic


def _wanted(form: Form, step: Step, values: dict) -> Array:
    """The value (N,) of what a step is for: a slide, an angle or a sum of angles."""
    if _slides(form, step):
        return np.asarray(values[step.symbol], dtype=float)
    return np.asarray(sum(k * values[angle_symbol(j)] for j, k in step.angle), dtype=float)


def _vanishing(form: Form, step: Step, q: Array) -> Array:
    """(N, m) the step's coefficients at joint vectors (N, n)."""
    values = truth(form, q, step.number - 1)
    for symbol, expression in step.names:
        values[symbol] = expression.evaluate(values, NumpyField)
    found = [np.broadcast_to(c.evaluate(values, NumpyField), len(q)) for c in step.degenerate]
    return np.stack(found, axis=1)


def usual_size(form: Form, step: Step) -> Array:
    """The largest size (m,) of a step's coefficients at random postures, one where they are nothing there."""
    q = random_postures(STARTS, form.n, _sliding(form), _scale(form), np.random.default_rng(43))
    size = np.abs(np.nan_to_num(_vanishing(form, step, q))).max(axis=0)
    return np.where(size > 0, size, 1.0)


def _postures(form: Form, step: Step, rng: np.random.Generator) -> Array:
    """Postures (m, n) at which the step degenerates, none when there are none."""
    size, sliding = _scale(form), _sliding(form)
    start = random_postures(STARTS, form.n, sliding, size, rng)
    q, gap, gone = vanishing_near(lambda points: _vanishing(form, step, points), start, scale_of(form.n, sliding, size))
    order = np.argsort(gap)  # the solver asks for the last digits
    return q[order[gone[order]]]


def _free(form: Form, step: Step, postures: Array, rng: np.random.Generator) -> npt.NDArray[np.bool_]:
    """At which postures (m, n) the step's joint can be moved, the joints before it held and those after following."""
    sliding = _sliding(form)
    moving = [j for j in range(form.n) if j + 1 not in form.chosen]
    mine = _row(form, step.angle)
    size = _scale(form)
    far = size if _slides(form, step) else 1.0
    A = np.array([*(_row(form, earlier.angle) for earlier in form.steps[: step.number - 1]), mine])
    moves = list(itertools.chain.from_iterable(MOVES))
    cells = list(itertools.product(range(len(postures)), moves))
    q = np.repeat(postures[[k for k, _ in cells]], OTHER_STARTS + 1, axis=0)
    target = q @ A.T
    target[:, -1] += np.repeat([by * far for _, by in cells], OTHER_STARTS + 1)
    x, others = q.copy(), np.arange(len(q)) % (OTHER_STARTS + 1) > 0
    scatter = rng.uniform(-np.pi, np.pi, (int(others.sum()), form.n))
    scatter[:, sliding] *= size / np.pi
    x[np.ix_(others, np.array(moving))] += scatter[:, moving]
    reached = _reached(form, form.poses(q), x, moving, A, target, size)
    some = reached.reshape(len(postures), *np.shape(MOVES), -1).any(axis=-1)
    return np.asarray(np.any(np.all(some, axis=-1), axis=-1), dtype=bool)


def _row(form: Form, angle: tuple) -> Array:
    """The sum of joint coordinates q that an angle of the table is, its constant left out."""
    row = np.zeros(form.n)
    for joint, factor in angle:
        row[joint - 1] = factor * form.description.sign[joint - 1]
    coupling = form.description.coupling
    return row if coupling is None else row @ coupling


def _reached(
    form: Form, T: Array, x: Array, moving: list[int], A: Array, target: Array, size: float
) -> npt.NDArray[np.bool_]:
    """Which poses (K, 4, 4) are reached from the starts x (K, n) with A x = target (K, m), by damped Newton steps."""
    columns = ["noap".index(c) for c in form.given]
    scales = np.array([size if c == "p" else 1.0 for c in form.given])
    unit = scale_of(form.n, _sliding(form), size)
    slides = (A != 0)[:, _sliding(form)].any(axis=1)

    def missed(points: Array, T: Array, target: Array) -> Array:
        parts = (form.poses(points)[:, :3, columns] - T[:, :3, columns]) / scales
        gap = points @ A.T - target
        held = np.where(slides, gap / size, short_way(gap))
        return np.concatenate([parts.reshape(len(points), -1), held], axis=1)

    done = np.zeros(len(x), dtype=bool)
    for _ in range(NEWTON):
        rows = np.flatnonzero(~done)
        if not len(rows):
            break
        here = missed(x[rows], T[rows], target[rows])
        done[rows] = np.abs(here).max(axis=1) < DEGENERATE_CLOSES
        many = len(moving)
        points = np.concatenate([x[rows] + h for h in DEGENERATE_STEP * np.diag(unit)[moving]])
        every = missed(points, np.tile(T[rows], (many, 1, 1)), np.tile(target[rows], (many, 1)))
        J = np.moveaxis((every.reshape(many, len(rows), -1) - here) / DEGENERATE_STEP, 0, 2)
        JT = np.swapaxes(J, 1, 2)
        damp = (DAMPING_OF_MISS * (here**2).sum(1) + DAMPING_LEAST)[:, None, None] * np.eye(many)
        move = np.linalg.solve(JT @ J + damp, JT @ here[..., None])[..., 0]
        x[np.ix_(rows, np.array(moving))] -= np.clip(move, -0.6, 0.6) * unit[moving]
    return done


def _rest(form: Form, step: Step) -> Expr | None:
    """What is left of the step's one equation where its coefficients, plain symbols, vanish; None when nothing is."""
    move = form.moves[step.number - 1]
    if len(move.equations) != 1:
        return None
    gone = {a for c in move.solved.degenerate for a in c.atoms()}
    total = move.equations[0].left - move.equations[0].right
    left = {key: v for key, v in total.terms.items() if not gone & {*(s for s, _ in key[0]), *key[1]}}
    rest = type(total)(left)
    if not left or rest.atoms() - set(form.constants):
        return None
    value = float(np.asarray(rest.expr().evaluate(form.constants, NumpyField)))
    return (rest if next(iter(left.values())) > 0 else -rest).expr() if abs(value) > COEFFICIENT_VANISHES else None


def _others(form: Form, step: Step, postures: Array, two: bool) -> Iterator[Instead]:
    """Equations of one unknown that may decide the step's joint at degenerate postures (m, n).

    Only where the two branches of an earlier step meet may one of `two` solutions: their sign tells those apart.
    """
    e = form.replayed(step.number - 1)
    values = truth(form, postures, step.number - 1, signs=True)
    wanted = _wanted(form, step, values)
    sigma, name = Sym("sigma", str(step.number), 0), Sym("f", str(step.number), 4)
    options: list[tuple] = []
    for equations in e.tiers():
        options += [o for o in e.options(equations, sigma, name) if o[1] == step.angle]
    for _, angle, used, recipe, polys in sorted(options, key=lambda option: option[0]):
        solved = recipe.build()
        if solved is None or (solved.branches > 1 and not two) or not _gives(e, solved, sigma, values, wanted):
            continue
        shown = [*polys, solved.formula, *(x for _, x in solved.definitions)]
        names = tuple(e.target.show([*shown, *_sides(used)]))
        yield (Move(step.symbol, angle, used, solved, sigma if solved.branches > 1 else None, names),), e


def _sides(equations: tuple[Equation, ...]) -> list:
    return list(itertools.chain.from_iterable((q.left, q.right) for q in equations))


def _gives(e: Eliminator, solved: Solved, sigma: Sym, values: dict, wanted: Array) -> bool:
    """Whether a formula, not degenerate there, gives the wanted values (m,) on one of its branches."""
    known = dict(values)
    for symbol, poly in e.target.definitions.items():
        known[symbol] = poly.evaluate(known)
    hits = np.zeros(wanted.shape, dtype=bool)
    for sign in branch_values(solved.branches):
        known[sigma] = np.full(wanted.shape, sign)
        for symbol, expression in solved.definitions:
            known[symbol] = expression.evaluate(known, NumpyField)
        for condition in solved.degenerate:
            known_size = np.abs(np.broadcast_to(condition.evaluate(known, NumpyField), wanted.shape))
            if len(solved.degenerate) == 1 and known_size.min() < DEGENERATE_CLEAR:
                return False
        if solved.degenerate:
            sizes = [np.abs(np.broadcast_to(c.evaluate(known, NumpyField), wanted.shape)) for c in solved.degenerate]
            if np.max(sizes, axis=0).min() < DEGENERATE_CLEAR:
                return False
        with np.errstate(all="ignore"):
            gap = np.broadcast_to(solved.formula.evaluate(known, NumpyField), wanted.shape) - wanted
        hits |= np.abs(np.angle(np.exp(1j * gap))) < DEGENERATE_CLEAR
    return bool(hits.all())
