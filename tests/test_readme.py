"""What README and the pages promise: code that runs, commands and targets that exist, links that lead somewhere."""

from __future__ import annotations

import re
import shlex
import tomllib

import pytest

from tests.tools.house import ROOT

README = (ROOT / "README.md").read_text()
PAGES = sorted([ROOT / "README.md", ROOT / "CONTRIBUTING.md", *(ROOT / "docs").rglob("*.md")])


def blocks(text: str, language: str = "") -> list[str]:
    """Return the code blocks of a page that are in a language."""
    return re.findall(rf"^```{language}\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)


def test_every_python_block_of_the_readme_runs_one_after_the_other(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    names: dict = {}
    for block in blocks(README, "python"):
        exec(compile(block, "README.md", "exec"), names)
    said = capsys.readouterr().out
    assert names["many"].valid.any(1).all() and names["track"].complete
    assert "spherical wrist" in said and (tmp_path / "my-arm.toml").exists()


@pytest.mark.parametrize("block", [b for b in blocks(README) if b.startswith("$ pieper")])
def test_a_command_of_the_readme_prints_what_stands_under_it(block, capsys):
    pytest.importorskip("click", reason="the command line is an extra")
    from pieper.cli import main

    command, *shown = block.splitlines()
    with pytest.raises(SystemExit) as left:
        main(shlex.split(command.split("#")[0])[2:])
    assert left.value.code == 0
    said = [words(line) for line in capsys.readouterr().out.splitlines()]
    for line in shown:
        assert not words(line) or words(line) in said, line


def words(line: str) -> list[str]:
    """Return the words of a line; rulers and residuals, which differ between machines, left out."""
    return [] if line.strip() == "..." else re.sub(r"─+|\S+e-\d+ mm.*", "", line).split()


def test_targets_extras_and_commands_that_are_named_exist():
    makefile = (ROOT / "Makefile").read_text()
    extras = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["optional-dependencies"]
    for page in PAGES:
        text = page.read_text()
        for target in re.findall(r"(?:^|`)make ([a-z]+)", text, re.MULTILINE):
            assert re.search(rf"^{target}:", makefile, re.MULTILINE), f"{page.name}: make {target}"
        for named in re.findall(r"(?:pieper|['\" ]\.)\[([a-z,]+)\]", text):
            assert set(named.split(",")) <= set(extras), f"{page.name}: {named}"


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_links_of_a_page_lead_somewhere(page):
    for target in re.findall(r"\]\(([^)#\s]+)(?:#[^)]*)?\)", page.read_text()):
        assert "://" in target or (page.parent / target).exists(), target


def test_every_dependency_has_a_page_among_the_decisions():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    extras = {e: d for e, d in project["optional-dependencies"].items() if e not in ("all", "test", "dev")}
    pages = "\n".join(p.read_text() for p in (ROOT / "docs" / "decisions").glob("*.md")).lower()
    for dependency in [*project["dependencies"], *(d for group in extras.values() for d in group)]:
        name = re.split(r"[>=\[]", dependency)[0].lower()
        assert name in pages, f"{name} has no page in docs/decisions"
