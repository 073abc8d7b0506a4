"""Rows of a long run, kept beside the file that they become, so that a run that was stopped goes on where it was."""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import shutil
import sys
from collections.abc import Iterator
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any, BinaryIO, TextIO

import numpy as np

import pieper
from pieper import InputError
from pieper.cli.failure import note
from pieper.cli.number_table import Place
from pieper.cli.output import plural
from pieper.cli.stopping import told

#: What the folder of a stopped run is called: the file's name and this.
SUFFIX = ".part"


@dataclass
class Rows:
    """Where rows go, and how far they are.

    Args:
        thing: What is counted, such as "pose".
        out: Where they are written; None for the standard output.

    Attributes:
        place: How much of the table they were made from.
        counts: What is counted on the way; "done" counts the things.
        notes: What was decided at the first of them.
    """

    thing: str
    out: TextIO | None = None
    place: Place = field(default_factory=Place, init=False)
    counts: dict[str, int] = field(default_factory=dict[str, int], init=False)
    notes: dict[str, str] = field(default_factory=dict[str, str], init=False)

    @property
    def done(self) -> int:
        """How many things are done."""
        return self.counts.get("done", 0)

    def put(self, text: str) -> None:
        """Write lines."""
        (self.out or sys.stdout).write(text)

    def keep(self, place: Place, **more: int) -> None:
        """Remember that everything up to a place of the table is written, and count on."""
        self.place = place
        for name, value in more.items():
            self.counts[name] = self.counts.get(name, 0) + value

    def stopped_at(self) -> str:
        """Return the sentences that say how far a stopped run was, and how to go on."""
        return f"stopped after {plural(self.done, self.thing)}. With --csv FILE the same command would go on there."


@dataclass
class KeptRows(Rows):
    """Rows that become a file when the last is there.

    Args:
        file: The file.
        question: What makes the rows these rows.
    """

    file: Path = field(kw_only=True)
    question: dict[str, Any] = field(kw_only=True)

    def __post_init__(self) -> None:
        self.folder = self.file.with_name(self.file.name + SUFFIX)
        self._rows, self._reached = self.folder / "rows.csv", self.folder / "reached.json"
        self._file: BinaryIO | None = None

    def open(self) -> None:
        """Begin, or go on where a stopped run was, and say so.

        Raises:
            InputError: The folder keeps rows of another question; the message says in what it differs.
        """
        others = {path.name for path in self.folder.iterdir()} if self.folder.is_dir() else {str(self.folder)}
        if self.folder.exists() and others - {self._rows.name, self._reached.name, self._reached.name + "~"}:
            raise InputError(
                f"{self.folder}, where rows are kept until the last is there, is something else: move it, or give "
                "--csv another name.",
                path=self.folder,
            )
        self.folder.mkdir(exist_ok=True)
        file = os.fdopen(os.open(self._rows, os.O_RDWR | os.O_CREAT, 0o666), "r+b")
        try:
            _lock(file, self.file)
            reached = self._before()
            file.seek(self._begin(reached, os.fstat(file.fileno()).st_size))
            file.truncate()
        except InputError:
            file.close()
            raise
        self._file = file

    def _before(self) -> dict[str, Any] | None:
        """Return what a stopped run of the same question wrote of itself, or None where there is none."""
        try:
            known: dict[str, Any] = json.loads(self._reached.read_text())
        except (OSError, ValueError):
            return None
        differs = [name for name, value in self.question.items() if known["question"].get(name) != value]
        if differs:
            raise InputError(
                f"{self.folder} keeps {plural(known['counts']['done'], self.thing)} of a stopped run with another "
                f"{' and another '.join(differs)}. Ask the same as before to go on, or remove it to begin anew.",
                path=self.folder,
                differs=differs,
            )
        return known

    def _begin(self, reached: dict[str, Any] | None, size: int) -> int:
        """Take over what a stopped run counted; return where in the file it goes on."""
        if reached is None:
            return 0
        if size < reached["bytes"]:
            raise InputError(f"{self.folder} lacks rows that it had: remove it to begin anew.", path=self.folder)
        self.place, self.counts, self.notes = Place(**reached["place"]), reached["counts"], reached["notes"]
        said = f"goes on after {plural(self.done, self.thing)}, whose rows {self.folder} keeps."
        note(said)
        return int(reached["bytes"])

    def put(self, text: str) -> None:
        """Write lines."""
        assert self._file is not None
        self._file.write(text.encode())

    def keep(self, place: Place, **more: int) -> None:
        """Remember that everything up to a place of the table is written; from here a stopped run goes on."""
        assert self._file is not None
        self._file.flush()
        data = {
            "bytes": self._file.tell(),
            "place": asdict(place),
            "counts": self.counts | {name: self.counts.get(name, 0) + value for name, value in more.items()},
            "notes": self.notes,
            "question": self.question,
        }
        new = self._reached.with_name(self._reached.name + "~")
        new.write_text(json.dumps(data, indent=1))
        os.replace(new, self._reached)
        super().keep(place, **more)

    def close(self, whole: bool) -> None:
        """Give the rows the file's name where they are whole; leave nothing where not one thing is done."""
        if self._file is None:
            return
        self._file.close()
        if whole:
            os.replace(self._rows, self.file)
        if whole or not self._reached.exists():
            shutil.rmtree(self.folder, ignore_errors=True)

    def stopped_at(self) -> str:
        """Return the sentences that say how far a stopped run was, and how to go on."""
        # what was written is what counts: the signal may have come before it was counted here
        reached = self._before()
        if not reached:
            return f"stopped before the first {self.thing} was done; nothing was written."
        done = plural(reached["counts"]["done"], self.thing)
        return f"stopped after {done}, whose rows {self.folder} keeps. The same command goes on there."


