"""What every dialect shares: the script it is handed, the targets it reads back, numbers and names."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from textwrap import wrap
from typing import TypeVar

import numpy as np

from pieper.description.dh import Description
from pieper.errors import InputError
from pieper.kinematics.arrays import Array
from pieper.kinematics.pose import inverse
from pieper.kinematics.spoken import read_pose
from pieper.motion.dialects.configuration import Configuration, configuration
from pieper.motion.dialects.manner import NUMBER, Reader, with_manner
from pieper.motion.dialects.target import Target
from pieper.motion.instructions import FrameChange, Instruction, Move, ToolChange
from pieper.motion.limits import Limits
from pieper.motion.motion import Motion
from pieper.solver.plan.plan import Plan
from pieper.words_by_number import plural

#: Tool speed that is written where none was said, m/s, as long as the limit of the tool's speed allows it.
USUAL_SPEED = 0.25


_NOBODY = "The arm's robot file names no maker: that its joints count as this controller's do is taken for granted."
_Key = TypeVar("_Key", str, int)


@dataclass(frozen=True, eq=False)
class Setup:
    """The tool and the work frame that hold where an instruction stands.

    Attributes:
        tool: (4, 4) in the last frame of the table, m.
        frame: (4, 4) in the base, m.
        tool_number: 1 for the arm's own, then counted as they first come.
        frame_number: 0 for the base, then counted as they first come.
    """

    tool: Array
    frame: Array
    tool_number: int = 1
    frame_number: int = 0


@dataclass(frozen=True, eq=False)
class Script:
    """A program as a writer sees it.

    Attributes:
        name: Its name, as the maker takes names.
        instructions: In order.
        plan: How the arm is solved.
        description: What is known of the arm.
        limits: What its motion keeps.
        start: (n,) posture it begins in.
        cartesian: Whether joint moves go to poses with configuration words rather than to joint values.
        motion: The timed motion, made when it is asked for.
    """

    name: str
    instructions: Sequence[Instruction]
    plan: Plan
    description: Description
    limits: Limits
    start: Array
    cartesian: bool
    motion: Callable[[], Motion]

    @property
    def moves(self) -> list[Move]:
        """The moves alone."""
        return [item for item in self.instructions if isinstance(item, Move)]

    def steps(self) -> Iterator[tuple[Instruction, Setup]]:
        """Yield each instruction with what holds at it; a change of tool or frame with what holds from there on.

        The poses of moves are those seen from the work frame.
        """
        tools, frames = [self.description.tool], [np.eye(4)]
        now = Setup(tools[0], frames[0])
        for item in self.instructions:
            if isinstance(item, ToolChange):
                k = _numbered(item.T, tools)
                now = replace(now, tool=tools[k], tool_number=k + 1)
            elif isinstance(item, FrameChange):
                k = _numbered(item.T, frames)
                now = replace(now, frame=frames[k], frame_number=k)
            elif isinstance(item, Move) and now.frame_number:
                seen = inverse(now.frame)
                yield replace(item, T=seen @ item.T, via=None if item.via is None else seen @ item.via), now
                continue
            yield item, now

    def setups(self) -> tuple[dict[int, Array], dict[int, Array]]:
        """Return the tools and the work frames that are changed to, by number."""
        tools: dict[int, Array] = {}
        frames: dict[int, Array] = {}
        for item, now in self.steps():
            if isinstance(item, ToolChange):
                tools[now.tool_number] = now.tool
            elif isinstance(item, FrameChange) and now.frame_number:
                frames[now.frame_number] = now.frame
        return tools, frames

    def degrees(self, q: Array) -> list[float]:
        """Return joint values as controllers take them: degrees, and millimetres of a slide."""
        return [float(v) for v in np.where(self.plan.prismatic, q * 1e3, np.degrees(q))]

    def configuration(self, q: Array, maker: str) -> Configuration:
        """Return a posture (n,) in a maker's configuration words."""
        return configuration(self.plan, q, maker, self.description.manufacturer)

    def line_speed(self, move: Move) -> float:
        """Return the speed of the tool's point that is written for a line or circle, m/s, within its limit."""
        said = USUAL_SPEED if move.speed is None else move.speed
        return said if self.limits.tool_speed is None else min(said, self.limits.tool_speed)

    def head(self, mark: str, width: int = 110, shares: bool = True) -> list[str]:
        """Return what a reader must know, as comments of at most `width` characters.

        Args:
            mark: What a comment begins with.
            width: Most characters of a line.
            shares: Whether joint moves are told in parts of the controller's full speed.
        """
        tool = read_pose(self.description.tool, "rpy", degrees=True, mm=True)
        said = [
            f"{self.plan.name}, {plural(len(self.moves), 'move')}; joints as in its robot file.",
            f"Tool in the last frame of its table: x y z {numbers(tool[:3], 3)} mm, rpy {numbers(tool[3:], 4)} deg; "
            "set the same on the controller.",
            *self._speeds(shares),
            *([] if self.description.manufacturer.strip() else [_NOBODY]),
            "Not confirmed on a controller.",
        ]
        return [f"{mark} {line}" for text in said for line in wrap(text, width - len(mark) - 1)]

    def _speeds(self, shares: bool) -> list[str]:
        """Return what the written speeds are, where that is not plain from the file."""
        out: list[str] = []
        if any(move.kind not in ("move_j", "move_s") and move.speed is None for move in self.moves):
            usual = self.line_speed(Move("move_l", self.start, np.eye(4))) * 1e3
            out.append(f"Lines of no given speed run at {usual:.6g} mm/s.")
        if shares and any(move.kind == "move_j" for move in self.moves):
            most = np.degrees(self.limits.of(self.plan.n, self.plan.names).speed)
            said = f"{most.min():.6g}" if np.ptp(most) == 0 else f"{most.min():.6g} to {most.max():.6g}"
            out.append(
                "Speeds of joint moves are parts of the controller's own full speed, not of the limits the motion was "
                f"timed with ({said} deg/s): lower the override where those are less."
            )
        return out


