// Loose triangles become a mesh: corners that are one are one, edges sharper than a crease stay sharp; and a coarse copy.

/** Cosine of the angle between two faces above which their edge is seen. */
const CREASE = Math.cos((38 * Math.PI) / 180);
/**
 * Triangles of the two coarse copies, at most: for where the processor draws, at rest and while things move; and the cells
 * along the diagonal that are tried for them, fine to coarse.
 */
const SOME = 16000,
  FEW = 1600,
  CELLS = [200, 140, 100, 72, 56, 40, 28, 20, 14];

/** Number equal rows of integers: `key(i, out)` writes three 32-bit integers. Returns the number of each row. */
function numbered(count, key) {
  let size = 1024;
  while (size < 2 * count) size *= 2;
  const slots = new Int32Array(size).fill(-1),
    seen = new Int32Array(3 * count),
    of = new Int32Array(count),
    k = new Int32Array(3);
  let n = 0;
  for (let i = 0; i < count; i++) {
    key(i, k);
    let at = (Math.imul(k[0], 73856093) ^ Math.imul(k[1], 19349663) ^ Math.imul(k[2], 83492791)) >>> 0;
    at = (at ^ (at >>> 15)) & (size - 1);
    for (;;) {
      const other = slots[at];
      if (other < 0) {
        slots[at] = n;
        seen.set(k, 3 * n);
        of[i] = n;
        n += 1;
        break;
      }
      if (seen[3 * other] === k[0] && seen[3 * other + 1] === k[1] && seen[3 * other + 2] === k[2]) {
        of[i] = other;
        break;
      }
      at = (at + 1) & (size - 1);
    }
  }
  return { of, n };
}

/** @param at nine numbers a triangle. @returns {at, normal, index} of the mesh, and of its coarse copies `some` and `few`; whether it is closed */
export function weld(at) {
  const bits = new Int32Array(at.buffer, at.byteOffset, at.length);
  const same = numbered(at.length / 3, (i, k) => {
    // minus zero and zero are one place
    for (let c = 0; c < 3; c++) k[c] = bits[3 * i + c] === -2147483648 ? 0 : bits[3 * i + c];
  });
  const points = new Float32Array(3 * same.n);
  for (let i = 0; i < same.of.length; i++) points.set(at.subarray(3 * i, 3 * i + 3), 3 * same.of[i]);
  const closed = turnedOut(points, same.of);
  const fine = shaded(points, same.of);
  const some = coarse(points, same.of, SOME) ?? fine;
  return { ...fine, closed, some, few: coarse(points, same.of, FEW) ?? some };
}

/** Turn the faces of a closed surface outwards; returns whether it is one: then its far side need not be drawn. */
function turnedOut(points, corner) {
  const sum = [0, 0, 0];
  let area = 0,
    volume = 0;
  for (let f = 0; f < corner.length; f += 3) {
    const a = 3 * corner[f],
      b = 3 * corner[f + 1],
      c = 3 * corner[f + 2];
    const ax = points[a],
      ay = points[a + 1],
      az = points[a + 2],
      bx = points[b] - ax,
      by = points[b + 1] - ay,
      bz = points[b + 2] - az,
      cx = points[c] - ax,
      cy = points[c + 1] - ay,
      cz = points[c + 2] - az;
    const x = by * cz - bz * cy,
      y = bz * cx - bx * cz,
      z = bx * cy - by * cx;
    sum[0] += x;
    sum[1] += y;
    sum[2] += z;
    area += Math.hypot(x, y, z);
    volume += ax * x + ay * y + az * z;
  }
  // the areas of a closed surface, as vectors, add up to nothing
  if (Math.hypot(...sum) > 1e-4 * area || volume === 0) return false;
  if (volume < 0) for (let f = 0; f < corner.length; f += 3) [corner[f], corner[f + 1]] = [corner[f + 1], corner[f]];
  return true;
}

