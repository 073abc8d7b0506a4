"""What real pages write: entries of matrices, degrees, LaTeX, NumPy, branches in a list, Jacobians, and excerpts."""

from __future__ import annotations

import pytest

import pieper
from pieper.algebra.parser import parse
from pieper.judge.verdict import HOLDS, PARTLY, WRONG
from tests.judge.planted.short_arms import two_links

SIX = """
[arm]
name = "six"
convention = "standard"
length_unit = "m"
columns = ["theta", "d", "a", "alpha"]
rows = [["q1", "d1", 0, "90 deg"], ["q2", 0, "a2", 0], ["q3", 0, "a3", "-90 deg"],
        ["q4", "d4", 0, "90 deg"], ["q5", 0, 0, "-90 deg"], ["q6", "d6", 0, 0]]
values = { d1 = 0.125, a2 = 0.21, a3 = 0.075, d4 = 0.22, d6 = 0.07 }
[symbols]
r = "hypot(P05x, v)"
P05x = "px - d6*r13"
v = "(T A6^-1)[2,4]"
[matrices]
Rc = [["c1", "-s1", 0], ["s1", "c1", 0], [0, 0, 1]]
"""
TWO = two_links(0.43, 0.31)
NAMES = {"a1", "a2", "d4", "px", "py", "P05x", "d7e", "lambda1", "beta"}


def verdict(head: str, claim: str):
    return pieper.check(f"{head}\n[[claim]]\nid = 'x'\n{claim}\n").verdicts[0]


@pytest.mark.parametrize(
    ("text", "reads"),
    [
        (r"\theta_1 + \theta_{2}", "theta1 + theta2"),
        (r"\frac{a_1 c_{23}}{2 a_2}", "a1 c23/(2 a2)"),
        (r"\frac12 p_x", "1/2 px"),
        (r"\sqrt{p_x^2+p_y^2-d_4^{2}}", "sqrt(px^2 + py^2 - d4^2)"),
        (r"\cos^{-1}\left(\frac{p_x}{a_2}\right)", "acos(px/a2)"),
        (r"\operatorname{atan2}(p_y, p_x) \pm \arccos\frac{a_1}{a_2}", "atan2(py, px) +- acos(a1/a2)"),
        (r"\text{Atan2}(p_y,p_x)", "atan2(py, px)"),
        (r"c\theta_1 s\theta_2", "c1 s2"),
        (r"c_{\theta_1} + s_{q_2}", "c1 + s2"),
        (r"\sin^2\theta_1", "s1^2"),
        (r"-\sin\theta_1\,d_4", "-s1 d4"),
        (r"90^\circ - \theta_2", "90 (pi/180) - theta2"),
        (r"\left|p_x\right|", "abs(px)"),
        ("cos θ₁ + a₂ cos(θ₁+θ₂)", "c1 + a2 c12"),
        ("cθ1 sθ2", "c1 s2"),
        ("½ px", "1/2 px"),
        ("px² + λ1 β", "px^2 + lambda1 beta"),
        ("theta234 - theta23", "theta2 + theta3 + theta4 - (theta2 + theta3)"),
        ("P05x + d7e", "P05x + d7e"),
        ("np.cos(theta1)*a1 + np.arctan2(py, px)", "c1 a1 + atan2(py, px)"),
        ("a1.*cos(t1) + math.sqrt(px**2)", "a1 c1 + sqrt(px^2)"),
        ("atan2d(py, px)", "atan2(py, px)/(pi/180)"),
    ],
)
def test_spellings_are_read(text, reads):
    assert str(parse(text, NAMES, 6)) == reads


@pytest.mark.parametrize(
    ("joint", "text", "status"),
    [
        (5, "+-acos(R36[3,3])", HOLDS),
        (5, r"\\pm \\arccos R36_{33}", HOLDS),
        (5, "+-acos((R03^T R06)[3,3])", HOLDS),
        (5, "+-acos(R36(3,3))", HOLDS),
        (5, "+-acos(R36[3,2])", WRONG),
        (4, "atan2(-R36[2,3] sign(s5), -R36[1,3] sign(s5))", HOLDS),
        (4, "atan2(-R36[2,3], -R36[1,3])", PARTLY),
        (1, "atan2(v, P05x) + pi/2 -+ pi/2", HOLDS),
        (3, "atan2(R36[2,3], R36[1,3])", WRONG),
    ],
)
def test_entries_of_matrices_stand_in_formulas(joint, text, status):
    assert verdict(SIX, f'kind = "joint"\njoint = {joint}\nis = "{text}"').status == status


@pytest.mark.parametrize(
    ("claim", "status"),
    [
        ('kind = "entry"\nof = "r33"\nis = "(Rz(pi) T)[3,3]"', HOLDS),
        ('kind = "entry"\nof = "r32"\nis = "cos(pitch) sin(roll)"', HOLDS),
        ('kind = "entry"\nof = "px"\nis = "p_x = (A1 A2 A3 A4 A5 A6)[1,4]"', HOLDS),
        ('kind = "equation"\nis = "norm(P04 - P01)^2 = a2^2 + a3^2 + d4^2 + 2a2(a3c3 - d4s3)"', HOLDS),
        ('kind = "equation"\nis = "norm(P04 - P01)^2 = a2^2 + a3^2 + d4^2 + 2a2(a3c3 + d4s3)"', WRONG),
        ('kind = "equation"\nis = "(Rc R03)[3,3] = R03[3,3]"', HOLDS),
    ],
)
def test_products_norms_and_matrices_of_ones_own(claim, status):
    assert verdict(SIX, claim).status == status


