"""Forward kinematics as the C of an export walks it, a row of the pose at a time."""

from __future__ import annotations

from collections.abc import Sequence

from pieper.code.export import Export
from pieper.code.staged import packed


def walk(export: Export) -> str:
    """Return forward kinematics, a row of the pose at a time, without what is zero or one."""
    said: list[str] = []
    turns = [j for j, slides in enumerate(export.slides) if not slides]
    x, y, z, p = "x", "y", "z", "p"
    for j, (slides, link) in enumerate(zip(export.slides, export.links[1:], strict=True)):
        said.append(f"if (axes) axes[{j}][k] = {z}, axes[{j}][3 + k] = {p};")
        if slides:
            said.append(f"const double p{j} = {p} + q[{j}] * {z};")
            p = f"p{j}"
        else:
            said.append(f"const double x{j} = c{j} * {x} + s{j} * {y}, y{j} = c{j} * {y} - s{j} * {x};")
            x, y = f"x{j}", f"y{j}"
        columns, names = [x, y, z], []
        for name, column in zip("uvwp", link.T, strict=True):
            text = _sum(column, columns, p if name == "p" else "")
            if text not in (x, y, z, p):
                said.append(f"const double {name}_{j} = {text};")
                text = f"{name}_{j}"
            names.append(text)
        x, y, z, p = names
    own = [f"const double c{j} = cos(q[{j}]), s{j} = sin(q[{j}]);" for j in turns]
    start = ["const double x = NAME_base[k][0], y = NAME_base[k][1], z = NAME_base[k][2], p = NAME_base[k][3];"]
    end = [f"T[4 * k{f' + {j}' if j else ''}] = {text};" for j, text in enumerate((x, y, z, p))]
    return (
        "/* To the tool; z and p of each joint's frame into axes where that is not null. */\n"
        "static void NAME_walk(const double *q, double *T, double (*axes)[6]) {\n"
        + "\n".join(packed([f"  {line}" for line in own]))
        + "\n  int k;\n  for (k = 0; k < 3; ++k) {\n"
        + "\n".join(packed([f"    {line}" for line in [*start, *said, *end]]))
        + "\n  }\n}\n"
    )


def _sum(factors: Sequence[float], names: Sequence[str], first: str) -> str:
    """Return a sum of multiples, those of zero left out."""
    out = first
    for factor, name in zip(factors, names, strict=True):
        if factor == 0:
            continue
        size = "" if abs(factor) == 1 else f"{abs(float(factor))!r} * "
        sign = "-" if factor < 0 else ""
        out += f" {sign or '+'} {size}{name}" if out else f"{sign}{size}{name}"
    return out or "0"
