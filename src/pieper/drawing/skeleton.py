"""Where the parts of an arm are in space for a posture: link polylines, joint axes, frames. Drawing comes elsewhere."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper.description.dh import Description, Slid
from pieper.description.fold import chain_of
from pieper.description.slid import with_short_rows
from pieper.kinematics.forward import frames
from pieper.tolerances import DRAWN_LEAST


@dataclass(frozen=True, eq=False)
class Skeleton:
    """An arm in one posture, ready to be drawn.

    Attributes:
        links: One polyline (k, 3) a joint: along its axis, then along the common normal; m.
        centres: (n, 3) where the joint axes are drawn, m.
        directions: (n, 3) unit joint axes.
        frames: (n + 2, 4, 4) base, after each joint, tool.
    """

    links: tuple[np.ndarray, ...]
    centres: np.ndarray
    directions: np.ndarray
    frames: np.ndarray

    @property
    def polyline(self) -> np.ndarray:
        """All links as one polyline (k, 3), m."""
        return np.concatenate(self.links)


def skeleton(description: Description, q: np.ndarray) -> Skeleton:
    """Return an arm's skeleton in posture q (n,), rad or m."""
    return skeletons(description, np.asarray(q, float)[None])[0]


def skeletons(description: Description, q: np.ndarray) -> list[Skeleton]:
    """Return an arm's skeletons in postures q (k, n), rad or m."""
    # links are drawn along common normals: of nearly parallel axes those lie far away
    short = with_short_rows(description)
    return [_skeleton(short, each) for each in frames(chain_of(short), q, short.base)]


def _skeleton(description: Description, frames: np.ndarray) -> Skeleton:
    origins, n = frames[:, :3, 3], len(description.rows)
    links, centres, directions = [], np.empty((n, 3)), np.empty((n, 3))
    for i, row in enumerate(description.rows):
        if description.convention == "standard":
            corner = origins[i + 1] - row.a * frames[i + 1, :3, 0]
            if isinstance(row, Slid):
                corner = corner - row.f * np.cross(frames[i, :3, 2], frames[i + 1, :3, 0])
            links.append(np.array([origins[i], corner, origins[i + 1]]))
            centres[i], directions[i] = origins[i], frames[i, :3, 2]
        else:
            # x of frame i - 1 carries the common normal of the proximal convention
            corner = origins[i] + row.a * frames[i, :3, 0]
            links.append(np.array([origins[i], corner, origins[i + 1]]))
            centres[i], directions[i] = origins[i + 1], frames[i + 1, :3, 2]
        if description.axis_types[i] == "P":
            centres[i] = (links[i][0] + corner) / 2
    links.append(np.array([origins[n], origins[n + 1]]))
    return Skeleton(tuple(links), centres, directions, frames)


def extent(*clouds: np.ndarray) -> tuple[np.ndarray, float]:
    """Return the centre (3,) and half the side of the cube that holds all points, a little larger, m."""
    points = np.concatenate([np.reshape(c, (-1, 3)) for c in clouds])
    low, high = points.min(0), points.max(0)
    half = max(float((high - low).max()) / 2, DRAWN_LEAST)
    return (low + high) / 2, 1.08 * half
