"""Exported MATLAB (run in Octave), JAX and WebAssembly give what the native solver gives."""

from __future__ import annotations

import importlib.util
import shutil
import subprocess

import numpy as np
import pytest

import pieper
from pieper.solver.words.labels import posture_words
from tests.code.test_export import (
    ARMS,
    REFUSED_BY_NODE,
    differing,
    loaded,
    no_poses,
    poses,
    said_by_node,
    written_down,
)

needs_octave = pytest.mark.skipif(shutil.which("octave-cli") is None, reason="no octave")
needs_wasm = pytest.mark.skipif(
    importlib.util.find_spec("ziglang") is None or shutil.which("node") is None, reason="no zig or no node"
)


def octave(folder, script):
    (folder / "run_it.m").write_text(script)
    ran = subprocess.run(
        ["octave-cli", "--no-gui", "-q", "--eval", "run_it"], cwd=folder, capture_output=True, text=True, timeout=300
    )
    assert "run_it done" in ran.stdout, ran.stderr[-2000:]
    return ran.stdout


@needs_octave
@pytest.mark.parametrize("name", ARMS)
def test_matlab_gives_the_native_rows(name, tmp_path):
    arm = pieper.load(name)
    assert arm.code("matlab", tmp_path / "robot.m", "one") == tmp_path / "robot.m"
    q, exact = poses(arm, 150)
    T = written_down(exact)
    np.savetxt(tmp_path / "no.txt", no_poses().reshape(-1, 16), fmt="%.17g")
    np.savetxt(tmp_path / "T.txt", T.reshape(-1, 16), fmt="%.17g")
    np.savetxt(tmp_path / "q0.txt", q[:1], fmt="%.17g")
    octave(
        tmp_path,
        "T = load('T.txt'); s = robot(); out = zeros(0, 9);\n"
        "for i = 1:size(T, 1)\n  pose = reshape(T(i, :), 4, 4)';\n  [q, unclear] = one_ik_all(pose);\n"
        "  r = s.ik(pose);\n  out = [out; i * ones(size(q, 1), 1), unclear * ones(size(q, 1), 1), "
        "zeros(size(q, 1), 1), q; i * ones(size(r, 1), 1), unclear * ones(size(r, 1), 1), "
        "ones(size(r, 1), 1), r];\nend\n"
        "dlmwrite('out.txt', out, 'precision', '%.17g');\n[P, J] = one_fk(load('q0.txt'));\n"
        "dlmwrite('fk.txt', [P(:)', J(:)'], 'precision', '%.17g', 'delimiter', ' ');\n"
        "dlmwrite('failed.txt', one_self_test());\nfile = fopen('names.txt', 'w');\n"
        "for i = 1:size(out, 1)\n  fprintf(file, '%s\\n', one_label(out(i, 4:9)));\nend\nfclose(file);\n"
        "no = load('no.txt'); refused = 0;\nfor i = 1:size(no, 1)\n  try, s.ik(reshape(no(i, :), 4, 4)');\n"
        "  catch e, refused = refused + ~isempty(strfind(e.message, 'no rigid motion')); end\n"
        "  try, s.ik_many(reshape(no(i, :), 4, 4)');\n"
        "  catch e, refused = refused + ~isempty(strfind(e.message, 'no rigid motion')); end\nend\n"
        "[q, of, unclear] = s.ik_many(permute(reshape(T', 4, 4, []), [2 1 3]));\n"
        "dlmwrite('many.txt', [of, unclear(of), ones(size(of)), q], 'precision', '%.17g');\n"
        "dlmwrite('refused.txt', refused);\ndisp('run_it done')\n",
    )
    assert float(np.loadtxt(tmp_path / "refused.txt")) == 12
    out = np.loadtxt(tmp_path / "out.txt", delimiter=",", ndmin=2)
    many = np.loadtxt(tmp_path / "many.txt", delimiter=",", ndmin=2)
    assert np.abs(many - out[out[:, 2] == 1]).max() < 1e-9
    for inside in (0, 1):
        part = out[out[:, 2] == inside]
        rows = [part[part[:, 0] == i + 1, 3:] for i in range(len(T))]
        unclear = [bool(part[part[:, 0] == i + 1, 1].any()) for i in range(len(T))]
        assert differing(arm, T, rows, unclear, inside=bool(inside)) == 0
    assert (tmp_path / "names.txt").read_text().splitlines() == posture_words(arm.plan, out[:, 3:])
    both = np.loadtxt(tmp_path / "fk.txt")
    assert np.abs(both[:16].reshape(4, 4, order="F") - T[0]).max() < 1e-13
    assert np.abs(both[16:].reshape(6, 6, order="F") - arm.jacobian(q[0])).max() < 1e-13
    assert float(np.loadtxt(tmp_path / "failed.txt")) == 0


