"""Excerpts as books print them: numbers of equations, several a line, branches, indices before letters, own letters."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import pieper
from pieper import DH
from pieper.judge.excerpt_lines import apart, numbered
from pieper.judge.verdict import HOLDS, PARTLY, WRONG

PX = "cos(t1)*(a2*cos(t2) + a3*cos(t2+t3))"
PLAIN = f"""px = {PX}          (7.1)
pz = d1 + a2*sin(t2) + a3*sin(t2+t3)   [12]
(6) theta2 + theta3 = atan2(nz, oz)
py = sin(t1)*(a2*cos(t2) + a3*cos(t2+t3))   Eq. (5)
c3 = (px^2+py^2+(pz-d1)^2-a2^2-a3^2)/(2 a2 a3),  s3 = +-sqrt(1-c3^2)
theta3 = atan2(s3, c3)
"""
LATEX = r"""with $r^2 = p_x^2+p_y^2$ and $D = \frac{r^2 + (p_z-d_1)^2 - a_2^2 - a_3^2}{2 a_2 a_3}$
\[ {}^0_1T = \begin{pmatrix} c_1 & 0 & s_1 & 0 \\ s_1 & 0 & -c_1 & 0 \\ 0 & 1 & 0 & d_1 \\ 0&0&0&1\end{pmatrix} \]
\[ \theta_3 = \begin{cases} +\arccos D & \text{elbow up} \\ -\arccos D & \text{elbow down}\end{cases} \]
\[ \theta_2 = \operatorname{atan2}(p_z - d_1, r) - \operatorname{atan2}(a_3 s_3, a_2 + a_3 c_3) \]
"""
OWN = "px = cos(t1)*(l_2*cos(t2) + l_3*cos(t2+t3)), pz = l_1 + l_2*sin(t2) + l_3*sin(t2+t3)\n"
OTHER = "px = cos(t1)*(l_2*cos(t2) - l_3*cos(t2+t3)), pz = l_1 - l_2*sin(t2)\n"
PLACE = f"x = {PX} (2.1)\ny = sin(t1)*(a2*cos(t2) + a3*cos(t2+t3)) (2.2)\ntheta1 = atan2(y, x)\n"


def judged(text: str, robot: str) -> dict[str, str]:
    return {v.id: v.status for v in pieper.check(pieper.guess_claims(text, robot, "page")[0]).verdicts}


@pytest.mark.parametrize(
    ("piece", "bare", "tag"),
    [
        ("px = a1 c1 (7.1)", "px = a1 c1", "7.1"),
        ("px = a1 c1, (3.7a)", "px = a1 c1", "3.7a"),
        ("px = a1 c1  [12]", "px = a1 c1", "12"),
        ("px = a1 c1   Eq. (5).", "px = a1 c1", "5"),
        (r"px = a1 c1 \tag{3}", "px = a1 c1", "3"),
        ("(6) px = a1 c1", "px = a1 c1", "6"),
        ("7. theta1 = atan2(py, px)", "theta1 = atan2(py, px)", "7"),
        ("Eq. 4: px = a1 c1", "px = a1 c1", "4"),
        ("px = a1 c(12)", "px = a1 c(12)", ""),
        ("px = P05[1]", "px = P05[1]", ""),
        ("px = R36(3)", "px = R36(3)", ""),
        ("2 px = a1 c1", "2 px = a1 c1", ""),
        ("px = a1 (c1 + 2)", "px = a1 (c1 + 2)", ""),
    ],
)
def test_the_number_of_an_equation_is_no_part_of_it(piece, bare, tag):
    got, said = numbered(piece)
    assert (got.strip(" ,"), said) == (bare, tag)


@pytest.mark.parametrize(
    ("piece", "parts"),
    [
        ("c3 = f, s3 = g", ["c3 = f", "s3 = g"]),
        ("px = atan2(py, px), py = 2", ["px = atan2(py, px)", "py = 2"]),
        ("px = r c1 and py = r s1", ["px = r c1", "py = r s1"]),
        (r"px = r c1 \quad py = r s1", ["px = r c1", "py = r s1"]),
        ("theta1 = atan2(v, u), for u > 0", ["theta1 = atan2(v, u), for u > 0"]),
        ("theta1 = atan2(v, u), when s5 = 0", ["theta1 = atan2(v, u), when s5 = 0"]),
        ("theta1 = atan2(v, u) where u = px", ["theta1 = atan2(v, u)", "u = px"]),
    ],
)
def test_equations_beside_each_other_are_two(piece, parts):
    assert [part.strip(" ,") for part in apart(piece)] == parts


def test_right_lines_of_a_plain_page_are_not_called_wrong(robot):
    status = judged(PLAIN, robot)
    assert [status[k] for k in ("7.1", "12", "6", "5", "line 5")] == [HOLDS] * 5
    assert set(status.values()) <= {HOLDS, PARTLY}


def test_branches_symbols_by_their_square_and_indices_before_the_letter_are_read(robot):
    text, _, missed = pieper.guess_claims(LATEX, robot, "page")
    assert missed == 0 and 'r = "sqrt(' in text and 'of = "T01"' in text
    assert {"line 2": HOLDS, "line 3": HOLDS}.items() <= judged(LATEX, robot).items()


def test_lengths_of_the_pages_own_naming_are_found_where_one_reading_makes_it_right(robot):
    text = pieper.guess_claims(OWN, robot, "page")[0]
    assert all(line in text for line in ('l1 = "d1"', 'l2 = "a2"', 'l3 = "a3"'))
    assert set(judged(OWN, robot).values()) == {HOLDS}


def test_where_no_reading_does_the_letters_are_named_and_nothing_is_claimed(robot):
    text, read, missed = pieper.guess_claims(OTHER, robot, "page")
    assert "no length of this arm" in text and (read, missed) == (0, 2)


def test_x_and_y_are_the_tools_place(robot):
    status = judged(PLACE, robot)
    assert status["2.1"] == status["2.2"] == HOLDS and len(status) == 3


def test_a_matrix_with_a_letter_that_nobody_knows_is_not_claimed(robot):
    text = r"A_1 = \begin{bmatrix} c_1 & 0 & w_9 & 0 \\ s_1 & 0 & -c_1 & 0 \\ 0 & 1 & 0 & d_1 \\ 0&0&0&1 \end{bmatrix}"
    assert "[[claim]]" not in pieper.guess_claims(text, robot, "page")[0]


@pytest.mark.parametrize("left", [r"\det J_v", r"\det(J_v)", r"\det J", "|J|", "|J(q)|", "det(J)"])
def test_a_determinant_is_read_beside_what_is_said_of_singular_places(left, robot):
    text = (
        f"The determinant is ${left} = -a_2 a_3 s_3 (a_2 c_2 + a_3 c_{{23}})$, and the arm is singular when $s_3=0$, "
        "and also when $a_2 c_2 + a_3 c_{23} = 0$."
    )
    claims = pieper.guess_claims(text, robot, "page")[0]
    assert list(judged(text, robot).values()) == [HOLDS, HOLDS]
    assert claims.count('kind = "determinant"') == claims.count('kind = "singular"') == 1


def test_a_robot_file_may_be_a_path(robot):
    assert pieper.guess_claims(PLAIN, Path(robot), "page") == pieper.guess_claims(PLAIN, robot, "page")


@pytest.mark.parametrize("kind", ["text", "latex"])
@pytest.mark.parametrize(
    "rows",
    [
        [DH(0.1, np.pi / 2, 0.2), DH(0.3, 0, 0.1), DH(0.05, np.pi / 2), DH(0, 1.0, 0.3), DH(0, -0.8), DH(d=0.1)],
        [DH(0.1, 1.1, 0.2), DH(0.3, -0.7, 0.1), DH(0.2, 0, 0.05)],
    ],
    ids=["wrist", "quartic"],
)
def test_derivations_of_odd_twists_are_read_and_hold(rows, kind, tmp_path):
    """Twists are letters of their own, a quartic's last term is no equation, and a definition has the pose in it."""
    arm = pieper.Arm.from_dh(rows, convention="standard", name="odd")
    arm.save(tmp_path / "odd.toml")
    verdicts = judged(getattr(arm.symbolic.ik(), kind)(), str(tmp_path / "odd.toml"))
    assert len(verdicts) >= 6 and set(verdicts.values()) == {HOLDS}


