"""Pages: self-contained, numbered, whole; formulas that fit; LaTeX that holds together."""

import re
import shutil
import subprocess
import xml.etree.ElementTree as ET

import numpy as np
import pytest

import pieper
from pieper.document import html, json, latex, markdown, text
from pieper.document.blocks import (
    Code,
    Document,
    Emphasis,
    Equation,
    Equations,
    Heading,
    Lines,
    Listing,
    Note,
    Paragraph,
    Step,
)
from pieper.document.formulas import ZERO, Written, matrix, named
from pieper.document.html import page as html_page
from pieper.document.latex import latex_text, source
from pieper.document.mathml_fit import LINE, fitted, width
from pieper.drawing.style import new_figure, picture
from pieper.errors import InputError
from pieper.presentation.report import good_pose, report, write_report
from pieper.presentation.sections_arm import add_arm, fixed

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
    assert not re.search(r"""(?:src|href)\s*=\s*["'](?!#|data:image/(?:png|svg))""", text)
    assert not re.search(r"@import|url\((?!#|data:font/woff2;)", text)
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
    words = re.sub(r"data:(?:image/png|font/woff2);base64,[^\")]*", "", text)
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


def long_sum(terms):
    row = "<mo>+</mo>".join(f"<mrow><mi>a</mi><mn>{k}</mn></mrow>" for k in range(terms))
    return f"<mrow>{row}</mrow>"


def test_long_formulas_are_broken_before_a_sign_and_lose_nothing():
    short = long_sum(3)
    assert short in fitted(short)
    broken = fitted(long_sum(60))
    lines = re.findall(r"<math.*?</math>", broken, flags=re.S)
    assert len(lines) > 2
    assert all(width(ET.fromstring(line.replace(" xmlns=", " was="))) <= LINE + 1 for line in lines)
    plain = re.sub(r"<[^>]+>", "", broken)
    assert plain == re.sub(r"<[^>]+>", "", long_sum(60))


def test_what_cannot_be_parsed_is_left_alone():
    assert "<mi>&unknown;" in fitted("<mi>&unknown;")


def small_page():
    """One block of each kind, with every kind of piece in a sentence."""
    x = named("x", "1")
    page = Document("A title_1", summary="In short.")
    page.section("One", Lines(("a", "b")), Listing("x < y"), picture(new_figure(2, 1), "What one sees.", "p"))
    page.say("Take ", x, " from ", Code("a*b"), ", ", Emphasis("not"), " 2 * 3 & more.")
    page.table(["", "value, mm"], [["a", "1"], [x, Code("c")]], "A table.")
    page.add(Step(2, x, branches=4), Equation((x, ZERO), number=7, name="x_1"), Note(("Missing.",)))
    page.add(Equations((Equation((x, ZERO)), Equation((named("J"), matrix([[x, ZERO], [ZERO, x]]))))))
    page.section("Two")
    return page


def test_a_document_keeps_its_order_and_numbers():
    page = html_page(small_page())
    words = (
        "<li>a",
        "x &lt; y",
        "Figure 1.",
        "<em>not</em> 2 * 3 &amp; more.",
        "Table 1.",
        "<h3>Step 2: ",
        "(7)",
        ">Two</h2>",
    )
    order = [page.index(w) for w in words]
    assert order == sorted(order)
    assert balanced(page)


def test_every_renderer_sets_every_block():
    page = small_page()
    plain, tex, md, fragment = (m.fragment(page) for m in (text, latex, markdown, html))
    assert "    x1 = 0    (7)" in plain and "\nStep 2: x1\n" in plain and "Take x1 from a*b, not 2 * 3" in plain
    assert "J = [ x1   0  ]\n        [ 0    x1 ]" in plain
    assert r"\[ x_{1} = 0 \tag{7} \]" in tex and r"\paragraph{Step 2: $x_{1}$}" in tex and r"\texttt{a*b}" in tex
    assert "$$\nx_{1} = 0 \\tag{7}\n$$" in md and r"2 \* 3" in md and "`a*b`" in md and "![What one sees.]" in md
    assert "| $x_{1}$ | `c` |" in md
    assert "<h3>Step 2: <math" in fragment and "<h2>A title_1</h2>" in fragment and balanced(fragment)


def test_json_carries_numbers_as_fields():
    blocks = json.fragment(small_page())["blocks"]
    step = next(b for b in blocks if b["kind"] == "step")
    assert (step["number"], step["branches"], step["solves"]) == (2, 4, {"latex": "x_{1}", "text": "x1"})
    equation = next(b for b in blocks if b["kind"] == "equation")
    assert equation == {"kind": "equation", "latex": "x_{1} = 0", "text": "x1 = 0", "number": 7, "name": "x_1"}
    sentence = next(b for b in blocks if b["kind"] == "paragraph")["pieces"]
    assert sentence[:4] == ["Take ", {"latex": "x_{1}", "text": "x1"}, " from ", {"code": "a*b"}]


def test_markup_in_words_is_words():
    page = Document("", blocks=[Paragraph(("a `b` *c* $d$ <e> _f_",)), Heading(("#1",))])
    assert "a `b` *c* $d$ &lt;e&gt; _f_" in html.fragment(page)
    assert r"\`b\` \*c\* \$d\$ \<e\> \_f\_" in markdown.fragment(page)
    assert r"a `b` *c* \$d\$ \textless{}e\textgreater{} \_f\_" in latex.fragment(page)


def test_written_formulas_add_up_in_every_notation():
    both = Written("a", "b", "c") + ZERO
    assert (both.text(), both.latex(), both.mathml()) == ("a0", "b0", "c<mn>0</mn>")


def test_the_same_page_is_written_in_three_notations(tmp_path):
    arm = pieper.load("three-r")
    written = write_report(arm, tmp_path / "p.html", latex=tmp_path / "p.tex", markdown=tmp_path / "p.md")
    assert {path.suffix for path in written} == {".html", ".tex", ".md", ".pdf", ".svg"}
    assert "## The inverse, derived" in (tmp_path / "p.md").read_text()


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


def test_a_route_that_is_refused_has_its_picture_and_what_closes_it_on_the_page(tmp_path):
    arm = pieper.load("abb-irb2400").with_tool(pieper.pose(0.05, 0.02, 0.35, rpy=(0, 35, 0), degrees=True, mm=False))
    seam = pieper.line(*(pieper.pose(0.9, y, 0.6, rpy=(180, 0, 0), degrees=True) for y in (-0.75, 0.75)), 13)
    for low, verdict in ((-0.7, "impossible"), (-2.0, "found")):
        route = arm.with_limits({"joint_1": (low, 0.3 if verdict == "impossible" else 2.0)}).route(
            seam, free=pieper.Freedom()
        )
        assert route.verdict.name.lower() == verdict
        page = html_page(report(arm, route=route))
        assert balanced(page) and "A route" in page and "open turns of the tool along the path" in page
        assert ("What closes each branch" in page) == (verdict == "impossible")


def test_a_place_that_cannot_be_written_is_said_and_nothing_is_left(tmp_path):
    with pytest.raises(InputError, match="missing"):
        write_report(pieper.load("three-r"), tmp_path / "missing" / "page.html")
    assert list(tmp_path.iterdir()) == []


def test_a_pose_that_is_none_is_refused():
    with pytest.raises(InputError, match="pose"):
        report(ARM, pose=np.eye(3))
