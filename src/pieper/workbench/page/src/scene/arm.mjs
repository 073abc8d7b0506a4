// The arm, its ghosts, its frames, the trace of its tool: what of the state is seen in space.
import * as THREE from 'three';
import { state, on } from '../store.mjs';
import { colours } from '../theme.mjs';
import { frames as forward } from '../kinematics.mjs';
import { position, norm, sub } from '../matrix.mjs';
import { scene, invalidate, wake, layGround, fit, remember, keepInView, returnFromWide } from './view.mjs';
import { debounce } from '../dom.mjs';
import { ARROW, proportions, shape, outline, outsideOf } from './shape.mjs';
import { Bodies } from './bodies.mjs';
import { matte, rim } from './matte.mjs';
import { Frames } from './frames.mjs';
import { framesOfStep } from '../panels/dh_steps.mjs';
import { isShown as handlesShown } from './gizmo.mjs';

const material = matte();

/** The arm's shadow: the same parts, flattened onto the ground along the light; each pixel is darkened once. */
const light = [0.32, -0.4, 1];
export const shadowMaterial = new THREE.MeshBasicMaterial({
  color: '#000',
  transparent: true,
  opacity: 0.1,
  side: THREE.DoubleSide,
  depthWrite: false,
  fog: false,
  stencilWrite: true,
  stencilFunc: THREE.NotEqualStencilFunc,
  stencilRef: 1,
  stencilZPass: THREE.ReplaceStencilOp,
  polygonOffset: true,
  polygonOffsetFactor: -1,
  polygonOffsetUnits: -1,
});
export const shadowMatrix = new THREE.Matrix4().set(
  1,
  0,
  -light[0],
  0,
  0,
  1,
  -light[1],
  0,
  0,
  0,
  0,
  0.0005,
  0,
  0,
  0,
  1,
);
/** Where the arm stands, the ground is darker: a soft disc, so that it does not seem to float. */
const contact = new THREE.Mesh(
  new THREE.CircleGeometry(1, 40),
  new THREE.ShaderMaterial({
    transparent: true,
    depthWrite: false,
    polygonOffset: true,
    polygonOffsetFactor: -1,
    polygonOffsetUnits: -1,
    uniforms: { strength: { value: 0.3 } },
    vertexShader:
      'varying vec2 at; void main() { at = position.xy; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }',
    fragmentShader:
      'uniform float strength; varying vec2 at; void main() { float d = 1.0 - length(at); gl_FragColor = vec4(0.0, 0.0, 0.0, strength * d * d); }',
  }),
);
contact.renderOrder = -1;
function standing() {
  const base = state.frames[0],
    r = 2 * (form.radius[0] ?? 0);
  contact.visible = state.table.joints.length > 0 && Math.abs(base[11]) < 0.02 * form.size && base[10] > 0.99;
  contact.position.set(base[3], base[7], 0.0004 * form.size);
  contact.scale.set(1.6 * r, 1.6 * r, 1);
}
const main = new Bodies(material, { shadow: { material: shadowMaterial, matrix: shadowMatrix } });

/** Show or hide what is drawn from the table; its shadow goes where the arm's looks throw their own. */
export function showSketch(yes, shadowless) {
  main.shown(yes, yes && !shadowless);
}
/** How much of what is behind it a ghost covers inside its outline; without one, twice as much. */
const FILL = 0.1;
const ghostMaterial = matte({ opacity: FILL, veil: true });
const ghostRim = rim();
const ghosts = new Bodies(ghostMaterial, { veil: true, rim: ghostRim });
const previewMaterial = matte({ opacity: 0.62, gloss: 0.1 });
const preview = new Bodies(previewMaterial, { veil: true });
const axes = new Frames();

let form = proportions(state.table);
let ghostRows = [],
  previewRow = null;

export function begin() {
  scene.add(contact, main.group, ghosts.group, preview.group, axes.group);
  ghosts.group.renderOrder = 1;
  on('table', (what) => {
    form = proportions(state.table);
    layGround(form.size);
    ghostRows = [];
    previewRow = null;
    drawGhosts();
    clearTrace();
    if (what === 'new') fitArm({ instant: true, view: 'iso' });
    wake();
  });
  on('q', drawArm);
  on('frames', drawFrames);
  on('theme', paint);
  on('hurry', (yes) => {
    ghostMaterial.uniforms.opacity.value = yes ? 2 * FILL : FILL;
    for (const bodies of [main, ghosts, preview]) bodies.hurry(yes);
  });
  paint();
}

const beside = new Map();
let alsoShown = [],
  alsoCount = 0;
/** What else belongs in the picture: the ends of a path, the corners of a cloud, a target. */
export function showBeside(what, points) {
  beside.set(what, points);
  alsoShown = [...beside.values()].flat();
  if (!state.table.joints.length) return;
  const before = alsoCount;
  alsoCount = alsoShown.length;
  remember(room());
  if (points.length) stayInView();
  else if (before > alsoCount) comeBack();
}
/** Points of the shapes that the links wear, where the frames F put them; they reach beyond what the table draws. */
let worn = () => [],
  wornCount = 0;
