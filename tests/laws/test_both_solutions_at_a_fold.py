"""The two solutions at a fold are both told as soon as a pose in double precision tells them apart.

Between two roots of a fold the pose is missed by a few roundings only, and they are 1e-6 to 1e-3 rad apart. A closed
form takes them for one in a flat valley, or gives one of them twice where its polishing ends beside it; what counts
branches may call them one; and where a task's virtual joints are cut off, one solution that was found twice must not
cost the place of another. Fifty digits say that the solution next to each joint vector is a row.
"""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from benchmarks.measure.fifty_digits import verdict
from benchmarks.measure.singular_strata import singular_joints, smallest
from oracle.arms.strata import ARMS
from oracle.joints import around
from pieper.kinematics.newton import newton, scaled_jacobian
from pieper.solver.singular.merged_roots import all_into_limits, distinct_roots

#: Arm, and a joint vector at a fold whose solution was not among the rows.
AT_A_FOLD = [
    (
        "fanuc-r2000ic-165f",
        (-1.8437691567989885, -3.1693970885662863, 1.7447999686591438)
        + (2.1922031505198274, -0.050014466858633144, -1.896195153091348),
    ),
    (
        "universal-robots-ur5e",
        (0.15520110053685612, 1.7330584846530432, -3.141592598495838)
        + (-2.0989971197313553, -2.4097364303028925, 0.7091410519161195),
    ),
    (
        "motoman-ea1400n",
        (-2.120349957849485, 1.441265988240218, -1.7295822894051212)
        + (0.6025573283443781, 0.0017861106695663902, 4.749938026223101),
    ),
    (
        "motoman-ea1400n",
        (2.81982575095694, 1.0165875754344098, -1.9031977108076639)
        + (-1.8395932310669172, -2.668401781804279, -3.1920728121232433),
    ),
    (
        "motoman-ea1400n",
        (-0.2489263987729464, 3.622036924162605, -0.42330763872694965)
        + (3.149157115879802, -1.5079929394227534, -0.314133281959625),
    ),
    (
        "three-r",
        (0.019803732660072817, 1.5709125630252152, -1.569019824155202),
    ),
    (
        "three parallel, skew",
        (1.1524864263042935, -2.960946033281001, 4.295182829045406)
        + (-1.8012605731767044, -2.9156753543892044, 3.4913121364591264),
    ),
    (
        "three parallel, skew",
        (6.884525837287179, -0.16522833057650538, -2.915753527966459)
        + (0.2273915074643718, -0.3315073432179901, 1.29117298455807),
    ),
]


@pytest.mark.parametrize(("name", "q"), AT_A_FOLD)
def test_both_solutions_at_a_fold_are_told(name, q):
    arm, q = ARMS[name](), np.array(q)
    T = arm.fk(q)
    one, many = arm.ik(T), arm.ik_many(T[None], threads=1)
    assert one.status.name == "SOLVED" and many.status[0] == one.status
    assert np.array_equal(one.all_q, many.q[0][many.valid[0]])
    assert len(one.all_q) % 2 == 0 and np.all(one.multiplicity == 1)
    asked = range(3) if arm.plan.task == "position" else range(6)
    assert verdict(arm, T, q, one.all_q, asked=asked) == "rounding"
    # the twin is a row too, near by, and neither of them twice
    apart = np.sort(np.abs(around(one.all_q - q)).max(1))
    assert apart[0] < 3e-6 and 1e-6 < apart[1] < 1e-3 < apart[2]


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize("name", ["fanuc-r2000ic-165f", "universal-robots-ur5e", "three parallel, skew"])
def test_near_a_fold_both_are_told_however_near(name, side):
    """From 1e-7 to 1e-4 rad beside a fold, on either side of it: the joint vector is always found."""
    arm, rng = ARMS[name](), np.random.default_rng(14)
    q = np.repeat(singular_joints(arm, rng, 12), 7, axis=0)
    way = rng.standard_normal(q.shape)
    way /= np.linalg.norm(way, axis=1, keepdims=True)
    q = q + side * np.tile(10.0 ** np.linspace(-7, -4, 7), 12)[:, None] * way
    many = arm.ik_many(arm.fk(q), threads=1)
    apart = np.where(many.valid, np.abs(around(many.q - q[:, None])).max(-1), np.inf).min(1)
    assert np.all(apart < 1e-6 + 1e-14 / smallest(arm, q))
    assert np.all(many.status == 0)


@pytest.mark.parametrize(
    ("name", "q"),
    [
        (
            "unimation-puma-560",
            (-1.5274709621959912, -3.723018826141399, -1.5238185747841728)
            + (-0.9271897357743779, 1.5359309575821696, 3.9028502715503994),
        ),
        (
            "wrist at the end, RRR (quartic)",
            (-2.551163257949755, 4.087791808306462, -4.3015151504615226)
            + (-1.3454228358975187, -3.6059163166856685, 0.1135181925778918),
        ),
    ],
)
def test_where_rounding_just_tells_two_of_some_folds_apart_all_are_counted_once(name, q):
    """One of two twins told as a double root and the other as a root of its own came to an odd number: UNCERTAIN."""
    arm, q = ARMS[name](), np.array(q)
    T = arm.fk(q)
    one = arm.ik(T)
    assert one.status.name == "SOLVED" and arm.ik_many(T[None]).status[0] == one.status
    assert one.multiplicity.sum() == 8
    assert np.abs(around(one.all_q - q)).max(1).min() < 1e-6


