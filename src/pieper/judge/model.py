"""The arm as the judge sees it: DH rows as expressions, evaluated by a plain product of matrices, the slow way on
purpose.

The judge does not use the solver's own kinematics: a claim and its judge must not share a mistake.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from pieper.algebra.parser import parse
from pieper.algebra.tree import NUMPY, Node, add, evaluate, mul, negated, num, rebuilt, sym

POSE_NAMES = [(a + b, i, j) for j, a in enumerate("noap") for i, b in enumerate("xyz")]
POSE_NAMES += [("P" + b, i, 3) for i, b in enumerate("xyz")]
POSE_NAMES += [(f"r{i + 1}{j + 1}", i, j) for i in range(3) for j in range(4)]
AXES = "xyz"


@dataclass(frozen=True)
class Row:
    """A DH row as expressions; the joint's variable ``theta<i>`` stands in `theta` or, for sliding, in `d`."""

    a: Node
    alpha: Node
    d: Node
    theta: Node


@dataclass(frozen=True, eq=False)
class ArmModel:
    """An arm for judging.

    Attributes:
        name: what the arm is called.
        convention: "standard" or "modified".
        rows: one `Row` per joint.
        values: length symbols and their values, in `unit`.
        unit: unit of length of the values, "m" or "mm".
        base, tool: (4, 4) constant poses before the first and after the last row.
        limits: (n, 2) in rad or the unit of length, nan where nothing is known.
        solver: the `pieper.Arm` with the same rows (SI), or None; used only to ask for the other solutions of a pose.
        aliases: names of sliding variables, such as b3 -> theta3.
    """

    name: str
    convention: str
    rows: tuple[Row, ...]
    values: dict[str, float]
    unit: str = "m"
    base: np.ndarray = field(default_factory=lambda: np.eye(4))
    tool: np.ndarray = field(default_factory=lambda: np.eye(4))
    limits: np.ndarray | None = None
    solver: object = None
    aliases: dict[str, str] = field(default_factory=dict)

    @property
    def n(self) -> int:
        return len(self.rows)

    def sliding(self, joint: int) -> bool:
        """Say whether joint (1-based) slides."""
        return f"theta{joint}" in self.rows[joint - 1].d.symbols()

    def with_row(self, index: int, **columns: Node) -> ArmModel:
        """Return the arm with some columns of one row (0-based) replaced."""
        rows = list(self.rows)
        rows[index] = replace(rows[index], **columns)
        return replace(self, rows=tuple(rows))

    def names(self) -> set[str]:
        """Symbols a formula about this arm may use, besides the joints."""
        return set(self.values) | {p[0] for p in POSE_NAMES} | {"pi"}

    def between(self, name: str) -> tuple[ArmModel, int] | None:
        """Return the arm of joints i+1 .. j (numbered from 1) for the name Tij, and i; None for other names."""
        if len(name) != 3 or name[0] != "T" or not name[1:].isdigit() or name[1] >= name[2]:
            return None
        first, last = int(name[1]), int(name[2])
        new = {f"theta{k}": sym(f"theta{k - first}") for k in range(first + 1, last + 1)}
        rows = tuple(Row(*(renamed(c, new) for c in (r.a, r.alpha, r.d, r.theta))) for r in self.rows[first:last])
        return replace(self, rows=rows, base=np.eye(4), tool=np.eye(4), solver=None, aliases={}), first

    def length(self) -> float:
        """A typical length, in the arm's unit: what errors in position are compared with."""
        env = {**self.values, **{f"theta{i + 1}": 0.0 for i in range(self.n)}, "pi": np.pi}
        total = sum(abs(float(evaluate(c, env))) for r in self.rows for c in (r.a, r.d))
        return total + float(np.abs(self.tool[:3, 3]).sum() + np.abs(self.base[:3, 3]).sum()) or 1.0

    def links(self, env: dict, arithmetic=NUMPY) -> list:
        """Evaluate A_1 .. A_n as 4 by 4 nested lists of the arithmetic's numbers."""
        out, o, i = [], arithmetic.number("0"), arithmetic.number("1")
        for row in self.rows:
            a, alpha, d, theta = (evaluate(c, env, arithmetic) for c in (row.a, row.alpha, row.d, row.theta))
            ca, sa = _clean(arithmetic, row.alpha, alpha)
            ct, st = _clean(arithmetic, row.theta, theta)
            if self.convention == "standard":
                out.append(
                    [[ct, -st * ca, st * sa, a * ct], [st, ct * ca, -ct * sa, a * st], [o, sa, ca, d], [o, o, o, i]]
                )
            else:
                out.append(
                    [[ct, -st, o, a], [st * ca, ct * ca, -sa, -d * sa], [st * sa, ct * sa, ca, d * ca], [o, o, o, i]]
                )
        return out

    def frames(self, env: dict) -> dict[str, np.ndarray]:
        """Evaluate A1 .. An and the whole pose T (base and tool included), each (K, 4, 4), for sampled symbols."""
        links = self.links(env)
        count = max((np.size(v) for v in env.values()), default=1)
        out = {}
        whole = np.broadcast_to(self.base, (count, 4, 4))
        for k, link in enumerate(links):
            A = np.empty((count, 4, 4))
            for r in range(4):
                for c in range(4):
                    A[:, r, c] = link[r][c]
            out[f"A{k + 1}"] = A
            whole = whole @ A
        out["T"] = whole @ self.tool
        return out

    def pose_exact(self, env: dict, arithmetic) -> list:
        """Evaluate T with another arithmetic (50 digits, or symbols), as a 4 by 4 nested list."""
        product = _constant(self.base, arithmetic)
        for link in self.links(env, arithmetic):
            product = matmul(product, link)
        return matmul(product, _constant(self.tool, arithmetic))


