"""What a posture of a map must keep clear of: the arm's own bodies and a scene, as plain data that can be sent."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any

import numpy as np

from pieper.collision.bodies import Bodies
from pieper.collision.distance import nearest
from pieper.collision.model import Model, model_of
from pieper.collision.scene import Scene
from pieper.description.dh import Description
from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.chain import Chain


@dataclass(frozen=True, eq=False)
class Around:
    """An arm's bodies and what stands around it.

    Args:
        description: The arm.
        chain: Its chain.
        bodies: Its bodies.
        scene: What stands around it, in the frame in which its base is.
    """

    description: Description
    chain: Chain
    bodies: Bodies
    scene: Scene

    @cached_property
    def model(self) -> Model:
        """The pairs that must keep apart; made where it is asked for, in each process once."""
        return model_of(self.description, self.chain, self.bodies, self.scene)

    def clear(self, q: Array) -> Bools:
        """Return which joint vectors (N, n) touch nothing."""
        return np.asarray(nearest(self.model, np.ascontiguousarray(q))[0] > 0)

    @property
    def fingerprint(self) -> str:
        """What tells this from other bodies, scenes and pairs that may touch."""
        mark = hashlib.sha256()
        for body in self.bodies:
            mark.update(f"{body.name} {body.on} {type(body.shape).__name__}".encode())
            _add(mark, body.shape)
        for shape, name in zip(self.scene, self.scene.names, strict=True):
            mark.update(f"{name} {type(shape).__name__}".encode())
            _add(mark, shape)
        for pair in sorted([sorted(p) for p in self.bodies.allowed] + [sorted(p) for p in self.scene.allowed]):
            mark.update(repr(pair).encode())
        return mark.hexdigest()

    def __getstate__(self) -> dict[str, Any]:
        return {entry.name: getattr(self, entry.name) for entry in fields(self)}


def _add(mark: Any, shape: Any) -> None:
    for entry in fields(shape):
        if entry.name != "name":
            mark.update(np.ascontiguousarray(getattr(shape, entry.name), np.float64).tobytes())
