"""Exported solvers give what the native one gives, in C, Python and JavaScript."""

from __future__ import annotations

import ctypes
import importlib.util
import json
import re
import shutil
import subprocess

import numpy as np
import pytest

import pieper
from pieper.solver.words.labels import posture_words, sides
from pieper.tolerances import NO_SIDE

#: Every family and kind that is exported: tilted, offset, slides, wrist inside, UR.
ARMS = (
    "denso-vp6242",
    "universal-robots-ur5e",
    "universal-robots-ur10e",
    "jaka-zu30",
    "stanford-arm",
    "rrp-wrist",
    "abb-irb4400l-30-243",
    "fanuc-r2000ic-165f",
    "kuka-kr3-r540",
    "motoman-hc20",
    "unimation-puma-560",
)
POSES = 10_000
needs_gcc = pytest.mark.skipif(shutil.which("gcc") is None, reason="no gcc")
needs_node = pytest.mark.skipif(shutil.which("node") is None, reason="no node")


def written_down(T):
    """Return poses (N, 4, 4) of which every second one is rounded, as people and files round: to digits, to float32."""
    T = T.copy()
    for k, places in enumerate((6, 8, 10, 12)):
        T[1 + 2 * k :: 10] = np.round(T[1 + 2 * k :: 10], places)
    T[9::10] = np.float32(T[9::10])
    return T


def no_poses():
    """Return matrices (6, 4, 4) that are no rigid motion: scaled, sheared, a mirror, no numbers, another last row."""
    T = np.tile(np.eye(4), (6, 1, 1))
    T[0, :3, :3] *= 1.001
    T[1, 0, 1], T[2, 2, 2], T[3, 0, 0], T[4, 0, 3], T[5, 3, 3] = 1e-3, -1.0, np.nan, np.inf, 1.1
    return T


def poses(arm, count=POSES, seed=3):
    rng = np.random.default_rng(seed)
    reach = np.where(arm.chain.prismatic, 1.0, np.pi)[:, None] * [-1.0, 1.0]
    limits = np.clip(np.where(np.isfinite(arm.limits), arm.limits, reach), reach[:, :1], reach[:, 1:])
    q = rng.uniform(limits[:, 0], limits[:, 1], (count, arm.n))
    return q, np.ascontiguousarray(arm.fk(q))


def differing(arm, T, rows, unclear, inside=False):
    """Return at how many poses rows are not the native ones; unclear poses may lack some, but add none."""
    many = arm.ik_many(T, threads=1)
    known = many.in_limits if inside else many.valid
    out = 0
    for i, found in enumerate(rows):
        wanted = many.q[i][known[i]]
        gap = arm.chain.joints.apart(np.reshape(found, (-1, 1, arm.n)), wanted[None])
        every = len(found) == len(wanted) or (unclear[i] and len(found) < len(wanted))
        out += not (every and (len(found) == 0 or (gap.min(1, initial=np.inf) < 1e-7).all()))
    return out


