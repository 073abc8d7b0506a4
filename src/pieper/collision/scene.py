"""What stands around an arm, and which of it may be touched by which body; from shapes or from a file."""

from __future__ import annotations

import os
import tomllib
from collections.abc import Iterator, Sequence
from pathlib import Path

from pieper import arguments
from pieper.description.bodyfield import shape_keys, shapes_of
from pieper.description.place import Place, kind_of
from pieper.description.robotparse import LARGEST_FILE
from pieper.description.robottext import text_of
from pieper.description.shapes import KINDS, Shape, unique_names
from pieper.description.wholefile import bytes_of, replace_file
from pieper.errors import InputError
from pieper.words_by_number import plural


class Scene(Sequence[Shape]):
    """Obstacles in the frame in which the arm's base is; unchangeable.

    Args:
        obstacles: Shapes; one without a name is called by its kind and a number.
        allowed: Pairs (a body of the arm, an obstacle) that may touch, such as a gripper and what it takes up.

    Attributes:
        names: One name an obstacle.
    """

    def __init__(self, obstacles: Sequence[Shape] = (), *, allowed: Sequence[tuple[str, str]] = ()) -> None:
        if isinstance(obstacles, tuple(KINDS)) or not isinstance(obstacles, Sequence):
            raise InputError(
                f"a scene is made of a list of shapes, got {type(obstacles).__name__}; put it into brackets.",
                given=obstacles,
            )
        for i, shape in enumerate(obstacles):
            if not isinstance(shape, tuple(KINDS)):
                raise InputError(
                    f"obstacle {i + 1} of the scene must be a Box, Capsule, Cylinder or Convex, got "
                    f"{type(shape).__name__}.",
                    index=i,
                    given=shape,
                )
        said = [shape.name for shape in obstacles if shape.name]
        twice = sorted({name for name in said if said.count(name) > 1})
        if twice:
            raise InputError(f"two obstacles are called {twice[0]!r}; names must differ.", given=twice[0])
        self._obstacles = tuple(obstacles)
        self.names = tuple(unique_names([shape.name or KINDS[type(shape)] for shape in obstacles]))
        self.allowed = frozenset(arguments.pairs(allowed, "allowed", "names of bodies"))
        for one, other in self.allowed:
            if one not in self.names and other not in self.names:
                raise InputError(
                    f"({one!r}, {other!r}) may touch, but neither is an obstacle of the scene; it has "
                    f"{', '.join(self.names) or 'none'}.",
                    given=(one, other),
                    allowed=self.names,
                )

    def __len__(self) -> int:
        return len(self._obstacles)

    def __getitem__(self, index: int) -> Shape:  # type: ignore[override]
        return self._obstacles[index]

    def __iter__(self) -> Iterator[Shape]:
        return iter(self._obstacles)

    @staticmethod
    def load(path: str | os.PathLike[str]) -> Scene:
        """Read a scene file: a table [[bodies]] an obstacle, as a robot file says bodies; pairs under [collision].

        Raises:
            InputError: The file cannot be read or says something impossible; the message names file and line.
        """
        file = str(arguments.file(path))
        data = bytes_of(Path(file), LARGEST_FILE, "scene file")
        try:
            document = tomllib.loads(data.decode("utf-8-sig"))
        except (UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
            raise InputError(f"{file}: not valid TOML: {error}.", file=file) from None
        top = Place(file, data.decode("utf-8-sig"))
        top.only(document, ("bodies", "collision", "notes"))
        tables = document.get("bodies", [])
        if not isinstance(tables, list) or any(not isinstance(table, dict) for table in tables):
            top.fail(f"must be an array of tables, each under [[bodies]], got {kind_of(tables)}.", "bodies")
        pairs = top.at("collision").table(document.get("collision", {}), "collision").get("allowed", [])
        if not isinstance(pairs, list) or any(not isinstance(p, list) or len(p) != 2 for p in pairs):
            top.at("collision").fail(f"must be a list of pairs of names, got {kind_of(pairs)}.", "allowed")
        return Scene(shapes_of(tables, top), allowed=[(a, b) for a, b in pairs])

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the scene as a file that `load` reads, whole or not at all.

        Raises:
            InputError: Another ending than .toml, or a place that cannot be written.
        """
        path = arguments.file_ending(path, (".toml", ""), "a scene")
        tables = [{"name": name, **shape_keys(s)} for name, s in zip(self.names, self._obstacles, strict=True)]
        top: dict = {"bodies": tables}
        if self.allowed:
            top["collision"] = {"allowed": [list(pair) for pair in sorted(self.allowed)]}
        replace_file(path, text_of(top))

    def __repr__(self) -> str:
        return f"<Scene of {plural(len(self), 'obstacle')}: {', '.join(self.names)}>"


#: What there is where nothing was said: the arm alone.
EMPTY = Scene()
