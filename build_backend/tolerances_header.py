"""Write the kernels' header of tolerances from the pages that have them, src/pieper/tolerances/kernels."""

from __future__ import annotations

import runpy
import sys
from pathlib import Path


def header(pages: Path) -> str:
    """Return the header's text: the tolerances of all pages of a folder, in the kernels' spelling.

    Pages for Python alone stand elsewhere, so that a change there does not compile the kernels anew.
    """
    lines = ["// Written by the build from src/pieper/tolerances/kernels, where the reasons stand.", "#pragma once"]
    lines += ["", "namespace pieper {", ""]
    for page in sorted(pages.glob("*.py")):
        for name, value in runpy.run_path(str(page)).items():
            if name.isupper() and not name.startswith("_"):
                lines.append(_constant("k" + "".join(word.capitalize() for word in name.split("_")), value))
    return "\n".join([*lines, "", "}  // namespace pieper", ""])


def _constant(name: str, value: float | tuple[float, ...]) -> str:
    """Return the line that defines a number, or several."""
    if isinstance(value, tuple):
        return f"inline constexpr double {name}[] = {{{', '.join(repr(float(v)) for v in value)}}};"
    return f"inline constexpr double {name} = {float(value)!r};"


if __name__ == "__main__":
    pages, target = map(Path, sys.argv[1:])
    text = header(pages)
    target.parent.mkdir(parents=True, exist_ok=True)
    if not target.exists() or target.read_text() != text:
        target.write_text(text)
