"""The workbench's messages: what is refused, and that the refusal says why."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

import pieper
from pieper.workbench import messages
from pieper.workbench.equation_blocks import forward_blocks, inverse_blocks, singular_blocks
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
    if arm.description.linked:
        with pytest.raises(pieper.PlanError, match="linkage that moves level"):
            table_from_arm(arm)
        arm = arm.uncoupled()
    again = arm_from_table(json.loads(json.dumps(table_from_arm(arm), allow_nan=False)))
    q = np.random.default_rng(3).uniform(-1, 1, (4, arm.n))
    assert np.allclose(again.fk(q), arm.fk(q), atol=1e-15)
    assert np.array_equal(again.limits, arm.limits)
    assert set(again.description.postures) == set(arm.description.postures)


def test_equations_are_blocks_with_their_numbers_as_fields():
    arm = pieper.load("denso-vp6242")
    blocks = inverse_blocks(arm)
    steps = [b for b in blocks if b["kind"] == "step"]
    assert [b["number"] for b in steps] == [1, 2, 3, 4, 5, 6]
    assert [b["branches"] for b in steps] == [2, 2, 1, 2, 1, 1]
    results = [b for b in blocks if b.get("number") == 2 and b["kind"] == "equation"]
    assert results[0]["text"].startswith("theta3 = atan2(")
    assert {b["kind"] for b in singular_blocks(arm)} == {"heading", "paragraph", "equation"}


def test_entries_of_the_pose_say_where_they_stand_and_what_moves_in_them():
    entries = [b for b in forward_blocks(pieper.load("adept-cobra-600"), "numbers") if "entry" in b]
    assert [b["entry"] for b in entries] == [0, 4, 8, 1, 5, 9, 2, 6, 10, 3, 7, 11]
    height = entries[-1]
    assert height["symbols"] == [{"latex": "d_{3}", "is": "slide", "joints": ((3, 1),)}]
