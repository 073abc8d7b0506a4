// The arm, its ghosts, its frames, the trace of its tool: what of the state is seen in space.
import * as THREE from 'three';
import { state, on } from '../store.mjs';
import { colours } from '../theme.mjs';
import { frames as forward } from '../kinematics.mjs';
import { position } from '../matrix.mjs';
import { scene, invalidate, layGround, fit, remember } from './view.mjs';
import { proportions, shape, outline } from './shape.mjs';
import { Bodies } from './bodies.mjs';
import { Frames } from './frames.mjs';

const solid = () => new THREE.MeshStandardMaterial({ roughness: 0.52, metalness: 0.08, fog: false });
const materials = { link: solid(), joint: solid(), accent: solid() };

/** The arm's shadow: the same instances, flattened onto the ground along the light; each pixel is darkened once. */
const light = [0.32, -0.4, 1];
const shadowMaterial = new THREE.MeshBasicMaterial({ color: '#000', transparent: true, opacity: 0.1, side: THREE.DoubleSide, depthWrite: false, fog: false,
  stencilWrite: true, stencilFunc: THREE.NotEqualStencilFunc, stencilRef: 1, stencilZPass: THREE.ReplaceStencilOp, polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -1 });
const shadowMatrix = new THREE.Matrix4().set(1, 0, -light[0], 0, 0, 1, -light[1], 0, 0, 0, 0, 0.0005, 0, 0, 0, 1);
const main = new Bodies(materials, { shadow: { material: shadowMaterial, matrix: shadowMatrix } });

const veil = (opacity) => new THREE.MeshLambertMaterial({ transparent: true, opacity, fog: false });
const ghostMaterial = veil(0.2);
const ghosts = new Bodies({ link: ghostMaterial, joint: ghostMaterial, accent: ghostMaterial });
const previewMaterial = veil(0.62);
const preview = new Bodies({ link: previewMaterial, joint: previewMaterial, accent: previewMaterial });
const axes = new Frames();

let form = proportions(state.table);
let ghostRows = [], previewRow = null;

export function begin() {
  scene.add(main.group, ghosts.group, preview.group, axes.group);
  ghosts.group.renderOrder = 1;
  on('table', (what) => {
    form = proportions(state.table);
    layGround(form.size);
    ghostRows = []; previewRow = null;
    drawGhosts();
    clearTrace();
    if (what === 'new') fitArm({ instant: true, view: 'iso' });
  });
  on('q', drawArm);
  on('frames', drawFrames);
  on('theme', paint);
  paint();
}

/** Bring the arm into the picture, with further points if there are any (a path). */
export function fitArm({ also = [], ...options } = {}) { fit([...outline(state.table, state.frames), ...also], options); }

function drawArm() {
  const F = state.frames;
  main.show(state.table.joints.length ? [{ parts: shape(state.table, F, form), colour: null }] : []);
  remember(outline(state.table, F));
  if (tracing) addTrace(position(F[F.length - 1]));
  drawFrames();
}
function drawFrames() {
  axes.show((state.shownFrames ?? []).filter((i) => i < state.frames.length).map((i) => ({ T: state.frames[i], name: frameName(i) })), form.size * 0.13);
  invalidate();
}
export function frameName(i) {
  const n = state.table.joints.length;
  return i === 0 ? 'base' : i === n + 1 ? 'tool' : String(i);
}

/** Ghost arms at joint vectors; the one under the hand is drawn more strongly. */
export function showGhosts(rows) { ghostRows = rows; drawGhosts(); }
export function showPreview(q) { previewRow = q; drawGhosts(); }
export const ghostCount = () => ghostRows.length;
function drawGhosts() {
  const partsOf = (q) => shape(state.table, forward(state.table, q), form);
  ghosts.show(ghostRows.map((q) => ({ parts: partsOf(q), colour: null })));
  preview.show(previewRow ? [{ parts: partsOf(previewRow), colour: null }] : []);
  invalidate();
}

// ---- trace of the tool
const MOST = 6000;
const traceAt = new Float32Array(3 * MOST);
const traceLine = new THREE.Line(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ fog: false }));
traceLine.geometry.setAttribute('position', new THREE.BufferAttribute(traceAt, 3));
traceLine.frustumCulled = false;
let traceCount = 0, tracing = true;
scene.add(traceLine);
function addTrace(p) {
  if (traceCount) {
    const k = 3 * (traceCount - 1);
    if (Math.hypot(p[0] - traceAt[k], p[1] - traceAt[k + 1], p[2] - traceAt[k + 2]) < form.size * 0.002) return;
  }
  if (traceCount === MOST) { traceAt.copyWithin(0, 3 * 1000); traceCount -= 1000; }
  traceAt.set(p, 3 * traceCount++);
  traceLine.geometry.setDrawRange(0, traceCount);
  traceLine.geometry.attributes.position.needsUpdate = true;
}
export function setTracing(yes) { tracing = yes; traceLine.visible = yes; if (!yes) clearTrace(); invalidate(); }
export function clearTrace() { traceCount = 0; traceLine.geometry.setDrawRange(0, 0); invalidate(); }
export const traceLength = () => traceCount;

// ---- the planned path
const pathLine = new THREE.Line(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ fog: false }));
pathLine.frustumCulled = false;
const pathDots = new THREE.Points(new THREE.BufferGeometry(), new THREE.PointsMaterial({ size: 4, sizeAttenuation: false, fog: false }));
pathDots.frustumCulled = false;
scene.add(pathLine, pathDots);
export function showPath(points) {
  const at = new Float32Array(points.flat());
  for (const o of [pathLine, pathDots]) {
    o.geometry.dispose();
    o.geometry = new THREE.BufferGeometry();
    o.geometry.setAttribute('position', new THREE.BufferAttribute(at, 3));
    o.visible = points.length > 0;
  }
  invalidate();
}

function paint() {
  materials.link.color.set(colours.link);
  materials.joint.color.set(colours.joint);
  materials.accent.color.set(colours.accent);
  ghostMaterial.color.set(colours.ghost);
  previewMaterial.color.set(colours.accent);
  traceLine.material.color.set(colours.accent);
  pathLine.material.color.set(colours.trace);
  pathDots.material.color.set(colours.trace);
  shadowMaterial.opacity = colours.dark ? 0.28 : 0.11;
  axes.paint();
  invalidate();
}
