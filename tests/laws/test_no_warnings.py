"""A warning is for what a user gives: what the library asks itself sets off none, of an arm of every kind."""

from __future__ import annotations

import numpy as np
import pytest

import pieper

ARMS = (
    "denso-vp6242",
    "adept-cobra-600",
    "dfrobot-rob0036",
    "stanford-arm",
    "rrp-wrist",
    "fanuc-crx-10ia",
    "kinova-jaco-j2n6",
    "kuka-lbr-iiwa-14-r820",
    "rethink-sawyer",
    "three-r",
    "universal-robots-ur10",
)
pytestmark = pytest.mark.filterwarnings("error")


@pytest.mark.parametrize("name", ARMS)
def test_plan_and_solutions_warn_of_nothing(name):
    arm = pieper.load(name)
    assert arm.plan.explain()
    rng = np.random.default_rng(7)
    low, high = np.clip(arm.limits, -np.pi, np.pi).T
    for q in (np.zeros(arm.n), *rng.uniform(low, high, (3, arm.n))):
        sols = arm.ik(arm.fk(q))
        assert sols.why and len(sols.labels) == len(sols.q) and len(sols.residual) == len(sols.q)
        assert len(sols.self_motions) >= (arm.plan.redundancy != ())
    far = arm.fk(np.zeros(arm.n))
    far[:3, 3] += 10 * arm.chain.length
    beyond = arm.ik(far)
    assert beyond.why and not len(beyond)
    assert len(arm.ik_many(arm.fk(rng.uniform(low, high, (50, arm.n)))).status) == 50


@pytest.mark.parametrize("name", ARMS)
def test_equations_warn_of_nothing(name):
    symbolic = pieper.load(name).symbolic
    assert symbolic.fk().text() and symbolic.jacobian().text() and symbolic.singularities().text()
    assert symbolic.ik().text()
