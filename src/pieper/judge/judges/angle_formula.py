"""A formula for a joint's angle: its angle, its branches' values, how far off they are."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from pieper.algebra.arithmetics import NumpyField
from pieper.algebra.expression import Add, Call, Expr, Mul, Power
from pieper.algebra.formula import ANGLE, Mention, Neg, PlusMinus, has_branch, number, unordered
from pieper.algebra.notation import joint_sum
from pieper.errors import InputError
from pieper.judge.claim import Claim
from pieper.judge.evidence import SIGN, Evidence, under, wrapped
from pieper.judge.products import Product
from pieper.tolerances import JUDGED_ZERO, SEARCH_ARC


def read_angle(ev: Evidence, claim: Claim) -> tuple[str, Expr]:
    """Read which angle a claim is about: joint = 4, or for = "theta1+theta2"."""
    if "joint" in claim:
        name = f"theta{claim.joint(ev.model.n)}"
    elif "for" in claim:
        name = str(claim["for"])
    else:
        raise claim.error('say which joint, as joint = 4 or for = "theta1+theta2"')
    angle = ev.parse(name, key="for").substitute({b: Mention(joint) for b, joint in ev.model.aliases.items()})
    if not (joint_sum(angle) or ANGLE.match(str(angle))):
        raise claim.error(f'for = {name!r} must be a joint or a sum of joints, as in for = "theta1 + theta2"', "for")
    return name, angle


def right_side(ev: Evidence, text: str, angle: Expr) -> str:
    """The right side of a formula whose left side is written out, as in theta2 = atan2(..)."""
    left, equals, right = text.partition("=")
    if not equals or "=" in right:
        return text
    with under("is"):
        named = ev.model.parse(left.strip())
    if unordered(named) != unordered(angle):
        raise InputError(f"is: the left side is {left.strip()!r}, but the claim is about {angle}", key="is")
    return right.strip()


def either_of(first: Expr, second: Expr) -> Expr:
    """One formula whose upper sign gives the first of two branches and whose lower sign the second."""
    if has_branch(first) or has_branch(second):
        raise InputError("is: a list of branches holds formulas without +-", key="is")
    half = number("0.5")
    return Add.of(Mul.of(half, Add.of(first, second)), PlusMinus(Mul.of(half, Add.of(first, Neg.of(second)))))


def signed(ev: Evidence, claim: Claim, node: Expr, angle: Expr) -> Expr:
    """A formula with the branch sign that it introduces as its +-, and that sign known from here on.

    A page writes sigma3 in the formula that leaves it open and in later ones; they hold with the same sign.
    """
    new = [name for name in ev.unknown if SIGN.fullmatch(name) and name in node.symbols()]
    if len(new) > 1:
        raise claim.error(f"{' and '.join(new)} are both new here; an earlier formula must leave one open", "is")
    if not new:
        return node
    upper, lower = (node.substitute({new[0]: number(value)}) for value in ("1", "-1"))
    found = ANGLE.match(str(angle))
    if found and ev.model.sliding(int(found.group(1))):
        near = [Neg.of(Power(Add.of(side, Neg.of(angle)), number(2))) for side in (upper, lower)]
    else:
        near = [Call("cos", Add.of(side, Neg.of(angle))) for side in (upper, lower)]
    ev.tell_sign(new[0], Call("sign", Add.of(near[0], Neg.of(near[1]))))
    return node.substitute({new[0]: PlusMinus(number("1"))})


def branch_values(node: Expr, env: dict[str, np.ndarray], shape: tuple[int, ...]) -> Iterator[np.ndarray]:
    """Yield the values of a formula at all samples, one array a branch; nan where it is undefined."""
    for branch in (1, -1) if has_branch(node) else (1,):
        with np.errstate(all="ignore"):
            yield np.broadcast_to(np.asarray(node.evaluate(env, NumpyField, branch), dtype=float), shape)


@dataclass(frozen=True)
class AngleFormula:
    """What a formula is to give: an angle, with the letters of the pose or of another frame."""

    angle: Expr
    frame: Product | None
    slides: bool = False
    tolerance: float = SEARCH_ARC

    @classmethod
    def of(cls, ev: Evidence, angle: Expr, frame: Product | None) -> AngleFormula:
        """The angle of a turning joint or a sum of such; a sliding joint's value counts no whole turns."""
        found = ANGLE.match(str(angle))
        if found and ev.model.sliding(int(found.group(1))):
            return cls(angle, frame, True, JUDGED_ZERO * ev.model.length())
        return cls(angle, frame)

    def off(self, value: np.ndarray, wanted: np.ndarray) -> np.ndarray:
        """How far values are from the right ones."""
        return value - wanted if self.slides else wrapped(value - wanted)

    @property
    def unit(self) -> float:
        """What a reader sees for one: degrees of an angle."""
        return 1.0 if self.slides else 180 / np.pi

    def wanted(self, ev: Evidence) -> np.ndarray:
        """The right angle at every sample."""
        return np.asarray(self.angle.evaluate(ev.samples.env), dtype=float)

    def judged(self, ev: Evidence, node: Expr) -> np.ndarray:
        """Where one of the formula's branches is the angle."""
        wanted = self.wanted(ev)
        good = np.zeros(len(wanted), dtype=bool)
        for value in branch_values(node, ev.environment(self.frame), wanted.shape):
            off = np.abs(self.off(value, wanted))
            good |= np.where(np.isfinite(off), off, np.inf) < self.tolerance
        return good

    def with_symbols(self, node: Expr) -> Callable[[Evidence], tuple[np.ndarray, dict[str, np.ndarray]]]:
        """Where the formula is right, and the values of all symbols, for `region_of`."""
        return lambda ev: (self.judged(ev, node), ev.environment(self.frame))

    def gap(self, ev: Evidence, node: Expr, more: dict[str, np.ndarray]) -> np.ndarray:
        """The formula's nearest branch minus the angle."""
        wanted = self.wanted(ev)
        gaps = np.array(
            [self.off(v, wanted) for v in branch_values(node, {**ev.environment(self.frame), **more}, wanted.shape)]
        )
        size = np.where(np.isfinite(gaps), np.abs(gaps), np.inf)
        return np.take_along_axis(gaps, size.argmin(0)[None], 0)[0]
