"""Pictures into one file: GIF and WebP by Pillow, which matplotlib brings; MP4 by ffmpeg, where there is one."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Callable, Iterator
from importlib import import_module
from typing import TYPE_CHECKING, BinaryIO, Protocol

import numpy as np
import numpy.typing as npt

from pieper.drawing.style import AXES
from pieper.errors import InputError

if TYPE_CHECKING:
    from PIL import Image

Picture = npt.NDArray[np.uint8]
Encoder = Callable[[Iterator[Picture], BinaryIO, float, tuple[int, int]], None]

#: Colours of a GIF; the pictures have few, and fewer make smaller files.
GIF_COLOURS = 128
#: The colours of a frame's axes and what they fade to on paper.
_AXES_FADED = np.array(
    [
        [round(255 + part * (int(colour[k : k + 2], 16) - 255)) for k in (1, 3, 5)]
        for colour in AXES
        for part in (1.0, 0.8, 0.6, 0.4, 0.2)
    ]
)
#: Quality of a WebP, percent.
WEBP_QUALITY = 82


class _HasFfmpeg(Protocol):
    def get_ffmpeg_exe(self) -> str: ...


def gif(pictures: Iterator[Picture], out: BinaryIO, rate: float, size: tuple[int, int]) -> None:
    """Write a GIF that repeats for ever; its times are whole hundredths of a second, spread so that none is lost."""
    frames = [_in_few_colours(p) for p in pictures]
    first, *rest = frames
    first.save(out, format="GIF", save_all=True, append_images=rest, duration=_durations(len(frames), rate, 10), loop=0)


def _in_few_colours(picture: Picture) -> Image.Image:
    """Return a picture in the colours of a GIF.

    A frame's axes are a few pixels among the many of paper and links, and would be drawn in a neighbour's colour: their
    own colours, and what they fade to on paper, are in every palette.
    """
    from PIL import Image

    full = Image.fromarray(picture)
    own = full.quantize(GIF_COLOURS - len(_AXES_FADED), dither=Image.Dither.NONE).getpalette() or []
    palette = Image.new("P", (1, 1))
    palette.putpalette(own[: 3 * (GIF_COLOURS - len(_AXES_FADED))] + _AXES_FADED.ravel().tolist())
    return full.quantize(palette=palette, dither=Image.Dither.NONE)


def webp(pictures: Iterator[Picture], out: BinaryIO, rate: float, size: tuple[int, int]) -> None:
    """Write a WebP that repeats for ever."""
    from PIL import Image, features

    if not features.check("webp"):
        raise InputError("this Pillow writes no WebP; write a .gif or an .html, or install another Pillow.")
    first, *rest = [Image.fromarray(p) for p in pictures]
    first.save(
        out,
        format="WEBP",
        save_all=True,
        append_images=rest,
        duration=_durations(1 + len(rest), rate, 1),
        loop=0,
        quality=WEBP_QUALITY,
    )


def _durations(count: int, rate: float, unit: int) -> list[int]:
    """Return how long each picture stands, ms, in whole units of ms, their sum as near to the truth as can be."""
    ends = np.round(np.arange(1, count + 1) * 1000 / rate / unit).astype(int)
    return [max(int(d), 1) * unit for d in np.diff(ends, prepend=0)]


def mp4(pictures: Iterator[Picture], out: BinaryIO, rate: float, size: tuple[int, int]) -> None:
    """Write an MP4 (H.264)."""
    import tempfile
    from pathlib import Path

    program = ffmpeg()
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "motion.mp4"
        words = [program, "-loglevel", "error", "-y", "-f", "rawvideo", "-pix_fmt", "rgb24"]
        words += ["-s", f"{size[0]}x{size[1]}", "-r", f"{rate:g}", "-i", "-", "-an", "-c:v", "libx264"]
        words += ["-pix_fmt", "yuv420p", "-crf", "20", "-movflags", "+faststart", str(file)]
        with (Path(folder) / "said").open("wb") as said:
            running = subprocess.Popen(words, stdin=subprocess.PIPE, stderr=said)
            assert running.stdin is not None
            try:
                for picture in pictures:
                    running.stdin.write(picture.tobytes())
                running.stdin.close()
            except BrokenPipeError:
                pass
            finally:
                if not running.stdin.closed:
                    running.kill()
                code = running.wait()
        if code:
            why = (Path(folder) / "said").read_text(errors="replace").strip().splitlines()
            raise InputError(f"ffmpeg could not write the video: {why[-1] if why else f'it ended with {code}'}.")
        with file.open("rb") as made:
            shutil.copyfileobj(made, out)


def ffmpeg() -> str:
    """Return the ffmpeg to run: the one of imageio-ffmpeg, or the one on the path.

    Raises:
        InputError: There is none; the message says how to get one.
    """
    try:
        found: _HasFfmpeg = import_module("imageio_ffmpeg")  # type: ignore[assignment]
        return found.get_ffmpeg_exe()
    except (ImportError, RuntimeError):
        program = shutil.which("ffmpeg")
    if program is None:
        raise InputError("an .mp4 needs ffmpeg: pip install 'pieper[video]', or write .gif, .webp or .html.")
    return program


BY_SUFFIX: dict[str, Encoder] = {".gif": gif, ".webp": webp, ".mp4": mp4}
