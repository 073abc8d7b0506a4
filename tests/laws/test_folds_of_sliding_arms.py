"""Near a fold both roots of a sliding arm are told as well as the pose tells them, never the fold between them."""

from __future__ import annotations

import numpy as np
import pytest

from benchmarks.measure.singular_strata import draw, smallest
from oracle.arms.strata import ARMS
from oracle.joints import around
from pieper import Arm, Status

H = np.pi / 2
#: Joint vectors of an RPR arm with a wrist of which the fold between them and their twins was given twice over.
LOST = [
    [
        0.8150983168922252,
        -0.19936545036364894,
        -2.049052242298101,
        -1.6387681236952707,
        -0.38130861258188053,
        2.2452786,
    ],
    [
        1.0963986203808491,
        -0.20974862008762152,
        -2.1733968247994495,
        2.0918376972406394,
        -0.0234569717569976,
        0.38058827,
    ],
]


def gaps(arm: Arm, q: np.ndarray) -> np.ndarray:
    """Return how far the nearest row of each pose is (rad; lengths), joint vectors (N, 6)."""
    many = arm.ik_many(arm.fk(q), threads=1)
    slide = arm.chain.prismatic
    apart = np.where(slide, (many.q - q[:, None]) / arm.chain.length, around(many.q - q[:, None]))
    return np.where(many.valid, np.abs(apart).max(-1), np.inf).min(1)


def test_a_root_beside_its_twin_is_given_and_not_the_fold_between_them():
    arm = ARMS["wrist at the end, RPR"]()
    assert gaps(arm, np.array(LOST)).max() < 1e-8
    for q in LOST:
        sols = arm.ik(arm.fk(q))
        assert sols.status == Status.SOLVED and (sols.multiplicity == 1).all() and len(sols.all_q) == 8


@pytest.mark.parametrize("name", [name for name in ARMS if name in ("wrist at the end, RPR", "stanford-arm")])
def test_what_is_told_near_a_fold_is_told_as_well_as_rounding_allows(name):
    arm = ARMS[name]()
    q, distance = draw(arm, np.random.default_rng(7), 600)
    q = q[distance > 1e-8]
    assert (gaps(arm, q) < 1e-9 + 1e-14 / smallest(arm, q)).all()
