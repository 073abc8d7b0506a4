"""The arms that ship: one robot file each, read when asked for."""

from __future__ import annotations

import difflib
import os
from functools import cache

from pieper.description.dh import Description
from pieper.description.robotfile import read
from pieper.errors import InputError

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "catalog")


@cache
def names() -> tuple[str, ...]:
    """Return the names of the arms that ship, sorted; no file is opened."""
    return tuple(sorted(name[: -len(".toml")] for name in os.listdir(FOLDER) if name.endswith(".toml")))


def path_of(name: str) -> str:
    """Return the robot file of a catalogue arm.

    Raises:
        InputError: There is no such arm; the message has the nearest names.
    """
    if name not in names():
        raise InputError(_unknown(name), given=name, allowed=names())
    return os.path.join(FOLDER, f"{name}.toml")


def load(name: str) -> Description:
    """Return the description of a catalogue arm.

    Args:
        name: One of `names()`, for example "denso-vp6242".

    Raises:
        InputError: There is no such arm; the message has the nearest names.
    """
    return read(path_of(name))


def _unknown(name: str) -> str:
    wanted = str(name).strip().lower().replace("_", "-").replace(" ", "-")
    bare = {other.replace("-", ""): other for other in names()}
    squeezed = wanted.replace("-", "")
    near = [wanted] if wanted in names() else []
    near += [other for key, other in bare.items() if squeezed and squeezed in key]
    near += difflib.get_close_matches(wanted, names(), n=3, cutoff=0.5)
    # "ur5" should find "universal-robots-ur5e", whose maker's name hides the likeness
    near += [other for other in names() if difflib.get_close_matches(wanted, [other.split("-")[-1]], n=1, cutoff=0.6)]
    near = list(dict.fromkeys(near))[:5]
    hint = f" Did you mean {', '.join(near)}?" if near else ""
    return f"there is no arm {name!r} in the catalogue.{hint} pieper.catalog() lists all {len(names())}."
