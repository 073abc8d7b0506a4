// 4x4 poses as flat arrays of 16 numbers, row by row: the arithmetic that the page needs and no more.

export const identity = () => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** Product of two poses; the last row is known, so it is not computed. */
export function mul(A, B) {
  const C = new Array(16);
  for (let r = 0; r < 12; r += 4) {
    const a = A[r],
      b = A[r + 1],
      c = A[r + 2];
    C[r] = a * B[0] + b * B[4] + c * B[8];
    C[r + 1] = a * B[1] + b * B[5] + c * B[9];
    C[r + 2] = a * B[2] + b * B[6] + c * B[10];
    C[r + 3] = a * B[3] + b * B[7] + c * B[11] + A[r + 3];
  }
  C[12] = 0;
  C[13] = 0;
  C[14] = 0;
  C[15] = 1;
  return C;
}

export function invert(T) {
  const x = T[3],
    y = T[7],
    z = T[11];
  return [
    T[0],
    T[4],
    T[8],
    -(T[0] * x + T[4] * y + T[8] * z),
    T[1],
    T[5],
    T[9],
    -(T[1] * x + T[5] * y + T[9] * z),
    T[2],
    T[6],
    T[10],
    -(T[2] * x + T[6] * y + T[10] * z),
    0,
    0,
    0,
    1,
  ];
}

export const position = (T) => [T[3], T[7], T[11]];
export const column = (T, c) => [T[c], T[4 + c], T[8 + c]];
export const rows = (T) => [0, 4, 8, 12].map((r) => T.slice(r, r + 4));
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const addScaled = (a, b, s) => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const norm = (a) => Math.hypot(a[0], a[1], a[2]);

/** How far the upper-left block is from a rotation: the largest entry of R R^T - I, or infinity when left-handed. */
export function rotationDefect(T) {
  let worst = 0;
  for (let i = 0; i < 3; i++)
    for (let j = i; j < 3; j++) {
      const e = dot([T[4 * i], T[4 * i + 1], T[4 * i + 2]], [T[4 * j], T[4 * j + 1], T[4 * j + 2]]) - (i === j ? 1 : 0);
      worst = Math.max(worst, Math.abs(e));
    }
  return dot(cross(column(T, 0), column(T, 1)), column(T, 2)) > 0 ? worst : Infinity;
}

/** The nearest rotation, by a few Newton steps of the polar decomposition; for typed matrices of four decimals. */
export function nearestRotation(T) {
  let R = T.slice();
  for (let k = 0; k < 8; k++) {
    const x = column(R, 0),
      y = column(R, 1),
      z = column(R, 2);
    const yz = cross(y, z),
      zx = cross(z, x),
      xy = cross(x, y),
      det = dot(x, yz);
    const C = [yz, zx, xy];
    for (let c = 0; c < 3; c++) for (let r = 0; r < 3; r++) R[4 * r + c] = 0.5 * (R[4 * r + c] + C[c][r] / det);
  }
  return R;
}

/** Angle in rad of the rotation that carries A's orientation into B's. */
export function angleBetween(A, B) {
  let trace = 0,
    skew = [0, 0, 0];
  const D = mul(invert(A), B);
  trace = D[0] + D[5] + D[10];
  skew = [D[9] - D[6], D[2] - D[8], D[4] - D[1]];
  return Math.atan2(norm(skew), trace - 1);
}
