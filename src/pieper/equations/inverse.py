"""The inverse of an arm as equations: a derivation when there is a closed form, and what is true when there is none."""

from __future__ import annotations

import functools
import itertools
from collections.abc import Iterator
from typing import Any

import numpy as np

from pieper.document.blocks import Document
from pieper.document.readable import Readable
from pieper.equations.arm import Arm
from pieper.equations.derivation.check import DerivationCheck, check
from pieper.equations.derivation.closed_form import ClosedForm
from pieper.equations.derivation.elimination import Eliminator
from pieper.equations.derivation.general import GeneralInverse, PolynomialCheck
from pieper.equations.derivation.sign_names import POSES, SignName, add_sign_names, sign_names
from pieper.equations.derivation.words import write_steps
from pieper.equations.derivation.worked import WorkedExample
from pieper.equations.lettering import checked_letters, in_letters
from pieper.equations.named_parts import broken_lines
from pieper.equations.table import symbol_table
from pieper.errors import InputError, PieperError, PlanError
from pieper.kinematics.arrays import Array
from pieper.kinematics.geometry import look
from pieper.kinematics.pose import checked_pose
from pieper.solver.plan.plan import Plan
from pieper.tolerances import ALIGNED

GIVEN = {"pose": "noap", "position": "p", "position+axis": "ap"}


class InverseEquations(Readable):
    """The inverse kinematics of one arm as equations.

    Attributes:
        form: The closed form (`ClosedForm`), or None.
        general: What is true of an arm without one (`GeneralInverse`), or None.
        task: "pose", "position" or "position+axis".
        letters: "noap" or "r", in which the page names the entries of the pose.
    """

    def __init__(self, arm: Arm, *, task: str | None = None, letters: str = "noap") -> None:
        self._arm = arm
        self.letters = checked_letters(letters)
        self.plan = _plan(arm, task)
        self.task = task or (self.plan.task if self.plan else "pose")
        self.form = _closed_form(arm, self.plan, self.task)
        self._fell_back = ""
        if self.form is None and task is None and self.task != "pose" and arm.n < 6:
            # the whole pose says more than the task asks for, and an arm with few joints needs it all the same
            self.form = _closed_form(arm, self.plan, "pose")
            if self.form is not None:
                self._fell_back, self.task = self.task, "pose"

    @functools.cached_property
    def general(self) -> GeneralInverse | None:
        """What is true of an arm without a closed form."""
        return GeneralInverse(self._arm, self.plan) if self.form is None else None

    @property
    def closed(self) -> bool:
        """Whether every joint has a formula."""
        return self.form is not None

    @property
    def steps(self) -> tuple:
        """The numbered steps of the derivation; empty without a closed form."""
        return self.form.steps if self.form else ()

    @functools.cached_property
    def sign_names(self) -> list[SignName]:
        """What the branch signs mean for the posture: shoulder, elbow, wrist; empty where labels follow no sign."""
        if self.form is None or self.plan is None:
            return []
        q = np.random.default_rng(20264).uniform(-np.pi, np.pi, (POSES, self._arm.n))
        return sign_names(self.form, self.plan, self._arm.fk(q))

    @functools.cached_property
    def page(self) -> Document:
        """Sentences and formulas in reading order."""
        page = Document(f"Inverse kinematics of {self._arm.name}")
        if self.form is not None:
            if self._fell_back:
                page.say(
                    f"By the {self._fell_back.replace('+', ' and the ')} alone, which is what the solver takes of this "
                    "arm, no order of steps was found that gives every joint. What follows is for the whole pose."
                )
            if self.plan is not None:
                # the plan's number of solutions is that of its own task
                page.add(*_how(self._arm, self.plan, self.form, counted=not self._fell_back))
            write_steps(page, self.form)
            add_sign_names(page, self.sign_names)
        elif self.general is not None:
            self.general.write(page)
        return in_letters(broken_lines(page), self.letters)

    def sympy(self) -> dict:
        """{name: sympy expression} in the order of evaluation, shorthands included."""
        if self.form is None:
            return {}
        found = {}
        for step in self.form.steps:
            for symbol, expr in (*step.names, (step.symbol, step.formula)):
                found[symbol.name] = expr.sympy()
        return found

    def evaluate(self, T: Array, *, chosen: Any = None) -> np.ndarray:
        """Every branch at poses T (N, 4, 4) -> (branches, N, n), NaN where not real."""
        if self.form is None:
            raise PieperError(f"{self._arm.name} has no closed form; use arm.ik, or .general.polynomial(T).")
        return self.form.evaluate(T, chosen=chosen)

    def worked(self, T: Any) -> WorkedExample:
        """Work one pose (4, 4) through the derivation, numbers put in line by line; a solution inside limits if any."""
        if self.form is None:
            raise PieperError(f"{self._arm.name} has no closed form to work through; arm.ik solves it.")
        T = checked_pose(T, "T")
        limits = np.asarray(self._arm.limits)
        if not (self.form.chosen or self.form.free or any(s.degenerate for s in self.form.steps)):
            return WorkedExample(self.form, T, limits)
        try:  # what may be chosen is taken from a solution: not every value of it has one
            sols = self._arm.ik(T)
            rows = [*sols.q, *sols.all_q]
        except PieperError:
            rows = []
        for row in (*rows[:8], None):
            try:
                return WorkedExample(self.form, T, limits, row)
            except InputError:
                continue
        return WorkedExample(self.form, T, limits)

    def check(self, n: int = 200, *, rng: np.random.Generator | None = None) -> DerivationCheck | PolynomialCheck:
        """Evaluate the formulas at every solution of `n` random poses, and at 50 digits (`DerivationCheck`)."""
        rng = rng or np.random.default_rng(20263)
        if self.form is not None:
            return check(self.form, self._arm, n, rng)
        return GeneralInverse(self._arm, self.plan).check(min(n, 20), rng=rng)


