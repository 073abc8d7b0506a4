// Solves arms with the kernels as WebAssembly: rows of the six joints that are solved, in the arm's own numbers, limits looked at.
"use strict";
window.PIEPER = window.PIEPER || {};
(() => {
  const TURN = 2 * Math.PI;
  let wasm = null;
  const made = new Map();
  const doubles = (values) => {
    const at = wasm.alloc(8 * Math.max(values.length, 1));
    new Float64Array(wasm.memory.buffer, at, values.length).set(values);
    return at;
  };
  const bytes = (values) => {
    const at = wasm.alloc(Math.max(values.length, 1));
    new Uint8Array(wasm.memory.buffer, at, values.length).set(values);
    return at;
  };
  const matrix = (A, B) => A.map((_, n) => [0, 1, 2, 3].reduce((sum, k) => sum + A[4 * (n >> 2) + k] * B[4 * k + (n & 3)], 0));
  const times = (M, v) => M.map((row) => row.reduce((sum, x, j) => sum + x * v[j], 0));

  // An arm's numbers go into the module once.
  function handle(arm) {
    if (made.has(arm.name)) return made.get(arm.name);
    const s = arm.solver, free = new Array(6).fill(Infinity);
    const own = {
      arm: wasm.make(
        s.family, doubles(s.numbers), s.general.length ? doubles(s.general) : 0, doubles(s.links),
        doubles(s.plain ? s.lower : free.map((x) => -x)), doubles(s.plain ? s.upper : free), bytes(s.sixSlides.map(Number)),
      ),
      T: wasm.alloc(128), q: wasm.alloc(48 * s.slots), valid: wasm.alloc(s.slots), inside: wasm.alloc(s.slots), flag: wasm.alloc(1),
    };
    made.set(arm.name, own);
    return own;
  }

  // Rows of the six joints, before limits; null where T is no rigid motion.
  function six(arm, T) {
    const { slots } = arm.solver, at = handle(arm);
    new Float64Array(wasm.memory.buffer, at.T, 16).set(T);
    if (wasm.solve(at.arm, at.T, 1, at.q, at.valid, at.inside, at.flag) === 0) return null;
    const valid = new Uint8Array(wasm.memory.buffer, at.valid, slots), q = new Float64Array(wasm.memory.buffer, at.q, 6 * slots);
    const rows = [];
    for (let m = 0; m < slots; ++m) if (valid[m]) rows.push(Array.from(q.subarray(6 * m, 6 * m + 6)));
    return { rows, unclear: (new Uint8Array(wasm.memory.buffer, at.flag, 1)[0] & 3) !== 0 };
  }

  // What the held joint does is taken off the pose.
  function takenOff(arm, T, value) {
    const s = arm.solver, c = Math.cos(value), w = Math.sin(value);
    const Z = arm.slides[s.held] ? [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -value, 0, 0, 0, 1] : [c, w, 0, 0, -w, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
    return s.atBase ? matrix(Z, matrix(s.takenOff, T)) : matrix(matrix(T, s.takenOff), Z);
  }

  const axesAt = (arm, q) => (arm.solver && arm.solver.gears ? times(arm.solver.gears, q) : q);

  function jointsAt(arm, v) {
    const s = arm.solver;
    if (!s.gears) return v;
    const q = times(s.back, v);
    return s.wraps ? q.map((x, j) => (arm.slides[j] ? x : x - TURN * Math.ceil((x - Math.PI) / TURN))) : q;
  }

  function same(arm, a, b, most) {
    return a.every((x, j) => {
      const d = Math.abs(x - b[j]);
      return (arm.slides[j] ? d : Math.abs(d - TURN * Math.round(d / TURN))) < most;
    });
  }

  // A pose whose rotation, where it was rounded, is the nearest one; null where T is no rigid motion.
  function rigid(arm, T) {
    const P = Array.from(T);
    P[3] = P[7] = P[11] = 0;
    const across = (A) => matrix(A.map((_, n) => A[4 * (n & 3) + (n >> 2)]), A);
    const off = Math.max(...across(P).map((x, n) => Math.abs(x - (n % 5 === 0))));
    const cross = P[0] * (P[5] * P[10] - P[6] * P[9]) - P[1] * (P[4] * P[10] - P[6] * P[8]) + P[2] * (P[4] * P[9] - P[5] * P[8]);
    if (!(off <= arm.solver.accepted && cross > 0 && T.every(Number.isFinite))) return null;
    let X = P;
    for (let step = 0; step < 2; ++step) {
      const Y = matrix(X, across(X));
      X = X.map((x, n) => 1.5 * x - 0.5 * Y[n]);
    }
    return [X[0], X[1], X[2], T[3], X[4], X[5], X[6], T[7], X[8], X[9], X[10], T[11], 0, 0, 0, 1];
  }

  // {rows, unclear} before limits, of a pose as 16 numbers row by row; value: where a joint to spare is held.
  function ikAll(arm, given, value) {
    const s = arm.solver, T = rigid(arm, given), found = T && six(arm, s.held === null ? T : takenOff(arm, T, value));
    if (!found || s.plain) return found;
    const kept = [];
    for (const row of found.rows) {
      const own = s.columns.map((column) => (column === null ? value : row[column]));
      if (s.filled.some(([k, most]) => Math.abs(row[k]) >= most) || kept.some((other) => same(arm, other, own, 1e-9))) continue;
      if (s.always || found.unclear) {
        const back = window.PIEPER.frames(arm, own).pop();
        if (s.tested.some((k) => Math.abs(back[k] - T[k]) >= s.verified)) continue;
      }
      kept.push(own);
    }
    return { rows: kept.map((row) => jointsAt(arm, row)), unclear: found.unclear };
  }

  // The row inside the limits, whole turns moved where only so it lies there; null where it does not.
  function inside(arm, row) {
    const { lower, upper, tied, moves, weight } = arm.solver, q = row.slice();
    if (tied) {
      const held = (v) => v.every((x, j) => !tied[j] || (x >= lower[j] && x <= upper[j]));
      let best = null, least = Infinity;
      for (const move of held(q) ? [] : moves) {
        const away = move.reduce((sum, x, j) => sum + weight[j] * x * x, 0);
        if (away < least && held(q.map((v, j) => v + move[j]))) [best, least] = [move, away];
      }
      if (best) best.forEach((x, j) => (q[j] += x));
    }
    for (let j = 0; j < q.length; ++j) {
      const turns = !arm.slides[j] && !(tied && tied[j]);
      if (turns && q[j] < lower[j]) q[j] += TURN * Math.ceil((lower[j] - q[j]) / TURN);
      else if (turns && q[j] > upper[j]) q[j] -= TURN * Math.ceil((q[j] - upper[j]) / TURN);
      if (q[j] < lower[j] || q[j] > upper[j]) return null;
    }
    return q;
  }

  const ready = (async () => {
    const letters = atob(window.PIEPER.kernel), packed = new Uint8Array(letters.length);
    for (let i = 0; i < letters.length; ++i) packed[i] = letters.charCodeAt(i);
    const code = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    wasm = (await WebAssembly.instantiate(await new Response(code).arrayBuffer(), {})).instance.exports;
    if (wasm._initialize) wasm._initialize();
  })();
  Object.assign(window.PIEPER, { ready, ikAll, inside, axesAt, same });
})();