@dataclass(frozen=True)
class Dialect:
    """A controller's language.

    Attributes:
        name: What it is called here.
        suffixes: Endings of its files, the first one usual.
        maker: Whose arms it is for, a key of the configuration words, "ur", or None for any.
        longest: Most characters of a program's name.
        write: The text of a script.
        read: The targets of a text.
        lines: What lines of a text may be, patterns of whole lines without the blanks around; none for any.
        reader: Reads of a line how a move goes or what happens; None where files do not say it.
        reserved: Words that are no program's name.
        exact_words: Whether large letters in them are others than small ones.
    """

    name: str
    suffixes: tuple[str, ...]
    maker: str | None
    longest: int
    write: Callable[[Script], str]
    read: Callable[[str], list[Target]]
    lines: tuple[str, ...] = ()
    reader: Reader | None = None
    reserved: frozenset[str] = frozenset()
    exact_words: bool = False

    def targets(self, text: str) -> list[Target]:
        """Return the targets of a text, or say which line is not understood: none is passed over.

        Raises:
            InputError: A line that is none of the dialect as it is written here.
        """
        known = re.compile("|".join(f"(?:{line})" for line in self.lines))
        for number, line in enumerate(text.splitlines() if self.lines else (), 1):
            said = line.strip()
            if said and not known.fullmatch(said):
                raise InputError(
                    f"line {number} is not {self.name} as it is written here: {said[:80]!r}. Only what Program.write "
                    "makes is read, and nothing is passed over: write such lines as moves to named or plain targets, "
                    "or leave them out.",
                    line=number,
                    given=said,
                )
        targets = self.read(text)
        return targets if self.reader is None else with_manner(text, targets, self.reader)


def _numbered(T: Array, known: list[Array]) -> int:
    """Return which of the known poses one is, put at their end where it is new."""
    for k, other in enumerate(known):
        if np.array_equal(T, other):
            return k
    known.append(T)
    return len(known) - 1


def numbers(values: Sequence[float], digits: int, between: str = " ") -> str:
    """Return numbers with a fixed count of decimals, zero without a sign."""
    return between.join(fixed(v, digits) for v in values)


def fixed(value: float, digits: int) -> str:
    """Return a number with a fixed count of decimals, zero without a sign."""
    return f"{value:z.{digits}f}"


def listed(count: int, number: str = NUMBER) -> str:
    """Return the pattern of so many numbers between commas."""
    return r"\s*,\s*".join([number] * count)


def known_one(what: str, name: _Key, known: Mapping[_Key, Array]) -> Array:
    """Return a tool or frame by its name, or say that the file does not set it."""
    if name not in known:
        raise InputError(
            f"{what} {name} is taken and nowhere set in the file: where its targets stand is not known. Set it in the "
            "file as Program.write does.",
            given=name,
        )
    return known[name]


def found(text: str, count: int, pattern: str = NUMBER) -> list[float]:
    """Return the first numbers of a text."""
    return [float(v) for v in re.findall(pattern, text)[:count]]


def named(text: str, names: Sequence[str]) -> list[float] | None:
    """Return the numbers that follow names such as X or A1 in a text, None where one is missing."""
    out: list[float] = []
    for name in names:
        hit = re.search(rf"(?<![A-Za-z0-9]){re.escape(name)}\s*=?\s*({NUMBER})", text)
        if hit is None:
            return None
        out.append(float(hit[1]))
    return out


#: What to do about a name that a maker does not take: it is the file's where none is said.
RENAME = "name the file so, or say another with name="


def checked_name(name: str, dialect: Dialect) -> str:
    """Return a program's name, or say why the maker does not take it."""
    if not name.isascii():
        raise InputError(f"a {dialect.name} program's name must be ASCII, got {name!r}; {RENAME}.", given=name)
    if not re.fullmatch(r"[A-Za-z][A-Za-z0-9_]*", name):
        raise InputError(
            f"a {dialect.name} program's name begins with a letter and has letters, digits and _ alone, got {name!r}; "
            f"{RENAME}.",
            given=name,
        )
    if (name if dialect.exact_words else name.lower()) in dialect.reserved:
        raise InputError(
            f"{name!r} is a word of {dialect.name} itself, and no program's name; {RENAME}.",
            given=name,
        )
    if len(name) > dialect.longest:
        raise InputError(
            f"a {dialect.name} program's name has at most {dialect.longest} characters, {name!r} has {len(name)}; "
            f"{RENAME}.",
            given=name,
        )
    return name
