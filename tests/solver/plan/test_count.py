"""How many solutions a pose can have: bounds by an arm's own axes, met by poses, passed by none a search finds."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from pieper.solver.counted import most_met
from pieper.solver.plan.six_joints import sample_joints
from pieper.words_by_number import plural

Q = np.pi / 2
#: joint types, rows (a, alpha, d, theta), task, what it is, the bound that is met.
ARMS = [
    ("RR", [(1, 0, 0, 0), (0.7, 0, 0, 0)], "pose", "a planar arm", 1),
    ("RR", [(1, 0, 0, 0), (0.7, 0, 0, 0)], "position", "two parallel turns", 2),
    ("RRR", [(1, 0, 0, 0), (0.7, 0, 0, 0), (0.3, 0, 0, 0)], "pose", "a planar arm", 2),
    ("RP", [(0.1, Q, 0, 0), (0, 0, 0, 0)], "pose", "a planar arm", 1),
    ("RP", [(0.1, Q, 0, 0), (0, 0, 0, 0)], "position", "a turn and a slide", 2),
    ("RPR", [(0, Q, 0, 0), (0, -Q, 0, 0), (0.2, 0, 0, 0)], "pose", "a planar arm", 2),
    ("PPP", [(0, Q, 0, Q), (0, Q, 0, Q), (0, 0, 0, 0)], "position", "a gantry", 1),
    ("PPPR", [(0, Q, 0, Q), (0, Q, 0, Q), (0, 0, 0, 0), (0.2, 0, 0, 0)], "pose", "a turn and a slide", 1),
    (
        "PPPRRR",
        [(0, Q, 0, Q), (0, Q, 0, Q), (0, 0, 0, 0), (0, Q, 0.1, 0), (0, -Q, 0, 0), (0, 0, 0.2, 0)],
        "pose",
        "a gantry with a spherical wrist",
        2,
    ),
    ("RRP", [(0.3, Q, 0.5, 0), (0.1, 1.0, 0.1, 0), (0, 0, 0, 0)], "position", "two turns and a slide", 4),
    ("PRR", [(0, Q, 0, 0), (0.5, Q, 0, 0), (0.4, 0, 0.1, 0)], "position", "two turns and a slide", 4),
    ("RPP", [(0.1, 0, 0.5, 0), (0, Q, 0, 0), (0, 0, 0, 0)], "position", "a turn and two slides", 2),
    ("RRR", [(0.1, Q, 0.5, 0), (0.5, 0.7, 0.1, 0), (0.4, 0, 0, 0)], "position", "three turns", 4),
    ("RRRP", [(0.4, 0, 0.3, 0), (0.3, np.pi, 0, 0), (0, 0, 0.1, 0), (0, 0, 0, 0)], "pose", "a SCARA arm", 2),
    ("PRRR", [(0, 0, 0, 0), (0.4, 0, 0.3, 0), (0.3, np.pi, 0, 0), (0, 0, 0.1, 0)], "pose", "a SCARA arm", 2),
    (
        "RRRR",
        [(0.1, Q, 0.4, 0), (0.4, 0, 0.1, 0), (0.3, 0, 0, 0), (0.2, 0, 0, 0)],
        "pose",
        "a planar arm on a turn",
        2,
    ),
    (
        "RRRRR",
        [(0, Q, 0.4, 0), (0.4, 0, 0, 0), (0.3, 0, 0, 0), (0, Q, 0, 0), (0, 0, 0.1, 0)],
        "pose",
        "a planar arm between two turns",
        4,
    ),
    (
        "RRRRR",
        [(0, Q, 0.4, 0), (0.1, Q, 0.1, 0), (0.3, 0, 0, 0), (0.4, 0, 0, 0), (0.1, 0, 0.1, 0)],
        "pose",
        "a planar arm and two turns",
        4,
    ),
    ("RRRR", [(0.3, 0.8, 0, 0), (0, 1.1, 0, Q), (0, -Q, 0, Q), (-0.2, -Q, -0.15, 0)], "pose", "an arm of 4 turns", 2),
    ("RPRR", [(0.3, 0, 0, 0), (0, -Q, 0, 0), (0.3, 0, 0, Q), (-0.2, 0, -0.15, 0)], "pose", "3 turns and 1 slide", 2),
    (
        "RPPRRR",
        [(0.1, 0, 0.4, 0), (0, Q, 0, 0), (0, 0, 0, 0), (0, Q, 0, 0), (0, -Q, 0, 0), (0, 0, 0.1, 0)],
        "pose",
        "a turn and two slides, with a spherical wrist",
        4,
    ),
]


def made(kinds, rows):
    return pieper.Arm.from_dh([pieper.DH(*row) for row in rows], convention="standard", joint_types=kinds)


@pytest.mark.parametrize(("kinds", "rows", "task", "kind", "most"), ARMS)
def test_the_bound_is_met_and_the_words_say_what_the_arm_is(kinds, rows, task, kind, most):
    plan = made(kinds, rows).plan_for(task)
    assert kind in plan.count.kind and plan.count.most == most == most_met(plan)
    assert plan.max_solutions >= most
    said = plan.explain()
    assert f"at most {most} solution" in said and kind in said.splitlines()[0]
    assert ("There are poses that have them all" in said) == (most > 1)


@pytest.mark.parametrize(("kinds", "rows", "task", "kind", "most"), [arm for arm in ARMS if len(arm[0]) < 6])
def test_no_search_finds_more(kinds, rows, task, kind, most):
    arm = made(kinds, rows)
    starts = sample_joints(arm.chain, 400, seed=7)
    for q in sample_joints(arm.chain, 6, seed=3):
        T = arm.fk(q)
        found = _everything(arm, T, task, starts)
        assert 1 <= len(found) <= most


def _everything(arm, T, task, starts, held=()):
    """Every distinct solution that damped Newton from many starts comes to; independent of the solver's families."""
    count = 3 if task == "position" else 6
    q = starts.copy()
    wanted = np.broadcast_to(T, (len(q), 4, 4))
    for _ in range(150):
        now = arm.fk(q)
        error = np.concatenate([wanted[:, :3, 3] - now[:, :3, 3], _turn(now, wanted)], 1)[:, :count]
        J = arm.jacobian(q)[:, :count]
        J[:, :, list(held)] = 0.0
        JJ = np.swapaxes(J, 1, 2) @ J + 1e-9 * np.eye(arm.n)
        step = np.linalg.solve(JJ, np.swapaxes(J, 1, 2) @ error[..., None])[..., 0]
        q = q + step * np.minimum(1.0, 0.5 / np.maximum(np.abs(step).max(1, keepdims=True), 1e-12))
    now = arm.fk(q)
    good = np.abs(np.concatenate([wanted[:, :3, 3] - now[:, :3, 3], _turn(now, wanted)], 1)[:, :count]).max(1) < 1e-9
    distinct = []
    turns = np.array([kind == "R" for kind in arm.joint_types])
    for row in q[good]:
        if all(np.abs(np.where(turns, np.sin((row - other) / 2), row - other)).max() > 1e-5 for other in distinct):
            distinct.append(row)
    return distinct


