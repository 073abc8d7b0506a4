"""A claims file spoilt in any way ends in a judgement, or in an InputError that names file, claim and key."""

from __future__ import annotations

import copy
import datetime
import random
import re
import tomllib
from pathlib import Path

import numpy as np
import pytest

from pieper.errors import InputError
from pieper.judge.claims import check, judge_tables

ROOT = Path(__file__).parents[2]
ODD = [
    *("", " ", "1/0", "R36", "T", "T09", "theta", "?", "a2", "1e400", "1e-400", "9^9^9^9", "sqrt(-1)"),
    *("acos(2)", "((((", "θ1", "²"),
    *("\x00", "inf", "nan", "1_000", "==", "px = ", "+-", "c(1", "A1^-1^-1", "(A1 + A2)^-1", "P03"),
    *("R36[3,3]", "x" * 300, "1" * 400),
    *("-" * 80 + "1", "30 deg", "pi/2", "theta1 + theta2", "atan2(s2,c2)", "mm", "modified", "position"),
    *("1e250*1e250",),
    *("(c1+s1)^40", "0^-1", "tan(pi/2)", "s12345678", "__import__('os')", "s5 > 0", "s5 >", "1 > 2"),
    *(0, 1, -1, 7, 1e308, -1e308, 10**30, 10**400, float("inf"), float("nan"), True, False, [], {}),
    *([[]], [1], ["a"], {"a": 1}),
    *(datetime.date(2020, 1, 1), datetime.time(1, 2), 3.7, [0] * 6, ["0"] * 6, [[0] * 4] * 4, [[1, 2], [3]]),
]  # fmt: skip
KEYS = """is of frame at_deg when task where joint for unit rounded complete matrix position q_deg q q_rad path
    free within search_zeros arm kind id says base tool robot rows values""".split()


def sources():
    """Every claim of the published files, alone with its arms."""
    found = []
    for path in sorted((ROOT / "examples" / "claims").glob("*.toml")):
        data = tomllib.loads(path.read_text(encoding="utf-8"))
        found += [(path.name, {**data, "claim": [claim], "seconds": 0.02}) for claim in data["claim"]]
    return found


def places(value, path=()):
    if path:
        yield path
    if isinstance(value, (dict, list)):
        for key in value if isinstance(value, dict) else range(len(value)):
            yield from places(value[key], (*path, key))


def spoilt(data, rng):
    """The tables with one to three values dropped, exchanged, wrapped or mistyped."""
    data = copy.deepcopy(data)
    for _ in range(rng.choice((1, 1, 2, 3))):
        found = list(places(data))
        if not found:
            break
        path = rng.choice([p for p in found if p[0] == "claim"] or found) if rng.random() < 0.6 else rng.choice(found)
        parent = data
        for key in path[:-1]:
            parent = parent[key]
        value, how = parent[path[-1]], rng.random()
        if how < 0.15:
            del parent[path[-1]]
        elif how < 0.6:
            parent[path[-1]] = copy.deepcopy(rng.choice(ODD))
        elif how < 0.75 and isinstance(value, str):
            k = rng.randrange(len(value) + 1)
            parent[path[-1]] = (
                value[:k] + rng.choice(["", "(", ")", "^", "/0", "9", "θ", "[", "=", "+-", " "]) + value[k + 1 :]
            )
        elif how < 0.85:
            parent[path[-1]] = rng.choice(([value], {"x": value}, str(value)))
        elif isinstance(parent, dict):
            parent[rng.choice(KEYS)] = copy.deepcopy(rng.choice([*ODD, value]))
    return data


@pytest.mark.parametrize("block", range(6))
def test_no_spoilt_file_gives_a_traceback(block):
    every = sources()
    for seed in range(100 * block, 100 * block + 100):
        rng = random.Random(seed)
        name, data = rng.choice(every)
        try:
            with np.errstate(all="ignore"):
                judgement = judge_tables(name, spoilt(data, rng))
            assert judgement.text() and judgement.markdown() and judgement.json()
        except InputError as error:
            assert name in str(error), f"seed {seed}: {error}"


ARM = """[arm]
convention = "standard"
length_unit = "m"
columns = ["theta", "d", "a", "alpha"]
rows = [["q1", 0, "a1", 0], ["q2", 0, "a2", 0]]
values = { a1 = 0.4, a2 = 0.3 }
"""


@pytest.mark.parametrize(
    ("claim", "words"),
    [
        ('kind = "equation"\nis = "px = px"\nframe = "R02"', ["frame", "whole pose"]),
        ('kind = "entry"\nof = "T[1,4]"\nis = ["px"]', ["is must be", "formula"]),
        ('kind = "matrix"\nof = "A1"\nis = "px"', ["is must be", "list"]),
        ('kind = "entry"\nof = 3\nis = "px"', ["of must be", "name"]),
        ('kind = "joint"\njoint = 2\nis = "1 +"', ["is:", "something must follow"]),
        ('kind = "joint"\njoint = 2\nis = "w"\nwhere = { w = "px (" }', ["where w", "something must follow"]),
        ('kind = "joint"\njoint = true\nis = "px"', ["joint must be", "whole number"]),
        ('kind = "joint"\nfor = "2 theta2"\nis = "px"', ["for", "a joint or a sum of joints"]),
        ('kind = "product"\nis = "(A1 - A1)^-1 = T"', ["claim x", "no inverse"]),
        ('kind = "joint"\njoint = 2\nis = "px"\nwhen = "s2"', ["when", "comparison"]),
        ('kind = "joint"\njoint = 2\nis = "px"\nwhen = "s2 > 2"', ["when", "too few"]),
        ('kind = "pose"\nq_deg = [0, 0]\nof = "P02"\nposition = [1, 2, 3]', ["P02", "shape"]),
        ('kind = "number"\nis = "a1"\nvalue = "0.4x"', ["value must be", "digits"]),
        ('kind = "solutions"\nq_deg = [0, 0]\nsolutions_deg = []', ["solutions_deg must be"]),
        ('kind = "count"\ncount = 1\ntask = "place"', ["task must be", "'position'"]),
    ],
)
def test_the_message_names_the_claim_the_key_and_the_cure(claim, words):
    try:
        text = check(f"{ARM}[[claim]]\nid = 'x'\n{claim}").text()
    except InputError as error:
        text = str(error)
        assert re.match(r"claims, line (8|9|1\d): claim x", text), text
    for word in words:
        assert word in text, text


