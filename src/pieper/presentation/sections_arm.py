"""Sections about an arm itself: its table and drawing, its equations, its singularities, its reach."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pieper.description.dh import Description, Slid
from pieper.description.slid import with_short_rows
from pieper.document.blocks import Document, Emphasis, Equations, Lines, Note
from pieper.document.formulas import in_line
from pieper.drawing.style import MM, picture
from pieper.equations.lettering import in_letters
from pieper.equations.named_parts import broken_lines
from pieper.errors import PieperError
from pieper.kinematics.orientation import rpy_of
from pieper.presentation.plot_arm import arm_figure, postures_figure
from pieper.presentation.plot_reach import joint_range, reach_figure, reach_samples
from pieper.solver.families import named
from pieper.solver.words.explain import how_many
from pieper.tolerances import ROUNDING, TYPED_DIGITS
from pieper.words_by_number import plural

if TYPE_CHECKING:
    from collections.abc import Callable

    from pieper.presentation.arm import Arm


def fixed(value: float, digits: int = 3) -> str:
    """Return a number with at most so many digits, no trailing zeros, no negative zero, infinity as a sign."""
    if not np.isfinite(value):
        return "∞" if value > 0 else "−∞"
    text = f"{float(value):z.{digits}f}"
    text = text.rstrip("0").rstrip(".") if "." in text else text
    return text.replace("-", "−")


def joint_value(arm: Arm, joint: int, value: float, digits: int = 3) -> str:
    """Return a joint's value in degrees or millimetres, without the unit."""
    return fixed(np.degrees(value) if arm.joint_types[joint] == "R" else value * MM, digits)


def joint_heads(arm: Arm) -> list[str]:
    """Return one table heading a joint, with its unit."""
    return [
        f"{name},\u00a0{'°' if kind == 'R' else 'mm'}"
        for name, kind in zip(short_names(arm), arm.joint_types, strict=True)
    ]


def short_names(arm: Arm) -> list[str]:
    """Return q₁, q₂ ...: makers' names are too long for the heads of tables, and stand beside these in the DH table."""
    return ["q" + "".join(chr(0x2080 + int(c)) for c in str(i + 1)) for i in range(arm.n)]


def first_posture(arm: Arm) -> np.ndarray:
    """Return a posture (n,) that shows the arm well: a named one, else a bent one inside the limits."""
    for name in ("line-start", "home", "ready", "folded"):
        if name in arm.description.postures:
            return np.asarray(arm.description.postures[name], float)
    others = [q for name, q in arm.description.postures.items() if name != "zero" and np.any(q)]
    if others:
        return np.asarray(others[0], float)
    low, high = joint_range(arm)
    slide = np.array([kind == "P" for kind in arm.joint_types])
    bent = np.array([0.35, -0.6, 0.9, 0.4, 0.8, 0.3, -0.5] * 9)[: arm.n]
    return np.clip(np.where(slide, (low + high) / 2, bent), low, high)


def add_arm(page: Document, arm: Arm) -> None:
    """Add the arm: what it is, its DH table, its drawing, its postures."""
    d = arm.description
    kinds = {"R": "revolute", "P": "prismatic"}
    counts = [f"{arm.joint_types.count(k)} {kinds[k]}" for k in "RP" if k in arm.joint_types]
    maker = f", made by {d.manufacturer}" if d.manufacturer else ""
    convention = "standard (distal)" if d.convention == "standard" else "modified (proximal, Craig)"
    page.section("The arm")
    page.add(
        f"{arm.name}{maker}, has {plural(arm.n, 'joint')}, {' and '.join(counts)}. Its geometry is given by a "
        f"Denavit–Hartenberg table in the {convention} convention: "
        + (
            "frame i follows frame i−1 by a turn θ about z, a shift d along z, a shift a along the new x and a turn "
            "α about it."
            if d.convention == "standard"
            else "frame i follows frame i−1 by a shift a and a turn α along and about x, then a turn θ and a shift d "
            "about and along the new z; row i holds a and α of frame i−1."
        )
    )
    heads, rows = ["joint", "a, mm", "α, °", "d, mm", "θ, °", "least", "most"], []
    plain = np.all(d.sign > 0) and not np.any(d.offset)
    for i, row in enumerate(d.rows):
        revolute = arm.joint_types[i] == "R"
        cells = [fixed(row.a * MM), fixed(np.degrees(row.alpha)), fixed(row.d * MM), fixed(np.degrees(row.theta))]
        cells[3 if revolute else 2] = _variable(arm, i)
        unit = "°" if revolute else " mm"
        limits = [joint_value(arm, i, v, 2) + (unit if np.isfinite(v) else "") for v in d.limits[i]]
        rows.append([d.joint_names[i], *cells, *limits])
    note = (
        "" if plain else " q is the joint coordinate of the maker, whose zero and sense stand in the variable's column."
    )
    page.table(heads, rows, f"DH table and joint limits of {arm.name}.{note}")
    _add_short(page, arm)
    for what, T in (("base", arm.base), ("tool", arm.tool)):
        if not np.array_equal(T, np.eye(4)):
            p = ", ".join(fixed(v * MM) for v in T[:3, 3])
            page.add(
                f"The {what} stands at ({p}) mm in the table's {'first' if what == 'base' else 'last'} "
                f"frame{_turned(T)}."
            )
    if d.actuator:
        g = d.actuator
        page.add(
            f"The tool has an actuator of its own, {g.name} ({g.lower:g} to {g.upper:g} {g.unit}); it moves no frame."
        )
    q = first_posture(arm)
    values = ", ".join(
        f"{joint_value(arm, i, v, 1)}{'°' if arm.joint_types[i] == 'R' else ' mm'}" for i, v in enumerate(q)
    )
    page.add(
        picture(
            arm_figure(arm, q),
            f"{arm.name} at ({values}), with its joint axes and frames. Drums are joints, turning about their own "
            "axis.",
            "arm",
            0.78,
        )
    )
    if d.notes:
        page.add(d.notes.strip())
    if d.source:
        page.say(Emphasis("Source of the table:"), f" {d.source}")


