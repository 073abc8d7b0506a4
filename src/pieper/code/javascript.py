"""The printer of JavaScript: a module (.mjs), or a script that serves Node and pages alike."""

from __future__ import annotations

from pieper.code.between import STEPS, Between, held_words
from pieper.code.export import Export
from pieper.code.labels import Manner
from pieper.code.language import USUAL, Language, counted, filled, functions
from pieper.code.program import LoopWords
from pieper.tolerances import CLOSES, FILLED_STARTS, HOLDS_TO_ROUNDING, NEWTON_FINITE


def _loop(loop: LoopWords) -> list[str]:
    return [
        *(f"  let {name} = {start};" for name, start in zip(loop.names, loop.start, strict=True)),
        f"  for (let step = 0; step < {loop.steps}; ++step) {{",
        *(f"  {line}" for line in loop.lines),
        *(f"    {name} = {text};" for name, text in zip(loop.names, loop.next, strict=True)),
        f"    if (!({loop.moving})) break;",
        "  }",
    ]


JAVASCRIPT = Language(
    words=USUAL | functions("Math.") | {"angle": "angle({0}, {1})", "eq": "{0} === {1}", "ne": "{0} !== {1}"},
    assign=lambda name, _, expression: f"  const {name} = {expression};",
    loop=_loop,
    infinity="Infinity",
    truths=("false", "true"),
    manner=Manner("Math.sin({0})", "Math.cos({0})", "q[{0}]", 0, "  const {0} = {1};", "side({0}, {1})"),
    per_row=("[{}]", ", "),
)


FRAME = """/*
@HEADER@

@SAID@ik(T): every joint vector inside the limits that reaches a pose, an array of arrays; T as 16 numbers row by
row, or as 4 rows of 4; a rotation that was rounded is taken as the nearest one, and what is no rigid motion throws a
RangeError. ikAll(T): {rows, unclear} before limits; unclear at and next to singular poses, where a row may
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

// The 16 numbers of the pose that is meant: a rotation that was rounded becomes the nearest one.
function rigid(pose) {
  const X = Array.from(pose.length === 16 ? pose : [].concat(...Array.from(pose, (row) => Array.from(row))));
  const G = [];
  let off = Math.abs(X[12]) + Math.abs(X[13]) + Math.abs(X[14]) + Math.abs(X[15] - 1);
  for (let step = 0; step < 2; ++step) {
    for (let a = 0; a < 3; ++a)
      for (let b = 0; b < 3; ++b) {
        const g = (G[3 * a + b] = X[a] * X[b] + X[4 + a] * X[4 + b] + X[8 + a] * X[8 + b]);
        if (!step) off = Math.max(off, Math.abs(a === b ? g - 1 : g));
      }
    if (!step) {
      const side = X[0] * (X[5] * X[10] - X[6] * X[9]) + X[1] * (X[6] * X[8] - X[4] * X[10]) +
        X[2] * (X[4] * X[9] - X[5] * X[8]);
      if (!(off <= @ACCEPTED@ && side > 0 && Number.isFinite(X[3] + X[7] + X[11])))
        throw new RangeError("the pose is no rigid motion: R^T R departs from I by over @ACCEPTED@, or R is a mirror");
      X.splice(12, 4, 0, 0, 0, 1);
    }
    for (let k = 0; k < 12; k += 4) {
      const x = X[k], y = X[k + 1], z = X[k + 2];
      for (let j = 0; j < 3; ++j) X[k + j] = 1.5 * X[k + j] - 0.5 * (x * G[j] + y * G[3 + j] + z * G[6 + j]);
    }
  }
  return X;
}

function walk(q, visit) {
  const T = LINKS[0].slice();
  for (let i = 0; i < AXES; ++i) {
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

@NEAREST@@COUPLED@function fk(q) {
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
  for (let i = 0; i < AXES; ++i)
    for (let k = 0; k < 3; ++k) {
      const a = (k + 1) % 3, b = (k + 2) % 3;
      J[k].push(SLIDES[i] ? z[i][k] : z[i][a] * (T[4 * b + 3] - p[i][b]) - z[i][b] * (T[4 * a + 3] - p[i][a]));
      J[3 + k].push(SLIDES[i] ? 0 : z[i][k]);
    }
  return @GEARED@;
}

function same(a, b, most, slides = SLIDES) {
  for (let j = 0; j < a.length; ++j) {
    let d = Math.abs(a[j] - b[j]);
    if (!slides[j]) d = Math.abs(d - TURN * Math.round(d / TURN));
    if (!(d < most)) return false;
  }
  return true;
}

function ikAll(pose@VALUE@) {
  const @POSE@ = rigid(pose);
@MOVED@@PROGRAM@
  const rows = [@ROWS@];
  const valid = [@VALID@];
  const unclear = @UNCLEAR@;
  const kept = [];
  for (let m = 0; m < 8; ++m) {
@OWN_ROW@    if (!valid[m] || @FILLED@@BROUGHT@kept.some((row) => same(row, own, 1e-9@SAME_SLIDES@))) continue;
    if (@DOUBT@) {
      const back = walk(@BACK_AT@);
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
    const back = [].concat(...fk(Q[i])), rows = ik(T[i]@TEST_VALUE@), pose = rigid(T[i]);
    const ok = back.every((x, k) => Math.abs(x - pose[k]) < @VERIFIED@);
    if (!(ok && rows.length === counts[i] && rows.some((row) => same(@FOUND_ROW@, 1e-7)))) ++failed;
  }
  return failed;
}
"""

