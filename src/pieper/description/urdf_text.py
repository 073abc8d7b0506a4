"""An arm as the text of a URDF: its joints, limits and frames to the last digit, without shapes and masses."""

from __future__ import annotations

from pathlib import Path
from xml.sax.saxutils import quoteattr

import numpy as np
import numpy.typing as npt

from pieper.description.dh import Description
from pieper.description.fold import chain_of
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
    same axis that mimics the other one.
    """
    chain = chain_of(arm)
    names = set(arm.joint_names)
    lines = ['<?xml version="1.0"?>', f"<robot name={quoteattr(arm.name)}>", '  <link name="base"/>']
    parent = "base"
    for i, name in enumerate(arm.joint_names):
        child = f"link_{i + 1}"
        turning = arm.joint_types[i] == "R"
        lower, upper = (float(v) for v in arm.limits[i])
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
        row = np.zeros(arm.n) if arm.coupling is None else arm.coupling[i] - np.eye(arm.n)[i]
        for k in np.flatnonzero(row):
            other = arm.joint_names[k]
            mimic = _free(f"{name} with {other}", names)
            child = f"link_{i + 1}_with_{k + 1}"
            extra = (
                f'<axis xyz="0 0 1"/><limit lower="{-UNLIMITED}" upper="{UNLIMITED}" effort="0" velocity="0"/>'
                f'<mimic joint={quoteattr(other)} multiplier={_number(float(row[k]))} offset="0"/>'
            )
            lines += _joint(mimic, "revolute" if turning else "prismatic", parent, child, np.eye(4), extra)
            parent = child
    lines += _joint(_free("tool_fixed", names), "fixed", parent, "tool", chain.links[-1], "")
    return "\n".join([*lines, "</robot>"]) + "\n"


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
