"""Bodies in a robot file or a scene file: a table each, its kind known by its keys; read and written."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from pieper.description.fields import number, numbers, one_key, quantity
from pieper.description.keys import pose_keys, quantity_key
from pieper.description.place import Place, kind_of
from pieper.description.posefield import POSE_KEYS, pose_of
from pieper.description.quantity import UNITS_OF
from pieper.description.shapes import Body, Box, Capsule, Convex, Cylinder, Shape, unique_names
from pieper.errors import InputError

#: Kind -> the keys it is said by.
_STEMS = {
    "box": ("size",),
    "capsule": ("from", "to", "radius"),
    "cylinder": ("radius", "height"),
    "convex body": ("points", "radius"),
}
#: The key by which a kind is known.
_KNOWN_BY = {"size": "box", "from": "capsule", "height": "cylinder", "points": "convex body"}
BASE, TOOL = "base", "tool"


def bodies_of(tables: list[dict], joint_names: Sequence[str], top: Place) -> tuple[Body, ...]:
    """Return the bodies that the tables [[bodies]] of a robot file say."""
    names = _names(tables, top)
    out = []
    for index, table in enumerate(tables):
        place = top.at("bodies", index)
        on = place.text_of(table, "on")
        known = [BASE, *joint_names, TOOL]
        if on not in known:
            place.fail(
                f"{on!r} is no joint of this arm; a body is on {', '.join(known)} (a joint: on the link it moves).",
                "on",
                given=on,
                allowed=known,
            )
        shape = _shape(table, place, ("name", "on", "source"))
        out.append(Body(names[index], known.index(on), shape, place.text_of(table, "source", "")))
    return tuple(out)


def shapes_of(tables: list[dict], top: Place) -> list[Shape]:
    """Return the shapes that the tables [[bodies]] of a scene file say, with their names."""
    names = _names(tables, top)
    for i, table in enumerate(tables):
        if "on" in table:
            top.at("bodies", i).fail(
                "bodies of a scene stand still; one that an arm carries is said in the arm's own file, or with "
                "arm.with_bodies.",
                "on",
                given=table["on"],
            )
    shapes = [_shape(table, top.at("bodies", i), ("name",)) for i, table in enumerate(tables)]
    return [_named(shape, name) for shape, name in zip(shapes, names, strict=True)]


def allowed_of(document: dict, known: Sequence[str], top: Place) -> tuple[tuple[str, str], ...]:
    """Return the pairs of names under [collision] that may touch."""
    place = top.at("collision")
    table = top.table(document.get("collision", {}), "collision")
    place.only(table, ("allowed",))
    pairs = table.get("allowed", [])
    if not isinstance(pairs, list) or any(
        not isinstance(pair, list) or len(pair) != 2 or any(not isinstance(name, str) for name in pair)
        for pair in pairs
    ):
        place.fail(f"must be a list of pairs of names, got {kind_of(pairs)}.", "allowed", given=pairs)
    for name in (name for pair in pairs for name in pair):
        if name not in known:
            place.fail(
                f"there is no body {name!r}; there is {', '.join(known) or 'none'}.",
                "allowed",
                given=name,
                allowed=known,
            )
    return tuple((one, other) for one, other in pairs)


def body_tables(bodies: Sequence[Body], joint_names: Sequence[str]) -> list[dict]:
    """Return bodies as the tables [[bodies]] of a robot file."""
    known = [BASE, *joint_names, TOOL]
    out = []
    for body in bodies:
        table = {"name": body.name, "on": known[body.on], **shape_keys(body.shape)}
        out.append(table | ({"source": body.source} if body.source else {}))
    return out


def shape_keys(shape: Shape) -> dict:
    """Return the keys that say a shape."""
    if isinstance(shape, Capsule):
        said = quantity_key("from", shape.a.tolist(), "length") | quantity_key("to", shape.b.tolist(), "length")
        return said | quantity_key("radius", [shape.r], "length", single=True)
    if isinstance(shape, Box):
        return pose_keys(shape.T) | quantity_key("size", shape.size.tolist(), "length")
    if isinstance(shape, Cylinder):
        said = quantity_key("radius", [shape.r], "length", single=True)
        return pose_keys(shape.T) | said | quantity_key("height", [shape.h], "length", single=True)
    said = {"points_m": [[float(x) for x in point] for point in shape.points]}
    return said | (quantity_key("radius", [shape.r], "length", single=True) if shape.r else {})


def _names(tables: list[dict], top: Place) -> list[str]:
    said = [top.at("bodies", i).text_of(table, "name", "") for i, table in enumerate(tables)]
    for i, name in enumerate(said):
        if name and name in said[:i]:
            top.at("bodies", i).fail(f"the name {name!r} is used twice; names of bodies must differ.", "name")
    return unique_names(
        [
            name or f"{_kind(table, top.at('bodies', i))}"
            for i, (name, table) in enumerate(zip(said, tables, strict=True))
        ]
    )


def _named(shape: Shape, name: str) -> Shape:
    if isinstance(shape, Capsule):
        return Capsule(shape.a, shape.b, shape.r, name)
    if isinstance(shape, Box):
        return Box(shape.T, shape.size, name)
    if isinstance(shape, Cylinder):
        return Cylinder(shape.T, shape.r, shape.h, name)
    return Convex(shape.points, shape.r, name)


def _kind(table: dict, place: Place) -> str:
    kinds = [kind for stem, kind in _KNOWN_BY.items() if any(f"{stem}_{unit}" in table for unit in UNITS_OF["length"])]
    if len(kinds) != 1:
        said = "nothing says what it is" if not kinds else f"it is both a {kinds[0]} and a {kinds[1]}"
        place.fail(
            f"{said}: give from_mm, to_mm and radius_mm (a capsule), size_mm (a box), radius_mm and height_mm (a "
            "cylinder) or points_mm (a convex body).",
            None,
            given=kinds,
        )
    return kinds[0]


def _shape(table: dict, place: Place, also: tuple[str, ...]) -> Shape:
    kind = _kind(table, place)
    own = tuple(f"{stem}_{unit}" for stem in _STEMS[kind] for unit in UNITS_OF["length"])
    posed = kind in ("box", "cylinder")
    place.only(table, (*also, *own, *(POSE_KEYS if posed else ())))
    _check_sizes(table, own, place, zero=kind == "convex body")
    try:
        if kind == "capsule":
            return Capsule(
                _point(table, "from", place), _point(table, "to", place), quantity(table, "radius", "length", place)
            )
        if kind == "convex body":
            return Convex(_points(table, place), quantity(table, "radius", "length", place, default=0.0))
        T = pose_of(table, place, also=(*also, *own))
        if kind == "box":
            return Box(T, _point(table, "size", place))
        return Cylinder(T, quantity(table, "radius", "length", place), quantity(table, "height", "length", place))
    except InputError as error:
        if "file" in error.data:
            raise
        place.fail(str(error), None, **error.data)


def _check_sizes(table: dict, keys: Sequence[str], place: Place, *, zero: bool) -> None:
    """Refuse a size that is none in the unit of the file: metres in a message would not be what stands there."""
    for key in keys:
        stem, unit = key.rsplit("_", 1)
        value = table.get(key)
        for one in value if isinstance(value, list) else [value]:
            if stem not in ("size", "radius", "height") or not isinstance(one, (int, float)):
                continue
            if one < 0 or (one == 0 and not zero):
                place.fail(
                    f"must be {'at least' if zero else 'more than'} zero, {unit}, got {one:g}.", key, given=value
                )


def _point(table: dict, stem: str, place: Place) -> list[float]:
    key, unit = one_key(table, stem, UNITS_OF["length"], place, required=True)
    return numbers(table[key or ""], unit, 3, place, key or "")


def _points(table: dict, place: Place) -> npt.NDArray[np.float64]:
    key, unit = one_key(table, "points", UNITS_OF["length"], place, required=True)
    rows = table[key or ""]
    if not isinstance(rows, list) or any(not isinstance(row, list) or len(row) != 3 for row in rows):
        place.fail(f"must be a list of points of three numbers, got {kind_of(rows)}.", key)
    return np.array([[number(value, unit, place, key or "") for value in row] for row in rows]).reshape(-1, 3)
