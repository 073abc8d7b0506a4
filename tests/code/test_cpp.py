"""Exported C++ is the kernel: the same rows for every family, several arms in one program, refusals said."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

import pieper
from pieper.code import kernel_source
from pieper.solver.families import FAMILIES
from pieper.solver.words.labels import posture_words, sides
from tests.code.test_export import poses

pytestmark = [pytest.mark.skipif(shutil.which("g++") is None, reason="no g++"), pytest.mark.slow]

WRAPPED = """
#include "one.hpp"
extern "C" {
long many(const double* T, long n, double* q, unsigned char* v, unsigned char* i, unsigned char* f) {
  return one_ik_many(T, n, q, v, i, f);
}
int ik(const double* T, double (*q)[6]) { return one_ik(T, q); }
int rows(const double* T) { return static_cast<int>(one_ik(T).size()); }
int refused(const double* T) { try { one_ik(T); } catch (const std::invalid_argument&) { return 1; } return 0; }
void fk(const double* q, double* T) { one_fk(q, T); }
const char* label(const double* q) { return one_label(q); }
void jacobian(const double* q, double (*J)[6]) { one_jacobian(q, J); }
int test() { return one_self_test(); }
}
"""


def general_arm():
    rng = np.random.default_rng(7)
    return pieper.Arm.from_dh(
        [pieper.DH(*rng.uniform(0.1, 0.5, 1), rng.uniform(0.4, 1.4), rng.uniform(-0.3, 0.3), 0.0) for _ in range(6)],
        convention="standard",
        joint_types="RRRRRR",
        limits=[(-2.5, 2.5)] * 6,
        name="general",
    )


def slides_arm():
    rows = [(0.1, 1.1, 0.2), (0.2, 0.7, 0.0), (0.05, 1.3, 0.1), (0.3, 0.9, 0.2), (0.1, 1.2, -0.1), (0.0, 0.0, 0.1)]
    return pieper.Arm.from_dh(
        [pieper.DH(a, alpha, d, 0.0) for a, alpha, d in rows],
        convention="standard",
        joint_types="RPRPRR",
        limits=[(-3, 3) if k == "R" else (-0.5, 0.5) for k in "RPRPRR"],
        name="slides",
    )


ARMS = {
    "spherical_wrist_parallel": lambda: pieper.load("denso-vp6242"),
    "three_parallel": lambda: pieper.load("universal-robots-ur5e"),
    "spherical_wrist": lambda: pieper.load("stanford-arm"),
    "offset_wrist": lambda: pieper.load("motoman-ea1400n"),
    "general": general_arm,
    "two_slides": slides_arm,
}


#: What a program may ask of every line it is made of.
STRICT = ("-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Werror")


def compiled(folder, source, output, *flags):
    (folder / "unit.cpp").write_text(source)
    command = ["g++", "-std=c++20", "-O1", "-ffp-contract=fast", *STRICT, *flags]
    subprocess.run([*command, "-o", output, "unit.cpp"], cwd=folder, check=True)


@pytest.mark.parametrize("family", ARMS)
def test_cpp_gives_the_native_rows(family, tmp_path):
    arm = ARMS[family]()
    assert arm.plan.family == family
    arm.code("c++", tmp_path / "one.hpp", "one")
    compiled(tmp_path, WRAPPED, "one.so", "-shared", "-fPIC")
    library = ctypes.CDLL(str(tmp_path / "one.so"))
    at = lambda array: ctypes.c_void_p(array.ctypes.data)  # noqa: E731
    q, T = poses(arm, 10_000 if family != "general" else 1_000)
    # a few that are singular, and a few that were rounded
    q[:50, 4] = 0.0
    T = np.ascontiguousarray(arm.fk(q))
    T[60:80] = np.float32(T[60:80])
    known = arm.plan.solver.many(T, 1)
    slots = known[0].shape[1]
    rows, valid = np.zeros((len(T), slots, 6)), np.zeros((len(T), slots), np.uint8)
    inside, flag = np.zeros_like(valid), np.zeros(len(T), np.uint8)
    assert library.many(at(T), ctypes.c_long(len(T)), at(rows), at(valid), at(inside), at(flag)) == len(T)
    same = (valid == known[1]).all(1) & (inside == known[2]).all(1)
    clear = (flag & 3 == 0) & (known[3] & 3 == 0)
    assert same[clear].all() and np.mean(same) > 0.995
    gap = arm.chain.joints.apart(rows, known[0])
    assert gap[clear][known[1][clear]].max() < 1e-7
    assert library.test() == 0
    room = np.zeros((slots, 6))
    for i in range(100, 120):
        count = library.ik(at(T[i]), at(room))
        assert count == library.rows(at(T[i])) == known[2][i].sum()
    library.label.restype = ctypes.c_char_p
    named = bool(sides(arm.plan, q[:1]))
    assert named == (family not in ("general", "two_slides"))
    said = [library.label(at(row)).decode() for row in q[:200]]
    assert said == (posture_words(arm.plan, q[:200]) if named else [""] * 200)
    back, J = np.zeros((4, 4)), np.zeros((6, 6))
    library.fk(at(q[0]), at(back))
    library.jacobian(at(q[0]), at(J))
    assert np.abs(back - arm.fk(q[0])).max() < 1e-13
    assert np.abs(J - arm.jacobian(q[0])).max() < 1e-13
    mirror = np.diag([1.0, 1.0, -1.0, 1.0])
    assert library.refused(at(mirror)) == 1 and library.ik(at(mirror), at(room)) == -1


def test_several_arms_and_units_live_in_one_program(tmp_path):
    for name, key in (("denso-vp6242", "a"), ("abb-irb140", "b"), ("stanford-arm", "c")):
        pieper.load(name).code("c++", tmp_path / f"{key}.hpp", key)
    both = '#include "a.hpp"\n#include "b.hpp"\n#include "c.hpp"\n#include "a.hpp"\n'
    (tmp_path / "other.cpp").write_text(both + "int other() { return a_self_test() + c_self_test(); }\n")
    main = "int other();\nint main() { return a_self_test() + b_self_test() + c_self_test() + other(); }\n"
    compiled(tmp_path, both + main, "program", "other.cpp")
    assert subprocess.run([tmp_path / "program"]).returncode == 0


def test_a_familys_header_is_the_one_of_the_builds_table():
    table = (Path(__file__).parents[2] / "CMakeLists.txt").read_text()
    for family in FAMILIES:
        assert '"{} {}"'.format(*kernel_source.header_of(family.name)) in table
    assert table.count('.hpp"\n') + table.count('.hpp")') == len(FAMILIES)
