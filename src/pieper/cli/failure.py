"""How a command fails: one readable sentence and an exit status, never a traceback for what a user can cure."""

from __future__ import annotations

import errno
import io
import os
import re
import shlex
import sys
import warnings
from collections.abc import Callable
from typing import Any

import click

from pieper import PieperError
from pieper.cli.status import DONE, INTERRUPTED, MISUSE
from pieper.cli.stopping import Stopped, signals_interrupt

#: Optional packages and the extra that brings each.
EXTRAS = {
    "distributed": "cluster",
    "matplotlib": "figures",
    "mpl_toolkits": "figures",
    "sympy": "symbolic",
    "mpmath": "symbolic",
    "starlette": "workbench",
    "uvicorn": "workbench",
    "websockets": "workbench",
}

#: What an output says that takes no more.
NO_ROOM = (errno.ENOSPC, errno.EFBIG, errno.EDQUOT)


def guarded(app: Callable[..., Any], arguments: list[str] | None) -> int:
    """Run a click app and return the exit status.

    Args:
        app: The app.
        arguments: What stands after the program's name; None for the process's own.

    Returns:
        0 done, 1 no solution, 2 misuse, 130 interrupted, 128 and the signal's number where another ended it.
    """
    warnings.showwarning = _say_warning
    if sys.stdout is None or sys.stderr is None:  # closed by who called: what would be said there is said to nobody
        nobody = open(os.devnull, "w")
        sys.stdout, sys.stderr = sys.stdout or nobody, sys.stderr or nobody
    if isinstance(sys.stdout, io.TextIOWrapper):
        # a terminal that knows no infinity sign still gets the numbers
        sys.stdout.reconfigure(errors="replace")
    try:
        with signals_interrupt():
            status = app(arguments, prog_name="pieper", standalone_mode=False)
            sys.stdout.flush()
        return int(status) if isinstance(status, int) else DONE
    except PieperError as error:
        return _misuse(str(error))
    except click.exceptions.NoArgsIsHelpError as error:
        print(error.format_message())
        return MISUSE
    except click.ClickException as error:
        context = error.ctx if isinstance(error, click.UsageError) else None
        hint = f" See: {context.command_path} --help" if context is not None else ""
        said = " ".join(error.format_message().split())
        return _misuse(said + ("" if said[-1:] in ".?!" else ".") + hint)
    except click.exceptions.Exit as error:
        return error.exit_code
    except ModuleNotFoundError as missing:
        package = (missing.name or "").split(".")[0]
        if package in EXTRAS:
            return _misuse(f"this needs {package}: pip install 'pieper[{EXTRAS[package]}]'")
        raise
    except (KeyboardInterrupt, click.Abort) as stop:
        cause = stop.__cause__ if isinstance(stop, click.Abort) else stop
        _say(str(cause or "") or "interrupted; nothing half written was left behind.")
        return cause.status if isinstance(cause, Stopped) else INTERRUPTED
    except (BrokenPipeError, SystemExit):  # the reader (head, less) has gone; click leaves then
        _say_no_more()
        return DONE
    except OSError as error:
        if error.errno not in NO_ROOM or error.filename is not None:
            raise
        _say_no_more()
        return _misuse(f"cannot write: {error.strerror}. Free room there, or choose another.")


def _say_no_more() -> None:
    """Keep the interpreter from complaining at its end that what is left cannot be written."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _misuse(sentence: str) -> int:
    _say(sentence)
    return MISUSE


#: What the library's sentences say of its arguments, and how a command is asked the same.
_WORDS = {
    "give a store=, a larger step": "give --out DIR, a larger --step",
    "give its own, orientations= rotations": "ask in Python, where arm.reach_map takes orientations= rotations",
    "hold= what is known, or fit fewer joint_terms": "--hold what is known, or fit fewer --terms",
}
_DEGREES = re.compile(
    r" holds [-+.e\d]+, taken as radians; more than \d+ rad looks like degrees\. Use np\.radians.*meant\."
)
_OPTIONS = re.compile(r"\b(base|tip|missing_limits)=('[^']*'|\"[^\"]*\")?")
_MILLIMETRES = re.compile(r"metres are meant\. Were these millimetres\? pieper\.pose\(\.\.\., mm=True\) takes them\.")


def as_typed(sentence: str) -> str:
    """Return a sentence of the library with its arguments as the command line has them."""

    def option(found: re.Match[str]) -> str:
        name, value = f"--{found[1].replace('_', '-')}", (found[2] or "")[1:-1]
        return f"{name} {value if value.isidentifier() else shlex.quote(value)}" if value else name

    sentence = _DEGREES.sub(
        " makes many whole turns: are the numbers in the unit that --angle says (deg where it says nothing)?", sentence
    )
    for library, command in _WORDS.items():
        sentence = sentence.replace(library, command)
    cure = "are the numbers in the unit that --length says (mm where it says nothing)?"
    sentence = sentence.replace(", or say another with name=", "")
    return _OPTIONS.sub(option, _MILLIMETRES.sub(cure, sentence))


def _say(sentence: str) -> None:
    from pieper.cli.layout import sentences, terminal_width

    print(sentences(f"pieper: {as_typed(sentence)}", terminal_width(sys.stderr)), file=sys.stderr)


def note(sentence: str) -> None:
    """Say beside the answer what was done with what was typed."""
    _say(f"note: {sentence}")


def _say_warning(message: Warning | str, *_: object, **__: object) -> None:
    _say(f"note: {message}")