def test_matlab_goes_into_a_folder_a_file_a_function(tmp_path):
    arm = pieper.load("denso-vp6242")
    folder = arm.code("matlab", tmp_path / "solver", "denso")
    names = sorted(p.name for p in folder.iterdir())
    whats = ("fk", "ik", "ik_all", "ik_many", "inside", "label", "rows", "self_test")
    assert names == [f"denso_{what}.m" for what in whats]
    arm.code("matlab", tmp_path / "denso_ik.m", "denso")
    assert "function q = denso_ik(T)" in (tmp_path / "denso_ik.m").read_text()
    (tmp_path / "file").write_text("")
    with pytest.raises(pieper.InputError, match="Name a folder"):
        arm.code("matlab", tmp_path / "file", "denso")


@pytest.mark.parametrize("name", ARMS)
def test_jax_gives_the_native_rows(name, tmp_path):
    pytest.importorskip("jax")
    arm = pieper.load(name)
    solver = loaded(arm.code("jax", tmp_path / "solver.py", "one"))
    q, exact = poses(arm)
    T = written_down(exact)
    rows, valid, inside, unclear = map(np.asarray, solver._compiled(T))
    assert differing(arm, T, [r[v] for r, v in zip(rows, valid, strict=True)], unclear) == 0
    assert differing(arm, T, [r[v] for r, v in zip(rows, inside, strict=True)], unclear, inside=True) == 0
    assert np.asarray(solver.one_ik(T[0])).shape == solver.ik(T[0]).shape == (inside[0].sum(), 6)
    for pose in no_poses():
        with pytest.raises(ValueError, match="no rigid motion"):
            solver.ik(pose)
        there, mixed = solver.one_ik_all(np.stack([T[0], pose]))[1::2]
        assert not there[1].any() and mixed[1]
    assert np.abs(np.asarray(solver.fk(q[0])) - T[0]).max() < 1e-12
    assert np.abs(np.asarray(solver.one_jacobian(q[0])) - arm.jacobian(q[0])).max() < 1e-12
    assert [solver.one_label(row) for row in q[:100]] == posture_words(arm.plan, q[:100])
    assert solver.one_self_test() == 0


@needs_wasm
@pytest.mark.slow
@pytest.mark.parametrize("name", ["denso-vp6242", "fanuc-crx-10ia"])
def test_wasm_gives_the_native_rows(name, tmp_path):
    arm = pieper.load(name)
    arm.code("wasm", tmp_path / "arm.wasm", "one")
    arm.code("wasm", tmp_path / "arm.mjs", "one")
    T = written_down(poses(arm)[1])
    said = said_by_node(
        tmp_path,
        T,
        "import { ik, ikAll, fk, jacobian, label, selfTest } from './arm.mjs';\n"
        "const module = new WebAssembly.Module(fs.readFileSync('arm.wasm'));\n"
        "const q = out[0].rows[0], T = fk(q);\n"
        "console.log(JSON.stringify({ out, q, J: jacobian(q), name: label(q), failed: selfTest(), rows: ik(T).length,\n"
        f"  refused: [{REFUSED_BY_NODE}],\n"
        "  imports: WebAssembly.Module.imports(module).length,\n"
        "  exports: WebAssembly.Module.exports(module).map((e) => e.name) }));\n",
    )
    assert said["failed"] == 0 and said["imports"] == 0 and said["refused"] == ["no rigid motion"] * 6
    assert {"memory", "alloc", "one_ik", "one_fk", "one_ik_many"} <= set(said["exports"])
    assert np.abs(np.array(said["J"]) - arm.jacobian(np.array(said["q"]))).max() < 1e-12
    assert [said["name"]] == posture_words(arm.plan, np.array([said["q"]]))
    assert differing(arm, T, [r["rows"] for r in said["out"]], [r["unclear"] for r in said["out"]]) == 0


def test_without_zig_wasm_says_what_to_install(tmp_path, monkeypatch):
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    with pytest.raises(pieper.InputError, match=r"pieper\[wasm\]"):
        pieper.load("denso-vp6242").code("wasm", tmp_path / "arm.wasm")
