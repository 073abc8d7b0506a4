"""What every judge of a claim works with: the arm, its samples, the file's own symbols, words for a counter-example."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from pieper.algebra.expression import Expr
from pieper.algebra.formula import Mention
from pieper.errors import InputError, PieperError
from pieper.judge.claim import Claim
from pieper.judge.matrices import Product, value_of
from pieper.judge.model import ArmModel
from pieper.judge.numbers import UNITS
from pieper.judge.samples import Samples, pose_of, pose_symbols, sample, samples_at
from pieper.judge.search.search import Explanation, Goal
from pieper.judge.slips.arm_slips import ARM_KINDS, arm_slips
from pieper.judge.slips.slip import KINDS

SOLVER_POSES = 10  # poses at which the other solutions are asked for


@dataclass
class Evidence:
    """One arm, its samples and the symbols of the claims file.

    Attributes:
        model: the arm.
        definitions: symbols of the file, each a formula; they may use one another.
        seconds: time the slip search may take per claim.
    """

    model: ArmModel
    definitions: dict[str, Expr] = field(default_factory=dict)
    seconds: float = 2.0
    unknown: list[str] = field(default_factory=list)

    def define(self, name: str, text: str) -> None:
        """Add a symbol of the file; "?" marks one that the source uses and never defines."""
        name = plain(name)
        if name in self.model.names():
            raise InputError(
                f"the symbol {name!r} already means something for this arm; choose another name", symbol=name
            )
        if str(text).strip() == "?":
            self.unknown.append(name)
            self.definitions[name] = Mention(f"{name}?")
            return
        self.definitions[name] = self.parse(str(text)).substitute(self.definitions)

    def local(self, where: Mapping[str, Any]) -> dict[str, Expr]:
        """Read definitions that belong to one claim alone; later ones may use earlier ones."""
        local: dict[str, Expr] = {}
        for name, body in where.items():
            local[plain(name)] = self.model.parse(str(body), {*self.definitions, *local}).substitute(local)
        return local

    def parse(self, text: str, where: Mapping[str, Any] | None = None) -> Expr:
        """Read a formula; `where` holds definitions of its claim alone, which go into the formula itself."""
        local = self.local(where or {})
        return self.model.parse(text, {*self.definitions, *local}).substitute(local)

    @cached_property
    def samples(self) -> Samples:
        """Joint vectors and everything that follows from them."""
        out = sample(self.model)
        self.fill(out.env)
        return out

    def holding(self, claim: Claim) -> Evidence:
        """Return evidence in which joints are held as the claim's at_deg = { theta5 = 0 } says; itself without it."""
        held = claim.get("at_deg")
        if not held:
            return self
        q = self.samples.q.copy()
        for name, degrees in held.items():
            joint = name.removeprefix("theta").removeprefix("q")
            if not joint.isdigit() or not 1 <= int(joint) <= self.model.n:
                raise InputError(f"at_deg: {name!r} is no joint of this arm; write theta1 .. theta{self.model.n}")
            q[:, int(joint) - 1] = np.radians(float(degrees))
        out = Evidence(self.model, self.definitions, self.seconds, self.unknown)
        fixed = samples_at(self.model, q, rng=np.random.default_rng(20_24))
        out.fill(fixed.env)
        out.__dict__["samples"] = fixed
        return out

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
        base, out = self.samples, []
        for kind, words, model in arm_slips(self.model):
            env = {k: base.env[k] for k in base.env if k.startswith("theta") or k in model.values or k in model.aliases}
            frames = model.frames(env)
            env.update(pose_symbols(frames["T"]))
            self.fill(env)
            out.append((kind, words, Samples(base.q, env, frames, base.nominal)))
        return out

    def solutions_at(self, k: int) -> np.ndarray:
        """Return all solutions of the pose of sample k, (m, n), before limits; raises what the solver raises."""
        rows = self.solved(self.samples.frames["T"][k])
        if not len(rows) or np.abs(wrapped(rows - self.samples.q[k])).max(1).min() > 1e-4:
            raise PieperError("the solver does not return the joints the pose was made from")
        back = pose_of(self.model, self.in_unit(rows))
        if np.abs(back - self.samples.frames["T"][k]).max() > 1e-6 * max(1.0, self.model.length()):
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
        names = [m for m in self.model.values if m in node.symbols()]
        return " with " + ", ".join(f"{m} = {self.samples.env[m][k]:g}" for m in names)

    def goal(self, wanted: np.ndarray | None, *, angle: bool = False, frame: Product | None = None) -> Goal:
        """Make the goal of a slip search from the samples."""
        return Goal(self.environment(frame), wanted, angle, 1e-3 * max(1.0, self.model.length()))


def plain(name: str) -> str:
    """Return a symbol's name as formulas hold it, without the marks of subscripts."""
    return name.translate(str.maketrans("", "", "_{}"))


def tried_text(explanation: Explanation, arms_tried: dict[str, int] | None = None) -> str:
    """Say what a search tried, by kind."""
    parts = [f"{KINDS.get(kind, kind)} ({count})" for kind, count in explanation.tried.items()]
    parts += [f"{ARM_KINDS.get(kind, kind)} ({count})" for kind, count in (arms_tried or {}).items()]
    text = ", ".join(parts)
    return text + ("" if explanation.complete else "; the search stopped at its limit of time or length")


def wrapped(x: Any) -> Any:
    """Return angles in [-pi, pi)."""
    with np.errstate(invalid="ignore"):
        return (x + np.pi) % (2 * np.pi) - np.pi


def number(value: float) -> str:
    """Write a number with the digits a reader needs."""
    return f"{0.0 if abs(value) < 1e-11 else value:.6g}"
