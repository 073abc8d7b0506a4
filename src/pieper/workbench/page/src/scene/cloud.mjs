// The cloud of reachable points, coloured by a value from low to high.
import * as THREE from 'three';
import { scene, renderer, invalidate } from './view.mjs';
import { rangeOf, colourAt, unpacked } from './scale.mjs';

const material = new THREE.PointsMaterial({ size: 2.2, sizeAttenuation: false, vertexColors: true, fog: false });
const points = new THREE.Points(new THREE.BufferGeometry(), material);
points.frustumCulled = false;
points.visible = false;
scene.add(points);

let at = null,
  values = null,
  count = 0;
export const range = { lo: 0, hi: 1 };

export function begin(total) {
  at = new Float32Array(3 * total);
  values = new Float32Array(total);
  count = 0;
  points.geometry.dispose();
  points.geometry = new THREE.BufferGeometry();
  points.geometry.setAttribute('position', new THREE.BufferAttribute(at, 3));
  points.geometry.setAttribute('color', new THREE.BufferAttribute(new Float32Array(3 * total), 3));
  points.geometry.setDrawRange(0, 0);
  points.visible = true;
  invalidate();
}
/** Take a piece as the server sends it: x, y, z, value as float32, in base64. */
export function take(base64) {
  const block = unpacked(base64);
  for (let i = 0; i < block.length && count < values.length; i += 4, count++) {
    at.set(block.subarray(i, i + 3), 3 * count);
    values[count] = block[i + 3];
  }
  recolour();
}
function recolour() {
  Object.assign(range, rangeOf(values.subarray(0, count)));
  const rgb = points.geometry.attributes.color.array;
  for (let i = 0; i < count; i++) colourAt(values[i], range).toArray(rgb, 3 * i);
  points.geometry.setDrawRange(0, count);
  points.geometry.attributes.position.needsUpdate = true;
  points.geometry.attributes.color.needsUpdate = true;
  invalidate();
}
export const size = () => count;
/** Leave out the half before the plane y = at, so that the inside and the arm are seen; null shows the whole. */
export function cutAt(at) {
  renderer.localClippingEnabled = at !== null;
  material.clippingPlanes = at === null ? null : [new THREE.Plane(new THREE.Vector3(0, 1, 0), -at)];
  material.needsUpdate = true;
  invalidate();
}
/** The eight corners of the cloud. */
export function corners() {
  const box = new THREE.Box3();
  for (let i = 0; i < count; i++) box.expandByPoint(new THREE.Vector3(at[3 * i], at[3 * i + 1], at[3 * i + 2]));
  const { min: a, max: b } = box;
  return count ? [0, 1, 2, 3, 4, 5, 6, 7].map((k) => [k & 1 ? a.x : b.x, k & 2 ? a.y : b.y, k & 4 ? a.z : b.z]) : [];
}
export function clear() {
  count = 0;
  points.visible = false;
  invalidate();
}
