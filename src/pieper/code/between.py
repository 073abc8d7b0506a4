"""What lies between an arm's own joints and the six that are solved: joints that are held, filled or coupled."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from pieper.errors import PlanError
from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.pose import inverse
from pieper.kinematics.whole_turns import WholeTurns
from pieper.solver.plan.plan import Plan

#: The entries of a pose, row by row, that a task asks for.
ASKED = {"pose": tuple(range(12)), "position": (3, 7, 11), "position+axis": (2, 3, 6, 7, 10, 11)}


@dataclass(frozen=True, eq=False)
class Between:
    """How rows of the six joints become joint vectors.

    Args:
        columns: For each joint of the arm the solved joint it is, or None where it is held at the value asked for.
        filled: (solved joint, its unit) that must come out as zero.
        weights: Of the tested entries, whose squares add up to what is missed, squared; for arms with filled joints,
            whose rows are brought nearest to the pose.
        tested: The entries of a pose that forward kinematics must return, of rows that are put back.
        always: Whether all rows are put back, and not those of unclear poses alone.
        held: The joint that is held, from 0; None where none is.
        at_base: Whether it is the first joint, not the last.
        taken_off: (4, 4) the constant part of what is taken off the pose then.
        default: The value it is held at where nobody says one.
        gears: (n, n) the coupling: the chain is at gears @ q; None where joints move by themselves.
        wraps: Whether each coupled joint's own number is brought to (-pi, pi].
        tied: (n,) joints whose numbers whole turns of the axes move together.
        moves: (k, n) how they move those, all that can matter inside the limits.
        weight: (n,) of squared differences, by which the shortest of several is chosen.
    """

    columns: tuple[int | None, ...]
    filled: tuple[tuple[int, float], ...] = ()
    tested: tuple[int, ...] = ASKED["pose"]
    weights: tuple[float, ...] = ()
    always: bool = False
    held: int | None = None
    at_base: bool = False
    taken_off: Array | None = None
    default: float = 0.0
    gears: Array | None = None
    wraps: bool = False
    tied: Bools | None = None
    moves: Array | None = None
    weight: Array | None = None

    @property
    def n(self) -> int:
        """Number of joints of the arm."""
        return len(self.columns)

    @property
    def plain(self) -> bool:
        """Whether the six joints are the arm's own."""
        return self.columns == tuple(range(6)) and not self.filled and self.gears is None and not self.always

    @property
    def back(self) -> Array:
        """(n, n) the inverse of the gears."""
        return np.asarray(np.eye(self.n) if self.gears is None else np.linalg.inv(self.gears), np.float64)

    def sums(self, matrix: Array, entry: Callable[[int], str]) -> list[str]:
        """Return matrix @ vector as a text a row, entries of the vector as a language says them."""
        return [" + ".join(_times(float(x), entry(j)) for j, x in enumerate(row) if x != 0) or "0.0" for row in matrix]


def _times(number: float, entry: str) -> str:
    return entry if number == 1 else f"({number!r}) * {entry}"


def held_words(own: Between) -> str:
    """Return the line of a file's head that says what value is asked for; empty where none is."""
    if own.held is None:
        return ""
    return f"The arm has a joint to spare: ik takes the value of joint {own.held + 1} too, rad or m.\n"


def between(plan: Plan) -> Between:
    """Return what lies between the joints of a plan and its six.

    Raises:
        PlanError: More than one joint is held, or one in the middle of the arm.
    """
    reduction, chain = plan.reduction, plan.chain
    if len(reduction.locked) > 1 or (reduction.locked and (reduction.at_ends is None or reduction.locked[0] >= plan.n)):
        raise PlanError(
            f"{plan.name}: {', '.join(plan.redundancy)} would have to be held in the middle of the arm, which "
            "changes the numbers of the six that are left. Lock it (with_joints_locked) at the value that is wanted, "
            "and export that arm."
        )
    kept = reduction.kept.tolist()
    held = reduction.locked[0] if reduction.locked else None
    at_base = held == 0
    link = chain.links[0 if at_base else plan.n] if held is not None else np.eye(4)
    short = bool(reduction.fill) or reduction.full.n > plan.n
    real = 6 - len(reduction.fill)
    own = Between(
        columns=tuple(None if j == held else kept.index(j) for j in range(plan.n)),
        filled=tuple((real + k, chain.length if slides else 1.0) for k, (_, slides) in enumerate(reduction.fill)),
        tested=ASKED[plan.task],
        weights=_weights(plan) if reduction.fill else (),
        always=short,
        held=held,
        at_base=at_base,
        taken_off=inverse(link),
        default=float(plan.defaults[0]) if held is not None else 0.0,
    )
    return own if chain.coupling is None else _coupled(plan, own, chain.coupling)


def _weights(plan: Plan) -> tuple[float, ...]:
    """Return what each tested entry counts: lengths per length of the arm, entries of a rotation half, squared."""
    turn = 0.5**0.5 if plan.task == "pose" else 1.0
    return tuple(1.0 / plan.chain.length if entry % 4 == 3 else turn for entry in ASKED[plan.task])


def _coupled(plan: Plan, own: Between, coupling: Array) -> Between:
    chain = plan.chain
    if chain.whole_turns:
        return replace(own, gears=coupling, wraps=True)
    turns = WholeTurns(coupling, chain.prismatic)
    # every row has its axes in (-pi, pi]: what whole turns can matter is found from both ends
    ends = turns.joints(np.where(chain.prismatic, 0.0, np.array([[np.pi], [-np.pi]])))
    tied, parts = np.zeros(plan.n, np.bool_), list[Array]()
    endless = [not np.isfinite(plan.limits[block]).any() for block in turns.blocks]
    # what has no limits is inside where it is: moves of other joints are not tried beside its own
    limits = plan.limits.copy()
    for block in itertools.compress(turns.blocks, endless):
        limits[block] = 0.0
    for block, moves, free in zip(turns.blocks, turns.between(limits, ends), endless, strict=True):
        if len(block) > 1 or abs(coupling[block[0], block[0]]) != 1:
            tied[block] = True
            parts.append(np.zeros((1, plan.n)) if free else moves)
    moves = np.array([np.sum(some, axis=0) for some in itertools.product(*parts)]).reshape(-1, plan.n)
    return replace(own, gears=coupling, tied=tied, moves=moves, weight=chain.joints.unit**-2.0)
