"""The arm as the judge sees it: DH rows as expressions and a plain product of matrices, the slow way on purpose.

The judge does not use the solver's own kinematics: a claim and its judge must not share a mistake.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any

import numpy as np

from pieper.algebra.arithmetics import NumpyField
from pieper.algebra.exact import pi_fraction
from pieper.algebra.expression import Add, Expr, PiFraction
from pieper.algebra.formula import Mention, Neg, number
from pieper.algebra.parser import parse
from pieper.description.coupling import moved_by
from pieper.description.dh import Description
from pieper.judge.solver import Solver
from pieper.tolerances import ROUNDING, UNROUNDED

POSE_NAMES = [(a + b, i, j) for j, a in enumerate("noap") for i, b in enumerate("xyz")]
POSE_NAMES += [("P" + b, i, 3) for i, b in enumerate("xyz")]
POSE_NAMES += [(f"r{i + 1}{j + 1}", i, j) for i in range(3) for j in range(4)]
QUARTERS = ((1, 0), (0, 1), (-1, 0), (0, -1))  # cosine and sine of whole quarter turns

Matrix = list[list[Any]]


@dataclass(frozen=True, eq=False)
class Row:
    """A DH row as expressions; the joint's variable ``theta<i>`` stands in `theta` or, for sliding, in `d`.

    Constant rows of a table, such as a gripper's, belong to the joint above them; those above the first joint to it.
    """

    a: Expr
    alpha: Expr
    d: Expr
    theta: Expr
    before: tuple[Row, ...] = ()
    after: tuple[Row, ...] = ()

    @property
    def cells(self) -> tuple[Expr, ...]:
        """The row's own four cells."""
        return self.a, self.alpha, self.d, self.theta

    def renamed(self, new: dict[str, Expr]) -> Row:
        """The row with symbols replaced."""
        a, alpha, d, theta = (cell.substitute(new) for cell in self.cells)
        return Row(a, alpha, d, theta, self.before, self.after)


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
        solver: solves the same rows (SI), or None; used only to ask for the other solutions of a pose.
        aliases: names of sliding variables, such as b3 -> theta3.
        zeros: the source's own length symbols that are zero for this arm, as e1 in a table with values = { e1 = 0 }.
        remark: what the angles of a page mean where that is not plain, a sentence.
    """

    name: str
    convention: str
    rows: tuple[Row, ...]
    values: dict[str, float]
    unit: str = "m"
    base: np.ndarray = field(default_factory=lambda: np.eye(4))
    tool: np.ndarray = field(default_factory=lambda: np.eye(4))
    solver: Solver | None = None
    aliases: dict[str, str] = field(default_factory=dict)
    zeros: frozenset[str] = frozenset()
    remark: str = ""

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.rows)

    @property
    def at_zero(self) -> dict[str, float]:
        """Every symbol of the table with all joints at zero."""
        return {**self.values, **{f"theta{i + 1}": 0.0 for i in range(self.n)}}

    def sliding(self, joint: int) -> bool:
        """Say whether joint (1-based) slides."""
        return f"theta{joint}" in self.rows[joint - 1].d.symbols()

    def sense(self, joint: int) -> float:
        """How the cell that moves goes with the value of joint (1-based): -1 where the table has -q."""
        row = self.rows[joint - 1]
        cell = row.d if self.sliding(joint) else row.theta
        zero = self.at_zero
        return float(cell.evaluate({**zero, f"theta{joint}": 1.0})) - float(cell.evaluate(zero))

    def with_row(self, index: int, **columns: Expr) -> ArmModel:
        """Return the arm with some columns of one row (0-based) replaced."""
        rows = list(self.rows)
        rows[index] = replace(rows[index], **columns)
        return replace(self, rows=tuple(rows))

    def names(self) -> set[str]:
        """Symbols a formula about this arm may use, besides the joints."""
        return set(self.values) | {p[0] for p in POSE_NAMES} | set(self.aliases) | {"pi", "roll", "pitch", "yaw"}

    def parse(self, text: str, extra: Collection[str] = ()) -> Expr:
        """Read a formula about this arm; `extra` are symbols defined in the claims file."""
        return parse(text, self.names() | set(extra), self.n)

    def between(self, name: str) -> tuple[ArmModel, int] | None:
        """Return the arm of joints i+1 .. j (numbered from 1) for the name Tij, and i; None for other names."""
        if len(name) != 3 or name[0] != "T" or not name[1:].isdigit() or name[1] >= name[2]:
            return None
        first, last = int(name[1]), int(name[2])
        new: dict[str, Expr] = {f"theta{k}": Mention(f"theta{k - first}") for k in range(first + 1, last + 1)}
        rows = tuple(r.renamed(new) for r in self.rows[first:last])
        return replace(self, rows=rows, base=np.eye(4), tool=np.eye(4), solver=None, aliases={}), first

    def length(self) -> float:
        """A typical length, in the arm's unit: what errors in position are compared with."""
        every = [r for row in self.rows for r in (*row.before, row, *row.after)]
        total = sum(abs(float(c.evaluate(self.at_zero))) for r in every for c in (r.a, r.d))
        return total + float(np.abs(self.tool[:3, 3]).sum() + np.abs(self.base[:3, 3]).sum()) or 1.0

    def links(self, env: dict, arithmetic: Any = NumpyField) -> list[Matrix]:
        """Evaluate A_1 .. A_n as 4 by 4 nested lists of the arithmetic's numbers, constant rows included."""
        out = []
        for row in self.rows:
            link, *rest = [self._link(r, env, arithmetic) for r in (*row.before, row, *row.after)]
            for more in rest:
                link = _matmul(link, more)
            out.append(link)
        return out

    def _link(self, row: Row, env: dict, arithmetic: Any) -> Matrix:
        o, i = arithmetic.rational(Fraction(0)), arithmetic.rational(Fraction(1))
        a, d = row.a.evaluate(env, arithmetic), row.d.evaluate(env, arithmetic)
        ca, sa = _turn(row.alpha, env, arithmetic)
        ct, st = _turn(row.theta, env, arithmetic)
        if self.convention == "standard":
            return [[ct, -st * ca, st * sa, a * ct], [st, ct * ca, -ct * sa, a * st], [o, sa, ca, d], [o, o, o, i]]
        return [[ct, -st, o, a], [st * ca, ct * ca, -sa, -d * sa], [st * sa, ct * sa, ca, d * ca], [o, o, o, i]]

    def axis_frames(self, frames: dict[str, np.ndarray], env: dict) -> list[np.ndarray]:
        """For every joint the frame (K, 4, 4), seen from the one before it, whose z axis is the joint's.

        Args:
            frames: A1 .. An, (K, 4, 4) each.
            env: The symbols of the table at every sample.
        """
        count = len(frames["A1"])
        modified = self.convention == "modified"
        out = []
        for k, row in enumerate(self.rows):
            if row.before or row.after:
                frame = np.broadcast_to(np.eye(4), (count, 4, 4))
                for part in (*row.before, row) if modified else row.before:
                    frame = frame @ _stacked(self._link(part, env, NumpyField), count)
            else:
                frame = frames[f"A{k + 1}"] if modified else np.broadcast_to(np.eye(4), (count, 4, 4))
            out.append(frame)
        return out

    def frames(self, env: dict) -> dict[str, np.ndarray]:
        """Evaluate A1 .. An and the whole pose T (base and tool included), each (K, 4, 4), for sampled symbols.

        J is the geometric Jacobian (K, 6, n) in the base frame, linear rows first.
        """
        count = max((np.size(v) for v in env.values()), default=1)
        out: dict[str, np.ndarray] = {}
        whole = np.broadcast_to(self.base, (count, 4, 4))
        before = [whole]
        for k, link in enumerate(self.links(env)):
            out[f"A{k + 1}"] = _stacked(link, count)
            whole = whole @ out[f"A{k + 1}"]
            before.append(whole)
        out["T"] = whole @ self.tool
        out["J"] = np.zeros((count, 6, self.n))
        for k, axis in enumerate(self.axis_frames(out, env)):
            frame = before[k] @ axis
            z, arm = self.sense(k + 1) * frame[:, :3, 2], out["T"][:, :3, 3] - frame[:, :3, 3]
            # a turning joint moves the tool by z x (p - o) and turns it about z; a sliding one moves it along z
            if self.sliding(k + 1):
                out["J"][:, :3, k] = z
            else:
                out["J"][:, :3, k], out["J"][:, 3:, k] = np.cross(z, arm), z
        return out

    def pose_exact(self, env: dict, arithmetic: Any) -> Matrix:
        """Evaluate T with another arithmetic (50 digits, or symbols), as a 4 by 4 nested list."""
        product = _constant(self.base, arithmetic)
        for link in (*self.links(env, arithmetic), _constant(self.tool, arithmetic)):
            product = _matmul(product, link)
        return product


