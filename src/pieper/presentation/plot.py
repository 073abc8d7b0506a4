"""The figures, by name: what one imports to draw something. Each returns a matplotlib figure and shows nothing."""

from __future__ import annotations

from pieper.drawing.style import png, save_figure, svg
from pieper.presentation.plot_arm import arm_figure, configuration_figure, solutions_figure
from pieper.presentation.plot_calibration import calibration_figure, deviations_figure
from pieper.presentation.plot_clearance import clearance_figure
from pieper.presentation.plot_curves import coordinates_figure, joints_figure, time_figure
from pieper.presentation.plot_limits import limits_figure
from pieper.presentation.plot_map import layers_figure, map_figure
from pieper.presentation.plot_path import path_figure
from pieper.presentation.plot_reach import reach_figure
from pieper.presentation.plot_route import route_figure

__all__ = [
    "arm_figure",
    "calibration_figure",
    "clearance_figure",
    "configuration_figure",
    "coordinates_figure",
    "deviations_figure",
    "joints_figure",
    "layers_figure",
    "limits_figure",
    "map_figure",
    "path_figure",
    "png",
    "reach_figure",
    "route_figure",
    "save_figure",
    "solutions_figure",
    "svg",
    "time_figure",
]
