"""Seed 003's Table 2: positions of the VS-6577 with the printed axes put right, and the errors between its columns."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from oracle.joints import turns_apart
from pieper import DH, Arm
from pieper.motion.sequence import compare
from tests.papers.reference_arms import read

TABLE = read("positions_of_the_vs6577.json")
AXES = [1, 2, 0]  # printed X, Y, Z are the base's y, z, x


def controller_arm(a1, a2, a3, d1, d4, d6) -> Arm:
    """Return the arm of equation (7), in mm, spoken to in the controller's angles."""
    rows = [(a1, -90, d1), (a2, 0, 0), (a3, 90, 0), (0, 90, d4), (0, -90, 0), (0, 0, d6)]
    return Arm.from_dh(
        [DH(a / 1000, np.radians(alpha), d / 1000, 0) for a, alpha, d in rows],
        convention="standard",
        offset=np.radians([0, -90, 180, 0, 0, 0]),
        sign=[1, 1, 1, 1, -1, 1],
        name="vs6577 in controller angles",
    )


def positions(arm) -> np.ndarray:
    """Return the tool positions (3, 3) of the table's postures in its own axes, mm."""
    q = np.radians([row["q"] for row in TABLE["rows"]])
    return 1000 * arm.fk(q)[:, :3, 3][:, AXES]


@pytest.mark.parametrize("fit", TABLE["fits"], ids=lambda f: "sign lost in " + f["lost_sign"])
def test_with_the_lengths_its_numbers_follow_the_table_is_one_arm_s(fit):
    expected = np.array([row["ref"] for row in TABLE["rows"]], float)
    expected[2, "XYZ".index(fit["lost_sign"])] *= -1
    # six lengths, each rounded to 0.01 mm, on top of the 0.003 mm the fit leaves
    np.testing.assert_allclose(positions(controller_arm(*fit["lengths_mm"])), expected, atol=0.03)


def test_the_catalogue_arm_gives_position_0_exactly_and_the_others_within_4_mm():
    got = positions(pieper.load("denso-vs6577-controller"))
    np.testing.assert_allclose(got[0], TABLE["rows"][0]["ref"], atol=1e-9)
    for row, place in zip(TABLE["rows"][1:], got[1:], strict=True):
        assert np.abs(np.abs(place) - row["ref"]).max() < 4.0


def test_the_printed_axes_are_not_the_base_s():
    arm = pieper.load("denso-vs6577-controller")
    raw = 1000 * arm.fk(np.zeros(6))[:3, 3]
    assert abs(raw[1] - TABLE["rows"][0]["ref"][1]) > 700  # printed Y is 790, the base's y is 0
    np.testing.assert_allclose(raw, [597, 0, 790], atol=1e-9)


def test_errors_between_the_columns_are_the_claimed_ones_where_they_are_defined():
    order = [0, 1, 0, 2]  # P0, P1, P2 = P0, P3
    reference = np.array([TABLE["rows"][i]["ref"] for i in order]) / 1000
    simulated = np.array([TABLE["rows"][i]["sim"] for i in order]) / 1000
    table = compare(reference, simulated)
    for j, axis in enumerate("XYZ"):
        for i, percent in enumerate(TABLE["percent"][axis]):
            assert table.defined[i, j] == (percent is not None)
            if percent is None:
                assert table.percent(i, j) == "undefined"
            else:
                assert table.relative[i, j] == pytest.approx(percent, abs=6e-5)
        assert table.largest_relative[j] == pytest.approx(TABLE["claimed_max_percent"][axis], abs=0.006)


def test_the_inverse_finds_the_postures_of_the_table_again():
    arm = pieper.load("denso-vs6577-controller")
    for row in TABLE["rows"][1:]:
        q = np.radians(row["q"])
        sols = arm.ik(arm.fk(q))
        gap = turns_apart(sols.all_q, q).max(1)
        assert gap.min() < 1e-9 or any(f.contains(q, 1e-6) for f in sols.self_motions)
