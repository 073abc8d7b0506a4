"""Which numbers of an arm are fitted: their names, units and plausible sizes, and which are held."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from pieper import arguments
from pieper.errors import InputError
from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.chain import Chain
from pieper.tolerances import PLAUSIBLE_DEPARTURE, PLAUSIBLE_GEAR

TERMS = ("gain", "coupling", "harmonic")
#: What `hold` may name beside joints.
TOOL = "tool"

Gears: TypeAlias = tuple[tuple[int, int, int], ...]


@dataclass(frozen=True, eq=False)
class Parameters:
    """The numbers that may change, in the order of a step.

    Args:
        names: One a number, for people: "joint_2 tilt a".
        units: "rad", "m", or "1" of a ratio.
        sizes: (k,) by how much such a number plausibly departs from its nominal value, in its unit.
        free: (k,) False for what is held.
        about: (3,) the place about which axes tilt and the tool turns, m.
        of_axis: One slice a joint.
        of_tool: The slice of the tool's six: turns, then ways.
        gears: (number, joint, of joint): gains where both are the same, else couplings.
        harmonics: (number, joint, 0 for sine or 1 for cosine).
        nominal_gears: (n, n) the gears a gain multiplies.
    """

    names: tuple[str, ...]
    units: tuple[str, ...]
    sizes: Array
    free: Bools
    about: Array
    of_axis: tuple[slice, ...]
    of_tool: slice
    gears: Gears
    harmonics: Gears
    nominal_gears: Array

    @property
    def count(self) -> int:
        """How many there are, held ones too."""
        return len(self.names)


def parameters_of(
    chain: Chain, joint_names: Sequence[str], hold: Sequence[str], joint_terms: Sequence[str]
) -> Parameters:
    """Return the parameters of a chain.

    Raises:
        InputError: A name to hold, or a joint term, that is none.
    """
    _known(joint_terms, TERMS, "joint_terms")
    hold = (hold,) if isinstance(hold, str) else tuple(arguments.several(hold, "hold", "names"))
    names: list[str] = []
    units: list[str] = []
    owners: list[str] = []
    of_axis: list[slice] = []

    def add(owner: str, what: str, unit: str) -> int:
        names.append(f"{owner} {what}")
        units.append(unit)
        owners.append(owner)
        return len(names) - 1

    for name, slides in zip(joint_names, chain.prismatic, strict=True):
        first = len(names)
        for what in ("tilt a", "tilt b"):
            add(name, what, "rad")
        for what in () if slides else ("shift a", "shift b"):
            add(name, what, "m")
        of_axis.append(slice(first, len(names)))
    first = len(names)
    for what, unit in (("turn", "rad"), ("shift", "m")):
        for axis in "xyz":
            add(TOOL, f"{what} {axis}", unit)
    of_tool = slice(first, len(names))
    gears: list[tuple[int, int, int]] = []
    harmonics: list[tuple[int, int, int]] = []
    slides = chain.prismatic
    for i, name in enumerate(joint_names):
        if "gain" in joint_terms:
            gears.append((add(name, "gain", "1"), i, i))
        # an earlier drive carries a later joint along (wrists, parallelograms)
        for j in range(i) if "coupling" in joint_terms else ():
            unit = "1" if slides[i] == slides[j] else "m/rad" if slides[i] else "rad/m"
            gears.append((add(name, f"coupling with {joint_names[j]}", unit), i, j))
        if "harmonic" in joint_terms and not slides[i]:
            harmonics += [(add(name, f"harmonic {wave}", "rad"), i, k) for k, wave in enumerate(("sine", "cosine"))]
    allowed = (*joint_names, TOOL, *names)
    _known(hold, allowed, "hold")
    free = np.array([not (owner in hold or name in hold) for owner, name in zip(owners, names, strict=True)])
    if not free.any():
        raise InputError("hold names everything there is: nothing is left to fit.", given=hold)
    L = chain.length
    scale = {
        "rad": PLAUSIBLE_DEPARTURE,
        "m": PLAUSIBLE_DEPARTURE * L,
        "1": PLAUSIBLE_GEAR,
        "m/rad": PLAUSIBLE_GEAR * L,
        "rad/m": PLAUSIBLE_GEAR / L,
    }
    about = np.array([*chain.points[~slides], chain.home[:3, 3]]).mean(0)
    return Parameters(
        tuple(names),
        tuple(units),
        np.array([scale[unit] for unit in units]),
        free,
        about,
        tuple(of_axis),
        of_tool,
        tuple(gears),
        tuple(harmonics),
        np.eye(chain.n) if chain.coupling is None else np.array(chain.coupling),
    )


def _known(said: Sequence[str], allowed: Sequence[str], what: str) -> None:
    for name in (said,) if isinstance(said, str) else arguments.several(said, what, "names"):
        if not isinstance(name, str) or name not in allowed:
            shown = ", ".join(repr(a) for a in allowed[:12]) + (", ..." if len(allowed) > 12 else "")
            raise InputError(f"{what} names {name!r}; it may name {shown}.", given=name, allowed=tuple(allowed))
