"""`pieper map`: a box filled with answers."""

from __future__ import annotations

import os
import re
import signal
import sys
import threading
import time
import warnings
from concurrent.futures import Executor, ProcessPoolExecutor
from contextlib import ExitStack
from importlib import import_module
from multiprocessing import parent_process
from pathlib import Path
from typing import Any

import click

import pieper
from pieper import InputError
from pieper.cli.arguments import numbers
from pieper.cli.failure import note
from pieper.cli.options import TakesNumbers, as_json, takes_arm, takes_units
from pieper.cli.output import as_json as print_json
from pieper.cli.output import plural, say, short
from pieper.cli.status import DONE
from pieper.cli.stopping import told
from pieper.cli.units import Units
from pieper.tolerances import RELATIVE_ROUNDING, SUSPICIOUSLY_SMALL


class _Progress:
    """Tiles done and time left, on one line of the terminal."""

    def __init__(self) -> None:
        self.started = time.monotonic()

    def __call__(self, done: int, tiles: int) -> None:
        left = (time.monotonic() - self.started) * (tiles - done) / max(done, 1)
        end = "\n" if done == tiles else ""
        print(f"\r{done} of {tiles} tiles, about {left:z.0f} s left   ", end=end, file=sys.stderr, flush=True)


def end_with_parent() -> None:
    """End this process when the one that began it is no more, however it ended: killed, it can tell nobody."""
    # forked, it would catch what ends it, and wait for a main thread that waits for work
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    threading.Thread(target=_watch_parent, daemon=True).start()


def _watch_parent() -> None:
    parent = parent_process()
    if parent is None:
        return
    # workers that were forked hold each other's ends of the pipe that shows it: whose child this is shows it as well
    while parent.is_alive() and os.getppid() == parent.pid:
        parent.join(1.0)
    os.kill(os.getpid(), signal.SIGTERM)


def _widened(shape: tuple[int, ...], step: float, sides: list[tuple[float, float]], units: Units) -> list[str]:
    """Return a line about sides of a box that whole voxels, so many and of such a step (m), made longer."""
    longer = [
        f"{axis} to {short((low + count * step) / units.metres)}"
        for axis, count, (low, high) in zip("xyz", shape, sides, strict=True)
        if low + count * step - high > 2 * RELATIVE_ROUNDING * max(step, abs(high))
    ]
    if not longer:
        return []
    voxels = f"whole voxels of {short(step / units.metres)} {units.length}"
    return [f"the box has {voxels}: it reaches {', '.join(longer)} {units.length}."]