LAW = "(px^2 + py^2 - a1^2 - a2^2)/(2a1a2)"


@pytest.mark.parametrize(
    ("claim", "status"),
    [
        (f'is = ["acos({LAW})", "theta_2 = -acos({LAW})"]', HOLDS),
        (f'is = ["acos({LAW})", "acos({LAW})"]', PARTLY),
        (f'unit = "deg"\nis = "+-(180 - acos(-{LAW}))"', HOLDS),
        (f'unit = "deg"\nis = "+-(180 - acosd(-{LAW}))"', HOLDS),
        (f'unit = "deg"\nis = "+-(90 - acos({LAW}))"', WRONG),
    ],
)
def test_branches_in_a_list_and_formulas_in_degrees(claim, status):
    assert verdict(TWO, f'kind = "joint"\njoint = 2\ntask = "position"\n{claim}').status == status


@pytest.mark.parametrize(
    ("claim", "status"),
    [
        ('kind = "determinant"\nis = "a1 a2 s2"', HOLDS),
        ('kind = "determinant"\nis = "-a1 a2 s2"', HOLDS),
        ('kind = "determinant"\nis = "a1 a2 s1"', WRONG),
        ('kind = "jacobian"\nis = [["-a1 s1 - a2 s12", "-a2 s12"], ["a1 c1 + a2 c12", "a2 c12"]]', HOLDS),
        ('kind = "jacobian"\nis = [["-a1 s1 - a2 s12", "a2 s12"], ["a1 c1 + a2 c12", "a2 c12"]]', WRONG),
        ('kind = "jacobian"\nof = "J[6,1]"\nis = "1"', HOLDS),
        ('kind = "singular"\nis = "sin(theta2) = 0"', HOLDS),
        ('kind = "singular"\nis = "theta2 = pi/2"', WRONG),
    ],
)
def test_jacobians_determinants_and_singularities(claim, status):
    assert verdict(TWO, claim).status == status


EXCERPT = r"""
\begin{equation} T_{06} = A_1 A_2 A_3 A_4 A_5 A_6 \tag{3} \end{equation}
\begin{align} u &= p_x - d_6 a_x \\ v &= p_y - d_6 a_y \\
\theta_5 &= \pm\arccos\left(a_z c_{23} - a_x c_1 s_{23} - a_y s_1 s_{23}\right) \tag{39} \end{align}
Therefore \theta_1 = \operatorname{atan2}(v, u), for u > 0
\[ A_1 = \begin{bmatrix} c_1 & 0 & s_1 & 0 \\ s_1 & 0 & -c_1 & 0 \\ 0 & 1 & 0 & d_1 \\ 0 & 0 & 0 & 1 \end{bmatrix} \]
foo = \unknown{3} + bar
"""


def test_claims_are_guessed_from_an_excerpt_and_can_be_judged():
    text, read, missed = pieper.guess_claims(EXCERPT, "denso-vp6242", "page.tex")
    assert (read, missed) == (6, 1)
    assert "not read: foo" in text
    judged = pieper.check(text)
    kinds = {v.id: v.status for v in judged.verdicts}
    assert kinds["3"] == kinds["39"] == HOLDS
    assert len(kinds) == 4


def test_symbols_may_be_defined_in_any_order():
    head = TWO + '[symbols]\nb = "a + px"\na = "py"\n'
    assert verdict(head, 'kind = "equation"\nis = "b = px + py"').status == HOLDS


OWN_PAGES = [
    "denso-vp6242",
    "unimation-puma-560",
    "universal-robots-ur5e",
    "stanford-arm",
    "adept-cobra-600",
    "three-r",
]
OWN_PAGES += ["rrp-wrist", "franka-panda", "staubli-rx160", "abb-irb2400"]


@pytest.mark.parametrize("name", OWN_PAGES)
@pytest.mark.parametrize("form", ["text", "latex"])
def test_the_judge_reads_the_derivation_that_pieper_prints_and_finds_it_right(name, form):
    page = getattr(pieper.load(name).symbolic.ik(), form)()
    file, read, _ = pieper.guess_claims(page, name, "pieper's own page")
    judged = pieper.check(file)
    assert read >= 8 and len(judged.verdicts) >= pieper.load(name).n
    assert all(v.holds for v in judged.verdicts), judged.text()


def test_a_sign_of_a_page_is_the_same_in_all_its_formulas():
    page = pieper.load("denso-vp6242").symbolic.ik().text()
    wrong = page.replace("atan2(-sigma3*u23, -sigma3*u13)", "atan2(sigma3*u23, sigma3*u13)")
    assert wrong != page
    judged = pieper.check(pieper.guess_claims(wrong, "denso-vp6242", "a page")[0])
    (bad,) = [v for v in judged.verdicts if not v.holds]
    assert "theta4" in bad.claim and bad.wrong
