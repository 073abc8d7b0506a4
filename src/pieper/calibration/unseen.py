"""What measurements cannot see, in words."""

from __future__ import annotations

import numpy as np

from pieper.calibration.model import AxesModel, adjoint
from pieper.calibration.parameters import Parameters
from pieper.kinematics.arrays import Array
from pieper.kinematics.pose import skew

#: A known motion belongs to what is unseen when this part of it lies there (a cosine).
LIES_THERE = 0.99
#: Numbers that make up less than this part of a direction are not named.
NAMED = 0.3


def in_words(model: AxesModel, parameters: Parameters, unseen: Array, sizes: Array) -> tuple[str, ...]:
    """Return one sentence part an unseen direction: first motions one knows, then what is left by its largest numbers.

    Args:
        model: The fitted arm.
        parameters: Its numbers.
        unseen: (m, k) orthonormal directions of scaled numbers, the set-up's after the arm's; held numbers among them.
        sizes: (k,) what they are scaled by.
    """
    held = np.flatnonzero(~parameters.free)
    known = np.eye(len(sizes))[held]
    space = _without(unseen, known)
    if not len(space):
        return ()
    words: list[str] = []
    whole, told = space, np.zeros((0, len(sizes)))
    for name, direction in _motions(model, parameters):
        scaled = np.zeros(len(sizes))
        scaled[: parameters.count] = direction / sizes[: parameters.count]
        scaled[held] = 0.0
        size = np.linalg.norm(scaled)
        if size == 0 or not len(space):
            continue
        along = whole.T @ (whole @ scaled) / size
        rest = along - told.T @ (told @ along)
        if np.linalg.norm(along) > LIES_THERE and np.linalg.norm(rest) > NAMED:
            words.append(name)
            told = np.vstack([told, rest / np.linalg.norm(rest)])
            space = _without(whole, told)
    names = [*parameters.names, *(f"set-up {k + 1}" for k in range(len(sizes) - parameters.count))]
    for direction in _simple(space):
        size = np.abs(direction)
        order = [k for k in np.argsort(-size) if size[k] > NAMED * size.max()]
        words.append(" with ".join(names[k] for k in order[:4]))
    return tuple(words)


def _motions(model: AxesModel, parameters: Parameters) -> list[tuple[str, Array]]:
    """Return named motions as numbers (k,), SI: the tool's turns, the arm as a whole moved, turned and scaled."""
    out: list[tuple[str, Array]] = []
    # a turn about the tool point moves the tool's frame there and nothing else
    p = model.home[:3, 3] - parameters.about
    for axis in range(3):
        step = np.zeros(parameters.count)
        turn = np.eye(3)[axis]
        step[parameters.of_tool] = [*turn, *-(skew(turn) @ p)]
        out.append((f"orientation of the tool about {'xyz'[axis]}", step))
    for what in ("place of the arm along", "orientation of the arm about"):
        for axis in range(3):
            twist = np.zeros(6)
            twist[axis + (3 if what.startswith("place") else 0)] = 1.0
            out.append((f"{what} {'xyz'[axis]} of the base frame", _whole(model, parameters, twist)))
    step = np.zeros(parameters.count)
    for B, at, p_i, slides in zip(
        model.directions(parameters.about), parameters.of_axis, model.points, model.prismatic, strict=True
    ):
        if not slides:
            step[at] = np.linalg.lstsq(B, np.concatenate([np.zeros(3), p_i]), rcond=None)[0]
    step[parameters.of_tool] = [0.0, 0.0, 0.0, *model.home[:3, 3]]
    out.append(("size of the arm", step))
    return out


def _whole(model: AxesModel, parameters: Parameters, twist: Array) -> Array:
    """Return the numbers (k,) that move the whole arm by a small twist (turn first, about the base frame's origin)."""
    step = np.zeros(parameters.count)
    for B, at, screw in zip(model.directions(parameters.about), parameters.of_axis, model.screws, strict=True):
        change = _bracket(twist) @ screw
        moved = np.stack([_bracket(b) @ screw for b in B.T], 1)
        step[at] = np.linalg.lstsq(moved, change, rcond=None)[0]
    T = np.eye(4)
    T[:3, 3] = -parameters.about
    step[parameters.of_tool] = adjoint(T) @ twist
    return step


def _bracket(twist: Array) -> Array:
    """Return the matrix (6, 6) of the Lie bracket with a twist, turn first."""
    out = np.zeros((6, 6))
    out[:3, :3] = out[3:, 3:] = skew(twist[:3])
    out[3:, :3] = skew(twist[3:])
    return out


def _without(space: Array, directions: Array) -> Array:
    """Return an orthonormal basis (m', k) of what of a space (m, k) is orthogonal to directions (j, k)."""
    if not len(space) or not len(directions):
        return space
    rest = space - (space @ directions.T) @ directions
    _, s, V = np.linalg.svd(rest, full_matrices=False)
    return V[s > 0.5]


def _simple(space: Array) -> Array:
    """Return another basis (m, k) of a space, in which each direction has few numbers (reduced echelon form)."""
    rows = space.copy()
    for i in range(len(rows)):
        column = int(np.argmax(np.abs(rows[i:]).max(0)))
        best = i + int(np.argmax(np.abs(rows[i:, column])))
        rows[[i, best]] = rows[[best, i]]
        rows[i] /= rows[i, column]
        for j in range(len(rows)):
            if j != i:
                rows[j] -= rows[j, column] * rows[i]
    return rows