def _turn(now, wanted):
    R = wanted[:, :3, :3] @ np.swapaxes(now[:, :3, :3], 1, 2)
    return np.stack([R[:, 2, 1] - R[:, 1, 2], R[:, 0, 2] - R[:, 2, 0], R[:, 1, 0] - R[:, 0, 1]], 1) / 2


@pytest.mark.parametrize(
    ("name", "kind", "most"),
    [
        ("adept-cobra-600", "a SCARA arm", 2),
        ("robotis-openmanipulator-x", "a planar arm on a turn", 2),
        ("ufactory-xarm5", "a planar arm between two turns", 4),
        ("three-r", "three turns, for positions", 4),
        ("stanford-arm", "two turns and a slide, with a spherical wrist", 8),
        ("franka-panda", "a redundant arm", 8),
    ],
)
def test_arms_of_the_catalogue_are_what_they_are(name, kind, most):
    plan = pieper.load(name).plan
    assert kind in plan.count.kind and plan.count.most == most == most_met(plan)
    assert f"at most {most} solution" in repr(plan)


#: joint types, rows (a, alpha, d, theta), task, what it is, the bound (spare joints held), and what is met.
SHORT = [
    ("RR", [(0, Q, 0.1, 0), (0, 0, 0.1, 0)], "pose", "2 turns", 1, 1),
    ("RR", [(0.3, 0.7, 0.1, 0), (0.2, 0, 0.1, 0)], "pose", "2 turns", 1, 1),
    ("RR", [(0, Q, 0.1, 0), (0.2, 0, 0.1, 0)], "position", "two turns, for positions", 2, 2),
    ("R", [(0.2, 0, 0.1, 0)], "position", "a single turn", 1, 1),
    ("RRR", [(0.3, 0.7, 0.1, 0), (0.2, 0.5, 0.1, 0), (0, 0, 0.1, 0)], "pose", "3 turns", 2, 1),
    ("RRR", [(0, Q, 0, 0), (0, Q, 0, 0), (0, 0, 0.1, 0)], "pose", "3 turns", 2, 2),
    ("RRR", [(0.3, 0, 0.1, 0), (0.2, 0.5, 0.1, 0), (0, 0, 0.1, 0)], "pose", "3 turns", 1, 1),
    ("PP", [(0, 0, 0.2, 0), (0, 0, 0, 0)], "pose", "1 freedom more", 1, 1),
    ("PPP", [(0, 0, 0.2, 0), (0, Q, 0, 0), (0, 0, 0, 0)], "pose", "1 freedom more", 1, 1),
    ("RPP", [(0, -Q, 0.2, 0), (0, 0, 0, 0), (0, 0, 0, 0)], "pose", "1 freedom more", 1, 1),
    ("RRR", [(0, 0, 0, 0), (0, 0, 0.1, 0), (0, 0, 0.1, 0)], "pose", "2 freedoms more", 1, 1),
    ("RRR", [(0, Q, 0, 0), (0, 0, 0, 0), (0.1, 0, 0.1, 0)], "pose", "1 freedom more", 1, 1),
    ("RRRR", [(0.4, 0, 0, 0), (0.3, 0, 0, 0), (0.2, 0, 0, 0), (0.1, 0, 0, 0)], "pose", "1 freedom more", 2, 2),
    ("RRRR", [(0, Q, 0, 0), (0, Q, 0, 0), (0, Q, 0, 0), (0, 0, 0.1, 0)], "pose", "1 freedom more", 2, 2),
]


