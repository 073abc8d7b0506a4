"""One identity: the workbench's page, reports, figures and the site look alike, out of one file."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import pieper
from pieper.document import identity
from pieper.document.blocks import Document
from pieper.document.html import page
from pieper.drawing import style

DIST = Path(pieper.__file__).parent / "workbench" / "page" / "dist"


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_the_shipped_page_has_the_colours_of_the_file(theme):
    css = (DIST / "page.css").read_text()
    block = re.search(r':root\[data-theme="?dark"?\]\{([^}]*)' if theme == "dark" else r":root\{(--paper[^}]*)", css)
    assert block is not None
    said = dict(re.findall(r"--([\w-]+):([^;]+)", block[1]))
    for name, value in identity.identity()[theme]["colours"].items():
        own = said[re.sub("[A-Z]", lambda m: "-" + m.group().lower(), name)]
        assert own.strip() == value, name


def test_reports_figures_and_the_page_have_one_icon_and_one_set_of_colours():
    written = page(Document("A title", []))
    assert identity.icon_address() in written and identity.colour("accent") in written
    assert (DIST / "icon.svg").read_bytes() == identity.ICON.read_bytes()
    assert style.COLOURS == identity.curves()[: len(style.LINES)] and style.AXES == identity.axes()
    script = (DIST / "app.js").read_text()
    assert all(colour in script for colour in (*identity.curves(), *identity.curves("dark"), *identity.axes()))


@pytest.mark.parametrize("made", ["animation", "page without a server"])
def test_pages_that_stand_alone_have_both_themes_of_the_file_and_no_colour_of_their_own(made, tmp_path):
    arm = pieper.load("three-r")
    if made == "animation":
        motion = pieper.sequence([[0.0, 0, 0], [0.5, 0.4, 0.3]], [1.0], [0.0], rate=20)
        motion.animate(tmp_path / "index.html", arm=arm)
        template = (Path(pieper.__file__).parent / "drawing/animation/page.html").read_text()
    else:
        from static_page.build import HERE, build

        build(tmp_path, ["three-r"], code=b"not run here")
        template = (HERE / "page.html").read_text() + (HERE / "page.js").read_text()
    written = (tmp_path / "index.html").read_text()
    assert identity.both_themes() in written and identity.icon_address() in written and "{{" not in written
    assert not re.search(r"#[0-9a-fA-F]{3,8}\b|rgba?\(", template), "colours come from the one file"
    for name in set(re.findall(r"var\(--([\w-]+)|colour\(['\"]([\w-]+)", template)):
        assert f"--{name[0] or name[1]}:" in identity.both_themes()


def _luminance(colour: str) -> float:
    channels = [int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    r, g, b = (c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in channels)
    return 0.2126 * r + 0.7152 * g + 0.0722 * b


def contrast(one: str, other: str) -> float:
    a, b = sorted((_luminance(one), _luminance(other)), reverse=True)
    return (a + 0.05) / (b + 0.05)


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_words_stand_out_from_what_is_behind_them(theme):
    def of(name: str) -> str:
        return identity.colour(name, theme)

    for ink, behind in [
        *((i, b) for i in ("ink", "muted", "accentInk", "wrong", "good") for b in ("panel", "ground", "softer")),
        ("onAccent", "accent"),
        ("onWrong", "wrong"),
        ("accentInk", "accentSoft"),
        ("wrong", "wrongSoft"),
    ]:
        assert contrast(of(ink), of(behind)) >= 4.5, (ink, behind)
    # curves are lines, for which three is asked
    assert all(contrast(c, of("panel")) >= 2.3 for c in identity.curves(theme))
