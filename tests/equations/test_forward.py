"""Forward kinematics as equations: right to 30 digits, gathered, readable, and the same in every notation."""

import gc
import json
import weakref
from pathlib import Path

import mpmath
import numpy as np
import pytest
import sympy

import pieper
from pieper.algebra.expression import Num
from pieper.description.dh import DH
from pieper.description.said import describe
from pieper.equations.forward import ForwardEquations, forward_matrices

PAPERS = json.loads((Path(__file__).parents[1] / "papers" / "data" / "forward_30_digits.json").read_text())["robots"]


def of_paper(name):
    data = PAPERS[name]
    rows = [DH(float(a), np.deg2rad(alpha), float(d), np.deg2rad(theta)) for _, a, alpha, d, theta in data["rows"]]
    types = "".join(row[0] for row in data["rows"])
    return describe(rows, convention=data["convention"], joint_types=types, name=name), data


@pytest.mark.parametrize("name", sorted(PAPERS))
def test_the_equations_agree_with_the_papers_arms_to_30_digits(name):
    description, data = of_paper(name)
    equations = ForwardEquations(description)
    for case in data["fk"]:
        with mpmath.workdps(60):
            q = [mpmath.mpf(x) * (mpmath.pi / 180 if kind == "R" else 1)
                 for x, kind in zip(case["q"], description.joint_types, strict=True)]  # fmt: skip
            pose = equations.evaluate_digits(q)
            for r in range(3):
                for c in range(4):
                    want = mpmath.mpf(case["pose"][r][c])
                    assert abs(pose[r][c] - want) <= 2e-29 * max(1, abs(want)), (case["q"], r, c)


@pytest.mark.parametrize("name", pieper.catalog())
@pytest.mark.parametrize("angles", ["theta", "q"])
def test_every_catalogue_arm_agrees_with_its_numeric_pose_in_both_notations(name, angles):
    arm = pieper.load(name)
    if angles == "q" and arm.description.coupling is not None:
        pytest.skip("coupled joints are no angles; tests/equations/test_coupled.py sees to them")
    for lengths in ("symbols", "numbers"):
        assert arm.symbolic.fk(lengths=lengths, angles=angles).check(40).worst < 1e-12


def test_sums_of_parallel_joints_are_gathered_and_differences_where_axes_oppose():
    equations = ForwardEquations(of_paper("denso_vp6242_seed000")[0])
    assert equations.pose[2, 3].text() == "d1 + a2*s2 + s23*(a3 - d6*c4*s5) + c23*(d4 + d6*c5)"
    assert equations.T(0, 3)[0, 0].text() == "c1*c23"
    opposed = ForwardEquations(of_paper("ea1400n_seed002_p2")[0])
    assert opposed.T(0, 3)[2, 3].text() == "d1 + a2*s2 + a3*s(2-3)"
    three = ForwardEquations(of_paper("rob0036_seed001_craig")[0])
    assert three.pose[2, 2].text() == "c234"


def test_the_lost_cosine_of_the_paper_is_there():
    """Seed 000 prints a3 C1 C3 in P_x where a3 C1 C2 C3 belongs; gathered, it is a3 c1 c23."""
    px = ForwardEquations(of_paper("denso_vp6242_seed000")[0]).pose[0, 3]
    assert px.text() == "c1*(a2*c2 - s23*(d4 + d6*c5) + c23*(a3 - d6*c4*s5)) + d6*s1*s4*s5"


def test_sympy_sees_the_same_matrix_as_the_product_of_its_own():
    description, _ = of_paper("fanuc_r2000ic165f_seed004")
    product = sympy.eye(4)
    for A in forward_matrices(description):
        product = product * A
    mine = ForwardEquations(description).sympy()
    values = {s: 0.1 + 0.37 * k for k, s in enumerate(sorted(product.free_symbols, key=str))}
    assert product.free_symbols == mine.free_symbols
    assert float((product - mine).subs(values).norm()) < 1e-14


def test_the_maker_s_zero_and_sense_are_shown_and_meant():
    rows = [DH(a=0.3, alpha=np.pi / 2), DH(a=0.2, theta=np.pi / 2), DH(d=0.1)]
    description = describe(rows, convention="standard", joint_types="RRP", sign=[1, -1, 1], offset=[0, 0, 0.05])
    arm = pieper.Arm(description)
    assert arm.symbolic.fk().relations() == ["theta2 = -q2 + pi/2", "d3 = q3 + 0.15"]
    assert arm.symbolic.fk(angles="q").relations() == []
    assert arm.symbolic.fk(angles="q").A[1][0, 0].text() == "s2"


def test_latex_and_mathml_stand_alone():
    equations = ForwardEquations(of_paper("vs6577_seed003_eq7")[0])
    latex, mathml = equations.latex(), equations.mathml()
    assert latex.count("{") == latex.count("}") and r"c_{23}" in latex
    assert latex.count(r"\left(") == latex.count(r"\right)")
    import xml.etree.ElementTree as tree

    tree.fromstring(f"<all>{mathml}</all>")
    assert "<script" not in mathml


def test_a_twist_that_is_no_quarter_turn_keeps_its_exact_cosine():
    description = describe([DH(alpha=np.deg2rad(55), d=0.1), DH(a=0.2)], convention="standard")
    equations = ForwardEquations(description)
    assert equations.meanings() == ["d1 = 0.1", "a2 = 0.2", "calpha1 = cos(11*pi/36)", "salpha1 = sin(11*pi/36)"]
    assert equations.A[0][1, 1].text() == "calpha1*c1"
    assert equations.A[0][3, 3] == Num(1)


def test_a_wrong_index_is_told():
    with pytest.raises(pieper.InputError, match="0 <= i < j"):
        ForwardEquations(of_paper("threeR_seed002_p4")[0]).T(2, 1)
    with pytest.raises(pieper.InputError, match="lengths"):
        ForwardEquations(of_paper("threeR_seed002_p4")[0], lengths="some")


def test_equations_live_no_longer_than_their_arm():
    arm = pieper.load("denso-vp6242")
    for made in (arm.symbolic.fk(), arm.symbolic.jacobian(), arm.symbolic.singularities(), arm.symbolic.ik()):
        assert made.text() and made.markdown() and made.json()["blocks"]
    gone = weakref.ref(arm)
    del arm, made
    gc.collect()
    assert gone() is None


def test_equations_are_made_once():
    symbolic = pieper.load("three-r").symbolic
    assert symbolic.fk() is symbolic.fk()
    assert symbolic.fk(lengths="numbers") is not symbolic.fk()
    assert symbolic.ik() is symbolic.ik()


def test_a_partial_product_too_wide_for_a_page_is_shown_entry_by_entry():
    """Browsers shrink every page of a report for one matrix that sticks out of it."""
    twists, lengths = [1.1, 0.3, -1.2, 0.9, -0.7, 0.4], [0.1, 0.4, 0.3, 0.05, 0.1, 0.02]
    rows = [pieper.DH(a, twist, 0.2) for a, twist in zip(lengths, twists, strict=True)]
    general = pieper.Arm.from_dh(rows, convention="standard", name="general").symbolic.fk()
    assert "T03,11 = " in general.text() and "T03 = [" not in general.text()
    assert "T03,11" not in pieper.load("denso-vp6242").symbolic.fk().text()
