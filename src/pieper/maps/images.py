"""Voxels that equal parts of a turn of the first joint take to each other: one is solved and answers for its images."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper.kinematics.arrays import Array, Indices
from pieper.kinematics.chain import Chain
from pieper.maps.grid import Grid
from pieper.tolerances import GEOMETRY_EXACT


@dataclass(frozen=True, eq=False)
class Images:
    """Which voxels answer for which.

    Args:
        fold: Into how many equal parts the turn is cut; 1 where each voxel answers for itself.
        sense: Which way the first joint turns about the base's z axis, 1 or -1.
        plane: (m, fold) numbers of columns of voxels along z, the solved one first; -1 where an image is not in the
            box, or the same column again.
        layers: Voxels of a column.
    """

    fold: int
    sense: float
    plane: Indices
    layers: int

    @property
    def count(self) -> int:
        """How many voxels are solved."""
        return len(self.plane) * self.layers

    def of(self, first: int, last: int) -> Indices:
        """Return the voxels' numbers (k, fold) of solved ones from one number up to another, -1 where there is none."""
        column, layer = np.divmod(np.arange(first, min(last, self.count)), self.layers)
        columns = self.plane[column]
        return np.asarray(np.where(columns < 0, -1, columns * self.layers + layer[:, None]), np.int64)


def images_of(grid: Grid, chain: Chain) -> Images:
    """Return how voxels of a grid answer for each other, if its first joint turns about a line along z at all."""
    nx, ny, nz = grid.shape
    for fold in (4, 2):
        sense = first_joint_turns(chain)
        plane = _plane(grid, chain.links[0][:2, 3], fold) if sense != 0.0 and grid.fold % fold == 0 else None
        if plane is not None and (plane[:, 1:] >= 0).any():
            return Images(fold, sense, plane, nz)
    return Images(1, 1.0, np.arange(nx * ny)[:, None], nz)


def first_joint_turns(chain: Chain) -> float:
    """Return 1 or -1 where the first joint turns all that follows about a line along z, by its sense; 0 where not."""
    if chain.prismatic[0] or chain.coupling is not None:
        return 0.0
    axis = chain.links[0][:3, 2]
    return float(np.sign(axis[2])) if np.hypot(axis[0], axis[1]) <= GEOMETRY_EXACT else 0.0


def _plane(grid: Grid, axis: Array, fold: int) -> Indices | None:
    """Return columns (m, fold) and their images; None where turned centres are no centres."""
    twice = 2 * ((grid.low[:2] - axis) / grid.step) + 1
    a0, b0 = np.round(twice).astype(np.int64)
    nx, ny, _ = grid.shape
    off = np.abs(twice - np.round(twice)).max()
    if off > GEOMETRY_EXACT * (1 + np.abs(twice).max()) or (fold == 4 and (a0 - b0) % 2):
        return None
    # centres in half steps from the axis
    a, b = (v.ravel() for v in np.meshgrid(a0 + 2 * np.arange(nx), b0 + 2 * np.arange(ny), indexing="ij"))
    found = []
    for image in range(fold):
        quarter = image * 4 // fold
        x, y = ((a, b), (-b, a), (-a, -b), (b, -a))[quarter]
        i, j = (x - a0) // 2, (y - b0) // 2
        inside = (0 <= i) & (i < nx) & (0 <= j) & (j < ny)
        found.append(np.where(inside, i * ny + j, -1))
    columns = np.stack(found, 1)
    columns[(a == 0) & (b == 0), 1:] = -1
    own = columns[:, 0]
    return columns[own == np.where(columns < 0, nx * ny, columns).min(1)]
