"""The catalogue searched by maker, joints, payload and reach, from an index that opens none of its files."""

from __future__ import annotations

import os
from dataclasses import dataclass
from functools import cache

from pieper import arguments
from pieper.description import catalog
from pieper.description.dh import Description
from pieper.errors import InputError

FILE = os.path.join(catalog.FOLDER, "index.tsv")
HEAD = "name\tmanufacturer\tjoint_types\tpayload_kg\treach_mm"


@dataclass(frozen=True, slots=True)
class Entry:
    """What a person chooses an arm by.

    Args:
        name: Its name in the catalogue.
        manufacturer: Its maker.
        joint_types: One letter a joint, R or P.
        payload: What the maker says it carries, kg; None where it is not known.
        reach: How far the maker says it reaches, m; None where it is not known.
    """

    name: str
    manufacturer: str
    joint_types: str
    payload: float | None
    reach: float | None

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.joint_types)


@cache
def entries() -> tuple[Entry, ...]:
    """Return every arm of the catalogue, sorted by name; only the index is read."""
    with open(FILE, encoding="utf-8") as file:
        lines = file.read().splitlines()[1:]
    out = []
    for line in lines:
        name, maker, kinds, payload, reach = line.split("\t")
        out.append(
            Entry(name, maker, kinds, float(payload) if payload else None, float(reach) / 1000 if reach else None)
        )
    return tuple(out)


def find(
    words: str = "",
    *,
    maker: str | None = None,
    joints: int | str | None = None,
    payload: float | None = None,
    reach: float | None = None,
) -> tuple[Entry, ...]:
    """Return the arms that answer to everything that is said, sorted by name.

    Args:
        words: Words that all stand in the name or the maker, in any order and case.
        maker: A part of the maker's name.
        joints: How many, or their types, such as "RRPR", "6R".
        payload: Carries at least this, kg; arms whose payload is not known are left out.
        reach: Reaches at least this far, m; arms whose reach is not known are left out.

    Raises:
        InputError: A number is below zero or no number, or the joints cannot be read.
    """
    for what, value, unit in (("payload", payload, "kg"), ("reach", reach, "m")):
        if value is not None:
            arguments.number(value, what, unit, least=0.0)
    kinds = None if joints is None else _kinds(joints)
    wanted = arguments.text(words, "words").lower().split()
    by = None if maker is None else arguments.text(maker, "maker").lower()

    def fits(arm: Entry) -> bool:
        said = f"{arm.name} {arm.manufacturer}".lower()
        return (
            all(word in said for word in wanted)
            and (by is None or by in arm.manufacturer.lower())
            and (kinds is None or (arm.n == kinds if isinstance(kinds, int) else arm.joint_types == kinds))
            and (payload is None or (arm.payload is not None and arm.payload >= payload))
            and (reach is None or (arm.reach is not None and round(arm.reach, 6) >= round(reach, 6)))
        )

    return tuple(arm for arm in entries() if fits(arm))


def _kinds(joints: int | str) -> int | str:
    said = joints.strip().upper() if isinstance(joints, str) else str(arguments.whole(joints, "joints", 1))
    if said.isdigit() and int(said) > 0:
        return int(said)
    if said[:-1].isdigit() and said[-1:] in ("R", "P") and 0 < int(said[:-1]) < 100:
        return said[-1] * int(said[:-1])
    if said and not set(said) - {"R", "P"}:
        return said
    raise InputError(
        f"joints {joints!r} cannot be read: give how many, such as 6, or their types, such as 6R or RRPR.", given=joints
    )


def text_of(arms: list[Description]) -> str:
    """Return the text of the index of these arms."""
    lines = [HEAD]
    for arm in sorted(arms, key=lambda arm: arm.name):
        payload = "" if arm.payload is None else f"{arm.payload:g}"
        reach = "" if arm.reach is None else f"{round(1000 * arm.reach, 3):g}"
        lines.append(f"{arm.name}\t{arm.manufacturer}\t{arm.joint_types}\t{payload}\t{reach}")
    return "\n".join(lines) + "\n"