@pytest.mark.parametrize(
    ("rows", "words"),
    [
        ("[]", ["rows"]),
        ('[["q1", 0, "1/0", 0], ["q2", 0, 0.3, 0]]', ["row 1, a", "no value"]),
        ('[["q1", 0, "q1", 0], ["q2", 0, 0.3, 0]]', ["row 1, a", "moves"]),
        ('[["q1", "b1", "a1", 0], ["q2", 0, "a2", 0]]', ["row 1", "one variable"]),
        ('[["q1", 0, "sqrt(", 0], ["q2", 0, 0.3, 0]]', ["row 1, a", "^"]),
    ],
)
def test_a_bad_table_is_refused_by_row_and_column(rows, words):
    text = ARM.replace('[["q1", 0, "a1", 0], ["q2", 0, "a2", 0]]', rows)
    with pytest.raises(InputError) as caught:
        check(text + "[[claim]]\nkind = 'count'\ncount = 2\n")
    for word in ("[arm]", *words):
        assert word in str(caught.value)


@pytest.mark.parametrize("last", ["atan2(0,0) 50", "pi/2", "80"])
def test_a_solution_with_a_formula_for_a_wrong_angle_is_judged(last):
    text = f"{ARM}[[claim]]\nkind = 'solutions'\nq_deg = [30, 40]\nsolutions_deg = [['30', '{last}']]\n"
    assert [verdict.status for verdict in check(text).verdicts] == ["wrong"]


@pytest.mark.parametrize(
    "body",
    [
        "0^-1",
        "(c1-c1)^-1",
        "1/(c1-c1)",
        "(c1-c1)^-0.5",
        "(c1-c1)/(c1-c1)",
        "sqrt(1/(s1-s1))",
        "mod(1, c1-c1)",
        "tan(pi/2)",
    ],
)
def test_a_symbol_that_divides_by_zero_everywhere_is_judged(body):
    text = f'[arm]\nrobot = "denso-vp6242"\n[symbols]\nK = "{body}"\n'
    text += '[[claim]]\nkind = "equation"\nis = "K = 7"\n[[claim]]\nkind = "equation"\nis = "px = r14"\n'
    assert [verdict.status for verdict in check(text).verdicts] == ["wrong", "holds"]


@pytest.mark.parametrize(
    ("given", "spoilt", "line", "words"),
    [
        ('joint = 2', 'joint = "2"', 15, "joint must be a whole number"),
        ('joint = 2', 'joint = 9', 15, "joint 9 does not exist"),
        ('is = "phi + 0 w"', 'is = "phi +"', 17, "something must follow"),
        ('w = "px"', 'w = "px ("', 16, "where w"),
        ('"q2", 0', '"q1", 0', 6, "write q2"),
        ('a1 = 0.4', 'a1 = "x"', 9, "values must be"),
        ('phi = "atan2(py, px)"', 'phi = "((py"', 11, "never closed"),
        ('kind = "count"', 'kind = "cuont"', 24, "did you mean 'count'"),
        ('count = 2', 'is = "# ] no comment"', 25, "'is' is not known"),
        ('count = 2', '', 23, "lacks the key 'count'"),
        ('"two"', '"one"', 26, "two claims are called"),
        ('length_unit = "m"', 'length_unit = "km"', 4, "length_unit must be"),
        ('title = "a"', 'titel = "a"', 1, "titel"),
    ],
)  # fmt: skip
def test_a_reason_names_the_line_to_mend(given, spoilt, line, words):
    """Brackets, quotes and words like `joint = 9` in long texts, lists and comments lead no line astray."""
    whole = '''title = "a"
[arm]  # [ a comment
convention = "standard"
length_unit = "m"
columns = ["theta", "d", "a", "alpha"]
rows = [["q1", 0, "a1", 0],
  ["q2", 0, "a2", 0],  # ]]
]
values = { a1 = 0.4, a2 = 0.3 }
[symbols]
phi = "atan2(py, px)"
[[claim]]
id = "one"
kind = "joint"
joint = 2
where = { w = "px" }
is = "phi + 0 w"
says = """
[[claim]]
joint = "3" and an open bracket [
"""

[[claim]]
kind = "count"
count = 2
id = "two"
'''
    assert given in whole
    with pytest.raises(InputError, match=f"^claims, line {line}: ") as caught:
        check(whole.replace(given, spoilt, 1))
    assert words in str(caught.value) and caught.value.data["line"] == line
