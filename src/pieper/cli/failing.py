"""How a command fails: one readable sentence and an exit status, never a traceback for what a user can cure."""

from __future__ import annotations

import os
import sys
import warnings
from collections.abc import Callable

from pieper.cli import DONE, INTERRUPTED, MISUSE
from pieper.errors import PieperError

#: Optional packages and the extra that brings each.
EXTRAS = {
    "matplotlib": "figures",
    "mpl_toolkits": "figures",
    "sympy": "symbolic",
    "mpmath": "symbolic",
    "starlette": "workbench",
    "uvicorn": "workbench",
    "websockets": "workbench",
}


def guarded(app: Callable, arguments: list[str] | None) -> int:
    """Run a click app and return the exit status.

    Args:
        app: The app.
        arguments: What stands after the program's name; None for the process's own.

    Returns:
        0 done, 1 no solution, 2 misuse, 130 interrupted.
    """
    warnings.showwarning = _say_warning
    try:
        status = app(arguments, prog_name="pieper", standalone_mode=False)
        sys.stdout.flush()
        return int(status) if isinstance(status, int) else DONE
    except PieperError as error:
        _say(str(error))
        return MISUSE
    except ModuleNotFoundError as missing:
        package = (missing.name or "").split(".")[0]
        if package in EXTRAS:
            _say(f"this needs {package}: pip install 'pieper[{EXTRAS[package]}]'")
            return MISUSE
        raise
    except KeyboardInterrupt:
        _say("interrupted; nothing half written was left behind.")
        return INTERRUPTED
    except BrokenPipeError:
        # the reader (head, less) has gone; keep the interpreter from complaining about it at exit
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return DONE
    except Exception as error:
        return _of_click(error)


def _of_click(error: Exception) -> int:
    """Treat what the argument parser raises; anything else goes on as the defect it is."""
    name = type(error).__name__
    if name == "Abort":
        _say("interrupted; nothing half written was left behind.")
        return INTERRUPTED
    if name == "Exit":
        return int(error.exit_code)
    if hasattr(error, "format_message"):
        context = getattr(error, "ctx", None)
        if name == "NoArgsIsHelpError":
            print(error.format_message())
            return MISUSE
        hint = f" See: {context.command_path} --help" if context is not None else ""
        _say(error.format_message().rstrip(".") + "." + hint)
        return MISUSE
    raise error


def _say(sentence: str) -> None:
    print(f"pieper: {sentence}", file=sys.stderr)


def _say_warning(message, category, filename, lineno, file=None, line=None) -> None:
    print(f"pieper: note: {message}", file=sys.stderr)
