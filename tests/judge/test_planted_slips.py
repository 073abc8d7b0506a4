"""Slips planted into right formulas of twenty arms by rules that know nothing of the judge; the rest is right."""

from __future__ import annotations

import numpy as np
import pytest

from oracle.joints import around
from tests.judge.planted.arms import ARMS
from tests.judge.planted.formula import evaluate, names_at, parse
from tests.judge.planted.generate import right_claims
from tests.judge.planted.measure import double, explained_by, judged, single, unusual

#: How many are judged here; `python -m tests.judge.planted.measure 1000` judges a thousand.
SLIPS, FORMS = 40, 60


@pytest.mark.parametrize("arm", ARMS, ids=lambda arm: arm.name)
def test_the_formulas_are_right_by_numpy_alone(arm):
    rng = np.random.default_rng(4)
    for _ in range(6):
        q = np.array([rng.uniform(-2.5, 2.5) for _ in range(arm.n)])
        values = names_at(arm, q)
        for entry, text in arm.entries.items():
            assert evaluate(parse(text), values) == pytest.approx(values[entry], abs=1e-12)
        for joint, text in arm.joints:
            gaps = np.array([evaluate(parse(text), values, branch) - q[joint - 1] for branch in (1, -1)])
            if arm.rows[joint - 1].kind == "R":
                gaps = around(gaps)
            assert np.nanmin(np.abs(gaps)) < 1e-6, text


def test_right_formulas_hold():
    assert all(verdict.holds for _, verdict in judged([c for arm in ARMS for c in right_claims(arm)]))


def test_right_formulas_in_unusual_forms_hold():
    wrong = [claim.text for claim, verdict in judged(unusual(FORMS, seed=8)) if not verdict.holds]
    assert not wrong


def test_no_planted_slip_is_called_right_and_the_planted_one_comes_first():
    verdicts = judged(single(SLIPS, seed=5))
    assert not [claim.text for claim, verdict in verdicts if verdict.holds]
    assert sum(explained_by(claim, verdict) for claim, verdict in verdicts) >= 0.9 * len(verdicts)


def test_two_slips_at_once_are_never_called_right():
    assert not [claim.text for claim, verdict in judged(double(6, seed=5)) if verdict.holds]


def test_a_sliding_joint_counts_no_whole_turns():
    arm = next(arm for arm in ARMS if arm.name == "cylindrical")
    right = next(claim for claim in right_claims(arm) if claim.kind == "joint")
    text = f"{right.text} + 2 pi"
    ((_, verdict),) = judged([type(right)(arm, "joint", right.target, text, right.text, "", right.tree, right.tree)])
    assert verdict.wrong
