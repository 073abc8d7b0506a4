"""A robot as links and joints, whichever kind of file it came from, and the way from one link to another."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import NoReturn

import numpy as np
import numpy.typing as npt

from pieper.errors import InputError

#: Joint kinds a serial arm may have, and their letter.
MOVING = {"revolute": "R", "continuous": "R", "prismatic": "P"}
#: A file with more joints is not one robot, and the walks below take their number times their depth.
MOST_JOINTS = 5000


@dataclass(frozen=True, slots=True)
class Mimic:
    """value of the joint = multiplier * value of `joint` + offset (rad or m)."""

    joint: str
    multiplier: float = 1.0
    offset: float = 0.0


@dataclass(slots=True, eq=False)
class Joint:
    """A joint as the file says it; what the numbers of its frame are is asked of the tree, when they are needed.

    Args:
        name: Its name.
        kind: "revolute", "continuous", "prismatic", "fixed", or what else the file calls it.
        parent: Link it hangs from.
        child: Link that hangs from it.
        line: Line of the file, 0 where there is none.
        lower: Lower limit, rad or m; None where the file is silent, NaN where it is not a number.
        upper: Upper limit.
        mimic: The joint whose value it follows.
        held: The value at which something holds it still (rad or m); its kind is "fixed" and its frame is there.
        bound: What ties it to others, where no coupling of joints can say that.
    """

    name: str
    kind: str
    line: int = 0
    parent: str = ""
    child: str = ""
    lower: float | None = None
    upper: float | None = None
    mimic: Mimic | None = None
    held: float | None = None
    bound: str = ""

    @property
    def moves(self) -> bool:
        """Whether anything but a fixed frame hangs from it."""
        return self.kind != "fixed"


@dataclass(slots=True, eq=False)
class Tree:
    """Links and joints of one file.

    Args:
        file: What messages call the file.
        name: Name of the robot.
        format: What kind of file it is.
        links: Names, in the file's order.
        joints: In the file's order.
        geometry: Joint -> its frame (4, 4) in the parent link and its unit axis (3,) in its own frame.
        remarks: Joints -> sentences about how their numbers were read.
        postures: Named values of joints, by their names.
        above: Link -> the joint it hangs from.
        below: Link -> the joints that hang from it.
    """

    file: str
    name: str
    format: str
    links: list[str]
    joints: list[Joint]
    geometry: Callable[[Joint], tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]]
    remarks: Callable[[list[Joint]], tuple[str, ...]] = lambda _: ()
    postures: dict[str, dict[str, float]] = field(default_factory=dict)
    above: dict[str, Joint] = field(default_factory=dict)
    below: dict[str, list[Joint]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        named = [link for joint in self.joints for link in (joint.parent, joint.child)]
        self.links = list(dict.fromkeys([*self.links, *named]))
        if not self.joints:
            raise InputError(
                f"{self.file}: there is no joint in this file; an arm has at least one. Load the robot's own file.",
                file=self.file,
            )
        if len(self.joints) > MOST_JOINTS:
            raise InputError(
                f"{self.file}: {len(self.joints):,} joints; at most {MOST_JOINTS:,} are read.", file=self.file
            )
        for joint in self.joints:
            if joint.child in self.above:
                other = self.above[joint.child]
                self.fail(
                    f"link {joint.child!r} hangs from two joints, {other.name!r} and {joint.name!r}; a closed loop is "
                    "not a serial arm. Take one of the two out of the file.",
                    joint,
                )
            self.above[joint.child] = joint
            self.below.setdefault(joint.parent, []).append(joint)
        self._no_ring()

    def _no_ring(self) -> None:
        seen: set[str] = set()
        stack = [link for link in self.links if link not in self.above]
        while stack:
            link = stack.pop()
            seen.add(link)
            stack += [joint.child for joint in self.below.get(link, ())]
        left = [link for link in self.links if link not in seen]
        if left:
            raise InputError(
                f"{self.file}: the links form a ring at {left[0]!r}; each hangs from another and none from a base. "
                "Take out the joint that closes it.",
                file=self.file,
                links=left,
            )

    @property
    def roots(self) -> list[str]:
        """Links that hang from nothing."""
        return [link for link in self.links if link not in self.above]

    def path(self, base: str, tip: str) -> list[tuple[Joint, bool]]:
        """Return the joints from base to tip, each with whether it is walked upward, from child to parent.

        Raises:
            InputError: The two links are in separate parts of the file.
        """
        up, down = self._to_root(base), self._to_root(tip)
        while up and down and up[-1] is down[-1]:
            up.pop()
            down.pop()
        top_of_base = up[-1].parent if up else base
        top_of_tip = down[-1].parent if down else tip
        if top_of_base != top_of_tip:
            raise InputError(
                f"{self.file}: link {tip!r} does not hang from {base!r}, nor do both hang from a third link.",
                file=self.file,
                base=base,
                tip=tip,
            )
        return [(joint, True) for joint in up] + [(joint, False) for joint in reversed(down)]

    def _to_root(self, link: str) -> list[Joint]:
        chain = []
        while link in self.above:
            chain.append(self.above[link])
            link = self.above[link].parent
        return chain

    def fail(self, message: str, joint: Joint | None = None, **data: object) -> NoReturn:
        """Raise an InputError that names the file, and the line and name of a joint."""
        line = joint.line if joint is not None and joint.line else None
        where = self.file if line is None else f"{self.file}, line {line}"
        name = None if joint is None else joint.name
        raise InputError(f"{where}: {message}", file=self.file, line=line, joint=name, **data)


def has_range(joint: Joint) -> bool:
    """Return whether the file says a range in which the joint can move; 0..0 is what exporters write for none."""
    if joint.kind == "continuous":
        return True
    if joint.lower is None and joint.upper is None:
        return False
    return not ((joint.lower or 0.0) == 0.0 and (joint.upper or 0.0) == 0.0)


def span(joint: Joint) -> float:
    """Return how far the joint can move, rad or m; infinite where the file does not say."""
    if not has_range(joint) or joint.kind == "continuous":
        return math.inf
    width = (joint.upper or 0.0) - (joint.lower or 0.0)
    return width if math.isfinite(width) else math.inf


def some(names: list[str], most: int = 12) -> str:
    """Return a list of names as text, the first ones if there are many."""
    return ", ".join(names[:most]) + (f" and {len(names) - most} more" if len(names) > most else "")
