"""Results are plain data: they pickle, free the arm they came from, and solve nothing when printed."""

from __future__ import annotations

import copy
import dataclasses
import gc
import pickle
import weakref

import numpy as np
import pytest

import pieper
from pieper.solver import results, verbs
from pieper.words_by_number import plural


@pytest.mark.parametrize("name", ["denso-vs6577", "franka-panda", "three-r"])
def test_an_arm_is_freed_once_nobody_holds_it(name):
    arm = pieper.load(name)
    T = arm.fk(np.full(arm.n, 0.3))
    sols = arm.ik(T)
    assert sols.labels and sols.why and arm.plan.explain() and len(arm.ik_many(T[None])) == 1
    beyond = arm.ik(pieper.pose(90.0, 0.0, 0.0))
    assert not len(beyond) and beyond.why and arm.closest(beyond.T).metres > 1
    held = [weakref.ref(one) for one in (arm, arm.plan, arm.chain)]
    del arm, sols, beyond
    gc.collect()
    assert not [one() for one in held if one() is not None]


@pytest.mark.parametrize("name", ["denso-vs6577", "franka-panda"])
def test_arms_plans_solutions_and_batches_pickle_and_copy(name):
    arm = pieper.load(name)
    q = np.full(arm.n, 0.3)
    T = arm.fk(q)
    sols, many = arm.ik(T), arm.ik_many(T[None], near=q)
    for twin in (pickle.loads(pickle.dumps(arm)), copy.deepcopy(arm), copy.copy(arm)):
        assert np.array_equal(twin.ik(T).q, sols.q)
    plan = pickle.loads(pickle.dumps(arm.plan))
    assert plan.explain() == arm.plan.explain() and np.array_equal(verbs.ik(plan, T).q, sols.q)
    twin = pickle.loads(pickle.dumps(sols))
    assert (twin.status, twin.why, twin.labels) == (sols.status, sols.why, sols.labels)
    assert np.array_equal(twin.nearest(q), sols.nearest(q))
    batch = pickle.loads(pickle.dumps(many))
    assert np.array_equal(batch.q, many.q) and np.array_equal(batch.nearest, many.nearest)


def test_printing_an_unreachable_pose_solves_nothing(monkeypatch):
    asked = []
    words = dataclasses.replace(verbs.WORDS, why=lambda plan, sols: asked.append(sols) or "why")
    monkeypatch.setattr(verbs, "WORDS", words)
    arm = pieper.load("denso-vs6577")
    T = arm.fk(np.zeros(6))
    T[:3, 3] *= 10
    sols = arm.ik(T)
    assert "OUT_OF_REACH" in repr(sols) and not asked
    assert sols.why == sols.why == "why" and len(asked) == 1


def test_printing_a_redundant_arms_empty_answer_traces_nothing():
    arm = pieper.load("franka-panda")
    T = arm.fk(np.full(7, 0.3))
    T[:3, 3] *= 10
    sols = results.Solutions(
        arm.plan, verbs.WORDS, T, np.zeros((0, 7)), np.zeros(0, int), np.zeros(0, bool), 0, self_motions=lambda: 1 / 0
    )
    assert "not worked out" in repr(sols)


def test_words_follow_their_number():
    assert plural(1, "solution") == "1 solution" and plural(0, "solution") == "0 solutions"
    assert plural(2, "family", "families") == "2 families"


def test_solutions_are_a_sequence_of_what_one_says_of_each():
    arm = pieper.load("denso-vp6242")
    sols = arm.with_limits(dict.fromkeys(arm.joint_names)).ik(arm.fk([0.1, 0.9, -2.6, 0.2, 1.7, 0]))
    assert len(list(sols)) == len(sols) == 8
    for one, q, label, residual in zip(sols, sols.q, sols.labels, sols.residual, strict=True):
        assert np.array_equal(one.q, q) and one.label == label and np.array_equal(one.residual, residual)
    assert sols[-1].label == sols.labels[-1] and [one.label for one in sols[1:3]] == sols.labels[1:3]
    with pytest.raises(IndexError):
        sols[8]


def test_a_table_shows_every_joint_value_in_degrees_and_the_reason():
    arm = pieper.load("denso-vp6242")
    sols = arm.ik(arm.fk([0.1, 0.9, -2.6, 0.2, 1.7, 0]))
    lines = str(sols).splitlines()
    assert len(lines) == 2 + len(sols) and lines[-1] == sols.why
    assert all(f"{np.degrees(v):.3f}" in lines[1] for v in sols.q[0, :5]) and "-0.000" not in lines[1]
    far = arm.ik(pieper.pose(3, 0, 0))
    assert far.table() == far.why


def test_one_row_inside_the_limits_says_how_the_pose_came_out_without_tracing_anything():
    arm = pieper.load("kuka-lbr-iiwa-14-r820")
    q = np.array([0.0, 0.6, -0.4, -1.2, 0.5, 0.9, -0.2])
    arm = arm.with_limits({name: (at - 0.2, at + 0.2) for name, at in zip(arm.joint_names, q.tolist(), strict=True)})
    sols = arm.ik(arm.fk(q))
    assert len(sols.q) == 1 and repr(sols) == "<Solutions: 1 inside the limits of 8, REDUNDANT>"