@pytest.mark.parametrize(("kinds", "rows", "task", "kind", "most", "met"), SHORT)
def test_short_arms_and_arms_with_joints_to_spare_are_counted_by_their_own_axes(kinds, rows, task, kind, most, met):
    arm = made(kinds, rows)
    plan = arm.plan_for(task)
    assert kind in plan.count.kind and plan.count.most == most and most_met(plan) == met
    said = plan.explain()
    assert f"at most {plural(most, 'solution')}" in said
    assert all(name in plan.count.argument for name in plan.redundancy)
    starts = sample_joints(arm.chain, 200, seed=7)
    held = list(plan.reduction.locked)
    for q in sample_joints(arm.chain, 6, seed=3):
        starts[:, held] = q[held]
        assert 1 <= len(_everything(arm, arm.fk(q), task, starts, held)) <= most


@pytest.mark.parametrize(("kinds", "rows", "task", "kind", "most", "met"), [a for a in SHORT if a[2] == "pose"])
def test_the_derivation_of_a_short_arm_gives_no_larger_number(kinds, rows, task, kind, most, met):
    form = made(kinds, rows).symbolic.ik().form
    assert form is None or met <= form.branches <= most


def test_where_the_bound_is_not_met_the_fullest_pose_is_told():
    plan = pieper.load("kinova-jaco-j2n6").plan
    assert most_met(plan) < plan.count.most
    assert f"the fullest has {most_met(plan)}." in plan.explain()


