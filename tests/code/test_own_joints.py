"""Arms whose joints are not the six that are solved: coupled, linked, short, with some to spare; in every language."""

from __future__ import annotations

import ctypes
import importlib.util
import json
import shutil
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest

import pieper
from pieper.code.between import between
from pieper.solver.words.labels import posture_words, sides
from tests.code.test_cpp import STRICT
from tests.code.test_export import loaded, needs_gcc, needs_node, poses, written_down
from tests.code.test_more_languages import needs_octave, needs_wasm, octave


def coupled(*entries, limits=None):
    """Return a Denso whose axes are tied to other joints as said: (axis, joint, ratio)."""
    said = pieper.load("denso-vp6242").description
    C = np.eye(6)
    for axis, joint, ratio in entries:
        C[axis, joint] = ratio
    return pieper.Arm(replace(said, coupling=C, limits=said.limits if limits is None else limits, name="coupled"))


def on_a_turntable(name):
    """Return an arm of the catalogue on a joint of its own: one more to spare."""
    said = pieper.load(name).description
    rows = [pieper.DH(0.2, np.pi / 2, 0.1, 0.0), *said.rows]
    return pieper.Arm.from_dh(
        rows, convention=said.convention, joint_types="R" + said.joint_types, limits=[(-1, 1), *said.limits.tolist()]
    )


ARMS = {
    "controller's numbers": lambda: pieper.load("fanuc-lr-mate-200id-controller"),
    "half a turn along": lambda: coupled((2, 1, 0.5)),
    "several ratios, wide limits": lambda: coupled(
        (2, 1, 0.5), (4, 3, -0.25), (5, 3, 1 / 3), (5, 4, 0.6), limits=np.tile([-6.0, 7.0], (6, 1))
    ),
    "a gear of two": lambda: coupled((0, 0, 2.0)),
    "SCARA": lambda: pieper.load("adept-cobra-600"),
    "five joints": lambda: pieper.load("dfrobot-rob0036"),
    "positions": lambda: pieper.load("three-r"),
    "spare at the tool": lambda: pieper.load("franka-panda"),
    "spare at the base": lambda: pieper.load("kuka-lbr-iiwa-7-r800"),
    "spare in the numbers": lambda: pieper.load("dfrobot-rob0036-as-printed"),
    "two to spare": lambda: on_a_turntable("kuka-lbr-iiwa-7-r800"),
    "a linkage": lambda: pieper.load("dobot-magician"),
    "a linkage that two joints move": lambda: pieper.load("kuka-kr120-r3200-pa"),
    # of its list of operations one is a constant truth
    "a truth alone": lambda: pieper.load("interbotix-pincherx-100"),
}


def held(arm):
    """Return the joint that a file is told the value of; None where it is told none."""
    return between(arm.plan).held


def asked(arm, count):
    """Return joint vectors, poses of which every second one is rounded, and their rows at values of spare joints."""
    q, exact = poses(arm, count)
    locked, own = list(arm.plan.reduction.locked), between(arm.plan)
    q[:, own.fixed] = [own.columns[j] for j in own.fixed]
    T = written_down(np.ascontiguousarray(arm.fk(q)) if own.fixed else exact)
    if own.fixed:
        T = T[:30]  # what a short arm with a joint to spare cannot hold is looked for a tenth of a second
    return q[: len(T)], T, arm.ik_many(T, redundancy=q[: len(T), locked] if locked else None)


def wrong(arm, many, found):
    """Return at how many poses rows are not the native ones inside the limits."""
    out = 0
    for i, rows in enumerate(found):
        wanted, rows = many.q[i][many.in_limits[i]], np.reshape(rows, (-1, arm.n))
        gap = np.abs(rows[:, None] - wanted[None]).max(-1)
        out += len(rows) != len(wanted) or (len(rows) and not (gap.min(1) < 1e-7).all())
    return out


def names(arm, q):
    solved = arm.plan.uncoupled if arm.plan.chain.linked else arm.plan
    return posture_words(arm.plan, q) if sides(solved, np.zeros((1, solved.n))) else [""] * len(q)


