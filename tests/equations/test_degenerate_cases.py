"""Every degenerate case that a page names is visited and compared with the solver: no false sentence."""

import numpy as np
import pytest

import pieper
from pieper import DH
from pieper.equations.derivation.degenerate import ELSEWHERE, FREE, IMPOSSIBLE, UNREACHED

PI = np.pi
NAMES = """
    abb-irb140 abb-irb2400 adept-cobra-600 denso-vp6242 denso-vs6577 dfrobot-rob0036 dfrobot-rob0036-as-printed
    fanuc-cr-35ia kuka-lbr-iiwa-14-r820 rrp-wrist stanford-arm staubli-rx160 three-r unimation-puma-560
    universal-robots-ur5e
""".split()
WRIST = [DH(alpha=PI / 2, d=0.4), DH(alpha=-PI / 2), DH(d=0.1)]

FIVE = [DH(d=0.3, alpha=PI / 2), DH(a=0.25), DH(a=0.21), DH(alpha=PI / 2), DH(d=0.12)]


def built(rows):
    return pieper.Arm.from_dh(rows, convention="standard")


BUILDS = {
    "five axes": lambda: built(FIVE),
    "equal links": lambda: built([DH(d=0.4, alpha=PI / 2), DH(a=0.4), DH(alpha=PI / 2), *WRIST]),
    "offset shoulder": lambda: built([DH(a=0.1, alpha=PI / 2, d=0.4), DH(a=0.5), DH(a=0.05, alpha=-PI / 2), *WRIST]),
    "side offset": lambda: built([DH(alpha=PI / 2, d=0.4), DH(a=0.5, d=0.15), DH(alpha=PI / 2), *WRIST]),
}


@pytest.fixture(scope="module", params=[*NAMES, *BUILDS])
def page(request):
    arm = BUILDS[request.param]() if request.param in BUILDS else pieper.load(request.param)
    return arm, arm.symbolic.ik()


def asked(T, given):
    return T[..., :3, ["noap".index(c) for c in given]]


def test_the_formulas_are_right_at_every_degenerate_posture(page):
    arm, ik = page
    for number, case in ik.form.cases.items():
        if case.kind not in (FREE, ELSEWHERE):
            continue
        T = arm.fk(case.postures)
        found = ik.evaluate(T, chosen=case.postures)
        gap = np.abs(np.angle(np.exp(1j * (found - case.postures)))).max(axis=2)
        assert (np.nanmin(gap, axis=0) < 1e-4).all(), (number, case.kind)
        real = np.isfinite(found).all(axis=2)
        back = arm.fk(np.nan_to_num(found))
        miss = np.abs(asked(back, ik.form.given) - asked(T, ik.form.given)).max(axis=(2, 3))
        assert miss[real].max() < 1e-5, (number, case.kind)


def test_the_solver_agrees_on_what_is_free(page):
    arm, ik = page
    for case in ik.form.cases.values():
        if ik.form.chosen or case.kind not in (FREE, ELSEWHERE):
            continue
        for q in case.postures[:2]:
            sols = arm.ik(arm.fk(q))
            if case.kind == FREE:
                assert sols.self_motions
            elif not sols.self_motions:
                rows = ik.evaluate(arm.fk(q)[None])[:, 0]
                for row in sols.all_q:
                    gap = np.abs(np.angle(np.exp(1j * (rows - row)))).max(axis=1)
                    assert np.nanmin(gap) < 1e-4


def test_what_cannot_be_is_met_by_no_posture(page):
    arm, ik = page
    q = np.random.default_rng(8).uniform(-PI, PI, (4000, arm.n))
    from pieper.equations.derivation.degenerate import _vanishing

    for number, case in ik.form.cases.items():
        if case.kind in (IMPOSSIBLE, UNREACHED):
            gap = np.abs(_vanishing(ik.form, ik.steps[number - 1], q)).max(axis=1)
            assert gap.min() > 1e-4
            assert "is free" not in ik.text().split(f"Step {number}:")[1].split("Step ")[0]


@pytest.mark.parametrize(
    ("name", "words"),
    [("unimation-puma-560", "0 = d3"), ("universal-robots-ur5e", "0 = d4"), ("stanford-arm", "out of reach")],
)
def test_a_pose_on_the_axis_of_the_first_joint_is_out_of_reach_of_an_offset_shoulder(name, words):
    arm = pieper.load(name)
    text = arm.symbolic.ik().text()
    assert words in text.split("Step 2:")[0]
    T = arm.fk(np.full(arm.n, 0.3))
    step = arm.symbolic.ik().steps[0]
    assert step.symbol.name == "theta1"
    if name == "unimation-puma-560":
        T[:2, 3] = 0
        assert not len(arm.ik(T).all_q)
        assert np.isnan(arm.symbolic.ik().evaluate(T)).any(axis=2).all()


@pytest.mark.parametrize(
    ("name", "said", "not_said"),
    [
        ("adept-cobra-600", "All axes are parallel", "meet in a point"),
        ("dfrobot-rob0036", "Axes 2, 3 and 4 are parallel", "meet in a point"),
    ],
)
def test_an_arm_with_few_joints_is_explained_as_itself(name, said, not_said):
    head = pieper.load(name).symbolic.ik().text().split("Step 1")[0]
    assert said in head and not_said not in head


def test_a_five_axis_arm_with_a_wrist_is_not_told_that_no_axes_meet():
    rows = [DH(0, -PI / 2, 0.1), DH(0.2), DH(0, PI / 2), DH(0, -PI / 2), DH(0.15)]
    arm = built(rows)
    ik = arm.symbolic.ik()
    assert ik.closed and "Axes 3, 4 and 5 meet in a point" in ik.text()
    found = ik.check(6)
    assert found.holds and found.valid == found.real, found.what


def test_the_count_said_is_met_and_never_passed():
    for name in ("adept-cobra-600", "dfrobot-rob0036", "three-r"):
        arm = pieper.load(name)
        words = arm.symbolic.ik().text()
        most = int(words.split("A pose has at most ")[1].split()[0])
        q = np.random.default_rng(4).uniform(-2, 2, (60, arm.n))
        counts = [len(arm.ik(T).all_q) for T in arm.fk(q)]
        assert max(counts) == most, (name, max(counts), most)


def test_with_the_tool_straight_down_another_equation_decides_the_first_joint():
    arm = BUILDS["five axes"]()
    ik = arm.symbolic.ik(task="pose")
    (case,) = [c for c in ik.form.cases.values() if c.kind == ELSEWHERE]
    assert "Another equation decides it" in ik.text()
    T = arm.fk(case.postures)
    found = ik.evaluate(T)
    back = arm.fk(np.nan_to_num(found))
    real = np.isfinite(found).all(axis=2)
    assert real.any(axis=0).all()
    assert np.abs(back - T)[real].max() < 1e-6
