"""Which door a source goes through: a catalogue name, a robot file, URDF, xacro, MJCF; others refused by name."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np

from pieper import arguments
from pieper.description import catalog, robotfile
from pieper.description.dh import Description
from pieper.description.wholefile import bytes_of
from pieper.errors import InputError
from pieper.kinematics.pose import inverse

#: Endings of files that are known and not read, and what to do instead.
_REFUSED = {
    ".sdf": "SDF is not read. Convert it to a URDF (with sdformat_urdf, for one) and load that.",
    ".world": "A Gazebo world is not read. Take the robot's own URDF, or convert its SDF to a URDF, and load that.",
    ".usd": "USD is not read. Export the robot as URDF (Isaac Sim: File > Export URDF) or as MJCF, and load that.",
    ".step": "A CAD file has no joints to read. Export a URDF from the CAD program and load that.",
    ".srdf": "An SRDF names groups of a robot's joints; load the URDF it belongs to with base= and tip=.",
    ".dae": "A mesh has no joints to read; load the URDF that refers to it.",
}
_REFUSED |= {ending: _REFUSED[".usd"] for ending in (".usda", ".usdc", ".usdz")}
_REFUSED |= {".stp": _REFUSED[".step"], ".stl": _REFUSED[".dae"]}
#: Endings by which a text is a file and not the name of an arm.
_FILES = (".toml", ".urdf", ".xacro", ".xml", ".mjcf", *_REFUSED)


def read(
    source: str | os.PathLike[str],
    *,
    base: str | None = None,
    tip: str | None = None,
    missing_limits: str = "refuse",
    xacro_args: Mapping[str, str] | None = None,
) -> Description:
    """Return the arm that a catalogue name or a file describes.

    Args:
        source: A name of the catalogue or a unique part of one, or a path: .toml, .urdf, .xacro, .xml (MJCF or URDF).
        base: Link (in a robot file: one of its named frames) that is the base.
        tip: Link (in a robot file: one of its named tools) that is the tool.
        missing_limits: "refuse" a URDF joint without a range, or take it as "unlimited".
        xacro_args: Values of the arguments of a .xacro.

    Raises:
        InputError: No such arm or file, a kind of file that is not read, or one that says something impossible.
    """
    path = arguments.file(source, "source", "the name of an arm or the path of a file")
    text = os.fsdecode(os.fspath(source))
    for what, name in (("base", base), ("tip", tip)):
        if name is not None:
            arguments.text(name, f"{what}, the name of a link,")
    arguments.word(missing_limits, "missing_limits", ("refuse", "unlimited"))
    if xacro_args is not None:
        arguments.by_name(xacro_args, "xacro_args", '{"prefix": "left_"}')
    ending = path.suffix.lower()
    is_file = ending in _FILES or os.sep in text or (ending and path.is_file())
    if not is_file:
        try:
            return _chosen(catalog.load(text), base, tip)
        except InputError as error:
            if path.is_file():
                raise InputError(f"{error} There is a file of that name: say ./{text}.", **error.data) from None
            raise
    if ending in _REFUSED:
        raise InputError(f"{text}: {_REFUSED[ending]}", file=text)
    if ending == ".urdf":
        return _urdf(path, base, tip, missing_limits, xacro_args)
    if ending == ".xacro":
        from pieper.description import xacro

        return xacro.read(path, base=base, tip=tip, missing_limits=missing_limits, arguments=xacro_args)
    if ending in (".xml", ".mjcf"):
        from pieper.description import mjcf, urdf

        first = urdf.first_element(bytes_of(path, urdf.LARGEST_FILE, "robot file"), text)
        if first == "mujoco":
            return mjcf.read(path, base=base, tip=tip, missing_limits=missing_limits)
        if first == "robot":
            return _urdf(path, base, tip, missing_limits, xacro_args)
        if f".{first}" in _REFUSED:
            raise InputError(f"{text}: {_REFUSED[f'.{first}']}", file=text)
        raise InputError(
            f"{text}: the first element is <{first}>; a URDF begins with <robot>, an MJCF with <mujoco>.", file=text
        )
    return _chosen(robotfile.read(path), base, tip)


def _urdf(
    path: Path, base: str | None, tip: str | None, missing_limits: str, xacro_args: Mapping[str, str] | None
) -> Description:
    from pieper.description import urdf, xacro

    try:
        return urdf.read(path, base=base, tip=tip, missing_limits=missing_limits)
    except urdf.NotExpanded:
        return xacro.read(path, base=base, tip=tip, missing_limits=missing_limits, arguments=xacro_args)


def _chosen(arm: Description, base: str | None, tip: str | None) -> Description:
    """Return the arm with the base and the tool that its robot file has under these names."""
    for what, name, known in (("base", base, arm.frames), ("tip", tip, arm.tools)):
        if name is not None and name not in known:
            table = "frames" if what == "base" else "tools"
            there = f"it has {', '.join(known)}" if known else f"it has none; write one under [{table}.{name}]"
            raise InputError(
                f"{arm.name} has no {table[:-1]} {name!r} for the {what}: {there}.", given=name, allowed=list(known)
            )
    if base is not None:
        back = inverse(arm.frames[base])
        # every named place is said from the new base too, as the arm is
        frames = {name: np.eye(4) if name == base else np.asarray(back @ T) for name, T in arm.frames.items()}
        arm = replace(arm, base=np.asarray(back @ arm.base), frames=frames, checks=())
    if tip is not None:
        arm = replace(arm, tool=arm.tools[tip], checks=())
    return arm


def write(arm: Description, path: str | os.PathLike[str]) -> None:
    """Write an arm as a robot file, or as a URDF where the name ends in .urdf; whole or not at all.

    Raises:
        InputError: The file cannot be written, or its ending is another format's.
    """
    target = arguments.file(path)
    ending = target.suffix.lower()
    if ending == ".urdf":
        from pieper.description import urdf_text

        urdf_text.write(arm, target)
    elif ending in (".xml", ".mjcf", ".xacro", *_REFUSED):
        raise InputError(
            f"{target}: an arm is written as .toml or .urdf. MuJoCo reads a .urdf, and saves it as MJCF.",
            file=str(target),
        )
    elif ending not in ("", ".toml"):
        raise InputError(
            f"{target}: an arm is written as .toml or .urdf, not as {ending!r}. Name the file {target.stem}.toml.",
            file=str(target),
        )
    else:
        robotfile.write(arm, target)
