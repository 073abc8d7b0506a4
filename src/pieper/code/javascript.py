"""The printer of JavaScript: a module (.mjs), or a script that serves Node and pages alike."""

from __future__ import annotations

from pieper.code.export import Export
from pieper.code.labels import Manner
from pieper.code.language import USUAL, Language, filled, functions

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

ik(T): every joint vector inside the limits that reaches a pose, an array of arrays; T as 16 numbers row by row, or as 4
rows of 4. ikAll(T): {rows, unclear} before limits; unclear at and next to singular poses, where a row may stand for
many and rows may be missing. fk(q): the pose as 4 rows of 4. jacobian(q): 6 rows, linear ones first. label(q): the
posture's name, such as "front, elbow up, wrist flip"; "" where the postures of this arm have none.
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

function fk(q) {
  const T = walk(q);
  return [T.slice(0, 4), T.slice(4, 8), T.slice(8, 12), [0, 0, 0, 1]];
}

function jacobian(q) {
  const z = [], p = [];
  const T = walk(q, (i, F) => {
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
  return J;
}

function same(a, b, most) {
  for (let j = 0; j < N; ++j) {
    let d = Math.abs(a[j] - b[j]);
    if (!SLIDES[j]) d = Math.abs(d - TURN * Math.round(d / TURN));
    if (!(d < most)) return false;
  }
  return true;
}

function ikAll(pose) {
  const T = pose.length === 16 ? pose : [].concat(...Array.from(pose, (row) => Array.from(row)));
@PROGRAM@
  const rows = [@ROWS@];
  const valid = [@VALID@];
  const unclear = @UNCLEAR@;
  const kept = [];
  for (let m = 0; m < 8; ++m) {
    if (!valid[m] || kept.some((row) => same(row, rows[m], 1e-9))) continue;
    if (unclear && !walk(rows[m]).every((x, k) => Math.abs(x - T[k]) < @VERIFIED@)) continue;
    kept.push(rows[m]);
  }
  return { rows: kept, unclear };
}

function ik(pose) {
  const found = [];
  for (const row of ikAll(pose).rows) {
    let inside = true;
    for (let j = 0; j < N; ++j) {
      let v = row[j];
      if (!SLIDES[j] && v < LOWER[j]) v += TURN * Math.ceil((LOWER[j] - v) / TURN);
      else if (!SLIDES[j] && v > UPPER[j]) v -= TURN * Math.ceil((v - UPPER[j]) / TURN);
      inside = inside && v >= LOWER[j] && v <= UPPER[j];
      row[j] = v;
    }
    if (inside) found.push(row);
  }
  return found;
}

// 0 where v is positive, 1 where it is negative, 2 where it has no side; seen by somebody who faces that way.
function side(v, facing) {
  const seen = facing < 0 ? -v : v;
  return seen > @NO_SIDE@ ? 0 : seen < -@NO_SIDE@ ? 1 : 2;
}

function label(q) {
  const names = @NAMES@;
@SUMS@
  return names[@PLACE@];
}

// How many of @TESTS@ stored poses fail: 0.
function selfTest() {
  const Q = @TEST_Q@;
  const T = @TEST_T@;
  const counts = @COUNTS@;
  let failed = 0;
  for (let i = 0; i < Q.length; ++i) {
    const back = [].concat(...fk(Q[i])), rows = ik(T[i]);
    const ok = back.every((x, k) => Math.abs(x - T[i][k]) < @VERIFIED@);
    if (!(ok && rows.length === counts[i] && rows.some((row) => same(row, Q[i], 1e-7)))) ++failed;
  }
  return failed;
}
"""

MODULE = "\nexport { ik, ikAll, fk, jacobian, label, selfTest };\n"
SCRIPT = """
if (typeof module !== "undefined") module.exports = { ik, ikAll, fk, jacobian, label, selfTest };
else globalThis.NAME_solver = { ik, ikAll, fk, jacobian, label, selfTest };
"""


def text(export: Export, suffix: str) -> str:
    """Return the file's text: a module for the suffix .mjs, else a script."""
    return filled(FRAME + (MODULE if suffix == ".mjs" else SCRIPT), JAVASCRIPT.parts(export), export)
