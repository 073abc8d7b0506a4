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
@click.option("--robot", help="The arm of a text or LaTeX excerpt: a catalogue name or a robot file.")
@click.option("--out", type=click.Path(dir_okay=False), help="Where the claims guessed from an excerpt are written.")
@as_json
def command(claims: str, brief: bool, robot: str | None, out: str | None, json: bool) -> int:
    """Judge the equations and numbers that someone claims about an arm; status 1 when one does not hold.

    CLAIMS is a claims file (.toml). Of any other text (.tex, .txt, .md) the claims are guessed with --robot, and
    written to a claims file for you to look through.
    """
    if not Path(claims).is_file():
        raise pieper.InputError(f"there is no claims file {claims!r}.", path=claims)
    if Path(claims).suffix != ".toml":
        return _guess(Path(claims), robot, out)
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


def _guess(source: Path, robot: str | None, out: str | None) -> int:
    if not robot:
        raise pieper.InputError(
            f"{source}: this is no claims file (.toml). To guess the claims of a text, name its arm with --robot.",
            path=str(source),
        )
    target = Path(out) if out else source.with_suffix(".claims.toml")
    if target.exists():
        raise pieper.InputError(f"{target} exists; name another file with --out.", path=str(target))
    made, read, missed = pieper.guess_claims(source.read_text(encoding="utf-8"), robot, source.name)
    partial = target.with_name(target.name + ".part")
    partial.write_text(made, encoding="utf-8")
    partial.replace(target)
    say(f"{target}: {read} equations read, {missed} not. Look it through, then run pieper check on it.")
    return DONE
