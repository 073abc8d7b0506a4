"""Which of the two joints of a closed form's pair of equations the quartic is written in: decided once for an arm."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.chain import Chain
from pieper.kinematics.pose import inverse, rotation_z, transform, translation
from pieper.tolerances import PAIR_ALWAYS_RANK_ONE

_POSES = 24


def group(chain: Chain, links: np.ndarray, first: int, plane: bool) -> dict[str, Any]:
    """Return what the kernels of the two families of groups are told of an arm: the fields of their geometry.

    Args:
        chain: The arm.
        links: (7, 4, 4) of the loop, m.
        first: First joint (0-based) of the wrist or the plane.
        plane: Whether the group is a plane or a wrist.
    """
    hide_c, first_c, apart = pair_order(chain, links, first, plane)
    return {
        "length": chain.length,
        "links": chain.links,
        "loop": links,
        "slides": tuple(chain.prismatic.tolist()),
        "first": first,
        "hide_c": hide_c,
        "first_c": first_c,
        "apart": apart,
    }


def pair_order(chain: Chain, links: np.ndarray, first: int, plane: bool) -> tuple[bool, bool, bool]:
    """Return (hide_c, first_c, apart) for the pair M f(a) + N f(c) = e that the three joints beside a group obey.

    The choice is a vote over random poses; it is one for all poses so that a solution keeps its slot along a path.

    Args:
        chain: The arm.
        links: (7, 4, 4) of the loop, m.
        first: First joint (0-based) of the wrist or the plane.
        plane: Whether the group is a plane (its normal and height are kept) or a wrist (its centre is).

    Returns:
        Whether the quartic is in c, whether c comes first where the equations fall apart, and whether they do so at
        every pose (M or N is of rank one, so that a combination of the equations holds one joint alone).
    """
    rng = np.random.default_rng(11)
    scaled = np.array(links)
    scaled[:, :3, 3] /= chain.length
    joints = [(first + 3 + k) % 6 for k in range(3)]
    slides = chain.prismatic[joints]
    Q = np.where(
        chain.prismatic, chain.length * rng.uniform(-0.5, 0.5, (_POSES, 6)), rng.uniform(-np.pi, np.pi, (_POSES, 6))
    )
    if plane and slides[1]:
        return False, False, True  # a sliding middle joint leaves each of the two equations one joint, at every pose
    hide_c = first_c = 0
    rank_one = np.ones(2, bool)
    for T in chain.native.fk(Q):
        near = T.copy()
        near[:3, 3] /= chain.length
        closing = scaled[6] @ inverse(near) @ scaled[0]
        pre, A, B, C = (closing if k % 6 == 0 else scaled[k % 6] for k in range(first + 3, first + 7))
        left, right = (_around_plane if plane else _positioning)(pre, A, B, C, slides)
        M, N = _terms(left, slides[0]), -_terms(right, slides[2])
        rank_one &= [abs(np.linalg.det(K)) <= PAIR_ALWAYS_RANK_ONE * np.sum(K * K) for K in (M, N)]
        hide_c += abs(np.linalg.det(M)) >= abs(np.linalg.det(N))
        first_c += np.linalg.norm(_null(M) @ N) >= np.linalg.norm(_null(N) @ M)
    good_m, good_n = 2 * hide_c >= _POSES, 2 * first_c >= _POSES
    if rank_one.any() and not rank_one.all():
        good_n = rank_one[0]  # M alone falls apart: c can be had first, and the other way round
    return bool(good_m), bool(good_n), bool(rank_one.any())


def _motion(x: float, slides: bool) -> np.ndarray:
    return translation(z=x) if slides else transform(rotation_z(x)[:3, :3])


def _positioning(
    pre: Array, A: Array, B: Array, C: Array, slides: Bools
) -> tuple[Callable[[float], Array], Callable[[float], Array]]:
    g = inverse(pre)[:3, 3]

    def left(x: float) -> Array:
        w = (inverse(A) @ inverse(_motion(x, slides[0])) @ [*g, 1])[:3]
        return w[:2] if slides[1] else np.array([w[2], w @ w])

    def right(x: float) -> Array:
        u = (B @ _motion(x, slides[2]) @ [*C[:3, 3], 1])[:3]
        return u[:2] if slides[1] else np.array([u[2], u @ u])

    return left, right


def _around_plane(
    pre: Array, A: Array, B: Array, C: Array, slides: Bools
) -> tuple[Callable[[float], Array], Callable[[float], Array]]:
    h, k = pre[2, :3], C[:3, 2]

    def left(x: float) -> Array:
        turned = h if slides[0] else _motion(x, False)[:3, :3].T @ h
        return np.array([(A[:3, :3].T @ turned)[2], turned @ A[:3, 3] + (x * h[2] if slides[0] else 0.0)])

    def right(x: float) -> Array:
        u = B[:3, :3] @ (k if slides[2] else _motion(x, False)[:3, :3] @ k)
        return np.array([u[2], -(u @ B[:3, 3]) - (x * k[2] if slides[2] else 0.0)])

    return left, right


def _terms(side: Callable[[float], Array], slides: bool) -> np.ndarray:
    """Return the coefficients (2, 2) of (cos, sin) or (d, d^2) of two equations, from three values of the joint."""
    zero, other, opposite = side(0.0), side(1.0 if slides else np.pi / 2), side(-1.0 if slides else np.pi)
    if slides:
        return np.stack([(other - opposite) / 2, (other + opposite) / 2 - zero], -1)
    return np.stack([(zero - opposite) / 2, other - (zero + opposite) / 2], -1)


def _null(matrix: np.ndarray) -> np.ndarray:
    return np.linalg.svd(matrix)[0][:, -1]