def _plan(arm: Arm, task: str | None) -> Plan | None:
    try:
        return arm.plan_for(task)
    except PlanError:
        return None


def _closed_form(arm: Arm, plan: Plan | None, task: str) -> ClosedForm | None:
    """The first set of chosen joints with which every joint can be solved; the plan's choice comes first."""
    table = symbol_table(arm.description)
    fold = task != "pose"
    for chosen in _choices(arm, plan, task):
        eliminator = Eliminator(table, given=GIVEN[task], chosen=chosen, fold_tool=fold)
        if eliminator.solve():
            try:
                return ClosedForm(eliminator, arm.description, fold_tool=fold)
            except KeyError:  # a step uses an angle that only a later one gives: this order of steps is no derivation
                continue
    return None


def _choices(arm: Arm, plan: Plan | None, task: str) -> Iterator[tuple[int, ...]]:
    wanted = {"pose": 6, "position": 3, "position+axis": 5}[task]
    spare = max(arm.n - wanted, 0)
    first = ()
    if plan is not None:
        first = tuple(j + 1 for j in plan.reduction.locked if j < arm.n)
        spare = max(spare, len(first))
    # the solver's own choice first, unless it stands for an arm that the solver has no closed form for either
    general = plan is not None and plan.max_solutions > 8 and spare
    seen = {first} if (len(first) == spare or not spare) and not general else set()
    yield from seen
    if not seen and not spare:
        yield ()
    free = functools.partial(_may_be_chosen, arm, task)
    if spare == 1:
        order = [1, arm.n, *range(2, arm.n)]
        yield from ((j,) for j in order if (j,) not in seen and free((j,)) and _promising(arm, j))
    elif spare > 1:
        others = (c for c in itertools.combinations(range(1, arm.n + 1), spare) if c not in seen and free(c))
        yield from itertools.islice(others, 20)


