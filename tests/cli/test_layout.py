"""Tables of the command line: at every width every number is there, whole, and nothing is wider than the terminal."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections import Counter

import numpy as np
import pytest

import pieper
from pieper.cli import layout, main, output
from pieper.cli.layout import Column, table

WIDTHS = (40, 80, 130, 160, 220)
ARMS = {
    "three-r": ["300", "100", "100"],
    "denso-vp6242": ["350", "0", "400"],
    "franka-panda": ["300", "100", "400", "180", "0", "0"],
    "rethink-sawyer": ["300", "100", "400", "180", "0", "0"],
}


@pytest.fixture
def run(capsys, monkeypatch):
    def call(*words, width=None):
        for room in (layout, output):
            monkeypatch.setattr(room, "terminal_width", lambda: width)
        with pytest.raises(SystemExit):
            main([str(w) for w in words])
        return capsys.readouterr().out

    return call


def tokens(text: str) -> Counter[str]:
    return Counter(text.replace(",", " ").split())


@pytest.mark.parametrize("width", WIDTHS)
@pytest.mark.parametrize("name", ARMS)
def test_every_joint_value_of_the_json_is_in_the_table(run, name, width):
    data = json.loads(run("ik", name, *ARMS[name], "--all", "--json"))
    out = run("ik", name, *ARMS[name], "--all", width=width)
    assert max(len(line) for line in out.splitlines()) <= width
    expected = Counter(f"{np.degrees(v) + 0.0:.3f}" for row in data["solutions"] for v in row["q"])
    assert data["solutions"] and not expected - tokens(out)
    for row in data["solutions"]:
        assert not tokens(row["label"]) - tokens(out)


@pytest.mark.parametrize("width", WIDTHS)
def test_a_path_and_an_arm_lose_nothing_either(run, width):
    words = ["path", "denso-vp6242", "--from", "350 0 400", "--to", "700 0 400", "--start", "line-start", "-n", 8]
    data = json.loads(run(*words, "--json"))
    out = run(*words, width=width)
    assert max(len(line) for line in out.splitlines()) <= width
    assert not Counter(f"{np.degrees(v) + 0.0:.3f}" for row in data["q"] for v in row) - tokens(out)
    assert not tokens(run(*words)) - tokens(out) - Counter(w for w in tokens(run(*words)) if set(w) == {"─"})
    assert not Counter(["-150.64", "210.000", "-75.000"][1:]) - tokens(run("show", "denso-vp6242", width=width))


#: Every command that prints a table, on arms of three, six and seven joints.
TABLES = (
    ("robots",),
    *(("show", name) for name in (*ARMS, "adept-cobra-600", "fanuc-lr-mate-200id-controller")),
    ("fk", "three-r", "10", "20", "30", "--frames"),
    ("fk", "denso-vp6242", "10", "20", "-150", "40", "50", "60", "--frames"),
    ("fk", "franka-panda", "10", "20", "30", "-40", "50", "60", "70", "--frames"),
    ("ik", "franka-panda", *ARMS["franka-panda"], "--near", "0 0 0 -90 0 90 0"),
    ("ik", "universal-robots-ur5e", "400", "-200", "250", "180", "0", "0", "--all"),
    ("path", "three-r", "--from", "300 100 100", "--to", "250 100 150", "-n", "5"),
    ("path", "franka-panda", "--from", "400 0 400 180 0 0", "--to", "450 100 400 180 0 0", "-n", "4"),
    ("time", "denso-vp6242", "--from", "350 0 400", "--to", "300 50 450", "--speed", "100", "--acceleration", "400"),
)


@pytest.mark.parametrize("width", WIDTHS)
@pytest.mark.parametrize("words", TABLES, ids=lambda words: "-".join(words[:2]))
def test_no_command_loses_a_word_or_a_number_of_what_a_pipe_gets(run, words, width):
    whole, out = run(*words), run(*words, width=width)
    assert max(len(line) for line in out.splitlines()) <= width
    there, lost = tokens(out.replace("\n", " ")), tokens(whole) - tokens(out)
    rules = {word for word in lost if set(word) <= {"─"}}
    assert not set(lost) - rules - {word for word in lost if word in there}, lost


def test_a_pipe_gets_one_line_a_row(run):
    out = run("ik", "franka-panda", *ARMS["franka-panda"], "--all")
    assert sum(line.split()[:1] == ["3"] and line.count(".") > 7 for line in out.splitlines()) == 1


def test_words_are_broken_between_words_and_numbers_never(run):
    columns = [Column("#"), Column("value"), Column("why", True)]
    made = table("t", columns, [["1", "123456789012345678901234567890", "one two three four five six seven"]], 20)
    assert "123456789012345678901234567890" in made
    assert tokens("one two three four five six seven") - tokens(made) == Counter()


def test_wide_characters_keep_columns_straight():
    made = table("", [Column("关节", True), Column("q")], [["基座", "1.0"], ["ab", "2.0"]], None).splitlines()
    assert made[-2].index("1.0") == made[-1].index("2.0") - 2


@pytest.mark.skipif(not hasattr(os, "openpty"), reason="needs a pseudo terminal")
def test_a_dumb_terminal_gets_every_number_and_no_escape_codes():
    import fcntl
    import struct
    import termios

    ours, theirs = os.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 50, 80, 0, 0))
    environment = {k: v for k, v in os.environ.items() if k not in ("COLUMNS", "LINES")} | {"TERM": "dumb"}
    command = [sys.executable, "-m", "pieper", "ik", "denso-vp6242", "350", "0", "400", "--all"]
    process = subprocess.Popen(command, stdout=theirs, stderr=theirs, env=environment)
    os.close(theirs)
    out = b""
    while True:
        try:
            out += (part := os.read(ours, 65536))
        except OSError:
            break
        if not part:
            break
    os.close(ours)
    assert process.wait() == 0
    text = out.decode()
    assert "\x1b" not in text
    rows = pieper.load("denso-vp6242").ik(pieper.pose(0.35, 0, 0.4)).all_q
    assert not Counter(f"{np.degrees(v) + 0.0:.3f}" for v in rows.ravel()) - tokens(text)


def test_an_error_is_broken_between_words_where_it_stands_on_a_terminal(monkeypatch, capsys):
    from pieper.cli import failure

    monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)
    monkeypatch.setattr("shutil.get_terminal_size", lambda: os.terminal_size((40, 20)))
    assert failure._misuse("'kuka kr10' may be " + ", ".join(f"kuka-kr10-{i}" for i in range(9)) + ": say which.") == 2
    lines = capsys.readouterr().err.splitlines()
    assert len(lines) > 3 and max(map(len, lines)) <= 40 and lines[0].startswith("pieper: 'kuka kr10' may be")


def test_lines_of_a_stacked_table_are_even_and_few(run):
    # at 130 columns the residuals alone do not fit: they do not stand alone beneath either
    lines = run("ik", "denso-vp6242", "350", "0", "400", "--all", width=130).splitlines()
    at = next(i for i, line in enumerate(lines) if line.startswith("1 "))
    assert lines[at + 1].split()[0] == "front," and "mm," in lines[at + 1] and "inside" in lines[at + 1]
    # names that leave others no room stand above them
    out = run("robots", "--joints", "4", width=40)
    assert max(map(len, out.splitlines())) <= 40
    assert len(out.splitlines()) <= 3 * 12 + 6, out


def test_the_fewest_lines_are_taken_whatever_the_columns_are():
    rng = np.random.default_rng(0)
    for _ in range(200):
        n = int(rng.integers(2, 9))
        columns = [Column(f"head {j}" * int(rng.integers(1, 3)), bool(rng.integers(2))) for j in range(n)]
        rows = [
            ["w" * int(k) if c.words else "9" * int(k) for c, k in zip(columns, rng.integers(1, 14, n), strict=True)]
        ]
        for width in (24, 40, 80):
            out = table("", columns, rows, width)
            assert max(map(len, out.splitlines())) <= width
            assert not tokens(table("", columns, rows, None).replace("─", "")) - tokens(out.replace("─", ""))
            assert len(out.splitlines()) <= len(table("", columns, rows, width - 6).splitlines())
