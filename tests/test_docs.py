"""The pages: every block of code on them runs, every command line is one, every page is on the site."""

from __future__ import annotations

import importlib.util
import json
import re
import shlex
import sys
import threading
import webbrowser

import numpy as np
import pytest

import pieper
from tests.tools.house import ROOT

DOCS = ROOT / "docs"
PAGES = sorted(p for p in DOCS.rglob("*.md"))
BLOCK = re.compile(r"^```(python|\{drawn\} [\w-]+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
WITH_CODE = [p for p in PAGES if BLOCK.search(p.read_text(encoding="utf-8"))]
#: Where the shell says a command and its answer.
LISTED = re.compile(r"^(?:\$ )?(pieper [a-z].*)$", re.MULTILINE)


def at_hand(folder) -> dict:
    """Return what a page may take for granted: an arm, postures, poses, a path, a track, measurements."""
    arm = pieper.load("denso-vp6242")
    q0 = np.asarray(arm.postures["line-start"], float)
    T0 = pieper.pose(0.35, 0.0, 0.4)
    T1 = pieper.pose(0.2, 0.1, 0.5)
    path = pieper.line(T0, T1, n=20)
    q = arm.ik(T0).q[0]
    via = pieper.pose(0.3, 0.05, 0.47)
    arm.save(folder / "my-arm.toml")
    slow = pieper.Limits(speed=[1.0] * 6, acceleration=[2.0] * 6)
    pick = pieper.Program(arm, slow, start=q).move_j(q + 0.05)
    pick.write(folder / "pick.csv", dialect="csv")
    arm.save(folder / "model.xml.urdf")
    text = (folder / "model.xml.urdf").read_text().replace('"base"', '"base_link"').replace('"tool"', '"tool0"')
    for name in ("robot.urdf", "model.xml"):
        (folder / name).write_text(text)
    xacro = text.replace("<robot ", '<robot xmlns:xacro="http://ros.org/wiki/xacro" ', 1)
    said = '<xacro:arg name="ur_type" default=""/><link name="base_link"/>'
    (folder / "robot.urdf.xacro").write_text(xacro.replace('<link name="base_link"/>', said, 1))
    return {
        "np": np,
        "pieper": pieper,
        "arm": arm,
        "q": q,
        "q0": q0,
        "q1": q0 + 0.1,
        "q_now": q0,
        "T": T0,
        "T0": T0,
        "T1": T1,
        "Ts": np.stack([T0, T1]),
        "q_or_T": q0 + 0.1,
        "via": via,
        "path": path,
        "track": arm.follow(path, start=q),
        "sols": arm.ik(T0),
        "postures": [q0, q0 + 0.1, q0],
    }


@pytest.fixture
def visitor(monkeypatch):
    """Somebody who opens each page that a block serves, does one thing, and closes it when the script says it stays."""
    bench_module = pytest.importorskip("pieper.workbench.bench")
    client = pytest.importorskip("websockets.sync.client")
    stays = threading.Event()

    def visit(url: str) -> None:
        address = url.replace("http:", "ws:") + "session"
        with client.connect(address, origin=url.rstrip("/"), max_size=None) as page:
            page.send(json.dumps({"op": "hello", "seq": 1}))
            shows = json.loads(page.recv())["bench"]
            done = {"op": "shown", "seq": 2, "said": 10**6, "q": shows["q"], "target": shows["target"], "table": None}
            page.send(json.dumps(done))
            stays.wait(60)

    stay = bench_module.Bench.stay
    monkeypatch.setattr(
        webbrowser, "open", lambda url: threading.Thread(target=visit, args=(url,), daemon=True).start()
    )
    monkeypatch.setattr(bench_module.Bench, "stay", lambda bench: (stays.set(), stay(bench))[1])


@pytest.mark.parametrize("page", WITH_CODE, ids=lambda page: str(page.relative_to(DOCS)))
@pytest.mark.usefixtures("visitor")
def test_every_block_of_a_page_runs_from_top_to_bottom(page, tmp_path, monkeypatch):
    pytest.importorskip("matplotlib")
    pytest.importorskip("sympy")
    if "xacro" in page.read_text(encoding="utf-8"):
        pytest.importorskip("xacrodoc")
    monkeypatch.chdir(tmp_path)
    names = at_hand(tmp_path)
    for block in BLOCK.finditer(page.read_text(encoding="utf-8")):
        # what is no part of the package's extras is run where it is there
        if any(f"import {name}\n" in block[2] and importlib.util.find_spec(name) is None for name in ("jax", "torch")):
            continue
        exec(compile(block[2], str(page.relative_to(ROOT)), "exec"), names)
        if block[1] != "python":
            assert hasattr(names["figure"], "savefig"), f"{block[1]} leaves a figure"


@pytest.mark.parametrize("page", [*PAGES, ROOT / "README.md"], ids=lambda page: page.name)
def test_every_command_of_a_page_is_one(page):
    pytest.importorskip("click")
    from pieper.cli.app import COMMANDS, app

    for block in re.findall(r"^```(?:text|sh|bash|console)?\n(.*?)^```$", page.read_text(), re.MULTILINE | re.DOTALL):
        for line in LISTED.findall(block):
            words = shlex.split(line.split("   ")[0].split("  #")[0])
            if words[1] in COMMANDS:
                options = {o for p in app.get_command(None, words[1]).params for o in (*p.opts, *p.secondary_opts)}
                said = {w.split("=")[0] for w in words[2:] if re.match(r"--[a-z]", w)}
                assert said <= options | {"--help"}, f"{line}: {said - options}"
            else:
                assert words[1].startswith("-") or words[1] in ("COMMAND",), line


@pytest.mark.parametrize("page", [*PAGES, ROOT / "README.md", ROOT / "CONTRIBUTING.md"], ids=lambda page: page.name)
def test_every_source_file_that_a_page_names_is_there(page):
    named = re.findall(r"`([\w./]+\.(?:py|hpp|cpp|mjs))`", page.read_text(encoding="utf-8"))
    rooms = [ROOT / room for room in ("src", "kernels", "examples", "tests", "oracle", "benchmarks", "build_backend")]
    for name in named:
        there = (ROOT / name).exists() or any(next(room.glob(f"**/{name}"), None) for room in rooms)
        assert there, f"{page.name} names {name}"


def test_every_page_is_on_the_site():
    listed = set()
    for page in PAGES:
        for tree in re.findall(r"```\{toctree\}\n(.*?)```", page.read_text(), re.DOTALL):
            for line in tree.splitlines():
                if "*" in line:
                    listed |= set(page.parent.glob(f"{line.strip()}.md"))
                elif line.strip() and not line.startswith(":"):
                    listed.add(page.parent / f"{line.strip()}.md")
    assert set(PAGES) - listed <= {DOCS / "index.md"}
    assert all(page.exists() for page in listed)


def test_the_version_is_one_and_the_changelog_begins_with_it_and_its_date():
    head = re.search(r"^## (\S+)(?: - (\d{4}-\d\d-\d\d))?$", (ROOT / "CHANGELOG.md").read_text(), re.MULTILINE)
    assert head and (head[1] == "Unreleased" or (head[1] == pieper.__version__ and head[2]))
    released = re.search(r"^## (\d\S*) - (\d{4}-\d\d-\d\d)$", (ROOT / "CHANGELOG.md").read_text(), re.MULTILINE)
    assert released and released[1] == pieper.__version__
    cited = (ROOT / "CITATION.cff").read_text()
    assert f"version: {pieper.__version__}\n" in cited and f"date-released: {released[2]}\n" in cited


def test_the_reference_has_every_public_name():
    reference = (DOCS / "api.md").read_text()
    missing = [name for name in pieper.__all__ if not re.search(rf"pieper\.{name}\b", reference)]
    assert not missing


def test_the_site_needs_no_module_that_is_not_among_the_extras():
    import tomllib

    extras = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["optional-dependencies"]
    assert {"sphinx", "furo", "myst-parser"} <= {re.split(r"[>=]", d)[0] for d in extras["docs"]}
    assert "drawn" not in sys.modules
