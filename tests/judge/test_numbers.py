"""Slips in printed solutions and tables: half turns, signs, radians, exchanged joints, units, mirrored axes."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from tests.judge.planted.arms import ARMS

ARM = next(arm for arm in ARMS if arm.name == "elbow")
HEAD = "\n".join(ARM.toml())
Q = np.array([33.5, -41.25, 71.75])
ROWS = [(33.5, -41.25, 71.75), (-12.0, 25.5, 61.0), (100.0, 60.0, -35.0)]


def verdict(claim: str):
    return pieper.check(f"{HEAD}\n[[claim]]\nid = 'x'\n{claim}\n").verdicts[0]


def solution(given) -> str:
    shown = ", ".join(f'"{v:.6f}"' for v in given)
    return f'kind = "solutions"\nq_deg = {Q.tolist()}\ntask = "position"\nsolutions_deg = [[{shown}]]'


@pytest.mark.parametrize(
    ("given", "slip"),
    [
        (Q, None),
        (Q + [0, 180, 0], "zero"),
        (Q * [1, 1, -1], "sense"),
        (Q[[0, 2, 1]], "exchanged joints"),
        (np.radians(Q), "degrees"),
    ],
)
def test_a_wrong_solution_names_its_slip(given, slip):
    found = verdict(solution(given))
    assert found.holds if slip is None else (found.wrong and found.slip == slip)


@pytest.mark.parametrize(
    ("change", "slip"),
    [
        (np.array([1.0, 1, 1]), None),
        (np.array([1000.0, 1000, 1000]), "millimetres"),
        (np.array([1.0, -1, 1]), "mirrored"),
        (np.array([1.0, 1, -1]), "mirrored"),
    ],
)
def test_a_wrong_table_names_its_slip(change, slip):
    rows = []
    for q in ROWS:
        at = ", ".join(f'"{v:.5f}"' for v in ARM.pose(np.radians(q))[:3, 3] * change)
        rows.append(f"{{ q_deg = {list(q)}, position = [{at}] }}")
    found = verdict('kind = "table"\nrows = [' + ", ".join(rows) + "]")
    assert found.holds if slip is None else (found.wrong and found.slip == slip)
