// The handles on the target: arrows to move it, rings to turn it, picked by what is nearest on the screen.
import * as THREE from 'three';
import { state, on, setTarget, tell } from '../store.mjs';
import { h, setText } from '../dom.mjs';
import { units, showUnit } from '../units.mjs';
import { fromQuaternion } from '../rotation.mjs';
import { mul, position, column } from '../matrix.mjs';
import { scene, camera, renderer, controls, invalidate, beforeEach, toScreen } from './view.mjs';
import { axisColours } from './frames.mjs';
import { colours } from '../theme.mjs';

/** Sizes as shares of the picture's height: length of an arrow, radius of a ring and of the outer one. */
const ARROW = 0.145,
  RING = 0.105,
  OUTER = 0.165;
/** How near on the screen a pointer must be, pixels; a finger is thicker than a mouse. */
const NEAR = { mouse: 13, pen: 16, touch: 28 };
/** Arrows that point at the eye and rings seen from the edge cannot be followed by a hand: shorter than this share. */
const SHORT = 0.2;
const AXES = ['x', 'y', 'z'];
const PIECES = 72;

const group = new THREE.Group();
const parts = new Map(); // name -> mesh
let mode = 'both',
  space = 'local',
  snap = 0,
  shown = false,
  hover = null,
  held = null;
export const isDragging = () => held !== null;
export const isShown = () => shown;

let readout = null,
  surface = null;

export function begin() {
  group.visible = false;
  scene.add(group);
  beforeEach(beforePicture);
  surface = document.getElementById('view');
  readout = h('output', { class: 'gizmo-readout', 'data-testid': 'gizmo-readout', hidden: true });
  document.getElementById('overlay').append(readout);
  // before the view's own controls hear of it, which turn the picture
  surface.addEventListener('pointerdown', down, true);
  surface.addEventListener('pointermove', move, true);
  for (const end of ['pointerup', 'pointercancel']) surface.addEventListener(end, up, true);
  addEventListener('keydown', (e) => e.key === 'Escape' && held && giveUp());
  on(['target', 'theme'], invalidate);
}

// ---- what is drawn
function solid(geometry, colour, order = 8) {
  const material = new THREE.MeshBasicMaterial({
    color: colour,
    depthTest: false,
    depthWrite: false,
    transparent: true,
    opacity: 0.95,
    fog: false,
  });
  const mesh = new THREE.Mesh(geometry, material);
  mesh.renderOrder = order;
  mesh.frustumCulled = false;
  mesh.userData.colour = colour;
  return mesh;
}
const ALONG = [
  new THREE.Quaternion().setFromUnitVectors(new THREE.Vector3(0, 1, 0), new THREE.Vector3(1, 0, 0)),
  new THREE.Quaternion(),
  new THREE.Quaternion().setFromUnitVectors(new THREE.Vector3(0, 1, 0), new THREE.Vector3(0, 0, 1)),
];
const ACROSS = [
  new THREE.Quaternion().setFromUnitVectors(new THREE.Vector3(0, 0, 1), new THREE.Vector3(1, 0, 0)),
  new THREE.Quaternion().setFromUnitVectors(new THREE.Vector3(0, 0, 1), new THREE.Vector3(0, 1, 0)),
  new THREE.Quaternion(),
];
/** Made when first shown: a first picture does without them. */
function make() {
  if (parts.size) return;
  const add = (name, mesh) => {
    parts.set(name, mesh);
    group.add(mesh);
  };
  AXES.forEach((a, i) => {
    const shaft = new THREE.CylinderGeometry(0.0032, 0.0032, ARROW * 0.8, 8).translate(0, ARROW * 0.45, 0);
    const head = new THREE.ConeGeometry(0.0125, 0.034, 14).translate(0, ARROW * 0.9, 0);
    const arrow = new THREE.Group();
    arrow.add(solid(shaft, axisColours[i]), solid(head, axisColours[i]));
    arrow.userData.turn = ALONG[i];
    add(`move-${a}`, arrow);
    const ring = solid(new THREE.TorusGeometry(RING, 0.0026, 6, PIECES), axisColours[i], 7);
    ring.userData.turn = ACROSS[i];
    add(`turn-${a}`, ring);
  });
  add('turn-view', solid(new THREE.TorusGeometry(OUTER, 0.0022, 6, PIECES), '#8891a0', 7));
  add('move-view', solid(new THREE.SphereGeometry(0.0115, 14, 10), '#8891a0', 9));
}

