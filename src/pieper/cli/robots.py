"""`pieper robots`: which arms ship."""

from __future__ import annotations

import click

import pieper
from pieper.cli.layout import Column
from pieper.cli.options import as_json
from pieper.cli.output import as_json as print_json
from pieper.cli.output import plural, print_table
from pieper.cli.status import DONE

KEYS = ("name", "joints", "joint_types", "convention", "manufacturer", "source")


@click.command("robots", short_help="List the arms that ship.")
@click.argument("pattern", default="")
@as_json
def command(pattern: str, json: bool) -> int:
    """List the arms that ship, or those whose name or maker contains PATTERN."""
    rows = []
    for name in pieper.catalog():
        d = pieper.load(name).description
        if pattern.lower() in f"{name} {d.manufacturer}".lower():
            rows.append((name, d.n, d.joint_types, d.convention, d.manufacturer, d.source))
    if json:
        print_json([dict(zip(KEYS, row, strict=True)) for row in rows])
        return DONE
    columns = [Column("name", True), Column("joints", True), Column("DH", True), Column("maker", True)]
    cells = [[name, types, convention, maker] for name, _, types, convention, maker, _ in rows]
    print_table(plural(len(rows), "arm"), columns, cells)
    return DONE
