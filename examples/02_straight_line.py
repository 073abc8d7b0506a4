"""A straight line followed by one branch: the study of the Denso VP-6242 in a few lines, with its figures."""

from pathlib import Path

import numpy as np

import pieper
from pieper.presentation import plot

arm = pieper.load("denso-vp6242")
T0, T1 = np.eye(4), np.eye(4)
T0[:3, 3], T1[:3, 3] = (0.35, 0.0, 0.4), (0.2, 0.1, 0.5)

path = pieper.line(T0, T1, n=50)
track = arm.follow(path, start=arm.description.postures["line-start"])
print(track.explain())
for branch in track.branches:
    print(branch.index + 1, branch.label, branch.points, "points,", "complete" if branch.complete else branch.stop)

folder = Path("line-figures")
folder.mkdir(exist_ok=True)
plot.save_figure(plot.path_figure(track, arm=arm), folder / "path.svg")
plot.save_figure(plot.coordinates_figure(track), folder / "coordinates.svg")
plot.save_figure(plot.joints_figure(track), folder / "joints.svg")
plot.save_figure(plot.configuration_figure(arm, track), folder / "configurations.svg")
print("figures in", folder.resolve())
