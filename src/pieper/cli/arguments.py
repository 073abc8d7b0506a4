"""What people type: joint vectors and poses, in degrees and millimetres unless they say otherwise."""

from __future__ import annotations

import math
import re
import sys
import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt

import pieper
from pieper import InputError, PieperWarning
from pieper.cli import pipes
from pieper.cli.output import plural
from pieper.cli.units import Units
from pieper.tolerances import SUSPICIOUSLY_SMALL

#: What may stand for an orientation after x y z: how many numbers, whether they are angles.
NOTATIONS = {
    "rpy": (3, True),
    "abc": (3, True),
    "wpr": (3, True),
    "zyz": (3, True),
    "rotvec": (3, True),
    "staubli": (3, True),
    "yaskawa": (3, True),
    "quat_wxyz": (4, False),
    "quat_xyzw": (4, False),
}
#: The same by the names of makers, and by those that robot files use.
ALSO = {
    "kuka": "abc",
    "fanuc": "wpr",
    "ur": "rotvec",
    "abb": "quat_wxyz",
    "zyx": "abc",
    "rotation_vector": "rotvec",
    "quaternion_wxyz": "quat_wxyz",
    "quaternion_xyzw": "quat_xyzw",
}
#: A file of numbers larger than this is not a pose or a joint vector.
LARGEST_FILE = 5_000_000


@dataclass(frozen=True)
class Target:
    """A pose that was typed: T (4, 4), m, and whether it was x y z alone, so that R = I is only what is usual."""

    T: npt.NDArray[np.float64]
    bare: bool


def numbers(words: Sequence[str], what: str, *, pairs: bool = False, pose: bool = False) -> list[float]:
    """Return the numbers of words that may hold several, apart by spaces or commas, or name a file as @file.

    Between semicolons or tabs a comma stands before decimals.

    Args:
        words: What was typed. Expressions such as pi/2 or sqrt(2)/2 are numbers too.
        what: Its name, for messages.
        pairs: Whether "0,5 0,7" may be four numbers. Elsewhere nobody can tell whether they are two.
        pose: Whether they are one pose: a file with a pose on each line is a table then, which has its own ending.

    Raises:
        InputError: Something is not a number; the message says which word.
    """
    parts: list[tuple[str, str]] = []
    for word in words:
        if word.startswith("@"):
            lines = [line.split("#")[0].strip("[] \t") for line in read_text(word[1:], what).splitlines()]
            rows = [row for line in lines if (row := _parts(line, pairs))]
            if pose:
                _one_pose([len(row) for row in rows], what, word[1:])
            parts += [(part, f"{what}, file {word[1:]}") for row in rows for part in row]
            continue
        brackets = "[]() \t\n" if word.count("(") == word.count(")") + 1 else "[] \t\n"
        parts += [(part, what) for part in _parts(word.strip(brackets), pairs)]
    for part, where in parts:
        if not pairs and len(parts) > 1 and PAIR.fullmatch(part):
            raise InputError(
                f"{where}: a comma parts numbers, so {part} is two. Write {_with_a_point(part)} with a point where it "
                "is one, and a space behind the comma where it is not.",
                given=part,
            )
    return [number(one.strip("[]"), where) for part, where in parts for one in part.split(",") if one.strip("[]")]


def _one_pose(counts: list[int], what: str, name: str) -> None:
    """Refuse a file with a pose on each line, and say of two lines of three numbers how they are read."""
    if len(counts) < 2 or len(set(counts)) > 1 or counts[0] not in (3, 6, 7, 12, 16):
        return
    table = f"A table, one pose a line, is read where its name ends in .csv: @{Path(name).stem}.csv."
    if counts == [3, 3]:
        said = f"{what}: the two lines of {name} were taken for one pose, x y z and its angles. {table}"
        warnings.warn(said, PieperWarning, stacklevel=3)
        return
    raise InputError(f"{what}: {name} has {len(counts)} lines of {counts[0]} numbers. {table}", path=name)


#: Two numbers and a comma, or one with a comma before its decimals or between its thousands.
PAIR = re.compile(r"[+-]?\d[\d.]*,\d[\d.]*")


def _parts(text: str, pairs: bool) -> list[str]:
    """Return what stands between spaces, semicolons and tabs."""
    cells = re.split(r"[;\t\n]", text)
    if len(cells) > 1 and not pairs and all(len(re.findall(r"\d,\d", cell)) < 2 for cell in cells):
        cells = [with_points(cell) for cell in cells]
    return [part for cell in cells for part in re.sub(r",\s+|\s+,", " ", cell).split()]


def with_points(text: str) -> str:
    """Return text with points for its decimal commas."""
    return re.sub(r"(?<=\d),(?=\d)", ".", text)


def _with_a_point(text: str) -> str:
    """Return how a number with a comma may have been meant: the last sign stands before the decimals."""
    whole, sign, decimals = text.rpartition("," if text.rfind(",") > text.rfind(".") else ".")
    return whole.replace(",", "").replace(".", "") + sign.replace(",", ".") + decimals


