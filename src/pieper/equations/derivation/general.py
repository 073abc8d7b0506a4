"""What is true of an arm without a closed form: why there is none, its polynomial, how the other joints follow."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from pieper.algebra.expression import Sym, angle_symbol
from pieper.description.coupling import chain_values, joint_values, moved_by
from pieper.document.blocks import Document
from pieper.document.formulas import NOTHING, ZERO, Written
from pieper.equations.arm import Arm
from pieper.equations.derivation.characteristic import CharacteristicPolynomial, characteristic_polynomial
from pieper.errors import PieperError
from pieper.kinematics.arrays import Array
from pieper.kinematics.geometry import look
from pieper.solver.plan.plan import Plan
from pieper.tolerances import CHOSEN_VALUE, DERIVED_SAME, MEETS

TERMS_A_LINE = 4


@dataclass(frozen=True)
class PolynomialCheck:
    """How the polynomial's real roots compare with the solver.

    Attributes:
        poses: Poses tried.
        solutions: Solutions the solver found.
        found: How many of them are among those that follow from the polynomial's real roots.
        extra: Solutions that follow from the polynomial and reach the pose but that the solver does not have.
        own: How many of the joint vectors that the poses were made from came back.
        worst: Largest joint deviation among the found ones, rad.
    """

    poses: int
    solutions: int
    found: int
    extra: int
    own: int
    worst: float

    @property
    def holds(self) -> bool:
        """Whether the polynomial gave every solution."""
        return self.found == self.solutions and self.own == self.poses

    @property
    def what(self) -> str:
        """The result in sentences."""
        if not self.poses:
            return "There is no polynomial to check."
        return (
            f"At {self.poses} random poses the real roots lead to {self.found} of the solver's {self.solutions} "
            f"solutions, to {self.worst:.1e} rad at worst, and to {self.extra} more; the joint vector that made the "
            f"pose came back {self.own} times of {self.poses}."
        )

    def __str__(self) -> str:
        return self.what


class GeneralInverse:
    """An arm whose joints cannot be solved one after the other.

    Attributes:
        chosen: Spare joints (0-based) that must be chosen first.
        example: The joint vector whose pose the page works out.
    """

    def __init__(self, arm: Arm, plan: Plan | None) -> None:
        self._arm, self.plan = arm, plan
        locked = plan.reduction.locked if plan is not None else ()
        self.chosen = tuple(j for j in locked if j < arm.n)
        if not self.chosen and arm.n > 6:
            self.chosen = tuple(range(6, arm.n))
        middle = np.random.default_rng(4).uniform(-1.2, 1.2, arm.n)
        self.example = np.radians(np.round(np.degrees(middle)))

    @property
    def _kept(self) -> list[int]:
        """The joints (0-based) that are solved for."""
        return [j for j in range(self._arm.n) if j not in self.chosen]

    def polynomial(self, T: Array, chosen: Any = None) -> CharacteristicPolynomial | None:
        """The characteristic polynomial at a pose (4, 4); `chosen` are the values of the spare joints, rad.

        Of coupled joints it is in the turn of an axis, and its solutions are in the joints' own numbers.
        """
        values = np.zeros(len(self.chosen)) if chosen is None else np.atleast_1d(chosen)
        poly = self._of_axes(T, values)
        coupling = self._arm.chain.coupling
        if poly is None or coupling is None:
            return poly
        axes = np.zeros((len(poly.solutions), self._arm.n))
        axes[:, self._kept], axes[:, self.chosen] = poly.solutions, values
        rows = self._arm.chain.joints.wrapped(joint_values(axes, coupling))
        return replace(poly, solutions=rows[:, self._kept])

    def _of_axes(self, T: Array, values: Array) -> CharacteristicPolynomial | None:
        """The polynomial with its solutions as turns of the axes."""
        chain = self._six(values)
        if chain.n != 6 or chain.prismatic.any():
            return None
        return characteristic_polynomial(np.array(chain.links), np.asarray(T, float), chain.native.fk)

    def _six(self, values: Any) -> Any:
        chain = self._arm.chain.uncoupled
        for joint, value in sorted(zip(self.chosen, values, strict=True), reverse=True):
            chain = chain.locked(joint, float(value))
        return chain

    # -- words -----------------------------------------------------------------------------------------------
    def why(self) -> list[str]:
        """Which axes would have to meet or be parallel for a closed form, and by how much they miss."""
        chain = self._six(self.example[list(self.chosen)])
        names = [j + 1 for j in self._kept]
        geometry = look(chain, MEETS)
        meets, turns = [], []
        for i in range(chain.n - 2):
            if chain.prismatic[i : i + 3].any():
                continue
            label = f"{names[i]}, {names[i + 1]} and {names[i + 2]}"
            angles = [geometry.pairs[i].angle, geometry.pairs[i + 1].angle]
            turns.append((max(angles), label))
            if min(angles) > MEETS:
                meets.append((geometry.common_point((i, i + 1, i + 2))[1], label))
        if any(miss < MEETS for miss, _ in meets) or any(angle < MEETS for angle, _ in turns):
            how = [f"axes {label} meet in a point" for miss, label in meets if miss < MEETS]
            how += [f"axes {label} are parallel" for angle, label in turns if angle < MEETS]
            return [
                f"On this arm {' and '.join(how)}, and the solver works from that. Written out step by "
                "step, no equation of it holds one unknown alone, so no formulas are given here."
            ]
        if self._arm.n < 6:
            return self._why_few()
        held = " and ".join(self._symbol(j + 1).text() for j in self.chosen)
        said = [
            "A six-joint arm has a closed form when three neighbouring axes meet in one point or are parallel "
            f"(Pieper 1968). {f'With {held} held' if held else 'Here'} none do."
        ]
        if meets:
            miss, label = min(meets)
            said.append(
                f"The nearest to meeting are axes {label}: any point misses one of them by at least about "
                f"{miss * 1e3:.4g} mm."
            )
        if turns:
            angle, label = min(turns)
            said.append(
                f"The nearest to being parallel are axes {label}: they are {np.degrees(angle):.4g} degrees apart."
            )
        return said

    def _why_few(self) -> list[str]:
        """What neighbouring axes of an arm of fewer than six joints do, those that are chosen among them."""
        geometry = look(self._arm.chain.uncoupled, MEETS)
        how = [
            f"axes {pair.first + 1} and {pair.first + 2} lie in one line"
            for pair in geometry.pairs
            if pair.relation == "coincident"
        ]
        for i in range(geometry.chain.n - 2):
            if geometry.chain.prismatic[i : i + 3].any():
                continue
            label = f"axes {i + 1}, {i + 2} and {i + 3}"
            if max(geometry.pairs[i].angle, geometry.pairs[i + 1].angle) < MEETS:
                how.append(f"{label} are parallel")
            elif geometry.common_point((i, i + 1, i + 2))[1] < MEETS:
                how.append(f"{label} meet in a point")
        if not how:
            return ["No three neighbouring axes of this arm meet in a point or are parallel."]
        return [f"On this arm {' and '.join(how)}; no order of steps was found that gives every joint a formula."]

    def write(self, page: Document) -> None:
        """Write what is true onto a page."""
        arm = self._arm
        page.say(" ".join(self.why()))
        names = [self._symbol(j + 1).text() for j in self.chosen]
        if names:
            page.say(
                f"The arm has a joint to spare; {', '.join(names)} is chosen first, and what follows is for that value."
            )
        T = arm.fk(self.example)
        poly = self.polynomial(T, chain_values(self.example, self._arm.chain.coupling)[list(self.chosen)])
        if poly is None:
            page.say(
                "All six ways to eliminate joints vanish for this arm's geometry, so no polynomial is given here; "
                "the solver finds its solutions numerically and certifies their number."
            )
            return
        unknown = self._symbol(self._name(poly))
        half = (
            Written("t = tan(", r"t = \tan(", "<mi>t</mi><mo>=</mo><mi>tan</mi><mo>(</mo>")
            + unknown
            + Written("/2)", "/2)", "<mo>/</mo><mn>2</mn><mo>)</mo>")
        )
        self._meaning(page)
        page.say(
            f"The joints satisfy one polynomial equation of degree {poly.degree} in ",
            half,
            f"{self._most(poly)} Its coefficients depend on the pose; there is no formula for its roots.",
        )
        self._method(page, poly)
        page.heading("The polynomial at one pose")
        page.say(
            "For the pose of the joint vector " + _degrees(self.example) + ", scaled to a largest coefficient of 1:"
        )
        terms = [(c, poly.degree - k) for k, c in enumerate(poly.coefficients)]
        for first in range(0, len(terms), TERMS_A_LINE):
            part = terms[first : first + TERMS_A_LINE]
            line = _polynomial(part, goes_on=first > 0)
            page.show(*([line, ZERO] if first + TERMS_A_LINE >= len(terms) else [line]))
        roots = ": t = " + ", ".join(f"{x:.6g}" for x in np.tan(poly.angles / 2)) if len(poly.angles) else ""
        page.say(
            f"Of its {poly.degree} roots {len(poly.solutions)} belong to real postures{roots}. They are, each brought "
            "to the pose and confirmed there:"
        )
        for row in poly.solutions:
            page.say(_degrees(row, 4))
        page.say(f"(The harmonics that must vanish by theory do so to {poly.noise:.0e} of the largest.)")

    def _name(self, poly: CharacteristicPolynomial) -> int:
        return self._kept[poly.joint - 1] + 1

    def _most(self, poly: CharacteristicPolynomial) -> str:
        """How many solutions a pose has by the polynomial, and by what the solver knows of the arm."""
        most = self.plan.count.most if self.plan is not None and not self.chosen else poly.degree
        if most >= poly.degree:
            return f", so a pose has at most {poly.degree} solutions."
        return f"; of its roots no more than {most} belong to different postures, which is the most that a pose has."

    def _symbol(self, joint: int) -> Sym:
        """What stands for the turn of an axis (1-based): the joint's number, of coupled joints another letter."""
        return angle_symbol(joint, "q" if self._arm.chain.coupling is None else "theta")

    def _meaning(self, page: Document) -> None:
        """Say what turns the axes of coupled joints."""
        coupling = self._arm.chain.coupling
        if coupling is None:
            return
        names = [angle_symbol(k + 1, "q").text() for k in range(self._arm.n)]
        moved = [f"{self._symbol(j + 1).text()} = {moved_by(coupling[j], names)}" for j in range(self._arm.n)]
        page.say(
            f"The joints are coupled; axes 1 to {self._arm.n} turn by {', '.join(moved)}, counted from where all "
            "joints are at zero."
        )

    def _method(self, page: Document, poly: CharacteristicPolynomial) -> None:
        names = [j + 1 for j in self._kept]
        cut = [names[(poly.joint - 3 + k) % 6] for k in range(6)]
        one, two, three, four, five, six = map(self._symbol, cut)
        page.heading("How it comes about")
        page.say(
            f"Close the loop of the arm and the wanted pose and cut it at joint {cut[5]}: the axis l of that joint "
            f"and the point p on it are reached through joints {cut[2]}, {cut[3]}, {cut[4]} on one side and through "
            f"{cut[1]}, {cut[0]} on the other."
        )
        page.say(
            "Equate p, l, p·p, p·l, p × l and (p·p) l − 2 (p·l) p of both sides: fourteen equations, each linear in "
            "the sine and cosine of every joint (Raghavan and Roth 1990)."
        )
        page.say(
            "Six combinations of them are free of ",
            one,
            " and ",
            two,
            ". With half-angle tangents for ",
            four,
            " and ",
            five,
            ", and each also multiplied by the first, they are twelve equations in twelve monomials; the "
            "determinant, which depends on ",
            three,
            " alone, must vanish.",
        )
        page.say(
            "At a root the null vector of that matrix gives ",
            four,
            " and ",
            five,
            " as ratios of neighbouring entries, eight of the fourteen equations give ",
            one,
            " and ",
            two,
            " linearly, and the loop leaves ",
            six,
            ".",
        )

    # -- numbers ---------------------------------------------------------------------------------------------
    def check(self, n: int = 10, *, rng: np.random.Generator) -> PolynomialCheck:
        """Compare the solutions that follow from the polynomial with the solver's at `n` random poses."""
        arm = self._arm
        poses = solutions = found = extra = own = 0
        worst = 0.0
        kept, coupling = self._kept, arm.chain.coupling
        for q in rng.uniform(-np.pi, np.pi, (n, arm.n)):
            T = arm.fk(q)
            axes = chain_values(q, coupling)
            poly = self._of_axes(T, axes[list(self.chosen)])
            if poly is None:
                continue
            poses += 1
            own += _among(axes[kept], poly.solutions) < DERIVED_SAME
            rows = [chain_values(row, coupling) for row in _solver_rows(arm, T, q, self.chosen)]
            matched = [_among(row[kept], poly.solutions) for row in rows]
            solutions += len(rows)
            good = [m for m in matched if m < DERIVED_SAME]
            found += len(good)
            extra += max(len(poly.solutions) - len(good), 0)
            worst = max([worst, *good])
        return PolynomialCheck(poses, solutions, found, extra, own, worst)


