"""Zig's clang under the names that builds look for."""

from __future__ import annotations

import stat
import sys
from pathlib import Path


def zig_tools(folder: Path, python: str = sys.executable, target: str = "") -> dict[str, str]:
    """Write scripts that call zig as compiler, archiver and index maker; return the environment that uses them.

    Zig compiles for the processor at hand unless told otherwise; the baseline is what a module for others needs.

    Args:
        folder: Where the scripts go.
        python: The interpreter that has ziglang.
        target: The machine to compile for, in zig's words, such as "aarch64-linux-gnu.2.17"; this one when left out.
    """
    tools = {}
    machine = f" -target {target}" if target else ""
    for variable, name, command in (
        ("CXX", "zig-c++", f"c++ -mcpu=baseline{machine}"),
        ("CC", "zig-cc", f"cc -mcpu=baseline{machine}"),
        ("AR", "zig-ar", "ar"),
        ("RANLIB", "zig-ranlib", "ranlib"),
    ):
        script = folder / name
        script.write_text(f'#!/bin/sh\nexec "{python}" -m ziglang {command} "$@"\n')
        script.chmod(script.stat().st_mode | stat.S_IXUSR)
        tools[variable] = str(script)
    return tools
