"""`pieper check`: a claims file judged, claim by claim."""

from __future__ import annotations

import json as json_format
from pathlib import Path

from pieper.cli import DONE, NO_SOLUTION
from pieper.cli.printed import as_json, console, table
from pieper.errors import InputError

COLOURS = {"holds": "green", "holds only in part": "yellow", "wrong": "red"}


def check(file: str, json: bool, brief: bool) -> int:
    """Judge a claims file and print the verdicts; the status is 1 when a claim does not hold."""
    if not Path(file).is_file():
        raise InputError(f"there is no claims file {file!r}.", path=file)
    from pieper import check as judge

    report = judge(file)
    status = DONE if report.ok else NO_SOLUTION
    if json:
        as_json(json_format.loads(report.json()))
        return status
    out = console()
    if brief:
        made = table(report.title, "claim", "verdict", "why", left=(0, 1, 2))
        for v in report.verdicts:
            made.add_row(v.id, f"[{COLOURS.get(v.status, 'white')}]{v.status}[/]", v.sentence.replace("[", "\\["))
        out.print(made)
        out.print(report.summary(), markup=False)
    else:
        out.print(report.text(), markup=False)
    return status
