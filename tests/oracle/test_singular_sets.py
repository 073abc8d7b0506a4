"""At singular poses: isolated solutions complete, what made the pose on a self-motion or among the rows, no doubles."""

from __future__ import annotations

import numpy as np
import pytest

from oracle import gap, judge, machine, search
from oracle.arms.known import free
from oracle.joints import turns_apart

QUARTER = np.pi / 2


def judged(arm, q, starts=600):
    """Judge the pose of q: return its Solutions and the oracle's findings after the claims all cases share."""
    m, T = machine(arm), arm.fk(q)
    sols = arm.ik(T)
    inner = m.inner(sols.all_q)
    on_row = len(inner) and gap(m, inner, m.inner(q)).min() < 3e-5
    assert on_row or any(f.contains(q, 1e-5) for f in sols.self_motions), f"lost: {sols.status.name}, {sols.why}"
    verdict = judge(arm, T, rows=sols.all_q, self_motions=sols.self_motions, m=m, starts=starts)
    assert not verdict.wrong
    assert not [x for x in verdict.missing if x[2] > 1e-6], f"isolated: {verdict.missing[:2]}"
    assert not verdict.missing, f"neither row nor on a self-motion: {verdict.missing[:2]}"
    assert verdict.found.crowded == bool(sols.self_motions)
    for motion in sols.self_motions:
        assert np.abs(arm.fk(motion.samples[:, : arm.n]) - T).max() < 1e-9
    apart = gap(m, inner[:, None], inner[None]) + 9 * np.eye(len(inner))
    assert len(inner) < 2 or apart.min() > 1e-4, f"one solution twice, {apart.min():.1e} rad apart"
    return sols, verdict.found


WRIST = ["denso-vp6242", "fanuc-r2000ic-165f", "unimation-puma-560"]


@pytest.mark.parametrize("name", WRIST)
def test_wrist_singularity(name):
    q = np.array([0.4, 0.9, -0.3, 0.8, 0.0, -0.5])
    sols, _ = judged(free(name), q)
    assert sols.status.name == "SINGULAR" and len(sols.self_motions) == 1 and list(sols.in_self_motion).count(-1) == 6


@pytest.mark.parametrize("name", WRIST[:2])
def test_elbow_at_the_edge_of_reach_is_a_double_root_given_once(name):
    arm = free(name)
    q = np.array([0.4, 0.9, 0.0, 0.8, 0.7, -0.5])
    rows = arm.description.rows
    forearm = np.arctan2(rows[3].d, rows[2].a)
    # the determinant vanishes where the forearm lines up with the upper arm, and where the wrist centre meets axis 1
    q[2] = root(arm, q, 2, nearest=-forearm if rows[2].alpha < 0 else forearm)
    sols, found = judged(arm, q)
    here = gap(machine(arm), sols.q, q).argmin()
    assert sols.multiplicity[here] == 2
    assert len(sols.all_q) == len(found.q)


def root(arm, q, joint, nearest):
    """Return the value of a joint where the determinant changes sign, the one nearest to a given value."""
    values = np.linspace(-np.pi, np.pi, 4001)
    line = np.tile(q, (len(values), 1))
    line[:, joint] = values
    det = np.linalg.det(arm.jacobian(line))
    turns = np.flatnonzero(det[:-1] * det[1:] < 0)
    off = turns_apart(values[turns], nearest)
    k = turns[off.argmin()]
    lower, upper, sign = values[k], values[k + 1], np.sign(det[k])
    point = q.copy()
    for _ in range(60):
        point[joint] = (lower + upper) / 2
        if np.sign(np.linalg.det(arm.jacobian(point))) == sign:
            lower = point[joint]
        else:
            upper = point[joint]
    return lower


def test_shoulder_singularity_of_the_denso():
    """The wrist centre on the first axis: joint 1 turns freely, in four ways to hold the elbow and the wrist."""
    arm = free("denso-vp6242")
    q = np.array([0.4, 0.9, -0.7, 0.8, 0.7, -0.5])
    q[1] = root(arm, q, 1, nearest=0.0)
    sols, _ = judged(arm, q)
    assert sols.status.name == "SINGULAR" and len(sols.self_motions) >= 1


@pytest.mark.parametrize("name", ["denso-vp6242", "unimation-puma-560", "universal-robots-ur5e", "stanford-arm"])
def test_the_zero_posture_where_singularities_meet(name):
    judged(free(name), np.zeros(6))


