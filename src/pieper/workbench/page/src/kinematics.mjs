// Forward kinematics of a DH table, mirrored from the library so that a slider never waits for the server.
// tests/browser/test_mirror.py holds it against Python on random tables of both conventions.
import { mul, column, position, cross, sub, identity } from './matrix.mjs';

/** Rz(theta) Tz(d) Tx(a) Rx(alpha) (standard) or Rx(alpha) Tx(a) Rz(theta) Tz(d) (modified). */
export function linkMatrix(convention, a, alpha, d, theta) {
  const c = Math.cos(theta),
    s = Math.sin(theta),
    C = Math.cos(alpha),
    S = Math.sin(alpha);
  return convention === 'standard'
    ? [c, -s * C, s * S, a * c, s, c * C, -c * S, a * s, 0, S, C, d, 0, 0, 0, 1]
    : [c, -s, 0, a, s * C, c * C, -S, -d * S, s * S, c * S, C, d * C, 0, 0, 0, 1];
}

/** The four DH numbers of joint i at joint value v (rad or m), with the maker's sign and offset put in. */
export function rowAt(joint, v) {
  const move = joint.sign * v + joint.offset;
  return joint.type === 'R'
    ? { a: joint.a, alpha: joint.alpha, d: joint.d, theta: joint.theta + move }
    : { a: joint.a, alpha: joint.alpha, d: joint.d + move, theta: joint.theta };
}

/** What the chain's rows move by at joint values q: the same numbers, or coupling @ q where one motor moves several rows. */
export const chainValues = ({ coupling }, q) =>
  coupling ? coupling.map((row) => row.reduce((sum, c, k) => sum + c * q[k], 0)) : q;

/** A_1 .. A_n at q. */
export function linkMatrices(table, q) {
  const moved = chainValues(table, q);
  return table.joints.map((joint, i) => {
    const r = rowAt(joint, moved[i]);
    return linkMatrix(table.convention, r.a, r.alpha, r.d, r.theta);
  });
}

/** Base, after each joint, tool: n + 2 poses in the world frame. */
export function frames(table, q) {
  const out = [table.base];
  linkMatrices(table, q).forEach((A, i) => out.push(mul(out[i], A)));
  out.push(mul(out[table.joints.length], table.tool));
  return out;
}

/** Where each joint turns or slides: a point on its axis and the axis direction, world frame. */
export function jointAxes(table, F) {
  return table.joints.map((joint, i) => {
    if (table.convention === 'standard') return { point: position(F[i]), dir: column(F[i], 2), x: column(F[i], 0) };
    const dir = column(F[i + 1], 2),
      x = column(F[i], 0),
      o = position(F[i]);
    return { point: [o[0] + joint.a * x[0], o[1] + joint.a * x[1], o[2] + joint.a * x[2]], dir, x };
  });
}

/** Geometric Jacobian in the world frame, 6 rows of n, linear rows first, at the tool point. */
export function jacobian(table, q, F = frames(table, q)) {
  const tip = position(F[F.length - 1]);
  const J = Array.from({ length: 6 }, () => new Array(table.joints.length).fill(0));
  jointAxes(table, F).forEach(({ point, dir }, i) => {
    const s = table.joints[i].sign;
    const [v, w] = table.joints[i].type === 'R' ? [cross(dir, sub(tip, point)), dir] : [dir, [0, 0, 0]];
    for (let r = 0; r < 3; r++) {
      J[r][i] = s * v[r];
      J[r + 3][i] = s * w[r];
    }
  });
  const { coupling } = table;
  return coupling ? J.map((row) => row.map((_, k) => row.reduce((sum, v, i) => sum + v * coupling[i][k], 0))) : J;
}

/** Sum of |a| and |d|, with the travel of prismatic joints: the size by which everything is drawn (m). */
export function reach(table) {
  let sum = Math.hypot(...position(table.tool));
  for (const j of table.joints) {
    sum += Math.hypot(j.a, j.d);
    if (j.type === 'P') sum += Math.max(Math.abs(j.lower ?? 0), Math.abs(j.upper ?? 0)) || 0;
  }
  return sum > 1e-9 ? sum : 1;
}

