"""The workbench's messages: what is refused, and that the refusal says why."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

import pieper
from pieper.workbench import messages
from pieper.workbench.equation_blocks import blocks_of_latex
from pieper.workbench.messages import Refused
from pieper.workbench.table import arm_from_table, table_from_arm


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("", "JSON"),
        ("[1]", "object"),
        ('{"op": "ik"}', "seq"),
        ('{"op": "ik", "seq": -1}', "seq"),
        ('{"op": "ik", "seq": true}', "seq"),
        ('{"op": "ik", "seq": 1.5}', "seq"),
        ('{"op": 7, "seq": 1}', "op"),
        ('{"op": "ik", "seq": 1, "T": [NaN]}', "finite"),
        ('{"op": "ik", "seq": 1, "T": [-Infinity]}', "finite"),
        ("[" * 100_000, "JSON"),
        ('{"op": "' + "x" * messages.MAX_BYTES + '", "seq": 1}', "characters"),
    ],
)
def test_a_malformed_message_is_refused_with_its_reason(text, reason):
    with pytest.raises(Refused, match=reason):
        messages.parse(text)


@pytest.mark.parametrize("value", [True, "1", None, [1], 1e8, math.inf, math.nan, 10**400])
def test_what_is_not_a_sane_number_is_refused(value):
    with pytest.raises(Refused, match="lower"):
        messages.number(value, "lower")


def table(n: int = 2) -> dict:
    row = {"name": "j", "type": "R", "a": 0.1, "alpha": 0.0, "d": 0.0, "theta": 0.0, "lower": None, "upper": None}
    return {"name": "t", "convention": "standard", "joints": [{**row, "name": f"j{i}"} for i in range(n)]}


def changed(**joint) -> dict:
    out = table()
    out["joints"][1].update(joint)
    return out


@pytest.mark.parametrize(
    ("given", "reason"),
    [
        (None, "object"),
        ({}, "no joints"),
        ({"joints": []}, "no joints"),
        (table(500), "500 joints"),
        (changed(a="1"), "joint 2, a"),
        (changed(type="X"), "joint 2, type"),
        (changed(alpha=1e300), "joint 2, alpha"),
        (changed(name="x" * 500), "joint 2, name"),
        ({**table(), "convention": "craig"}, "convention"),
        ({**table(), "base": [0] * 16}, "base"),
        ({**table(), "tool": [1, 2]}, "tool"),
        ({**table(), "postures": {"a": [1]}}, "posture a"),
    ],
)
def test_an_impossible_table_is_refused_and_the_joint_is_named(given, reason):
    with pytest.raises((Refused, pieper.InputError), match=reason):
        arm_from_table(given)


@pytest.mark.parametrize("name", pieper.catalog())
def test_every_catalogue_arm_survives_the_way_to_the_page_and_back(name):
    arm = pieper.load(name)
    again = arm_from_table(json.loads(json.dumps(table_from_arm(arm), allow_nan=False)))
    q = np.random.default_rng(3).uniform(-1, 1, (4, arm.n))
    assert np.allclose(again.fk(q), arm.fk(q), atol=1e-15)
    assert np.array_equal(again.limits, arm.limits)
    assert set(again.description.postures) == set(arm.description.postures)


def test_latex_is_cut_into_sentences_and_formulas():
    blocks = blocks_of_latex(
        r"\section*{Step 1} From $p_x$ follows:"
        "\n"
        r"\[ \theta_1 = 0 \]"
        "\n\nThen \\textbf{all}.\n"
        r"\begin{align*} a &= b \\ c &= d \end{align*}"
    )
    assert blocks == [
        {"heading": "Step 1"},
        {"text": "From $p_x$ follows:"},
        {"latex": r"\theta_1 = 0"},
        {"text": "Then all."},
        {"latex": r"\begin{aligned} a &= b \\ c &= d \end{aligned}"},
    ]