UPRIGHT = {1: QUARTER, 2: 0.0, 4: 0.0}


@pytest.mark.parametrize(
    ("name", "values"),
    [
        (name, values)
        for name in ("universal-robots-ur5e", "motoman-ea1400n", "fanuc-crx-10ia")
        for values in ({4: 0.0}, {2: 0.0}, {2: 0.0, 4: 0.0}, UPRIGHT)
    ],
)
def test_special_postures_of_offset_arms(name, values):
    q = np.array([0.4, 0.9, -0.7, 0.8, 0.7, -0.5])
    for joint, value in values.items():
        q[joint] = value
    judged(free(name), q)


@pytest.mark.parametrize("slide", [0.0, 1e-9, 1e-4])
def test_a_slide_that_is_drawn_in_leaves_the_second_joint_free(slide):
    judged(free("stanford-arm"), np.array([-1.1, 0.8, slide, 0.75, 0.4, 2.0]))


def test_a_double_root_of_little_bend_is_given_once():
    """Forward kinematics misses by 6e-5 t^2 only, t rad away from it: rounding hides 1e-5 rad."""
    arm = free("kinova-jaco-j2n6")
    q = np.array([1.5, 0.0, 0.0, -1.07, 0.0, -0.58])
    sols, found = judged(arm, q)
    assert len(sols.all_q) == len(found.q)
    assert sorted(sols.multiplicity) == [1, 1, 1, 1, 2, 2]


@pytest.mark.parametrize("name", ["denso-vp6242", "universal-robots-ur5e", "motoman-ea1400n", "fanuc-crx-10ia"])
@pytest.mark.parametrize("distance", [1e-10, 1e-8, 1e-6, 1e-4, 1e-2])
def test_nothing_is_lost_near_a_singular_posture(name, distance):
    arm = free(name)
    m = machine(arm)
    for joint in (2, 4):
        q = np.array([0.4, 0.9, -0.7, 0.8, 0.7, -0.5])
        q[joint] = root(arm, q, joint, nearest=0.0) + distance
        T = arm.fk(q)
        sols = arm.ik(T)
        on_row = gap(m, m.inner(sols.all_q), m.inner(q)).min() < 3e-5
        assert on_row or any(f.contains(q, 1e-5) for f in sols.self_motions)
        found = search(arm, T, m=m, starts=400, at_most=25)
        clear = found.q[found.sigma > 1e-5]
        for other in clear:
            assert gap(m, m.inner(sols.all_q), m.inner(other)).min() < 1e-5


#: Joint vectors next to a self-motion of the arm folded onto its shoulder: their solutions hide along what is left of
#: it, and the elimination, itself nearly singular there, gives four to twelve of the others only.
HIDING = [
    ([1.1757, -1.2226, -4.7124, 0.5717, -1.1459, -0.4997], 4e-6),
    ([0.5747, 0.0484, 1.5708, 0.444, -1.0409, 2.7012], 4e-7),
    ([-1.7652, 2.9461, 1.5708, -2.5693, -1.8207, 2.7005], 2e-8),
    ([-0.4657, -3.7503, 1.5708, 2.5109, -0.5139, -0.7688], 5e-10),
]


@pytest.mark.parametrize(("near", "distance"), HIDING)
def test_solutions_that_hide_next_to_a_self_motion_are_found(near, distance):
    arm = free("fanuc-crx-10ia")
    q = np.array(near)
    q[2] = np.round(q[2] / QUARTER) * QUARTER
    q += distance * np.array([0.3, -0.5, 0.6, 0.2, -0.4, 0.3])
    T = arm.fk(q)
    sols, many = arm.ik(T), arm.ik_many(T[None], threads=1)
    m = machine(arm)
    # a pose in double precision says no more of q than 1e-16 over the distance
    assert gap(m, m.inner(sols.all_q), m.inner(q)).min() < 1e-6 + 1e-14 / distance
    assert len(sols.all_q) == many.count[0] and len(sols.all_q) % 2 == 0
    assert len(sols.all_q) <= arm.plan.max_solutions
    assert sols.residual.max() < 1e-12


