"""Xacro: macros expanded by the packages of the extra `xacro`, then read as a URDF."""

from __future__ import annotations

import contextlib
import io
import os
import re
from collections import deque
from collections.abc import Mapping
from pathlib import Path
from typing import NoReturn

from pieper.description import urdf
from pieper.description.dh import Description
from pieper.description.tree import some
from pieper.description.wholefile import bytes_of
from pieper.errors import InputError

#: How many files around one that only defines macros are looked through for one that uses them.
MOST_LOOKED_AT = 300
#: How far up from a file, how deep down from there, and through how many folders in all its packages are looked for.
LEVELS_UP, LEVELS_DOWN, MOST_FOLDERS = 4, 3, 2000


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
        path: A .xacro file. Packages named in $(find ...) are looked for in the folders around it (`packages_around`).
        base: Link whose frame is the base.
        tip: Link whose frame is the tool.
        missing_limits: As in `urdf.read`.
        arguments: Values of the file's xacro arguments.

    Raises:
        InputError: The extra is not installed, or the file cannot be expanded; the message says why.
    """
    path = Path(path)
    bytes_of(path, urdf.LARGEST_FILE, "xacro")
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
    around: dict[str, str] | None = None
    for _ in range(2 + len(_declared(path))):
        said = io.StringIO()
        try:
            # the expander prints its warnings and where it was; they belong into the message, not onto the screen
            with contextlib.redirect_stderr(said), contextlib.redirect_stdout(said):
                # what a failed file left behind (its includes, its packages' folders) is none of this one's, and a
                # file's own folder is where its includes are
                expander.init_stacks(str(path))
                packages.reset()
                packages.update_package_cache(around or {})
                return XacroDoc.from_file(str(path), subargs=given, resolve_packages=False).to_urdf_string()
        except (Exception, SystemExit) as error:  # it evaluates expressions of the file: anything can come
            reason = _reason(error)
            if around is None and "Package not found" in reason:
                around = packages_around(path)
                continue
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


def packages_around(path: Path) -> dict[str, str]:
    """Return the ROS packages that lie around a file, name -> folder, the nearest where a name is there twice.

    Looked through are the folders above the file, `LEVELS_UP` of them and none that holds other people's homes, each
    `LEVELS_DOWN` deep, and no more than `MOST_FOLDERS` in all: a file in a home folder does not walk a whole disk.
    """
    homes, seen, found = Path.home().resolve().parents, set[Path](), dict[str, str]()
    for top in list(path.resolve().parents)[:LEVELS_UP]:
        if top.parent == top or top in homes:
            break
        queue = deque([(top, 0)])
        while queue and len(seen) < MOST_FOLDERS:
            folder, depth = queue.popleft()
            if folder in seen and folder != path.resolve().parent and depth:
                continue
            seen.add(folder)
            name = _package_name(folder)
            if name:
                found.setdefault(name, str(folder))
            if depth < LEVELS_DOWN and (
                not name or not depth
            ):  # packages hold no packages, but a repository may be one
                queue += [(inner, depth + 1) for inner in _folders_in(folder)]
    return found


def _package_name(folder: Path) -> str:
    """Return the name of the package that a folder is, "" where it is none."""
    with contextlib.suppress(OSError):
        if (folder / "package.xml").is_file():
            text = (folder / "package.xml").read_text(encoding="utf-8", errors="replace")
            said = re.search(r"<name>\s*([^<\s]+)\s*</name>", text)
            return said[1] if said else ""
        if (folder / "manifest.xml").is_file():
            return folder.name
    return ""


def _folders_in(folder: Path) -> list[Path]:
    """Return the folders in a folder that are not hidden, in order; none where it cannot be read."""
    with contextlib.suppress(OSError), os.scandir(folder) as entries:
        inner = [e.name for e in entries if e.is_dir(follow_symlinks=False) and not e.name.startswith(".")]
        return [folder / name for name in sorted(inner)]
    return []


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
