"""`pieper check`: a claims file judged, claim by claim."""

from __future__ import annotations

import json as json_format
from pathlib import Path

import click

import pieper
from pieper.cli.layout import Column
from pieper.cli.options import as_json
from pieper.cli.output import as_json as print_json
from pieper.cli.output import print_table, say
from pieper.cli.status import DONE, NO_SOLUTION


@click.command("check", short_help="Judge the claims someone makes about an arm.")
@click.argument("claims")
@click.option("--brief", is_flag=True, help="One line a claim, without counter-examples.")
@as_json
def command(claims: str, brief: bool, json: bool) -> int:
    """Judge the equations and numbers that someone claims about an arm; status 1 when one does not hold.

    CLAIMS is a claims file (.toml).
    """
    if not Path(claims).is_file():
        raise pieper.InputError(f"there is no claims file {claims!r}.", path=claims)
    judged = pieper.check(claims)
    if json:
        print_json(json_format.loads(judged.json()))
    elif brief:
        columns = [Column("claim", True), Column("verdict", True), Column("why", True)]
        print_table(judged.title, columns, [[v.id, v.status, v.sentence] for v in judged.verdicts])
        say(judged.summary())
    else:
        say(judged.text())
    return DONE if judged.ok else NO_SOLUTION
