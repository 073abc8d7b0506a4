"""Does a formula for an angle use the angle it is to give?"""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache

import numpy as np

from pieper.algebra.expression import Add, Expr, Sym
from pieper.algebra.formula import ANGLE, is_call
from pieper.algebra.notation import joint_sum
from pieper.judge.model import ArmModel
from pieper.judge.samples import sample
from pieper.tolerances import ROUNDING


def uses_itself(
    model: ArmModel,
    angle: Expr,
    node: Expr,
    definitions: Mapping[str, Expr],
    known: Mapping[str, set[int]] | None = None,
) -> str:
    """Return the place where a formula uses the angle that it is for, "" when it does not.

    A sum of joints with parallel axes may be known before its members are, so c234 may stand in a formula for theta3.
    A sign may be that of the angle's own sine: then it names the branch.

    Args:
        model: the arm.
        angle: the angle, a joint or a sum of joints.
        node: the formula.
        definitions: the file's symbols.
        known: the joints that entries of matrices in the formula, such as R36[3,3], must be known for.
    """
    own = frozenset(j for _, j in joint_sum(angle) or ())
    if not own:
        return ""
    if len(own) == 1:
        (joint,) = own
        for name, joints in sorted((known or {}).items()):
            if joint in joints:
                return name
        return _place(model, joint, node, definitions, set())
    # a formula for a sum is circular when it uses the sum, or every member of it
    for name, joints in sorted((known or {}).items()):
        if own <= joints:
            return name
    places = [_place(model, joint, node, definitions, set()) for joint in own]
    return "" if "" in places else places[0]


def _place(model: ArmModel, joint: int, node: Expr, definitions: Mapping[str, Expr], seen: set[str]) -> str:
    stack: list[Expr] = [node]
    while stack:
        here = stack.pop()
        if is_call(here, "sign", "sgn"):
            continue
        if isinstance(here, Sym) and here.name in definitions:
            inner = definitions[here.name]
            members = net(inner)
            known = members is not None and len(members) > 1 and parallel(model, set(members))
            if here.name not in seen and not known:
                seen.add(here.name)
                if _place(model, joint, inner, definitions, seen):
                    return f"{here.name} = {_short(inner)}"
            continue
        if is_call(here, "sin", "cos", "tan") and (turned := net(here.args[0])) is not None:
            if joint in turned and (len(turned) == 1 or not parallel(model, set(turned))):
                return str(here)
            continue
        parts = net(here)
        if parts is not None and len(joint_sum(here) or ()) > len(parts):
            # (theta1 + theta2) - theta1: the sum is known, and the joints that are taken off it
            parts = {j: 1 for _, j in joint_sum(here) or ()}
        if parts is not None:
            if parts == {joint: parts.get(joint)} or (joint in parts and not parallel(model, set(parts))):
                return str(here)
            continue
        if isinstance(here, Add):
            # theta2 + theta3 among other terms: the joints of a sum go together
            turning = [t for t in here.args if net(t) is not None]
            inside = net(Add.of(*turning)) if turning else None
            if inside and joint in inside and (len(inside) == 1 or not parallel(model, set(inside))):
                return str(Add.of(*turning))
            stack.extend(t for t in here.args if net(t) is None)
            continue
        stack.extend(here.args)
    return ""


def net(node: Expr) -> dict[int, int] | None:
    """The joints of a signed sum with their factors, those that cancel left out; None for anything else."""
    parts = joint_sum(node)
    if not parts:
        return None
    total: dict[int, int] = {}
    for sign, joint in parts:
        total[joint] = total.get(joint, 0) + sign
    return {j: k for j, k in total.items() if k}


def parallel(model: ArmModel, joints: set[int]) -> bool:
    """Whether the axes of joints (1-based) are parallel, so that their sum means something."""
    senses = axis_senses(model)
    first = min(joints)
    return all(senses[first - 1][j - 1] for j in joints)


@lru_cache(maxsize=32)
def axis_senses(model: ArmModel) -> tuple[tuple[int, ...], ...]:
    """For every two joints: 1 where their axes are parallel in every posture, -1 where they are opposed, else 0."""
    samples = sample(model, 6)
    axes = []
    R = np.broadcast_to(np.eye(4), (6, 4, 4))
    for joint, own in enumerate(model.axis_frames(samples.frames, samples.env), 1):
        axes.append((R @ own)[:, :3, 2])
        R = R @ samples.frames[f"A{joint}"]
    dots = np.einsum("ikc,jkc->ijk", np.array(axes), np.array(axes))
    senses = np.where(np.all(dots > 1 - ROUNDING, axis=2), 1, np.where(np.all(dots < -1 + ROUNDING, axis=2), -1, 0))
    return tuple(tuple(row) for row in senses.tolist())


def given_angles(node: Expr, definitions: Mapping[str, Expr]) -> tuple[set[int], list[dict[int, int]]]:
    """The joints, and the sums of joints, that a formula takes as known."""
    joints: set[int] = set()
    sums: list[dict[int, int]] = []
    stack = [node.substitute(dict(definitions))]
    while stack:
        here = stack.pop()
        if is_call(here, "sign", "sgn"):
            continue
        raw, parts = joint_sum(here) or (), net(here)
        if parts is not None and len(raw) > max(1, len(parts)):
            parts = {j: 1 for _, j in raw}
        if parts is not None and len(parts) > 1:
            if parts not in sums:
                sums.append(parts)
            continue
        if isinstance(here, Add):
            # a sum of joints with a constant turn beside it is known as that sum
            turning = [t for t in here.args if net(t) is not None]
            inside = net(Add.of(*turning)) if len(turning) > 1 else None
            if inside and len(inside) > 1 and not any(t.symbols() for t in here.args if net(t) is None):
                if inside not in sums:
                    sums.append(inside)
                continue
        found = ANGLE.match(here.name) if isinstance(here, Sym) else None
        if found:
            joints.add(int(found.group(1)))
        stack.extend(here.args)
    return joints, sums


def _short(node: Expr) -> str:
    text = str(node)
    return text if len(text) <= 60 else text[:57] + "..."
