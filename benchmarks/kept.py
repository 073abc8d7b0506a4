"""Where measurements and the pages made of them stand, and how they are written: whole or not at all."""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
RESULTS = ROOT / "benchmarks" / "results"
DOCS = ROOT / "docs"


def commit() -> str:
    """Return the commit that is measured."""
    asked = ["git", "rev-parse", "--short", "HEAD"]
    return subprocess.run(asked, cwd=ROOT, capture_output=True, text=True).stdout.strip()


def read(name: str) -> Any:
    """Return a result, None where it has not been measured."""
    path = RESULTS / f"{name}.json"
    return json.loads(path.read_text()) if path.exists() else None


def write(state: dict[str, Any], path: Path, indent: int | None = None) -> None:
    """Write a result with the commit that was measured last."""
    state["commit"] = commit()
    write_text(json.dumps(state, indent=indent) + "\n", path)


def in_lines(entries: dict[str, Any]) -> str:
    """Return an object of JSON with an entry a line: what is added to it later changes no other line."""
    return "{\n" + ",\n".join(f"{json.dumps(name)}: {json.dumps(own)}" for name, own in entries.items()) + "\n}"


def in_chunks(kept: dict[str, Any]) -> str:
    """Return what was measured of arms, chunk by chunk, as JSON with a chunk a line."""
    arms = []
    for name, own in kept.items():
        facts = [f"{json.dumps(key)}: {json.dumps(value)}" for key, value in own.items() if key != "chunks"]
        arms.append(f'{json.dumps(name)}: {{{", ".join(facts)}, "chunks": {in_lines(own["chunks"])}}}')
    return "{\n" + ",\n".join(arms) + "\n}\n"


@contextmanager
def held() -> Iterator[None]:
    """Keep others from writing results: what one reads, adds to and writes is not taken back by one who read before."""
    import fcntl

    folder = os.open(RESULTS, os.O_RDONLY)
    try:
        fcntl.flock(folder, fcntl.LOCK_EX)
        yield
    finally:
        os.close(folder)


def write_text(text: str, path: Path) -> None:
    """Write a file whole or not at all."""
    part = path.with_suffix(".part")
    part.write_text(text)
    part.replace(path)
