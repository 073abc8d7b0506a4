"""A page as LaTeX: nothing runs over the margin."""

from __future__ import annotations

import re
import shutil
import subprocess

import pytest

from pieper.document.blocks import Document
from pieper.document.latex import latex_text, source

PATH = "joint origins, axes and limits of some-maker/arm_stack at 44f9d13c1b, arm_description/urdf/arm_of_it.urdf.xacro"
NAMES = "Self-motions 1 to 8: iiwa_joint_1, iiwa_joint_2, iiwa_joint_3, iiwa_joint_5, iiwa_joint_6, iiwa_joint_7"


def test_a_path_may_end_a_line_and_a_name_stays_whole():
    assert latex_text("iiwa_joint_1, a/b  c") == r"iiwa\_joint\_1, a/b  c"
    assert latex_text("iiwa_description/urdf/x") == (r"iiwa\_\allowbreak{}description/\allowbreak{}urdf/\allowbreak{}x")


@pytest.mark.skipif(not shutil.which("pdflatex"), reason="no pdflatex")
def test_long_words_stay_inside_the_margin(tmp_path):
    page = Document("Words")
    page.add(PATH, NAMES)
    (tmp_path / "page.tex").write_text(source(page)[0], encoding="utf-8")
    run = subprocess.run(
        ["pdflatex", "-interaction=nonstopmode", "page.tex"], cwd=tmp_path, capture_output=True, text=True, check=True
    )
    assert re.findall(r"Overfull.*", run.stdout) == []
