"""What a caller hands in, read as what it should be or refused: numbers, words, files, objects of ours."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
import numpy.typing as npt

from pieper.errors import InputError

_T = TypeVar("_T")
#: Characters of what was given that a message shows.
LONGEST = 60


def kind_of(value: object) -> str:
    """Return words for what was given, short and without an address."""
    if isinstance(value, np.ndarray):
        return f"an array of shape {value.shape} of {value.dtype}"
    if isinstance(value, np.generic):
        value = value.item()
    if value is None or isinstance(value, (str, bytes, bool, int, float, complex, list, tuple, dict, set, Mapping)):
        said = repr(value)  # pyright: ignore[reportUnknownArgumentType]
        if " at 0x" not in said:
            return said if len(said) <= LONGEST else f"{said[:LONGEST]}..."
    return f"an object of type {type(value).__name__}"  # pyright: ignore[reportUnknownArgumentType]


def numbers(value: Any, what: str, wanted: str = "real numbers") -> npt.NDArray[np.float64]:
    """Return real numbers as a float64 array of whatever shape, a new one unless it was one already.

    Raises:
        InputError: Text, complex numbers, rows of several lengths or anything else that is no number.
    """
    if type(value) is np.ndarray and value.dtype == np.float64:
        return value
    try:
        given = np.asarray(value)
        if given.dtype.kind in "iufbO":
            return np.asarray(given, np.float64)
        found = "complex numbers" if given.dtype.kind == "c" else kind_of(value)
    except (TypeError, ValueError):
        found = kind_of(value)
    raise InputError(f"{what} must be {wanted}, got {found}.", given=value, allowed=wanted)


def number(
    value: Any,
    what: str,
    unit: str = "",
    *,
    least: float = -math.inf,
    above: float = -math.inf,
    most: float = math.inf,
    below: float = math.inf,
) -> float:
    """Return one finite real number between bounds.

    Raises:
        InputError: No number, or one outside the bounds; the message has them and the unit.
    """
    bounds = [
        word.format(bound)
        for word, bound in (
            ("of at least {:.12g}", least),
            ("above {:.12g}", above),
            ("of at most {:.12g}", most),
            ("below {:.12g}", below),
        )
        if math.isfinite(bound)
    ]
    wanted = "a finite number" + (f" {' and '.join(bounds)}" if bounds else "") + (f", {unit}" if unit else "")
    read = math.nan
    if not isinstance(value, (str, bytes, bytearray)):
        try:
            read = float(value)
        except (TypeError, ValueError, OverflowError):
            pass
    if not (math.isfinite(read) and least <= read <= most and above < read < below):
        raise InputError(f"{what} must be {wanted}, got {kind_of(value)}.", given=value, allowed=wanted)
    return read


def whole(value: Any, what: str, least: int, most: float = math.inf) -> int:
    """Return one whole number between bounds.

    Raises:
        InputError: No whole number, or one outside the bounds.
    """
    wanted = f"a whole number from {least}" + (f" to {most:z,.0f}" if math.isfinite(most) else "")
    if isinstance(value, (int, np.integer)) and not isinstance(value, bool) and least <= value <= most:
        return int(value)
    raise InputError(f"{what} must be {wanted}, got {kind_of(value)}.", given=value, allowed=wanted)


def flag(value: Any, what: str) -> bool:
    """Return whether something is so: True or False, and nothing that merely counts as one of them.

    Raises:
        InputError: Anything else.
    """
    if isinstance(value, (bool, np.bool_)) or (isinstance(value, (int, np.integer)) and value in (0, 1)):
        return bool(value)
    raise InputError(f"{what} must be True or False, got {kind_of(value)}.", given=value, allowed=(True, False))


def word(value: Any, what: str, allowed: Iterable[str]) -> str:
    """Return one of some words.

    Raises:
        InputError: Another word, or none.
    """
    known = list(allowed)
    if isinstance(value, str) and value in known:
        return value
    listed = ", ".join(map(repr, known[:-1])) + (" or " if len(known) > 1 else "") + repr(known[-1])
    raise InputError(f"{what} must be {listed}, got {kind_of(value)}.", given=value, allowed=known)


def text(value: Any, what: str) -> str:
    """Return a text.

    Raises:
        InputError: Something that is none.
    """
    if isinstance(value, str):
        return value
    raise InputError(f"{what} must be a text, got {kind_of(value)}.", given=value, allowed="a text")


def file(value: Any, what: str = "path", wanted: str = "the path of a file") -> Path:
    """Return the path of a file or folder; "~" at its beginning is the user's own folder, as a shell has it.

    Raises:
        InputError: Something that is no path, or the folder of a user who is not known.
    """
    try:
        read = os.fsdecode(os.fspath(value))
    except (TypeError, ValueError):
        raise InputError(f"{what} must be {wanted}, got {kind_of(value)}.", given=value, allowed=wanted) from None
    if "\0" in read or not read:
        raise InputError(f"{what} must be {wanted}, got {read!r}.", given=value, allowed=wanted)
    try:
        return Path(read).expanduser()
    except RuntimeError:
        cure = f"for a folder of that name write ./{read}"
        raise InputError(f"{what}: there is no user {read.split('/')[0][1:]!r}; {cure}.", given=value) from None


def file_ending(value: Any, endings: tuple[str, ...], what: str) -> Path:
    """Return the path of a file to be written, which says by its ending what it holds.

    Args:
        value: What was given.
        endings: Those that may be, such as ".toml"; "" for none.
        what: What is written, for the message.

    Raises:
        InputError: No path, or another ending.
    """
    path = file(value)
    if path.suffix.lower() not in endings:
        written = " or ".join(ending for ending in endings if ending)
        raise InputError(
            f"{path.name}: {what} is written as {written}, not as {path.suffix or 'a file without ending'!r}.",
            given=path.suffix,
            allowed=list(endings),
        )
    return path


def a(kind: type[_T], value: Any, what: str, cure: str) -> _T:
    """Return an object of one of our kinds.

    Raises:
        InputError: Another object; the message has the cure.
    """
    if isinstance(value, kind):
        return value
    raise InputError(
        f"{what} must be a pieper.{kind.__name__}, got {kind_of(value)}; {cure}.", given=value, allowed=kind.__name__
    )


def like(kind: Any, value: Any, what: str, wanted: str) -> None:
    """Refuse what does not answer as a protocol says, or is not of one of some types."""
    if not isinstance(value, kind):
        raise InputError(f"{what} must be {wanted}, got {kind_of(value)}.", given=value, allowed=wanted)


def by_name(value: Any, what: str, example: str) -> Mapping[Any, Any]:
    """Return a mapping.

    Raises:
        InputError: Something that is none.
    """
    if isinstance(value, Mapping):
        return value  # pyright: ignore[reportUnknownVariableType]
    raise InputError(f"{what} must be a dictionary such as {example}, got {kind_of(value)}.", given=value)


def several(value: Any, what: str, of: str) -> list[Any]:
    """Return the items of a list, a tuple or an array; a text or a dictionary is none.

    Raises:
        InputError: Something without items.
    """
    if not isinstance(value, (str, bytes, Mapping)):
        try:
            return list(value)
        except TypeError:
            pass
    raise InputError(f"{what} must be a list of {of}, got {kind_of(value)}.", given=value, allowed=of)


def told(progress: Callable[[int, int], object] | None) -> Callable[[int, int], object] | None:
    """Return who is told how far a call is, None for nobody.

    Raises:
        InputError: Something that cannot be called.
    """
    if progress is None or callable(progress):
        return progress
    raise InputError(
        f"progress must be a function of how many are done and of how many, got {kind_of(progress)}.", given=progress
    )


def pairs(value: Any, what: str, of: str) -> list[tuple[str, str]]:
    """Return pairs of texts.

    Raises:
        InputError: Something that is none.
    """
    out: list[tuple[str, str]] = []
    for item in several(value, what, f"pairs of {of}"):
        both = item if isinstance(item, (tuple, list)) else ()
        if len(both) != 2 or not all(isinstance(name, str) for name in both):
            raise InputError(f"{what} must be a list of pairs of {of}, one is {kind_of(item)}.", given=value)
        out.append((both[0], both[1]))
    return out


def cause(error: Exception) -> str:
    """Return why something failed, without the number and the name of a file that an OSError adds."""
    return (error.strerror or str(error)) if isinstance(error, OSError) else str(error)