def loaded(path):
    spec = importlib.util.spec_from_file_location(path.stem, path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@needs_gcc
@pytest.mark.parametrize("name", ARMS)
def test_c_gives_the_native_rows(name, tmp_path):
    arm = pieper.load(name)
    source, library = arm.code("c", tmp_path / "arm.c", "one"), tmp_path / "arm.so"
    strict = ["gcc", "-std=c99", "-O2", "-Wall", "-Wextra", "-Werror"]
    subprocess.run([*strict, "-shared", "-fPIC", "-o", library, source, "-lm"], check=True)
    subprocess.run([*strict, "-Done_MAIN", "-o", tmp_path / "arm", source, "-lm"], check=True)
    assert (
        "0 of 20 poses failed" in subprocess.run([tmp_path / "arm"], capture_output=True, text=True, check=True).stdout
    )
    solver, numbers = ctypes.CDLL(str(library)), ctypes.POINTER(ctypes.c_double)
    q, exact = poses(arm)
    T = written_down(exact)
    rows, inside, unclear = [], [], []
    room, flag = np.zeros((8, 6)), ctypes.c_int()
    for pose in T:
        at = pose.ctypes.data_as(numbers)
        count = solver.one_ik_all(at, room.ctypes.data_as(numbers), ctypes.byref(flag))
        rows.append(room[:count].copy())
        unclear.append(bool(flag.value))
        inside.append(room[: solver.one_ik(at, room.ctypes.data_as(numbers))].copy())
    assert np.mean(unclear) < 0.01
    assert differing(arm, T, rows, unclear) == 0
    assert differing(arm, T, inside, unclear, inside=True) == 0
    assert source.stat().st_size <= 40_000
    J = np.zeros((6, 6))
    solver.one_jacobian(q[0].ctypes.data_as(numbers), J.ctypes.data_as(numbers))
    assert np.abs(J - arm.jacobian(q[0])).max() < 1e-13
    for pose in no_poses():
        at = pose.ctypes.data_as(numbers)
        assert solver.one_ik(at, room.ctypes.data_as(numbers)) == -1
        assert solver.one_ik_all(at, room.ctypes.data_as(numbers), ctypes.byref(flag)) == -1
    solver.one_label.restype = ctypes.c_char_p
    said = [solver.one_label(row.ctypes.data_as(numbers)).decode() for row in q[:500]]
    assert said == posture_words(arm.plan, q[:500])


@pytest.mark.parametrize("name", ARMS)
def test_numpy_gives_the_native_rows(name, tmp_path):
    arm = pieper.load(name)
    text = (path := arm.code("python", tmp_path / "solver.py")).read_text()
    assert set(re.findall(r"^(?:import|from) (\w+)", text, re.M)) == {"numpy"}
    solver = loaded(path)
    q, exact = poses(arm)
    T = written_down(exact)
    rows, valid, unclear = solver.ik_all(T)
    assert differing(arm, T, [r[v] for r, v in zip(rows, valid, strict=True)], unclear) == 0
    assert solver.self_test() == 0
    assert np.abs(solver.fk(q) - exact).max() < 1e-12
    for k, pose in enumerate(no_poses()):
        with pytest.raises(ValueError, match=r"Ts\[0\] is no rigid motion"):
            solver.ik(pose)
        with pytest.raises(ValueError, match=rf"Ts\[{k + 1}\] is no rigid motion"):
            solver.ik_all(np.concatenate([T[: k + 1], pose[None]]))
    assert np.abs(solver.jacobian(q[:50]) - arm.jacobian(q[:50])).max() < 1e-12
    edges = np.round(q[:500] / (np.pi / 2)) * (np.pi / 2)
    # where the wrist stands on axis 1, rounding decides which way somebody faces
    edges = edges[np.abs(sides(arm.plan, edges)[0].values) > NO_SIDE]
    assert [solver.label(row) for row in [*q, *edges]] == posture_words(arm.plan, np.concatenate([q, edges]))
    assert differing(arm, T[:50], [solver.ik(pose) for pose in T[:50]], unclear, inside=True) == 0


#: What ik says of matrices that are no rigid motion, in JavaScript.
REFUSED_BY_NODE = (
    ", ".join(
        f"(() => {{ try {{ return ik({row.tolist()}).length; }} catch (e) {{ return e.message.slice(12, 27); }} }})()"
        for row in no_poses().reshape(-1, 16)
    )
    .replace("inf", "Infinity")
    .replace("nan", "NaN")
)


def said_by_node(folder, T, program):
    """Return what a program says of a module's rows of poses, `out`, which it finds made, as JSON."""
    (folder / "poses.bin").write_bytes(T.tobytes())
    imports, rest = program.split("\n", 1)
    (folder / "run.mjs").write_text(
        f"import fs from 'fs';\n{imports}\n"
        "const b = fs.readFileSync('poses.bin'), out = [];\n"
        "const t = new Float64Array(b.buffer, b.byteOffset, b.length / 8);\n"
        f"for (let i = 0; i < t.length; i += 16) out.push(ikAll(t.subarray(i, i + 16)));\n{rest}"
    )
    ran = subprocess.run(["node", "run.mjs"], cwd=folder, capture_output=True, text=True, check=True)
    return json.loads(ran.stdout)


@needs_node
@pytest.mark.parametrize("name", ARMS)
def test_javascript_gives_the_native_rows(name, tmp_path):
    arm = pieper.load(name)
    arm.code("javascript", tmp_path / "solver.mjs")
    arm.code("javascript", tmp_path / "solver.js")
    T = written_down(poses(arm)[1])
    said = said_by_node(
        tmp_path,
        T,
        "import { ikAll, ik, fk, label, selfTest } from './solver.mjs';\n"
        f"const refused = [{REFUSED_BY_NODE}];\n"
        "const T = fk(out[0].rows[0]);\n"
        "const names = out.slice(0, 500).map((o) => o.rows.map(label));\n"
        "const counts = { refused, failed: selfTest(), rows: ik(T).length, flat: ik(T.flat()).length };\n"
        "console.log(JSON.stringify({ out, names, ...counts }));\n",
    )
    assert said["failed"] == 0 and said["refused"] == ["no rigid motion"] * 6
    assert said["rows"] == said["flat"]
    assert differing(arm, T, [r["rows"] for r in said["out"]], [r["unclear"] for r in said["out"]]) == 0
    for found, names in zip(said["out"], said["names"], strict=False):
        assert names == posture_words(arm.plan, np.reshape(found["rows"], (-1, arm.n)))
    script = "console.log(require('./solver.js').selfTest())"
    assert subprocess.run(["node", "-e", script], cwd=tmp_path, capture_output=True, text=True).stdout.strip() == "0"


@pytest.mark.parametrize("name", ["denso-vp6242", "universal-robots-ur5e", "stanford-arm"])
def test_rows_at_singular_poses_hold_and_the_pose_is_said_to_be_unclear(name, tmp_path):
    arm = pieper.load(name)
    solver = loaded(arm.code("python", tmp_path / "solver.py"))
    q = np.random.default_rng(2).uniform(-1, 1, (200, 6))
    q[:, 4] = 0.0
    T = arm.fk(q)
    singular = np.linalg.svd(arm.jacobian(q), compute_uv=False)[:, -1] < 1e-9
    rows, valid, unclear = solver.ik_all(T)
    assert unclear[singular].all()
    assert np.abs(solver.fk(rows[valid]) - np.repeat(T, valid.sum(1), 0)).max() < 1e-8


@pytest.mark.parametrize("name", pieper.catalog())
def test_an_arm_is_exported_or_refused_with_its_reason(name, tmp_path):
    arm = pieper.load(name)
    try:
        path = arm.code("python", tmp_path / "solver.py")
    except pieper.PlanError as refused:
        assert name in str(refused) and len(str(refused)) > 60
        assert not (tmp_path / "solver.py").exists()
    else:
        assert loaded(path).self_test() == 0


def test_other_words_are_refused(tmp_path):
    arm = pieper.load("denso-vp6242")
    with pytest.raises(pieper.InputError, match="must be 'c', "):
        arm.code("cobol", tmp_path / "x")
    with pytest.raises(pieper.InputError, match="a word"):
        arm.code("c", tmp_path / "x.c", "two words")
    with pytest.raises(pieper.InputError):
        arm.code("c", tmp_path / "none" / "x.c")


def test_a_path_that_ends_as_another_language_does_is_refused_and_not_written(tmp_path):
    arm = pieper.load("denso-vp6242")
    for language, ending in (("c", "py"), ("python", "c"), ("c++", "c"), ("matlab", "py"), ("jax", "m"), ("c", "MJS")):
        with pytest.raises(pieper.InputError, match=r"ends as a file of .* asked for\. Name another file, or ask for"):
            arm.code(language, tmp_path / f"x.{ending}")
        assert not list(tmp_path.iterdir())
    with pytest.raises(pieper.InputError, match="begins with no digit"):
        arm.code("c", tmp_path / "x.c", "9x")


def test_the_head_says_where_it_comes_from(tmp_path):
    arm = pieper.load("denso-vp6242")
    for language, ending in (("c", "c"), ("python", "py"), ("javascript", "mjs")):
        head = arm.code(language, tmp_path / f"a.{ending}").read_text()[:900]
        assert "denso-vp6242" in head and "sha256" in head and "licence" in head and "Written by pieper" in head


@pytest.mark.parametrize("language", ["python", "jax"])
@pytest.mark.parametrize("name", ["stanford-arm", "adept-cobra-600", "franka-panda"])
def test_how_many_poses_are_taken_is_not_how_many_joints_there_are(name, language, tmp_path):
    text = pieper.load(name).code(language, tmp_path / "solver.py").read_text()
    assert "takes poses (k, 4, 4)" in text and not re.search(r"poses \(\d", text)