def _solver_rows(arm: Arm, T: Array, q: Array, chosen: Any) -> list:
    try:
        rows = arm.ik(T, redundancy=float(q[chosen[0]])).all_q if chosen else arm.ik(T).all_q
    except PieperError:
        return [q]
    return [row for row in rows if all(abs(np.angle(np.exp(1j * (row[j] - q[j])))) < CHOSEN_VALUE for j in chosen)]


def _among(q: Array, rows: Any) -> float:
    if not len(rows):
        return np.inf
    return float(np.abs(np.angle(np.exp(1j * (rows - q)))).max(axis=1).min())


def _degrees(q: Array, digits: int = 0) -> str:
    return "(" + ", ".join(f"{x:z.{digits}f}" for x in np.degrees(q)) + ") deg"


def _polynomial(terms: list[tuple[float, int]], *, goes_on: bool) -> Written:
    """Some terms of a polynomial in t; `goes_on` when they follow others."""
    out = NOTHING
    for place, (value, power) in enumerate(terms):
        lead = "-" if value < 0 else "+"
        around = f" {lead} " if place else f"{lead} " if goes_on else lead
        if place or goes_on or value < 0:
            out = out + Written(around, around, f"<mo>{'−' if lead == '-' else '+'}</mo>")
        out = out + _number(abs(value))
        if power:
            raised = f"<msup><mi>t</mi><mn>{power}</mn></msup>" if power > 1 else "<mi>t</mi>"
            text, latex = (f"t^{power}", f"t^{{{power}}}") if power > 1 else ("t", "t")
            out = out + Written("*" + text, " " + latex, raised)
    return out


def _number(value: float) -> Written:
    number = f"{value:.6g}"
    mantissa, _, exponent = number.partition("e")
    if not exponent:
        return Written(number, number, f"<mn>{number}</mn>")
    power = int(exponent)
    mathml = f"<mn>{mantissa}</mn><mo>·</mo><msup><mn>10</mn><mn>{power}</mn></msup>"
    return Written(number, rf"{mantissa}\cdot 10^{{{power}}}", mathml)
