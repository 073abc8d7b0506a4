"""`pieper code`: an arm's solver in another language."""

from __future__ import annotations

import click

import pieper
from pieper import InputError
from pieper.cli.options import takes_arm
from pieper.cli.status import DONE

#: Language -> the ending of its files.
ENDINGS = {"c": "c", "c++": "hpp", "python": "py", "matlab": "m", "javascript": "mjs", "jax": "py", "wasm": "wasm"}


@click.command("code", short_help="Write an arm's solver in another language.")
@takes_arm
@click.option("--to", "language", required=True, type=click.Choice(list(ENDINGS)), help="The language.")
@click.option("--out", "-o", default="", metavar="FILE", help="Where to; named after the arm when left out.")
@click.option("--name", default="arm", show_default=True, help="What the functions begin with: NAME_ik, NAME_fk.")
def command(arm: pieper.Arm, language: str, out: str, name: str) -> int:
    """Write an arm's inverse and forward kinematics as one file that needs no pieper.

    The file has a self-test of 20 poses and says where its numbers come from.

    Example: pieper code denso-vp6242 --to c --name denso
    """
    if out == "-":
        raise InputError("--out takes the name of a file, not the standard output.", given=out)
    stem = "".join(letter if letter.isalnum() else "_" for letter in arm.name)
    print(arm.code(language, out or f"{stem}.{ENDINGS[language]}", name))
    return DONE
