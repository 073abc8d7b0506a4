"""How an exported file is run on many poses, a language at a time: rows inside the limits, how many a pose, seconds."""

from __future__ import annotations

import ctypes
import importlib.util
import json
import runpy
import shutil
import subprocess
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np

from pieper.kinematics.arrays import Array, Bools, Indices

#: Poses that the languages of arrays take at once.
BLOCK = 5_000
#: How often what is compiled is run over all poses; the least time counts.
LOOPS = 3


class Asked(NamedTuple):
    """What a solver is asked: joint vectors (N, n), poses (N, 4, 4), and which joint is held, if one is."""

    q: Array
    T: Array
    spare: int | None


class Found(NamedTuple):
    """What it says: rows inside the limits (k, n), how many there are of each pose (N,), and how long it took, s.

    And which poses it says are unclear (N,); None where it was not asked.
    """

    rows: Array
    counts: Indices
    seconds: float
    unclear: Bools | None = None


@dataclass(frozen=True)
class Ran:
    """A language on this machine.

    Args:
        file: What the exported file is called.
        run: Runs it.
        there: Whether it can run here.
    """

    file: str
    run: Callable[[Path, Asked], Found]
    there: Callable[[], bool]


def tool(*names: str) -> Callable[[], bool]:
    """Return whether programs are there."""
    return lambda: all(shutil.which(name) for name in names)


def package(name: str, *programs: str) -> Callable[[], bool]:
    """Return whether a package and programs are there."""
    return lambda: importlib.util.find_spec(name) is not None and tool(*programs)()


def _called(path: Path, ask: Asked, head: str, command: list[str]) -> Found:
    """Compile C or C++ around one_ik, and run it in one loop."""
    n = ask.q.shape[1]
    value = "" if ask.spare is None else f"q[{n} * i + {ask.spare}], "
    unit = path.with_name("loop" + path.suffix.replace("hpp", "cpp"))
    unit.write_text(
        f'#include "{path.name}"\n{head}void all(const double *T, const double *q, long count, double (*out)[{n}], '
        f"long *counts) {{\n  long i;\n  (void)q;\n  for (i = 0; i < count; ++i) {{\n"
        f"    counts[i] = one_ik(T + 16 * i, {value}out);\n    out += counts[i];\n  }}\n}}\n"
    )
    made = path.parent / "loop.so"
    subprocess.run([*command, "-shared", "-fPIC", "-o", made, unit, "-lm"], check=True)
    library, counts = ctypes.CDLL(str(made)), np.zeros(len(ask.T), np.int64)
    out = np.zeros((len(ask.T) * (8 if path.suffix == ".c" else 16) + 16, n))
    at = lambda array: ctypes.c_void_p(array.ctypes.data)  # noqa: E731
    took = []
    for _ in range(LOOPS):
        start = time.process_time()
        library.all(at(ask.T), at(ask.q), ctypes.c_long(len(ask.T)), at(out), at(counts))
        took.append(time.process_time() - start)
    return Found(out, counts, min(took))


def run_c(path: Path, ask: Asked) -> Found:
    """Run C, compiled by gcc -O2."""
    return _called(path, ask, "", ["gcc", "-O2"])


def run_cpp(path: Path, ask: Asked) -> Found:
    """Run C++, compiled by g++ -O1, which takes half the time of -O3."""
    return _called(path, ask, 'extern "C" ', ["g++", "-std=c++20", "-O1", "-march=native", "-ffp-contract=fast"])


def _in_blocks(ask: Asked, rows_of: Callable[[Array, tuple[Array, ...]], tuple[Array, Bools, Bools]]) -> Found:
    rows, counts, doubts, start = [], [], [], time.process_time()
    for first in range(0, len(ask.T), BLOCK):
        at = np.s_[first : first + BLOCK]
        found, inside, unclear = rows_of(ask.T[at], () if ask.spare is None else (ask.q[at, ask.spare],))
        rows.append(found[inside])
        counts.append(inside.sum(1))
        doubts.append(unclear)
    seconds = time.process_time() - start
    return Found(np.concatenate(rows), np.concatenate(counts), seconds, np.concatenate(doubts))


def run_python(path: Path, ask: Asked) -> Found:
    """Run the NumPy file on blocks of poses."""
    solver: Any = SimpleNamespace(**runpy.run_path(str(path)))

    def rows_of(T: Array, values: tuple[Array, ...]) -> tuple[Array, Bools, Bools]:
        found, valid, unclear = solver.ik_all(T, *values)
        found, inside = solver._inside(found)
        return found, inside & valid, unclear

    return _in_blocks(ask, rows_of)


