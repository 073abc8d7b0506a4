"""Between the page's DH table (JSON) and the library's arm."""

from __future__ import annotations

from dataclasses import asdict, replace
from typing import Any

import numpy as np
import numpy.typing as npt

import pieper
from pieper.workbench.messages import LONGEST_NAME, MAX_JOINTS, Refused, number, pose, vector, word


def arm_from_table(table: object) -> pieper.Arm:
    """Return the arm that a page's table describes, or refuse it with the joint and the reason.

    Args:
        table: {name, convention, joints: [{name, type, a, alpha, d, theta, lower, upper, sign, offset}], base, tool,
            postures, coupling}; metres and radians, null for a limit that is not there, poses as 16 numbers row by row.
    """
    if not isinstance(table, dict):
        raise Refused("The arm must be an object with convention and joints.")
    joints = table.get("joints")
    if not isinstance(joints, list) or not joints:
        raise Refused("The table has no joints: add at least one.")
    if len(joints) > MAX_JOINTS:
        raise Refused(f"The table has {len(joints)} joints; the workbench takes at most {MAX_JOINTS}.")
    rows, types, limits, names, sign, offset = [], [], [], [], [], []
    for i, joint in enumerate(joints):
        at = f"joint {i + 1}"
        if not isinstance(joint, dict):
            raise Refused(f"{at} must be an object.")
        rows.append(pieper.DH(*(number(joint.get(key), f"{at}, {key}") for key in ("a", "alpha", "d", "theta"))))
        types.append(word(joint.get("type"), f"{at}, type", ("R", "P")))
        limits.append([None if joint.get(k) is None else number(joint[k], f"{at}, {k}") for k in ("lower", "upper")])
        names.append(word(joint.get("name", f"joint_{i + 1}"), f"{at}, name"))
        sign.append(number(joint.get("sign", 1), f"{at}, sign"))
        offset.append(number(joint.get("offset", 0), f"{at}, offset"))
    arm = pieper.Arm.from_dh(
        rows,
        convention=word(table.get("convention"), "convention", ("standard", "modified")),
        joint_types="".join(types),
        limits=limits,
        base=pose(table["base"], "base") if "base" in table else None,
        tool=pose(table["tool"], "tool") if "tool" in table else None,
        name=word(table.get("name", "my-arm"), "name"),
        joint_names=names,
        sign=sign,
        offset=offset,
        coupling=_coupling(table["coupling"], len(rows)) if table.get("coupling") else None,
    )
    return _with_notes(arm, table)


def _with_notes(arm: pieper.Arm, table: dict[str, Any]) -> pieper.Arm:
    """Return the arm with the table's postures and remarks, which change no mathematics."""
    postures = table.get("postures") or {}
    if not isinstance(postures, dict) or len(postures) > 40:
        raise Refused("postures must be an object of at most 40 joint vectors.")
    named = {word(k, "posture name"): vector(v, arm.n, f"posture {k[:LONGEST_NAME]}") for k, v in postures.items()}
    remarks = {key: table[key][:4000] for key in ("manufacturer", "source", "notes") if isinstance(table.get(key), str)}
    gripper = _actuator(table["actuator"]) if table.get("actuator") else None
    if not (named or remarks or gripper):
        return arm
    return pieper.Arm(replace(arm.description, postures=named, actuator=gripper, **remarks))


def _coupling(given: object, n: int) -> npt.NDArray[np.float64]:
    """Return (n, n): chain values = coupling @ joint values."""
    if not isinstance(given, list) or len(given) != n:
        raise Refused(f"coupling must be a list of {n} rows of {n} numbers.")
    return np.array([vector(row, n, f"coupling, row {i + 1}") for i, row in enumerate(given)])


def _actuator(given: object) -> pieper.Actuator:
    if not isinstance(given, dict):
        raise Refused("actuator must be an object.")
    lower, upper, value = (number(given.get(key), f"actuator, {key}") for key in ("lower", "upper", "value"))
    if not lower <= upper:
        raise Refused("actuator: the lower limit is above the upper one.")
    return pieper.Actuator(
        word(given.get("name"), "actuator, name"), lower, upper, value, word(given.get("unit"), "actuator, unit")
    )


def table_from_arm(arm: pieper.Arm, catalog: str | None = None) -> dict[str, Any]:
    """Return the page's table of an arm; one that is the catalogue's says so, by the name it has there."""
    d = arm.description
    d.not_linked(
        "the page shows arms of which every axis has a joint",
        "In Python, pieper.workbench(arm.uncoupled()) shows it by its axes.",
    )
    return {
        "name": d.name,
        "convention": d.convention,
        "manufacturer": d.manufacturer,
        "source": d.source,
        "notes": d.notes,
        "joints": [
            {
                "name": d.joint_names[i],
                "type": d.joint_types[i],
                "a": row.a,
                "alpha": row.alpha,
                "d": row.d,
                "theta": row.theta,
                "lower": _bound(d.limits[i, 0]),
                "upper": _bound(d.limits[i, 1]),
                "sign": float(d.sign[i]),
                "offset": float(d.offset[i]),
            }
            for i, row in enumerate(d.rows)
        ],
        "base": d.base.ravel().tolist(),
        "tool": d.tool.ravel().tolist(),
        "postures": {name: np.asarray(q).tolist() for name, q in d.postures.items()},
        "actuator": None if d.actuator is None else asdict(d.actuator),
        "coupling": None if d.coupling is None else np.asarray(d.coupling).tolist(),
        **({"catalog": catalog} if catalog else {}),
    }


def is_of_catalog(arm: pieper.Arm) -> str | None:
    """Return the name of an arm that is the catalogue's as it ships, else None."""
    if arm.name in pieper.catalog() and table_from_arm(pieper.load(arm.name)) == table_from_arm(arm):
        return arm.name
    return None


def _bound(value: float) -> float | None:
    return float(value) if np.isfinite(value) else None