@click.command("map", cls=TakesNumbers, short_help="Fill a box with answers: what the arm reaches.")
@takes_arm
@click.option("--box", required=True, metavar="NUMBERS", help="x0 x1 y0 y1 z0 z1, quoted, in --length.")
@click.option("--step", required=True, type=float, help="Side of a voxel, in --length.")
@click.option("--orientations", default="128 16", show_default=True, help="Directions of the tool's z axis, and rolls.")
@click.option(
    "--out", "-o", default="", metavar="DIR", help="Keep finished tiles here; the same command goes on there."
)
@click.option(
    "--symmetry", default="auto", show_default=True, type=click.Choice(["auto", "none"]), help="See docs/maps.md."
)
@click.option("--workers", default=0, help="Processes; without it one process uses all cores.")
@click.option("--scheduler", default=None, metavar="ADDRESS", help="A dask scheduler, such as tcp://host:8786.")
@click.option("--scene", default="", metavar="FILE", help="Count only what touches neither this nor the arm itself.")
@click.option(
    "--task", default=None, type=click.Choice(["pose", "position", "position+axis"]), help="What a voxel is asked."
)
@click.option("--measure", is_flag=True, help="Keep the best manipulability and distance to limits as well.")
@click.option("--save", default="", metavar="FILE", help="Write the map as .npz, .parquet or .vtk.")
@click.option("--picture", default="", metavar="FILE", help="Draw three sections as .png, .svg or .pdf.")
@click.option("--report", default="", metavar="FILE", help="Write the arm's report with this map in it (.html).")
@as_json
@takes_units
def command(
    arm: pieper.Arm,
    box: str,
    step: float,
    orientations: str,
    out: str,
    symmetry: str,
    workers: int,
    scheduler: str | None,
    scene: str,
    task: str | None,
    measure: bool,
    save: str,
    picture: str,
    report: str,
    json: bool,
    units: Units,
) -> int:
    """Map what an arm reaches inside its limits: voxels of a box, orientations of the tool at each.

    Example: pieper map denso-vp6242 --box "-600 600 -600 600 -200 800" --step 50 --out denso-map
    """
    corners = [value * units.metres for value in numbers([box], "--box", pairs=True)]
    counts = [int(word) for word in orientations.replace("x", " ").split() if word.isdigit()]
    if len(corners) != 6:
        raise InputError(f"--box takes six numbers (x0 x1 y0 y1 z0 z1), got {len(corners)}.", given=box)
    if len(counts) != 2:
        raise InputError(f"--orientations takes two whole numbers, got {orientations!r}.", given=orientations)
    if workers < 0:
        raise InputError(f"--workers takes none (0) or more, got {workers}.", given=workers)
    widths = [high - low for low, high in zip(corners[::2], corners[1::2], strict=True)]
    if min(widths) <= 0:
        said = "xyz"[widths.index(min(widths))]
        raise InputError(f"--box: {said}0 must be less than {said}1 on every axis, got {box!r}.", given=box)
    if not 0 < step * units.metres <= min(widths) * (1 + RELATIVE_ROUNDING):
        raise InputError(
            f"--step must be positive and at most the box's smallest side, {short(min(widths) / units.metres)} "
            f"{units.length}; got {short(step)} {units.length}.",
            given=step,
        )
    if units.length == "mm" and 0 < max(widths) < 2 * SUSPICIOUSLY_SMALL:
        warnings.warn(
            f"--box is {short(max(widths) / units.metres)} mm wide; were metres meant? Then say --length m.",
            pieper.PieperWarning,
            stacklevel=2,
        )
    sides = [(corners[0], corners[1]), (corners[2], corners[3]), (corners[4], corners[5])]
    asked = {
        "orientations": (counts[0], counts[1]),
        "symmetry": symmetry,
        "store": out or None,
        "measure": measure,
        "task": task,
    }
    around = pieper.Scene.load(scene) if scene else None
    with ExitStack() as stack:
        executor: Executor | None = None
        if scheduler is not None:
            executor = stack.enter_context(_cluster(stack, scheduler).get_executor())
        elif workers:
            count = min(workers, os.cpu_count() or 1)
            executor = stack.enter_context(ProcessPoolExecutor(count, initializer=end_with_parent))
        progress = _Progress() if sys.stderr.isatty() and not json else None
        try:
            found = arm.reach_map(
                sides, step * units.metres, executor=executor, progress=progress, scene=around, **asked
            )
        except KeyboardInterrupt as stop:
            raise told(stop, _what_is_kept(out)) from stop
    for line in _widened(found.grid.shape, found.grid.step, sides, units):
        note(line)
    if save:
        found.save(save)
    if picture:
        pieper.plot.save_figure(pieper.plot.map_figure(found), picture)
    if report:
        pieper.write_report(arm, Path(report), reach_map=found)
    if json:
        print_json({"arm": arm.name, "volume_m3": found.volume, "fraction": found.fraction, "count": found.count})
        return DONE
    say(found.explain())
    return DONE


def _cluster(stack: ExitStack, address: str) -> Any:
    """Return a client of a dask scheduler; where no worker is there yet, that is said."""
    if not re.fullmatch(r"([a-z]+://)?.+:\d+", address):
        raise InputError(
            f"--scheduler: {address!r} is no address: give host and port, such as tcp://host:8786.", given=address
        )
    try:
        client = stack.enter_context(import_module("distributed").Client(address, timeout="10s"))
    except (OSError, ValueError) as error:
        raise InputError(f"--scheduler: nothing answers at {address}: {error}.", given=address) from None
    if not client.scheduler_info()["workers"]:
        note(f"{address} has no worker yet; the map waits for one (dask worker {address}). Ctrl-C ends it.")
    return client


def _what_is_kept(out: str) -> str:
    """Return what an interrupted map leaves behind."""
    if not out:
        return "interrupted; nothing of the map is kept. With --out DIR the same command goes on where it was."
    # a tile is finished once its checksum stands beside it
    tiles = plural(len(list(Path(out).glob("tile_*.sha256"))), "finished tile")
    return f"interrupted; {tiles} in {out}: the same command goes on there."
