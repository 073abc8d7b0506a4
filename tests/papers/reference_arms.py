"""The arms of the five source papers, made of the tables that stand beside their reference numbers."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np

from oracle.joints import around
from pieper import DH, Arm

TO_METRES = {"m": 1.0, "mm": 1e-3}


def read(name: str) -> dict:
    """Return a file of tests/papers/data."""
    return json.loads((Path(__file__).parent / "data" / name).read_text())


def arm_of(entry: dict, name: str = "reference") -> Arm:
    """Return the arm of rows (type, a, alpha in deg, d, theta in deg)."""
    unit = TO_METRES[entry["unit"]]
    rows = [DH(a * unit, np.radians(alpha), d * unit, np.radians(theta)) for _, a, alpha, d, theta in entry["rows"]]
    types = "".join(row[0] for row in entry["rows"])
    return Arm.from_dh(rows, convention=entry["convention"], joint_types=types, name=name)


def pose_of(entry: dict, rows) -> np.ndarray:
    """Return a pose (4, 4) in metres from its upper rows in the entry's unit."""
    T = np.eye(4)
    T[:3] = np.reshape(rows, (3, 4))
    T[:3, 3] *= TO_METRES[entry["unit"]]
    return T


def same(a: np.ndarray, b: np.ndarray, slides: np.ndarray) -> np.ndarray:
    """Return the largest joint differences (k, m) between joint vectors a (k, n) and b (m, n), around the circle."""
    gap = a[:, None] - b[None]
    return np.abs(np.where(slides, gap, around(gap))).max(-1)