@pytest.mark.parametrize("distance", [0.0, 1e-10, 2.5e-8, 1e-6])
def test_a_short_arm_loses_nothing_where_its_virtual_joint_is_of_no_help(distance):
    """The arm's five joints are at ease; the six of which its closed form thinks are singular."""
    arm = free("dfrobot-rob0036")
    plan = arm.plan
    six = plan.reduction.six(plan.defaults)
    q = np.array([-0.518, -4.303, -0.519, 5.351, 1.967])
    lower, upper = q[4] - 0.3, q[4] + 0.3

    def det(value):
        return np.linalg.det(six_jacobian(six, np.array([*q[:4], value, 0.0])))

    values = np.linspace(q[4] - np.pi, q[4] + np.pi, 400)
    signs = np.sign([det(v) for v in values])
    k = np.flatnonzero(signs[:-1] != signs[1:])[0]
    lower, upper = values[k], values[k + 1]
    for _ in range(60):
        q[4] = (lower + upper) / 2
        lower, upper = (q[4], upper) if np.sign(det(q[4])) == signs[k] else (lower, q[4])
    q[4] += distance
    T = arm.fk(q)
    sols, many = arm.ik(T), arm.ik_many(T[None], threads=1)
    m = machine(arm)
    assert gap(m, m.inner(sols.all_q), m.inner(q)).min() < 1e-9
    assert len(sols.all_q) == many.count[0] == len(search(arm, T, m=m, starts=400).q)


def six_jacobian(chain, q):
    """Return the Jacobian of a chain with lengths in units of the arm."""
    J = chain.native.jacobian(q)
    J[:3] /= chain.length
    return J


def test_a_surface_of_solutions_is_told_as_such_and_takes_no_long_search():
    """Wrist and shoulder singular at once, and axes 1, 4 and 6 in one line: two joints may be chosen."""
    arm = free("denso-vp6242")
    q = np.array([0.4, 7.488808, 11.360793, 0.3, 0.0, 0.5])
    q[1:3] = upright(arm, q)
    sols = arm.ik(arm.fk(q))
    assert sols.status.name == "SINGULAR"
    surfaces = [f for f in sols.self_motions if f.dimension == 2]
    assert surfaces and "2 degrees of freedom" in sols.why
    curves = [f for f in sols.self_motions if f.dimension == 1]
    found = search(arm, arm.fk(q), starts=400)
    for other in found.q:
        rank = np.linalg.svd(six_jacobian(arm.chain, other), compute_uv=False)
        assert rank[4] < 1e-6 or any(f.contains(other, 1e-4) for f in curves)


def upright(arm, q):
    """Return joints 2 and 3 that put the wrist centre on the first axis and the forearm along it, by Newton."""
    from pieper.kinematics.geometry import axes_at

    def left(x):
        z, o = axes_at(arm.chain, np.array([q[0], *x, *q[3:]]))
        side = np.cross(z[1], z[0])
        return np.array([z[3] @ side, (o[4] - o[0]) @ side])

    x = q[1:3].copy()
    for _ in range(8):
        J = np.stack([(left(x + 1e-6 * e) - left(x - 1e-6 * e)) / 2e-6 for e in np.eye(2)], 1)
        x -= np.linalg.solve(J, left(x))
    return x


def test_what_merges_and_along_which_direction_is_in_the_result():
    arm = free("denso-vp6242")
    q = np.array([0.4, 0.9, 0.0, 0.8, 0.7, -0.5])
    rows = arm.description.rows
    q[2] = root(arm, q, 2, nearest=-np.arctan2(rows[3].d, rows[2].a))
    sols = arm.ik(arm.fk(q))
    here = gap(machine(arm), sols.q, q).argmin()
    assert sols.multiplicity[here] == 2
    assert {label.split(", ")[1] for label in sols.merged_labels[here]} == {"elbow up", "elbow down"}
    way = sols.direction[here]
    assert np.linalg.norm(way) == pytest.approx(1) and np.linalg.norm(arm.jacobian(q) @ way) < 1e-7
    q = np.array([0.4, 0.9, -0.3, 0.8, 0.0, -0.5])
    sols = arm.ik(arm.fk(q))
    for row, motion, way, labels in zip(sols.q, sols.in_self_motion, sols.direction, sols.merged_labels, strict=True):
        assert labels == ()
        assert bool(way.any()) == (motion >= 0)
        if motion >= 0:
            assert np.linalg.norm(arm.jacobian(row) @ way) < 1e-9
            assert abs(way @ sols.self_motions[motion].direction) == pytest.approx(1)
