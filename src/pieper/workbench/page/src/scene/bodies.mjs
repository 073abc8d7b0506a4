// Many arms in a handful of draw calls: every rod, ball, drum and sleeve of all of them is an instance of one mesh.
import * as THREE from 'three';
import { cross, norm, sub } from '../matrix.mjs';

/** Meshes of one unit, along z: fine for the arm, coarse for its ghosts and its shadow. */
function parts(round, rings) {
  const bevel = 0.1,
    turn = (g) => g.rotateX(Math.PI / 2);
  const profile = [
    [0, -0.5],
    [1 - bevel, -0.5],
    [1, -0.5 + bevel / 2],
    [1, 0.5 - bevel / 2],
    [1 - bevel, 0.5],
    [0, 0.5],
  ];
  return {
    rod: turn(new THREE.CylinderGeometry(1, 1, 1, round, 1, true)),
    ball: new THREE.SphereGeometry(1, round, rings),
    drum: turn(
      rings > 8
        ? new THREE.LatheGeometry(
            profile.map(([r, y]) => new THREE.Vector2(r, y)),
            round,
          )
        : new THREE.CylinderGeometry(1, 1, 1, round),
    ),
    band: turn(new THREE.CylinderGeometry(1, 1, 1, round, 1, true)),
    box: new THREE.BoxGeometry(2, 2, 1),
  };
}
const fine = parts(26, 12),
  coarse = parts(11, 5);

const m = new THREE.Matrix4();
/** Unit mesh along z to a place: radius r, height h, centred at `at`, z along dir. */
function stand(at, dir, r, h, x = null) {
  let ux =
    x && Math.abs(dir[0] * x[0] + dir[1] * x[1] + dir[2] * x[2]) < 0.5
      ? x
      : cross(dir, Math.abs(dir[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0]);
  let uy = cross(dir, ux),
    k = norm(uy) || 1;
  uy = uy.map((v) => v / k);
  ux = cross(uy, dir);
  return m.set(
    ux[0] * r,
    uy[0] * r,
    dir[0] * h,
    at[0],
    ux[1] * r,
    uy[1] * r,
    dir[1] * h,
    at[1],
    ux[2] * r,
    uy[2] * r,
    dir[2] * h,
    at[2],
    0,
    0,
    0,
    1,
  );
}

export class Bodies {
  /**
   * @param materials {link, joint, accent}
   * @param options.shadow {material, matrix} of the flattened copy, or null
   * @param options.veil true for ghosts: coarse meshes, without bands and plates
   */
  constructor(materials, { shadow = null, veil = false } = {}) {
    this.group = new THREE.Group();
    this.materials = materials;
    this.shadow = shadow;
    this.veil = veil;
    this.capacity = 0;
    this.meshes = {};
  }

  #grow(capacity) {
    if (capacity <= this.capacity) return;
    this.capacity = Math.max(64, 2 ** Math.ceil(Math.log2(capacity)));
    this.group.clear();
    const kinds = {
      rod: ['rod', 'link'],
      ball: ['ball', 'link'],
      drum: ['drum', 'joint'],
      band: ['band', 'accent'],
      box: ['box', 'joint'],
      tip: ['ball', 'accent'],
      plate: ['drum', 'joint'],
    };
    for (const [kind, [geometry, material]] of Object.entries(kinds)) {
      this.meshes[kind]?.dispose();
      const mesh = new THREE.InstancedMesh(
        (this.veil ? coarse : fine)[geometry],
        this.materials[material],
        this.capacity,
      );
      mesh.frustumCulled = false;
      mesh.count = 0;
      this.meshes[kind] = mesh;
      this.group.add(mesh);
      if (this.shadow && kind !== 'band' && kind !== 'tip') {
        const flat = new THREE.InstancedMesh(coarse[geometry], this.shadow.material, this.capacity);
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

  /** Show arms: a list of what `shape` returns. */
  show(arms) {
    const most = arms.reduce(
      (sum, parts) => sum + Math.max(parts.rods.length, parts.balls.length, parts.drums.length + 3),
      0,
    );
    this.#grow(most);
    for (const mesh of Object.values(this.meshes)) mesh.count = 0;
    for (const parts of arms) this.#add(parts);
    for (const mesh of Object.values(this.meshes)) {
      mesh.instanceMatrix.needsUpdate = true;
      mesh.visible = mesh.count > 0;
      if (mesh.userData.flat) {
        mesh.userData.flat.count = mesh.count;
        mesh.userData.flat.visible = mesh.visible;
      }
    }
  }

  #put(kind, matrix) {
    const mesh = this.meshes[kind];
    mesh.setMatrixAt(mesh.count, matrix);
    mesh.count += 1;
  }

  #add(parts) {
    // A ghost is a little thinner than the arm: where both stand in one place, the arm is seen and not a pattern of the two.
    const k = this.veil ? 0.95 : 1;
    for (const { a, b, r } of parts.rods) {
      const v = sub(b, a),
        len = norm(v),
        dir = v.map((x) => x / len);
      this.#put('rod', stand([(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2], dir, k * r, len));
    }
    for (const { at, r } of parts.balls) this.#put('ball', m.makeScale(k * r, k * r, k * r).setPosition(...at));
    for (const { at, dir, r, h } of parts.drums) {
      this.#put('drum', stand(at, dir, k * r, k * h));
      if (!this.veil) this.#put('band', stand(at, dir, r * 1.012, h * 0.13));
    }
    for (const { at, dir, x, r, h } of parts.sleeves) this.#put('box', stand(at, dir, k * r, k * h, x));
    if (parts.pedestal && !this.veil) {
      const { at, dir, r, h } = parts.pedestal;
      this.#put(
        'plate',
        stand([at[0] + (dir[0] * h) / 2, at[1] + (dir[1] * h) / 2, at[2] + (dir[2] * h) / 2], dir, r, h),
      );
    }
    if (parts.flange) {
      const { at, dir, r, h } = parts.flange;
      this.#put('plate', stand(at, dir, r, h));
    }
    if (parts.tip && !this.veil)
      this.#put('tip', m.makeScale(parts.tip.r, parts.tip.r, parts.tip.r).setPosition(...parts.tip.at));
  }
}