def _add_short(page: Document, arm: Arm) -> None:
    """Add the table with slid rows, where common normals of nearly parallel axes lie far away."""
    d = with_short_rows(arm.description)
    if d is arm.description:
        return
    rows = []
    for i, row in enumerate(d.rows):
        across = fixed(row.f * MM) if isinstance(row, Slid) else ""
        turns = [fixed(np.degrees(angle)) for angle in (row.alpha, row.theta)]
        cells = [fixed(row.a * MM), across, turns[0], fixed(row.d * MM), turns[1]]
        cells[4 if d.axis_types[i] == "R" else 3] = _variable(arm, i, d)
        rows.append([d.axis_names[i], *cells])
    page.table(
        ["joint", "a, mm", "f, mm", "α, °", "d, mm", "θ, °"],
        rows,
        f"The same of {arm.name} without the way to far common normals, as its equations are written: nearly parallel "
        "axes are joined straight across, by a along x and f along y, before the turn α.",
    )
    for what, T, own in (("base", d.base, arm.base), ("tool", d.tool, arm.tool)):
        if np.abs(T - own).max() > TYPED_DIGITS:
            p = ", ".join(fixed(v * MM) for v in T[:3, 3])
            page.add(f"The {what} of that table stands at ({p}) mm{_turned(T)}.")


def _variable(arm: Arm, i: int, d: Description | None = None) -> str:
    d = d or arm.description
    revolute = d.axis_types[i] == "R"
    names = ["q" + "".join(chr(0x2080 + int(c)) for c in str(k + 1)) for k in range(arm.n)]
    text = d.moved_by(i, names, signed=True).replace("-", "−")
    constant = (d.rows[i].theta if revolute else d.rows[i].d) + d.offset[i]
    if constant:
        shown = fixed(abs(np.degrees(constant) if revolute else constant * MM))
        text += f" {'+' if constant > 0 else '−'} {shown}"
    return text


def _turned(T: np.ndarray) -> str:
    angles = np.degrees(rpy_of(T[:3, :3]))
    if np.abs(angles).max() < ROUNDING:
        return ""
    return f", turned by roll, pitch, yaw ({', '.join(fixed(v, 2) for v in angles)})° about the fixed axes"


def add_plan(page: Document, arm: Arm) -> None:
    """Add how the arm is solved, with the geometry it rests on, or why it is not."""
    page.section("How it is solved")
    try:
        plan = arm.plan
    except PieperError as error:
        page.add(str(error))
        return
    family = named(plan.family)
    page.add("What matters for the inverse is which neighbouring axes are parallel or meet:")
    page.add(Lines(tuple(plan.geometry.sentences(plan.names))))
    spare = f" The arm has joints to spare: {', '.join(plan.redundancy)} is chosen freely." if plan.redundancy else ""
    counted = f"It is {plan.count.kind}. {' '.join(how_many(plan))}{spare}"
    if arm.n < 6:  # what is said of six axes is not said of the arm's own
        page.add(counted)
        page.add(
            f"The solver fills the arm up to six joints, with ones that must come out as zero or that the task leaves "
            f"free, and solves those as a chain with {family.arrangement}."
        )
    else:
        page.add(f"That makes it an arm with {family.arrangement}. {family.words} {counted}")
    fewer = by_formulas(arm)
    if fewer is not None and fewer < plan.count.most:
        page.add(
            f"Step by step it has a closed form all the same, derived below, by which a pose has at most "
            f"{plural(fewer, 'solution')}."
        )


def by_formulas(arm: Arm) -> int | None:
    """How many solutions a pose has at most by the derivation of the inverse; None where there is none."""
    try:
        ik = arm.symbolic.ik()
    except (PieperError, ImportError):
        return None
    return ik.form.branches if ik.form is not None and not ik.form.chosen and not ik.form.free else None