def renamed(node: Node, new: dict[str, Node]) -> Node:
    """Replace symbols once, all at the same time."""
    if node.op == "sym":
        return new.get(node.value, node)
    return rebuilt(node, tuple(renamed(a, new) for a in node.args)) if node.args else node


def matmul(x: list, y: list) -> list:
    """Multiply nested lists of any numbers."""
    out = []
    for row in x:
        line = []
        for c in range(len(y[0])):
            total = row[0] * y[0][c]
            for k in range(1, len(row)):
                total = total + row[k] * y[k][c]
            line.append(total)
        out.append(line)
    return out


def _clean(arithmetic, node: Node, value):
    """Return cosine and sine, exact where a constant angle is a whole number of quarter turns."""
    if not node.symbols() - {"pi"}:
        quarter = float(evaluate(node, {"pi": np.pi})) / (np.pi / 2)
        if abs(quarter - round(quarter)) < 1e-12:
            c, s = [(1, 0), (0, 1), (-1, 0), (0, -1)][round(quarter) % 4]
            return arithmetic.number(str(c)), arithmetic.number(str(s))
    return arithmetic.cos(value), arithmetic.sin(value)


def _constant(T: np.ndarray, arithmetic) -> list:
    snapped = np.where(np.abs(T - np.round(T)) < 1e-13, np.round(T), T)
    return [[arithmetic.number(repr(float(v))) for v in row] for row in snapped]


def angle_node(value: float) -> Node:
    """Write an angle (rad) as an exact fraction of pi when it is a multiple of 15 degrees, otherwise as a number."""
    step = value / (np.pi / 12)
    if abs(step - round(step)) < 1e-10:
        return (
            num(0)
            if round(step) == 0
            else mul(num(round(step)), Node("div", (sym("pi"), num(12))))
            if round(step) > 0
            else negated(mul(num(-round(step)), Node("div", (sym("pi"), num(12)))))
        )
    return num(repr(float(value)))


