"""The report says what a map and a calibration found, with their pictures."""

from __future__ import annotations

import csv

import numpy as np
import pytest

import pieper
from pieper.document.blocks import Document
from pieper.document.html import page as html_page
from pieper.document.text import fragment
from pieper.presentation.sections_scale import add_fit, add_map
from tests.calibration.command import main
from tests.calibration.planted import NOISE, noisy, planted, postures

BOX = ((-0.6, 0.6), (-0.6, 0.6), (-0.2, 0.8))


def pictures(page):
    return {block.name for block in page.blocks if hasattr(block, "drawing")}


@pytest.mark.parametrize("measure", [False, True])
def test_a_map_is_told_layer_by_layer_with_slices_and_sections(measure):
    m = pieper.load("denso-vp6242").reach_map(BOX, 0.2, (8, 4), measure=measure)
    page = Document("")
    add_map(page, m)
    said = fragment(page)
    assert m.explain().split(". ")[0] in said.replace("\n", " ")
    assert f"{m.count[:, :, 2].sum():,}" in said
    assert pictures(page) == {"map-slices", "map-sections"} | ({"map-margin", "map-singular"} if measure else set())
    if measure:
        negative, positive = m.aspects.reshape(-1, 2).sum(0)
        assert (
            f"{negative:,} have a negative and {positive:,} a positive" in said and negative + positive == m.count.sum()
        )
    assert html_page(page).count("<svg") + html_page(page).count("data:image") >= 2


def test_a_calibration_is_told_with_how_sure_each_number_is():
    arm, rng = pieper.load("universal-robots-ur5e"), np.random.default_rng(3)
    true, q = planted(arm, rng), postures(arm, rng, 60)
    fit = arm.calibrate(q, noisy(true.fk(q), rng), sigma=NOISE)
    page = Document("")
    add_fit(page, fit)
    said = fragment(page)
    assert "held-out poses the error is" in said and pictures(page) == {"calibration", "calibration-deviations"}
    for name in fit.parameters.names:
        assert name in said
    deviation = np.sqrt(np.diag(fit.covariance))
    k = fit.parameters.names.index("joint_2 tilt a") if "joint_2 tilt a" in fit.parameters.names else 0
    assert f"{deviation[k] * 1e3:.3g}" in said


def test_the_commands_write_reports(tmp_path, capsys):
    said = ["map", "denso-vp6242", "--box", "-600 600 -600 600 -200 800", "--step", "200", "--orientations", "4 2"]
    assert main([*said, "--report", str(tmp_path / "map.html")]) == 0
    assert "Where the tool gets" in (tmp_path / "map.html").read_text()
    arm, rng = pieper.load("denso-vp6242"), np.random.default_rng(4)
    q = postures(arm, rng, 40)
    p = planted(arm, rng).fk(q)[:, :3, 3] * 1e3
    with (tmp_path / "d.csv").open("w", newline="") as file:
        out = csv.writer(file)
        out.writerow([*(f"q{j + 1}_deg" for j in range(6)), "x_mm", "y_mm", "z_mm"])
        out.writerows(np.concatenate([np.degrees(q), p], 1).tolist())
    asked = ["calibrate", "denso-vp6242", str(tmp_path / "d.csv"), "--kind", "position"]
    assert main([*asked, "--report", str(tmp_path / "fit.html")]) == 0
    assert "The arm as it was measured" in (tmp_path / "fit.html").read_text()
    capsys.readouterr()