#: Arm, and a joint vector 1e-7 to 2e-6 rad from a fold: where rounding only just tells its two solutions apart, or not.
JUST_TOLD = [
    (
        "motoman-ea1400n",
        (0.05504927565450003, 1.2156582413634696, 0.4015077522020782)
        + (2.8662329246606597, 1.5484464805173013, 1.2415162900269838),
    ),
    (
        "kinova-jaco-j2n6",
        (0.36964453241578393, 0.04956458277317862, -3.021232510337087)
        + (2.9812292031563605, -1.0939187372778172, 2.1351970988781255),
    ),
    (
        "motoman-ea1400n",
        (-1.229527343736146, 1.7978579866542563, -1.61388024578226)
        + (1.7386574976962827, 2.1206260225949247, -1.9156757184524875),
    ),
    (
        "motoman-ea1400n",
        (-2.228371687507652, 1.2734694168323593, -1.6865225203035876)
        + (0.4663818979912348, 1.9557926189463164, -2.854404919586988),
    ),
    (
        "fanuc-crx-10ia",
        (1.955419538348068, -2.281452044214881, -0.3631510177892872)
        + (-1.5828686639271237, -0.01392948477210902, 2.956206559194883),
    ),
    (
        "fanuc-r2000ic-165f",
        (-2.2872619116768136, -1.973818203879203, 1.7447999611216953)
        + (1.6044838460999098, 1.125723780711337, 0.21615693059197483),
    ),
    (
        "motoman-ea1400n",
        (0.15208658021131086, 2.235226698253536, -0.693541417030736)
        + (1.0541045926653514, -3.1105533949174586, -1.3653155515272175),
    ),
    (
        "universal-robots-ur5e",
        (1.2073419071462876, -1.6258955920931522, 3.141592619212913)
        + (3.1220530052490525, -0.9419073286956527, 2.6568111604909848),
    ),
    (
        "universal-robots-ur5e",
        (-0.2613980350916336, 2.7339363010811257, -3.1415926885607584)
        + (-1.151094835142495, 2.5026135428817526, -0.16982449887979234),
    ),
]


@pytest.mark.parametrize(("name", "q"), JUST_TOLD)
def test_at_the_border_of_rounding_a_fold_counts_two(name, q):
    """One row with two branches, or two rows of one each: not one simple row, nor three, nor one twice at a limit."""
    arm, q = pieper.load(name), np.array(q)
    arm = arm.with_limits({joint: (-np.pi, np.pi) for joint in arm.joint_names})
    T = arm.fk(q)
    one, many = arm.ik(T), arm.ik_many(T[None], threads=1)
    assert one.status.name == "SOLVED" and many.status[0] == one.status
    assert np.array_equal(one.all_q, many.q[0][many.valid[0]])
    assert one.multiplicity.sum() % 2 == 0
    here = np.abs(around(one.all_q - q)).max(1) < 1e-5
    assert one.multiplicity[here].sum() == 2
    apart = np.abs(around(one.all_q[:, None] - one.all_q)).max(-1) + 9 * np.eye(len(one.all_q))
    assert apart.min() > 1e-7
    assert np.abs(arm.fk(one.all_q) - T).max() < 5e-15


def _two_roots(arm, q):
    """Return a solution at a fold and its twin, by Newton's method from as far on the other side."""
    chain, T = arm.plan.exact.full, arm.fk(q)
    way = np.linalg.svd(scaled_jacobian(chain, q[None])[0])[2][-1]
    found = [newton(chain, q + side * 3e-6 * way, T, steps=60, cutoff=1e-14) for side in (1, -1)]
    return T, [q, max(found, key=lambda p: np.abs(p - q).max())]


@pytest.mark.parametrize(("name", "q"), JUST_TOLD)
def test_the_slow_look_counts_two_at_the_border_too(name, q):
    """Where one root stands for both, two branches merge in it; where both stay, limits a turn apart keep them two."""
    arm = pieper.load(name)
    arm = arm.with_limits({joint: (-np.pi, np.pi) for joint in arm.joint_names})
    chain = arm.plan.exact.full
    T, roots = _two_roots(arm, np.array(q))
    assert 1e-7 < chain.joints.apart(*roots) < 4e-6
    told = distinct_roots(chain, [(root, 1) for root in roots], T)
    assert sum(branches for _, branches in told) == 2
    placed = all_into_limits(chain, roots, T, arm.limits)
    assert chain.joints.apart(*placed) > 1e-7
