"""Pages: self-contained, numbered, whole; formulas that fit; LaTeX that holds together."""

import re
import shutil
import subprocess
import xml.etree.ElementTree as ET

import numpy as np
import pytest

import pieper
from pieper.document.blocks import Code, Document, Formula, Lines, Picture, marked
from pieper.document.html_page import inline_svg
from pieper.document.html_page import page as html_page
from pieper.document.latex_page import latex_text, source
from pieper.document.mathml_fit import LINE, fitted, width
from pieper.errors import InputError
from pieper.presentation.report import good_pose, report, write_report
from pieper.presentation.sections_arm import add_arm, fixed
from pieper.presentation.style import new_figure

ARM = pieper.load("denso-vp6242")


def balanced(text):
    """Whether HTML elements close in the order in which they open."""
    text = re.sub(r"<!doctype[^>]*>|<meta[^>]*>|<!--.*?-->", "", text, flags=re.S)
    open_ = []
    for close, name, alone in re.findall(r"<(/?)([a-zA-Z][\w:]*)(?:\"[^\"]*\"|'[^']*'|[^>\"'])*?(/?)>", text):
        if alone:
            continue
        if not close:
            open_.append(name)
        elif not open_ or open_.pop() != name:
            return False
    return not open_


@pytest.fixture(scope="module")
def page():
    T0, T1 = np.eye(4), np.eye(4)
    T0[:3, 3], T1[:3, 3] = (0.35, 0, 0.4), (0.2, 0.1, 0.5)
    track = ARM.follow(pieper.line(T0, T1, 8), start=ARM.description.postures["line-start"])
    return report(ARM, pose=T0, track=track)


def test_the_page_needs_nothing_from_elsewhere_and_runs_nothing(page):
    text = html_page(page)
    assert balanced(text)
    assert "<script" not in text
    assert not re.search(r"""(?:src|href)\s*=\s*["'](?!#|data:image/png)""", text)
    assert not re.search(r"@import|url\((?!#)", text)
    assert "<math" in text and "<svg" in text


def test_the_page_holds_all_its_parts(page):
    text = html_page(page)
    sections = "The arm|How it is solved|Forward kinematics|The inverse, derived|A pose and all its solutions|"
    for words in (sections + "Singular configurations|Reach|A path").split("|"):
        assert f">{words}</h2>" in text
    assert "−150.64" in text
    assert "front, elbow up, wrist no flip" in text
    assert re.findall(r"<b>Figure (\d+)\.", text) == [str(k + 1) for k in range(text.count("<figure"))]


def test_no_identifier_stands_twice(page):
    ids = re.findall(r'\bid="([^"]+)"', html_page(page))
    twice = {name for name in ids if ids.count(name) > 1}
    assert not {name for name in twice if not re.match(r"f\d+-", name)}, twice


@pytest.mark.parametrize("name", ["rrp-wrist"])
def test_arms_of_other_kinds_get_a_page_too(name, tmp_path):
    text = write_report(pieper.load(name), tmp_path / "page.html")[0].read_text()
    assert balanced(text)
    assert "Reach" in text
    words = re.sub(r"data:image/png;base64,[^\"]*", "", text)
    assert "NaN" not in words and ">nan" not in words


def test_html_in_names_is_text():
    arm = pieper.Arm.from_dh(ARM.description.rows, convention="standard", name="<script>alert(1)</script>")
    page = Document(f"Kinematics of the {arm.name}")
    add_arm(page, arm)
    text = html_page(page)
    assert "<script" not in text
    assert "&lt;script&gt;" in text


@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="needs pdflatex")
def test_the_latex_source_compiles(page, tmp_path):
    text, figures = source(page, folder="pictures")
    (tmp_path / "pictures").mkdir()
    for name, content in figures.items():
        (tmp_path / name).write_bytes(content)
    (tmp_path / "page.tex").write_text(text)
    done = subprocess.run(
        ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "page.tex"],
        cwd=tmp_path,
        capture_output=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout.decode(errors="replace")[-2000:]


