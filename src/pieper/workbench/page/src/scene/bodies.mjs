// Many arms in one draw call: every rod, ball, drum and sleeve of all of them is written into one mesh.
// Instances would be less to write, but a software renderer draws each of them like a mesh of its own.
import * as THREE from 'three';
import { cross, norm, sub } from '../matrix.mjs';

/** Corners, normals and triangles of one unit, along z. */
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
  const drum =
    rings > 8
      ? new THREE.LatheGeometry(
          profile.map(([r, y]) => new THREE.Vector2(r, y)),
          round,
        )
      : new THREE.CylinderGeometry(1, 1, 1, round);
  const bare = {
    rod: turn(new THREE.CylinderGeometry(1, 1, 1, round, 1, true)),
    ball: rings > 3 ? new THREE.SphereGeometry(1, round, rings) : new THREE.OctahedronGeometry(1, 0),
    drum: turn(drum),
    box: new THREE.BoxGeometry(2, 2, 1),
  };
  return Object.fromEntries(
    Object.entries(bare).map(([name, g]) => {
      const at = g.attributes.position;
      const index = g.index ? g.index.array : Uint16Array.from({ length: at.count }, (_, i) => i);
      return [name, { at: at.array, normal: g.attributes.normal.array, index, count: at.count }];
    }),
  );
}
/**
 * Where the processor draws, triangles are what a picture costs: while things move the arm has a fifth of them, and its ghosts
 * and its shadow have as few as still tell a rod from a drum.
 */
const made = new Map();
const unitParts = (round, rings) => made.get(round) ?? made.set(round, parts(round, rings)).get(round);
const fine = () => unitParts(26, 12),
  middling = () => unitParts(11, 5),
  coarse = () => unitParts(6, 3);

/** One growing mesh; `paint` numbers the colours of its material. */
class Heap {
  constructor(material) {
    this.mesh = new THREE.Mesh(new THREE.BufferGeometry(), material);
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
    this.#room(1024, 4096);
    this.clear();
  }

  /** Make room for so many corners and triangle indices; what is there already stays. */
  #room(corners, indices) {
    const old = this.mesh.geometry.attributes,
      g = new THREE.BufferGeometry();
    const grown = (name, size) => {
      const array = new Float32Array(size * corners);
      if (old[name]) array.set(old[name].array);
      const attribute = new THREE.BufferAttribute(array, size).setUsage(THREE.DynamicDrawUsage);
      g.setAttribute(name, attribute);
      return array;
    };
    this.at = grown('position', 3);
    this.normal = grown('normal', 3);
    this.paint = grown('paint', 1);
    const index = new Uint32Array(indices);
    if (this.index) index.set(this.index);
    this.index = index;
    g.setIndex(new THREE.BufferAttribute(index, 1).setUsage(THREE.DynamicDrawUsage));
    this.mesh.geometry.dispose();
    this.mesh.geometry = g;
  }

  clear() {
    this.corners = 0;
    this.indices = 0;
  }

  /** A part at a place: x and y of the unit times r (at its far end `far`) along ux and uy, z times h along uz. */
  put(part, paint, at, ux, uy, uz, r, h, far = r) {
    const first = this.corners,
      end = first + part.count;
    if (3 * end > this.at.length || this.indices + part.index.length > this.index.length)
      this.#room(
        2 * Math.max(end, this.at.length / 3),
        2 * Math.max(this.indices + part.index.length, this.index.length),
      );
    for (let v = 0, o = 3 * first; v < 3 * part.count; v += 3, o += 3) {
      const wide = part.at[v + 2] > 0 ? far : r,
        x = wide * part.at[v],
        y = wide * part.at[v + 1],
        z = h * part.at[v + 2];
      // normals go with the inverse scale; the shader brings them to length one
      const nx = part.normal[v] / r,
        ny = part.normal[v + 1] / r,
        nz = part.normal[v + 2] / h;
      for (let k = 0; k < 3; k++) {
        this.at[o + k] = at[k] + ux[k] * x + uy[k] * y + uz[k] * z;
        this.normal[o + k] = ux[k] * nx + uy[k] * ny + uz[k] * nz;
      }
    }
    this.paint.fill(paint, first, end);
    for (let i = 0; i < part.index.length; i++) this.index[this.indices + i] = first + part.index[i];
    this.corners = end;
    this.indices += part.index.length;
  }

  /** Hand over what was put since the last clear. */
  done() {
    const g = this.mesh.geometry;
    for (const [attribute, used] of [
      [g.attributes.position, 3 * this.corners],
      [g.attributes.normal, 3 * this.corners],
      [g.attributes.paint, this.corners],
      [g.index, this.indices],
    ]) {
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(0, used);
      attribute.needsUpdate = true;
    }
    g.setDrawRange(0, this.indices);
    this.mesh.visible = this.indices > 0;
  }
}

const X = [1, 0, 0],
  Y = [0, 1, 0],
  Z = [0, 0, 1];
/** Two unit vectors across a direction, the first as near to `x` as can be. */
function across(dir, x = null) {
  const ux =
    x && Math.abs(dir[0] * x[0] + dir[1] * x[1] + dir[2] * x[2]) < 0.5 ? x : cross(dir, Math.abs(dir[2]) < 0.9 ? Z : X);
  const v = cross(dir, ux),
    k = norm(v) || 1,
    uy = v.map((c) => c / k);
  return [cross(uy, dir), uy];
}

