"""Sections about what goes beyond one pose: a reach map in slices and sections, a calibration with what it moved."""

from __future__ import annotations

import numpy as np

from pieper.calibration.fit import Fit
from pieper.document.blocks import Document
from pieper.drawing.style import MM, picture
from pieper.maps.reach_map import ReachMap
from pieper.presentation.plot_calibration import calibration_figure, deviations_figure
from pieper.presentation.plot_map import layers_figure, map_figure


def add_map(page: Document, m: ReachMap) -> None:
    """Add a map: what was asked, its layers from below upwards, three sections, and sections of what was measured."""
    page.section("Where the tool gets", m.explain())
    per_layer = (m.fraction > 0).sum((0, 1))
    rows = [
        [f"{z * MM:z.0f}", f"{n * m.grid.step**2:z.3f}", f"{share.mean():.1%}", f"{share.max():.1%}", f"{count:,}"]
        for z, n, share, count in zip(
            m.axes[2], per_layer, np.moveaxis(m.fraction, 2, 0), m.count.sum((0, 1)), strict=True
        )
    ]
    page.table(
        ["z, mm", "reached, m²", "mean share", "best share", "solutions"],
        rows,
        "Layer by layer: the area that is reached in some orientation, the share of orientations that is reached on "
        "the mean and in the best voxel, and the solutions inside the limits.",
    )
    page.add(
        picture(layers_figure(m), "Slices through the box: the share of orientations reached.", "map-slices"),
        picture(map_figure(m), "Sections through the voxel that is served best.", "map-sections"),
    )
    if not m.measures.shape[1]:
        return
    negative, positive = m.aspects.reshape(-1, 2).sum(0)
    page.add(
        f"Of the solutions {negative:,} have a negative and {positive:,} a positive determinant of the Jacobian: no "
        "way from one of them to one of the others avoids a singular posture.",
        picture(map_figure(m, what="margin"), "The best distance to limits.", "map-margin"),
        picture(
            map_figure(m, what="least_singular"),
            "The smallest singular value of the solution nearest to singular: light along the singular surfaces.",
            "map-singular",
        ),
    )


def add_fit(page: Document, fit: Fit) -> None:
    """Add a calibration: its headline, what was gained, how far each axis moved, and how sure each number is."""
    page.section("The arm as it was measured", *fit.explain().splitlines())
    page.add(
        picture(
            calibration_figure(fit),
            "The error before and after on poses the fit has not seen, and how far each axis was moved.",
            "calibration",
        ),
        picture(
            deviations_figure(fit),
            "One standard deviation of every fitted number, as a part of by how much it may plausibly depart.",
            "calibration-deviations",
        ),
    )
    deviation = np.sqrt(np.maximum(np.diag(fit.covariance), 0.0))
    rows = [
        [name, f"{size * scale:.3g}", unit]
        for name, own, size in zip(fit.parameters.names, fit.parameters.units, deviation, strict=True)
        for scale, unit in [{"m": (MM, "mm"), "rad": (1e3, "mrad")}.get(own, (1.0, own))]
        if size > 0
    ]
    page.table(["number", "± one deviation", ""], rows, "How sure each fitted number is.", left=(0, 2))
