"""WebAssembly: the arm's C++ compiled by zig, without imports; alone, or inside a JavaScript module."""

from __future__ import annotations

import base64
import importlib.util
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from pieper.code import cpp
from pieper.code.export import Export
from pieper.code.language import filled
from pieper.errors import InputError

API = """#define NAME_PLAIN
#include "arm.hpp"
#include <stdlib.h>
#define PIEPER_EXPORT(name) __attribute__((export_name(name)))
void* operator new(size_t size) { return malloc(size); }
void operator delete(void* p) noexcept { free(p); }
void operator delete(void* p, size_t) noexcept { free(p); }
extern "C" {
/* A destructor that never comes: the module ends with the page. */
int __cxa_atexit(void (*)(void*), void*, void*) { return 0; }
PIEPER_EXPORT("alloc") void* w_alloc(int bytes) { return malloc(bytes); }
PIEPER_EXPORT("release") void w_release(void* p) { free(p); }
PIEPER_EXPORT("NAME_slots") int w_slots() { return @SLOTS@; }
PIEPER_EXPORT("NAME_ik") int w_ik(const double* T, @VALUE@double (*q)[N]) { return NAME_ik(T, @VALUE_SAID@q); }
PIEPER_EXPORT("NAME_ik_all") int w_all(const double* T, @VALUE@double (*q)[N], int* unclear) {
  return NAME_ik_all(T, @VALUE_SAID@q, unclear);
}
PIEPER_EXPORT("NAME_ik_many") long w_many(const double* T, long count, @VALUE@double* q, unsigned char* valid,
                                        unsigned char* inside, unsigned char* flag) {
  return NAME_ik_many(T, count, @VALUE_SAID@q, valid, inside, flag);
}
PIEPER_EXPORT("NAME_fk") void w_fk(const double* q, double* T) { NAME_fk(q, T); }
PIEPER_EXPORT("NAME_jacobian") void w_jacobian(const double* q, double (*J)[N]) { NAME_jacobian(q, J); }
PIEPER_EXPORT("NAME_label") const char* w_label(const double* q) { return NAME_label(q); }
PIEPER_EXPORT("NAME_self_test") int w_test() { return NAME_self_test(); }
}
"""

MODULE = """/*
@HEADER@

The kernel as WebAssembly inside this module; nothing is fetched. ik(T): every joint vector inside the limits, an array
of arrays; T as 16 numbers row by row, or as 4 rows of 4; a rotation that was rounded is taken as the nearest one, and
what is no rigid motion throws a RangeError. ikAll(T): {rows, unclear} before limits.
fk(q): 4 rows of 4. jacobian(q): 6 rows, linear ones first. label(q): the posture's name. selfTest():
stored poses that fail, 0.
*/
const bytes = Uint8Array.from(atob("@BYTES@"), (letter) => letter.charCodeAt(0));
const wasm = (await WebAssembly.instantiate(bytes, {})).instance.exports;
if (wasm._initialize) wasm._initialize();
const SLOTS = wasm.NAME_slots();
const at = { T: wasm.alloc(128), q: wasm.alloc(8 * N * SLOTS), J: wasm.alloc(48 * N), unclear: wasm.alloc(4) };
const numbers = (where, count) => new Float64Array(wasm.memory.buffer, where, count);
const rowsOf = (where, count, width) =>
  Array.from({ length: count }, (_, i) => Array.from(numbers(where + 8 * width * i, width)));
const flat = (pose) => (pose.length === 16 ? pose : [].concat(...pose.map((row) => Array.from(row))));
const put = (pose) => numbers(at.T, 16).set(flat(pose));

const held = (count) => {
  if (count < 0) throw new RangeError("the pose is no rigid motion");
  return count;
};

export function ik(pose@VALUE_JS@) {
  put(pose);
  const count = wasm.NAME_ik(at.T, @VALUE_SAID@at.q);
  return rowsOf(at.q, held(count), N);
}
export function ikAll(pose@VALUE_JS@) {
  put(pose);
  const count = wasm.NAME_ik_all(at.T, @VALUE_SAID@at.q, at.unclear);
  held(count);
  const unclear = new Int32Array(wasm.memory.buffer, at.unclear, 1)[0] !== 0;
  return { rows: rowsOf(at.q, count, N), unclear };
}
export function fk(q) {
  numbers(at.q, N).set(q);
  wasm.NAME_fk(at.q, at.T);
  return rowsOf(at.T, 4, 4);
}
export function jacobian(q) {
  numbers(at.q, N).set(q);
  wasm.NAME_jacobian(at.q, at.J);
  return rowsOf(at.J, 6, N);
}
export function label(q) {
  numbers(at.q, N).set(q);
  const where = wasm.NAME_label(at.q), letters = new Uint8Array(wasm.memory.buffer, where);
  return String.fromCharCode(...letters.subarray(0, letters.indexOf(0)));
}
export const selfTest = () => wasm.NAME_self_test();
"""
#: For size: a quarter smaller than -O2 and as fast, the general solver apart, which takes one part in twenty longer.
FLAGS = (
    *("-target", "wasm32-wasi", "-mexec-model=reactor", "-std=gnu++20", "-Os", "-msimd128"),
    *("-fno-exceptions", "-fno-rtti", "-fno-threadsafe-statics", "-fno-math-errno", "-fno-trapping-math"),
    *("-ffp-contract=fast", "-Wl,--strip-all"),
)


def compiled(sources: dict[str, str], unit: str) -> bytes:
    """Return the WebAssembly of a unit among sources {name: text}.

    Raises:
        InputError: There is no zig, or it failed.
    """
    if importlib.util.find_spec("ziglang") is None:
        raise InputError("WebAssembly is compiled by zig, which is an extra: pip install 'pieper[wasm]'.")
    with tempfile.TemporaryDirectory(prefix="pieper-wasm-") as name:
        folder = Path(name)
        for file, text in sources.items():
            (folder / file).write_text(text)
        environment = dict(os.environ)
        # zig keeps what it once built of its own library; without a home there is a place for this time
        environment.setdefault("ZIG_LOCAL_CACHE_DIR", str(folder / "cache"))
        if not os.environ.get("HOME"):
            environment.setdefault("ZIG_GLOBAL_CACHE_DIR", str(folder / "cache"))
        command = [sys.executable, "-m", "ziglang", "c++", *FLAGS, "-o", "out.wasm", unit]
        ran = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=False)
        if ran.returncode:
            raise InputError(f"zig could not compile the arm: {ran.stderr.strip()[-500:]}")
        return (folder / "out.wasm").read_bytes()


def content(export: Export, suffix: str) -> bytes:
    """Return the file: WebAssembly as it is, or for .mjs a module that holds it."""
    held = export.between.held is not None
    parts = {
        "SLOTS": str(export.solved.spec.max_solutions),
        "HEADER": "\n".join(export.header).replace("*/", "* /"),
        "VALUE": "double value, " if held else "",
        "VALUE_SAID": "value, " if held else "",
        "VALUE_JS": f", value = {export.between.default!r}" if held else "",
    }
    code = compiled({"arm.hpp": cpp.text(export), "unit.cpp": filled(API, parts, export)}, "unit.cpp")
    if suffix != ".mjs":
        return code
    return filled(MODULE, parts | {"BYTES": base64.b64encode(code).decode()}, export).encode()