const place = new THREE.Vector3(),
  toEye = new THREE.Vector3(),
  turn = new THREE.Quaternion();
/** World length of the picture's height at the target. */
function heightThere() {
  return 2 * Math.tan(THREE.MathUtils.degToRad(camera.fov / 2)) * camera.position.distanceTo(place);
}
const axesOf = () => (space === 'world' ? [0, 1, 2].map((i) => [0, 1, 2].map((k) => Number(i === k))) : local());
const local = () => [0, 1, 2].map((i) => column(state.target, i));
const m4 = new THREE.Matrix4();

/** Put the handles where the target is, at one size on the screen; called before every picture. */
export function beforePicture() {
  group.visible = shown;
  if (!shown) return;
  place.set(...position(state.target));
  toEye.copy(camera.position).sub(place).normalize();
  if (space === 'world') turn.identity();
  else turn.setFromRotationMatrix(m4.set(...state.target));
  group.position.copy(place);
  group.scale.setScalar(heightThere());
  const axes = axesOf();
  for (const [name, mesh] of parts) {
    const [what, which] = name.split('-'),
      i = AXES.indexOf(which);
    const wanted = mode === 'both' || mode === what;
    mesh.visible = wanted && usable(what, axes[i]) && (!held || held.name === name);
    if (which === 'view') mesh.quaternion.copy(camera.quaternion);
    else mesh.quaternion.copy(turn).multiply(mesh.userData.turn);
    const lit = name === (held?.name ?? hover);
    mesh.traverse((o) => o.material?.color.set(lit ? colours.accent : o.userData.colour));
  }
}
/** Whether a hand on the screen can follow it from here. */
function usable(what, axis) {
  if (!axis || what !== 'move') return true;
  return Math.hypot(...crossed(axis, toEye.toArray())) > SHORT;
}
const crossed = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

