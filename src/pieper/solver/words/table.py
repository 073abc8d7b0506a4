"""Solutions as a table for people: degrees and millimetres, one line a solution, the reason under it."""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.solver.plan.plan import Plan
from pieper.solver.results import Solutions


def table(plan: Plan, sols: Solutions) -> str:
    """Return the solutions inside the limits, one line each, and under them how the pose came out.

    Args:
        plan: How the arm is solved.
        sols: The solutions.

    Returns:
        Lines without an end: a head with names and units, the rows, `sols.why`.
    """
    units = ["mm" if slides else "deg" for slides in plan.prismatic]
    heads = ["#", *(f"{name}, {unit}" for name, unit in zip(plan.names, units, strict=True)), "posture", "residual"]
    rows = [heads]
    for i, (q, label, missed) in enumerate(zip(sols.q, sols.labels, sols.residual, strict=True)):
        residual = f"{missed[0] * 1e3:.1e} mm, {np.degrees(missed[1]):.1e} deg"
        rows.append([str(i + 1), *_joints(plan, q), label, residual])
    widths = [max(len(cell) for cell in column) for column in zip(*rows, strict=True)]
    return "\n".join([*(_line(row, widths) for row in rows if len(rows) > 1), sols.why])


def _line(row: list[str], widths: list[int]) -> str:
    # numbers stand to the right, the words at the end to the left
    numbers, words = row[:-2], row[-2:]
    cells = [cell.rjust(width) for cell, width in zip(numbers, widths[:-2], strict=True)]
    cells += [cell.ljust(width) for cell, width in zip(words, widths[-2:], strict=True)]
    return "  ".join(cells).rstrip()


def _joints(plan: Plan, q: Array) -> list[str]:
    shown = np.where(plan.prismatic, q * 1e3, np.degrees(q))
    # the rounding of zero is zero, without a sign
    return [f"{value:z.3f}" for value in np.round(shown, 3)]