@pytest.mark.parametrize("kind", ARMS)
def test_numpy_takes_and_gives_the_joints_own_numbers(kind, tmp_path):
    arm = ARMS[kind]()
    solver, spare = loaded(arm.code("python", tmp_path / "solver.py")), held(arm)
    q, T, many = asked(arm, 150)
    found = [solver.ik(t) if spare is None else solver.ik(t, v[spare]) for t, v in zip(T, q, strict=True)]
    assert wrong(arm, many, found) == 0 and solver.self_test() == 0
    values = () if spare is None else (q[:, spare],)
    assert np.array_equal(solver.ik_all(T, *values)[1].sum(1), many.valid.sum(1))
    assert np.abs(solver.fk(q)[::2] - T[::2]).max() < 1e-13
    assert np.abs(solver.jacobian(q[:9]) - arm.jacobian(q[:9])).max() < 1e-13
    assert [solver.label(row) for row in q[:30]] == names(arm, q[:30])
    assert not len(solver.ik(pieper.pose(40.0, 0, 0)))


@pytest.mark.parametrize("kind", ["SCARA", "five joints"])
def test_a_pose_that_a_short_arm_cannot_hold_has_no_rows(kind, tmp_path):
    arm = ARMS[kind]()
    solver = loaded(arm.code("python", tmp_path / "solver.py"))
    turned = poses(arm, 50)[1] @ pieper.pose(0, 0, 0, rpy=(0.01, 0.02, 0.0))
    assert [len(solver.ik(T)) for T in turned] == [len(arm.ik(T)) for T in turned]


def sliding_beside_a_plane(twists):
    """Return three parallel joints, then a turn, a slide and a turn."""
    rows = [pieper.DH(0.4, 0, 0.1, 0), pieper.DH(0.35, 0, 0, 0), pieper.DH(0.1, twists[0], 0.05, 0)]
    rows += [pieper.DH(0.07, twists[1], 0.1, 0.3), pieper.DH(0.05, twists[2], 0.2, 0.2), pieper.DH(0, 0, 0.1, 0)]
    return pieper.Arm.from_dh(rows, convention="standard", joint_types="RRRRPR")


CLEAR = {
    "viperx from its tool": lambda: pieper.load("interbotix-viperx-300").reversed(),
    "pincherx from its tool": lambda: pieper.load("interbotix-pincherx-150").reversed(),
    "a slide beside a plane, square": lambda: sliding_beside_a_plane([np.pi / 2] * 3),
    "a slide beside a plane": lambda: sliding_beside_a_plane([0.9, -0.5, 1.2]),
}


@pytest.mark.parametrize("kind", CLEAR)
def test_poses_that_are_not_singular_are_clear(kind, tmp_path):
    """A slide in the middle of the three joints beside a plane left every pose unclear, and solved with care."""
    arm = CLEAR[kind]()
    q = np.random.default_rng(0).uniform(-1, 1, (300, arm.n))
    T = arm.fk(q)
    rows, valid, unclear = loaded(arm.code("python", tmp_path / "arm.py")).ik_all(T)
    assert unclear.sum() <= 3
    gap = np.abs(rows - q[:, None])
    turns = ~arm.chain.prismatic
    gap[..., turns] = np.abs((gap[..., turns] + np.pi) % (2 * np.pi) - np.pi)
    assert ((gap.max(-1) < 1e-7) & valid).any(1).all()
    assert np.abs(arm.fk(rows[valid]) - np.repeat(T, valid.sum(1), 0)).max() < 1e-9
    if arm.n == 6:  # from the tool the same arm is another closed form's
        seen_from_tool = arm.reversed()
        assert [len(seen_from_tool.ik(np.linalg.inv(t)).all_q) for t in T[:40]] == valid.sum(1)[:40].tolist()


LIMITS = [(4, np.inf), (3.2, np.inf), (-np.inf, -4), (-np.inf, -3), (2, np.inf), (-1e5, -4), (300, 301)]


@pytest.mark.parametrize("limits", LIMITS)
@pytest.mark.filterwarnings("ignore:limits of joint_6")
def test_limits_far_from_zero_or_on_one_side_are_written(limits, tmp_path, recwarn):
    arm = pieper.load("abb-irb2400").with_limits({"joint_6": limits})
    recwarn.clear()
    module = loaded(arm.code("python", tmp_path / "arm.py"))
    assert not recwarn.list and module.self_test() == 0 and len(module._Q) == 20
    assert ((module._Q[:, 5] >= limits[0] - 1e-9) & (module._Q[:, 5] <= limits[1] + 1e-9)).all()


