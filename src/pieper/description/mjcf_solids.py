"""The geoms of an MJCF that can touch something: as they are, meshes and ellipsoids as what encloses them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from pieper.description import mjcf
from pieper.description.enclose import enclosing
from pieper.description.shapes import Box, Capsule, Cylinder, Shape
from pieper.errors import InputError

Array = npt.NDArray[np.float64]


class Geoms:
    """Shapes of links, read once.

    Args:
        file: The MJCF.

    Attributes:
        tree: Its links and joints.
        notes: What could not be read, in sentences.

    Raises:
        InputError: It cannot be read any more, or one of its meshes is missing.
    """

    def __init__(self, file: str) -> None:
        self.tree, found, self._corners = mjcf.solids(Path(file))
        self._said: dict[str, list[tuple[Array, dict[str, Any]]]] = {}
        for body, T, shape in found:
            self._said.setdefault(body, []).append((T, shape))
        self.notes: list[str] = []

    def of(self, link: str) -> list[tuple[Shape, str]]:
        """Return the shapes of a link in its frame, each with where it comes from; what cannot be taken is noted."""
        out: list[tuple[Shape, str]] = []
        for T, said in self._said.get(link, ()):
            try:
                out.append(self._shape(T, said, link))
            except InputError as error:
                self.notes.append(f"The {said['kind']} of {link!r} was left out: {error}")
        return out

    def _shape(self, T: Array, said: dict[str, Any], link: str) -> tuple[Shape, str]:
        kind, size, source = said["kind"], said["size"], f"the {said['kind']} of {link}"
        if kind == "box":
            return Box(T, size), source
        if kind == "cylinder":
            return Cylinder(T, *size), source
        if kind == "capsule":
            z = T[:3, 2] * size[1] / 2
            return Capsule(T[:3, 3] - z, T[:3, 3] + z, size[0]), source
        if kind == "sphere":
            return Capsule(T[:3, 3], T[:3, 3], size[0]), source
        if kind == "ellipsoid":
            return Box(T, size), f"measured: box about the ellipsoid of {link}"
        corners = self._corners[said["mesh"]].reshape(-1, 3).astype(np.float64)
        shape = enclosing(corners @ T[:3, :3].T + T[:3, 3], "")
        word = "box" if isinstance(shape, Box) else "capsule"
        return shape, f"measured: {word} about the mesh {said['mesh']} of {link}"