// ---- picking, in the pixels of the screen
const along = (axis, k) => position(state.target).map((v, i) => v + k * axis[i]);
function ringPoints(i, radius) {
  const axes = axesOf();
  const [u, v] =
    i < 0 ? [column3(camera.matrixWorld, 0), column3(camera.matrixWorld, 1)] : [axes[(i + 1) % 3], axes[(i + 2) % 3]];
  return Array.from({ length: PIECES + 1 }, (_, k) => {
    const t = (2 * Math.PI * k) / PIECES;
    const out = u.map((c, m) => Math.cos(t) * c + Math.sin(t) * v[m]);
    return {
      p: along(out, radius),
      front: i < 0 || out.reduce((sum, c, m) => sum + c * toEye.getComponent(m), 0) > -0.15,
    };
  });
}
const column3 = (M, c) => [M.elements[4 * c], M.elements[4 * c + 1], M.elements[4 * c + 2]];
function toSegment(x, y, [ax, ay], [bx, by]) {
  const dx = bx - ax,
    dy = by - ay,
    d = dx * dx + dy * dy;
  const t = d > 0 ? Math.min(Math.max(((x - ax) * dx + (y - ay) * dy) / d, 0), 1) : 0;
  return Math.hypot(x - ax - t * dx, y - ay - t * dy);
}
/** Pixels from a point of the screen to every handle that is there, by name. */
function distances(x, y) {
  const size = heightThere(),
    out = [];
  for (const [name, mesh] of parts) {
    if (!mesh.visible) continue;
    const [what, which] = name.split('-'),
      i = AXES.indexOf(which);
    let d = Infinity;
    if (what === 'move' && i < 0) {
      const [cx, cy] = toScreen(position(state.target));
      d = Math.hypot(x - cx, y - cy) - 3;
    } else if (what === 'move') {
      const axis = axesOf()[i];
      // the tip is what a hand aims at
      const tip = toScreen(along(axis, 0.92 * ARROW * size));
      d = Math.min(
        toSegment(x, y, toScreen(along(axis, 0.3 * ARROW * size)), tip),
        Math.hypot(x - tip[0], y - tip[1]) - 4,
      );
    } else {
      const points = ringPoints(i, (i < 0 ? OUTER : RING) * size).map((r) => ({ ...r, s: toScreen(r.p) }));
      for (let k = 0; k < PIECES; k++)
        if (points[k].front) d = Math.min(d, toSegment(x, y, points[k].s, points[k + 1].s) + (i < 0 ? 2 : 0));
    }
    out.push([name, d]);
  }
  return out.sort((a, b) => a[1] - b[1]);
}
function pick(e) {
  if (!shown) return null;
  beforePicture();
  const [best] = distances(e.clientX, e.clientY);
  return best && best[1] <= (NEAR[e.pointerType] ?? NEAR.mouse) ? best[0] : null;
}
/** Where each handle can be taken hold of on the screen now; for tests that drag like a hand. */
export function handles() {
  if (!shown) return {};
  beforePicture();
  const size = heightThere(),
    axes = axesOf(),
    out = { 'move-view': toScreen(position(state.target)) };
  AXES.forEach((a, i) => {
    const stem = [0.92, 0.85, 0.75, 0.6, 0.5].map((k) => toScreen(along(axes[i], k * ARROW * size)));
    const clearStem = stem.find(([x, y]) => distances(x, y)[0]?.[0] === `move-${a}`);
    if (clearStem) out[`move-${a}`] = clearStem;
    const free = ringPoints(i, RING * size).filter((r) => r.front);
    const clear = free.map((r) => toScreen(r.p)).filter(([x, y]) => distances(x, y)[0]?.[0] === `turn-${a}`);
    if (clear.length) out[`turn-${a}`] = clear[Math.floor(clear.length / 2)];
  });
  out['turn-view'] = toScreen(ringPoints(-1, OUTER * size)[9].p);
  return out;
}

// ---- dragging
const ray = new THREE.Raycaster(),
  pointer = new THREE.Vector2();
function rayAt(e) {
  const r = renderer.domElement.getBoundingClientRect();
  pointer.set(((e.clientX - r.x) / r.width) * 2 - 1, 1 - ((e.clientY - r.y) / r.height) * 2);
  ray.setFromCamera(pointer, camera);
  return ray.ray;
}
/** How far along an axis through the target the ray passes it nearest. */
function alongAxis(axis, from, e) {
  const { origin, direction } = rayAt(e);
  const a = new THREE.Vector3(...axis),
    w = new THREE.Vector3(...from).sub(origin);
  const b = a.dot(direction),
    det = 1 - b * b;
  return det < 1e-6 ? 0 : (b * direction.dot(w) - a.dot(w)) / det;
}
function onPlane(normal, from, e) {
  const plane = new THREE.Plane().setFromNormalAndCoplanarPoint(normal, new THREE.Vector3(...from));
  return rayAt(e).intersectPlane(plane, new THREE.Vector3());
}

function down(e) {
  if (e.button !== 0) return;
  const name = pick(e);
  if (!name) return;
  e.stopPropagation();
  e.preventDefault();
  surface.focus({ preventScroll: true });
  surface.setPointerCapture(e.pointerId);
  controls.enabled = false;
  const [what, which] = name.split('-'),
    i = AXES.indexOf(which);
  const axis = i < 0 ? toEye.toArray() : axesOf()[i].slice();
  held = { name, what, axis, i, T: state.target.slice(), x: e.clientX, y: e.clientY, total: 0, before: null };
  held.start =
    what === 'turn' ? angleOf(e) : i < 0 ? onPlane(toEye, position(held.T), e) : alongAxis(axis, position(held.T), e);
  invalidate();
}
/** The pointer's angle about the centre; of a ring seen from its edge, how far it went along it. */
function angleOf(e) {
  const [cx, cy] = toScreen(position(held.T));
  const facing = held.axis.reduce((sum, v, k) => sum + v * toEye.getComponent(k), 0);
  if (Math.abs(facing) > 0.3) return -Math.sign(facing) * Math.atan2(e.clientY - cy, e.clientX - cx);
  const rim = crossed(held.axis, toEye.toArray()),
    size = heightThere();
  const a = toScreen(position(held.T)),
    b = toScreen(along(rim, RING * size));
  const dx = b[0] - a[0],
    dy = b[1] - a[1],
    length = Math.hypot(dx, dy) || 1;
  return ((e.clientX - held.x) * dx + (e.clientY - held.y) * dy) / (length * length);
}
const wrap = (a) => Math.atan2(Math.sin(a), Math.cos(a));
/** A step of the snap: that many degrees, that many millimetres. Shift takes 5 of each where none is set. */
const snapped = (v, e, unit) => {
  const steps = snap || (e.shiftKey ? 5 : 0);
  return steps ? Math.round(v / (steps * unit)) * steps * unit : v;
};

