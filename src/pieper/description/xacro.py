"""Xacro: macros expanded by the packages of the extra `xacro`, then read as a URDF."""

from __future__ import annotations

import contextlib
import io
import os
import re
from collections.abc import Mapping
from pathlib import Path
from typing import NoReturn

from pieper.description import urdf
from pieper.description.dh import Description
from pieper.description.tree import some
from pieper.errors import InputError

#: How many files around one that only defines macros are looked through for one that uses them.
MOST_LOOKED_AT = 300


def read(
    path: str | Path,
    *,
    base: str | None = None,
    tip: str | None = None,
    missing_limits: str = "refuse",
    arguments: Mapping[str, str] | None = None,
) -> Description:
    """Expand a xacro file and read the chain from one of its links to another; see `urdf.read`.

    Args:
        path: A .xacro file. Packages named in $(find ...) are looked for in the folders around it.
        base: Link whose frame is the base.
        tip: Link whose frame is the tool.
        missing_limits: As in `urdf.read`.
        arguments: Values of the file's xacro arguments.

    Raises:
        InputError: The extra is not installed, or the file cannot be expanded; the message says why.
    """
    path = Path(path)
    urdf.bytes_of(path, urdf.LARGEST_FILE, "xacro")
    text = expanded(path, arguments or {})
    if "<joint" not in text:
        users = _users(path)
        which = f": {some(users, 4)}" if users else ""
        raise InputError(
            f"{path}: this xacro expands to no joint; it may only define macros. Load the file that uses them{which}.",
            file=str(path),
            allowed=users,
        )
    return urdf.loads(text, file=str(path), base=base, tip=tip, missing_limits=missing_limits)


def expanded(path: Path, arguments: Mapping[str, str]) -> str:
    """Return the URDF that a xacro file stands for."""
    try:
        import xacro as expander  # pyright: ignore[reportMissingImports]
        from xacrodoc import XacroDoc, packages
    except ImportError:
        raise InputError(
            f"{path}: reading xacro needs an extra: pip install 'pieper[xacro]'; or expand the file first "
            "(xacro in.xacro > out.urdf).",
            file=str(path),
        ) from None
    given = {key: str(value) for key, value in arguments.items()}
    for _ in range(1 + len(_declared(path))):
        said = io.StringIO()
        try:
            # the expander prints its warnings and where it was; they belong into the message, not onto the screen
            with contextlib.redirect_stderr(said), contextlib.redirect_stdout(said):
                # what a failed file left behind (its includes, its packages' folders) is none of this one's, and a
                # file's own folder is where its includes are
                expander.init_stacks(str(path))
                packages.reset()
                packages.look_in([str(folder) for folder in list(path.resolve().parents)[:4]])
                return XacroDoc.from_file(str(path), subargs=given, resolve_packages=False).to_urdf_string()
        except (Exception, SystemExit) as error:  # it evaluates expressions of the file: anything can come
            reason = _reason(error)
            early = re.search(r"Undefined substitution argument (\w+)", reason)
            default = _declared(path).get(early[1]) if early else None
            if early is None or default is None or early[1] in given or "$" in default:
                _refuse(path, reason, given)
            # used before the line that declares it, as in <robot name="$(arg name)">
            given[early[1]] = default
    raise AssertionError("every argument was tried")


def _refuse(path: Path, reason: str, given: Mapping[str, str]) -> NoReturn:
    """Raise what the expander said as a sentence with a cure."""
    asked = [name for name, default in _declared(path).items() if default is None and name not in given]
    missing = re.search(r"Undefined substitution argument (\w+)", reason)
    if missing and missing[1] not in asked:
        asked.append(missing[1])
    if asked:
        said_so = ", ".join(f"{name!r}: 'value'" for name in asked)
        raise InputError(
            f"{path}: the xacro asks for {', '.join(asked)} and has no default. Say pieper.load(..., "
            f"xacro_args={{{said_so}}}).",
            file=str(path),
            allowed=asked,
        ) from None
    expand = "expand the xacro where its packages are installed (xacro in.xacro > out.urdf) and load the .urdf."
    package = re.search(r"Package not found: (\S+)", reason)
    file = re.search(r"No such file or directory: \'?([^\s\']+)", reason)
    if package:
        what, cure = f"needs the package {package[1]!r}, which is not in the folders around it", "Lay it there, or"
    elif file:
        what, cure = f"needs {file[1]!r}, which is not there", "Lay it there, or"
    else:
        what, cure = f"could not be expanded: {reason[:300]}", "Correct what it says, or"
    known = _declared(path)
    options = f" Its arguments are {some(list(known))}; xacro_args= sets them." if known else ""
    raise InputError(f"{path}: the xacro {what}. {cure} {expand}{options}", file=str(path)) from None


def _reason(error: BaseException) -> str:
    """Return what the expander said, once."""
    text = " ".join(str(error).split()) or type(error).__name__
    return re.sub(r"^<class '[^']*'>: ", "", text)


def _users(path: Path) -> list[str]:
    """Return the xacro files in the folder of a file, and in those beside it, that include it, from that folder."""
    users: list[str] = []
    folder = path.resolve().parent
    for other in [*sorted(folder.glob("*.xacro")), *sorted(folder.parent.glob("*/*.xacro"))][:MOST_LOOKED_AT]:
        if other.name == path.name or other.stat().st_size > urdf.LARGEST_FILE:
            continue
        included = re.findall(r"<xacro:include[^>]*/>", other.read_text(encoding="utf-8", errors="replace"))
        if any(re.search(rf"[/\"']{re.escape(path.name)}[\"']", tag) for tag in included):
            users.append(os.path.relpath(other, folder))
    return list(dict.fromkeys(users))


def _declared(path: Path) -> dict[str, str | None]:
    """Return the arguments that a xacro file declares, in order, and their defaults."""
    words = path.read_text(encoding="utf-8", errors="replace")
    found: dict[str, str | None] = {}
    for tag in re.findall(r"<xacro:arg\b[^>]*>", words):
        name = re.search(r"\bname\s*=\s*([\"'])(.*?)\1", tag)
        default = re.search(r"\bdefault\s*=\s*([\"'])(.*?)\1", tag)
        if name:
            found[name[2]] = None if default is None else default[2]
    return found
