"""What a robot's file says of its looks: boxes, cylinders, spheres and meshes of its links, in the arm's frames."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, TypeAlias
from xml.parsers import expat

import numpy as np
import numpy.typing as npt

from pieper.description import mjcf, urdf, xacro
from pieper.description.dh import Description
from pieper.description.tree import Tree
from pieper.description.tree_bodies import links_of
from pieper.description.urdf_solids import mesh_file, numbers_of, origin_of
from pieper.description.wholefile import bytes_of

Array = npt.NDArray[np.float64]
#: A link's shapes: where each stands in the link, and what it is.
Shapes: TypeAlias = "dict[str, list[tuple[Array, dict[str, Any]]]]"


@dataclass(frozen=True, eq=False)
class Visual:
    """One shape that a link looks like.

    Attributes:
        name: Of the link.
        on: What carries it: 0 the base, k the link that joint k (1-based) moves.
        T: (4, 4) where it stands in the frame of `Arm.frames` of that number, m.
        kind: "box", "cylinder", "capsule", "sphere" or "mesh".
        size: (3,) of a box; (2,) radius and length of a cylinder or a capsule; (1,) radius of a sphere; (3,) scale
            of a mesh.
        mesh: The mesh as the file names it, or None.
        colour: Red, green, blue and opacity, 0 to 1, or None where the file says none.
    """

    name: str
    on: int
    T: Array
    kind: str
    size: tuple[float, ...]
    mesh: str | None = None
    colour: tuple[float, float, float, float] | None = None


@dataclass(frozen=True, eq=False)
class Visuals:
    """What an arm looks like, and what could not be read, in sentences.

    Attributes:
        shapes: Its shapes.
        notes: What was left out.
        file: The file that says them, from whose place meshes are looked for.
        triangles: Mesh -> (k, 3, 3) corners, where the file's reader has them (MJCF); other meshes are files.
    """

    shapes: tuple[Visual, ...] = ()
    notes: tuple[str, ...] = ()
    file: str = ""
    triangles: dict[str, npt.NDArray[np.float32]] | None = None

    def mesh_file(self, name: str) -> Path:
        """Return the file of a mesh: beside the robot's, or in the package named, which a folder above holds.

        Raises:
            InputError: There is no such file.
        """
        return mesh_file(Path(self.file), name)


def visuals_of(arm: Description) -> Visuals:
    """Return what the file that an arm was read from says of its looks; nothing for an arm of a table or the catalogue.

    Shapes are in the arm's own frames, at their zero, whatever the arm's base and tool are now. An arm whose rows were
    changed after it was read is another arm: its looks are not these.

    Raises:
        InputError: The file is gone, or cannot be read any more.
    """
    origin = arm.origin
    if origin is None:
        return Visuals()
    read = _of_mjcf if origin.kind == "MJCF" else _of_urdf
    tree, shapes, notes, triangles = read(arm, Path(origin.file))
    at = arm.base if arm.unmeasured is None else arm.unmeasured.at
    found: list[Visual] = []
    for link, on, T in links_of(replace(arm, base=at), tree, origin.base, origin.tip):
        for local, said in shapes.get(link, ()):
            found.append(Visual(name=link, on=on, T=T @ local, **said))
    return Visuals(tuple(found), tuple(notes), origin.file, triangles)


Read: TypeAlias = "tuple[Tree, Shapes, list[str], dict[str, npt.NDArray[np.float32]]]"


def _of_urdf(arm: Description, path: Path) -> Read:
    text = xacro.expanded(path, {}) if path.suffix.lower() == ".xacro" else None
    data = bytes_of(path, urdf.LARGEST_FILE, "URDF") if text is None else text.encode()
    exact = True if arm.unmeasured is None else arm.unmeasured.exact_angles
    shapes, notes = _said(data)
    return urdf.parse(data, str(path), exact), shapes, notes, {}


def _said(data: bytes) -> tuple[Shapes, list[str]]:
    """Return the <visual> shapes of each link of a URDF, and sentences on those that cannot be read."""
    shapes: Shapes = {}
    notes: list[str] = []
    named: dict[str, tuple[float, ...]] = {}
    #: visuals whose material is said by its name, which may be said later
    waiting: list[tuple[dict[str, Any], str]] = []
    at: list[str] = []
    link, T, material, mine = "", np.eye(4), "", list[dict[str, Any]]()

    def start(tag: str, said: dict[str, str]) -> None:
        nonlocal link, T, material, mine
        at.append(tag)
        match tuple(at):
            case ("robot", "link"):
                link = said.get("name", "")
            case ("robot", "link", "visual"):
                T, material, mine = np.eye(4), "", []
            case ("robot", "link", "visual", "origin"):
                T = origin_of(said)
            case ("robot", "link", "visual", "geometry", kind):
                try:
                    shape = _shape(kind, said)
                except (ValueError, KeyError):
                    notes.append(f"A visual <{kind}> of {link!r} was left out: it cannot be read.")
                else:
                    mine.append(shape)
                    shapes.setdefault(link, []).append((T, shape))
            case ("robot", "material") | ("robot", "link", "visual", "material"):
                material = said.get("name", "")
                if len(at) > 2:
                    waiting.extend((shape, material) for shape in mine)
            case ("robot", "material", "color") | ("robot", "link", "visual", "material", "color"):
                try:
                    colour = tuple(min(max(v, 0.0), 1.0) for v in numbers_of(said.get("rgba", ""), 4))
                except ValueError:
                    return
                if len(at) > 3:
                    for shape in mine:
                        shape["colour"] = colour
                if material:
                    named.setdefault(material, colour)

    def end(_: str) -> None:
        at.pop()

    parser = expat.ParserCreate()
    parser.StartElementHandler, parser.EndElementHandler = start, end
    parser.Parse(data, True)
    for shape, name in waiting:
        if shape.get("colour") is None and name in named:
            shape["colour"] = named[name]
    for name in list(shapes):
        good = [(T, shape) for T, shape in shapes[name] if np.isfinite(T).all()]
        if len(good) < len(shapes[name]):
            notes.append(f"A visual of {name!r} was left out: its place cannot be read.")
        shapes[name] = good
    return shapes, notes


def _shape(kind: str, said: dict[str, str]) -> dict[str, Any]:
    if kind == "box":
        return {"kind": kind, "size": _sizes(said["size"], 3)}
    if kind == "cylinder":
        return {"kind": kind, "size": (*_sizes(said["radius"], 1), *_sizes(said["length"], 1))}
    if kind == "sphere":
        return {"kind": kind, "size": _sizes(said["radius"], 1)}
    if kind != "mesh" or not said["filename"]:
        raise ValueError(kind)
    scale = tuple(numbers_of(said.get("scale", "1 1 1"), 3))
    if not np.isfinite(scale).all():
        raise ValueError(kind)
    return {"kind": kind, "size": scale, "mesh": said["filename"]}


def _sizes(text: str, count: int) -> tuple[float, ...]:
    values = tuple(numbers_of(text, count))
    if not all(np.isfinite(v) and v > 0 for v in values):
        raise ValueError(text)
    return values


def _of_mjcf(arm: Description, path: Path) -> Read:
    tree, geoms, triangles = mjcf.looks(path)
    shapes: Shapes = {}
    for body, T, shape in geoms:
        shapes.setdefault(body, []).append((T, shape))
    return tree, shapes, [], triangles
