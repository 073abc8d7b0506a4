// How fast the tool's point can go, or how hard it can push, in every direction: an ellipsoid at the tool.
import * as THREE from 'three';
import { state, on, tell } from '../store.mjs';
import { jacobian, reach } from '../kinematics.mjs';
import { position } from '../matrix.mjs';
import { colours } from '../theme.mjs';
import { scene, invalidate } from './view.mjs';

/** The longest axis drawn, as a part of the arm; a force has no longest one, so that it is drawn against its shortest. */
const SHARE = 0.14;
const mesh = new THREE.Mesh(
  new THREE.SphereGeometry(1, 32, 20),
  new THREE.MeshBasicMaterial({ transparent: true, opacity: 0.3, depthWrite: false, fog: false }),
);
mesh.matrixAutoUpdate = false;
mesh.visible = false;
mesh.renderOrder = 4;
let kind = 'none';

/**
 * Axes of J J^T for the tool's point: unit vectors and half lengths, m/s for joint rates of norm one (Yoshikawa, 1985), by
 * Jacobi's rotations of the 3 x 3 matrix.
 */
export function velocityAxes(table, q, F) {
  const J = jacobian(table, q, F).slice(0, 3);
  const A = J.map((u) => J.map((v) => u.reduce((sum, x, k) => sum + x * v[k], 0))),
    V = [
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ];
  for (let sweep = 0; sweep < 20; sweep++)
    for (const [p, r] of [
      [0, 1],
      [0, 2],
      [1, 2],
    ]) {
      if (Math.abs(A[p][r]) < 1e-300) continue;
      const half = (A[r][r] - A[p][p]) / (2 * A[p][r]);
      const t = Math.sign(half || 1) / (Math.abs(half) + Math.sqrt(half * half + 1));
      const c = 1 / Math.sqrt(t * t + 1),
        s = t * c;
      for (let k = 0; k < 3; k++) [A[k][p], A[k][r]] = [c * A[k][p] - s * A[k][r], s * A[k][p] + c * A[k][r]];
      for (let k = 0; k < 3; k++) [A[p][k], A[r][k]] = [c * A[p][k] - s * A[r][k], s * A[p][k] + c * A[r][k]];
      for (let k = 0; k < 3; k++) [V[k][p], V[k][r]] = [c * V[k][p] - s * V[k][r], s * V[k][p] + c * V[k][r]];
    }
  return [0, 1, 2]
    .map((i) => ({ axis: V.map((row) => row[i]), length: Math.sqrt(Math.max(A[i][i], 0)) }))
    .sort((a, b) => b.length - a.length);
}

export function showEllipsoid(what) {
  kind = what;
  draw();
}
export const ellipsoidShown = () => state.ellipsoid ?? null;
function draw() {
  const yes = kind !== 'none' && state.table.joints.length > 0;
  mesh.visible = yes;
  state.ellipsoid = null;
  if (yes) {
    const axes = velocityAxes(state.table, state.q, state.frames),
      size = SHARE * reach(state.table);
    const most = axes[0].length || 1,
      thin = 0.004;
    // of forces the directions change places: where the point cannot go, it can bear any load
    const drawn = axes.map(({ axis, length }) => ({
      axis,
      half:
        size *
        Math.max(kind === 'velocity' ? length / most : Math.min(axes[2].length / Math.max(length, 1e-12), 1), thin),
    }));
    const at = position(state.frames.at(-1)),
      [a, b] = drawn,
      c = { ...drawn[2] };
    mesh.matrix.set(
      ...[0, 1, 2].flatMap((i) => [a.half * a.axis[i], b.half * b.axis[i], c.half * c.axis[i], at[i]]),
      0,
      0,
      0,
      1,
    );
    mesh.material.color.set(kind === 'velocity' ? colours.trace : colours.accent);
    mesh.material.side = THREE.DoubleSide;
    state.ellipsoid = axes;
  }
  invalidate();
  tell('ellipsoid');
}

export function begin() {
  scene.add(mesh);
  on(['q', 'theme'], () => kind !== 'none' && draw());
}
