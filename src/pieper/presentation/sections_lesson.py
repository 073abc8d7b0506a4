"""Sections that teach: the DH frames step by step, the triangle of two links, the Jacobian of a short arm."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pieper.document.blocks import Document, Equation
from pieper.document.formulas import Written
from pieper.drawing.style import MM, picture
from pieper.equations.triangle import triangle_of
from pieper.presentation.plot_lesson import ROWS, dh_steps_figure, triangle_figure
from pieper.presentation.sections_arm import attempt, first_posture, fixed, short_names

if TYPE_CHECKING:
    from pieper.presentation.arm import Arm

THIN = 0.35  # rad; a triangle with such an angle at the elbow shows nothing
SHORT = 4  # joints of an arm whose Jacobian is printed entry by entry
LAW = Written(
    "cos gamma = (L1^2 + L2^2 - r^2)/(2*L1*L2)",
    r"\cos\gamma = \frac{L_1^2 + L_2^2 - r^2}{2 L_1 L_2}",
    "<mrow><mi>cos</mi><mi>γ</mi><mo>=</mo><mfrac><mrow><msubsup><mi>L</mi><mn>1</mn><mn>2</mn></msubsup><mo>+</mo>"
    "<msubsup><mi>L</mi><mn>2</mn><mn>2</mn></msubsup><mo>−</mo><msup><mi>r</mi><mn>2</mn></msup></mrow><mrow><mn>2</mn>"
    "<msub><mi>L</mi><mn>1</mn></msub><msub><mi>L</mi><mn>2</mn></msub></mrow></mfrac></mrow>",
)


def add_dh_steps(page: Document, arm: Arm) -> None:
    """Add pictures of every row of the table at work: the frame moved by theta, d, a and alpha in turn."""
    q = first_posture(arm)
    order = "θ, d, a and α" if arm.description.convention == "standard" else "α, a, θ and d"
    count = -(-arm.n // ROWS)
    size = -(-arm.n // count)
    for k in range(count):
        first, last = k * size, min((k + 1) * size, arm.n)
        which = f"rows {first + 1} to {last}" if last > first + 1 else f"row {first + 1}"
        caption = (
            f"The table at work, {which}: the frame that is moved by {order} in turn, seen from the frame before it, "
            "with the joints as in the picture above. Pale is where it was; lengths of a row are in proportion."
        )
        page.add(picture(dh_steps_figure(arm, q, first, last), caption, f"steps-{k + 1}", 0.95))


def add_triangle(page: Document, arm: Arm, q: np.ndarray | None = None) -> None:
    """Add the triangle of the law of cosines, where two neighbouring axes are parallel; nothing elsewhere.

    Args:
        page: The page.
        arm: The arm.
        q: (n,) the posture to draw; one that shows the arm well when left out.
    """
    found = triangle_of(arm)
    if found is None:
        return
    q = first_posture(arm) if q is None else np.asarray(q, dtype=float)
    if found.inner(q) < 0.35 or found.inner(q) > 2.8:
        q = q.copy()
        q[found.elbow - 1] = np.pi / 2 - found.constant
    low, high = found.reach
    shift = np.degrees(-found.constant)
    beside = "" if fixed(abs(shift), 2) == "0" else f" {'+' if shift > 0 else '−'} {fixed(abs(shift), 2)}°"
    page.heading("The triangle of two links")
    joint, end = short_names(arm)[found.elbow - 1], found.end
    page.add(
        f"Seen along axes {found.shoulder} and {found.elbow}, which are parallel, the arm is a triangle from axis "
        f"{found.shoulder} over axis {found.elbow} to {end}. Two of its sides are the same in every posture, L₁ = "
        f"{fixed(found.first * MM, 2)} mm and L₂ = {fixed(found.second * MM, 2)} mm; the third, r, is how far {end} "
        f"is from axis {found.shoulder} across the axes. The law of cosines gives the angle γ at axis {found.elbow}:"
    )
    page.add(Equation((LAW,)))
    page.add(
        f"and with it the joint: {joint} = ±(180° − γ){beside}, whole turns aside; the two signs are the elbow's two "
        f"sides. So r lies between {fixed(low * MM, 2)} and {fixed(high * MM, 2)} mm, limits aside: nearer "
        "or farther there is no triangle, and no solution."
    )
    caption = (
        f"The triangle of axis {found.shoulder}, axis {found.elbow} and {found.end}, to scale, with "
        f"{short_names(arm)[found.elbow - 1]} at {fixed(np.degrees(q[found.elbow - 1]), 1)}°."
    )
    page.add(picture(triangle_figure(found, q), caption, "triangle", 0.62))


def add_jacobian(page: Document, arm: Arm) -> None:
    """Add the Jacobian as a matrix, of an arm with few joints."""
    if arm.n > SHORT:
        return
    page.section("Jacobian")

    def written() -> None:
        equations = arm.symbolic.jacobian()
        page.add(
            "How the joints' rates move the tool's point (rows 1 to 3) and turn it (rows 4 to 6), in the base frame:"
        )
        page.add(*equations.page.blocks, str(equations.check()))

    attempt(page, "The Jacobian", written)
