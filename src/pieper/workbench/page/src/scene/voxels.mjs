// A reach map as solid voxels, coloured by a value, whole or cut open; only faces that can be seen are drawn.
import * as THREE from 'three';
import { scene, invalidate } from './view.mjs';
import { rangeOf, colourAt, unpacked } from './scale.mjs';

/** The six faces of a voxel: where its neighbour is, its corners in order, and how light it is. */
const FACES = [
  [[1, 0, 0], [1, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1], 0.86],
  [[-1, 0, 0], [0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 1, 1], 0.7],
  [[0, 1, 0], [1, 1, 0, 0, 1, 0, 0, 1, 1, 1, 1, 1], 0.66],
  [[0, -1, 0], [0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1], 0.92],
  [[0, 0, 1], [0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1], 1],
  [[0, 0, -1], [0, 1, 0, 1, 1, 0, 1, 0, 0, 0, 0, 0], 0.5],
];
const mesh = new THREE.Mesh(
  new THREE.BufferGeometry(),
  new THREE.MeshBasicMaterial({ vertexColors: true, fog: false }),
);
mesh.frustumCulled = false;
mesh.visible = false;
scene.add(mesh);

let grid = null,
  cut = null;
export const range = { lo: 0, hi: 1 };

/** Begin a map of so many voxels in a box: {low, shape, step}. */
export function begin({ low, shape, step }) {
  grid = { low, shape, step, values: new Map() };
  draw();
}
const key = (i, j, k) => (i * grid.shape[1] + j) * grid.shape[2] + k;
export function take(base64) {
  const block = unpacked(base64);
  for (let o = 0; o < block.length; o += 4) {
    const [i, j, k] = [0, 1, 2].map((c) => Math.floor((block[o + c] - grid.low[c]) / grid.step));
    grid.values.set(key(i, j, k), block[o + 3]);
  }
  draw();
}
export const size = () => grid?.values.size ?? 0;
/** Leave out what lies before the plane y = at; null shows the whole. */
export function cutAt(at) {
  cut = at;
  draw();
}
export function corners() {
  if (!size()) return [];
  const high = grid.low.map((v, c) => v + grid.shape[c] * grid.step);
  return [0, 1, 2, 3, 4, 5, 6, 7].map((b) => [0, 1, 2].map((c) => (b & (1 << c) ? high[c] : grid.low[c])));
}
export function clear() {
  grid = null;
  draw();
}

function draw() {
  mesh.visible = size() > 0;
  mesh.geometry.dispose();
  mesh.geometry = new THREE.BufferGeometry();
  if (!mesh.visible) {
    invalidate();
    return;
  }
  const { low, shape, step, values } = grid,
    at = [],
    rgb = [],
    index = [];
  Object.assign(range, rangeOf(values.values()));
  const seen = (i, j, k) =>
    j >= 0 && i >= 0 && k >= 0 && i < shape[0] && j < shape[1] && k < shape[2] && values.has(key(i, j, k)) && after(j);
  const after = (j) => cut === null || low[1] + (j + 0.5) * step >= cut;
  for (const [where, value] of values) {
    const k = where % shape[2],
      j = Math.floor(where / shape[2]) % shape[1],
      i = Math.floor(where / (shape[1] * shape[2]));
    if (!after(j)) continue;
    const { r, g, b } = colourAt(value, range);
    for (const [[di, dj, dk], corner, light] of FACES) {
      if (seen(i + di, j + dj, k + dk)) continue;
      const first = at.length / 3;
      for (let c = 0; c < 12; c += 3) {
        at.push(
          low[0] + (i + corner[c]) * step,
          low[1] + (j + corner[c + 1]) * step,
          low[2] + (k + corner[c + 2]) * step,
        );
        rgb.push(r * light, g * light, b * light);
      }
      index.push(first, first + 1, first + 2, first, first + 2, first + 3);
    }
  }
  mesh.geometry.setAttribute('position', new THREE.Float32BufferAttribute(at, 3));
  mesh.geometry.setAttribute('color', new THREE.Float32BufferAttribute(rgb, 3));
  mesh.geometry.setIndex(index);
  invalidate();
}