/** The links wear other shapes from now on: a picture of the arm holds these too. */
export function wear(points) {
  const before = wornCount;
  worn = points;
  wornCount = worn(state.frames).length;
  if (!state.table.joints.length) return;
  remember(room());
  if (wornCount < before) comeBack();
  else if (wornCount) stayInView();
}
/** What a picture must hold: the arm, what its links wear, and what stands beside it. */
const room = () => [...outline(state.table, state.frames), ...worn(state.frames), ...alsoShown];
/** What made the picture wider is gone: as near as before, unless a hand has moved the camera meanwhile. */
const comeBack = debounce(returnFromWide, 120);
/** The room a whole motion takes, so that the picture holds still while it plays. */
export function showMotionRoom(table, list) {
  const step = Math.max(1, Math.floor(list.length / 24));
  const some = list.filter((_, k) => k % step === 0 || k === list.length - 1);
  showBeside(
    'motion',
    some.flatMap((q) => {
      const F = forward(table, q);
      return [...outline(table, F), ...(table === state.table ? worn(F) : [])];
    }),
  );
}
/** Bring the arm into the picture; what stands beside it (a path) stays in the picture from then on. */
export function fitArm(options) {
  fit(room(), options);
}
const stayInView = debounce(keepInView, 220);

function drawArm() {
  const F = state.frames;
  main.show(state.table.joints.length ? [shape(state.table, F, form, state.q)] : []);
  standing();
  remember(room());
  stayInView();
  if (tracing) addTrace(position(F[F.length - 1]));
  drawFrames();
}
function drawFrames() {
  const chosen = (state.shownFrames ?? [])
    // the target's handles stand where the tool's own arrows would
    .filter((i) => i < state.frames.length && !(i === state.frames.length - 1 && handlesShown()))
    .map((i) => ({ T: state.frames[i], name: frameName(i) }));
  axes.show(state.dhStep === null ? chosen : framesOfStep(), form.size * ARROW);
  invalidate();
}
/** Numbers of the joints that are drawn red now. */
export const beyondDrawn = () =>
  main.arms.flatMap((a) => [...a.drums, ...a.sleeves].filter((d) => d.beyond).map((d) => d.joint + 1));
/** Names of the frames that are drawn now. */
export const framesDrawn = () => (axes.last?.[0] ?? []).map((f) => f.name);
export function frameName(i) {
  const n = state.table.joints.length;
  return i === 0 ? 'base' : i === n + 1 ? 'tool' : String(i);
}

/** Ghost arms at joint vectors, outlined, red where one lies outside its limits; the one under the hand is drawn more strongly. */
export function showGhosts(rows) {
  ghostRows = rows;
  drawGhosts();
}
export function showPreview(q) {
  previewRow = q;
  drawGhosts();
}
export const ghostCount = () => ghostRows.length;
/** How many ghosts are outlined in red. */
export const ghostsOutside = () => ghosts.arms.filter((a) => a.outside).length;
/** Breadth of a ghost's outline as a share of the arm. */
const RIM = 0.0035;
function drawGhosts() {
  const partsOf = (q) => ({
    ...shape(state.table, forward(state.table, q), form),
    outside: state.table.joints.some((j, i) => outsideOf(j, q[i])),
    rim: RIM * form.size,
  });
  ghosts.show(ghostRows.map(partsOf));
  preview.show(previewRow ? [partsOf(previewRow)] : []);
  invalidate();
}

// ---- trace of the tool: pairs of points, so that a jump (a typed value) leaves no line that the tool never drew
const MOST = 6000;
const traceAt = new Float32Array(6 * MOST);
const traceLine = new THREE.LineSegments(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ fog: false }));
traceLine.geometry.setAttribute('position', new THREE.BufferAttribute(traceAt, 3));
traceLine.frustumCulled = false;
traceLine.visible = false;
let traceCount = 0,
  tracing = true,
  lastPoint = null;
scene.add(traceLine);
function addTrace(p) {
  const step = lastPoint ? norm(sub(p, lastPoint)) : Infinity;
  if (step < form.size * 0.002) return;
  if (step < form.size * 0.2) {
    if (traceCount === MOST) {
      traceAt.copyWithin(0, 6 * 1000);
      traceCount -= 1000;
    }
    traceAt.set(lastPoint, 6 * traceCount);
    traceAt.set(p, 6 * traceCount + 3);
    traceCount += 1;
    traceLine.geometry.setDrawRange(0, 2 * traceCount);
    traceLine.geometry.attributes.position.needsUpdate = true;
    traceLine.visible = true;
  }
  lastPoint = p;
}
export function setTracing(yes) {
  tracing = yes;
  if (!yes) clearTrace();
  invalidate();
}
export function clearTrace() {
  traceCount = 0;
  lastPoint = null;
  traceLine.visible = false;
  invalidate();
}
export const traceLength = () => traceCount;

// ---- the planned path
const pathLine = new THREE.Line(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ fog: false }));
pathLine.frustumCulled = false;
const pathDots = new THREE.Points(
  new THREE.BufferGeometry(),
  new THREE.PointsMaterial({ size: 4, sizeAttenuation: false, fog: false }),
);
pathDots.frustumCulled = false;
pathLine.visible = pathDots.visible = false;
scene.add(pathLine, pathDots);
export function showPath(points) {
  showBeside('path', points);
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
  material.repaint(colours.link, colours.joint, colours.accent, colours.dark, colours.wrong);
  ghostMaterial.repaint(colours.ghost, colours.ghost, colours.ghost, colours.dark, colours.wrong);
  ghostRim.repaint(colours.ghost, colours.wrong);
  previewMaterial.repaint(colours.accent, colours.accent, colours.accent, colours.dark);
  traceLine.material.color.set(colours.accent);
  pathLine.material.color.set(colours.trace);
  pathDots.material.color.set(colours.trace);
  shadowMaterial.opacity = colours.dark ? 0.28 : 0.11;
  contact.material.uniforms.strength.value = colours.dark ? 0.75 : 0.34;
  invalidate();
}
