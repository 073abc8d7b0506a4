"""Figures: returned not shown, readable in grey, with units, written whole or not at all."""

import os
import sys
import xml.etree.ElementTree as ET

import numpy as np
import pytest

import pieper
from pieper.document.writing import write_whole
from pieper.drawing.skeleton import skeleton
from pieper.drawing.style import COLOURS, LINES, MARKERS
from pieper.errors import InputError
from pieper.motion.sequence import sequence
from pieper.presentation import plot
from pieper.presentation.plot_reach import joint_range, reach_samples

ARM = pieper.load("denso-vp6242")
HOME = ARM.description.postures["line-start"]


@pytest.fixture(scope="module")
def track():
    T0, T1 = np.eye(4), np.eye(4)
    T0[:3, 3], T1[:3, 3] = (0.35, 0, 0.4), (0.2, 0.1, 0.5)
    return ARM.follow(pieper.line(T0, T1, 12), start=HOME)


def labels(figure):
    """All axis labels of a figure."""
    out = []
    for axes in figure.axes:
        out += [axes.get_xlabel(), axes.get_ylabel()]
        if hasattr(axes, "get_zlabel"):
            out.append(axes.get_zlabel())
    return [text for text in out if text]


def drawings(track):
    motion = sequence([np.zeros(6), HOME], 2.0, 0.5, rate=40)
    return {
        "arm": plot.arm_figure(ARM, HOME),
        "path": plot.path_figure(track, arm=ARM),
        "coordinates": plot.coordinates_figure(track),
        "joints": plot.joints_figure(track),
        "configurations": plot.configuration_figure(ARM, track),
        "time": plot.time_figure(motion, arm=ARM),
        "reach": plot.reach_figure(ARM, points=reach_samples(ARM, samples=50_000)),
    }


def test_every_axis_has_its_unit_and_nothing_is_left_in_pyplot(track):
    for name, figure in drawings(track).items():
        for text in labels(figure):
            assert any(unit in text for unit in ("mm", "deg", "number", ", s")), (name, text)
    if "matplotlib.pyplot" in sys.modules:
        assert sys.modules["matplotlib.pyplot"].get_fignums() == []


def test_curves_differ_in_colour_line_and_marker(track):
    figure = plot.joints_figure(track)
    lines = [line for line in figure.axes[0].lines if len(line.get_xdata()) > 2]
    assert len(lines) == 6
    assert len({line.get_color() for line in lines}) == 6
    assert len({line.get_marker() for line in lines}) == 6
    assert len({str(line._dash_pattern) for line in lines}) == 6
    assert len(COLOURS) == len(LINES) == len(MARKERS)


def test_the_joint_curves_show_the_numbers_of_the_track(track):
    lines = plot.joints_figure(track).axes[0].lines[:6]
    for joint, line in enumerate(lines):
        assert np.allclose(line.get_ydata(), np.degrees(track.followed[:, joint]))


def test_a_stop_is_drawn_where_it_is(track):
    limits = ARM.limits.copy()
    limits[0] = [-0.1, 0.1]
    short = pieper.Arm.from_dh(ARM.description.rows, convention="standard", limits=limits).follow(
        track.path, start=HOME
    )
    assert not short.complete
    texts = [t.get_text() for t in plot.joints_figure(short).axes[0].texts]
    assert any("limit" in t for t in texts)


def test_all_solutions_get_a_picture_each():
    sols = ARM.ik(ARM.fk(HOME))
    figure = plot.solutions_figure(ARM, sols.all_q, labels=sols.all_labels)
    assert len(figure.axes) == len(sols.all_q) == 8


@pytest.mark.parametrize("name", ["denso-vp6242", "universal-robots-ur5e", "rrp-wrist", "dfrobot-rob0036", "three-r"])
def test_the_skeleton_begins_at_the_base_and_ends_at_the_tool(name):
    arm = pieper.load(name)
    rng = np.random.default_rng(3)
    low, high = joint_range(arm)
    q = low + (high - low) * rng.random(arm.n)
    parts = skeleton(arm.description, q)
    assert parts.polyline[-1] == pytest.approx(arm.fk(q)[:3, 3], abs=1e-12)
    assert parts.polyline[0] == pytest.approx(arm.base[:3, 3], abs=1e-12)
    for link, row in zip(parts.links, arm.description.rows, strict=False):
        shortest = sorted((np.linalg.norm(link[1] - link[0]), np.linalg.norm(link[2] - link[1])))
        assert any(length == pytest.approx(abs(row.a), abs=1e-9) for length in shortest)


def test_png_svg_and_pdf_are_what_they_say(tmp_path, track):
    figure = plot.coordinates_figure(track)
    assert plot.save_figure(figure, tmp_path / "a.png").read_bytes().startswith(b"\x89PNG")
    root = ET.fromstring(plot.save_figure(figure, tmp_path / "a.svg").read_text())
    assert root.tag.endswith("svg")
    assert plot.save_figure(figure, tmp_path / "a.pdf").read_bytes().startswith(b"%PDF")


def test_an_unknown_suffix_and_a_missing_folder_are_said(tmp_path, track):
    figure = plot.coordinates_figure(track)
    with pytest.raises(InputError, match=".png"):
        plot.save_figure(figure, tmp_path / "a.bmp")
    with pytest.raises(InputError, match="nowhere"):
        plot.save_figure(figure, tmp_path / "nowhere" / "a.png")
    assert list(tmp_path.iterdir()) == []


def test_an_interruption_leaves_the_old_file_and_no_rest(tmp_path, monkeypatch):
    target = tmp_path / "page.html"
    write_whole(target, "old")

    def interrupted(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr(os, "replace", interrupted)
    with pytest.raises(KeyboardInterrupt):
        write_whole(target, "new")
    assert target.read_text() == "old"
    assert [p.name for p in tmp_path.iterdir()] == ["page.html"]
