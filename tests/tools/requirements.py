"""Print what an extra of pyproject.toml asks for, extras of extras included: for an environment without pieper itself.

Usage: python -m tests.tools.requirements EXTRA
"""

from __future__ import annotations

import re
import sys
import tomllib
from pathlib import Path

PROJECT = tomllib.loads((Path(__file__).resolve().parents[2] / "pyproject.toml").read_text())


def wanted(extra: str) -> list[str]:
    """Return the requirements of an extra."""
    out: list[str] = []
    for requirement in PROJECT["project"]["optional-dependencies"][extra]:
        inner = re.fullmatch(r"pieper\[([\w,]+)\]", requirement)
        out += [r for name in inner[1].split(",") for r in wanted(name)] if inner else [requirement]
    return out


def main() -> None:
    """Print them, a line each."""
    both = [*PROJECT["project"]["dependencies"], *PROJECT["build-system"]["requires"], *wanted(sys.argv[1])]
    print("\n".join(f"'{r}'" for r in dict.fromkeys(both)))


if __name__ == "__main__":
    main()
