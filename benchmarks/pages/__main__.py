"""Write every page that is made from results; with --check, say which are out of date instead and fail.

Usage: python -m benchmarks.pages [--check]
"""

from __future__ import annotations

import sys

from benchmarks import kept
from benchmarks.pages import (
    arms,
    benchmarks,
    completeness,
    exported_solvers,
    narrow_limits,
    route_verdicts,
    singular_strata,
    workbench_measured,
)

PAGES = {
    "arms.md": arms,
    "benchmarks.md": benchmarks,
    "completeness.md": completeness,
    "exported_solvers.md": exported_solvers,
    "narrow_limits.md": narrow_limits,
    "route_verdicts.md": route_verdicts,
    "singular_strata.md": singular_strata,
    "workbench_measured.md": workbench_measured,
}


def main() -> None:
    """Write the pages, or compare them."""
    if "--check" not in sys.argv[1:]:
        for page, module in PAGES.items():
            kept.write_text(module.page(), kept.DOCS / page)
        return
    stale = [name for name, module in PAGES.items() if (kept.DOCS / name).read_text() != module.page()]
    if stale:
        sys.exit(f"out of date, say `make pages`: {', '.join('docs/' + name for name in stale)}")
    print(f"{len(PAGES)} pages are what the results say")


if __name__ == "__main__":
    main()
