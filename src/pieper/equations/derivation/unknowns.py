"""Which angles of an equation are still unknown, and the equation written by them.

An angle combination is known when all its joints are, or when that very sum has been found (theta234 is often known
long before theta3). What is known moves into the coefficients.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from pieper.algebra.expression import Sym, Trig
from pieper.algebra.harmonic import Poly, trig


@dataclass
class Knowledge:
    """What has been found so far.

    Attributes:
        prismatic: Symbols of sliding joints, {joint: symbol}.
        joints: Joints (1-based) whose variable is known.
        sums: Angle combinations that are known as a whole, {angle: symbol}.
    """

    prismatic: dict[int, Sym]
    joints: set[int] = field(default_factory=set)
    sums: dict[tuple, Sym] = field(default_factory=dict)

    def unknown_part(self, angle: tuple) -> tuple:
        """The combination without its known joints; empty when it is known altogether."""
        rest = tuple((j, k) for j, k in angle if j not in self.joints)
        if not rest or angle in self.sums or rest in self._reduced_sums():
            return ()
        return rest

    def _reduced_sums(self) -> set[tuple]:
        found = set()
        for angle in self.sums:
            rest = tuple((j, k) for j, k in angle if j not in self.joints)
            if rest:
                found |= {rest, tuple((j, -k) for j, k in rest)}
        return found

    def knows(self, poly: Poly) -> bool:
        """Whether every angle and slide of the polynomial is known."""
        for atom in poly.atoms():
            if isinstance(atom, Trig):
                if self.unknown_part(atom.angle):
                    return False
            elif atom in self.hidden_slides():
                return False
        return True

    def hidden_slides(self) -> dict[Sym, int]:
        """Symbols of the sliding joints that are not known."""
        return {s: j for j, s in self.prismatic.items() if j not in self.joints}

    def view(self, poly: Poly) -> View:
        """The polynomial by its unknowns."""
        slides = self.hidden_slides()
        terms: dict[tuple, Poly] = {}
        for (symbols, functions), value in poly.terms.items():
            kept = tuple((s, p) for s, p in symbols if s not in slides)
            moving = tuple((s, p) for s, p in symbols if s in slides)
            pieces = [(Poly({(kept, ()): value}), ())]
            for t in functions:
                rest = self.unknown_part(t.angle)
                if not rest:
                    pieces = [(c * Poly.symbol(t), m) for c, m in pieces]
                    continue
                pieces = [(c * k, (*m, u)) for c, m in pieces for k, u in self._expanded(t, rest)]
            for coefficient, mono in pieces:
                key = (moving, mono)
                terms[key] = terms.get(key, Poly()) + coefficient
        return View({key: c for key, c in terms.items() if c})

    @staticmethod
    def _expanded(t: Trig, rest: tuple) -> list[tuple[Poly, tuple[str, tuple]]]:
        """A cos or sin of (unknown + known) as [(known coefficient, (kind, unknown angle))], the unknown with +."""
        flip = -1 if rest[0][1] < 0 else 1
        unknown = tuple((j, flip * k) for j, k in rest)
        known = {j: k for j, k in t.angle if (j, k) not in rest}
        ck, sk = (trig(kind, known, t.group, t.letter) for kind in "cs")
        # cos(f x + k) = cos k cos x - f sin k sin x;  sin(f x + k) = sin k cos x + f cos k sin x
        pair = (ck, -(sk * flip)) if t.kind == "c" else (sk, ck * flip)
        return [(coefficient, (kind, unknown)) for kind, coefficient in zip("cs", pair, strict=True) if coefficient]


@dataclass(frozen=True)
class View:
    """A polynomial as {(slides, functions of unknown angles): known coefficient}."""

    terms: dict

    @property
    def angles(self) -> set[tuple]:
        """The unknown angle combinations."""
        return {angle for _, mono in self.terms for _, angle in mono}

    @property
    def slides(self) -> set[Sym]:
        """The unknown slides."""
        return {s for moving, _ in self.terms for s, _ in moving}

    def part(self, moving: tuple = (), mono: tuple = ()) -> Poly:
        """The coefficient of one monomial of the unknowns."""
        return self.terms.get((moving, mono), Poly())

    def linear(self) -> tuple[tuple, Poly, Poly, Poly] | None:
        """(angle, A, B, C) when the equation reads A cos x + B sin x + C = 0 in a single unknown x."""
        if self.slides or len(self.angles) != 1:
            return None
        (angle,) = self.angles
        allowed = {((), (("c", angle),)), ((), (("s", angle),)), ((), ())}
        if not set(self.terms) <= allowed:
            return None
        return angle, self.part((), (("c", angle),)), self.part((), (("s", angle),)), self.part()

    def quadratic(self) -> tuple[Sym, Poly, Poly, Poly] | None:
        """(slide, A, B, C) when the equation reads A d^2 + B d + C = 0 in a single unknown slide."""
        if self.angles or len(self.slides) != 1:
            return None
        (slide,) = self.slides
        if any(p > 2 for moving, _ in self.terms for _, p in moving):
            return None
        return slide, self.part(((slide, 2),)), self.part(((slide, 1),)), self.part()
