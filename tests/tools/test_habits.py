"""What continuous integration, the file of pre-commit, the issue forms and the pages name is there."""

from __future__ import annotations

import ast
import importlib.util
import re
import sys
import tomllib
from pathlib import Path

import pytest
import yaml

from tests.tools.check import CHECKS

ROOT = Path(__file__).resolve().parents[2]
TARGETS = set(re.findall(r"^([a-z-]+):", (ROOT / "Makefile").read_text(), re.MULTILINE))
WORKFLOWS = sorted((ROOT / ".github" / "workflows").glob("*.yml"))
FORMS = sorted((ROOT / ".github" / "ISSUE_TEMPLATE").glob("*.yml"))
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md"))]


def asked_to_run(words: str) -> tuple[set[str], list[str]]:
    """Return the targets of make that commands name, and the modules and files of ours that they run."""
    targets = set(re.findall(r"(?:^|exec |&& )make ([a-z-]+)", words, re.MULTILINE))
    ours = re.findall(r"python(?:3\.\d+)? (?:-m )?((?:tests|benchmarks|build_backend|static_page)[./]\S+)", words)
    return targets, ours


def is_there(name: str) -> bool:
    return (ROOT / name).exists() if "/" in name else importlib.util.find_spec(name) is not None


@pytest.mark.parametrize("path", WORKFLOWS, ids=lambda p: p.name)
def test_a_workflow_runs_targets_and_files_that_are_there(path):
    jobs = yaml.safe_load(path.read_text())["jobs"]
    named = 0
    for job in jobs.values():
        assert set([job.get("needs", [])] if isinstance(job.get("needs"), str) else job.get("needs", [])) <= set(jobs)
        assert all(("uses" in step) != ("run" in step) for step in job["steps"])
        targets, ours = asked_to_run("\n".join(step.get("run", "") for step in job["steps"]))
        named += len(targets) + len(ours)
        assert targets <= TARGETS and all(map(is_there, ours)), (targets - TARGETS, ours)
    assert named > 0


def test_what_continuous_integration_runs_is_there():
    targets, _ = asked_to_run((ROOT / ".ci" / "run").read_text())
    assert {"check", "test"} <= targets <= TARGETS


def test_what_is_looked_at_before_a_commit_is_there():
    repos = yaml.safe_load((ROOT / ".pre-commit-config.yaml").read_text())["repos"]
    hooks = [hook for repo in repos for hook in repo["hooks"]]
    tools = " ".join(tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["optional-dependencies"]["dev"])
    files = [str(p.relative_to(ROOT)) for folder in ("src", "kernels") for p in (ROOT / folder).rglob("*.*")]
    for hook in hooks:
        first, *rest = hook["entry"].split()
        assert first == "python" or first in tools
        assert all(map(is_there, asked_to_run(hook["entry"])[1]))
        assert "--only" not in rest or any(name.startswith(rest[-1]) for name in CHECKS)
        assert any(re.search(hook.get("files", ""), name) for name in files)


@pytest.mark.parametrize("path", FORMS, ids=lambda p: p.name)
def test_an_issue_form_has_what_such_a_form_needs(path):
    form = yaml.safe_load(path.read_text())
    assert form["name"] and form["description"]
    ids = [field["id"] for field in form["body"]]
    assert len(set(ids)) == len(ids) > 0
    assert all(field["type"] in {"textarea", "input", "dropdown", "checkboxes", "markdown"} for field in form["body"])
    assert all(field["attributes"]["label"] for field in form["body"])


@pytest.mark.parametrize("path", PAGES, ids=lambda p: p.name)
def test_the_targets_of_make_that_a_page_names_are_there(path):
    named = set(re.findall(r"`make ([a-z-]+)[^`]*`", path.read_text()))
    assert named <= TARGETS, named - TARGETS


def test_what_runs_inside_a_peers_environment_needs_numpy_alone():
    # a peer's environment holds the peer and NumPy: the adapters name their package inside the class that needs it
    seen, todo = set(), ["benchmarks.measure.worker"]
    while todo:
        spec = importlib.util.find_spec(name := todo.pop())
        if name in seen or spec is None or spec.origin is None:
            continue
        seen.add(name)
        for node in ast.parse(Path(spec.origin).read_text()).body:
            named = [a.name for a in node.names] if isinstance(node, ast.Import) else []
            named += [node.module or ""] if isinstance(node, ast.ImportFrom) else []
            todo += [full for full in named if full.startswith("benchmarks")]
            allowed = {*sys.stdlib_module_names, "numpy", "benchmarks"}
            assert {full.split(".")[0] for full in named} <= allowed, (name, named)
    assert "benchmarks.measure.contestants" in seen
