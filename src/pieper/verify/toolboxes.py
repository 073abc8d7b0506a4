"""What a toolbox must answer to be compared with, and which ones are known."""

from __future__ import annotations

from importlib import import_module
from importlib.util import find_spec
from typing import Protocol, cast, runtime_checkable

from pieper.description.dh import Description
from pieper.errors import InputError
from pieper.kinematics.arrays import Array


@runtime_checkable
class Toolbox(Protocol):
    """An arm as a toolbox has it.

    Attributes:
        name: The toolbox and its version.
        words: How it was given the arm and in which conventions it answers, in sentences.
    """

    name: str
    words: str

    def fk(self, q: Array) -> Array:
        """Pose (4, 4) of the tool in the base frame, of joint values (n,)."""
        ...

    def jacobian(self, q: Array) -> Array:
        """Jacobian (6, n): the tool point, in the base frame, linear rows first."""
        ...

    def solve(self, T: Array, start: Array) -> Array | None:
        """Joint values (n,) by the toolbox's own inverse kinematics from a start (n,); None where there are none."""
        ...


class Builder(Protocol):
    """A room that makes a toolbox's arm."""

    def build(self, arm: Description) -> Toolbox:
        """Return the arm as the toolbox has it."""
        ...


#: Toolbox -> the package that is imported.
KNOWN = {"roboticstoolbox": "roboticstoolbox", "pinocchio": "pinocchio", "mujoco": "mujoco"}


def installed() -> list[str]:
    """Return the known toolboxes that are installed."""
    return [name for name, package in KNOWN.items() if find_spec(package) is not None]


def open_toolbox(name: str, arm: Description) -> Toolbox:
    """Return an arm as a toolbox has it.

    Raises:
        InputError: It is not known or not installed; the message names those that are.
    """
    if name not in KNOWN:
        raise InputError(f"toolboxes are {', '.join(KNOWN)}, got {name!r}.", given=name, allowed=list(KNOWN))
    if find_spec(KNOWN[name]) is None:
        there = installed()
        raise InputError(
            f"{name} is not installed: pip install 'pieper[{name}]'"
            + (f"; {' and '.join(there)} {'is' if len(there) == 1 else 'are'}." if there else "."),
            given=name,
            allowed=there,
        )
    room = cast(Builder, import_module(f"pieper.verify.with_{name}"))
    return room.build(arm)
