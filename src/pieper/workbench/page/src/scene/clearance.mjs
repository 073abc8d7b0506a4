// How near the arm is to touching itself or what stands around it: two points, the line between them, the distance, live.
import * as THREE from 'three';
import { state, on, tell } from '../store.mjs';
import { colours } from '../theme.mjs';
import { mul } from '../matrix.mjs';
import { newestOnly } from '../link.mjs';
import { askArm, moot } from '../library.mjs';
import { awaiting } from '../late.mjs';
import { bodyMesh } from './world.mjs';
import { scene, invalidate } from './view.mjs';

const line = new THREE.Line(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ depthTest: false, fog: false }));
const ends = new THREE.Points(
  new THREE.BufferGeometry(),
  new THREE.PointsMaterial({ size: 9, sizeAttenuation: false, depthTest: false, fog: false }),
);
line.renderOrder = ends.renderOrder = 6;
line.frustumCulled = ends.frustumCulled = false;
line.visible = ends.visible = false;
const shells = new THREE.Group();
let shown = null, // the bodies that are drawn, or null
  about = '';
export const wanted = () => state.watch || state.world.some((t) => t.role === 'obstacle' && t.kind !== 'frame');

/** The distance of an earlier posture is not shown beside the present one for long. */
const wait = awaiting((late) => late && show({ waiting: true }));
function show(found) {
  state.clearance = found;
  draw();
  tell('clearance');
}
const ask = newestOnly(async () => {
  const { q, world } = state,
    present = () => q === state.q && world === state.world;
  let found;
  try {
    found = await askArm('clearance', { q, world });
  } catch (error) {
    if (moot(error)) return;
    found = { refused: error.message };
  }
  // while the arm moves a distance of just now will do, one of long ago will not
  if (!wanted() || (!present() && wait.late())) return;
  wait(!present());
  show(found);
});
function look() {
  if (wanted() && state.table.joints.length) {
    wait(true);
    ask();
  } else {
    wait(false);
    if (state.clearance) show(null);
  }
}
function draw() {
  const c = state.clearance,
    yes = Boolean(c?.points?.length);
  line.visible = ends.visible = yes;
  if (yes) {
    const points = c.points.map((p) => new THREE.Vector3(...p));
    for (const o of [line, ends]) {
      o.geometry.setFromPoints(points);
      o.material.color.set(c.metres > 0 ? colours.trace : colours.wrong);
    }
  }
  invalidate();
}

/** The bodies that distances are measured of, over the arm; false takes them away. */
export async function showBodies(yes) {
  shown = null;
  if (yes) {
    const { bodies, explain } = await askArm('bodies', {});
    shown = bodies;
    about = explain;
  }
  for (const m of shells.children) m.geometry.dispose();
  shells.clear();
  for (const b of shown ?? []) {
    const made = bodyMesh(b, colours.trace, 0.34);
    if (!made) continue;
    made.mesh.userData = { on: b.on, T: made.T };
    shells.add(made.mesh);
  }
  place();
  return about;
}
export const bodiesShown = () => shells.children.length;
const m4 = new THREE.Matrix4();
function place() {
  for (const mesh of shells.children) {
    const { on: k, T } = mesh.userData;
    if (state.frames[k]) mesh.matrix.copy(m4.set(...mul(state.frames[k], T)));
  }
  invalidate();
}

export function begin() {
  scene.add(line, ends, shells);
  on(['q', 'world', 'watch'], look);
  on('plan', look);
  on('q', () => shown && place());
  on('table', () => shown && showBodies(false).then(() => tell('bodies-gone')));
  on('theme', draw);
}