COURSE = r"""
\begin{align*}
p_x &= l_1 \cos \theta_1 + l_2 \cos(\theta_1 + \theta_2) \\
p_y &= l_1 \sin \theta_1 + l_2 \sin(\theta_1 + \theta_2)
\end{align*}
\[ \cos\theta_2 = \frac{p_x^2 + p_y^2 - l_1^2 - l_2^2}{2 l_1 l_2} \equiv D \]
\[ \sin\theta_2 = \pm\sqrt{1 - D^2} \]
where $k_1 = l_1 + l_2 c_2$ and $k_2 = l_2 s_2$,
so $\theta_1 = \operatorname{Atan2}(p_y, p_x) - \operatorname{Atan2}(k_2, k_1)$.
$$ T_2^0 = A_1 A_2 $$
"""


@pytest.fixture(scope="module")
def two(tmp_path_factory):
    file = tmp_path_factory.mktemp("robots") / "two.toml"
    pieper.Arm.from_dh([DH(a=0.35), DH(a=0.3)], convention="standard", name="two").save(str(file))
    return str(file)


def test_a_course_page_is_read_whole(two):
    text, _, lost = pieper.guess_claims(COURSE, two, "page")
    assert not lost
    assert {v.status for v in pieper.check(text).verdicts} == {HOLDS}


