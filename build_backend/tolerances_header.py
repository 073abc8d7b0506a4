"""Write the kernels' header of tolerances from the one page that has them all, src/pieper/tolerances.py."""

from __future__ import annotations

import re
import runpy
import sys
from pathlib import Path


def header(page: Path) -> str:
    """Return the header's text: the page's general tolerances and those of the kernels, in the kernels' spelling.

    Sections for Python alone are left out, so that a change there does not compile the kernels anew.
    """
    lines = ["// Written by the build from src/pieper/tolerances.py, where the reasons stand.", "#pragma once", ""]
    lines += ["namespace pieper {", ""]
    values, wanted = runpy.run_path(str(page)), True
    for line in page.read_text().splitlines():
        if line.startswith("# ---- "):
            wanted = line.startswith("# ---- kernels: ")
        name = re.match(r"([A-Z][A-Z0-9_]*) = ", line)
        if wanted and name and isinstance(values[name[1]], float):
            spelled = "k" + "".join(word.capitalize() for word in name[1].split("_"))
            lines.append(f"inline constexpr double {spelled} = {values[name[1]]!r};")
    return "\n".join([*lines, "", "}  // namespace pieper", ""])


if __name__ == "__main__":
    page, target = map(Path, sys.argv[1:])
    text = header(page)
    target.parent.mkdir(parents=True, exist_ok=True)
    if not target.exists() or target.read_text() != text:
        target.write_text(text)
