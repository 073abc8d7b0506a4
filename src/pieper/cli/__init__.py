"""The command line: `pieper COMMAND`, listed in `cli.app`."""

from __future__ import annotations

import gc
import sys

from pieper.cli.status import MISUSE

#: New objects before young, middle and old ones are looked through.
GARBAGE = (100_000, 20, 20)


def main(arguments: list[str] | None = None) -> int:
    """Run the command line and leave with its exit status.

    Args:
        arguments: What stands after `pieper`; the process's own arguments when left out.

    Returns:
        Nothing in practice: it raises SystemExit with 0 done, 1 no solution, 2 misuse.
    """
    # imports make much that stays and little that goes: looking for garbage meanwhile is 20 of a short command's 290 ms
    gc.set_threshold(*GARBAGE)
    try:
        from pieper.cli.app import app
    except ModuleNotFoundError as missing:
        if missing.name == "click":
            print(f"pieper: the command line needs {missing.name}: pip install 'pieper[cli]'", file=sys.stderr)
            sys.exit(MISUSE)
        raise
    from pieper.cli.failure import guarded

    sys.exit(guarded(app, arguments))
