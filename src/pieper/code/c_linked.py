"""What the C of an export says of axes that a linkage moves, and how a row becomes a joint vector."""

from __future__ import annotations

from collections.abc import Sequence

from pieper.code.between import Between
from pieper.kinematics.arrays import Array


def lines(texts: Sequence[str], into: str, margin: str = "  ") -> str:
    """Return assignments to the entries of an array."""
    return "".join(f"{margin}{into}[{j}] = {text};\n" for j, text in enumerate(texts))


def own_row(own: Between) -> str:
    """Return the lines that make a joint vector of a row."""
    if not own.linked:
        return lines(own.axes("rows[m][{}]".format), "own", "    ")
    said = lines(own.axes("rows[m][{}]".format), "at", "    ")
    return f"    double at[AXES];\n{said}    keep = NAME_linked(at, own);\n"


def linked(gears: Array, back: Array, own: Between) -> dict[str, str]:
    """Return what is said of axes that a linkage moves: joints' numbers of those with a joint, the others tested."""
    starts = ", ".join(map(repr, own.starts))
    wrapped = "6.28318530717958647693 * ceil((q[j] - 3.14159265358979323846) / 6.28318530717958647693)"
    return {
        "AXES_AT": "/* A linkage moves some axes: where they are at joint vectors q. */\n"
        "static void NAME_axes(const double *q, double *v) {\n" + lines(own.sums(gears, "q[{}]".format), "v") + "}\n\n",
        "COUPLED": "/* The joints' numbers where their axes are at v; whether the linkage puts the others there. */\n"
        "static int NAME_linked(const double *v, double *q) {\n"
        f"  static const double starts[] = {{{starts}}};\n  double said[AXES];\n  int j, kept = 1;\n"
        + lines(own.sums(back, "v[{}]".format), "q")
        + "  NAME_axes(q, said);\n  for (j = 0; j < AXES; ++j) {\n    double d = fabs(v[j] - said[j]);\n"
        "    if (!NAME_slides[j]) d = fabs(d - 6.28318530717958647693 * floor(d / 6.28318530717958647693 + 0.5));\n"
        "    kept = kept && d < starts[j];\n  }\n  return kept;\n}\n\n",
        "TO_AXES": "  double v[AXES];\n  NAME_axes(q, v);\n",
        "V": "v",
        "GEARED": "  for (k = 0; k < 6; ++k) {\n"
        + lines(own.sums(gears.T, "by[k][{}]".format), "J[k]", "    ")
        + "  }\n",
        "FROM_AXES": "  for (m = 0; m < count; ++m)\n    for (j = 0; j < N; ++j)\n"
        f"      if (!NAME_joint_slides[j]) q[m][j] -= {wrapped.replace('q[j]', 'q[m][j]')};\n",
        "LABELLED": "given",
        "LABEL_AXES": "  double q[AXES];\n  NAME_axes(given, q);\n",
    }