function move(e) {
  if (!held) {
    if (e.buttons || !shown) return;
    const name = pick(e);
    if (name !== hover) {
      hover = name;
      surface.style.setProperty('cursor', name ? 'grab' : '');
      invalidate();
    }
    return;
  }
  e.stopPropagation();
  const { T, axis, what, i } = held,
    frame = space === 'world' || i < 0 ? '' : 'tool ';
  let next = T.slice(),
    text;
  if (what === 'turn') {
    const now = angleOf(e);
    held.total += wrap(now - (held.before ?? held.start));
    held.before = now;
    const angle = snapped(held.total, e, Math.PI / 180);
    const s = Math.sin(angle / 2);
    next = mul(fromQuaternion([Math.cos(angle / 2), s * axis[0], s * axis[1], s * axis[2]]), T);
    for (const k of [3, 7, 11]) next[k] = T[k];
    text = `${signed(angle, 'angle')} about ${i < 0 ? 'the line of sight' : frame + AXES[i]}`;
  } else if (i < 0) {
    const at = onPlane(toEye, position(T), e);
    if (!at) return;
    const by = at.sub(held.start);
    if (snap || e.shiftKey) by.set(...by.toArray().map((v) => snapped(v, e, 1e-3)));
    [3, 7, 11].forEach((k, m) => {
      next[k] = T[k] + by.getComponent(m);
    });
    text = by
      .toArray()
      .map((v, m) => `${AXES[m]} ${signed(v, 'length')}`)
      .join(', ');
  } else {
    const by = snapped(alongAxis(axis, position(T), e) - held.start, e, 1e-3);
    [3, 7, 11].forEach((k, m) => {
      next[k] = T[k] + by * axis[m];
    });
    text = `${signed(by, 'length')} along ${frame}${AXES[i]}`;
  }
  setTarget(next, 'drag');
  tellNumbers(text, e);
  invalidate();
}
const signed = (v, kind) => `${v >= 0 ? '+' : ''}${showUnit(v, kind, units.digits(kind))}`;
function tellNumbers(text, e) {
  const r = surface.getBoundingClientRect();
  readout.hidden = false;
  setText(readout, text);
  readout.style.setProperty('left', `${Math.min(e.clientX - r.x + 18, r.width - readout.offsetWidth - 8)}px`);
  readout.style.setProperty('top', `${Math.max(e.clientY - r.y - 34, 8)}px`);
}
function up(e) {
  if (!held) return;
  e.stopPropagation();
  held = null;
  readout.hidden = true;
  controls.enabled = true;
  setTarget(state.target, 'dropped');
  invalidate();
}
/** Escape while dragging: the target goes back to where it was taken up. */
function giveUp() {
  const { T } = held;
  setTarget(T, 'drag');
  up({ stopPropagation() {} });
}

// ---- what the panel chooses
function apply() {
  if (shown) make();
  group.visible = shown;
  tell('frames');
  invalidate();
}
export function show(yes) {
  shown = yes;
  apply();
}
export function setMode(name) {
  mode = name;
  apply();
}
/** Along the target's own axes or along those of the world. */
export function setSpace(name) {
  space = name;
  invalidate();
}
/** Whole steps of so many degrees and millimetres; 0 for none. */
export function setSnap(steps) {
  snap = steps;
}