/** Numbers of the colours in `matte`. */
const LINK = 0,
  JOINT = 1,
  ACCENT = 2,
  BEYOND = 3;

export class Bodies {
  /**
   * @param material a `matte`
   * @param options.shadow {material, matrix} of the flattened copy, or null
   * @param options.veil true for ghosts: fewer triangles, without bands and plates
   * @param options.rim a `rim` that outlines them, as broad as each arm says
   */
  constructor(material, { shadow = null, veil = false, rim = null } = {}) {
    this.group = new THREE.Group();
    this.veil = veil;
    this.moving = false;
    this.seen = this.shadowSeen = true;
    this.arms = [];
    this.body = new Heap(material);
    this.group.add(this.body.mesh);
    if (rim) {
      this.rim = new Heap(rim);
      this.rim.mesh.renderOrder = 1;
      this.group.add(this.rim.mesh);
    }
    if (shadow) {
      this.flat = new Heap(shadow.material);
      this.flat.mesh.matrixAutoUpdate = false;
      this.flat.mesh.matrix.copy(shadow.matrix);
      this.flat.mesh.renderOrder = -1;
      this.group.add(this.flat.mesh);
    }
  }

  /** Whether the arms, and their shadow, are seen. */
  shown(yes, shadow) {
    if (yes === this.seen && shadow === this.shadowSeen) return;
    this.seen = yes;
    this.shadowSeen = shadow;
    this.show(this.arms);
  }

  /** Draw with few triangles while things move, with many when they rest. */
  hurry(yes) {
    this.moving = yes;
    this.show(this.arms);
  }

  /** Show arms: a list of what `shape` returns. */
  show(arms) {
    this.arms = arms;
    this.body.clear();
    const unit = this.veil ? (this.moving ? coarse : middling) : this.moving ? middling : fine;
    for (const arm of this.seen ? arms : []) this.#write(this.body, arm, unit());
    this.body.done();
    if (this.rim) {
      this.rim.clear();
      // an outline costs as much as the body: where the processor draws, it waits until things rest
      for (const arm of this.seen && !this.moving ? arms : []) this.#write(this.rim, arm, unit(), { rim: true });
      this.rim.done();
    }
    if (!this.flat) return;
    this.flat.clear();
    for (const arm of this.shadowSeen ? arms : [])
      this.#write(this.flat, arm, this.moving ? coarse() : middling(), { flat: true });
    this.flat.done();
  }

  #write(heap, arm, unit, { flat = false, rim = false } = {}) {
    // A ghost is a little thinner than the arm: where both stand in one place, the arm is seen and not a pattern of the two.
    const inset = this.rim && !this.moving && !rim ? arm.rim : 0,
      whole = !this.veil && !flat,
      fit = (r) => (this.veil ? Math.max(0.96 * r - inset, 0.3 * r) : r),
      tall = (h) => 2 * fit(h / 2),
      of = (paint) => (this.veil ? (arm.outside ? BEYOND : LINK) : paint);
    const stand = (part, paint, at, dir, r, h, x, far) =>
      heap.put(part, of(paint), at, ...across(dir, x), dir, r, h, far);
    const ball = (paint, at, r) => heap.put(unit.ball, of(paint), at, X, Y, Z, r, r);
    for (const { a, b, r, far } of arm.rods) {
      const v = sub(b, a),
        len = norm(v);
      const middle = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2];
      stand(
        unit.rod,
        LINK,
        middle,
        v.map((c) => c / len),
        fit(r),
        len,
        null,
        fit(far ?? r),
      );
    }
    for (const { at, r } of arm.balls) ball(LINK, at, fit(r));
    for (const { at, dir, turned, r, h, beyond } of arm.drums) {
      stand(unit.drum, beyond && whole ? BEYOND : JOINT, at, dir, fit(r), tall(h));
      if (!whole) continue;
      stand(unit.rod, ACCENT, at, dir, r * 1.012, h * 0.13);
      // an index on the moving part, so that a joint that turns in place is seen to turn
      const rim = [0, 1, 2].map((c) => at[c] + turned[c] * r * 0.96);
      stand(unit.box, LINK, rim, dir, r * 0.11, h * 0.86, turned);
    }
    for (const { at, dir, x, r, h, beyond } of arm.sleeves)
      stand(unit.box, beyond && whole ? BEYOND : JOINT, at, dir, fit(r), tall(h), x);
    if (arm.pedestal && !this.veil) {
      const { at, dir, r, h } = arm.pedestal;
      stand(
        unit.drum,
        JOINT,
        [at[0] + (dir[0] * h) / 2, at[1] + (dir[1] * h) / 2, at[2] + (dir[2] * h) / 2],
        dir,
        r,
        h,
      );
    }
    if (arm.flange) stand(unit.drum, JOINT, arm.flange.at, arm.flange.dir, fit(arm.flange.r), tall(arm.flange.h));
    if (arm.flange && whole) {
      const { at, dir, turned, r, h } = arm.flange;
      stand(
        unit.box,
        ACCENT,
        [0, 1, 2].map((c) => at[c] + turned[c] * r * 0.95),
        dir,
        r * 0.16,
        h * 1.04,
        turned,
      );
    }
    if (arm.tip && whole) ball(ACCENT, arm.tip.at, arm.tip.r);
  }
}
