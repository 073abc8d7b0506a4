"""What C does in its own way: an arctangent, values that wait for their row, alike blocks in one loop."""

from __future__ import annotations

import ctypes
import itertools
import subprocess

import numpy as np
import pytest

import pieper
from pieper.code.c import C
from pieper.code.c_pose import ANGLE
from pieper.code.folded import folded
from pieper.code.program import program_of
from pieper.code.staged import staged
from tests.code.test_export import needs_gcc


def compiled(tmp_path, source, name):
    (tmp_path / f"{name}.c").write_text(source)
    strict = ["gcc", "-std=c99", "-O2", "-Wall", "-Wextra", "-Werror", "-shared", "-fPIC"]
    subprocess.run([*strict, "-o", tmp_path / f"{name}.so", tmp_path / f"{name}.c", "-lm"], check=True)
    return ctypes.CDLL(str(tmp_path / f"{name}.so"))


@needs_gcc
def test_the_arctangent_is_good_to_its_bound(tmp_path):
    loop = "void all(const double *y, const double *x, long n, double *r) {\n  long i;\n"
    loop += "  for (i = 0; i < n; ++i) r[i] = one_angle(y[i], x[i]);\n}\n"
    library = compiled(tmp_path, "#include <math.h>\n" + ANGLE.replace("NAME_", "one_") + loop, "angle")
    rng = np.random.default_rng(5)
    size = 10.0 ** rng.uniform(-12, 6, (2, 400_000))
    near = np.array(list(itertools.product([0.0, -0.0, 1e-200, -1e-200, 1.0, -1.0, 1e200, -1e200], repeat=2))).T
    y, x = np.ascontiguousarray(np.concatenate([size * rng.choice([-1.0, 1.0], size.shape), near], axis=1))
    found = np.empty_like(x)
    at = lambda array: ctypes.c_void_p(array.ctypes.data)  # noqa: E731
    library.all(at(y), at(x), ctypes.c_long(len(x)), at(found))
    # 64 bits of mantissa beside 53; half a turn is said as +pi, and (0, 0) has no direction
    wanted = np.arctan2(y.astype(np.longdouble), x.astype(np.longdouble))
    gap = np.abs(found - np.where((x == 0) & (y == 0), 0, wanted))
    assert np.minimum(gap, np.abs(gap - 2 * np.arctan2(np.longdouble(0), np.longdouble(-1)))).max() < 8e-16
    assert found.min() > -np.pi
    assert found.max() <= np.pi


@needs_gcc
def test_what_only_a_row_needs_waits_for_it(tmp_path):
    """A row under two truths: its arctangent stands behind both, and says what the flat program says."""
    leaf = [("in", k, -1, -1, 0.0) for k in range(3)]
    nodes = [
        *leaf,
        ("const", -1, -1, -1, 0.0),  # 3
        ("gt", 0, 3, -1, 0.0),  # 4: a > 0
        ("sqrt", 0, -1, -1, 0.0),  # 5
        ("gt", 1, 5, -1, 0.0),  # 6: b > sqrt a
        ("and", 4, 6, -1, 0.0),  # 7
        ("angle", 1, 5, -1, 0.0),  # 8
        ("lt", 2, 3, -1, 0.0),  # 9: c < 0, seldom
        ("sqrt", 1, -1, -1, 0.0),  # 10
        ("select", 9, 10, 8, 0.0),  # 11
        ("gt", 8, 2, -1, 0.0),  # 12
        ("and", 7, 12, -1, 0.0),  # 13: doubt where the row holds
        ("false", -1, -1, -1, 0.0),  # 14
    ]
    program = program_of(nodes, [11] * 6 + [3] * 42, [7] + [14] * 7, 13, [])
    text = staged(program, C.words, C.entry)
    lines = text.splitlines()
    depth = lambda word: next(len(line) - len(line.lstrip()) for line in lines if word in line)  # noqa: E731
    assert depth("angle(") > depth("sqrt(T[0])") > 2
    assert depth("sqrt(T[1])") > depth("angle(")
    source = (
        "#include <math.h>\n" + ANGLE.replace("NAME_", "one_") + "int one(const double *T, double *q, int *doubted) {\n"
        "  double rows[8][6];\n  int valid[8] = {0}, doubt = 0;\n"
        + text.replace("NAME_", "one_")
        + "\n  if (valid[0]) *q = rows[0][5];\n  *doubted = doubt;\n  return valid[0];\n}\n"
    )
    library = compiled(tmp_path, source, "row")
    rng = np.random.default_rng(2)
    for a, b, c in rng.uniform(-1, 1, (300, 3)):
        given, q, doubt = (ctypes.c_double * 3)(a, b, c), ctypes.c_double(), ctypes.c_int()
        holds = library.one(given, ctypes.byref(q), ctypes.byref(doubt))
        angle = np.arctan2(b, np.sqrt(max(a, 0)))
        assert holds == (a > 0 and b > np.sqrt(a))
        assert doubt.value == (holds and angle > c)
        if holds:
            assert abs(q.value - (np.sqrt(b) if c < 0 else angle)) < 1e-15


def test_blocks_that_differ_in_names_alone_are_one_loop():
    block = lambda own, given, row: [  # noqa: E731
        f" if ({given}) {{",
        f"  const double {own} = {given} * v0;",
        f"  rows[{row}][0] = {own};",
        f"  valid[{row}] = 1;",
        " }",
    ]
    said = folded([block("v5", "v1", 0), block("v6", "v2", 2), block("v7", "v3", 4)], " ")
    assert said is not None
    text = "\n".join(said)
    assert "{{v1}, {v2}, {v3}}" in text
    assert "rows[2 * each + 0][0]" in text
    assert "its[0] * v0" in text
    # another row, another operation: no loop
    assert folded([block("v5", "v1", 0), block("v6", "v2", 2), block("v7", "v3", 5)], " ") is None
    other = [line.replace("*", "+") for line in block("v6", "v2", 2)]
    assert folded([block("v5", "v1", 0), other], " ") is None


@pytest.mark.parametrize("name", ["jaka-zu20", "jaka-zu30"])
def test_a_quartic_is_a_loop(name, tmp_path):
    """The wrist of a JAKA Zu misses by a quarter of a millimetre: four roots, found by steps that are written once."""
    arm = pieper.load(name)
    assert arm.code("c", tmp_path / "arm.c", "one").stat().st_size <= 40_000
    assert arm.code("javascript", tmp_path / "arm.mjs", "one").stat().st_size <= 60_000