def test_what_rests_on_a_symbol_that_was_not_read_is_not_read_either(robot):
    page = "k_1 = l_7 c_2\nk_2 = k_1 + 1\nr = sqrt(k_1^2 + k_2^2)\ntheta1 = atan2(py, px) + 0 r\n"
    text, _, lost = pieper.guess_claims(page, robot, "page")
    assert lost == 4
    assert "[[claim]]" not in text
    assert "no length of this arm" in text


def test_one_sign_or_the_other_makes_an_equation_hold_and_a_wrong_one_not(two):
    def verdict(equation: str) -> str:
        arm = f'[arm]\nfile = "{two}"\n[[claim]]\nkind = "equation"\nis = "{equation}"\n'
        return pieper.check(arm).verdicts[0].status

    assert verdict("s2 = +-sqrt(1 - c2^2)") == HOLDS
    assert verdict("px = a1 c1 + a2 (c1 c2 +- s1 sqrt(1 - c2^2))") == HOLDS
    assert verdict("s2 = +-sqrt(1 + c2^2)") == WRONG
    assert verdict("s2 = +-sqrt(1 - c1^2)") == WRONG
    assert verdict("s2 = +-sqrt(1 - c2^2) + 1e-9") == WRONG


def guessed(text, robot):
    """The claims file that is guessed from a text."""
    return pieper.guess_claims(text, robot, "page")[0]


def test_a_page_of_code_and_a_page_in_markdown_are_read():
    text = """function q = ik(T)
  d6 = 0.07;
  wx = T(1,4) - d6*T(1,3);
  wy = T(2,4) - d6*T(2,3);
  q1 = atan2(wy, wx);
end
There are eight configurations of the arm: front or rear, elbow up or down, wrist flipped or not.
"""
    found = guessed(text, "denso-vp6242")
    assert "not read" not in found
    assert 'wx = "T[1,4] - d6* T[1,3]"' in found and "count = 8" in found
    found = guessed("With the table, `px = a1*c1 + a2*c12` and `py = a1*s1 + a2*s12`.", "adept-cobra-600")
    assert "not read" not in found and found.count('kind = "entry"') == 2


@pytest.mark.parametrize(
    "sentence",
    [
        "The determinant of the Jacobian vanishes where s3 = 0 or s5 = 0.",
        "The Jacobian has rank less than six when $s_3 = 0$ or $s_5 = 0$.",
        "The arm loses rank if s3 = 0 or s5 = 0.",
        "The arm is singular when s3 = 0 or s5 = 0.",
    ],
)
def test_a_sentence_that_says_where_an_arm_is_singular_in_other_words(sentence):
    assert 'kind = "singular"' in guessed(sentence, "denso-vp6242")


@pytest.mark.parametrize("word", ["unless", "except when", "if", "provided that"])
def test_an_equation_on_which_a_sentence_makes_a_condition_is_no_claim(word):
    assert "[[claim]]" not in guessed(rf"The angles are found in two ways {word} $\theta_5 = 0$.", "denso-vp6242")


def test_two_equations_with_a_wide_space_between_them():
    found = guessed(r"$$\theta_4 = \tan^{-1}\left(\frac{a_y}{a_x}\right),\qquad p_z = d_1$$", "denso-vp6242")
    assert "not read" not in found
