// What stands around the arm: frames, curves, boxes, cylinders, capsules; the page's own and what Python added.
import * as THREE from 'three';
import { state, on } from '../store.mjs';
import { colours } from '../theme.mjs';
import { column, position } from '../matrix.mjs';
import { scene, invalidate } from './view.mjs';
import { showBeside } from './arm.mjs';
import { Frames } from './frames.mjs';
import { reach } from '../kinematics.mjs';

const group = new THREE.Group();
const frames = new Frames();
const place = new THREE.Matrix4();

/** A body's paint: lit a little from above, so that its sides are told apart. */
const paint = (colour) =>
  new THREE.MeshBasicMaterial({ color: colour, vertexColors: true, transparent: true, opacity: 0.86, fog: false });
/** Faces darker the less they look up and to the light. */
function shaded(geometry) {
  const n = geometry.attributes.normal,
    c = new Float32Array(3 * n.count);
  for (let i = 0; i < n.count; i++)
    c.fill(0.72 + 0.2 * n.getZ(i) + 0.08 * (n.getX(i) * 0.6 - n.getY(i) * 0.8), 3 * i, 3 * i + 3);
  geometry.setAttribute('color', new THREE.BufferAttribute(c, 3));
  return geometry;
}
const upright = (g) => g.rotateX(Math.PI / 2);

const makers = {
  box: (t) => [shaded(new THREE.BoxGeometry(...t.size)), t.T],
  cylinder: (t) => [shaded(upright(new THREE.CylinderGeometry(t.r, t.r, t.h, 40))), t.T],
  capsule(t) {
    const a = new THREE.Vector3(...t.a),
      along = new THREE.Vector3(...t.b).sub(a),
      length = along.length();
    const m = new THREE.Matrix4().makeRotationFromQuaternion(
      new THREE.Quaternion().setFromUnitVectors(
        new THREE.Vector3(0, 0, 1),
        length ? along.clone().normalize() : new THREE.Vector3(0, 0, 1),
      ),
    );
    m.setPosition(a.addScaledVector(along, 0.5));
    return [shaded(upright(new THREE.CapsuleGeometry(t.r, length, 12, 28))), m.clone().transpose().elements.slice()];
  },
};

/** A body's mesh in a colour, and its place; null for what is none. */
export function bodyMesh(t, colour, opacity = 0.86) {
  if (!makers[t.kind]) return null;
  const [geometry, T] = makers[t.kind](t),
    material = paint(colour);
  material.opacity = opacity;
  material.depthWrite = opacity > 0.5;
  const mesh = new THREE.Mesh(geometry, material);
  mesh.matrixAutoUpdate = false;
  return { mesh, T };
}

/** Everything that stands there, whoever put it. */
export const things = () => [...state.world, ...(state.things ?? [])];

/** Where a body is and a point over it, on whose side its name stands. */
const middleOf = (t) => {
  const T = carried.get(t.name) ?? t.T;
  return T ? position(T) : t.a.map((v, i) => (v + t.b[i]) / 2);
};
const above = (t) => middleOf(t).map((v, i) => v + (i === 2 ? 1 : 0));
/** Points that a picture of a thing must hold. */
function corners(t) {
  if (t.kind === 'curve') return t.points.filter((_, i) => i % 20 === 0 || i === t.points.length - 1);
  if (t.kind === 'capsule') return [t.a, t.b];
  if (!t.T) return [];
  const p = position(t.T),
    half = t.kind === 'box' ? t.size.map((v) => v / 2) : t.kind === 'cylinder' ? [t.r, t.r, t.h / 2] : [0, 0, 0];
  return [-1, 1].flatMap((s) => [0, 1, 2].map((k) => p.map((v, i) => v + s * half[k] * column(t.T, k)[i])));
}

export function begin() {
  scene.add(group, frames.group);
  on(['world', 'table'], draw);
  on('theme', draw);
}
/** Where a thing is while something holds it, by its name. */
const carried = new Map();
export function carry(name, T) {
  if (T) carried.set(name, T);
  else if (!carried.delete(name)) return;
  const mesh = group.children.find((m) => m.userData.name === name);
  const t = state.world.find((x) => x.name === name);
  if (mesh && t) mesh.matrix.set(...(T ?? t.T));
  showNames();
}
export const carriedAt = (name) => carried.get(name) ?? null;
export function letAllGo() {
  for (const name of [...carried.keys()]) carry(name, null);
}

/** Frames, and the names of everything, where they stand now. */
function showNames() {
  const list = things();
  frames.show(
    list.filter((t) => t.kind === 'frame'),
    0.11 * reach(state.table),
    list.filter((t) => makers[t.kind]).map((t) => ({ text: t.name, at: middleOf(t), wish: above(t) })),
  );
}
function draw() {
  for (const o of group.children) o.geometry.dispose();
  group.clear();
  const list = things();
  for (const t of list) {
    if (t.kind === 'curve') {
      const g = new THREE.BufferGeometry().setFromPoints(t.points.map((p) => new THREE.Vector3(...p)));
      group.add(new THREE.Line(g, new THREE.LineBasicMaterial({ color: colours.trace, fog: false })));
    } else if (makers[t.kind]) {
      const { mesh, T } = bodyMesh(t, t.role === 'object' ? colours.accent : colours.ghost);
      mesh.matrix.copy(place.set(...(carried.get(t.name) ?? T)));
      mesh.userData.name = t.name;
      group.add(mesh);
    }
  }
  showNames();
  showBeside('world', list.flatMap(corners));
  invalidate();
}
export const thingsDrawn = () => group.children.length + (frames.last?.[0].length ?? 0);
