"""Public pages judged: every verdict agrees with plain NumPy, and what is published is what the judge says."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import pytest

import pieper
from pieper.judge.pages import page
from pieper.judge.verdict import HOLDS, PARTLY, WRONG
from tests.papers.public_pages import PAGES
from tests.papers.public_tables import TABLES

ROOT = Path(__file__).parents[2]
CLAIMS = ROOT / "examples" / "pages"
NAMES = sorted(path.stem for path in CLAIMS.glob("*.toml"))
TWINS = PAGES | TABLES
ONE_ARM = {", this arm": True, ", another arm": False}  # formulas that hold for the page's lengths only


@cache
def judged(name: str):
    return pieper.check(CLAIMS / f"{name}.toml")


@pytest.mark.parametrize("name", NAMES)
def test_plain_numpy_says_the_same(name):
    status = {v.id: (v.status, v.sentence) for v in judged(name).verdicts}
    with np.errstate(all="ignore"):
        for claim, good in TWINS[name]():
            ending = next((e for e in ONE_ARM if claim.endswith(e)), "")
            if ending:
                said, sentence = status[claim.removesuffix(ending)]
                assert said == PARTLY and "this arm" in sentence and good.all() == ONE_ARM[ending], claim
                continue
            share = good.mean()
            wanted = HOLDS if share == 1 else WRONG if share < 0.1 else PARTLY
            assert status[claim][0] == wanted, (claim, share, status[claim])


@pytest.mark.parametrize("name", NAMES)
def test_the_published_page_is_what_the_judge_says(name):
    published = (ROOT / "docs" / "pages" / f"{name}.md").read_text(encoding="utf-8")
    assert published == page(CLAIMS / f"{name}.toml", judged(name), folder="pages")


@pytest.mark.parametrize(
    ("name", "claim", "words"),
    [
        ("simple_manipulator", "z", "joint 2 has its zero -90 deg"),
        ("slide_turn_slide", "q1_1", "the sign of a2 s2"),
        ("two_links_readme", "theta2", "the angle inside the triangle"),
        ("two_links_readme", "a", "atan for atan2"),
        ("puma_project", "the position stands in (4,1)", "T06[4,1] for T06[1,4]"),
        ("ur5_review", "theta4, before", "circular"),
        ("kr210_lengths", "a3, in the list", "a digit too many"),
        ("robotic_dog", "D0_1", "joint 1 has its zero -90 deg"),
    ],
)
def test_the_cause_is_named(name, claim, words):
    verdict = next(v for v in judged(name).verdicts if v.id == claim)
    assert verdict.status != HOLDS
    assert words in verdict.sentence + " ".join(text for _, text in verdict.details)