def number(text: str, what: str) -> float:
    """Return one number or expression.

    Raises:
        InputError: It is not one, or not finite.
    """
    try:
        value = float(text)
    except ValueError:
        try:
            value = pieper.evaluate(text)
        except ValueError as error:
            why = str(error).rstrip(".")
            if re.fullmatch(r"[+-]?\d[\d.,'\u2019\u00a0\u202f ]*", text):
                why = "a point stands before decimals, and nothing between thousands"
            raise InputError(f"{what}: {text!r} is not a number ({why}).", given=text) from None
    if not math.isfinite(value):
        raise InputError(f"{what}: {text!r} is not finite.", given=text)
    return value


def read_text(name: str, what: str) -> str:
    """Return the text of a file that holds numbers; `-` is the standard input.

    Raises:
        InputError: It cannot be read, is not text, or is far too large.
    """
    if name == "-":
        return sys.stdin.read(LARGEST_FILE)
    path = Path(name)
    try:
        if path.stat().st_size > LARGEST_FILE:
            raise InputError(
                f"{what}: {path} has {path.stat().st_size:,} bytes; at most {LARGEST_FILE:,} are read.", path=path
            )
        if pipes.is_pipe(name):
            with pipes.opened(name) as file:
                return file.read(LARGEST_FILE).decode("utf-8-sig")
        return path.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError:
        raise InputError(f"{what}: {path} is not a text file.", path=path) from None
    except OSError as error:
        raise InputError(f"{what}: cannot read {path}: {error.strerror}.", path=path) from None


def joints(arm: pieper.Arm, words: Sequence[str], units: Units, what: str = "joints") -> npt.NDArray[np.float64]:
    """Return the joint vector (n,), rad and m, that was typed as numbers, @file, or the name of a posture of the arm.

    Raises:
        InputError: Not as many numbers as joints, or an unknown posture.
    """
    if len(words) == 1 and re.fullmatch(r"[A-Za-z][\w-]*", words[0]) and words[0] != "pi":
        known = arm.postures
        if words[0] not in known:
            raise InputError(
                f"{what}: {arm.name} has no posture {words[0]!r}; it knows {', '.join(known)}.", given=words[0]
            )
        return np.asarray(known[words[0]], float)
    values = numbers(words, what)
    if len(values) != arm.n:
        raise InputError(
            f"{what}: {arm.name} has {plural(arm.n, 'joint')} ({units.said_of_joints(arm)}), "
            f"got {len(values)} number{'s' if len(values) != 1 else ''}.",
            given=values,
        )
    q = np.array(values) * units.of_joints(arm)
    turning = np.array([kind == "R" for kind in arm.joint_types])
    if units.angle == "rad" and np.any(np.abs(q[turning]) > 4 * math.pi):
        warnings.warn(
            f"{what}: more than two turns; were degrees meant? Then leave --angle rad out.", PieperWarning, stacklevel=2
        )
    return q


def target(words: Sequence[str], units: Units, order: str = "rpy", what: str = "pose") -> Target:
    """Return the pose that was typed.

    Args:
        words: Three numbers x y z (orientation R = I), x y z and the numbers of the notation, 12 or 16 numbers row by
            row, or @file with any of these.
        units: Of lengths and angles; matrix entries of a rotation have none.
        order: A notation of `NOTATIONS`: what the numbers after x y z mean.
        what: Its name, for messages.

    Raises:
        InputError: Another count of numbers, not a rotation.
    """
    values = numbers(words, what, pose=True)
    T, bare = posed(values, units, order, what)
    far = float(np.linalg.norm(T[:3, 3]))
    if units.length == "mm" and 0 < far < SUSPICIOUSLY_SMALL:
        warnings.warn(
            f"{what}: the position is {far * 1e3:.3g} mm from the base; were metres meant? Then say --length m.",
            PieperWarning,
            stacklevel=2,
        )
    return Target(T, bare)


def posed(values: npt.ArrayLike, units: Units, order: str, what: str) -> tuple[npt.NDArray[np.float64], bool]:
    """Return poses (..., 4, 4), m, of 3, 6, 7, 12 or 16 numbers each, and whether they were x y z alone; see `target`.

    Raises:
        InputError: Another count of numbers, not a rotation.
    """
    order = ALSO.get(order, order)
    count, angles = NOTATIONS[order]
    v = np.asarray(values, float)
    size = v.shape[-1]
    try:
        if size in (12, 16):
            M = v.reshape(*v.shape[:-1], size // 4, 4)
            if np.any(M[..., 3:, :] != (0, 0, 0, 1)):
                raise InputError("the last row of the matrix must be 0 0 0 1.", given=M)
            return pieper.poses(M[..., :3, 3] * units.metres, "R", M[..., :3, :3]), False
        p = v[..., :3] * units.metres
        if size == 3:
            return pieper.poses(p), True
        if size == 3 + count:
            return pieper.poses(p, order, v[..., 3:] * (units.radians if angles else 1.0)), False
    except InputError as error:
        raise InputError(f"{what}: {error}", **error.data) from None
    raise InputError(
        f"{what}: give x y z, or x y z and {count} numbers for {order}, or the 12 or 16 numbers of a matrix row by "
        f"row; got {size} number{'s' if size != 1 else ''}.",
        given=size,
    )
