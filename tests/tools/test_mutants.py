"""The tool that changes the code: a limit of processor time, one place changed, the tests that reach it asked."""

from __future__ import annotations

import ast
import os
import signal
import time

import pytest

from tests.tools import mutants
from tests.tools.mutants import Change, changes, limited, sample, with_change
from tests.tools.reached import ordered


def test_what_works_longer_than_its_processor_time_is_stopped_and_what_only_waits_is_not():
    said, spent = limited(lambda: sum(1 for _ in iter(int, 1)), 0.5)
    assert said == "noticed: it takes too long" and 0.5 < spent < 4
    said, spent = limited(lambda: time.sleep(1.5) or 0, 1.0)
    assert said == "survived" and spent < 1.0


def test_what_waits_for_good_is_stopped_too(monkeypatch):
    monkeypatch.setattr(mutants, "WAITS", 0.5)
    assert limited(lambda: time.sleep(60) or 0, 1.0)[0] == "noticed: it waits for good"


def test_a_failure_and_a_crash_are_noticed():
    assert limited(lambda: os.write(1, b"FAILED a::b\n") and 1, 20.0)[0] == "noticed: FAILED a::b"
    assert limited(lambda: os.kill(os.getpid(), signal.SIGTERM) or 0, 20.0)[0].startswith("noticed")


def test_the_sample_is_the_same_each_time_and_each_change_alters_one_expression():
    chosen = sample(["judge"], 40, 3)
    assert chosen == sample(["judge"], 40, 3)
    assert len({c.name for c in chosen}) == 40
    for change in chosen:
        text = (mutants.SOURCE / change.path).read_text()
        altered = with_change(text, change)
        assert ast.dump(ast.parse(altered)) != ast.dump(ast.parse(text))
        first, _, last, _ = change.span
        assert altered.splitlines()[: first - 1] == text.splitlines()[: first - 1]
        assert (
            altered.splitlines()[len(altered.splitlines()) - (len(text.splitlines()) - last) :]
            == text.splitlines()[last:]
        )


def test_words_and_types_are_left_alone_and_comparisons_signs_and_or_are_turned(tmp_path, monkeypatch):
    monkeypatch.setattr(mutants, "SOURCE", tmp_path)
    path = tmp_path / "some.py"
    path.write_text(
        'def f(a: "int | None") -> "x - y":\n    """Return a - b."""\n    return f"{a - 1}", a < -b and b\n'
    )
    found = {(c.before, c.after) for c in changes(path)}
    assert found == {
        ("a < -b and b", "a < -b or b"),
        ("a < -b", "a <= -b"),
        ("a < -b", "a >= -b"),
        ("-b", "b"),
    }


def test_the_test_of_its_own_file_is_asked_first_then_the_quickest_within_the_budget():
    tests = {"t/test_slow.py::a": 9.0, "t/test_other.py::b": 0.1, "t/test_rows.py::c": 3.0, "t/test_other.py::d": 0.2}
    assert ordered(tests, "rows", None) == [
        "t/test_rows.py::c",
        "t/test_other.py::b",
        "t/test_other.py::d",
        "t/test_slow.py::a",
    ]
    assert ordered(tests, "rows", 3.2) == ["t/test_rows.py::c", "t/test_other.py::b"]
    assert ordered(tests, "slow", 1.0) == ["t/test_slow.py::a"]


@pytest.mark.parametrize("text", ["é = 1 < 2\n", "x = ('é', 1 < 2)\n"])
def test_columns_count_bytes(text, tmp_path, monkeypatch):
    monkeypatch.setattr(mutants, "SOURCE", tmp_path)
    (tmp_path / "a.py").write_text(text)
    turned = next(c for c in changes(tmp_path / "a.py") if c.after == "1 >= 2")
    assert isinstance(turned, Change)
    assert with_change(text, turned) == text.replace("1 < 2", "(1 >= 2)")