@needs_gcc
@pytest.mark.parametrize("kind", ARMS)
def test_c_takes_and_gives_the_joints_own_numbers(kind, tmp_path):
    arm = ARMS[kind]()
    source, library = arm.code("c", tmp_path / "arm.c", "one"), tmp_path / "arm.so"
    strict = ["gcc", "-std=c99", "-O1", "-Wall", "-Wextra", "-Werror"]
    subprocess.run([*strict, "-shared", "-fPIC", "-o", library, source, "-lm"], check=True)
    judged(arm, ctypes.CDLL(str(library)), 500)


def judged(arm, library, count):
    """Hold a library's functions one_... against the native solver."""
    at = lambda array: ctypes.c_void_p(array.ctypes.data)  # noqa: E731
    q, T, many = asked(arm, count)
    room, spare, found, flag = np.zeros((64, arm.n)), held(arm), [], ctypes.c_int()
    for i in range(len(T)):
        value = () if spare is None else (ctypes.c_double(q[i, spare]),)
        assert library.one_ik_all(at(T[i]), *value, at(room), ctypes.byref(flag)) == many.valid[i].sum()
        found.append(room[: library.one_ik(at(T[i]), *value, at(room))].copy())
    assert wrong(arm, many, found) == 0 and library.one_self_test() == 0
    back, J = np.zeros((4, 4)), np.zeros((6, arm.n))
    library.one_fk(at(q[0]), at(back))
    library.one_jacobian(at(q[0]), at(J))
    assert np.abs(back - T[0]).max() < 1e-13 and np.abs(J - arm.jacobian(q[0])).max() < 1e-13
    library.one_label.restype = ctypes.c_char_p
    assert [library.one_label(at(row)).decode() for row in q[:30]] == names(arm, q[:30])


@needs_node
@pytest.mark.parametrize("kind", ARMS)
def test_javascript_takes_and_gives_the_joints_own_numbers(kind, tmp_path):
    arm = ARMS[kind]()
    arm.code("javascript", tmp_path / "solver.mjs")
    run_module(arm, tmp_path, 300)


def run_module(arm, folder, count):
    """Hold a module's functions against the native solver."""
    q, T, many = asked(arm, count)
    (folder / "asked.json").write_text(json.dumps({"q": q.tolist(), "T": T.reshape(-1, 16).tolist()}))
    value = "" if held(arm) is None else f", q[i][{held(arm)}]"
    (folder / "run.mjs").write_text(
        "import fs from 'fs';\nimport { ik, ikAll, fk, jacobian, label, selfTest } from './solver.mjs';\n"
        "const { q, T } = JSON.parse(fs.readFileSync('asked.json'));\n"
        f"const rows = T.map((t, i) => ik(t{value})), all = T.map((t, i) => ikAll(t{value}).rows.length);\n"
        "const names = q.slice(0, 30).map((row) => label(row));\n"
        "console.log(JSON.stringify({ rows, all, names, fk: fk(q[0]), J: jacobian(q[0]), failed: selfTest() }));\n"
    )
    ran = subprocess.run(["node", "run.mjs"], cwd=folder, capture_output=True, text=True, check=True)
    said = json.loads(ran.stdout)
    assert wrong(arm, many, said["rows"]) == 0 and said["failed"] == 0
    assert said["all"] == many.valid.sum(1).tolist() and said["names"] == names(arm, q[:30])
    assert np.abs(said["fk"] - T[0]).max() < 1e-13 and np.abs(said["J"] - arm.jacobian(q[0])).max() < 1e-13


