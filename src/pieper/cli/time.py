"""`pieper time`: straight lines followed by one branch, and the fastest motion along them within limits."""

from __future__ import annotations

from typing import Any

import click
import numpy as np

import pieper
from pieper.cli.arguments import numbers
from pieper.cli.options import (
    TakesNumbers,
    animate,
    as_csv,
    as_json,
    figure,
    order,
    rate,
    start,
    takes_arm,
    takes_limits,
    takes_units,
)
from pieper.cli.output import say
from pieper.cli.path import followed
from pieper.cli.status import DONE, NO_SOLUTION
from pieper.cli.straight import Straight, takes_straight
from pieper.cli.timed import print_data, tell, write
from pieper.cli.units import Units


@click.command("time", cls=TakesNumbers, short_help="Time a path within limits.")
@takes_arm
@takes_straight
@start
@click.option(
    "--constant",
    multiple=True,
    metavar="NUMBERS",
    help="A section of constant tool speed: s0 s1 and the speed, quoted; s from 0 to 1.",
)
@rate
@as_csv
@figure
@animate
@order
@as_json
@takes_units
@takes_limits
def command(
    arm: pieper.Arm,
    straight: Straight,
    start: str,
    constant: tuple[str, ...],
    rate: float,
    csv: str,
    figure: str,
    animate: str,
    order: str,
    json: bool,
    units: Units,
    limits: pieper.Limits | None,
) -> int:
    """Follow straight lines with one branch and time them: as fast as the limits allow, proved on the whole curve.

    Example: pieper time denso-vp6242 --from "350 0 400" --to "200 100 500" --start line-start --speed 180
    --acceleration 600
    """
    if limits is None:
        raise pieper.InputError("a motion needs limits: say --speed and --acceleration, and more where it matters.")
    track, note = followed(arm, straight, start, units, order)
    if note:
        say(note + "\n")
    if not track.complete:
        say(track.explain())
        return NO_SOLUTION
    sections = [_section(text, units) for text in constant]
    try:
        motion = pieper.time_law(track, limits, constant_speed=sections, rate=rate)
    except pieper.InputError as error:
        if "fastest" not in error.data:
            raise
        raise pieper.InputError(_too_fast(error.data, units), **error.data) from None
    written = write(arm, motion, units, csv=csv, figure=figure, animate=animate)
    if json:
        print_data(arm, motion, s=motion.s, deviation=motion.deviation)
        return DONE
    tell(arm, motion)
    off = _off_the_lines(arm, motion, track.path[:, :3, 3])
    say(f"At its samples the tool's point is up to {off * 1e3:.3g} mm off the lines; more points (-n) keep it nearer.")
    for sentence in written:
        say(sentence)
    return DONE


def _off_the_lines(arm: pieper.Arm, motion: pieper.Motion, corners: np.ndarray) -> float:
    """Return how far the tool's point is from the lines between points (N, 3) at a motion's samples, m."""
    p = arm.fk(motion.q)[:, :3, 3]
    way = np.diff(corners, axis=0)
    length = np.maximum((way * way).sum(1), np.finfo(float).tiny)
    # the curve meets the points at their own s, so that a sample's line is known
    k = np.clip((motion.s * len(way)).astype(int), 0, len(way) - 1)
    part = np.clip(((p - corners[k]) * way[k]).sum(1) / length[k], 0.0, 1.0)
    return float(np.linalg.norm(p - corners[k] - part[:, None] * way[k], axis=1).max())


def _too_fast(data: dict[str, Any], units: Units) -> str:
    """Return why a section of constant speed cannot be, its speeds in the units that were typed."""
    (s0, s1, v), s, limit = data["given"], data["s"], data["limit"]
    most = f"{data['fastest'] / units.metres:.6g} {units.length}/s"
    at = {"run-up": f"the run-up to s = {s:.4g}", "run-out": f"the run-out from s = {s:.4g}"}.get(
        limit, f"at s = {s:.4g} the {limit}{' of ' + data['joint'] if data['joint'] else ''}"
    )
    return (
        f"the tool cannot keep {v / units.metres:g} {units.length}/s from s = {s0:g} to {s1:g}: {at} allows {most}, "
        "the highest speed that would do."
    )


def _section(text: str, units: Units) -> tuple[float, float, float]:
    values = numbers([text], "--constant")
    if len(values) != 3:
        raise pieper.InputError(f"--constant takes s0, s1 and a speed, got {len(values)} numbers.", given=values)
    if not 0 <= values[0] < values[1] <= 1:
        raise pieper.InputError(
            f"--constant goes from s = {values[0]:g} to {values[1]:g}; s goes from 0 to 1, forward.", given=values
        )
    if values[2] <= 0:
        raise pieper.InputError(
            f"the speed of --constant must be more than zero, got {values[2]:g} {units.length}/s.", given=values
        )
    return values[0], values[1], values[2] * units.metres
