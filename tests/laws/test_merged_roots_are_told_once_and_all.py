"""Poses at which two solutions are about to merge, or did: none is lost, and what rounding scatters is told once.

Of an arm that is solved by elimination a nearby arm is a second witness; its own roots, where this one's are about to
merge, may be complex. Where several directions are free at once rounding scatters the one root over 1e-5 rad and
more, elsewhere on each processor.
"""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from oracle.arms.strata import ARMS
from oracle.arms.tables import TABLES
from oracle.joints import around
from pieper import DH, Arm

#: Arm, a joint vector, how many solutions its pose has, those that merge counted as often. Each was lost with its twin.
LOST = [
    ("fanuc-crx-10ia", (-np.pi / 2, np.pi / 4, 0.0, 3.0973442300713714, 2.819653812632872, 0.4424020195661864), 12),
    (
        "fanuc-crx-10ia, placed",
        (4.117919697607541, -0.2365552458281885, -4.712565670053517, 4.501964205782604)
        + (3.8583829915210046, 0.03775560579921259),
        12,
    ),
    (
        "motoman-hc10, placed",
        (3.487048428335321, 5.123987267173694, 0.3100512587777787, 1.6886221611512306)
        + (1.5454141481725971, -6.755533701928329),
        8,
    ),
]


def an_arm(name: str) -> Arm:
    """The arm of a table; `placed`, with base and tool."""
    if name.endswith(", placed"):
        return ARMS[name.removesuffix(", placed")]()
    return Arm.from_dh([DH(a=a, alpha=alpha, d=d, theta=0) for d, a, alpha in TABLES[name]], convention="standard")


@pytest.mark.parametrize(("name", "q", "count"), LOST)
def test_solutions_that_are_about_to_merge_are_all_found(name, q, count):
    arm = an_arm(name)
    T = arm.fk(np.array(q))
    one, many = arm.ik(T), arm.ik_many(T[None], threads=1)
    assert one.status.name == "SOLVED"
    assert int(one.multiplicity.sum()) == count
    for rows in (one.all_q, many.q[0][many.valid[0]]):
        assert np.abs(around(rows - np.array(q))).max(1).min() < 1e-6
        assert np.abs(arm.fk(rows) - T).max() < 1e-11


#: Arm, a joint vector near folds at which the elimination keeps few digits, how many solutions its pose has. Where as
#: many are found as there can be, or the determinant's other roots say how many digits are left, nothing is in doubt.
CLEAR = [
    ("fanuc-crx-10ia", (-1.9940667619443206, -0.06315896751765004, 1.5725544032130445)
     + (0.013063486700183535, 0.7040709541541594, 0.8336566988305192), 16),
    ("fanuc-crx-10ia", (-1.8775178361058322, -3.0217453915943135, 1.5338837725429766)
     + (0.06803470508312204, 0.017906728481527967, -0.7780574330904018), 16),
    ("fanuc-crx-10ia", (-2.990256764142819, -2.7778567210488667, 1.5676244798951515)
     + (3.1246279029943347, 0.0828267033415111, 1.0552893222421051), 16),
    ("kinova-gen3-6dof", (-0.058049953039409186, 0.6075822528140766, 1.4233874695918929)
     + (0.15339177458043807, 0.39083696620950503, -0.050939946427506655), 8),
    ("kinova-gen3-6dof", (2.2778354501852633, 2.9354286072698392, -0.4710780723923871)
     + (3.0355445775157626, 0.19840409011100935, -1.3079923769399713), 8),
]  # fmt: skip


@pytest.mark.parametrize(("name", "q", "count"), CLEAR)
def test_poses_near_folds_of_which_all_is_clear_are_not_marked(name, q, count):
    arm = pieper.load(name) if name in pieper.catalog() else an_arm(name)
    T = arm.fk(np.array(q))
    rows, valid, _, flags = arm.plan.solver.many(T[None], 1)
    assert flags[0] == 0 and valid[0].sum() == count
    found = rows[0][valid[0]]
    assert np.abs(arm.fk(found) - T).max() < 1e-11
    apart = np.abs(around(found[:, None] - found[None])).max(-1)
    assert apart[np.triu_indices(count, 1)].min() > 1e-6
    one = arm.ik(T)
    assert one.status.name in ("SOLVED", "OUTSIDE_LIMITS") and len(one.all_q) == count and not one.self_motions


@pytest.mark.parametrize(
    "name", ["kinova-jaco-j2n6", "kinova-mico", "kinova-gen3-6dof", "neuromeka-indy7", "neuromeka-indy12"]
)
def test_a_root_with_three_free_directions_is_one(name):
    arm = pieper.load(name)
    T = arm.fk(np.zeros(6))
    one, many = arm.ik(T), arm.ik_many(T[None], threads=1)
    assert one.status.name == "SOLVED" and many.status[0] == one.status
    assert len(one.all_q) == many.count[0] == 1 and list(one.multiplicity) == [8]
    assert np.abs(one.all_q).max() < 1e-12  # rows alone are known to 1e-5


def test_a_curve_that_bends_sharply_is_told_once():
    """Two directions are all but free where it bends: a point of it lies 1e-3 from the pieces it is followed by."""
    arm = an_arm("fanuc-crx-10ia")
    q = np.array([-np.pi / 4, -3 * np.pi / 4, np.pi / 2, 3.118896302309892, 0.39622796369325264, np.pi / 4])
    found = arm.ik(arm.fk(q))
    assert len(found.self_motions) == 2 and any(motion.contains(q, 1e-6) for motion in found.self_motions)
    here, there = (np.array([motion.at(u) for u in np.linspace(0, 1, 2001)]) for motion in found.self_motions)
    assert min(np.abs(around(there - p)).max(1).min() for p in here[::50]) > 0.1
