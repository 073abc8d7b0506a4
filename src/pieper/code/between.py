"""What lies between an arm's joints and the six that are solved: joints that are held, filled, coupled or linked."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from pieper.errors import PlanError
from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.pose import inverse
from pieper.kinematics.whole_turns import WholeTurns
from pieper.solver.plan.holding import locked_at
from pieper.solver.plan.plan import Plan
from pieper.tolerances import LINKAGE_STARTS

#: The entries of a pose, row by row, that a task asks for.
ASKED = {"pose": tuple(range(12)), "position": (3, 7, 11), "position+axis": (2, 3, 6, 7, 10, 11)}
#: Steps of least squares that bring a row to its pose: as many as the library's own.
STEPS = 6


@dataclass(frozen=True, eq=False)
class Between:
    """How rows of the six joints become joint vectors.

    Args:
        columns: For each axis of the arm the solved joint it is; None where it is held at the value asked for, a number
            where it is held at that one.
        filled: (solved joint, its unit) that must come out as zero.
        weights: Of the tested entries, whose squares add up to what is missed, squared; for arms with filled joints,
            whose rows are brought nearest to the pose.
        tested: The entries of a pose that forward kinematics must return, of rows that are put back.
        always: Whether all rows are put back, and not those of unclear poses alone.
        held: The joint that is held, from 0; None where none is.
        at_base: Whether it is the first joint, not the last.
        taken_off: (4, 4) the constant part of what is taken off the pose then.
        default: The value it is held at where nobody says one.
        gears: (axes, n) the coupling: the chain is at gears @ q; None where joints move by themselves. Where a linkage
            moves axes there are more of these than joints.
        back: (n, axes) what makes joints' numbers of the axes' values; None where joints move by themselves.
        joints_slide: (n,) which joints slide; None where every axis has a joint.
        starts: (axes,) by how much values of the axes may miss what a linkage holds and be brought there; else empty.
        wraps: Whether each coupled joint's own number is brought to (-pi, pi].
        tied: (n,) joints whose numbers whole turns of the axes move together.
        moves: (k, n) how they move those, all that can matter inside the limits.
        weight: (n,) of squared differences, by which the shortest of several is chosen.
    """

    columns: tuple[int | float | None, ...]
    filled: tuple[tuple[int, float], ...] = ()
    tested: tuple[int, ...] = ASKED["pose"]
    weights: tuple[float, ...] = ()
    always: bool = False
    held: int | None = None
    at_base: bool = False
    taken_off: Array | None = None
    default: float = 0.0
    gears: Array | None = None
    back: Array | None = None
    joints_slide: tuple[bool, ...] | None = None
    starts: tuple[float, ...] = ()
    wraps: bool = False
    tied: Bools | None = None
    moves: Array | None = None
    weight: Array | None = None

    @property
    def linked(self) -> bool:
        """Whether a linkage moves axes that have no joint of their own."""
        return self.joints_slide is not None

    @property
    def plain(self) -> bool:
        """Whether the six joints are the arm's own."""
        return self.columns == tuple(range(6)) and not self.filled and self.gears is None and not self.always

    @property
    def fixed(self) -> list[int]:
        """Joints that are held at a number in every row."""
        return [j for j, column in enumerate(self.columns) if isinstance(column, float)]

    def axes(self, row: Callable[[int], str]) -> list[str]:
        """Return the values of the axes, each as a text: entries of a row as a language says them, values held."""
        return [
            "value" if column is None else row(column) if isinstance(column, int) else repr(column)
            for column in self.columns
        ]

    def sums(self, matrix: Array, entry: Callable[[int], str]) -> list[str]:
        """Return matrix @ vector as a text a row, entries of the vector as a language says them."""
        return [" + ".join(_times(float(x), entry(j)) for j, x in enumerate(row) if x != 0) or "0.0" for row in matrix]


def _times(number: float, entry: str) -> str:
    return entry if number == 1 else f"({number!r}) * {entry}"


def held_words(own: Between) -> str:
    """Return the line of a file's head that says which joint is held, and at what; empty where none is."""
    if own.held is not None:
        return f"The arm has a joint to spare: ik takes the value of joint {own.held + 1} too, rad or m.\n"
    fixed = [f"joint {j + 1} at {own.columns[j]!r}" for j in own.fixed]
    return f"The arm has joints to spare: {', '.join(fixed)} (rad or m), in every row.\n" if fixed else ""