def _stacked(link: Matrix, count: int) -> np.ndarray:
    """A nested list of samples as one array (K, 4, 4)."""
    A = np.empty((count, 4, 4))
    for r in range(4):
        for c in range(4):
            A[:, r, c] = link[r][c]
    return A


def _matmul(x: Matrix, y: Matrix) -> Matrix:
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


def _turn(angle: Expr, env: dict, arithmetic: Any) -> tuple[Any, Any]:
    """Return cosine and sine, exact where a constant angle is a whole number of quarter turns."""
    if not angle.symbols():
        quarter = float(angle.evaluate({})) / (np.pi / 2)
        if abs(quarter - round(quarter)) < ROUNDING:
            c, s = QUARTERS[round(quarter) % 4]
            return arithmetic.rational(Fraction(c)), arithmetic.rational(Fraction(s))
    value = angle.evaluate(env, arithmetic)
    return arithmetic.cos(value), arithmetic.sin(value)


def decimal(value: float) -> Fraction:
    """The number as its shortest decimal says it."""
    return Fraction(repr(float(value)))


def _constant(T: np.ndarray, arithmetic: Any) -> Matrix:
    snapped = np.where(np.abs(T - np.round(T)) < UNROUNDED, np.round(T), T)
    return [[arithmetic.rational(decimal(v)) for v in row] for row in snapped]


