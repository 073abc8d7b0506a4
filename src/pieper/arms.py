"""Where arms come from: the catalogue and files."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pieper.arm import Arm
    from pieper.description.catalog_index import Entry


def load(
    source: str | os.PathLike[str],
    base: str | None = None,
    tip: str | None = None,
    snap: float | None = None,
    *,
    missing_limits: str = "refuse",
    xacro_args: Mapping[str, str] | None = None,
) -> Arm:
    """Load an arm: a catalogue name or a unique part of one, or a file: .toml, .urdf, .xacro, .xml (MJCF).

    Args:
        source: Name or path.
        base: Link that is the base; in a robot file one of its named frames.
        tip: Link that is the tool; in a robot file one of its named tools.
        snap: As in `Arm`.
        missing_limits: "refuse" a joint whose range the file does not say, or take it as "unlimited".
        xacro_args: Values of the arguments of a .xacro file.

    Raises:
        InputError: No such arm or file, or the file says something impossible or leaves a choice; the message lists it.
    """
    from pieper.arm import Arm
    from pieper.description import source as door

    said = door.read(source, base=base, tip=tip, missing_limits=missing_limits, xacro_args=xacro_args)
    return Arm(said, snap=snap)


def ur_calibrated(path: str | os.PathLike[str]) -> Arm:
    """Load the arm that a UR controller's factory calibration (.yaml of `ur_calibration`) describes.

    Raises:
        InputError: The file is missing or no calibration; the message names link and number.
    """
    from pieper.arm import Arm
    from pieper.description import ur_calibration

    return Arm(ur_calibration.read(path))


def catalog() -> list[str]:
    """Return the names of the arms that ship."""
    from pieper.description import catalog as shelf

    return list(shelf.names())


def find_arms(
    words: str = "",
    *,
    maker: str | None = None,
    joints: int | str | None = None,
    payload: float | None = None,
    reach: float | None = None,
) -> list[Entry]:
    """Return the arms that ship and answer to everything that is said.

    Args:
        words: Words that all stand in the name or the maker.
        maker: A part of the maker's name.
        joints: How many, or their types, such as "RRPR", "6R".
        payload: Carries at least this, kg.
        reach: Reaches at least this far by the maker's own measure, m.

    Returns:
        Entries with `name`, `manufacturer`, `n`, `joint_types`, `payload` (kg) and `reach` (m), None where not known.

    Raises:
        InputError: A number is below zero, or the joints cannot be read.
    """
    from pieper.description import catalog_index

    return list(catalog_index.find(words, maker=maker, joints=joints, payload=payload, reach=reach))
