"""Xacro: macros expanded by the packages of the extra `xacro`, then read as a URDF."""

from __future__ import annotations

import contextlib
import io
import re
from collections.abc import Mapping
from pathlib import Path

from pieper.description import urdf
from pieper.description.dh import Description
from pieper.errors import InputError


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
        raise InputError(
            f"{path}: this xacro expands to no joint; it may only define macros. Load the file that uses them.",
            file=str(path),
        )
    return urdf.loads(text, file=str(path), base=base, tip=tip, missing_limits=missing_limits)


def expanded(path: Path, arguments: Mapping[str, str]) -> str:
    """Return the URDF that a xacro file stands for."""
    try:
        from xacrodoc import XacroDoc, packages
    except ImportError:
        raise InputError(
            f"{path}: reading xacro needs an extra: pip install 'pieper[xacro]'; or expand the file first "
            "(xacro in.xacro > out.urdf).",
            file=str(path),
        ) from None
    said = io.StringIO()
    try:
        # the expander prints its warnings and where it was; they belong into the message, not onto the screen
        with contextlib.redirect_stderr(said), contextlib.redirect_stdout(said):
            packages.look_in([str(folder) for folder in list(path.resolve().parents)[:4]])
            doc = XacroDoc.from_file(
                str(path),
                subargs={key: str(value) for key, value in arguments.items()},
                resolve_packages=False,
            )
            return doc.to_urdf_string()
    except (Exception, SystemExit) as error:  # the expander evaluates expressions of the file: anything can come
        reason = " ".join(str(error).split()) or type(error).__name__
        asked = [name for name in _without_default(path) if name not in arguments]
        if asked:
            said_so = ", ".join(f"{name!r}: 'value'" for name in asked)
            raise InputError(
                f"{path}: the xacro asks for {', '.join(asked)} and has no default. Say pieper.load(..., "
                f"xacro_args={{{said_so}}}).",
                file=str(path),
                allowed=asked,
            ) from None
        cure = (
            "Give the argument: pieper.load(..., xacro_args={'name': 'value'})."
            if "rgument" in reason or "substitution" in reason.lower()
            else "Expand it where its packages are installed (xacro in.xacro > out.urdf) and load the .urdf."
        )
        raise InputError(f"{path}: the xacro could not be expanded: {reason[:300]}. {cure}", file=str(path)) from None


def _without_default(path: Path) -> list[str]:
    """Return the names of the arguments that a xacro file has no default for, in order."""
    words = path.read_text(encoding="utf-8", errors="replace")
    found = [match for match in re.findall(r"<xacro:arg\b[^>]*>", words) if not re.search(r"\bdefault\s*=", match)]
    return [name for tag in found for name in re.findall(r"\bname\s*=\s*[\"']([^\"']+)", tag)]
