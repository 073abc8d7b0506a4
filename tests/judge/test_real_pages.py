"""What real pages write: entries of matrices, degrees, LaTeX, NumPy, branches in a list, Jacobians, and excerpts."""

from __future__ import annotations

import tomllib

import numpy as np
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


PRINTED = r"""
θ4 = atan2(c1 r23 - s1 r13, c1 c23 r13 + c23 r23 s1 + r33 s23), sin(θ5) ≠ 0
c5 = r33 c23 - r13 c1 s23 - r23 s1 s23
\theta_5 = \arccos(c_5), \qquad \text{if } s_5 > 0
The determinant is $\det J = 0$. It is singular when $s_5 = 0$.
Then $w = h^2$ where $h = p_z - d_1$.
A1=
[c1, 0, s1, 0],
[s1, 0, -c1, 0],
[0,  1, 0,  0.125],
[0,  0, 0,  1]
A6 = np.array([[np.cos(q6), -np.sin(q6), 0, 0], [np.sin(q6), np.cos(q6), 0, 0], [0, 0, 1, 0.07], [0, 0, 0, 1]])
"""


def test_an_excerpt_has_conditions_singular_places_sines_on_the_way_and_matrices():
    text, read, missed = pieper.guess_claims(PRINTED, "denso-vp6242", "page")
    claims = {c["id"]: c for c in tomllib.loads(text)["claim"]}
    assert (read, missed) == (9, 0), text
    assert claims["line 2"]["kind"] == "joint" and "when" not in claims["line 2"]
    assert claims["line 4"] == {
        "id": "line 4",
        "kind": "joint",
        "joint": 5,
        "is": "acos((r33 c23 - r13 c1 s23 - r23 s1 s23))",
        "when": "s_5 > 0",
    }
    assert claims["line 5"]["kind"] == "singular" and claims["line 5'"]["kind"] == "determinant"
    assert claims["line 7"]["of"] == "A1" and claims["line 12"]["of"] == "A6"
    assert tomllib.loads(text)["symbols"] == {"w": "h^2", "h": "p_z - d_1"}


TABLE = """
[arm]
name = "two joints, a constant turn and a gripper"
convention = "{convention}"
length_unit = "m"
columns = ["theta", "d", "a", "alpha"]
rows = [["q1", "e1", 0, "90 deg"], ["90 deg", 0, "e2", "-90 deg"], ["q2", 0, "e3", 0], [0, "e4", 0, 0]]
values = {{ e1 = 0.4, e2 = 0.3, e3 = 0.2, e4 = 0.1 }}
"""


@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_constant_rows_of_a_table_go_with_the_joint_above_them(convention):
    head = TABLE.format(convention=convention)
    rows = [(0.7, 0.4, 0, 90), (np.pi / 2, 0, 0.3, -90), (-1.1, 0, 0.2, 0), (0, 0.1, 0, 0)]
    T = np.eye(4)
    for theta, d, a, alpha in rows:
        Z, X, r = np.eye(4), np.eye(4), np.radians(alpha)
        Z[:2, :2], Z[2, 3] = [[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]], d
        X[1:3, 1:3], X[0, 3] = [[np.cos(r), -np.sin(r)], [np.sin(r), np.cos(r)]], a
        T = T @ (Z @ X if convention == "standard" else X @ Z)
    position = ", ".join(f'"{v:.6f}"' for v in T[:3, 3])
    assert verdict(head, f'kind = "pose"\nq_rad = [0.7, -1.1]\nunit = "m"\nposition = [{position}]').status == HOLDS
    # the first row's quarter turn about x comes before joint 1 in Craig's convention
    entry, value = ("J[6,1]", 1) if convention == "standard" else ("J[5,1]", -1)
    assert verdict(head, f'kind = "jacobian"\nof = "{entry}"\nis = "{value}"').status == HOLDS
    assert (
        verdict(
            head, 'kind = "product"\nis = "cross(R01[:,3], P02 - P01) = cross(R01[:,3], P02) - cross(R01[:,3], P01)"'
        ).status
        == HOLDS
    )
    with pytest.raises(pieper.InputError, match="write q2, not theta3"):
        verdict(head.replace('"q2"', '"q3"'), 'kind = "count"\ncount = 1')


@pytest.mark.parametrize(
    ("claim", "status"),
    [
        ('kind = "product"\nis = "cross(R02[:,3], P06 - P02) = J[1:3,3]"', HOLDS),
        ('kind = "product"\nis = "cross(P06 - P02, R02[:,3]) = J[1:3,3]"', WRONG),
        ('kind = "equation"\nis = "dot(R01[:,3], P02 - P01) = 0"', HOLDS),
        ('kind = "equation"\nis = "norm(cross(R00[:,3], P06)) = hypot(px, py)"', HOLDS),
        ('kind = "equation"\nis = "cross(R00[:,3], P06)[1] = -py"', HOLDS),
        ('kind = "equation"\nis = "(M^-1 g)[2] = M2[1,1]"', HOLDS),
        ('kind = "entry"\nof = "px"\nis = "pow(px, 3)/px**2"', HOLDS),
        ('kind = "joint"\njoint = 6\nis = "np.deg2rad(np.degrees(theta6 + 0*px))"', WRONG),
    ],
)
def test_cross_products_columns_and_small_matrices(claim, status):
    more = '[matrices]\nM = [["c1", "-s1"], ["s1", "c1"]]\ng = [["px"], ["py"]]\nM2 = [["c1 py - s1 px"]]\n'
    assert verdict(SIX.replace("[matrices]\n", more), claim).status == status


@pytest.mark.parametrize(
    ("text", "reads"),
    [
        ("pow(px, 2)", "px^2"),
        ("np.degrees(theta1)", "theta1/(pi/180)"),
        ("90 degrees (px)", "90 (pi/180) px"),
        ("math.radians(30)", "30 (pi/180)"),
        ("wrapToPi(theta1)", "atan2(sin(theta1), cos(theta1))"),
        ("fmod(px, pi)", "fmod(px, pi)"),
    ],
)
def test_functions_of_programs(text, reads):
    said = str(parse(text, NAMES, 6))
    assert said.replace("s1", "sin(theta1)").replace("c1", "cos(theta1)") == reads


@pytest.mark.parametrize(
    ("kind", "claim", "words"),
    [
        ("singular", "px^2 + py^2 = 0", "loses rank at 40 of 40"),
        ("singular", "c3 + 2 = 0", "the smallest value met is 1"),
        ("joint", "theta1", "(rear)"),
        ("joint", "theta3", "the elbow's bend"),
    ],
)
def test_sides_of_the_arm_name_regions_and_touching_zeros_are_found(kind, claim, words):
    head = SIX[: SIX.index("[symbols]")]
    three = head
    law = "(px^2 + py^2 + (pz - d1)^2 - a2^2 - a3^2 - d4^2)/(2 a2 hypot(a3, d4))"
    text = {
        "theta1": 'joint = 1\nis = "atan2(-py, -px)"\nframe = "T05"',
        "theta3": f'joint = 3\nframe = "T05"\nis = "atan2(-d4, a3) + acos({law})"',
    }.get(claim, f'is = "{claim}"\nrows = [1, 2, 3]')
    if kind == "singular":
        three = (
            TABLE.format(convention="standard")
            .replace('["90 deg", 0, "e2", "-90 deg"], ', "")
            .replace('[0, "e4", 0, 0]', '["q3", 0, "e2", 0]')
        )
    found = verdict(three, f'kind = "{kind}"\n{text}')
    assert words in found.sentence + str(found.details), (found.sentence, found.details)
