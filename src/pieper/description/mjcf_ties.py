"""What a MuJoCo model's equality constraints say of its joints: followers, joints held still, ties that no arm has."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from pieper.description.tree import Joint, Mimic, Tree, some


@dataclass(slots=True)
class Ties:
    """The ties of a model, by joint number.

    Args:
        mimics: Follower -> the joint it follows.
        held: Joint -> the value it is held at, rad or m.
        bound: Joint -> what ties it, where no coupling of joints says that.
        rings: Pairs of bodies that are held together, and by what kind of constraint.
        asleep: Joints -> a sentence about a constraint that is not active at the start.
    """

    mimics: dict[int, Mimic] = field(default_factory=dict)
    held: dict[int, float] = field(default_factory=dict)
    bound: dict[int, str] = field(default_factory=dict)
    rings: list[tuple[int, int, str]] = field(default_factory=list)
    asleep: list[tuple[set[str], str]] = field(default_factory=list)


def without_space_tendons(spec: Any, mujoco: Any) -> list[str]:
    """Take tendons through space out of a model, and constraints on them; return the names of those constrained."""
    space = {
        tendon.name: tendon
        for tendon in spec.tendons
        if any(wrap.type != mujoco.mjtWrap.mjWRAP_JOINT for wrap in tendon.path)
    }
    named: list[str] = []
    for equality in list(spec.equalities):
        if equality.type == mujoco.mjtEq.mjEQ_TENDON and {equality.name1, equality.name2} & set(space):
            named += [name for name in (equality.name1, equality.name2) if name in space]
            spec.delete(equality)
    for tendon in space.values():
        spec.delete(tendon)
    return named


def ties_of(model: Any, mujoco: Any) -> Ties:
    """Return what ties the joints of a compiled model."""
    ties = Ties()
    kinds = {int(mujoco.mjtEq.mjEQ_CONNECT): "connect", int(mujoco.mjtEq.mjEQ_WELD): "weld"}
    for e in range(model.neq):
        kind, one, other = int(model.eq_type[e]), int(model.eq_obj1id[e]), int(model.eq_obj2id[e])
        data = [float(value) for value in model.eq_data[e][:5]]
        joints: list[int] = []
        if kind == int(mujoco.mjtEq.mjEQ_JOINT):
            joints = [j for j in (one, other) if j >= 0]
        elif kind == int(mujoco.mjtEq.mjEQ_TENDON):
            joints = sorted({j for tendon in (one, other) for j in _of_tendon(model, mujoco, tendon)})
        if not model.eq_active0[e]:
            names = [name_of(model, j) for j in joints]
            ties.asleep.append((set(names), f"A constraint on {some(names)} is not active at the model's start."))
        elif kind == int(mujoco.mjtEq.mjEQ_JOINT):
            _joints(model, ties, one, other, data)
        elif kind == int(mujoco.mjtEq.mjEQ_TENDON):
            _tendons(model, ties, _of_tendon(model, mujoco, one), _of_tendon(model, mujoco, other), data)
        elif kind in kinds:
            sites = int(model.eq_objtype[e]) == int(mujoco.mjtObj.mjOBJ_SITE)
            bodies = [int(model.site_bodyid[i]) if sites else i for i in (one, other)]
            # a body that is moved by hand is a target, not a part of the robot
            if not any(model.body_mocapid[body] >= 0 for body in bodies):
                ties.rings.append((bodies[0], bodies[1], kinds[kind]))
    return ties


def _of_tendon(model: Any, mujoco: Any, tendon: int) -> dict[int, float]:
    """Return the joints of a tendon and their coefficients; none for one through space."""
    summed: dict[int, float] = {}
    if tendon < 0:
        return summed
    first, count = int(model.tendon_adr[tendon]), int(model.tendon_num[tendon])
    for w in range(first, first + count):
        if int(model.wrap_type[w]) == int(mujoco.mjtWrap.mjWRAP_JOINT):
            joint = int(model.wrap_objid[w])
            summed[joint] = summed.get(joint, 0.0) + float(model.wrap_prm[w])
    return summed


def _joints(model: Any, ties: Ties, follower: int, leader: int, polynomial: list[float]) -> None:
    """Take one constraint on joints: y - y0 = c0 + c1 (x - x0) + ..., from the joints' reference values."""
    if leader < 0:
        ties.held[follower] = _rest(model, follower) + polynomial[0]
        return
    order = int(np.max(np.flatnonzero(polynomial), initial=0))
    if order > 1:
        numbers = " ".join(f"{value:g}" for value in polynomial)
        ties.bound[follower] = f"follows {name_of(model, leader)!r} by a curve (polycoef {numbers})"
        return
    offset = _rest(model, follower) + polynomial[0] - polynomial[1] * _rest(model, leader)
    if polynomial[1] == 0.0:
        ties.held[follower] = offset
    else:
        ties.mimics[follower] = Mimic(name_of(model, leader), polynomial[1], offset)


def _tendons(model: Any, ties: Ties, one: dict[int, float], other: dict[int, float], polynomial: list[float]) -> None:
    """Take one constraint on tendons: of two joints, one follows; of more, or by a curve, there is no coupling."""
    total = dict(one)
    for j, by in other.items():
        total[j] = total.get(j, 0.0) - polynomial[1] * by
    at = sorted((j, by) for j, by in total.items() if by)
    level = polynomial[0] + sum(by * _rest(model, j) for j, by in at)
    if len(at) > 2 or (other and any(polynomial[2:])):
        for j, _ in at:
            ties.bound[j] = f"is tied to {some([name_of(model, k) for k, _ in at if k != j])} by tendons"
    elif len(at) == 2:
        (leader, by), (follower, own) = at
        ties.mimics[follower] = Mimic(name_of(model, leader), -by / own, level / own)
    elif at:
        ties.held[at[0][0]] = level / at[0][1]


def name_of(model: Any, joint: int) -> str:
    """Return a joint's name, or the one it is given by its number; no other joint has it."""
    return _names([str(model.joint(j).name) for j in range(model.njnt)], "joint")[joint]


def body_names(model: Any) -> list[str]:
    """Return the bodies' names, those without one named by their number."""
    return _names([str(model.body(i).name) for i in range(model.nbody)], "body")


def _names(given: list[str], kind: str) -> list[str]:
    out = list(given)
    for i, name in enumerate(given):
        if not name:
            out[i] = f"{kind}_{i}"
            while out[i] in given:
                out[i] += "_"
    return out


def _rest(model: Any, joint: int) -> float:
    return float(model.qpos0[model.jnt_qposadr[joint]])


def remarks(tree: Tree, ties: Ties, bodies: list[str], asked: list[Joint]) -> tuple[str, ...]:
    """Return sentences about the ties of the joints between a base and a tip that are not followed."""
    moving = {joint.name for joint in asked if joint.moves}
    said = [text for names, text in ties.asleep if names & moving]
    for one, other, kind in ties.rings:
        tied = [joint.name for joint, _ in tree.path(bodies[one], bodies[other]) if joint.name in moving]
        if tied:
            said.append(
                f"Bodies {bodies[one]!r} and {bodies[other]!r} are held together ({kind}), which ties "
                f"{some(tied)}; here each moves by itself."
            )
    numbers = {j.name: j.held for j in asked if j.held is not None}
    if numbers:
        values = ", ".join(f"{name} at {value:.6g}" for name, value in numbers.items())
        said.append(f"Held still by the model's constraints: {values} (rad or m).")
    return tuple(said)