def add_forward(page: Document, arm: Arm, letters: str = "noap") -> None:
    """Add the matrices and the forward equations, with the numbers that check them."""
    page.section("Forward kinematics")

    def equations() -> None:
        forward = arm.symbolic.fk()
        known = forward.meaning_equations
        page.say(
            "Each joint contributes one matrix. c₁ stands for cos θ₁, s₂₃ for sin(θ₂ + θ₃), and so on; the lengths "
            "keep their symbols",
            *((": ", *in_line(known), " (m).") if known else (".",)),
        )
        if forward.relation_equations:
            related = in_line(forward.relation_equations)
            page.say("The table's angles follow from the joint coordinates: ", *related, ".")
        page.add(Equations(tuple(matrix.equation for matrix in forward.A), beside=True))
        if forward.halves:
            page.add("Their partial products, sums of parallel joints gathered:")
            page.add(*(matrix.shown for matrix in forward.halves))
        entries = Document("")
        entries.add(
            "The pose of the tool, entry by entry; n, o, a are the columns of the rotation and p is the position:",
            forward.pose.entry_equations,
        )
        page.add(*in_letters(broken_lines(entries), letters).blocks, str(forward.check()))

    attempt(page, "The equations", equations)


def add_derivation(page: Document, arm: Arm, letters: str = "noap") -> None:
    """Add the derivation of the inverse, when the symbolic wing has one for this arm."""
    page.section("The inverse, derived")

    def derived() -> None:
        inverse = arm.symbolic.ik(letters=letters)
        page.add(*inverse.page.blocks, str(inverse.check()))

    attempt(page, "The derivation", derived)


def add_worked(page: Document, arm: Arm, T: np.ndarray, letters: str = "noap") -> None:
    """Add one pose worked through the derivation with its numbers; nothing where that cannot be."""
    try:
        worked = arm.symbolic.ik().worked(T)
    except PieperError:
        return
    page.heading("A worked example")
    page.add(*in_letters(worked.page, letters).blocks)


def add_singularities(page: Document, arm: Arm) -> None:
    """Add the singular configurations in words and equations, with a picture of each kind."""
    page.section("Singular configurations")

    def found() -> None:
        equations = arm.symbolic.singularities()
        page.add(*equations.page.blocks, str(equations.check()))
        seen = [c for c in equations.configurations if len(c.samples)][:3]
        if seen:
            titles = [f"{chr(97 + k)}) {'singular' if c.kind == 'other' else c.kind}" for k, c in enumerate(seen)]
            words = "; ".join(f"{chr(97 + k)}) {c.words[0].rstrip('.').lower()}" for k, c in enumerate(seen))
            figure = postures_figure(arm, np.array([_tame(arm, c.samples) for c in seen]), titles)
            page.add(
                picture(
                    figure,
                    f"The arm in singular configurations: {words}.",
                    "singular",
                    min(1.0, 0.15 + 0.3 * len(seen)),
                )
            )

    attempt(page, "The list of singular configurations", found)


def _tame(arm: Arm, samples: np.ndarray) -> np.ndarray:
    """Return the sample that lies best inside the limits, angles taken modulo a turn."""
    turn = 2 * np.pi
    revolute = np.array([kind == "R" for kind in arm.joint_types])
    q = np.where(revolute, samples - turn * np.round(samples / turn), samples)
    beyond = np.maximum(arm.limits[:, 0] - q, q - arm.limits[:, 1]).clip(0).max(1)
    return q[int(np.argmin(beyond))]


def add_reach(page: Document, arm: Arm) -> None:
    """Add where the tool can be, in two slices."""
    page.section("Reach")
    points = reach_samples(arm)
    foot = arm.chain.points[0]
    far = float(np.linalg.norm(points - foot, axis=1).max())
    low, high = points[:, 2].min() * MM, points[:, 2].max() * MM
    least, most = fixed(low, 0), fixed(high, 0)
    height = f"stayed {least} mm" if least == most else f"lay between {least} and {most} mm"
    page.add(
        f"Of {len(points):,} postures drawn evenly inside the joint limits, the tool came as far as "
        f"{fixed(far * MM, 0)} mm from the foot of the first axis, and its height {height}."
    )
    page.add(
        picture(
            reach_figure(arm, points=points, q=first_posture(arm)),
            "Where the tool can be, whatever its orientation: darker where more postures end. Left, turned into one "
            "half plane through the first axis, with the arm drawn in; right, a slice from above.",
            "reach",
        )
    )


def attempt(page: Document, what: str, work: Callable[[], None]) -> None:
    """Run a part that rests on the symbolic wing; where that has nothing to say, say so in a sentence and go on."""
    length = len(page.blocks)
    try:
        work()
    except (PieperError, ImportError) as error:
        del page.blocks[length:]
        page.add(Note((f"{what} cannot be given for this arm: {str(error).strip().rstrip('.')}.",)))
