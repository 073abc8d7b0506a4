// Many arms in a handful of draw calls: every rod, ball, drum and sleeve of all of them is an instance of one mesh.
import * as THREE from 'three';
import { cross, norm, sub } from '../matrix.mjs';

const segments = 24;
const rodGeometry = new THREE.CylinderGeometry(1, 1, 1, segments, 1, true).rotateX(Math.PI / 2);
const ballGeometry = new THREE.SphereGeometry(1, segments, 14);
const bevel = 0.1;
const drumGeometry = new THREE.LatheGeometry(
  [[0, -0.5], [1 - bevel, -0.5], [1, -0.5 + bevel / 2], [1, 0.5 - bevel / 2], [1 - bevel, 0.5], [0, 0.5]].map(([r, y]) => new THREE.Vector2(r, y)), segments)
  .rotateX(Math.PI / 2);
const bandGeometry = new THREE.CylinderGeometry(1, 1, 1, segments, 1, true).rotateX(Math.PI / 2);
const boxGeometry = new THREE.BoxGeometry(2, 2, 1);
for (const g of [drumGeometry]) g.computeVertexNormals();

const m = new THREE.Matrix4();
/** Unit mesh along z to a place: radius r, height h, centred at `at`, z along dir. */
function stand(at, dir, r, h, x = null) {
  let ux = x && Math.abs(dir[0] * x[0] + dir[1] * x[1] + dir[2] * x[2]) < 0.5 ? x
    : cross(dir, Math.abs(dir[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0]);
  let uy = cross(dir, ux), k = norm(uy) || 1;
  uy = uy.map((v) => v / k);
  ux = cross(uy, dir);
  return m.set(ux[0] * r, uy[0] * r, dir[0] * h, at[0], ux[1] * r, uy[1] * r, dir[1] * h, at[1], ux[2] * r, uy[2] * r, dir[2] * h, at[2], 0, 0, 0, 1);
}

export class Bodies {
  /** @param kinds {link, joint, accent} materials; `shadow` a material for the flattened copy, or null. */
  constructor(materials, { shadow = null, perArm = 1 } = {}) {
    this.group = new THREE.Group();
    this.materials = materials;
    this.shadow = shadow;
    this.capacity = 0;
    this.perArm = perArm;
    this.meshes = {};
  }

  #grow(capacity) {
    if (capacity <= this.capacity) return;
    this.capacity = Math.max(64, 2 ** Math.ceil(Math.log2(capacity)));
    this.group.clear();
    const kinds = { rod: [rodGeometry, 'link'], ball: [ballGeometry, 'link'], drum: [drumGeometry, 'joint'], band: [bandGeometry, 'accent'],
      box: [boxGeometry, 'joint'], tip: [ballGeometry, 'accent'], plate: [drumGeometry, 'joint'] };
    for (const [kind, [geometry, material]] of Object.entries(kinds)) {
      this.meshes[kind]?.dispose();
      const mesh = new THREE.InstancedMesh(geometry, this.materials[material], this.capacity);
      mesh.frustumCulled = false;
      mesh.count = 0;
      this.meshes[kind] = mesh;
      this.group.add(mesh);
      if (this.shadow && kind !== 'band') {
        const flat = new THREE.InstancedMesh(geometry, this.shadow.material, this.capacity);
        flat.instanceMatrix = mesh.instanceMatrix;
        flat.frustumCulled = false;
        flat.matrixAutoUpdate = false;
        flat.matrix.copy(this.shadow.matrix);
        flat.renderOrder = -1;
        mesh.userData.flat = flat;
        this.group.add(flat);
      }
    }
  }

  /** Show arms: a list of {parts, colour}; colour null keeps the material's own. */
  show(arms) {
    const most = arms.reduce((sum, { parts }) => sum + Math.max(parts.rods.length, parts.balls.length, parts.drums.length + 3), 0);
    this.#grow(most);
    for (const mesh of Object.values(this.meshes)) mesh.count = 0;
    for (const { parts, colour } of arms) this.#add(parts, colour);
    for (const mesh of Object.values(this.meshes)) {
      mesh.instanceMatrix.needsUpdate = true;
      if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
      mesh.visible = mesh.count > 0;
      if (mesh.userData.flat) { mesh.userData.flat.count = mesh.count; mesh.userData.flat.visible = mesh.visible; }
    }
  }

  #put(kind, matrix, colour) {
    const mesh = this.meshes[kind];
    mesh.setMatrixAt(mesh.count, matrix);
    if (colour) mesh.setColorAt(mesh.count, colour);
    mesh.count += 1;
  }

  #add(parts, colour) {
    for (const { a, b, r } of parts.rods) {
      const v = sub(b, a), len = norm(v), dir = v.map((x) => x / len);
      this.#put('rod', stand([(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2], dir, r, len), colour);
    }
    for (const { at, r } of parts.balls) this.#put('ball', m.makeScale(r, r, r).setPosition(...at), colour);
    for (const { at, dir, r, h } of parts.drums) {
      this.#put('drum', stand(at, dir, r, h), colour);
      this.#put('band', stand(at, dir, r * 1.012, h * 0.13), colour);
    }
    for (const { at, dir, x, r, h } of parts.sleeves) this.#put('box', stand(at, dir, r, h, x), colour);
    if (parts.pedestal) { const { at, dir, r, h } = parts.pedestal; this.#put('plate', stand([at[0] + dir[0] * h / 2, at[1] + dir[1] * h / 2, at[2] + dir[2] * h / 2], dir, r, h), colour); }
    if (parts.flange) { const { at, dir, r, h } = parts.flange; this.#put('plate', stand(at, dir, r, h), colour); }
    if (parts.tip) this.#put('tip', m.makeScale(parts.tip.r, parts.tip.r, parts.tip.r).setPosition(...parts.tip.at), colour);
  }
}
