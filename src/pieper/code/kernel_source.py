"""The kernels' own sources as one text, for whoever compiles them away from here."""

from __future__ import annotations

import hashlib
import re
import runpy
from functools import lru_cache
from importlib import resources
from pathlib import Path

from pieper.errors import PlanError

_INCLUDE = re.compile(r'^#include "([^"]+)"\n', re.M)
_LOOSE = re.compile(r"^(?=(?:void|double|int|bool|long) \w+\()", re.M)


def folder() -> Path:
    """Return where the kernels' headers are: beside this file in an installed package, else in the tree.

    Raises:
        PlanError: They are nowhere.
    """
    packed = Path(str(resources.files("pieper"))) / "code" / "kernels"
    tree = Path(__file__).resolve().parents[3] / "kernels"
    for place in (packed, tree):
        if (place / "code" / "taken.hpp").exists():
            return place
    raise PlanError("the kernels' headers were not installed with this package, so no C++ can be written from them.")


def _tolerances() -> str:
    place = folder() / "tolerances.hpp"
    if place.exists():
        return place.read_text()
    writer = runpy.run_path(str(folder().parent / "build_backend" / "tolerances_header.py"))
    return str(writer["header"](Path(__file__).resolve().parents[1] / "tolerances" / "kernels"))


@lru_cache
def _lines() -> dict[str, str]:
    """Every header by the name it is included with."""
    place = folder()
    found = {p.relative_to(place).as_posix(): p.read_text() for p in place.rglob("*.hpp")}
    return found | {"tolerances.hpp": _tolerances()}


def header_of(family: str) -> tuple[str, str]:
    """Return the struct of a family's geometry and the header of its kernel, as the headers themselves say."""
    said = re.compile(rf'struct (\w+) : \w+ {{\s+static constexpr const char\* name = "{family}";')
    (own,) = [m[1] for text in _lines().values() for m in said.finditer(text)]
    kernel = re.compile(rf"^(?:class|using) {own}Kernel\b", re.M)
    (header,) = [name for name, text in _lines().items() if kernel.search(text)]
    return own, header


@lru_cache
def fingerprint() -> str:
    """Return what tells one state of the kernels from another, a word."""
    both = "".join(name + text for name, text in sorted(_lines().items()))
    return hashlib.sha256(both.encode()).hexdigest()[:12]


@lru_cache
def joined(*wanted: str) -> str:
    """Return headers by their names, with all they include, as one text that may be included any number of times.

    Everything lives in a namespace of this state of the kernels, and each header is guarded by itself: texts of several
    arms, families and versions may stand in one program.
    """
    mark = f"pieper_{fingerprint()}"
    sources, taken = _lines(), set[str]()

    def inlined(name: str) -> str:
        if name in taken:
            return ""
        taken.add(name)
        text = sources[name].replace("#pragma once\n", "")
        # what has one home in the library may come into several units here
        text = _LOOSE.sub("inline ", text)
        body = _INCLUDE.sub(lambda found: inlined(found[1]), text)
        guard = f"{mark}_{re.sub(r'[^a-z0-9]', '_', name)}"
        return f"#ifndef {guard}\n#define {guard}\n{body}#endif\n"

    text = "".join(inlined(name) for name in wanted)
    return re.sub(r"\bpieper::", f"{mark}::", re.sub(r"\bnamespace pieper\b(?!_)", f"namespace {mark}", text))