/** Eigenvalues of a small symmetric matrix by Jacobi rotations (ascending). */
function symmetricEigenvalues(M) {
  const n = M.length,
    A = M.map((r) => r.slice());
  for (let sweep = 0; sweep < 30; sweep++) {
    let off = 0;
    for (let p = 0; p < n; p++) for (let r = p + 1; r < n; r++) off += A[p][r] ** 2;
    if (off < 1e-30) break;
    for (let p = 0; p < n; p++)
      for (let r = p + 1; r < n; r++) {
        if (Math.abs(A[p][r]) < 1e-300) continue;
        const h = (A[r][r] - A[p][p]) / (2 * A[p][r]);
        const t = Math.sign(h || 1) / (Math.abs(h) + Math.sqrt(h * h + 1));
        const c = 1 / Math.sqrt(t * t + 1),
          s = t * c;
        for (let k = 0; k < n; k++) {
          const x = A[k][p],
            y = A[k][r];
          A[k][p] = c * x - s * y;
          A[k][r] = s * x + c * y;
        }
        for (let k = 0; k < n; k++) {
          const x = A[p][k],
            y = A[r][k];
          A[p][k] = c * x - s * y;
          A[r][k] = s * x + c * y;
        }
      }
  }
  return A.map((r, i) => r[i]).sort((x, y) => x - y);
}

/**
 * Singular values of the Jacobian, ascending, its linear rows divided by the arm's length so that metres and radians
 * can be compared; with `length` 1 they are as they come. Of an arm of n joints, and of the
 * rows that its task moves, there are as many as there are of the fewer.
 */
export function singularValues(table, q, F, length = reach(table), rows = 6) {
  const J = jacobian(table, q, F),
    n = table.joints.length;
  const rowsOf = J.slice(0, rows).map((r, i) => r.map((x) => (i < 3 ? x / length : x)));
  const cols = Array.from({ length: n }, (_, i) => rowsOf.map((r) => r[i]));
  const side = n < rows ? cols : rowsOf;
  const gram = side.map((u) => side.map((v) => u.reduce((sum, x, k) => sum + x * v[k], 0)));
  return symmetricEigenvalues(gram).map((e) => Math.sqrt(Math.max(e, 0)));
}

/** Solve the small dense system M x = b by elimination with pivots. */
function solveLinear(M, b) {
  const n = b.length,
    A = M.map((r, i) => [...r, b[i]]);
  for (let c = 0; c < n; c++) {
    let p = c;
    for (let r = c + 1; r < n; r++) if (Math.abs(A[r][c]) > Math.abs(A[p][c])) p = r;
    [A[c], A[p]] = [A[p], A[c]];
    for (let r = c + 1; r < n; r++) {
      const f = A[r][c] / A[c][c];
      for (let k = c; k <= n; k++) A[r][k] -= f * A[c][k];
    }
  }
  const x = new Array(n);
  for (let r = n - 1; r >= 0; r--)
    x[r] = (A[r][n] - x.slice(r + 1).reduce((sum, v, k) => sum + v * A[r][r + 1 + k], 0)) / A[r][r];
  return x;
}

/**
 * Bring a posture that nearly holds the pose T onto it, by the shortest joint steps (Newton with damped least squares).
 * For sliding along a self-motion between two points that the library gave.
 */
export function ontoPose(table, q, T, steps = 4) {
  const L = reach(table);
  let best = q;
  for (let k = 0; k < steps; k++) {
    const F = frames(table, best),
      X = F[F.length - 1],
      J = jacobian(table, best, F);
    const half = (c) => cross(column(X, c), column(T, c));
    const turn = [0, 1, 2].map(half).reduce((a, v) => [a[0] + v[0] / 2, a[1] + v[1] / 2, a[2] + v[2] / 2], [0, 0, 0]);
    const e = [...sub(position(T), position(X)), ...turn.map((v) => v * L)];
    if (Math.hypot(...e) < 1e-13 * L) break;
    const S = J.map((r, i) => (i < 3 ? r : r.map((v) => v * L)));
    const gram = S.map((u, i) =>
      S.map((v, j) => u.reduce((sum, w, m) => sum + w * v[m], 0) + (i === j ? 1e-10 * L * L : 0)),
    );
    const y = solveLinear(gram, e);
    best = best.map((v, m) => v + S.reduce((sum, row, i) => sum + row[m] * y[i], 0));
  }
  return best.every(Number.isFinite) ? best : q;
}

/** A blank table to build an arm from: no joints yet. */
export const blank = (convention) => ({
  name: 'my-arm',
  convention,
  joints: [],
  base: identity(),
  tool: identity(),
  postures: {},
});
