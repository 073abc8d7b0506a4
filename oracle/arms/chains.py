"""Random six-joint chains of the closed-form families, wherever in the chain their joints can stand."""

from __future__ import annotations

import numpy as np

from pieper.kinematics.chain import Chain
from pieper.kinematics.pose import inverse, rotation_about, rotation_x, rotation_z, transform, translation

QUARTER = np.pi / 2


def _rigid(rng) -> np.ndarray:
    axis = rng.standard_normal(3)
    return transform(rotation_about(axis / np.linalg.norm(axis), rng.uniform(-np.pi, np.pi)), rng.uniform(-0.5, 0.5, 3))


def _typed(rng) -> np.ndarray:
    """A link as tables have it: twists of right angles, many lengths zero."""
    shift = translation(float(rng.choice([0, 0, 0.3, 0.5])), 0.0, float(rng.choice([0, 0, 0.2, 0.4])))
    return (
        rotation_z(float(rng.choice([0, QUARTER])))
        @ shift
        @ rotation_x(float(rng.choice([0, QUARTER, -QUARTER, np.pi])))
    )


def wrist_arm(rng, first: int, others: str, typed: bool) -> Chain:
    """Return an arm with a spherical wrist at joints first..first+2 and three others, in loop order after the wrist."""
    links = [(_typed if typed else _rigid)(rng) for _ in range(7)]
    for k in (first + 1, first + 2):
        twist = float(rng.choice([-1, 1])) * QUARTER if typed else rng.uniform(0.3, 2.8)
        links[k] = rotation_z(rng.uniform(-3, 3)) @ rotation_x(twist) @ rotation_z(rng.uniform(-3, 3))
    for j in range(first, first + 3):  # where a frame sits on its axis must not matter
        shift = translation(z=rng.uniform(-0.3, 0.3))
        links[j], links[j + 1] = links[j] @ shift, inverse(shift) @ links[j + 1]
    types = ["R"] * 6
    for j, kind in zip([*range(first + 3, 6), *range(first)], others, strict=True):
        types[j] = kind
    return Chain.of(np.array(links), np.array([t == "P" for t in types]))


def plane_arm(rng, first: int, types: str, typed: bool) -> Chain:
    """Return an arm whose joints first..first+2 turn about parallel axes (of either sense) or slide across them."""
    links = [(_typed if typed else _rigid)(rng) for _ in range(7)]
    for k in (first + 1, first + 2):
        links[k] = rotation_z(rng.uniform(-3, 3)) @ translation(*rng.uniform(-0.5, 0.5, 3))
    for j in range(first, first + 3):
        if types[j] == "P":
            gauge = transform(np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]))
        else:
            gauge = rotation_x(np.pi * float(rng.integers(2)))
        links[j], links[j + 1] = links[j] @ gauge, inverse(gauge) @ links[j + 1]
    return Chain.of(np.array(links), np.array([t == "P" for t in types]))


def offset_arm(rng, alike: bool) -> Chain:
    """Return an arm with axes 2 and 3 parallel (of either sense), 1 across them, 4 and 5 meeting, all else any.

    Args:
        rng: The generator.
        alike: Whether the two sides of the arm are alike: no offset of shoulder or forearm, no twist out of the plane.
    """
    links = [_rigid(rng) for _ in range(7)]
    side = float(rng.choice([-1, 1])) * QUARTER
    links[1] = (
        rotation_z(rng.uniform(-3, 3))
        @ translation(x=0.0 if alike else rng.uniform(-0.3, 0.3), z=0.2)
        @ rotation_x(side)
    )
    turned = rotation_x(float(rng.choice([0, np.pi])))
    links[2] = rotation_z(rng.uniform(-3, 3)) @ translation(x=0.5, z=0.0 if alike else rng.uniform(-0.2, 0.2)) @ turned
    if alike:  # axis 4 leaves the elbow along the forearm
        links[3] = rotation_z(rng.uniform(-3, 3)) @ rotation_x(side) @ rotation_z(rng.uniform(-3, 3))
    links[4] = translation(z=0.4) @ rotation_x(rng.uniform(0.4, 2.7)) @ rotation_z(rng.uniform(-3, 3))
    for j in range(6):  # where a frame sits on its axis must not matter
        shift = translation(z=rng.uniform(-0.3, 0.3))
        links[j], links[j + 1] = links[j] @ shift, inverse(shift) @ links[j + 1]
    return Chain.of(np.array(links), np.zeros(6, bool))


def sliding_arm(rng, order: str, typed: bool) -> Chain:
    """Return an arm with joints in an order such as "RPRRPR"; its links any, or such as tables have."""
    links = [(_typed if typed else _rigid)(rng) for _ in range(7)]
    return Chain.of(np.array(links), np.array([kind == "P" for kind in order]))
