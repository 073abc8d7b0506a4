"""Straight lines through poses, as commands are given them: --from, --via, --to and --points."""

from __future__ import annotations

import functools
from dataclasses import dataclass
from typing import Any

import click
import numpy as np
import numpy.typing as npt

import pieper
from pieper.cli.arguments import Target, target
from pieper.cli.options import Command
from pieper.cli.units import Units


@dataclass(frozen=True)
class Straight:
    """What was typed.

    Attributes:
        first: The first pose; empty where none was said.
        via: Poses on the way.
        last: The last pose.
        points: Poses on each stretch, ends included.
    """

    first: str
    via: tuple[str, ...]
    last: str
    points: int

    @property
    def typed(self) -> bool:
        """Whether any pose was said."""
        return bool(self.first or self.via or self.last)

    def targets(self, units: Units, order: str, missing: str) -> list[Target]:
        """Return the poses in their order.

        Raises:
            pieper.InputError: An end is missing, with that sentence; a pose cannot be read.
        """
        if not self.first or not self.last:
            raise pieper.InputError(missing)
        words = [("--from", self.first), *(("--via", v) for v in self.via), ("--to", self.last)]
        return [target([text], units, order, what) for what, text in words]

    def through(self, poses: list[npt.NDArray[np.float64]]) -> npt.NDArray[np.float64]:
        """Return straight lines (k, 4, 4) through poses, corners once."""
        stretches = [pieper.line(a, b, self.points) for a, b in zip(poses[:-1], poses[1:], strict=True)]
        return np.concatenate([stretches[0], *(s[1:] for s in stretches[1:])])


def takes_straight(command: Command) -> Command:
    """Add --from, --to, --via and --points; the command is given `straight`."""

    @functools.wraps(command)
    def with_straight(first: str, last: str, via: tuple[str, ...], points: int, **rest: Any) -> Any:
        return command(straight=Straight(first, via, last, points), **rest)

    made: Command = with_straight
    for option in (
        click.option("--points", "-n", default=50, show_default=True, help="Poses on each stretch, ends included."),
        click.option("--via", multiple=True, metavar="POSE", help="A pose on the way; may be repeated."),
        click.option("--to", "last", default="", metavar="POSE", help="Last pose, quoted, as for ik; or @file."),
        click.option("--from", "first", default="", metavar="POSE", help="First pose, quoted, as for ik; or @file."),
    ):
        made = option(made)
    return made
