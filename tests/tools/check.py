"""Every check that needs no test run: one line each, what it took, and what is wrong in full.

Usage: python -m tests.tools.check [--only NAME ...]

Nothing is allowed to stand. What needs Node says so and is left out where there is none.
"""

from __future__ import annotations

import argparse
import shutil
import subprocess
import sys
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

from tests.tools import types

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "src" / "pieper" / "workbench" / "page"
BIN = Path(sys.executable).parent


class LeftOut(Exception):
    """A check cannot be made here, and why."""


def run(*command: str, cwd: Path = ROOT) -> tuple[int, str]:
    """Run a tool of this environment, or of the machine; return its exit status and what it said."""
    own = BIN / command[0]
    line = [str(own) if own.exists() else command[0], *command[1:]]
    done = subprocess.run(line, cwd=cwd, capture_output=True, text=True)
    return done.returncode, (done.stdout + done.stderr).strip()


def tracked(*patterns: str) -> list[str]:
    """Return the files of patterns, what git ignores left out."""
    _, said = run("git", "ls-files", "--cached", "--others", "--exclude-standard", "--", *patterns)
    return [line for line in said.splitlines() if (ROOT / line).exists()]


def complaints(*command: str) -> list[str]:
    """Return what a tool says, a complaint a line; nothing when it is content."""
    status, said = run(*command)
    return said.splitlines() if status else []


def style() -> list[str]:
    return complaints("ruff", "check", "--output-format", "concise", "--quiet", ".")


def layout() -> list[str]:
    return complaints("ruff", "format", "--check", "--quiet", ".")


def words_and_types() -> list[str]:
    """Docstrings (Google's sections) and annotations; tests and what has two underscores go without."""
    rules = ("--select", "D,ANN", "--ignore", "D105,D107,ANN401", "--output-format", "concise", "--quiet")
    return complaints("ruff", "check", *rules, "src", "build_backend")


def whole_types() -> list[str]:
    return types.complaints(run)


def kernels() -> list[str]:
    sources = tracked("kernels/*.hpp", "kernels/*.cpp", "oracle/*.cpp")
    _, said = run("clang-format", "--dry-run", "--ferror-limit=1", *sources)
    return sorted(
        {line.split(":")[0] for line in said.splitlines() if "warning: code should be clang-formatted" in line}
    )


def node() -> None:
    """Raise LeftOut where the page's tools are not there."""
    if shutil.which("node") is None:
        raise LeftOut("no Node on this machine")
    if not (PAGE / "node_modules").exists():
        raise LeftOut("the page's tools are not installed: npm ci in src/pieper/workbench/page")


def page_layout() -> list[str]:
    node()
    _, said = run(
        "node", "node_modules/prettier/bin/prettier.cjs", "--list-different", "src/**/*.mjs", "build.mjs", cwd=PAGE
    )
    return said.splitlines()


def page_shipped() -> list[str]:
    """Bundle the page again, beside the shipped one, and compare."""
    node()
    status, said = run("node", "build.mjs", "--check", cwd=PAGE)
    return said.splitlines() if status else []


def pages() -> list[str]:
    return complaints(sys.executable, "-m", "benchmarks.pages", "--check")


def house() -> list[str]:
    return complaints(sys.executable, "-m", "tests.tools.house", "--short")


CHECKS: dict[str, Callable[[], list[str]]] = {
    "style (ruff)": style,
    "layout (ruff)": layout,
    "docstrings, annotations (ruff)": words_and_types,
    "types (pyright)": whole_types,
    "kernels' layout (clang-format)": kernels,
    "page's layout (prettier)": page_layout,
    "page as shipped (esbuild)": page_shipped,
    "pages made of results": pages,
    "law of the house": house,
}


def made(name: str) -> tuple[list[str], str]:
    """Make one check; return what is wrong, and a line that says how it went."""
    begin = time.monotonic()
    try:
        found = CHECKS[name]()
    except LeftOut as why:
        return [], f"{name:32} LEFT OUT: {why}"
    verdict = f"FAILS, {len(found)} complaints" if found else "holds"
    return found, f"{name:32} {time.monotonic() - begin:5.1f} s  {verdict}"


def main() -> None:
    """Make the checks, the longest beside the others, all of them also when one fails."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--only", nargs="*", default=list(CHECKS), help="names, or their beginnings")
    asked = parser.parse_args().only
    names = [name for name in CHECKS if any(name.startswith(one) for one in asked)]
    wrong = 0
    with ThreadPoolExecutor(2) as pool:
        for done in as_completed(
            [pool.submit(made, name) for name in sorted(names, key=lambda name: "types" not in name)]
        ):
            found, line = done.result()
            print(line, *(f"    {one}" for one in found[:200]), sep="\n", flush=True)
            wrong += bool(found)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