def _may_be_chosen(arm: Arm, task: str, chosen: tuple[int, ...]) -> bool:
    """Whether the other joints can do all that the arm can do without these (1-based): no pose fixes one of them."""
    kept = [j for j in range(arm.n) if j + 1 not in chosen]
    for q in np.random.default_rng(6).uniform(-2.5, 2.5, (3, arm.n)):
        J = arm.jacobian(q)
        if task == "position":
            J = J[:3]
        elif task == "position+axis":
            across = np.linalg.svd(arm.fk(q)[:3, 2][None])[2][1:]
            J = np.vstack([J[:3], across @ J[3:]])
        if np.linalg.matrix_rank(J[:, kept], ALIGNED) < np.linalg.matrix_rank(J, ALIGNED):
            return False
    return True


def _promising(arm: Arm, joint: int) -> bool:
    """Whether three neighbouring axes meet or are parallel once this joint (1-based) is held, or few are left."""
    if arm.n < 6:
        return True
    geometry = look(arm.chain.locked(joint - 1, 0.37), ALIGNED)
    return bool(geometry.spherical) or any(len(group.joints) > 2 for group in geometry.parallel)


def _how(arm: Arm, plan: Plan, form: ClosedForm, *, counted: bool) -> tuple[str, ...]:
    words = {
        "spherical_wrist_parallel": "The last three axes meet in a point, the wrist centre, and axes 2 and 3 are "
        "parallel: the first three joints place the wrist centre, the last three turn the tool.",
        "spherical_wrist": "Three axes meet in a point: the other joints place that point, these three turn the tool.",
        "three_parallel": "Three neighbouring axes are parallel: what happens across them is solved first, then "
        "their plane.",
    }
    # an arm with few joints is solved as one with six; what is said is said of the arm itself
    sentence = words.get(plan.family, "") if arm.n >= 6 else _short_arm(arm)
    if plan.snapped:
        sentence += (
            " The formulas are those of the table as it stands; the solver takes " + "; ".join(plan.snapped) + "."
        )
    most = min(plan.count.most, form.branches)
    if counted and not form.chosen:
        sentence += f" A pose has at most {most} solution{'s' * (most != 1)}."
    said = sentence.strip()
    return (said,) if said else ()


def _short_arm(arm: Arm) -> str:
    """What makes an arm with fewer than six joints solvable, in a sentence; "" where nothing does at a glance."""
    chain = arm.chain
    slides = [j + 1 for j in range(arm.n) if chain.prismatic[j]]
    turns = [j + 1 for j in range(arm.n) if not chain.prismatic[j]]
    if not turns:
        return "The arm only slides: every slide follows from the position."
    axes = _axes(arm)
    if len(turns) > 1 and all(np.linalg.norm(np.cross(axes[t - 1], axes[turns[0] - 1])) < ALIGNED for t in turns):
        along = [s for s in slides if np.linalg.norm(np.cross(axes[s - 1], axes[turns[0] - 1])) < ALIGNED]
        if slides and along == slides:
            height = "the slide sets" if len(slides) == 1 else "the slides set"
            return f"All axes are parallel: the turning joints place the tool across them, {height} the height."
        return "All turning axes are parallel: the arm moves its tool in a plane." if not slides else ""
    geometry = look(chain, ALIGNED)
    parallel = [group.joints for group in geometry.parallel if len(group.joints) > 2]
    if parallel:
        *first, last = (str(j + 1) for j in parallel[0])
        names = f"{', '.join(first)} and {last}"
        return f"Axes {names} are parallel: what happens across them is solved first, then their plane."
    if arm.n > 3 and not slides:
        for i in range(arm.n - 2):
            if min(geometry.pairs[i].angle, geometry.pairs[i + 1].angle) < ALIGNED:
                continue
            if geometry.common_point((i, i + 1, i + 2))[1] < ALIGNED:
                return (
                    f"Axes {i + 1}, {i + 2} and {i + 3} meet in a point: the other joints place that point, these "
                    "three turn the tool."
                )
    return ""


def _axes(arm: Arm) -> list[np.ndarray]:
    """The direction of every joint's axis at a posture, found by moving the joint a little."""
    q = np.full(arm.n, 0.3)
    found = []
    for j, kind in enumerate(arm.joint_types):
        column = arm.jacobian(q)[:, j]
        axis = column[3:] if kind == "R" else column[:3]
        found.append(axis / np.linalg.norm(axis))
    return found
