"""How a file says that its targets are gone to: speeds, blends, and what happens on the way; read line by line."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import TypeAlias

from pieper.motion.dialects.target import Target
from pieper.motion.instructions import Gripper, Happening, Output, Wait

NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"


@dataclass(frozen=True)
class Manner:
    """How a target is gone to; None for what its line does not say.

    Attributes:
        speed: Part of the joints' full speed of a joint move; the tool's speed of the others, m/s.
        joint_speed: Speed of the fastest joint of a joint move, rad/s, where that is what is said.
        blend: Radius within which the corner is cut, m; 0 stops there.
    """

    speed: float | None = None
    joint_speed: float | None = None
    blend: float | None = None


@dataclass(frozen=True)
class Happenings:
    """How a language says what is no move, to be read; `Events` writes it.

    Attributes:
        wait: Pattern of a rest, its number the one group.
        output: Pattern of an output that is set; groups are `port` and `on`, empty where it is put out.
        comment: What a comment begins with: the gripper stands in one.
        second: How many of the numbers of a rest are a second.
    """

    wait: str
    output: str
    comment: str
    second: float = 1.0

    def read(self, line: str) -> Happening | None:
        """Return what a line says, None where it says something else."""
        if m := re.match(self.wait, line):
            return Wait(float(m[1]) / self.second)
        if m := re.match(self.output, line):
            return Output(int(m["port"]), bool(m["on"]))
        m = re.match(rf"{re.escape(self.comment)} gripper ({NUMBER})$", line)
        return Gripper(float(m[1])) if m else None


#: Reads one line, given what lines before it have set: how a move goes, something that happens, or neither.
Reader: TypeAlias = Callable[[str, dict[str, float]], "Manner | Happening | None"]


def with_manner(text: str, targets: Sequence[Target], reader: Reader) -> list[Target]:
    """Return targets with how they are gone to and what happens before and, at the last, after them.

    Args:
        text: The whole file.
        targets: What was read of it, each with its place in the text.
        reader: Reads one line.
    """
    out: list[Target] = []
    left, state = list(targets), dict[str, float]()
    happened: list[Happening] = []
    end = 0
    for line in text.splitlines(keepends=True):
        end += len(line)
        said = reader(line.strip(), state)
        if isinstance(said, (Wait, Output, Gripper)):
            happened.append(said)
        while left and left[0].place < end:
            manner = said if isinstance(said, Manner) else Manner()
            out.append(
                replace(
                    left.pop(0),
                    speed=manner.speed,
                    joint_speed=manner.joint_speed,
                    blend=manner.blend,
                    before=tuple(happened),
                )
            )
            happened = []
    if happened and not out:
        out.append(Target("stay"))
    if happened:
        out[-1] = replace(out[-1], after=tuple(happened))
    return out


def without_comments(text: str, comment: str) -> str:
    """Return a text with blanks where a pattern of comments meets it, everything else where it was."""
    return re.sub(comment, lambda m: " " * len(m[0]), text)
