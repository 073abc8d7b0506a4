"""What people type: arms, joint vectors and poses, in degrees and millimetres unless they say otherwise."""

from __future__ import annotations

import math
import re
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from pieper.description.quantity import ExpressionError, evaluate
from pieper.errors import InputError
from pieper.kinematics.orientation import ANGLE_NOTATIONS, NOTATIONS, rotation
from pieper.kinematics.pose import checked_pose

if TYPE_CHECKING:
    from pieper.arm import Arm

LENGTHS = {"mm": 1e-3, "m": 1.0}
ANGLES = {"deg": math.pi / 180, "rad": 1.0}
#: A file of numbers larger than this is not a pose or a joint vector.
LARGEST_FILE = 5_000_000
#: A position this small (m) in millimetres was probably meant in metres.
SUSPICIOUSLY_SMALL = 2.5e-3


class Units:
    """The units a command speaks.

    Args:
        length: "mm" or "m".
        angle: "deg" or "rad".
    """

    def __init__(self, length: str = "mm", angle: str = "deg") -> None:
        if length not in LENGTHS:
            raise InputError(f"--length {length!r} is unknown: say {' or '.join(LENGTHS)}.", given=length)
        if angle not in ANGLES:
            raise InputError(f"--angle {angle!r} is unknown: say {' or '.join(ANGLES)}.", given=angle)
        self.length, self.angle = length, angle
        self.metres, self.radians = LENGTHS[length], ANGLES[angle]

    def of_joints(self, arm: Arm) -> np.ndarray:
        """Return the SI value (n,) of one unit of each joint."""
        return np.array([self.radians if kind == "R" else self.metres for kind in arm.joint_types])

    def names_of_joints(self, arm: Arm) -> list[str]:
        """Return the unit of each joint."""
        return [self.angle if kind == "R" else self.length for kind in arm.joint_types]


def numbers(words: list[str], what: str) -> list[float]:
    """Return the numbers of words that may hold several, apart by spaces or commas, or name a file as @file.

    Args:
        words: What was typed. Expressions such as pi/2 or sqrt(2)/2 are numbers too.
        what: Its name, for messages.

    Raises:
        InputError: Something is not a number; the message says which word.
    """
    out: list[float] = []
    for word in words:
        if word.startswith("@"):
            out += _file_numbers(word[1:], what)
            continue
        for part in re.split(
            r"[\s,;]+", word.strip("[]() \t\n") if word.count("(") == word.count(")") + 1 else word.strip("[] \t\n")
        ):
            if part:
                out.append(_number(part, what))
    return out


def _number(text: str, what: str) -> float:
    try:
        value = float(text)
    except ValueError:
        try:
            value = evaluate(text)
        except ExpressionError as error:
            raise InputError(f"{what}: {text!r} is not a number ({error}).", given=text) from None
    if not math.isfinite(value):
        raise InputError(f"{what}: {text!r} is not finite.", given=text)
    return value


def read_text(name: str, what: str) -> str:
    """Return the text of a file that holds numbers.

    Raises:
        InputError: It cannot be read, is not text, or is far too large.
    """
    path = Path(name)
    try:
        if path.stat().st_size > LARGEST_FILE:
            raise InputError(f"{what}: {path} has {path.stat().st_size:,} bytes; at most {LARGEST_FILE:,} are read.")
        return path.read_text()
    except UnicodeDecodeError:
        raise InputError(f"{what}: {path} is not a text file.", path=path) from None
    except OSError as error:
        raise InputError(f"{what}: cannot read {path}: {error.strerror}.", path=path) from None


def _file_numbers(name: str, what: str) -> list[float]:
    lines = (line.split("#")[0] for line in read_text(name, what).splitlines())
    return [_number(part, f"{what}, file {name}") for line in lines for part in re.split(r"[\s,;\[\]]+", line) if part]


def joints(arm: Arm, words: list[str], units: Units, what: str = "joints") -> np.ndarray:
    """Return the joint vector (n,), rad and m, that was typed as numbers, @file, or the name of a posture of the arm.

    Raises:
        InputError: Not as many numbers as joints, or an unknown posture.
    """
    if len(words) == 1 and re.fullmatch(r"[A-Za-z][\w-]*", words[0]) and words[0] != "pi":
        known = {"zero": np.zeros(arm.n)} | arm.description.postures
        if words[0] not in known:
            raise InputError(
                f"{what}: {arm.name} has no posture {words[0]!r}; it knows {', '.join(known)}.", given=words[0]
            )
        return np.asarray(known[words[0]], float)
    values = numbers(words, what)
    if len(values) != arm.n:
        raise InputError(
            f"{what}: {arm.name} has {arm.n} joints ({', '.join(units.names_of_joints(arm))}), "
            f"got {len(values)} numbers.",
            given=values,
        )
    q = np.array(values) * units.of_joints(arm)
    turning = np.array([kind == "R" for kind in arm.joint_types])
    if units.angle == "rad" and np.any(np.abs(q[turning]) > 4 * math.pi):
        import warnings

        from pieper.errors import PieperWarning

        warnings.warn(
            f"{what}: more than two turns; were degrees meant? Then leave --angle rad out.", PieperWarning, stacklevel=2
        )
    return q


def pose(words: list[str], units: Units, order: str = "rpy", what: str = "pose") -> np.ndarray:
    """Return the pose (4, 4), m, that was typed.

    Args:
        words: Three numbers x y z (orientation R = I), x y z and the numbers of the notation, 12 or 16 numbers row by
            row, or @file with any of these.
        units: Of lengths and angles; matrix entries of a rotation have none.
        order: A notation of `orientation.NOTATIONS`: what the numbers after x y z mean.
        what: Its name, for messages.

    Raises:
        InputError: Another count of numbers, an unknown notation, not a rotation.
    """
    if order not in NOTATIONS:
        raise InputError(f"--order {order!r} is unknown; it may be {', '.join(NOTATIONS)}.", given=order)
    values = numbers(words, what)
    count = NOTATIONS[order][0]
    T = np.eye(4)
    if len(values) in (12, 16):
        T[: len(values) // 4] = np.reshape(values, (-1, 4))
        T[:3, 3] *= units.metres
    elif len(values) in (3, 3 + count):
        T[:3, 3] = np.array(values[:3]) * units.metres
        rest = values[3:]
        if rest:
            factor = units.radians if order in ANGLE_NOTATIONS else 1.0
            try:
                T[:3, :3] = rotation(order, [v * factor for v in rest])
            except ValueError as error:
                raise InputError(f"{what}: {error}.", given=rest) from None
    else:
        raise InputError(
            f"{what}: give x y z, or x y z and {count} numbers for {order}, or the 12 or 16 numbers of a matrix row by "
            f"row; got {len(values)} numbers.",
            given=len(values),
        )
    far = float(np.linalg.norm(T[:3, 3]))
    if units.length == "mm" and 0 < far < SUSPICIOUSLY_SMALL:
        import warnings

        from pieper.errors import PieperWarning

        warnings.warn(
            f"{what}: the position is {far * 1e3:.3g} mm from the base; were metres meant? Then say --length m.",
            PieperWarning,
            stacklevel=2,
        )
    return checked_pose(T, what)


def arm(name: str) -> Arm:
    """Return the arm of a catalogue name or a robot file.

    Raises:
        InputError: There is no such arm or file.
    """
    import pieper

    return pieper.load(name)
