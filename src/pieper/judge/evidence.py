"""What every judge of a claim works with: the arm, its samples, the file's own symbols, words for a counter-example."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np

from pieper.algebra.expression import Expr
from pieper.algebra.formula import Mention
from pieper.algebra.formula_error import FormulaError
from pieper.algebra.parser import parse_equation
from pieper.errors import InputError, PieperError
from pieper.judge.claim import Claim
from pieper.judge.conditions import Condition, read_conditions
from pieper.judge.keys import UNITS
from pieper.judge.letters import MatrixLetter, neighbours, pick_letters
from pieper.judge.matrices import value_of
from pieper.judge.model import POSE_NAMES, ArmModel
from pieper.judge.products import Product, factors_of, parse_product
from pieper.judge.samples import Samples, joined, pose_of, pose_symbols, sample, some
from pieper.judge.search.search import Goal
from pieper.judge.slips.arm_slips import arm_slips
from pieper.judge.symbols import in_order, plain, refuse, refuse_another
from pieper.kinematics.joints import short_way
from pieper.tolerances import EVIDENCE_BACK, EVIDENCE_SAME, FLOOR_OF_SEARCH, SHOWN_ZERO

MOST_ROWS = 4  # of a matrix of the file's own
SIGNS = 24  # joint vectors at which a page's sine is compared with the joint's
DRAWS = 60  # of joint vectors, until enough meet the conditions of a claim
SOLVER_POSES = 10  # poses at which the other solutions are asked for

#: A branch sign of a page of formulas, as pieper writes it: one value in all formulas of a solution.
SIGN = re.compile(r"\bsigma\d{1,2}\b")


@dataclass
class Evidence:
    """One arm, its samples and the symbols of the claims file.

    Attributes:
        model: the arm.
        definitions: symbols of the file, each a formula; they may use one another.
        seconds: time the slip search may take per claim.
        unknown: symbols that the source never defines.
        held: joints (1-based) that a claim holds at a value.
        when: what a claim says of the joints it is about.
        zeros: lengths that are zero for this arm and that a formula names, so that they are varied too.
    """

    model: ArmModel
    definitions: dict[str, Expr] = field(default_factory=dict)
    seconds: float = 2.0
    unknown: list[str] = field(default_factory=list)
    held: Mapping[int, float] = field(default_factory=dict)
    when: tuple[Condition, ...] = ()
    letters: dict[str, MatrixLetter] = field(default_factory=dict)
    matrices: dict[str, list[list[Expr]]] = field(default_factory=dict)
    zeros: frozenset[str] = frozenset()

    @property
    def varied_zeros(self) -> frozenset[str]:
        """The lengths that are zero for this arm and not for every one of its build."""
        return self.zeros | self.model.zeros

    @property
    def lengths(self) -> dict[str, float]:
        """The lengths by name, those that are zero here and are varied with the length of the arm."""
        return {**self.model.values, **dict.fromkeys(self.varied_zeros, self.model.length())}

    def naming(self, *nodes: Expr) -> Evidence:
        """Return evidence in which the lengths that formulas name are varied, those that are zero here included."""
        used = set[str]().union(*(node.substitute(self.definitions).symbols() for node in nodes))
        named = frozenset(name for name, value in self.model.values.items() if not value and name in used)
        return self if named <= self.varied_zeros else replace(self, zeros=self.zeros | named)

    def define_matrix(self, name: str, rows: list[list[Any]]) -> None:
        """Add a matrix of the file, of 1 to 4 rows and columns, its entries numbers or formulas of the joints."""
        if name in self.model.names() or name in ("I", "T", "J") or re.fullmatch(r"[AQTRPv]\d{1,2}", name):
            raise InputError(f"the matrix {name!r} already means something for this arm; choose another name")
        if len(rows) > MOST_ROWS or len(rows[0]) > MOST_ROWS or any(len(row) != len(rows[0]) for row in rows):
            raise InputError(f"a matrix of one's own has rows of as many entries, {MOST_ROWS} of each at most")
        self.matrices[name] = [[self.parse(str(cell)).substitute(self.definitions) for cell in row] for row in rows]

    def define(self, name: str, text: str) -> None:
        """Add a symbol of the file; "?" marks one that the source uses and never defines."""
        name = plain(name)
        turned = refuse(name, self.model.n, self.model.names())
        if str(text).strip() == "?":
            self.unknown.append(name)
            self.definitions[name] = Mention(f"{name}?")
            return
        node = self.parse(str(text)).substitute(self.definitions)
        if turned is not None and not node.symbols() & {pose[0] for pose in POSE_NAMES}:
            env = self.draw(SIGNS, vary={}).env
            refuse_another(name, node, *(np.asarray(tree.evaluate(env), dtype=float) for tree in (node, turned)))
        self.definitions[name] = node

    def local(self, where: Mapping[str, Any]) -> dict[str, Expr]:
        """Read definitions that belong to one claim alone; later ones may use earlier ones."""
        local: dict[str, Expr] = {}
        with under("where"):
            ordered = in_order({plain(k): str(v) for k, v in where.items()}, {*self.model.names(), *self.definitions})
        for name, body in ordered.items():
            with under(f"where {name}", "where"):
                refuse(name, self.model.n)
                local[name] = self.read(body, {*self.definitions, *local}).substitute(local)
        return local

    def meet_signs(self, text: str) -> None:
        """Take note of branch signs sigma1, sigma2 ..: until a joint's formula says what one is, it may be anything."""
        for name in dict.fromkeys(SIGN.findall(re.sub(r"[_{}]", "", plain(text)))):
            if name not in self.definitions:
                self.unknown.append(name)
                self.definitions[name] = Mention(f"{name}?")
                self.fill_again()

    def tell_sign(self, name: str, meaning: Expr) -> None:
        """Say what a branch sign is: the one with which its first formula gives the joint's value."""
        self.unknown.remove(name)
        self.definitions[name] = meaning.substitute(self.definitions)
        self.fill_again()

    def fill_again(self) -> None:
        """Bring joint vectors that were drawn already up to the symbols known now."""
        if "samples" in self.__dict__:
            self.fill(self.samples.env)
        self.__dict__.pop("other_arms", None)

    def read(self, text: str, extra: Collection[str]) -> Expr:
        """Read a formula whose letters may be entries of matrices, as in R36[3,3]."""
        self.meet_signs(text)
        extra = {*extra, *self.definitions}
        text, letters = pick_letters(text, self.model.n, frozenset(self.matrices))
        new = {name: letter for name, letter in letters.items() if name not in self.letters}
        for letter in list(new.values()):
            new = {**neighbours(letter), **new}
        if new:
            self.letters.update(new)
            if "samples" in self.__dict__:
                self.pick(self.samples.env, self.samples.frames)
            self.__dict__.pop("other_arms", None)
        return self.model.parse(text, {*extra, *self.letters})

    def read_equation(self, text: str, extra: Collection[str]) -> tuple[Expr, Expr]:
        """Read both sides of an equation."""
        self.meet_signs(text)
        text, _ = pick_letters(text, self.model.n, frozenset(self.matrices))
        if text.count("=") != 1:
            return parse_equation(text, {*self.model.names(), *self.definitions, *extra}, self.model.n)
        known = {*self.definitions, *extra}
        left, right = text.split("=")
        return self.read(left, known), self.read(right, known)

    def picks(self, node: Expr) -> set[str]:
        """The letters of a formula that are entries of matrices."""
        return node.substitute(self.definitions).symbols() & set(self.letters)

    def pick(self, env: dict[str, np.ndarray], frames: dict[str, np.ndarray]) -> None:
        """Add the letters that are entries of matrices to an environment, and the file's matrices to the frames."""
        shape = env["theta1"].shape
        own = set(self.matrices)
        used = {name: own & {f.name for f in factors_of(letter.product)} for name, letter in self.letters.items()}
        self._pick_letters([name for name in used if not used[name]], env, frames)
        done = set[str]()
        for name, rows in self.matrices.items():
            M = np.empty((*shape, len(rows), len(rows[0])))
            for i, row in enumerate(rows):
                for j, cell in enumerate(row):
                    M[..., i, j] = cell.evaluate(env)
            frames[name] = M
            done.add(name)
            self._pick_letters([k for k, by in used.items() if name in by and by <= done], env, frames)

    def _pick_letters(self, names: list[str], env: dict[str, np.ndarray], frames: dict[str, np.ndarray]) -> None:
        for name in names:
            try:
                env[name] = self.letters[name].value(frames)
            except (InputError, np.linalg.LinAlgError):
                env[name] = np.full(env["theta1"].shape, np.nan)  # a neighbour of what was asked for may not exist

    def parse(self, text: str, where: Mapping[str, Any] | None = None, key: str = "is") -> Expr:
        """Read a formula.

        Args:
            text: the formula.
            where: definitions of its claim alone, which go into the formula itself.
            key: the key it stands under, for messages.
        """
        local = self.local(where or {})
        with under(key):
            return self.read(text, {*self.definitions, *local}).substitute(local)

    def product(self, claim: Claim, key: str, default: str = "T") -> Product:
        """Read the product of matrices under a key of a claim."""
        with under(key):
            return parse_product(str(claim.get(key, default)), self.model.n, frozenset(self.matrices))

    def frame(self, claim: Claim) -> Product | None:
        """The frame whose letters a claim uses, a whole matrix; None for the pose itself."""
        if "frame" not in claim:
            return None
        frame = self.product(claim, "frame")
        with under("frame"):
            if value_of(frame, self.samples.frames).shape[1:] != (4, 4):
                raise InputError(
                    f"{claim['frame']!r} must be a whole pose such as T03, for its letters are n, o, a, P", key="frame"
                )
        return frame

    @property
    def own_names(self) -> tuple[str, ...]:
        """Symbols beside lengths and angles: those of the file, and the sliding joints."""
        return (
            *(name for name in self.model.aliases if name[0] == "b" or name not in self.model.values),
            *self.definitions,
        )

    @cached_property
    def samples(self) -> Samples:
        """Joint vectors and everything that follows from them."""
        return self.draw()

    def draw(self, count: int = 96, *, seed: int = 20_24, vary: Mapping[str, str] | None = None) -> Samples:
        """Draw joint vectors that meet the claim's conditions, see `samples.sample`."""
        parts: list[Samples] = []
        found = 0
        for attempt in range(DRAWS):
            start, zeros = seed + 7919 * attempt, self.varied_zeros
            drawn = sample(self.model, count, seed=start, vary=vary, held=self.held, zeros=zeros)
            self.pick(drawn.env, drawn.frames)
            self.fill(drawn.env)
            if not self.when:
                return drawn
            part = some(drawn, np.logical_and.reduce([c.met(drawn.env) for c in self.when]))
            parts.append(part)
            found += len(part.q)
            if found >= count:
                break
        out = joined(parts)
        if min(out.nominal.sum(), (~out.nominal).sum() if vary is None else count) < count // 8:
            words = " and ".join(c.text for c in self.when)
            raise InputError(
                f"when: {words} is met by {found} of {count * DRAWS} joint vectors, too few to judge by", key="when"
            )
        return out

    def on(self, samples: Samples) -> Evidence:
        """The same arm and claim at other joint vectors."""
        out = replace(self)
        out.__dict__["samples"] = samples
        return out

    def drawn(self, count: int, seed: int, vary: Mapping[str, str] | None = None) -> Evidence:
        """The same arm and claim at fresh joint vectors."""
        return self.on(self.draw(count, seed=seed, vary=vary))

    def holding(self, claim: Claim) -> Evidence:
        """Return evidence that meets a claim's at_deg = { theta5 = 0 } and when = "s5 > 0"; itself without these."""
        at, when = claim.get("at_deg"), claim.get("when")
        if not at and not when:
            return self
        held = {}
        for name, degrees in (at or {}).items():
            joint = name.removeprefix("theta").removeprefix("q")
            if not (joint.isascii() and joint.isdigit()) or not 1 <= int(joint[:3]) <= self.model.n:
                raise InputError(
                    f"at_deg: {name!r} is no joint of this arm; write theta1 .. theta{self.model.n}", key="at_deg"
                )
            held[int(joint)] = float(degrees) if self.model.sliding(int(joint)) else float(np.radians(float(degrees)))
        conditions = read_conditions(str(when), lambda text: self.parse(text, claim.where, "when")) if when else ()
        return replace(self, held=held, when=conditions)

    def fill(self, env: dict) -> None:
        """Add the file's symbols to an environment."""
        rng = np.random.default_rng(11)
        shape = env["theta1"].shape
        for name in self.unknown:
            # a symbol nobody defines may have any value, so it gets another one at every sample
            env[f"{name}?"] = rng.uniform(0.1, 1.0, shape) * self.model.length()
        with np.errstate(all="ignore"):
            for name, tree in self.definitions.items():
                env[name] = np.broadcast_to(np.asarray(tree.evaluate(env), dtype=float), shape)

    def environment(self, frame: Product | None = None) -> dict[str, np.ndarray]:
        """Return the samples' symbols; the pose letters are those of another frame (such as T03) when one is given."""
        if frame is None:
            return self.samples.env
        env = {**self.samples.env, **pose_symbols(value_of(frame, self.samples.frames))}
        self.fill(env)
        return env

    @cached_property
    def other_arms(self) -> list[tuple[str, str, Samples]]:
        """(kind, words, samples) with the same joint vectors and lengths for the arms one slip away."""
        return list(self.arms(arm_slips(self.model)))

    def arms(self, others: Iterator[tuple[str, str, ArmModel]]) -> Iterator[tuple[str, str, Samples]]:
        """The same joint vectors and lengths for other arms, with what is said of them."""
        return ((kind, words, self._as(model)) for kind, words, model in others)

    def _as(self, model: ArmModel) -> Samples:
        """The samples of another arm at the same joint vectors and lengths."""
        base = self.samples
        env = {k: base.env[k] for k in base.env if k.startswith("theta") or k in model.values or k in model.aliases}
        frames = model.frames(env)
        env.update(pose_symbols(frames["T"]))
        self.pick(env, frames)
        self.fill(env)
        return Samples(base.q, env, frames, base.nominal)

    def solutions_at(self, k: int) -> np.ndarray:
        """Return all solutions (m, n) of the pose of sample k in the claims' units, before limits.

        Raises:
            PieperError: What the solver raises, or its solutions do not hold.
        """
        rows = self.in_unit(self.solved(self.samples.frames["T"][k], "pose"))
        if not len(rows) or self.apart(rows, self.samples.q[k]).max(1).min() > EVIDENCE_SAME:
            raise PieperError("the solver does not return the joints the pose was made from")
        back = pose_of(self.model, rows)
        if np.abs(back - self.samples.frames["T"][k]).max() > EVIDENCE_BACK * max(1.0, self.model.length()):
            raise PieperError("the solver returns joints that do not close under forward kinematics")
        return rows

    def solved(self, T: np.ndarray, task: str | None = None) -> np.ndarray:
        """Return all solutions (m, n), rad or m, of a pose in the arm's unit, before limits."""
        if self.model.solver is None:
            raise PieperError("this arm's table cannot be given to the solver")
        T = T.copy()
        T[:3, 3] *= UNITS[self.model.unit]
        return self.model.solver.solutions(T, task)

    def in_unit(self, rows: np.ndarray) -> np.ndarray:
        """Return solver rows (SI) with sliding joints in the unit of the claims."""
        out = rows.copy()
        for joint in range(1, self.model.n + 1):
            if self.model.sliding(joint):
                out[:, joint - 1] /= UNITS[self.model.unit]
        return out

    def apart(self, rows: np.ndarray, q: np.ndarray) -> np.ndarray:
        """How far joint vectors (m, n) are from another (n,), whole turns apart counting as equal."""
        gap = rows - q
        turns = np.array([not self.model.sliding(j + 1) for j in range(self.model.n)])
        return np.abs(np.where(turns, wrapped(gap), gap))

    def at(self, k: int) -> str:
        """Write the joint vector of sample k."""
        parts = []
        for joint in range(1, self.model.n + 1):
            value = self.samples.q[k, joint - 1]
            parts.append(f"{value:g} {self.model.unit}" if self.model.sliding(joint) else f"{np.degrees(value):g}")
        return "joints (" + ", ".join(parts) + ") deg"

    def extra_lengths(self, k: int, node: Expr) -> str:
        """Write the lengths of sample k where they are not the arm's own."""
        if self.samples.nominal[k]:
            return ""
        used = node.substitute(self.definitions).symbols() | self.varied_zeros
        names = [m for m in self.model.values if m in used]
        if not names or used & {pose[0] for pose in POSE_NAMES} or used & set(self.letters):  # all have a share in it
            names = [m for m, own in self.model.values.items() if self.samples.env[m][k] != own]
        return " with " + ", ".join(f"{m} = {self.samples.env[m][k]:g}" for m in names)

    def goal(self, wanted: np.ndarray | None, *, angle: bool = False, frame: Product | None = None) -> Goal:
        """Make the goal of a slip search from the samples."""
        return Goal(self.environment(frame), wanted, angle, FLOOR_OF_SEARCH * max(1.0, self.model.length()))


@contextmanager
def under(words: str, key: str = "") -> Iterator[None]:
    """Put where something stands in front of what is wrong with it: a key (`key`), and perhaps a name under it."""
    own = {"key": key or words}
    try:
        yield
    except FormulaError as error:
        raise FormulaError(f"{words}: {error}", **{**own, **error.data}) from None
    except InputError as error:
        raise InputError(f"{words}: {error}", **{**own, **error.data}) from None
    except np.linalg.LinAlgError:
        raise InputError(f"{words}: a matrix that is inverted here has no inverse", **own) from None


def wrapped(x: Any) -> Any:
    """Return angles in [-pi, pi)."""
    with np.errstate(invalid="ignore"):
        return short_way(x)


def number(value: float) -> str:
    """Write a number with the digits a reader needs."""
    return f"{0.0 if abs(value) < SHOWN_ZERO else value:.6g}"
