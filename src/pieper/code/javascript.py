"""The printer of JavaScript: a module (.mjs), or a script that serves Node and pages alike."""

from __future__ import annotations

from pieper.code.between import held_words
from pieper.code.export import Export
from pieper.code.labels import Manner
from pieper.code.language import USUAL, Language, filled, functions
from pieper.tolerances import FILLED_ZERO

JAVASCRIPT = Language(
    words=USUAL | functions("Math.") | {"angle": "angle({0}, {1})", "eq": "{0} === {1}", "ne": "{0} !== {1}"},
    assign=lambda name, _, expression: f"  const {name} = {expression};",
    infinity="Infinity",
    truths=("false", "true"),
    manner=Manner("Math.sin({0})", "Math.cos({0})", "q[{0}]", 0, "  const {0} = {1};", "side({0}, {1})"),
    per_row=("[{}]", ", "),
)


FRAME = """/*
@HEADER@

@SAID@ik(T): every joint vector inside the limits that reaches a pose, an array of arrays; T as 16 numbers row by
row, or as 4 rows of 4. ikAll(T): {rows, unclear} before limits; unclear at and next to singular poses, where a row may
stand for many and rows may be missing. fk(q): the pose as 4 rows of 4. jacobian(q): 6 rows, linear ones first.
label(q): the posture's name, such as "front, elbow up, wrist flip"; "" where the postures of this arm have none.
*/
const LOWER = @LOWER@;
const UPPER = @UPPER@;
const SLIDES = @SLIDES@;
const LINKS = @LINKS@;
const TURN = 6.28318530717958647693;

// An angle that rounds to -pi is said as pi.
function angle(y, x) {
  const r = Math.atan2(y, x);
  return r <= -Math.PI ? Math.PI : r;
}

function walk(q, visit) {
  const T = LINKS[0].slice();
  for (let i = 0; i < N; ++i) {
    const c = Math.cos(q[i]), s = Math.sin(q[i]), L = LINKS[i + 1];
    if (visit) visit(i, T);
    for (let k = 0; k < 12; k += 4) {
      let x = T[k], y = T[k + 1], z = T[k + 2], p = T[k + 3];
      if (SLIDES[i]) p += q[i] * z;
      else [x, y] = [c * x + s * y, c * y - s * x];
      for (let j = 0; j < 4; ++j) T[k + j] = x * L[j] + y * L[4 + j] + z * L[8 + j];
      T[k + 3] += p;
    }
  }
  return T;
}

@COUPLED@function fk(q) {
  const T = walk(@V@);
  return [T.slice(0, 4), T.slice(4, 8), T.slice(8, 12), [0, 0, 0, 1]];
}

function jacobian(q) {
  const z = [], p = [];
  const T = walk(@V@, (i, F) => {
    z.push([F[2], F[6], F[10]]);
    p.push([F[3], F[7], F[11]]);
  });
  const J = [[], [], [], [], [], []];
  for (let i = 0; i < N; ++i)
    for (let k = 0; k < 3; ++k) {
      const a = (k + 1) % 3, b = (k + 2) % 3;
      J[k].push(SLIDES[i] ? z[i][k] : z[i][a] * (T[4 * b + 3] - p[i][b]) - z[i][b] * (T[4 * a + 3] - p[i][a]));
      J[3 + k].push(SLIDES[i] ? 0 : z[i][k]);
    }
  return @GEARED@;
}

function same(a, b, most) {
  for (let j = 0; j < N; ++j) {
    let d = Math.abs(a[j] - b[j]);
    if (!SLIDES[j]) d = Math.abs(d - TURN * Math.round(d / TURN));
    if (!(d < most)) return false;
  }
  return true;
}

function ikAll(pose@VALUE@) {
  const @POSE@ = pose.length === 16 ? pose : [].concat(...Array.from(pose, (row) => Array.from(row)));
@MOVED@@PROGRAM@
  const rows = [@ROWS@];
  const valid = [@VALID@];
  const unclear = @UNCLEAR@;
  const kept = [];
  for (let m = 0; m < 8; ++m) {
    const own = [@OWN_ROW@];
    if (!valid[m] || @FILLED@kept.some((row) => same(row, own, 1e-9))) continue;
    if (@DOUBT@) {
      const back = walk(own);
      if (!@TESTED@.every((k) => Math.abs(back[k] - @POSE@[k]) < @VERIFIED@)) continue;
    }
    kept.push(own);
  }
  return { rows: @KEPT@, unclear };
}

// Whole turns where only they lie inside the limits; whether all joints do then.
function inside(q) {
  let all = true;
@TIED@  for (let j = 0; j < N; ++j) {
    let v = q[j];
    if (!@ALONE@ && v < LOWER[j]) v += TURN * Math.ceil((LOWER[j] - v) / TURN);
    else if (!@ALONE@ && v > UPPER[j]) v -= TURN * Math.ceil((v - UPPER[j]) / TURN);
    all = all && v >= LOWER[j] && v <= UPPER[j];
    q[j] = v;
  }
  return all;
}

function ik(pose@VALUE@) {
  return ikAll(pose@VALUE_SAID@).rows.filter(inside);
}

// 0 where v is positive, 1 where it is negative, 2 where it has no side; seen by somebody who faces that way.
function side(v, facing) {
  const seen = facing < 0 ? -v : v;
  return seen > @NO_SIDE@ ? 0 : seen < -@NO_SIDE@ ? 1 : 2;
}

function label(@LABELLED@) {
  const names = @NAMES@;
@LABEL_AXES@@SUMS@
  return names[@PLACE@];
}

// How many of @TESTS@ stored poses fail: 0.
function selfTest() {
  const Q = @TEST_Q@;
  const T = @TEST_T@;
  const counts = @COUNTS@;
  let failed = 0;
  for (let i = 0; i < Q.length; ++i) {
    const back = [].concat(...fk(Q[i])), rows = ik(T[i]@TEST_VALUE@);
    const ok = back.every((x, k) => Math.abs(x - T[i][k]) < @VERIFIED@);
    if (!(ok && rows.length === counts[i] && rows.some((row) => same(@FOUND_ROW@, 1e-7)))) ++failed;
  }
  return failed;
}
"""