def test_the_latex_source_is_balanced_and_plain(page):
    text, figures = source(page)
    assert all(ord(c) < 0x250 for c in text)
    assert set(re.findall(r"\\includegraphics\[[^]]*\]\{([^}]*)\}", text)) == set(figures)
    opened, closed = re.findall(r"\\begin\{(\w+\*?)\}", text), re.findall(r"\\end\{(\w+\*?)\}", text)
    assert sorted(opened) == sorted(closed)
    assert all(content.startswith(b"%PDF") for content in figures.values())


def test_special_characters_are_escaped_in_latex():
    assert latex_text("50 % of a_1 & #2 {x} \\ ~ θ°") == (
        r"50 \% of a\_1 \& \#2 \{x\} \textbackslash{} \textasciitilde{} \ensuremath{\theta}\textdegree{}"
    )


def test_code_and_emphasis_are_marked_and_nothing_else():
    assert marked("a `b*c` *d* 2 * 3") == [
        ("plain", "a "),
        ("code", "b*c"),
        ("plain", " "),
        ("emphasis", "d"),
        ("plain", " 2 * 3"),
    ]


def long_sum(terms):
    row = "<mo>+</mo>".join(f"<mrow><mi>a</mi><mn>{k}</mn></mrow>" for k in range(terms))
    return f'<math xmlns="http://www.w3.org/1998/Math/MathML" display="block"><mrow>{row}</mrow></math>'


def test_long_formulas_are_broken_before_a_sign_and_lose_nothing():
    short = long_sum(3)
    assert fitted(short) == short
    broken = fitted(long_sum(60))
    lines = re.findall(r"<math.*?</math>", broken, flags=re.S)
    assert len(lines) > 2
    assert all(width(ET.fromstring(line)) <= LINE + 1 for line in lines)
    plain = re.sub(r"<[^>]+>", "", broken)
    assert plain == re.sub(r"<[^>]+>", "", long_sum(60))


def test_what_cannot_be_parsed_is_left_alone():
    bad = '<math display="block"><mi>&unknown;</math>'
    assert fitted(bad) == bad


def test_identifiers_in_inline_drawings_are_kept_apart():
    text = '<?xml version="1.0"?>\n<svg width="10pt" height="5pt" viewBox="0 0 10 5">'
    text += '<g id="a" clip-path="url(#b)"/><use xlink:href="#a"/></svg>'
    out = inline_svg(text, "f1-")
    assert 'id="f1-a"' in out
    assert "url(#f1-b)" in out
    assert 'href="#f1-a"' in out
    assert "width" not in out


def test_a_document_keeps_its_order_and_numbers():
    figure = new_figure(2, 1)
    page = Document("Title", summary="In `short`.")
    page.section("One", "A sentence.", Lines(("a", "b")), Code("x < y"), Picture(figure, "What one sees.", "p"))
    page.table(["", "value, mm"], [["a", "1"]], "A table.")
    page.section("Two", Formula("<math display='block'></math>", r"\[ x \]"))
    text = html_page(page)
    order = [text.index(words) for words in ("A sentence.", "<li>a", "x &lt; y", "Figure 1.", "Table 1.", ">Two</h2>")]
    assert order == sorted(order)


@pytest.mark.parametrize(
    ("value", "text"),
    [(0.0, "0"), (-0.0001, "0"), (1.5, "1.5"), (-210.0, "−210"), (1e-9, "0"), (np.inf, "∞"), (100.0, "100")],
)
def test_numbers_have_sensible_digits(value, text):
    assert fixed(value) == text


def test_the_chosen_pose_can_be_solved():
    for name in ("denso-vp6242", "universal-robots-ur5e", "three-r"):
        arm = pieper.load(name)
        assert len(arm.ik(good_pose(arm))) > 0


def test_a_place_that_cannot_be_written_is_said_and_nothing_is_left(tmp_path):
    with pytest.raises(InputError, match="missing"):
        write_report(pieper.load("three-r"), tmp_path / "missing" / "page.html")
    assert list(tmp_path.iterdir()) == []


def test_a_pose_that_is_none_is_refused():
    with pytest.raises(InputError, match="pose"):
        report(ARM, pose=np.eye(3))