def _angle(value: float) -> Expr:
    """Write an angle (rad) as a fraction of pi when it is one, otherwise as a number."""
    multiple = pi_fraction(value)
    return number(repr(float(value))) if multiple is None else PiFraction(multiple) if multiple else number(0)


def model_from_description(d: Description, solver: Solver | None = None) -> ArmModel:
    """Read an arm description (SI units) into expressions; lengths become a1, d4, ..., the table's numbers values.

    Joints that are coupled are read as the axes, each moving by itself, which `solver` solves; the remark says so.
    """
    remark, d = _coupled_in_words(d), d.by_axes()
    rows, values = [], {}
    for i, row in enumerate(d.rows):
        at = i + 1 if d.convention == "standard" else i
        values[f"a{at}"] = row.a
        joint: Expr = Mention(f"theta{i + 1}")
        joint = joint if d.sign[i] > 0 else Neg(joint)
        theta, slide = _angle(row.theta), Mention(f"d{i + 1}")
        if d.joint_types[i] == "R":
            values[f"d{i + 1}"] = row.d
            shift = row.theta + float(d.offset[i])
            theta = Add.of(joint, _angle(shift)) if abs(shift) > ROUNDING else joint
        else:
            shift = row.d + float(d.offset[i])
            slide = Add.of(joint, number(repr(float(shift)))) if shift else joint
        rows.append(Row(Mention(f"a{at}"), _angle(row.alpha), slide, theta))
    aliases = {f"{c}{i + 1}": f"theta{i + 1}" for i in range(d.n) if d.joint_types[i] == "P" for c in "db"}
    base, tool = np.asarray(d.base), np.asarray(d.tool)
    return ArmModel(d.name, d.convention, tuple(rows), values, "m", base, tool, solver, aliases, remark=remark)


def _coupled_in_words(d: Description) -> str:
    """Say what theta stands for where joints are coupled; nothing where they are not."""
    if d.coupling is None:
        return ""
    numbers = [f"q{j + 1}" for j in range(d.coupling.shape[1])]
    said = [f"{moved_by(row, numbers)}" for row in d.coupling]
    moved = [f"theta{i + 1} = {text}" for i, text in enumerate(said) if text != f"q{i + 1}"]
    return (
        "Its joints are coupled: theta1, theta2 .., q_deg and solutions_deg are judged as the values of the axes, each "
        f"turning by itself, and not as the maker's numbers q1, q2 .. ({', '.join(moved)})."
    )