@pytest.mark.parametrize("name", ["doosan-p3020", "dfrobot-rob0036-as-printed"])
def test_a_level_hand_has_all_the_solutions_that_a_palletizer_can_have(name):
    """Any other pose leaves the common direction one of its two values: the arm stands beside its first axis."""
    plan = pieper.load(name).plan
    assert plan.count.most == 4 == most_met(plan)


@pytest.mark.parametrize(("name", "met"), [("denso-cobotta", 14), ("kinova-gen3-lite", 16), ("kinova-mico", 14)])
def test_the_fullest_pose_is_looked_for_near_full_ones(name, met):
    assert met <= most_met(pieper.load(name).plan) <= 16


def mixed(rng: np.random.Generator, kinds: str) -> pieper.Arm:
    """Return an arm of round and other twists and lengths, at times with three turns that meet in a point."""
    rows = [
        [rng.choice([0, 0, 0.1, 0.2, 0.3]), rng.choice([0, Q, -Q, Q, -Q, 0.7]), rng.choice([0, 0, 0.1, 0.25]), 0.0]
        for _ in kinds
    ]
    groups = [i for i in range(len(kinds) - 2) if kinds[i : i + 3] == "RRR"]
    if groups and rng.random() < 0.5:
        first = int(rng.choice(groups))
        rows[first][:2], rows[first + 1][:3] = [0, Q], [0, -Q, 0]
    return made(kinds, rows)


def never_more(kinds: str, arms: int, poses: int, seed: int, task: str | None = None) -> None:
    """Hold the bounds of arms of some kinds against random postures' poses that are not marked."""
    rng = np.random.default_rng(seed)
    for _ in range(arms):
        arm = mixed(rng, kinds)
        try:
            plan = arm.plan_for(task)
        except pieper.PlanError:
            continue
        if plan.redundancy:
            continue
        many = arm.ik_many(arm.fk(rng.uniform(-3, 3, (poses, arm.n))), task=task, threads=1)
        plain = (many.flag & 3) == 0
        most = int(many.valid.sum(1)[plain].max(initial=0))
        assert most <= plan.count.most, f"{kinds}: {most} of {plan.count}: {arm.description.rows}"


MIXED = [
    "PPPRRR",
    "RPPPRR",
    "PRPRPR",
    "RRRPPP",
    "PRRRRP",
    "PPRRRR",
    "PRRRPR",
    "RPRRRR",
    "PPRRR",
    "RRPPR",
    "PRRR",
    "RPRP",
    "RRRR",
    "RRPP",
    "PRRP",
    "PRPP",
]


@pytest.mark.parametrize("kinds", MIXED)
def test_no_pose_of_a_mixed_arm_has_more(kinds):
    never_more(kinds, 4, 200, seed=1)


@pytest.mark.slow
@pytest.mark.parametrize("kinds", MIXED)
def test_none_of_many_poses_of_a_mixed_arm_has_more(kinds):
    never_more(kinds, 6, 5000, seed=2)


@pytest.mark.parametrize("kinds", ["PPPRRR", "RPPPRR", "PRPRPR", "RRRPPP", "PPRRRP"])
def test_three_turns_and_three_slides_have_two_solutions_wherever_they_stand(kinds):
    rng = np.random.default_rng(4)
    for _ in range(3):
        # of no special kind, zeros of slides included: three slides must not lie in one plane
        rows = rng.uniform([0.1, 0.6, 0.1, 0.3], [0.4, 2.4, 0.4, 2.8], (6, 4))
        plan = made(kinds, rows).plan
        assert plan.count.most == 2 == most_met(plan)
