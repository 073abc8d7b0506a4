// Orientation in the notations of the field, both ways, each with its order named. Angles in rad.
const EPS = 1e-9;

const fromColumns = (x, y, z) => [x[0], y[0], z[0], 0, x[1], y[1], z[1], 0, x[2], y[2], z[2], 0, 0, 0, 0, 1];
const rz = (t) => [Math.cos(t), Math.sin(t)];

/** Rz(yaw) Ry(pitch) Rx(roll). */
function fromRpy([roll, pitch, yaw]) {
  const [c1, s1] = rz(yaw),
    [c2, s2] = rz(pitch),
    [c3, s3] = rz(roll);
  return fromColumns(
    [c1 * c2, s1 * c2, -s2],
    [c1 * s2 * s3 - s1 * c3, s1 * s2 * s3 + c1 * c3, c2 * s3],
    [c1 * s2 * c3 + s1 * s3, s1 * s2 * c3 - c1 * s3, c2 * c3],
  );
}
function toRpy(T) {
  const c = Math.hypot(T[0], T[4]);
  const pitch = Math.atan2(-T[8], c);
  // Gimbal lock: only a sum or difference is defined; yaw is set to zero, so that roll carries all of it.
  return c > EPS ? [Math.atan2(T[9], T[10]), pitch, Math.atan2(T[4], T[0])] : [Math.atan2(-T[6], T[5]), pitch, 0];
}

/** Rz(phi) Ry(theta) Rz(psi). */
function fromZyz([phi, theta, psi]) {
  const [c1, s1] = rz(phi),
    [c2, s2] = rz(theta),
    [c3, s3] = rz(psi);
  return fromColumns(
    [c1 * c2 * c3 - s1 * s3, s1 * c2 * c3 + c1 * s3, -s2 * c3],
    [-c1 * c2 * s3 - s1 * c3, -s1 * c2 * s3 + c1 * c3, s2 * s3],
    [c1 * s2, s1 * s2, c2],
  );
}
function toZyz(T) {
  const s = Math.hypot(T[2], T[6]);
  if (s < EPS) return T[10] > 0 ? [0, 0, Math.atan2(T[4], T[0])] : [0, Math.PI, Math.atan2(T[4], -T[0]) || 0];
  return [Math.atan2(T[6], T[2]), Math.atan2(s, T[10]), Math.atan2(T[9], -T[8])];
}

/** Unit quaternion, w x y z, w >= 0; the largest component is found first, so that nothing small is divided by. */
export function toQuaternion(T) {
  const m = [T[0] + T[5] + T[10], T[0] - T[5] - T[10], T[5] - T[0] - T[10], T[10] - T[0] - T[5]];
  const k = m.indexOf(Math.max(...m)),
    r = 2 * Math.sqrt(Math.max(m[k] + 1, 0));
  const a = T[9] - T[6],
    b = T[2] - T[8],
    c = T[4] - T[1],
    d = T[1] + T[4],
    e = T[2] + T[8],
    f = T[6] + T[9];
  const all = [
    [r / 4, a / r, b / r, c / r],
    [a / r, r / 4, d / r, e / r],
    [b / r, d / r, r / 4, f / r],
    [c / r, e / r, f / r, r / 4],
  ];
  const q = all[k],
    s = q[0] < 0 ? -1 : 1;
  return q.map((v) => s * v + 0);
}
export function fromQuaternion(q) {
  const n = Math.hypot(...q);
  if (n < EPS) return null;
  const [w, x, y, z] = q.map((v) => v / n);
  return fromColumns(
    [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)],
    [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)],
    [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)],
  );
}

function toAxisAngle(T) {
  const [w, x, y, z] = toQuaternion(T),
    s = Math.hypot(x, y, z);
  return s < EPS ? [0, 0, 1, 0] : [x / s, y / s, z / s, 2 * Math.atan2(s, w)];
}
function fromAxisAngle([x, y, z, angle]) {
  const n = Math.hypot(x, y, z),
    s = Math.sin(angle / 2);
  return n < EPS ? null : fromQuaternion([Math.cos(angle / 2), (s * x) / n, (s * y) / n, (s * z) / n]);
}

/** kind of each number: 'angle' follows the unit of angles, 'plain' has none. */
export const notations = {
  rpy: {
    title: 'Roll, pitch, yaw',
    order: 'R = Rz(yaw) Ry(pitch) Rx(roll)',
    names: ['roll', 'pitch', 'yaw'],
    kinds: ['angle', 'angle', 'angle'],
    to: toRpy,
    from: fromRpy,
  },
  zyz: {
    title: 'ZYZ Euler angles',
    order: 'R = Rz(φ) Ry(θ) Rz(ψ)',
    names: ['φ', 'θ', 'ψ'],
    kinds: ['angle', 'angle', 'angle'],
    to: toZyz,
    from: fromZyz,
  },
  axis: {
    title: 'Axis and angle',
    order: 'unit axis x y z, then the turn about it',
    names: ['x', 'y', 'z', 'angle'],
    kinds: ['plain', 'plain', 'plain', 'angle'],
    to: toAxisAngle,
    from: fromAxisAngle,
  },
  quaternion: {
    title: 'Quaternion',
    order: 'order w x y z, scalar first, w ≥ 0',
    names: ['w', 'x', 'y', 'z'],
    kinds: ['plain', 'plain', 'plain', 'plain'],
    to: toQuaternion,
    from: fromQuaternion,
  },
};

/** Pose with T's rotation taken from the numbers of a notation; null where they name no rotation. */
export function poseFrom(notation, numbers, p) {
  const R = notations[notation].from(numbers);
  if (!R) return null;
  R[3] = p[0];
  R[7] = p[1];
  R[11] = p[2];
  return R;
}

/** The pose a fraction s of the way: straight in position, one constant-axis rotation. */
export function between(A, B, s) {
  const qa = toQuaternion(A);
  let qb = toQuaternion(B),
    c = qa.reduce((sum, v, i) => sum + v * qb[i], 0);
  if (c < 0) {
    qb = qb.map((v) => -v);
    c = -c;
  }
  const h = Math.acos(Math.min(c, 1)),
    k = Math.sin(h);
  const [u, v] = k < 1e-7 ? [1 - s, s] : [Math.sin((1 - s) * h) / k, Math.sin(s * h) / k];
  const R = fromQuaternion(qa.map((x, i) => u * x + v * qb[i]));
  [3, 7, 11].forEach((i) => {
    R[i] = A[i] + s * (B[i] - A[i]);
  });
  return R;
}
