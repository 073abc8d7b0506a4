"""The tool that changes the code: a limit of processor time, one place changed, the tests that reach it asked."""

from __future__ import annotations

import ast
import os
import signal
import time
from types import SimpleNamespace

import pytest

from tests.tools import mutants, reached
from tests.tools.mutants import Change, changes, limited, sample, with_change
from tests.tools.reached import Recorded, cost, ordered, probed, reaching


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
    assert ordered(tests, "rows", None, {}) == [
        "t/test_rows.py::c",
        "t/test_other.py::b",
        "t/test_other.py::d",
        "t/test_slow.py::a",
    ]
    assert ordered(tests, "rows", 3.2, {}) == ["t/test_rows.py::c", "t/test_other.py::b"]
    assert ordered(tests, "slow", 1.0, {}) == ["t/test_slow.py::a"]


def test_what_a_file_prepares_counts_once_and_puts_its_tests_behind_quicker_ones():
    tests = {"t/test_a.py::x": 0.1, "t/test_a.py::y": 0.1, "t/test_b.py::z": 0.5}
    prepares = {"t/test_a.py": 60.0}
    assert cost(["t/test_a.py::x", "t/test_a.py::y"], tests, prepares) == pytest.approx(60.2)
    assert ordered(tests, "rows", None, prepares) == ["t/test_b.py::z", "t/test_a.py::x", "t/test_a.py::y"]
    assert ordered(tests, "rows", 5.0, prepares) == ["t/test_b.py::z"]


@pytest.mark.parametrize("text", ["é = 1 < 2\n", "x = ('é', 1 < 2)\n"])
def test_columns_count_bytes(text, tmp_path, monkeypatch):
    monkeypatch.setattr(mutants, "SOURCE", tmp_path)
    (tmp_path / "a.py").write_text(text)
    turned = next(c for c in changes(tmp_path / "a.py") if c.after == "1 >= 2")
    assert isinstance(turned, Change)
    assert with_change(text, turned) == text.replace("1 < 2", "(1 >= 2)")


def test_a_place_says_that_it_is_evaluated_and_the_text_does_what_it_did():
    text = (
        '"""Words."""\n\nfrom __future__ import annotations\n\nAT_ONCE = 3\n\n\n'
        "def f(x: int = 7):\n    if x < 0:\n        return -x\n    return [x + k for k in range(AT_ONCE)]\n"
    )
    spans = {node_text: _span(text, node_text) for node_text in ("AT_ONCE = 3", "x < 0", "-x", "x + k")}
    numbered = {0: (5, 10, 5, 11), 1: spans["x < 0"], 2: spans["-x"], 3: spans["x + k"]}
    seen: list[int] = []
    module = probed(text, numbered)
    assert module.index("__future__") < module.index("probes") < module.index("AT_ONCE")
    there: dict = {"_evaluated": seen.append}
    exec(module.replace("from pieper.probes import evaluated as _evaluated", ""), there)
    assert there["f"](2) == [2, 3, 4] and set(seen) == {0, 1, 3}
    seen.clear()
    assert there["f"](-2) == 2 and seen == [0, 1, 2]


def _span(text: str, part: str) -> tuple[int, int, int, int]:
    line = next(i for i, words in enumerate(text.splitlines()) if part in words)
    column = text.splitlines()[line].index(part)
    return line + 1, column, line + 1, column + len(part)


def test_a_test_is_asked_that_comes_to_the_place_and_all_are_where_it_is_evaluated_when_the_file_is_loaded():
    one = Recorded({"a.py::x": 1.0, "a.py::y": 2.0}, {"a.py::x": [3], "a.py::failed": [3, 4]})
    two = Recorded({"b.py::z": 0.5}, {"b.py": [4], "": [3]})
    assert reaching([one, two], 3, loaded=False) == {"a.py::x": 1.0, "b.py::z": 0.5}, "one when its file is read"
    assert reaching([one, two], 4, loaded=False) == {"b.py::z": 0.5}
    assert reaching([one, two], 5, loaded=False) == {}
    assert reaching([one, two], 5, loaded=True) == {"a.py::x": 1.0, "a.py::y": 2.0, "b.py::z": 0.5}


def test_what_is_prepared_is_no_part_of_a_test_s_time_and_a_file_ends_after_the_longest_time(monkeypatch):
    monkeypatch.setattr(reached, "spent", {})
    monkeypatch.setattr(reached, "prepared", {})
    item = SimpleNamespace(nodeid="t/test_a.py::x", session=SimpleNamespace(shouldstop=False))

    def run(hook, inside=lambda: None):
        steps = hook(item)
        next(steps)
        inside()
        with pytest.raises(StopIteration):
            steps.send(None)

    def busy():
        begin = time.process_time()
        while time.process_time() < begin + 0.2:
            pass

    run(reached.pytest_runtest_protocol, lambda: run(reached.pytest_runtest_setup, busy))
    assert reached.prepared["t/test_a.py"] >= 0.2 > 0.1 > reached.spent["t/test_a.py::x"]
    assert not item.session.shouldstop
    monkeypatch.setenv(reached.LONGEST, "0")
    run(reached.pytest_runtest_protocol)
    assert item.session.shouldstop
