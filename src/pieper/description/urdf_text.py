"""An arm as the text of a URDF: its joints, limits and frames to the last digit, without shapes and masses."""

from __future__ import annotations

from pathlib import Path
from xml.sax.saxutils import quoteattr

import numpy as np
import numpy.typing as npt

from pieper.description.dh import Description
from pieper.description.fold import chain_of
from pieper.description.urdf import WHOLE
from pieper.description.wholefile import replace_file
from pieper.kinematics.orientation import rpy_of
from pieper.tolerances import UNLIMITED


def write(arm: Description, path: str | Path) -> Path:
    """Write an arm as a URDF, whole or not at all."""
    replace_file(Path(path), dumps(arm))
    return Path(path)


def dumps(arm: Description) -> str:
    """Return the URDF of an arm, from link "base" to link "tool".

    Every joint turns about or slides along its own z axis. What a coupling adds to a joint is a joint of its own on the
    same axis that mimics the other one; an axis that a linkage moves is made of such joints alone.
    """
    chain = chain_of(arm)
    names = set(arm.axis_names)
    lines = ['<?xml version="1.0"?>', f"<robot name={quoteattr(arm.name)}>", f"  {WHOLE}", '  <link name="base"/>']
    parent = "base"
    for i, name in enumerate(arm.axis_names):
        child = f"link_{i + 1}"
        turning = arm.axis_types[i] == "R"
        row = np.eye(arm.n)[i] if arm.coupling is None else np.array(arm.coupling[i])
        if i not in arm.own_axes:
            lines += _linked(arm, i, row, parent, chain.links[i], names)
            parent = child
            continue
        joint = arm.own_axes.index(i)
        lower, upper = (float(v) for v in arm.limits[joint])
        endless = not (np.isfinite(lower) or np.isfinite(upper))
        kind = ("continuous" if endless else "revolute") if turning else "prismatic"
        bounds = (
            ""
            if turning and endless
            else f"lower={_number(max(lower, -UNLIMITED))} upper={_number(min(upper, UNLIMITED))} "
        )
        limit = f'<limit {bounds}effort="0" velocity="0"/>'
        lines += _joint(name, kind, parent, child, chain.links[i], f'<axis xyz="0 0 1"/>{limit}')
        parent = child
        row[joint] -= 1.0
        for k in np.flatnonzero(row):
            other = arm.joint_names[k]
            mimic = _free(f"{name} with {other}", names)
            child = f"link_{i + 1}_with_{k + 1}"
            lines += _mimic(mimic, turning, parent, child, np.eye(4), other, float(row[k]))
            parent = child
    lines += _joint(_free("tool_fixed", names), "fixed", parent, "tool", chain.links[-1], "")
    return "\n".join([*lines, "</robot>"]) + "\n"


def _linked(
    arm: Description, axis: int, row: npt.NDArray[np.float64], parent: str, T: npt.NDArray[np.float64], names: set[str]
) -> list[str]:
    """Return the joints of an axis that a linkage moves, to link_(axis + 1): the first has the axis's name."""
    lines, movers = [], np.flatnonzero(row).tolist()
    for k in movers:
        other, name = arm.joint_names[k], arm.axis_names[axis]
        child = f"link_{axis + 1}" if k == movers[-1] else f"link_{axis + 1}_with_{k + 1}"
        said = name if k == movers[0] else _free(f"{name} with {other}", names)
        lines += _mimic(said, arm.axis_types[axis] == "R", parent, child, T, other, float(row[k]))
        parent, T = child, np.eye(4)
    return lines


def _mimic(
    name: str, turning: bool, parent: str, child: str, T: npt.NDArray[np.float64], other: str, by: float
) -> list[str]:
    extra = (
        f'<axis xyz="0 0 1"/><limit lower="{-UNLIMITED}" upper="{UNLIMITED}" effort="0" velocity="0"/>'
        f'<mimic joint={quoteattr(other)} multiplier={_number(by)} offset="0"/>'
    )
    return _joint(name, "revolute" if turning else "prismatic", parent, child, T, extra)


def _joint(name: str, kind: str, parent: str, child: str, T: npt.NDArray[np.float64], inside: str) -> list[str]:
    xyz = " ".join(repr(float(value)) for value in T[:3, 3])
    rpy = " ".join(repr(float(value)) for value in rpy_of(T[:3, :3]))
    return [
        f'  <link name="{child}"/>',
        f'  <joint name={quoteattr(name)} type="{kind}">',
        f'    <parent link="{parent}"/><child link="{child}"/>',
        f'    <origin xyz="{xyz}" rpy="{rpy}"/>{inside}',
        "  </joint>",
    ]


def _number(value: float) -> str:
    return f'"{value!r}"'


def _free(name: str, taken: set[str]) -> str:
    while name in taken:
        name += "_"
    taken.add(name)
    return name