def model_from_description(d, solver=None) -> ArmModel:
    """Read an arm description (SI units) into expressions; lengths become a1, d4, ... with the table's numbers as
    values."""
    rows, values = [], {}
    for i, row in enumerate(d.rows):
        at = i + 1 if d.convention == "standard" else i
        values[f"a{at}"] = row.a
        var = sym(f"theta{i + 1}")
        var = var if d.sign[i] > 0 else negated(var)
        theta, dd = angle_node(row.theta), sym(f"d{i + 1}")
        if d.joint_types[i] == "R":
            values[f"d{i + 1}"] = row.d
            shift = row.theta + float(d.offset[i])
            theta = add(var, angle_node(shift)) if abs(shift) > 1e-12 else var
        else:
            shift = row.d + float(d.offset[i])
            dd = add(var, num(repr(float(shift)))) if shift else var
        rows.append(Row(sym(f"a{at}"), angle_node(row.alpha), dd, theta))
    aliases = {f"{c}{i + 1}": f"theta{i + 1}" for i in range(d.n) if d.joint_types[i] == "P" for c in "db"}
    return ArmModel(
        d.name,
        d.convention,
        tuple(rows),
        values,
        "m",
        np.asarray(d.base),
        np.asarray(d.tool),
        np.asarray(d.limits),
        solver,
        aliases,
    )


@dataclass(frozen=True, eq=False)
class Samples:
    """Joint vectors at which claims are tried.

    Attributes:
        q: (K, n) in rad (or the unit of length), tenths of a degree so that a counter-example can be read and retyped.
        env: every symbol's values, (K,) each.
        frames: A1 .. An and T, (K, 4, 4).
        nominal: (K,) bool, True where the lengths are those of the arm, False where they were varied.
    """

    q: np.ndarray
    env: dict[str, np.ndarray]
    frames: dict[str, np.ndarray]
    nominal: np.ndarray


def sample(model: ArmModel, count: int = 96, *, seed: int = 20_24, vary: bool = True) -> Samples:
    """Draw joint vectors (and, in the second half, other lengths) and evaluate everything a formula can name.

    Args:
        model: the arm.
        count: number of joint vectors.
        seed: start of the generator; the same claims get the same counter-examples every time.
        vary: draw other values for the lengths in the second half, so that "identically" means for every arm of this
        build.

    Returns:
        The samples.
    """
    rng = np.random.default_rng(seed)
    n = model.n
    degrees = rng.integers(-1799, 1800, size=(count, n))
    degrees += (degrees % 50 == 0).astype(int)
    q = np.radians(degrees / 10)
    scale = model.length() / max(n, 1)
    for joint in range(1, n + 1):
        if model.sliding(joint):
            q[:, joint - 1] = np.round(rng.uniform(0.2, 1.5, count) * scale, 3)
    return evaluate_samples(model, q, rng=rng if vary else None)


def evaluate_samples(model: ArmModel, q: np.ndarray, *, rng=None) -> Samples:
    """Evaluate lengths, pose and frames at given joint vectors; see `sample`."""
    count = len(q)
    nominal = np.ones(count, dtype=bool)
    env: dict[str, np.ndarray] = {"pi": np.full(count, np.pi)}
    if rng is not None:
        nominal[count // 2 :] = False
    for name, value in model.values.items():
        env[name] = np.full(count, float(value))
        if rng is not None:
            env[name][count // 2 :] *= np.round(rng.uniform(0.7, 1.4, count - count // 2), 3)
    for joint in range(1, model.n + 1):
        env[f"theta{joint}"] = q[:, joint - 1]
    for alias, target in model.aliases.items():
        env[alias] = env[target]
    frames = model.frames(env)
    env.update(pose_symbols(frames["T"]))
    return Samples(q, env, frames, nominal)


def pose_symbols(T: np.ndarray) -> dict[str, np.ndarray]:
    """Name the entries of poses (K, 4, 4): nx .. az, px, Px, r11 .. r34."""
    return {name: T[:, i, j] for name, i, j in POSE_NAMES}


def parse_for(model: ArmModel, text: str, extra=()) -> Node:
    """Read a formula about this arm; `extra` are symbols defined in the claims file."""
    node = parse(text, model.names() | set(extra) | set(model.aliases), model.n)
    return node