/** Faces of shared points become a mesh with normals that follow smooth places and stop at creases. */
function shaded(points, corner) {
  const faces = corner.length / 3,
    n = points.length / 3,
    normal = new Float32Array(3 * faces), // twice the area long
    unit = new Float32Array(3 * faces);
  for (let f = 0; f < faces; f++) {
    const a = 3 * corner[3 * f],
      b = 3 * corner[3 * f + 1],
      c = 3 * corner[3 * f + 2];
    const ux = points[b] - points[a],
      uy = points[b + 1] - points[a + 1],
      uz = points[b + 2] - points[a + 2],
      vx = points[c] - points[a],
      vy = points[c + 1] - points[a + 1],
      vz = points[c + 2] - points[a + 2];
    const x = uy * vz - uz * vy,
      y = uz * vx - ux * vz,
      z = ux * vy - uy * vx,
      len = Math.hypot(x, y, z) || 1;
    normal[3 * f] = x;
    normal[3 * f + 1] = y;
    normal[3 * f + 2] = z;
    unit[3 * f] = x / len;
    unit[3 * f + 1] = y / len;
    unit[3 * f + 2] = z / len;
  }
  // the faces about each point, one after another
  const first = new Int32Array(n + 1);
  for (const p of corner) first[p + 1] += 1;
  for (let p = 0; p < n; p++) first[p + 1] += first[p];
  const around = new Int32Array(corner.length),
    next = first.slice();
  for (let i = 0; i < corner.length; i++) around[next[corner[i]]++] = (i / 3) | 0;
  const mine = new Int8Array(3 * corner.length);
  for (let i = 0; i < corner.length; i++) {
    const f = 3 * ((i / 3) | 0),
      p = corner[i];
    let x = 0,
      y = 0,
      z = 0;
    // a fan of very many faces (the middle of a disc) is flat: its own normal will do
    if (first[p + 1] - first[p] > 64) {
      x = unit[f];
      y = unit[f + 1];
      z = unit[f + 2];
    } else
      for (let k = first[p]; k < first[p + 1]; k++) {
        const g = 3 * around[k];
        if (unit[f] * unit[g] + unit[f + 1] * unit[g + 1] + unit[f + 2] * unit[g + 2] < CREASE) continue;
        x += normal[g];
        y += normal[g + 1];
        z += normal[g + 2];
      }
    const len = Math.hypot(x, y, z) || 1;
    mine[3 * i] = Math.round((127 * x) / len);
    mine[3 * i + 1] = Math.round((127 * y) / len);
    mine[3 * i + 2] = Math.round((127 * z) / len);
  }
  const whole = numbered(corner.length, (i, k) => {
    k[0] = corner[i];
    k[1] = (mine[3 * i] << 16) ^ ((mine[3 * i + 1] & 0xff) << 8) ^ (mine[3 * i + 2] & 0xff);
    k[2] = 0;
  });
  const out = { at: new Float32Array(3 * whole.n), normal: new Int8Array(4 * whole.n), index: null };
  for (let i = 0; i < corner.length; i++) {
    const v = whole.of[i],
      p = 3 * corner[i];
    out.at[3 * v] = points[p];
    out.at[3 * v + 1] = points[p + 1];
    out.at[3 * v + 2] = points[p + 2];
    out.normal[4 * v] = mine[3 * i];
    out.normal[4 * v + 1] = mine[3 * i + 1];
    out.normal[4 * v + 2] = mine[3 * i + 2];
  }
  out.index = new Uint32Array(whole.of);
  return out;
}

/** Points in one cell of a grid become one; faces that vanish go. Null where there are few faces anyway. */
function coarse(points, corner, most) {
  if (corner.length / 3 <= most) return null;
  const lo = [Infinity, Infinity, Infinity],
    hi = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < points.length; i++) {
    const c = i % 3;
    if (points[i] < lo[c]) lo[c] = points[i];
    if (points[i] > hi[c]) hi[c] = points[i];
  }
  const diagonal = Math.hypot(hi[0] - lo[0], hi[1] - lo[1], hi[2] - lo[2]) || 1;
  let made = null;
  const faces = corner.length / 3;
  for (const cells of CELLS) {
    // a closed surface fills about three cells a face of its box: what is far too fine is not tried
    if (Math.min(faces, 1.2 * cells * cells) > 3 * most) continue;
    const size = diagonal / cells;
    const groups = numbered(points.length / 3, (i, k) => {
      for (let c = 0; c < 3; c++) k[c] = Math.floor((points[3 * i + c] - lo[c]) / size);
    });
    const sum = new Float32Array(3 * groups.n),
      count = new Int32Array(groups.n);
    for (let i = 0; i < groups.of.length; i++) {
      const g = groups.of[i];
      count[g] += 1;
      for (let c = 0; c < 3; c++) sum[3 * g + c] += points[3 * i + c];
    }
    for (let g = 0; g < groups.n; g++) for (let c = 0; c < 3; c++) sum[3 * g + c] /= count[g];
    const kept = [];
    for (let f = 0; f < corner.length; f += 3) {
      const a = groups.of[corner[f]],
        b = groups.of[corner[f + 1]],
        c = groups.of[corner[f + 2]];
      if (a !== b && b !== c && c !== a) kept.push(a, b, c);
    }
    made = { sum, kept };
    if (kept.length / 3 <= most) break;
  }
  return shaded(made.sum, Int32Array.from(made.kept));
}
