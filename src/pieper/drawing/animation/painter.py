"""One picture of a motion: the arm, the way of its tool, the time, and what happens."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from pieper.description.dh import Description
from pieper.drawing.animation.moving import Moving
from pieper.drawing.animation.telling import happenings
from pieper.drawing.draw3d import draw_arm, draw_frame, draw_shadow, space_axes
from pieper.drawing.skeleton import Skeleton, extent, skeletons
from pieper.drawing.style import COLOURS, FAINT, INK, MM, new_figure
from pieper.tolerances import NO_LENGTH

#: Dots an inch of the pictures.
DPI = 100
#: Postures that decide how much room the picture needs, and points of the drawn way, at most.
LOOKED_AT, WAY = 60, 400


class Painter:
    """Draws the pictures of one motion.

    Args:
        motion: The joint curves.
        description: Whose.
        size: Width and height, pixels.
        view: Elevation and azimuth, deg.
    """

    def __init__(
        self, motion: Moving, description: Description, size: tuple[int, int], view: tuple[float, float]
    ) -> None:
        self.motion, self.description = motion, description
        looked = skeletons(description, motion.between(np.linspace(0, motion.duration, LOOKED_AT)))
        self.way = way_of_the_tool(motion, description)
        centre, half = extent(self.way, *(s.polyline for s in looked))
        self.size = 2 * half
        self.figure = new_figure(size[0] / DPI, size[1] / DPI)
        self.figure.set_layout_engine("none")
        self.axes = space_axes(self.figure, (1, 1, 1), centre, half, view=view)
        self.axes.set_position((-0.07, -0.05, 1.14, 1.05))
        self.axes.plot(*(self.way * MM).T, color=FAINT, linewidth=1.2, linestyle=(0, (2, 2)), zorder=2)
        self.clock = self.figure.text(0.03, 0.955, "", color=INK, fontsize=11, va="center", family="monospace")
        self.figure.text(0.97, 0.955, description.name, color=INK, fontsize=10, va="center", ha="right")
        self.told = self.figure.text(0.97, 0.915, "", color=COLOURS[1], fontsize=10, va="center", ha="right")
        # what stays is drawn once and copied under every picture
        self._still = [*self.axes.get_children()]
        self._words = [self.clock, self.told]
        for words in self._words:
            words.set_visible(False)
        self._canvas: Any = self.figure.canvas
        self._canvas.draw()
        self._paper = self._canvas.copy_from_bbox(self.figure.bbox)
        for words in self._words:
            words.set_visible(True)

    def picture(self, time: float) -> npt.NDArray[np.uint8]:
        """Return the picture (height, width, 3) at a time, s."""
        from mpl_toolkits.mplot3d.art3d import Poly3DCollection

        still = set(self._still)
        self._draw(skeletons(self.description, self.motion.between([time]))[0], time)
        moving = [a for a in self.axes.get_children() if a not in still]
        self._canvas.restore_region(self._paper)
        renderer = self._canvas.get_renderer()
        for artist in sorted(moving, key=lambda a: a.get_zorder()) + self._words:
            if isinstance(artist, Poly3DCollection):
                artist.do_3d_projection()
            artist.draw(renderer)
        for artist in moving:
            artist.remove()
        return np.array(self._canvas.buffer_rgba())[..., :3]

    def _draw(self, parts: Skeleton, time: float) -> None:
        done = max(2, round(len(self.way) * time / max(self.motion.duration, NO_LENGTH)))
        self.axes.plot(*(self.way[:done] * MM).T, color=COLOURS[0], linewidth=1.8, zorder=4)
        draw_shadow(self.axes, parts)
        draw_arm(self.axes, parts, self.size)
        draw_frame(self.axes, parts.frames[-1], 0.09 * self.size)
        self.clock.set_text(f"{time:z7.2f} s")
        self.told.set_text(happenings(self.motion, time))


def way_of_the_tool(motion: Moving, description: Description) -> npt.NDArray[np.float64]:
    """Return points (k, 3) of the tool's way, evenly spaced in time, m."""
    q = motion.between(np.linspace(0, motion.duration, WAY))
    return np.array([s.frames[-1][:3, 3] for s in skeletons(description, q)])