def asked_for(plan: Plan) -> int | None:
    """Return the joint whose value is asked for with each pose: one to spare at an end of the arm; else None."""
    reduction = plan.reduction
    alone = len(reduction.locked) == 1 and reduction.at_ends is not None and reduction.locked[0] < plan.n
    return reduction.locked[0] if alone else None


def solved_by(plan: Plan) -> Plan:
    """Return the plan whose six joints a file solves.

    Of axes that a linkage moves all are solved for, as if each moved by itself. Joints to spare that are not asked for
    are held where the plan holds them when nobody chooses, and the others are an arm of their own.

    Raises:
        PlanError: What is held is no joint of the arm but a turn of the tool that the task leaves free; or no family
            takes what is left.
    """
    if plan.chain.linked and plan.uncoupled is not None:
        return plan.uncoupled
    if not plan.reduction.locked or asked_for(plan) is not None:
        return plan
    if any(joint >= plan.n for joint in plan.reduction.locked):
        raise PlanError(
            f"{plan.name}: for {plan.task} its tool turns as it likes ({', '.join(plan.redundancy)}); "
            "a file would hold few of its rows. Ask for the whole pose, or ask arm.ik."
        )
    return locked_at(plan, tuple(plan.defaults.tolist()))


def between(plan: Plan) -> Between:
    """Return what lies between the joints of a plan and its six.

    Raises:
        PlanError: As of `solved_by`.
    """
    chain, solved, held = plan.chain, solved_by(plan), asked_for(plan)
    reduction = solved.reduction
    # joints of the plan that is solved among the axes, and where they stand among the six
    of = [j for j in range(chain.axis_count) if j not in plan.reduction.locked or solved is plan]
    place = {of[j]: int(reduction.real[k]) for k, j in enumerate(reduction.kept.tolist()) if j < len(of)}
    fixed = dict(zip(plan.reduction.locked, plan.defaults.tolist(), strict=True))
    at_base = held == 0
    link = chain.links[0 if at_base else plan.n] if held is not None else np.eye(4)
    fill = [(int(j), slides) for j, (_, slides) in zip(reduction.filled, reduction.fill, strict=True)]
    columns = tuple(place[j] if j in place else None if j == held else fixed[j] for j in range(chain.axis_count))
    own = Between(
        columns=columns,
        filled=tuple((j, chain.length if slides else 1.0) for j, slides in fill),
        tested=ASKED[plan.task],
        weights=_weights(plan, solved.chain.length) if fill else (),
        always=bool(fill) or plan.reduction.full.n > plan.n,
        held=held,
        at_base=at_base,
        taken_off=inverse(link),
        default=fixed[held] if held is not None else 0.0,
    )
    if chain.coupling is None:
        return own
    return _linked(plan, own, chain.coupling) if chain.linked else _coupled(plan, own, chain.coupling)


def _weights(plan: Plan, length: float) -> tuple[float, ...]:
    """Return what each tested entry counts: lengths per length of the arm, entries of a rotation half, squared."""
    turn = 0.5**0.5 if plan.task == "pose" else 1.0
    return tuple(1.0 / length if entry % 4 == 3 else turn for entry in ASKED[plan.task])


def _linked(plan: Plan, own: Between, coupling: Array) -> Between:
    """Return the same where a linkage moves axes: joints' numbers follow from their own axes, the others are tested.

    What is nearly held is brought nearest to the pose by the joints, as rows of arms with filled joints are.
    """
    chain = plan.chain
    back = np.zeros((plan.n, chain.axis_count))
    back[:, list(chain.own)] = np.linalg.inv(coupling[list(chain.own)])
    return replace(
        own,
        weights=_weights(plan, chain.length),
        always=True,
        gears=coupling,
        back=back,
        joints_slide=tuple(bool(s) for s in plan.prismatic),
        starts=tuple(LINKAGE_STARTS * (chain.length if slides else 1.0) for slides in chain.sliding),
        wraps=True,
    )


def _coupled(plan: Plan, own: Between, coupling: Array) -> Between:
    chain, own = plan.chain, replace(own, gears=coupling, back=np.linalg.inv(coupling))
    if chain.whole_turns:
        return replace(own, wraps=True)
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
    return replace(own, tied=tied, moves=moves, weight=chain.joints.unit**-2.0)
