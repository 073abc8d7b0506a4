"""`pieper animate`: a program or a motion as a moving picture."""

from __future__ import annotations

from pathlib import Path

import click

import pieper
from pieper.cli.arguments import numbers
from pieper.cli.options import TakesNumbers, takes_arm
from pieper.cli.output import say
from pieper.cli.status import DONE
from pieper.cli.timed import drawing

#: Endings of a motion in time.
MOTIONS = (".csv", ".yaml", ".yml")


@click.command("animate", cls=TakesNumbers, short_help="Write a motion as a moving picture.")
@takes_arm
@click.argument("file", metavar="FILE")
@click.argument("out", metavar="OUT")
@click.option("--rate", default=25.0, show_default=True, help="Pictures a second.")
@click.option("--speed", default=1.0, show_default=True, help="1 as it runs, 0.5 half as fast.")
@click.option("--size", default="640 480", show_default=True, metavar="NUMBERS", help="Width and height, pixels.")
@click.option("--view", default="22 -58", show_default=True, metavar="NUMBERS", help="Elevation and azimuth, degrees.")
def command(arm: pieper.Arm, file: str, out: str, rate: float, speed: float, size: str, view: str) -> int:
    """Write FILE, a program (.toml) or a motion in time (.csv, .yaml), into OUT: .gif, .webp, .mp4, or .html.

    The .html is one page that plays the motion, can be turned with the mouse, and needs nothing else.
    """
    if Path(file).suffix.lower() == ".toml":
        motion = pieper.load_program(arm, file).motion(rate=max(4 * rate, 100.0))
    elif Path(file).suffix.lower() in MOTIONS:
        motion = pieper.read_motion(file, arm)
    else:
        raise pieper.InputError(
            f"{file} is no program of pieper (.toml) and no motion in time ({', '.join(MOTIONS)}); for a controller's "
            f"program: pieper program {arm.name} {file} --start JOINTS --speed NUMBERS --acceleration NUMBERS "
            f"--animate {out}.",
            path=file,
        )
    width, height = _two(size, "--size")
    elevation, azimuth = _two(view, "--view")
    motion.animate(
        out,
        arm=arm,
        rate=rate,
        speed=speed,
        size=(int(width), int(height)),
        view=(elevation, azimuth),
        progress=drawing(),
    )
    say(f"{out}: {motion.duration:z.3f} s")
    return DONE


def _two(text: str, what: str) -> tuple[float, float]:
    values = numbers([text], what, pairs=True)
    if len(values) != 2:
        raise pieper.InputError(f"{what} takes two numbers, got {len(values)}.", given=values)
    return values[0], values[1]
