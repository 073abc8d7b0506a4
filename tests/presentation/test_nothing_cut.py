"""Figures of a page show their labels whole: none hangs over the edge, none is printed over another."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from pieper import DH
from pieper.presentation.plot_arm import arm_figure, postures_figure, solutions_figure
from pieper.presentation.plot_reach import reach_figure

PLANAR = pieper.Arm.from_dh([DH(0.4), DH(0.3), DH(0.2)], convention="standard", name="planar 3R")
LIFT = pieper.Arm.from_dh([DH()], convention="standard", joint_types="P", name="lift")
MISS = 0.5  # pixels


def hangs_over(figure) -> float:
    """How far the label of an axis goes over the edge of its figure at most, pixels."""
    figure.canvas.draw()
    renderer, edge, worst = figure.canvas.get_renderer(), figure.bbox, 0.0
    for axes in figure.axes:
        for axis in (axes.xaxis, axes.yaxis, axes.zaxis):
            if axis.get_visible() and axis.label.get_text():
                box = axis.label.get_window_extent(renderer)
                worst = max(worst, edge.x0 - box.x0, edge.y0 - box.y0, box.x1 - edge.x1, box.y1 - edge.y1)
        if axes.title.get_text():
            box = axes.title.get_window_extent(renderer)
            worst = max(worst, edge.x0 - box.x0, box.x1 - edge.x1, box.y1 - edge.y1)
    return worst


@pytest.mark.parametrize("name", ["adept-cobra-600", "so-101", "fanuc-crx-10ia-controller", "stanford-arm"])
def test_no_label_of_an_axis_is_cut_at_the_edge(name):
    arm = pieper.load(name)
    low, high = np.nan_to_num(arm.limits.T, posinf=2, neginf=-2)
    q = np.random.default_rng(1).uniform(low, high, (4, arm.n))
    figures = [arm_figure(arm, q[0]), *(postures_figure(arm, q[:k], ["elbow"] * k) for k in (1, 2, 3))]
    figures += [solutions_figure(arm, q[:k]) for k in (1, 4)]
    assert [hangs_over(figure) <= MISS for figure in figures] == [True] * len(figures)


@pytest.mark.parametrize("arm", [PLANAR, LIFT], ids=lambda arm: arm.name)
def test_the_marks_of_a_flat_reach_stand_apart(arm):
    figure = reach_figure(arm, points=arm.fk(np.random.default_rng(2).uniform(-1, 1, (4000, arm.n)))[:, :3, 3])
    figure.canvas.draw()
    renderer = figure.canvas.get_renderer()
    for axes in figure.axes:
        for axis, side in ((axes.xaxis, "x"), (axes.yaxis, "y")):
            low, high = sorted(axis.get_view_interval())
            shown = [t for t in axis.get_major_ticks() if low <= t.get_loc() <= high]
            boxes = [t.label1.get_window_extent(renderer) for t in shown]
            ends = sorted((getattr(b, f"{side}0"), getattr(b, f"{side}1")) for b in boxes)
            assert len(ends) > 0
            assert all(first[1] <= second[0] for first, second in zip(ends, ends[1:], strict=False)), (side, ends)
