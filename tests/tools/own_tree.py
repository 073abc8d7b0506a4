"""A URDF's tree read anew and multiplied joint by joint, without code of pieper and without a DH table."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]
#: Angles typed to a few digits are meant as multiples of this, within `MEANT`, rad.
STEP, MEANT = np.pi / 12, 2e-3


@dataclass(frozen=True)
class Joint:
    """One joint: where it stands on its parent and how it moves."""

    name: str
    kind: str
    parent: str
    child: str
    origin: Array
    axis: Array
    limits: tuple[float, float] | None
    mimic: tuple[str, float, float] | None


def floats(text: str | None, default: str) -> list[float]:
    """Return the numbers of an attribute."""
    return [float(word) for word in (text or default).split()]


def turn(axis: Array, angle: float) -> Array:
    """Return the pose (4, 4) of a turn about a unit axis (3,), by Rodrigues' formula."""
    x, y, z = axis
    K = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    T = np.eye(4)
    T[:3, :3] += np.sin(angle) * K + (1 - np.cos(angle)) * (K @ K)
    return T


def meant(angle: float, exact: bool) -> float:
    """Return the multiple of 15 degrees that a rounded angle stands for, or the angle."""
    near = round(angle / STEP) * STEP
    return near if exact and abs(angle - near) < MEANT else angle


def placed(element: ET.Element | None, exact: bool) -> Array:
    """Return the pose (4, 4) of an <origin>."""
    T = np.eye(4)
    if element is None:
        return T
    r, p, y = (meant(a, exact) for a in floats(element.get("rpy"), "0 0 0"))
    X, Y, Z = np.eye(3)
    T = turn(Z, y) @ turn(Y, p) @ turn(X, r)
    T[:3, 3] = floats(element.get("xyz"), "0 0 0")
    return T


def joints_of(path: str | Path, *, exact: bool = True) -> list[Joint]:
    """Return the joints of a URDF in the order of the file.

    Args:
        path: The file.
        exact: Whether rounded multiples of 15 degrees are taken as the multiples.
    """
    out = []
    for element in ET.parse(path).getroot().findall("joint"):
        parent, child, limit = element.find("parent"), element.find("child"), element.find("limit")
        if parent is None or child is None:
            continue
        said = element.find("axis")
        axis = np.array(floats(said.get("xyz") if said is not None else None, "1 0 0"))
        bounds = None
        if limit is not None and element.get("type") != "continuous":
            bounds = (float(limit.get("lower") or 0), float(limit.get("upper") or 0))
        out.append(
            Joint(
                element.get("name") or "",
                element.get("type") or "fixed",
                parent.get("link") or "",
                child.get("link") or "",
                placed(element.find("origin"), exact),
                axis / max(float(np.linalg.norm(axis)), 1e-300),
                bounds,
                _mimic(element.find("mimic")),
            )
        )
    return out


def _mimic(element: ET.Element | None) -> tuple[str, float, float] | None:
    if element is None:
        return None
    return element.get("joint") or "", float(element.get("multiplier") or 1), float(element.get("offset") or 0)


def between(joints: list[Joint], base: str, tip: str, values: dict[str, float]) -> Array:
    """Return the pose (4, 4) of any link seen from any other one."""
    above = {joint.child: joint for joint in joints}
    values = followed(joints, values)

    def placed_at(link: str) -> Array:
        top = link
        while top in above:
            top = above[top].parent
        return product(way(joints, top, link), values)

    return np.asarray(np.linalg.inv(placed_at(base)) @ placed_at(tip), np.float64)


def followed(joints: list[Joint], values: dict[str, float]) -> dict[str, float]:
    """Return the values with those of joints that mimic one, or one that does: a linkage beside the arm may lead."""
    out = dict(values)
    for _ in joints:
        before = dict(out)
        for joint in joints:
            if joint.mimic is not None:
                leader, times, plus = joint.mimic
                out[joint.name] = times * out.get(leader, 0.0) + plus
        if out == before:
            break
    return out


def way(joints: list[Joint], base: str, tip: str) -> list[Joint]:
    """Return the joints from a link down to another one."""
    above = {joint.child: joint for joint in joints}
    out: list[Joint] = []
    while tip != base:
        out.insert(0, above[tip])
        tip = above[tip].parent
    return out


def product(joints: list[Joint], values: dict[str, float]) -> Array:
    """Return the pose (4, 4) at the end of a way; joints without a value stand at zero, mimics follow."""
    T = np.eye(4)
    for joint in joints:
        T = T @ joint.origin
        value = values.get(joint.name, 0.0)
        if joint.mimic is not None:
            leader, times, plus = joint.mimic
            value = times * values.get(leader, 0.0) + plus
        if joint.kind in ("revolute", "continuous"):
            T = T @ turn(joint.axis, value)
        elif joint.kind == "prismatic":
            slide = np.eye(4)
            slide[:3, 3] = joint.axis * value
            T = T @ slide
    return T


def moving(joints: list[Joint]) -> list[Joint]:
    """Return the joints that move."""
    return [joint for joint in joints if joint.kind in ("revolute", "continuous", "prismatic")]
