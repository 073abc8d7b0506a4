"""`pieper robots`: which arms ship, searched by maker, joints, payload and reach."""

from __future__ import annotations

import click

import pieper
from pieper.cli.layout import Column
from pieper.cli.options import as_json
from pieper.cli.output import as_json as print_json
from pieper.cli.output import plural, print_table, say
from pieper.cli.status import DONE


@click.command("robots", short_help="List the arms that ship; search them.")
@click.argument("words", nargs=-1)
@click.option("--maker", metavar="NAME", help="A part of the maker's name.")
@click.option("--joints", metavar="WHICH", help="How many joints, or their types: 6, 7R, RRPR.")
@click.option("--payload", type=float, metavar="KG", help="Carries at least this, kg.")
@click.option("--reach", type=float, metavar="MM", help="Reaches at least this far, mm, by the maker's own measure.")
@as_json
def command(
    words: tuple[str, ...],
    maker: str | None,
    joints: str | None,
    payload: float | None,
    reach: float | None,
    json: bool,
) -> int:
    """List the arms that ship, or those whose name or maker has all the WORDS.

    Payload and reach are the maker's figures; an arm for which they are not known is not found by them.
    """
    far = None if reach is None else reach / 1000
    found = pieper.find_arms(" ".join(words), maker=maker, joints=joints, payload=payload, reach=far)
    if json:
        print_json([_said(arm.name) for arm in found])
        return DONE
    columns = [Column("name", True), Column("joints", True), *(Column(head) for head in ("payload, kg", "reach, mm"))]
    cells = [
        [
            arm.name,
            _short(arm.joint_types),
            "-" if arm.payload is None else f"{arm.payload:g}",
            "-" if arm.reach is None else f"{1000 * arm.reach:g}",
            arm.manufacturer,
        ]
        for arm in found
    ]
    if not found:
        asked = " ".join(words)
        say(
            (f"No arm's name or maker has {asked!r}" if words else "No arm is so")
            + ". Search by --maker, --payload, --reach, or by kinds of joints: --joints 7R, --joints RRPR (a SCARA)."
        )
        return DONE
    print_table(plural(len(found), "arm"), [*columns, Column("maker", True)], cells)
    return DONE


def _said(name: str) -> dict[str, object]:
    d = pieper.load(name).description
    return {
        "name": name,
        "joints": d.n,
        "joint_types": d.joint_types,
        "convention": d.convention,
        "manufacturer": d.manufacturer,
        "payload_kg": d.payload,
        "reach_m": d.reach,
        "source": d.source,
    }


def _short(kinds: str) -> str:
    return f"{len(kinds)}{kinds[0]}" if len(set(kinds)) == 1 else kinds