#: Of arms with filled joints: a row becomes the joint vector whose pose comes nearest to what was asked.
NEAREST = """// Least squares: q becomes the joint vector whose pose comes nearest to T; by how much it misses.
function nearest(q, T) {
  const tested = @TESTED@, weights = @WEIGHTS@;
  for (let step = 0, moved = 1; ; ++step) {
    const axes = [], P = walk(@BACK_AT@, (i, F) => axes.push([F[2], F[6], F[10], F[3], F[7], F[11]]));
    const r = tested.map((e, k) => weights[k] * (T[e] - P[e]));
    const miss = r.reduce((sum, x) => sum + x * x, 0);
    if (step === @STEPS@ || moved < @ROUNDING@ || miss < @SETTLED@) {
      q.forEach((x, j) => (q[j] = @JOINTS_SLIDE@[j] ? x : x - TURN * Math.ceil((x - Math.PI) / TURN)));
      return Math.sqrt(miss);
    }
    const @OF_AXES@ = axes.map((z, j) => tested.map((e, k) => {
      const c = e % 4, o = c === 3 ? 1 : 0, i = (e - c) / 4, a = (i + 1) % 3, b = (i + 2) % 3;
      const turned = z[a] * (P[4 * b + c] - o * z[3 + b]) - z[b] * (P[4 * a + c] - o * z[3 + a]);
      return weights[k] * (SLIDES[j] ? o * z[i] : turned);
    }));
@BY_JOINTS@@FIXED@    const times = (u, v) => u.reduce((sum, x, k) => sum + x * v[k], 0);
    const A = D.map((u, i) => [...D.map((v, j) => times(u, v) * (i === j ? 1 + @DAMPED@ : 1)), times(u, r)]);
@HOLDING@    for (let i = 0; i < N; ++i)
      for (let k = i + 1; k < N; ++k) {
        const by = A[k][i] / A[i][i];
        for (let j = i; j <= N; ++j) A[k][j] -= by * A[i][j];
      }
    moved = 0;
    for (let i = N - 1; i >= 0; --i) {
      for (let j = i + 1; j < N; ++j) A[i][N] -= A[i][j] * A[j][N];
      q[i] += A[i][N] /= A[i][i];
      moved = Math.max(moved, Math.abs(A[i][N]));
    }
  }
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
        "OWN_ROW": f"    const own = [{', '.join(own.axes('rows[m][{}]'.format))}];\n",
        "SAME_SLIDES": ", JOINTS_SLIDE" if own.linked else "",
        "BACK_AT": "axesAt(own)" if own.linked else "own",
        "FILLED": "".join(f"Math.abs(rows[m][{k}]) >= {FILLED_STARTS * unit!r} || " for k, unit in own.filled),
        "BROUGHT": f"!(nearest(own, {'given' if held else 'T'}) < {CLOSES!r}) || " if own.weights else "",
        "NEAREST": _nearest(export),
        "DOUBT": "true" if own.always else "unclear",
        "TESTED": str(list(own.tested)),
        "KEPT": "kept",
        "ALONE": "JOINTS_SLIDE[j]" if own.linked else "SLIDES[j]" if own.tied is None else "(SLIDES[j] || TIED[j])",
        "V": "q",
        "GEARED": "J",
        "LABELLED": "q",
        "FOUND_ROW": "row, Q[i]",
        **dict.fromkeys(("COUPLED", "TIED", "LABEL_AXES"), ""),
    }
    if own.gears is None:
        return parts
    slides = "JOINTS_SLIDE" if own.linked else "SLIDES"
    wrap = f"q.map((x, j) => ({slides}[j] ? x : x - TURN * Math.ceil((x - Math.PI) / TURN)))" if own.wraps else "q"
    assert own.back is not None
    parts |= {
        "COUPLED": "// The joints are coupled: where the axes are at joint vectors q, and back.\n"
        f"const GEARS = {JAVASCRIPT.numbers(own.gears)};\nconst BACK = {JAVASCRIPT.numbers(own.back)};\n"
        "const times = (M, v) => M.map((row) => row.reduce((sum, x, j) => sum + x * v[j], 0));\n"
        "const axesAt = (q) => times(GEARS, q);\n"
        f"const wrapped = (q) => {wrap};\nconst jointsAt = (v) => wrapped(times(BACK, v));\n\n",
        "V": "axesAt(q)",
        "GEARED": "J.map((row) => GEARS[0].map((_, j) => row.reduce((sum, x, i) => sum + x * GEARS[i][j], 0)))",
        "KEPT": "kept.map(jointsAt)",
        "LABELLED": "joints",
        "LABEL_AXES": "  const q = axesAt(joints);\n",
        "FOUND_ROW": "axesAt(row), axesAt(Q[i])",
    }
    if own.linked:
        return parts | _linked(own, parts)
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


def _nearest(export: Export) -> str:
    """Return the function that brings a row nearest to its pose, of arms that need it."""
    own = export.between
    if not own.weights:
        return ""
    by_joints = (
        "    const D = GEARS[0].map((_, j) =>\n"
        "      tested.map((_, k) => GEARS.reduce((sum, row, i) => sum + row[j] * by[i][k], 0)));\n"
    )
    said = {
        "TESTED": str(list(own.tested)),
        "WEIGHTS": str(list(own.weights)),
        "DAMPED": repr(NEWTON_FINITE),
        "SETTLED": repr(HOLDS_TO_ROUNDING**2),
        "ROUNDING": repr(HOLDS_TO_ROUNDING),
        "STEPS": str(STEPS),
        "JOINTS_SLIDE": "JOINTS_SLIDE" if own.linked else "SLIDES",
        "BACK_AT": "axesAt(q)" if own.linked else "q",
        "OF_AXES": "by" if own.linked else "D",
        "BY_JOINTS": by_joints if own.linked else "",
        "FIXED": "".join(f"    D[{j}].fill(0);\n" for j in own.fixed),
        "HOLDING": "".join(f"    A[{j}][{j}] = 1;\n" for j in own.fixed),
    }
    text = NEAREST
    for word, what in said.items():
        text = text.replace(f"@{word}@", what)
    return counted(text, export)


def _linked(own: Between, parts: dict[str, str]) -> dict[str, str]:
    """Return what is said of axes that a linkage moves: the joints' numbers follow from their own axes."""
    slides = JAVASCRIPT.listed(JAVASCRIPT.truths[int(s)] for s in own.joints_slide or ())
    return {
        "COUPLED": f"const JOINTS_SLIDE = {slides};\n{parts['COUPLED']}"
        "// Whether the linkage puts the axes at v, nearly, where the joints are at q.\n"
        f"const STARTS = {JAVASCRIPT.numbers(own.starts)};\nconst linked = (v, q) =>\n  axesAt(q).every((x, j) => {{\n"
        "    const d = Math.abs(v[j] - x);\n"
        "    return (SLIDES[j] ? d : Math.abs(d - TURN * Math.round(d / TURN))) < STARTS[j];\n  });\n\n",
        "OWN_ROW": parts["OWN_ROW"].replace("own", "at", 1) + "    const own = times(BACK, at);\n",
        "FILLED": parts["FILLED"] + "!linked(at, own) || ",
        "KEPT": "kept.map(wrapped)",
    }


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
