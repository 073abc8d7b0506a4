"""Words for a posture, read off the arm's geometry at the posture, not off a table or a sign convention.

- front / rear: on which side of the first axis the wrist lies, seen along the arm's own forward direction: the side of
  the shoulder offset; where there is none, the side the wrist has with all joints at zero. With three parallel axes
  the wrist is where the last two axes meet, or come closest: its crossing of the first axis is the shoulder's
  singularity.
- elbow up / down: whether the elbow lies above the line from shoulder to wrist (with three parallel axes: to the third
  of them), for somebody who looks along the arm.
- elbow left / right: on which side of that line the elbow lies, seen from above, where the first two axes are parallel.
- slide out / back: whether a slide across the second axis holds the wrist ahead of that axis or behind it.
- wrist no flip / flip: whether the sine of the bend from the fourth to the sixth axis, about the fifth, is positive.
- shoulder, elbow no flip / flip: the same of the bends about joints 2 and 4 of seven-joint arms whose axes meet in
  shoulder, elbow and wrist.
- aspect + / -: the sign of the Jacobian's determinant, for arms whose postures have no name of their own.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.kinematics.geometry import axes_at
from pieper.kinematics.newton import determinant
from pieper.solver.plan.plan import Plan
from pieper.tolerances import ASPECT_SIGN, LABEL_STEP, LABELLED_ANGLE, NO_SIDE, TINY


@dataclass(frozen=True, eq=False)
class Sides:
    """One of a label's words, as it hangs on a number: which side of a singularity a posture lies on.

    Args:
        values: (m,) the number, per length or a sine; smooth in the joints where it is not mirrored.
        words: What is said where it is positive, negative, and neither.
        mirrored: The number is that of somebody who faces the first word's way: its sign turns where that one's does.
    """

    values: Array
    words: tuple[str, str, str]
    mirrored: bool = False

    def said(self) -> list[str]:
        """Return the word of each row."""
        positive, negative, neither = self.words
        return [(positive if v > 0 else negative) if abs(v) > NO_SIDE else neither for v in self.values]


def sides(plan: Plan, q: Array) -> list[Sides]:
    """Return the words of rows q (m, n) with the numbers they hang on; none where the postures have no names."""
    parts = (_shoulder_and_elbow, _planar_elbow, _slide, _seven_joints, _wrist)
    return [side for part in parts for side in part(plan, q)]


def joined(words: tuple[str, ...]) -> str:
    """Return a label made of its words."""
    return ", ".join(word for word in words if word) or "on a singularity"


def posture_words(plan: Plan, q: Array) -> list[str]:
    """Return one label a row of q (m, n), such as "front, elbow up, wrist flip"."""
    if not len(q):
        return []
    if plan.chain.linked and plan.uncoupled is not None:
        return posture_words(plan.uncoupled, q @ np.asarray(plan.chain.coupling).T)
    columns = [side.said() for side in sides(plan, q)]
    return [joined(row) for row in zip(*(columns or [_aspect(plan, q)]), strict=True)]


def labels_beside(plan: Plan, q: Array, direction: Array) -> tuple[str, ...]:
    """Return the labels of the branches that meet in q (n,) along a direction (n,) without units, each once."""
    step = LABEL_STEP * direction * plan.chain.joints.unit
    return tuple(dict.fromkeys(posture_words(plan, np.stack([q + step, q - step]))))


def has_elbow(plan: Plan) -> bool:
    """Whether the second and third axes are parallel and the first is not: an arm with a shoulder and an elbow."""
    g = plan.geometry
    if plan.n < 3 or plan.prismatic[:3].any() or plan.chain is not g.chain:
        return False
    return g.pairs[1].relation == "parallel" and g.pairs[0].angle > LABELLED_ANGLE


def _wrist_joint(plan: Plan) -> int | None:
    """Return the joint (0-based) whose axis point stands for the wrist."""
    for group in plan.geometry.spherical:
        if group.joints[-1] == plan.n - 1:
            return group.joints[1]
    return None


def _shoulder_and_elbow(plan: Plan, q: Array) -> list[Sides]:
    if not has_elbow(plan):
        return []
    z, o = axes_at(plan.chain, np.vstack([q, np.zeros(plan.n)]))
    center = _wrist_joint(plan)
    if center is not None:
        wrist = _spherical_point(plan, q)
    elif plan.n >= 6 and _three_parallel(plan) and plan.geometry.pairs[4].angle > LABELLED_ANGLE:
        wrist = _meeting(z[:, 4], o[:, 4], z[:, 5], o[:, 5])
    elif plan.n >= 5:
        wrist = o[:, 4]
    elif plan.n == 4:
        wrist = o[:, 3]
    else:
        wrist = plan.reduction.arm and _tool_points(plan, q)
    first, second, third = z[:, 0], z[:, 1], z[:, 2]
    up = first[0] * (1.0 if _upward(plan, first[0]) else -1.0)
    forward = _perpendicular(np.asarray(np.cross(second, up), np.float64), up)
    end = o[:, 3] if _three_parallel(plan) else wrist
    shoulder = o[:, 1] + _along(end - o[:, 1], second)
    elbow = o[:, 2] + _along(end - o[:, 2], third)
    base = o[:, 0] + np.sum((shoulder - o[:, 0]) * up, -1)[:, None] * up
    size = plan.chain.length
    offset = np.sum((shoulder - base) * forward, -1) / size
    reach = np.sum((wrist - base) * forward, -1) / size
    reference = offset[-1] if abs(offset[-1]) > NO_SIDE else reach[-1]
    sense = -1.0 if reference < -NO_SIDE else 1.0
    side = sense * reach[:-1]
    facing = np.where(side >= 0, sense, -sense)[:, None] * forward[:-1]
    line, bone = end[:-1] - shoulder[:-1], elbow[:-1] - shoulder[:-1]
    # turn the line to the wrist by a quarter turn upward, as seen when facing the wrist
    turn_axis = np.cross(facing, up)
    normal = np.cross(turn_axis, line)
    height = np.sum(bone * normal, -1) / size**2
    return [
        Sides(side, ("front", "rear", "")),
        Sides(height, ("elbow up", "elbow down", "elbow straight"), mirrored=True),
    ]


def _three_parallel(plan: Plan) -> bool:
    """Whether a third parallel axis follows the second and third."""
    return plan.n >= 4 and not plan.prismatic[3] and plan.geometry.pairs[2].relation == "parallel"


def _planar_elbow(plan: Plan, q: Array) -> list[Sides]:
    g = plan.geometry
    if plan.n < 3 or plan.prismatic[:2].any() or g.pairs[0].relation != "parallel" or g.pairs[1].angle > NO_SIDE:
        return []
    z, o = axes_at(plan.chain, q)
    if _wrist_joint(plan) is not None:
        end = _spherical_point(plan, q)[:-1]
    else:
        # a slide along the axes has no place of its own: the next axis that turns tells where the tool goes
        turning = [j for j in range(2, plan.n) if not plan.prismatic[j]]
        end = o[:, turning[0]] if turning else _tool_points(plan, q)[:-1]
    up = z[:, 0] * (1.0 if _upward(plan, z[0, 0]) else -1.0)
    side = np.sum(np.cross(o[:, 1] - o[:, 0], end - o[:, 0]) * up, -1) / plan.chain.length**2
    return [Sides(side, ("elbow right", "elbow left", "elbow straight"))]


def _slide(plan: Plan, q: Array) -> list[Sides]:
    """Front or rear, and on which side of the second axis, of two turns, a slide across the second and a wrist."""
    g = plan.geometry
    kinds = list(plan.prismatic[:3]) == [False, False, True]
    if plan.n != 6 or not kinds or _wrist_joint(plan) != 4 or g.pairs[0].angle < LABELLED_ANGLE:
        return []
    if abs(g.pairs[1].angle - np.pi / 2) > NO_SIDE:
        return []
    z, o = axes_at(plan.chain, np.vstack([q, np.zeros(plan.n)]))
    wrist = _spherical_point(plan, q)
    up = z[:, 0] * (1.0 if _upward(plan, z[0, 0]) else -1.0)
    forward = _perpendicular(np.cross(z[:, 1], up), up)
    reach = np.sum((wrist - o[:, 0]) * forward, -1)[:-1] / plan.chain.length
    out = np.sum((wrist - o[:, 1]) * z[:, 2], -1)[:-1] / plan.chain.length
    return [Sides(reach, ("front", "rear", "")), Sides(out, ("slide out", "slide back", "slide in"))]


def _seven_joints(plan: Plan, q: Array) -> list[Sides]:
    groups = {group.joints for group in plan.geometry.spherical}
    if plan.n != 7 or plan.prismatic.any() or not {(0, 1, 2), (4, 5, 6)} <= groups:
        return []
    z, _ = axes_at(plan.chain, q)
    return [_bend(z, 1, "shoulder"), _bend(z, 3, "elbow")]


def _wrist(plan: Plan, q: Array) -> list[Sides]:
    if plan.n < 6 or plan.prismatic[-3:].any():
        return []
    pairs = plan.geometry.pairs
    named = _wrist_joint(plan) is not None or (has_elbow(plan) and min(p.angle for p in pairs[-2:]) > LABELLED_ANGLE)
    if not named:
        return []
    z, _ = axes_at(plan.chain, q)
    return [_bend(z, plan.n - 2, "wrist")]


def _bend(z: Array, middle: int, name: str) -> Sides:
    """Return the sine of the bend about a joint, from the axis before it to the one behind it, of axes z (m, n, 3)."""
    sine = np.sum(np.cross(z[:, middle - 1], z[:, middle + 1]) * z[:, middle], -1)
    return Sides(sine, (f"{name} no flip", f"{name} flip", f"{name} straight"))


def _aspect(plan: Plan, q: Array) -> list[str]:
    if plan.n != 6:
        return [f"solution {i + 1}" for i in range(len(q))]
    det = determinant(plan.chain, q)
    return [("aspect +" if d > 0 else "aspect -") if abs(d) > ASPECT_SIGN else "" for d in det]


def _spherical_point(plan: Plan, q: Array) -> Array:
    """Return the wrist centre (m + 1, 3) at each row of q and, last, at zero."""
    joint = _wrist_joint(plan)
    z, o = axes_at(plan.chain, np.vstack([q, np.zeros(plan.n)]))
    group = next(g for g in plan.geometry.spherical if g.joints[1] == joint)
    along = (np.array(group.point) - o[-1, joint]) @ z[-1, joint]
    return o[:, joint] + along * z[:, joint]


def _meeting(u: Array, a: Array, v: Array, b: Array) -> Array:
    """Return where lines (m, 3) through a along u and through b along v meet."""
    cross = np.cross(u, v)
    t = np.sum(np.cross(b - a, v) * cross, -1) / np.sum(cross * cross, -1)
    return a + t[:, None] * u


def _tool_points(plan: Plan, q: Array) -> Array:
    return plan.chain.native.fk(np.vstack([q, np.zeros(plan.n)]))[..., :3, 3]


def _upward(plan: Plan, axis: Array) -> bool:
    up = plan.chain.links[0][:3, 2] if abs(axis[2]) < 0.5 else np.array([0.0, 0.0, 1.0])
    return bool(axis @ up >= 0)


def _along(v: Array, axis: Array) -> Array:
    return np.sum(v * axis, -1)[..., None] * axis


def _perpendicular(v: Array, axis: Array) -> Array:
    v = v - _along(v, np.broadcast_to(axis, v.shape))
    return v / np.maximum(np.linalg.norm(v, axis=-1, keepdims=True), TINY)
