// A two-finger gripper at the tool, from open (0) to closed (1); drawn where a program has one.
import * as THREE from 'three';
import { state, on } from '../store.mjs';
import { colours } from '../theme.mjs';
import { reach } from '../kinematics.mjs';
import { scene, invalidate } from './view.mjs';

const group = new THREE.Group();
const material = new THREE.MeshBasicMaterial({ fog: false });
const lighter = new THREE.MeshBasicMaterial({ fog: false });
const box = new THREE.BoxGeometry(1, 1, 1);
const palm = new THREE.Mesh(box, material),
  fingers = [new THREE.Mesh(box, lighter), new THREE.Mesh(box, lighter)];
group.add(palm, ...fingers);
group.matrixAutoUpdate = false;
group.visible = false;
let value = null;

export function begin() {
  scene.add(group);
  on('q', () => value !== null && place());
  on('theme', paint);
  paint();
}
function paint() {
  material.color.set(colours.joint);
  lighter.color.set(colours.accent);
}
/** Show it at a value, 0 open to 1 closed; null takes it away. */
export function showGripper(v) {
  if (v === null && value === null) return;
  value = v;
  group.visible = v !== null;
  if (v !== null) place();
  invalidate();
}
export const gripperShown = () => value;
function place() {
  const T = state.frames.at(-1),
    size = 0.075 * reach(state.table);
  // the fingers end at the tool's point, which is what a program says where to
  palm.scale.set(0.35 * size, 1.1 * size, 0.25 * size);
  palm.position.set(0, 0, -0.85 * size);
  fingers.forEach((f, i) => {
    const open = (0.08 + 0.36 * (1 - value)) * size;
    f.scale.set(0.26 * size, 0.13 * size, 0.95 * size);
    f.position.set(0, (i ? 1 : -1) * open, -0.3 * size);
  });
  group.matrix.set(...T);
  group.updateMatrixWorld(true);
}
