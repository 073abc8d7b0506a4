"""The <collision> shapes of a URDF: boxes, cylinders and spheres as they are, meshes as what encloses them."""

from __future__ import annotations

from pathlib import Path
from xml.parsers import expat

import numpy as np
import numpy.typing as npt

from pieper.description import stl
from pieper.description.enclose import enclosing
from pieper.description.shapes import Box, Capsule, Cylinder, Shape
from pieper.errors import InputError
from pieper.kinematics.orientation import rotation

Array = npt.NDArray[np.float64]


class Solids:
    """Shapes of links, read once.

    Args:
        data: The URDF, which has been parsed before.
        file: Its place, from which meshes are looked for.

    Attributes:
        notes: What could not be read, in sentences.
    """

    def __init__(self, data: bytes, file: str) -> None:
        self._file = Path(file)
        self._said: dict[str, list[tuple[Array, str, dict[str, str]]]] = {}
        self.notes: list[str] = []
        at: list[str] = []
        link, T = "", np.eye(4)

        def start(tag: str, said: dict[str, str]) -> None:
            nonlocal link, T
            at.append(tag)
            match tuple(at):
                case ("robot", "link"):
                    link = said.get("name", "")
                case ("robot", "link", "collision"):
                    T = np.eye(4)
                case ("robot", "link", "collision", "origin"):
                    T = origin_of(said)
                case ("robot", "link", "collision", "geometry", kind):
                    self._said.setdefault(link, []).append((T, kind, dict(said)))

        def end(_: str) -> None:
            at.pop()

        parser = expat.ParserCreate()
        parser.StartElementHandler, parser.EndElementHandler = start, end
        parser.Parse(data, True)

    def __bool__(self) -> bool:
        return bool(self._said)

    def of(self, link: str) -> list[tuple[Shape, str]]:
        """Return the shapes of a link in its frame, each with where it comes from; what cannot be read is noted."""
        out: list[tuple[Shape, str]] = []
        for T, kind, said in self._said.get(link, ()):
            try:
                out.append(self._shape(T, kind, said, link))
            except (InputError, ValueError, KeyError) as error:
                reason = str(error) if isinstance(error, InputError) else "its numbers cannot be read"
                self.notes.append(f"The collision shape of {link!r} was left out: {reason}")
        return out

    def _shape(self, T: Array, kind: str, said: dict[str, str], link: str) -> tuple[Shape, str]:
        source = f"the collision {kind} of {link}"
        if kind == "box":
            return Box(T, numbers_of(said["size"], 3)), source
        if kind in ("cylinder", "capsule"):
            r, h = float(said["radius"]), float(said["length"])
            z = T[:3, 2] * h / 2
            return (Cylinder(T, r, h) if kind == "cylinder" else Capsule(T[:3, 3] - z, T[:3, 3] + z, r)), source
        if kind == "sphere":
            return Capsule(T[:3, 3], T[:3, 3], float(said["radius"])), source
        if kind != "mesh":
            raise InputError(f"a <{kind}> is no shape of a URDF.", given=kind)
        name = said["filename"]
        if not name.lower().endswith(".stl"):
            raise InputError(f"{name} is no STL; other meshes are not read.", file=name)
        points = stl.read(mesh_file(self._file, name)) * np.array(numbers_of(said.get("scale", "1 1 1"), 3))
        shape = enclosing(points @ T[:3, :3].T + T[:3, 3], "")
        word = "box" if isinstance(shape, Box) else "capsule"
        return shape, f"measured: {word} about the mesh {Path(name).name} of {link}"


def mesh_file(file: Path, name: str) -> Path:
    """Return the file of a mesh: beside the robot's, or in the package named, which one of the folders above holds.

    Raises:
        InputError: There is no such file.
    """
    path = name.removeprefix("file://")
    if name.startswith(("package://", "model://")):
        path = name.split("://", 1)[1]
        package, _, rest = path.partition("/")
        for folder in file.resolve().parents:
            for place in (folder / package / rest, folder / rest if folder.name == package else None):
                if place is not None and place.is_file():
                    return place
    place = file.parent / path
    if not place.is_file():
        raise InputError(f"there is no mesh {name}.", file=name)
    return place


def origin_of(said: dict[str, str]) -> Array:
    """Return the pose (4, 4) of an <origin>, NaN where its numbers cannot be read."""
    T = np.eye(4)
    try:
        T[:3, :3] = rotation("rpy", numbers_of(said.get("rpy", "0 0 0"), 3))
        T[:3, 3] = numbers_of(said.get("xyz", "0 0 0"), 3)
    except ValueError:
        T[:3, 3] = np.nan
    return T


def numbers_of(text: str, count: int) -> list[float]:
    """Return so many numbers of a text, or raise ValueError."""
    values = [float(word) for word in text.split()]
    if len(values) != count:
        raise ValueError(text)
    return values