@needs_octave
@pytest.mark.parametrize("kind", ARMS)
def test_matlab_takes_and_gives_the_joints_own_numbers(kind, tmp_path):
    arm = ARMS[kind]()
    arm.code("matlab", tmp_path, "one")
    q, T, many = asked(arm, 25)
    np.savetxt(tmp_path / "T.txt", T.reshape(-1, 16), fmt="%.17g")
    np.savetxt(tmp_path / "q.txt", q, fmt="%.17g")
    value = "" if (spare := held(arm)) is None else f", q(i, {spare + 1})"
    octave(
        tmp_path,
        f"T = load('T.txt'); q = load('q.txt'); out = zeros(0, {arm.n + 1});\n"
        f"i = 1:size(T, 1); [r, of] = one_ik_many(permute(reshape(T', 4, 4, []), [2 1 3]){value});\n"
        "dlmwrite('many.txt', [of, r], 'precision', '%.17g');\n"
        f"for i = 1:size(T, 1)\n  r = one_ik(reshape(T(i, :), 4, 4)'{value});\n"
        "  out = [out; i * ones(size(r, 1), 1), r];\nend\n"
        "dlmwrite('out.txt', out, 'precision', '%.17g');\n[P, J] = one_fk(q(1, :));\n"
        "dlmwrite('fk.txt', [reshape(P', 1, []), reshape(J', 1, [])], 'precision', '%.17g', 'delimiter', ' ');\n"
        "dlmwrite('failed.txt', one_self_test());\nfile = fopen('names.txt', 'w');\n"
        "for i = 1:size(q, 1)\n  fprintf(file, '%s\\n', one_label(q(i, :)));\nend\nfclose(file);\n"
        "disp('run_it done')\n",
    )
    out = np.loadtxt(tmp_path / "out.txt", delimiter=",", ndmin=2)
    assert wrong(arm, many, [out[out[:, 0] == i + 1, 1:] for i in range(len(T))]) == 0
    # many poses at once, row by row in the same order
    assert np.abs(np.loadtxt(tmp_path / "many.txt", delimiter=",", ndmin=2) - out).max() < 1e-9
    both = np.loadtxt(tmp_path / "fk.txt")
    assert np.abs(both - np.concatenate([T[0].ravel(), arm.jacobian(q[0]).ravel()])).max() < 1e-13
    assert (tmp_path / "names.txt").read_text().splitlines() == names(arm, q)
    assert float(np.loadtxt(tmp_path / "failed.txt")) == 0


@pytest.mark.slow
@pytest.mark.parametrize(
    "kind",
    ["several ratios, wide limits", "SCARA", "spare at the tool", "spare in the numbers", "a linkage", "a truth alone"],
)
def test_jax_takes_and_gives_the_joints_own_numbers(kind, tmp_path):
    if importlib.util.find_spec("jax") is None:
        pytest.skip("no jax")
    arm = ARMS[kind]()
    arm.code("jax", tmp_path / "solver.py", "one")
    q, T, many = asked(arm, 20)
    np.savez(tmp_path / "asked.npz", q=q, T=T)
    value = "" if held(arm) is None else f", jnp.array(q[:, {held(arm)}])"
    script = (
        "import jax, json, numpy as np\njax.config.update('jax_disable_jit', True)\nimport jax.numpy as jnp, solver\n"
        f"q, T = (np.load('asked.npz')[k] for k in 'qT')\nrows, _, inside, _ = solver.one_ik_all(jnp.array(T){value})\n"
        "rows, inside = np.array(rows), np.array(inside)\n"
        "found = [r[k].tolist() for r, k in zip(rows, inside)]\n"
        "print(json.dumps([found, np.array(solver.one_jacobian(q[0])).tolist()]))"
    )
    ran = subprocess.run([sys.executable, "-c", script], cwd=tmp_path, capture_output=True, text=True, check=True)
    rows, J = json.loads(ran.stdout)
    assert wrong(arm, many, rows) == 0 and np.abs(J - arm.jacobian(q[0])).max() < 1e-12


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("g++") is None, reason="no g++")
@pytest.mark.parametrize("kind", [*ARMS, "offset wrist, coupled", "general, spare"])
def test_cpp_takes_and_gives_the_joints_own_numbers(kind, tmp_path):
    more = {"offset wrist, coupled": "fanuc-crx-10ia-controller", "general, spare": "rethink-sawyer"}
    arm = ARMS[kind]() if kind in ARMS else pieper.load(more[kind])
    arm.code("c++", tmp_path / "one.hpp", "one")
    value, said = ("", "") if held(arm) is None else ("double value, ", "value, ")
    last, told = value.rstrip(", ") and f", {value.rstrip(', ')}", said.rstrip(", ") and f", {said.rstrip(', ')}"
    n = arm.n
    (tmp_path / "unit.cpp").write_text(
        '#include "one.hpp"\nnamespace plain { extern "C" {\n'
        f"int one_ik(const double* T, {value}double (*q)[{n}]) {{ return ::one_ik(T, {said}q); }}\n"
        f"int one_ik_all(const double* T, {value}double (*q)[{n}], int* u) {{ return ::one_ik_all(T, {said}q, u); }}\n"
        f"long one_many(const double* T, long k, {value}double* q, unsigned char* v, unsigned char* i, "
        f"unsigned char* f) {{ return ::one_ik_many(T, k, {said}q, v, i, f); }}\n"
        f"int one_rows(const double* T{last}) {{ return (int)::one_ik(T{told}).size(); }}\n"
        "void one_fk(const double* q, double* T) { ::one_fk(q, T); }\n"
        f"void one_jacobian(const double* q, double (*J)[{n}]) {{ ::one_jacobian(q, J); }}\n"
        "const char* one_label(const double* q) { return ::one_label(q); }\n"
        "int one_self_test() { return ::one_self_test(); }\n} }\n"
    )
    flags = ["-std=c++20", "-O1", "-ffp-contract=fast", *STRICT, "-shared", "-fPIC"]
    subprocess.run(["g++", *flags, "-o", "one.so", "unit.cpp"], cwd=tmp_path, check=True)
    library = ctypes.CDLL(str(tmp_path / "one.so"))
    judged(arm, library, 200 if arm.plan.family == "general" else 500)
    q, T, many = asked(arm, 20)
    at = lambda array: ctypes.c_void_p(array.ctypes.data)  # noqa: E731
    slots = 64
    rows, valid = np.zeros((20, slots, n)), np.zeros((20 * slots,), np.uint8)
    inside, flag, spare = np.zeros_like(valid), np.zeros(20, np.uint8), held(arm)
    for i in range(20):
        v = () if spare is None else (ctypes.c_double(q[i, spare]),)
        assert library.one_many(at(T[i]), ctypes.c_long(1), *v, at(rows), at(valid), at(inside), at(flag)) == 1
        assert inside[:16].sum() == many.in_limits[i].sum() == library.one_rows(at(T[i]), *v)
        inside[:] = 0
    assert library.one_ik(at(np.diag([1.0, 1, -1, 1])), *v, at(rows)) == -1


