"""`pieper tour`: a whole study, written up."""

from __future__ import annotations

from pathlib import Path

import click

from pieper.cli.output import say
from pieper.cli.status import DONE, NO_SOLUTION


@click.command("tour", short_help="Run a whole study and write it up.")
@click.option("--out", "-o", default="pieper-tour", show_default=True, help="Folder for the page and the figures.")
def command(out: str) -> int:
    """Run a whole study on the Denso VP-6242 and write it up on one page."""
    from pieper.cli.denso_study import run

    page, complete = run(Path(out), say=say)
    say(f"\nThe page: {page.resolve()}")
    return DONE if complete else NO_SOLUTION
