"""Results are plain data: they pickle, free the arm they came from, and solve nothing when printed."""

from __future__ import annotations

import copy
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
    arm_left, plan_left = weakref.ref(arm), weakref.ref(arm.plan)
    del arm, sols
    gc.collect()
    assert arm_left() is None and plan_left() is None


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
    words = results.Words(lambda plan, sols: asked.append(sols) or "why", *[verbs.posture_words, verbs.labels_beside])
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
