"""From a motion to a file: which format, how many pictures, and what is refused before the first is drawn."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np

from pieper import arguments
from pieper.description.dh import Description
from pieper.document.writing import whole_file, write_whole
from pieper.drawing.animation import encoders
from pieper.drawing.animation.encoders import Picture
from pieper.drawing.animation.moving import Moving
from pieper.drawing.animation.page import page
from pieper.drawing.animation.painter import Painter
from pieper.errors import InputError

#: More pictures than this are asked for by mistake.
MAX_PICTURES = 100_000
#: Largest side of a picture, pixels.
LARGEST_SIDE = 4096
SUFFIXES = (".gif", ".webp", ".mp4", ".html")


def animate(
    motion: Moving,
    description: Description,
    path: str | os.PathLike[str],
    *,
    rate: float,
    speed: float,
    size: tuple[int, int],
    view: tuple[float, float],
    progress: Callable[[int, int], None] | None = None,
) -> Path:
    """Write a motion of an arm; see `Motion.animate`."""
    file = arguments.file(path)
    suffix = file.suffix.lower()
    if suffix not in SUFFIXES:
        raise InputError(
            f"a motion is written as {', '.join(SUFFIXES)}; {file.name!r} ends in {suffix or 'nothing'}.", given=suffix
        )
    for value, name in ((rate, "rate"), (speed, "speed")):
        arguments.number(value, name, above=0.0)
    if arguments.numbers(view, "view", "elevation and azimuth, deg").shape != (2,):
        raise InputError(f"view must be elevation and azimuth, deg, got {view!r}.", given=view)
    width, height = checked_size(size)
    count = int(np.ceil(motion.duration / speed * rate)) + 1
    if count > MAX_PICTURES:
        raise InputError(
            f"{motion.duration:g} s at {rate:g} pictures a second and speed {speed:g} are {count:,} pictures; at most "
            f"{MAX_PICTURES:,} are drawn. Choose a lower rate.",
            pictures=count,
        )
    times = np.minimum(np.arange(count) * speed / rate, motion.duration)
    if suffix == ".html":
        return write_whole(file, page(motion, description, times, speed=speed, view=view))
    write = encoders.BY_SUFFIX[suffix]
    painter = Painter(motion, description, (width, height), view)

    def drawn() -> Iterator[Picture]:
        for k, time in enumerate(times):
            picture = painter.picture(float(time))
            if progress is not None:
                progress(k + 1, count)
            yield picture

    with whole_file(file) as out:
        write(drawn(), out, rate, (width, height))
    return file


def checked_size(size: tuple[int, int]) -> tuple[int, int]:
    """Return width and height of a picture.

    Raises:
        InputError: Not two even whole numbers from 64 to `LARGEST_SIDE`; encoders of moving pictures take no others.
    """
    try:
        width, height = (int(v) for v in size)
    except (TypeError, ValueError):
        raise InputError(f"size must be a width and a height, pixels, got {size!r}.", given=size) from None
    if not all(64 <= v <= LARGEST_SIDE and v % 2 == 0 for v in (width, height)):
        raise InputError(
            f"size must be two even numbers of pixels from 64 to {LARGEST_SIDE}, got {width} and {height}.", given=size
        )
    return width, height
