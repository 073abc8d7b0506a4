"""What every judge of a claim works with: the arm, its sampled poses, the file's own symbols, and the words for a
counter-example."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from pieper.algebra.tree import NUMPY, Node, evaluate, substitute, sym
from pieper.errors import InputError, PieperError
from pieper.judge.matrices import value_of
from pieper.judge.model import ArmModel, Samples, evaluate_samples, parse_for, pose_symbols, sample
from pieper.judge.search.search import Explanation, Target
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
    definitions: dict[str, Node] = field(default_factory=dict)
    seconds: float = 2.0
    unknown: list[str] = field(default_factory=list)

    def define(self, name: str, text: str):
        """Add a symbol of the file; "?" marks one that the source uses and never defines."""
        name = plain(name)
        if name in self.model.names() or name in self.model.aliases:
            raise InputError(
                f"the symbol {name!r} already means something for this arm; choose another name", symbol=name
            )
        if str(text).strip() == "?":
            self.unknown.append(name)
            self.definitions[name] = sym(f"{name}?")
            return
        self.definitions[name] = substitute(self.parse(str(text)), self.definitions)

    def parse(self, text: str, where: dict | None = None) -> Node:
        """Read a formula; `where` holds definitions of its claim alone, which go into the formula itself."""
        local: dict[str, Node] = {}
        for name, body in (where or {}).items():
            local[plain(name)] = substitute(parse_for(self.model, str(body), set(self.definitions) | set(local)), local)
        node = parse_for(self.model, text, set(self.definitions) | set(local))
        return substitute(node, local) if local else node

    @cached_property
    def samples(self) -> Samples:
        """Joint vectors and everything that follows from them."""
        out = sample(self.model)
        self.fill(out.env)
        return out

    def holding(self, claim: dict) -> Evidence:
        """Return evidence in which some joints are held, as the claim's at_deg = { theta5 = 0 } says; itself without
        that key."""
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
        fixed = evaluate_samples(self.model, q, rng=np.random.default_rng(20_24))
        out.fill(fixed.env)
        out.__dict__["samples"] = fixed
        return out

    def fill(self, env: dict):
        """Add the file's symbols to an environment."""
        rng = np.random.default_rng(11)
        for name in self.unknown:
            # a symbol nobody defines may have any value, so it gets another one at every sample
            env[f"{name}?"] = rng.uniform(0.1, 1.0, env["pi"].shape) * self.model.length()
        with np.errstate(all="ignore"):
            for name, tree in self.definitions.items():
                env[name] = np.broadcast_to(np.asarray(evaluate(tree, env, NUMPY), dtype=float), env["pi"].shape)

    def environment(self, frame=None, samples: Samples | None = None) -> dict:
        """Return the samples' symbols, the pose letters taken from another frame (a product, such as T03) when one is
        given."""
        samples = samples or self.samples
        if frame is None:
            return samples.env
        env = {**samples.env, **pose_symbols(value_of(frame, samples.frames))}
        self.fill(env)
        return env

    @cached_property
    def other_arms(self) -> list[tuple[str, str, Samples]]:
        """(kind, words, samples) with the same joint vectors and lengths for the arms one slip away."""
        base, out = self.samples, []
        for kind, words, model in arm_slips(self.model):
            env = {
                k: base.env[k]
                for k in base.env
                if k.startswith("theta") or k in model.values or k in model.aliases or k == "pi"
            }
            frames = model.frames(env)
            env.update(pose_symbols(frames["T"]))
            self.fill(env)
            out.append((kind, words, Samples(base.q, env, frames, base.nominal)))
        return out

    def solutions_at(self, k: int) -> np.ndarray:
        """Return all solutions of the pose of sample k, (m, n), before limits; raises what the solver raises."""
        T = self.samples.frames["T"][k].copy()
        T[:3, 3] *= 0.001 if self.model.unit == "mm" else 1.0
        rows = np.asarray(self.model.solver.ik(T).all_q)
        if not len(rows) or np.abs((rows - self.samples.q[k] + np.pi) % (2 * np.pi) - np.pi).max(1).min() > 1e-4:
            raise PieperError("the solver does not return the joints the pose was made from")
        back = fresh_samples(self.model, self.in_unit(rows)).frames["T"]
        if np.abs(back - self.samples.frames["T"][k]).max() > 1e-6 * max(1.0, self.model.length()):
            raise PieperError("the solver returns joints that do not close under forward kinematics")
        return rows

    def in_unit(self, rows: np.ndarray) -> np.ndarray:
        """Return solver rows (SI) with sliding joints in the unit of the claims."""
        out = rows.copy()
        for joint in range(1, self.model.n + 1):
            if self.model.sliding(joint) and self.model.unit == "mm":
                out[:, joint - 1] *= 1000
        return out

    def at(self, k: int, samples: Samples | None = None) -> str:
        """Write the joint vector of sample k."""
        samples = samples or self.samples
        parts = []
        for joint in range(1, self.model.n + 1):
            value = samples.q[k, joint - 1]
            parts.append(f"{value:g} {self.model.unit}" if self.model.sliding(joint) else f"{np.degrees(value):g}")
        return "joints (" + ", ".join(parts) + ") deg"

    def extra_lengths(self, k: int, node: Node) -> str:
        """Write the lengths of sample k where they are not the arm's own."""
        if self.samples.nominal[k]:
            return ""
        names = [m for m in self.model.values if m in node.symbols()]
        return " with " + ", ".join(f"{m} = {self.samples.env[m][k]:g}" for m in names)

    def target(self, wanted, *, angle=False, frame=None, rows=None) -> Target:
        """Make the target of a slip search from the samples."""
        env = self.environment(frame)
        out = Target(env, wanted, angle, 1e-3 * max(1.0, self.model.length()))
        return out if rows is None else out.restrict(rows)


def plain(name: str) -> str:
    """Return a symbol's name as formulas hold it, without the marks of subscripts."""
    return name.translate(str.maketrans("", "", "_{}"))


def tried_text(explanation: Explanation, arms_tried: dict[str, int] | None = None) -> str:
    """Say what a search tried, by kind."""
    parts = [f"{KINDS.get(kind, kind)} ({count})" for kind, count in explanation.tried.items()]
    parts += [f"{ARM_KINDS.get(kind, kind)} ({count})" for kind, count in (arms_tried or {}).items()]
    text = ", ".join(parts)
    return text + ("" if explanation.complete else "; the search stopped at its limit of time or length")


def fresh_samples(model: ArmModel, q: np.ndarray) -> Samples:
    """Evaluate an arm at given joint vectors, lengths as they are."""
    return evaluate_samples(model, np.atleast_2d(np.asarray(q, dtype=float)))


def number(value: float) -> str:
    """Write a number with the digits a reader needs."""
    return f"{0.0 if abs(value) < 1e-11 else value:.6g}"
