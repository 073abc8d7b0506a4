"""The arms that ship: one robot file each, read when asked for."""

from __future__ import annotations

import os
from functools import cache

from pieper.description.dh import Description
from pieper.description.robotfile import read
from pieper.errors import InputError
from pieper.tolerances import LEAST_LIKENESS

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "catalog")


@cache
def names() -> tuple[str, ...]:
    """Return the names of the arms that ship, sorted; no file is opened."""
    return tuple(sorted(name[: -len(".toml")] for name in os.listdir(FOLDER) if name.endswith(".toml")))


def path_of(name: str) -> str:
    """Return the robot file of a catalogue arm, called by its name or a part of it; see `full_name`.

    Raises:
        InputError: There is no such arm, or the part fits several; the message has the nearest names.
    """
    return os.path.join(FOLDER, f"{full_name(name)}.toml")


def full_name(part: str) -> str:
    """Return the catalogue name that a part stands for: the only one that has it, or the only one that ends in it.

    Case, blanks, underscores and hyphens do not matter: "Panda" and "UR 5e" are understood; "ur5" is the arm whose name
    ends so, although "ur5e" has it too.

    Raises:
        InputError: None has it, or several have; the message lists those, or the nearest names.
    """
    if part in names():
        return part
    wanted = _squeezed(part)
    # a letter is the whole end of some name by chance, and no part that anybody means
    having = [name for name in names() if len(wanted) > 1 and wanted in _squeezed(name)]
    ending = [name for name in having if any(wanted == _squeezed(end) for end in _ends(name))]
    for found in (ending, having):
        if len(found) == 1:
            return found[0]
    if having:
        few = ", ".join(having[:8]) + (f" and {len(having) - 8} more" if len(having) > 8 else "")
        raise InputError(f"{part!r} may be {few}: say which.", given=part, allowed=tuple(having))
    raise InputError(_unknown(part), given=part, allowed=names())


def _squeezed(name: str) -> str:
    return "".join(c for c in str(name).lower() if c.isalnum())


def _ends(name: str) -> list[str]:
    words = name.split("-")
    return ["-".join(words[i:]) for i in range(len(words))]


def load(name: str) -> Description:
    """Return the description of a catalogue arm.

    Args:
        name: One of `names()`, for example "denso-vp6242", or a part of one; see `full_name`.

    Raises:
        InputError: There is no such arm; the message has the nearest names.
    """
    return read(path_of(name))


def _unknown(name: str) -> str:
    wanted = str(name).strip().lower().replace("_", "-").replace(" ", "-")
    import difflib

    # all its words in some order come first: "kuka iiwa" means the arms that have both
    words = [word for word in wanted.split("-") if word]
    near = [name for name in names() if words and all(word in name for word in words)]

    # "ur5ee" should find "universal-robots-ur5e", whose maker's name hides the likeness
    def likeness(name: str) -> float:
        return max(difflib.SequenceMatcher(None, wanted, end).ratio() for end in _ends(name))

    alike = sorted(((likeness(name), name) for name in names()), key=lambda pair: -pair[0])
    near += [name for ratio, name in alike if ratio >= LEAST_LIKENESS]
    near = list(dict.fromkeys(near))[:5]
    hint = f" Did you mean {', '.join(near)}?" if near else ""
    every = f"pieper.catalog(), or `pieper robots`, lists all {len(names())}."
    return f"there is no arm {name!r} in the catalogue.{hint} {every}"
