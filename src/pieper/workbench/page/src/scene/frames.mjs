// Coordinate frames as three arrows, x red, y green, z blue, with the frame's name beside its origin.
import * as THREE from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import { showLabels } from './labels.mjs';
import identity from '../../../../document/identity.json';

export const axisColours = identity.axes;

function arrow(colour, turn) {
  const shaft = new THREE.CylinderGeometry(0.028, 0.028, 0.82, 8).translate(0, 0.41, 0);
  const head = new THREE.ConeGeometry(0.085, 0.22, 12).translate(0, 0.9, 0);
  const g = mergeGeometries([shaft, head]).applyMatrix4(turn);
  const c = new THREE.Color(colour),
    rgb = new Float32Array(g.attributes.position.count * 3);
  for (let i = 0; i < rgb.length; i += 3) rgb.set([c.r, c.g, c.b], i);
  g.setAttribute('color', new THREE.BufferAttribute(rgb, 3));
  return g;
}
const along = (axis) =>
  new THREE.Matrix4().makeRotationFromQuaternion(
    new THREE.Quaternion().setFromUnitVectors(new THREE.Vector3(0, 1, 0), new THREE.Vector3(...axis)),
  );
const glyph = mergeGeometries([
  arrow(axisColours[0], along([1, 0, 0])),
  arrow(axisColours[1], along([0, 1, 0])),
  arrow(axisColours[2], along([0, 0, 1])),
]);

export class Frames {
  constructor() {
    this.group = new THREE.Group();
    this.mesh = new THREE.InstancedMesh(glyph, new THREE.MeshBasicMaterial({ vertexColors: true, fog: false }), 64);
    this.mesh.frustumCulled = false;
    this.mesh.count = 0;
    this.group.add(this.mesh);
  }

  /** Show frames of a size; other names may stand beside theirs. */
  show(list, size, names = []) {
    this.last = [list, size];
    const m = new THREE.Matrix4();
    this.mesh.count = list.length;
    list.forEach(({ T }, i) => this.mesh.setMatrixAt(i, m.set(...T).scale(new THREE.Vector3(size, size, size))));
    // a name would stand where none of the arrows go
    const corner = (T, r) => T[r + 3] - size * 0.4 * (T[r] + T[r + 1] + T[r + 2]);
    showLabels(this, [
      ...list.map(({ T, name }) => ({ text: name, at: [T[3], T[7], T[11]], wish: [0, 4, 8].map((r) => corner(T, r)) })),
      ...names,
    ]);
    this.mesh.instanceMatrix.needsUpdate = true;
    this.mesh.visible = list.length > 0;
  }
}