@pytest.mark.slow
@needs_wasm
@pytest.mark.parametrize("kind", ["half a turn along", "five joints", "spare at the base", "a linkage"])
def test_wasm_takes_and_gives_the_joints_own_numbers(kind, tmp_path):
    arm = ARMS[kind]()
    arm.code("wasm", tmp_path / "solver.mjs")
    run_module(arm, tmp_path, 200)


def test_what_cannot_be_written_down_is_refused_with_the_reason(tmp_path):
    with pytest.raises(pieper.PlanError, match=r"iteration.* arm\.code\('c\+\+', \.\.\.\) .* or 'wasm'"):
        pieper.load("rethink-sawyer").code("c", tmp_path / "x.c")


def test_the_file_says_where_joints_are_held_that_nobody_is_asked_for(tmp_path):
    arm = ARMS["spare in the numbers"]()
    for language, file in (("c", "arm.c"), ("python", "arm.py"), ("javascript", "arm.mjs"), ("c++", "arm.hpp")):
        assert "joint 1 at 0.0" in arm.code(language, tmp_path / file).read_text()
    assert "joint 1 at 0.0" in (arm.code("matlab", tmp_path / "m") / "arm_ik.m").read_text()


def test_joints_without_limits_whose_turns_are_no_whole_ones_are_written_at_once(tmp_path):
    """A calibrated CRX with gains: nineteen whole turns of each of six joints in every combination took gigabytes."""
    free = pieper.load("universal-robots-ur5e")
    free = free.with_limits(dict.fromkeys(free.joint_names))
    arm = pieper.Arm(replace(free.description, coupling=np.diag(1 + 1e-3 * np.arange(1, 7))))
    solver = loaded(arm.code("python", tmp_path / "solver.py"))
    assert len(solver._MOVES) == 1
    q, T, many = asked(arm, 100)
    assert wrong(arm, many, [solver.ik(t) for t in T]) == 0
    assert solver.self_test() == 0
