"""One pose worked through a derivation with numbers put in, line by line, as a good book does it."""

from __future__ import annotations

import functools
from typing import Any

import numpy as np

from pieper.algebra.arithmetics import NumpyField
from pieper.algebra.expression import Expr, Num, Sym, angle_symbol
from pieper.document.blocks import Document, Equation, Equations, Piece, listed
from pieper.document.formulas import equals
from pieper.document.readable import Readable
from pieper.equations.derivation.closed_form import CHOSEN, INSTEAD, REGULAR, ClosedForm
from pieper.equations.derivation.step import Step
from pieper.errors import InputError
from pieper.kinematics.arrays import Array
from pieper.tolerances import LED_BACK

DECIMALS = 5
LONG = 70  # letters; a formula with longer numbers in it takes two lines


class WorkedExample(Readable):
    """A pose solved by the formulas of a derivation, each with its numbers.

    Attributes:
        form: The closed form.
        T: (4, 4) the pose.
        branch: Which combination of signs is followed.
        q: (n,) the joint vector that comes out, rad or m.
    """

    def __init__(self, form: ClosedForm, T: Array, limits: Array, chosen: Array | None = None) -> None:
        start = np.zeros(form.n) if chosen is None else chosen
        self._solved = form.solved(T[None], start[None])
        found = self._solved.q[:, 0]
        real = np.isfinite(found).all(-1)
        if not real.any():
            raise InputError(
                "the pose cannot be worked through: no choice of signs leads to it by these formulas; take one that "
                "the arm reaches, and not where a step degenerates without another equation to decide it"
            )
        inside = real & ((found >= limits[:, 0]) & (found <= limits[:, 1])).all(-1)
        miss = form.missed(self._solved.q, T[None])[:, 0]
        self.reached = miss < LED_BACK * max(1.0, float(np.abs(T[:3]).max()))
        self.form, self.T = form, T
        ranked = [self.reached & inside, self.reached, real]
        self.branch = int(np.argmax(next(rows for rows in ranked if rows.any())))
        self.q, self.miss = found[self.branch], float(miss[self.branch])

    def __str__(self) -> str:
        return self.text()

    @functools.cached_property
    def values(self) -> dict[Any, float]:
        """Every letter of the page at this pose and on this branch."""
        every = self._solved.values
        return {
            key: float(np.broadcast_to(value, (self.form.branches, 1))[self.branch, 0])
            for key, value in every.items()
            if np.size(value) in (1, self.form.branches)
        }

    @functools.cached_property
    def page(self) -> Document:
        """Every shorthand and every joint: its formula, the numbers in it, what comes out."""
        form, page = self.form, Document("A worked example")
        letters = [Sym(c, x, 4) for c in form.given for x in "xyz"]
        page.say(
            f"Numbers are shown to {DECIMALS} decimals and carried in full. Lengths are in metres; angles that come "
            "out are in degrees, inside formulas in radians. The pose is"
        )
        page.add(Equations(tuple(Equation((x, self._number(self.values[x]))) for x in letters), beside=True))
        if form.sigmas:
            signs: list[Piece] = [equals(s, Num(int(self.values[s]))) for s in form.sigmas]
            page.say("and of the solutions the one with ", *listed(signs), " is followed.")
        for joint in (*form.chosen, *form.free):
            symbol = form.table.variable(joint)
            page.say(symbol, " may be chosen; it is taken as ", self._joint(symbol, joint), ".")
        for step in form.steps:
            self._step(page, step)
        self._joints(page)
        if not self.reached[self.branch]:
            page.say(
                "Put back through forward kinematics these joints do not give the pose: an entry of it is missed by "
                f"{self.miss:.2g}. The arm cannot take it; the formulas use some of its entries, and others do not fit."
            )
            return page
        given = {"p": "its position", "ap": "its position and approach"}.get(form.given, "the pose")
        to = f"to {self.miss:.0e} at worst" if self.miss else "to the last digit"
        page.say(f"Put back through forward kinematics these joints give {given} again, {to}.")
        return page

    def _joints(self, page: Document) -> None:
        """Say the joints' own numbers, where an angle or slide of the table is another one."""
        relations = [(s, expr) for s, expr in self.form.table.relation.values() if s.base != "q"]
        if all(expr == angle_symbol(k, "q") for k, (_, expr) in enumerate(relations, 1)):
            return
        turning = [k + 1 not in self.form.table.prismatic for k in range(self.form.n)]
        numbers = [
            equals(angle_symbol(k + 1, "q"), self._number(np.degrees(v), "°") if turning[k] else self._number(v))
            for k, v in enumerate(self.q)
        ]
        page.say("In the joints' own numbers that is ", *listed(numbers), ".")

    def _step(self, page: Document, step: Step) -> None:
        """The lines of a step; where it degenerates those of what decides it instead."""
        ways = self._solved.ways.get(step.number)
        way = REGULAR if ways is None else int(ways[self.branch, 0])
        for symbol, expr in step.names:
            self._line(page, symbol, expr)
        joint = step.angle[0][0]
        instead = self.form.instead(step) if way == INSTEAD else ()
        if way == CHOSEN:
            value = self._joint(step.symbol, joint)
            page.say(f"Here step {step.number} degenerates and ", step.symbol, " is free; it is taken as ", value, ".")
            return
        if instead:
            what = "another equation decides" if len(instead) == 1 else "another order of steps decides"
            page.say(f"Here step {step.number} degenerates, and {what}:")
            for other in instead:
                for symbol, expr in other.names:
                    self._line(page, symbol, expr)
                self._line(page, other.symbol, other.formula, angle=self._turns(other.angle[0][0]))
            return
        self._line(page, step.symbol, step.formula, angle=self._turns(joint))

    def _joint(self, symbol: Sym, joint: int) -> Sym:
        value = float(self.values[symbol])
        return self._number(np.degrees(value), "°") if self._turns(joint) else self._number(value)

    def _turns(self, joint: int) -> bool:
        return joint not in self.form.table.prismatic

    def _line(self, page: Document, symbol: Sym, expr: Expr, *, angle: bool = False) -> None:
        atoms = {atom: self._put(float(atom.evaluate(self.values, NumpyField))) for atom in expr.atoms()}
        value = float(self.values[symbol])
        shown = self._number(np.degrees(value), "°") if angle else self._number(value)
        put_in = expr.substitute(atoms)
        if len(put_in.text()) < LONG:
            page.show(symbol, expr, put_in, shown)
        else:
            page.show(symbol, expr)
            page.show(symbol, put_in, shown)

    @staticmethod
    def _put(value: float) -> Sym:
        """A number where a letter stood: in brackets, so that products and signs stay what they are."""
        text = str(int(value)) if value in (1.0, -1.0) else f"{value:z.{DECIMALS}f}"
        return Sym(f"({text})", "", 0)

    @staticmethod
    def _number(value: float, unit: str = "") -> Sym:
        return Sym(f"{value:z.{DECIMALS}f}{unit}", "", 0)