@contextlib.contextmanager
def rows_to(file: str, thing: str, question: dict[str, Any]) -> Iterator[Rows]:
    """Yield where rows go: the standard output, or a file that is there when the last row is.

    A run that is stopped, or meets a line that it cannot read, leaves what it did in a folder beside the file; the same
    run goes on there, and its rows are those of a run that was never stopped.

    Args:
        file: The file, or "" for the standard output.
        thing: What is counted, such as "pose".
        question: What makes the rows these rows, by names that follow "another".

    Raises:
        InputError: The file cannot be written, or the folder keeps rows of something else.
    """
    if not file:
        yield from _unkept(Rows(thing))
        return
    path = Path(file)
    if path.is_dir():
        raise InputError(f"{path} is a folder: give the name of a file in it.", path=path)
    # a device or a pipe cannot be given its name afterwards, and a link to a pipe leads to no name
    if path.exists() and not path.is_file():
        with path.open("w", encoding="utf-8") as out:
            yield from _unkept(Rows(thing, out))
        return
    path = Path(os.path.realpath(path)) if path.is_symlink() else path
    kept = KeptRows(thing, file=path, question=question)
    whole = False
    try:
        kept.open()
        yield kept
        whole = True
    except KeyboardInterrupt as stop:
        raise told(stop, kept.stopped_at()) from stop
    except InputError as error:
        if not kept.done or error.data.get("path") == kept.folder:
            raise
        said = kept.stopped_at()
        if "read_before" in error.data:
            said = f"remove {kept.folder} to begin anew, or give --csv another name."
        raise InputError(f"{error} {said[0].upper()}{said[1:]}", **error.data) from None
    except OSError as error:
        raise InputError(f"cannot write {path}: {error.strerror or error}.", path=path) from None
    finally:
        kept.close(whole)


def _unkept(rows: Rows) -> Iterator[Rows]:
    try:
        yield rows
    except KeyboardInterrupt as stop:
        raise told(stop, rows.stopped_at()) from stop


def _lock(out: BinaryIO, file: Path) -> None:
    """Refuse a second run that would write the same file, where the system can tell."""
    try:
        import fcntl
    except ModuleNotFoundError:
        return
    try:
        fcntl.flock(out, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        raise InputError(f"another run is writing {file}: wait for it, or give another name.", path=file) from None


def fingerprint(arm: pieper.Arm) -> str:
    """Return a checksum of an arm: how it moves, within which limits, and what its joints are called."""
    found = hashlib.sha256(repr((arm.name, arm.joint_names, arm.joint_types)).encode())
    # where every frame is at zero and with one joint away from it says all of a chain
    for array in (arm.limits, arm.coupling, arm.frames(np.vstack([np.zeros(arm.n), np.eye(arm.n)]))):
        found.update(np.ascontiguousarray(array).tobytes())
    return found.hexdigest()