def run_jax(path: Path, ask: Asked) -> Found:
    """Run the JAX file, compiled, on blocks of poses."""
    solver: Any = SimpleNamespace(**runpy.run_path(str(path)))

    def rows_of(T: Array, values: tuple[Array, ...]) -> tuple[Array, Bools, Bools]:
        found, _, inside, unclear = map(np.asarray, solver._compiled(T, *values))
        return found, inside, unclear

    return _in_blocks(ask, rows_of)


def run_node(path: Path, ask: Asked) -> Found:
    """Run a module, JavaScript or WebAssembly within, in Node."""
    folder, value = path.parent, "" if ask.spare is None else f", q[{ask.q.shape[1]} * i + {ask.spare}]"
    (folder / "q.bin").write_bytes(ask.q.tobytes())
    (folder / "T.bin").write_bytes(ask.T.tobytes())
    (folder / "run.mjs").write_text(
        f"import fs from 'fs';\nimport {{ ik }} from './{path.name}';\n"
        "const read = (name) => { const b = fs.readFileSync(name); "
        "return new Float64Array(b.buffer, b.byteOffset, b.length / 8); };\n"
        "const q = read('q.bin'), T = read('T.bin'), rows = [], counts = [], start = process.cpuUsage().user;\n"
        f"for (let i = 0; 16 * i < T.length; ++i) {{ const found = ik(T.subarray(16 * i, 16 * i + 16){value}); "
        "counts.push(found.length); for (const row of found) rows.push(...row); }\n"
        "const took = process.cpuUsage().user - start;\n"
        "fs.writeFileSync('rows.bin', Buffer.from(new Float64Array(rows).buffer));\n"
        "console.log(JSON.stringify({ counts, took }));\n"
    )
    ran = subprocess.run(["node", "run.mjs"], cwd=folder, capture_output=True, text=True, check=True)
    said = json.loads(ran.stdout)
    rows = np.fromfile(folder / "rows.bin").reshape(-1, ask.q.shape[1])
    return Found(rows, np.array(said["counts"]), said["took"] / 1e6)


def run_octave(path: Path, ask: Asked) -> Found:
    """Run the folder of MATLAB functions in Octave, on blocks of poses."""
    folder, value = path, "" if ask.spare is None else f", q(some, {ask.spare + 1})"
    for name, array in (("T", ask.T.reshape(-1, 16)), ("q", ask.q)):
        (folder / f"{name}.bin").write_bytes(array.tobytes())
    n = ask.q.shape[1]
    (folder / "run_it.m").write_text(
        "function run_it()\n"
        "  T = numbers('T.bin', 16);\n"
        f"  q = numbers('q.bin', {n});\n"
        f"  count = size(T, 1); counts = zeros(count, 1); rows = zeros(16 * count, {n}); last = 0;\n"
        "  start = cputime();\n"
        f"  for first = 1:{BLOCK}:count\n"
        f"    some = first:min(first + {BLOCK - 1}, count);\n"
        f"    [found, of] = one_ik_many(permute(reshape(T(some, :)', 4, 4, []), [2 1 3]){value});\n"
        "    counts(some) = accumarray(of, 1, [numel(some), 1]);\n"
        "    rows(last + 1:last + size(found, 1), :) = found;\n"
        "    last = last + size(found, 1);\n"
        "  end\n"
        "  took = cputime() - start;\n"
        "  written('counts.bin', counts); written('took.bin', took); written('rows.bin', rows(1:last, :)');\n"
        "end\n"
        "function A = numbers(name, width)\n"
        "  f = fopen(name); A = fread(f, [width, Inf], 'double')'; fclose(f);\n"
        "end\n"
        "function written(name, A)\n"
        "  f = fopen(name, 'w'); fwrite(f, A, 'double'); fclose(f);\n"
        "end\n"
    )
    subprocess.run(["octave-cli", "--no-gui", "-q", "--eval", "run_it"], cwd=folder, capture_output=True, check=True)
    counts = np.fromfile(folder / "counts.bin").astype(np.int64)
    return Found(np.fromfile(folder / "rows.bin").reshape(-1, n), counts, float(np.fromfile(folder / "took.bin")[0]))


LANGUAGES = {
    "c": Ran("solver.c", run_c, tool("gcc")),
    "python": Ran("solver.py", run_python, lambda: True),
    "javascript": Ran("solver.mjs", run_node, tool("node")),
    "c++": Ran("solver.hpp", run_cpp, tool("g++")),
    "jax": Ran("solver.py", run_jax, package("jax")),
    "wasm": Ran("solver.mjs", run_node, package("ziglang", "node")),
    "matlab": Ran("solver", run_octave, tool("octave-cli")),
}