MODULE = "\nexport { ik, ikAll, fk, jacobian, label, selfTest };\n"
SCRIPT = """
if (typeof module !== "undefined") module.exports = { ik, ikAll, fk, jacobian, label, selfTest };
else globalThis.NAME_solver = { ik, ikAll, fk, jacobian, label, selfTest };
"""


def _own_parts(export: Export) -> dict[str, str]:
    """Return what is said of what lies between the arm's joints and the six that are solved."""
    own = export.between
    held = own.held is not None
    parts = {
        "SAID": held_words(own),
        "VALUE": f", value = {own.default!r}" if held else "",
        "VALUE_SAID": ", value" if held else "",
        "TEST_VALUE": f", Q[i][{own.held}]" if held else "",
        "POSE": "given" if held else "T",
        "MOVED": _moved(export) if held else "",
        "OWN_ROW": ", ".join("value" if column is None else f"rows[m][{column}]" for column in own.columns),
        "FILLED": "".join(f"Math.abs(rows[m][{k}]) >= {FILLED_ZERO * unit!r} || " for k, unit in own.filled),
        "DOUBT": "true" if own.always else "unclear",
        "TESTED": str(list(own.tested)),
        "KEPT": "kept",
        "ALONE": "SLIDES[j]" if own.tied is None else "(SLIDES[j] || TIED[j])",
        "V": "q",
        "GEARED": "J",
        "LABELLED": "q",
        "FOUND_ROW": "row, Q[i]",
        **dict.fromkeys(("COUPLED", "TIED", "LABEL_AXES"), ""),
    }
    if own.gears is None:
        return parts
    wrap = "q.map((x, j) => (SLIDES[j] ? x : x - TURN * Math.ceil((x - Math.PI) / TURN)))" if own.wraps else "q"
    parts |= {
        "COUPLED": "// The joints are coupled: where the axes are at joint vectors q, and back.\n"
        f"const GEARS = {JAVASCRIPT.numbers(own.gears)};\nconst BACK = {JAVASCRIPT.numbers(own.back)};\n"
        "const times = (M, v) => M.map((row) => row.reduce((sum, x, j) => sum + x * v[j], 0));\n"
        "const axesAt = (q) => times(GEARS, q);\n"
        f"function jointsAt(v) {{\n  const q = times(BACK, v);\n  return {wrap};\n}}\n\n",
        "V": "axesAt(q)",
        "GEARED": "J.map((row) => GEARS.map((_, j) => row.reduce((sum, x, i) => sum + x * GEARS[i][j], 0)))",
        "KEPT": "kept.map(jointsAt)",
        "LABELLED": "joints",
        "LABEL_AXES": "  const q = axesAt(joints);\n",
        "FOUND_ROW": "axesAt(row), axesAt(Q[i])",
    }
    if own.tied is None or own.moves is None or own.weight is None:
        return parts
    parts["COUPLED"] += (
        "// Joints whose numbers whole turns of the axes move together, and how.\n"
        f"const TIED = {JAVASCRIPT.listed(JAVASCRIPT.truths[int(t)] for t in own.tied)};\n"
        f"const MOVES = {JAVASCRIPT.numbers(own.moves)};\nconst WEIGHT = {JAVASCRIPT.numbers(own.weight)};\n"
        "const held = (q) => q.every((v, j) => !TIED[j] || (v >= LOWER[j] && v <= UPPER[j]));\n"
        "// The shortest move that brings them inside, where one does.\n"
        "function moveInside(q) {\n  if (held(q)) return;\n  let best = q.map(() => 0), least = Infinity;\n"
        "  for (const move of MOVES) {\n    const away = move.reduce((sum, x, j) => sum + WEIGHT[j] * x * x, 0);\n"
        "    if (away < least && held(q.map((v, j) => v + move[j]))) [best, least] = [move, away];\n  }\n"
        "  best.forEach((x, j) => (q[j] += x));\n}\n\n"
    )
    parts["TIED"] = "  moveInside(q);\n"
    return parts


def _moved(export: Export) -> str:
    """Return the lines that take the held joint off a pose."""
    own = export.between
    if own.taken_off is None or own.held is None:
        return ""
    product = "matrix(OFF, given)" if own.at_base else "matrix(given, OFF)"
    turn = "matrix(Z, off)" if own.at_base else "matrix(off, Z)"
    Z = (
        "[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -value, 0, 0, 0, 1]"
        if export.slides[own.held]
        else "[c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]"
    )
    return (
        "  // What the held joint does is taken off the pose.\n"
        f"  const OFF = {JAVASCRIPT.numbers(own.taken_off.ravel())};\n"
        "  const matrix = (A, B) =>\n    A.map((_, n) => [0, 1, 2, 3].reduce((sum, k) => sum + A[4 * (n >> 2) + k] * "
        "B[4 * k + (n & 3)], 0));\n"
        f"  const c = Math.cos(value), s = Math.sin(value);\n  const Z = {Z};\n"
        f"  const off = {product};\n  const T = {turn};\n"
    )


def text(export: Export, suffix: str) -> str:
    """Return the file's text: a module for the suffix .mjs, else a script."""
    parts = JAVASCRIPT.parts(export) | _own_parts(export)
    return filled(FRAME + (MODULE if suffix == ".mjs" else SCRIPT), parts, export)
